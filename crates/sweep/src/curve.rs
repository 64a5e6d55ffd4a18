//! What a response may follow over the increments: histories of nodes, of contact pairs, energies.
//!
//! ```text
//!   RF2@100            a reaction or a motion of a node, or of a set of one node
//!   force_y@CIRCLE     a column of JOB.pair.csv, or normal_force, of a contact pair
//!   released_energy    a column of JOB.energy.csv
//! ```

use slideline::Model;
use slideline::model::Dof;
use slideline::observe::Frame;
use slideline::output::{energy_named, pair_quantity};

/// A history, as a response names it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Curve {
    /// A reaction, or else a motion.
    Node {
        is_reaction: bool,
        dof: Dof,
        /// Label, or name of a set of one node.
        node: String,
    },
    /// A quantity of a contact pair.
    Pair { quantity: String, pair: String },
    /// An energy.
    Energy(String),
}

/// Where a history is taken from in the frames of one model.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Source {
    Motion(usize, Dof),
    Reaction(usize, Dof),
    Pair(usize, slideline::output::PairQuantity),
    /// Sum of pressures times areas of a pair [F].
    NormalForce(usize),
    Energy(slideline::output::EnergyOf),
}

/// The word for the sum of all pressures of a pair, as `JOB.json` has it.
const NORMAL_FORCE: &str = "normal_force";

impl Curve {
    /// The history of that name, of a node or a pair where one stands behind `@`; `None`: there is
    /// no such history.
    pub fn named(word: &str, whose: Option<&str>) -> Option<Self> {
        let owner = || whose.unwrap_or_default().to_owned();
        if let Some((dof, is_reaction)) = of_node(word) {
            return Some(Self::Node { is_reaction, dof, node: owner() });
        }
        if word == NORMAL_FORCE || pair_quantity(word).is_some() {
            return Some(Self::Pair { quantity: word.to_owned(), pair: owner() });
        }
        energy_named(word).map(|_| Self::Energy(word.to_owned()))
    }

    /// Whether a node or a pair belongs to it.
    pub fn has_owner(&self) -> bool {
        !matches!(self, Self::Energy(_))
    }

    /// Where it is taken from; `None`: the model has no such node, no set of one node, no such pair.
    pub fn source(&self, model: &Model) -> Option<Source> {
        match self {
            Self::Node { is_reaction: true, dof, node } => {
                Some(Source::Reaction(node_of(node, model)?, *dof))
            }
            Self::Node { dof, node, .. } => Some(Source::Motion(node_of(node, model)?, *dof)),
            Self::Pair { quantity, pair } => {
                let named =
                    |own: &slideline::model::ContactPair| own.name.eq_ignore_ascii_case(pair);
                let pair = model.contact_pairs.iter().position(named)?;
                Some(match pair_quantity(quantity) {
                    Some(quantity) => Source::Pair(pair, quantity),
                    None => Source::NormalForce(pair),
                })
            }
            Self::Energy(name) => energy_named(name).map(Source::Energy),
        }
    }

    /// Why a model does not have it, and what to do.
    pub fn objection(&self, model: &Model) -> [String; 2] {
        match self {
            Self::Node { node, .. } => [
                format!(
                    "a response names {node}, but the deck has no node {node} and no set {node} of \
                     one node"
                ),
                "Name a node by its label, or a node set that has one member.".to_owned(),
            ],
            Self::Pair { pair, .. } => {
                let names = model.contact_pairs.iter().map(|own| own.name.as_str());
                let names: Vec<&str> = names.collect();
                let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
                [
                    format!("a response names {pair}, but the deck has no contact pair {pair}"),
                    format!("Its contact pairs: {known}."),
                ]
            }
            Self::Energy(name) => [format!("there is no energy {name}"), String::new()],
        }
    }
}

fn of_node(word: &str) -> Option<(Dof, bool)> {
    let named = |dof: &Dof| [dof.name(), dof.reaction_name()].iter().position(|own| *own == word);
    Dof::ALL.iter().find_map(|dof| Some((*dof, named(dof)? == 1)))
}

fn node_of(name: &str, model: &Model) -> Option<usize> {
    if let Ok(label) = name.parse() {
        return model.nodes.find(label);
    }
    let set = model.node_sets.iter().find(|set| set.name.eq_ignore_ascii_case(name))?;
    match set.members[..] {
        [node] => Some(node),
        _ => None,
    }
}

impl Source {
    /// The value in a state; zero of a pair at the start of a step.
    pub fn value(self, frame: &Frame<'_>) -> f64 {
        match self {
            Self::Motion(node, dof) => frame.nodal.displacement(node, dof),
            Self::Reaction(node, dof) => frame.nodal.reaction(node, dof),
            Self::Pair(pair, quantity) => frame.pairs.get(pair).map_or(0.0, quantity),
            Self::NormalForce(pair) => {
                let own = frame.contact.iter().filter(|row| row.pair == pair);
                own.map(|row| row.pressure * row.area).sum()
            }
            Self::Energy(of) => of(&frame.energy),
        }
    }
}
