//! The parts of `corpus/field` with other friction, increments and stiffness, told as a table:
//! `cargo run --release -p slideline-verification --example field_variations [-- PART ...]`.
//!
//! Every part is run with coefficients of friction from 0 to 0.5, in 50, 100 and 200 increments a
//! step, and with moduli ten times as large and as small. A line each: what it is, how it ended,
//! increments, attempts given up, most iterations of an increment, imbalance of a pair and energy that
//! is missing over the largest one. A `!` marks what misses docs/field/index.md: no attempt given up,
//! at most six iterations, 1e-9 and 1 %.

use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::fmt::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// What a run leaves.
#[derive(Default)]
struct Watch {
    given_up: usize,
    increments: usize,
    iterations: usize,
    imbalance: f64,
    energy: f64,
    missing: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::AttemptFailed(_) => self.given_up += 1,
            Event::Committed(frame) => {
                self.increments += 1;
                let own = frame.severe_iterations + frame.equilibrium_iterations;
                self.iterations = self.iterations.max(own);
                for pair in frame.pairs {
                    let size = pair.force_imbalance.max(pair.moment_imbalance);
                    self.imbalance = self.imbalance.max(size);
                }
                let energy = frame.energy;
                let all = [energy.external_work, energy.strain_energy, energy.friction_dissipation];
                self.energy = all.iter().fold(self.energy, |most, part| most.max(part.abs()));
                self.missing = self.missing.max(energy.balance.abs());
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// What is changed in a deck; `None`: nothing.
#[derive(Clone, Copy, Default)]
struct Variation {
    friction: Option<f64>,
    increments: Option<usize>,
    stiffness: Option<f64>,
}

impl Variation {
    fn told(self) -> String {
        let mut told = String::new();
        let mut add = |name: &str, value: Option<String>| {
            if let Some(value) = value {
                let _ = write!(told, "{name} {value} ");
            }
        };
        add("mu", self.friction.map(|x| x.to_string()));
        add("increments", self.increments.map(|x| x.to_string()));
        add("moduli x", self.stiffness.map(|x| x.to_string()));
        told
    }

    /// The deck with it, data line by data line.
    fn of(self, deck: &str) -> String {
        let (mut card, mut place, mut varied) = (String::new(), 0, String::new());
        for line in deck.lines() {
            if line.starts_with("**") {
            } else if line.starts_with('*') {
                (card, place) = (line.split(',').next().unwrap_or("").to_uppercase(), 0);
            } else {
                place += 1;
            }
            let is_first = place == 1 && !line.starts_with('*');
            varied += &self.line(&card, is_first, line).unwrap_or_else(|| line.to_owned());
            varied.push('\n');
        }
        varied
    }

    fn line(self, card: &str, is_first: bool, line: &str) -> Option<String> {
        let values: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |k: usize| values.get(k)?.parse::<f64>().ok();
        match card.trim() {
            "*FRICTION" if is_first => self.friction.map(|mu| format!("{mu}")),
            "*STATIC" if is_first => {
                let step = number(1)? / self.increments? as f64;
                Some(format!("{step}, {}, 1.0E-6, {step}", values[1]))
            }
            "*ELASTIC" if is_first => {
                Some(format!("{}, {}", number(0)? * self.stiffness?, values[1]))
            }
            "*HYPERELASTIC" if is_first => {
                let by = self.stiffness?;
                Some(format!("{}, {}, {}", number(0)? * by, number(1)? * by, number(2)? / by))
            }
            _ => None,
        }
    }
}

/// All of them: each friction in each number of increments, and other moduli.
fn variations() -> Vec<Variation> {
    let mut all = vec![Variation::default()];
    for friction in [0.0, 0.1, 0.2, 0.3, 0.4, 0.5] {
        for increments in [50, 100, 200] {
            let (friction, increments) = (Some(friction), Some(increments));
            all.push(Variation { friction, increments, stiffness: None });
        }
    }
    let stiffer = [0.1, 10.0].map(|by| Variation { stiffness: Some(by), ..Variation::default() });
    all.extend(stiffer);
    all
}

fn parts(wanted: &[String]) -> std::io::Result<Vec<PathBuf>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus/field");
    let all = std::fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut all = all.collect::<std::io::Result<Vec<_>>>()?;
    let name = |path: &PathBuf| path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    all.retain(|path| wanted.is_empty() || name(path).is_some_and(|own| wanted.contains(&own)));
    all.sort();
    Ok(all)
}

fn main() -> std::io::Result<()> {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let (mut runs, mut marked) = (0, 0);
    for path in parts(&wanted)? {
        let deck = std::fs::read_to_string(&path)?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        for variation in variations() {
            let read = Job::read_text(&name, &variation.of(&deck), &ReadOptions::default());
            let Some(model) = read.model else {
                println!("! {name} {}: {:?}", variation.told(), read.diagnostics);
                continue;
            };
            let mut watch = Watch::default();
            let ending = solve(&model, &SolveOptions::default(), &mut watch);
            let missing = watch.missing / watch.energy;
            let done = matches!(ending, Ending::Completed(_));
            let sound = watch.given_up == 0 && watch.iterations <= 6 && watch.imbalance <= 1e-9;
            let kept = done && sound && missing <= 0.01;
            (runs, marked) = (runs + 1, marked + usize::from(!kept));
            println!(
                "{} {name} {}: {}, {} increments, {} given up, {} iterations, {:.1e}, {:.2} %",
                if kept { " " } else { "!" },
                variation.told(),
                if done { "completed".to_owned() } else { format!("{ending:?}") },
                watch.increments,
                watch.given_up,
                watch.iterations,
                watch.imbalance,
                100.0 * missing
            );
        }
    }
    println!("{runs} runs, {marked} marked");
    Ok(())
}
