//! What the charts of the page draw, as JSON that may stand in a script.

use super::contact::{Contacts, Point, runs};
use super::overlay::Overlay;
use super::results::{Driven, Results};
use super::value::Value;
use crate::json::{self, Object};
use crate::verdict::Judged;
use crate::vtu::base64;
use slideline_measures::Taken;

/// All numbers of the page.
pub(crate) fn data(
    job: &str,
    results: &Results,
    judged: &Judged,
    overlay: Option<&Overlay>,
) -> String {
    let energies = &results.energies;
    let with_start = |values: &[f64]| -> Vec<f64> {
        std::iter::once(0.0).chain(values.iter().copied()).collect()
    };
    let numbers = |place: usize| -> Vec<f64> {
        energies.numbers.iter().map(|numbers| numbers[place] as f64).collect()
    };
    let energy = energies.columns.iter().zip(&energies.values);
    let object = Object::new()
        .text("job", job)
        .raw("times", &doubles(&with_start(&energies.times)))
        .raw("step", &doubles(&with_start(&numbers(0))))
        .raw("increment", &doubles(&with_start(&numbers(1))))
        .raw("driven", &driven(results, judged))
        .raw("supports", &supports(results))
        .raw("heights", &heights(results))
        .array(
            "loaded",
            results.loaded.iter().map(|(node, motion)| {
                Object::new().raw("node", &node.to_string()).text("motion", motion).finish()
            }),
        )
        .raw("history", &history(results))
        .raw("energy", &columns(energy.map(|(name, values)| (name.as_str(), &values[..]))))
        .count("stride", results.contacts.stride)
        .array("contact", results.contacts.points.iter().map(|own| point(&results.contacts, own)))
        .raw("pairs", &pairs(results))
        .raw("frames", &frames(results))
        .array("attempts", results.attempts.iter().map(attempt));
    let overlay = overlay.map(|overlay| {
        let own = overlay.columns.iter().map(|(name, values)| (name.as_str(), &values[..]));
        Object::new().text("name", &overlay.name).raw("columns", &columns(own)).finish()
    });
    safe(&object.raw("overlay", overlay.as_deref().unwrap_or("null")).finish())
}

/// No text in it ends a script or a line of one.
fn safe(json: &str) -> String {
    let mut text = String::with_capacity(json.len());
    for letter in json.chars() {
        match letter {
            '<' => text.push_str("\\u003c"),
            '>' => text.push_str("\\u003e"),
            '&' => text.push_str("\\u0026"),
            '\u{2028}' => text.push_str("\\u2028"),
            '\u{2029}' => text.push_str("\\u2029"),
            other => text.push(other),
        }
    }
    text
}

/// Doubles in base64, little-endian.
fn doubles(values: &[f64]) -> String {
    quoted(values.iter().flat_map(|value| value.to_le_bytes()).collect())
}

/// Single precision where a picture is made of it.
fn singles(values: impl Iterator<Item = f32>) -> String {
    quoted(values.flat_map(f32::to_le_bytes).collect())
}

fn quoted(bytes: Vec<u8>) -> String {
    let mut text = "\"".to_owned();
    base64::push(&mut text, &bytes);
    text.push('"');
    text
}

fn columns<'a>(columns: impl Iterator<Item = (&'a str, &'a [f64])>) -> String {
    let mut object = Object::new();
    for (name, values) in columns {
        object = object.raw(name, &doubles(values));
    }
    object.finish()
}

/// Driven motions, that which does most work first, with the places of the
/// largest push and pull.
fn driven(results: &Results, judged: &Judged) -> String {
    let moved = judged.strokes.iter().map(|(driven, stroke)| (driven, Some(stroke)));
    let known = |driven: &Driven| judged.strokes.iter().any(|(own, _)| own == driven);
    let still = results.driven.iter().filter(|driven| !known(driven)).map(|driven| (driven, None));
    json::array(moved.chain(still).map(|(driven, stroke)| {
        let place = |taken: Option<Taken>| {
            taken.map_or_else(|| "null".to_owned(), |taken| taken.place.to_string())
        };
        Object::new()
            .raw("node", &driven.node.to_string())
            .text("motion", &driven.motion)
            .text("reaction", &driven.reaction)
            .number("inward", stroke.map_or(1.0, |stroke| stroke.inward))
            .raw("push", &place(stroke.and_then(|stroke| stroke.push)))
            .raw("pull", &place(stroke.and_then(|stroke| stroke.pull)))
            .finish()
    }))
}

/// Held nodes with the numbers of their dofs.
fn supports(results: &Results) -> String {
    json::array(results.summary.list("supports").iter().filter_map(|held| {
        let dofs = held.list("dofs").iter().filter_map(|dof| match dof {
            Value::Number(number) => Some(number.to_string()),
            _ => None,
        });
        let object = Object::new().raw("node", &held.count("node")?.to_string());
        Some(object.array("dofs", dofs).finish())
    }))
}

/// Height of the section of every cell; zero for what is no beam.
fn heights(results: &Results) -> String {
    let sections = results.summary.list("sections");
    let number = |value: &Value| match value {
        Value::Number(number) => *number as i64,
        _ => 0,
    };
    let ranges: Vec<(f64, Vec<i64>)> = sections
        .iter()
        .filter_map(|own| {
            Some((own.number("height")?, own.list("elements").iter().map(number).collect()))
        })
        .collect();
    let of = |element: i64| {
        let inside = |list: &[i64]| {
            list.as_chunks::<2>().0.iter().any(|[a, b]| (*a..=*b).contains(&element))
        };
        ranges.iter().find(|(_, list)| inside(list)).map_or(0.0, |(height, _)| *height)
    };
    let frames = &results.frames;
    let cells = frames.kinds.iter().zip(&frames.elements);
    singles(cells.map(|(kind, element)| if *kind == 0 { of(*element) as f32 } else { 0.0 }))
}

fn history(results: &Results) -> String {
    json::array(results.history.nodes.iter().map(|node| {
        let names = results.history.columns.iter().map(String::as_str);
        let values = names.zip(node.values.iter().map(Vec::as_slice));
        Object::new().raw("node", &node.node.to_string()).raw("columns", &columns(values)).finish()
    }))
}

fn point(contacts: &Contacts, point: &Point) -> String {
    let end = point.closed_until();
    let [opening, pressure, shear, slip, angle] =
        contacts.numbers(point).map(|column| singles(column.iter().copied()));
    Object::new()
        .text("pair", &point.pair)
        .raw("node", &point.node.to_string())
        .count("first", point.first)
        .text("status", &runs(&point.status[..end]))
        .text("friction", &runs(&point.friction[..end]))
        .number("area", point.area)
        .raw("opening", &opening)
        .raw("pressure", &pressure)
        .raw("shear", &shear)
        .raw("slip", &slip)
        .raw("angle", &angle)
        .finish()
}

fn pairs(results: &Results) -> String {
    json::array(results.summary.list("pairs").iter().map(|pair| {
        let labels = |key: &str| -> Vec<String> {
            let all = pair.list(key).iter();
            all.filter_map(|label| match label {
                Value::Number(number) => Some(number.to_string()),
                _ => None,
            })
            .collect()
        };
        Object::new()
            .text("name", pair.text("name").unwrap_or("?"))
            .array("slave", labels("slave"))
            .text("master", pair.text("master").unwrap_or("?"))
            .array("nodes", labels("nodes"))
            .finish()
    }))
}

fn frames(results: &Results) -> String {
    let frames = &results.frames;
    let whole = |values: &[i64]| json::array(values.iter().map(i64::to_string));
    let moved = frames.displacement.iter().flatten().copied();
    Object::new()
        .raw("labels", &whole(&frames.labels))
        .raw("reference", &singles(frames.reference.iter().map(|x| *x as f32)))
        .raw("cells", &whole(&frames.cells))
        .array("kinds", frames.kinds.iter().map(i32::to_string))
        .raw("elements", &whole(&frames.elements))
        .array("states", frames.states.iter().map(usize::to_string))
        .raw("displacement", &singles(moved))
        .raw("sections", &singles(frames.sections.iter().flatten().copied()))
        .raw("strained", &strained(results))
        .finish()
}

/// The element with the largest fibre strain.
fn strained(results: &Results) -> String {
    let summary = results.summary.get("fibre_strain");
    let said = summary.and_then(|strain| strain.count("element"));
    said.map_or_else(|| "null".to_owned(), |element| element.to_string())
}

fn attempt(attempt: &super::iterations::Attempt) -> String {
    let iterations = attempt.iterations.iter().map(|iteration| {
        let flags = usize::from(iteration.severe) + 2 * usize::from(iteration.converged);
        let counts = [flags, iteration.changes, iteration.closed].map(|count| count.to_string());
        let residuals = [iteration.force, iteration.moment].concat();
        json::array(counts.into_iter().chain(residuals.into_iter().map(json::number)))
    });
    Object::new()
        .count("step", attempt.step)
        .count("increment", attempt.increment)
        .count("attempt", attempt.attempt)
        .optional_text("reason", attempt.reason.as_deref())
        .array("iterations", iterations)
        .finish()
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_text_ends_the_script() {
        let object = crate::json::Object::new().text("job", "</script><!--\u{2028}").finish();
        let safe = super::safe(&object);
        assert!(!safe.contains(['<', '>', '\u{2028}']), "{safe}");
        let back = super::super::value::Value::read(&safe).unwrap();
        assert_eq!(back.text("job"), Some("</script><!--\u{2028}"));
    }
}
