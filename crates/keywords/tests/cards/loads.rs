//! Loads, curves over time and the surfaces that they act on: what acts, and what is refused.

#![allow(clippy::expect_used)] // a test may stop

use slideline_model::{Curve, Dialect, Dof, Model, Pressed};

use super::two_squares::{A, C, codes, deck, interpret, model, step};

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

/// Requirement: SCALEX and SCALEY multiply times and values of every kind of curve; beside a shift along the same
/// axis they are refused. Source: Abaqus manual, `*AMPLITUDE`.
#[test]
fn amplitudes_are_scaled() {
    let [tabular, decay] = ["\n0.0, 1.0, 2.0, 5.0\n", ", DEFINITION=DECAY\n1.0, 2.0, 0.5, 4.0\n"];
    for data in [tabular, decay, ", DEFINITION=MODULATED\n1.0, 2.0, 0.5, 3.0, 5.0\n"] {
        let of = |scales: &str| {
            let curve = format!("*AMPLITUDE, NAME=A{scales}{data}");
            let load = step("*CLOAD, AMPLITUDE=A\n6, 1, 1.0");
            model(&deck(&format!("{curve}{load}"), &[]), A).amplitude("A").expect("a curve").clone()
        };
        let (plain, scaled) = (of(""), of(", SCALEX=2.0, SCALEY=-3.0"));
        for time in [0.0, 0.4, 0.7, 1.1, 3.0] {
            assert!((scaled.at(2.0 * time) + 3.0 * plain.at(time)).abs() < 1e-14, "{data} {time}");
        }
    }
    for (scales, code) in [("SCALEX=2.0, SHIFTX=1.0", "SL0221"), ("SCALEX=0.0", "SL0210")] {
        let curve = format!("*AMPLITUDE, NAME=A, {scales}{tabular}");
        let cards = format!("{curve}{}", step("*CLOAD\n6, 1, 1.0"));
        assert_eq!(codes(&deck(&cards, &[]), A), [code], "{scales}");
    }
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
