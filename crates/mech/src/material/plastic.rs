//! Metals: elastic until von Mises' stress reaches the yield stress, then plastic at constant volume.
//!
//! ```text
//!   stress |      ______ table of yield stress and plastic strain, straight between
//!          |   __/
//!          |  /          b_e = F Cp^-1 F'   elastic part of the deformation
//!          | /           plastic flow along the deviator of the Kirchhoff stress
//!          |/_________
//! ```
//!
//! Return along the radius, exact on every straight piece of the table [simo1998], section 3.3; at
//! large strain in principal logarithmic strains, where the same algorithm holds [simo1992b].
//! docs/theory.md eqs. (3.44) to (3.47). Where hardening moves the yield surface the centre has
//! directions of its own: then small strain is taken to large strain as in `logarithmic.rs`.
//!
//! State variables: Cp^-1 - 1 (six; less twice the plastic strain where strains are small or the
//! surface moves), equivalent plastic strain, plastic work per volume, back stresses (six each).

use super::answer::Answer;
use super::back_stress::BackStress;
use super::elastic::Elastic;
use super::hardening::{Hardening, yield_stress};
use super::logarithmic;
use super::principal::Axes;
use super::tensor::{
    Matrix, Symmetric, add, add_dyad, add_pair, add_unit, carried, contract, deformation, deviator,
    inverse, left,
};

/// Index of the equivalent plastic strain among the state variables.
pub const PEEQ: usize = 6;
const WORK: usize = 7;
const BACK: usize = 8;

/// Part of a yield stress by which rounding may put a state beyond its surface [1].
const ROUNDING: f64 = 1e-10;

/// Whether a yield stress holds an equivalent trial stress: a state that has yielded and does not move stands on
/// its surface to rounding and answers elastically, for it may be unloaded next.
fn is_held(trial: f64, stress: f64) -> bool {
    trial <= stress * (1.0 + ROUNDING)
}

/// An elastic material that yields.
#[derive(Debug, Clone, PartialEq)]
pub struct Plastic {
    /// Elasticity.
    pub elastic: Elastic,
    /// Yield stress [F/L2] and plastic strain [1], strains ascending from zero; constant behind the
    /// last one.
    pub table: Hardening,
    /// What moves the yield surface; none: it stays.
    pub back_stresses: Vec<BackStress>,
}

/// What a return to the yield surface comes to.
struct Return {
    /// Increment of the equivalent plastic strain [1].
    strain: f64,
    /// The way of the flow, a unit tensor.
    way: Symmetric,
    /// Equivalent stress from the centre that is kept to the trial stress [F/L2].
    trial: f64,
    /// By how much the trial stress grows with the increment [F/L2].
    slope: f64,
    /// What recall takes of the centre for a unit of the increment, across the way [F/L2].
    recalled: Symmetric,
    /// Work of the yield stress per volume [F/L2].
    work: f64,
}

/// An increment that is tried.
struct Excess {
    strain: f64,
    excess: f64,
    trial: f64,
    way: Symmetric,
    slope: f64,
    recalled: Symmetric,
}

/// A return along a radius: increment, slope of the yield stress there, work.
struct Radial {
    strain: f64,
    slope: f64,
    work: f64,
}

impl Plastic {
    /// Number of state variables of a point.
    pub fn states(&self) -> usize {
        BACK + 6 * self.back_stresses.len()
    }

    /// Begins a point with an equivalent plastic strain [1] and a first back stress [F/L2], of which the
    /// deviator counts; false where no back stress can be.
    pub(super) fn harden(&self, strain: f64, first: &Symmetric, state: &mut [f64]) -> bool {
        let moves = first.iter().any(|part| *part != 0.0);
        if state.len() < self.states() || (moves && self.back_stresses.is_empty()) {
            return false;
        }
        state[PEEQ] = strain;
        if moves {
            state[BACK..BACK + 6].copy_from_slice(&deviator(first));
        }
        true
    }

    /// Yield stress and its slope at an equivalent plastic strain.
    pub(super) fn yield_stress(&self, strain: f64) -> [f64; 2] {
        yield_stress(&self.table, strain)
    }

    /// Returns an equivalent trial stress to a yield surface that stays; `None`: it is inside.
    fn radial(&self, trial: f64, before: f64) -> Option<Radial> {
        let three = 3.0 * self.elastic.shear_modulus();
        let [start, mut slope] = self.yield_stress(before);
        if is_held(trial, start) {
            return None;
        }
        let (mut at, mut stress, mut work) = (before, start, 0.0);
        let mut ends = self.table.iter().map(|line| line[1]).filter(|end| *end > before);
        loop {
            let step = (trial - three * (at - before) - stress) / (three + slope);
            let end = ends.next().unwrap_or(f64::INFINITY);
            let room = (end - at).min(step);
            work += room * (stress + 0.5 * slope * room);
            at += room;
            if step <= end - (at - room) || !end.is_finite() {
                return Some(Radial { strain: at - before, slope, work });
            }
            [stress, slope] = self.yield_stress(end);
        }
    }

    /// Returns a deviator to the yield surface; `None`: it is inside.
    fn back(&self, deviator: &Symmetric, committed: &[f64]) -> Option<Return> {
        let before = committed[PEEQ];
        let centre = self.centre(committed, 0.0);
        let relative = add(deviator, -1.0, &centre);
        let trial = (1.5 * contract(&relative, &relative)).sqrt();
        if self.back_stresses.is_empty() {
            let Radial { strain, slope, work } = self.radial(trial, before)?;
            let way = relative.map(|s| 1.5f64.sqrt() * s / trial);
            let slope = 3.0 * self.elastic.shear_modulus() + slope;
            return Some(Return { strain, way, trial, slope, recalled: [0.0; 6], work });
        }
        if is_held(trial, self.yield_stress(before)[0]) {
            return None;
        }
        Some(self.moving(deviator, committed))
    }

    /// Returns a deviator to a yield surface that moves, docs/theory.md eq. (3.69): Newton's steps,
    /// halves where they leave what encloses the answer.
    fn moving(&self, deviator: &Symmetric, committed: &[f64]) -> Return {
        let three = 3.0 * self.elastic.shear_modulus();
        let sizes = committed[BACK..].as_chunks::<6>().0.iter();
        let size = |tensor: &Symmetric| (1.5 * contract(tensor, tensor)).sqrt();
        let reach = size(deviator) + sizes.map(size).sum::<f64>();
        let (mut low, mut high) = (0.0, reach / three);
        let mut at = self.excess_at(deviator, committed, 0.0);
        // every halving gains a digit of two: all of them are found
        for _ in 0..2 * f64::MANTISSA_DIGITS {
            if at.excess > 0.0 {
                low = at.strain
            } else {
                high = at.strain
            }
            let step = at.strain + at.excess / at.slope;
            let inside = at.slope > 0.0 && low < step && step < high;
            let next = if inside { step } else { 0.5 * (low + high) };
            if (next - at.strain).abs() <= f64::EPSILON * high || at.excess == 0.0 {
                break;
            }
            at = self.excess_at(deviator, committed, next);
        }
        let before = committed[PEEQ];
        let work = self.work(before, at.strain);
        let lost = contract(&at.recalled, &at.way);
        let recalled = add(&at.recalled, -lost, &at.way);
        let Excess { strain, way, trial, slope, .. } = at;
        Return { strain, way, trial, slope, recalled, work }
    }

    /// How far the stress of an increment lies outside of the moved surface.
    fn excess_at(&self, deviator: &Symmetric, committed: &[f64], strain: f64) -> Excess {
        let before = committed[PEEQ];
        let relative = add(deviator, -1.0, &self.centre(committed, strain));
        let size = contract(&relative, &relative).sqrt();
        let (trial, way) = (1.5f64.sqrt() * size, relative.map(|s| s / size));
        let three = 3.0 * self.elastic.shear_modulus();
        let [stress, hardening] = self.yield_stress(before + strain);
        let (mut held, mut slope) = (three * strain + stress, three + hardening);
        let mut recalled = [0.0; 6];
        let centres = committed[BACK..].as_chunks::<6>().0.iter();
        for (own, centre) in self.back_stresses.iter().zip(centres) {
            let [_, rise] = own.rise(before, strain);
            let [lost, growth] = own.slopes(before, strain);
            held += rise;
            slope += growth;
            recalled = add(&recalled, -lost, centre);
        }
        slope -= 1.5f64.sqrt() * contract(&way, &recalled);
        Excess { strain, excess: trial - held, trial, way, slope, recalled }
    }

    /// Sum of what an increment keeps of the back stresses.
    fn centre(&self, committed: &[f64], strain: f64) -> Symmetric {
        let centres = committed[BACK..].as_chunks::<6>().0.iter();
        let own = self.back_stresses.iter().zip(centres);
        own.fold([0.0; 6], |sum, (own, centre)| {
            add(&sum, own.rise(committed[PEEQ], strain)[0], centre)
        })
    }

    /// Work of the yield stress on an increment: exact on every straight piece.
    pub(super) fn work(&self, before: f64, strain: f64) -> f64 {
        let (mut at, end, mut work) = (before, before + strain, 0.0);
        let ends =
            self.table.iter().map(|line| line[1]).filter(|line| *line > before && *line < end);
        for to in ends.chain([end]) {
            let [stress, slope] = self.yield_stress(at);
            work += (to - at) * (stress + 0.5 * slope * (to - at));
            at = to;
        }
        work
    }

    /// Answer to a small strain.
    pub fn small(&self, strain: &Symmetric, committed: &[f64], state: &mut [f64]) -> Answer {
        state.copy_from_slice(committed);
        let plastic: Symmetric = std::array::from_fn(|k| -0.5 * committed[k]);
        let mut elastic = add(strain, -1.0, &plastic);
        let mut stress = self.elastic.stress(&elastic);
        let mut moduli = self.elastic.moduli();
        let shear = self.elastic.shear_modulus();
        if let Some(back) = self.back(&deviator(&stress), committed) {
            let way = back.way;
            let amount = 1.5f64.sqrt() * back.strain;
            stress = add(&stress, -2.0 * shear * amount, &way);
            elastic = add(&elastic, -amount, &way);
            (0..6).for_each(|k| state[k] -= 2.0 * amount * way[k]);
            self.note(&back, state);
            let kept = 3.0 * shear * back.strain / back.trial;
            add_unit(&mut moduli, -2.0 * shear * kept);
            (0..3).for_each(|i| (0..3).for_each(|j| moduli[i][j] += 2.0 / 3.0 * shear * kept));
            let tangent = 3.0 * shear / back.slope - kept;
            add_dyad(&mut moduli, -2.0 * shear * tangent, &way);
            // the symmetric part of what recall makes of the moduli
            let half = -0.5 * kept * 6f64.sqrt() * shear / back.slope;
            add_pair(&mut moduli, half, &back.recalled, &way);
        }
        let energy = 0.5 * contract(&stress, &elastic) + state[WORK];
        Answer { stress, moduli, energy, dissipation: state[WORK] }
    }

    /// Answer to a deformation.
    pub fn large(&self, gradient: &Matrix, committed: &[f64], state: &mut [f64]) -> Answer {
        if self.back_stresses.is_empty() {
            return self.multiplicative(gradient, committed, state);
        }
        logarithmic::answer(gradient, |strain| self.small(strain, committed, state))
    }

    /// Answer to a deformation where the yield surface stays in its place.
    fn multiplicative(&self, gradient: &Matrix, committed: &[f64], state: &mut [f64]) -> Answer {
        state.copy_from_slice(committed);
        let f = deformation(gradient);
        let plastic: Symmetric = std::array::from_fn(|k| committed[k]);
        let axes = Axes::of(&add(&left(gradient), 1.0, &carried(&f, &plastic)));
        let (mut stresses, mut slopes, _) = self.elastic.principal(&axes.logs);
        let mut logs = axes.logs;
        let mean = (stresses[0] + stresses[1] + stresses[2]) / 3.0;
        let s = stresses.map(|stress| stress - mean);
        let size = (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]).sqrt();
        let trial = 1.5f64.sqrt() * size;
        if let Some(back) = self.radial(trial, committed[PEEQ]) {
            let shear = self.elastic.shear_modulus();
            let way = s.map(|s| s / size);
            let amount = 1.5f64.sqrt() * back.strain;
            let kept = 3.0 * shear * back.strain / trial;
            let tangent = 3.0 * shear / (3.0 * shear + back.slope) - kept;
            for a in 0..3 {
                stresses[a] -= 2.0 * shear * amount * way[a];
                logs[a] -= amount * way[a];
                slopes[a][a] -= 2.0 * shear * kept;
                for b in 0..3 {
                    slopes[a][b] += 2.0 * shear * (kept / 3.0 - tangent * way[a] * way[b]);
                }
            }
            // Cp^-1 = F^-1 b_e F^-T
            let elastic = axes.tensor(&logs.map(|log| (2.0 * log).exp_m1()));
            self.keep(&f, gradient, &elastic, state);
            state[PEEQ] += back.strain;
            state[WORK] += back.work;
        }
        let stored = 0.5 * (0..3).map(|a| stresses[a] * logs[a]).sum::<f64>();
        let answer = axes.answer(&stresses, &slopes, stored + state[WORK]);
        Answer { dissipation: state[WORK], ..answer }
    }

    /// Keeps Cp^-1 - 1 = F^-1 (b_e - b) F^-T, of b_e - 1.
    fn keep(&self, f: &Matrix, gradient: &Matrix, elastic: &Symmetric, state: &mut [f64]) {
        let (back, _) = inverse(f);
        let plastic = carried(&back, &add(elastic, -1.0, &left(gradient)));
        state[..6].copy_from_slice(&plastic);
    }

    /// Notes strain, work and the moved surface of a return.
    fn note(&self, back: &Return, state: &mut [f64]) {
        let before = state[PEEQ];
        state[PEEQ] += back.strain;
        state[WORK] += back.work;
        let flow = 1.5f64.sqrt() * back.strain;
        let mut held = 0.0;
        let moved = state[BACK..].as_chunks_mut::<6>().0.iter_mut();
        for (own, stress) in self.back_stresses.iter().zip(moved) {
            let [kept, rise] = own.rise(before, back.strain);
            let now = add(&stress.map(|s| kept * s), (2.0 / 3.0f64).sqrt() * rise, &back.way);
            let mean = add(&now, 1.0, stress).map(|s| 0.5 * s);
            held += flow * contract(&mean, &back.way);
            *stress = now;
        }
        state[WORK] += held;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// det Cp^-1, one where flow keeps the volume.
    fn volume(a: &Symmetric) -> f64 {
        let mut b = *a;
        (0..3).for_each(|k| b[k] += 1.0);
        super::super::tensor::determinant(&super::super::tensor::full(&b))
    }

    fn steel() -> Plastic {
        Plastic {
            elastic: Elastic { modulus: 200.0, poisson: 0.3 },
            table: vec![[1.0, 0.0], [1.5, 0.1], [1.6, 0.4]],
            back_stresses: Vec::new(),
        }
    }

    /// Requirement: a stretch far beyond the table's first pieces ends on the table. Source: the
    /// table. Tolerance: rounding.
    #[test]
    fn the_stress_ends_on_the_table() {
        let steel = steel();
        for (amount, before) in [(0.02, 0.0), (0.2, 0.0), (0.9, 0.0), (0.3, 0.05), (3.0, 1.0)] {
            let mut committed = vec![0.0; 8];
            committed[PEEQ] = before;
            let mut state = vec![0.0; 8];
            let strain = [amount, -0.5 * amount, -0.5 * amount, 0.1 * amount, 0.0, 0.0];
            let answer = steel.small(&strain, &committed, &mut state);
            let exact = steel.yield_stress(state[PEEQ])[0];
            assert!((super::super::tensor::mises(&answer.stress) - exact).abs() < 1e-12);
            assert!(super::super::tensor::trace(&std::array::from_fn(|k| state[k])).abs() < 1e-14);
            let large = [[amount, 0.1 * amount, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
            let answer = steel.large(&large, &committed, &mut state);
            let exact = steel.yield_stress(state[PEEQ])[0];
            assert!((super::super::tensor::mises(&answer.stress) - exact).abs() < 1e-11);
            let flow: Symmetric = std::array::from_fn(|k| state[k]);
            assert!((volume(&flow) - 1.0).abs() < 1e-12, "{}", volume(&flow));
        }
    }

    /// Requirement: tension in one direction follows sigma = yield stress of the plastic strain
    /// left when the elastic part is taken away, at small and at large strain (there in logarithmic
    /// strain and Kirchhoff stress), and unloads elastically. Source: definition of the table.
    #[test]
    fn tension_in_one_direction() {
        let steel = steel();
        // the strain across is found by bisection so that nothing pulls there
        let pull = |large: bool, log: f64, committed: &[f64], state: &mut [f64]| {
            let mut answer = Answer::default();
            let (mut low, mut high) = (-2.0, 2.0);
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                answer = if large {
                    let [x, y]: [f64; 2] = [log, middle];
                    let h =
                        [[x.exp_m1(), 0.0, 0.0], [0.0, y.exp_m1(), 0.0], [0.0, 0.0, y.exp_m1()]];
                    steel.large(&h, committed, state)
                } else {
                    steel.small(&[log, middle, middle, 0.0, 0.0, 0.0], committed, state)
                };
                if answer.stress[1] > 0.0 { high = middle } else { low = middle }
            }
            answer.stress[0]
        };
        for large in [false, true] {
            let (mut first, mut second) = (vec![0.0; 8], vec![0.0; 8]);
            let stress = pull(large, 0.15, &[0.0; 8], &mut first);
            let exact = steel.yield_stress(0.15 - stress / 200.0)[0];
            assert!((stress - exact).abs() < 1e-9, "{large} {stress} {exact}");
            assert!((first[PEEQ] - (0.15 - stress / 200.0)).abs() < 1e-9);
            let less = pull(large, 0.148, &first, &mut second);
            assert!((stress - less - 0.4).abs() < 1e-9, "{large} {less}");
            assert_eq!(second[PEEQ], first[PEEQ]);
        }
    }

    /// Requirement: linear kinematic hardening: after tension the yield stress in compression is
    /// lower by twice what it rose (Bauschinger). Source: definition. Tolerance: rounding.
    #[test]
    fn the_yield_surface_moves() {
        let steel = Plastic {
            table: vec![[1.0, 0.0]],
            back_stresses: vec![BackStress::Evolving { modulus: 10.0, recall: 0.0 }],
            ..steel()
        };
        let mut state = vec![0.0; 14];
        // pure shear: eps12 gives sigma12, yield at 1/sqrt 3
        let shear = |strain: f64, from: &[f64], state: &mut Vec<f64>| {
            steel.small(&[0.0, 0.0, 0.0, strain, 0.0, 0.0], from, state).stress[3]
        };
        let start = vec![0.0; 14];
        let up = shear(0.05, &start, &mut state);
        let peeq = state[PEEQ];
        assert!((up - (1.0 + 10.0 * peeq) / 3f64.sqrt()).abs() < 1e-13);
        let from = state.clone();
        let g = 200.0 / 2.6;
        let turn = 0.05 - (2.0 / 3f64.sqrt()) / (2.0 * g);
        let down = shear(turn + 1e-9, &from, &mut state);
        assert_eq!(state[PEEQ], peeq);
        assert!((up - down - 2.0 / 3f64.sqrt()).abs() < 1e-6);
        shear(turn - 1e-6, &from, &mut state);
        assert!(state[PEEQ] > peeq);
    }
}
