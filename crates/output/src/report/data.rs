//! What the charts of the page draw, as JSON that may stand in a script.

use super::contact::{Contacts, Point, letters, runs, shown};
use super::iterations::Attempt;
use super::overlay::Overlay;
use super::results::Results;
use super::skin::Triangle;
use crate::json::{Map, Members as _, Value, json, text};
use crate::reading::history::with_start;
use crate::reading::summary::Driven;
use crate::verdict::Judged;
use base64::{Engine as _, engine::general_purpose::STANDARD};
use slideline_solve::observe::{ContactRow, Frame};

/// All numbers of the page.
pub(crate) fn data(
    job: &str,
    results: &Results,
    judged: &Judged,
    overlay: Option<&Overlay>,
) -> String {
    let Results { energies, contacts, .. } = results;
    let numbers = |place: usize| -> Vec<f64> {
        with_start(&energies.numbers.iter().map(|own| own[place] as f64).collect::<Vec<_>>())
    };
    let pairs = |list: &[(String, Vec<f64>)]| columns(list.iter().map(|(n, own)| (n, &own[..])));
    let energy = energies.columns.iter().zip(energies.values.iter().map(Vec::as_slice));
    let loaded = results.loaded.iter();
    let object = json!({
        "job": job,
        "times": doubles(&with_start(&energies.times)),
        "step": doubles(&numbers(0)),
        "increment": doubles(&numbers(1)),
        "driven": driven(results, judged),
        "supports": supports(results),
        "heights": heights(results),
        "loaded": loaded
            .map(|(node, name, way)| json!({"node": node, "name": name, "motion": way}))
            .collect::<Value>(),
        "history": history(results),
        "energy": columns(energy),
        "stride": contacts.stride,
        "contact": contacts.points.iter().map(|own| point(contacts, own)).collect::<Value>(),
        "pairs": self::pairs(results),
        "frames": frames(results),
        "attempts": results.attempts.iter().map(attempt).collect::<Value>(),
        "overlay": overlay.map(|own| json!({"name": own.name, "columns": pairs(&own.columns)})),
    });
    safe(&text(&object))
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
    STANDARD.encode(values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>())
}

/// Single precision where a picture is made of it.
fn singles(values: impl Iterator<Item = f32>) -> String {
    STANDARD.encode(values.flat_map(f32::to_le_bytes).collect::<Vec<u8>>())
}

fn columns<'a>(columns: impl Iterator<Item = (&'a String, &'a [f64])>) -> Map<String, Value> {
    columns.map(|(name, values)| (name.clone(), doubles(values).into())).collect()
}

/// Driven motions, that which does most work first, with the places of the
/// largest push and pull.
fn driven(results: &Results, judged: &Judged) -> Value {
    let moved = judged.strokes.iter().map(|(driven, stroke)| (driven, Some(stroke)));
    let known = |driven: &Driven| judged.strokes.iter().any(|(own, _)| own == driven);
    let still = results.driven.iter().filter(|driven| !known(driven)).map(|driven| (driven, None));
    let all = moved.chain(still).map(|(driven, stroke)| {
        json!({
            "node": driven.nodes.first(),
            "who": driven.words(),
            "nodes": driven.nodes.len(),
            "force": of_stroke(results, driven, 1),
            "travel": of_stroke(results, driven, 0).filter(|_| !driven.along.is_empty()),
            "motion": driven.motion,
            "reaction": driven.reaction,
            "inward": stroke.map_or(1.0, |stroke| stroke.inward),
            "push": stroke.and_then(|stroke| stroke.push).map(|taken| taken.place),
            "pull": stroke.and_then(|stroke| stroke.pull).map(|taken| taken.place),
        })
    });
    all.collect()
}

/// The motion (0) of what is driven, or what all its nodes are driven with (1), from the first increment on;
/// none of a single node along an axis of the model, whose columns stand among the histories.
fn of_stroke(results: &Results, driven: &Driven, which: usize) -> Option<String> {
    let is_told = driven.nodes.len() > 1 || !driven.along.is_empty();
    let stroke = results.history.stroke(driven).filter(|_| is_told)?;
    Some(doubles(stroke[which].get(1..)?))
}

/// Held nodes with the numbers of their dofs.
fn supports(results: &Results) -> Value {
    let held = results.summary.list("supports").iter();
    held.map(|held| json!({"node": held["node"], "dofs": held["dofs"]})).collect()
}

/// Height of the section of every cell; zero for what is no beam.
fn heights(results: &Results) -> String {
    let sections = results.summary.list("sections");
    let number = |value: &Value| value.as_f64().unwrap_or_default() as i64;
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

fn history(results: &Results) -> Value {
    let shown = |node: u64| {
        let driven = results.driven.iter().any(|own| own.nodes.first() == Some(&node));
        driven || results.loaded.iter().any(|load| load.0 == node)
    };
    let nodes = results.history.nodes.iter().filter(|own| shown(own.node)).map(|node| {
        let values = node.values.iter().map(Vec::as_slice);
        json!({"node": node.node, "columns": columns(results.history.columns.iter().zip(values))})
    });
    nodes.collect()
}

fn point(contacts: &Contacts, point: &Point) -> Value {
    let end = point.closed_until();
    let [opening, pressure, shear, slip, angle] =
        contacts.numbers(point).map(|column| singles(column.iter().copied()));
    json!({
        "pair": point.pair,
        "node": point.node,
        "first": point.first,
        "status": runs(&point.status[..end]),
        "friction": runs(&point.friction[..end]),
        "area": point.area,
        "opening": opening,
        "pressure": pressure,
        "shear": shear,
        "slip": slip,
        "angle": angle,
    })
}

fn pairs(results: &Results) -> Value {
    let pairs = results.summary.list("pairs").iter().map(|pair| {
        json!({
            "name": pair.text("name").unwrap_or("?"),
            "slave": pair.list("slave"),
            "master": pair.text("master").unwrap_or("?"),
            "nodes": pair.list("nodes"),
        })
    });
    pairs.collect()
}

fn frames(results: &Results) -> Value {
    let frames = &results.frames;
    let strained = results.summary.get("fibre_strain");
    json!({
        "labels": frames.labels,
        "reference": singles(frames.reference.iter().map(|x| *x as f32)),
        "cells": frames.cells,
        "kinds": frames.kinds,
        "elements": frames.elements,
        "states": frames.states,
        "displacement": singles(frames.displacement.iter().flatten().copied()),
        "sections": singles(frames.sections.iter().flatten().copied()),
        "skin": skin(&frames.skin),
        "changed": frames.changed,
        "changes": frames.changes.iter().map(|own| {
            json!({"skin": skin(&own.skin), "gone": frames.gone(own)})
        }).collect::<Value>(),
        "space": frames.in_space,
        "depth": singles(frames.depth.iter().map(|z| *z as f32)),
        "depth_moved": singles(frames.depth_moved.iter().flatten().copied()),
        "fields": fields(results),
        "strained": strained.and_then(|strain| strain.count("element")),
    })
}

/// Triangles: their points and a mark.
fn skin(triangles: &[Triangle]) -> String {
    singles(triangles.iter().flat_map(|(points, mark)| {
        let [a, b, c] = points.map(|point| point as f32);
        [a, b, c, f32::from(*mark)]
    }))
}

/// What the surface of solids can be coloured by: nodal values, frame by frame. Plastic strain
/// where there is some.
fn fields(results: &Results) -> Value {
    let names = ["Mises stress", "equivalent plastic strain"];
    let all = names.into_iter().zip(&results.frames.values).filter(|(name, values)| {
        let some = values.iter().flatten().any(|value| *value > 0.0);
        some || *name == names[0] && !values.is_empty()
    });
    let field = |(name, values): (&str, &Vec<Vec<f32>>)| json!({"name": name, "values": singles(values.iter().flatten().copied())});
    all.map(field).collect()
}

/// One state, to be put behind those that [`data`] told: its shape, and the contact points of its
/// frame.
pub(crate) fn state(results: &Results, frame: &Frame<'_>) -> Value {
    let frames = &results.frames;
    let last = |list: &[Vec<f32>]| list.last().map(|own| singles(own.iter().copied()));
    let told = |row: &ContactRow| {
        let [status, friction] = letters(row);
        json!({
            "pair": frame.model.contact_pairs[row.pair].name,
            "node": frame.model.nodes.label(row.node),
            "status": status.to_string(),
            "friction": friction.to_string(),
            "area": row.area,
            "values": shown(row).map(|value| f64::from(value as f32)),
        })
    };
    let contact = frame.contact.iter().filter(|row| row.ever_closed);
    json!({
        "state": frames.states.last(),
        "displacement": last(&frames.displacement),
        "sections": last(&frames.sections),
        "depth_moved": last(&frames.depth_moved),
        "fields": frames.values.iter().filter_map(|own| last(own)).collect::<Value>(),
        "changed": frames.changed.last(),
        "contact": contact.map(told).collect::<Value>(),
    })
}

fn attempt(attempt: &Attempt) -> Value {
    let iterations = attempt.iterations.iter().map(|own| {
        let flags = usize::from(own.severe) + 2 * usize::from(own.converged);
        let ([force, most_force], [moment, most_moment]) = (own.force, own.moment);
        json!([flags, own.changes, own.closed, force, most_force, moment, most_moment])
    });
    json!({
        "step": attempt.step,
        "increment": attempt.increment,
        "attempt": attempt.attempt,
        "reason": attempt.reason,
        "iterations": iterations.collect::<Value>(),
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_text_ends_the_script() {
        let object = serde_json::json!({"job": "</script><!--\u{2028}"});
        let safe = super::safe(&object.to_string());
        assert!(!safe.contains(['<', '>', '\u{2028}']), "{safe}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&safe).unwrap(), object);
    }
}
