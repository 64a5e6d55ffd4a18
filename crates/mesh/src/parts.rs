//! Which cells of a mesh become elements, of which type and in which set.
//!
//! ```text
//!   cells of the largest dimension   -> solids      in their groups, or REST
//!   lines of groups asked for        -> beams
//!   other groups                     -> faces of the solids, nodes
//! ```

use crate::corners::{corner_count, reversed};
use crate::fault::{misfit, no_element};
use crate::mesh::{Cell, Mesh};
use crate::names::{clean, free};
use crate::wishes::Asked;
use slideline_diag::Diagnostic;
use slideline_model::{ElementType, element_type};

/// Elements of one set and one type.
pub(crate) struct Part {
    pub set: String,
    pub kind: &'static ElementType,
    /// Numbers and nodes.
    pub elements: Vec<(u64, Vec<u64>)>,
}

/// The name of the set of what is in no group.
const REST: &str = "REST";

/// Elements of a mesh.
pub(crate) struct Parts {
    pub parts: Vec<Part>,
    /// Dimension of the solids [1]; 1 where there are beams alone.
    pub dimension: usize,
    /// Whether all is in the plane.
    pub in_plane: bool,
}

impl Parts {
    pub fn of(mesh: &Mesh, asked: &Asked) -> Result<Self, Box<Diagnostic>> {
        let dimension = mesh.cells.iter().map(|cell| cell.dimension).max().unwrap_or_default();
        let mut parts = Self { parts: Vec::new(), dimension, in_plane: false };
        let set_of = sets(mesh, asked, dimension);
        let rest = free(REST, &mut mesh.groups.iter().map(|own| clean(&own.name)).collect());
        for (cell, set) in mesh.cells.iter().zip(&set_of) {
            if cell.dimension == dimension && dimension > 1
                || set.is_some_and(|g| is_beam(asked, g))
            {
                parts.take(mesh, asked, cell, (*set, &rest))?;
            }
        }
        if parts.parts.is_empty() {
            let message =
                "the mesh has neither areas nor volumes, and no group is said to be beams";
            return Err(misfit(message, "Say which lines are beams: --beam NAME=B21."));
        }
        parts.in_plane = parts.parts.iter().all(|part| !is_in_space(part.kind));
        parts.must_be_flat(mesh)?;
        if parts.in_plane {
            parts.turn(mesh);
        }
        Ok(parts)
    }

    fn take(
        &mut self,
        mesh: &Mesh,
        asked: &Asked,
        cell: &Cell,
        (set, rest): (Option<usize>, &str),
    ) -> Result<(), Box<Diagnostic>> {
        let name = set.map_or(rest, |place| &mesh.groups[place].name);
        let kind = kind(cell, name, set.and_then(|place| asked.kinds[place].as_ref()))?;
        let set = clean(name);
        let element = (cell.label, cell.nodes.clone());
        let same = |part: &&mut Part| part.set == set && part.kind.name() == kind.name();
        match self.parts.iter_mut().find(same) {
            Some(part) => part.elements.push(element),
            None => self.parts.push(Part { set, kind, elements: vec![element] }),
        }
        Ok(())
    }

    /// Elements of the plane stand in it: a surface in space has no element here.
    fn must_be_flat(&self, mesh: &Mesh) -> Result<(), Box<Diagnostic>> {
        if self.parts.iter().all(|part| is_in_space(part.kind)) {
            return Ok(());
        }
        let used = self.parts.iter().flat_map(|part| &part.elements).flat_map(|own| &own.1);
        let places: Vec<[f64; 3]> = used.filter_map(|node| mesh.nodes.get(node)).copied().collect();
        let extent = |axis: usize| {
            let values = places.iter().map(|place| place[axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (f64::min(low, v), f64::max(high, v))
            });
            high - low
        };
        if extent(2) > FLAT * extent(0).max(extent(1)) {
            let message = "the areas or lines of the mesh do not lie in the plane of x and y";
            let help = "There are no shells here: mesh the volume, or draw the section in x and y.";
            return Err(misfit(message, help));
        }
        Ok(())
    }

    /// Areas of the plane are counter-clockwise; gmsh follows the drawing.
    fn turn(&mut self, mesh: &Mesh) {
        let areas = self.parts.iter_mut().filter(|part| part.kind.cell.dimension == 2);
        for (_, nodes) in areas.flat_map(|part| &mut part.elements) {
            let corners = &nodes[..corner_count(nodes.len())];
            let place = |node: &u64| mesh.nodes.get(node).copied().unwrap_or_default();
            let next = corners.iter().cycle().skip(1);
            let twice = |(a, b): (&u64, &u64)| {
                let ([x, y, _], [to_x, to_y, _]) = (place(a), place(b));
                x * to_y - to_x * y
            };
            let area: f64 = corners.iter().zip(next).map(twice).sum();
            if area < 0.0 {
                *nodes = reversed(nodes);
            }
        }
    }
}

/// Part of its size by which a plane mesh may leave the plane: what is left of rounding.
const FLAT: f64 = 1e-9;

fn is_in_space(kind: &ElementType) -> bool {
    kind.cell.dimension == 3 || kind.is_space_beam()
}

fn is_beam(asked: &Asked, group: usize) -> bool {
    asked.kinds[group].as_ref().is_some_and(|(_, beam)| *beam)
}

/// The group that every cell belongs to: the first one with an element type, or else the first one.
fn sets(mesh: &Mesh, asked: &Asked, dimension: usize) -> Vec<Option<usize>> {
    let mut sets: Vec<Option<usize>> = vec![None; mesh.cells.len()];
    for (place, group) in mesh.groups.iter().enumerate() {
        let wanted = asked.kinds[place].is_some();
        for &cell in &group.cells {
            let own = mesh.cells[cell].dimension;
            let first = sets[cell].is_none() && own == dimension;
            let better = wanted && sets[cell].is_none_or(|other| asked.kinds[other].is_none());
            if first || better {
                sets[cell] = Some(place);
            }
        }
    }
    sets
}

/// The element type of a cell: the one asked for, the one of its family with so many nodes, or the
/// plain one.
fn kind(
    cell: &Cell,
    set: &str,
    asked: Option<&(String, bool)>,
) -> Result<&'static ElementType, Box<Diagnostic>> {
    let (dimension, nodes) = (cell.dimension, cell.nodes.len());
    let fits = |kind: &&ElementType| kind.cell.dimension == dimension && kind.cell.nodes == nodes;
    let Some((name, beam)) = asked else {
        let family = if dimension == 2 { "CPS" } else { "C3D" };
        return element_type(&format!("{family}{nodes}")).filter(fits).ok_or_else(|| {
            no_element(format!("there are no elements of {nodes} nodes"), Some(cell.span))
        });
    };
    let Some(own) = element_type(name) else {
        let known = slideline_model::TYPES.into_iter().map(ElementType::name);
        let help = slideline_deck::nearest(name, known).map_or_else(
            || "`slideline explain ELEMENT` lists them.".to_owned(),
            |near| format!("Is {near} meant?"),
        );
        return Err(misfit(format!("{name} is not a type of elements"), help));
    };
    let is_line = own.is_beam() || own.is_space_beam();
    if fits(&own) && *beam == is_line {
        return Ok(own);
    }
    if !*beam && own.cell.dimension == dimension {
        // triangles among quadrilaterals
        let family = if dimension == 3 { "C3D" } else { name.get(..3).unwrap_or(name) };
        if let Some(kind) = element_type(&format!("{family}{nodes}")).filter(fits) {
            return Ok(kind);
        }
    }
    let what = ["points", "lines", "areas", "volumes"][dimension.min(3)];
    let message = format!("the group {set} has {what} of {nodes} nodes, which {name} has not");
    let help = match (beam, dimension, nodes) {
        (true, 1, 2) => "Lines of two nodes are B21, B23 or B31.",
        (true, 1, 3) => {
            "Lines of three nodes are B22 or B32; lines of two nodes come with Mesh.ElementOrder = 1."
        }
        (true, ..) => "Beams are made of lines: give a physical group of curves.",
        _ => "Ask for elements of that shape by --solid, or leave the group out.",
    };
    Err(misfit(message, help))
}
