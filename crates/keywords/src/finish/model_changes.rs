//! `*MODEL CHANGE`: which elements and contact pairs are absent in every step.
//!
//! ```text
//!   step 1  REMOVE B      A .        absent: B
//!   step 2                A .                B
//!   step 3  ADD B         A B                -      begun: B
//! ```

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{ContactPair, ElementIndex, Load, NodeIndex, Presence};

use super::bodies::Bodies;
use super::unmoved::unmoved_nodes;
use crate::changes::{Act, Changed, ModelChange};
use crate::draft::{Draft, ElementKind, StepDraft};
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::Named;

/// What is absent, and where that was said.
#[derive(Default)]
pub(super) struct Absent {
    /// Elements by their place among all that the deck defines.
    elements: BTreeMap<usize, Span>,
    /// Contact pairs by their place in the model.
    pairs: BTreeMap<usize, Span>,
    /// Pairs of general contact, one side of which is of absent elements.
    general: BTreeSet<usize>,
    /// The card that changed the model last.
    origin: Option<Span>,
    /// Where elements stand in the model, when it is first asked for.
    places: HashMap<u64, ElementIndex>,
}

/// What the cards of one step have changed so far.
#[derive(Default)]
struct Now {
    elements: HashMap<usize, Span>,
    pairs: HashMap<usize, Span>,
    begun: BTreeSet<usize>,
}

impl Absent {
    /// How much a further step copies.
    pub fn size(&self) -> usize {
        self.elements.len() + self.pairs.len()
    }

    /// Whether an element is absent, by its place among all that the deck defines.
    pub fn contains(&self, element: usize) -> bool {
        self.elements.contains_key(&element)
    }

    /// Follows the cards of a step; what is there in it.
    pub fn change(&mut self, step: &StepDraft, draft: &mut Draft) -> Presence {
        let mut now = Now::default();
        for card in &step.changes {
            self.origin = Some(card.origin);
            self.follow(card, &mut now, draft);
        }
        let mut presence = self.presence(&now, draft);
        if !step.changes.is_empty() {
            self.without_ground(&mut presence, draft);
        }
        presence
    }

    fn follow(&mut self, card: &ModelChange, now: &mut Now, draft: &mut Draft) {
        match &card.of {
            Changed::Elements(named) => {
                for (target, span) in named {
                    let (own, contact) = elements(target, *span, draft);
                    own.into_iter()
                        .for_each(|own| self.element(own, (card.act, *span), now, draft));
                    let pairs = pairs_of(contact, *span, draft);
                    pairs.into_iter().for_each(|own| self.pair(own, (card.act, *span), now, draft));
                }
            }
            Changed::Pairs(named) => {
                for (surfaces, span) in named {
                    for own in pairs_of_surfaces(surfaces, *span, draft) {
                        self.pair(own, (card.act, *span), now, draft);
                    }
                }
            }
        }
    }

    fn element(&mut self, own: usize, (act, span): (Act, Span), now: &mut Now, draft: &mut Draft) {
        let label = draft.elements[own].label;
        let first = now.elements.insert(own, span);
        let was = self.elements.get(&own).copied();
        if !fits(&format!("element {label}"), (act, span), (first, was), draft) {
            return;
        }
        match act {
            Act::Remove => {
                self.elements.insert(own, span);
            }
            Act::Begin | Act::Return => {
                self.elements.remove(&own);
                if act == Act::Begin {
                    now.begun.insert(own);
                }
            }
        }
    }

    fn pair(&mut self, own: usize, (act, span): (Act, Span), now: &mut Now, draft: &mut Draft) {
        let name = draft.model.contact_pairs[own].name.clone();
        let first = now.pairs.insert(own, span);
        let was = self.pairs.get(&own).copied();
        if !fits(&format!("the contact pair {name}"), (act, span), (first, was), draft) {
            return;
        }
        match act {
            Act::Remove => self.pairs.insert(own, span),
            Act::Begin | Act::Return => self.pairs.remove(&own),
        };
    }

    /// The same in the indices of the model; elements without mechanics of their own are none.
    fn presence(&mut self, now: &Now, draft: &Draft) -> Presence {
        if self.places.is_empty() && !(self.elements.is_empty() && now.begun.is_empty()) {
            self.places = places(draft);
        }
        let index = |own: &usize| self.places.get(&draft.elements[*own].label).copied();
        let mut absent: Vec<ElementIndex> = self.elements.keys().filter_map(index).collect();
        let mut begun: Vec<ElementIndex> = now.begun.iter().filter_map(index).collect();
        absent.sort_unstable();
        begun.sort_unstable();
        let pairs: BTreeSet<usize> = self.pairs.keys().chain(&self.general).copied().collect();
        let absent_pairs = pairs.into_iter().collect();
        Presence { absent, begun, absent_pairs, origin: self.origin }
    }

    /// Pairs of general contact leave and come with the elements of either side. SL0382: other
    /// contact of nodes whose elements are all absent.
    fn without_ground(&mut self, presence: &mut Presence, draft: &mut Draft) {
        self.general.clear();
        let mut bare = HashSet::new();
        if !self.elements.is_empty() {
            bare = bare_nodes(presence, draft);
            bare.extend(self.bare_bodies(draft));
        }
        let pairs: Vec<ContactPair> = draft.model.contact_pairs.clone();
        for (place, pair) in pairs.iter().enumerate() {
            let is_general = draft.general_made == Some(pair.origin);
            if is_general && has_lost_a_side(pair, &bare) {
                self.general.insert(place);
            } else if !self.pairs.contains_key(&place) {
                self.judge_ground((place, pair), &bare, draft);
            }
        }
        let absent: BTreeSet<usize> = self.pairs.keys().chain(&self.general).copied().collect();
        presence.absent_pairs = absent.into_iter().collect();
    }

    /// SL0382, once a card.
    fn judge_ground(
        &self,
        (place, pair): (usize, &ContactPair),
        bare: &HashSet<NodeIndex>,
        draft: &mut Draft,
    ) {
        let mut nodes = pair.slave_places().chain(pair.master.deforming_nodes());
        let Some(node) = nodes.find(|node| bare.contains(node)) else { return };
        let Some(origin) = self.origin else { return };
        let node = draft.model.nodes.label(node);
        let message = format!(
            "the contact pair {} acts on node {node}, all of whose elements are absent",
            pair.name
        );
        let help = match draft.general_made == Some(pair.origin) {
            true => {
                "general contact leaves with the elements of a whole part or of all that it has of a \
                 part: keep what leaves out of it by *CONTACT EXCLUSIONS, give that a *CONTACT PAIR \
                 of its own with what it meets, and remove this pair too: *MODEL CHANGE, \
                 TYPE=CONTACT PAIR, REMOVE"
            }
            false => {
                "remove the pair as well: *MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE; where only a \
                 part of a surface is removed, make it a surface and a pair of its own"
            }
        };
        let error = Diagnostic::error(Code("SL0382"), message).at(origin);
        let error = error.label(pair.origin, "the pair").help(help);
        if draft.log.first_time(&format!("bare pair {place} {}", origin.start)) {
            draft.consequence(Subject::Contact, error);
        }
    }

    /// Nodes of absent elements that are a part of a rigid body each, and that no element has that is
    /// there: they move with the body, but nothing of it is there.
    fn bare_bodies(&self, draft: &Draft) -> HashSet<NodeIndex> {
        let bodies = Bodies::of(draft);
        let nodes = |own: usize| draft.elements[own].nodes().iter();
        let found = |own: usize| nodes(own).filter_map(|&label| draft.model.nodes.find(label));
        let is_rigid = |own: &usize| bodies.hold_all(found(*own));
        let absent = self.elements.keys().copied();
        let mut bare: HashSet<NodeIndex> = absent.filter(is_rigid).flat_map(found).collect();
        if !bare.is_empty() {
            // contact, masses and what names a node are no parts of a body
            let there = (0..draft.elements.len())
                .filter(|own| !self.contains(*own) && is_part(draft.elements[*own].kind));
            there.flat_map(found).for_each(|node| _ = bare.remove(&node));
        }
        bare
    }

    /// SL0383: loads on nodes whose elements are all absent.
    pub fn loads(&self, presence: &Presence, loads: &[Load], draft: &mut Draft) {
        if presence.absent.is_empty() || loads.is_empty() {
            return;
        }
        let bare = unmoved_nodes(presence, &draft.model);
        for load in loads.iter().filter(|own| own.value != 0.0 && bare.contains(&own.node)) {
            let node = draft.model.nodes.label(load.node);
            let message = format!(
                "the load on node {node} moves nothing: all elements that it could move are absent"
            );
            let said = Diagnostic::warning(Code("SL0383"), message).at(load.origin);
            let said = match self.origin {
                Some(origin) => said.label(origin, "removed here"),
                None => said,
            };
            let help = "take it off in the step of the removal: *CLOAD, OP=NEW, or give it the \
                        value zero";
            draft.consequence(Subject::Steps, said.help(help));
        }
    }
}

/// Whether what is named can leave or come; complains where it has been changed in the same step
/// (`first`), or is where it is wanted already (`was`: it is absent).
fn fits(
    what: &str,
    (act, span): (Act, Span),
    (first, was): (Option<Span>, Option<Span>),
    draft: &mut Draft,
) -> bool {
    let (message, label, help) = match (first, was, act) {
        (Some(first), ..) => (
            format!("{what} is changed twice in one step"),
            Some((first, "first here")),
            "name it once; to let an element begin anew, remove it in one step and add it in the \
             next",
        ),
        (None, Some(before), Act::Remove) => (
            format!("{what} is absent already"),
            Some((before, "removed here")),
            "name it once; what was removed stays absent until it is added",
        ),
        (None, None, Act::Begin | Act::Return) => (
            format!("{what} is there already"),
            None,
            "only what an earlier step has removed can be added; to add it later on, remove it in \
             the first step",
        ),
        _ => return true,
    };
    let error = Diagnostic::error(Code("SL0381"), message).at(span);
    let error = match label {
        Some((at, text)) => error.label(at, text),
        None => error,
    };
    draft.consequence(Subject::Steps, error.help(help));
    false
}

/// The elements that a target names, those of contact apart by their numbers.
fn elements(target: &Target, span: Span, draft: &mut Draft) -> (Vec<usize>, Vec<u64>) {
    let found = draft.elements_at(target, span);
    let kind = |own: &usize| draft.elements[*own].kind;
    let contact = found.iter().filter(|own| kind(own).is_contact());
    let contact = contact.map(|own| draft.elements[*own].label).collect();
    let own = found.into_iter().filter(|own| is_part(kind(own)));
    (own.collect(), contact)
}

/// Whether an element is a part of the model that can be there or not.
fn is_part(kind: ElementKind) -> bool {
    matches!(kind, ElementKind::Structural(_) | ElementKind::Bare(_))
}

/// The contact pairs of contact elements; complains where only some elements of a pair are named.
fn pairs_of(labels: Vec<u64>, span: Span, draft: &mut Draft) -> Vec<usize> {
    let labels: HashSet<u64> = labels.into_iter().collect();
    let mut found = Vec::new();
    let mut parted = None;
    for (place, pair) in draft.model.contact_pairs.iter().enumerate() {
        let named = pair.elements.iter().filter(|own| labels.contains(&own.label)).count();
        match named {
            0 => {}
            _ if named == pair.elements.len() => found.push(place),
            _ => parted = Some((pair.name.clone(), pair.origin)),
        }
    }
    if let Some((name, origin)) = parted {
        let message = format!("only a part of the contact elements of {name} is named");
        let error = Diagnostic::error(Code("SL0381"), message).at(span);
        let error = error.label(origin, "the pair");
        let help = "contact leaves and comes pair by pair: give the part an *INTERFACE of its own";
        draft.consequence(Subject::Contact, error.help(help));
    }
    found
}

/// The contact pair of two surfaces, or those of the pieces of the master; complains where there is none.
fn pairs_of_surfaces([slave, master]: &[Named; 2], span: Span, draft: &mut Draft) -> Vec<usize> {
    let pairs = &draft.model.contact_pairs;
    let places = |slave: &str, master: &str| -> Vec<usize> {
        // a surface that meets itself has its name alone
        let meets_itself = slave == master;
        let name = if meets_itself { slave.to_owned() } else { format!("{slave}/{master}") };
        let own = pairs.iter().enumerate().filter(|(_, pair)| pair.is_called(&name));
        own.map(|(place, _)| place).collect()
    };
    let found = places(&slave.name, &master.name);
    if !found.is_empty() {
        return found;
    }
    let message = format!("there is no contact pair of {} and {}", slave.name, master.name);
    let error = Diagnostic::error(Code("SL0381"), message).at(span);
    let help = match places(&master.name, &slave.name).is_empty() {
        false => format!("the slave comes first: {}, {}", master.name, slave.name),
        true => {
            let names: Vec<String> = pairs.iter().map(|own| own.name.replace('/', ", ")).collect();
            match names.is_empty() {
                true => "the deck has no *CONTACT PAIR".to_owned(),
                false => format!("pairs of the deck: {}", names.join("; ")),
            }
        }
    };
    draft.consequence(Subject::Contact, error.help(help));
    Vec::new()
}

/// Where elements stand in the model, by their numbers.
fn places(draft: &Draft) -> HashMap<u64, ElementIndex> {
    let blocks = draft.model.blocks.iter().enumerate();
    let all = blocks.flat_map(|(block, own)| {
        let elements = own.elements.iter().enumerate();
        elements.map(move |(member, element)| (element.label, (block, member)))
    });
    all.collect()
}

/// Whether all nodes of the slave or of the master are those of absent elements.
fn has_lost_a_side(pair: &ContactPair, bare: &HashSet<NodeIndex>) -> bool {
    let mut slaves = pair.slave_places().peekable();
    let masters = pair.master.deforming_nodes();
    let slave = slaves.peek().is_some() && slaves.all(|node| bare.contains(&node));
    slave || !masters.is_empty() && masters.iter().all(|node| bare.contains(node))
}

/// Nodes of absent elements that no element has that is there, and no rigid body.
fn bare_nodes(presence: &Presence, draft: &Draft) -> HashSet<NodeIndex> {
    let model = &draft.model;
    let absent = presence.absent.iter().filter_map(|&(block, member)| {
        model.blocks.get(block).map(|own| own.elements.get(member).nodes)
    });
    let mut bare: HashSet<NodeIndex> = absent.flatten().copied().collect();
    presence.elements(&model.blocks).flat_map(|(_, element)| element.nodes).for_each(|node| {
        bare.remove(node);
    });
    model.rigid_links.iter().for_each(|link| {
        bare.remove(&link.dependent);
    });
    bare
}
