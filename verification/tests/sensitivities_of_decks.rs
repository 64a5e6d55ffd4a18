//! Derivatives of decks of the corpus against differences of whole runs: the short form of the example
//! `sensitivities_of_decks`, which takes any deck.

use slideline_verification::derivatives;

/// Decks with contact, friction, metal, rubber, heat, creep, springs, rigid bodies and changes of the
/// model among them, each of which runs in a moment.
const DECKS: [&str; 13] = [
    "sound/block_slides_in_space",
    "sound/eccentric_cam_mm",
    "sound/filleted_wedge_mm",
    "sound/press_and_lift_inch",
    "sound/solid_blocks_mm",
    "sound/sprung_roller_m",
    "sound/three_sections_mm",
    "sound/two_leaves_mm",
    "keywords/CREEP",
    "keywords/MODEL-CHANGE",
    "keywords/PLASTIC",
    "keywords/RIGID-BODY",
    "keywords/SPRING",
];

/// Contact over faces with friction, metal and heat at once.
const FACES: &str = "block_over_faces";

/// Rows that are known to be off: the dissipation of the two leaves by their section is, by 1.4e-6, and a reaction of
/// the cam by its law of contact, by 1.1e-6: the differences of whole runs are, for the tangent and four neighbours
/// tell the same to 2e-7.
const KNOWN: [(&str, &str); 2] =
    [("sound/two_leaves_mm", "section"), ("sound/eccentric_cam_mm", "law")];

/// Requirement: derivatives by every number that a deck has are those of differences of whole runs to
/// 1e-6 of the largest of their kind. Neighbours that do not run, or run in other increments, prove
/// nothing and are left out; most rows must prove something.
#[test]
fn derivatives_are_those_of_whole_runs() {
    let (mut proved, mut left_out, mut apart) = (0, Vec::new(), Vec::new());
    let corpus = DECKS.map(|deck| (deck, format!("../corpus/{deck}.inp")));
    for (deck, path) in corpus.into_iter().chain([(FACES, format!("tests/decks/{FACES}.inp"))]) {
        let path = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).unwrap();
        for (name, held) in derivatives(&text) {
            match held {
                Ok(held) if held.is_same() => proved += 1,
                Ok(_) if KNOWN.contains(&(deck, name)) => {}
                Ok(held) => apart.push(format!("{deck}, {name}: {}", held.told)),
                Err(why) => left_out.push(format!("{deck}, {name}: {why}")),
            }
        }
    }
    assert!(apart.is_empty(), "{apart:#?}");
    assert!(proved >= 40 && left_out.len() * 4 <= proved, "{proved} proved, {left_out:#?}");
}
