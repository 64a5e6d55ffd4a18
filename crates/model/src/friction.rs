//! Friction laws as the deck says them.

/// The friction law as the deck says it.
#[derive(Clone, Debug, PartialEq, Default)]
pub enum Friction {
    /// None.
    #[default]
    Frictionless,
    /// Coulomb's law.
    Coulomb {
        /// Coefficient mu [1] (the static one, with decay).
        coefficient: f64,
        /// Coefficient along the second axis of the surface, where it is another one than along the
        /// first [1] (`ANISOTROPIC`).
        second: Option<f64>,
        /// `TAUMAX` [F/L2].
        limit: Option<f64>,
        /// Decay from static to kinetic.
        decay: Option<Decay>,
        /// How sticking is imposed.
        stick: StickRule,
    },
    /// No slip while closed.
    Rough,
    /// A law of the embedding program.
    User {
        /// Its name.
        name: String,
        /// Constants of the card.
        properties: Vec<f64>,
        /// Number of state variables a point keeps (`DEPVAR`).
        state_size: usize,
    },
}

impl Friction {
    /// Whether a closed point can feel it at any slip rate. A Coulomb law is none only where both
    /// its coefficients are zero: with decay the static one alone says nothing.
    pub fn acts(&self) -> bool {
        match self {
            Self::Frictionless => false,
            Self::Coulomb { second, .. } => {
                self.coefficients().iter().chain(second).any(|&mu| mu != 0.0)
            }
            Self::Rough | Self::User { .. } => true,
        }
    }

    /// Whether it has a coefficient of its own along either axis of the surface.
    pub fn is_directed(&self) -> bool {
        matches!(self, Self::Coulomb { second: Some(_), .. })
    }

    /// How far a sticking point may move, where the deck says so [L] (`ELASTIC SLIP`).
    pub fn elastic_slip(&self) -> Option<f64> {
        match self {
            Self::Coulomb { stick: StickRule::ElasticSlip(slip), .. } => Some(*slip),
            _ => None,
        }
    }

    /// Coulomb's coefficients along the first axis, at rest and in fast sliding [1]; the same without
    /// decay, zero for a law that has none.
    pub fn coefficients(&self) -> [f64; 2] {
        match *self {
            Self::Coulomb { coefficient, decay: Some(decay), .. } if decay.rate > 0.0 => {
                [coefficient, decay.kinetic]
            }
            Self::Coulomb { coefficient, .. } => [coefficient; 2],
            Self::Frictionless | Self::Rough | Self::User { .. } => [0.0; 2],
        }
    }
}

/// mu = mu_k + (mu_s - mu_k) exp(-d_c |slip rate|).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decay {
    /// Kinetic coefficient mu_k [1].
    pub kinetic: f64,
    /// Decay constant d_c [T/L].
    pub rate: f64,
}

/// How sticking is imposed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StickRule {
    /// Elastic slip of this fraction of the average contact element length [1].
    SlipTolerance(f64),
    /// Elastic slip [L].
    ElasticSlip(f64),
    /// Traction by elastic slip [F/L3], whatever the pressure (CalculiX' stick slope).
    Slope(f64),
    /// Exactly, by a multiplier.
    Lagrange,
}

impl Default for StickRule {
    fn default() -> Self {
        Self::SlipTolerance(0.005)
    }
}
