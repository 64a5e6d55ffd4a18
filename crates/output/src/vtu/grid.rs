//! One state as an unstructured grid.

use crate::outline::{Outline, outlines};
use crate::section::{axial_stresses, beams, outer_mises};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use slideline_model::{Dof, Element, Kinematics, Model, NodeIndex};
use slideline_results::element as solid;
use slideline_results::{NodeComponent, NodeField, contact_component, shown};
use slideline_solve::observe::{Frame, Status, Unconverged};
use std::collections::HashMap;
use std::fmt::Write as _;

/// Bytes that are coded at a time.
const BLOCK: usize = 3072;

/// The field of forces and moments.
const REACTION: NodeField = NodeField::Reaction;

/// Arrays of contact, each with its component and what stands where there is no
/// contact point.
const CONTACT: [(&str, &str, f64); 4] = [
    ("contact_pressure", "CPRESS", 0.0),
    ("contact_shear", "CSHEAR1", 0.0),
    ("contact_slip", "CSLIP1", 0.0),
    ("contact_opening", "COPEN", f64::NAN),
];

/// VTK_LINE: all curves are lines (some readers know no poly-lines).
const LINE: u8 = 3;

/// What a cell stands for, as written to `kind`.
#[derive(Clone, Copy)]
enum Kind {
    Beam = 0,
    Spring = 1,
    SlaveSurface = 2,
    RigidSurface = 3,
    Solid = 4,
}

struct Cell {
    points: Vec<usize>,
    /// Type in VTK's numbers.
    shape: u8,
    kind: Kind,
    label: u64,
}

impl Cell {
    fn line(points: [usize; 2], kind: Kind, label: u64) -> Self {
        Self { points: points.to_vec(), shape: LINE, kind, label }
    }
}

/// What does not change between states.
pub(super) struct Grid {
    outlines: Vec<Outline>,
    cells: Vec<Cell>,
    /// First index in the cell list of every element label with results and number
    /// of its cells: two for a beam of three nodes.
    cells_of: HashMap<u64, (usize, usize)>,
    point_count: usize,
    /// The finished `<Cells>` element.
    topology: String,
    /// The finished arrays of node labels, and of element labels and kinds.
    labels: [String; 2],
}

impl Grid {
    /// Lays points and cells of a model out.
    pub fn new(model: &Model) -> Self {
        let mut cells = element_cells(model);
        let mut cells_of = HashMap::new();
        for (place, cell) in cells.iter().enumerate() {
            if matches!(cell.kind, Kind::Beam | Kind::Solid) {
                cells_of.entry(cell.label).or_insert((place, 0)).1 += 1;
            }
        }
        let outlines = outlines(model);
        let mut point_count = model.nodes.len();
        for outline in &outlines {
            let end = point_count + outline.points.len();
            let lines = (point_count + 1..end).map(|point| [point - 1, point]);
            cells.extend(lines.map(|points| Cell::line(points, Kind::RigidSurface, 0)));
            point_count = end;
        }
        let topology = topology(&cells);
        let labels = [node_labels(model, point_count), cell_labels(&cells)];
        Self { outlines, cells, cells_of, point_count, topology, labels }
    }

    /// The whole file of a state, in place of what `text` holds; of one that is
    /// no equilibrium with what is missing to it.
    pub fn file(
        &self,
        text: &mut String,
        frame: &Frame<'_>,
        unconverged: Option<&Unconverged<'_>>,
    ) {
        text.clear();
        let _ = write!(
            text,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" \
             byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<UnstructuredGrid>\n\
             <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            self.point_count,
            self.cells.len()
        ); // a String takes any text
        let (points, displacement) = self.positions(frame);
        text.push_str("<Points>\n");
        push_floats(text, "Points", 3, &points);
        text.push_str("</Points>\n");
        text.push_str(&self.topology);
        text.push_str("<PointData>\n");
        push_floats(text, "displacement", 3, &displacement);
        let value = |part: NodeComponent, node| part.value(frame, node);
        self.push_vectors(text, frame, "rotation", (NodeField::Motion, 3), &value);
        self.push_vectors(text, frame, "reaction_force", (REACTION, 0), &value);
        self.push_vectors(text, frame, "reaction_moment", (REACTION, 3), &value);
        if let Some(state) = unconverged {
            let missing = |part: NodeComponent, node| part.residual(state, node);
            self.push_vectors(text, frame, "residual_force", (REACTION, 0), &missing);
            self.push_vectors(text, frame, "residual_moment", (REACTION, 3), &missing);
        }
        self.push_contact(text, frame);
        text.push_str("</PointData>\n<CellData>\n");
        self.push_sections(text, frame);
        text.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    }

    /// Current positions and displacements, three components a point.
    fn positions(&self, frame: &Frame<'_>) -> (Vec<f64>, Vec<f64>) {
        let mut points = Vec::with_capacity(3 * self.point_count);
        let mut displacement = Vec::with_capacity(3 * self.point_count);
        for (index, node) in frame.model.nodes.iter().enumerate() {
            for (axis, dof) in [Dof::U1, Dof::U2, Dof::U3].into_iter().enumerate() {
                let moved = frame.nodal.displacement(index, dof);
                points.push(node.position[axis] + moved);
                displacement.push(moved);
            }
        }
        for outline in &self.outlines {
            for &point in &outline.points {
                let moved = outline.carried(frame, point);
                points.extend([moved[0], moved[1], 0.0]);
                displacement.extend([moved[0] - point[0], moved[1] - point[1], 0.0]);
            }
        }
        (points, displacement)
    }

    /// Three components of a field, from one on, at every node; zero at the
    /// points of outlines.
    fn push_vectors(
        &self,
        text: &mut String,
        frame: &Frame<'_>,
        name: &str,
        (field, first): (NodeField, usize),
        value: &dyn Fn(NodeComponent, NodeIndex) -> f64,
    ) {
        let parts: Vec<NodeComponent> = field.components(&Dof::ALL[first..first + 3]).collect();
        let mut values = Vec::with_capacity(3 * self.point_count);
        for node in 0..frame.model.nodes.len() {
            values.extend(parts.iter().map(|&part| value(part, node)));
        }
        values.resize(3 * self.point_count, 0.0);
        push_floats(text, name, 3, &values);
    }

    /// Contact at slave nodes: elsewhere no pressure, no opening (not a
    /// number) and status -1. A node of several pairs shows where it is
    /// pressed most.
    fn push_contact(&self, text: &mut String, frame: &Frame<'_>) {
        let shown = shown(frame);
        for (name, component, without) in CONTACT {
            let mut values = vec![without; self.point_count];
            for (&node, row) in &shown {
                values[node] = contact_component(component).map_or(without, |own| (own.value)(row));
            }
            push_floats(text, name, 1, &values);
        }
        let mut status = vec![-1; self.point_count];
        for (&node, row) in &shown {
            status[node] = match row.status {
                Status::Open => 0,
                Status::Stick => 1,
                Status::Slip => 2,
            };
        }
        push_short(text, "contact_status", &status);
        text.push_str(&self.labels[0]);
    }

    fn push_sections(&self, text: &mut String, frame: &Frame<'_>) {
        let count = self.cells.len();
        let mut columns = [
            ("axial_force", vec![0.0; count]),
            ("shear_force", vec![0.0; count]),
            ("bending_moment", vec![0.0; count]),
            ("fibre_strain", vec![0.0; count]),
            ("S11_1", vec![0.0; count]),
            ("S11_5", vec![0.0; count]),
            ("mises", vec![0.0; count]),
        ];
        for (beam, _, section) in beams(frame) {
            let Some(&(first, cells)) = self.cells_of.get(&beam.label) else { continue };
            let stresses = axial_stresses(beam, section);
            let values = [
                beam.axial_force,
                beam.shear_force,
                beam.bending_moment,
                beam.fibre_strain,
                stresses[0],
                stresses[4],
                outer_mises(&stresses),
            ];
            for ((_, column), value) in columns.iter_mut().zip(values) {
                column[first..first + cells].fill(value);
            }
        }
        let [.., (_, mises)] = &mut columns;
        let own = self.solids(frame, mises);
        for (name, column) in &columns {
            push_floats(text, name, 1, column);
        }
        for (name, column) in &own {
            push_floats(text, name, 1, column);
        }
        text.push_str(&self.labels[1]);
    }

    /// Means over the element of all fields that are not those of a beam, each under
    /// its own name; Mises stresses of solids go into `mises`.
    fn solids(&self, frame: &Frame<'_>, mises: &mut [f64]) -> Vec<(&'static str, Vec<f64>)> {
        let mut columns: Vec<(&'static str, Vec<f64>)> = Vec::new();
        for (kind, results) in solid::blocks(frame) {
            for (element, values) in results.elements(frame.model) {
                let Some(&(first, cells)) = self.cells_of.get(&element.label) else { continue };
                let own = first..first + cells;
                for (name, mean) in solid::means(kind, values) {
                    let known = columns.iter().position(|(column, _)| *column == name);
                    let at = known.unwrap_or_else(|| {
                        columns.push((name, vec![0.0; self.cells.len()]));
                        columns.len() - 1
                    });
                    columns[at].1[own.clone()].fill(mean);
                }
                let stresses = solid::stresses(kind, values);
                if !stresses.is_empty() {
                    let sum: f64 = stresses.iter().map(|&tensor| solid::mises(tensor)).sum();
                    mises[own].fill(sum / stresses.len() as f64);
                }
            }
        }
        columns
    }
}

fn node_labels(model: &Model, points: usize) -> String {
    let labels = model.nodes.iter().map(|node| whole(node.label)).chain(std::iter::repeat(0));
    let mut text = String::new();
    push_long(&mut text, "node", &labels.take(points).collect::<Vec<i64>>());
    text
}

fn cell_labels(cells: &[Cell]) -> String {
    let mut text = String::new();
    push_long(
        &mut text,
        "element",
        &cells.iter().map(|cell| whole(cell.label)).collect::<Vec<_>>(),
    );
    push_short(&mut text, "kind", &cells.iter().map(|cell| cell.kind as i32).collect::<Vec<_>>());
    text
}

fn whole(label: u64) -> i64 {
    i64::try_from(label).unwrap_or(i64::MAX)
}

fn element_cells(model: &Model) -> Vec<Cell> {
    let mut cells = Vec::new();
    for block in &model.blocks {
        let kind = match block.kind.kinematics {
            Kinematics::Beam { .. } => Kind::Beam,
            Kinematics::Spring => Kind::Spring,
            Kinematics::Solid { .. } | Kinematics::Other => Kind::Solid,
        };
        for element in &block.elements {
            let Element { label, nodes, .. } = element;
            cells.extend(block.kind.cell.pieces.iter().map(|piece| {
                let points = piece.nodes.iter().map(|&place| nodes[place]).collect();
                Cell { points, shape: piece.vtk, kind, label }
            }));
        }
    }
    for pair in &model.contact_pairs {
        let surface = pair.elements.iter();
        cells.extend(surface.map(|e| Cell::line(e.nodes, Kind::SlaveSurface, e.label)));
    }
    cells
}

fn topology(cells: &[Cell]) -> String {
    let count = |place: usize| i64::try_from(place).unwrap_or(i64::MAX);
    let connectivity: Vec<i64> =
        cells.iter().flat_map(|cell| cell.points.iter().map(|&p| count(p))).collect();
    let mut end = 0;
    let ends = cells.iter().map(|cell| {
        end += cell.points.len();
        count(end)
    });
    let offsets: Vec<i64> = ends.collect();
    let types: Vec<u8> = cells.iter().map(|cell| cell.shape).collect();
    let mut text = "<Cells>\n".to_owned();
    push_long(&mut text, "connectivity", &connectivity);
    push_long(&mut text, "offsets", &offsets);
    push_array(&mut text, ["UInt8", "types"], 1, &types, |kind| [kind]);
    text.push_str("</Cells>\n");
    text
}

/// A data array: the number of bytes and the bytes, as one base64 text, coded a
/// block at a time right into the file's text.
fn push_array<T: Copy, const N: usize>(
    text: &mut String,
    [kind, name]: [&str; 2],
    components: usize,
    values: &[T],
    code: impl Fn(T) -> [u8; N],
) {
    let _ = write!(text, "<DataArray type=\"{kind}\" Name=\"{name}\""); // a String takes any text
    if components > 1 {
        let _ = write!(text, " NumberOfComponents=\"{components}\""); // as above
    }
    text.push_str(" format=\"binary\">");
    let length = u32::try_from(values.len() * N).unwrap_or(u32::MAX);
    let mut block = [0; BLOCK];
    block[..4].copy_from_slice(&length.to_le_bytes());
    let mut filled = 4;
    for &value in values {
        block[filled..filled + N].copy_from_slice(&code(value));
        filled += N;
        if filled > BLOCK - 8 {
            let whole = filled - filled % 3; // so that nothing is padded between
            STANDARD.encode_string(&block[..whole], text);
            block.copy_within(whole..filled, 0);
            filled -= whole;
        }
    }
    STANDARD.encode_string(&block[..filled], text);
    text.push_str("</DataArray>\n");
}

fn push_floats(text: &mut String, name: &str, components: usize, values: &[f64]) {
    push_array(text, ["Float64", name], components, values, f64::to_le_bytes);
}

fn push_long(text: &mut String, name: &str, values: &[i64]) {
    push_array(text, ["Int64", name], 1, values, i64::to_le_bytes);
}

fn push_short(text: &mut String, name: &str, values: &[i32]) {
    push_array(text, ["Int32", name], 1, values, i32::to_le_bytes);
}
