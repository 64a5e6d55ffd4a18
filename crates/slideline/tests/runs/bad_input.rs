//! Faults that people make, in every family of solids and both dialects: each is named, at its line,
//! all in one go, and nothing panics.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::block_of_any_type::{Deck, FAMILIES, Family};
use slideline::{Diagnostic, Dialect, Job, ReadOptions, Severity, advise};

/// What reading and the adviser say, and whether there is a model to run.
fn said(deck: &str, dialect: Dialect) -> (Vec<Diagnostic>, bool) {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("block", deck, &options);
    let mut all = read.diagnostics.clone();
    all.extend(advise(&read));
    (all, read.model.is_some())
}

const DIALECTS: [Dialect; 2] = [Dialect::Abaqus, Dialect::Calculix];

/// A fault: its name, which families it is one of, how it comes into a deck, its code.
type Fault = (&'static str, fn(Family) -> bool, fn(&mut Deck), &'static str);

fn all(_: Family) -> bool {
    true
}

fn quadratic(family: Family) -> bool {
    family.quadratic
}

fn thick(family: Family) -> bool {
    !family.in_space() && !family.is_ring()
}

/// Faults that end a job before anything is solved.
const ERRORS: [Fault; 30] = [
    ("wrong way round", |own| !own.quadratic, turn, "SL0346"),
    ("cells without volume", all, flatten, "SL0346"),
    ("a corner through the others", |own| !own.in_space(), |deck| push(deck, -0.5), "SL0346"),
    ("a middle node far out", |own| own.quadratic && own.name != "C3D20R", bulge, "SL0346"),
    ("an undefined node", all, |deck| deck.elements[0][1] = 999, "SL0303"),
    ("a node too few", all, |deck| _ = deck.elements.last_mut().unwrap().pop(), "SL0231"),
    ("an unknown type", all, |deck| deck.kind = "C9D9".to_owned(), "SL0220"),
    ("no section", all, |deck| deck.section.clear(), "SL0307"),
    ("a section without its material", all, |deck| steel(deck, "STEEL"), "SL0308"),
    ("no thickness", thick, |deck| deck.section = deck.section.replace("1.0", "0.0"), "SL0210"),
    ("no elasticity", all, |deck| set(&mut deck.material, "*DENSITY\n1.0\n"), "SL0309"),
    ("nu of one half", all, |deck| elastic(deck, "200.0, 0.5"), "SL0234"),
    ("nu beyond", all, |deck| elastic(deck, "200.0, 0.7"), "SL0234"),
    ("nu below -1", all, |deck| elastic(deck, "200.0, -1.2"), "SL0234"),
    ("no stiffness", all, |deck| elastic(deck, "0.0, 0.3"), "SL0234"),
    ("negative stiffness", all, |deck| elastic(deck, "-200.0, 0.3"), "SL0234"),
    ("negative hardening", all, |deck| deck.material += "*PLASTIC\n1.0, 0.0\n0.5, 0.1\n", "SL0234"),
    ("plastic strain at yield", all, |deck| deck.material += "*PLASTIC\n1.0, 0.1\n", "SL0234"),
    ("rubber without stiffness", all, |deck| rubber(deck, "-1.0, 0.5, 0.01"), "SL0234"),
    ("a face that does not exist", all, no_face, "SL0256"),
    ("a ninth face", all, |deck| set(&mut deck.load, "*DLOAD\nALL, P9, 1.0\n"), "SL0256"),
    ("a load on no set", all, |deck| set(&mut deck.load, "*DLOAD\nNO, P1, 1.0\n"), "SL0308"),
    ("weight without mass", all, |deck| set(&mut deck.load, WEIGHT), "SL0309"),
    ("a support of no set", all, |deck| deck.support += "NO, 1, 1\n", "SL0304"),
    ("a support of no node", all, |deck| deck.support += "9999, 1, 1\n", "SL0304"),
    ("a seventh degree of freedom", all, |deck| deck.support += "LEFT, 7, 7\n", "SL0248"),
    ("no such curve", all, |deck| set(&mut deck.load, NO_CURVE), "SL0321"),
    ("no such surface", all, |deck| set(&mut deck.load, "*DSLOAD\nNO, P, 1.0\n"), "SL0327"),
    ("a word for a number", all, |deck| deck.support += "LEFT, 1, 1, 0.O\n", "SL0116"),
    ("an unknown card", all, |deck| deck.more += "*BOUNDRY\nLEFT, 1\n", "SL0201"),
];

const WEIGHT: &str = "*DLOAD\nALL, GRAV, 9.81, 0.0, -1.0, 0.0\n";
const NO_CURVE: &str = "*CLOAD, AMPLITUDE=NO\nRIGHT, 1, 1.0\n";

/// Faults that are said and may run.
const WARNINGS: [Fault; 9] = [
    ("a middle node past the quarter", quadratic, |deck| slide(deck, 0.15), "SL0345"),
    ("nothing holds it", all, |deck| set(&mut deck.support, "LEFT, 3, 3, 0.0\n"), "SL0409"),
    ("held one way", |own| !own.is_ring(), |deck| hold_one_way(deck), "SL0409"),
    ("cells that were not merged", all, split, "SL0410"),
    ("a cell twice", all, |deck| deck.elements.push(deck.elements[0].clone()), "SL0411"),
    ("a block in a block", all, copy, "SL0411"),
    ("a moment on solids", all, |deck| set(&mut deck.load, "*CLOAD\nRIGHT, 6, 1.0\n"), "SL0427"),
    ("steel in tonnes and metres", all, heavy, "SL0413"),
    ("rubber that gives way", all, |deck| rubber(deck, "1.0, -0.6, 0.01"), "SL0420"),
];

fn set(piece: &mut String, text: &str) {
    text.clone_into(piece);
}

fn elastic(deck: &mut Deck, constants: &str) {
    deck.material = format!("*ELASTIC\n{constants}\n");
}

fn rubber(deck: &mut Deck, constants: &str) {
    deck.material = format!("*HYPERELASTIC, MOONEY-RIVLIN\n{constants}\n");
}

fn steel(deck: &mut Deck, name: &str) {
    deck.section = deck.section.replace("MATERIAL=M", &format!("MATERIAL={name}"));
}

fn heavy(deck: &mut Deck) {
    deck.material = "*ELASTIC\n210000.0, 0.3\n*DENSITY\n7850.0\n".to_owned();
    set(&mut deck.load, WEIGHT);
}

fn hold_one_way(deck: &mut Deck) {
    set(&mut deck.support, "LEFT, 1, 1\n");
}

fn turn(deck: &mut Deck) {
    let old = deck.elements[0].clone();
    deck.elements[0] = deck.family.shape.turned().iter().map(|&k| old[k]).collect();
}

/// All of the first cell stands in one plane.
fn flatten(deck: &mut Deck) {
    let begin = deck.begin();
    deck.nodes.iter_mut().filter(|at| at[0] < begin + 1.5).for_each(|at| at[0] = begin);
}

/// A corner beyond the one across from it.
fn push(deck: &mut Deck, part: f64) {
    let [first, _, third] = [0, 1, 2].map(|k| deck.elements[0][k] - 1);
    let [from, to] = [deck.nodes[first], deck.nodes[third]];
    deck.nodes[third] = std::array::from_fn(|axis| from[axis] + part * (to[axis] - from[axis]));
}

fn bulge(deck: &mut Deck) {
    let [_, middle, _] = deck.first_edge();
    deck.nodes[middle - 1][1] += 1.5;
}

fn slide(deck: &mut Deck, part: f64) {
    let [a, middle, b] = deck.first_edge();
    let [from, to] = [deck.nodes[a - 1], deck.nodes[b - 1]];
    deck.nodes[middle - 1] =
        std::array::from_fn(|axis| from[axis] + part * (to[axis] - from[axis]));
}

fn no_face(deck: &mut Deck) {
    deck.more += &format!("*SURFACE, NAME=S\nALL, S{}\n", deck.family.faces() + 1);
    set(&mut deck.load, "*DSLOAD\nS, P, 1.0\n");
}

/// The second cell has nodes of its own.
fn split(deck: &mut Deck) {
    let half = deck.elements.len() / 2;
    let (first, second) = deck.elements.split_at_mut(half);
    let mut own = std::collections::BTreeMap::new();
    for node in second.iter_mut().flatten() {
        if first.iter().flatten().any(|other| other == node) {
            let new = *own.entry(*node).or_insert_with(|| {
                deck.nodes.push(deck.nodes[*node - 1]);
                deck.nodes.len()
            });
            *node = new;
        }
    }
}

/// A second block a little beside the first one, which nothing joins to it.
fn copy(deck: &mut Deck) {
    let count = deck.nodes.len();
    let moved: Vec<_> = deck.nodes.iter().map(|&[x, y, z]| [x + 0.37, y, z]).collect();
    deck.nodes.extend(moved);
    let of = |nodes: &Vec<usize>| nodes.iter().map(|node| node + count).collect();
    let second: Vec<Vec<usize>> = deck.elements.iter().map(of).collect();
    deck.elements.extend(second);
}

/// Requirement: the blocks that faults are put into are sound.
#[test]
fn the_block_is_sound() {
    for family in FAMILIES {
        for dialect in DIALECTS {
            let (said, runs) = said(&Deck::new(family).text(), dialect);
            let bad: Vec<_> = said.iter().filter(|own| own.severity >= Severity::Warning).collect();
            assert!(runs && bad.is_empty(), "{}: {bad:?}", family.name);
        }
    }
}

/// Requirement: each fault is an error of its own code with its line; no other code comes with it,
/// and there is nothing to run.
#[test]
fn errors_are_named() {
    let mut wrong = Vec::new();
    for family in FAMILIES {
        for (name, applies, put, code) in ERRORS.iter().filter(|fault| fault.1(family)) {
            debug_assert!(applies(family));
            let mut deck = Deck::new(family);
            put(&mut deck);
            for dialect in DIALECTS {
                let (said, runs) = said(&deck.text(), dialect);
                let errors = said.iter().filter(|own| own.severity == Severity::Error);
                let codes: Vec<&str> = errors.clone().map(|own| own.code.0).collect();
                let placed = errors.clone().all(|own| own.span.is_some());
                let only = !codes.is_empty() && codes.iter().all(|own| own == code);
                if runs || !placed || !only {
                    wrong.push(format!("{} {dialect:?}, {name}: {codes:?}", family.name));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Requirement: what may run all the same is said, with its line.
#[test]
fn doubts_are_named() {
    let mut wrong = Vec::new();
    for family in FAMILIES {
        for (name, applies, put, code) in WARNINGS.iter().filter(|fault| fault.1(family)) {
            debug_assert!(applies(family));
            let mut deck = Deck::new(family);
            put(&mut deck);
            for dialect in DIALECTS {
                let (said, runs) = said(&deck.text(), dialect);
                let told = said.iter().any(|own| own.code.0 == *code && own.span.is_some());
                if !runs || !told {
                    let codes: Vec<&str> = said.iter().map(|own| own.code.0).collect();
                    wrong.push(format!("{} {dialect:?}, {name}: {codes:?}", family.name));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Requirement: faults that do not hide one another are said in one go: every pair of those, in one
/// family of each kind.
#[test]
fn faults_are_said_in_one_go() {
    const APART: [&str; 12] = [
        "wrong way round",
        "no section",
        "a section without its material",
        "no such curve",
        "nu of one half",
        "a node too few",
        "a face that does not exist",
        "a support of no set",
        "a seventh degree of freedom",
        "negative hardening",
        "a word for a number",
        "an unknown card",
    ];
    // these are of one card, or a lost element may be why there is no section
    const TOGETHER: [[&str; 2]; 3] = [
        ["no section", "a section without its material"],
        ["no such curve", "a face that does not exist"],
        ["no section", "a node too few"],
    ];
    let together = |a, b| TOGETHER.contains(&[a, b]) || TOGETHER.contains(&[b, a]);
    let faults: Vec<&Fault> = ERRORS.iter().filter(|own| APART.contains(&own.0)).collect();
    assert_eq!(faults.len(), APART.len());
    let mut wrong = Vec::new();
    for family in FAMILIES.iter().step_by(3) {
        for first in &faults {
            for second in faults.iter().filter(|own| own.0 != first.0 && !together(own.0, first.0))
            {
                let mut deck = Deck::new(*family);
                first.2(&mut deck);
                second.2(&mut deck);
                if !(first.1(*family) && second.1(*family)) {
                    continue;
                }
                let (said, _) = said(&deck.text(), Dialect::Abaqus);
                let has = |code: &str| said.iter().any(|own| own.code.0 == code);
                if !has(first.3) || !has(second.3) {
                    let codes: Vec<&str> = said.iter().map(|own| own.code.0).collect();
                    wrong.push(format!("{}: {} and {}: {codes:?}", family.name, first.0, second.0));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
