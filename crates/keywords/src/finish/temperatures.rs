//! Temperatures of nodes: what lines mean for each node, before the first step and in it.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{NodalTemperature, NodeIndex, Temperature};

use super::standing::InForce;
use crate::draft::{Body, Draft, ElementKind, Heat, Section};

/// Temperatures before the first step, a node each; none where the deck has none.
pub(super) fn initial(draft: &mut Draft) {
    for line in std::mem::take(&mut draft.initial_temperatures) {
        check(&line, draft);
        let nodes = on_both_sides(&line, draft);
        let all = &mut draft.model.initial_temperatures;
        all.resize(draft.model.nodes.len(), Temperature::default());
        for node in nodes {
            all[node] = line.temperature;
        }
    }
}

/// The nodes that a line names, and those that stand for them behind cuts by pre-tension sections.
fn on_both_sides(line: &Heat, draft: &mut Draft) -> Vec<NodeIndex> {
    let mut nodes = draft.nodes_of(&line.target, line.target_span);
    if !draft.behind_cuts.is_empty() {
        let all = &draft.model.nodes;
        let behind = |&node: &NodeIndex| draft.behind_cuts.get(&all.label(node));
        let behind = nodes.iter().filter_map(behind).flatten().filter_map(|&own| all.find(own));
        let behind: Vec<NodeIndex> = behind.collect();
        nodes.extend(behind);
    }
    nodes
}

/// Says that temperatures of the steps cause no strain where no material expands.
pub(super) fn without_expansion(draft: &mut Draft) {
    let expands = |section: &Section| match &section.body {
        Body::Beam { elastic: Some((_, expansion)), .. } => *expansion != 0.0,
        _ => false,
    };
    let materials = draft.materials.iter().any(|material| material.expansion.is_some());
    if materials || draft.sections.iter().any(expands) {
        return;
    }
    let lines = draft.steps.iter().flat_map(|step| &step.temperatures);
    let Some(span) = lines.map(|line| line.origin).next() else { return };
    let message = "temperatures cause no strain here: no material expands";
    let note = Diagnostic::note(Code("SL0253"), message).at(span);
    draft.log.push(note.help("give the material its *EXPANSION, or leave *TEMPERATURE out"));
}

/// Says that coefficients which shear out of the plane strain nothing in models of it.
pub(super) fn out_of_plane(draft: &mut Draft) {
    if draft.model.is_in_space() {
        return;
    }
    let own = draft.materials.iter().filter_map(|material| material.expansion.as_ref());
    let shears = own.filter(|(own, _)| {
        own.iter().flat_map(|own| &own.table).any(|(_, row)| row[4] != 0.0 || row[5] != 0.0)
    });
    let cards: Vec<Span> = shears.map(|(_, (_, card))| *card).collect();
    for card in cards {
        let message = "a13 and a23 have no effect here: they shear out of the plane";
        draft.log.note("SL0257", message, card);
    }
}

/// Puts a line of a step, with its amplitude, into force.
pub(super) fn heat(
    (line, amplitude): (&Heat, Option<usize>),
    into: &mut InForce<NodalTemperature, NodeIndex>,
    draft: &mut Draft,
) {
    check(line, draft);
    for node in on_both_sides(line, draft) {
        let (temperature, origin) = (line.temperature, line.origin);
        into.set(node, NodalTemperature { node, temperature, amplitude, origin });
    }
}

/// Slopes count in beams alone, one in the plane and two in space, and nothing takes more than that; solids have one
/// temperature at a node.
fn check(line: &Heat, draft: &mut Draft) {
    let any = |is_such: fn(ElementKind) -> bool| draft.elements.iter().any(|own| is_such(own.kind));
    let most = match (any(ElementKind::is_beam), any(ElementKind::is_space_beam)) {
        (_, true) => Some((4, line.further)),
        (true, false) => Some((3, line.other_slope.or(line.further))),
        (false, false) => None,
    };
    if let Some((values, Some(span))) = most {
        let message = format!("more values than this line takes ({values})");
        draft.log.push(Diagnostic::error(Code("SL0209"), message).at(span));
    }
    let Some(span) = line.slope.or(line.other_slope).or(line.further) else { return };
    if most.is_none() && draft.log.first_time("slope of the temperature") {
        let message = "solids have one temperature at a node: further values have no effect";
        let note = Diagnostic::note(Code("SL0253"), message).at(span);
        draft.log.push(note.help("give every node its own temperature"));
    }
}
