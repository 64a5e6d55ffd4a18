use super::*;
use crate::element::cell::{Cell, QUAD4, QUAD8, TRI3, TRI6};

/// Numbers without order in -1..1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self, size: f64) -> Vector {
        std::array::from_fn(|_| size * self.next())
    }
}

/// A bent face with its variables: slave, nodes, normals.
fn example(cell: &'static Cell, smooth: bool, gap: f64, seed: u64) -> (Vec<Vector>, [f64; 2]) {
    let mut numbers = Numbers(seed);
    let mut all = vec![[0.0; 3]];
    for place in cell.places {
        let bulge = 0.2 * place[0] * place[1] - 0.1 * place[0] * place[0];
        all.push(add([place[0], 0.8 * place[1], bulge], numbers.vector(0.07)));
    }
    if smooth {
        for _ in 0..cell.faces.len() {
            let n = add([0.0, 0.0, 1.0], numbers.vector(0.3));
            all.push(scale(n, 1.0 / size(n)));
        }
    }
    let at = if cell.faces.len() == 3 { [0.3, 0.45] } else { [0.3, -0.25] };
    let patch = patch_of(cell, &all);
    let place = patch.place(at);
    let (_, normal) = patch.frame(&place).unwrap();
    all[0] = add(patch.position(&place.value), scale(normal, gap));
    (all, at)
}

fn patch_of(cell: &'static Cell, all: &[Vector]) -> Patch {
    let (nodes, normals) = all[1..].split_at(cell.nodes);
    Patch::new(cell, nodes, (!normals.is_empty()).then_some(normals))
}

/// The gap, its place found anew.
fn gap_of(cell: &'static Cell, all: &[Vector], start: [f64; 2]) -> FaceGap {
    let patch = patch_of(cell, all);
    let mut at = start;
    for _ in 0..50 {
        let place = patch.place(at);
        let (tangents, _) = patch.frame(&place).unwrap();
        let r = sub(all[0], patch.position(&place.value));
        let entry = |k: usize, l: usize| {
            dot(tangents[k], tangents[l]) - dot(r, patch.position(place.second(k, l)))
        };
        let side = tangents.map(|t| dot(t, r));
        let whole = entry(0, 0) * entry(1, 1) - entry(0, 1).powi(2);
        at[0] += (entry(1, 1) * side[0] - entry(0, 1) * side[1]) / whole;
        at[1] += (entry(0, 0) * side[1] - entry(0, 1) * side[0]) / whole;
    }
    FaceGap::new(patch, at, all[0]).unwrap()
}

fn faces() -> Vec<(&'static Cell, bool)> {
    vec![
        (&TRI3, false),
        (&QUAD4, false),
        (&TRI6, false),
        (&QUAD8, false),
        (&TRI3, true),
        (&QUAD4, true),
    ]
}

const STEP: f64 = 1e-6;

/// Central difference of some values by every variable.
fn differences(all: &[Vector], of: impl Fn(&[Vector]) -> Vec<f64>) -> Vec<Vec<f64>> {
    (0..3 * all.len())
        .map(|k| {
            let at = |step: f64| {
                let mut moved = all.to_vec();
                moved[k / 3][k % 3] += step;
                of(&moved)
            };
            let (plus, minus) = (at(STEP), at(-STEP));
            plus.iter().zip(&minus).map(|(p, m)| (p - m) / (2.0 * STEP)).collect()
        })
        .collect()
}

/// Requirement: dh and n follow the variables as differences say, for every face. Tolerance: of
/// central differences at a step of 1e-6, rounding 1e-16 / 1e-6.
#[test]
fn first_derivatives_are_those_of_differences() {
    for (cell, smooth) in faces() {
        let (all, start) = example(cell, smooth, 0.15, 7);
        let gap = gap_of(cell, &all, start);
        assert!((gap.gap - 0.15).abs() < 1e-12);
        let z = [0.3, -0.7, 0.2];
        let values = |all: &[Vector]| {
            let gap = gap_of(cell, all, start);
            vec![-gap.gap, dot(z, gap.normal), gap.at[0], gap.at[1]]
        };
        let own = [gap.gradient(), gap.normal_follows(z), gap.moves[0], gap.moves[1]];
        for (k, by) in differences(&all, values).iter().enumerate() {
            for (value, parts) in by.iter().zip(&own) {
                let own = parts.as_flattened()[k];
                assert!((value - own).abs() < 1e-8, "{} {smooth} {k}: {own} {value}", cell.name);
            }
        }
    }
}

/// Requirement: the derivative of normal dh + tangential . drag is that of differences, at a gap
/// and at a penetration; the part of the normal force is symmetric.
#[test]
fn second_derivatives_are_those_of_differences() {
    for (cell, smooth) in faces() {
        for opening in [0.2, -0.1] {
            let (all, start) = example(cell, smooth, opening, 11);
            let first = gap_of(cell, &all, start);
            let from = add(first.normal, [0.05, -0.08, 0.02]);
            let from = scale(from, 1.0 / size(from));
            let before = directions_across(from, [1.0, 0.2, 0.1]);
            let (normal, tangential) = (1.3, [0.8, -0.6]);
            let turned = |gap: &FaceGap| Turned::new(from, before, gap.normal).unwrap();
            let force = |all: &[Vector]| {
                let gap = gap_of(cell, all, start);
                let mut sum = NO_PARTS;
                add_to(&mut sum, &gap.gradient(), normal);
                for (t, force) in turned(&gap).directions.into_iter().zip(tangential) {
                    add_to(&mut sum, &gap.drag(t), force);
                }
                sum.as_flattened()[..gap.width()].to_vec()
            };
            let width = first.width();
            let mut own = vec![0.0; width * width];
            first.derivative(normal, (&turned(&first), tangential), &mut own);
            for (k, by) in differences(&all, force).iter().enumerate() {
                for (i, value) in by.iter().enumerate() {
                    let own = own[width * i + k];
                    assert!(
                        (value - own).abs() < 2e-7,
                        "{} {smooth} {i} {k}: {own} {value}",
                        cell.name
                    );
                }
            }
            first.derivative(normal, (&turned(&first), [0.0; 2]), &mut own);
            for i in 0..width {
                for j in 0..i {
                    assert!((own[width * i + j] - own[width * j + i]).abs() < 1e-12);
                }
            }
        }
    }
}

/// Requirement: pressure and traction on a point and its face balance in force and moment at any
/// gap; normals of a smoothed face take moments alone.
#[test]
fn forces_and_moments_balance_at_any_gap() {
    for (cell, smooth) in faces() {
        let (all, start) = example(cell, smooth, 0.3, 5);
        let gap = gap_of(cell, &all, start);
        let t = directions_across(gap.normal, [0.4, 1.0, 0.0]);
        for parts in [gap.gradient(), gap.drag(t[0]), gap.drag(t[1])] {
            let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
            for (part, at) in parts.iter().zip(&all) {
                moment = add(moment, cross(*at, *part));
            }
            for part in &parts[..=cell.nodes] {
                force = add(force, *part);
            }
            assert!(size(force) < 1e-13, "{} {smooth}: {force:?}", cell.name);
            assert!(size(moment) < 1e-13, "{} {smooth}: {moment:?}", cell.name);
        }
    }
}

/// Requirement: in the middle of a face with nodes and normals of a sphere, whose edges are a third
/// of the radius long, smoothing leaves at most a twentieth of the deviation of the flat face: it
/// falls with the fourth power of the edge instead of the second.
#[test]
fn a_smoothed_face_follows_a_sphere() {
    for cell in [&TRI3, &QUAD4] {
        let normals: Vec<_> = cell
            .places
            .iter()
            .map(|p| {
                let edge = if cell.faces.len() == 3 { 0.3 } else { 0.15 };
                let at = [edge * p[0], edge * p[1], 1.0];
                scale(at, 1.0 / size(at))
            })
            .collect();
        let nodes: Vec<_> = normals.iter().map(|n| scale(*n, 2.0)).collect();
        let middle = if cell.faces.len() == 3 { [1.0 / 3.0; 2] } else { [0.0; 2] };
        let radius = |normals: Option<&[Vector]>| {
            let patch = Patch::new(cell, &nodes, normals);
            size(patch.position(&patch.place(middle).value))
        };
        let (smooth, flat) = (radius(Some(&normals)) - 2.0, radius(None) - 2.0);
        assert!(smooth.abs() < 0.05 * flat.abs(), "{}: {smooth} {flat}", cell.name);
    }
}
