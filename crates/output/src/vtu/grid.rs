//! One state as an unstructured grid.

use super::array::{Arrays, Text};
use super::held::Held;
use crate::outline::{Drawing, Kind, SPACE};
use crate::section::{axial_stresses, beams, outer_mises, space_beams};
use slideline_model::{Dof, Model};
use slideline_results::element::{self, AtNodes, NodalResults, nodal_results, solids};
use slideline_results::{NodeField, contact_component, shown};
use slideline_solve::observe::{ContactRow, Frame, Status, Unconverged};
use std::ops::Range;

/// Arrays of contact across the master, each with its component and what stands where there is no
/// contact point.
const CONTACT: [(&str, &str, f64); 2] =
    [("contact_pressure", "CPRESS", 0.0), ("contact_opening", "COPEN", f64::NAN)];
/// A vector of a contact point.
type Vector = fn(&ContactRow) -> [f64; 3];

/// Arrays of contact along the master: in the plane a number; in space a vector, for every point has
/// directions of its own.
const ALONG: [(&str, &str, Vector); 2] = [
    ("contact_shear", "CSHEAR1", ContactRow::shear_in_space),
    ("contact_slip", "CSLIP1", ContactRow::slip_in_space),
];

/// Arrays of beams, of which the last is one of solids too.
const SECTION: [&str; 7] =
    ["axial_force", "shear_force", "bending_moment", "fibre_strain", "S11_1", "S11_5", "mises"];

const TURNS: [Dof; 3] = [Dof::UR1, Dof::UR2, Dof::UR3];

/// What does not change between states.
pub(crate) struct Grid {
    drawing: Drawing,
    /// Label and cells of every element with results, in the order of the model:
    /// two for a beam of three nodes.
    cells_of: Vec<(u64, Range<usize>)>,
    /// The head of the file.
    head: String,
    /// The finished `<Cells>` element.
    topology: Vec<u8>,
    /// The finished arrays of node labels, and of element labels and kinds.
    labels: [Vec<u8>; 2],
}

impl Grid {
    /// Lays points and cells of a model out.
    pub fn new(model: &Model) -> Self {
        let drawing = Drawing::split(model);
        let mut cells_of: Vec<(u64, Range<usize>)> = Vec::new();
        let with_results = |kind| matches!(kind, Kind::Beam | Kind::Solid);
        let pieces = drawing.pieces.iter().enumerate();
        for (place, piece) in pieces.filter(|(_, piece)| with_results(piece.kind)) {
            match cells_of.last_mut().filter(|(label, _)| *label == piece.label) {
                Some((_, cells)) => cells.end = place + 1,
                None => cells_of.push((piece.label, place..place + 1)),
            }
        }
        let head = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" \
             byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<UnstructuredGrid>\n\
             <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
            drawing.labels.len(),
            drawing.pieces.len()
        );
        let topology = topology(&drawing);
        let labels = [
            node_labels(&drawing, model.nodes.len() + drawing.copies(0).count()),
            cell_labels(&drawing),
        ];
        Self { drawing, cells_of, head, topology, labels }
    }

    /// The whole file of a state, in place of what `text` holds; of one that is
    /// no equilibrium with what is missing to it.
    pub(super) fn file(
        &self,
        text: &mut Text,
        frame: &Frame<'_>,
        unconverged: Option<&Unconverged<'_>>,
    ) {
        text.letters.clear();
        text.push(self.head.as_bytes());
        let [points, displacement] = self.drawing.moved(frame);
        text.push_floats("Points", 3, &points);
        text.push(b"</Points>\n");
        text.push(&self.topology);
        text.push(b"<PointData>\n");
        text.push_floats("displacement", 3, &displacement);
        let mut push = |name: &str, frame: &Frame<'_>, field: NodeField, dofs: [Dof; 3]| {
            text.push_floats(name, 3, &self.drawing.values(field.table(frame, &dofs)));
        };
        push("rotation", frame, NodeField::Motion, TURNS);
        push("reaction_force", frame, NodeField::Reaction, SPACE);
        push("reaction_moment", frame, NodeField::Reaction, TURNS);
        if let Some(missing) = unconverged.map(Unconverged::missing) {
            push("residual_force", &missing, NodeField::Reaction, SPACE);
            push("residual_moment", &missing, NodeField::Reaction, TURNS);
        }
        if frame.model.has_temperatures() {
            let mut values = vec![0.0; self.drawing.labels.len()];
            let nodes = values.iter_mut().take(frame.model.nodes.len()).enumerate();
            nodes.for_each(|(node, value)| *value = frame.nodal.temperature(node));
            text.push_floats("temperature", 1, &values);
        }
        self.push_contact(text, frame);
        self.push_solids(text, frame);
        text.push(b"</PointData>\n<CellData>\n");
        self.push_sections(text, frame);
        text.push(&self.labels[1]);
        text.push(b"</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    }

    /// Contact at slave nodes: elsewhere no pressure, no opening (not a
    /// number) and status -1. A node of several pairs shows where it is
    /// pressed most.
    fn push_contact(&self, text: &mut Text, frame: &Frame<'_>) {
        let (shown, count) = (shown(frame), self.drawing.labels.len());
        let copies = || self.drawing.copies(frame.model.nodes.len());
        let mut numbers = CONTACT.to_vec();
        for (name, component, in_space) in ALONG {
            if !frame.model.is_in_space() {
                numbers.push((name, component, 0.0));
                continue;
            }
            let mut values = vec![[0.0; 3]; count];
            shown.iter().for_each(|(&node, row)| values[node] = in_space(row));
            copies().for_each(|(copy, node)| values[copy] = values[node]);
            text.push_floats(name, 3, values.as_flattened());
        }
        for (name, component, without) in numbers {
            let mut values = vec![without; count];
            if let Some(component) = contact_component(component) {
                shown.iter().for_each(|(&node, row)| values[node] = (component.value)(row));
                copies().for_each(|(copy, node)| values[copy] = values[node]);
            }
            text.push_floats(name, 1, &values);
        }
        let mut status = vec![-1; count];
        for (&node, row) in &shown {
            status[node] = match row.status {
                Status::Open => 0,
                Status::Stick => 1,
                Status::Slip => 2,
            };
        }
        copies().for_each(|(copy, node)| status[copy] = status[node]);
        text.push_short("contact_status", &status);
        text.push(&self.labels[0]);
    }

    fn push_sections(&self, arrays: &mut impl Arrays, frame: &Frame<'_>) {
        let zeros = || vec![0.0; self.drawing.pieces.len()];
        let mut columns = SECTION.map(|name| (name, zeros()));
        let mut places = self.cells_of.iter();
        for (beam, _, section) in beams(frame) {
            let Some(cells) = find(&mut places, beam.label) else { continue };
            let stresses = axial_stresses([beam.axial_force, beam.bending_moment], section);
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
                column[cells.clone()].fill(value);
            }
        }
        let mut places = self.cells_of.iter();
        for beam in space_beams(frame) {
            let Some(cells) = find(&mut places, beam.element.label) else { continue };
            let own = [("axial_force", beam.value("SF", 0)), ("fibre_strain", beam.fibre_strain())];
            for (name, value) in own {
                let columns = columns.iter_mut().filter(|(column, _)| *column == name);
                columns.for_each(|(_, column)| column[cells.clone()].fill(value));
            }
        }
        let [.., (_, mises)] = &mut columns;
        let own = self.solids(frame, mises);
        for (name, column) in columns.iter().chain(&own) {
            arrays.push_floats(name, 1, column);
        }
        if let Some(there) = self.presence(frame.model, frame.step) {
            arrays.push_short("active", &there);
        }
    }

    /// Which cells are there in a step, in models that some step changes.
    pub fn presence(&self, model: &Model, step: usize) -> Option<Vec<i32>> {
        let step = model.steps.get(step.wrapping_sub(1)).filter(|_| model.is_changed())?;
        let pieces = self.drawing.pieces.iter();
        Some(pieces.map(|piece| i32::from(piece.owner.is_there(&step.presence))).collect())
    }

    /// What a picture of a state needs of its file, held in memory.
    pub fn drawn(&self, frame: &Frame<'_>) -> Held {
        let mut held = Held::default();
        let [points, displacement] = self.drawing.moved(frame);
        held.push_floats("Points", 3, &points);
        held.push_floats("displacement", 3, &displacement);
        let place = |block, node| self.drawing.point(block, node);
        let results = nodal_results(frame, self.drawing.labels.len(), place);
        if results.iter().any(|own| own.is_some()) {
            held.push_floats(
                "mises_stress",
                1,
                &numbers(&results, |own| element::mises(own.stress)),
            );
            held.push_floats("plastic_strain", 1, &numbers(&results, |own| own.plastic));
        }
        self.push_sections(&mut held, frame);
        held
    }

    /// The same with what does not change.
    pub fn drawn_whole(&self, frame: &Frame<'_>) -> Held {
        let mut held = self.drawn(frame);
        let nodes = frame.model.nodes.len();
        push_nodes(&mut held, &self.drawing, nodes + self.drawing.copies(0).count());
        push_cells(&mut held, &self.drawing);
        push_topology(&mut held, &self.drawing);
        held
    }

    /// Means over the element of all fields that are not those of a beam, each under
    /// its own name; Mises stresses of solids go into `mises`.
    fn solids(&self, frame: &Frame<'_>, mises: &mut [f64]) -> Vec<(&'static str, Vec<f64>)> {
        let mut columns: Vec<(&'static str, Vec<f64>)> = Vec::new();
        let mut places = self.cells_of.iter();
        for solid in solids(frame) {
            let Some(cells) = find(&mut places, solid.element.label) else { continue };
            for (name, mean) in solid.means() {
                let known = columns.iter().position(|(column, _)| *column == name);
                let at = known.unwrap_or_else(|| {
                    columns.push((name, vec![0.0; self.drawing.pieces.len()]));
                    columns.len() - 1
                });
                columns[at].1[cells.clone()].fill(mean);
            }
            if solid.points() > 0 {
                let points = 0..solid.points();
                let sum: f64 = points.map(|point| element::mises(solid.stress(point))).sum();
                mises[cells].fill(sum / solid.points() as f64);
            }
        }
        columns
    }

    /// Stresses and strains of solids at their nodes; no number where there is no solid.
    fn push_solids(&self, text: &mut Text, frame: &Frame<'_>) {
        let place = |block, node| self.drawing.point(block, node);
        let results = nodal_results(frame, self.drawing.labels.len(), place);
        if results.iter().all(|own| own.is_none()) {
            return;
        }
        let tensor = |of: fn(&AtNodes) -> [f64; 6]| -> Vec<f64> {
            // VTK has xx, yy, zz, xy, yz, xz
            let order = |[xx, yy, zz, xy, xz, yz]: [f64; 6]| [xx, yy, zz, xy, yz, xz];
            results.iter().flat_map(|own| own.map_or([f64::NAN; 6], |own| order(of(own)))).collect()
        };
        let number = |of: fn(&AtNodes) -> f64| numbers(&results, of);
        text.push_floats("stress", 6, &tensor(|own| own.stress));
        text.push_floats("strain", 6, &tensor(|own| own.strain));
        let principal: Vec<f64> =
            results.iter().flat_map(|own| own.map_or([f64::NAN; 3], AtNodes::principal)).collect();
        text.push_floats("principal_stress", 3, &principal);
        text.push_floats("mises_stress", 1, &number(|own| element::mises(own.stress)));
        text.push_floats("plastic_strain", 1, &number(|own| own.plastic));
        if solids(frame).any(|solid| solid.creeps()) {
            text.push_floats("creep_strain", 1, &number(|own| own.creep));
        }
        text.push_floats("energy_density", 1, &number(|own| own.energy));
    }
}

/// Cells of an element; elements are asked for in the order of the model.
fn find(
    places: &mut std::slice::Iter<'_, (u64, Range<usize>)>,
    label: u64,
) -> Option<Range<usize>> {
    let mut rest = places.clone();
    let (_, cells) = rest.find(|(own, _)| *own == label)?;
    *places = rest;
    Some(cells.clone())
}

/// A number of the results at every point; no number where there is none.
fn numbers(results: &NodalResults, of: fn(&AtNodes) -> f64) -> Vec<f64> {
    results.iter().map(|own| own.map_or(f64::NAN, of)).collect()
}

fn node_labels(drawing: &Drawing, nodes: usize) -> Vec<u8> {
    let mut text = Text::default();
    push_nodes(&mut text, drawing, nodes);
    text.letters
}

fn push_nodes(arrays: &mut impl Arrays, drawing: &Drawing, nodes: usize) {
    let own = |(place, &label): (usize, &u64)| if place < nodes { label } else { 0 };
    arrays.push_long("node", drawing.labels.iter().enumerate().map(own));
}

fn cell_labels(drawing: &Drawing) -> Vec<u8> {
    let mut text = Text::default();
    push_cells(&mut text, drawing);
    text.letters
}

fn push_cells(arrays: &mut impl Arrays, drawing: &Drawing) {
    arrays.push_long("element", drawing.pieces.iter().map(|piece| piece.label));
    let kinds: Vec<i32> = drawing.pieces.iter().map(|piece| piece.kind as i32).collect();
    arrays.push_short("kind", &kinds);
}

fn topology(drawing: &Drawing) -> Vec<u8> {
    let mut text = Text::default();
    text.push(b"<Cells>\n");
    push_topology(&mut text, drawing);
    text.push(b"</Cells>\n");
    text.letters
}

fn push_topology(arrays: &mut impl Arrays, drawing: &Drawing) {
    let pieces = || drawing.pieces.iter();
    let mut end = 0;
    let ends = pieces().map(|piece| {
        end += piece.vtk.1.len() as u64;
        end
    });
    let types: Vec<u8> = pieces().map(|piece| piece.vtk.0).collect();
    let points = pieces().flat_map(|piece| piece.vtk.1.iter().map(|&point| point as u64));
    arrays.push_long("connectivity", points);
    arrays.push_long("offsets", ends);
    arrays.push_types(&types);
}
