//! Surfaces and contact pairs, the modern spelling (semantics, table old and
//! modern): the same model as with contact elements, or a refusal by name.
//! Reading copies numbers, so that all comparisons are exact.

#![allow(clippy::expect_used, clippy::panic)] // a test may stop

use slideline_deck::FromDisk;
use slideline_diag::{Severity, Sources, Span};
use slideline_keywords::{Interpreted, read};
use slideline_model::{
    ContactPair, Dialect, Formulation, Friction, Master, Model, NormalLaw, SurfaceSegment,
    Vocabulary,
};

const ALONG: &str = include_str!("../../../../corpus/keywords/CONTACT-PAIR.inp");
const NODES: &str = include_str!("../../../../corpus/keywords/RIGID-BODY.inp");

fn interpret(name: &str, bytes: &[u8]) -> Interpreted {
    read(&mut Sources::default(), name, bytes, &FromDisk, Dialect::Abaqus)
}

fn corpus(name: &str) -> Model {
    let path = format!("{}/../../corpus/diehl1995/{name}.inp", env!("CARGO_MANIFEST_DIR"));
    let read = interpret(&path, &std::fs::read(&path).expect("a deck of the corpus"));
    let loud: Vec<_> = read.diagnostics.iter().filter(|d| d.severity > Severity::Note).collect();
    assert!(loud.is_empty(), "{name}: {loud:#?}");
    read.model
}

/// The deck with pieces exchanged.
fn with(deck: &str, changes: &[(&str, &str)]) -> Interpreted {
    let mut deck = deck.to_owned();
    for (old, new) in changes {
        assert!(deck.contains(old), "{old}");
        deck = deck.replacen(old, new, 1);
    }
    interpret("a.inp", deck.as_bytes())
}

fn codes(deck: &str, changes: &[(&str, &str)]) -> Vec<&'static str> {
    with(deck, changes).diagnostics.iter().map(|d| d.code.0).collect()
}

fn model_of(deck: &str, changes: &[(&str, &str)]) -> Model {
    let read = with(deck, changes);
    let errors: Vec<_> =
        read.diagnostics.iter().filter(|d| d.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:#?}");
    read.model
}

fn only_pair(model: &Model) -> &ContactPair {
    let [pair] = model.contact_pairs.as_slice() else { panic!("one pair") };
    pair
}

fn labels(model: &Model, nodes: &[usize]) -> Vec<u64> {
    nodes.iter().map(|&node| model.nodes.label(node)).collect()
}

fn chain(model: &Model) -> Vec<u64> {
    let Master::SlideLine(line) = &only_pair(model).master else { panic!("a chain") };
    labels(model, &line.nodes)
}

/// A pair without what only says where it was written: name, origins, element
/// numbers.
fn bare(pair: &ContactPair) -> ContactPair {
    let here = Span::default();
    let mut pair = pair.clone();
    (pair.name, pair.origin) = (String::new(), here);
    pair.vocabulary = Vocabulary::default();
    for element in &mut pair.elements {
        (element.label, element.origin) = (0, here);
    }
    match &mut pair.master {
        Master::RigidSurface(surface) => surface.origin = here,
        Master::SlideLine(line) => line.origin = here,
        Master::Faces(faces) => faces.origin = here,
        Master::Itself(surface) => surface.origin = here,
    }
    let interaction = &mut pair.interaction;
    interaction.origin = here;
    interaction.normal_origin = interaction.normal_origin.map(|_| here);
    interaction.friction_origin = interaction.friction_origin.map(|_| here);
    pair
}

/// Requirement: the modern decks of the corpus are the old ones, number by
/// number, so that a run gives the same bits.
#[test]
fn modern_decks_are_the_old_models() {
    for (old, modern) in [("irs_coarse", "irs_modern"), ("isl_coarse", "isl_modern")] {
        let (old, modern) = (corpus(old), corpus(modern));
        let nodes = |model: &Model| -> Vec<_> {
            model.nodes.iter().map(|node| (node.label, node.position)).collect()
        };
        assert_eq!(nodes(&old), nodes(&modern));
        assert_eq!(bare(only_pair(&old)), bare(only_pair(&modern)));
        let links = |model: &Model| -> Vec<_> {
            model.rigid_links.iter().map(|link| (link.dependent, link.master)).collect()
        };
        assert_eq!(links(&old), links(&modern));
        assert_eq!(old.blocks.len(), modern.blocks.len());
        let prescribed = |model: &Model| -> Vec<_> {
            let list = &model.steps[0].prescribed;
            list.iter().map(|entry| (entry.node, entry.dof, entry.value)).collect()
        };
        assert_eq!(prescribed(&old), prescribed(&modern));
        assert_eq!(old.steps[0].controls, modern.steps[0].controls);
        assert_eq!(old.friction_onset, modern.friction_onset);
    }
}

#[test]
fn contact_is_integrated_along_the_beam() {
    for (deck, friction) in [("surface_coarse", 0.0), ("surface_coarse_mu03", 0.3)] {
        let model = corpus(deck);
        let pair = only_pair(&model);
        assert_eq!(pair.formulation, Formulation::SurfaceToSurface);
        let elements: Vec<u64> = pair.elements.iter().map(|element| element.label).collect();
        assert_eq!(elements, (101..=124).collect::<Vec<u64>>());
        assert_eq!(labels(&model, &pair.slave_nodes()), (1..=25).collect::<Vec<u64>>());
        let Master::RigidSurface(surface) = &pair.master else { panic!("analytical") };
        assert_eq!(model.nodes.label(surface.reference), 9999);
        assert_eq!(pair.interaction.width, 25e-3);
        let law = NormalLaw::Exponential { clearance: 1e-5, pressure: 4.8e6 };
        assert_eq!(pair.interaction.normal, law);
        match pair.interaction.friction {
            Friction::Frictionless => assert_eq!(friction, 0.0),
            Friction::Coulomb { coefficient, .. } => assert_eq!(coefficient, friction),
            _ => panic!("another law"),
        }
    }
}

/// Verification, section 2: centre of the cam at 40 degrees on an arm of 10 mm
/// about (30, 17) mm, r = 9 mm. The deck prints 13 digits of millimetres.
#[test]
fn the_cam_stands_where_it_should() {
    let model = corpus("cam_surface");
    let Master::RigidSurface(cam) = &only_pair(&model).master else { panic!("analytical") };
    assert_eq!(model.nodes.position(cam.reference), [30e-3, 17e-3, 0.0]);
    let phi = 40f64.to_radians();
    let expected = [30e-3 + 10e-3 * phi.sin(), 17e-3 - 10e-3 * phi.cos()];
    let mut from = cam.start;
    for segment in &cam.segments {
        let SurfaceSegment::Circle { end, centre } = *segment else { panic!("arcs") };
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-15, "{a} is not {b}");
        near(centre[0], expected[0]);
        near(centre[1], expected[1]);
        let arm = |point: [f64; 2]| [point[0] - centre[0], point[1] - centre[1]];
        let (a, b) = (arm(from), arm(end));
        near(a[0].hypot(a[1]), 9e-3);
        near(b[0].hypot(b[1]), 9e-3);
        assert!(a[0] * b[1] - a[1] * b[0] < 0.0, "clockwise: the normal points outwards");
        from = end;
    }
    assert_eq!(cam.segments.len(), 2, "90 degrees to both sides of the arm");
}

#[test]
fn either_order_gives_the_same_integrated_contact() {
    let swapped = [("BEAM, CIRCLE\n", "CIRCLE, BEAM\n")];
    assert_eq!(codes(ALONG, &swapped), ["SL0335"]);
    let (straight, swapped) = (model_of(ALONG, &[]), model_of(ALONG, &swapped));
    assert_eq!(bare(only_pair(&straight)), bare(only_pair(&swapped)));
    assert_eq!(only_pair(&straight).name, "BEAM/CIRCLE");
}

#[test]
fn elements_come_in_the_order_of_the_chain() {
    let shuffled = model_of(ALONG, &[("BEAM, SPOS", "3, SPOS\n1, SPOS\n4,\n2, SNEG\n1, SNEG")]);
    let elements: Vec<u64> = only_pair(&shuffled).elements.iter().map(|e| e.label).collect();
    assert_eq!(elements, [1, 2, 3, 4]);
}

#[test]
fn node_to_surface_is_the_default_of_type() {
    let pair =
        |card: &str| only_pair(&model_of(ALONG, &[(", TYPE=SURFACE TO SURFACE", card)])).clone();
    assert_eq!(pair("").formulation, Formulation::NodeToSurface);
    assert_eq!(bare(&pair("")), bare(&pair(", TYPE=node to surface")));
}

/// What CalculiX calls massless is contact at nodes where no time is in it, and that is said.
#[test]
fn massless_contact_is_at_nodes() {
    let deck = include_str!("../../../../corpus/keywords/CONTACT.inp");
    let general = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n";
    let pair = "*SURFACE, NAME=LOW\nA, S3\n*SURFACE, NAME=UP\nB, S1\n*SURFACE INTERACTION, NAME=I\n\
                *CONTACT PAIR, INTERACTION=I, TYPE=MASSLESS\nUP, LOW\n";
    let read = with(deck, &[(general, pair)]);
    assert_eq!(only_pair(&read.model).formulation, Formulation::NodeToSurface);
    let notes = read.diagnostics.iter().filter(|own| own.code.0 == "SL0257");
    assert!(notes.into_iter().any(|own| own.message.contains("MASSLESS")));
}

#[test]
fn a_master_of_beams_has_its_defaults() {
    let model = model_of(NODES, &[]);
    let Master::SlideLine(line) = &only_pair(&model).master else { panic!("a chain") };
    assert_eq!((line.smooth, line.extension), (None, 0.1));
    let given =
        [("INTERACTION=SLIDING\nCAM", "INTERACTION=SLIDING, SMOOTH=0, EXTENSION ZONE=0.2\nCAM")];
    let model = model_of(NODES, &given);
    let Master::SlideLine(line) = &only_pair(&model).master else { panic!("a chain") };
    assert_eq!((line.smooth, line.extension), (Some(0.0), 0.2));
}

/// Semantics, surfaces: the outward normal stands 90 degrees counter-clockwise
/// of travel. The beam runs up, the cam is on its left.
#[test]
fn the_side_decides_the_travel() {
    let with_side = |data: &str| chain(&model_of(NODES, &[("TIP, SPOS", data)]));
    assert_eq!(with_side("TIP, SPOS"), [2, 3, 4, 5]);
    assert_eq!(with_side("TIP, SNEG"), [5, 4, 3, 2]);
    assert_eq!(with_side("TIP,"), [2, 3, 4, 5]);
    assert_eq!(with_side("4\n2, SPOS\n3"), [2, 3, 4, 5]);
    let mirrored = [
        ("TIP, SPOS", "TIP"),
        ("101, -1.0E-3", "101, 1.0E-3"),
        ("102, -0.1E-3", "102, 0.1E-3"),
        ("103, -1.0E-3", "103, 1.0E-3"),
    ];
    assert_eq!(chain(&model_of(NODES, &mirrored)), [5, 4, 3, 2]);
    let said = with(NODES, &mirrored);
    let note = said.diagnostics.iter().find(|d| d.code.0 == "SL0330").expect("a note");
    assert!(note.message.contains("SNEG") && note.severity == Severity::Note, "{note:?}");
}

/// An element that runs against the others: the label of the same side is the
/// opposite one.
#[test]
fn elements_may_run_either_way() {
    let turned = (
        "*ELSET, ELSET=TIP, GENERATE\n2, 4",
        "*ELEMENT, TYPE=B21, ELSET=ODD\n9, 4, 3\n*ELSET, ELSET=BEAM\n9\n*ELSET, ELSET=TIP\n2, 9, 4",
    );
    assert_eq!(chain(&model_of(NODES, &[turned, ("TIP, SPOS", "TIP")])), [2, 3, 4, 5]);
    let labelled = ("TIP, SPOS", "2, SPOS\n9, SNEG\n4, SPOS");
    assert_eq!(chain(&model_of(NODES, &[turned, labelled])), [2, 3, 4, 5]);
    let section = |data: &str| codes(NODES, &[turned, ("TIP, SPOS", data)]);
    assert_eq!(section("TIP, SPOS"), ["SL0254", "SL0331"]);
    assert_eq!(section("2, SPOS\n2, SNEG"), ["SL0254", "SL0331"], "both faces");
}

#[test]
fn what_is_no_chain_is_refused() {
    let tip = |members: &str, more: &str| {
        let beams = format!("*ELSET, ELSET=TIP\n{members}");
        let elements =
            format!("*ELEMENT, TYPE=B21, ELSET=BEAM\n{more}*ELSET, ELSET=TIP\n{members}");
        let new = if more.is_empty() { beams } else { elements };
        codes(NODES, &[("*ELSET, ELSET=TIP, GENERATE\n2, 4", &new)])
    };
    assert_eq!(tip("2, 4", ""), ["SL0254", "SL0329"], "apart");
    let more = "*NODE\n6, 5.0E-3, 25.0E-3\n*ELEMENT, TYPE=B21, ELSET=BEAM\n";
    let branch = format!("{more}11, 3, 6\n");
    assert_eq!(tip("2, 3, 11", &branch), ["SL0254", "SL0329"], "branch");
    let ring = format!("{more}11, 4, 6\n12, 6, 3\n");
    assert!(!tip("3, 11, 12", &ring).contains(&"SL0329"), "a ring is a master");
}

#[test]
fn node_surfaces_get_their_areas_from_beams_or_neighbours() {
    let model = model_of(NODES, &[]);
    let elements = &only_pair(&model).elements;
    let ends: Vec<_> = elements.iter().map(|element| labels(&model, &element.nodes)).collect();
    assert_eq!(ends, [[101, 102], [102, 103]]);
    let beams = [
        ("BEAM, SPOS", "BEAM"),
        ("*SURFACE, NAME=BEAM, TYPE=ELEMENT", "*SURFACE, NAME=BEAM, TYPE=NODE"),
        (", TYPE=SURFACE TO SURFACE", ""),
    ];
    let model = model_of(ALONG, &beams);
    let numbers: Vec<u64> = only_pair(&model).elements.iter().map(|e| e.label).collect();
    assert_eq!(numbers, [1, 2, 3, 4]);
}

#[test]
fn parts_that_no_surface_can_take() {
    let pair = |deck: &str, old: &str, card: &str| codes(deck, &[(old, card)]);
    let along = "INTERACTION=SLIDING, TYPE=SURFACE TO SURFACE, NO THICKNESS\nBEAM, CIRCLE";
    let refused = |card: &str| pair(ALONG, along, card);
    assert_eq!(refused("INTERACTION=SLIDING\nCIRCLE, BEAM"), ["SL0332"]);
    assert_eq!(refused("INTERACTION=SLIDING, TYPE=SURFACE TO SURFACE\nCIRCLE, CIRCLE"), ["SL0332"]);
    assert_eq!(refused("INTERACTION=SLIDING, TYPE=SURFACE TO SURFACE\nBEAM, BEAM"), ["SL0221"]);
    assert_eq!(refused("INTERACTION=SLIDING\nBEAM, BEAM"), ["SL0221"]);
    assert_eq!(refused("INTERACTION=SLIDING\nBEAM"), ["SL0221"]);
    let nodes = "INTERACTION=SLIDING\nCAM, BEAM";
    let refused = |card: &str| pair(NODES, nodes, card);
    assert_eq!(refused("INTERACTION=SLIDING\nBEAM, CAM"), ["SL0332"]);
    let along = "INTERACTION=SLIDING, TYPE=SURFACE TO SURFACE\nCAM, BEAM";
    assert_eq!(refused(along), ["SL0332"]);
    assert_eq!(pair(NODES, "CAM,\n", "102\n"), ["SL0332"], "one node");
    assert_eq!(pair(ALONG, "BEAM, CIRCLE\n", "BEAM, CIRCLE\nBEAM, CIRCLE\n"), ["SL0242"]);
}

#[test]
fn hard_contact_along_a_beam_is_an_advice() {
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n1.0E-5, 4.8E6\n";
    for hard in ["", "*SURFACE BEHAVIOR\n", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n"] {
        assert_eq!(codes(ALONG, &[(law, hard)]), ["SL0401"]);
        let model = model_of(ALONG, &[(law, hard)]);
        assert_eq!(only_pair(&model).interaction.normal, NormalLaw::Hard);
        let pair = [(law, hard), (", TYPE=SURFACE TO SURFACE", "")];
        assert_eq!(codes(ALONG, &pair), [""; 0], "exact at nodes");
    }
}

#[test]
fn interactions_have_their_defaults_and_keep_apart() {
    let thin = codes(ALONG, &[("NAME=SLIDING\n10.0E-3\n", "NAME=SLIDING\n")]);
    assert_eq!(thin, ["SL0255"]);
    let second = [(
        "*CONTACT PAIR, I",
        "*SURFACE INTERACTION, NAME=ROLLING\n5.0E-3\n*FRICTION\n0.01\n*CONTACT PAIR, I",
    )];
    assert_eq!(codes(ALONG, &second), ["SL0338"]);
    let model = model_of(ALONG, &second);
    let interaction = &only_pair(&model).interaction;
    assert_eq!(interaction.width, 10e-3);
    assert!(matches!(interaction.friction, Friction::Coulomb { coefficient: 0.3, .. }));
    assert_eq!(
        codes(ALONG, &[("*FRICTION\n0.3\n", "*FRICTION\n0.3\n*FRICTION\n0.2\n")]),
        ["SL0242"]
    );
    assert_eq!(codes(ALONG, &[("10.0E-3\n*FRICTION", "-1.\n*FRICTION")]), ["SL0210"]);
}

#[test]
fn rigid_bodies_tie_each_node_once() {
    let linked = |card: &str| {
        let model = model_of(NODES, &[("REF NODE=100, TIE NSET=CAM", card)]);
        let links = model.rigid_links.iter();
        links.map(|link| model.nodes.label(link.dependent)).collect::<Vec<_>>()
    };
    assert_eq!(linked("REF NODE=100, TIE NSET=CAM"), [101, 102, 103]);
    let change = [
        ("*NODE\n100,", "*NODE, NSET=CAM\n100,"),
        (
            "*RIGID BODY, REF NODE=100",
            "*NSET, NSET=HUB\n100\n*ELEMENT, TYPE=B21, ELSET=RIM\n50, 101, 102\n51, 102, 103\n*BEAM SECTION, SECTION=RECT, ELSET=RIM, MATERIAL=STEEL\n10.0E-3, 1.0E-3\n*RIGID BODY, REF NODE=HUB, ELSET=RIM",
        ),
        ("CAM,\n*ELSET", "101, \n102\n103\n*ELSET"),
    ];
    let model = model_of(NODES, &change);
    let links: Vec<u64> =
        model.rigid_links.iter().map(|link| model.nodes.label(link.dependent)).collect();
    assert_eq!(links, [101, 102, 103]);
    assert_eq!(codes(NODES, &[("TIE NSET=CAM", "TIE NSET=CAN")]), ["SL0304", "SL0254"]);
    assert_eq!(
        codes(NODES, &[("REF NODE=100, TIE NSET=CAM", "REF NODE=100")]),
        ["SL0205", "SL0254"]
    );
    assert_eq!(codes(NODES, &[("REF NODE=100", "REF NODE=CAM")]), ["SL0317", "SL0254"]);
    let mpc = [("*SURFACE, NAME=CAM", "*MPC\nBEAM, 101, 100\n*SURFACE, NAME=CAM")];
    assert!(codes(NODES, &mpc).contains(&"SL0316"));
}

const MIDDLES: &str = "*NODE, NSET=BEAM
1, 0.0, 0.0
5, 4.0, 0.0
*NGEN, NSET=BEAM
1, 5
*ELEMENT, TYPE=B22, ELSET=BEAM
1, 1, 2, 3
2, 3, 4, 5
*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=STEEL
1.0, 0.1
*MATERIAL, NAME=STEEL
*ELASTIC
210.0E3, 0.3
*NODE
100, 2.0, 2.0
101, 1.0, 0.1
102, 2.0, 0.1
103, 3.0, 0.1
*NSET, NSET=CAM
101, 102, 103
*RIGID BODY, REF NODE=100, TIE NSET=CAM
*SURFACE, NAME=BEAM, TYPE=ELEMENT
BEAM, SPOS
*SURFACE, NAME=CAM, TYPE=NODE
CAM
*SURFACE INTERACTION, NAME=S
1.0
*CONTACT PAIR, INTERACTION=S
CAM, BEAM
*STEP, NLGEOM
*STATIC
*BOUNDARY
1, 1, 6
100, 1, 6
*END STEP
";

/// Requirement: the middle node of a three-node beam touches like any other,
/// as a slave with four sixths of the element's length and in the master's
/// chain; contact integrated along beams keeps whole elements.
#[test]
fn middle_nodes_take_part() {
    let model = model_of(MIDDLES, &[]);
    assert_eq!(chain(&model), [1, 2, 3, 4, 5]);
    let plate = "*SURFACE, NAME=PLATE, TYPE=SEGMENTS\nSTART, 5., 1.\nLINE, -1., 1.\n\
         *RIGID BODY, REF NODE=100, ANALYTICAL SURFACE=PLATE\n*SURFACE, NAME=CAM";
    let changes = |pair: &'static str| {
        [
            ("*RIGID BODY, REF NODE=100, TIE NSET=CAM\n", ""),
            ("*SURFACE, NAME=CAM", plate),
            ("*CONTACT PAIR, INTERACTION=S\nCAM, BEAM", pair),
        ]
    };
    for pair in [
        "*CONTACT PAIR, INTERACTION=S\nBEAM, PLATE",
        "*CONTACT PAIR, INTERACTION=S\nALL, PLATE\n*SURFACE, NAME=ALL, TYPE=NODE\nBEAM",
    ] {
        let model = model_of(MIDDLES, &changes(pair));
        let slaves = only_pair(&model).slave_nodes();
        assert_eq!(labels(&model, &slaves), [1, 2, 3, 4, 5], "{pair}");
        let shares = only_pair(&model).elements.iter().map(|e| e.lumping.shares());
        let middle: Vec<f64> = shares.map(|[a, b]| a.max(b)).collect();
        assert_eq!(middle, [2.0 / 3.0; 4], "{pair}");
    }
    let along = "*CONTACT PAIR, INTERACTION=S, TYPE=SURFACE TO SURFACE\nBEAM, PLATE";
    let model = model_of(MIDDLES, &changes(along));
    assert_eq!(labels(&model, &only_pair(&model).slave_nodes()), [1, 3, 5]);
}

/// Requirement: FILLET RADIUS is the surface with its tangent points worked
/// out by hand. Tolerance: rounding.
#[test]
fn fillets_are_arcs_written_by_the_program() {
    let segments = |surface: &str| -> Vec<[f64; 2]> {
        let old = "TYPE=SEGMENTS\nSTART, -9.0E-3, 54.0E-3\n\
            CIRCL, 0.0, 45.0E-3, -9.0E-3, 45.0E-3\nCIRCL, -9.0E-3, 36.0E-3, -9.0E-3, 45.0E-3";
        let model = model_of(ALONG, &[(old, surface)]);
        let Master::RigidSurface(surface) = &only_pair(&model).master else { panic!("rigid") };
        surface.segments.iter().map(SurfaceSegment::end).collect()
    };
    let by_hand = segments(
        "TYPE=SEGMENTS\nSTART, -9.0E-3, 50.0E-3\nLINE, -1.0E-3, 50.0E-3\n\
         CIRCL, 0., 49.0E-3, -1.0E-3, 49.0E-3\nLINE, 0., 40.0E-3",
    );
    let filleted = segments(
        "TYPE=SEGMENTS, FILLET RADIUS=1.0E-3\nSTART, -9.0E-3, 50.0E-3\nLINE, 0., 50.0E-3\n\
         LINE, 0., 40.0E-3",
    );
    assert_eq!(by_hand.len(), filleted.len());
    for (a, b) in by_hand.iter().flatten().zip(filleted.iter().flatten()) {
        assert!((a - b).abs() < 1e-16, "{by_hand:?} {filleted:?}");
    }
}
