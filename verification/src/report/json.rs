//! The record of a claim as JSON.

use crate::claim::Outcome;
use crate::record::{Chart, Measured};
use slideline::output::json::{Value, json, text};
use slideline::output::plot::Panel;

pub(super) fn record(outcome: &Outcome) -> String {
    let claim = &outcome.claim;
    let record = &outcome.record;
    let object = json!({
        "schema": 1,
        "claim": outcome.id(),
        "chapter": outcome.chapter,
        "requirement": claim.requirement,
        "source": claim.source,
        "tolerance": claim.tolerance,
        "holds": outcome.holds(),
        "broken": outcome.broken,
        "measured": record.measured().iter().map(measured).collect::<Value>(),
        "charts": record.charts().iter().map(chart).collect::<Value>(),
    });
    text(&object) + "\n"
}

fn measured(one: &Measured) -> Value {
    json!({
        "quantity": one.quantity,
        "value": one.value,
        "required": one.required(),
        "holds": one.holds(),
    })
}

fn chart(chart: &Chart) -> Value {
    json!({"title": chart.title, "panels": chart.panels.iter().map(panel).collect::<Value>()})
}

fn panel(panel: &Panel) -> Value {
    let series = panel.series.iter().map(|own| json!({"name": own.name, "points": own.points}));
    json!({"x": panel.x.title, "y": panel.y.title, "series": series.collect::<Value>()})
}
