//! Creep of metals and plastics: flow at any stress, with time, beside plastic flow.
//!
//! ```text
//!   creep  |      ___---       rate = A q^n t^m                    time hardening
//!   strain |  _--              rate = (A q^n ((m+1) e)^m)^(1/(m+1))   strain hardening
//!          | /                 q: von Mises' stress, e: creep strain so far
//!          +------------- t
//! ```
//!
//! Flow runs along the deviator, backward Euler in the stress and exact in time at that stress; the
//! size of the stress solves one equation, docs/theory.md eqs. (3.93) to (3.98). Small strain is taken
//! to large strain as in `logarithmic.rs`.
//!
//! State variables: less twice the strain that has flowed (six), equivalent plastic strain, work of
//! flow per volume, creep strain (six), equivalent creep strain, deviator of the stress (six),
//! difference of the creep strains that both ends of the increment stand for.

use super::answer::{Answer, Clock, Conditions};
use super::elastic::Elastic;
use super::expansion::between;
use super::logarithmic;
use super::plastic::{PEEQ, Plastic};
use super::tensor::{
    Matrix, Symmetric, UNIT, add, add_dyad, add_unit, contract, deviator, symmetric, trace,
};

const WORK: usize = 7;
const CREEP: usize = 8;
/// Index of the equivalent creep strain among the state variables.
pub const CEEQ: usize = 14;
const STRESS: usize = 15;
const DIFFERENCE: usize = 21;
/// State variables of a point.
pub const STATES: usize = 22;

/// What makes creep slower with time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CreepHardening {
    /// The strain so far.
    Strain,
    /// The total time.
    Time,
}

/// Constants of a power law at a temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    /// A, of the dimension [(L2/F)^n T^-(1+m)].
    pub factor: f64,
    /// n, the power of the stress [1].
    pub stress: f64,
    /// m, the power of the time, above -1 [1].
    pub time: f64,
}

/// A metal or a plastic that creeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Creeping<M> {
    /// Elastic, or a metal whose yield surface grows; also over temperature.
    pub metal: M,
    /// What makes it slower.
    pub hardening: CreepHardening,
    /// The law over temperature, ascending.
    pub law: Vec<(f64, PowerLaw)>,
    /// Whether, while time passes, the stress beyond the yield stress alone drives creep, and creep
    /// raises the yield stress as plastic flow does: CalculiX' law of both.
    pub beyond_yield: bool,
}

/// An increment of time, and what came before it.
#[derive(Debug, Clone, Copy)]
struct Passing {
    law: PowerLaw,
    hardening: CreepHardening,
    /// Time that passes, and the total time at its end [T].
    times: [f64; 2],
    /// Equivalent creep strain before [1].
    before: f64,
}

impl Passing {
    /// Creep strain of the increment at a stress, and its derivative by it: docs/theory.md eq. (3.94).
    fn strain(&self, stress: f64) -> [f64; 2] {
        let [passed, end] = self.times;
        let PowerLaw { factor, stress: power, time } = self.law;
        if stress <= 0.0 || passed <= 0.0 {
            return [0.0; 2];
        }
        let once = time + 1.0;
        let rate = factor * stress.powf(power);
        match self.hardening {
            CreepHardening::Time => {
                let strain = rate * self.span(passed, end);
                [strain, power * strain / stress]
            }
            CreepHardening::Strain => {
                // e^(1/(m+1)) grows evenly
                let step = (rate / once).powf(1.0 / once) * passed;
                let root = self.before.powf(1.0 / once);
                let strain = match root > 0.0 {
                    true => self.before * (once * (step / root).ln_1p()).exp_m1(),
                    false => step.powf(once),
                };
                [strain, power * (root + step).powf(time) * step / stress]
            }
        }
    }

    /// Integral of t^m over the increment.
    fn span(&self, passed: f64, end: f64) -> f64 {
        let once = self.law.time + 1.0;
        if self.law.time == 0.0 {
            return passed;
        }
        let end = end.max(passed);
        -end.powf(once) * (once * (-passed / end).ln_1p()).exp_m1() / once
    }
}

/// What an increment comes to.
struct Flow {
    /// Equivalent stress [F/L2].
    stress: f64,
    /// Its derivative by the trial stress [1].
    slope: f64,
    /// Increments of the equivalent creep strain and plastic strain [1].
    strains: [f64; 2],
}

/// The root of a function that falls from zero to the right end: Newton's steps, halves where they
/// leave what encloses it or come nearer too slowly. The function gives value and slope.
fn falling(end: f64, of: impl Fn(f64) -> [f64; 2]) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let (mut at, mut last) = (end, end);
    // every halving gains a binary digit, of a root that may lie far below the end
    for _ in 0..20 * f64::MANTISSA_DIGITS {
        let [value, slope] = of(at);
        if value > 0.0 {
            low = at;
        } else {
            high = at;
        }
        let step = -value / slope;
        let inside = low <= at + step && at + step <= high;
        let next = if inside && step.abs() <= 0.5 * last { at + step } else { 0.5 * (low + high) };
        last = (next - at).abs();
        at = next;
        if last <= f64::EPSILON * at {
            break;
        }
    }
    at
}

/// Equivalent creep strain of a state [1].
pub(super) fn strain(state: &[f64]) -> Option<f64> {
    state.get(CEEQ).copied()
}

/// Difference of the creep strains of an increment by the stresses at its two ends [1].
pub(super) fn difference(state: &[f64]) -> Option<f64> {
    state.get(DIFFERENCE).copied()
}

impl<M> Creeping<M> {
    /// Answers a displacement gradient with elasticity and plasticity of one temperature.
    pub(super) fn respond(
        &self,
        (elastic, plastic): (&Elastic, Option<&Plastic>),
        gradient: &Matrix,
        under: &Conditions,
        (committed, state): (&[f64], &mut [f64]),
    ) -> Answer {
        let Some(law) = self.law_at(under.temperature) else { return Answer::default() };
        // nothing creeps where all time there is stands for elasticity alone
        let Clock { passed, total } = under.clock;
        let passed = if passed.is_finite() { passed } else { 0.0 };
        let before = committed[CEEQ];
        let times = [passed, total];
        let passing = Passing { law, hardening: self.hardening, times, before };
        let metal = Metal { elastic, plastic, passing, one_strain: self.beyond_yield };
        let mut small = |strain: &Symmetric| metal.small(strain, committed, &mut *state);
        match under.large {
            true => logarithmic::answer(gradient, small),
            false => small(&symmetric(gradient)),
        }
    }

    /// The power law at a temperature.
    fn law_at(&self, temperature: f64) -> Option<PowerLaw> {
        let (low, high, part) = between(&self.law, temperature)?;
        let number = |low: f64, high: f64| low + part * (high - low);
        Some(PowerLaw {
            factor: number(low.factor, high.factor),
            stress: number(low.stress, high.stress),
            time: number(low.time, high.time),
        })
    }
}

/// A metal of one temperature in an increment of time.
struct Metal<'a> {
    elastic: &'a Elastic,
    plastic: Option<&'a Plastic>,
    passing: Passing,
    /// Whether creep raises the yield stress.
    one_strain: bool,
}

impl Metal<'_> {
    /// Answer to a small strain.
    fn small(&self, strain: &Symmetric, committed: &[f64], state: &mut [f64]) -> Answer {
        state.copy_from_slice(committed);
        let flowed: Symmetric = std::array::from_fn(|k| -0.5 * committed[k]);
        let mut elastic = add(strain, -1.0, &flowed);
        let [shear, bulk] = [self.elastic.shear_modulus(), self.elastic.bulk_modulus()];
        let trial = deviator(&elastic).map(|strain| 2.0 * shear * strain);
        let size = (1.5 * contract(&trial, &trial)).sqrt();
        let flow = self.flow(size, committed);
        let [kept, slope] = match size > 0.0 {
            true => [flow.stress / size, flow.slope],
            false => [1.0; 2],
        };
        let shape = trial.map(|stress| kept * stress);
        if size > 0.0 {
            let [creep, plastic] = flow.strains;
            let way = trial.map(|stress| 1.5 * stress / size);
            elastic = add(&elastic, -(creep + plastic), &way);
            self.note((&way, &flow), &shape, state);
        }
        state[STRESS..DIFFERENCE].copy_from_slice(&shape);
        state[DIFFERENCE] = self.difference(&flow, committed);
        let mut moduli = [[0.0; 6]; 6];
        add_unit(&mut moduli, 2.0 * shear * kept);
        add_dyad(&mut moduli, bulk - 2.0 / 3.0 * shear * kept, &UNIT);
        if size > 0.0 {
            let factor = 3.0 * shear * (slope - kept) / (size * size);
            add_dyad(&mut moduli, factor, &trial);
        }
        let stress = add(&shape, bulk * trace(strain), &UNIT);
        let energy = 0.5 * contract(&stress, &elastic) + state[WORK];
        Answer { stress, moduli, energy, dissipation: state[WORK] }
    }

    /// What an equivalent trial stress flows to: creep alone, or creep at the yield stress,
    /// docs/theory.md eqs. (3.95) and (3.96).
    fn flow(&self, trial: f64, committed: &[f64]) -> Flow {
        let three = 3.0 * self.elastic.shear_modulus();
        let before = self.flowed(committed);
        if let Some(metal) = self.driving() {
            return self.driven_flow(metal, trial, before);
        }
        let creep = |stress: f64| self.passing.strain(stress);
        let stress = falling(trial, |stress| {
            let [strain, slope] = creep(stress);
            [trial - stress - three * strain, -1.0 - three * slope]
        });
        let [strain, slope] = creep(stress);
        let alone = Flow { stress, slope: 1.0 / (1.0 + three * slope), strains: [strain, 0.0] };
        let Some(metal) = self.plastic else { return alone };
        if stress <= metal.yield_stress(before)[0] {
            return alone;
        }
        let plastic = falling(trial / three, |plastic| {
            let [stress, hardening] = metal.yield_stress(before + plastic);
            let [strain, slope] = creep(stress);
            let left = trial - stress - three * (plastic + strain);
            [left, -hardening * (1.0 + three * slope) - three]
        });
        let [stress, hardening] = metal.yield_stress(before + plastic);
        let [strain, slope] = creep(stress);
        let slope = hardening / (hardening * (1.0 + three * slope) + three);
        Flow { stress, slope, strains: [strain, plastic] }
    }

    /// The same where the stress beyond the yield stress drives creep: docs/theory.md eq. (3.98).
    fn driven_flow(&self, metal: &Plastic, trial: f64, before: f64) -> Flow {
        let three = 3.0 * self.elastic.shear_modulus();
        let most = trial - metal.yield_stress(before)[0];
        if most <= 0.0 {
            return Flow { stress: trial, slope: 1.0, strains: [0.0; 2] };
        }
        let beyond = falling(most, |beyond| {
            let [strain, slope] = self.passing.strain(beyond);
            let [stress, hardening] = metal.yield_stress(before + strain);
            [trial - three * strain - stress - beyond, -1.0 - (three + hardening) * slope]
        });
        let [strain, slope] = self.passing.strain(beyond);
        let [stress, hardening] = metal.yield_stress(before + strain);
        let slope = 1.0 - three * slope / (1.0 + (three + hardening) * slope);
        Flow { stress: stress + beyond, slope, strains: [strain, 0.0] }
    }

    /// The metal whose stress beyond the yield stress drives creep while time passes.
    fn driving(&self) -> Option<&Plastic> {
        self.plastic.filter(|_| self.one_strain && self.passing.times[0] > 0.0)
    }

    /// Strain that has raised the yield stress so far [1].
    fn flowed(&self, state: &[f64]) -> f64 {
        if self.one_strain { state[PEEQ] + state[CEEQ] } else { state[PEEQ] }
    }

    /// Notes strains and work of a flow along `way`, a tensor of unit equivalent strain.
    fn note(&self, (way, flow): (&Symmetric, &Flow), shape: &Symmetric, state: &mut [f64]) {
        let [creep, plastic] = flow.strains;
        let mean = add(shape, 1.0, &std::array::from_fn(|k| state[STRESS + k]));
        state[WORK] += 0.5 * creep * contract(&mean, way);
        state[WORK] += self.plastic.map_or(0.0, |metal| metal.work(self.flowed(state), plastic));
        for (k, way) in way.iter().enumerate() {
            state[k] -= 2.0 * (creep + plastic) * way;
            state[CREEP + k] += creep * way;
        }
        state[PEEQ] += plastic;
        state[CEEQ] += creep;
    }

    /// By how much the creep strain of the increment differs where its rate is that of the stress
    /// before: docs/theory.md eq. (3.97).
    fn difference(&self, flow: &Flow, committed: &[f64]) -> f64 {
        let before: Symmetric = std::array::from_fn(|k| committed[STRESS + k]);
        let stress = (1.5 * contract(&before, &before)).sqrt();
        let held = self.driving();
        let held = held.map_or(0.0, |metal| metal.yield_stress(self.flowed(committed))[0]);
        let stress = stress - held;
        (flow.strains[0] - self.passing.strain(stress)[0]).abs()
    }
}
