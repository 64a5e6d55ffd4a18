//! Requests for output: they stand until a step makes others.
//!
//! ```text
//!   step 1   *NODE PRINT A      .dat: A
//!   step 2                      .dat: A
//!   step 3   *NODE PRINT B      .dat: B        of a kind and a file, the new ones alone
//! ```

use super::section_prints::with_faces;
use super::tied_pairs::{across_ties, wants_tied};
use crate::draft::{Draft, StepDraft};
use crate::rule::Subject;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{ContactPrint, NodeIndex, OutputRequests, PrintTarget, Request};
use std::collections::HashSet;

/// What a further step copies.
pub(super) fn size(standing: &OutputRequests) -> usize {
    let nodes = standing.node_prints.iter().map(|print| print.nodes.len());
    let elements = standing.element_prints.iter().map(|print| print.elements.len());
    let points = standing.contact_prints.iter().map(|print| print.nodes.len());
    let faces = standing.section_prints.iter().map(|print| print.faces.len());
    nodes.chain(elements).chain(points).chain(faces).sum()
}

/// Requests of a kind for a file stand until a step makes new ones of that
/// kind for that file.
pub(super) fn renew(standing: &mut OutputRequests, step: &StepDraft, draft: &mut Draft) {
    standing.restart = step.restart.or(standing.restart);
    standing.contact_changes |= step.contact_changes;
    let asked = step.prints.iter().cloned().map(|(mut print, span)| {
        print.nodes = nodes_to_print(&print.request.set, span, draft);
        print
    });
    replace(&mut standing.node_prints, asked.collect(), |print| &print.request);
    let asked = step.element_prints.iter().cloned().map(|(mut print, span)| {
        print.elements = elements_to_print(&print.request.set, span, draft);
        print
    });
    replace(&mut standing.element_prints, asked.collect(), |print| &print.request);
    let asked = step.contact_prints.iter().cloned().map(|(mut print, span)| {
        print.nodes = nodes_to_print(&print.request.set, span, draft);
        without_pair(&print, draft);
        print
    });
    let asked: Vec<ContactPrint> = asked.collect();
    let ties = across_ties(&asked, draft);
    let (mut tied, mut sections): (Vec<_>, Vec<_>) =
        std::mem::take(&mut standing.section_prints).into_iter().partition(|print| print.is_tied);
    tied.retain(|old| asked.iter().all(|new| new.request.target != old.request.target));
    replace(&mut standing.contact_prints, asked, |print| &print.request);
    let asked = with_faces(&step.section_prints, draft);
    replace(&mut sections, asked, |print| &print.request);
    sections.extend(tied.into_iter().chain(ties));
    standing.section_prints = sections;
    if !step.states_every.is_empty() {
        standing.states_every.clone_from(&step.states_every);
    }
}

/// Warns of a request for a pair that does not exist.
fn without_pair(print: &ContactPrint, draft: &mut Draft) {
    if draft.model.contact_pairs.iter().any(|pair| print.wants(pair))
        || print.surfaces.iter().all(String::is_empty)
        || wants_tied(print, draft)
    {
        return;
    }
    let [slave, master] = &print.surfaces;
    let pair = match (slave.as_str(), master.as_str()) {
        (slave, "") => format!("whose slave is {slave}"),
        ("", master) => format!("whose master is {master}"),
        (slave, master) => format!("of {slave} on {master}"),
    };
    let message = format!("there is no contact pair {pair}: nothing is printed");
    let said = Diagnostic::warning(Code("SL0252"), message).at(print.request.origin);
    let help = "SLAVE and MASTER are the surfaces of a line of *CONTACT PAIR";
    draft.consequence(Subject::Contact, said.help(help));
}

fn replace<P>(standing: &mut Vec<P>, new: Vec<P>, request: fn(&P) -> &Request) {
    let targets: Vec<PrintTarget> = new.iter().map(|print| request(print).target).collect();
    standing.retain(|print| !targets.contains(&request(print).target));
    standing.extend(new);
}

/// The nodes of a set, each once; without a set all nodes.
fn nodes_to_print(set: &str, span: Option<Span>, draft: &mut Draft) -> Vec<NodeIndex> {
    let mut nodes = match span {
        Some(span) => draft.nodes_of(&crate::log::Target::Set(set.to_owned()), span),
        None => {
            let all = 0..draft.model.nodes.len();
            if draft.expand(all.len(), Span::default()) { all.collect() } else { Vec::new() }
        }
    };
    let mut seen = HashSet::new();
    nodes.retain(|node| seen.insert(*node));
    nodes
}

/// Labels of the elements with results of an element set, ascending; without a set
/// of all.
fn elements_to_print(set: &str, span: Option<Span>, draft: &mut Draft) -> Vec<u64> {
    let asked: Option<HashSet<u64>> = span.map(|span| {
        let found = draft.elements_of(set, span);
        found.unwrap_or_default().into_iter().map(|index| draft.elements[index].label).collect()
    });
    let blocks = draft.model.blocks.iter().filter(|block| !block.kind.fields.is_empty());
    let all = blocks.flat_map(|block| &block.elements).map(|element| element.label);
    let mut labels: Vec<u64> =
        all.filter(|label| asked.as_ref().is_none_or(|asked| asked.contains(label))).collect();
    labels.sort_unstable();
    labels
}
