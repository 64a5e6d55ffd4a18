//! Overclosure -> pressure and slope.
//!
//! ```text
//!    p |            /            h = -c0: the pressure begins, with zero slope
//!      |           /             h = 0:   p0
//!   p0 + - - - - .'
//!      |      _-' .
//!   ---+===---+---+------ h
//!            -c0  0
//! ```
//!
//! A law is a convex, increasing scalar function with its slope, its energy and its inverse; it knows
//! nothing of geometry.

mod exponential;
mod tabular;

use std::f64::consts::PI;

/// How pressure follows overclosure. [semantics: softened contact]
#[derive(Debug, Clone, PartialEq)]
pub enum NormalLaw {
    /// Impenetrable: p >= 0, h <= 0, p h = 0.
    Hard,
    /// p = stiffness h for h > 0.
    Linear {
        /// Stiffness per area [F/L3].
        stiffness: f64,
    },
    /// Abaqus dialect: p = p0/(e-1) xi (exp(xi) - 1), xi = 1 + h/c0; zero below -c0; continued
    /// linearly above 6 c0.
    Exponential {
        /// Clearance at which the pressure vanishes, c0 [L].
        clearance: f64,
        /// Pressure at zero clearance, p0 [F/L2].
        pressure: f64,
    },
    /// CalculiX dialect: p = p0 exp(b h), b = ln(100)/c0; no spring beyond c0, where the pressure
    /// jumps to 0.01 p0. Continued linearly where b h exceeds 23.
    CalculixExponential {
        /// Clearance c0 at which the pressure is 0.01 p0 [L].
        clearance: f64,
        /// Pressure at zero clearance, p0 [F/L2].
        pressure: f64,
    },
    /// CalculiX dialect: p = K h [1/2 + atan(h/eps)/pi], eps = pi tension/K: below K h by `tension` where it is well
    /// closed.
    CalculixLinear {
        /// Stiffness per area K [F/L3].
        stiffness: f64,
        /// Largest pull sigma_inf [F/L2].
        tension: f64,
        /// Whether it pulls when open, by at most `tension`, however far: gap elements do, surfaces do not.
        pulls: bool,
    },
    /// Pairs (pressure [F/L2], overclosure [L]) ascending in overclosure, pressures not descending,
    /// at least two; zero below the first, last slope continued.
    Tabular(Vec<(f64, f64)>),
    /// What has closed and does not separate: p = stiffness h both ways; infinite: h = 0 under any
    /// pressure or tension. docs/theory.md eq. (6.9)
    Bonded {
        /// Stiffness per area, or infinity [F/L3].
        stiffness: f64,
    },
}

impl NormalLaw {
    /// The law of points that have closed and must not separate: of a hard or a linear law.
    pub fn bonded(&self) -> Option<Self> {
        match *self {
            Self::Hard => Some(Self::Bonded { stiffness: f64::INFINITY }),
            Self::Linear { stiffness } | Self::CalculixLinear { stiffness, .. } => {
                Some(Self::Bonded { stiffness })
            }
            _ => None,
        }
    }

    /// Whether it holds points against tension as it holds them against pressure.
    pub fn is_bonded(&self) -> bool {
        matches!(self, Self::Bonded { .. })
    }

    /// Pressure [F/L2] and slope dp/dh [F/L3] at the overclosure h [L]. `None` for the hard law,
    /// whose pressure is not a function of h.
    pub fn pressure(&self, overclosure: f64) -> Option<(f64, f64)> {
        let h = overclosure;
        match self {
            Self::Hard => None,
            Self::Bonded { stiffness } => {
                stiffness.is_finite().then_some((stiffness * h, *stiffness))
            }
            Self::Linear { stiffness } => {
                Some(if h > 0.0 { (stiffness * h, *stiffness) } else { (0.0, 0.0) })
            }
            Self::Exponential { clearance, pressure } => {
                let (p, slope) = exponential::dimensionless(h / clearance);
                Some((pressure * p, pressure / clearance * slope))
            }
            Self::CalculixExponential { clearance, pressure } => {
                let (p, slope, _) = exponential::calculix(h / clearance);
                Some((pressure * p, pressure / clearance * slope))
            }
            Self::CalculixLinear { stiffness, tension, pulls } => Some(if *pulls || h > 0.0 {
                calculix_linear(*stiffness, *tension, h)
            } else {
                (0.0, 0.0)
            }),
            Self::Tabular(pairs) => Some(tabular::pressure(pairs, h)),
        }
    }

    /// Energy per area w(h) [F/L], the integral of p dh from where contact begins (CalculiX
    /// exponential: from -infinity, its tail below -c0 being 0.01 p0/b, kept as a constant there;
    /// CalculiX linear: from 0). Zero for the hard law.
    pub fn energy(&self, overclosure: f64) -> f64 {
        let h = overclosure;
        match self {
            Self::Hard => 0.0,
            Self::Bonded { stiffness } if stiffness.is_infinite() => 0.0,
            Self::Bonded { stiffness } => 0.5 * stiffness * h * h,
            Self::Linear { stiffness } => 0.5 * stiffness * h.max(0.0).powi(2),
            Self::Exponential { clearance, pressure } => {
                pressure * clearance * exponential::energy(h / clearance)
            }
            Self::CalculixExponential { clearance, pressure } => {
                pressure * clearance * exponential::calculix(h / clearance).2
            }
            Self::CalculixLinear { pulls: false, .. } if h <= 0.0 => 0.0,
            Self::CalculixLinear { stiffness, tension, .. } => {
                let eps = PI * tension / stiffness;
                let x = h / eps;
                let inner = 0.25 * x * x + (0.5 * (x * x + 1.0) * x.atan() - 0.5 * x) / PI;
                stiffness * eps * eps * inner
            }
            Self::Tabular(pairs) => tabular::energy(pairs, h),
        }
    }

    /// Inverse law: overclosure h [L] and dh/dp [L3/F] that carry the pressure p. `None` where no
    /// single overclosure carries it: p <= 0 (the CalculiX linear law of gaps goes down to -tension), or a
    /// level stretch of a table. Hard: (0, 0).
    pub fn overclosure(&self, pressure: f64) -> Option<(f64, f64)> {
        let lowest = match self {
            Self::CalculixLinear { tension, pulls: true, .. } => -tension,
            Self::Bonded { .. } => f64::NEG_INFINITY,
            _ => 0.0,
        };
        if !(pressure > lowest && pressure.is_finite()) {
            return None;
        }
        match self {
            Self::Hard => Some((0.0, 0.0)),
            Self::Linear { stiffness } | Self::Bonded { stiffness } => {
                Some((pressure / stiffness, 1.0 / stiffness))
            }
            Self::Exponential { clearance, pressure: p0 } => {
                let (h, slope) = exponential::inverse(pressure / p0);
                Some((clearance * h, clearance / p0 * slope))
            }
            Self::CalculixExponential { clearance, pressure: p0 } => {
                let (h, slope) = exponential::calculix_inverse(pressure / p0);
                Some((clearance * h, clearance / p0 * slope))
            }
            Self::CalculixLinear { stiffness, tension, .. } => {
                invert_calculix_linear(*stiffness, *tension, pressure)
            }
            Self::Tabular(pairs) => tabular::inverse(pairs, pressure),
        }
    }

    /// The overclosure above which contact carries pressure [L]: -c0 for both exponential laws (the
    /// CalculiX one has no spring beyond c0), the first overclosure of a table at zero pressure, 0
    /// otherwise (the CalculiX linear law of gaps pulls below); minus infinity for what does not separate.
    pub fn contact_begins(&self) -> f64 {
        match self {
            Self::Exponential { clearance, .. } | Self::CalculixExponential { clearance, .. } => {
                -clearance
            }
            Self::Tabular(pairs) => tabular::begins(pairs),
            Self::Hard | Self::Linear { .. } | Self::CalculixLinear { .. } => 0.0,
            Self::Bonded { .. } => f64::NEG_INFINITY,
        }
    }

    /// The pressure p that solves h = z - p/kappa with p = p(h), and its slope dp/dz in [0, kappa].
    ///
    /// This is the Moreau-Yosida form of the law: monotone and single-valued for every law, also the
    /// hard one (kappa max(z, 0)) and one that jumps (the jump is run through at slope kappa). `z` =
    /// h + p/kappa [L], `kappa` > 0 [F/L3]; an infinite kappa inserts the law (a hard one then has no
    /// finite answer and keeps slope and pressure infinite). Newton on h + p(h)/kappa - z, convex
    /// with slope >= 1, so that it converges from anywhere; it begins from an overclosure `near` the
    /// one that is sought.
    pub fn resolvent(&self, z: f64, kappa: f64, near: f64) -> (f64, f64) {
        match self {
            Self::Hard => {
                if z > 0.0 {
                    (kappa * z, kappa)
                } else {
                    (0.0, 0.0)
                }
            }
            Self::Tabular(pairs) => tabular::resolvent(pairs, z, kappa),
            Self::Bonded { stiffness } => {
                let slope = match stiffness.is_finite() {
                    true => stiffness / (1.0 + stiffness / kappa),
                    false => kappa,
                };
                (slope * z, slope)
            }
            _ => self.resolvent_of_function(z, kappa, near),
        }
    }

    fn resolvent_of_function(&self, z: f64, kappa: f64, near: f64) -> (f64, f64) {
        let begins = self.contact_begins();
        let pulls = matches!(self, Self::CalculixLinear { pulls: true, .. });
        if !pulls {
            if z <= begins {
                return (0.0, 0.0);
            }
            let jump = self.jump();
            if kappa * (z - begins) <= jump {
                return (kappa * (z - begins), kappa); // on the jump, h = -c0
            }
        }
        let law = |h: f64| self.pressure(h).unwrap_or((0.0, 0.0));
        let mut h = if near > begins && near < z { near } else { z };
        let (mut p, mut slope) = law(h);
        for _ in 0..100 {
            let step = (h - z + p / kappa) / (1.0 + slope / kappa);
            let next = if pulls {
                h - step
            } else {
                // The next double above: with a jump, the law at -c0 itself is zero.
                (h - step).max(begins + f64::EPSILON * begins.abs())
            };
            let done = (next - h).abs() <= 2.0 * f64::EPSILON * h.abs().max(begins.abs());
            h = next;
            (p, slope) = law(h);
            if done || !step.is_finite() {
                break;
            }
        }
        // Of the two expressions of p the one in which rounding of h counts less.
        let value = if slope > kappa { kappa * (z - h) } else { p };
        (value, slope / (1.0 + slope / kappa))
    }

    /// Height of the jump where contact begins [F/L2].
    fn jump(&self) -> f64 {
        match self {
            Self::CalculixExponential { pressure, .. } => 0.01 * pressure,
            _ => 0.0,
        }
    }
}

/// Pressure and slope of the CalculiX linear law.
fn calculix_linear(stiffness: f64, tension: f64, h: f64) -> (f64, f64) {
    let x = h * stiffness / (PI * tension);
    // 1/2 + atan(x)/pi without cancellation for large negative x.
    let share = if x < -1.0 { (-1.0 / x).atan() / PI } else { 0.5 + x.atan() / PI };
    (stiffness * h * share, stiffness * (share + x / (PI * (1.0 + x * x))))
}

/// Newton from the right; the law is convex and increasing.
fn invert_calculix_linear(stiffness: f64, tension: f64, pressure: f64) -> Option<(f64, f64)> {
    let mut h = if pressure > 0.0 { 2.0 * pressure / stiffness } else { 0.0 };
    for _ in 0..200 {
        let (p, slope) = calculix_linear(stiffness, tension, h);
        let next = h - (p - pressure) / slope;
        let done = (next - h).abs() <= 2.0 * f64::EPSILON * h.abs();
        h = next;
        if done {
            break;
        }
    }
    let (p, slope) = calculix_linear(stiffness, tension, h);
    let close = (p - pressure).abs() <= 1e-9 * (pressure.abs() + tension);
    (close && slope > 0.0).then_some((h, 1.0 / slope))
}

#[cfg(test)]
mod tests;
