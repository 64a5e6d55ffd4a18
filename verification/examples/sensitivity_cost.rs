//! What derivatives by five parameters cost, in analyses: decks of the paper, a snap-fit, solids.
//! `cargo run --release -p slideline-verification --example sensitivity_cost [-- DECK]`.

// a deck that cannot be read has nothing to measure
#![allow(clippy::expect_used, clippy::print_stdout)]

use slideline::keywords::Setting;
use slideline::{Job, Parametric, Plan, Quiet, ReadOptions, SolveOptions, Workspace};
use std::sync::Arc;
use std::time::Instant;

/// How often each is run; the fastest counts.
const RUNS: usize = 5;

const ISL: &str = include_str!("../../corpus/diehl1995/isl_coarse_mu03.inp");
const IRS: &str = include_str!("../../corpus/diehl1995/irs_fine_mu03.inp");
const SURFACE: &str = include_str!("../../corpus/diehl1995/surface_coarse_mu03.inp");
const BLOCKS: &str = include_str!("../../corpus/sound/solid_blocks_mm.inp");

/// A deck of the paper with names for five of its numbers.
fn of_paper(deck: &str) -> String {
    let names = "*PARAMETER\nt = 1.5E-3\ne = 6.9E9\nmu = 0.3\nw = 25.0E-3\ndown = -30.0E-3\n";
    let deck = deck
        .replace("25.0E-3,1.5E-3", "25.0E-3, 1.5E-3")
        .replace("25.0E-3, 1.5E-3", "<w>, <t>")
        .replace("6.9E9", "<e>")
        .replace("*FRICTION\n0.3", "*FRICTION\n<mu>")
        .replace("9999, 2,, -30.0E-3", "9999, 2,, <down>");
    deck.replacen("*HEADING\n", &format!("{names}*HEADING\n"), 1)
}

fn of_blocks(deck: &str) -> String {
    let names = "*PARAMETER\ne = 2600.0\nnu = 0.35\nmu = 0.2\npress = -0.02\ndrag = 0.4\n";
    let deck = deck
        .replace("2600.0, 0.35", "<e>, <nu>")
        .replace("\n0.2\n", "\n<mu>\n")
        .replace("-0.02", "<press>")
        .replace("TOP, 1, 1, 0.4", "TOP, 1, 1, <drag>");
    deck.replacen("*HEADING\n", &format!("{names}*HEADING\n"), 1)
}

fn fastest(mut run: impl FnMut()) -> f64 {
    let time = |_| {
        let began = Instant::now();
        run();
        began.elapsed().as_secs_f64()
    };
    (0..RUNS).map(time).fold(f64::INFINITY, f64::min)
}

fn main() {
    let decks = [
        ("irs_fine_mu03", of_paper(IRS)),
        ("isl_coarse_mu03", of_paper(ISL)),
        ("surface_coarse_mu03", of_paper(SURFACE)),
        ("solid_blocks_mm", of_blocks(BLOCKS)),
    ];
    println!("deck, parameters, run [ms], differentiated [ms], more [runs]");
    let only = std::env::args().nth(1);
    for (name, deck) in decks {
        if only.as_ref().is_some_and(|own| own != name) {
            continue;
        }
        let read = Job::read_text(name, &deck, &ReadOptions::default());
        let model = read.model.as_ref().expect("the deck is read");
        let deck = Arc::new(Parametric::of(&read).expect("it goes on from no other"));
        let none: [Setting; 0] = [];
        let parameters = deck.varied(&none, &deck.numbers(&none));
        let mut workspace = Workspace::new(&Plan::of(model), &SolveOptions::default());
        let plain = fastest(|| drop(workspace.run(model, &mut Quiet)));
        let all = fastest(|| {
            drop(workspace.run_differentiated(model, &parameters, &mut Quiet));
        });
        let more = (all - plain) / plain;
        let count = parameters.len();
        println!("{name}, {count}, {:.2}, {:.2}, {more:.2}", 1e3 * plain, 1e3 * all);
    }
}
