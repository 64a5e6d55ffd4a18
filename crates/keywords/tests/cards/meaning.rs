//! What cards mean, one rule at a time (semantics: deck language, friction,
//! softened contact). Values are exact: reading computes nothing but copies.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::NoFiles;
use slideline_diag::Sources;
use slideline_keywords::{Interpreted, describe, read};
use slideline_model::{
    Decay, Dialect, Dof, Extrapolation, Friction, Model, NodeVariable, NormalLaw, Onset, SpringLaw,
    SpringWay, StickRule,
};

const BEAM: &str = include_str!("../../../../corpus/keywords/NODE.inp");
const ISL: &str = include_str!("../../../../corpus/keywords/SLIDE-LINE.inp");

fn interpret(text: &str, dialect: Dialect) -> Interpreted {
    read(&mut Sources::default(), "a.inp", text.as_bytes(), &NoFiles, dialect)
}

/// The deck with a piece exchanged, which must give a model without error.
fn model(deck: &str, old: &str, new: &str) -> Model {
    assert!(deck.contains(old), "{old}");
    let read = interpret(&deck.replacen(old, new, 1), Dialect::Abaqus);
    let errors: Vec<_> = read.diagnostics.iter().filter(|d| d.severity.word() == "error").collect();
    assert!(errors.is_empty(), "{errors:#?}");
    read.model
}

fn codes(deck: &str, old: &str, new: &str) -> Vec<&'static str> {
    assert!(deck.contains(old), "{old}");
    let read = interpret(&deck.replacen(old, new, 1), Dialect::Abaqus);
    read.diagnostics.iter().map(|d| d.code.0).collect()
}

fn friction(card: &str) -> Friction {
    let model = model(ISL, "*FRICTION\n0.3\n", card);
    model.contact_pairs[0].interaction.friction.clone()
}

fn refused(card: &str) -> Vec<&'static str> {
    codes(ISL, "*FRICTION\n0.3\n", card)
}

fn coulomb(stick: StickRule) -> Friction {
    Friction::Coulomb { coefficient: 0.3, second: None, limit: None, decay: None, stick }
}

#[test]
fn every_form_of_friction() {
    assert_eq!(friction(""), Friction::Frictionless);
    assert_eq!(friction("*FRICTION\n0.0\n"), Friction::Frictionless);
    assert_eq!(friction("*FRICTION\n0.3\n"), coulomb(StickRule::SlipTolerance(0.005)));
    assert_eq!(
        friction("*FRICTION, SLIP TOLERANCE=0.01\n0.3,\n"),
        coulomb(StickRule::SlipTolerance(0.01))
    );
    assert_eq!(
        friction("*friction, elastic slip = 1.D-6\n0.3\n"),
        coulomb(StickRule::ElasticSlip(1e-6))
    );
    assert_eq!(friction("*FRICTION, LAGRANGE\n0.3\n"), coulomb(StickRule::Lagrange));
    assert_eq!(friction("*FRICTION, ROUGH\n"), Friction::Rough);
    assert_eq!(friction("*FRICTION, TAUMAX=0\n0.3\n"), coulomb(StickRule::default()));
    let limited = friction("*FRICTION, TAUMAX=2.E6\n0.3\n");
    assert!(matches!(limited, Friction::Coulomb { limit: Some(2e6), .. }));
    let decaying = friction("*FRICTION, EXPONENTIAL DECAY\n0.3, 0.2, 5.\n");
    let expected = Decay { kinetic: 0.2, rate: 5.0 };
    assert!(matches!(decaying, Friction::Coulomb { decay: Some(decay), .. } if decay == expected));
    // One coefficient of zero is not the absence of friction.
    let from_zero = friction("*FRICTION, EXPONENTIAL DECAY\n0., 0.3, 5.\n");
    assert_eq!((from_zero.acts(), from_zero.coefficients()), (true, [0.0, 0.3]));
    let never = friction("*FRICTION, EXPONENTIAL DECAY\n0., 0.3, 0.\n");
    assert_eq!(never, Friction::Frictionless, "without decay the static coefficient holds");
    let user = friction("*FRICTION, USER=STRIBECK, PROPERTIES=3, DEPVAR=2\n0.3, 0.2, 5.\n");
    let properties = vec![0.3, 0.2, 5.0];
    assert_eq!(user, Friction::User { name: "STRIBECK".into(), properties, state_size: 2 });
}

#[test]
fn friction_that_is_refused() {
    for pair in ["LAGRANGE, ROUGH", "ELASTIC SLIP=1E-6, SLIP TOLERANCE=0.01", "USER=A, LAGRANGE"] {
        assert!(refused(&format!("*FRICTION, {pair}\n0.3\n")).contains(&"SL0215"), "{pair}");
    }
    assert_eq!(refused("*FRICTION, EXPONENTIAL DECAY, TAUMAX=1.\n0.3,0.2,1.\n"), ["SL0215"]);
    assert_eq!(refused("*FRICTION, DEPVAR=1\n0.3\n"), ["SL0215"]);
    assert_eq!(refused("*FRICTION\n-0.1\n"), ["SL0216"]);
    assert_eq!(refused("*FRICTION\n11\n"), ["SL0217"]);
    assert_eq!(refused("*FRICTION\n"), ["SL0208"]);
    assert_eq!(refused("*FRICTION, ANISOTROPIC\n"), ["SL0208"]);
    // a table of coefficients is one cause
    assert_eq!(refused("*FRICTION\n0.3, 0., 0.\n0.2, 10., 0.\n"), ["SL0221"]);
    assert_eq!(refused("*FRICTION\n0.3,, 0.\n0.1,, 100.\n"), ["SL0221"]);
    assert_eq!(refused("*FRICTION, ELASTIC SLIP=0\n0.3\n"), ["SL0210"]);
    assert_eq!(refused("*FRICTION\nnan\n"), ["SL0116"]);
    assert_eq!(refused("*FRICTION, USER\n0.3\n"), ["SL0206"]);
}

#[test]
fn every_pressure_law() {
    let law = |card: &str| {
        let old = "*SURFACE CONTACT, SOFTENED\n1.0E-5, 4.8E6\n";
        model(ISL, old, card).contact_pairs[0].interaction.normal.clone()
    };
    assert_eq!(law(""), NormalLaw::Hard);
    assert_eq!(law("*SURFACE CONTACT\n"), NormalLaw::Hard);
    assert_eq!(law("*SURFACE BEHAVIOR\n"), NormalLaw::Hard);
    let behaviour = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE";
    assert_eq!(law(&format!("{behaviour}=HARD\n")), NormalLaw::Hard);
    assert_eq!(law(&format!("{behaviour}=LINEAR\n1e9\n")), NormalLaw::Linear { stiffness: 1e9 });
    assert_eq!(
        law(&format!("{behaviour}=EXPONENTIAL\n1e-5, 2e6\n")),
        NormalLaw::Exponential { clearance: 1e-5, pressure: 2e6 }
    );
    assert_eq!(
        law(&format!("{behaviour}=TABULAR\n0, 0\n1, 2\n")),
        NormalLaw::Tabular(vec![(0.0, 0.0), (1.0, 2.0)])
    );
    let calculix = interpret(ISL, Dialect::Calculix).model;
    assert_eq!(
        calculix.contact_pairs[0].interaction.normal,
        NormalLaw::CalculixExponential { clearance: 1e-5, pressure: 4.8e6 },
        "one word, two laws (semantics, section 1)"
    );
}

#[test]
fn the_onset_is_a_card_of_the_model() {
    for (word, onset) in
        [("IMMEDIATE", Onset::Immediate), ("DELAYED", Onset::Delayed), ("MATFRU", Onset::Matfru)]
    {
        let card = format!("*Contact Controls, FrictionOnset={word}\n*STEP");
        assert_eq!(model(ISL, "*STEP", &card).friction_onset, onset);
    }
}

#[test]
fn sets_may_be_used_before_they_are_defined() {
    let deck = BEAM
        .replace("5, 1, 1.0\n", "TIP, 1, 1.0\n")
        .replace("*STEP", "*NSET, NSET=TIP\nEND,\n*NSET, NSET=END\n5\n*STEP");
    let model = model(&deck, "*MATERIAL", "*MATERIAL");
    assert_eq!(model.nodes.label(model.steps[0].loads[0].node), 5);
}

#[test]
fn elements_may_come_before_their_nodes() {
    let nodes = "*NODE, NSET=BEAM\n1, 0.0, 0.0\n5, 0.0, 50.0E-3\n*NGEN, NSET=BEAM\n1, 5\n";
    let deck = BEAM.replace(nodes, "").replace("*STEP", &format!("{nodes}*STEP"));
    let model = model(&deck, "*STEP", "*STEP");
    assert_eq!((model.blocks[0].word(), model.blocks[0].elements.len()), ("B21", 4));
}

const SECOND: &str = "*END STEP\n*STEP, NLGEOM, EXTRAPOLATION=NO, AMPLITUDE=STEP, UNSYMM\n\
    hold\n*STATIC, DIRECT\n0.25, 0.5\n";

#[test]
fn a_step_takes_over_what_was_prescribed() {
    let model =
        model(BEAM, "*END STEP\n", &format!("{SECOND}*BOUNDARY\n5, 2, 2, 0.1\n*END STEP\n"));
    let [first, second] = model.steps.as_slice() else { panic!("two steps") };
    assert_eq!((first.prescribed.len(), second.prescribed.len()), (3, 4));
    assert_eq!((second.loads.len(), second.loads[0].value), (1, 1.0));
    assert_eq!((second.extrapolation, second.at_once), (Extrapolation::None, true));
    assert_eq!((second.unsymmetric, second.procedure.direct), (Some(true), true));
    assert_eq!((second.procedure.minimum, second.procedure.maximum), (0.25, 0.25));
}

#[test]
fn op_new_drops_what_was_prescribed() {
    let cards = "*BOUNDARY, OP=NEW\n1, ENCASTRE\n*CLOAD, OP=NEW\n5, 6, 2.0\n*END STEP\n";
    let model = model(BEAM, "*END STEP\n", &format!("{SECOND}{cards}"));
    let second = &model.steps[1];
    let dofs: Vec<Dof> = second.prescribed.iter().map(|p| p.dof).collect();
    assert_eq!(dofs, [Dof::U1, Dof::U2, Dof::UR3]);
    assert_eq!((second.loads.len(), second.loads[0].dof), (1, Dof::UR3));
}

#[test]
fn a_curve_leaves_its_last_value_to_the_next_step() {
    let deck = BEAM
        .replace("*STEP", "*AMPLITUDE, NAME=A\n0., 0., 1., 0.5\n*STEP")
        .replace("*CLOAD\n", "*CLOAD, AMPLITUDE=a\n");
    let model = model(&deck, "*END STEP\n", &format!("{SECOND}*END STEP\n"));
    let [first, second] = model.steps.as_slice() else { panic!("two steps") };
    assert_eq!((first.loads[0].amplitude, first.loads[0].value), (Some(0), 1.0));
    assert_eq!((second.loads[0].amplitude, second.loads[0].value), (None, 0.5));
    assert_eq!((first.loads[0].continues, second.loads[0].continues), (None, Some(0)));
}

/// Requirement: what `OP=NEW` removes ramps off, also where another load takes its place in the
/// list; a load that was said again goes on from the old one.
#[test]
fn removed_loads_ramp_off() {
    let cards = "*CLOAD, OP=NEW\n4, 1, 3.0\n5, 6, 2.0\n*END STEP\n";
    let second = SECOND.replace(", AMPLITUDE=STEP", "");
    let third = second.trim_start_matches("*END STEP\n");
    let last = "*CLOAD\n5, 6, 7.0\n*END STEP\n";
    let model = model(BEAM, "*END STEP\n", &format!("{second}{cards}{third}{last}"));
    let of = |step: usize| -> Vec<(f64, Option<usize>)> {
        model.steps[step].loads.iter().map(|load| (load.value, load.continues)).collect()
    };
    assert_eq!(of(0), [(1.0, None)]);
    assert_eq!(of(1), [(3.0, None), (2.0, None), (0.0, Some(0))]);
    assert_eq!(of(2), [(3.0, Some(0)), (7.0, Some(1))]);
}

#[test]
fn static_has_its_defaults() {
    let times = |card: &str| {
        let step = model(BEAM, "*STATIC\n0.1, 1.0\n", card).steps[0].procedure;
        [step.initial, step.period, step.minimum, step.maximum]
    };
    assert_eq!(times("*STATIC\n"), [1.0, 1.0, 1e-5, 1.0]);
    assert_eq!(times(""), [1.0, 1.0, 1e-5, 1.0]);
    assert_eq!(times("*STATIC\n0.1, 2.0\n"), [0.1, 2.0, 2e-5, 2.0]);
    assert_eq!(times("*STATIC\n1e-6, 1.0\n"), [1e-6, 1.0, 1e-6, 1.0]);
    assert_eq!(times("*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n"), [0.05, 1.0, 1e-6, 0.05]);
}

#[test]
fn controls_change_what_they_name() {
    let cards = "*CONTROLS, PARAMETERS=FIELD\n1e-8, , 2.\n\
        *CONTROLS, PARAMETERS=TIME INCREMENTATION\n6, , , 20\n0.2\n*END STEP";
    let controls = model(BEAM, "*END STEP", cards).steps[0].controls;
    assert_eq!((controls.field.r_n, controls.field.r_p, controls.field.c_n), (1e-8, 4e-8, 1e-2));
    assert_eq!((controls.field.initial_flux, controls.field.set_by_deck), (Some(2.0), true));
    assert_eq!((controls.time.i_0, controls.time.i_r, controls.time.i_c), (6, 8, 20));
    assert_eq!((controls.time.d_f, controls.time.d_c), (0.2, 0.5));
    let reset = format!("{}*END STEP", cards.replace("*END STEP", "*CONTROLS, RESET\n"));
    assert_eq!(model(BEAM, "*END STEP", &reset).steps[0].controls, Default::default());
}

#[test]
fn springs_and_tables() {
    let springs = "*ELEMENT, TYPE=SPRING1, ELSET=S\n50, 5\n*SPRING, ELSET=S\n2\n7.0\n\
        *ELEMENT, TYPE=SPRINGA, ELSET=T\n51, 1, 5\n*SPRING, ELSET=T\n\n8.0\n*STEP";
    let springs = model(BEAM, "*STEP", springs);
    let kinds: Vec<_> = springs
        .blocks
        .iter()
        .filter_map(|block| block.springs())
        .map(|springs| (springs.section.way, springs.section.law.clone()))
        .collect();
    let line = SpringWay::Line { in_space: false };
    let (seven, eight) = (SpringLaw::Linear(7.0), SpringLaw::Linear(8.0));
    assert_eq!(kinds, [(SpringWay::Dof(Dof::U2), seven), (line, eight)]);
    let further = "*ELEMENT, TYPE=SPRING2, ELSET=S\n50, 1, 5\n*SPRING, ELSET=S, NONLINEAR\n2, 2\n\
        -1., -2.\n3., 1.\n*ELEMENT, TYPE=SPRINGA, ELSET=T\n51, 1, 5\n*SPRING, ELSET=T, NONLINEAR\n\
        \n0., 0.\n1., 1.\n*STEP";
    let further = model(BEAM, "*STEP", further);
    let laws: Vec<_> = further
        .blocks
        .iter()
        .filter_map(|block| block.springs())
        .map(|springs| (springs.section.way, springs.section.law.clone()))
        .collect();
    let first = SpringLaw::Table([[-2.0, -1.0], [1.0, 3.0]].into());
    let second = SpringLaw::Table([[0.0, 0.0], [1.0, 1.0]].into());
    assert_eq!(laws, [(SpringWay::Dof(Dof::U2), first), (line, second)]);
    let print = "*NODE PRINT, NSET=BEAM, FREQ=3\nU1, RF2, U\n*END STEP";
    let step = model(BEAM, "*END STEP", print).steps[0].clone();
    let print = &step.output.node_prints[0];
    assert_eq!(print.variables, [NodeVariable::U, NodeVariable::RF]);
    assert_eq!((print.nodes.len(), print.request.frequency), (5, 3));
}

#[test]
fn a_commented_out_card_is_a_comment() {
    let quiet = "** FRICTION as measured\n**FRICTION\n**0.2\n*FRICTION\n** mu\n0.3\n";
    assert_eq!(codes(ISL, "*FRICTION\n0.3\n", quiet), [""; 0]);
    assert_eq!(codes(BEAM, "*NODE, NSET=BEAM\n", "*NODE, NSET=BEAM\n**node, x, y\n"), [""; 0]);
}

#[test]
fn two_slips_give_two_errors() {
    let deck =
        ISL.replace("*FRICTION\n", "*FRICTON\n").replace("*MPC\n", "*NSET, NSTE=A\n1\n*MPC\n");
    assert_eq!(codes(&deck, "*STEP", "*STEP"), ["SL0202", "SL0201"]);
    let lost = ISL.replace("210.0E9", "210.0G9").replace("1.0E-5, 4.8E6\n", "1.0E-5\n");
    assert_eq!(codes(&lost, "100, 1, 6\n", "101, 1, 6\n"), ["SL0116", "SL0119", "SL0315"]);
}

#[test]
fn keywords_are_found_as_people_write_them() {
    let found = |name: &str| describe(name).map(|description| description.name);
    assert_eq!(found("*slide line"), Some("SLIDE LINE"));
    assert_eq!(found("Beam sec"), Some("BEAM SECTION"));
    assert_eq!(found("include"), Some("INCLUDE"));
    assert_eq!(found("SURFACE"), Some("SURFACE"));
    assert_eq!(found("RIGID"), None);
    assert_eq!(found("friction onset"), None);
}

/// Keywords of other programs are not taken for slips of ours.
#[test]
fn a_foreign_keyword_is_not_a_misspelt_one() {
    let swelling = BEAM.replace("*STEP", "*SWELLING\n1.E-8\n*STEP");
    assert_eq!(codes(&swelling, "*STEP", "*STEP"), ["SL0221"]);
    assert_eq!(codes(BEAM, "*CLOAD\n5, 1, 1.0", "*DLOAD\nBEAM, P1, 1.0"), ["SL0221"]);
    assert_eq!(codes(BEAM, "*BEAM SECTION", "*SHELL SECTION"), ["SL0221"]);
    for name in ["TIED CONTACT", "SHELL SECTION", "SUBMODEL"] {
        assert_eq!(codes(BEAM, "*STEP", &format!("*{name}\n1, 2\n*STEP")), ["SL0221"], "{name}");
    }
}

/// Cards without effect are passed over, each with one note, wherever they
/// stand; the card whose place they take is read as before.
#[test]
fn cards_without_effect_are_passed_over() {
    let plain = model(BEAM, "*STEP", "*STEP");
    for (old, new) in [
        ("*ELASTIC", "*DAMPING, ALPHA=0.1\n*ELASTIC"),
        ("*STEP", "*PREPRINT, ECHO=NO, MODEL=NO\n*PREPRINT, HISTORY=NO\n*STEP"),
        ("*END STEP", "*MONITOR, NODE=5, DOF=1\n*END STEP"),
        ("*END STEP", "*SECTION FILE, SURFACE=S\nSOF\n*END STEP"),
        ("*STEP", "*SURFACE, NAME=NOTHING\n*STEP"),
    ] {
        assert_eq!(codes(BEAM, old, new), ["SL0257"], "{new}");
        assert_eq!(model(BEAM, old, new).blocks.len(), plain.blocks.len(), "{new}");
    }
}

/// One cause, one message: parts that number their nodes alike, instances with
/// names of their own, parameters in place of numbers, faces of solids.
#[test]
fn one_cause_gives_one_message() {
    let part = |name: &str| {
        let mut text = format!("*PART, NAME={name}\n*NODE\n");
        for k in 1..1000 {
            text += &format!("{k}, {}.\n", k + name.len());
        }
        text + "*ELEMENT, TYPE=SPRINGA, ELSET=E\n1, 1, 2\n*SPRING, ELSET=E\n\n1.\n*END PART\n"
    };
    let deck = "*HEADING\n".to_owned()
        + &part("A")
        + &part("BB")
        + "*ASSEMBLY, NAME=X\n*INSTANCE, NAME=A-1, PART=A\n1., 2., 3.\n*END INSTANCE\n\
           *NSET, NSET=S, INTERNAL, INSTANCE=A-1\n1, 2\n*END ASSEMBLY\n\
           *STEP\n*STATIC\n*BOUNDARY\nS, 1, 2\n*END STEP\n";
    assert_eq!(codes(&deck, "*STEP\n", "*STEP, NLGEOM\n"), ["SL0228", "SL0271"]);
    let parameters = "*PARAMETER DEPENDENCE\nw = 2.\n*BEAM SECTION";
    let deck = BEAM.replace("*BEAM SECTION", parameters).replace("210.0E9, 0.3", "<w>, 0.3");
    assert_eq!(codes(&deck, "5, 1, 1.0", "5, 1, <w>"), ["SL0221"]);
    let mut solids = String::from(
        "*ELEMENT, TYPE=S8R5, ELSET=X\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         *ELEMENT, TYPE=S8R5, ELSET=X\n2, 1, 2, 3, 4, 5, 6, 7, 8\n*SURFACE, NAME=S\n",
    );
    (1..2000).for_each(|k| solids += &format!("{k}, S3\n"));
    assert_eq!(codes(BEAM, "*STEP", &format!("{solids}*STEP")), ["SL0220"]);
}

/// `*CONTACT CONTROLS, STABILIZE` belongs to its own step; its factor, the
/// fraction along the tangent, and data in place of the program's choice.
#[test]
fn contact_is_stabilised_in_its_step() {
    let card = "*CONTACT CONTROLS, STABILIZE=2.5, TANGENT FRACTION=0.5\n40.0, , 0.01\n*END STEP\n";
    let later = "*STEP\n*STATIC\n*END STEP\n";
    let model = model(BEAM, "*END STEP\n", &format!("{card}{later}"));
    let found = model.steps[0].stabilisation.unwrap();
    assert_eq!((found.factor, found.tangent_fraction), (2.5, 0.5));
    assert_eq!((found.coefficient, found.range), (Some(40.0), Some(0.01)));
    assert!(model.steps[1].stabilisation.is_none());
}

#[test]
fn what_stabilisation_cannot_be() {
    for (card, code) in [
        ("STABILIZE=0.0\n", "SL0210"),
        ("STABILIZE, TANGENT FRACTION=-1.0\n", "SL0210"),
        ("STABILIZE\n-1.0\n", "SL0210"),
        ("STABILIZE\n1.0, 0.1\n", "SL0221"),
        ("TANGENT FRACTION=0.5\n", "SL0236"),
    ] {
        let new = format!("*CONTACT CONTROLS, {card}*END STEP\n");
        let read = interpret(&BEAM.replacen("*END STEP\n", &new, 1), Dialect::Abaqus);
        let codes: Vec<_> = read.diagnostics.iter().map(|d| d.code.0).collect();
        assert!(codes.contains(&code), "{card}: {codes:?}");
    }
    let early = BEAM.replacen("*STEP", "*CONTACT CONTROLS, STABILIZE\n*STEP", 1);
    let read = interpret(&early, Dialect::Abaqus);
    assert!(read.diagnostics.iter().any(|d| d.code.0 == "SL0214"));
}

/// Requirement: nodes of an element go on in the next line, behind a comma or where a line cannot
/// hold them all; curves over the total time, the friction and the boundary of CalculiX, and
/// parameters of output cards are read.
#[test]
fn small_forms_are_read() {
    let mut nodes = String::from("*NODE\n");
    (1..=20)
        .for_each(|k| nodes += &format!("{}, {k}., {}., {}.\n", 100 + k, k * k % 7, k * k * k % 5));
    let list: Vec<String> = (101..=120).map(|k: u32| k.to_string()).collect();
    let (first, rest) = (list[..10].join(", "), list[10..].join(", "));
    let solid = format!("{nodes}*ELEMENT, TYPE=C3D20\n7, {first}\n{rest}\n*STEP");
    let said = codes(BEAM, "*STEP", &solid);
    assert_eq!(said, ["SL0346", "SL0307"], "read whole, but folded and without a section");
    let broken = BEAM.replace("1, 1, 2\n", "1, 1,\n2\n");
    assert_ne!(broken, BEAM);
    assert_eq!(codes(&broken, "*STEP", "*STEP"), [""; 0]);
    let over = "*AMPLITUDE, NAME=A, TIME=TOTAL TIME\n0., 0., 2., 1.\n*STEP";
    let later = "*END STEP\n*STEP\n*STATIC\n1., 1.\n*CLOAD, AMPLITUDE=A\n5, 1, 1.\n*END STEP\n";
    let model = model(&BEAM.replace("*END STEP\n", later), "*STEP", over);
    let place = model.steps[1].loads[0].amplitude.unwrap();
    assert_eq!([0.0, 1.0].map(|t| model.amplitudes[place].at(t)), [0.5, 1.0]);
    let output = "*NODE FILE, OUTPUT=3D, GLOBAL=YES\nU, HFL\n*STATIC, SOLVER=PARDISO";
    assert_eq!(codes(BEAM, "*STATIC", output), ["SL0257"; 3]);
}
