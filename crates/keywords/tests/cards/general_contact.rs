//! General contact: which pairs its cards make, with which roles and laws.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::NoFiles;
use slideline_diag::{Severity, Sources};
use slideline_keywords::read;
use slideline_model::{Adjust, Dialect, Formulation, Master, Model};

const PLANE: &str = include_str!("../../../../corpus/keywords/CONTACT.inp");
const NAMED: &str = include_str!("../../../../corpus/keywords/CONTACT-PROPERTY-ASSIGNMENT.inp");

const BEGUN: &str = include_str!("../../../../corpus/keywords/CONTACT-INITIALIZATION-DATA.inp");

fn model(deck: &str) -> Model {
    let read = read(&mut Sources::default(), "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus);
    let errors: Vec<_> =
        read.diagnostics.iter().filter(|d| d.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:#?}");
    read.model
}

fn names(model: &Model) -> Vec<&str> {
    model.contact_pairs.iter().map(|pair| pair.name.as_str()).collect()
}

/// The contact cards of the deck in place of its own ones.
fn with(cards: &str) -> String {
    let (before, rest) = NAMED.split_once("*CONTACT\n").expect("general contact");
    let (_, after) = rest.split_once("*STEP").expect("a step");
    format!("{before}*CONTACT\n{cards}*STEP{after}")
}

/// Requirement: every two parts make a pair, none twice; the finer mesh is the slave, and outlines
/// that are masters go all round: their last node is their first.
#[test]
fn every_two_parts_make_a_pair() {
    let model = model(PLANE);
    assert_eq!(names(&model), ["B/A", "C/A", "C/B"]);
    for pair in &model.contact_pairs {
        assert_eq!(pair.formulation, Formulation::Mortar);
        assert_eq!(pair.elements.len(), 4, "the whole outline of the slave");
        let Master::SlideLine(line) = &pair.master else { unreachable!("a chain") };
        assert_eq!(line.nodes.len(), 5, "no face of the master's outline is left out");
        assert_eq!(line.nodes.first(), line.nodes.last());
        assert_eq!(line.extension, 0.0, "nothing lies beyond its ends");
    }
}

/// Requirement: a part that is ten times as stiff is the master, however fine.
#[test]
fn the_stiffer_part_is_the_master() {
    let stiff = PLANE.replace("*ELSET, ELSET=ALL\nA, B, C", "*ELSET, ELSET=ALL\nA, B").replace(
        "*MATERIAL, NAME=RUBBER",
        "*SOLID SECTION, ELSET=C, MATERIAL=STEEL\n1.0\n*MATERIAL, NAME=STEEL\n*ELASTIC\n\
             1000., 0.3\n*MATERIAL, NAME=RUBBER",
    );
    let pairs = model(&stiff);
    let on_steel: Vec<_> = names(&pairs).into_iter().filter(|name| name.ends_with("/C")).collect();
    assert_eq!(on_steel.len(), 2, "{:?}", names(&pairs));
}

/// Requirement: exclusions take their pair away and no other, in either order of the names.
#[test]
fn exclusions_take_pairs_away() {
    for excluded in ["SKIN-A, SKIN-C", "SKIN-C, SKIN-A"] {
        let deck =
            with(&format!("*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT EXCLUSIONS\n{excluded}\n"));
        assert_eq!(names(&model(&deck)).len(), 2, "{excluded}");
    }
    let named = with("*CONTACT INCLUSIONS\nSKIN-A, SKIN-B\nSKIN-B, SKIN-A\n");
    assert_eq!(names(&model(&named)), ["B/A"]);
}

/// Requirement: of faces that are excluded in part the others keep their contact; all stay, so that nothing is seen through
/// a hole.
#[test]
fn faces_are_excluded_alone() {
    let cards = "*CONTACT INCLUSIONS\nSKIN-A, SKIN-B\n*CONTACT EXCLUSIONS\nSIDE, SKIN-A\n";
    let deck = with(cards).replace("*CONTACT\n", "*SURFACE, NAME=SIDE\nB, S2\n*CONTACT\n");
    let model = model(&deck);
    assert_eq!(model.contact_pairs.len(), 1);
    let pair = &model.contact_pairs[0];
    assert_eq!((pair.elements.len(), pair.left_out.len()), (4, 1));
    let [own] = &pair.left_out[..] else { unreachable!() };
    assert_eq!(own.slave.len().min(own.master.len()), 1);
}

/// Requirement: the last property that fits counts; without one contact is hard and frictionless.
#[test]
fn the_last_property_that_fits_counts() {
    let with_laws = model(NAMED);
    let friction =
        |pair: &slideline_model::ContactPair| pair.interaction.friction.coefficients()[0];
    let found: Vec<f64> = with_laws.contact_pairs.iter().map(friction).collect();
    let of = |name: &str| {
        let place = names(&with_laws).iter().position(|own| own.starts_with(name)).expect("a pair");
        found[place]
    };
    assert!((of("B/A") - 0.05).abs() < 1e-12 && (of("C/A") - 0.2).abs() < 1e-12, "{found:?}");
    let bare = model(PLANE);
    assert!(bare.contact_pairs.iter().all(|pair| friction(pair) == 0.0));
}

/// Requirement: slaves of the pair that a line names begin at the clearance of its data, in either
/// order of the names, or within its distance; all others begin where they are, and every pair keeps
/// its interaction. A name that nothing has, and what is not supported, are errors.
#[test]
fn slaves_begin_as_their_data_say() {
    let adjusts = |deck: &str| -> Vec<(String, Adjust)> {
        let pairs = model(deck).contact_pairs.into_iter();
        let mut own: Vec<_> = pairs.map(|pair| (pair.name, pair.adjust)).collect();
        own.sort_by(|a, b| a.0.cmp(&b.0));
        own
    };
    let gap = |begun: Adjust| {
        let of = |name: &str, own| (name.to_owned(), own);
        vec![of("B/A", begun), of("C/A", Adjust::Nothing), of("C/B", Adjust::Nothing)]
    };
    assert_eq!(adjusts(BEGUN), gap(Adjust::Clearance(0.01)));
    let turned = BEGUN.replace("SKIN-A, SKIN-B, LOOSE", "SKIN-B, SKIN-A, LOOSE");
    assert_eq!(adjusts(&turned), gap(Adjust::Clearance(0.01)));
    let near = BEGUN.replace("INITIAL CLEARANCE=0.01", "SEARCH ABOVE=0.02, SEARCH BELOW=0.1");
    assert_eq!(adjusts(&near), gap(Adjust::Within(0.02)));
    // the friction of DRY, which C on A has there too
    let named = model(NAMED);
    let dry = named.contact_pairs.iter().find(|pair| pair.name == "C/A").expect("a pair");
    for pair in model(BEGUN).contact_pairs {
        assert_eq!(pair.interaction.friction, dry.interaction.friction, "{}", pair.name);
    }
    for (old, new, code) in [
        ("SKIN-B, LOOSE", "SKIN-B, LOSE", "SL0328"),
        ("INITIAL CLEARANCE=0.01", "INTERFERENCE FIT", "SL0221"),
        ("INITIAL CLEARANCE=0.01", "SEARCH ABOVE=-1.", "SL0210"),
    ] {
        let deck = BEGUN.replace(old, new);
        let read =
            read(&mut Sources::default(), "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus);
        assert!(read.diagnostics.iter().any(|said| said.code.0 == code), "{new}");
    }
}

/// A strip of six elements of sets LEFT and RIGHT, and a block beside it, with contact cards.
fn strip(cards: &str) -> String {
    let mut deck = String::from("*HEADING\na strip and a block\n*NODE\n");
    for k in 0..7 {
        deck += &format!("{}, {k}.0, 0.0\n{}, {k}.0, 1.0\n", 1 + k, 11 + k);
    }
    deck += "21, 1.0, 1.5\n22, 1.5, 1.5\n23, 1.5, 2.0\n24, 1.0, 2.0\n";
    for (set, first) in [("LEFT", 0), ("RIGHT", 3)] {
        deck += &format!("*ELEMENT, TYPE=CPE4, ELSET={set}\n");
        for k in first..first + 3 {
            deck += &format!("{}, {}, {}, {}, {}\n", 1 + k, 1 + k, 2 + k, 12 + k, 11 + k);
        }
    }
    deck + "*ELEMENT, TYPE=CPE4, ELSET=B\n21, 21, 22, 23, 24\n*ELSET, ELSET=STRIP\nLEFT, RIGHT
*ELSET, ELSET=ENDS\n1, 6\n*ELSET, ELSET=ALL\nSTRIP, B
*SURFACE, NAME=SKIN\nSTRIP,\n*SURFACE, NAME=BLOCK\nB,\n*SURFACE, NAME=HEAD\n1, S4
*SURFACE, NAME=TAIL\n6, S2\n*SOLID SECTION, ELSET=LEFT, MATERIAL=M\n1.0
*SOLID SECTION, ELSET=RIGHT, MATERIAL=M\n1.0\n*SOLID SECTION, ELSET=B, MATERIAL=M\n1.0
*MATERIAL, NAME=M\n*ELASTIC\n10.0, 0.3\n*SURFACE INTERACTION, NAME=OIL\n*FRICTION\n0.05
*SURFACE INTERACTION, NAME=DRY\n*FRICTION\n0.4\n*CONTACT\n"
        + cards
        + "*STEP, NLGEOM\n*STATIC\n0.5, 1.0\n*BOUNDARY\n1, 1, 2\n11, 1, 2\n21, 1, 2\n22, 1, 2\n*END STEP\n"
}

/// Requirement: a part with faces that can meet is a surface that meets itself, whether all outsides
/// are included or its own alone; excluded, it is none; the last property with it on both sides counts.
#[test]
fn a_part_meets_itself() {
    const ALL: &str = "*CONTACT INCLUSIONS, ALL EXTERIOR\n";
    let with_itself = model(&strip(ALL));
    assert_eq!(names(&with_itself), ["B/STRIP", "STRIP"], "one element has no faces that can meet");
    let own = &with_itself.contact_pairs[1];
    assert!(own.meets_itself() && own.elements.len() == 14, "{}", own.elements.len());
    for named in ["SKIN,", "SKIN, SKIN"] {
        let model = model(&strip(&format!("*CONTACT INCLUSIONS\n{named}\n")));
        assert_eq!(names(&model), ["STRIP"], "{named}");
    }
    let without = format!("{ALL}*CONTACT EXCLUSIONS\nSKIN,\n");
    assert_eq!(names(&model(&strip(&without))), ["B/STRIP"]);
    let laws =
        format!("{ALL}*CONTACT PROPERTY ASSIGNMENT\n, , DRY\nSKIN, SKIN, OIL\nSKIN, BLOCK, DRY\n");
    let with_laws = model(&strip(&laws));
    let friction =
        with_laws.contact_pairs.iter().map(|own| own.interaction.friction.coefficients()[0]);
    assert_eq!(friction.collect::<Vec<_>>(), [0.4, 0.05]);
}

/// Requirement: two surfaces of a part that share no node are the sides of a pair like any other.
#[test]
fn two_ends_of_a_part_are_a_pair() {
    let model = model(&strip("*CONTACT INCLUSIONS\nHEAD, TAIL\n"));
    assert_eq!(model.contact_pairs.len(), 1);
    let pair = &model.contact_pairs[0];
    assert!(!pair.meets_itself() && pair.elements.len() == 1);
}

/// Requirement: a part that cannot be made to meet itself keeps its other contact, and says why.
#[test]
fn what_cannot_meet_itself_is_said() {
    let all = strip("*CONTACT INCLUSIONS, ALL EXTERIOR\n");
    let stepped = all.replace("ELSET=RIGHT, MATERIAL=M\n1.0", "ELSET=RIGHT, MATERIAL=M\n2.0");
    // a seventh element that touches a corner of the strip alone
    let touching = all
        .replace("21, 1.0, 1.5\n", "31, 7.0, 1.0\n32, 7.0, 2.0\n33, 6.0, 2.0\n21, 1.0, 1.5\n")
        .replace("ELSET=B\n", "ELSET=RIGHT\n7, 17, 31, 32, 33\n*ELEMENT, TYPE=CPE4, ELSET=B\n");
    for (deck, why) in [(stepped, "thick"), (touching, "touches")] {
        let read =
            read(&mut Sources::default(), "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus);
        let said = read.diagnostics.iter().find(|own| own.code.0 == "SL0393");
        assert!(said.is_some_and(|own| own.message.contains(why)), "{:#?}", read.diagnostics);
        let pairs = &read.model.contact_pairs;
        assert!(pairs.iter().all(|own| !own.meets_itself()), "{:?}", names(&read.model));
    }
}

/// Requirement: the hole of a part faces inward, and what is beside the part does not lie behind it: the outside of faces of solids
/// comes from the mesh, and no label could be the wrong one (SL0337).
#[test]
fn a_hole_has_nothing_behind_it() {
    let mut deck = "*NODE\n".to_owned();
    // the block has the finer mesh, and so the frame is the master
    for (first, count, size, [right, up]) in [(1, 4, 2, [0, 0]), (101, 2, 1, [8, 2])] {
        for k in 0..count * count {
            let [x, y] = [right + size * (k % count), up + size * (k / count)];
            deck += &format!("{}, {x}., {y}.\n", first + k);
        }
    }
    deck += "*ELEMENT, TYPE=CPE4, ELSET=FRAME\n";
    for k in (0..9).filter(|k| *k != 4) {
        let first = 1 + k % 3 + 4 * (k / 3);
        deck += &format!("{}, {first}, {}, {}, {}\n", k + 1, first + 1, first + 5, first + 4);
    }
    deck += "*ELEMENT, TYPE=CPE4, ELSET=BLOCK\n101, 101, 102, 104, 103\n*ELSET, ELSET=ALL\nFRAME, BLOCK\n\
             *SOLID SECTION, ELSET=ALL, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*CONTACT\n\
             *CONTACT INCLUSIONS, ALL EXTERIOR\n*STEP\n*STATIC\n*BOUNDARY\n1, 1, 2\n2, 2\n101, 1, 2\n102, 2\n*END STEP\n";
    // the wall of the hole is met by nothing that stands outside
    let pairs = names(&model(&deck)).len();
    assert_eq!(pairs, 2, "the block on the outside, and the frame on itself");
    let read = read(&mut Sources::default(), "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus);
    assert!(read.diagnostics.iter().all(|found| found.code.0 != "SL0337"));
}
