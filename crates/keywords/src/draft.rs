//! The model while it is read: objects by name, references not yet resolved.

mod cards;
mod contents;
mod elements;
mod heat;
mod owner;
mod properties;
mod sections;

use std::collections::{HashMap, HashSet};

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    Dialect, Dof, Interaction, LinearConstraint, Model, Node, NodeIndex, Numbered, NumberedSet,
    SavedStates,
};

use crate::axes::{Distribution, Orientation, Transform};
use crate::constraints::{
    Coupling, Embedment, Equation, Link, OpenMean, PreTension, ShapeMpc, Tie,
};
use crate::expression::Values;
use crate::log::{Log, MAX_LABEL};
use crate::motion::Frame;
use crate::overrides::Overrides;
use crate::rule::Subject;
use crate::scopes::Parts;
use crate::sets::Sets;
use crate::surfaces::{
    Clearance, GeneralContact, Initialization, Named, NamedInteraction, NamedSurface, Pairing,
    RigidBody, SurfaceThickness,
};
pub(crate) use cards::{
    Boundary, Gap, Interface, NodalThickness, Normal, ParameterRange, PointMass, Shape, Spring,
    StepDraft, Surface,
};
pub(crate) use contents::Contents;
pub(crate) use elements::{Element, ElementKind, MOST_NODES};
pub(crate) use heat::{HardeningLine, Heat, StressLine};
pub(crate) use owner::Owner;
pub(crate) use properties::PropertyChange;
pub(crate) use sections::{
    Allowable, Body, Card, CreepLaw, Elasticity, Kind, Material, Section, Table, Test, Wanted,
    Yielding,
};

/// Most nodes, elements and set members that a deck may generate. A slip in
/// an `*NGEN` line must not fill the memory.
pub const MAX_GENERATED: u64 = 5_000_000;

/// Most members that all uses of sets may come to, together with what steps
/// take over from one another: a large set named on every line must not fill
/// the memory either.
pub const MAX_EXPANDED: u64 = 10_000_000;

/// Everything known so far.
#[derive(Default)]
pub(crate) struct Draft {
    pub log: Log,
    pub dialect: Dialect,
    /// Filled directly: heading, nodes, amplitudes, friction onset.
    pub model: Model,
    pub node_sets: Sets,
    pub element_sets: Sets,
    /// Node sets that the nodes of an element set join.
    pub node_sets_of_elements: Vec<(String, Named)>,
    pub elements: Vec<Element>,
    /// Whether one of them moves in space.
    pub spatial: bool,
    pub element_by_label: Numbered<u64, usize>,
    pub sections: Vec<Section>,
    pub materials: Vec<Material>,
    pub allowables: Vec<Allowable>,
    /// Section of each element by its label, when it is first asked for.
    pub section_of: Numbered<u64, usize>,
    /// Mass of each MASS element by its label, when sets are resolved.
    pub mass_of: Numbered<u64, f64>,
    pub springs: Vec<Spring>,
    pub gaps: Vec<Gap>,
    pub normals: Vec<Normal>,
    /// Axis 1 of the sections of beams that have one of their own, by the place of the element.
    pub first_axes: Numbered<usize, [f64; 3]>,
    pub masses: Vec<PointMass>,
    pub surfaces: Vec<Surface>,
    pub interfaces: Vec<Interface>,
    pub named_surfaces: Vec<NamedSurface>,
    pub interactions: Vec<NamedInteraction>,
    pub pairings: Vec<Pairing>,
    /// `*SURFACE PROPERTY ASSIGNMENT`.
    pub surface_thicknesses: Vec<SurfaceThickness>,
    /// `*CONTACT`.
    pub general: Option<GeneralContact>,
    /// The card of the general contact whose pairs have been made.
    pub general_made: Option<Span>,
    /// `*CONTACT INITIALIZATION DATA`.
    pub initializations: Vec<Initialization>,
    /// `*CLEARANCE`.
    pub clearances: Vec<Clearance>,
    /// Contact pairs of the model by the name of their surface interaction.
    pub pairs_of_interaction: HashMap<String, Vec<usize>>,
    pub bodies: Vec<RigidBody>,
    pub links: Vec<Link>,
    pub equations: Vec<Equation>,
    pub couplings: Vec<Coupling>,
    pub ties: Vec<Tie>,
    pub transforms: Vec<Transform>,
    pub orientations: Vec<Orientation>,
    pub distributions: Vec<Distribution>,
    /// Names of `*DISTRIBUTION TABLE`s of axes.
    pub distribution_tables: Vec<String>,
    /// Axes of the nodes that have their own, when all cards are read.
    pub axes: Numbered<NodeIndex, slideline_model::Axes>,
    pub pre_tensions: Vec<PreTension>,
    /// The nodes that cuts by pre-tension sections have added, and those that they stand for.
    pub cut_nodes: Numbered<u64, u64>,
    /// Those that pre-tension sections have added for a node.
    pub behind_cuts: Numbered<u64, Vec<u64>>,
    /// What nodes follow that stand in for others in `*SPRING`.
    pub crossed_springs: Vec<LinearConstraint>,
    pub shape_mpcs: Vec<ShapeMpc>,
    pub embedments: Vec<Embedment>,
    /// Dofs that follow others, and where it was said; known when links are resolved.
    pub dependents: Numbered<(NodeIndex, Dof), Span>,
    /// Clouds that may turn far, until it is known what follows what.
    pub means: Vec<OpenMean>,
    /// Ends of masters in pieces that are taken for one, and the complaint where they are not.
    pub joined_ends: Vec<([NodeIndex; 2], Diagnostic)>,
    /// Dofs of tied nodes that supports hold as they hold what they would follow, which is one node.
    pub held_alike: Numbered<(NodeIndex, Dof), NodeIndex>,
    /// Dofs that follow others which are held alike: their own supports say nothing new.
    pub implied: NumberedSet<(NodeIndex, Dof)>,
    pub parts: Parts<Contents>,
    /// `*SYSTEM`: the axes in which coordinates of nodes are given.
    pub node_frame: Option<Frame>,
    /// Instances that leave the plane of x and y, and their cards.
    pub tilted: Vec<(String, Span)>,
    /// A card that adds mass, which weighs nothing here.
    pub added_mass: Option<Span>,
    /// Whether some step has nonlinear kinematics; known from when steps are finished.
    pub large: bool,
    pub restart: Option<SavedStates>,
    /// Whether the cards are those of a deck that goes on from an earlier job.
    pub goes_on: bool,
    /// Steps of the jobs it goes on from.
    pub earlier_steps: usize,
    /// Boundary conditions before the first step.
    pub initial: Vec<Boundary>,
    /// Amplitudes in place of the numbers of loads and motions: `VALUE=ABSOLUTE`.
    pub absolute_amplitudes: HashSet<String>,
    /// Thickness at nodes.
    pub thicknesses: Vec<NodalThickness>,
    /// Temperatures before the first step.
    pub initial_temperatures: Vec<Heat>,
    /// Stresses before the first step.
    pub initial_stresses: Vec<StressLine>,
    /// Plastic strains before the first step.
    pub initial_hardening: Vec<HardeningLine>,
    /// Values of names.
    pub parameters: Values,
    /// Between which numbers the values of names must lie.
    pub ranges: HashMap<String, ParameterRange>,
    /// Names whose values are numbers that follow from no other.
    pub numbers: Vec<(String, f64)>,
    /// Values from outside the deck, for names that it defines.
    pub overrides: Overrides,
    pub steps: Vec<StepDraft>,
    pub in_step: bool,
    pub owner: Owner,
    generated: u64,
    expanded: u64,
    incomplete: Vec<Subject>,
}

impl Draft {
    /// Nothing read yet.
    pub fn new(dialect: Dialect) -> Self {
        let model = Model { dialect, ..Model::default() };
        Self { dialect, model, ..Self::default() }
    }

    /// The node of the deck that a node stands for: both sides of a cut by a pre-tension section
    /// are one part, and the cut is no outside.
    pub fn uncut(&self, node: u64) -> u64 {
        self.cut_nodes.get(&node).copied().unwrap_or(node)
    }

    /// The step that is open.
    pub fn step(&mut self) -> Option<&mut StepDraft> {
        if self.in_step { self.steps.last_mut() } else { None }
    }

    /// Remembers that cards of a subject could not all be read.
    pub fn mark_incomplete(&mut self, subject: Subject) {
        if !self.incomplete.contains(&subject) {
            self.incomplete.push(subject);
        }
    }

    /// Nothing can be trusted to be complete any more.
    pub fn mark_all_incomplete(&mut self) {
        use Subject::{Amplitudes, Contact, Elements, Links, Nodes, Properties, Sections, Steps};
        for subject in [Nodes, Elements, Sections, Properties, Contact, Links, Amplitudes, Steps] {
            self.mark_incomplete(subject);
        }
    }

    pub fn is_complete(&self, subject: Subject) -> bool {
        let rests_on = (subject == Subject::Properties).then_some(Subject::Sections);
        !rests_on.into_iter().chain([subject]).any(|own| self.incomplete.contains(&own))
    }

    /// Whether `count` more things may be generated; complains if not.
    pub fn reserve(&mut self, count: u128, what: &str, span: Span) -> bool {
        let total = u128::from(self.generated) + count;
        if total > u128::from(MAX_GENERATED) {
            let message = format!("{count} {what} are too many to generate");
            let error = Diagnostic::error(Code("SL0227"), message).at(span);
            let limit = format!("a deck may generate {MAX_GENERATED} nodes, elements and members");
            self.log.push(error.help(format!("{limit}; check the last number and the increment")));
            return false;
        }
        self.generated = u64::try_from(total).unwrap_or(u64::MAX);
        true
    }

    /// Counts members of sets that are used; complains once where they are
    /// too many, and from then on nothing more is used.
    pub fn expand(&mut self, count: usize, span: Span) -> bool {
        let before = self.expanded;
        self.expanded = before.saturating_add(count as u64);
        let fits = self.expanded <= MAX_EXPANDED;
        if !fits && before <= MAX_EXPANDED {
            let message = format!("with this, sets are used for more than {MAX_EXPANDED} members");
            let error = Diagnostic::error(Code("SL0227"), message).at(span);
            self.log.push(error.help("name a large set on fewer lines, or in fewer steps"));
        }
        fits
    }

    /// Whether no set is used any more.
    pub fn has_expanded_all(&self) -> bool {
        self.expanded > MAX_EXPANDED
    }

    /// Takes a node in. One that exists already must stand where it stood.
    pub fn add_node(&mut self, label: u64, position: [f64; 3], origin: Span, generated: bool) {
        let Some(index) = self.model.nodes.find(label) else {
            self.model.nodes.insert(Node { label, position, origin });
            return;
        };
        let old = *self.model.nodes.get(index);
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * a.abs().max(b.abs());
        if old.position.iter().zip(position).all(|(&a, b)| near(a, b)) {
            if !generated {
                self.log.note(
                    "SL0222",
                    format!("node {label} is defined again, unchanged"),
                    origin,
                );
            }
        } else if self.log.first_time(&format!("node {} {}", origin.file.0, origin.start)) {
            let message = format!("node {label} is defined again with other coordinates");
            let error = Diagnostic::error(Code("SL0223"), message).at(origin);
            self.log.push_harmless(error.label(old.origin, "defined here first"));
        }
    }

    /// Takes an element in; its number must be new.
    pub fn add_element(&mut self, element: Element) {
        if let Some(&old) = self.element_by_label.get(&element.label) {
            let origin = element.origin;
            if self.log.first_time(&format!("element {} {}", origin.file.0, origin.start)) {
                let message = format!("element {} is defined twice", element.label);
                let error = Diagnostic::error(Code("SL0229"), message).at(origin);
                self.log.push(error.label(self.elements[old].origin, "defined here first"));
            }
            return;
        }
        self.element_by_label.insert(element.label, self.elements.len());
        self.elements.push(element);
    }

    /// Notes that the deck has elements of a kind, sound or not.
    pub fn note_spatial(&mut self, kind: ElementKind) {
        self.spatial |= kind.is_spatial();
    }

    /// Whether the model moves in space, not in a plane alone.
    pub fn is_spatial(&self) -> bool {
        self.spatial
    }

    /// The interaction of the `*INTERFACE` or `*SURFACE INTERACTION` that a
    /// `*FRICTION` or `*SURFACE CONTACT` belongs to, with the name of that
    /// card; complains once where there is none.
    pub fn owning_interaction(
        &mut self,
        keyword: &str,
        span: Span,
    ) -> Option<(&mut Interaction, &'static str)> {
        match self.owner {
            Owner::Interface(index) => {
                let interface = self.interfaces.get_mut(index)?;
                return Some((&mut interface.interaction, "*INTERFACE"));
            }
            Owner::Interaction(index) => {
                let named = self.interactions.get_mut(index)?;
                return Some((&mut named.interaction, "*SURFACE INTERACTION"));
            }
            Owner::FrictionChange if keyword == "FRICTION" => {
                let change = self.steps.last_mut()?.frictions.last_mut()?;
                return Some((&mut change.interaction, "*CHANGE FRICTION"));
            }
            Owner::PressureChange if keyword == "SURFACE BEHAVIOR" => {
                let change = self.steps.last_mut()?.pressures.last_mut()?;
                return Some((&mut change.interaction, "*CHANGE SURFACE BEHAVIOR"));
            }
            Owner::Broken => return None,
            _ => {}
        }
        let (code, message, help) = self.owner.without_interaction(keyword);
        self.log.push(Diagnostic::error(Code(code), message).at(span).help(help));
        self.owner = Owner::Broken;
        self.mark_incomplete(Subject::Contact);
        None
    }

    /// The material that a card belongs to; complains once where there is none.
    pub fn owning_material(&mut self, keyword: &str, span: Span) -> Option<&mut Material> {
        let Owner::Material(index) = self.owner else {
            self.orphan(keyword, "MATERIAL", span);
            self.mark_incomplete(Subject::Sections); // one without its card
            return None;
        };
        self.materials.get_mut(index)
    }

    /// Gives the open material a property, which it must not have yet.
    pub fn give_material<T>(
        &mut self,
        (keyword, span): Card,
        property: fn(&mut Material) -> &mut Option<(T, Card)>,
        value: T,
    ) {
        let Some(material) = self.owning_material(keyword, span) else { return };
        let place = property(material);
        let Some((first, at)) = place.as_ref().map(|own| own.1) else {
            *place = Some((value, (keyword, span)));
            return;
        };
        let message = match first == keyword {
            true => format!("a second *{keyword} of the material {}", material.name),
            false => format!("*{keyword} and *{first} of the material {}", material.name),
        };
        let error = Diagnostic::error(Code("SL0242"), message).at(span);
        let error = error.label(at, "the first one");
        self.log.push(error.help("a material has one of them: leave the other out"));
    }

    /// Complains that a suboption stands alone.
    pub fn orphan(&mut self, keyword: &str, owner: &str, span: Span) {
        if self.owner == Owner::Broken {
            return;
        }
        let message = format!("*{keyword} has no *{owner} to belong to");
        let error = Diagnostic::error(Code("SL0236"), message).at(span);
        self.log.push(error.help(format!("put it directly behind its *{owner} card")));
        self.owner = Owner::Broken;
    }

    /// A number so many steps further; complains where no node or element may have it.
    pub fn further(&mut self, label: u64, step: u64, times: u64, span: Span) -> Option<u64> {
        let most = MAX_LABEL.unsigned_abs();
        let moved = step.checked_mul(times).and_then(|by| label.checked_add(by));
        let found = moved.filter(|&label| label <= most);
        if found.is_none() && self.log.first_time(&format!("further {}", span.start)) {
            let message = format!("numbers run beyond the largest one, {most}");
            self.log.error("SL0224", message, span);
        }
        found
    }

    /// The dofs from the one at a place of a line to the one behind it, which defaults to the first.
    pub fn dof_range(
        &mut self,
        line: &DataLine,
        at: usize,
    ) -> Option<std::ops::RangeInclusive<Dof>> {
        if line.field(at).is_none() {
            let span = line.fields.get(at).map_or(line.end(), |field| field.span);
            self.log.error("SL0119", "the degree of freedom is missing", span);
            return None;
        }
        let first = self.log.integer_or(line, at, 1)?;
        let last = self.log.integer_or(line, at + 1, first)?;
        let dofs = self.dof(first, line, at)?..=self.dof(last, line, at + 1)?;
        if dofs.is_empty() {
            let message = format!("the first dof, {first}, comes after the last, {last}");
            let span = line.fields[at].span.to(line.fields[at + 1].span);
            self.log.error("SL0248", message, span);
            return None;
        }
        Some(dofs)
    }

    /// A degree of freedom given by its number.
    pub fn dof(&mut self, number: i64, line: &DataLine, at: usize) -> Option<Dof> {
        let dof = Dof::from_number(number);
        if dof.is_none() {
            let span = line.fields.get(at).map_or(line.span, |field| field.span);
            let message = format!("{number} is not a degree of freedom: 1 to 6");
            self.log.error("SL0248", message, span);
        }
        dof
    }
}
