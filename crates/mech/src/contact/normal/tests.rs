use super::NormalLaw;

const C0: f64 = 1e-5;
const P0: f64 = 4.8e6;

fn soft() -> NormalLaw {
    NormalLaw::Exponential { clearance: C0, pressure: P0 }
}

fn laws() -> Vec<NormalLaw> {
    vec![
        soft(),
        NormalLaw::Linear { stiffness: 3e11 },
        NormalLaw::CalculixExponential { clearance: C0, pressure: P0 },
        NormalLaw::CalculixLinear { stiffness: 2e11, tension: 1e5, pulls: true },
        NormalLaw::CalculixLinear { stiffness: 2e11, tension: 1e5, pulls: false },
        NormalLaw::Tabular(vec![(0.0, -2e-6), (1e5, 0.0), (1e5, 1e-6), (4e6, 9e-6)]),
    ]
}

/// Requirement: pressure, slope and energy of the Abaqus exponential law as tabulated, linear
/// continuation from 6 c0. Source: semantics, section 2. Tolerance: the digits printed there.
#[test]
fn exponential_law_follows_its_table() {
    let law = NormalLaw::Exponential { clearance: 2.0, pressure: 3.0 };
    let rows = [
        (-0.9, 0.006_120_702, 0.125_525_4, 0.000_201_5),
        (-0.5, 0.188_770_4, 0.857_299_4, 0.029_470_9),
        (-0.1, 0.764_509_5, 2.137_744, 0.203_133_0),
        (0.0, 1.0, 2.581_977, 0.290_988_3),
        (0.5, 3.039_393, 5.938_620, 1.231_372),
        (1.0, 7.436_564, 12.318_80, 3.718_282),
        (2.0, 33.322_01, 46.175_28, 21.341_71),
        (3.0, 124.771_5, 158.292_3, 91.250_72),
        (6.0, 4463.431, 5105.138, 3815.613),
    ];
    for (x, p, slope, energy) in rows {
        let (pressure, by_h) = law.pressure(2.0 * x).unwrap();
        assert!((pressure / 3.0 - p).abs() < 1e-6 * p, "{x}");
        assert!((by_h * 2.0 / 3.0 - slope).abs() < 1e-6 * slope, "{x}");
        assert!((law.energy(2.0 * x) / 6.0 - energy).abs() < 3e-7 * energy.max(0.2), "{x}");
    }
    let (p6, slope6) = law.pressure(12.0).unwrap();
    let (p9, slope9) = law.pressure(18.0).unwrap();
    assert!((p9 - p6 - 6.0 * slope6).abs() < 1e-9 * p9);
    assert_eq!(slope9, slope6);
    assert_eq!(law.pressure(-2.0), Some((0.0, 0.0)));
}

/// Requirement: the closed forms of the softened law of the seed. Source: verification, section 6.
/// Tolerance: 1e-9 as set there.
#[test]
fn softened_law_of_the_1995_deck() {
    for (h, p) in [
        (-9e-6, 29_379.371_8),
        (-5e-6, 906_097.605),
        (0.0, 4.8e6),
        (5e-6, 14_589_086.0),
        (10e-6, 35_695_505.6),
    ] {
        let (pressure, _) = soft().pressure(h).unwrap();
        assert!((pressure - p).abs() < 3e-9 * p, "{h}: {pressure}");
    }
    let (_, slope) = soft().pressure(0.0).unwrap();
    assert!((slope - 1.239_348_82e12).abs() < 1e-8 * slope);
}

/// Requirement: the CalculiX exponential law is 100 p0 at c0 and 0.01 p0 where it begins.
#[test]
fn calculix_exponential_law() {
    let law = NormalLaw::CalculixExponential { clearance: C0, pressure: P0 };
    assert!((law.pressure(C0).unwrap().0 / (100.0 * P0) - 1.0).abs() < 1e-13);
    assert!((law.pressure(-0.999_999_999 * C0).unwrap().0 / (0.01 * P0) - 1.0).abs() < 1e-7);
    assert_eq!(law.pressure(-1.000_001 * C0), Some((0.0, 0.0)));
}

/// Requirement: the CalculiX linear law of surfaces is that of gaps where it is closed, and nothing where it is open,
/// without a leap between.
#[test]
fn calculix_linear_law() {
    let law = |pulls| NormalLaw::CalculixLinear { stiffness: 2e11, tension: 1e5, pulls };
    for h in [1e-9, 1e-7, 3e-6, 1.0] {
        assert_eq!(law(false).pressure(h), law(true).pressure(h));
        assert_eq!(law(false).pressure(-h), Some((0.0, 0.0)));
        assert!(law(true).pressure(-h).unwrap().0 < 0.0);
    }
    assert!((law(true).pressure(-1.0).unwrap().0 / -1e5 - 1.0).abs() < 1e-6);
    assert!(law(false).pressure(1e-18).unwrap().0 < 1e-6 * P0);
}

/// Requirement: slope is dp/dh and p is dw/dh. Tolerance: central differences of step 1e-6 c0 are
/// good to 1e-7.
#[test]
fn slope_and_energy_by_differences() {
    let step = 1e-6 * C0;
    for law in laws() {
        for h in [-0.97, -0.43, -0.1, 0.031, 0.55, 1.7, 4.0, 7.3] {
            let h = h * C0;
            let (p, slope) = law.pressure(h).unwrap();
            let (up, down) = (law.pressure(h + step).unwrap().0, law.pressure(h - step).unwrap().0);
            let tiny = 1e-9 * P0;
            assert!(((up - down) / (2.0 * step) - slope).abs() < 1e-7 * slope + 1e-9 * P0 / C0);
            if !matches!(law, NormalLaw::CalculixExponential { .. }) || h > -C0 {
                let dw = (law.energy(h + step) - law.energy(h - step)) / (2.0 * step);
                assert!((dw - p).abs() < 1e-7 * p.abs() + tiny, "{law:?} {h}: {dw} {p}");
            }
        }
    }
}

/// Requirement: the inverse law inverts, with the reciprocal slope. Tolerance: round-off of p(h), and
/// that of p at given h where the slope is large.
#[test]
fn inverse_law() {
    for law in laws() {
        for p in [1e-9, 1e-3, 0.04, 0.7, 1.0, 30.0, 5e4] {
            let p = p * P0;
            let Some((h, slope)) = law.overclosure(p) else { continue };
            if slope == 0.0 {
                continue; // on a jump
            }
            let (back, by_h) = law.pressure(h).unwrap();
            let rounding = 4.0 * f64::EPSILON * (h.abs() + C0) * by_h;
            assert!((back - p).abs() < 1e-13 * p + rounding, "{law:?} {p} {back}");
            assert!((slope * by_h - 1.0).abs() < 1e-6, "{law:?} {p}");
        }
        assert!(law.overclosure(f64::NAN).is_none());
    }
    assert!(soft().overclosure(0.0).is_none());
}

/// Requirement: the resolvent solves p = p(z - p/kappa), wherever it begins; its slope is dp/dz, within
/// [0, kappa].
/// Tolerance: round-off of z times kappa; slopes by differences.
#[test]
fn resolvent_solves_its_equation() {
    for law in laws() {
        for kappa in [1e9, 1e12, 1e16] {
            for z in [-2.0, -0.9, -0.25, 0.3, 1.0, 5.0, 300.0] {
                let z = z * C0;
                let (p, slope) = law.resolvent(z, kappa, z);
                assert!(slope >= 0.0 && slope <= kappa * (1.0 + 1e-14), "{law:?}");
                let h = z - p / kappa;
                for near in [h, 0.5 * (h + z), 2.0 * h - z, -0.99 * C0, 1e3 * C0, f64::NAN] {
                    let (other, _) = law.resolvent(z, kappa, near);
                    let rounding = 1e-13 * p.abs() + 8.0 * f64::EPSILON * kappa.min(slope) * C0;
                    assert!((other - p).abs() <= rounding, "{law:?} {z} {near}: {other} {p}");
                }
                let (expected, by_h) = law.pressure(h).unwrap();
                let rounding = 8.0 * f64::EPSILON * (z.abs() + C0) * by_h.max(1.0);
                let on_jump = matches!(law, NormalLaw::CalculixExponential { .. })
                    && (h + C0).abs() < 1e-12 * C0
                    && p <= 0.01 * P0 * (1.0 + 1e-9);
                if !on_jump {
                    assert!(
                        (p - expected).abs() <= 1e-12 * p.abs() + rounding,
                        "{law:?} {kappa} {z}: {p} {expected}"
                    );
                }
                let step = 1e-6 * C0;
                let (up, down) =
                    (law.resolvent(z + step, kappa, z).0, law.resolvent(z - step, kappa, z).0);
                let difference = (up - down) / (2.0 * step);
                assert!((difference - slope).abs() < 1e-6 * slope + 1e-7 * P0 / C0, "{law:?} {z}");
            }
        }
    }
}

/// Requirement: an infinite kappa inserts the law; the hard law is kappa max(z, 0).
#[test]
fn limits_of_the_resolvent() {
    for law in laws() {
        let h = 0.3 * C0;
        let (p, slope) = law.pressure(h).unwrap();
        let (q, by_z) = law.resolvent(h, f64::INFINITY, h);
        assert!((p - q).abs() < 1e-14 * p && (slope - by_z).abs() < 1e-13 * slope, "{law:?}");
    }
    assert_eq!(NormalLaw::Hard.resolvent(2.0, 5.0, 2.0), (10.0, 5.0));
    assert_eq!(NormalLaw::Hard.resolvent(-2.0, 5.0, 0.0), (0.0, 0.0));
    assert_eq!(NormalLaw::Hard.pressure(1.0), None);
}

/// Requirement: on the jump of the CalculiX law the resolvent runs up at slope kappa.
#[test]
fn resolvent_runs_through_a_jump() {
    let law = NormalLaw::CalculixExponential { clearance: C0, pressure: P0 };
    let kappa = 1e12;
    let z = -C0 + 0.005 * P0 / kappa;
    let (p, slope) = law.resolvent(z, kappa, z);
    assert!((p - 0.005 * P0).abs() < 1e-9 * P0);
    assert_eq!(slope, kappa);
}

/// Requirement: where contact begins. Source: semantics, section 2.
#[test]
fn where_contact_begins() {
    assert_eq!(soft().contact_begins(), -C0);
    assert_eq!(NormalLaw::Hard.contact_begins(), 0.0);
    let table = NormalLaw::Tabular(vec![(0.0, -2e-6), (0.0, -1e-6), (4e6, 9e-6)]);
    assert_eq!(table.contact_begins(), -1e-6);
}

/// Requirement: degenerate tables carry nothing and never give NaN.
#[test]
fn degenerate_tables() {
    for pairs in [vec![], vec![(1.0, 0.0)], vec![(0.0, 0.0), (1.0, 0.0)]] {
        let law = NormalLaw::Tabular(pairs);
        let (p, slope) = law.pressure(0.5).unwrap();
        assert!(p.is_finite() && slope.is_finite() && law.energy(0.5).is_finite());
        assert!(law.resolvent(0.5, 2.0, 0.5).0.is_finite());
    }
}
