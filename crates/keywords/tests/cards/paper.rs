//! The decks of Diehl (1995), read as the paper means them. Numbers are those
//! of the semantics, sections 1 to 3, and of the listings themselves.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::FromDisk;
use slideline_diag::{Severity, Sources};
use slideline_keywords::{Interpreted, read};
use slideline_model::{
    Dialect, Dof, Friction, Master, Model, NormalLaw, Onset, SurfaceSegment, types,
};

fn corpus(name: &str) -> Interpreted {
    let path = format!("{}/../../corpus/{name}", env!("CARGO_MANIFEST_DIR"));
    let bytes = std::fs::read(&path).expect("a deck of the corpus");
    read(&mut Sources::default(), &path, &bytes, &FromDisk, Dialect::Abaqus)
}

fn good(name: &str) -> Model {
    let read = corpus(&format!("diehl1995/{name}.inp"));
    let loud: Vec<_> = read.diagnostics.iter().filter(|d| d.severity > Severity::Note).collect();
    assert!(loud.is_empty(), "{loud:#?}");
    let codes: Vec<&str> = read.diagnostics.iter().map(|d| d.code.0).collect();
    assert_eq!(codes, ["SL0204", "SL0235", "SL0204", "SL0219"], "FREQ, POISSON, ISO, OPT");
    read.model
}

fn at(model: &Model, label: u64) -> [f64; 2] {
    let [x, y, _] = model.nodes.position(model.nodes.find(label).expect("a node"));
    [x, y]
}

fn near(a: [f64; 2], b: [f64; 2]) {
    let size = b[0].abs().max(b[1].abs());
    let close = (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) < 1e-14 * size; // rounding only
    assert!(close, "{a:?} is not {b:?}");
}

#[test]
fn the_beam_is_generated() {
    let model = good("irs_coarse");
    near(at(&model, 13), [8.111e-3, 25e-3]);
    assert_eq!(model.blocks[0].kind, &types::B21);
    let beam = model.blocks[0].beams().unwrap();
    assert_eq!(beam.elements.len(), 24);
    assert_eq!((beam.elements.get(0).label, beam.elements.get(23).label), (101, 124));
    assert_eq!(beam.elements.get(23).ends().map(|node| model.nodes.label(node)), [24, 25]);
    let shape = slideline_model::Shape::Rectangle { width: 25e-3, height: 1.5e-3 };
    assert_eq!(beam.section.shape, shape);
    assert_eq!((beam.section.material.modulus, beam.section.material.poisson), (6.9e9, 0.3));
    assert_eq!(model.rigid_links, []);
}

#[test]
fn the_irs_pair() {
    for (deck, elements) in [("irs_coarse", 23), ("irs_fine", 98)] {
        let model = good(deck);
        let [pair] = model.contact_pairs.as_slice() else { panic!("one pair") };
        assert_eq!(pair.elements.len(), elements);
        let slaves = pair.slave_nodes();
        assert_eq!(model.nodes.label(slaves[0]), 2);
        assert_eq!(model.nodes.label(slaves[elements]), elements as u64 + 2);
        let Master::RigidSurface(surface) = &pair.master else { panic!("a rigid surface") };
        assert_eq!(model.nodes.label(surface.reference), 9999);
        assert_eq!(surface.start, [0.0, 54e-3]);
        let centre = [0.0, 45e-3];
        assert_eq!(
            surface.segments,
            [[9e-3, 45e-3], [0.0, 36e-3]].map(|end| SurfaceSegment::Circle { end, centre })
        );
        assert_eq!(pair.interaction.width, 25e-3);
        assert_eq!(pair.interaction.friction, Friction::Frictionless);
        assert!(pair.interaction.friction_origin.is_some());
        let softened = NormalLaw::Exponential { clearance: 1e-5, pressure: 4.8e6 };
        assert_eq!(pair.interaction.normal, softened);
    }
}

#[test]
fn the_isl_pair() {
    let model = good("isl_coarse");
    near(at(&model, 9000), [0.0, 36e-3]);
    near(at(&model, 9030), [0.0, 54e-3]);
    let angle = 88.0_f64.to_radians(); // node 9017 (semantics, section 1)
    near(at(&model, 9017), [9e-3 * angle.sin(), 45e-3 - 9e-3 * angle.cos()]);
    assert_eq!(model.rigid_links.len(), 31);
    let [pair] = model.contact_pairs.as_slice() else { panic!("one pair") };
    assert_eq!(pair.elements.len(), 20);
    let Master::SlideLine(line) = &pair.master else { panic!("a slide line") };
    let labels: Vec<u64> = line.nodes.iter().map(|&node| model.nodes.label(node)).collect();
    assert_eq!(labels, (2..=25).collect::<Vec<u64>>());
    assert_eq!((line.smooth, line.extension), (Some(0.25), 0.1));
    let [_, dummy] = model.blocks.as_slice() else { panic!("two blocks") };
    assert_eq!(dummy.elements.len(), 30);
}

#[test]
fn the_step() {
    let model = good("isl_coarse");
    let [step] = model.steps.as_slice() else { panic!("one step") };
    assert_eq!((step.title.as_str(), step.nlgeom), ("MOVE BEARING DOWN", true));
    assert_eq!(step.max_increments, 100);
    let times = step.procedure;
    let increments = [times.initial, times.period, times.minimum, times.maximum];
    assert_eq!(increments, [0.05, 1.0, 1e-6, 0.05]);
    let said: Vec<_> =
        step.prescribed.iter().map(|p| (model.nodes.label(p.node), p.dof, p.value)).collect();
    let expected = [
        (1, Dof::U1, 0.0),
        (1, Dof::U2, 0.0),
        (1, Dof::UR3, 0.0),
        (9999, Dof::U1, 0.0),
        (9999, Dof::UR3, 0.0),
        (9999, Dof::U2, -30e-3),
    ];
    assert_eq!(said, expected);
    assert!(step.controls.discontinuous && step.output.contact_changes);
    assert_eq!(step.output.restart.map(|states| states.every), Some(1));
    assert_eq!(model.friction_onset, Onset::Immediate);
    let history: Vec<u64> =
        model.history_nodes().into_iter().map(|node| model.nodes.label(node)).collect();
    assert_eq!(history, [9999]);
}

/// The listing literally as printed: two lines of page furniture and a
/// keyword with one star too many, each named once, and nothing else.
#[test]
fn the_listing_as_printed() {
    let read = corpus("bad/isl_as_printed.inp");
    let errors: Vec<&str> =
        read.diagnostics.iter().filter(|d| d.severity > Severity::Note).map(|d| d.code.0).collect();
    assert_eq!(errors, ["SL0212", "SL0212", "SL0211"]);
    assert!(read.diagnostics.iter().all(|d| d.severity < Severity::Error || d.edit.is_some()));
    assert_eq!(read.model.contact_pairs[0].interaction.width, 25e-3, "read as if mended");
}
