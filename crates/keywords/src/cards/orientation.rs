//! `*ORIENTATION`: axes of materials.
//!
//! ```text
//!   a, b, c: points, nodes, nodes of the element or a distribution; then an axis and a turn about it
//! ```

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::System;

use crate::axes::{Given, Orientation as Draught, system_of};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*ORIENTATION`.
pub(crate) struct Orientation;

const SYSTEMS: &[&str] = &["RECTANGULAR", "CYLINDRICAL", "SPHERICAL", "Z RECTANGULAR", "USER"];
const DEFINITIONS: &[&str] = &["COORDINATES", "NODES", "OFFSET TO NODES"];

impl Keyword for Orientation {
    fn name(&self) -> &'static str {
        "ORIENTATION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("NAME"),
            Rule::value("SYSTEM"),
            Rule::value("DEFINITION"),
            Rule::value("LOCAL DIRECTIONS"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("ORIENTATION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(name) = card.name("NAME") else { return };
        let system = match card.choice("SYSTEM", SYSTEMS, &mut draft.log) {
            None if card.has("SYSTEM") => return,
            system => system.unwrap_or(SYSTEMS[0]),
        };
        let definition = match card.choice("DEFINITION", DEFINITIONS, &mut draft.log) {
            None if card.has("DEFINITION") => return,
            definition => definition.unwrap_or(DEFINITIONS[0]),
        };
        let offset = definition == "OFFSET TO NODES";
        if system == "USER" || (offset && system != "RECTANGULAR") {
            let message = format!("SYSTEM={system} with DEFINITION={definition} is not supported");
            draft.log.error("SL0221", message, card.span_of("SYSTEM"));
            return;
        }
        let Some(line) = card.first_line("a, b and perhaps c", &mut draft.log) else { return };
        if names_a_distribution(line) && definition != "COORDINATES" {
            let message = format!("a *DISTRIBUTION has points, not DEFINITION={definition}");
            draft.log.error("SL0215", message, card.span_of("DEFINITION"));
            return;
        }
        let fibres = card.at_least(1, "LOCAL DIRECTIONS", 0, &mut draft.log);
        draft.log.at_most_lines(card.data(), 2 + fibres, self.name());
        let Some(directions) = directions(card, fibres, draft) else { return };
        let given = match definition {
            "COORDINATES" if names_a_distribution(line) => {
                draft.log.at_most(line, 1);
                Some(Given::Distribution(system, normalise(&line.fields[0].text)))
            }
            "COORDINATES" => from_points(system, line, draft).map(Given::System),
            "NODES" => from_nodes(line, draft).map(|nodes| Given::Nodes(system, nodes)),
            _ => own_nodes(line, draft).map(Given::Own),
        };
        let turn = card.data().get(1).map_or(Some(None), |line| turn(line, draft));
        let (Some(given), Some(turn)) = (given, turn) else { return };
        if draft.orientations.iter().any(|known| known.name == name) {
            let message = format!("the orientation {name} is defined twice");
            draft.log.error("SL0250", message, card.span_of("NAME"));
            return;
        }
        draft.orientations.push(Draught { name, given, turn, directions, line: line.span });
    }
}

/// Directions of fibres, a line each behind the points and the turn; `None` after an error.
fn directions(card: &Reading<'_>, count: usize, draft: &mut Draft) -> Option<Vec<[f64; 3]>> {
    let lines = card.data().get(2..2 + count);
    let Some(lines) = lines.filter(|_| count > 0) else {
        if count > 0 {
            let message = "the lines with the local directions are missing";
            let error = Diagnostic::error(Code("SL0208"), message);
            let help =
                "behind the points and the line of the further turn each has a line: x, y, z";
            draft.log.push(error.at(card.span_of("LOCAL DIRECTIONS")).help(help));
        }
        return (count == 0).then(Vec::new);
    };
    lines.iter().map(|line| super::dload::direction(line, 0, draft)).collect()
}

/// Whether a line has a name in the place of points.
fn names_a_distribution(line: &DataLine) -> bool {
    line.field(0)
        .is_some_and(|first| first.text.starts_with(|c: char| c.is_alphabetic() || c == '_'))
}

fn from_points(system: &str, line: &DataLine, draft: &mut Draft) -> Option<System> {
    draft.log.at_most(line, 9);
    let [a, b, c] = draft.log.points(line)?;
    let made = system_of(system, [a, b, c]);
    if made.is_none() {
        draft.log.error("SL0232", "these points give no direction, or the same one", line.span);
    }
    made
}

/// Labels of the nodes a, b and perhaps c.
fn from_nodes(line: &DataLine, draft: &mut Draft) -> Option<[Option<u64>; 3]> {
    draft.log.at_most(line, 3);
    let mut nodes = [None; 3];
    for (at, node) in nodes.iter_mut().enumerate().take(line.fields.len().max(2)) {
        if at == 2 && line.field(at).is_none() {
            break;
        }
        *node = Some(draft.log.label(line, at, "the node")?);
    }
    Some(nodes)
}

/// Places of the nodes of the element, from 0; without c it is the first one.
fn own_nodes(line: &DataLine, draft: &mut Draft) -> Option<[usize; 3]> {
    draft.log.at_most(line, 3);
    let mut own = [0; 3];
    for (at, place) in own.iter_mut().enumerate() {
        let number = draft.log.integer_or(line, at, if at == 2 { 1 } else { 0 })?;
        let Some(known) = usize::try_from(number - 1).ok().filter(|&place| place < 27) else {
            let message = format!("{number} is not a node of an element: 1, 2, ...");
            draft.log.error("SL0210", message, line.span);
            return None;
        };
        *place = known;
    }
    Some(own)
}

/// The axis, 0 to 2, and the angle about it [1]: `Some(None)` where nothing turns.
fn turn(line: &DataLine, draft: &mut Draft) -> Option<Option<(usize, f64)>> {
    draft.log.at_most(line, 2);
    if line.field(1).is_some_and(|angle| angle.text.starts_with(char::is_alphabetic)) {
        let message = "an angle from a *DISTRIBUTION is not supported: turn its points";
        draft.log.error("SL0221", message, line.span);
        return None;
    }
    let axis = draft.log.integer_or(line, 0, 1)?;
    let degrees = draft.log.number_or(line, 1, 0.0)?;
    let Some(axis) = usize::try_from(axis - 1).ok().filter(|&axis| axis < 3) else {
        draft.log.error("SL0210", format!("{axis} is not an axis: 1, 2 or 3"), line.span);
        return None;
    };
    Some((degrees != 0.0).then(|| (axis, degrees.to_radians())))
}
