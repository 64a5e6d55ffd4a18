//! A copy of a part at its place in the assembly.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Node, SurfaceSegment};

use crate::axes::{Distribution, Given, Orientation, Transform};
use crate::constraints::{Coupling, Cut, Equation, Link, Points, PreTension, ShapeMpc, Tie};
use crate::draft::{
    Boundary, Contents, Draft, Element, Gap, Interface, PointMass, Section, Shape, Spring, Surface,
};
use crate::instances::{Placement, Target};
use crate::motion::Motion;
use crate::sets::{Item, NamedSet, Sets};
use crate::surfaces::{Extent, Named, NamedSurface, Pairing, RigidBody};

/// Something with numbers or names of a part.
pub(crate) trait Place {
    /// The same with those of the instance.
    #[must_use]
    fn placed(self, by: &Placement) -> Self;
}

impl Place for Target {
    fn placed(self, by: &Placement) -> Self {
        match self {
            Self::Label(label) => Self::Label(by.label(label)),
            Self::Set(set) => Self::Set(by.name(&set)),
        }
    }
}

impl Place for Item {
    fn placed(self, by: &Placement) -> Self {
        match self {
            Self::One(label) => Self::One(by.label(label)),
            Self::Range(first, last, step) => Self::Range(by.label(first), by.label(last), step),
            Self::Set(set) => Self::Set(by.name(&set)),
        }
    }
}

impl Place for Named {
    fn placed(self, by: &Placement) -> Self {
        Self { name: by.name(&self.name), ..self }
    }
}

impl<T: Place> Place for Option<T> {
    fn placed(self, by: &Placement) -> Self {
        self.map(|own| own.placed(by))
    }
}

impl Place for Element {
    fn placed(mut self, by: &Placement) -> Self {
        let count = self.kind.node_count() + usize::from(self.pointed_at().is_some());
        self.label = by.label(self.label);
        self.nodes[..count].iter_mut().for_each(|node| *node = by.label(*node));
        self
    }
}

impl Place for Section {
    fn placed(self, by: &Placement) -> Self {
        let orientation = self.orientation.map(|(name, span)| (by.name(&name), span));
        Self { set: by.name(&self.set), orientation, ..self }
    }
}

impl Place for Spring {
    fn placed(self, by: &Placement) -> Self {
        Self { set: by.name(&self.set), ..self }
    }
}

impl Place for Gap {
    fn placed(self, by: &Placement) -> Self {
        Self { set: by.name(&self.set), ..self }
    }
}

impl Place for PointMass {
    fn placed(self, by: &Placement) -> Self {
        Self { set: by.name(&self.set), ..self }
    }
}

impl Place for Surface {
    fn placed(mut self, by: &Placement) -> Self {
        self.set = by.name(&self.set);
        if let Shape::Line { nodes, .. } = &mut self.shape {
            nodes.iter_mut().for_each(|(label, _)| *label = by.label(*label));
        }
        self
    }
}

impl Place for Interface {
    fn placed(self, by: &Placement) -> Self {
        Self { set: by.name(&self.set), ..self }
    }
}

impl Place for NamedSurface {
    fn placed(mut self, by: &Placement) -> Self {
        self.named = self.named.placed(by);
        match &mut self.extent {
            Extent::Elements(stretches) => {
                for stretch in stretches {
                    stretch.elements = stretch.elements.clone().placed(by);
                }
            }
            Extent::Nodes(targets) => {
                targets.iter_mut().for_each(|(target, _)| *target = target.clone().placed(by));
            }
            Extent::Rigid { .. } | Extent::Swept { .. } => {}
        }
        self
    }
}

impl Place for Pairing {
    fn placed(mut self, by: &Placement) -> Self {
        (self.slave, self.master) = (self.slave.placed(by), self.master.placed(by));
        self
    }
}

impl Place for RigidBody {
    fn placed(mut self, by: &Placement) -> Self {
        self.reference = self.reference.placed(by);
        self.tied = self.tied.placed(by);
        self.pinned = self.pinned.placed(by);
        self.turn = self.turn.map(|(target, span)| (target.placed(by), span));
        self.elements = self.elements.placed(by);
        self.surface = self.surface.placed(by);
        self
    }
}

impl Place for Link {
    fn placed(mut self, by: &Placement) -> Self {
        (self.dependent, self.master) = (self.dependent.placed(by), self.master.placed(by));
        self
    }
}

impl Place for Equation {
    fn placed(mut self, by: &Placement) -> Self {
        self.terms.iter_mut().for_each(|term| term.node = term.node.clone().placed(by));
        self
    }
}

impl Place for Points {
    fn placed(self, by: &Placement) -> Self {
        match self {
            Self::Nodes { target, span, weight } => {
                Self::Nodes { target: target.placed(by), span, weight }
            }
            Self::Surface(named) => Self::Surface(named.placed(by)),
        }
    }
}

impl Place for PreTension {
    fn placed(self, by: &Placement) -> Self {
        let cut = match self.cut {
            Cut::Surface(named) => Cut::Surface(named.placed(by)),
            Cut::Element(label, span) => Cut::Element(by.label(label), span),
        };
        Self { cut, reference: self.reference.placed(by), ..self }
    }
}

impl Place for ShapeMpc {
    fn placed(mut self, by: &Placement) -> Self {
        self.nodes.iter_mut().for_each(|(target, _)| *target = target.clone().placed(by));
        self
    }
}

impl Place for Boundary {
    fn placed(self, by: &Placement) -> Self {
        Self { target: self.target.placed(by), ..self }
    }
}

impl Place for Tie {
    fn placed(mut self, by: &Placement) -> Self {
        (self.slave, self.master) = (self.slave.placed(by), self.master.placed(by));
        self
    }
}

impl Place for Transform {
    fn placed(self, by: &Placement) -> Self {
        Self { set: by.name(&self.set), ..self }
    }
}

impl Place for Orientation {
    fn placed(mut self, by: &Placement) -> Self {
        self.name = by.name(&self.name);
        match &mut self.given {
            Given::Nodes(_, labels) => {
                labels.iter_mut().flatten().for_each(|label| *label = by.label(*label));
            }
            Given::Distribution(_, name) => *name = by.name(name),
            Given::System(_) | Given::Own(_) => {}
        }
        self
    }
}

impl Place for Distribution {
    fn placed(self, by: &Placement) -> Self {
        let lines = self.lines.into_iter();
        let lines = lines.map(|(target, numbers)| (target.placed(by), numbers)).collect();
        Self { name: by.name(&self.name), lines, ..self }
    }
}

impl Place for Coupling {
    fn placed(mut self, by: &Placement) -> Self {
        self.reference = self.reference.placed(by);
        self.points = self.points.into_iter().map(|points| points.placed(by)).collect();
        self
    }
}

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
        extend(&mut self.sections, own.sections, by);
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
        let moved = own.transforms.into_iter().map(|transform| Transform {
            system: transform.system.moved(|x| motion.point(x), |way| motion.direction(way)),
            ..transform
        });
        extend(&mut self.transforms, moved.collect(), by);
        let turned = own.orientations.into_iter().map(|mut orientation| {
            if let Given::System(system) = orientation.given {
                let moved = system.moved(|x| motion.point(x), |way| motion.direction(way));
                orientation.given = Given::System(moved);
            }
            orientation
        });
        extend(&mut self.orientations, turned.collect(), by);
        let distributions = own.distributions.into_iter();
        let moved = distributions.map(|own| Distribution { motion: Some(*motion), ..own });
        extend(&mut self.distributions, moved.collect(), by);
        extend(&mut self.pre_tensions, own.pre_tensions, by);
        extend(&mut self.shape_mpcs, own.shape_mpcs, by);
        extend(&mut self.initial, own.initial, by);
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
