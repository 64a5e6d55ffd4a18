//! Derivatives of decks held against differences of whole runs, whatever the decks have in them.
//! `cargo run --release -p slideline-verification --example sensitivities_of_decks -- DECK...`.
//!
//! Numbers of a deck become parameters: the first modulus, coefficient of friction, yield stress,
//! coefficient of expansion, load and motion, and others. A row a parameter and kind of response
//! tells how far apart both are, of the largest derivative of that kind.

// a command that prints what it found
#![allow(clippy::print_stdout)]

use slideline_verification::derivatives;

fn main() {
    for path in std::env::args().skip(1) {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        if text.to_ascii_uppercase().contains("*PARAMETER") {
            println!("{path}: has parameters of its own");
            continue;
        }
        for (name, held) in derivatives(&text) {
            match held {
                Ok(held) => {
                    let mark = if held.is_same() { "same" } else { "APART" };
                    println!("{path}, {name}: {mark}: {}", held.told);
                }
                Err(why) => println!("{path}, {name}: - {why}"),
            }
        }
    }
}
