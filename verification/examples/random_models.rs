//! Many random models, told as a table:
//! `cargo run --release -p slideline-verification --example random_models -- 10000`.
//!
//! ```text
//!   COUNT [--class NAME] [--seed N] [--keep DIR] [--limit SECONDS] [--files DIR]
//! ```
//!
//! COUNT models in all, divided among the classes, from number N on. Decks of
//! those that failed or broke something go to DIR, with what was said as a
//! comment; the result files of the last model stay in DIR of `--files`.
//! `--class pressed` are the models of a body pressed into a beam.

use slideline_verification::random::classes::CLASSES;
use slideline_verification::random::trial::{Ending, Label, Table, Verdict, sweep};
use slideline_verification::random::{Tally, judge, model, solids};
use std::path::PathBuf;
use std::time::{Duration, Instant};

struct Arguments {
    count: u64,
    class: Option<String>,
    seed: u64,
    keep: Option<PathBuf>,
    limit: Duration,
    files: Option<PathBuf>,
}

fn arguments() -> Result<Arguments, String> {
    let mut given = Arguments {
        count: 10_000,
        class: None,
        seed: 0,
        keep: None,
        limit: Duration::from_secs(10),
        files: None,
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or(format!("{word} needs a value"));
        let number = |text: String| text.parse().map_err(|_| format!("{text} is no number"));
        match word.as_str() {
            "--class" => given.class = Some(value()?),
            "--seed" => given.seed = number(value()?)?,
            "--keep" => given.keep = Some(value()?.into()),
            "--files" => given.files = Some(value()?.into()),
            "--limit" => given.limit = Duration::from_secs(number(value()?)?),
            _ => given.count = number(word)?,
        }
    }
    Ok(given)
}

fn main() -> std::io::Result<()> {
    let given = arguments().map_err(std::io::Error::other)?;
    if given.class.as_deref() == Some("pressed") {
        return pressed(&given);
    }
    let solids = solids::CLASSES.iter().map(|class| class.name);
    let names: Vec<_> = CLASSES.iter().map(|class| class.name).chain(solids).collect();
    if given.class.as_ref().is_some_and(|name| !names.contains(&name.as_str())) {
        return Err(std::io::Error::other(format!("classes: pressed, {}", names.join(", "))));
    }
    let wanted = |name: &str| given.class.as_ref().is_none_or(|class| class == name);
    let wanted: Vec<_> = names.iter().filter(|name| wanted(name)).collect();
    let each = given.count.div_ceil(wanted.len() as u64);
    let passing = std::env::temp_dir().join(format!("slideline-random-{}", std::process::id()));
    let folder = given.files.clone().unwrap_or(passing);
    std::fs::create_dir_all(&folder)?;
    let (began, mut table) = (Instant::now(), Table::default());
    let mut tell = |label: Label, verdict: &Verdict, text: &dyn Fn() -> String| {
        table.add(label, verdict);
        if let Some(why) = remarkable(verdict) {
            let posed = if label.well_posed { "" } else { " (not well-posed)" };
            println!("{} {}{posed}: {why}", label.class, label.number);
            if let Some(keep) = &given.keep {
                store(keep, label, &format!("** {}\n{}", why.replace('\n', " "), text()));
            }
        }
    };
    let (numbers, run) = (given.seed..given.seed + each, (folder.as_path(), given.limit));
    for class in CLASSES.iter().filter(|class| wanted.contains(&&class.name)) {
        sweep(class, numbers.clone(), run, |case, verdict| {
            tell(case.label(), verdict, &|| case.text());
        });
    }
    for class in solids::CLASSES.iter().filter(|class| wanted.contains(&&class.name)) {
        solids::sweep(class, numbers.clone(), run, |case, verdict| {
            tell(case.label(), verdict, &|| case.text());
        });
    }
    if given.files.is_none() {
        std::fs::remove_dir_all(&folder)?;
    }
    println!("{table}\n{:.1} s", began.elapsed().as_secs_f64());
    Ok(())
}

/// What is wrong with it, if anything.
fn remarkable(verdict: &Verdict) -> Option<String> {
    let broken = verdict.violations.iter().map(|(kind, why)| format!("BROKEN {kind}: {why}"));
    let mut lines: Vec<_> = broken.collect();
    if verdict.ending != Ending::Completed {
        let [increments, iterations] = verdict.work;
        lines.push(format!(
            "{:?} ({increments} increments, {iterations} iterations)",
            verdict.ending
        ));
    }
    (!lines.is_empty()).then(|| lines.join("; "))
}

fn store(keep: &std::path::Path, label: Label, text: &str) {
    let path = keep.join(format!("{}_{}.inp", label.class, label.number));
    if let Err(error) = std::fs::create_dir_all(keep).and_then(|()| std::fs::write(path, text)) {
        eprintln!("{}: {error}", keep.display());
    }
}

/// The models of one body pressed into a beam, judged as they run.
fn pressed(given: &Arguments) -> std::io::Result<()> {
    let (began, mut tally) = (Instant::now(), Tally::default());
    for number in given.seed..given.seed + given.count {
        let model = model(number);
        let Ok(verdict) = std::panic::catch_unwind(|| judge(&model)) else {
            eprintln!("{number} PANICS");
            continue;
        };
        tally.add(&model, &verdict);
    }
    for (number, kind, why) in &tally.remarkable {
        println!("{number} {kind:?}: {why}");
        if let Some(folder) = &given.keep {
            std::fs::create_dir_all(folder)?;
            std::fs::write(folder.join(format!("random_{number}.inp")), model(*number).text)?;
        }
    }
    println!("{tally}{:.1} s", began.elapsed().as_secs_f64());
    Ok(())
}
