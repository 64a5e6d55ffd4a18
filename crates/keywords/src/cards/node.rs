//! `*NODE`: points of the model.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*NODE`.
pub(crate) struct Node;

impl Keyword for Node {
    fn name(&self) -> &'static str {
        "NODE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("NSET"), Rule::value("SYSTEM"), Rule::value("INPUT")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("NODE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let system = card.choice(
            "SYSTEM",
            &["R", "RECTANGULAR", "C", "CYLINDRICAL", "S", "SPHERICAL"],
            &mut draft.log,
        );
        let set = card.name("NSET");
        if let Some(set) = &set {
            draft.node_sets.open(set, card.span());
        }
        for line in card.data() {
            draft.log.at_most(line, 7); // behind the coordinates may stand a normal
            let Some(label) = draft.log.label(line, 0, "the node number") else { continue };
            let given = [1, 2, 3].map(|at| draft.log.number_or(line, at, 0.0).unwrap_or(0.0));
            let own = straight(given, system);
            let place = draft.node_frame.map_or(own, |frame| frame.point(own));
            if let Some(set) = &set {
                draft.node_sets.join(set, Item::One(label), line.span);
            }
            draft.add_node(label, place, line.span, false);
        }
    }
}

/// Straight coordinates of a point given by radius, angle [degrees] and height, or by radius and
/// the angles about z and from the equator.
fn straight([a, b, c]: [f64; 3], system: Option<&str>) -> [f64; 3] {
    let (sin, cos) = b.to_radians().sin_cos();
    match system {
        Some("C" | "CYLINDRICAL") => [a * cos, a * sin, c],
        Some("S" | "SPHERICAL") => {
            let (up, out) = c.to_radians().sin_cos();
            [a * out * cos, a * out * sin, a * up]
        }
        _ => [a, b, c],
    }
}
