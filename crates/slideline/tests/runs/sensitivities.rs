//! Derivatives by direct differentiation against differences of whole runs.

#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout)] // a test may fail where it stands

use crate::sensitivity_decks::{Response, Varied, motion, reaction};
use slideline::model::Dof;

/// A beam under a rigid circle that presses and is dragged.
fn leaf(law: &str, pair: &str) -> String {
    format!(
        "*PARAMETER\nthickness = 1.0\nmodulus = 210000.0\nmu = 0.2\nx = 30.3\npush = 1.0\n\
         middle = x - 0.0\nleft = x + 8.0\nright = x - 8.0\ndown = -push\n\
         *NODE, NSET=BEAM\n1, 0.0, 0.0\n31, 60.0, 0.0\n*NGEN, NSET=BEAM\n1, 31, 1\n\
         *ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 30, 1, 1\n\
         *BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n10.0, <thickness>\n\
         *MATERIAL, NAME=M\n*ELASTIC\n<modulus>, 0.3\n*NODE\n900, <x>, 8.05\n\
         *SURFACE, NAME=ROLLER, TYPE=SEGMENTS\nSTART, <left>, 8.05\n\
         CIRCL, <middle>, 0.05, <middle>, 8.05\nCIRCL, <right>, 8.05, <middle>, 8.05\n\
         *RIGID BODY, REF NODE=900, ANALYTICAL SURFACE=ROLLER\n\
         {pair}*SURFACE INTERACTION, NAME=TOUCH\n10.0\n*FRICTION\n<mu>\n{law}\
         *STEP, NLGEOM, INC=400\n*STATIC, DIRECT\n0.1, 1.0\n*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n\
         *BOUNDARY\n1, 1, 6\n900, 1\n900, 6\n\
         900, 2, 2, <down>\n*END STEP\n\
         *STEP, NLGEOM, INC=400\n*STATIC, DIRECT\n0.1, 1.0\n*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n\
         *BOUNDARY\n900, 1, 1, 1.0\n*END STEP\n"
    )
}

const PARAMETERS: [(&str, f64); 5] =
    [("thickness", 1.0), ("modulus", 210000.0), ("mu", 0.2), ("x", 30.3), ("push", 1.0)];

const INTEGRATED: &str = "*SURFACE, NAME=TOP, TYPE=ELEMENT\nBEAM, SPOS\n\
    *CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE, NO THICKNESS\nTOP, ROLLER\n";
const AT_NODES: &str = "*SURFACE, NAME=TOP, TYPE=NODE\nBEAM\n\
    *CONTACT PAIR, INTERACTION=TOUCH, TYPE=NODE TO SURFACE\nTOP, ROLLER\n";

const OF_ROLLER: [Response; 5] = [
    |frame| motion(frame, 31, Dof::U2),
    |frame| reaction(frame, 900, Dof::U1),
    |frame| reaction(frame, 900, Dof::U2),
    |frame| frame.energy.strain_energy,
    |frame| frame.energy.friction_dissipation,
];

/// Requirement: derivatives of motions, reactions and energies with contact that is integrated along
/// beams and rubs, by section, material, friction, geometry and motion, are those of differences.
#[test]
fn a_beam_under_a_circle_with_friction() {
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 40.0\n";
    let deck = Varied::new(&leaf(law, INTEGRATED), &PARAMETERS, &OF_ROLLER);
    let seen = deck.check(&[1e-4, 1e-4, 1e-4, 1e-5, 1e-4], 1e-6);
    assert!(seen.one_sided.iter().flatten().all(|one| !one));
}

/// Requirement: the same with hard contact at nodes.
#[test]
fn nodes_on_a_hard_circle_with_friction() {
    let deck = Varied::new(&leaf("", AT_NODES), &PARAMETERS, &OF_ROLLER);
    let seen = deck.check(&[1e-5], 1e-6);
    assert!(seen.one_sided.iter().flatten().all(|one| !one));
}

/// Requirement: where a hard contact just touches at the end of an increment, the reaction has a kink by
/// the motion: the derivative is that of one side, zero or the stiffness, and is marked from there on, for
/// friction remembers; by the thickness nothing changes there, and nothing is marked.
#[test]
fn a_change_of_status_is_marked() {
    let text = leaf("", AT_NODES).replace("30.3", "30.0").replace("push = 1.0", "push = 0.5");
    let parameters = [("push", 0.5), ("thickness", 1.0)];
    let seen = Varied::new(&text, &parameters, &OF_ROLLER).differentiated();
    assert!(seen.one_sided[0].iter().all(|one| *one), "{:?}", seen.one_sided);
    assert!(!seen.one_sided[1][0], "{:?}", seen.one_sided);
    // a tenth of the motion, on a cantilever of 30 mm: 3 EI/l^3, softened by nothing
    let stiffness = 3.0 * 210_000.0 * (10.0 / 12.0) / 30.0_f64.powi(3);
    let touches = seen.rates[0][0][2].abs();
    assert!(
        touches < 1e-9 * stiffness || (touches / (0.1 * stiffness) - 1.0).abs() < 0.01,
        "{touches}"
    );
}

/// Solids pressed on one another and dragged: nodes on faces, hard, with friction.
fn blocks() -> String {
    let deck = include_str!("../../../../corpus/sound/solid_blocks_mm.inp");
    let names = "*PARAMETER\nmodulus = 2600.0\nnu = 0.35\nmu = 0.2\nwidth = 5.0\nlift = 0.8\n\
                 press = -0.02\ndrag = 0.1\n";
    let controls = "*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n*BOUNDARY\n";
    let deck = deck
        .replace("2600.0, 0.35", "<modulus>, <nu>")
        .replace("\n5.0\n", "\n<width>\n")
        .replace("\n0.2\n", "\n<mu>\n")
        .replace(", 0.8\n", ", <lift>\n")
        .replace("-0.02", "<press>")
        .replace("TOP, 1, 1, 0.4", "TOP, 1, 1, <drag>")
        .replace("*STATIC\n0.5, 1.0", "*STATIC, DIRECT\n0.5, 1.0")
        .replace("*STATIC\n0.1, 1.0, 1.0E-5, 0.1", "*STATIC, DIRECT\n0.2, 1.0")
        .replace("*BOUNDARY\nTOP", &format!("{controls}TOP"));
    deck.replacen("*NODE\n", &format!("{names}*NODE\n"), 1)
}

/// Requirement: derivatives of solids with hard contact and friction, by material, section, places of
/// nodes and motion.
#[test]
fn solids_on_one_another() {
    let parameters = [
        ("modulus", 2600.0),
        ("nu", 0.35),
        ("mu", 0.2),
        ("width", 5.0),
        ("lift", 0.8),
        ("press", -0.02),
        ("drag", 0.1),
    ];
    let responses: [Response; 4] = [
        |frame| motion(frame, 102, Dof::U2),
        |frame| reaction(frame, 110, Dof::U1),
        |frame| reaction(frame, 4, Dof::U2),
        |frame| frame.energy.strain_energy,
    ];
    let seen = Varied::new(&blocks(), &parameters, &responses).check(&[1e-4], 1e-6);
    // the symmetric part of the tangent finds the run, but no derivatives
    let symmetric = blocks().replace("*STEP, NLGEOM", "*STEP, NLGEOM, UNSYMM=NO");
    assert_ne!(symmetric, blocks());
    Varied::new(&symmetric, &parameters, &responses).check(&[1e-4], 1e-6);
    // the tangent tells of what moves no places: two models each, and no step of four
    for (own, models) in parameters.iter().zip(&seen.models) {
        assert_eq!(*models == 2, own.0 != "lift", "{}: {models}", own.0);
    }
}

/// A square that stands on its corner is pressed into a row of squares and dragged; `pair` names both sides.
fn corner(pair: &str) -> String {
    let mut deck = String::from(
        "*PARAMETER\nmodulus = 1000.0\nmu = 0.2\npress = 0.06\nx = 0.4\nlow = -0.01\ndown = -press\nleft = -x\n*NODE\n",
    );
    for k in 0..5 {
        let x = 0.5 * f64::from(k) - 0.87;
        deck += &format!("{}, {x:?}, -1.0\n{}, {x:?}, 0.0\n", 1 + k, 11 + k);
    }
    deck += "100, 0.0, <low>\n101, <x>, 0.4\n102, 0.0, 0.8\n103, <left>, 0.4\n\
             *ELEMENT, TYPE=CPE4, ELSET=ROW\n1, 1, 2, 12, 11\n2, 2, 3, 13, 12\n3, 3, 4, 14, 13\n\
             4, 4, 5, 15, 14\n*ELEMENT, TYPE=CPE4, ELSET=SQUARE\n9, 100, 101, 102, 103\n\
             *SOLID SECTION, ELSET=ROW, MATERIAL=M\n1.0\n*SOLID SECTION, ELSET=SQUARE, MATERIAL=M\n1.0\n\
             *MATERIAL, NAME=M\n*ELASTIC\n<modulus>, 0.3\n*SURFACE, NAME=TOP\nROW, S3\n\
             *SURFACE, NAME=TIP\nSQUARE, S1\nSQUARE, S4\n*SURFACE INTERACTION, NAME=DRY\n*FRICTION\n<mu>\n";
    deck += &format!("*CONTACT PAIR, INTERACTION=DRY, {pair}\n");
    deck += "*NSET, NSET=LOW, GENERATE\n1, 5\n*NSET, NSET=HEAD\n101, 102, 103\n*BOUNDARY\nLOW, 1, 2\n\
             *STEP, NLGEOM\n*STATIC, DIRECT\n0.2, 1.0\n*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n\
             *BOUNDARY\nHEAD, 1, 1, 0.05\nHEAD, 2, 2, <down>\n*END STEP\n";
    deck
}

/// Requirement: derivatives where a sharp edge is held, of the slave over faces and of the master.
#[test]
fn a_corner_that_is_held() {
    let parameters =
        [("modulus", 1000.0), ("mu", 0.2), ("press", 0.06), ("x", 0.4), ("low", -0.01)];
    let responses: [Response; 4] = [
        |frame| reaction(frame, 102, Dof::U1),
        |frame| reaction(frame, 102, Dof::U2),
        |frame| motion(frame, 100, Dof::U2),
        |frame| frame.energy.strain_energy,
    ];
    for pair in ["TYPE=SURFACE TO SURFACE\nTIP, TOP", "TYPE=NODE TO SURFACE\nTOP, TIP"] {
        Varied::new(&corner(pair), &parameters, &responses).check(&[1e-4], 1e-5);
    }
}

/// The same square tipped by 25 degrees, held softly and tipped further: at its tip one face counts in part.
fn tipped() -> String {
    let pair = "TYPE=NODE TO SURFACE\nTIP, TOP";
    let law = "*FRICTION\n<mu>\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n<stiff>\n";
    corner(pair)
        .replace("press = 0.06", "press = 0.06\nstiff = 2000.0\nmore = -1.2*press")
        .replace(
            "101, <x>, 0.4\n102, 0.0, 0.8\n103, <left>, 0.4",
            "101, 0.54, 0.24\n102, 0.29, 0.78\n103, <left>, 0.53",
        )
        .replace("*FRICTION\n<mu>\n", law)
        .replace("HEAD, 2, 2, <down>", "101, 2, 2, <more>\n102, 2, 2, <down>\n103, 2, 2, <down>")
}

/// Requirement: derivatives where a face at a slave node counts in part, which changes with what the node has done before, are those
/// of differences, and the run keeps its bits. Source: docs/theory.md 5.21.
#[test]
fn a_tip_whose_faces_count_in_part() {
    let parameters = [
        ("modulus", 1000.0),
        ("mu", 0.2),
        ("press", 0.06),
        ("stiff", 2000.0),
        ("x", 0.25),
        ("low", -0.01),
    ];
    let responses: [Response; 5] = [
        |frame| reaction(frame, 102, Dof::U1),
        |frame| reaction(frame, 102, Dof::U2),
        |frame| motion(frame, 100, Dof::U2),
        |frame| frame.energy.strain_energy,
        |frame| frame.pairs[0].area,
    ];
    let deck = tipped().replace("x = 0.4", "x = 0.25");
    let seen = Varied::new(&deck, &parameters, &responses).check(&[1e-4], 1e-6);
    let area = |of: usize| (parameters[of].1 * seen.rates[of][4][4]).abs();
    assert!((0..6).all(|of| area(of) > 1e-6), "{:?}", seen.rates);
}

/// A block over two others, spread over faces that rub, pressed down; `moved` moves its nodes.
fn stuck_block() -> String {
    String::from(
        "*PARAMETER\nmoved = 0.7\nright = 2.0 + moved\npress = -0.012\nmu = 0.25\nstiff = 5000.0\n\
         modulus = 1000.0\n*NODE\n1, 0., 0.\n2, 2., 0.\n3, 4., 0.\n4, 0., 2.\n5, 2., 2.\n6, 4., 2.\n\
         101, <moved>, 2.01\n102, <right>, 2.01\n103, <moved>, 4.01\n104, <right>, 4.01\n\
         *ELEMENT, TYPE=CPE4, ELSET=A\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*ELEMENT, TYPE=CPE4, ELSET=B\n\
         101, 101, 102, 104, 103\n*NSET, NSET=BOTTOM\n1, 2, 3\n*NSET, NSET=TOP\n103, 104\n\
         *SOLID SECTION, ELSET=A, MATERIAL=M\n1.\n*SOLID SECTION, ELSET=B, MATERIAL=N\n1.\n\
         *MATERIAL, NAME=M\n*ELASTIC\n<modulus>, 0.3\n*MATERIAL, NAME=N\n*ELASTIC\n500., 0.3\n\
         *SURFACE, NAME=SA\nA, S3\n*SURFACE, NAME=SB\nB, S1\n*SURFACE INTERACTION, NAME=I\n\
         *FRICTION\n<mu>\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n<stiff>\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nSB, SA\n*STEP, NLGEOM\n\
         *STATIC, DIRECT\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n*BOUNDARY\n\
         BOTTOM, 1, 2\nTOP, 1, 1\nTOP, 2, 2, <press>\n*END STEP\n",
    )
}

/// Requirement: a parameter that moves places leaves nothing behind for the next one: where faces stood at the
/// last commit, and what slips count from, is that of each model.
#[test]
fn moved_places_are_those_of_one_parameter() {
    let all =
        [("moved", 0.7), ("press", -0.012), ("mu", 0.25), ("stiff", 5000.0), ("modulus", 1000.0)];
    let responses: [Response; 3] = [
        |frame| reaction(frame, 103, Dof::U2),
        |frame| reaction(frame, 103, Dof::U1),
        |frame| motion(frame, 101, Dof::U1),
    ];
    let mut back = all;
    back.reverse();
    for parameters in [all, back] {
        Varied::new(&stuck_block(), &parameters, &responses).check(&[1e-4], 1e-5);
    }
}

/// What else a frame holds: rows of contact and of its pairs, of beams, energies.
const OF_FRAMES: [Response; 8] = [
    |frame| frame.contact.iter().map(|row| row.pressure).sum(),
    |frame| frame.contact.iter().map(|row| row.shear[0]).sum(),
    |frame| frame.pairs[0].force[0],
    |frame| frame.pairs[0].force[1],
    |frame| frame.pairs[0].energy,
    |frame| frame.beams.iter().map(|row| row.fibre_strain.abs()).fold(0.0, f64::max),
    |frame| frame.energy.external_work,
    |frame| frame.energy.contact_energy + frame.energy.friction_elastic,
];

/// Requirement: whatever a frame holds is differentiated, of contact at nodes with a law that is a
/// function and friction with elastic slip; by what moves no places with two models a parameter.
#[test]
fn frames_of_nodes_on_a_soft_circle() {
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 40.0\n";
    let parameters = [("thickness", 1.0), ("modulus", 210000.0), ("mu", 0.2), ("push", 1.0)];
    let mut responses = OF_FRAMES.to_vec();
    responses.extend(OF_ROLLER);
    let deck = Varied::new(&leaf(law, AT_NODES), &parameters, &responses);
    let seen = deck.check(&[1e-4, 1e-4, 1e-3, 1e-5], 1e-6);
    assert_eq!(seen.models, [2; 4]);
    assert!(seen.one_sided.iter().flatten().all(|one| !one));
}

/// Requirement: the same of contact that is integrated along beams, whose integration points follow the closed
/// parts of their cells, by section, material, friction, motion, the clearance at which contact begins and the width; with the
/// surface at the line of the beam and at its face. By all of them but what moves places one or two pairs of models tell.
#[test]
fn frames_of_a_beam_along_a_soft_circle() {
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n<clearance>, 40.0\n";
    let parameters = [
        ("thickness", 1.0),
        ("modulus", 210000.0),
        ("mu", 0.2),
        ("push", 1.0),
        ("clearance", 0.01),
        ("width", 10.0),
    ];
    let mut responses = OF_FRAMES.to_vec();
    responses.extend(OF_ROLLER);
    let deck = leaf(law, INTEGRATED)
        .replace("*PARAMETER\n", "*PARAMETER\nclearance = 0.01\nwidth = 10.0\n")
        .replace("NAME=TOUCH\n10.0\n", "NAME=TOUCH\n<width>\n");
    let below = deck.replace("1, 0.0, 0.0\n31, 60.0, 0.0", "1, 0.0, -0.5\n31, 60.0, -0.5");
    let at_face = below.replace(", NO THICKNESS", "").replace(
        "*CONTACT PAIR",
        "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=THICKNESS\nTOP, ORIGINAL\n*CONTACT PAIR",
    );
    for (deck, moves_places) in [(deck, None), (at_face, Some(0))] {
        let seen = Varied::new(&deck, &parameters, &responses)
            .check(&[1e-4, 1e-4, 1e-3, 1e-5, 5e-4, 1e-3], 2e-6);
        for (k, models) in seen.models.iter().enumerate() {
            assert_eq!(*models <= 4, Some(k) != moves_places, "{k}: {models}");
        }
        assert!(seen.one_sided.iter().flatten().all(|one| !one));
    }
}

/// A strip that yields, is unloaded and yields again, held by loads.
const PLASTIC: &str = "*PARAMETER\nmodulus = 1000.0\nyield = 10.0\nhard = 15.0\nload = 11.5\n\
    back = -11.0\nlength = 2.0\n*NODE\n1, 0, 0\n2, <length>, 0\n3, <length>, 1.1\n4, 0, 1\n\
    5, 4, 0\n6, 4, 0.8\n*ELEMENT, TYPE=CPE4, ELSET=ALL\n1, 1, 2, 3, 4\n2, 2, 5, 6, 3\n\
    *SOLID SECTION, ELSET=ALL, MATERIAL=M\n1.0\n*MATERIAL, NAME=M\n*ELASTIC\n<modulus>, 0.3\n\
    *PLASTIC\n<yield>, 0.0\n<hard>, 0.05\n*BOUNDARY\n1, 1, 2\n4, 1\n";

fn plastic() -> String {
    let step = |loads: &str| {
        format!(
            "*STEP, NLGEOM, INC=100\n*STATIC, DIRECT\n0.1, 1.0\n*CONTROLS, PARAMETERS=FIELD\n\
             1e-11, 1e-8\n*CLOAD\n5, 1, {loads}\n6, 1, {loads}\n*END STEP\n"
        )
    };
    let halves = "load2 = load/2.2\nback2 = back/2.2\n";
    let text = PLASTIC.replace("length = 2.0\n", &format!("length = 2.0\n{halves}"));
    text + &step("<load2>") + &step("<back2>")
}

/// Requirement: the history of plastic strain counts, over loading, unloading and yielding back.
#[test]
fn plastic_history() {
    let parameters = [
        ("modulus", 1000.0),
        ("yield", 10.0),
        ("hard", 15.0),
        ("load", 11.5),
        ("back", -11.0),
        ("length", 2.0),
    ];
    let responses: [Response; 4] = [
        |frame| motion(frame, 5, Dof::U1),
        |frame| motion(frame, 6, Dof::U2),
        |frame| frame.energy.strain_energy,
        |frame| frame.energy.material_dissipation,
    ];
    Varied::new(&plastic(), &parameters, &responses).check(&[1e-5], 1e-6);
}

/// Requirement: every increment of a deck of the paper has its derivatives, also where the program has
/// looked for jumps behind it. Source: the deck of the paper with friction.
#[test]
fn no_increment_is_left_out() {
    let names = "*PARAMETER\nt = 1.5E-3\nmu = 0.3\n";
    let deck = include_str!("../../../../corpus/diehl1995/irs_fine_mu03.inp");
    let deck = deck
        .replace("25.0E-3,1.5E-3", "25.0E-3, <t>")
        .replace("*FRICTION\n0.3", "*FRICTION\n<mu>")
        .replacen("*NODE", &format!("{names}*NODE"), 1);
    let responses: [Response; 1] = [|frame| reaction(frame, 9999, Dof::U2)];
    let parameters = [("t", 1.5e-3), ("mu", 0.3)];
    let seen = Varied::new(&deck, &parameters, &responses).differentiated();
    for rates in &seen.rates {
        assert_eq!(rates.len(), seen.rows.len());
    }
}

/// A block that is moved onto another one through a gap, in ten increments of which the last two press.
fn lowered(kind: &str, friction: &str) -> String {
    format!(
        "*PARAMETER\nmodulus = 2000.0\n*NODE, NSET=LOW\n1, 0., -1.\n5, 4., -1.\n201, 0., 0.\n205, 4., 0.\n1001, 1.1, .5\n1004, 3.1, .52\n\
         1201, 1.1, 1.5\n1204, 3.1, 1.5\n*NGEN, NSET=FOOT\n1, 5\n*NGEN, NSET=OVER\n201, 205\n*NFILL\nFOOT, OVER, 2, 100\n\
         *NGEN, NSET=SOLE\n1001, 1004\n*NGEN, NSET=GRIP\n1201, 1204\n*NFILL\nSOLE, GRIP, 2, 100\n\
         *ELEMENT, TYPE={kind}, ELSET=BASE\n1, 1, 2, 102, 101\n*ELGEN, ELSET=BASE\n1, 4, 1, 1, 2, 100, 10\n\
         *ELEMENT, TYPE={kind}, ELSET=BLOCK\n101, 1001, 1002, 1102, 1101\n*ELGEN, ELSET=BLOCK\n101, 3, 1, 1, 2, 100, 10\n\
         *ELSET, ELSET=ALL\nBASE, BLOCK\n*SOLID SECTION, ELSET=ALL, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n<modulus>, .3\n\
         *SURFACE, NAME=A\nBASE,\n*SURFACE, NAME=B\nBLOCK,\n*SURFACE INTERACTION, NAME=I\n{friction}\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nB, A\n*BOUNDARY\nFOOT, 1, 2\n*STEP, NLGEOM\n*STATIC, DIRECT\n0.1, 1.0\n\
         *BOUNDARY\nGRIP, 1\nGRIP, 2, 2, -.57\n*END STEP\n"
    )
}

/// Requirement: increments in which a part only moves have no kinks, whatever its elements store, and what follows has none either. The
/// rounding of incompatible modes and thicknesses was taken for one, and all later rows were marked.
#[test]
fn what_only_moves_has_no_kinks() {
    for kind in ["CPS4I", "CPE4I", "CPS4", "CPE4R"] {
        for friction in ["", "*FRICTION\n.3\n"] {
            let responses: [Response; 1] = [|frame| reaction(frame, 1201, Dof::U2)];
            let deck = Varied::new(&lowered(kind, friction), &[("modulus", 2000.0)], &responses);
            let seen = deck.differentiated();
            assert!(seen.rates.last().is_some());
            let marked = seen.one_sided[0].iter().filter(|one| **one).count();
            assert_eq!(marked, 0, "{kind} {friction}: {:?}", seen.one_sided);
        }
    }
}
