//! Numbers and names of a part become those of an instance.

use crate::axes::{Distribution, Given, Orientation, Transform};
use crate::constraints::{
    Coupling, Cut, Embedment, Equation, Link, Points, PreTension, ShapeMpc, Tie,
};
use crate::draft::{
    Boundary, Element, Gap, Interface, Normal, PointMass, Section, Shape, Spring, Surface,
};
use crate::instances::{Placement, Target};
use crate::sets::Item;
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
        self.axes = self.axes.map(|own| own.map(|(name, span)| (by.name(&name), span)));
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

impl Place for Embedment {
    fn placed(self, by: &Placement) -> Self {
        let embedded =
            self.embedded.into_iter().map(|(own, span)| (own.placed(by), span)).collect();
        Self { hosts: self.hosts.placed(by), embedded, ..self }
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
        self.axes = self.axes.map(|(name, span)| (by.name(&name), span));
        self
    }
}

impl Place for Normal {
    fn placed(self, by: &Placement) -> Self {
        Self { elements: self.elements.placed(by), nodes: self.nodes.placed(by), ..self }
    }
}
