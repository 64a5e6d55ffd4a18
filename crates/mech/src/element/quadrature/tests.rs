use super::super::cell::{HEX8, HEX20, QUAD4, QUAD8, TET4, TET10, TRI3, TRI6, WEDGE6, WEDGE15};
use super::*;

fn factorial(n: i32) -> f64 {
    (1..=n).map(f64::from).product()
}

/// Integral of x^a y^b z^c over a reference cell: a simplex in the first `simplex` axes times
/// [-1, 1] in the others up to `dimension`.
fn exact(powers: [i32; 3], simplex: usize, dimension: usize) -> f64 {
    let corner: i32 = powers[..simplex].iter().sum();
    let mut integral = powers[..simplex].iter().map(|&a| factorial(a)).product::<f64>();
    integral /= factorial(corner + i32::try_from(simplex).unwrap_or(0));
    for &power in &powers[simplex..dimension] {
        integral *= if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
    }
    integral
}

/// Requirement: rules are exact up to their degree (along each axis for products) and not beyond.
/// Source: integrals in closed form. Tolerance: rounding.
#[test]
fn degrees_of_exactness() {
    let rules: [(&Quadrature, usize, usize, [i32; 2]); 12] = [
        (&TRI_1, 2, 2, [1, 1]),
        (&TRI_3, 2, 2, [2, 2]),
        (&QUAD_1, 0, 2, [1, 1]),
        (&QUAD_4, 0, 2, [3, 3]),
        (&QUAD_9, 0, 2, [5, 5]),
        (&TET_1, 3, 3, [1, 1]),
        (&TET_4, 3, 3, [2, 2]),
        (&WEDGE_AXIS_2, 2, 3, [1, 3]),
        (&WEDGE_3X3, 2, 3, [2, 5]),
        (&HEX_1, 0, 3, [1, 1]),
        (&HEX_8, 0, 3, [3, 3]),
        (&HEX_27, 0, 3, [5, 5]),
    ];
    for (rule, simplex, dimension, [corner, line]) in rules {
        let integral = |powers: [i32; 3]| -> f64 {
            let of = |at: &[f64; 3]| (0..3).map(|k| at[k].powi(powers[k])).product::<f64>();
            rule.points.iter().zip(rule.weights).map(|(at, weight)| weight * of(at)).sum()
        };
        for code in 0..343 {
            let powers = [code % 7, code / 7 % 7, if dimension == 3 { code / 49 } else { 0 }];
            let flat: i32 = powers[..simplex].iter().sum();
            let within = flat <= corner && powers[simplex..dimension].iter().all(|&p| p <= line);
            let error = (integral(powers) - exact(powers, simplex, dimension)).abs();
            assert!(!within || error < 1e-14, "{} {powers:?} {error}", rule.name);
        }
        let beyond = if simplex > 0 { [corner + 1, 0, 0] } else { [line + 1, 0, 0] };
        let error = (integral(beyond) - exact(beyond, simplex, dimension)).abs();
        assert!(error > 1e-5, "{} {error}", rule.name);
    }
}

/// Requirement: linear functions are carried to the nodes exactly by every rule but those of one
/// point along an axis. Tolerance: rounding.
#[test]
fn linear_functions_reach_the_nodes() {
    let pairs: [(&Quadrature, &Cell); 8] = [
        (&TRI_3, &TRI6),
        (&QUAD_4, &QUAD4),
        (&QUAD_4, &QUAD8),
        (&QUAD_9, &QUAD8),
        (&TET_4, &TET10),
        (&WEDGE_3X3, &WEDGE15),
        (&HEX_8, &HEX8),
        (&HEX_27, &HEX20),
    ];
    for (rule, cell) in pairs {
        let of = |at: &[f64; 3]| 2.0 + at[0] - 3.0 * at[1] + 0.5 * at[2];
        let other = |at: &[f64; 3]| 1.0 - at[0] + 2.0 * at[1];
        let values: Vec<f64> = rule.points.iter().flat_map(|at| [of(at), other(at)]).collect();
        let mut nodes = vec![f64::NAN; 2 * cell.nodes];
        rule.carry(&values, 2, cell, &mut nodes);
        for (node, place) in nodes.chunks_exact(2).zip(cell.places) {
            assert!((node[0] - of(place)).abs() < 1e-14, "{} {}", rule.name, cell.name);
            assert!((node[1] - other(place)).abs() < 1e-14, "{} {}", rule.name, cell.name);
        }
    }
    for (rule, cell) in [(&TRI_1, &TRI3), (&TET_1, &TET4), (&HEX_1, &HEX8), (&QUAD_1, &QUAD4)] {
        let mut nodes = vec![0.0; cell.nodes];
        rule.carry(&[2.5], 1, cell, &mut nodes);
        assert!(nodes.iter().all(|&node| node == 2.5));
    }
    let mut nodes = [0.0; 6];
    WEDGE_AXIS_2.carry(&[-GAUSS_2, GAUSS_2], 1, &WEDGE6, &mut nodes);
    assert!(nodes.iter().zip(WEDGE6.places).all(|(node, at)| (node - at[2]).abs() < 1e-15));
}

/// Requirement: n points integrate polynomials of degree 2 n - 1. Tolerance: rounding.
#[test]
fn four_points_on_a_line() {
    for degree in 0..8 {
        let exact = if degree % 2 == 0 { 1.0 / f64::from(degree + 1) } else { 0.0 };
        let four: f64 = GAUSS_4.iter().zip(GAUSS_4_MEAN).map(|(x, w)| w * x.powi(degree)).sum();
        assert!((four - exact).abs() < 1e-15, "{degree}");
    }
}
