//! What a run leaves: histories of every increment, fields of the states that are kept.

use slideline::model::{Dof, NodeIndex};
use slideline::observe::{BlockResults, Frame, StepReport};
use slideline::output::{contact_columns, energy_columns, history_columns};
use slideline::{Event, Model};
use slideline_results::{ContactComponent, NodeComponent, NodeField};

/// Of which states fields are kept.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Keep {
    /// Of the start and every converged increment.
    All,
    /// Of the last one.
    Last,
}

/// The histories of a node: a column each of its motions and reactions.
pub(crate) struct NodeHistory {
    pub node: NodeIndex,
    pub label: u64,
    pub columns: Vec<Vec<f64>>,
}

/// Rows of contact points that are or were closed.
#[derive(Default)]
pub(crate) struct ContactRows {
    /// Place of the state in the times, name of the pair, label of the node.
    pub states: Vec<usize>,
    pub pairs: Vec<String>,
    pub nodes: Vec<i64>,
    pub statuses: Vec<&'static str>,
    pub frictions: Vec<&'static str>,
    /// Columns of numbers, and how many of them stand before the word on friction.
    pub names: Vec<&'static str>,
    pub before: usize,
    pub values: Vec<Vec<f64>>,
}

/// What a run leaves.
pub(crate) struct Recording {
    keep: Keep,
    pub dofs: Vec<Dof>,
    pub nodes: usize,
    /// Step, increment and total time [T] of the start and of every converged increment.
    pub steps: Vec<i64>,
    pub increments: Vec<i64>,
    pub times: Vec<f64>,
    /// Places in the times of the states whose fields are kept.
    pub frames: Vec<i64>,
    /// Motions [L or 1] and reactions [F or F L], state by state, node by node, dof by dof.
    pub motions: Vec<f64>,
    pub reactions: Vec<f64>,
    /// Results of elements, state by state.
    pub elements: Vec<Vec<BlockResults>>,
    pub components: Vec<NodeComponent>,
    pub histories: Vec<NodeHistory>,
    pub contact: ContactRows,
    contact_components: Vec<&'static ContactComponent>,
    energies: Vec<slideline::output::EnergyColumn>,
    pub energy_names: Vec<&'static str>,
    pub energy: Vec<Vec<f64>>,
}

impl Recording {
    pub fn new(keep: Keep) -> Self {
        Self {
            keep,
            dofs: Vec::new(),
            nodes: 0,
            steps: Vec::new(),
            increments: Vec::new(),
            times: Vec::new(),
            frames: Vec::new(),
            motions: Vec::new(),
            reactions: Vec::new(),
            elements: Vec::new(),
            components: Vec::new(),
            histories: Vec::new(),
            contact: ContactRows::default(),
            contact_components: Vec::new(),
            energies: Vec::new(),
            energy_names: Vec::new(),
            energy: Vec::new(),
        }
    }

    /// Takes note of an event.
    pub fn take(&mut self, event: &Event<'_>) {
        match event {
            Event::StepBegin(report) if self.times.is_empty() => {
                self.begin(report);
                self.state(&report.start);
            }
            Event::Committed(frame) => self.state(frame),
            _ => {}
        }
    }

    fn begin(&mut self, report: &StepReport<'_>) {
        let model: &Model = report.model;
        self.dofs = report.start.nodal.dofs().to_vec();
        self.nodes = model.nodes.len();
        self.components = history_columns(&self.dofs);
        let history = |node: NodeIndex| NodeHistory {
            node,
            label: model.nodes.label(node),
            columns: vec![Vec::new(); self.components.len()],
        };
        self.histories = model.history_nodes().into_iter().map(history).collect();
        let [before, behind] = contact_columns(model.is_in_space());
        self.contact.before = before.len();
        self.contact_components = [before, behind].concat();
        self.contact.names = self.contact_components.iter().map(|own| own.name).collect();
        self.contact.values = vec![Vec::new(); self.contact_components.len()];
        self.energies = energy_columns(report);
        self.energy_names = self.energies.iter().map(|(name, _)| *name).collect();
        self.energy = vec![Vec::new(); self.energies.len()];
    }

    fn state(&mut self, frame: &Frame<'_>) {
        self.steps.push(number(frame.step));
        self.increments.push(number(frame.increment));
        self.times.push(frame.total_time);
        for history in &mut self.histories {
            for (column, own) in history.columns.iter_mut().zip(&self.components) {
                column.push(own.value(frame, history.node));
            }
        }
        for (values, (_, value)) in self.energy.iter_mut().zip(&self.energies) {
            values.push(value(&frame.energy));
        }
        self.contact(frame);
        self.fields(frame);
    }

    fn contact(&mut self, frame: &Frame<'_>) {
        let rows = &mut self.contact;
        for row in frame.contact.iter().filter(|row| row.ever_closed) {
            rows.states.push(self.times.len() - 1);
            rows.pairs.push(frame.model.contact_pairs[row.pair].name.clone());
            rows.nodes.push(frame.model.nodes.label(row.node).cast_signed());
            rows.statuses.push(row.status.word());
            rows.frictions.push(row.friction.word());
            for (values, own) in rows.values.iter_mut().zip(&self.contact_components) {
                values.push((own.value)(row));
            }
        }
    }

    fn fields(&mut self, frame: &Frame<'_>) {
        if self.keep == Keep::Last {
            self.frames.clear();
            self.motions.clear();
            self.reactions.clear();
            self.elements.clear();
        }
        self.frames.push(number(self.times.len() - 1));
        self.motions.extend(NodeField::Motion.table(frame, &self.dofs));
        self.reactions.extend(NodeField::Reaction.table(frame, &self.dofs));
        self.elements.push(frame.elements.to_vec());
    }
}

/// A count as NumPy has it.
pub(crate) fn number(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}
