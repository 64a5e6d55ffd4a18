//! What contact at nodes may miss of masters, where pairs carry most.
//!
//! ```text
//!   force |        .-x--.      measured at x: where a pair carries a tenth more than where it was measured,
//!         |    .-x-      '     and at the end of a step that carries more
//!         |  x
//!         +-x------------> t
//! ```
//!
//! docs/theory.md section 5.20

use crate::contact::{FallsRoom, MissedAt};
use crate::newton::Scratch;
use crate::observe::results::PairRow;
use crate::problem::Problem;
use crate::state::State;
use serde::{Deserialize, Serialize};
use slideline_mech::vector::size;

/// Force over that where a pair was measured from which on it is measured again [1].
const MORE: f64 = 1.1;

/// A pair where it carried most, to a tenth.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Heaviest {
    /// Its force [F].
    pub force: f64,
    /// How far its master falls away there [L].
    pub falls_away: f64,
    /// How far its master is smoothed away there [L].
    pub smoothed_away: f64,
    /// Sums over its nodes, while it is measured.
    #[serde(skip)]
    pub sums: Option<Sums>,
}

impl Heaviest {
    /// Whether its numbers are such that a run can reach.
    pub fn is_sound(&self) -> bool {
        [self.force, self.falls_away, self.smoothed_away].iter().all(|own| own.is_finite())
    }

    /// Whether a pair that carries `force` is to be measured.
    fn is_passed(&self, force: f64, is_last: bool) -> bool {
        force > if is_last { self.force } else { MORE * self.force }
    }
}

/// The pairs of a run, and room in which they are measured.
#[derive(Default)]
pub struct Measured {
    /// Each where it carried most so far; part of what a run goes on from.
    pub pairs: Vec<Heaviest>,
    /// Room in which masters are held against faces.
    pub room: FallsRoom,
}

/// Sums over closed nodes.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Sums {
    /// Forces [F].
    force: f64,
    /// Forces by the way by which the master falls away [F L].
    falls: f64,
    /// Forces by the way by which its corners are smoothed away [F L].
    smoothed: f64,
}

impl Measured {
    /// Becomes that of a run which begins, or goes on, with these.
    pub fn begin(&mut self, pairs: &[Heaviest]) {
        self.pairs.clear();
        self.pairs.extend_from_slice(pairs);
    }

    /// Tells the rows of a committed state what masters miss, and measures it where pairs carry more than before.
    pub fn take(
        &mut self,
        plan: &Problem<'_>,
        (state, work): (&State, &Scratch),
        is_last: bool,
        rows: &mut [PairRow],
    ) {
        if self.pairs.len() != rows.len() {
            self.pairs.resize(rows.len(), Heaviest::default());
            plan.contact.make_room(plan.dofs.len(), &mut self.room);
        }
        let mut is_any = false;
        for (row, heaviest) in rows.iter().zip(&mut self.pairs) {
            let is_passed = heaviest.is_passed(size(row.force), is_last);
            heaviest.sums = is_passed.then(Sums::default);
            is_any |= is_passed;
        }
        if is_any {
            self.add(plan, state, work);
        }
        for (row, heaviest) in rows.iter_mut().zip(&mut self.pairs) {
            if let Some(sums) = heaviest.sums.take() {
                let part = if sums.force > 0.0 { 1.0 / sums.force } else { 0.0 };
                heaviest.force = size(row.force);
                heaviest.falls_away = part * sums.falls;
                heaviest.smoothed_away = part * sums.smoothed;
            }
            (row.falls_away, row.smoothed_away) = (heaviest.falls_away, heaviest.smoothed_away);
        }
    }

    /// Adds the closed nodes of all pairs that are measured.
    fn add(&mut self, plan: &Problem<'_>, state: &State, work: &Scratch) {
        let Self { pairs, room } = self;
        let (contact, u) = (plan.contact, &state.displacement[..]);
        let positions = work.evaluation.positions();
        contact.make_room(u.len(), room);
        let points = contact.points.iter().zip(&state.points).enumerate();
        for (place, (point, now)) in points.filter(|(_, (_, now))| now.closed) {
            let is_node = point.is_node();
            let of = pairs.get_mut(contact.parent(point.pair)).filter(|_| is_node);
            let Some(own) = of.and_then(|pair| pair.sums.as_mut()) else { continue };
            let missed = match (contact.is_edge(place), contact.is_reversed(point.pair)) {
                (false, _) => contact.missed_at(place, (u, positions), room),
                (true, true) => contact.edge_falls_away(place, u, positions),
                (true, false) => None,
            };
            let Some(MissedAt { falls_away, smoothed_away }) = missed else { continue };
            let force = now.area * now.pressure;
            own.force += force;
            own.falls += force * falls_away;
            own.smoothed += force * smoothed_away;
        }
    }
}

/// Takes the ways by which parts have come together, from the energies of a state.
pub fn take_approaches(state: &State, rows: &mut [PairRow]) {
    for row in rows {
        let force = size(row.force);
        row.approach =
            if force > 0.0 { 2.0 * state.energy.of_the_model().max(0.0) / force } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a pair is measured again where it carries a tenth more, or more at all at the end of a step;
    /// whatever the units. The first force is measured, none is not.
    #[test]
    fn a_pair_is_measured_where_it_carries_more() {
        for unit in [1e-12, 1.0, 1e12] {
            let heaviest = Heaviest { force: 10.0 * unit, ..Heaviest::default() };
            let passed =
                |force: f64| [false, true].map(|last| heaviest.is_passed(force * unit, last));
            assert_eq!([9.9, 10.9, 11.1].map(passed), [[false; 2], [false, true], [true; 2]]);
            let none = Heaviest::default();
            assert_eq!([0.0, unit].map(|force| none.is_passed(force, false)), [false, true]);
        }
    }
}
