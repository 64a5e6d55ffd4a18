//! Creep and relaxation of a point.

use super::tensor::*;
use super::tests::{after, foretold, matrix, near, noise};
use super::*;
use proptest::prelude::*;
use std::sync::Arc;

const PLASTIC: Elastic = Elastic { modulus: 7.0, poisson: 0.3 };

fn term(shear: f64, bulk: f64, time: f64) -> Relaxation {
    Relaxation { shear, bulk, time }
}

/// A law that relaxes in two times.
fn relaxing(law: Material) -> Material {
    let series = vec![term(0.3, 0.1, 0.5), term(0.2, 0.0, 4.0)];
    Material::Viscoelastic(Box::new(Viscoelastic { law, series }))
}

fn elastic() -> Material {
    Material::Elastic(PLASTIC, LargeStrain::Logarithmic)
}

fn yielding() -> Material {
    let table = vec![[0.6, 0.0], [0.9, 0.1], [1.2, 0.6]];
    Material::Plastic(Plastic { elastic: PLASTIC, table, back_stresses: Vec::new() })
}

fn creeping(
    metal: Material,
    hardening: CreepHardening,
    [factor, stress, time]: [f64; 3],
) -> Material {
    let law = vec![(0.0, PowerLaw { factor, stress, time })];
    Material::Creeping(Box::new(Creeping { metal, hardening, law, beyond_yield: false }))
}

/// A metal of CalculiX that yields and creeps.
fn beyond_yield([factor, stress, time]: [f64; 3]) -> Material {
    let law = vec![(0.0, PowerLaw { factor, stress, time })];
    let hardening = CreepHardening::Time;
    let creeping = Creeping { metal: yielding(), hardening, law, beyond_yield: true };
    Material::Creeping(Box::new(creeping))
}

fn rubber(terms: &[(u8, u8, f64)]) -> Material {
    let volume = [3.0, 0.4, 0.0, 0.0, 0.0, 0.0];
    Material::Rubber(Rubber::Polynomial { terms: terms.to_vec(), volume })
}

/// Every law that takes time.
fn all() -> Vec<(&'static str, Material)> {
    let (strain, time) = (CreepHardening::Strain, CreepHardening::Time);
    let expansion = Expansion::even(1e-3);
    let law = relaxing(elastic());
    let soft = Material::Elastic(Elastic { modulus: 4.0, ..PLASTIC }, LargeStrain::Logarithmic);
    let rows = vec![(0.0, elastic()), (100.0, soft)];
    let graded = Material::Graded(Arc::new(Graded::new(rows).unwrap_or_default()));
    let ogden = Rubber::Ogden { terms: vec![[1.2, 1.7], [0.3, 4.0]], volume: [2.0; MOST_TERMS] };
    let heated = Expanding { expansion, growth: Growth::Logarithmic, law };
    vec![
        ("relaxing", relaxing(elastic())),
        ("relaxing neo-Hooke", relaxing(rubber(&[(1, 0, 1.2)]))),
        ("relaxing Mooney-Rivlin", relaxing(rubber(&[(1, 0, 1.0), (0, 1, 0.4)]))),
        ("relaxing Ogden", relaxing(Material::Rubber(ogden))),
        ("relaxing, over temperature", relaxing(graded.clone())),
        ("relaxing, hot", Material::Expanding(Box::new(heated))),
        ("Norton", creeping(elastic(), time, [0.05, 3.0, 0.0])),
        ("time hardening", creeping(elastic(), time, [0.1, 4.5, -0.4])),
        ("strain hardening", creeping(elastic(), strain, [0.1, 2.5, -0.5])),
        ("creeping, over temperature", creeping(graded, strain, [0.1, 2.5, 0.0])),
        ("creeping metal", creeping(yielding(), strain, [0.05, 3.0, -0.2])),
        ("creeping beyond yield", beyond_yield([0.3, 3.0, 0.0])),
    ]
}

/// A point on its way.
struct Point {
    material: Material,
    large: bool,
    time: f64,
    state: Vec<f64>,
}

impl Point {
    fn new(material: &Material, large: bool) -> Self {
        let state = vec![0.0; material.states()];
        Self { material: material.clone(), large, time: 0.0, state }
    }

    /// The answer after a time, and the state it leaves.
    fn answer(&self, h: &Matrix, passed: f64) -> (Answer, Vec<f64>) {
        let clock = Clock { passed, total: self.time + passed };
        let under = Conditions { large: self.large, temperature: 70.0, initial: 20.0, clock };
        let mut state = vec![f64::NAN; self.state.len()];
        (self.material.respond(h, &under, &self.state, &mut state), state)
    }

    fn walk(&mut self, h: &Matrix, passed: f64) -> Answer {
        let (answer, state) = self.answer(h, passed);
        self.time += if passed.is_finite() { passed } else { 0.0 };
        self.state = state;
        answer
    }
}

/// Pure shear, eps12.
fn sheared(strain: f64) -> Matrix {
    [[0.0, strain, 0.0], [strain, 0.0, 0.0], [0.0; 3]]
}

/// Moved by t times `way`.
fn moved(h: &Matrix, t: f64, way: &Matrix, large: bool) -> Matrix {
    let l = way.map(|row| row.map(|x| t * x));
    match large {
        true => after(&l, h),
        false => std::array::from_fn(|i| std::array::from_fn(|j| h[i][j] + l[i][j])),
    }
}

/// Requirement: at 200 random states behind a random history the moduli are the derivative of the
/// stress of the increment and symmetric, whatever time passes. Source: central differences.
/// Tolerance: their error; steps across the corner where yield begins are left out.
#[test]
fn tangents() {
    let mut kept = 0;
    for case in 0..200 {
        let random = |seed: usize, size: f64| {
            matrix(std::array::from_fn(|k| size * noise(1000 * case + 20 * seed + k)))
        };
        let passed = [0.0, 0.01, 0.7, 30.0, f64::INFINITY][case % 5];
        for (name, material) in all() {
            for large in [false, true] {
                let mut point = Point::new(&material, large);
                point.walk(&random(0, 0.2), 0.0);
                point.walk(&random(1, 0.2), 0.3);
                let (h, way) = (random(2, 0.2), random(3, 1.0));
                let (answer, state) = point.answer(&h, passed);
                let step = 1e-6;
                let [up, down] =
                    [step, -step].map(|t| point.answer(&moved(&h, t, &way, large), passed));
                let yields = |state: &[f64]| {
                    name.starts_with("creeping ")
                        && state[plastic::PEEQ] > point.state[plastic::PEEQ]
                };
                if yields(&up.1) != yields(&down.1) {
                    continue;
                }
                kept += 1;
                let difference =
                    std::array::from_fn(|k| (up.0.stress[k] - down.0.stress[k]) / (2.0 * step));
                let exact = if large {
                    foretold(&answer, &way)
                } else {
                    let strain = symmetric(&way);
                    answer.moduli.map(|row| (0..6).map(|k| row[k] * COUNTS[k] * strain[k]).sum())
                };
                near(&difference, &exact, 3e-5, name);
                for i in 0..6 {
                    for j in 0..i {
                        assert!(
                            (answer.moduli[i][j] - answer.moduli[j][i]).abs() < 1e-12,
                            "{name}"
                        );
                    }
                }
                assert!(state.iter().all(|entry| entry.is_finite()), "{name}");
            }
        }
    }
    assert!(kept > 4000, "{kept}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(50))]

    /// Requirement: a body that turns while it creeps or relaxes has the stress of one that does not,
    /// turned, and the same energies. Source: objectivity. Tolerance: rounding.
    #[test]
    fn objectivity(h in prop::array::uniform9(-0.3..0.3_f64), axis in prop::array::uniform3(-3.0..3.0_f64)) {
        let h = matrix(h);
        let w = [[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]];
        let minus = w.map(|row| row.map(|x| -x));
        let turn = product(&inverse(&deformation(&minus)).0, &deformation(&w));
        let turned = |h: &Matrix| -> Matrix {
            let f = product(&turn, &deformation(h));
            std::array::from_fn(|i| std::array::from_fn(|j| f[i][j] - f64::from(u8::from(i == j))))
        };
        for (name, material) in all() {
            let (mut one, mut other) = (Point::new(&material, true), Point::new(&material, true));
            one.walk(&h, 0.2);
            other.walk(&h, 0.2);
            let further = h.map(|row| row.map(|x| 0.7 * x));
            let (a, b) = (one.walk(&further, 1.5), other.walk(&turned(&further), 1.5));
            near(&carried(&turn, &a.stress), &b.stress, 1e-12, name);
            prop_assert!((a.energy - b.energy).abs() < 1e-12 && (a.dissipation - b.dissipation).abs() < 1e-12, "{name}");
        }
    }
}

/// Requirement: fixed shear and fixed volume relax by g(t) and k(t), exactly for any increments; at
/// once nothing relaxes, in the long term all of it; a committed state answers its own strain with
/// its own stress where no time passes. Source: closed form. Tolerance: rounding.
#[test]
fn relaxation_is_exact() {
    let material = relaxing(elastic());
    for large in [false, true] {
        let mut point = Point::new(&material, large);
        let even = if large { 0.01f64.exp_m1() } else { 0.01 };
        let volume = [[even, 0.0, 0.0], [0.0, even, 0.0], [0.0, 0.0, even]];
        let g = |t: f64| 0.5 + 0.3 * (-t / 0.5).exp() + 0.2 * (-t / 4.0).exp();
        let k = |t: f64| 0.9 + 0.1 * (-t / 0.5).exp();
        let bulk = 3.0 * PLASTIC.bulk_modulus() * 0.01;
        let whole = point.walk(&volume, 0.0);
        assert!((whole.stress[0] - bulk).abs() < 1e-14);
        for dt in [0.01, 0.4, 2.0, 7.0, 1e3] {
            let answer = point.walk(&volume, dt);
            assert!((answer.stress[0] - bulk * k(point.time)).abs() < 1e-14, "{}", point.time);
            let (again, _) = point.answer(&volume, 0.0);
            near(&again.stress, &answer.stress, 1e-15, "again");
            assert_eq!((again.energy, again.dissipation), (answer.energy, answer.dissipation));
        }
        let mut point = Point::new(&material, false);
        let stress = 2.0 * PLASTIC.shear_modulus() * 0.02;
        point.walk(&sheared(0.02), 0.0);
        for dt in [0.01, 0.4, 2.0, 7.0] {
            let answer = point.walk(&sheared(0.02), dt);
            assert!((answer.stress[3] - stress * g(point.time)).abs() < 1e-15);
        }
        let at_last = point.walk(&sheared(0.02), f64::INFINITY);
        assert!((at_last.stress[3] - 0.5 * stress).abs() < 1e-16);
    }
    // rubber: the same of its whole stress, however large the strain
    let law = rubber(&[(1, 0, 1.2)]);
    let series = vec![term(0.4, 0.4, 2.0)];
    let material = Material::Viscoelastic(Box::new(Viscoelastic { law: law.clone(), series }));
    let h = [[0.6, 0.4, 0.0], [0.0, -0.2, 0.1], [0.0, 0.3, 0.1]];
    let whole = Point::new(&law, true).walk(&h, 0.0);
    let mut point = Point::new(&material, true);
    near(&point.walk(&h, 0.0).stress, &whole.stress, 1e-14, "at once");
    let after = point.walk(&h, 3.0);
    let left = 0.6 + 0.4 * (-1.5f64).exp();
    near(&after.stress, &whole.stress.map(|s| left * s), 1e-14, "relaxed");
}

/// Requirement: a standard solid under a constant rate of strain, s = 2 G r (g t + g1 tau (1 -
/// exp(-t/tau))), exactly for any increments. Source: closed form. Tolerance: rounding.
#[test]
fn a_constant_rate_is_exact() {
    let series = vec![term(0.6, 0.0, 1.3)];
    let law = Viscoelastic { law: elastic(), series };
    let mut point = Point::new(&Material::Viscoelastic(Box::new(law)), false);
    for dt in [0.3, 0.01, 2.0, 0.7] {
        let strain = 0.01 * (point.time + dt);
        let answer = point.walk(&sheared(strain), dt);
        let t = point.time;
        let exact = 0.02 * PLASTIC.shear_modulus() * (0.4 * t + 0.78 * -(-t / 1.3).exp_m1());
        assert!((answer.stress[3] - exact).abs() < 1e-15, "{t}");
    }
}

/// Size of the error at the end of a history of `count` increments against a far finer one.
fn error(material: &Material, large: bool, count: usize, way: impl Fn(f64) -> Matrix) -> f64 {
    let end = |count: usize| {
        let mut point = Point::new(material, large);
        let dt = 2.0 / count as f64;
        point.walk(&[[0.0; 3]; 3], 0.0);
        (1..=count).fold(Answer::default(), |_, k| point.walk(&way(dt * k as f64), dt)).stress
    };
    let (own, fine) = (end(count), end(64 * count));
    (0..6).map(|k| (own[k] - fine[k]).powi(2)).sum::<f64>().sqrt()
}

/// Requirement: halved increments leave a quarter of the error of relaxing laws on a curved history,
/// and half of that of creep, at small and at large strain. Source: order of the rules.
#[test]
fn orders() {
    let way = |t: f64| -> Matrix {
        let s = 0.2 * (1.5 * t).sin();
        [[s, 0.5 * s * t, 0.0], [0.0, -0.3 * s, 0.1 * t], [0.0, 0.0, 0.05 * t]]
    };
    for (name, material) in all() {
        for large in [false, true] {
            let [one, two] = [40, 80].map(|count| error(&material, large, count, way));
            let order = (one / two).log2();
            let expected = if name.starts_with("relaxing") { 2.0 } else { 1.0 };
            let tolerance = if name == "creeping metal" { 0.5 } else { 0.25 };
            assert!((order - expected).abs() < tolerance, "{name} {large} {order}");
        }
    }
}

/// Requirement: under a stress that is held creep follows e = A q^n t^(m+1)/(m+1) for both kinds of
/// hardening, exactly for any increments. Source: closed form. Tolerance: of the bisection for the
/// strain that holds the stress.
#[test]
fn creep_under_a_held_stress() {
    let (factor, power, m) = (0.05, 3.0, -0.4);
    for hardening in [CreepHardening::Strain, CreepHardening::Time] {
        let mut point = Point::new(&creeping(elastic(), hardening, [factor, power, m]), false);
        let stress = 0.5;
        let held = |point: &Point, dt: f64| {
            let (mut low, mut high) = (0.0, 10.0);
            for _ in 0..80 {
                let middle = 0.5 * (low + high);
                let (answer, _) = point.answer(&sheared(middle), dt);
                if answer.stress[3] > stress { high = middle } else { low = middle }
            }
            low
        };
        point.walk(&sheared(held(&point, 0.0)), 0.0);
        for dt in [0.1, 1.0, 0.01, 5.0] {
            point.walk(&sheared(held(&point, dt)), dt);
            let q = 3f64.sqrt() * stress;
            let exact = factor * q.powf(power) * point.time.powf(m + 1.0) / (m + 1.0);
            let strain = point.state[creep::CEEQ];
            assert!((strain - exact).abs() < 1e-12 * exact, "{hardening:?} {strain} {exact}");
            assert!(creep::difference(&point.state).is_some_and(|own| own < 1e-12));
        }
    }
}

/// Requirement: Norton's relaxation of a fixed shear, q^(1-n) = q0^(1-n) + (n-1) 3 G A t, to first
/// order in the increment; a single long increment stays positive and below. Source: closed form.
#[test]
fn norton_relaxation() {
    for power in [1.0, 3.0, 8.0] {
        let factor = 0.05;
        let material = creeping(elastic(), CreepHardening::Time, [factor, power, 0.0]);
        let three = 3.0 * PLASTIC.shear_modulus();
        let start = 3f64.sqrt() * 2.0 * PLASTIC.shear_modulus() * 0.2;
        let end = |count: u32| {
            let mut point = Point::new(&material, false);
            point.walk(&sheared(0.2), 0.0);
            let dt = 4.0 / f64::from(count);
            (0..count).fold(0.0, |_, _| mises(&point.walk(&sheared(0.2), dt).stress))
        };
        let exact = match power {
            1.0 => start * (-three * factor * 4.0_f64).exp(),
            _ => {
                let left = start.powf(1.0 - power) + (power - 1.0) * three * factor * 4.0;
                left.powf(1.0 / (1.0 - power))
            }
        };
        let [rough, fine] = [200, 400].map(|count| end(count) / exact - 1.0);
        assert!(rough.abs() < 0.03 && (rough / fine - 2.0).abs() < 0.1, "{power} {rough} {fine}");
        let once = end(1);
        assert!(once > 0.0 && once < start);
    }
}

/// Requirement: a metal that creeps and yields keeps its stress on the table while it yields, and
/// creeps on from there when it is held. Source: definition.
#[test]
fn creep_beside_plastic_flow() {
    let mut point =
        Point::new(&creeping(yielding(), CreepHardening::Time, [0.05, 3.0, 0.0]), false);
    let answer = point.walk(&sheared(0.3), 0.5);
    let (peeq, ceeq) = (point.state[plastic::PEEQ], point.state[creep::CEEQ]);
    let Material::Plastic(metal) = yielding() else { unreachable!() };
    let stress = mises(&answer.stress);
    assert!(peeq > 0.01 && ceeq > 0.001, "{peeq} {ceeq}");
    assert!((stress - metal.yield_stress(peeq)[0]).abs() < 1e-12);
    assert!((ceeq - 0.5 * 0.05 * stress.powi(3)).abs() < 1e-12);
    // all strain is accounted for
    let whole = stress / (3.0 * PLASTIC.shear_modulus()) + peeq + ceeq;
    assert!((whole - 2.0 * 0.3 / 3f64.sqrt()).abs() < 1e-12, "{whole}");
    let held = point.walk(&sheared(0.3), 5.0);
    assert_eq!(point.state[plastic::PEEQ], peeq);
    assert!(mises(&held.stress) < stress && point.state[creep::CEEQ] > ceeq);
}

/// Requirement: where the stress beyond the yield stress drives creep, nothing creeps below it, the
/// rate is A (q - yield stress)^n, creep raises the yield stress, and without time it is a metal
/// that yields. Source: CalculiX' manual, *CREEP; measured with ccx.
#[test]
fn creep_beyond_the_yield_stress() {
    let mut point = Point::new(&beyond_yield([0.3, 3.0, 0.0]), false);
    let Material::Plastic(metal) = yielding() else { unreachable!() };
    let below = 0.59 / 3f64.sqrt() / (2.0 * PLASTIC.shear_modulus());
    point.walk(&sheared(below), 10.0);
    assert_eq!(point.state[creep::CEEQ], 0.0);
    let answer = point.walk(&sheared(0.3), 0.5);
    let creep = point.state[creep::CEEQ];
    let beyond = mises(&answer.stress) - metal.yield_stress(creep)[0];
    assert!(creep > 0.01 && (creep - 0.5 * 0.3 * beyond.powi(3)).abs() < 1e-13, "{creep}");
    let still = point.walk(&sheared(0.6), 0.0);
    let flowed = point.state[plastic::PEEQ] + point.state[creep::CEEQ];
    assert!(point.state[creep::CEEQ] == creep && point.state[plastic::PEEQ] > 0.01);
    assert!((mises(&still.stress) - metal.yield_stress(flowed)[0]).abs() < 1e-12);
}

/// Requirement: constants run straight between temperatures. Source: Abaqus manual.
#[test]
fn creep_over_temperature() {
    let law = |factor: f64| PowerLaw { factor, stress: 2.0, time: 0.0 };
    let law = vec![(20.0, law(0.1)), (120.0, law(0.5))];
    let creeping =
        Creeping { metal: elastic(), hardening: CreepHardening::Time, law, beyond_yield: false };
    let mut point = Point::new(&Material::Creeping(Box::new(creeping)), false);
    let answer = point.walk(&sheared(0.1), 0.2);
    let rate = 0.3 * mises(&answer.stress).powi(2);
    assert!((point.state[creep::CEEQ] - 0.2 * rate).abs() < 1e-14);
}

/// Requirement: the work of the stress on any history is what is stored and taken, exactly at small
/// strain without a change of temperature and to second order at large; what is taken never
/// comes back. Source: first and second law. Tolerance: rounding; the order.
#[test]
fn energies() {
    let way = |t: f64| -> Matrix {
        let s = 0.2 * (1.5 * t).sin();
        [[s, 0.5 * s * t, 0.0], [0.0, -0.3 * s, 0.1 * t], [0.0, 0.0, 0.05 * t]]
    };
    for (name, material) in all() {
        for large in [false, true] {
            let miss = |count: usize| {
                let mut point = Point::new(&material, large);
                let dt = 3.0 / count as f64;
                let hot = point.walk(&[[0.0; 3]; 3], 0.0);
                let (mut before, mut work) = ((hot.stress, [[0.0; 3]; 3]), hot.energy);
                let mut taken = 0.0;
                let mut last = Answer::default();
                for k in 1..=count {
                    let h = way(dt * k as f64);
                    last = point.walk(&h, dt);
                    work += work_of(&before, &(last.stress, h), large);
                    before = (last.stress, h);
                    assert!(last.dissipation >= taken - 1e-9, "{name} {large}");
                    taken = last.dissipation;
                }
                assert!(taken > 0.0 && taken < last.energy, "{name} {large}");
                (work - last.energy).abs()
            };
            let [one, two] = [100, 200].map(miss);
            if large || name == "creeping metal" {
                assert!(one < 1e-3 && two < 0.6 * one, "{name} {large} {one} {two}");
            } else {
                assert!(one < 1e-14, "{name} {one}");
            }
        }
    }
}

/// Work of the mean of two first Piola-Kirchhoff stresses on a change of H.
fn work_of(from: &(Symmetric, Matrix), to: &(Symmetric, Matrix), large: bool) -> f64 {
    let first = |(stress, h): &(Symmetric, Matrix)| -> Matrix {
        if !large {
            return full(stress);
        }
        let back = inverse(&deformation(h)).0;
        let transposed = std::array::from_fn(|i| std::array::from_fn(|j| back[j][i]));
        product(&full(stress), &transposed)
    };
    let (a, b) = (first(from), first(to));
    let each = (0..9).map(|k| (k / 3, k % 3));
    each.map(|(i, j)| 0.5 * (a[i][j] + b[i][j]) * (to.1[i][j] - from.1[i][j])).sum()
}

/// Requirement: other units of time and of force give the same strains and the same stresses in those
/// units, to the last digits. Source: dimensions. Tolerance: rounding.
#[test]
fn other_units() {
    let (second, pascal) = (3600.0, 1e-9);
    let own = Elastic { modulus: pascal * PLASTIC.modulus, ..PLASTIC };
    let own = Material::Elastic(own, LargeStrain::Logarithmic);
    let [n, m] = [2.5, -0.5];
    let factor = 0.1 * f64::powf(pascal, -n) * f64::powf(second, -(m + 1.0));
    let series = [term(0.3, 0.1, 0.5), term(0.2, 0.0, 4.0)];
    let series = series.map(|own| Relaxation { time: second * own.time, ..own }).to_vec();
    let pairs = [
        (
            relaxing(elastic()),
            Material::Viscoelastic(Box::new(Viscoelastic { law: own.clone(), series })),
        ),
        (
            creeping(elastic(), CreepHardening::Strain, [0.1, n, m]),
            creeping(own, CreepHardening::Strain, [factor, n, m]),
        ),
    ];
    for (one, other) in pairs {
        let (mut one, mut other) = (Point::new(&one, true), Point::new(&other, true));
        for (k, dt) in [0.0, 0.3, 2.0].into_iter().enumerate() {
            let h = matrix(std::array::from_fn(|i| 0.2 * noise(20 * k + i)));
            let (a, b) = (one.walk(&h, dt), other.walk(&h, second * dt));
            near(&a.stress.map(|s| pascal * s), &b.stress, 1e-13 * pascal, "units");
        }
    }
}
