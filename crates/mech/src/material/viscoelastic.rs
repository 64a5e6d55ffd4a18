//! Materials that relax: the stress of an elastic law, of which a part fades with time.
//!
//! ```text
//!   stress |\                       g(t) = 1 - sum g_i (1 - exp(-t/tau_i))
//!          | \__                    g_i: part of the shape that fades, k_i: of the volume
//!          |    \_____              tau_i: in this time
//!          |          ------- long
//!          +------------------ t
//! ```
//!
//! Every term has a stress of its own, which grows with that of the law and decays. Over an increment
//! the stress of the law runs straight and the decay is exact, whatever the increment is [simo1998],
//! section 10.2: docs/theory.md eqs. (3.87) to (3.89). Linear laws are taken to large strain as in
//! `logarithmic.rs`; of rubber the stress that keeps the volume decays in the undeformed body
//! [simo1987], eqs. (3.90) and (3.91).
//!
//! State variables: strain that keeps the volume (six), change of volume; stress of the law to both
//! (six and one); work that relaxing saved, energy that it took, difference of the creep strains that
//! both ends of the increment stand for; then of every term the stress to both strains (seven).

use super::answer::Answer;
use super::elastic::Elastic;
use super::hyperelastic::Rubber;
use super::logarithmic;
use super::tensor::{
    Matrix, Moduli, Symmetric, UNIT, add, add_dyad, add_pair, add_unit, carried, contract,
    deformation, deviator, dilation, inverse, right, trace,
};

const STRAIN: usize = 0;
const VOLUME: usize = 6;
const STRESS: usize = 7;
const PRESSURE: usize = 13;
const SAVED: usize = 14;
const TAKEN: usize = 15;
const DIFFERENCE: usize = 16;
const TERMS: usize = 17;
/// State variables of a term.
const TERM: usize = 7;

/// A term of a Prony series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxation {
    /// Part of the stress against a change of shape that fades [1].
    pub shear: f64,
    /// Part of the pressure that fades [1].
    pub bulk: f64,
    /// Time in which it does [T].
    pub time: f64,
}

/// What is left of the stress of a term after a time that passes, and what is left of an increment
/// of the stress of the law that runs straight over it: docs/theory.md eq. (3.89).
fn left_after(passed: f64, time: f64) -> [f64; 2] {
    let ratio = passed / time;
    let [kept, gone] = [(-ratio).exp(), -(-ratio).exp_m1()];
    [kept, if ratio == 0.0 { 1.0 } else { gone / ratio }]
}

/// An elastic law that relaxes.
#[derive(Debug, Clone, PartialEq)]
pub struct Viscoelastic<M> {
    /// What it answers at once: linear elasticity or rubber, also over temperature.
    pub law: M,
    /// What fades of it.
    pub series: Vec<Relaxation>,
}

/// Difference of the creep strains of an increment by the rates at its two ends [1].
pub(super) fn difference(state: &[f64]) -> Option<f64> {
    state.get(DIFFERENCE).copied()
}

/// What relaxes, at one temperature.
pub(super) enum Elasticity<'a> {
    Linear(&'a Elastic),
    Rubber(&'a Rubber),
}

/// What the law answers at once.
struct AtOnce {
    /// Strain that keeps the volume, and change of volume [1].
    strain: (Symmetric, f64),
    /// Stresses that do work on them [F/L2].
    stress: (Symmetric, f64),
    /// Moduli of small strains: shear, bulk [F/L2].
    moduli: [f64; 2],
}

/// What the past leaves of the stresses: a part of those of the law, and what does not depend on the
/// strain of now.
struct Remembered {
    /// Parts of the stress and of the pressure [1].
    parts: [f64; 2],
    /// Stress and pressure of the past [F/L2].
    past: (Symmetric, f64),
}

impl<M> Viscoelastic<M> {
    /// Number of state variables of a point.
    pub fn states(&self) -> usize {
        TERMS + TERM * self.series.len()
    }

    /// Answers a displacement gradient with a law of one temperature.
    pub(super) fn respond(
        &self,
        law: Elasticity<'_>,
        (gradient, large): (&Matrix, bool),
        passed: f64,
        (committed, state): (&[f64], &mut [f64]),
    ) -> Answer {
        let elastic = match (law, large) {
            (Elasticity::Rubber(rubber), true) => {
                return self.rubber(rubber, gradient, passed, (committed, state));
            }
            (Elasticity::Rubber(rubber), false) => rubber.small(),
            (Elasticity::Linear(elastic), _) => *elastic,
        };
        let mut linear =
            |strain: &Symmetric| self.linear(&elastic, strain, passed, (committed, &mut *state));
        match large {
            true => logarithmic::answer(gradient, linear),
            false => linear(&super::tensor::symmetric(gradient)),
        }
    }

    /// Answer of a linear law to a small strain.
    fn linear(
        &self,
        elastic: &Elastic,
        strain: &Symmetric,
        passed: f64,
        (committed, state): (&[f64], &mut [f64]),
    ) -> Answer {
        let at_once = elastic.small(strain);
        let volume = trace(strain);
        let [shear, bulk] = [elastic.shear_modulus(), elastic.bulk_modulus()];
        let now = AtOnce {
            strain: (deviator(strain), volume),
            stress: (deviator(&at_once.stress), bulk * volume),
            moduli: [shear, bulk],
        };
        let Remembered { parts, past } = self.remember(&now, passed, committed, state);
        let pressure = parts[1] * now.stress.1 + past.1;
        let shape = add(&past.0, parts[0], &now.stress.0);
        let mut moduli = [[0.0; 6]; 6];
        add_unit(&mut moduli, 2.0 * parts[0] * shear);
        add_dyad(&mut moduli, parts[1] * bulk - 2.0 / 3.0 * parts[0] * shear, &UNIT);
        Answer {
            stress: add(&shape, pressure, &UNIT),
            moduli,
            energy: at_once.energy + state[SAVED],
            dissipation: state[TAKEN],
        }
    }

    /// Answer of rubber to a deformation.
    fn rubber(
        &self,
        rubber: &Rubber,
        gradient: &Matrix,
        passed: f64,
        (committed, state): (&[f64], &mut [f64]),
    ) -> Answer {
        let at_once = rubber.large(gradient);
        let dilation = dilation(gradient);
        let [pressure, slope] = rubber.volume_stress(dilation);
        let volume = 1.0 + dilation;
        let even = (-dilation.ln_1p() / 3.0).exp();
        // of the same volume: F/J^(1/3), and (C/J^(2/3) - 1)/2
        let f = deformation(gradient).map(|row| row.map(|entry| even * entry));
        let stretched = right(gradient).map(|entry| 0.5 * even * even * entry);
        let shrunk = 0.5 * (-2.0 / 3.0 * dilation.ln_1p()).exp_m1();
        let now = AtOnce {
            strain: (add(&stretched, shrunk, &UNIT), dilation),
            stress: (carried(&inverse(&f).0, &deviator(&at_once.stress)), pressure),
            moduli: [rubber.shear_modulus(), rubber.bulk_modulus()],
        };
        let Remembered { parts: [shape, bulk], past } =
            self.remember(&now, passed, committed, state);
        let past = (carried(&f, &past.0), volume * past.1);
        // the law with its two parts: all of it by one, the pressure by what the other has more
        let more = bulk - shape;
        let mut stress = at_once.stress.map(|entry| shape * entry);
        let mut moduli = at_once.moduli.map(|row| row.map(|entry| shape * entry));
        let held = more * volume * pressure + past.1;
        stress = add(&add(&stress, 1.0, &deviator(&past.0)), held, &UNIT);
        add_dyad(&mut moduli, held + more * volume * volume * slope, &UNIT);
        add_unit(&mut moduli, -2.0 * held);
        add_past(&mut moduli, &past.0);
        let energy = at_once.energy + state[SAVED];
        Answer { stress, moduli, energy, dissipation: state[TAKEN] }
    }

    /// Takes the stresses of the law into those of the terms.
    fn remember(
        &self,
        now: &AtOnce,
        passed: f64,
        committed: &[f64],
        state: &mut [f64],
    ) -> Remembered {
        state.copy_from_slice(committed);
        let before = (six(committed, STRESS), committed[PRESSURE]);
        let grown = (add(&now.stress.0, -1.0, &before.0), now.stress.1 - before.1);
        let [shear, bulk] = now.moduli;
        let mut remembered = Remembered { parts: [1.0; 2], past: ([0.0; 6], 0.0) };
        // stresses that the law has more than the body, before and now
        let (mut missing, mut missing_now) = (([0.0; 6], 0.0), ([0.0; 6], 0.0));
        let mut faster = [0.0; 6];
        for (k, term) in self.series.iter().enumerate() {
            let at = TERMS + TERM * k;
            let held = (six(committed, at), committed[at + 6]);
            let [kept, taken] = left_after(passed, term.time);
            let past = (
                add(&held.0.map(|stress| kept * stress), -taken * term.shear, &before.0),
                kept * held.1 - taken * term.bulk * before.1,
            );
            let own = (
                add(&past.0, taken * term.shear, &now.stress.0),
                past.1 + taken * term.bulk * now.stress.1,
            );
            remembered.past = (add(&remembered.past.0, 1.0, &past.0), remembered.past.1 + past.1);
            remembered.parts[0] -= term.shear * (1.0 - taken);
            remembered.parts[1] -= term.bulk * (1.0 - taken);
            missing = missed(missing, term, &before, &held);
            missing_now = missed(missing_now, term, &now.stress, &own);
            state[TAKEN] += taken_by(term, &grown, (&held, &own), [shear, bulk]);
            let change = add(&own.0, -1.0, &held.0);
            faster = add(&faster, 0.5 / (shear * term.time), &change);
            state[at..at + 6].copy_from_slice(&own.0);
            state[at + 6] = own.1;
        }
        let strained = add(&now.strain.0, -1.0, &six(committed, STRAIN));
        let mean = add(&missing.0, 1.0, &missing_now.0);
        state[SAVED] -= 0.5 * contract(&mean, &strained)
            + 0.5 * (missing.1 + missing_now.1) * (now.strain.1 - committed[VOLUME]);
        state[DIFFERENCE] = match passed.is_finite() {
            true => passed * (2.0 / 3.0 * contract(&faster, &faster)).sqrt(),
            false => 0.0,
        };
        state[STRAIN..VOLUME].copy_from_slice(&now.strain.0);
        state[VOLUME] = now.strain.1;
        state[STRESS..PRESSURE].copy_from_slice(&now.stress.0);
        state[PRESSURE] = now.stress.1;
        remembered
    }
}

/// Six state variables.
fn six(state: &[f64], at: usize) -> Symmetric {
    std::array::from_fn(|k| state[at + k])
}

/// Adds what a term has lost of its part of the stresses of the law.
fn missed(
    sum: (Symmetric, f64),
    term: &Relaxation,
    law: &(Symmetric, f64),
    own: &(Symmetric, f64),
) -> (Symmetric, f64) {
    let shape = add(&add(&sum.0, term.shear, &law.0), -1.0, &own.0);
    (shape, sum.1 + term.bulk * law.1 - own.1)
}

/// Energy that a term takes on an increment [F/L2]: the mean of its stresses times the strain by which
/// its spring falls behind, docs/theory.md eq. (3.92).
fn taken_by(
    term: &Relaxation,
    grown: &(Symmetric, f64),
    (held, own): (&(Symmetric, f64), &(Symmetric, f64)),
    [shear, bulk]: [f64; 2],
) -> f64 {
    let mut taken = 0.0;
    if term.shear > 0.0 {
        let behind =
            add(&grown.0.map(|stress| term.shear * stress), -1.0, &add(&own.0, -1.0, &held.0));
        let mean = add(&held.0, 1.0, &own.0);
        taken += 0.25 * contract(&mean, &behind) / (term.shear * shear);
    }
    if term.bulk > 0.0 {
        let behind = term.bulk * grown.1 - (own.1 - held.1);
        taken += 0.5 * (held.1 + own.1) * behind / (term.bulk * bulk);
    }
    taken
}

/// Adds the moduli of a stress of the past that keeps the volume, carried to now:
/// docs/theory.md eq. (3.91).
fn add_past(moduli: &mut Moduli, past: &Symmetric) {
    let sum = trace(past);
    add_pair(moduli, -2.0 / 3.0, past, &UNIT);
    add_unit(moduli, 2.0 / 3.0 * sum);
    add_dyad(moduli, 2.0 / 9.0 * sum, &UNIT);
}
