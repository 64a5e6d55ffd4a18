//! What a deck says and the model cannot hold is refused, never passed over; what it can hold is
//! taken as the dialects have it.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::NoFiles;
use slideline_diag::{Diagnostic, Sources};
use slideline_keywords::{Interpreted, read};
use slideline_mech::element::solid::Formulation;
use slideline_model::{Curve, Dialect, Dof, Kinematics, Model, Pressed};

/// Two squares, of 1 by 1, as solids of a type; sections and steps follow.
const SQUARES: &str = "\
*NODE
1, 1.0, 0.0
2, 2.0, 0.0
3, 3.0, 0.0
4, 1.0, 1.0
5, 2.0, 1.0
6, 3.0, 1.0
*ELEMENT, TYPE=CPS4, ELSET=A
1, 1, 2, 5, 4
*ELEMENT, TYPE=CPS4, ELSET=B
2, 2, 3, 6, 5
*ELSET, ELSET=ALL
A, B
*NSET, NSET=LEFT
1, 4
*NSET, NSET=RIGHT
3, 6
*SURFACE, NAME=TOP
ALL, S3
*SURFACE, NAME=POINTS, TYPE=NODE
RIGHT
*SOLID SECTION, ELSET=A, MATERIAL=M
2.0
*SOLID SECTION, ELSET=B, MATERIAL=M
2.0
*MATERIAL, NAME=M
*ELASTIC
200.0, 0.3
*DENSITY
3.0
*BOUNDARY
LEFT, 1, 2
";

fn interpret(text: &str, dialect: Dialect) -> Interpreted {
    read(&mut Sources::default(), "a.inp", text.as_bytes(), &NoFiles, dialect)
}

fn errors(read: &Interpreted) -> Vec<Diagnostic> {
    let all = read.diagnostics.iter();
    all.filter(|found| found.severity.word() == "error").cloned().collect()
}

/// The deck with more cards and pieces exchanged.
fn deck(more: &str, exchanged: &[(&str, &str)]) -> String {
    let mut deck = format!("{SQUARES}{more}");
    for (old, new) in exchanged {
        assert!(deck.contains(old), "{old}");
        deck = deck.replace(old, new);
    }
    deck
}

fn step(cards: &str) -> String {
    format!("*STEP, NLGEOM\n*STATIC\n{cards}\n*END STEP\n")
}

/// Codes of the errors of a deck, each once.
fn codes(deck: &str, dialect: Dialect) -> Vec<&'static str> {
    let mut codes: Vec<_> =
        errors(&interpret(deck, dialect)).iter().map(|found| found.code.0).collect();
    codes.dedup();
    codes
}

fn model(deck: &str, dialect: Dialect) -> Model {
    let read = interpret(deck, dialect);
    assert!(errors(&read).is_empty(), "{:#?}", errors(&read));
    read.model
}

const A: Dialect = Dialect::Abaqus;
const C: Dialect = Dialect::Calculix;

/// Requirement: a plane model has no third coordinate: after the message about it nothing of it
/// is left. Source: review, plane models with z.
#[test]
fn the_plane_is_that_of_z_zero() {
    let more = step("*CLOAD\n6, 1, 1.0");
    let read = interpret(&deck(&more, &[("6, 3.0, 1.0", "6, 3.0, 1.0, 0.25")]), A);
    assert!(read.diagnostics.iter().any(|found| found.code.0 == "SL0228"));
    assert!(read.model.nodes.iter().all(|node| node.position[2] == 0.0));
}

/// Requirement: nonlinear kinematics stay for the steps behind the one that asks for them, until one
/// says NO. Source: Abaqus and CalculiX manuals, `*STEP`; ccx 2.20, two steps of a cube.
#[test]
fn nonlinear_kinematics_stay() {
    for dialect in [A, C] {
        let steps = ["", ", NLGEOM", "", ", NLGEOM=NO", "", ", NLGEOM=YES", ""];
        let cards = steps.map(|own| format!("*STEP{own}\n*STATIC\n*END STEP\n")).concat();
        let model = model(&deck(&cards, &[]), dialect);
        let found: Vec<bool> = model.steps.iter().map(|step| step.nlgeom).collect();
        assert_eq!(found, [false, true, true, false, false, true, true]);
    }
}

/// Requirement: a density over temperature is that of the temperature before the first step, straight
/// between its lines and constant outside; a temperature that comes later changes no mass. Source:
/// mass is conserved. Tolerance: rounding.
#[test]
fn density_is_that_before_the_first_step() {
    let dense = [("*DENSITY\n3.0", "*DENSITY\n1.0, 0.0\n2.0, 100.0\n8.0, 200.0")];
    for (before, expected) in [(-10.0, 1.0), (50.0, 1.5), (100.0, 2.0), (150.0, 5.0), (300.0, 8.0)]
    {
        let heat = format!(
            "*NSET, NSET=N, GENERATE\n1, 6\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nN, {before}\n"
        );
        let cards = "*TEMPERATURE\nN, 500.0\n*DLOAD\nALL, GRAV, 10.0, 0.0, -1.0, 0.0";
        let model = model(&deck(&(heat + &step(cards)), &dense), A);
        let forces = &model.steps[0].distributed.forces;
        let weight: f64 = forces.iter().map(|load| load.value).sum();
        // two squares of 1 by 1, 2 thick
        assert!((weight + 40.0 * expected).abs() < 1e-10, "{before} {weight}");
    }
}

/// Requirement: BEAM of `*MPC` in CalculiX keeps the distance of two nodes alone, as LINK does; in
/// Abaqus it is a rigid bar. Source: both manuals; ccx 2.20 on a cube. Tolerance: equal.
#[test]
fn beam_in_calculix_keeps_a_distance() {
    let of = |mpc: &str| {
        step("*CLOAD\n6, 1, 1.0").replace("*STEP", &format!("*MPC\n{mpc}, 3, 5\n*STEP"))
    };
    let read = |mpc: &str, dialect| model(&deck(&of(mpc), &[]), dialect);
    let (beam, link) = (read("BEAM", C), read("LINK", C));
    assert_eq!(beam.shapes, link.shapes);
    assert!(!beam.shapes.is_empty());
    assert!(read("BEAM", A).shapes.is_empty());
}

/// Requirement: a four-node element in plane strain has one pressure in Abaqus' dialect and one a
/// point in that of CalculiX, as its C3D8. Source: ccx 2.20: four squares in a row, E = 1000, nu =
/// 0.3, a force 1 across their end: 0.156, as by C3D8 held across the plane; here 0.291 before.
#[test]
fn plane_strain_is_integrated_as_in_calculix() {
    let squares = [("*ELEMENT, TYPE=CPS4, ELSET=A", "*ELEMENT, TYPE=CPE4, ELSET=A")];
    let model = model(&deck(&step("*CLOAD\n6, 1, 1.0"), &squares), C);
    let kind = model.blocks.iter().map(|own| own.kind).find(|own| own.name() == "CPE4").unwrap();
    let Kinematics::Solid { formulation, .. } = kind.kinematics else { panic!("{}", kind.name()) };
    assert_eq!(formulation, [Formulation::MeanDilation, Formulation::Plain]);
}

/// Changes of a deck, a load, and whether that load acts.
type Case<'a> = (&'a [(&'a str, &'a str)], &'a str, bool);

/// Requirement: distributed loads that leave the plane, or break the symmetry of a ring, are
/// refused; those of a ring's own directions act. Source: Abaqus manual, `*DLOAD` (BR, BZ).
#[test]
fn loads_stay_in_the_plane() {
    let ring: &[(&str, &str)] = &[("CPS4", "CAX4")];
    let cases: [Case<'_>; 15] = [
        (&[], "*DLOAD\nALL, BX, 1.0", true),
        (&[], "*DLOAD\nALL, BZ, 1.0", false),
        (&[], "*DLOAD\nALL, BR, 1.0", false),
        (&[], "*DLOAD\nALL, GRAV, 9.81, 0.0, -1.0, 0.0", true),
        (&[], "*DLOAD\nALL, GRAV, 9.81, 0.0, -1.0, 0.1", false),
        (&[], "*DLOAD\n, GRAV, 9.81, 0.0, 0.0, -1.0", false),
        (&[], "*DSLOAD\nTOP, TRVEC, 1.0, 1.0, 0.0, 1.0", false),
        (&[], "*DSLOAD\nTOP, TRSHR, 1.0, 1.0, 0.0, 1.0", false),
        (&[], "*DLOAD\nALL, CENTRIF, 4.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0", false),
        (&[], "*DLOAD\nALL, CENTRIF, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0", true),
        (ring, "*DLOAD\nALL, BR, 1.0", true),
        (ring, "*DLOAD\nALL, BZ, 1.0", true),
        (ring, "*DLOAD\nALL, GRAV, 9.81, 1.0, 0.0, 0.0", false),
        (ring, "*DLOAD\nALL, CENTRIF, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0", true),
        (ring, "*DLOAD\nALL, CENTRIF, 4.0, 0.5, 0.0, 0.0, 0.0, 1.0, 0.0", false),
    ];
    for (exchanged, cards, sound) in cases {
        let found = codes(&deck(&step(cards), exchanged), A);
        assert_eq!(found.is_empty(), sound, "{cards} {found:?}");
        assert!(sound || found == ["SL0251"], "{cards} {found:?}");
    }
    let total = |cards: &str| -> [f64; 2] {
        let model = model(&deck(&step(cards), ring), A);
        let forces = &model.steps[0].distributed.forces;
        [Dof::U1, Dof::U2]
            .map(|dof| forces.iter().filter(|load| load.dof == dof).map(|load| load.value).sum())
    };
    // 2 pi int r dr dz over the rings: 2 pi (9 - 1)/2
    let volume = 8.0 * std::f64::consts::PI;
    for (cards, expected) in
        [("*DLOAD\nALL, BR, 1.0", [volume, 0.0]), ("*DLOAD\nALL, BZ, 1.0", [0.0, volume])]
    {
        let sums = total(cards);
        let near = |k: usize| (sums[k] - expected[k]).abs() < 1e-12 * volume;
        assert!(near(0) && near(1), "{cards} {sums:?}");
    }
}

/// Requirement: loads on beams in space have the whole of their forces: per length, per volume on
/// the area, gravity on the mass; half at each end of an element, no moments. What acts
/// across the plane of the model, or is a pressure in CalculiX, is refused.
#[test]
fn loads_along_beams() {
    let deck = |load: &str, nlgeom: &str| {
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 3., 0., 4.\n3, 6., 0., 8.\n*ELEMENT, TYPE=B31, ELSET=B\n\
             1, 1, 2\n2, 2, 3\n*BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n0.5, 0.2\n\
             0., -1., 0.\n*MATERIAL, NAME=M\n*ELASTIC\n1.0, 0.3\n*DENSITY\n7.0\n\
             *STEP{nlgeom}\n*STATIC\n*BOUNDARY\n1, 1, 6\n*DLOAD\n{load}\n*END STEP\n"
        )
    };
    // n1 = -y, n2 = t x n1 = (0.8, 0, -0.6)
    for (load, expected) in [
        ("B, PY, 2.0", [0.0, 20.0, 0.0]),
        ("B, BZ, 3.0", [0.0, 0.0, 3.0]),
        ("B, GRAV, 2.0, 0., 0., -1.", [0.0, 0.0, -14.0]),
        ("B, P1, 2.0", [0.0, -20.0, 0.0]),
        ("B, P2, 2.0", [16.0, 0.0, -12.0]),
    ] {
        let model = model(&deck(load, ""), A);
        let forces = &model.steps[0].distributed.forces;
        assert!(forces.iter().all(|own| !own.dof.is_rotation()));
        for (k, dof) in [Dof::U1, Dof::U2, Dof::U3].into_iter().enumerate() {
            let of = |node: usize| {
                let own = forces.iter().filter(|own| own.dof == dof && own.node == node);
                let turning = model.steps[0].distributed.pressures.iter().map(|own| {
                    let Pressed::Sections(shares) = &own.on else { return 0.0 };
                    let all = own.nodes.iter().zip(shares).filter(|(at, _)| **at == node);
                    all.map(|(_, share)| own.value * share[k]).sum()
                });
                own.map(|own| own.value).chain(turning).sum::<f64>()
            };
            for (node, share) in [0.25, 0.5, 0.25].into_iter().enumerate() {
                assert!((of(node) - share * expected[k]).abs() < 1e-12, "{load}");
            }
        }
    }
    assert!(codes(&deck("B, P1, 2.0", ", NLGEOM"), A).is_empty());
    assert_eq!(codes(&deck("B, P1, 2.0", ""), Dialect::Calculix), ["SL0221"]);
    // in the plane axis 2 is across the beam, axis 1 across the plane
    let plane = |load: &str| {
        deck(load, "").replace("B31", "B21").replace("0., 4.", "4.").replace("0., 8.", "8.")
    };
    assert_eq!(codes(&plane("B, P1, 2.0"), A), ["SL0221"]);
    let across = model(&plane("B, P2, 2.0"), A).steps[0].distributed.pressures[1].on.clone();
    let Pressed::Sections(shares) = across else { panic!("{across:?}") };
    for (share, expected) in shares[0].into_iter().zip([-2.0, 1.5, 0.0]) {
        assert!((share - expected).abs() < 1e-12, "{shares:?}");
    }
    assert_eq!(codes(&deck("B, P3, 2.0", ""), A), ["SL0256"]);
}

/// Requirement: tractions on a face of elements are those on a surface of these faces; faces that are
/// not there and tractions of user subroutines are refused, and what their card says of other loads
/// is told. Source: Abaqus manual, `*DLOAD`, `*DSLOAD`.
#[test]
fn tractions_on_faces() {
    let pulled = |load: &str| model(&deck(&step(load), &[]), A).steps[0].distributed.clone();
    for how in ["", ", FOLLOWER=NO", ", FOLLOWER=NO, CONSTANT RESULTANT=YES"] {
        for kind in ["TRVEC", "TRSHR"] {
            let surface = pulled(&format!("*DSLOAD{how}\nTOP, {kind}, 2.0, 0.8, 0.6, 0.0"));
            let faces = pulled(&format!("*DLOAD{how}\nALL, {kind}3, 2.0, 0.8, 0.6, 0.0"));
            let on = |own: &slideline_model::Distributed| {
                own.pressures.iter().map(|own| (own.on.clone(), own.nodes.clone())).collect()
            };
            let [one, other]: [Vec<_>; 2] = [on(&surface), on(&faces)];
            assert_eq!(one, other, "{how} {kind}");
            assert_eq!(surface.forces.len(), faces.forces.len(), "{how} {kind}");
        }
    }
    for (load, code) in [
        ("*DLOAD\nALL, TRVEC7, 1.0, 1.0", "SL0256"),
        ("*DLOAD\nALL, TRVEC3NU, 1.0, 1.0", "SL0221"),
        ("*DSLOAD\nTOP, TRVECNU, 1.0, 1.0", "SL0221"),
        ("*DLOAD\nALL, TRVEC3, 1.0", "SL0232"),
        ("*DLOAD\nALL, TRSHR3, 1.0, 0.0, 1.0", "SL0232"),
        ("*DLOAD\nALL, TRVEC3, 1.0, 0.0, 0.0, 1.0", "SL0251"),
    ] {
        assert_eq!(codes(&deck(&step(load), &[]), A), [code], "{load}");
    }
    for load in [
        "*DSLOAD, FOLLOWER=NO\nTOP, TRSHR, 1.0, 1.0",
        "*DSLOAD, FOLLOWER=NO\nTOP, P, 1.0",
        "*DLOAD, CONSTANT RESULTANT=YES\nALL, P3, 1.0",
    ] {
        let said = interpret(&deck(&step(load), &[]), A).diagnostics;
        assert!(said.iter().any(|own| own.code.0 == "SL0253"), "{load} {said:?}");
    }
}

/// Requirement: gravity that finds no mass, or cubic beams, is refused.
#[test]
fn gravity_needs_mass() {
    let cards = step("*DLOAD\n, GRAV, 9.81, 0.0, -1.0, 0.0");
    let light = [("*DENSITY\n3.0\n", "")];
    assert_eq!(codes(&deck(&cards, &light), A), ["SL0309"]);
    let beams = [
        ("*ELEMENT, TYPE=CPS4, ELSET=B\n2, 2, 3, 6, 5", "*ELEMENT, TYPE=B23, ELSET=B\n2, 5, 6"),
        (
            "*SOLID SECTION, ELSET=B, MATERIAL=M\n2.0",
            "*BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n1.0, 0.1",
        ),
        ("ALL, S3", "A, S3"),
    ];
    assert_eq!(codes(&deck(&cards, &beams), A), ["SL0221"]);
}

/// Requirement: a surface of one kind is not taken where another kind is meant.
#[test]
fn surfaces_have_a_kind() {
    let rigid = "*SURFACE, NAME=FLAT, TYPE=SEGMENTS\nSTART, 9.0, 0.0\nLINE, 0.0, 0.0\n";
    let cases = [
        step("*DSLOAD\nPOINTS, P, 1.0"),
        format!("{rigid}{}", step("*DSLOAD\nFLAT, P, 1.0")),
        format!(
            "*NODE\n9, 5.0, 0.0\n{rigid}*COUPLING, REF NODE=9, SURFACE=FLAT\n*KINEMATIC\n{}",
            step("*CLOAD\n6, 1, 1.0")
        ),
        format!("{rigid}*TIE, NAME=T\nFLAT, TOP\n{}", step("*CLOAD\n6, 1, 1.0")),
        format!("*TIE, NAME=T\nTOP, POINTS\n{}", step("*CLOAD\n6, 1, 1.0")),
    ];
    for cards in cases {
        assert!(codes(&deck(&cards, &[]), A).contains(&"SL0332"), "{cards}");
    }
    let lonely =
        "*COUPLING, REF NODE=3, SURFACE=ONE\n*KINEMATIC\n*SURFACE, NAME=ONE, TYPE=NODE\n3\n";
    let cards = format!("{lonely}{}", step("*CLOAD\n6, 1, 1.0"));
    assert_eq!(codes(&deck(&cards, &[]), A), ["SL0317"]);
}

/// Requirement: a material has one elasticity, one density, one hardening, and those go together.
#[test]
fn material_cards_do_not_clash() {
    let cases = [
        ("*DENSITY\n3.0\n", "*ELASTIC\n1.0\n", "SL0242"),
        ("*DENSITY\n3.0\n", "*HYPERELASTIC, NEO HOOKE\n1.0, 0.1\n", "SL0242"),
        ("*DENSITY\n3.0\n", "*DENSITY\n3.0\n*DENSITY\n3.0\n", "SL0242"),
        ("*DENSITY\n3.0\n", "*PLASTIC\n1.0\n*PLASTIC\n1.0\n", "SL0242"),
        ("*DENSITY\n3.0\n", "*DENSITY\n-3.0\n", "SL0234"),
        ("*ELASTIC\n200.0, 0.3\n", "*HYPERELASTIC, NEO HOOKE\n1.0, 0.1\n*PLASTIC\n1.0\n", "SL0309"),
        (
            "*ELASTIC\n200.0, 0.3\n",
            "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n2.0, 2.0, 2.0, 0.1, 0.1, 0.1, 1.0, 1.0,\n1.0\n*PLASTIC\n1.0\n",
            "SL0309",
        ),
    ];
    for (old, new, code) in cases {
        let found = codes(&deck(&step("*CLOAD\n6, 1, 1.0"), &[(old, new)]), A);
        assert_eq!(found, [code], "{new}");
    }
}

/// Requirement: loads of different kinds act together, those of one kind replace one another from
/// step to step (OP=MOD) and add up within one; OP=NEW removes its own. CalculiX tells gravities
/// by their directions and has one list. Source: both manuals, `*CLOAD`, `*DLOAD`, `*DSLOAD`.
#[test]
fn loads_are_known_by_their_kind() {
    let first = "*DLOAD\nALL, GRAV, 2.0, 0.0, -1.0, 0.0\nALL, BX, 5.0\nA, P3, 7.0\n*DSLOAD, FOLLOWER=NO, CONSTANT RESULTANT=YES\nTOP, TRVEC, 1.0, 1.0, 0.0, 0.0\nTOP, P, 11.0\n";
    let two = |second: &str, dialect| {
        model(&deck(&format!("{}{}", step(first), step(second)), &[]), dialect)
    };
    // per volume 4: gravity 2 x 3 x 4 down, body force 5 x 4 and traction 1 x 4 to the right
    let sums = |model: &Model, step: usize| -> [f64; 3] {
        let loads = &model.steps[step].distributed;
        let along = |dof| -> f64 {
            loads.forces.iter().filter(|load| load.dof == dof).map(|load| load.value).sum()
        };
        [along(Dof::U1), along(Dof::U2), loads.pressures.iter().map(|load| load.value).sum()]
    };
    let near = |found: [f64; 3], expected: [f64; 3]| {
        let close = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(close, "{found:?} {expected:?}");
    };
    let kept = two("*DLOAD\nB, GRAV, 1.0, 1.0, 0.0, 0.0", A);
    near(sums(&kept, 0), [24.0, -24.0, 29.0]);
    near(sums(&kept, 1), [30.0, -12.0, 29.0]);
    near(sums(&two("*DLOAD\nB, GRAV, 1.0, 1.0, 0.0, 0.0", C), 1), [30.0, -24.0, 29.0]);
    near(sums(&two("*DLOAD, OP=NEW\nALL, BX, 1.0", A), 1), [8.0, 0.0, 22.0]);
    near(sums(&two("*DLOAD, OP=NEW\nALL, BX, 1.0", C), 1), [4.0, 0.0, 0.0]);
    let twice = "*CLOAD\nRIGHT, 1, 1.0\n6, 1, 2.0\n6, 2, 4.0\n";
    let model = model(&deck(&format!("{}{}", step(twice), step("*CLOAD\n6, 1, 5.0")), &[]), A);
    let of = |step: usize, label: u64, dof| -> f64 {
        let node = model.nodes.find(label).expect("a node");
        let own =
            model.steps[step].loads.iter().filter(|load| (load.node, load.dof) == (node, dof));
        own.map(|load| load.value).sum()
    };
    assert_eq!([of(0, 3, Dof::U1), of(0, 6, Dof::U1), of(0, 6, Dof::U2)], [1.0, 3.0, 4.0]);
    assert_eq!([of(1, 3, Dof::U1), of(1, 6, Dof::U1), of(1, 6, Dof::U2)], [1.0, 5.0, 4.0]);
}

/// Requirement: supports in a part are those of the instance; an instance that turns them, or that
/// leaves the plane, is refused. `*NSET, ELSET=, INSTANCE=` takes the elements of the instance.
#[test]
fn parts_carry_supports_and_stay_in_the_plane() {
    let (mesh, rest) = SQUARES.split_once("*MATERIAL").expect("a material");
    let (material, support) = rest.split_once("*BOUNDARY").expect("a support");
    let of = |inside: &str, motion: &str| {
        format!(
            "*PART, NAME=P\n{mesh}{inside}*END PART\n*ASSEMBLY, NAME=Q\n*INSTANCE, NAME=P-1, PART=P\n\
             {motion}*END INSTANCE\n*NSET, NSET=OFA, ELSET=A, INSTANCE=P-1\n*END ASSEMBLY\n\
             *MATERIAL{material}{}",
            step("*CLOAD\nP-1.6, 1, 5000000000.0")
        )
    };
    let supports = format!("*BOUNDARY{support}");
    let model = model(&of(&supports, ""), A);
    assert_eq!(model.steps[0].prescribed.len(), 4);
    let members = model.node_sets.iter().find(|set| set.name == "OFA").map(|set| set.members.len());
    assert_eq!(members, Some(4));
    let quarter = "0.0, 0.0\n0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 90.0\n";
    assert_eq!(codes(&of(&supports, quarter), A), ["SL0258"]);
    let up = "0.0, 0.0\n0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 90.0\n";
    assert!(codes(&of("", up), A).contains(&"SL0258"));
    // a large number is said as it stands, a node by its name
    let inside = of("", "").replace("*STEP, NLGEOM", "*STEP, INC=5000000012");
    let said: Vec<String> =
        errors(&interpret(&inside, A)).iter().map(|found| found.message.clone()).collect();
    assert!(said.iter().any(|message| message.contains("5000000012")), "{said:?}");
}

/// Requirement: a tie that folds an element, or has a negative tolerance, is refused.
#[test]
fn ties_do_not_fold_elements() {
    let other = "*NODE\n11, 1.0, 1.3\n12, 3.0, 1.3\n13, 3.0, 1.1\n14, 1.0, 1.1\n\
        *ELEMENT, TYPE=CPS4, ELSET=C\n3, 11, 14, 13, 12\n\
        *SOLID SECTION, ELSET=C, MATERIAL=M\n2.0\n*SURFACE, NAME=LOW, TYPE=NODE\n11\n12\n";
    let tie = |more: &str| {
        let cards = format!("{other}*TIE, NAME=T{more}\nLOW, TOP\n{}", step("*CLOAD\n6, 1, 1.0"));
        codes(&deck(&cards, &[]), A)
    };
    assert_eq!(tie(", POSITION TOLERANCE=0.5, ADJUST=NO"), [""; 0]);
    assert_eq!(tie(", POSITION TOLERANCE=0.5"), ["SL0346"]);
    assert_eq!(tie(", POSITION TOLERANCE=-0.5"), ["SL0210"]);
}

/// Requirement: faces of a slave that lie upon two masters, in two ties, take their means over both, and every
/// node stands where what it follows is; where the slaves have only some faces in common, no node
/// follows itself.
#[test]
fn faces_lie_upon_the_masters_of_two_ties() {
    let other = "*NODE\n11, 1.0, 1.02\n12, 1.7, 1.02\n13, 2.4, 1.02\n14, 3.0, 1.02\n\
        21, 1.0, 2.0\n22, 1.7, 2.0\n23, 2.4, 2.0\n24, 3.0, 2.0\n\
        *ELEMENT, TYPE=CPS4, ELSET=C\n11, 11, 12, 22, 21\n12, 12, 13, 23, 22\n13, 13, 14, 24, 23\n\
        *SOLID SECTION, ELSET=C, MATERIAL=M\n2.0\n*SURFACE, NAME=LOW\nC, S1\n\
        *SURFACE, NAME=LOWER\n12, S1\n13, S1\n*SURFACE, NAME=MA\nA, S3\n*SURFACE, NAME=MB\nB, S3\n";
    let tied = |first: &str, second: &str| {
        let ties = format!("*TIE, NAME=T\n{first}, MA\n*TIE, NAME=U\n{second}, MB\n");
        deck(&format!("{other}{ties}{}", step("*CLOAD\n6, 1, 1.0")), &[])
    };
    assert_eq!(codes(&tied("LOW", "LOW"), A), [""; 0]);
    let model = model(&tied("LOW", "LOW"), A);
    assert_eq!(model.linear_constraints.len(), 8);
    for own in &model.linear_constraints {
        let axis = own.dependent.1 as usize;
        let at = |node| model.nodes.position(node)[axis];
        let followed: f64 = own.terms.iter().map(|&(node, _, share)| share * at(node)).sum();
        assert!((at(own.dependent.0) - followed).abs() < 1e-14, "{own:?}");
    }
    assert_eq!(codes(&tied("LOW", "LOWER"), A), [""; 0]);
    assert_eq!(codes(&tied("LOWER", "LOW"), A), [""; 0]);
}

/// Requirement: SHIFTX and SHIFTY move every kind of curve; a load that follows a curve over the
/// total time follows it through the steps. Source: both manuals, `*AMPLITUDE`.
#[test]
fn amplitudes_are_shifted_and_go_on() {
    let curves = "*AMPLITUDE, NAME=W, DEFINITION=PERIODIC, SHIFTX=0.5, SHIFTY=2.0\n1, 3.0, 0.25, 1.0\n0.0, 1.0\n\
        *AMPLITUDE, NAME=T, TIME=TOTAL TIME\n0.0, 0.0, 2.0, 4.0, 3.0, 9.0\n";
    let cards = format!(
        "{curves}{}{}{}",
        step("*CLOAD, AMPLITUDE=T\n6, 1, 10.0\n*CLOAD, AMPLITUDE=W\n3, 1, 1.0"),
        step("*CLOAD\n6, 2, 1.0"),
        step("*DLOAD\nALL, BX, 1.0")
    );
    let model = model(&deck(&cards, &[]), A);
    let wave = model.amplitude("W").expect("a curve");
    assert!(matches!(wave.curve, Curve::Periodic { start: 0.75, mean: 3.0, .. }));
    for (step, expected) in [(0, 2.0), (1, 4.0), (2, 9.0)] {
        let node = model.nodes.find(6).expect("a node");
        let load = model.steps[step]
            .loads
            .iter()
            .find(|load| (load.node, load.dof) == (node, Dof::U1))
            .expect("a load");
        let curve = &model.amplitudes[load.amplitude.expect("its curve")];
        assert_eq!(load.value * curve.at(1.0), 10.0 * expected, "{step}");
    }
}

/// Requirement: dofs from the last to the first are refused on every card that takes a range.
#[test]
fn ranges_of_dofs_ascend() {
    let cases = [
        "*BOUNDARY\n3, 2, 1\n".to_owned() + &step("*CLOAD\n6, 1, 1.0"),
        "*COUPLING, REF NODE=3, SURFACE=POINTS\n*KINEMATIC\n6, 1\n".to_owned()
            + &step("*CLOAD\n6, 1, 1.0"),
        "*KINEMATIC COUPLING, REF NODE=3\n6, 6, 1\n".to_owned() + &step("*CLOAD\n6, 1, 1.0"),
        "*COUPLING, REF NODE=3, SURFACE=POINTS\n*DISTRIBUTING\n6, 1\n".to_owned()
            + &step("*CLOAD\n6, 1, 1.0"),
    ];
    for cards in cases {
        assert_eq!(codes(&deck(&cards, &[]), A), ["SL0248"], "{cards}");
    }
}

/// Requirement: the width of a contact is one; where the solids of the slave differ it is asked
/// for.
#[test]
fn one_width() {
    let contact = "*NODE\n9, 5.0, 5.0\n*SURFACE, NAME=FLAT, TYPE=SEGMENTS\nSTART, 9.0, 2.0\nLINE, 0.0, 2.0\n\
        *RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE=9\n*SURFACE INTERACTION, NAME=I\n\
        *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n10.0\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nTOP, FLAT\n";
    let cards = format!("{contact}{}", step("*BOUNDARY\n9, 1, 6"));
    let thin = ("ELSET=B, MATERIAL=M\n2.0", "ELSET=B, MATERIAL=M\n1.0");
    assert_eq!(codes(&deck(&cards, &[]), A), [""; 0]);
    assert_eq!(codes(&deck(&cards, &[thin]), A), ["SL0332"]);
    let given = ("*SURFACE INTERACTION, NAME=I\n", "*SURFACE INTERACTION, NAME=I\n1.5\n");
    assert_eq!(model(&deck(&cards, &[thin, given]), A).contact_pairs[0].interaction.width, 1.5);
}

/// Requirement: equations that follow one another in a long row are put in order in time that
/// grows with their number, and a circle is still found.
#[test]
fn long_chains_of_equations() {
    let count = 20_000_u64;
    let mut cards = String::from("*NODE\n");
    for k in 0..count {
        cards += &format!("{}, {}.0, 7.0\n", 100 + k, k);
    }
    cards += "*EQUATION\n";
    for k in 1..count {
        cards += &format!("2\n{}, 1, 1.0, {}, 1, -1.0\n", 99 + k, 100 + k);
    }
    let began = std::time::Instant::now();
    let open = deck(&format!("{cards}{}", step("*CLOAD\n6, 1, 1.0")), &[]);
    assert_eq!(codes(&open, A), [""; 0]);
    assert!(began.elapsed().as_secs() < 20, "{:?}", began.elapsed());
    let closed =
        format!("{cards}2\n{}, 1, 1.0, 100, 1, -1.0\n{}", 99 + count, step("*CLOAD\n6, 1, 1.0"));
    assert_eq!(codes(&deck(&closed, &[]), A), ["SL0347"]);
}

/// Requirement: a section is cut through all its nodes: the own side gets nodes of its own, which
/// follow the others and the reference node along the normal; a surface that does not cut through
/// is refused. Source: docs/theory.md eq. (4.12).
#[test]
fn bolts_are_cut() {
    let cut = "*NODE\n100, 2.0, 5.0\n*SURFACE, NAME=CUT\n1, S2\n";
    let cards = format!(
        "{cut}*PRE-TENSION SECTION, SURFACE=CUT, NODE=100\n{}",
        step("*CLOAD\n100, 1, 1.0")
    );
    let parted = model(&deck(&cards, &[]), A);
    assert_eq!((parted.nodes.len(), parted.linear_constraints.len()), (9, 4));
    for constraint in &parted.linear_constraints {
        let (own, dof) = constraint.dependent;
        let other = constraint.terms[0].0;
        assert_eq!(parted.nodes.position(own), parted.nodes.position(other));
        assert_eq!((constraint.terms[0].1, constraint.terms[0].2), (dof, 1.0));
        let reference = parted.nodes.find(100).expect("a node");
        match dof {
            Dof::U1 => assert_eq!(constraint.terms[1], (reference, Dof::U1, 1.0)),
            _ => assert_eq!(constraint.terms.len(), 1),
        }
        let elements = parted.blocks.iter().flat_map(|block| &block.elements);
        let of: Vec<u64> =
            elements.filter(|e| e.nodes.contains(&own)).map(|element| element.label).collect();
        assert_eq!(of, [1]);
    }
    let turned = cards.replace("NODE=100\n", "NODE=100\n-2.0, 0.0\n");
    let turned = model(&deck(&turned, &[]), A);
    assert!(
        turned.linear_constraints.iter().any(|own| own.terms.iter().any(|term| term.2 == -1.0))
    );
    let outside = cards.replace("1, S2", "2, S2");
    assert_eq!(codes(&deck(&outside, &[]), A), ["SL0347"]);
    // a face in the middle of two rows of elements: joined round its end
    let row = "*NODE\n17, 1.0, 2.0\n18, 2.0, 2.0\n19, 3.0, 2.0\n*ELEMENT, TYPE=CPS4, ELSET=A\n\
        11, 4, 5, 18, 17\n12, 5, 6, 19, 18\n";
    assert_eq!(codes(&deck(&format!("{row}{cards}"), &[("ALL, S3", "A, S3")]), A), ["SL0347"]);
    let both = cards.replace("1, S2\n", "1, S2\n11, S2\n");
    let both = model(&deck(&format!("{row}{both}"), &[("ALL, S3", "A, S3")]), A);
    assert_eq!((both.nodes.len(), both.linear_constraints.len()), (13, 6));
    for (old, new) in [("SURFACE=CUT", "ELEMENT=1"), ("SURFACE=CUT, ", "")] {
        assert!(!codes(&deck(&cards.replace(old, new), &[]), A).is_empty(), "{new}");
    }
}

/// Requirement: elements without stiffness are read, with one note each; masses weigh if they have one, which
/// must not be negative or that of another element.
/// CalculiX leaves out members of sets that do not exist.
#[test]
fn elements_without_effect() {
    let masses = "*ELEMENT, TYPE=MASS, ELSET=HEAVY\n7, 3\n8, 6\n*MASS, ELSET=HEAVY\n1.0\n\
        *ELEMENT, TYPE=DASHPOTA, ELSET=DAMP\n9, 3, 6\n*DASHPOT, ELSET=DAMP\n\n1.0\n";
    let cards = |load: &str| format!("{masses}{}", step(load));
    let read = interpret(&deck(&cards("*CLOAD\n6, 1, 1.0"), &[]), A);
    assert!(errors(&read).is_empty(), "{:#?}", errors(&read));
    let notes = read.diagnostics.iter().filter(|found| found.code.0 == "SL0257").count();
    assert_eq!(notes, 3, "{:#?}", read.diagnostics);
    let weight = cards("*DLOAD\nHEAVY, GRAV, 1.0, 0.0, -1.0, 0.0");
    assert_eq!(codes(&deck(&weight, &[]), A), [""; 0]);
    for (old, new, code) in [
        ("*MASS, ELSET=HEAVY\n1.0\n", "", "SL0309"),
        ("*MASS, ELSET=HEAVY\n1.0", "*MASS, ELSET=HEAVY\n-1.0", "SL0234"),
        ("*MASS, ELSET=HEAVY", "*MASS, ELSET=DAMP", "SL0325"),
        ("*MASS, ELSET=HEAVY", "*MASS, ELSET=LIGHT", "SL0308"),
        ("-1.0, 0.0\n", "0.0, 1.0\n", "SL0251"),
    ] {
        let found = codes(&deck(&weight.replace(old, new), &[]), A);
        assert!(found.contains(&code), "{new}: {found:?}");
    }
    let absent = deck(&step("*CLOAD\n6, 1, 1.0"), &[("RIGHT\n3, 6", "RIGHT\n3, 6, 77")]);
    assert_eq!(codes(&absent, A), ["SL0304"]);
    assert_eq!(codes(&absent, C), [""; 0]);
}

/// Requirement: FIXED is a motion of its own, which needs a step before.
#[test]
fn fixed_supports() {
    let cards = format!("{}{}", step("*CLOAD\n6, 1, 1.0"), step("*BOUNDARY, FIXED\n6, 1"));
    let held = model(&deck(&cards, &[]), A);
    let fixed: Vec<bool> = held.steps[1].prescribed.iter().map(|own| own.fixed).collect();
    assert_eq!(fixed, [false, false, false, false, true]);
    assert_eq!(
        codes(&deck(&cards, &[("*BOUNDARY\nLEFT", "*BOUNDARY, FIXED\nLEFT")]), A),
        ["SL0214"]
    );
}

/// Requirement: what a parameter of another program asks for is called not supported, a slip of
/// the pen a slip.
#[test]
fn parameters_of_other_programs_are_named() {
    let linear = |of: &str| deck(&step("*CLOAD\n6, 1, 1.0").replace("*STATIC", of), &[]);
    assert_eq!(codes(&linear("*STATIC, RIKS"), A), ["SL0221"]);
    assert_eq!(codes(&linear("*STATIC, RICKS"), A), ["SL0202"]);
    let cyclic = deck(&step("*CLOAD, FOLLOWER\n6, 1, 1.0"), &[]);
    assert_eq!(codes(&cyclic, A), ["SL0221"]);
}

/// Requirement: nodes and elements that are filled in, copied and given in other axes stand where
/// the cards say. Source: Abaqus manual, `*NFILL`, `*NCOPY`, `*ELCOPY`, `*SYSTEM`, `*NODE`.
#[test]
fn mesh_cards() {
    let arm = |cards: &str| {
        let deck = format!(
            "{cards}*ELEMENT, TYPE=B21, ELSET=E\n1, 1, 2\n*BEAM SECTION, SECTION=RECT, ELSET=E, \
             MATERIAL=M\n1.0, 0.1\n*MATERIAL, NAME=M\n*ELASTIC\n200.0\n{}",
            step("*BOUNDARY\n1, 1, 6")
        );
        let read = interpret(&deck, A);
        (codes(&deck, A), read.model)
    };
    let places = |cards: &str| {
        let (codes, model) = arm(cards);
        assert_eq!(codes, [""; 0], "{cards}");
        let mut all: Vec<(u64, [f64; 3])> =
            model.nodes.iter().map(|node| (node.label, node.position)).collect();
        all.sort_by_key(|node| node.0);
        all
    };
    let ends =
        "*NODE, NSET=A\n1, 0.0, 0.0\n11, 0.0, 1.0\n*NODE, NSET=B\n5, 4.0, 0.0\n15, 8.0, 1.0\n";
    let filled = places(&format!("{ends}*NFILL, NSET=ALL\nA, B, 4, 1\n"));
    assert_eq!(filled.len(), 10);
    assert_eq!([filled[1], filled[7]], [(2, [1.0, 0.0, 0.0]), (13, [4.0, 1.0, 0.0])]);
    let row = "*NODE, NSET=A\n1, 1.0, 0.0\n";
    let shift = "*NCOPY, OLD SET=A, CHANGE NUMBER=1, SHIFT, MULTIPLE=3, NEW SET=C\n2.0, 0.0\n";
    let copied = places(&format!("{row}{shift}"));
    assert_eq!(copied.iter().map(|node| node.1[0]).collect::<Vec<_>>(), [1.0, 3.0, 5.0, 7.0]);
    let turned = places(&format!(
        "{row}*NCOPY, OLD SET=A, CHANGE NUMBER=1, SHIFT\n1.0, 0.0\n0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 90.0\n"
    ));
    assert_eq!(turned[1], (2, [0.0, 2.0, 0.0]));
    let axes = places(
        "*SYSTEM\n1.0, 2.0, 0.0, 1.0, 3.0, 0.0\n*NODE\n1, 5.0, 0.0\n2, 0.0, 5.0\n*SYSTEM\n*NODE\n3, 5.0, 0.0\n",
    );
    assert_eq!(
        axes.iter().map(|node| node.1).collect::<Vec<_>>(),
        [[1.0, 7.0, 0.0], [-4.0, 2.0, 0.0], [5.0, 0.0, 0.0]]
    );
    let round = places("*NODE, SYSTEM=C\n1, 2.0, 0.0\n2, 2.0, 90.0\n");
    assert!((round[1].1[0].abs() < 1e-15) && (round[1].1[1] - 2.0).abs() < 1e-15);
    let far = format!("{row}*NCOPY, OLD SET=A, CHANGE NUMBER=999999999, SHIFT\n2.0, 0.0\n");
    assert_eq!(arm(&far).0[0], "SL0224");
    assert_eq!(arm(&format!("{ends}*NFILL\nA, D, 4, 1\n")).0[0], "SL0304");
    let twins = "*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n11, 0.0, 1.0\n12, 1.0, 1.0\n*ELEMENT, TYPE=B21, ELSET=E\n\
        21, 1, 2\n*ELCOPY, OLD SET=E, ELEMENT SHIFT=10, SHIFT NODES=10, NEW SET=F\n*ELSET, ELSET=E\nF\n";
    let (found, model) = arm(twins);
    assert_eq!(found, [""; 0]);
    let copy = model.blocks.iter().flat_map(|block| &block.elements).find(|e| e.label == 31);
    let nodes = copy.expect("a copy").nodes;
    assert_eq!([nodes[0], nodes[1]].map(|node| model.nodes.label(node)), [11, 12]);
}

/// Requirement: shapes are kept by equations that every rigid motion fulfils, and a node that leaves
/// the shape does not; with NLGEOM they are kept in large motion, on nodes without own axes.
/// Source: docs/theory.md eqs (4.13), (4.14), (4.16), (4.17).
#[test]
fn shapes_are_kept() {
    let bricks = "*NODE\n1, 0.0, 0.0, 0.0\n2, 2.0, 0.0, 0.0\n3, 2.0, 1.0, 0.0\n4, 0.0, 1.0, 0.0\n\
        5, 0.0, 0.0, 1.0\n6, 2.0, 0.0, 1.0\n7, 2.0, 1.0, 1.0\n8, 0.0, 1.0, 1.0\n9, 0.5, 0.0, 0.0\n\
        10, 0.5, 0.25, 0.0\n20, 0.0, 0.0, 3.0\n*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
        *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1.0\n";
    let of =
        |mpc: &str| format!("{bricks}*MPC\n{mpc}*STEP\n*STATIC\n*CLOAD\n6, 1, 1.0\n*END STEP\n");
    let cases = [
        ("STRAIGHT, 1, 2, 9\n", 2),
        ("PLANE, 1, 2, 3, 10, 9\n", 2),
        ("PLANE, 1, 2, 3\n, 10, 9\n", 2),
        ("MEANROT, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 20\n", 1),
        ("LINK, 10, 7\n", 1),
        ("LINEAR, 9, 1, 2\n", 3),
    ];
    // a displacement and a small turn w: u = c + w x X; the mean rotation about z is w_z
    let (c, w) = ([0.3, -0.2, 0.7], [0.5, -1.1, 0.4]);
    for (mpc, count) in cases {
        let model = model(&of(mpc), A);
        assert_eq!(model.linear_constraints.len(), count, "{mpc}");
        let u = |(node, dof): (usize, Dof)| {
            let [x, y, z] = model.nodes.position(node);
            let turn = [w[1] * z - w[2] * y, w[2] * x - w[0] * z, w[0] * y - w[1] * x];
            match model.nodes.label(node) {
                20 => w[2],
                _ => c[dof as usize] + turn[dof as usize],
            }
        };
        for own in &model.linear_constraints {
            let sum: f64 = own.terms.iter().map(|&(node, dof, a)| a * u((node, dof))).sum();
            assert!((sum - u(own.dependent)).abs() < 1e-12, "{mpc} {own:?}");
        }
    }
    for broken in [
        "STRAIGHT, 1, 2, 10\n",
        "PLANE, 1, 2, 9, 10\n",
        "PLANE, 1, 2, 3, 5\n",
        "LINEAR, 9, 1\n",
        "LINK, 9, 9\n",
    ] {
        assert_eq!(codes(&of(broken), A), ["SL0347"], "{broken}");
    }
    for (mpc, count) in &cases[..5] {
        let large = of(mpc).replace("*STEP", "*STEP, NLGEOM");
        let own = model(&large, A);
        assert_eq!(own.shapes.len(), *count, "{mpc}");
        for shape in &own.shapes {
            let followed = &own.linear_constraints[shape.constraint];
            let all = followed.terms.iter().map(|term| term.0).chain([followed.dependent.0]);
            let all: Vec<usize> = all.collect();
            assert!(shape.nodes.iter().all(|node| all.contains(node)), "{mpc}");
        }
        let turned = large.replace("*STEP", "*TRANSFORM, NSET=T\n0., 1., 0., -1., 0., 0.\n*STEP");
        let first = mpc.split(',').nth(1).unwrap().trim();
        let turned = turned.replace("*MPC", &format!("*NSET, NSET=T\n{first}\n*MPC"));
        assert_eq!(codes(&turned, A), ["SL0221"], "{mpc}");
    }
    // nothing is left of the node between the others that could follow
    let held = of("STRAIGHT, 1, 2, 9\n").replace("*CLOAD", "*BOUNDARY\n9, 1, 3\n*CLOAD");
    assert_eq!(codes(&held.replace("*STEP", "*STEP, NLGEOM"), A), ["SL0315"]);
}

/// Requirement: `TIME DELAY` has a load follow its curve later by that time, and is refused where
/// there is no curve to be late; two delays of one curve are two curves. Source: CalculiX manual,
/// `*CLOAD`.
#[test]
fn a_delay_shifts_the_curve() {
    let curve = "*AMPLITUDE, NAME=UP\n0.0, 0.0, 1.0, 1.0\n";
    let cards = "*CLOAD, AMPLITUDE=UP, TIME DELAY=0.25\n6, 1, 1.0\n*BOUNDARY, AMPLITUDE=UP, TIME \
                 DELAY=0.5\n3, 1, 1, 0.1\n*DLOAD, AMPLITUDE=UP, TIME DELAY=0.25\nALL, BX, 1.0";
    let model = model(&deck(&format!("{curve}{}", step(cards)), &[]), C);
    let step = &model.steps[0];
    let at = |place: Option<usize>| {
        let curve = place.and_then(|place| model.amplitudes.get(place)).expect("a curve");
        [0.2, 0.5, 1.0].map(|time| curve.at(time))
    };
    assert_eq!(at(step.loads[0].amplitude), [0.0, 0.25, 0.75]);
    let moved = step.prescribed.iter().find(|own| own.value == 0.1).expect("a motion");
    assert_eq!(at(moved.amplitude), [0.0, 0.0, 0.5]);
    assert_eq!(at(step.distributed.forces[0].amplitude), [0.0, 0.25, 0.75]);
    assert_eq!(model.amplitudes.len(), 3);
    for wrong in
        ["*CLOAD, TIME DELAY=0.25\n6, 1, 1.0", "*CLOAD, AMPLITUDE=UP, TIME DELAY=1.0\n6, 1, 1.0"]
    {
        assert_eq!(codes(&deck(&self::step(wrong), &[]), C), ["SL0321"], "{wrong}");
    }
}

/// Requirement: a first linear step is the same with PERTURBATION, however it says that it is linear;
/// equations hold in all steps, so that one that ends is refused by one error. Source: decks as CAE
/// writes them, ccx 2.20.
#[test]
fn linear_steps_and_equations_that_end() {
    let load = "*CLOAD\n6, 1, 1.0";
    let said = |nlgeom: &str| step(load).replace(", NLGEOM", &format!("{nlgeom}, PERTURBATION"));
    for linear in ["", ", NLGEOM=NO"] {
        assert!(codes(&deck(&said(linear), &[]), A).is_empty(), "{linear}");
    }
    assert_eq!(codes(&deck(&said(", NLGEOM"), &[]), A), ["SL0221"]);
    let two = said("").repeat(2);
    assert!(codes(&deck(&two, &[]), A).is_empty());
    let behind = format!("{}{}", step(load).replace(", NLGEOM", ""), said(""));
    assert_eq!(codes(&deck(&behind, &[]), A), ["SL0221"]);
    assert_eq!(codes(&deck(&two, &[]), C), ["SL0221"]);
    let yields: &[(&str, &str)] = &[("*ELASTIC", "*PLASTIC\n1e6, 0.\n*ELASTIC")];
    assert_eq!(codes(&deck(&said(""), yields), A), ["SL0221"]);
    for ends in ["*EQUATION, REMOVE\n6, 2", "*EQUATION, REMOVE ALL"] {
        assert_eq!(codes(&deck(&step(&format!("{ends}\n{load}")), &[]), C), ["SL0221"], "{ends}");
    }
    let late = step(&format!("*EQUATION\n2\n6, 1, 1., 3, 1, -1.\n{load}"));
    assert_eq!(codes(&deck(&late, &[]), C), ["SL0214"]);
}

/// Requirement: six coefficients of expansion are read; those that shear in the dialect of CalculiX
/// alone, where they are known to be components of a tensor. Initial displacements have no effect in a
/// static step of ccx 2.20, and are refused in the other dialect.
#[test]
fn what_each_dialect_says_alone() {
    let expands = |row: &str| {
        let card = format!("*EXPANSION, TYPE=ANISO\n{row}\n*ELASTIC");
        deck(&step("*CLOAD\n6, 1, 1.0"), &[("*ELASTIC", card.as_str())])
    };
    let (sheared, plain) = ("1e-5, 2e-5, 3e-5, 1e-6, 0., 0.", "1e-5, 2e-5, 3e-5, 0., 0., 0., 20.");
    assert!(codes(&expands(sheared), C).is_empty() && codes(&expands(plain), A).is_empty());
    assert_eq!(codes(&expands(sheared), A), ["SL0221"]);
    let initial =
        format!("*INITIAL CONDITIONS, TYPE=DISPLACEMENT\n6, 1, 0.1\n{}", step("*CLOAD\n6, 1, 1."));
    assert!(codes(&deck(&initial, &[]), C).is_empty());
    assert_eq!(codes(&deck(&initial, &[]), A), ["SL0221"]);
}

/// Requirement: nodes give plane solids their thickness where the section asks for it and nowhere
/// else, as in ccx 2.20; one that is not even is refused, and Abaqus gives it to shells alone.
/// Source: CalculiX manual, `*NODAL THICKNESS`.
#[test]
fn nodes_give_a_thickness() {
    let bare: &[(&str, &str)] = &[("MATERIAL=M\n2.0", "MATERIAL=M")];
    let asking: &[(&str, &str)] = &[("MATERIAL=M\n2.0", "MATERIAL=M, NODAL THICKNESS\n2.0")];
    let with = |lines: &str| format!("*NODAL THICKNESS\n{lines}\n{}", step("*CLOAD\n6, 1, 1.0"));
    let even = with("LEFT, 0.5\nRIGHT, 0.5\n2, 0.5\n5, 0.5");
    let thicknesses = |model: &Model| -> Vec<f64> {
        let of = |block: &slideline_model::ElementBlock| match &block.section {
            slideline_model::Section::Solid(own) => own.thickness,
            _ => f64::NAN,
        };
        model.blocks.iter().map(of).collect()
    };
    assert_eq!(thicknesses(&model(&deck(&even, asking), C)), [0.5, 0.5]);
    assert_eq!(thicknesses(&model(&deck(&even, bare), C)), [1.0, 1.0]);
    assert_eq!(thicknesses(&model(&deck(&even, bare), A)), [1.0, 1.0]);
    assert!(codes(&deck(&even, &[]), C).is_empty());
    for uneven in ["LEFT, 0.5", "LEFT, 0.5\nRIGHT, 0.7\n2, 0.5\n5, 0.5"] {
        assert_eq!(codes(&deck(&with(uneven), asking), C), ["SL0221"], "{uneven}");
    }
}

/// Requirement: forms that change no result are taken with a note, and those beside them that do
/// are refused: turning forces in a step that turns, temperatures at points of a beam's section,
/// constants over fields. Source: decks of other people.
#[test]
fn forms_without_effect() {
    let load = "*CLOAD, FOLLOWER\n6, 1, 1.0";
    assert_eq!(codes(&deck(&step(load), &[]), A), ["SL0221"]);
    let linear = step(load).replace(", NLGEOM", "");
    let forms: &[(&str, &str)] = &[
        ("*MATERIAL, NAME=M", "*CONSTRAINT CONTROLS, PRINT=YES\n*MATERIAL, NAME=M"),
        ("ELSET=A, MATERIAL=M\n2.0", "ELSET=A, MATERIAL=M\n2.0, 5"),
        ("200.0, 0.3", "200.0, 0.3,, 1.0"),
        ("*END STEP", "*ELEMENT MATRIX OUTPUT, ELSET=ALL, STIFFNESS=YES\n*END STEP"),
    ];
    let read = interpret(&deck(&linear, forms), A);
    assert!(errors(&read).is_empty(), "{:#?}", errors(&read));
    let notes = read.diagnostics.iter().filter(|found| found.code.0 == "SL0257").count();
    assert_eq!(notes, 5, "{:#?}", read.diagnostics);
    let short = step("*CLOAD\n6, 1, 1.0\n*EL PRINT, POS=CENTROIDAL\nS");
    assert!(codes(&deck(&short, &[]), A).is_empty());
    assert_eq!(codes(&deck(&short.replace("POS=", "PO="), &[]), A), ["SL0202"]);
    let over: &[(&str, &str)] = &[("200.0, 0.3", "200.0, 0.3, 0.0, 1.0\n100.0, 0.3, 9.0, 2.0")];
    assert_eq!(codes(&deck(&linear, over), A), ["SL0209"]);
    let beam = |more: &str| {
        let section = format!("*BEAM SECTION, ELSET=R, MATERIAL=M, SECTION=RECT{more}\n1.0, 1.0\n");
        let beam = "*ELEMENT, TYPE=B21, ELSET=R\n9, 3, 6\n";
        deck(&format!("{beam}{section}{linear}"), &[])
    };
    assert!(codes(&beam(", TEMPERATURE=GRADIENTS, LUMPED=NO"), A).is_empty());
    assert_eq!(codes(&beam(", TEMPERATURE=VALUES"), A), ["SL0221"]);
}

/// Requirement: `<name>` stands for the value of the last *PARAMETER above, in data and behind `=`,
/// with arithmetic; a name without a value is one error. Source: Abaqus manual, parametric input.
#[test]
fn values_behind_names() {
    let parameters = "*PARAMETER\n# a comment\nE = 2.0e2; \nnu = 3.0/10 # behind it\nset = 'ALL'\n\
                      load = -sqrt(E*E)\nnode = 2*3\n*NODE\n1,";
    let exchanged: &[(&str, &str)] = &[
        ("*NODE\n1,", parameters),
        ("200.0, 0.3", "<E>, <nu>"),
        ("B, MATERIAL=M\n2.0", "B, MATERIAL=M\n<E>"),
    ];
    let cards = "*CLOAD\n<node>, 1, <load>\n*PARAMETER\nload = load/4\n*CLOAD\n3, 1, <load>\n*EL PRINT, ELSET=<set>\nS";
    let plain = [("B, MATERIAL=M\n2.0", "B, MATERIAL=M\n200.0")];
    let same = "*CLOAD\n6, 1, -200.0\n*CLOAD\n3, 1, -50.0\n*EL PRINT, ELSET=ALL\nS";
    let (own, other) =
        (model(&deck(&step(cards), exchanged), A), model(&deck(&step(same), &plain), A));
    let sections = |model: &Model| {
        model.blocks.iter().map(|block| format!("{:?}", block.section)).collect::<Vec<_>>()
    };
    assert_eq!(sections(&own), sections(&other));
    let loads = |model: &Model| {
        model.steps[0].loads.iter().map(|own| (own.node, own.dof, own.value)).collect::<Vec<_>>()
    };
    assert_eq!(loads(&own), loads(&other));
    let missing = deck(&step("*CLOAD\n6, 1, <Load>\n3, 1, <Load>"), exchanged);
    assert_eq!(codes(&missing, A), ["SL0286"]);
    let broken = deck(
        &step(cards),
        &[&[("3.0/10", "3/10")], exchanged].concat().into_iter().rev().collect::<Vec<_>>(),
    );
    assert_eq!(codes(&broken, A), ["SL0286"]);
}

/// Requirement: foam and deformation plasticity neither yield nor relax nor creep, and are no beams:
/// refused, not passed over. Source: Abaqus manual, the laws that they go with.
#[test]
fn laws_that_stand_alone() {
    let foam = "*HYPERFOAM\n1.0, 4.0, 0.2";
    let metal = "*DEFORMATION PLASTICITY\n200.0, 0.3, 1.0, 4.0, 0.5";
    let load = step("*CLOAD\n6, 1, 1.0");
    for law in [foam, metal] {
        let with = |more: &str| {
            let law = format!("{law}\n{more}");
            codes(&deck(&load, &[("*ELASTIC\n200.0, 0.3\n", law.as_str())]), A)
        };
        assert!(with("").is_empty(), "{law}: {:?}", with(""));
        assert_eq!(with("*PLASTIC\n1.0, 0.0\n"), ["SL0309"], "{law}");
        assert_eq!(with("*VISCOELASTIC, TIME=PRONY\n0.5, 0.0, 1.0\n"), ["SL0309"], "{law}");
        assert_eq!(with("*CREEP, LAW=TIME\n1e-9, 3.0, 0.0\n"), ["SL0309"], "{law}");
        assert_eq!(with("*ELASTIC\n200.0, 0.3\n"), ["SL0242"], "{law}");
        let beam = format!(
            "*ELEMENT, TYPE=B21, ELSET=R\n9, 3, 6\n*BEAM SECTION, ELSET=R, MATERIAL=M, SECTION=RECT\n\
             1.0, 1.0\n{load}"
        );
        let law = format!("{law}\n");
        let found = codes(&deck(&beam, &[("*ELASTIC\n200.0, 0.3\n", law.as_str())]), A);
        assert_eq!(found, ["SL0309"], "{law}");
    }
    for wrong in [
        "*HYPERFOAM\n1.0, 0.0, 0.2",
        "*HYPERFOAM\n1.0, 4.0, 0.5",
        "*HYPERFOAM\n-1.0, 4.0, 0.2",
        "*DEFORMATION PLASTICITY\n200.0, 0.3, 0.0, 4.0, 0.5",
        "*DEFORMATION PLASTICITY\n200.0, 0.3, 1.0, 0.5, 0.5",
        "*DEFORMATION PLASTICITY\n200.0, 0.3, 1.0, 4.0, 0.0",
    ] {
        let law = format!("{wrong}\n");
        let found = codes(&deck(&load, &[("*ELASTIC\n200.0, 0.3\n", law.as_str())]), A);
        assert_eq!(found, ["SL0234"], "{wrong}");
    }
}

/// Faces of the two squares: the top of each, and a surface that joins what `data` names.
fn joined(parameters: &str, data: &str) -> String {
    format!(
        "*SURFACE, NAME=TA\nA, S3\n*SURFACE, NAME=TB\nB, S3\n*SURFACE, NAME=BOTH{parameters}\n{data}\n{}",
        step("*DSLOAD\nBOTH, P, 1.0")
    )
}

/// Requirement: the union of surfaces presses on the faces of all of them, on each once; what is not
/// a union of faces is refused. Source: Abaqus, `*SURFACE`, COMBINE.
#[test]
fn surfaces_are_united() {
    let faces = |data: &str| {
        let model = model(&deck(&joined(", COMBINE=UNION", data), &[]), A);
        model.steps[0].distributed.pressures.len()
    };
    assert_eq!(faces("TA, TB"), 2);
    assert_eq!(faces("TA,\nTB"), 2);
    assert_eq!(faces("TA, TOP, TA"), 2);
    let refused = |parameters: &str, data: &str| codes(&deck(&joined(parameters, data), &[]), A);
    assert_eq!(refused(", COMBINE=DIFFERENCE", "TA, TB"), ["SL0221"]);
    assert_eq!(refused(", COMBINE=UNION", "TA, TC"), ["SL0327"]);
    assert_eq!(refused(", COMBINE=UNION", "TA, POINTS"), ["SL0332"]);
}

/// Requirement: where a curve of CalculiX has two values at one time it jumps to the later one; in
/// the other dialect, and where time goes back, that is refused. Source: CalculiX, `*AMPLITUDE`.
#[test]
fn curves_jump_in_calculix() {
    let cards = |points: &str| {
        format!("*AMPLITUDE, NAME=J\n{points}\n{}", step("*CLOAD, AMPLITUDE=J\n6, 1, 1.0"))
    };
    let jump = deck(&cards("0.0, 0.0, 0.5, 1.0, 0.5, 3.0, 1.0, 3.0"), &[]);
    let model = model(&jump, Dialect::Calculix);
    let curve = model.amplitude("J").expect("a curve");
    assert_eq!([0.0, 0.25, 0.5, 0.75].map(|time| curve.at(time)), [0.0, 0.5, 3.0, 3.0]);
    assert_eq!(codes(&jump, A), ["SL0249"]);
    let back = deck(&cards("0.0, 0.0, 0.5, 1.0, 0.4, 3.0"), &[]);
    assert_eq!(codes(&back, Dialect::Calculix), ["SL0249"]);
}

/// Requirement: friction of a gap is refused as such, not as a law without an owner.
#[test]
fn gaps_do_not_rub() {
    let gap = "*ELEMENT, TYPE=GAPUNI, ELSET=G\n9, 6, 5\n*GAP, ELSET=G\n0.1, 1.0, 0.0, 0.0\n*FRICTION\n0.3\n";
    let text = deck(&format!("{gap}{}", step("*CLOAD\n6, 1, 1.0")), &[]);
    let said = errors(&interpret(&text, A));
    let said: Vec<_> = said.iter().map(|own| (own.code.0, own.message.as_str())).collect();
    assert_eq!(said, [("SL0221", "*FRICTION of *GAP is not supported: gaps do not rub")]);
}

/// Requirement: CalculiX' rigid body needs no reference node: one of its own stands in the middle of its
/// nodes, above all labels, and a note says so; Abaqus' needs one.
#[test]
fn a_body_without_a_reference_node() {
    let cards = format!("*RIGID BODY, NSET=RIGHT\n{}", step("*CLOAD\n6, 1, 1.0"));
    assert_eq!(codes(&deck(&cards, &[]), A), ["SL0205"]);
    let profile = cards.replace("NSET=RIGHT", "ANALYTICAL SURFACE=P");
    assert!(codes(&deck(&profile, &[]), C).contains(&"SL0205"));
    let read = model(&deck(&cards, &[]), C);
    let last = (0..read.nodes.len()).max_by_key(|&node| read.nodes.label(node)).unwrap();
    let [third, sixth] = [3, 6].map(|label| read.nodes.position(read.nodes.find(label).unwrap()));
    for axis in 0..3 {
        let middle = 0.5 * (third[axis] + sixth[axis]);
        assert!((read.nodes.position(last)[axis] - middle).abs() < 1e-14);
    }
    assert_eq!(read.rigid_links.iter().filter(|link| link.master == last).count(), 2);
    let notes = interpret(&deck(&cards, &[]), C).diagnostics;
    let said = |text: &str| notes.iter().any(|note| note.message.contains(text));
    assert!(said("names no REF NODE"), "{notes:#?}");
}
