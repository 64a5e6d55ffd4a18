//! Axes of elements from distributions, as CAE writes discrete orientations.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::NoFiles;
use slideline_diag::Sources;
use slideline_keywords::{Interpreted, read};
use slideline_model::{Axes, Dialect, Model};

/// A part of three elements in a row that is placed twice, the second time turned by 90 degrees about z.
fn deck(exchanged: &[(&str, &str)]) -> String {
    let mut deck = String::from(
        "*Part, name=Ply\n*Node\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n4, 3., 0.\n5, 0., 1.\n6, 1., 1.\n\
         7, 2., 1.\n8, 3., 1.\n*Element, type=CPS4\n1, 1, 2, 6, 5\n2, 2, 3, 7, 6\n3, 3, 4, 8, 7\n\
         *Elset, elset=All\n1, 2, 3\n*Elset, elset=Last\n3,\n\
         *Distribution, name=Ori-1-DiscOrient, location=ELEMENT, table=Ori-1-DiscOrient_Table\n\
         , 1., 0., 0., 0., 1., 0.\n2, 0.8, 0.6, 0., -0.6, 0.8, 0.\nLast, 0., 2., 0., -1., 0., 0.\n\
         *Orientation, name=Ori-1, system=RECTANGULAR\nOri-1-DiscOrient\n3, 0.\n\
         *Solid Section, elset=All, orientation=Ori-1, material=Carbon\n,\n*End Part\n\
         *Assembly, name=Assembly\n*Instance, name=Ply-1, part=Ply\n*End Instance\n\
         *Instance, name=Ply-2, part=Ply\n5., 0., 0.\n5., 0., 0., 5., 0., 1., 90.\n*End Instance\n\
         *End Assembly\n*Distribution Table, name=Ori-1-DiscOrient_Table\ncoord3d, coord3d\n\
         *Material, name=Carbon\n*Elastic, type=LAMINA\n120., 9., 0.3, 5., 5., 3.\n\
         *Step\n*Static\n1., 1.\n*Boundary\nPly-1.1, 1, 2\nPly-2.1, 1, 2\n*End Step\n",
    );
    for (old, new) in exchanged {
        assert!(deck.contains(old), "{old}");
        deck = deck.replace(old, new);
    }
    deck
}

fn interpret(deck: &str) -> Interpreted {
    read(&mut Sources::default(), "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus)
}

/// Codes and places of the errors: the text that each is about.
fn errors(deck: &str) -> Vec<(&'static str, String)> {
    let said = interpret(deck).diagnostics;
    let errors = said.into_iter().filter(|own| own.severity.word() == "error");
    let words = |start: usize, end: usize| deck[start..end].to_owned();
    errors
        .map(|own| {
            let span = own.span.expect("a place");
            (own.code.0, words(span.start as usize, span.end as usize))
        })
        .collect()
}

/// The axes of every element at its first point, block by block.
fn axes(model: &Model) -> Vec<Axes> {
    let blocks = model.blocks.iter().flat_map(|block| {
        block.elements.iter().enumerate().map(move |(place, own)| {
            let nodes = own.nodes.iter().map(|&node| model.nodes.position(node));
            block.axes_at_points(place, &nodes.collect::<Vec<_>>())[0]
        })
    });
    blocks.collect()
}

/// Requirement: every element has the axes of its line, alone or by its set, others the default, and an
/// instance that is turned turns them. Source: Abaqus manual, `*DISTRIBUTION`. Tolerance: rounding.
#[test]
fn every_element_has_its_own() {
    let read = interpret(&deck(&[]));
    assert!(
        read.diagnostics.iter().all(|own| own.severity.word() != "error"),
        "{:#?}",
        read.diagnostics
    );
    let found = axes(&read.model);
    let first = [[1.0, 0.0, 0.0], [0.8, 0.6, 0.0], [0.0, 1.0, 0.0]];
    let turned = first.map(|[x, y, z]: [f64; 3]| [-y, x, z]);
    assert_eq!(found.len(), 6);
    for (found, expected) in found.iter().zip(first.into_iter().chain(turned)) {
        let near = found[0].iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(near && (found[2][2] - 1.0).abs() < 1e-12, "{found:?} {expected:?}");
    }
    // a further turn comes on top of each
    let read = interpret(&deck(&[("3, 0.\n", "3, 90.\n")]));
    for (found, [x, y, z]) in axes(&read.model).iter().zip(first) {
        let near = found[0].iter().zip([-y, x, z]).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(near, "{found:?}");
    }
}

/// Requirement: what a distribution cannot be is refused once, at its place.
#[test]
fn what_it_cannot_be() {
    const DEFAULT: &str = ", 1., 0., 0., 0., 1., 0.\n";
    for (old, new, code, place) in [
        (DEFAULT, "", "SL0208", "2, 0.8"),
        (DEFAULT, ", 1., 0., 0., 2., 0., 0.\n", "SL0232", ", 1."),
        ("2, 0.8", "9, 0.8", "SL0308", "9, 0.8"),
        ("Last, 0.,", "Lost, 0.,", "SL0308", "Lost, 0."),
        ("location=ELEMENT", "location=NODE", "SL0221", "location"),
        ("Table, name=Ori-1", "Table, name=Ori-2", "SL0308", "table"),
        ("coord3d, coord3d", "angle", "SL0221", "angle"),
        ("\nOri-1-DiscOrient\n", "\nOri-9-DiscOrient\n", "SL0308", "Ori-9"),
        ("3, 0.\n", "3, Ori-1-DiscOrient\n", "SL0221", "3, Ori-1"),
        ("system=RECTANGULAR", "definition=NODES", "SL0215", "definition"),
        ("2, 0.8, 0.6, 0., -0.6, 0.8, 0.", "2, 0.8, 0.6, 0., -0.6, 0.8, 0., 1.", "SL0209", "1."),
        ("2, 0.8, 0.6, 0.,", "2, 0.8, 0.6, 0.5,", "SL0232", "elset=All"),
    ] {
        let found = errors(&deck(&[(old, new)]));
        assert!(!found.is_empty(), "{new}: accepted");
        for (own, words) in &found {
            assert!(*own == code && words.starts_with(place), "{new}: {found:?}");
        }
    }
    // axes of elements are those of sections alone
    let load =
        "*Elset, elset=Right, instance=Ply-1\n3,\n*Surface, name=Edge\nRight, S2\n*End Assembly\n";
    let pulled = deck(&[
        ("*End Assembly\n", load),
        (
            "*End Step\n",
            "*Dsload, orientation=Ply-1.Ori-1\nEdge, TRVEC, 1., 1., 0., 0.\n*End Step\n",
        ),
    ]);
    let found = errors(&pulled);
    assert!(matches!(&found[..], [("SL0221", place)] if place.contains("Ori-1")), "{found:?}");
}
