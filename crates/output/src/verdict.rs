//! The verdict of a run: its files held against the table of rules in
//! [`slideline_measures::verdict`].
//!
//! ```text
//!   JOB.json  JOB.energy.csv  JOB.history.csv --> RunMeasures --> colour, reasons
//!                                             `-> strokes  --> forces in and out
//! ```

use crate::job::JobFiles;
use crate::json::{Members as _, Value, json};
use crate::reading::history::{Energies, History};
use crate::reading::summary::{Driven, driven, raw};
use slideline_measures::{RunMeasures, Stroke, Taken, Verdict, WayOut, stroke, verdict};

/// Codes of advice that cast no doubt, or that the measures of the run decide:
/// a start within the layer of a softened law, bodies that contact will hold,
/// noise, hand-over from node to node, penetration.
const NO_DOUBT: [&str; 5] = ["SL0402", "SL0414", "SL0610", "SL0611", "SL0612"];
/// A warning whose measure is a row of the table itself.
const MEASURED: &str = "SL0613";
/// Diagnosis of a contact that jams.
const JAM: &str = "SL0506";

/// A verdict with the strokes that belong to it.
#[derive(Clone, Debug)]
pub(crate) struct Judged {
    /// Colour and reasons.
    pub verdict: Verdict,
    /// Every driven motion that moves, the one that does most work first.
    pub strokes: Vec<(Driven, Stroke)>,
}

/// Judges a run by what its files say. `curve` gives motion and reaction of a
/// driven node from the start on.
pub(crate) fn judge(
    summary: &Value,
    energies: Option<&Energies>,
    mut curve: impl FnMut(&Driven) -> Option<[Vec<f64>; 2]>,
) -> Judged {
    let mut strokes: Vec<(Driven, Stroke)> = driven(summary)
        .into_iter()
        .filter_map(|driven| {
            let [motion, reaction] = curve(&driven)?;
            Some((driven, stroke(&motion, &reaction)?))
        })
        .collect();
    // what does most work is what the part is about
    strokes.sort_by(|a, b| size(&b.1).total_cmp(&size(&a.1)));
    let verdict = verdict(&measures(summary, energies, strokes.first().map(|(_, own)| own)));
    Judged { verdict, strokes }
}

/// Work of the driver, both ways counted [F L].
fn size(stroke: &Stroke) -> f64 {
    stroke.work[0].abs() + stroke.work[1].abs()
}

fn measures(summary: &Value, energies: Option<&Energies>, first: Option<&Stroke>) -> RunMeasures {
    let noise = summary.get("noise");
    let pairs = noise.map_or(&[][..], |noise| noise.list("pairs"));
    let largest = |key: &str| pairs.iter().filter_map(|pair| pair.number(key)).reduce(worse);
    let imbalance = [largest("force_imbalance"), largest("moment_imbalance")];
    let strains = ["fibre_strain", "principal_strain"];
    let strains = strains.iter().filter_map(|key| summary.get(key)?.number("max"));
    let rounding = summary.number("energy_rounding").unwrap_or_default();
    let unsure = summary.number("energy_unsure").unwrap_or_default().max(rounding);
    // a stroke that works no more than that has forces of rounding, and no peak
    let first = first.filter(|own| size(own) > rounding);
    let peaks = first.map(|own| [own.push, own.pull]).into_iter().flatten().flatten();
    RunMeasures {
        unfinished: unfinished(summary),
        pair_imbalance: imbalance.into_iter().flatten().reduce(worse),
        energy: energies.and_then(|energies| out_of_balance(energies, unsure)),
        noise: driven(summary)
            .iter()
            .filter_map(|driven| {
                let name = format!("{}.{}", driven.name, driven.reaction);
                noise?.get("reactions")?.get(&name)?.number("of_mesh")
            })
            .reduce(worse),
        peak_step: peaks.map(|taken| taken.step).reduce(worse),
        strain: strains.reduce(worse),
        unstable: summary.get("unstable_strain").and_then(|own| own.number("max")),
        linear: summary.get("linear_motion").and_then(|own| own.number("max")),
        utilisation: summary.get("allowable").and_then(|used| used.number("utilisation")),
        penetration: largest("penetration_over_c0"),
        said: codes(summary, "warnings", &[MEASURED]),
        advised: codes(summary, "advice", &NO_DOUBT),
    }
}

/// The larger of two; what is no number is the worst.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

fn unfinished(summary: &Value) -> Option<String> {
    match summary.text("status").unwrap_or_default() {
        "completed" => None,
        "not_converged" => {
            let code = summary.get("diagnosis").and_then(|said| said.text("code"));
            let code = code.map_or_else(String::new, |code| format!(" ({code})"));
            Some(format!("not completed: an increment did not converge{code}"))
        }
        "interrupted" => Some("not completed: interrupted on request".to_owned()),
        "input_error" => Some("not run: the deck has errors".to_owned()),
        "output_error" => Some("not completed: results could not be written".to_owned()),
        "running" => Some("not completed: it runs, or was killed".to_owned()),
        _ => Some("not completed: the program failed".to_owned()),
    }
}

/// Codes of what the summary has under a key, without some.
fn codes(summary: &Value, key: &str, without: &[&str]) -> Vec<String> {
    let codes = summary.list(key).iter().filter_map(|said| said.text("code"));
    codes.filter(|code| !without.contains(code)).map(str::to_owned).collect()
}

/// Largest `balance` beyond what is of rounding over the largest energy that there was.
fn out_of_balance(energies: &Energies, rounding: f64) -> Option<f64> {
    let most = |column: &[f64]| column.iter().map(|value| value.abs()).reduce(worse);
    let balance = energies.column("balance").and_then(most)?;
    // what was dropped is in no balance
    let others = energies.columns.iter().zip(&energies.values);
    let others =
        others.filter(|(name, _)| !["balance", "dropped_friction"].contains(&name.as_str()));
    let scale = others.filter_map(|(_, values)| most(values)).fold(0.0, f64::max);
    let left = if balance <= rounding { 0.0 } else { balance };
    (scale > 0.0).then(|| left / scale)
}

/// What `JOB.json` says, with forces and verdict behind everything else; those
/// that were there are replaced.
pub(crate) fn attached(mut summary: Value, energies: &Energies, history: &History) -> Value {
    let judged = judge(&summary, Some(energies), |driven| history.stroke(driven));
    let forces = judged.strokes.iter().map(|(driven, stroke)| forces(driven, stroke));
    let reasons = judged.verdict.reasons.iter().map(|(_, reason)| reason.as_str());
    let verdict = json!({
        "colour": judged.verdict.colour.word(),
        "reasons": reasons.collect::<Value>(),
    });
    if let Some(members) = summary.as_object_mut() {
        for (key, value) in [("forces", forces.collect()), ("verdict", verdict)] {
            members.shift_remove(key);
            members.insert(key.to_owned(), value);
        }
    }
    summary
}

fn forces(driven: &Driven, stroke: &Stroke) -> Value {
    let taken = |taken: Option<Taken>| {
        taken.map(|taken| json!({"force": taken.force, "at": taken.at, "place": taken.place}))
    };
    json!({
        "node": driven.nodes.first(),
        "name": driven.name,
        "motion": driven.motion,
        "reaction": driven.reaction,
        "inward": stroke.inward,
        "push_in": taken(stroke.push),
        "pull_out": taken(stroke.pull),
        "ratio": stroke.ratio(),
        "work_in": stroke.work[0],
        "work_out": stroke.work[1],
        "way_out": way_out_word(stroke.way_out),
    })
}

fn way_out_word(way_out: WayOut) -> &'static str {
    match way_out {
        WayOut::None => "none",
        WayOut::NoReaction => "no_reaction",
        WayOut::Pulled => "pulled",
        WayOut::PulledUntil(_) => "pulled_until",
        WayOut::SpringsBack => "springs_back",
    }
}

/// Colour and reasons as `JOB.json` has them; none where the job has no verdict.
pub fn verdict_of(job: &JobFiles) -> Option<(String, Vec<String>)> {
    let summary = raw(job).ok()?;
    let verdict = summary.get("verdict")?;
    let reasons = verdict.list("reasons").iter().filter_map(Value::as_str).map(str::to_owned);
    Some((verdict.text("colour")?.to_owned(), reasons.collect()))
}

/// Whether the part is locked: the pull grew until the contact jammed.
pub(crate) fn is_locked(summary: &Value, stroke: &Stroke) -> bool {
    let code = summary.get("diagnosis").and_then(|said| said.text("code"));
    stroke.held_at_the_end && code == Some(JAM)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary(more: &str) -> Value {
        let text = format!("{{\"status\":\"completed\",\"warnings\":[],\"advice\":[]{more}}}");
        serde_json::from_str(&text).unwrap()
    }

    fn colour(summary: &Value, energies: Option<&Energies>) -> &'static str {
        judge(summary, energies, |_| None).verdict.colour.word()
    }

    /// Requirement: columns are found by their names; one that is not there
    /// is missing, one more does no harm and counts for the scale.
    #[test]
    fn energy_is_read_by_names() {
        let energies = |columns: &[(&str, f64)]| Energies {
            columns: columns.iter().map(|(name, _)| (*name).to_owned()).collect(),
            values: columns.iter().map(|(_, value)| vec![0.0, *value]).collect(),
            ..Energies::default()
        };
        let plain = energies(&[("external_work", -4.0), ("balance", 0.4), ("strain_energy", 1.0)]);
        assert_eq!(out_of_balance(&plain, 0.0), Some(0.1));
        let more = energies(&[("external_work", 1.0), ("balance", -0.4), ("released_energy", 8.0)]);
        assert_eq!(out_of_balance(&more, 0.0), Some(0.05));
        assert_eq!(out_of_balance(&energies(&[("external_work", 1.0)]), 0.0), None);
        assert_eq!(out_of_balance(&plain, 0.5), Some(0.0));
        let nan = energies(&[("external_work", 1.0), ("balance", f64::NAN)]);
        assert!(out_of_balance(&nan, 0.5).unwrap().is_nan());
        assert_eq!(colour(&summary(""), Some(&plain)), "amber");
        assert_eq!(colour(&summary(",\"energy_rounding\":0.5"), Some(&plain)), "green");
        assert_eq!(colour(&summary(",\"energy_unsure\":0.5"), Some(&plain)), "green");
        assert_eq!(colour(&summary(""), Some(&more)), "green");
    }

    /// Requirement: warnings and doubtful advice are amber, what the measures
    /// decide is not counted twice, and what did not complete is red.
    #[test]
    fn what_was_said_colours_the_verdict() {
        let said = |code: &str| {
            let text =
                "{\"status\":\"completed\",\"warnings\":[],\"advice\":[{\"code\":\"CODE\"}]}";
            serde_json::from_str(&text.replace("CODE", code)).unwrap()
        };
        assert_eq!(colour(&summary(""), None), "green");
        assert_eq!(colour(&said("SL0405"), None), "amber");
        assert_eq!(colour(&said("SL0611"), None), "green");
        let warned = "{\"status\":\"completed\",\"warnings\":[{\"code\":\"SL0402\"}]}";
        assert_eq!(colour(&serde_json::from_str(warned).unwrap(), None), "amber");
        for status in ["not_converged", "interrupted", "output_error", "running", "input_error"] {
            let text = format!("{{\"status\":\"{status}\"}}");
            assert_eq!(colour(&serde_json::from_str(&text).unwrap(), None), "red", "{status}");
        }
        let strained = summary(",\"allowable\":{\"utilisation\":1.5}");
        assert_eq!(colour(&strained, None), "red");
    }

    /// Requirement: the verdict stands last in the file and is replaced, not
    /// written twice, when the file gets another warning.
    #[test]
    fn the_tail_is_replaced() {
        let attached = |summary| attached(summary, &Energies::default(), &History::default());
        let text = "{\"status\":\"completed\",\"title\":\",\\\"forces\\\":\",\"warnings\":[]}";
        let once = attached(serde_json::from_str(text).unwrap());
        assert!(
            crate::json::text(&once)
                .ends_with(",\"forces\":[],\"verdict\":{\"colour\":\"green\",\"reasons\":[]}}")
        );
        assert_eq!(attached(once.clone()), once);
        let mut warned = once;
        warned["warnings"] = json!([{"code": "SL0602"}]);
        warned["late"] = json!(1);
        let again = crate::json::text(&attached(warned));
        assert!(again.contains("amber") && again.contains("\"late\":1,\"forces\""), "{again}");
    }
}
