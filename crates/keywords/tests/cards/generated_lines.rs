//! Nodes that are generated on arcs and parabolas.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use slideline_keywords::interpret;
use slideline_model::Dialect;

/// The places of nodes that a deck makes, and the codes of what is said.
fn read(lines: &str) -> (Vec<(u64, [f64; 3])>, Vec<&'static str>) {
    let deck = format!("*NODE\n1, 2., 0.\n5, 0., 2.\n9, -2., 0.\n50, 0., 0.\n60, 1., 3.\n{lines}");
    let mut sources = slideline_diag::Sources::default();
    let parsed =
        slideline_deck::parse(&mut sources, "a.inp", deck.as_bytes(), &slideline_deck::NoFiles);
    let read = interpret(&parsed, Dialect::Abaqus);
    let nodes = &read.model.nodes;
    let places = (0..nodes.len()).map(|node| (nodes.label(node), nodes.position(node))).collect();
    (places, read.diagnostics.iter().map(|said| said.code.0).collect())
}

/// Requirement: *NGEN, LINE=C goes the shorter way about a node or a place, or round an axis by the
/// right hand; LINE=P passes the extra point half way. A half circle without an axis is refused.
#[test]
fn arcs_and_parabolas() {
    let half = 2.0_f64.sqrt();
    for (lines, expected) in [
        ("*NGEN, LINE=C\n1, 5, 2, 50\n", [half, half, 0.0]),
        ("*NGEN, LINE=C\n1, 5, 2, , 0., 0.\n", [half, half, 0.0]),
        ("*NGEN, LINE=C\n1, 5, 2, , 0., 0., 0., 0., 0., -1.\n", [-half, -half, 0.0]),
        ("*NGEN, LINE=P\n1, 5, 2, 60\n", [1.0, 3.0, 0.0]),
        ("*NGEN\n1, 5, 2\n", [1.0, 1.0, 0.0]),
    ] {
        let (places, _) = read(lines);
        let found = places.iter().find(|(label, _)| *label == 3).unwrap().1;
        assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-12), "{lines}: {found:?}");
    }
    let (_, codes) = read("*NGEN, LINE=C\n1, 9, 2, 50\n");
    assert!(codes.contains(&"SL0232"), "{codes:?}");
    let (places, _) = read("*NGEN, LINE=C\n1, 9, 4, 50, , , , 0., 0.\n");
    assert!(places.iter().any(|(label, _)| *label == 5));
}
