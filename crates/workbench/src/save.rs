//! A state of the bench as a deck, as a script of Python, as a report.

use crate::answers::{overtaken, refused};
use crate::deck::{Opened, Reads};
use crate::markdown::fragment;
use crate::places::Place;
use crate::solve::{Room, Silent};
use crate::values::Values;
use serde_json::{Value, json};
use slideline::deck::apply;
use slideline::diag::Edit;
use slideline::output::report::Options;
use slideline::{Diagnostic, Judge, Read, Severity, code_page, objections};
use std::fmt::Write as _;

/// Writes what is asked for.
pub(crate) fn save(
    opened: &Opened,
    values: &Values,
    (room, read): (&mut Room, &Reads),
    (id, asked): (&Value, &Value),
    say: &mut dyn FnMut(&str) -> bool,
) -> Value {
    let job = opened.job();
    let file = |end: &str, text: String| json!({"say": "file", "id": id, "name": format!("{job}{end}"), "text": text});
    let deck = match saved(opened, values) {
        Ok(deck) => deck,
        Err(said) => return refused(id, said.first().map_or("", |own| &own.message)),
    };
    match asked.get("what").and_then(Value::as_str).unwrap_or_default() {
        // the deck that was opened stays as it is
        "deck" => file("_set.inp", deck),
        "python" => file("_set.py", script(opened, &deck)),
        "report" => match report(&read(&opened.name, &deck), job, room, say) {
            Ok(page) => file("_set.html", page),
            Err(None) => overtaken(id),
            Err(Some(why)) => refused(id, &why),
        },
        other => refused(id, &format!("`{other}` cannot be saved")),
    }
}

/// The deck with the values written in; what has the deck's own value stays as it is written.
/// `Err`: there is no such deck.
pub(crate) fn saved(opened: &Opened, values: &Values) -> Result<String, Vec<Diagnostic>> {
    let deck = &opened.read.deck;
    let Some(file) = deck.files.first().map(|own| own.file) else {
        return Ok(opened.text.clone());
    };
    let changed = opened.places.changed(&opened.sliders, values)?;
    let edit = |(place, replacement): (&Place, String)| Edit { span: place.span, replacement };
    let edits: Vec<Edit> = changed.into_iter().map(edit).collect();
    Ok(String::from_utf8_lossy(&apply(deck, file, &edits).bytes).into_owned())
}

/// A script that runs the deck and draws its curve.
fn script(opened: &Opened, deck: &str) -> String {
    let job = opened.job();
    let model = opened.read.model.as_ref();
    let driven = model.and_then(|model| {
        let own = model.driven().into_iter().next()?;
        let node = model.nodes.label(*own.nodes.first()?);
        Some((node, own.dof.name(), own.dof.reaction_name()))
    });
    // a deck that would end the text is written in one line
    let raw = !deck.contains("'''") && !deck.ends_with(['\\', '\'']);
    let quoted = if raw { format!("r'''{deck}'''") } else { json!(deck).to_string() };
    let mut text = format!(
        "\"\"\"{job} with the values of the workbench: runs the deck below and draws its curve.\n\n\
         Needs the package slideline; the picture needs Matplotlib.\n\"\"\"\n\n\
         import slideline\n\nDECK = {quoted}\n\n\
         job = slideline.read_text(DECK, {})\nresult = job.run()\nprint(result)\n",
        json!(job)
    );
    if let Some((node, motion, reaction)) = driven {
        // a String takes any text
        let _ = write!(
            text,
            "travel = result.history({node}, \"{motion}\")\nforce = result.history({node}, \
             \"{reaction}\")\nfor row in zip(travel, force):\n    print(*row)\n\n\
             result.plot({node}, \"{reaction}\")\n"
        );
    }
    text
}

/// The report of a deck, as a run of it writes it. `Err`: why there is none, or something newer.
fn report(
    read: &Read,
    job: &str,
    room: &mut Room,
    say: &mut dyn FnMut(&str) -> bool,
) -> Result<String, Option<String>> {
    let Some(model) = &read.model else {
        let first = read.diagnostics.iter().find(|said| said.severity == Severity::Error);
        return Err(Some(first.map_or_else(String::new, |said| said.message.clone())));
    };
    let mut said = read.diagnostics.clone();
    said.extend(objections(model));
    said.sort_by_key(|own| own.severity == Severity::Note);
    let shown = (job, &*read.deck_hash, true);
    let mut silent = Silent::of(Judge::showing(model, (&said, &read.sources), shown), model, say);
    room.run(model, &mut silent);
    let options = Options { page: |code| code_page(code).map(fragment), ..Options::default() };
    silent.page(job, &options).ok_or(None)
}
