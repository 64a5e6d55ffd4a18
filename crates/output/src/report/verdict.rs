//! The verdict in words: what a designer wants to know first.

use super::results::Results;
use crate::json::Members as _;
use crate::number::general;
use crate::reading::summary::Driven;
use crate::verdict::{Judged, is_locked, judge};
use maud::{Markup, html};
use slideline_measures::{Colour, Stroke, Taken, WayOut};

/// Judges the results that were read back.
pub(crate) fn judged(results: &Results) -> Judged {
    judge(&results.summary, Some(&results.energies), |driven| results.history.stroke(driven))
}

/// The verdict in short sentences, the first on how the run ended.
pub(crate) fn sentences(results: &Results, judged: &Judged) -> Vec<String> {
    let mut said = vec![ending(results)];
    let verdict = &judged.verdict;
    let reasons: Vec<&str> = verdict.reasons.iter().map(|(_, reason)| reason.as_str()).collect();
    said.push(match reasons.is_empty() {
        true => format!("verdict {}", verdict.colour.word()),
        false => format!("verdict {} ({})", verdict.colour.word(), reasons.join("; ")),
    });
    if let Some((driven, stroke)) = judged.strokes.first() {
        said.extend(of_stroke(results, driven, stroke));
        match judged.strokes.len() - 1 {
            0 => {}
            1 => said.push("another driven motion is shown below".to_owned()),
            more => said.push(format!("{more} further driven motions are shown below")),
        }
    } else if results.driven.is_empty() {
        said.push("no node is driven, so there is no force in or out".to_owned());
    }
    said.push(strain(results));
    said.iter().map(|sentence| capital(sentence)).collect()
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn ending(results: &Results) -> String {
    let summary = &results.summary;
    let count = |key: &str| summary.count(key).unwrap_or_default();
    let (increments, cutbacks) = (results.energies.times.len(), count("cutbacks"));
    let cutbacks = match cutbacks {
        0 => "no cutback".to_owned(),
        1 => "1 cutback".to_owned(),
        many => format!("{many} cutbacks"),
    };
    let plural = if increments == 1 { "" } else { "s" };
    let counts =
        format!("{increments} increment{plural}, {} iterations, {cutbacks}", count("iterations"));
    let diagnosis = summary.get("diagnosis");
    let because = diagnosis.map_or_else(String::new, |said| {
        let (code, message) = (said.text("code"), said.text("message"));
        format!(" because {} ({})", message.unwrap_or("?"), code.unwrap_or("?"))
    });
    match summary.text("status").unwrap_or_default() {
        "completed" => format!("Completed: {counts}"),
        "not_converged" => format!("Not converged{because}; kept are {counts}"),
        "interrupted" => format!("Interrupted on request; kept are {counts}"),
        "output_error" => format!("Results could not be written to the end; kept are {counts}"),
        "running" => {
            format!("Not finished: running or killed; written so far are {increments} increments")
        }
        _ => format!("Ended by a fault of the program{because}; kept are {counts}"),
    }
}

fn number(value: f64) -> String {
    general(value, 4).to_string()
}

fn of_stroke(results: &Results, driven: &Driven, stroke: &Stroke) -> Vec<String> {
    let Driven { motion, reaction, .. } = driven;
    let who = driven.words();
    let kind = kind(driven);
    let taken =
        |taken: &Taken| format!("{} at {motion} = {}", number(taken.force), number(taken.at));
    let mut said = vec![match &stroke.push {
        Some(found) => format!("push-in {kind} {} ({who}, {reaction})", taken(found)),
        None => format!("no push-in {kind} ({who}, {reaction})"),
    }];
    if stroke.way_out == WayOut::None {
        said.push(format!("work in {}", number(stroke.work[0])));
        said.push(locking(results, stroke));
        return said;
    }
    said.push(match &stroke.pull {
        Some(found) => format!("pull-out {kind} {}", taken(found)),
        None => format!("no pull-out {kind}"),
    });
    said.push(format!("work in {}, work out {}", number(stroke.work[0]), number(stroke.work[1])));
    said.push(way_out(driven, stroke));
    said.push(locking(results, stroke));
    said
}

fn kind(driven: &Driven) -> &'static str {
    if driven.reaction.starts_with("RM") { "moment" } else { "force" }
}

/// How it comes out, once it comes out.
fn way_out(driven: &Driven, stroke: &Stroke) -> String {
    match stroke.way_out {
        WayOut::Pulled => "it must be pulled all the way out".to_owned(),
        WayOut::PulledUntil(at) => {
            format!(
                "it must be pulled until {} = {}, then it goes by itself",
                driven.motion,
                number(at)
            )
        }
        WayOut::SpringsBack => "it springs back by itself".to_owned(),
        _ => "the way out has no reaction".to_owned(),
    }
}

/// Why there is no force out.
fn no_way_out(results: &Results) -> &'static str {
    match results.summary.text("status") {
        Some("completed") => "the deck has no way out",
        _ => "the run did not get to a way out",
    }
}

/// Self-locking as designers mean it: it cannot be pulled out.
fn locking(results: &Results, stroke: &Stroke) -> String {
    let reached = stroke.pull.map_or(0.0, |pull| pull.force);
    if is_locked(&results.summary, stroke) {
        let reached = number(reached);
        return format!("self-locking: it cannot be pulled out; the pull had reached {reached}");
    }
    match (stroke.held_at_the_end, stroke.way_out) {
        (true, _) => {
            "it had not come out when the run ended, with the pull still growing: whether \
                      it is self-locking is not known"
                .to_owned()
        }
        (_, WayOut::None) => {
            let why = no_way_out(results);
            format!("{why}, so pull-out force and self-locking are not known")
        }
        (_, WayOut::NoReaction) => "self-locking is not known".to_owned(),
        _ => "not self-locking".to_owned(),
    }
}

fn strain(results: &Results) -> String {
    match largest_strain(results) {
        Some((value, element, time)) if value > 0.0 => format!(
            "largest fibre strain {} % in element {element} at time {}{}",
            general(100.0 * value, 4),
            general(time, 5),
            share(results)
        ),
        _ => solids(results).unwrap_or_else(|| "no beam is strained".to_owned()),
    }
}

/// Largest stress and plastic strain of solids.
fn solids(results: &Results) -> Option<String> {
    let (most, element, time) = largest(results, "mises")?;
    let mut said = format!(
        "largest Mises stress {} in element {element} at time {}",
        number(most),
        general(time, 5)
    );
    if let Some((plastic, element, _)) = largest(results, "plastic_strain") {
        said.push_str(&format!(
            ", largest plastic strain {} % in element {element}",
            general(100.0 * plastic, 4)
        ));
    }
    if let Some((strain, element, _)) = largest(results, "principal_strain") {
        let strain = general(100.0 * strain, 4);
        said.push_str(&format!(", largest principal strain {strain} % in element {element}"));
    }
    said.push_str(&share(results));
    Some(said)
}

/// How much of the allowable is used, where there is one.
fn share(results: &Results) -> String {
    allowable(results).map_or_else(String::new, |(used, pass)| {
        let (used, end) = (percent(used), if pass { "pass" } else { "FAIL" });
        format!(", {used} % of the allowable: {end}")
    })
}

/// A largest value of the summary, with element and time.
fn largest(results: &Results, key: &str) -> Option<(f64, usize, f64)> {
    let own = results.summary.get(key)?;
    Some((own.number("max")?, own.count("element")?, own.number("time")?))
}

/// Largest strain over the allowable one, and whether that passes.
fn allowable(results: &Results) -> Option<(f64, bool)> {
    let used = results.summary.get("allowable")?;
    Some((used.number("utilisation")?, used.flag("pass")))
}

fn largest_strain(results: &Results) -> Option<(f64, usize, f64)> {
    let said = results.summary.get("fibre_strain").and_then(|strain| {
        Some((strain.number("max")?, strain.count("element")?, strain.number("time")?))
    });
    said.or_else(|| {
        let (value, element, state) = results.frames.strain?;
        let time = state.checked_sub(1).and_then(|place| results.energies.times.get(place));
        Some((value, usize::try_from(element).ok()?, time.copied().unwrap_or(0.0)))
    })
}

/// What a colour means.
pub(crate) fn headline(colour: Colour) -> &'static str {
    match colour {
        Colour::Green => "Green: the numbers can be trusted",
        Colour::Amber => "Amber: look at the reasons before you use the numbers",
        Colour::Red => "Red: do not use the numbers",
    }
}

/// The verdict as it stands at the top of the page: colour, reasons, numbers.
pub(crate) fn banner(results: &Results, judged: &Judged) -> Markup {
    let verdict = &judged.verdict;
    let word = verdict.colour.word();
    let words = sentences(results, judged);
    let first = words.first().map_or("", String::as_str);
    let rest: Vec<&str> = words.iter().skip(2).map(String::as_str).collect();
    html! {
        div id="verdict" class=(format!("verdict {word}")) {
            p.colour { span.lamp aria-hidden="true" {} strong { (headline(verdict.colour)) } }
            @if !verdict.reasons.is_empty() {
                ul {
                    @for (colour, reason) in &verdict.reasons {
                        li class=(colour.word()) { (capital(reason)) }
                    }
                }
            }
            p { (first) "." }
        }
        (tiled(&tiles(results, judged)))
        p.words { (rest.join(". ")) "." }
    }
}

/// Big numbers: forces in and out, their ratio, normal force, work, strain.
pub(crate) fn tiles(results: &Results, judged: &Judged) -> Vec<[String; 3]> {
    let mut list: Vec<[String; 3]> = Vec::new();
    if let Some((driven, stroke)) = judged.strokes.first() {
        let kind = kind(driven);
        let taken = |taken: Option<Taken>, without: &str| match taken {
            Some(t) => (number(t.force), format!("at {} = {}", driven.motion, number(t.at))),
            None => ("none".to_owned(), without.to_owned()),
        };
        let (value, note) = taken(stroke.push, "the driver holds it back");
        list.push([format!("push-in {kind}"), value, note]);
        if stroke.way_out == WayOut::None {
            list.push([format!("pull-out {kind}"), "-".into(), no_way_out(results).into()]);
        } else {
            let (value, note) = taken(stroke.pull, "it comes out by itself");
            list.push([format!("pull-out {kind}"), value, note]);
        }
        if let Some(ratio) = stroke.ratio() {
            list.push([
                "out / in".into(),
                general(ratio, 3).to_string(),
                "pull-out over push-in".into(),
            ]);
        }
        let out = match stroke.way_out {
            WayOut::None => String::new(),
            _ => format!("out {}", number(stroke.work[1])),
        };
        list.push(["work in".to_owned(), number(stroke.work[0]), out]);
    }
    if let Some(normal) = results.summary.get("normal_force") {
        let force = normal.number("max").unwrap_or(f64::NAN);
        let pair = normal.text("pair").unwrap_or("?");
        list.push(["largest normal force".to_owned(), number(force), format!("pair {pair}")]);
    }
    if let Some((value, element, _)) = largest_strain(results).filter(|(value, ..)| *value > 0.0) {
        let strain = format!("{} %", general(100.0 * value, 3));
        list.push(["largest strain".to_owned(), strain, margin(results, element)]);
    }
    list.extend(tiles_of_solids(results));
    list
}

fn tiled(list: &[[String; 3]]) -> Markup {
    html! {
        dl.tiles {
            @for [name, value, note] in list {
                div class=[note.ends_with("FAIL").then_some("fail")] {
                    dt { (name) }
                    dd { b { (value) } small { (note) } }
                }
            }
        }
    }
}

/// The same of solids: stress and plastic strain.
fn tiles_of_solids(results: &Results) -> impl Iterator<Item = [String; 3]> {
    let kinds = [
        ("mises", "largest Mises stress", 1.0, ""),
        ("plastic_strain", "largest plastic strain", 100.0, " %"),
        ("principal_strain", "largest principal strain", 100.0, " %"),
    ];
    let has_beams = largest_strain(results).is_some_and(|(value, ..)| value > 0.0);
    kinds.into_iter().filter_map(move |(key, name, factor, unit)| {
        let (most, element, _) = largest(results, key)?;
        let value = format!("{}{unit}", general(factor * most, 4));
        // said once: of the beams where there are some
        let is_judged = key == "mises" && allowable(results).is_some() && !has_beams;
        let note = if is_judged { margin(results, element) } else { format!("element {element}") };
        Some([name.to_owned(), value, note])
    })
}

/// A share in percent to three digits; whole from a thousand on, as people write it.
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if (1e3..1e6).contains(&value.abs()) {
        format!("{value:.0}")
    } else {
        general(value, 3).to_string()
    }
}

/// The margin to the allowable, where there is one.
fn margin(results: &Results, element: usize) -> String {
    match allowable(results) {
        Some((used, pass)) => format!(
            "{} % of the allowable, margin {} %: {}",
            percent(used),
            percent(1.0 / used - 1.0),
            if pass { "pass" } else { "FAIL" }
        ),
        None => format!("element {element}; no allowable is given"),
    }
}
