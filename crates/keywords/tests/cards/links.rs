//! Ties, equations, parts and shapes that are kept: what holds nodes together, and what is refused.

#![allow(clippy::expect_used, clippy::panic)] // a test may stop

use slideline_model::Dof;

use super::two_squares::{A, C, SQUARES, codes, deck, errors, interpret, model, step};

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
    // a coupling of the side that follows: it says which node of the deck that is
    let coupled = "*NODE\n101, 3.0, 5.0\n*COUPLING, REF NODE=101, SURFACE=CUT, CONSTRAINT NAME=C\n*KINEMATIC\n";
    let text = deck(&format!("{coupled}{cards}"), &[]);
    let said = errors(&interpret(&text, A));
    let helps = |help: &str| help.contains("the other side of node");
    let told =
        said.iter().any(|own| own.code.0 == "SL0316" && own.help.as_deref().is_some_and(helps));
    assert!(told, "{said:#?}");
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

/// Requirement: a coupling in a part names axes of that part, and every instance has its own.
#[test]
fn couplings_of_parts_have_axes_of_parts() {
    let text = "*PART, NAME=P\n*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n9, 2., 0.5\n\
        *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n\
        *SURFACE, NAME=SIDE\n1, S2\n*ORIENTATION, NAME=O\n0.6, 0.8, 0., -0.8, 0.6, 0.\n\
        *COUPLING, REF NODE=9, SURFACE=SIDE, CONSTRAINT NAME=K, ORIENTATION=O\n*KINEMATIC\n1, 1\n*END PART\n\
        *ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n*INSTANCE, NAME=J, PART=P\n5., 0., 0.\n\
        *END INSTANCE\n*END ASSEMBLY\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n";
    let text =
        format!("{text}*STEP, NLGEOM=NO\n*STATIC\n*BOUNDARY\nI.1, 1, 2\nJ.1, 1, 2\n*END STEP\n");
    let model = model(&text, A);
    assert!(model.linear_constraints.len() == 4);
    let turned = |own: &slideline_model::LinearConstraint| own.terms.len() > 1;
    assert!(model.linear_constraints.iter().all(turned), "{:?}", model.linear_constraints);
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
    let general = format!("{}{}", said(""), step(load).replace(", NLGEOM", ""));
    assert_eq!(codes(&deck(&general, &[]), A), ["SL0221"]);
    assert_eq!(codes(&deck(&two, &[]), C), ["SL0221"]);
    let gaps =
        "*ELEMENT, TYPE=SPRING1, ELSET=S\n9, 6\n*SPRING, ELSET=S, NONLINEAR\n1\n0., 0.\n1., 1.\n";
    assert_eq!(codes(&deck(&format!("{gaps}{}", said("")), &[]), A), ["SL0221"]);
    let yields: &[(&str, &str)] = &[("*ELASTIC", "*PLASTIC\n1e6, 0.\n*ELASTIC")];
    assert_eq!(codes(&deck(&said(""), yields), A), ["SL0221"]);
    for ends in ["*EQUATION, REMOVE\n6, 2", "*EQUATION, REMOVE ALL"] {
        assert_eq!(codes(&deck(&step(&format!("{ends}\n{load}")), &[]), C), ["SL0221"], "{ends}");
    }
    let late = step(&format!("*EQUATION\n2\n6, 1, 1., 3, 1, -1.\n{load}"));
    assert_eq!(codes(&deck(&late, &[]), C), ["SL0214"]);
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

/// Requirement: the axes of a distributing coupling are those of its reference node in the dialect of
/// CalculiX; a node that has others by `*TRANSFORM` is refused, the same ones are not.
#[test]
fn a_reference_node_has_one_system_of_axes() {
    let coupled_along = |axes: &str, transform: &str| {
        let cards = format!(
            "*NODE, NSET=REF\n9, 4.0, 0.5\n*SURFACE, NAME=SIDE\nB, S2\n*ORIENTATION, NAME=O\n{axes}\n\
             *COUPLING, REF NODE=9, SURFACE=SIDE, CONSTRAINT NAME=K, ORIENTATION=O\n*DISTRIBUTING\n1, 2\n"
        );
        let transform = match transform.strip_prefix("**") {
            Some(other) => format!("{other}\n"),
            None => format!("*TRANSFORM, NSET=REF\n{transform}\n"),
        };
        codes(&deck(&format!("{cards}{transform}{}", step("*CLOAD\n9, 1, 1.0")), &[]), C)
    };
    let coupled = |transform: &str| coupled_along("0., 1., 0., -1., 0., 0.", transform);
    assert_eq!(coupled("1., 1., 0., -1., 1., 0."), ["SL0349"]);
    assert!(coupled("0., 1., 0., -1., 0., 0.").is_empty());
    // equations follow *TRANSFORM alone
    let equation =
        "0., 1., 0., -1., 0., 0.\n*NODE\n10, 5.0, 0.5\n*EQUATION\n2\n10, 1, 1., 9, 1, -1.";
    assert!(coupled(equation).is_empty());
    let bare = equation.split_once("\n").unwrap().1;
    assert_eq!(coupled(&format!("**\n{bare}")), ["SL0349"]);
    // the axes of the model are those that equations mean
    let plain = coupled_along("1., 0., 0., 0., 1., 0.", &format!("**\n{bare}"));
    assert!(plain.is_empty(), "{plain:?}");
}

/// Requirement: of a coupling that may turn far the reference node follows where it is free; where a part of it
/// is prescribed, whole nodes do that no other coupling follows, and what is left of them follows dofs of its
/// own. Without NLGEOM nothing is noted; couplings whose nodes must follow one another are refused.
#[test]
fn clouds_that_may_turn_far() {
    let of = |support: &str, second: &str, step_line: &str| {
        let cards = format!(
            "*NODE\n9, 4.0, 0.5\n10, 4.0, 0.9\n*NSET, NSET=CLOUD\n3, 4, 5, 6\n*SURFACE, NAME=SIDE, TYPE=NODE\nCLOUD,\n\
             *COUPLING, REF NODE=9, SURFACE=SIDE, CONSTRAINT NAME=K\n*DISTRIBUTING\n1, 6\n{second}"
        );
        let deck = step(&format!("{support}*CLOAD\n9, 1, 1.0"));
        deck.replace("*STEP, NLGEOM", &format!("{cards}*STEP{step_line}"))
    };
    let read = |support: &str, line: &str| model(&deck(&of(support, "", line), &[]), A);
    let free = read("", ", NLGEOM");
    let reference = free.nodes.find(9).expect("the reference node");
    let [own] = &free.mean_motions[..] else { panic!("one coupling") };
    assert_eq!(own.dependents, [Dof::U1, Dof::U2, Dof::UR3].map(|dof| (reference, dof)));
    assert!(own.turning.is_empty());
    let held = read("*BOUNDARY\n9, 6, 6, 2.0\n", ", NLGEOM");
    let own = &held.mean_motions[0];
    assert!(own.dependents.iter().all(|(node, _)| *node != reference), "{own:?}");
    assert_eq!(own.dependents.len(), 3 + own.turning.len());
    for &(node, _) in &own.dependents {
        assert_eq!(own.dependents.iter().filter(|other| other.0 == node).count(), 2);
    }
    assert!(read("", "").mean_motions.is_empty());
    let second = "*COUPLING, REF NODE=10, SURFACE=SIDE, CONSTRAINT NAME=L\n*DISTRIBUTING\n1, 6\n";
    let both = of("*BOUNDARY\n9, 6, 6, 2.0\n10, 6, 6, 1.0\n", second, ", NLGEOM");
    let both = interpret(&deck(&both, &[]), A);
    assert!(errors(&both).iter().all(|said| said.code.0 == "SL0347") && !errors(&both).is_empty());
    // nodes that follow others already leave no whole ones: it stays linear
    let follow = |node: usize| format!("*EQUATION\n2\n{node}, 2, 1.0, 1, 2, -1.0\n");
    let equations: String = [3, 5, 6].map(follow).into_iter().collect();
    let few = of("*BOUNDARY\n9, 6, 6, 1.0\n", &equations, ", NLGEOM");
    let few = model(&deck(&few, &[]), A);
    assert_eq!((few.mean_motions.len(), few.linear_mean_turns.len()), (0, 1));
    // and so does one that a step of small motion shares
    let small = of("*BOUNDARY\n9, 6, 6, 1.0\n", "", ", NLGEOM");
    let small = small.replace("*END STEP", "*END STEP\n*STEP, NLGEOM=NO\n*STATIC\n*END STEP");
    let small = model(&deck(&small, &[]), A);
    assert_eq!((small.mean_motions.len(), small.linear_mean_turns.len()), (0, 1));
}
