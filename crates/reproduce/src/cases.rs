//! What is run: models, friction, decks.

use crate::decks::{self, Deck, Family};
use slideline::Onset;
use slideline::model::Dof;

/// Coefficient of friction of the models that have friction [1].
pub const FRICTION: f64 = 0.3;
/// Equal increments of every model.
pub const INCREMENTS: usize = 20;
/// Equal increments of the runs that show noise.
pub const FINE: usize = 100;

/// A finite element model of the paper, or ours beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelKind {
    /// First problem, contact elements on 24 beams.
    IrsCoarse,
    /// First problem, contact elements on 99 beams.
    IrsFine,
    /// First problem, contact elements on the circle.
    Isl,
    /// First problem, contact integrated along 24 beams; not in the paper.
    Integrated,
    /// Second problem, slave nodes every 3 degrees.
    Cam,
    /// Second problem, slave nodes every 4 degrees.
    CamWide,
    /// Second problem, contact integrated along 24 beams; not in the paper.
    CamIntegrated,
}

impl ModelKind {
    /// In the order of the study.
    pub const ALL: [Self; 7] = [
        Self::IrsCoarse,
        Self::IrsFine,
        Self::Isl,
        Self::Integrated,
        Self::Cam,
        Self::CamWide,
        Self::CamIntegrated,
    ];

    /// In a few words.
    pub fn name(self) -> &'static str {
        match self {
            Self::IrsCoarse => "IRS coarse",
            Self::IrsFine => "IRS fine",
            Self::Isl => "ISL coarse",
            Self::Integrated => "integrated",
            Self::Cam => "ISL cam 3 deg",
            Self::CamWide => "ISL cam 4 deg",
            Self::CamIntegrated => "integrated cam",
        }
    }

    /// Number of the paper's problem.
    pub fn problem(self) -> u8 {
        if matches!(self, Self::Cam | Self::CamWide | Self::CamIntegrated) { 2 } else { 1 }
    }

    /// The model whose references are its own too: where contact is integrated
    /// there is no slave node, and the share of one that softened contact at
    /// one point asks for is that of the ISL model of the same problem.
    pub fn shares_references_of(self) -> Self {
        match self {
            Self::Integrated => Self::Isl,
            Self::CamIntegrated => Self::Cam,
            own => own,
        }
    }

    /// Dof that drives the model.
    pub fn driven(self) -> Dof {
        if self.problem() == 1 { Dof::U2 } else { Dof::UR3 }
    }

    fn decks(self) -> Family {
        match self {
            Self::IrsCoarse => decks::IRS_COARSE,
            Self::IrsFine => decks::IRS_FINE,
            Self::Isl => decks::ISL,
            Self::Integrated => decks::INTEGRATED,
            Self::Cam => decks::CAM,
            Self::CamWide => decks::CAM_WIDE,
            Self::CamIntegrated => decks::CAM_INTEGRATED,
        }
    }
}

/// How sticking is imposed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stick {
    /// There is no friction.
    Frictionless,
    /// Elastic slip.
    Penalty,
    /// Multipliers.
    Lagrange,
}

impl Stick {
    /// The word of files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Frictionless => "none",
            Self::Penalty => "penalty",
            Self::Lagrange => "lagrange",
        }
    }
}

/// One run of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    /// The model.
    pub model: ModelKind,
    /// How sticking is imposed.
    pub stick: Stick,
    /// When friction is called.
    pub onset: Onset,
    /// Its deck.
    pub deck: Deck,
}

impl Case {
    /// Coefficient of friction [1].
    pub fn friction(&self) -> f64 {
        if self.stick == Stick::Frictionless { 0.0 } else { FRICTION }
    }

    /// In a line.
    pub fn words(&self) -> String {
        let onset = slideline::output::onset_word(self.onset);
        match self.stick {
            Stick::Frictionless => format!("{}, no friction", self.deck.name),
            Stick::Penalty | Stick::Lagrange => format!("{}, {onset}", self.deck.name),
        }
    }
}

/// Every run of the study: each model without friction, and with friction
/// under both logics, with both algorithms.
pub fn cases() -> Vec<Case> {
    let of = |model: ModelKind| {
        let [none, penalty, lagrange] = model.decks();
        let case = move |stick, onset, deck| Case { model, stick, onset, deck };
        [
            case(Stick::Frictionless, Onset::Immediate, none),
            case(Stick::Penalty, Onset::Immediate, penalty),
            case(Stick::Lagrange, Onset::Immediate, lagrange),
            case(Stick::Penalty, Onset::Matfru, penalty),
            case(Stick::Lagrange, Onset::Matfru, lagrange),
        ]
    };
    ModelKind::ALL.into_iter().flat_map(of).collect()
}
