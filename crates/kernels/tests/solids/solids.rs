//! Solids of every cell, kinematics and formulation: derivatives, symmetries, rank, bending.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use slideline_mech::element::cell::{
    Cell, HEX8, HEX20, QUAD4, QUAD8, TET4, TET10, TRI3, TRI6, WEDGE6, WEDGE15,
};
use slideline_mech::element::quadrature::{
    HEX_1, HEX_8, HEX_27, QUAD_1, QUAD_4, QUAD_9, Quadrature, TET_1, TET_4, TRI_1, TRI_3,
    WEDGE_3X3, WEDGE_AXIS_2,
};
use slideline_mech::element::solid::{
    Formulation, Interpolation, Kinematics, Recipe, Told, smallest_jacobian, states,
};
use slideline_mech::element::{Failure, Kernel, Response, Strains};
use slideline_mech::material::{Elastic, LargeStrain, Material, Plastic, Rubber};

use Formulation::{Hourglass, Incompatible, LinearDilation, MeanDilation, Plain};
use Kinematics::{Axisymmetric, PlaneStrain, PlaneStress, Space};

const STEEL: Elastic = Elastic { modulus: 7.0, poisson: 0.3 };

fn hencky() -> Material {
    Material::Elastic(STEEL, LargeStrain::Logarithmic)
}

fn materials() -> Vec<(&'static str, Material)> {
    let volume = [3.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let table = vec![[0.15, 0.0], [0.4, 0.3], [0.5, 2.0]];
    vec![
        ("Hencky", hencky()),
        ("Green", Material::Elastic(STEEL, LargeStrain::Green)),
        (
            "Mooney",
            Material::Rubber(Rubber::Polynomial { terms: vec![(1, 0, 1.2), (0, 1, 0.3)], volume }),
        ),
        (
            "plastic",
            Material::Plastic(Plastic { elastic: STEEL, table, back_stresses: Vec::new() }),
        ),
    ]
}

/// A cell with its rule, what is done with it, and how many motions without stiffness it has beside
/// the rigid ones.
type Kind = (&'static Cell, &'static Quadrature, Kinematics, Formulation, usize);

fn kinds() -> Vec<Kind> {
    let mut kinds: Vec<Kind> = vec![
        (&QUAD4, &QUAD_4, PlaneStrain, MeanDilation, 0),
        (&QUAD4, &QUAD_4, Axisymmetric, MeanDilation, 0),
        (&QUAD8, &QUAD_9, PlaneStrain, LinearDilation, 0),
        (&QUAD8, &QUAD_9, Axisymmetric, LinearDilation, 0),
        (&HEX20, &HEX_27, Space, LinearDilation, 0),
        // fewer points than docs/theory.md eq. (3.33) needs: no row has them
        (&QUAD8, &QUAD_4, PlaneStrain, LinearDilation, 1),
        (&HEX20, &HEX_8, Space, LinearDilation, 10),
        (&TET4, &TET_1, Space, Plain, 0),
        (&TET10, &TET_4, Space, Plain, 0),
        // the three quadratic motions that change no shape (conformal ones)
        (&TET10, &TET_4, Space, MeanDilation, 3),
        // two points on the axis miss one twist of an even wedge
        (&WEDGE6, &WEDGE_AXIS_2, Space, Plain, 1),
        (&WEDGE15, &WEDGE_3X3, Space, Plain, 0),
        (&HEX8, &HEX_8, Space, Plain, 0),
        (&HEX8, &HEX_8, Space, MeanDilation, 0),
        (&HEX8, &HEX_8, Space, Incompatible, 0),
        (&HEX8, &HEX_1, Space, Hourglass, 0),
        (&HEX20, &HEX_27, Space, Plain, 0),
        // six modes that neighbours do not take up together
        (&HEX20, &HEX_8, Space, Plain, 6),
    ];
    for plane in [PlaneStrain, PlaneStress, Axisymmetric] {
        // one point sees four strains of a ring, which has one rigid motion only
        let one = if plane == Axisymmetric { 1 } else { 0 };
        kinds.extend([
            (&TRI3, &TRI_1, plane, Plain, one),
            (&TRI6, &TRI_3, plane, Plain, 0),
            (&QUAD4, &QUAD_4, plane, Plain, 0),
            (&QUAD4, &QUAD_4, plane, Incompatible, 0),
            (&QUAD4, &QUAD_1, plane, Hourglass, one),
            (&QUAD8, &QUAD_9, plane, Plain, 0),
            (&QUAD8, &QUAD_4, plane, Plain, 1),
        ] as [Kind; 7]);
    }
    kinds
}

fn name(kind: &Kind) -> String {
    format!("{} {} {:?} {:?}", kind.0.name, kind.1.name, kind.2, kind.3)
}

/// Numbers in [-1, 1] in no order.
fn noise(seed: usize) -> f64 {
    ((seed as f64 * 12.9898 + 4.1414).sin() * 43_758.545).fract()
}

/// The cell's own shape, a little out of shape and away from the axis.
fn nodes(cell: &Cell, distortion: f64) -> Vec<[f64; 3]> {
    let of = |(a, at): (usize, &[f64; 3])| {
        let moved = |axis: usize| {
            let reach = if axis < cell.dimension { distortion } else { 0.0 };
            at[axis] + reach * noise(7 * a + axis)
        };
        [4.0 + moved(0), 0.3 * moved(0) + 1.2 * moved(1) - 3.0, moved(2)]
    };
    cell.places.iter().enumerate().map(of).collect()
}

fn kernel(kind: &Kind, material: &Material, nodes: &[[f64; 3]]) -> Box<dyn Kernel> {
    let (cell, rule, kinematics, formulation, _) = *kind;
    let material = material.clone();
    let told = Told::Logarithmic;
    let temperatures = match formulation {
        _ if cell.is_quadratic() => Interpolation::Linear,
        Incompatible => Interpolation::Shapes,
        _ => Interpolation::Mean,
    };
    let (thickness, orientation) = (0.5, None);
    let recipe = Recipe {
        cell,
        rule,
        kinematics,
        formulation,
        material,
        thickness,
        told,
        orientation,
        temperatures,
    };
    slideline_kernels::solids(recipe, nodes).unwrap()
}

pub(super) struct Answer {
    pub force: Vec<f64>,
    pub tangent: Vec<f64>,
    pub state: Vec<f64>,
    pub energy: f64,
}

fn state_count(kind: &Kind, material: &Material) -> usize {
    states((kind.0, kind.1), (kind.2, kind.3), material)
}

pub(super) fn respond(
    kernel: &dyn Kernel,
    q: &[f64],
    committed: &[f64],
    strains: Strains<'_>,
) -> Answer {
    let width = kernel.variables();
    let (mut force, mut tangent) = (vec![0.0; width], vec![0.0; width * width]);
    let mut state = vec![0.0; committed.len()];
    let into = Response { force: &mut force, tangent: Some(&mut tangent), state: &mut state };
    let energy = kernel.respond(0, q, committed, &strains.into(), into).unwrap();
    let mut alone = vec![0.0; width];
    let into = Response { force: &mut alone, tangent: None, state: &mut state };
    assert_eq!(kernel.respond(0, q, committed, &strains.into(), into), Ok(energy));
    assert_eq!(alone, force, "the force alone has the same bits");
    Answer { force, tangent, state, energy }
}

/// Displacements u = A X + noise.
fn motion(cell: &Cell, nodes: &[[f64; 3]], a: [[f64; 3]; 3], noise_size: f64) -> Vec<f64> {
    let of = |(k, x): (usize, &[f64; 3])| -> Vec<f64> {
        (0..cell.dimension)
            .map(|i| {
                (0..3).map(|j| a[i][j] * x[j]).sum::<f64>() + noise_size * noise(31 * k + i + 5)
            })
            .collect()
    };
    nodes.iter().enumerate().flat_map(of).collect()
}

const STRETCH: [[f64; 3]; 3] = [[0.1, 0.08, -0.05], [-0.05, -0.08, 0.06], [0.02, 0.04, 0.06]];

/// Requirement: the tangent is the derivative of the force and, for elastic materials, the force
/// that of the energy, at large strain and at small, from a plastic state too; tangents are
/// symmetric. Source: central differences. Tolerance: their error.
#[test]
fn derivatives() {
    for kind in kinds() {
        for (what, material) in materials() {
            let nodes = nodes(kind.0, 0.12);
            let kernel = kernel(&kind, &material, &nodes);
            let q = motion(kind.0, &nodes, STRETCH, 0.03);
            let before: Vec<f64> = q.iter().map(|u| 0.7 * u).collect();
            for strains in [Strains::Exact, Strains::Linear] {
                let zero = vec![0.0; state_count(&kind, &material)];
                let committed = respond(&*kernel, &before, &zero, strains).state;
                let at = respond(&*kernel, &q, &committed, strains);
                assert!(at.energy.is_finite(), "{} {what}", name(&kind));
                let width = q.len();
                let step = 1e-6;
                for j in (0..width).step_by(3) {
                    let moved = |by: f64| {
                        let mut q = q.clone();
                        q[j] += by;
                        respond(&*kernel, &q, &committed, strains)
                    };
                    let (up, down) = (moved(step), moved(-step));
                    let slope = (up.energy - down.energy) / (2.0 * step);
                    if what != "plastic" {
                        let error = (slope - at.force[j]).abs();
                        assert!(error < 2e-7, "{} {what} force {error}", name(&kind));
                    }
                    for i in 0..width {
                        let slope = (up.force[i] - down.force[i]) / (2.0 * step);
                        let (own, mirror) = (at.tangent[i * width + j], at.tangent[j * width + i]);
                        let error = (slope - own).abs();
                        assert!(
                            error < 2e-6,
                            "{} {what} {strains:?} {i} {j}: {slope} {own}",
                            name(&kind)
                        );
                        assert!((own - mirror).abs() < 1e-11, "{} {what}", name(&kind));
                    }
                }
            }
        }
    }
}

fn mooney() -> Material {
    materials().into_iter().find(|(what, _)| *what == "Mooney").unwrap().1
}

/// Pressures where a linear solution arrives.
fn arrived(kernel: &dyn Kernel, q: &[f64], change: &[f64]) -> Vec<f64> {
    let mut pressures = vec![f64::NAN; kernel.estimate_size()];
    kernel.stresses_after(0, q, change, &Strains::Exact.into(), &mut pressures);
    pressures
}

/// Requirement: with the pressures of its strains the tangent of rubber is the derivative of the force,
/// with others what these make of the second derivative of its volume; forces and energies have the
/// same bits whatever the pressures, and so has all of another material. Source: the area of a
/// quadrilateral, which is quadratic in its nodes. Tolerance: rounding.
#[test]
fn pressures_of_their_own() {
    for kind in kinds() {
        let nodes = nodes(kind.0, 0.12);
        let kernel_of = |material: &Material| kernel(&kind, material, &nodes);
        let (rubber, metal) = (kernel_of(&mooney()), kernel_of(&hencky()));
        let q = motion(kind.0, &nodes, STRETCH, 0.03);
        let across = vec![0.0; state_count(&kind, &mooney())];
        let exact = respond(&*rubber, &q, &across, Strains::Exact);
        let estimated =
            matches!(kind.3, Plain | MeanDilation | LinearDilation) && kind.2 != PlaneStress;
        assert_eq!((rubber.estimates(), metal.estimates()), (estimated, false), "{}", name(&kind));
        let own = arrived(&*rubber, &q, &vec![0.0; q.len()]);
        let other: Vec<f64> = own.iter().map(|own| own + 2.0).collect();
        let [at, far] = [&own, &other].map(|p| respond(&*rubber, &q, &across, Strains::Mixed(p)));
        assert!(at.force == exact.force && far.force == exact.force && far.energy == exact.energy);
        let off = |a: &[f64]| {
            a.iter().zip(&exact.tangent).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        assert!(off(&at.tangent) < 1e-12, "{} {}", name(&kind), off(&at.tangent));
        assert!((off(&far.tangent) > 0.1) == estimated, "{} {}", name(&kind), off(&far.tangent));
        if state_count(&kind, &hencky()) == 0 {
            let [at, far] = [Strains::Exact, Strains::Mixed(&other)]
                .map(|strains| respond(&*metal, &q, &[], strains).tangent);
            assert_eq!(at, far, "{}", name(&kind));
        }
        if kind.0.nodes == 4 && kind.2 == PlaneStrain && estimated {
            let v: Vec<f64> = (0..q.len()).map(|k| noise(3 * k + 1)).collect();
            let volume = |by: f64| {
                let x: Vec<[f64; 2]> = (0..4)
                    .map(|a| [0, 1].map(|i| nodes[a][i] + q[2 * a + i] + by * v[2 * a + i]))
                    .collect();
                let cross = |a: usize| x[a][0] * x[(a + 1) % 4][1] - x[a][1] * x[(a + 1) % 4][0];
                0.5 * 0.5 * (0..4).map(cross).sum::<f64>()
            };
            let bend = volume(1.0) + volume(-1.0) - 2.0 * volume(0.0);
            let entry = |(k, value): (usize, f64)| v[k / q.len()] * value * v[k % q.len()];
            let beyond = far.tangent.iter().zip(&at.tangent).map(|(far, at)| far - at);
            let found: f64 = beyond.enumerate().map(entry).sum();
            assert!((found - 2.0 * bend).abs() < 1e-12, "{}: {found} {bend}", name(&kind));
        }
    }
}

/// Requirement: pressures arrive where their derivative along the correction leads. Source: central
/// differences. Tolerance: their error.
#[test]
fn pressures_arrive_by_differences() {
    for kind in kinds() {
        let nodes = nodes(kind.0, 0.12);
        let kernel = kernel(&kind, &mooney(), &nodes);
        let q = motion(kind.0, &nodes, STRETCH, 0.03);
        let change: Vec<f64> = (0..q.len()).map(|k| 0.2 * noise(5 * k + 2)).collect();
        let at = |t: f64| {
            let moved: Vec<f64> = q.iter().zip(&change).map(|(q, dq)| q + t * dq).collect();
            arrived(&*kernel, &moved, &vec![0.0; q.len()])
        };
        let (here, up, down) = (at(0.0), at(1e-6), at(-1e-6));
        for (k, arrival) in arrived(&*kernel, &q, &change).iter().enumerate() {
            let line = here[k] + (up[k] - down[k]) / 2e-6;
            assert!((arrival - line).abs() < 1e-7, "{} {k}: {arrival} {line}", name(&kind));
        }
    }
}

/// Requirement: a turn and a shift make no force by themselves, and after any deformation turn the
/// force and leave the energy. Rings turn about nothing. Source: objectivity. Tolerance: rounding.
#[test]
fn objectivity() {
    for kind in kinds().iter().filter(|kind| kind.2 != Axisymmetric) {
        for (what, material) in materials() {
            let nodes = nodes(kind.0, 0.12);
            let kernel = kernel(kind, &material, &nodes);
            let zero = vec![0.0; state_count(kind, &material)];
            let turn = turned(kind.0.dimension);
            for (a, noise_size) in [([[0.0; 3]; 3], 0.0), (STRETCH, 0.03)] {
                let q = motion(kind.0, &nodes, a, noise_size);
                let d = kind.0.dimension;
                let after: Vec<f64> = (0..q.len())
                    .map(|k| {
                        let (node, i) = (k / d, k % d);
                        let turned: f64 =
                            (0..d).map(|j| turn[i][j] * (nodes[node][j] + q[node * d + j])).sum();
                        turned + 2.0 - nodes[node][i]
                    })
                    .collect();
                let (one, two) = (
                    respond(&*kernel, &q, &zero, Strains::Exact),
                    respond(&*kernel, &after, &zero, Strains::Exact),
                );
                assert!((one.energy - two.energy).abs() < 1e-12, "{} {what}", name(kind));
                for k in 0..q.len() {
                    let (node, i) = (k / d, k % d);
                    let exact: f64 = (0..d).map(|j| turn[i][j] * one.force[node * d + j]).sum();
                    let error = (two.force[k] - exact).abs();
                    assert!(error < 2e-12, "{} {what} {error}", name(kind));
                }
            }
        }
    }
}

/// A turn in the plane, or about an axis in space.
fn turned(dimension: usize) -> [[f64; 3]; 3] {
    let (s, c) = f64::sin_cos(2.1);
    let about_z = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]];
    if dimension == 2 {
        return about_z;
    }
    let (s, c) = f64::sin_cos(0.8);
    let about_x = [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).map(|k| about_z[i][k] * about_x[k][j]).sum())
    })
}

/// Requirement: under a homogeneous deformation every point of an element of straight edges has
/// the same stress and no enhanced strain, and forces are those of the same element integrated
/// without any formulation: the patch test. Source: linear fields are within all spaces.
/// Tolerance: rounding.
#[test]
fn homogeneous_deformations() {
    for kind in kinds().iter().filter(|kind| kind.2 != Axisymmetric) {
        let (cell, d) = (kind.0, kind.0.dimension);
        let mut nodes = nodes(cell, 0.15);
        straighten(cell, &mut nodes);
        let a = if d == 2 { [[0.2, 0.1, 0.0], [-0.1, -0.15, 0.0], [0.0; 3]] } else { STRETCH };
        let q = motion(cell, &nodes, a, 0.0);
        for strains in [Strains::Exact, Strains::Linear] {
            let own = kernel(kind, &hencky(), &nodes);
            let zero = vec![0.0; state_count(kind, &hencky())];
            let at = respond(&*own, &q, &zero, strains);
            let points = kind.1.points.len();
            let width = if d == 2 { 4 } else { 6 };
            let mut results = vec![0.0; points * (2 * width + 4) + 3];
            own.results(0, &q, &at.state, &strains.into(), &mut results);
            for k in 0..points * width {
                let error = (results[k] - results[k % width]).abs();
                assert!(error < 1e-12, "{} {results:?}", name(kind));
            }
            assert!(results[0].abs() > 0.1);
            let finest = match cell.name {
                "quad4" => &QUAD_4,
                "quad8" => &QUAD_9,
                "hex8" => &HEX_8,
                "hex20" => &HEX_27,
                _ => kind.1,
            };
            let plain = (cell, finest, kind.2, Plain, 0);
            let zero = vec![0.0; state_count(&plain, &hencky())];
            let exact = respond(&*kernel(&plain, &hencky(), &nodes), &q, &zero, strains);
            for (own, exact) in at.force.iter().zip(&exact.force) {
                assert!((own - exact).abs() < 1e-12, "{} {own} {exact}", name(kind));
            }
        }
    }
}

/// Puts middle nodes between their corners.
fn straighten(cell: &Cell, nodes: &mut [[f64; 3]]) {
    let corners = cell.places.iter().filter(|at| is_corner(cell, at)).count();
    for middle in corners..cell.nodes {
        let mut ends = Vec::new();
        for i in 0..corners {
            for j in 0..i {
                let between = |axis: usize| 0.5 * (cell.places[i][axis] + cell.places[j][axis]);
                let (a, b) = (cell.places[i], cell.places[j]);
                let apart = (0..3).filter(|&axis| a[axis] != b[axis]).count();
                let edge = apart == 1 || cell.name.starts_with('t') || cell.name == "wedge15";
                if edge && (0..3).all(|axis| between(axis) == cell.places[middle][axis]) {
                    ends = vec![i, j];
                }
            }
        }
        nodes[middle] =
            std::array::from_fn(|axis| 0.5 * (nodes[ends[0]][axis] + nodes[ends[1]][axis]));
    }
}

fn is_corner(cell: &Cell, at: &[f64; 3]) -> bool {
    let simplex = if cell.name.starts_with("wedge") { 2 } else { cell.dimension };
    if cell.name.starts_with("quad") || cell.name.starts_with("hex") {
        at[..cell.dimension].iter().all(|x| x.abs() == 1.0)
    } else {
        at[..simplex].iter().all(|x| *x == 0.0 || *x == 1.0)
            && (simplex == cell.dimension || at[2].abs() == 1.0)
    }
}

/// Number of positive pivots of a symmetric matrix, by elimination with full pivoting.
fn rank(matrix: &[f64], width: usize) -> usize {
    let (mut k, mut rank) = (matrix.to_vec(), 0);
    let scale = (0..width).map(|i| k[i * width + i].abs()).fold(0.0, f64::max);
    let mut left: Vec<usize> = (0..width).collect();
    while let Some(place) = (0..left.len())
        .max_by(|&a, &b| k[left[a] * (width + 1)].abs().total_cmp(&k[left[b] * (width + 1)].abs()))
    {
        let pivot = left.swap_remove(place);
        if k[pivot * (width + 1)] < 1e-10 * scale {
            break;
        }
        rank += 1;
        for &i in &left {
            let factor = k[i * width + pivot] / k[pivot * (width + 1)];
            (0..width).for_each(|j| k[i * width + j] -= factor * k[pivot * width + j]);
        }
    }
    rank
}

/// Requirement: an element has its rigid motions without stiffness and no others but those named,
/// whether distorted or not. Tolerance: 1e-10 of the largest pivot.
#[test]
fn rank_of_the_stiffness() {
    for kind in kinds() {
        for distortion in [0.0, 0.12] {
            let own = kernel(&kind, &hencky(), &nodes(kind.0, distortion));
            let width = own.variables();
            let rigid = match (kind.2, kind.0.dimension) {
                (Axisymmetric, _) => 1,
                (_, 2) => 3,
                _ => 6,
            };
            let zero = vec![0.0; state_count(&kind, &hencky())];
            let at = respond(&*own, &vec![0.0; width], &zero, Strains::Linear);
            let (rank, least) = (rank(&at.tangent, width), width - rigid - kind.4);
            assert!(rank >= least && rank <= width - rigid, "{} {rank}", name(&kind));
            assert!(distortion > 0.0 || rank == least, "{} {rank} {least}", name(&kind));
        }
    }
}

/// Stiffness of a square against bending, per unit of u = x y in the plane.
fn bending(formulation: Formulation, rule: &'static Quadrature, poisson: f64) -> f64 {
    let square = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let elastic = Elastic { modulus: 1.0, poisson };
    let material = Material::Elastic(elastic, LargeStrain::Logarithmic);
    let kind = (&QUAD4, rule, PlaneStrain, formulation, 0);
    let mode = [1.0, 0.0, -1.0, 0.0, 1.0, 0.0, -1.0, 0.0];
    let zero = vec![0.0; state_count(&kind, &material)];
    let at = respond(&*kernel(&kind, &material, &square), &mode, &zero, Strains::Linear);
    let stiffness = at.force.iter().zip(mode).map(|(f, u)| f * u).sum::<f64>() / 4.0;
    stiffness / 0.5
}

/// Requirement: bending of a square: mean dilation 7/9 G whatever the bulk modulus (.299 E at nu =
/// .3), incompatible modes exact, E/(3 (1 - nu^2)) (.3663 E), full integration .577 E. Source:
/// hourglass mode u = x y in closed form. Tolerance: rounding.
#[test]
fn bending_of_a_square() {
    for poisson in [0.0, 0.3, 0.49, 0.4999] {
        let shear = 1.0 / (2.0 * (1.0 + poisson));
        let stiffness = bending(MeanDilation, &QUAD_4, poisson);
        assert!((stiffness - 7.0 / 9.0 * shear).abs() < 1e-12, "{poisson}: {stiffness}");
        let stiffness = bending(Incompatible, &QUAD_4, poisson);
        let exact = 1.0 / (3.0 * (1.0 - poisson * poisson));
        assert!((stiffness - exact).abs() < 1e-9, "{poisson}: {stiffness} {exact}");
        let stiffness = bending(Hourglass, &QUAD_1, poisson);
        assert!((stiffness - exact).abs() < 1e-12, "{stiffness}");
    }
    assert!((bending(Plain, &QUAD_4, 0.3) - 0.577).abs() < 5e-4);
}

/// Requirement: incompatible modes bend a brick as a beam, whichever way: E I / 2 of curvature
/// squared where the nodes let the section grow narrower on the side in tension (u = - nu y z), E I
/// / 2 (1 - nu^2) where they hold its sides. Source: beam and plate theory; exact for a rectangular
/// block. Tolerance: rounding of the elimination.
#[test]
fn bending_of_a_brick() {
    let brick: Vec<[f64; 3]> = HEX8.places.to_vec();
    let kind = (&HEX8, &HEX_8, Space, Incompatible, 0);
    let zero = vec![0.0; state_count(&kind, &hencky())];
    for (along, across) in [(0, 1), (1, 2), (2, 0), (0, 2)] {
        let other = 3 - along - across;
        for (poisson, modulus) in [(0.3, 7.0), (0.0, 7.0 / (1.0 - 0.09))] {
            let mut mode = vec![0.0; 24];
            for (a, at) in brick.iter().enumerate() {
                mode[3 * a + along] = at[along] * at[across];
                mode[3 * a + other] = -poisson * at[across] * at[other];
            }
            let at = respond(&*kernel(&kind, &hencky(), &brick), &mode, &zero, Strains::Linear);
            // E/2 of the integral of y^2 over a cube of side 2
            let exact = 0.5 * modulus * 8.0 / 3.0;
            assert!((at.energy - exact).abs() < 1e-12 * exact, "{} {exact}", at.energy);
        }
    }
}

/// Requirement: plane stress has none across, plane strain no strain across, at large strain too.
#[test]
fn across_the_plane() {
    for (plane, (what, material)) in [PlaneStress, PlaneStrain]
        .into_iter()
        .flat_map(|p| materials().into_iter().map(move |m| (p, m)))
    {
        let kind = (&QUAD4, &QUAD_4, plane, Plain, 0);
        let nodes = nodes(&QUAD4, 0.1);
        let q = motion(&QUAD4, &nodes, STRETCH, 0.02);
        let own = kernel(&kind, &material, &nodes);
        for strains in [Strains::Exact, Strains::Linear] {
            let zero = vec![0.0; state_count(&kind, &material)];
            let state = respond(&*own, &q, &zero, strains).state;
            let mut results = [0.0; 4 * (2 * 4 + 4) + 3];
            own.results(0, &q, &state, &strains.into(), &mut results);
            for k in 0..4 {
                let across = results[if plane == PlaneStress { 4 * k + 2 } else { 16 + 4 * k + 2 }];
                assert!(across.abs() < 1e-13, "{what} {plane:?} {across}");
                assert!(results[4 * k].abs() > 0.01);
            }
        }
    }
}

/// What an element says of displacements.
fn outcome(kernel: &dyn Kernel, q: &[f64], committed: &[f64]) -> Result<f64, Failure> {
    let mut force = vec![0.0; kernel.variables()];
    let mut state = committed.to_vec();
    let into = Response { force: &mut force, tangent: None, state: &mut state };
    kernel.respond(0, q, committed, &Strains::Exact.into(), into)
}

/// Requirement: an element that is carried along without strain has an answer, also where strains go
/// to nothing at all: what it solves for inside (modes, the strain across the plane) has nothing to
/// be held against then.
#[test]
fn carried_along_without_strain() {
    for kind in kinds() {
        for (law, material) in materials() {
            let nodes = nodes(kind.0, 0.1);
            let zero = vec![0.0; state_count(&kind, &material)];
            let own = kernel(&kind, &material, &nodes);
            let moved = |size: f64| -> Vec<f64> {
                (0..nodes.len() * kind.0.dimension).map(|k| size * noise(k)).collect()
            };
            let committed = respond(&*own, &moved(1e-10), &zero, Strains::Exact).state;
            for size in [1e-30, 1e-160, 1e-316, 0.0] {
                let ended = outcome(&*own, &moved(size), &committed);
                assert!(ended.is_ok(), "{} {law} {size:e}", name(&kind));
            }
        }
    }
}

/// Requirement: an element that is turned inside out at a point has no answer and says why, of
/// whatever material and however it is turned: mirrored along an axis, a
/// ring mirrored across its axis; one whose nodes run the wrong way round is told before.
#[test]
fn inside_out() {
    for kind in kinds() {
        for (what, material) in materials() {
            let nodes = nodes(kind.0, 0.0);
            let zero = vec![0.0; state_count(&kind, &material)];
            let own = kernel(&kind, &material, &nodes);
            for stretch in [-1.5, -1.001] {
                let mut a = [[0.0; 3]; 3];
                // rings are mirrored along their axis, which moves no point towards it
                let axis = usize::from(kind.2 == Axisymmetric);
                a[axis][axis] = stretch;
                let answer = outcome(&*own, &motion(kind.0, &nodes, a, 0.0), &zero);
                assert_eq!(answer, Err(Failure::InsideOut(0)), "{} {what}", name(&kind));
            }
            if kind.2 == Axisymmetric {
                for stretch in [-1.001, -2.0] {
                    let mut a = [[0.0; 3]; 3];
                    a[0][0] = stretch;
                    let q = motion(kind.0, &nodes, a, 0.0);
                    let answer = outcome(&*own, &q, &zero);
                    assert_eq!(answer, Err(Failure::OnAxis(0)), "{} {what}", name(&kind));
                    // across the axis and mirrored: the volume is positive again
                    a[1][1] = -2.0;
                    let answer = outcome(&*own, &motion(kind.0, &nodes, a, 0.0), &zero);
                    assert_eq!(answer, Err(Failure::OnAxis(0)), "{} {what}", name(&kind));
                }
            }
        }
        let mut nodes = nodes(kind.0, 0.1);
        assert!(smallest_jacobian(kind.0, kind.1, &nodes) > 0.0);
        nodes.iter_mut().for_each(|node| node[0] *= -1.0);
        assert!(smallest_jacobian(kind.0, kind.1, &nodes) < 0.0);
    }
}

/// Requirement: one point inside out fails the element, however sound the others are.
#[test]
fn one_point_inside_out() {
    for kind in kinds().iter().filter(|kind| kind.1.points.len() > 2 && kind.3 != Incompatible) {
        let nodes = nodes(kind.0, 0.0);
        let zero = vec![0.0; state_count(kind, &hencky())];
        let own = kernel(kind, &hencky(), &nodes);
        // the node of the last point goes far into the element
        let mut q = vec![0.0; own.variables()];
        let d = kind.0.dimension;
        let inwards = nodes.iter().fold([0.0; 3], |sum, x| std::array::from_fn(|k| sum[k] + x[k]));
        let last = (0..nodes.len().min(if d == 2 { 4 } else { 8 })).next_back().unwrap();
        for axis in 0..d {
            let centre = inwards[axis] / nodes.len() as f64;
            q[d * last + axis] = 1.9 * (centre - nodes[last][axis]);
        }
        assert!(
            matches!(outcome(&*own, &q, &zero), Err(Failure::InsideOut(_))),
            "{} {:?}",
            name(kind),
            outcome(&*own, &q, &zero)
        );
    }
}

/// Requirement: where no thickness is free of stress an element of plane stress has no answer.
/// Green's strain in the plane of more than (1 - nu)/nu over 4 in both directions would ask for a
/// strain of -1/2 across, which is no thickness at all; below that it has one.
#[test]
fn no_thickness() {
    let elastic = Elastic { modulus: 7.0, poisson: 0.45 };
    let green = Material::Elastic(elastic, LargeStrain::Green);
    let kind = (&QUAD4, &QUAD_4, PlaneStress, Plain, 0);
    let nodes = nodes(&QUAD4, 0.0);
    let own = kernel(&kind, &green, &nodes);
    let zero = vec![0.0; state_count(&kind, &green)];
    // E33 = - nu/(1 - nu) (E11 + E22) = -1/2
    let limit = (1.0 + 2.0 * 0.25 * 0.55 / 0.45_f64).sqrt() - 1.0;
    for (part, sound) in [(0.5, true), (0.99, true), (1.01, false), (2.0, false)] {
        let stretch = part * limit;
        let a = [[stretch, 0.0, 0.0], [0.0, stretch, 0.0], [0.0; 3]];
        let q = motion(&QUAD4, &nodes, a, 0.0);
        match outcome(&*own, &q, &zero) {
            Ok(_) => {
                let at = respond(&*own, &q, &zero, Strains::Exact);
                let strain = stretch + 0.5 * stretch * stretch;
                let across = (1.0 - 4.0 * 0.45 / 0.55 * strain).sqrt() - 1.0;
                assert!(sound && (at.state[0] - across).abs() < 1e-12, "{part} {:?}", at.state);
            }
            failed => {
                assert!(!sound && failed == Err(Failure::NoThickness(0)), "{part} {failed:?}")
            }
        }
    }
}

/// Centroid of a polygon.
fn centroid(corners: &[[f64; 3]]) -> [f64; 2] {
    let (mut twice, mut moment) = (0.0, [0.0; 2]);
    for (k, a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        let area = a[0] * b[1] - b[0] * a[1];
        twice += area;
        (0..2).for_each(|axis| moment[axis] += area * (a[axis] + b[axis]) / 3.0);
    }
    moment.map(|moment| moment / twice)
}

/// Requirement: a ring of one point is free to roll about the centroid of its section (u = z, -r from
/// it), the one motion without stiffness that docs/keywords/ELEMENT.md names; one of four points is
/// not. Source: the mean of the hoop strain z/r over its volume vanishes. Tolerance: rounding.
#[test]
fn rings_of_one_point_roll() {
    let kinds: [Kind; 4] = [
        (&TRI3, &TRI_1, Axisymmetric, Plain, 1),
        (&QUAD4, &QUAD_1, Axisymmetric, Hourglass, 1),
        (&QUAD4, &QUAD_4, Axisymmetric, MeanDilation, 0),
        (&QUAD8, &QUAD_4, Axisymmetric, Plain, 0),
    ];
    for kind in kinds {
        let nodes = nodes(kind.0, 0.12);
        let centre = centroid(&nodes[..nodes.len().min(4)]);
        let q: Vec<f64> = nodes.iter().flat_map(|x| [x[1] - centre[1], centre[0] - x[0]]).collect();
        let zero = vec![0.0; state_count(&kind, &hencky())];
        let at = respond(&*kernel(&kind, &hencky(), &nodes), &q, &zero, Strains::Linear);
        let free = at.energy.abs() < 1e-27;
        assert!(free == (kind.4 == 1), "{} {}", name(&kind), at.energy);
        assert!(free || at.energy > 1e-3);
    }
}
