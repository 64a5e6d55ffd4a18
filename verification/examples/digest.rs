//! Every bit that some small decks give, a line a value: what one build of
//! the program prints must be what any other prints. `.ci/debug` holds a
//! build without optimisation, with overflow checks, against the optimised
//! one.

use slideline_verification::random::model;
use slideline_verification::{paper, run};

fn main() -> Result<(), String> {
    let short = |deck: &str| deck.replace("0.05, 1.0, 1.0E-6, 0.05", "0.05, 0.2, 1.0E-6, 0.05");
    let decks = [paper::IRS_COARSE, paper::ISL_PUSH_PULL, paper::SURFACE_COARSE_MU03];
    let mut decks: Vec<String> = decks.iter().map(|deck| short(deck)).collect();
    decks.extend((0..30).map(|number| model(number).text));
    for (place, deck) in decks.iter().enumerate() {
        // A deck that does not converge is a digest too: of how it ends.
        let curve = match run(deck) {
            Ok(curve) => curve,
            Err(why) => {
                println!("{place} {why}");
                continue;
            }
        };
        for (increment, row) in curve.rows.iter().enumerate() {
            let values = row.displacement.iter().chain(&row.reaction).flatten();
            for value in values.filter(|value| **value != 0.0) {
                println!("{place} {increment} {:016x} {value:e}", value.to_bits());
            }
        }
    }
    Ok(())
}
