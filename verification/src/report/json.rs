//! The record of a claim as JSON.

use crate::claim::Outcome;
use crate::record::{Chart, Measured};
use slideline::output::json::{Object, array, number};
use slideline::output::plot::Panel;

pub(super) fn record(outcome: &Outcome) -> String {
    let claim = &outcome.claim;
    let record = &outcome.record;
    let mut text = Object::new()
        .count("schema", 1)
        .text("claim", &outcome.id())
        .text("chapter", outcome.chapter)
        .text("requirement", claim.requirement)
        .text("source", claim.source)
        .text("tolerance", claim.tolerance)
        .flag("holds", outcome.holds())
        .optional_text("broken", outcome.broken.as_deref())
        .array("measured", record.measured().iter().map(measured))
        .array("charts", record.charts().iter().map(chart))
        .finish();
    text.push('\n');
    text
}

fn measured(one: &Measured) -> String {
    Object::new()
        .text("quantity", &one.quantity)
        .number("value", one.value)
        .text("required", &one.required())
        .flag("holds", one.holds())
        .finish()
}

fn chart(chart: &Chart) -> String {
    Object::new()
        .text("title", &chart.title)
        .array("panels", chart.panels.iter().map(panel))
        .finish()
}

fn panel(panel: &Panel) -> String {
    let series = panel.series.iter().map(|series| {
        let points = series.points.iter().map(|[x, y]| array([number(*x), number(*y)]));
        Object::new().text("name", &series.name).array("points", points).finish()
    });
    Object::new()
        .text("x", &panel.x.title)
        .text("y", &panel.y.title)
        .array("series", series)
        .finish()
}
