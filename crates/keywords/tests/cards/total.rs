//! Requirement: interpretation is total (architecture: fuzz, "parse and
//! interpret never panic"), whatever the bytes; and a generator line that asks
//! for a million million nodes costs no memory.

use proptest::prelude::*;
use slideline_deck::NoFiles;
use slideline_diag::Sources;
use slideline_keywords::{Interpreted, read};
use slideline_model::Dialect;

fn interpret(bytes: &[u8]) -> Interpreted {
    read(&mut Sources::default(), "a.inp", bytes, &NoFiles, Dialect::Abaqus)
}

fn codes(deck: &str) -> Vec<&'static str> {
    interpret(deck.as_bytes()).diagnostics.iter().map(|d| d.code.0).collect()
}

#[test]
fn a_million_million_is_an_error_at_once() {
    let nodes = "*NODE\n1, 0.\n999999999, 1.\n*NGEN\n1, 999999999\n*STEP,NLGEOM\n*END STEP\n";
    assert_eq!(codes(nodes), ["SL0227"]);
    let elements = "*NODE\n1\n2, 1.\n*ELEMENT, TYPE=B21\n1, 1, 2\n\
        *ELGEN\n1, 1000000, 1, 1, 1000000, 1, 1\n*STEP,NLGEOM\n*END STEP\n";
    assert_eq!(codes(elements), ["SL0227"]);
    let repeated = "*NODE\n1\n5000000, 1.\n".to_owned()
        + &"*NSET, NSET=A, GENERATE\n1, 4000000\n".repeat(50)
        + "*STEP,NLGEOM\n*END STEP\n";
    assert_eq!(codes(&repeated).iter().filter(|&&code| code == "SL0227").count(), 49);
}

const DECK: &str = include_str!("../../../../corpus/diehl1995/isl_coarse.inp");
const SURFACES: [&str; 2] = [
    include_str!("../../../../corpus/keywords/RIGID-BODY.inp"),
    include_str!("../../../../corpus/keywords/CONTACT-PAIR.inp"),
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        interpret(&bytes);
    }

    /// The paper's deck with some lines taken out, doubled or exchanged.
    #[test]
    fn a_shuffled_deck(moves in proptest::collection::vec((0_usize..90, 0_usize..90, 0..4), 1..12)) {
        let mut lines: Vec<&str> = DECK.lines().collect();
        for (a, b, kind) in moves {
            let (a, b) = (a % lines.len(), b % lines.len());
            match kind {
                0 => { lines.remove(a); }
                1 => lines.insert(a, lines[b]),
                2 => lines.swap(a, b),
                _ => lines[a] = "1, 2, , 3.5, X",
            }
        }
        interpret(lines.join("\n").as_bytes());
    }

    /// Surfaces and pairs with some lines taken out, doubled or exchanged.
    #[test]
    fn shuffled_surfaces(
        which in 0_usize..2,
        moves in proptest::collection::vec((0_usize..50, 0_usize..50, 0..4), 1..12),
    ) {
        let mut lines: Vec<&str> = SURFACES[which].lines().collect();
        for (a, b, kind) in moves {
            let (a, b) = (a % lines.len(), b % lines.len());
            match kind {
                0 => { lines.remove(a); }
                1 => lines.insert(a, lines[b]),
                2 => lines.swap(a, b),
                _ => lines[a] = "TIP, SNEG",
            }
        }
        interpret(lines.join("\n").as_bytes());
    }

    /// The paper's deck with characters exchanged.
    #[test]
    fn a_misspelt_deck(slips in proptest::collection::vec((0_usize..3000, 32_u8..127), 1..20)) {
        let mut bytes = DECK.as_bytes().to_vec();
        for (at, byte) in slips {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        interpret(&bytes);
    }
}

/// A large set on every line, and taken over by every step.
#[test]
fn a_large_set_used_again_and_again_is_an_error_at_once() {
    let nodes = "*NODE\n1, 0.\n500001, 1.\n*NGEN, NSET=ALL\n1, 500001\n";
    let lines = "ALL, 1, 1\n".repeat(10_000);
    let deck = format!("{nodes}*STEP,NLGEOM\n*STATIC\n*BOUNDARY\n{lines}*END STEP\n");
    assert_eq!(codes(&deck), ["SL0227"]);
    let steps = "*STEP,NLGEOM\n*STATIC\n*END STEP\n".repeat(10_000);
    let deck = format!("{nodes}*STEP,NLGEOM\n*STATIC\n*BOUNDARY\nALL, 1, 2\n*END STEP\n{steps}");
    assert_eq!(codes(&deck), ["SL0227"]);
    let sets: String = (0..10_000).map(|k| format!("*NSET, NSET=S{k}\nALL,\n")).collect();
    let deck = format!("{nodes}{sets}*STEP,NLGEOM\n*STATIC\n*END STEP\n");
    assert_eq!(codes(&deck), ["SL0227"]);
}

#[test]
fn a_step_has_so_many_increments() {
    let deck = |count: &str| format!("*STEP, NLGEOM, INC={count}\n*STATIC\n*END STEP\n");
    assert_eq!(codes(&deck("1000000000")), [""; 0]);
    assert_eq!(codes(&deck("1000000001")), ["SL0210"]);
}
