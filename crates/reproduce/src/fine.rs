//! The three ways of sampling contact on the mesh of 24 beams, in small
//! increments: what 20 increments show of their noise is a matter of luck.
//!
//! ```text
//!   error |  /|/|/|/|   IRS: a beam node carries all, until the next one does
//!         |  ~~~~~~~    ISL: so does a node of the circle
//!         |  -------    integrated along the beam
//!         +----------> displacement
//! ```

use crate::cases::{Case, FINE, FRICTION, ModelKind, Stick, cases};
use crate::curve::{Curve, run};
use crate::failure::Failure;
use crate::progress::Count;
use crate::theory::References;
use rayon::prelude::*;
use slideline::Onset;
use slideline_measures as measures;

/// The models, from the noisiest to the smoothest.
pub(crate) const MODELS: [ModelKind; 3] =
    [ModelKind::IrsCoarse, ModelKind::Isl, ModelKind::Integrated];

/// How far a model is from the shear-flexible beam with pressure spread along
/// it, increment by increment.
#[derive(Clone, Debug)]
pub struct Errors {
    /// The model.
    pub model: ModelKind,
    /// Coefficient of friction [1].
    pub friction: f64,
    /// Displacements of the circle along Y [L].
    pub motions: Vec<f64>,
    /// Differences of RF2 [% of the peak].
    pub errors: Vec<f64>,
    /// Their RMS [% of the peak].
    pub rms: f64,
    /// Their largest magnitude [% of the peak].
    pub largest: f64,
    /// Roughness [% of the peak].
    pub roughness: f64,
    /// Changes of direction of the force, of which theory has none.
    pub reversals: usize,
}

pub(crate) fn count() -> usize {
    2 * MODELS.len()
}

/// Holds the curves against theory.
pub(crate) fn errors(curves: &[Curve], references: &References) -> Vec<Errors> {
    let each = |curve: &Curve| compare(curve, references.fine(curve.case.friction()));
    curves.iter().map(each).collect()
}

/// Runs the models without and with friction.
pub(crate) fn curves(count: &Count<'_>) -> Result<Vec<Curve>, Failure> {
    let each = |(friction, model)| curve(model, friction, count);
    let all = [0.0, FRICTION].map(|friction| MODELS.map(|model| (friction, model)));
    all.concat().into_par_iter().map(each).collect()
}

fn curve(model: ModelKind, friction: f64, count: &Count<'_>) -> Result<Curve, Failure> {
    let stick = if friction == 0.0 { Stick::Frictionless } else { Stick::Penalty };
    let wanted =
        |case: &Case| case.model == model && case.stick == stick && case.onset == Onset::Immediate;
    let case = cases().into_iter().find(wanted).ok_or(Failure::Figure("formulations"))?;
    let curve = run(case, Some(FINE))?;
    count.tick(format!("{}, {FINE} increments", case.words()));
    Ok(curve)
}

fn compare(curve: &Curve, exact: &[f64]) -> Errors {
    let (found, motions) = (curve.reactions(), curve.motions());
    let percent = |value: Option<f64>| 100.0 * value.unwrap_or(f64::NAN);
    let peak = measures::maximum(exact).unwrap_or(f64::NAN);
    Errors {
        model: curve.case.model,
        friction: curve.case.friction(),
        motions,
        errors: found.iter().zip(exact).map(|(f, e)| 100.0 * (f - e) / peak).collect(),
        rms: percent(measures::rms_error(&found, exact)),
        largest: percent(measures::max_error(&found, exact)),
        roughness: percent(measures::roughness_against(&found, exact)),
        reversals: measures::reversals(&found, measures::DEFAULT_NOISE_FLOOR),
    }
}
