//! `*NMAP`: nodes from one system of coordinates to another.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::vector::{cross, dot, sub};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*NMAP`.
pub(crate) struct Nmap;

impl Keyword for Nmap {
    fn name(&self) -> &'static str {
        "NMAP"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NSET"), Rule::required("TYPE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("NMAP")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let kinds = &["CYLINDRICAL", "RECTANGULAR", "SPHERICAL", "TOROIDAL", "BLENDED"];
        match card.choice("TYPE", kinds, &mut draft.log) {
            Some("CYLINDRICAL") => {}
            Some(other) => {
                let message = format!("*NMAP, TYPE={other} is not supported: CYLINDRICAL only");
                draft.log.error("SL0221", message, card.span_of("TYPE"));
                return;
            }
            None => return,
        }
        draft.log.at_most_lines(card.data(), 3, self.name());
        let Some(set) = card.name("NSET") else { return };
        let Some(system) = system(card, draft) else { return };
        if draft.has_expanded_all() {
            return;
        }
        let Some(labels) = draft.node_sets.labels(&set) else {
            if draft.is_complete(Subject::Nodes) {
                let message = format!("the node set {set} is not defined yet");
                let error = Diagnostic::error(Code("SL0304"), message).at(card.span_of("NSET"));
                draft
                    .log
                    .push(error.help("*NMAP moves the nodes that are in the set when it is read"));
            }
            return;
        };
        if !draft.expand(labels.len(), card.span()) {
            return;
        }
        for label in labels {
            if let Some(index) = draft.model.nodes.find(label) {
                let position = draft.model.nodes.get(index).position;
                draft.model.nodes.place(index, system.place(position));
            }
        }
    }
}

/// A cylindrical system: origin, directions, scale factors.
struct System {
    origin: [f64; 3],
    radial: [f64; 3],
    tangential: [f64; 3],
    axial: [f64; 3],
    scale: [f64; 3],
}

impl System {
    /// Stored coordinates read as (r, theta in degrees, z) become x =
    /// a + r (cos theta e_r + sin theta e_t) + z e_z.
    /// [semantics: deck language, *NMAP]
    fn place(&self, stored: [f64; 3]) -> [f64; 3] {
        let [r, theta, z] = [0, 1, 2].map(|k| stored[k] * self.scale[k]);
        let (sin, cos) = theta.to_radians().sin_cos();
        [0, 1, 2].map(|k| {
            let across = r * (cos * self.radial[k] + sin * self.tangential[k]);
            self.origin[k] + across + z * self.axial[k]
        })
    }
}

fn system(card: &Reading<'_>, draft: &mut Draft) -> Option<System> {
    let first = card.first_line("the points a and b of the axis", &mut draft.log)?;
    let Some(second) = card.data().get(1) else {
        draft.log.error("SL0208", "*NMAP needs a second line: the point c", card.span());
        return None;
    };
    draft.log.at_most(first, 6);
    draft.log.at_most(second, 3);
    let a = point(first, 0, draft)?;
    let b = point(first, 3, draft)?;
    let c = point(second, 0, draft)?;
    let scale = match card.data().get(2) {
        Some(line) => {
            draft.log.at_most(line, 3);
            let read = [0, 1, 2].map(|at| draft.log.number_or(line, at, 1.0));
            [read[0]?, read[1]?, read[2]?]
        }
        None => [1.0; 3],
    };
    let Some(axial) = unit(sub(b, a)) else {
        draft.log.error("SL0232", "the points a and b of the axis coincide", first.span);
        return None;
    };
    let ac = sub(c, a);
    let along = dot(ac, axial);
    let across = [0, 1, 2].map(|k| ac[k] - along * axial[k]);
    let far = dot(across, across) > 1e-24 * dot(ac, ac);
    let Some(radial) = unit(across).filter(|_| far) else {
        let message = "the point c lies on the axis: it must show where theta is zero";
        draft.log.error("SL0232", message, second.span);
        return None;
    };
    Some(System { origin: a, radial, tangential: cross(axial, radial), axial, scale })
}

fn point(line: &DataLine, at: usize, draft: &mut Draft) -> Option<[f64; 3]> {
    let read = [0, 1, 2].map(|k| draft.log.number_or(line, at + k, 0.0));
    Some([read[0]?, read[1]?, read[2]?])
}

fn unit(a: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(a, a).sqrt();
    (length > 0.0 && length.is_finite()).then(|| a.map(|x| x / length))
}
