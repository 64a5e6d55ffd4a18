//! Decks in parts become one flat model.
//!
//! ```text
//!   *PART ARM            *INSTANCE ARM-1, ARM-2            one model
//!    o--o  nodes 1, 2  ->  each: translated, turned   ->   o--o   o--o
//!    set TIP               numbers ARM-1.1, ARM-2.1        sets ARM-1.TIP, ARM-2.TIP
//! ```
//!
//! The cards of a part are read into [`Contents`] of their own, in which numbers and names are
//! those of the part. An instance places a copy of them: positions moved, numbers behind those
//! of the instances before, names behind the name of the instance. Nothing else knows of parts.

mod place;
mod renamed;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::Model;

use crate::draft::{Contents, Draft};
use crate::motion::Motion;
use crate::rule::Subject;
use crate::scopes::{Assembly, Kind, Open, Part};
pub(crate) use renamed::Place;

impl Draft {
    fn take_contents(&mut self) -> Contents {
        use std::mem::take;
        self.element_by_label.clear();
        self.node_frame = None; // those of one part are not those of another
        Contents {
            nodes: take(&mut self.model.nodes),
            node_sets: take(&mut self.node_sets),
            element_sets: take(&mut self.element_sets),
            node_sets_of_elements: take(&mut self.node_sets_of_elements),
            elements: take(&mut self.elements),
            sections: take(&mut self.sections),
            springs: take(&mut self.springs),
            gaps: take(&mut self.gaps),
            normals: take(&mut self.normals),
            masses: take(&mut self.masses),
            surfaces: take(&mut self.surfaces),
            interfaces: take(&mut self.interfaces),
            named_surfaces: take(&mut self.named_surfaces),
            pairings: take(&mut self.pairings),
            bodies: take(&mut self.bodies),
            links: take(&mut self.links),
            equations: take(&mut self.equations),
            couplings: take(&mut self.couplings),
            ties: take(&mut self.ties),
            transforms: take(&mut self.transforms),
            orientations: take(&mut self.orientations),
            distributions: take(&mut self.distributions),
            pre_tensions: take(&mut self.pre_tensions),
            shape_mpcs: take(&mut self.shape_mpcs),
            embedments: take(&mut self.embedments),
            initial: take(&mut self.initial),
        }
    }

    fn put_contents(&mut self, contents: Contents) {
        let labels = contents.elements.iter().enumerate();
        self.element_by_label = labels.map(|(at, element)| (element.label, at)).collect();
        self.model.nodes = contents.nodes;
        self.node_sets = contents.node_sets;
        self.element_sets = contents.element_sets;
        self.node_sets_of_elements = contents.node_sets_of_elements;
        self.elements = contents.elements;
        self.sections = contents.sections;
        self.springs = contents.springs;
        self.gaps = contents.gaps;
        self.normals = contents.normals;
        self.masses = contents.masses;
        self.surfaces = contents.surfaces;
        self.interfaces = contents.interfaces;
        self.named_surfaces = contents.named_surfaces;
        self.pairings = contents.pairings;
        self.bodies = contents.bodies;
        self.links = contents.links;
        self.equations = contents.equations;
        self.couplings = contents.couplings;
        self.ties = contents.ties;
        self.transforms = contents.transforms;
        self.orientations = contents.orientations;
        self.distributions = contents.distributions;
        self.pre_tensions = contents.pre_tensions;
        self.shape_mpcs = contents.shape_mpcs;
        self.embedments = contents.embedments;
        self.initial = contents.initial;
    }

    /// `*PART`.
    pub fn open_part(&mut self, name: String, name_span: Span, origin: Span) {
        self.close_forgotten("*PART", origin);
        if let Some(old) = self.parts.list.iter().find(|part| part.name == name) {
            let message = format!("the part {name} is defined twice");
            let error = Diagnostic::error(Code("SL0250"), message).at(name_span);
            self.log.push(error.label(old.origin, "defined here first"));
        }
        if self.parts.assembly != Assembly::None {
            let message = "a *PART stands before the *ASSEMBLY, not within or behind it";
            self.log.error("SL0258", message, origin);
        }
        let outer = self.take_contents();
        self.parts.open = Some(Open { kind: Kind::Part, name, outer, origin });
    }

    /// `*END PART`.
    pub fn end_part(&mut self, span: Span) {
        if !matches!(self.parts.open, Some(Open { kind: Kind::Part, .. })) {
            self.log.error("SL0258", "there is no *PART to end here", span);
            return;
        }
        self.close();
    }

    /// Ends the part or instance that is being read.
    fn close(&mut self) {
        let Some(open) = self.parts.open.take() else { return };
        let contents = self.take_contents();
        self.put_contents(open.outer);
        match open.kind {
            Kind::Part => {
                let Open { name, origin, .. } = open;
                self.parts.list.push(Part { name, contents, origin, instances: 0 });
            }
            Kind::Instance(motion) => {
                let Some(placement) = self.log.instances.placement(&open.name) else { return };
                self.place(contents, &placement, &motion, open.origin);
            }
        }
    }

    /// `*ASSEMBLY`.
    pub fn open_assembly(&mut self, origin: Span) {
        self.close_forgotten("*ASSEMBLY", origin);
        if self.parts.assembly != Assembly::None {
            self.log.error("SL0258", "a second *ASSEMBLY: a deck has one", origin);
        }
        self.parts.assembly = Assembly::Open(origin);
    }

    /// `*END ASSEMBLY`.
    pub fn end_assembly(&mut self, span: Span) {
        self.close_forgotten("*END ASSEMBLY", span);
        if !matches!(self.parts.assembly, Assembly::Open(_)) {
            self.log.error("SL0258", "there is no *ASSEMBLY to end here", span);
        }
        self.parts.assembly = Assembly::Closed;
    }

    /// `*INSTANCE`: what stands until `*END INSTANCE` joins the copy of the part.
    pub fn open_instance(
        &mut self,
        (name, name_span): (String, Span),
        (part, part_span): (String, Span),
        motion: Motion,
        origin: Span,
    ) {
        self.close_forgotten("*INSTANCE", origin);
        if !matches!(self.parts.assembly, Assembly::Open(_)) {
            let error = Diagnostic::error(Code("SL0258"), "*INSTANCE belongs into the *ASSEMBLY");
            let help = "put it between *ASSEMBLY, NAME=... and *END ASSEMBLY";
            self.log.push(error.at(origin).help(help));
        }
        let contents = match self.parts.list.iter_mut().find(|own| own.name == part) {
            Some(own) => {
                own.instances += 1;
                own.contents.clone()
            }
            None => {
                self.no_part(&part, part_span);
                Contents::default()
            }
        };
        if !self.log.instances.add(&name) {
            let message = format!("the instance {name} is defined twice");
            self.log.error("SL0250", message, name_span);
        }
        let outer = self.take_contents();
        self.put_contents(contents);
        self.parts.open = Some(Open { kind: Kind::Instance(motion), name, outer, origin });
    }

    fn no_part(&mut self, part: &str, span: Span) {
        let error = Diagnostic::error(Code("SL0258"), format!("there is no part {part}")).at(span);
        let names = self.parts.list.iter().map(|own| own.name.as_str());
        let help = match slideline_deck::nearest(part, names) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("define it before the *ASSEMBLY: *PART, NAME={part}"),
        };
        self.log.push(error.help(help));
        self.mark_all_incomplete();
    }

    /// `*END INSTANCE`.
    pub fn end_instance(&mut self, span: Span) {
        if !matches!(self.parts.open, Some(Open { kind: Kind::Instance(_), .. })) {
            self.log.error("SL0258", "there is no *INSTANCE to end here", span);
            return;
        }
        self.close();
    }

    /// Ends what should have been ended before `card`, and says so.
    pub fn close_forgotten(&mut self, card: &str, span: Span) {
        let Some(open) = &self.parts.open else { return };
        let kind = if matches!(open.kind, Kind::Part) { "PART" } else { "INSTANCE" };
        let message = format!("*{kind} {} has no *END {kind} before {card}", open.name);
        let error = Diagnostic::error(Code("SL0258"), message).at(span);
        self.log.push(error.label(open.origin, "opened here"));
        self.close();
    }

    /// When all cards are read: what is still open, what was never used, and the numbering.
    pub fn end_parts(&mut self) {
        if let Some(origin) = self.parts.open.as_ref().map(|open| open.origin) {
            self.close_forgotten("the end of the deck", origin);
        }
        if let Assembly::Open(origin) = self.parts.assembly {
            self.log.error("SL0258", "the *ASSEMBLY has no *END ASSEMBLY", origin);
        }
        self.model.nodes.set_numbering(self.log.instances.numbering());
        for part in std::mem::take(&mut self.parts.list) {
            if part.instances == 0 && !part.contents.nodes.is_empty() {
                let message = format!("the part {} has no *INSTANCE: it is left out", part.name);
                let warning = Diagnostic::warning(Code("SL0271"), message).at(part.origin);
                self.consequence(Subject::Nodes, warning);
            }
        }
    }
}

/// Gives the numbers of the finished model back to the parts: as they stand in the deck where
/// no two scopes use one, else behind a round number for each instance.
pub(crate) fn renumber(model: &mut Model) {
    let numbering = model.nodes.numbering().clone();
    if numbering.instances().is_empty() {
        return;
    }
    let mut largest = 0;
    let mut clash = false;
    let nodes: Vec<u64> = model.nodes.iter().map(|node| node.label).collect();
    let elements = model.blocks.iter().flat_map(|block| &block.elements);
    let elements: Vec<u64> = elements.map(|element| element.label).collect();
    for labels in [nodes, elements] {
        let mut own: Vec<u64> =
            labels.iter().map(|&label| numbering.name(label).number()).collect();
        own.sort_unstable();
        clash |= own.windows(2).any(|pair| pair[0] == pair[1]);
        largest = largest.max(own.last().copied().unwrap_or(0));
    }
    let mut stride = 10_u64;
    while stride <= largest {
        stride *= 10;
    }
    model.restride(if clash { stride } else { 0 });
}
