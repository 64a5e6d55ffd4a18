//! What a deck says and the model cannot hold is refused, never passed over; what it can hold is
//! taken as the dialects have it.

#![allow(clippy::expect_used)] // a test may stop

use slideline_model::Model;

use super::two_squares::{A, C, codes, deck, errors, interpret, model, step};

/// Requirement: a plane model has no third coordinate: after the message about it nothing of it
/// is left. Source: review, plane models with z.
#[test]
fn the_plane_is_that_of_z_zero() {
    let more = step("*CLOAD\n6, 1, 1.0");
    let read = interpret(&deck(&more, &[("6, 3.0, 1.0", "6, 3.0, 1.0, 0.25")]), A);
    assert!(read.diagnostics.iter().any(|found| found.code.0 == "SL0228"));
    assert!(read.model.nodes.iter().all(|node| node.position[2] == 0.0));
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
    for cards in [
        "*TEMPERATURE, FILE=OTHER, BSTEP=1, BINC=1",
        "*TEMPERATURE, FILE=OTHER, ESTEP=2, EINC=3",
        "*DLOAD, REF NODE=3\n1, P1, 1.0",
    ] {
        let with = deck(&step(&format!("*CLOAD\n6, 1, 1.0\n{cards}")), &[]);
        let found = codes(&with, A);
        assert!(
            !found.is_empty() && found.iter().all(|code| *code == "SL0221"),
            "{cards} {found:?}"
        );
    }
    let pad = "*SURFACE INTERACTION, NAME=I, PAD THICKNESS=0.1\n1.0\n";
    let with = deck(&format!("{pad}{}", step("*CLOAD\n6, 1, 1.0")), &[]);
    assert_eq!(codes(&with, A), ["SL0221"]);
}

/// Requirement: parameters that change no result of a static step are told and ignored.
#[test]
fn parameters_without_effect() {
    let controls = "*CONTACT CONTROLS, PERTURBATION\n*SURFACE INTERACTION, NAME=I, UNSYMM\n1.0\n";
    let read = interpret(&deck(&format!("{controls}{}", step("*CLOAD, REAL\n6, 1, 1.0")), &[]), A);
    assert!(errors(&read).is_empty(), "{:#?}", errors(&read));
    let notes = read.diagnostics.iter().filter(|found| found.code.0 == "SL0257").count();
    assert_eq!(notes, 3, "{:#?}", read.diagnostics);
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
    let told = |row: &str| {
        let said = interpret(&expands(row), C).diagnostics;
        said.iter().any(|own| own.message.contains("a13 and a23"))
    };
    assert!(told("1e-5, 2e-5, 3e-5, 0., 0., 1e-6") && !told(sheared));
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
    let unsaid: &[(&str, &str)] = &[("MATERIAL=M\n2.0", "MATERIAL=M, NODAL THICKNESS")];
    assert_eq!(codes(&deck(&step("*CLOAD\n6, 1, 1.0"), unsaid), C), ["SL0221"]);
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

/// Requirement: friction of a gap is refused as such, not as a law without an owner.
#[test]
fn gaps_do_not_rub() {
    let gap = "*ELEMENT, TYPE=GAPUNI, ELSET=G\n9, 6, 5\n*GAP, ELSET=G\n0.1, 1.0, 0.0, 0.0\n*FRICTION\n0.3\n";
    let text = deck(&format!("{gap}{}", step("*CLOAD\n6, 1, 1.0")), &[]);
    let said = errors(&interpret(&text, A));
    let said: Vec<_> = said.iter().map(|own| (own.code.0, own.message.as_str())).collect();
    assert_eq!(said, [("SL0221", "*FRICTION of *GAP is not supported: gaps do not rub")]);
}
