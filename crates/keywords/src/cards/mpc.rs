//! `*MPC`: rigid links.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::Dialect;

use crate::constraints::{Link, LinkKind, Shape, ShapeMpc};
use crate::draft::Draft;
use crate::log::Target;

use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*MPC`.
pub(crate) struct Mpc;

impl Keyword for Mpc {
    fn name(&self) -> &'static str {
        "MPC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("INPUT")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("MPC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.first_line("type, dependent, master", &mut draft.log).is_none() {
            return;
        }
        for line in card.data() {
            let word = normalise(line.field(0).map_or("", |field| &field.text));
            match (shape(&word, draft.dialect), draft.shape_mpcs.last()) {
                (Some(shape), _) => {
                    let nodes = nodes(line, draft);
                    draft.shape_mpcs.push(ShapeMpc { shape, nodes, origin: line.span });
                }
                // a line without a type goes on with the nodes of the one before
                (None, Some(_)) if word.is_empty() || word == "0" => {
                    let more = nodes(line, draft);
                    if let Some(own) = draft.shape_mpcs.last_mut() {
                        own.nodes.extend(more);
                    }
                }
                _ => {
                    let link = link(line, draft);
                    draft.links.extend(link);
                }
            }
        }
    }
}

const SHAPES: [(&str, Shape); 5] = [
    ("STRAIGHT", Shape::Straight),
    ("PLANE", Shape::Plane),
    ("MEANROT", Shape::MeanRotation),
    ("LINEAR", Shape::Linear),
    ("LINK", Shape::Link),
];

/// The shape that a type keeps. CalculiX' BEAM keeps the distance of two nodes alone, which is
/// what LINK does.
fn shape(word: &str, dialect: Dialect) -> Option<Shape> {
    let word = if dialect == Dialect::Calculix && word == "BEAM" { "LINK" } else { word };
    SHAPES.iter().find(|(own, _)| *own == word).map(|&(_, shape)| shape)
}

/// The nodes and sets behind the type.
fn nodes(line: &DataLine, draft: &mut Draft) -> Vec<(Target, Span)> {
    let given = (1..line.fields.len()).filter(|&at| line.field(at).is_some());
    let given: Vec<usize> = given.collect();
    let read = given.into_iter().filter_map(|at| {
        let target = draft.log.target(line, at, "a node or set")?;
        Some((target, line.fields[at].span))
    });
    read.collect()
}

fn link(line: &DataLine, draft: &mut Draft) -> Option<Link> {
    let word = line.field(0).map_or("", |field| &field.text);
    let kind = match normalise(word).as_str() {
        "BEAM" => LinkKind::Beam,
        "TIE" => LinkKind::Tie,
        "PIN" => LinkKind::Pin,
        _ => {
            let span = line.fields.first().map_or(line.span, |field| field.span);
            let message = format!("*MPC of type `{word}` is not supported");
            let error = Diagnostic::error(Code("SL0221"), message).at(span);
            let help = "BEAM, TIE, PIN, LINK, LINEAR, STRAIGHT, PLANE, MEANROT";
            draft.log.push(error.help(help));
            return None;
        }
    };
    draft.log.at_most(line, 3);
    let dependent = draft.log.target(line, 1, "the dependent node or set");
    let master = draft.log.target(line, 2, "the master node");
    Some(Link {
        kind,
        dependent: dependent?,
        dependent_span: line.fields[1].span,
        master: master?,
        master_span: line.fields[2].span,
        origin: line.span,
    })
}
