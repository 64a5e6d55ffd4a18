//! The page itself: what can be said in words stands in it as HTML, what is
//! drawn follows as data and script.

use super::data::data;
use super::options::Options;
use super::overlay::Overlay;
use super::results::Results;
use super::verdict;
use crate::json::{Members as _, Value};
use crate::number::general;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// Style sheet of the report, light, dark and on paper, for other pages that
/// shall look like it.
pub const STYLE: &str = include_str!("assets/page.css");
/// Nothing is loaded from anywhere.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'";
/// Scripts that draw the deformed shape, with their names, in the order in which they need one
/// another: classic scripts, for every page that has the report's elements and data.
pub const DRAWING: [(&str, &str); 3] = [
    ("drawing.js", include_str!("assets/drawing.js")),
    ("skin.js", include_str!("assets/skin.js")),
    ("shape.js", include_str!("assets/shape.js")),
];
/// What the report adds: its data, its charts, and what puts them on the page.
const SCRIPTS: [&str; 3] = [
    include_str!("assets/data.js"),
    include_str!("assets/chart.js"),
    include_str!("assets/page.js"),
];
const BODY: &str = include_str!("assets/body.html");

/// The whole page. `remarks` are what making it had to say.
pub(crate) fn page(
    job: &str,
    results: &Results,
    overlay: Option<&Overlay>,
    options: &Options<'_>,
    remarks: &[String],
) -> String {
    let judged = verdict::judged(results);
    let data = data(job, results, &judged, overlay);
    let head = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title(job, results)) " - slideline" }
                style { (PreEscaped(STYLE)) }
            }
        }
    };
    let head = head.into_string();
    let mut text = String::with_capacity(data.len() + (1 << 17));
    text.push_str(head.strip_suffix("</html>").unwrap_or(&head));
    text.push_str("\n<body>\n");
    let places = [
        ("remarks", html! { @for said in remarks { (note(said)) } }),
        ("verdict", verdict::banner(results, &judged)),
        ("facts", facts(results)),
        ("states", states(results)),
        ("along_link", html! { @if has_beams(results) { a href="#along" { "Along the beam" } } }),
        (
            "along",
            html! {
                @if has_beams(results) {
                    section id="along" { h2 { "Moment and stress along the beam" } div id="beams" {} }
                }
            },
        ),
        ("ledger", ledger(results)),
        ("noise", noise(results)),
        ("warnings", warnings(results, options)),
        ("notes", notes(results)),
        ("title", html! { (title(job, results)) }),
        ("settings", settings(results)),
        ("echo", html! { pre.echo { (results.echo) } }),
        ("job", html! { (job) }),
    ];
    let place = |name: &str| {
        let (_, content) = places.iter().find(|(own, _)| *own == name)?;
        Some(content.0.clone())
    };
    text.push_str(&filled(BODY, place));
    text.push_str(&format!("<script type=\"application/json\" id=\"data\">{data}</script>\n"));
    text.push_str("<script>\n\"use strict\";\n(function () {\n");
    DRAWING.iter().for_each(|(_, script)| text.push_str(script));
    SCRIPTS.iter().for_each(|script| text.push_str(script));
    text.push_str("})();\n</script>\n</body>\n</html>\n");
    text
}

/// Whether a beam is drawn.
fn has_beams(results: &Results) -> bool {
    results.frames.kinds.contains(&0)
}

/// Fills the places `{{name}}` of a template in one pass, so that what is filled in
/// is never searched for places. A place that nothing is known of stays.
pub fn filled(template: &str, content: impl Fn(&str) -> Option<String>) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, name, behind)) = next_place(rest) {
        text.push_str(before);
        match content(name) {
            Some(content) => text.push_str(&content),
            None => text.extend(["{{", name, "}}"]),
        }
        rest = behind;
    }
    text.push_str(rest);
    text
}

fn next_place(template: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = template.split_once("{{")?;
    let (name, behind) = rest.split_once("}}")?;
    Some((before, name, behind))
}

/// What the deck calls itself, its first line; the job's name where it has no
/// heading.
fn title(job: &str, results: &Results) -> String {
    let heading = results.summary.text("title").unwrap_or_default();
    let first = heading.lines().map(str::trim).find(|line| !line.is_empty());
    first.unwrap_or(job).to_owned()
}

fn note(said: &str) -> Markup {
    html! { p.remark { (said) } }
}

/// Version, deck, dialect: what a reader must know to repeat the run.
fn facts(results: &Results) -> Markup {
    let summary = &results.summary;
    let text = |key: &str| summary.text(key).unwrap_or("-").to_owned();
    let seconds =
        summary.number("wall_seconds").map_or("-".to_owned(), |s| general(s, 3).to_string());
    let facts = [
        ("program", format!("slideline {}", text("program_version"))),
        ("deck (SHA-256)", text("deck_hash")),
        ("dialect", text("dialect")),
        ("friction onset", text("friction_onset")),
        ("wall time", format!("{seconds} s")),
    ];
    html! { dl.facts { @for (name, value) in facts { dt { (name) } dd { (value) } } } }
}

/// Which increments the shape can be drawn at, where it is not all of them.
fn states(results: &Results) -> Markup {
    let (written, count) = (&results.frames.written, results.energies.times.len());
    if written.is_empty() {
        return note("The deck asked for no states, so there is no shape to draw.");
    }
    if written.len() > count {
        return html! {};
    }
    let after: Vec<String> = written.iter().filter(|n| **n > 0).map(usize::to_string).collect();
    let list = match after.len() {
        0..=24 => after.join(", "),
        many => format!("{}, ..., {}", after[..20].join(", "), after[many - 1]),
    };
    note(&format!(
        "States were written for {} of {count} converged increments, as FREQUENCY asks (counted \
         over all steps: {list}); the shape is drawn at those, curves have every increment.",
        after.len()
    ))
}

fn table(heading: &[&str], rows: &[Vec<String>]) -> Markup {
    html! {
        div.wide {
            table {
                thead { tr { @for head in heading { th { (head) } } } }
                tbody { @for row in rows { tr { @for cell in row { td { (cell) } } } } }
            }
        }
    }
}

/// Friction that acted, and friction that the onset did not call.
fn ledger(results: &Results) -> Markup {
    let energy = |name: &str| results.energies.last(name).unwrap_or(0.0);
    let dropped = results.summary.get("dropped_friction");
    let count = |friction: char| -> usize {
        let letters = results.contacts.points.iter().flat_map(|point| point.friction.chars());
        letters.filter(|letter| *letter == friction).count()
    };
    let points = dropped.and_then(|d| d.count("point_increments")).unwrap_or_else(|| count('d'));
    let (lost, done) = (energy("dropped_friction"), energy("friction_dissipation"));
    let share = if lost + done > 0.0 { 100.0 * lost / (lost + done) } else { 0.0 };
    let number = |value: f64| general(value, 6);
    let rows = [
        vec!["friction dissipated".to_owned(), number(done).to_string()],
        vec![
            "stored in elastic slip at the end".to_owned(),
            number(energy("friction_elastic")).to_string(),
        ],
        vec!["point-increments with friction called".to_owned(), count('c').to_string()],
        vec!["point-increments with friction dropped".to_owned(), points.to_string()],
        vec![
            "friction work dropped".to_owned(),
            format!("{} ({} % of dropped and dissipated)", number(lost), general(share, 3)),
        ],
    ];
    let said = match points {
        0 => "Friction was called at every closed point that has any.",
        _ => "Closed points went without friction (SL0601): the forces lack it.",
    };
    html! { p { (said) } (table(&["entry", "value"], &rows)) }
}

/// Noise of the driven reactions and of the contact pairs.
fn noise(results: &Results) -> Markup {
    let Some(noise) = results.summary.get("noise") else {
        return html! { p { "The summary holds no measures of noise." } };
    };
    let cell =
        |value: Option<f64>| value.map_or("-".to_owned(), |value| general(value, 3).to_string());
    let percent = |value: Option<f64>| cell(value.map(|value| 100.0 * value));
    let reactions: Vec<Vec<String>> = results
        .driven
        .iter()
        .map(|driven| format!("{}.{}", driven.name, driven.reaction))
        .filter_map(|name| Some((noise.get("reactions")?.get(&name)?, name)))
        .map(|(reaction, name)| {
            let turns = reaction.count("reversals").unwrap_or_default();
            vec![name, percent(reaction.number("roughness")), turns.to_string()]
        })
        .collect();
    let pairs: Vec<Vec<String>> = noise
        .list("pairs")
        .iter()
        .map(|pair| {
            let number = |key: &str| cell(pair.number(key));
            vec![
                pair.text("name").unwrap_or("?").to_owned(),
                number("changes_per_increment"),
                number("penetration"),
                number("penetration_over_c0"),
                number("force_imbalance"),
                number("moment_imbalance"),
            ]
        })
        .collect();
    let of_reactions = ["driven reaction", "roughness, % of peak", "reversals"];
    let of_pairs = [
        "contact pair",
        "contact changes per increment",
        "deepest penetration",
        "in c0",
        "forces left over",
        "moments left over",
    ];
    html! {
        @if !reactions.is_empty() { (table(&of_reactions, &reactions)) }
        @if !pairs.is_empty() { (table(&of_pairs, &pairs)) }
        @if reactions.is_empty() && pairs.is_empty() {
            p { "Nothing is driven and nothing touches." }
        }
    }
}

/// What was said before, during and after the run and may matter.
fn warnings(results: &Results, options: &Options<'_>) -> Markup {
    let summary = &results.summary;
    let list = |key: &str, severity| summary.list(key).iter().map(move |said| (severity, said));
    let diagnosis = summary.get("diagnosis").map(|said| ("error", said));
    let all: Vec<(&str, &Value)> = diagnosis
        .into_iter()
        .chain(list("warnings", "warning"))
        .chain(list("advice", "advice"))
        .collect();
    let mut told: Vec<&str> = Vec::new();
    let mut page_of = |code| {
        let first = !told.contains(&code);
        told.push(code);
        (options.page)(code).filter(|_| first)
    };
    html! {
        @if all.is_empty() { p { "No warning before, during or after the run." } }
        @for (severity, said) in all {
            @let code = said.text("code").unwrap_or("?");
            div class=(format!("said {severity}")) {
                p {
                    strong { (severity) " " (code) }
                    (place(said)) ": " (said.text("message").unwrap_or_default())
                }
                @if let Some(help) = said.text("help") { p { "What to do: " (help) } }
                @if let Some(page) = page_of(code) {
                    details { summary { "The page of " (code) } (PreEscaped(page)) }
                }
            }
        }
    }
}

fn place(said: &Value) -> Markup {
    html! {
        @if let (Some(file), Some(line)) = (said.text("file"), said.count("line")) {
            " " span.place { (file) ":" (line) }
        }
    }
}

/// Trivial things, one line each.
fn notes(results: &Results) -> Markup {
    let notes = results.summary.list("notes");
    html! {
        @if notes.is_empty() { p { "None." } } @else {
            ul {
                @for said in notes {
                    li {
                        (said.text("code").unwrap_or("?")) (place(said)) ": "
                        (said.text("message").unwrap_or_default())
                    }
                }
            }
        }
    }
}

fn settings(results: &Results) -> Markup {
    let settings = results.summary.list("settings");
    html! {
        @if settings.is_empty() { p { "The summary lists no settings." } } @else {
            div.wide {
                table {
                    thead { tr { th { "card" } th { "setting" } th { "value that ruled" } th { "it is the" } } }
                    tbody {
                        @for own in settings {
                            tr {
                                @for key in ["card", "name", "value"] {
                                    td { (own.text(key).unwrap_or_default()) }
                                }
                                @if own.flag("default") { td.default { "default" } }
                                @else { td { "deck or command line" } }
                            }
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: names are escaped everywhere, and a name that looks like
    /// a place of the template is only a name.
    #[test]
    fn what_is_filled_in_is_not_filled_again() {
        let place = |name: &str| match name {
            "a" => Some("{{b}}".to_owned()),
            "b" => Some("x".to_owned()),
            _ => None,
        };
        assert_eq!(filled("<{{a}}{{b}}{{c}}>", place), "<{{b}}x{{c}}>");
    }
}
