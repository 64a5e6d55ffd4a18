//! `*RIGID SURFACE`: analytic surface of a rigid body.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ProfilePoint, SurfaceSegment};

use crate::crossing::crossing;
use crate::draft::Draft;
use crate::draft::{Shape, Surface};
use crate::fillet::{Profile, drawn, fillet};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*RIGID SURFACE`.
pub(crate) struct RigidSurface;

impl Keyword for RigidSurface {
    fn name(&self) -> &'static str {
        "RIGID SURFACE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::required("ELSET"), Rule::required("TYPE"), Rule::value("FILLET RADIUS")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("RIGID-SURFACE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        card.choice("TYPE", &["SEGMENTS"], &mut draft.log);
        let Some(set) = card.name("ELSET") else { return };
        let Some((start, segments)) = segments(card, draft) else { return };
        let set_span = card.span_of("ELSET");
        let shape = Shape::Rigid { start, segments };
        draft.surfaces.push(Surface { set, set_span, shape, origin: card.span() });
    }
}

/// The lines `START`, `LINE`, `CIRCL` and `PARAB` of a card: first point and
/// segments, undeformed [L].
pub(crate) fn segments(
    card: &Reading<'_>,
    draft: &mut Draft,
) -> Option<(ProfilePoint, Vec<SurfaceSegment>)> {
    card.first_line("START, x, y", &mut draft.log)?;
    profile(card, card.data(), draft)
}

/// The same on lines that follow others of the card.
pub(super) fn profile(
    card: &Reading<'_>,
    lines: &[DataLine],
    draft: &mut Draft,
) -> Option<Profile> {
    let errors = draft.log.errors();
    let radius = card.number("FILLET RADIUS", &mut draft.log)?.filter(|&radius| radius != 0.0);
    if radius.is_some_and(|radius| radius < 0.0) {
        let span = card.span_of("FILLET RADIUS");
        draft.log.error("SL0210", "FILLET RADIUS must not be negative", span);
    }
    let Some((first, rest)) = lines.split_first() else {
        draft.log.error("SL0237", "the profile START, x, y is missing", card.span());
        return None;
    };
    let start = start(first, draft)?;
    let mut segments = Vec::new();
    let mut from = Some(start);
    for line in rest {
        let segment = segment(line, from, draft);
        from = segment.map(|segment| end_of(&segment));
        segments.extend(segment);
    }
    if rest.is_empty() {
        draft.log.error("SL0237", "a rigid surface needs at least one segment", card.span());
        return None;
    }
    let profile = (start, segments);
    if draft.log.errors() > errors {
        return Some(profile);
    }
    let whole = match radius {
        Some(radius) => with_fillets((card, lines), &profile, radius, draft)?,
        None => profile.clone(),
    };
    warn_of_crossing((card, lines), [&profile, &whole], draft);
    Some(whole)
}

/// Says so where a profile crosses itself; the lines of its segments are those before corners were
/// rounded.
fn warn_of_crossing(
    (card, lines): (&Reading<'_>, &[DataLine]),
    [given, whole]: [&Profile; 2],
    draft: &mut Draft,
) {
    let Some(found) = crossing(&drawn(whole)) else { return };
    let given = crossing(&drawn(given));
    let line = |part: usize| lines.get(part + 1).map(|line| line.span);
    let [earlier, later] = given.map_or([None; 2], |given| given.parts.map(line));
    let [x, y] = given.map_or(found.at, |given| given.at);
    let message = format!("the profile crosses itself at ({x:.4e}, {y:.4e})");
    let mut said =
        Diagnostic::warning(Code("SL0339"), message).at(later.unwrap_or_else(|| card.span()));
    if let Some(earlier) = earlier.filter(|_| earlier != later) {
        said = said.label(earlier, "the segment that it crosses");
    }
    draft.log.push(said.help(
        "beyond the crossing the outside of one segment is the inside of another, and contact there \
         means nothing: correct the points, or give each part a surface of its own",
    ));
}

/// The profile with its corners rounded; complains about a corner that the arc does not fit.
fn with_fillets(
    (card, lines): (&Reading<'_>, &[DataLine]),
    profile: &Profile,
    radius: f64,
    draft: &mut Draft,
) -> Option<Profile> {
    let misfit = match fillet(profile, radius) {
        Ok(rounded) => return Some(rounded),
        Err(misfit) => misfit,
    };
    let at = misfit.segment.checked_sub(1).map_or(profile.0, |before| profile.1[before].end());
    let before = if misfit.segment == 0 { lines.last() } else { lines.get(misfit.segment) };
    let message = format!(
        "an arc of radius {radius} does not fit the corner at ({}, {}): a segment is too short, \
         or an arc too tight",
        at[0], at[1]
    );
    let span = lines.get(misfit.segment + 1).map_or(card.span(), |line| line.span);
    let mut error = Diagnostic::error(Code("SL0259"), message).at(span);
    if let Some(line) = before {
        error = error.label(line.span, "the segment before the corner");
    }
    draft.log.push(error.help(match misfit.largest.map(rounded_down) {
        Some(largest) => format!("the largest radius that fits all corners is {largest}"),
        None => "no radius fits: the surface turns back on itself there".to_owned(),
    }));
    None
}

/// Four digits, never more than the number.
fn rounded_down(value: f64) -> String {
    let unit = 10f64.powf(value.log10().floor() - 3.0);
    format!("{:.3e}", (value / unit * (1.0 - 1e-9)).floor() * unit)
}

/// Two radii of an arc may differ by this much, relative to their size.
const RADIUS_TOLERANCE: f64 = 1e-4;

fn start(line: &DataLine, draft: &mut Draft) -> Option<ProfilePoint> {
    let word = line.field(0).map_or("", |field| &field.text);
    if normalise(word) != "START" {
        let message = "the first line of a rigid surface is START, x, y";
        draft.log.error("SL0237", message, line.span);
        return None;
    }
    draft.log.at_most(line, 3);
    point(line, 1, draft)
}

fn point(line: &DataLine, at: usize, draft: &mut Draft) -> Option<ProfilePoint> {
    let x = draft.log.number(line, at, "x");
    let y = draft.log.number(line, at + 1, "y");
    Some([x?, y?])
}

fn end_of(segment: &SurfaceSegment) -> ProfilePoint {
    match *segment {
        SurfaceSegment::Line { end }
        | SurfaceSegment::Circle { end, .. }
        | SurfaceSegment::Parabola { end, .. } => end,
    }
}

/// A segment; `from` is `None` where the one before could not be read, and
/// then its shape is not judged.
fn segment(
    line: &DataLine,
    from: Option<ProfilePoint>,
    draft: &mut Draft,
) -> Option<SurfaceSegment> {
    let word = line.field(0).map_or("", |field| &field.text);
    let name = normalise(word);
    let segment = match name.as_str() {
        "LINE" => {
            draft.log.at_most(line, 3);
            SurfaceSegment::Line { end: point(line, 1, draft)? }
        }
        "CIRCL" | "CIRCLE" => {
            draft.log.at_most(line, 5);
            let (end, centre) = (point(line, 1, draft), point(line, 3, draft));
            SurfaceSegment::Circle { end: end?, centre: centre? }
        }
        "PARAB" | "PARABOLA" => {
            draft.log.at_most(line, 5);
            let (middle, end) = (point(line, 1, draft), point(line, 3, draft));
            SurfaceSegment::Parabola { middle: middle?, end: end? }
        }
        _ => {
            let message = format!("`{word}` is not a segment of a rigid surface");
            let error = Diagnostic::error(Code("SL0237"), message).at(line.span);
            draft.log.push(error.help("segments are LINE, CIRCL and PARAB"));
            return None;
        }
    };
    if let Some(problem) = from.and_then(|from| fault(from, &segment)) {
        draft.log.error("SL0237", problem, line.span);
    }
    Some(segment)
}

fn distance(a: ProfilePoint, b: ProfilePoint) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// What is wrong with the shape of a segment. [semantics: surfaces, segments]
fn fault(from: ProfilePoint, segment: &SurfaceSegment) -> Option<String> {
    let end = end_of(segment);
    if distance(from, end) == 0.0 {
        return Some("the segment has zero length".to_owned());
    }
    let SurfaceSegment::Circle { centre, .. } = *segment else { return None };
    let (first, second) = (distance(from, centre), distance(end, centre));
    if (first - second).abs() > RADIUS_TOLERANCE * first.max(second) {
        return Some(format!(
            "the centre of the arc is {first} from its start, but {second} from its end"
        ));
    }
    // The chord of an arc of 180 degrees is its diameter: which side is meant is then open.
    let half_turn = distance(from, end) >= (first + second) * (1.0 - 1e-9);
    half_turn.then(|| "an arc of 180 degrees: split it in two".to_owned())
}
