//! Temperatures of nodes: what lines mean for each node, before the first step and in it.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{NodalTemperature, NodeIndex, Section, Temperature};

use super::standing::InForce;
use crate::draft::{Draft, Heat};
use crate::rule::Subject;

/// Temperatures before the first step, a node each; none where the deck has none.
pub(super) fn initial(draft: &mut Draft) {
    for line in std::mem::take(&mut draft.initial_temperatures) {
        check(&line, draft);
        let nodes = draft.nodes_of(&line.target, line.target_span);
        let all = &mut draft.model.initial_temperatures;
        all.resize(draft.model.nodes.len(), Temperature::default());
        for node in nodes {
            all[node] = line.temperature;
        }
    }
}

/// Puts a line of a step, with its amplitude, into force.
pub(super) fn heat(
    (line, amplitude): (&Heat, Option<usize>),
    into: &mut InForce<NodalTemperature, NodeIndex>,
    draft: &mut Draft,
) {
    check(line, draft);
    for node in draft.nodes_of(&line.target, line.target_span) {
        let (temperature, origin) = (line.temperature, line.origin);
        into.set(node, NodalTemperature { node, temperature, amplitude, origin });
    }
}

/// A slope counts in beams alone.
fn check(line: &Heat, draft: &mut Draft) {
    let Some(span) = line.slope else { return };
    if draft.elements.iter().any(|element| element.kind.is_beam()) {
        return;
    }
    let message = "a slope of the temperature counts in beams, and there are none";
    let error = Diagnostic::error(Code("SL0210"), message).at(span);
    draft.consequence(Subject::Elements, error.help("give every node its own temperature"));
}

/// Complains about beams in space that would expand or soften where nodes are heated: they do not.
pub(super) fn beams_in_space(draft: &mut Draft) {
    if !draft.model.has_temperatures() {
        return;
    }
    let blocks = draft.model.blocks.iter().filter(|block| block.kind.is_space_beam());
    let warm = blocks.filter(|block| match &block.section {
        Section::Beam(section) => section.heat.is_some(),
        _ => false,
    });
    let errors: Vec<Diagnostic> = warm
        .map(|block| {
            let message = format!(
                "the beams in space of {} do not answer temperatures, and nodes are heated",
                block.name
            );
            let help = "model what is heated with solids, trusses or beams of the plane";
            Diagnostic::error(Code("SL0309"), message).at(block.origin).help(help)
        })
        .collect();
    errors.into_iter().for_each(|error| draft.consequence(Subject::Sections, error));
}
