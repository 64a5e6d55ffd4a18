//! Cost of one stencil: beams by hand and from their energy, a gap against a corner and a circle,
//! force and tangent of solids at large displacement; and of a search, the skin of a slab against itself.
#![allow(missing_docs, clippy::unwrap_used)] // generated entry points; fixed sound data

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use slideline_mech::contact::gap::circle::{Circle, Side};
use slideline_mech::contact::gap::curve::{Along, Weights, point_to_curve};
use slideline_mech::contact::gap::{Gap, Quadratic};
use slideline_mech::contact::search::faces::tree;
use slideline_mech::contact::search::own_faces::{OwnFaces, PlacedOwn, Standing};
use slideline_mech::differentiate::Second;
use slideline_mech::element::cell::{Cell, HEX8, HEX20, QUAD4, QUAD8, TET10};
use slideline_mech::element::quadrature::{HEX_8, HEX_27, QUAD_4, QUAD_9, Quadrature, TET_4};
use slideline_mech::element::solid::{
    Formulation, Interpolation, Kinematics, Recipe, Solids, Told, states,
};
use slideline_mech::element::{Beam21, Beam22, Beam23, Kernel, Response, Strains};
use slideline_mech::material::{Elastic, LargeStrain, Material, Plastic};
use slideline_mech::section::BeamStiffness;
use slideline_mech::surface::mesh::{FaceMesh, MeshFace, PlacedFace};

fn beam(criterion: &mut Criterion) {
    let stiffness =
        BeamStiffness { axial: 258_750.0, shear: 57_033.0, bending: 0.0485, centroid: 0.0 };
    let element = Beam21::new([[0.0, 0.0], [1e-4, 2e-3]], stiffness);
    let q = [1e-4, 2e-4, 0.1, 3e-4, -1e-4, 0.2];
    criterion.bench_function("b21 closed form", |bench| {
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        bench.iter(|| element.force_and_tangent(black_box(&q), &mut force, &mut tangent));
    });
    criterion.bench_function("b21 differentiated", |bench| {
        bench.iter(|| element.energy(&Second::variables(black_box(&q))));
    });
}

fn finer_beams(criterion: &mut Criterion) {
    let stiffness =
        BeamStiffness { axial: 258_750.0, shear: 57_033.0, bending: 0.0485, centroid: 0.0 };
    let quadratic = Beam22::new([[0.0, 0.0], [5e-5, 1e-3], [1e-4, 2e-3]], stiffness);
    let q = [1e-4, 2e-4, 0.1, 2e-4, 0.0, 0.15, 3e-4, -1e-4, 0.2];
    criterion.bench_function("b22 closed form", |bench| {
        let (mut force, mut tangent) = ([0.0; 9], [0.0; 81]);
        bench.iter(|| quadratic.force_and_tangent(black_box(&q), &mut force, &mut tangent));
    });
    let cubic = Beam23::new([[0.0, 0.0], [1e-4, 2e-3]], stiffness);
    let q = [1e-4, 2e-4, 0.1, 3e-4, -1e-4, 0.2];
    criterion.bench_function("b23 closed form", |bench| {
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        bench.iter(|| cubic.force_and_tangent(black_box(&q), &mut force, &mut tangent));
    });
    criterion.bench_function("b23 differentiated", |bench| {
        bench.iter(|| cubic.energy(&Second::variables(black_box(&q))));
    });
}

fn gaps(criterion: &mut Criterion) {
    let control = [[0.0, 0.0], [1.0, 0.1], [2.0, 0.0]];
    criterion.bench_function("gap corner", |bench| {
        bench.iter(|| -> Option<Gap<8>> {
            let s = black_box(0.4);
            let along = Along::corner(0.0, 0.2, 0.2, s);
            point_to_curve(black_box([0.95, 0.2]), &control, &Weights::corner(s, 0.2), &along, s)
        });
    });
    let circle = Circle { radius: 9e-3, side: Side::Convex };
    criterion.bench_function("gap circle", |bench| {
        bench.iter(|| circle.gap::<Quadratic>(black_box([8.9e-3, 1e-3]), [0.0, 0.0], 0.1, 0.0));
    });
}

/// What the nodes of a slab meet whose whole skin meets itself: nothing, which has to be found out.
fn skin(criterion: &mut Criterion) {
    const CELLS: usize = 60;
    let node = |side: usize, i: usize, j: usize| side * (CELLS + 1).pow(2) + j * (CELLS + 1) + i;
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    for side in 0..2 {
        for (j, i) in (0..=CELLS).flat_map(|j| (0..=CELLS).map(move |i| (j, i))) {
            nodes.push([i as f64, j as f64, 6.0 * side as f64]);
            if i < CELLS && j < CELLS {
                let mut round = [[0, 0], [1, 0], [1, 1], [0, 1]];
                if side == 0 {
                    round.reverse();
                }
                let nodes = round.map(|[a, b]| node(side, i + a, j + b)).to_vec();
                faces.push(MeshFace { cell: &QUAD4, nodes });
            }
        }
    }
    let mesh = FaceMesh::new(faces, &nodes, true);
    let own = OwnFaces::new(&mesh, &nodes);
    let (tree, mut standing, mut room) =
        (tree(&mesh, &nodes), Standing::default(), PlacedFace::EMPTY);
    criterion.bench_function("7200 faces against themselves", |bench| {
        bench.iter(|| {
            standing.take(&mesh, black_box(&nodes));
            let placed =
                PlacedOwn { mesh: &mesh, positions: &nodes, standing: &standing, tree: &tree };
            let met = |node: &usize| own.closest(placed, (*node, 0.1, None), &mut room).is_some();
            (0..nodes.len()).filter(met).count()
        });
    });
}

/// One element on its reference cell, bent and stretched a little.
fn solid<const D: usize, const N: usize, const P: usize>(
    criterion: &mut Criterion,
    (name, cell, rule): (&str, &'static Cell, &'static Quadrature),
    formulation: Formulation,
    material: Material,
) {
    let kinematics = if D == 2 { Kinematics::PlaneStrain } else { Kinematics::Space };
    let count = states((cell, rule), (kinematics, formulation), &material);
    let (thickness, told) = (1.0, Told::Logarithmic);
    let (orientation, temperatures) = (None, Interpolation::default());
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
    let nodes: [[f64; D]; N] =
        std::array::from_fn(|a| std::array::from_fn(|axis| cell.places[a][axis]));
    let element = Solids::<D, N, P>::new(recipe, [nodes].into_iter()).unwrap();
    let q: Vec<f64> = (0..D * N).map(|k| 0.02 * ((k * k) as f64).sin()).collect();
    let (mut force, mut tangent) = (vec![0.0; D * N], vec![0.0; D * N * D * N]);
    let (committed, mut state) = (vec![0.0; count], vec![0.0; count]);
    criterion.bench_function(name, |bench| {
        bench.iter(|| {
            let into =
                Response { force: &mut force, tangent: Some(&mut tangent), state: &mut state };
            element.respond(0, black_box(&q), &committed, &Strains::Exact.into(), into)
        });
    });
}

fn solids(criterion: &mut Criterion) {
    use Formulation::{Incompatible, MeanDilation, Plain};
    let steel = Elastic { modulus: 7.0, poisson: 0.3 };
    let hencky = || Material::Elastic(steel, LargeStrain::Logarithmic);
    let green = Material::Elastic(steel, LargeStrain::Green);
    let table = vec![[0.05, 0.0], [0.1, 1.0]];
    let metal = Material::Plastic(Plastic { elastic: steel, table, back_stresses: Vec::new() });
    let hex = |name| (name, &HEX8, &HEX_8);
    solid::<2, 4, 4>(criterion, ("CPE4", &QUAD4, &QUAD_4), MeanDilation, hencky());
    solid::<2, 8, 9>(criterion, ("CPE8", &QUAD8, &QUAD_9), Plain, hencky());
    solid::<3, 8, 8>(criterion, hex("C3D8"), MeanDilation, hencky());
    solid::<3, 8, 8>(criterion, hex("C3D8 Green"), MeanDilation, green);
    solid::<3, 8, 8>(criterion, hex("C3D8 plastic"), MeanDilation, metal);
    solid::<3, 8, 8>(criterion, hex("C3D8I"), Incompatible, hencky());
    solid::<3, 10, 4>(criterion, ("C3D10", &TET10, &TET_4), Plain, hencky());
    solid::<3, 20, 8>(criterion, ("C3D20R", &HEX20, &HEX_8), Plain, hencky());
    solid::<3, 20, 27>(criterion, ("C3D20", &HEX20, &HEX_27), Plain, hencky());
}

criterion_group!(benches, beam, finer_beams, gaps, skin, solids);
criterion_main!(benches);
