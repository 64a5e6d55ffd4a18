//! Parts that people recognise, `corpus/field`: they run as they are, and their files say that they
//! are right.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, TangentCheck, solve};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Most iterations of an increment.
const ITERATIONS: usize = 6;
/// Part of a pair's force by which its two sides may differ.
const IMBALANCE: f64 = 1e-9;
/// Part of the largest energy that may be missing; the trapezoidal rule over the deck's own
/// increments leaves 0.02 to 0.9 %.
const ENERGY: f64 = 0.01;
/// The same of the hook in space, which has half as many increments as the one in the plane: 1.6 %.
const ENERGY_IN_SPACE: f64 = 0.02;

/// What a run leaves.
#[derive(Default)]
pub(crate) struct Watch {
    pub(crate) attempts_given_up: usize,
    pub(crate) increments: usize,
    pub(crate) most_iterations: usize,
    pub(crate) imbalance: f64,
    largest_energy: f64,
    missing_energy: f64,
    closed: usize,
    tangent: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::AttemptFailed(_) => self.attempts_given_up += 1,
            Event::Committed(frame) => {
                self.increments += 1;
                let iterations = frame.severe_iterations + frame.equilibrium_iterations;
                self.most_iterations = self.most_iterations.max(iterations);
                for pair in frame.pairs {
                    let size = pair.force_imbalance.max(pair.moment_imbalance);
                    self.imbalance = self.imbalance.max(size);
                    self.closed = self.closed.max(pair.closed);
                }
                let energy = frame.energy;
                let sizes =
                    [energy.external_work, energy.strain_energy, energy.friction_dissipation];
                let own = sizes.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
                self.largest_energy = self.largest_energy.max(own);
                self.missing_energy = self.missing_energy.max(energy.balance.abs());
            }
            Event::Tangent(report) => self.tangent = self.tangent.max(report.off),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

fn decks() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/field");
    let mut decks: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    decks.sort();
    decks
}

fn run(path: &Path) -> Watch {
    let deck = std::fs::read_to_string(path).unwrap();
    run_deck((&path.display().to_string(), &deck), &SolveOptions::default())
}

pub(crate) fn run_deck((name, deck): (&str, &str), options: &SolveOptions) -> Watch {
    let read = Job::read_text("field", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{name}: {:#?}", read.diagnostics));
    let mut watch = Watch::default();
    let ending = solve(&model, options, &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{name}: {ending:?}");
    watch
}

/// Requirement: every part goes in and out without an increment that is given up, with at most six
/// iterations an increment; the forces of a pair balance to 1e-9; the energy to 1 % of the largest.
#[test]
fn parts_run_as_they_are() {
    let decks = decks();
    assert!(decks.len() >= 9, "{decks:?}");
    for path in decks {
        let watch = run(&path);
        let name = path.display();
        assert_eq!(watch.attempts_given_up, 0, "{name}");
        assert!(watch.increments >= 100, "{name}: {}", watch.increments);
        assert!(watch.most_iterations <= ITERATIONS, "{name}: {}", watch.most_iterations);
        assert!(watch.closed > 0, "{name}: nothing touches");
        assert!(watch.imbalance <= IMBALANCE, "{name}: {:e}", watch.imbalance);
        let missing = watch.missing_energy / watch.largest_energy;
        let allowed = match path.ends_with("hook_in_space.inp") {
            true => ENERGY_IN_SPACE,
            false => ENERGY,
        };
        assert!(missing <= allowed, "{name}: {missing}");
    }
}

/// Requirement: the hook with a mesh twice as fine and increments twice as long runs as it is too, and
/// where faces of the slot look past the head the tangent has every coupling of what touches:
/// differences find it to 1e-7. Beside parts that lie deep behind a face, couplings were missing.
#[test]
fn a_finer_mesh_changes_nothing() {
    let deck = include_str!("mortar_decks/finer_hook.inp");
    let check_tangent = TangentCheck::Increment(9);
    let options = SolveOptions { check_tangent, ..SolveOptions::default() };
    let watch = run_deck(("finer_hook", deck), &options);
    assert_eq!((watch.attempts_given_up, watch.increments), (0, 100));
    assert!(watch.most_iterations <= ITERATIONS, "{}", watch.most_iterations);
    assert!(0.0 < watch.tangent && watch.tangent <= 1e-7, "{:e}", watch.tangent);
}

/// Requirement: every part has a page and a picture.
#[test]
fn every_part_has_a_page() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    for path in decks() {
        let name = path.file_stem().unwrap().to_str().unwrap();
        let page = std::fs::read_to_string(docs.join(format!("field/{name}.md"))).unwrap();
        assert!(page.contains(&format!("corpus/field/{name}.inp")), "{name}");
        assert!(page.contains(&format!("../images/field/{name}.png")), "{name}");
        assert!(docs.join(format!("images/field/{name}.png")).exists(), "{name}");
    }
}
