//! What a designer would change of a rigid surface: the angles of its flanks, its radii, its place.

use crate::drawing::Segment;
use crate::places::{Drawn, Follows};
use crate::profile::{Handle, Kind, Profile};
use crate::search::{Number, Search};
use slideline::deck::{Card, DataLine, Field, normalise, parse_number};

const ANGLE: &str = "angle";
const FILLET: (&str, &str) = ("fillet", "corners");
const RADIUS: (&str, &str) = ("radius", "arc");
/// Ends of the slider of an angle, to both sides of the deck's [degrees].
const TURN: f64 = 15.0;

/// Looks at the surface of a card. `plane`: its profile lies in the plane of the model.
pub(crate) fn surface(search: &mut Search, card: &Card, owner: &str, plane: bool) {
    let fillet = card.parameters.iter().find(|own| own.name.name == "FILLETRADIUS");
    if let Some(word) = fillet.and_then(|own| own.value.as_ref())
        && let Ok(value) = parse_number(&word.raw)
        && value > 0.0
    {
        let slider = search.add(Number::new(FILLET, owner, value));
        search.follow(word.span, value, Follows::Same(slider));
    }
    let is_start = |line: &DataLine| line.fields.first().is_some_and(|own| word(own) == "START");
    let Some(start) = card.data.iter().position(is_start) else { return };
    let (axes, lines) = card.data.split_at(start);
    let read: Option<Vec<(&Field, f64)>> = lines
        .iter()
        .flat_map(|line| fields(line).get(1..).unwrap_or_default())
        .map(|field| Some((field, search.number(field)?)))
        .collect();
    if let Some(read) = read
        && let Some(profile) = profile(lines, &read, plane)
    {
        drawn(search, owner, profile, &read);
    }
    if !plane {
        moved(search, owner, axes);
    }
}

/// Fields of a line without empty ones at its end.
fn fields(line: &DataLine) -> &[Field] {
    let last = line.fields.iter().rposition(|own| !own.text.trim().is_empty());
    &line.fields[..last.map_or(0, |last| last + 1)]
}

/// The keyword of a segment.
fn word(field: &Field) -> String {
    normalise(&field.text)
}

/// The profile of its lines and their numbers; `None`: it is none.
fn profile(lines: &[DataLine], read: &[(&Field, f64)], plane: bool) -> Option<Profile> {
    let mut numbers = read.iter().map(|own| own.1);
    let mut point = || Some([numbers.next()?, numbers.next()?]);
    let start = point()?;
    let mut segments = Vec::new();
    for line in lines.get(1..)? {
        let own = fields(line);
        segments.push(match (word(own.first()?).as_str(), own.len()) {
            ("LINE", 3) => Segment::Line(point()?),
            ("CIRCL" | "CIRCLE", 5) => Segment::Arc(point()?, point()?),
            ("PARAB" | "PARABOLA", 5) => Segment::Parabola(point()?, point()?),
            _ => return None,
        });
    }
    (!segments.is_empty() && fields(&lines[0]).len() == 3)
        .then(|| Profile::of(start, &segments, plane))
}

/// Sliders of a profile, and the numbers that follow them.
fn drawn(search: &mut Search, owner: &str, profile: Profile, read: &[(&Field, f64)]) {
    let sliders = profile.handles.iter().map(|own| search.add(number(own, owner, &profile)));
    let (name, sliders) = (owner.to_owned(), sliders.collect());
    let drawn = search.draw(Drawn { name, profile, sliders });
    for (place, (field, value)) in read.iter().enumerate() {
        search.follow(field.span, *value, Follows::Drawn(drawn, place));
    }
}

fn number(handle: &Handle, owner: &str, profile: &Profile) -> Number {
    match handle.kind {
        Kind::Angle(flank) => {
            let about = format!("segment {}", profile.line(flank));
            let mut own = Number::new((ANGLE, &about), owner, handle.value);
            (own.unit, own.range) = ("°", [handle.value - TURN, handle.value + TURN]);
            own
        }
        Kind::Fillet => Number::new(FILLET, owner, handle.value),
        Kind::Radius(_) => Number::new(RADIUS, owner, handle.value),
        Kind::Shift(axis) => {
            Number::shift(axis, owner, [profile.ends(0), profile.ends(1), [0.0, 0.0]])
        }
    }
}

/// The axes of a surface in space, which move with it.
fn moved(search: &mut Search, owner: &str, axes: &[DataLine]) {
    let along =
        |axis: usize| axes.iter().flat_map(move |line| fields(line).iter().skip(axis).step_by(3));
    let read = [0, 1, 2].map(|axis| {
        let all = along(axis).map(|field| Some((field, search.number(field)?)));
        all.collect::<Option<Vec<(&Field, f64)>>>().unwrap_or_default()
    });
    let ends = [0, 1, 2].map(|axis: usize| {
        read[axis].iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| {
            [low.min(own.1), high.max(own.1)]
        })
    });
    for (axis, read) in read.iter().enumerate().filter(|(_, own)| !own.is_empty()) {
        let slider = search.add(Number::shift(axis, owner, ends));
        for (field, value) in read {
            search.follow(field.span, *value, Follows::Moved(slider));
        }
    }
}
