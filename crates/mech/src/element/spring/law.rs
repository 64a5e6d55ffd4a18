//! Force of a spring by its relative displacement.

use crate::contact::normal::NormalLaw;
use std::sync::Arc;

/// Force of a spring by its relative displacement.
#[derive(Debug, Clone, PartialEq)]
pub enum SpringLaw {
    /// Proportional, with the stiffness k [F/L], or [F L] about a rotation.
    Linear(f64),
    /// Lines between pairs of displacement [L] and force [F], displacements ascending; beyond the
    /// ends the force stays.
    Table(Arc<[[f64; 2]]>),
    /// A gap that closes when its ends approach one another: the law at the overclosure
    /// h = -(clearance + u), forces in place of pressures. docs/theory.md eq. (3.111)
    Gap {
        /// Opening at rest [L]; negative: overclosed.
        clearance: f64,
        /// Force by overclosure; one that is a function of it.
        law: Box<NormalLaw>,
    },
}

impl SpringLaw {
    /// Energy, force and stiffness at a relative displacement.
    pub fn answer(&self, u: f64) -> [f64; 3] {
        match self {
            Self::Linear(stiffness) => [0.5 * stiffness * u * u, stiffness * u, *stiffness],
            Self::Table(table) => {
                let (stored, force, slope) = along(table, u);
                [stored - along(table, 0.0).0, force, slope]
            }
            Self::Gap { clearance, law } => {
                let overclosure = -(clearance + u);
                let (force, slope) = closed(law, overclosure);
                [law.energy(overclosure) - law.energy(-clearance), -force, slope]
            }
        }
    }

    /// Its largest stiffness.
    pub fn stiffest(&self) -> f64 {
        match self {
            Self::Linear(stiffness) => stiffness.abs(),
            Self::Table(table) => {
                let slopes = table.windows(2).map(|pair| slope(pair[0], pair[1]).abs());
                slopes.fold(0.0, f64::max)
            }
            Self::Gap { law, .. } => match **law {
                NormalLaw::Linear { stiffness } | NormalLaw::CalculixLinear { stiffness, .. } => {
                    stiffness
                }
                _ => 0.0,
            },
        }
    }

    /// Whether it resists at rest, whichever way it is moved: a gap that is open does not.
    pub fn holds_at_rest(&self) -> bool {
        match self {
            Self::Linear(stiffness) => *stiffness != 0.0,
            Self::Table(_) => self.stiffest() != 0.0,
            Self::Gap { clearance, .. } => *clearance <= 0.0,
        }
    }
}

/// Force and slope of a gap; one that has just closed has the slope of one that is closed, so that
/// what rests on it is held.
fn closed(law: &NormalLaw, overclosure: f64) -> (f64, f64) {
    match law {
        NormalLaw::Linear { stiffness } if overclosure == 0.0 => (0.0, *stiffness),
        _ => law.pressure(overclosure).unwrap_or_default(),
    }
}

fn slope(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]) / (to[0] - from[0])
}

/// Work from the first pair of a table to `u`, force and slope there.
fn along(table: &[[f64; 2]], u: f64) -> (f64, f64, f64) {
    let (Some(first), Some(last)) = (table.first(), table.last()) else { return (0.0, 0.0, 0.0) };
    if u < first[0] {
        return ((u - first[0]) * first[1], first[1], 0.0);
    }
    let mut stored = 0.0;
    for pair in table.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        if u < to[0] {
            let rise = slope(from, to);
            let force = from[1] + rise * (u - from[0]);
            return (stored + 0.5 * (from[1] + force) * (u - from[0]), force, rise);
        }
        stored += 0.5 * (from[1] + to[1]) * (to[0] - from[0]);
    }
    (stored + (u - last[0]) * last[1], last[1], 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a table is read line by line, its force stays beyond the ends, its energy is
    /// the work from rest: areas by hand.
    #[test]
    fn tables_are_lines() {
        let law = SpringLaw::Table([[-1.0, -2.0], [0.5, 1.0], [1.5, 5.0]].into());
        assert_eq!(law.answer(0.25), [0.0625, 0.5, 2.0]);
        assert_eq!(law.answer(1.0), [0.25 + 1.0, 3.0, 4.0]);
        assert_eq!(law.answer(2.5), [0.25 + 3.0 + 5.0, 5.0, 0.0]);
        assert_eq!(law.answer(-3.0), [1.0 + 4.0, -2.0, 0.0]);
        assert_eq!(law.stiffest(), 4.0);
        // at rest at its first pair it has the stiffness of its first line
        let begins = SpringLaw::Table([[0.0, 0.0], [1.0, 10.0]].into());
        assert_eq!(begins.answer(0.0), [0.0, 0.0, 10.0]);
        // a law that pulls at rest has no energy there
        let pulls = SpringLaw::Table([[-1.0, 1.0], [1.0, 3.0]].into());
        assert_eq!(pulls.answer(0.0), [0.0, 2.0, 1.0]);
    }

    /// Requirement: a gap carries nothing while it is open, then its law at what is beyond; its
    /// force is the slope of its energy. At touch it has the slope of contact.
    #[test]
    fn gaps_close() {
        let gap = |clearance, law| SpringLaw::Gap { clearance, law: Box::new(law) };
        let linear = gap(0.5, NormalLaw::Linear { stiffness: 8.0 });
        assert_eq!(linear.answer(3.0), [0.0, 0.0, 0.0]);
        assert_eq!(linear.answer(-0.5), [0.0, 0.0, 8.0]);
        assert_eq!(linear.answer(-0.75), [0.25, -2.0, 8.0]);
        let calculix =
            gap(0.5, NormalLaw::CalculixLinear { stiffness: 8.0, tension: 1e-3, pulls: true });
        for law in [&linear, &calculix, &gap(-0.2, NormalLaw::Linear { stiffness: 3.0 })] {
            assert_eq!(law.answer(0.0)[0], 0.0);
            for u in [-0.9, -0.51, -0.4999, 0.1, 1.0] {
                let [_, force, slope] = law.answer(u);
                let (after, before) = (law.answer(u + 1e-6), law.answer(u - 1e-6));
                assert!((force - (after[0] - before[0]) / 2e-6).abs() < 1e-6);
                assert!((slope - (after[1] - before[1]) / 2e-6).abs() < 1e-4 * law.stiffest());
            }
        }
        // far open it pulls by the force that CalculiX says
        assert!((calculix.answer(1e3)[1] - 1e-3).abs() < 1e-8);
    }
}
