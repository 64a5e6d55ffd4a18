//! `slideline check`: what a deck means, before anything is solved.

use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::run::Interruptible;
use crate::{interrupt, render, screen};
use slideline::diag::{Code, Diagnostic, Severity, has_errors};
use slideline::model::{ContactPair, Formulation, Master, MasterFaces, NodeIndex, NormalLaw};
use slideline::observe::ContactRow;
use slideline::output::json::{self, Value, json};
use slideline::output::number::general;
use slideline::output::{Scene, echo, picture, picture_page, record, test_charts, write_file};
use slideline::{InitialGaps, Job, Model, Read, SolveOptions, initial_gaps};
use std::fmt::Write as _;
use std::io::{ErrorKind, Write as _};
use std::path::Path;

/// Mended decks that may stand beside a deck.
const MOST_FIXED: usize = 99;
/// Rows of the table of initial gaps.
const CLOSEST: usize = 12;

/// Checks a deck; ends as a run would on reading.
pub(crate) fn check(arguments: &CheckArguments) -> Exit {
    let mut read = Job::read(&arguments.deck.job, &arguments.deck.options());
    read.diagnostics.extend(slideline::advise(&read));
    let from = read.from.as_ref().and_then(|from| from.checkpoint.as_ref());
    let options = SolveOptions::default();
    let start = read.model.as_ref().and_then(|model| initial_gaps(model, &options, from));
    if arguments.json {
        screen::print(&json_lines(&read, start.as_ref()));
    } else {
        render::to_standard_error(&read.diagnostics, &read.sources);
        screen::print(&report(&read, start.as_ref()));
    }
    if let Some(path) = &arguments.picture
        && !draw(path, &read, start.as_ref())
    {
        return Exit::Output;
    }
    if arguments.fix && !fix(&read) {
        return Exit::Output;
    }
    if has_errors(&read.diagnostics) { Exit::Input } else { Exit::Completed }
}

/// Draws the model; says where on standard error.
fn draw(path: &Path, read: &Read, start: Option<&InitialGaps>) -> bool {
    let Some(model) = &read.model else {
        eprintln!("no picture: the deck has errors");
        return true;
    };
    let drawn = picture(model, start.map_or(&[][..], |start| &start.points));
    let scenes: Vec<_> = std::iter::once(drawn).chain(test_charts(model)).collect();
    let heading = model.heading.lines().next().filter(|line| !line.trim().is_empty());
    let name = read.job.stem.to_string_lossy().into_owned();
    let content = match path.extension().and_then(|ending| ending.to_str()) {
        Some("html") => {
            let words = report(read, start);
            Some(picture_page(&scenes, heading.unwrap_or(&name), &words).into_bytes())
        }
        Some("png") => in_one(scenes).and_then(|scene| scene.png(192.0)),
        _ => in_one(scenes).map(|scene| scene.svg().into_bytes()),
    };
    let Some(content) = content else {
        eprintln!("{} cannot be encoded", path.display());
        return false;
    };
    match write_file(path, &content) {
        Ok(()) => {
            eprintln!("the model is drawn in {}", path.display());
            true
        }
        Err(reason) => {
            eprintln!("{reason}");
            false
        }
    }
}

/// Figures below one another.
fn in_one(scenes: Vec<Scene>) -> Option<Scene> {
    scenes.into_iter().reduce(Scene::above)
}

/// Writes the mended deck beside the old one, under a name that nothing has;
/// says so on standard error.
fn fix(read: &Read) -> bool {
    interrupt::listen();
    let options = SolveOptions::default();
    let mend = slideline::try_mends(read, &read.diagnostics, &options, &mut Interruptible);
    for (code, reason) in &mend.left_out {
        eprintln!("{code}: its card was tried and left out, because {reason}");
    }
    let Some(bytes) = mend.deck else {
        let none = mend.left_out.is_empty();
        eprintln!(
            "{}",
            if none {
                "nothing to correct: no finding suggests a card"
            } else {
                "no corrected deck: no card helps"
            }
        );
        return true;
    };
    for number in 1..=MOST_FIXED {
        let mut name = read.job.stem.clone();
        name.push(if number == 1 { ".fixed.inp".into() } else { format!(".fixed-{number}.inp") });
        let path = read.job.deck.with_file_name(name);
        let written = std::fs::File::create_new(&path).and_then(|mut file| file.write_all(&bytes));
        match written {
            Ok(()) => {
                let codes: Vec<&str> = mend.mended.iter().map(|code| code.0).collect();
                let tried = if mend.was_run { "checked and run" } else { "checked" };
                eprintln!(
                    "the corrected deck is {} ({}; {tried})",
                    path.display(),
                    codes.join(", ")
                );
                return true;
            }
            Err(reason) if reason.kind() == ErrorKind::AlreadyExists => {}
            Err(reason) => {
                eprintln!("{} cannot be written: {reason}", path.display());
                return false;
            }
        }
    }
    eprintln!("there are already {MOST_FIXED} corrected decks beside {}", read.job.deck.display());
    false
}

fn report(read: &Read, start: Option<&InitialGaps>) -> String {
    let mut text = String::new();
    if let Some(model) = &read.model {
        let counts = [
            (model.nodes.len(), "node"),
            (elements(model), "element"),
            (model.contact_pairs.len(), "contact pair"),
            (model.steps.len(), "step"),
        ];
        let counts: Vec<String> = counts.map(|(count, noun)| counted(count, noun)).into();
        let _ = write!(text, "{}", counts.join(", ")); // a String takes any text
        match start {
            Some(start) => {
                let _ = writeln!(text, ", {} equations", start.equations); // as above
            }
            None => text.push('\n'),
        }
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            let points = start.map_or(Vec::new(), |start| nearest_first(start, place));
            push_pair(&mut text, read, pair, &points);
        }
    }
    push_verdict(&mut text, &read.diagnostics);
    text
}

fn elements(model: &Model) -> usize {
    model.blocks.iter().map(|block| block.elements.len()).sum()
}

/// Contact points of a pair, the deepest overclosure first.
fn nearest_first(start: &InitialGaps, pair: usize) -> Vec<ContactRow> {
    let mut points: Vec<ContactRow> =
        start.points.iter().copied().filter(|row| row.pair == pair).collect();
    points.sort_by(|a, b| a.opening.total_cmp(&b.opening));
    points
}

fn push_pair(text: &mut String, read: &Read, pair: &ContactPair, points: &[ContactRow]) {
    let Some(model) = &read.model else { return };
    text.push('\n');
    text.push_str(&echo::pair_echo(model, pair));
    let _ = writeln!(text, "  why      {}", why(read, pair)); // a String takes any text
    if points.is_empty() {
        return;
    }
    let begins = pair.interaction.normal.contact_begins();
    let _ = writeln!(
        text,
        "  initial gaps, nearest first; {}",
        match pair.interaction.normal {
            NormalLaw::Exponential { .. } | NormalLaw::CalculixExponential { .. } =>
                format!("contact begins below c0 = {}", general(-begins, 9)),
            _ => format!("contact begins below a gap of {}", general(-begins, 9)),
        }
    );
    let over = if begins < 0.0 { "h/c0" } else { "" };
    let _ = writeln!(text, "  {:>10} {:>20} {:>16} {over:>10}", "node", "gap", "area");
    for row in points.iter().take(CLOSEST) {
        let state = if row.opening < -begins { "  in contact" } else { "" };
        let over =
            overclosure_over_c0(pair, row).map_or(String::new(), |h| general(h, 4).to_string());
        let _ = writeln!(
            text,
            "  {:>10} {:>20} {:>16} {over:>10}{state}",
            model.nodes.label(row.node),
            echo::gap(row.opening),
            general(row.area, 7),
        );
    }
    if points.len() > CLOSEST {
        let _ = writeln!(text, "  {:>10} and {} more", "", points.len() - CLOSEST);
    }
}

/// Overclosure in units of c0 [1], for a softened law and a point that faces
/// its master.
fn overclosure_over_c0(pair: &ContactPair, row: &ContactRow) -> Option<f64> {
    let c0 = match pair.interaction.normal {
        NormalLaw::Exponential { clearance, .. }
        | NormalLaw::CalculixExponential { clearance, .. } => clearance,
        _ => return None,
    };
    row.opening.is_finite().then(|| -row.opening / c0)
}

/// Why the sides are as they are: the deck decides, never the program.
fn why(read: &Read, pair: &ContactPair) -> &'static str {
    let card = read.deck.cards.iter().find(|card| {
        card.span.file == pair.origin.file
            && (card.span.start..=card.full_span().end).contains(&pair.origin.start)
    });
    let modern = card.is_some_and(|card| card.keyword.name == "CONTACTPAIR");
    match (&pair.master, modern, pair.formulation) {
        (Master::Itself(_) | Master::Faces(MasterFaces { meets_itself: true, .. }), ..) => {
            "a surface that *CONTACT PAIR names alone meets itself: of two of its nodes that meet, the \
             sharper one is the slave, or the first along the surface"
        }
        (Master::RigidSurface(_), true, _) if pair.profile.is_some() => {
            "contact is integrated along the profile named first on *CONTACT PAIR, the slave; the one \
             named second is the master"
        }
        (Master::RigidSurface(_), true, Formulation::SurfaceToSurface) => {
            "contact is integrated along the first surface of *CONTACT PAIR, the slave; the \
             rigid surface, named second, is the master"
        }
        (Master::RigidSurface(_), true, Formulation::NodeToSurface) => {
            "nodes of the first surface of *CONTACT PAIR are slaves, the rigid surface, named \
             second, is the master"
        }
        (_, _, Formulation::Mortar) => {
            "contact is integrated over the faces of the slave, the first surface of *CONTACT PAIR \
             that is made of faces"
        }
        (Master::SlideLine(_), true, _) => {
            "nodes of the first surface of *CONTACT PAIR are slaves, the beams of the second \
             one are the master"
        }
        (Master::Faces(faces), ..) if faces.swept.is_some() => {
            "nodes of the first surface of *CONTACT PAIR are slaves, the analytical surface is the \
             master"
        }
        (Master::Faces(_), ..) => {
            "nodes of the first surface of *CONTACT PAIR are slaves, the faces of the second one \
             are the master"
        }
        (Master::RigidSurface(_), false, _) => {
            "nodes of IRS elements are slaves, their rigid surface is the master"
        }
        (Master::SlideLine(_), false, _) => {
            "nodes of ISL elements are slaves, the nodes of *SLIDE LINE are the master"
        }
    }
}

fn push_verdict(text: &mut String, diagnostics: &[Diagnostic]) {
    let count = |severity| diagnostics.iter().filter(|said| said.severity == severity).count();
    let parts: Vec<String> = [
        (count(Severity::Error), "error"),
        (count(Severity::Warning), "warning"),
        (count(Severity::Advice), "hint"),
        (count(Severity::Note), "note"),
    ]
    .into_iter()
    .filter(|(count, _)| *count > 0)
    .map(|(count, noun)| counted(count, noun))
    .collect();
    let verdict = if parts.is_empty() { "nothing to object".to_owned() } else { parts.join(", ") };
    let _ = writeln!(text, "{}{verdict}", if text.is_empty() { "" } else { "\n" }); // as above
}

/// `1 step`, `2 steps`.
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// Every diagnostic, then one note per contact pair that carries its points.
fn json_lines(read: &Read, start: Option<&InitialGaps>) -> String {
    let mut text = String::new();
    for said in &read.diagnostics {
        text.push_str(&json::text(&record(said, &read.sources)));
        text.push('\n');
    }
    let Some(model) = &read.model else { return text };
    for (place, pair) in model.contact_pairs.iter().enumerate() {
        let points = start.map_or(Vec::new(), |start| nearest_first(start, place));
        let slaves = pair.slave_nodes();
        let message = format!(
            "contact pair {}: {} slave nodes ({}); {}",
            pair.name,
            slaves.len(),
            echo::labels(model, &slaves),
            why(read, pair)
        );
        let note = Diagnostic::note(Code("SL0400"), message).at(pair.origin);
        let mut object = record(&note, &read.sources);
        object["pair"] = pair_object(model, pair, &points);
        text.push_str(&json::text(&object));
        text.push('\n');
    }
    text
}

fn pair_object(model: &Model, pair: &ContactPair, points: &[ContactRow]) -> Value {
    let label = |node| model.nodes.label(node);
    let labels = |nodes: &[NodeIndex]| nodes.iter().map(|&node| label(node)).collect::<Vec<u64>>();
    let master = match &pair.master {
        Master::RigidSurface(surface) => {
            json!({"kind": "rigid_surface", "reference_node": label(surface.reference)})
        }
        Master::SlideLine(chain) => json!({"kind": "slide_line", "nodes": labels(&chain.nodes)}),
        Master::Itself(surface) => {
            json!({"kind": "itself", "nodes": labels(&surface.nodes().collect::<Vec<_>>())})
        }
        Master::Faces(faces) => json!({"kind": "faces", "nodes": labels(&faces.nodes())}),
    };
    let gaps = points.iter().map(|row| {
        let mut gap = json!({"node": label(row.node), "gap": row.opening, "area": row.area});
        if let Some(over) = overclosure_over_c0(pair, row) {
            gap["overclosure_over_c0"] = over.into();
        }
        gap
    });
    json!({
        "name": pair.name,
        "slave_nodes": labels(&pair.slave_nodes()),
        "master": master,
        "normal": echo::normal_law(&pair.interaction.normal),
        "friction": echo::friction_law(&pair.interaction.friction),
        "contact_begins_at_gap": -pair.interaction.normal.contact_begins(),
        "initial_gaps": gaps.collect::<Value>(),
    })
}
