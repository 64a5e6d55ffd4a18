//! Results of solids at their nodes.
//!
//! ```text
//!   o---o---o     x -> o: each element by the polynomial through its points, then the mean of the
//!   | A | A |     elements that meet; where two sections meet, A and B have values of their own
//!   o---o---o
//!   | B | B |
//!   o---o---o
//! ```

use super::points::{Solid, principal, solids};
use slideline_model::{Dialect, ElementType, Location, Model, NodeIndex};
use slideline_solve::observe::Frame;

/// Results at a node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AtNodes {
    /// Cauchy stress 11, 22, 33, 12, 13, 23 [F/L2].
    pub stress: [f64; 6],
    /// Strain as elements tell it [1]; shears are components of the tensor.
    pub strain: [f64; 6],
    /// Equivalent plastic strain [1].
    pub plastic: f64,
    /// Equivalent creep strain [1].
    pub creep: f64,
    /// Stored energy of a unit of undeformed volume [F/L2].
    pub energy: f64,
    /// Energy that plastic strain took of it [F/L2].
    pub dissipated: f64,
}

impl AtNodes {
    /// Principal stresses, ascending [F/L2].
    pub fn principal(&self) -> [f64; 3] {
        principal(self.stress)
    }
}

/// Number of values of a node.
const WIDTH: usize = 16;

/// Results at all places that somebody asks for.
#[derive(Clone, Debug, Default)]
pub struct NodalResults(Vec<Option<AtNodes>>);

impl NodalResults {
    /// Those at a place; `None` where no solid is.
    pub fn at(&self, place: usize) -> Option<&AtNodes> {
        self.0.get(place)?.as_ref()
    }

    /// All places.
    pub fn iter(&self) -> impl Iterator<Item = Option<&AtNodes>> {
        self.0.iter().map(Option::as_ref)
    }
}

/// A component of a result: where it stands among the values of an element, and at a node.
#[derive(Clone, Copy, Debug)]
struct Column {
    first: usize,
    /// From one point to the next; zero where the element has one value.
    stride: usize,
    into: usize,
}

impl Column {
    /// Its value at a point of an element.
    fn value(&self, element: &[f64], point: usize) -> f64 {
        element.get(self.first + self.stride * point).copied().unwrap_or_default()
    }
}

/// Components of all results that nodes have.
#[derive(Debug, Default)]
struct Columns(Vec<Column>);

impl Columns {
    /// Those that elements of a type offer.
    fn of(kind: &ElementType) -> Self {
        let told = [("S", 0), ("E", 6), ("PEEQ", 12), ("ENER", 13), ("PENER", 14), ("CEEQ", 15)];
        let mut columns = Vec::with_capacity(WIDTH);
        for (name, into) in told {
            let Some((field, first)) = kind.field(name) else { continue };
            let width = field.components.len();
            let stride = if field.location == Location::Centroid { 0 } else { width };
            let component = |k| Column { first: first + k, stride, into: into + k };
            columns.extend((0..width).map(component));
        }
        Self(columns)
    }
}

/// Results at the nodes of all solids of a frame, and of trusses where no solid is. `place` says for block and node where its values
/// are summed, among `places`: those of one place are averaged.
pub fn nodal_results(
    frame: &Frame<'_>,
    places: usize,
    place: impl Fn(usize, NodeIndex) -> usize + Copy,
) -> NodalResults {
    let mut sums: Vec<([f64; WIDTH], f64)> = vec![([0.0; WIDTH], 0.0); places];
    let (mut columns, mut of_block) = (Columns::default(), None);
    let (mut points, mut nodes) = (Vec::new(), Vec::new());
    let is_whole = |solid: &Solid<'_>| solid.points() > 0 && !solid.block.kind.is_truss();
    for solid in solids(frame).filter(is_whole) {
        if of_block.replace(solid.number) != Some(solid.number) {
            columns = Columns::of(solid.block.kind);
        }
        let width = columns.0.len();
        points.clear();
        for point in 0..solid.points() {
            points.extend(columns.0.iter().map(|column| column.value(solid.values(), point)));
        }
        nodes.resize(width * solid.element.nodes.len(), 0.0);
        (solid.block.kind.at_nodes)(&points, width, &mut nodes);
        for (&node, values) in solid.element.nodes.iter().zip(nodes.chunks_exact(width)) {
            if let Some((sum, count)) = sums.get_mut(place(solid.number, node)) {
                for (column, value) in columns.0.iter().zip(values) {
                    sum[column.into] += value;
                }
                *count += 1.0;
            }
        }
    }
    add_trusses(frame, place, &mut sums);
    let shear = if frame.model.dialect == Dialect::Abaqus { 0.5 } else { 1.0 };
    let mean = |(sum, count): ([f64; WIDTH], f64)| {
        let mean = sum.map(|sum| sum / count);
        let of = |first: usize| std::array::from_fn(|k| mean[first + k]);
        let mut strain: [f64; 6] = of(6);
        strain[3..].iter_mut().for_each(|strain| *strain *= shear);
        let [plastic, energy, dissipated, creep] = std::array::from_fn(|k| mean[12 + k]);
        AtNodes { stress: of(0), strain, plastic, creep, energy, dissipated }
    };
    let all = sums.into_iter().map(|sums| (sums.1 > 0.0).then(|| mean(sums)));
    NodalResults(all.collect())
}

/// Adds trusses where no solid is, along the axes of the model: along a truss alone, its stress is none that solids could be
/// averaged with.
fn add_trusses(
    frame: &Frame<'_>,
    place: impl Fn(usize, NodeIndex) -> usize,
    sums: &mut [([f64; WIDTH], f64)],
) {
    let has_solids: Vec<bool> = sums.iter().map(|(_, count)| *count > 0.0).collect();
    let shear = if frame.model.dialect == Dialect::Abaqus { 2.0 } else { 1.0 };
    for truss in solids(frame).filter(|own| own.points() > 0 && own.block.kind.is_truss()) {
        let mut mean = [0.0; WIDTH];
        let share = 1.0 / truss.points() as f64;
        for point in 0..truss.points() {
            let mut strain = truss.truss_strain(point).unwrap_or_default();
            strain[3..].iter_mut().for_each(|own| *own *= shear);
            let one = |name| truss.field(name, point).first().copied().unwrap_or_default();
            let tensors = truss.stress_in_space(point).into_iter().chain(strain);
            let values = tensors.chain([one("PEEQ"), 0.0, 0.0, one("CEEQ")]);
            mean.iter_mut().zip(values).for_each(|(sum, own)| *sum += share * own);
        }
        for &node in truss.element.nodes {
            let at = place(truss.number, node);
            let Some((sum, count)) = sums.get_mut(at).filter(|_| !has_solids[at]) else { continue };
            sum.iter_mut().zip(mean).for_each(|(sum, own)| *sum += own);
            *count += 1.0;
        }
    }
}

/// Of every block the first one with the same section: over its border stresses may jump.
pub fn regions(model: &Model) -> Vec<usize> {
    let blocks = &model.blocks;
    let first = |block: &slideline_model::ElementBlock| {
        blocks.iter().position(|other| other.section == block.section).unwrap_or_default()
    };
    blocks.iter().map(first).collect()
}
