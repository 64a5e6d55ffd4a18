//! What the curves are held against: the paper's linear theory and the exact
//! references, at the study's increments.

use crate::cases::{FINE, FRICTION, INCREMENTS, ModelKind};
use crate::failure::Failure;
use crate::progress::Count;
use rayon::prelude::*;
use slideline_theory::{FirstProblem, Reference, SecondProblem, TheoryError};

/// Theories, from the paper's own to the one that leaves out least.
pub(crate) const THEORIES: [Theory; 5] =
    [Theory::Linear, Theory::Elastica, Theory::Reissner, Theory::Softened, Theory::Continuum];

/// A theory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theory {
    /// The paper's.
    Linear,
    /// Large deflections.
    Elastica,
    /// And stretching and shear.
    Reissner,
    /// And softened contact at one point of the area of a slave node.
    Softened,
    /// And pressure spread along the beam.
    Continuum,
}

impl Theory {
    /// The reference that a model of its kind goes to when everything is made
    /// fine but the share of a slave node.
    pub fn exact(model: ModelKind) -> Self {
        match model {
            ModelKind::Integrated | ModelKind::CamIntegrated => Self::Continuum,
            _ => Self::Softened,
        }
    }
}

/// A reference at the increments 1 to 20.
#[derive(Clone, Debug)]
pub struct Values {
    /// Whose theory.
    pub theory: Theory,
    /// Coefficient of friction [1].
    pub friction: f64,
    /// Model whose problem and slave area it is for.
    pub model: ModelKind,
    /// RF2 [F] or RM3 [F L].
    pub reactions: Vec<f64>,
    /// The same at the increments of [`FINE`], where they were asked for.
    pub fine: Vec<f64>,
}

/// All references, and fine curves of the linear theory for the figures.
#[derive(Clone, Debug)]
pub struct References {
    /// At the increments.
    pub values: Vec<Values>,
    /// Linear theory, first problem without and with friction, second problem
    /// the same: motion [L or 1] and reaction [F or F L].
    pub lines: [Vec<[f64; 2]>; 4],
}

impl References {
    /// A reference at the increments; empty if it was not computed.
    pub fn get(&self, model: ModelKind, theory: Theory, friction: f64) -> &[f64] {
        self.find(model, theory, friction).map_or(&[], |values| values.reactions.as_slice())
    }

    /// The first problem with pressure along the beam, in small increments.
    pub(crate) fn fine(&self, friction: f64) -> &[f64] {
        let found = self.find(ModelKind::Isl, Theory::Continuum, friction);
        found.map_or(&[], |values| values.fine.as_slice())
    }

    fn find(&self, model: ModelKind, theory: Theory, friction: f64) -> Option<&Values> {
        // only softened contact asks how large a slave node's share is
        let same = |own: ModelKind| match theory {
            Theory::Softened => own == model.shares_references_of(),
            _ => own.problem() == model.problem(),
        };
        self.values.iter().find(|v| v.theory == theory && v.friction == friction && same(v.model))
    }
}

/// Fine curves have this many pieces.
const PIECES: usize = 240;

pub(crate) fn count_of_references() -> usize {
    wanted().len()
}

fn wanted() -> Vec<(ModelKind, Theory, f64)> {
    let mut wanted = Vec::new();
    let own = |model: &ModelKind| model.shares_references_of() == *model;
    for model in ModelKind::ALL.into_iter().filter(own) {
        let first_of_problem = matches!(model, ModelKind::Isl | ModelKind::Cam);
        for theory in THEORIES {
            if theory == Theory::Softened || first_of_problem {
                wanted.extend([0.0, FRICTION].map(|friction| (model, theory, friction)));
            }
        }
    }
    // the longest first, so that none is left alone at the end
    wanted.sort_by_key(|(_, theory, _)| *theory != Theory::Continuum);
    wanted
}

pub(crate) fn references(count: &Count<'_>) -> Result<References, Failure> {
    let each = |(model, theory, friction): (ModelKind, Theory, f64)| {
        let small = theory == Theory::Continuum && model.problem() == 1;
        let increments = if small { FINE } else { INCREMENTS };
        let reactions = reactions(model, theory, friction, increments)?;
        count.tick(format!("theory {theory:?}, problem {}", model.problem()).to_lowercase());
        let all: Vec<f64> = reactions.into_iter().skip(1).map(|[_, value]| value).collect();
        let every = increments / INCREMENTS;
        let reactions = all.iter().copied().skip(every - 1).step_by(every).collect();
        let fine = if small { all } else { Vec::new() };
        Ok(Values { theory, friction, model, reactions, fine })
    };
    let values: Result<Vec<Values>, TheoryError> = wanted().into_par_iter().map(each).collect();
    let line = |model, friction| reactions(model, Theory::Linear, friction, PIECES);
    let lines = [
        line(ModelKind::Isl, 0.0)?,
        line(ModelKind::Isl, FRICTION)?,
        line(ModelKind::Cam, 0.0)?,
        line(ModelKind::Cam, FRICTION)?,
    ];
    Ok(References { values: values?, lines })
}

fn reactions(
    model: ModelKind,
    theory: Theory,
    friction: f64,
    increments: usize,
) -> Result<Vec<[f64; 2]>, TheoryError> {
    let reference = match theory {
        Theory::Linear => Reference::Linear,
        Theory::Elastica => Reference::Elastica,
        Theory::Reissner => Reference::Reissner,
        Theory::Softened => Reference::Softened { area: slave_area(model) },
        Theory::Continuum => Reference::Continuum,
    };
    if model.problem() == 1 {
        let rows = FirstProblem::diehl().rows(friction, increments, reference)?;
        Ok(rows.iter().map(|row| [row.u2, row.rf2]).collect())
    } else {
        let rows = SecondProblem::project().rows(friction, increments, reference)?;
        Ok(rows.iter().map(|row| [row.ur3, row.rm3]).collect())
    }
}

/// Share of the surface of a slave node inside the deck's contact elements [L2]; where contact is
/// integrated, of the ISL model.
fn slave_area(model: ModelKind) -> f64 {
    let first = FirstProblem::diehl();
    let strip = first.beam.width * first.beam.length();
    match model {
        ModelKind::IrsCoarse => strip / 24.0,
        ModelKind::IrsFine => strip / 99.0,
        ModelKind::Isl | ModelKind::Integrated => first.slave_area(4f64.to_radians()),
        ModelKind::Cam | ModelKind::CamIntegrated => {
            SecondProblem::project().slave_area(3f64.to_radians())
        }
        ModelKind::CamWide => SecondProblem::project().slave_area(4f64.to_radians()),
    }
}
