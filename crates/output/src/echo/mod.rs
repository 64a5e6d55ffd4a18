//! What was understood, in words: the opening of `JOB.dat` and of `check`.

mod contact;
mod elements;
mod materials;
mod steps;
mod words;

use crate::ledger::onset_word;
pub use contact::{friction_law, gap, normal_law, pair_echo};
use slideline_model::{Dof, Model, NodeIndex};
use slideline_solve::observe::{ContactRow, Frame};
use std::fmt::Write as _;
pub use words::labels;
use words::number;

/// Everything that was understood of a deck, with the state in which it
/// starts.
pub fn model_echo(model: &Model, start: &Frame<'_>) -> String {
    let mut text = String::new();
    heading(&mut text, model);
    nodes(&mut text, model);
    instances(&mut text, model);
    for block in &model.blocks {
        elements::block(&mut text, model, block);
    }
    constraints(&mut text, model);
    for (place, pair) in model.contact_pairs.iter().enumerate() {
        text.push('\n');
        text.push_str(&pair_echo(model, pair));
        let rows: Vec<&ContactRow> = start.contact.iter().filter(|row| row.pair == place).collect();
        contact::points(&mut text, model, &rows);
    }
    contact::initial_contact_energy(&mut text, model, start);
    for (place, step) in model.steps.iter().enumerate() {
        steps::step_echo(&mut text, model, place + 1, step);
    }
    text
}

fn heading(text: &mut String, model: &Model) {
    for heading in model.heading.lines() {
        line!(text, "{heading}");
    }
    line!(text, "dialect          {}", model.dialect.word());
    line!(text, "friction onset   {}", onset_word(model.friction_onset));
}

fn nodes(text: &mut String, model: &Model) {
    let linked = model.rigid_links.len();
    line!(text, "\nNODES  {}, {linked} of them on rigid links", model.nodes.len());
    for axis in 0..3 {
        let values = model.nodes.iter().map(|node| node.position[axis]);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if high > low {
            let name = ["x", "y", "z"][axis];
            line!(text, "  {name} from {} to {}", number(low), number(high));
        }
    }
}

/// Who has which numbers: in files a node of an instance has one number.
fn instances(text: &mut String, model: &Model) {
    let numbering = model.nodes.numbering();
    if numbering.instances().is_empty() {
        return;
    }
    if numbering.stride() == 0 {
        line!(text, "\nINSTANCES  all numbers are those of the deck");
        return;
    }
    line!(text, "\nINSTANCES  numbers in files of nodes and elements");
    for (name, k) in numbering.instances().iter().zip(1_u64..) {
        let offset = k * numbering.stride();
        line!(text, "  {name}.n is {offset} + n");
    }
}

/// Dofs that follow others: `*EQUATION`, `*TIE`, `*COUPLING` and the like.
fn constraints(text: &mut String, model: &Model) {
    let all = &model.linear_constraints;
    if all.is_empty() {
        return;
    }
    line!(text, "\nDEPENDENT DOFS  {}, by equations, ties and couplings", all.len());
    for own in all.iter().take(MOST_EQUATIONS) {
        let name = |node: NodeIndex, dof: Dof| format!("{}.{}", model.nodes.name(node), dof.name());
        let terms = own.terms.iter().map(|&(node, dof, factor)| {
            format!("{} {} {}", sign(factor), number(factor.abs()), name(node, dof))
        });
        let mut terms: Vec<String> = terms.collect();
        if own.constant != 0.0 || terms.is_empty() {
            terms.push(format!("{} {}", sign(own.constant), number(own.constant.abs())));
        }
        line!(text, "  {} = {}", name(own.dependent.0, own.dependent.1), terms.join(" "));
    }
    if all.len() > MOST_EQUATIONS {
        line!(text, "  and {} more", all.len() - MOST_EQUATIONS);
    }
}

/// Most equations that are told one by one.
const MOST_EQUATIONS: usize = 20;

fn sign(value: f64) -> char {
    if value < 0.0 { '-' } else { '+' }
}
