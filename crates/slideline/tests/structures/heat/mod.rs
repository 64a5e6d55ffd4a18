//! Runs decks and keeps what their increments show.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof};
use slideline::observe::{Ending, Energies, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::collections::HashMap;
use std::ops::ControlFlow;

const DOFS: [Dof; 6] = Dof::ALL;

/// What the increments of a run show.
#[derive(Default)]
pub struct Watch {
    /// Displacements and rotations by node at the end.
    pub u: HashMap<u64, [f64; 6]>,
    pub reactions: HashMap<u64, [f64; 6]>,
    /// Results of all elements at the end, one after the other.
    pub elements: Vec<f64>,
    /// Temperatures of the nodes, an increment each.
    pub temperatures: Vec<Vec<f64>>,
    pub energies: Vec<Energies>,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let nodes = &frame.model.nodes;
            for node in 0..nodes.len() {
                let label = nodes.label(node);
                self.u.insert(label, DOFS.map(|dof| frame.nodal.displacement(node, dof)));
                self.reactions.insert(label, DOFS.map(|dof| frame.nodal.reaction(node, dof)));
            }
            let temperatures = (0..nodes.len()).map(|node| frame.nodal.temperature(node));
            self.temperatures.push(temperatures.collect());
            self.elements = frame.elements.iter().flat_map(|own| own.values.clone()).collect();
            self.energies.push(frame.energy);
        }
        ControlFlow::Continue(())
    }
}

pub fn run(text: &str) -> Watch {
    run_in(text, Dialect::Abaqus)
}

pub fn run_in(text: &str, dialect: Dialect) -> Watch {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("deck", text, &options);
    let Some(mut model) = read.model else { panic!("{:?}\n{text}", read.diagnostics) };
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-11;
    }
    let mut watch = Watch::default();
    let ending = solve(&model, &SolveOptions::default(), &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{text}");
    watch
}
