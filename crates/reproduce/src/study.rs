//! The models of the study and their runs.
//!
//! ```text
//!   decks x onsets --> runs, side by side --> curves
//!                                               |--> figures, table, page
//!   closed forms and exact references ----------'
//! ```

use crate::cases::{Case, ModelKind, Stick, cases};
use crate::curve::{Curve, run};
use crate::failure::Failure;
use crate::fine;
use crate::progress::Count;
use crate::theory::{References, references};
use rayon::prelude::*;
use slideline::Onset;

/// Everything that was computed.
#[derive(Clone, Debug)]
pub struct Study {
    /// One curve a case, in the order of [`cases`].
    pub curves: Vec<Curve>,
    /// What the curves are held against.
    pub references: References,
    /// The three formulations of 24 beams in small increments.
    pub fine: Vec<fine::Errors>,
}

impl Study {
    /// The curve of a case.
    pub fn curve(&self, model: ModelKind, stick: Stick, onset: Onset) -> Option<&Curve> {
        self.curves.iter().find(|curve| {
            let case = &curve.case;
            case.model == model && case.stick == stick && case.onset == onset
        })
    }
}

/// Runs every case and finds every reference, side by side.
pub(crate) fn compute(count: &Count<'_>) -> Result<Study, Failure> {
    let curves = || {
        let each = |case: Case| {
            let curve = run(case, None)?;
            count.tick(case.words());
            Ok(curve)
        };
        cases().into_par_iter().map(each).collect::<Result<Vec<Curve>, Failure>>()
    };
    let all = || rayon::join(curves, || fine::curves(count));
    let (references, (curves, small)) = rayon::join(|| references(count), all);
    let references = references?;
    Ok(Study { curves: curves?, fine: fine::errors(&small?, &references), references })
}
