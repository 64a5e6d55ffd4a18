//! Points that slide off the end of their master.
//!
//! ```text
//!             o-->  slave node
//!   x-----x-----x        the end, and what prolongs it
//! ```

use super::case::Case;
use crate::newton::TOUCH;
use crate::problem::Problem;
use crate::state::State;
use slideline_diag::{Code, Diagnostic, Place, Severity};
use slideline_model::{
    ContactPair, Master, Model, NodeIndex, RigidSurface, SlideLine, SurfaceSegment, Vocabulary,
};

impl Case<'_> {
    /// The run ends where a point has slid off the end of its master.
    pub(super) fn off_the_end(&self) -> Option<Diagnostic> {
        let now = State {
            points: self.work.evaluation.points.clone(),
            displacement: self.work.u.clone(),
            total_time: self.committed.total_time + self.dt,
            ..State::default()
        };
        let (_, last) = slid_off(self.plan, self.committed, &now).pop()?;
        Some(Diagnostic { severity: Severity::Error, ..last })
    }
}

/// Points that carried pressure at the last commit, now face no master, and
/// would touch it were its end prolonged: they have slid off. A word a node, with its pair.
pub fn slid_off(plan: &Problem<'_>, committed: &State, now: &State) -> Vec<(usize, Diagnostic)> {
    // Hard contact touches with a gap of nothing but rounding.
    let slack = TOUCH * plan.reach;
    let mut left = Vec::new();
    let mut last = None;
    for (place, point) in plan.contact.points.iter().enumerate() {
        let before = &committed.points[place];
        let gone = before.closed
            && !plan.contact.is_edge(place)
            && now.points[place].along.is_none()
            && last != Some((point.pair, point.node))
            && plan.contact.has_slid_off(place, (before.xi, slack), &now.displacement);
        if !gone {
            continue;
        }
        last = Some((point.pair, point.node));
        let pair = plan.pair_of(place);
        let label = plan.model.nodes.name(point.node);
        let end = master_end(plan, pair, before.along.unwrap_or_default()[0]);
        let message = format!(
            "node {label} has slid off the end of {} between total time {:.6} and {:.6}",
            end.what, committed.total_time, now.total_time
        );
        let mut said = Diagnostic::warning(Code("SL0504"), message).at(end.origin).help(end.remedy);
        if let Some((place, card)) = end.card {
            said = said.card(place, card);
        }
        left.push((point.pair, said));
    }
    left
}

/// The end of a master, and how it is prolonged.
pub(super) struct End {
    pub what: &'static str,
    pub remedy: String,
    pub origin: slideline_diag::Span,
    pub card: Option<(Place, String)>,
}

/// The end of the master of a pair that is nearer to a place on it.
pub(super) fn master_end(plan: &Problem<'_>, pair: &ContactPair, along: f64) -> End {
    match &pair.master {
        Master::SlideLine(line) => line_end(plan.model, line, pair, along),
        Master::RigidSurface(surface) => surface_end(surface, pair, along),
        Master::Itself(surface) => End {
            what: "the surface",
            remedy: "name the faces beyond its end in *SURFACE too".to_owned(),
            origin: surface.origin,
            card: None,
        },
        Master::Faces(faces) => End {
            what: "the surface",
            remedy: "name the faces beyond its edge in *SURFACE too, or prolong it with EXTENSION \
                     ZONE"
                .to_owned(),
            origin: faces.origin,
            card: None,
        },
    }
}

/// The beam's own nodes beyond the end prolong a slide line; where there are
/// none, its longest extension zone does.
fn line_end(model: &Model, line: &SlideLine, pair: &ContactPair, along: f64) -> End {
    let at = |node: NodeIndex| model.nodes.get(node).position;
    let sides = line.nodes.windows(2).map(|w| {
        let (a, b) = (at(w[0]), at(w[1]));
        (b[0] - a[0]).hypot(b[1] - a[1])
    });
    let in_front = along < 0.5 * sides.sum::<f64>();
    let mut nodes = line.nodes.clone();
    if in_front {
        nodes.reverse();
    }
    while let Some(next) = nodes.last().and_then(|&end| neighbour(model, end, &nodes)) {
        nodes.push(next);
    }
    let extension = if nodes.len() > line.nodes.len() { line.extension } else { 0.2 };
    if in_front {
        nodes.reverse();
    }
    let known = nodes.len() == line.nodes.len() && line.extension >= extension;
    let card = (!known && pair.vocabulary == Vocabulary::Elements).then(|| {
        let head = format!("*SLIDE LINE, TYPE=LINEAR, ELSET={}", pair.name);
        let mut text =
            format!("{head}, SMOOTH={}, EXTENSION ZONE={extension}\n", line.smooth.unwrap_or(0.0));
        let labels: Vec<String> = nodes.iter().map(|&n| model.nodes.name(n).to_string()).collect();
        for row in labels.chunks(16) {
            text.push_str(&row.join(", "));
            text.push('\n');
        }
        (Place::Instead(line.origin), text)
    });
    let lengthen = pair.vocabulary.lengthen_chain();
    let remedy = format!("{lengthen}, or extend its ends with EXTENSION ZONE");
    End { what: "the slide line", remedy, origin: line.origin, card }
}

/// The other end of a beam at a node that is not among the nodes known.
fn neighbour(model: &Model, end: NodeIndex, known: &[NodeIndex]) -> Option<NodeIndex> {
    let beams = model.blocks.iter().filter_map(|block| block.beams());
    let mut elements = beams.flat_map(|block| block.elements);
    elements.find_map(|beam| {
        let [a, b] = beam.ends();
        let other = if a == end { b } else { a };
        ((a == end || b == end) && !known.contains(&other)).then_some(other)
    })
}

/// One more data line prolongs a rigid surface by twice its length.
fn surface_end(surface: &RigidSurface, pair: &ContactPair, along: f64) -> End {
    let remedy = format!("extend {} beyond the stroke", pair.vocabulary.rigid_surface());
    let end = End { what: "the rigid surface", remedy, origin: surface.origin, card: None };
    let mut from = surface.start;
    let mut length = 0.0;
    let mut last = None;
    for segment in &surface.segments {
        let to = match *segment {
            SurfaceSegment::Line { end } => {
                last = Some((from, end));
                end
            }
            SurfaceSegment::Circle { end, .. } | SurfaceSegment::Parabola { end, .. } => {
                last = None;
                end
            }
        };
        length += (to[0] - from[0]).hypot(to[1] - from[1]);
        from = to;
    }
    let Some((a, b)) = last else { return end };
    if along < 0.5 * length {
        return end; // it left at the start, where no data line can be added
    }
    let size = (b[0] - a[0]).hypot(b[1] - a[1]);
    let [x, y] = [0, 1].map(|k| b[k] + (b[k] - a[k]) / size * 2.0 * length);
    End { card: Some((Place::After(surface.origin), format!("LINE, {x:.6E}, {y:.6E}\n"))), ..end }
}
