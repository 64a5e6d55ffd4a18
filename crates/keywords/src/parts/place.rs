//! A copy of a part at its place in the assembly.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Node, SurfaceSegment};

use super::renamed::Place;
use crate::axes::{Distribution, Given, Orientation, Transform};
use crate::draft::{Body, Contents, Draft, Gap, Normal, Section, Shape, Surface};
use crate::instances::Placement;
use crate::motion::Motion;
use crate::sets::{NamedSet, Sets};
use crate::surfaces::{Extent, NamedSurface};

fn extend<T: Place>(all: &mut Vec<T>, new: Vec<T>, by: &Placement) {
    all.extend(new.into_iter().map(|own| own.placed(by)));
}

fn join(all: &mut Sets, new: &Sets, by: &Placement) {
    for NamedSet { name, items, origin } in new.iter() {
        let set = all.open(&by.name(name), *origin);
        set.items.extend(items.iter().map(|(item, span)| (item.clone().placed(by), *span)));
    }
}

impl Draft {
    /// Adds an instance to the assembly.
    pub(super) fn place(&mut self, own: Contents, by: &Placement, motion: &Motion, origin: Span) {
        let count = (own.nodes.len() + own.elements.len()) as u128;
        if !self.reserve(count, "nodes and elements of this instance", origin) {
            self.mark_all_incomplete();
            return;
        }
        for node in own.nodes.iter() {
            let (label, position) = (by.label(node.label), motion.point(node.position));
            self.model.nodes.insert(Node { label, position, origin: node.origin });
        }
        self.check_turn(&own, by, motion, origin);
        for element in own.elements {
            let element = element.placed(by);
            self.element_by_label.insert(element.label, self.elements.len());
            self.elements.push(element);
        }
        join(&mut self.node_sets, &own.node_sets, by);
        join(&mut self.element_sets, &own.element_sets, by);
        let pairs = own.node_sets_of_elements.into_iter();
        self.node_sets_of_elements
            .extend(pairs.map(|(nodes, elements)| (by.name(&nodes), elements.placed(by))));
        let mut shapes = own.surfaces;
        let mut surfaces = own.named_surfaces;
        self.turn_surfaces(&mut shapes, &mut surfaces, by, motion);
        let directed = own.sections.into_iter().map(|section| turned(section, motion));
        extend(&mut self.sections, directed.collect(), by);
        let normals = own.normals.into_iter();
        let moved = normals.map(|own| Normal { direction: motion.direction(own.direction), ..own });
        extend(&mut self.normals, moved.collect(), by);
        extend(&mut self.springs, own.springs, by);
        let turned = own
            .gaps
            .into_iter()
            .map(|gap| Gap { direction: gap.direction.map(|way| motion.direction(way)), ..gap });
        extend(&mut self.gaps, turned.collect(), by);
        extend(&mut self.masses, own.masses, by);
        extend(&mut self.surfaces, shapes, by);
        extend(&mut self.interfaces, own.interfaces, by);
        extend(&mut self.named_surfaces, surfaces, by);
        extend(&mut self.pairings, own.pairings, by);
        extend(&mut self.bodies, own.bodies, by);
        extend(&mut self.links, own.links, by);
        extend(&mut self.equations, own.equations, by);
        extend(&mut self.couplings, own.couplings, by);
        extend(&mut self.ties, own.ties, by);
        self.place_axes((own.transforms, own.orientations, own.distributions), by, motion);
        extend(&mut self.pre_tensions, own.pre_tensions, by);
        extend(&mut self.shape_mpcs, own.shape_mpcs, by);
        extend(&mut self.embedments, own.embedments, by);
        extend(&mut self.initial, own.initial, by);
    }

    /// Adds the axes of nodes and of materials, moved with the instance.
    fn place_axes(
        &mut self,
        (transforms, orientations, distributions): (
            Vec<Transform>,
            Vec<Orientation>,
            Vec<Distribution>,
        ),
        by: &Placement,
        motion: &Motion,
    ) {
        let moved = transforms.into_iter().map(|transform| Transform {
            system: transform.system.moved(|x| motion.point(x), |way| motion.direction(way)),
            ..transform
        });
        extend(&mut self.transforms, moved.collect(), by);
        let turned = orientations.into_iter().map(|mut orientation| {
            if let Given::System(system) = orientation.given {
                let moved = system.moved(|x| motion.point(x), |way| motion.direction(way));
                orientation.given = Given::System(moved);
            }
            orientation
        });
        extend(&mut self.orientations, turned.collect(), by);
        let moved =
            distributions.into_iter().map(|own| Distribution { motion: Some(*motion), ..own });
        extend(&mut self.distributions, moved.collect(), by);
    }

    /// Moves analytical surfaces with their instance; complains about those that leave the plane.
    fn turn_surfaces(
        &mut self,
        shapes: &mut [Surface],
        surfaces: &mut [NamedSurface],
        by: &Placement,
        motion: &Motion,
    ) {
        for surface in &mut *surfaces {
            if let Extent::Swept { axes, .. } = &mut surface.extent {
                axes.origin = motion.point(axes.origin);
                axes.directions = axes.directions.map(|way| motion.direction(way));
            }
        }
        let rigid = shapes.iter_mut().filter_map(|surface| match &mut surface.shape {
            Shape::Rigid { start, segments } => Some((start, segments, surface.origin)),
            Shape::Line { .. } => None,
        });
        let named = surfaces.iter_mut().filter_map(|surface| match &mut surface.extent {
            Extent::Rigid { start, segments } => Some((start, segments, surface.origin)),
            _ => None,
        });
        for (start, segments, origin) in rigid.chain(named) {
            if turn(start, segments, motion).is_none() {
                let message = format!(
                    "the instance {} turns its analytical surface out of the plane",
                    by.prefix.trim_end_matches('.')
                );
                let error = Diagnostic::error(Code("SL0258"), message).at(origin);
                self.log.push(error.help("turn it about an axis along z"));
            }
        }
    }

    /// Remembers an instance that leaves the plane, and complains about one that turns what its
    /// part says of directions.
    fn check_turn(&mut self, own: &Contents, by: &Placement, motion: &Motion, origin: Span) {
        let name = by.prefix.trim_end_matches('.').to_owned();
        if motion.rotation.is_some()
            && let Some(&first) = (own.initial.iter().map(|line| &line.origin))
                .chain(own.equations.iter().map(|equation| &equation.origin))
                .chain(own.pre_tensions.iter().map(|section| &section.origin))
                .next()
        {
            let message = format!(
                "the instance {name} is turned, and its part speaks of directions: are they \
                 turned with it?"
            );
            let error = Diagnostic::error(Code("SL0258"), message).at(origin);
            let error = error.label(first, "the directions of the part");
            self.log.push(error.help("say it in the assembly, of the nodes of the instance"));
        }
        let places = own.nodes.iter().map(|node| motion.point(node.position));
        let (mut low, mut high, mut reach) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for place in places {
            (low, high) = (low.min(place[2]), high.max(place[2]));
            reach = place.iter().fold(reach, |reach, x| reach.max(x.abs()));
        }
        if !motion.keeps_the_plane() && high - low > 1e-9 * reach {
            self.tilted.push((name, origin));
        }
    }
}

/// A section whose axis 1 turns with its instance.
fn turned(mut section: Section, motion: &Motion) -> Section {
    if let Body::Beam { first_axis, .. } = &mut section.body {
        *first_axis = motion.direction(*first_axis);
    }
    section
}

/// Moves an analytical surface with its instance; `None` where it would leave the plane.
fn turn<const D: usize>(
    start: &mut [f64; D],
    segments: &mut [SurfaceSegment],
    motion: &Motion,
) -> Option<()> {
    if !motion.keeps_the_plane() {
        return None;
    }
    *start = moved(start, motion);
    for segment in segments {
        *segment = match *segment {
            SurfaceSegment::Line { end } => SurfaceSegment::Line { end: moved(&end, motion) },
            SurfaceSegment::Circle { end, centre } => {
                SurfaceSegment::Circle { end: moved(&end, motion), centre: moved(&centre, motion) }
            }
            SurfaceSegment::Parabola { middle, end } => SurfaceSegment::Parabola {
                middle: moved(&middle, motion),
                end: moved(&end, motion),
            },
        };
    }
    Some(())
}

/// Where a point of the part stands, by its first coordinates.
fn moved<const D: usize>(point: &[f64; D], motion: &Motion) -> [f64; D] {
    let mut place = [0.0; 3];
    place.iter_mut().zip(point).for_each(|(own, x)| *own = *x);
    let place = motion.point(place);
    std::array::from_fn(|k| place[k])
}
