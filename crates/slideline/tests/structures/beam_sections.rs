//! Sections of beams whose axes are neither principal nor through the centroid: closed forms,
//! through decks.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Model, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Displacements of all nodes by label, strain energy.
#[derive(Default)]
struct End {
    nodes: BTreeMap<u64, [f64; 6]>,
    energy: f64,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for node in 0..frame.model.nodes.len() {
                let label = frame.model.nodes.label(node);
                self.nodes.insert(label, Dof::ALL.map(|dof| frame.nodal.named(node, dof)[0]));
            }
            self.energy = frame.energy.strain_energy;
        }
        ControlFlow::Continue(())
    }
}

fn read(deck: &str) -> Model {
    let read = Job::read_text("sections", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        (step.controls.field.r_n, step.controls.field.c_n) = (1e-11, 1e-9);
    }
    model
}

fn run(deck: &str) -> End {
    let mut end = End::default();
    let ending = solve(&read(deck), &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    end
}

/// Length of the beams [L].
const LENGTH: f64 = 20.0;
const MODULUS: f64 = 1000.0;
const SHEAR_MODULUS: f64 = 400.0;

/// A cantilever along z in space with n1 along x and n2 along y: so many elements B32 or
/// B31.
fn in_space(kind: &str, elements: u64, section: &str, step: &str, loads: &str) -> String {
    let per = if kind == "B32" { 2 } else { 1 };
    let last = 1 + per * elements;
    let first = (1..=per + 1).map(|node| node.to_string()).collect::<Vec<_>>().join(", ");
    format!(
        "*NODE, NSET=ALL\n1, 0., 0., 0.\n{last}, 0., 0., {LENGTH}\n*NGEN, NSET=ALL\n1, {last}\n\
         *NSET, NSET=TIP\n{last}\n*ELEMENT, TYPE={kind}, ELSET=BEAM\n1, {first}\n\
         *ELGEN, ELSET=BEAM\n1, {elements}, {per}\n{section}\n*MATERIAL, NAME=M\n*ELASTIC\n\
         {MODULUS}, 0.25\n{step}\n*STATIC\n*BOUNDARY\n1, 1, 6\n*CLOAD\n{loads}\n*END STEP\n"
    )
}

fn tip(end: &End) -> [f64; 6] {
    *end.nodes.last_key_value().unwrap().1
}

fn near(a: f64, b: f64, by: f64) {
    assert!((a - b).abs() <= by, "{a} {b}");
}

/// Transverse shear stiffness K of all beams, whatever their length [F].
const K: f64 = 1e4;
const SHEAR: &str = "*TRANSVERSE SHEAR STIFFNESS\n1e4, 1e4, 0.";

/// Requirement: an angle pushed along a leg bends away from the push, by the closed form of
/// unsymmetric bending about the centroid, and does not twist, its axis being its shear centre.
/// Source: docs/theory.md eq. (3.79). Tolerance: 1e-8 of the deflection.
#[test]
fn an_angle_bends_sideways() {
    let section = format!(
        "*BEAM SECTION, SECTION=L, ELSET=BEAM, MATERIAL=M\n2., 3., 0.2, 0.3\n1., 0., 0.\n\
         {SHEAR}"
    );
    // plates by hand: the leg along 1, and the rest of that along 2
    let plates = [(2.0, 0.2, [0.85, 0.0]), (0.3, 2.8, [0.0, 1.5])];
    let area: f64 = plates.iter().map(|(a, b, _)| a * b).sum();
    let centroid = [0, 1].map(|k| plates.iter().map(|(a, b, x)| a * b * x[k]).sum::<f64>() / area);
    let moment = |i: usize, j: usize| {
        let of = |(a, b, x): &(f64, f64, [f64; 2])| {
            let side = [a, b][i];
            let own = if i == j { a * b * side * side / 12.0 } else { 0.0 };
            own + a * b * (x[i] - centroid[i]) * (x[j] - centroid[j])
        };
        plates.iter().map(of).sum::<f64>()
    };
    let [first, mixed, second] = [moment(1, 1), moment(0, 1), moment(0, 0)];
    let deflection = |moment: f64| {
        0.01 * LENGTH.powi(3) / (3.0 * MODULUS) * moment / (first * second - mixed * mixed)
    };
    let end = run(&in_space("B32", 3, &section, "*STEP", "TIP, 2, 0.01"));
    let size = deflection(second);
    let [x, y, z, _, turn_2, twist] = tip(&end);
    near(y, size + 0.01 * LENGTH / K, 1e-8 * size);
    near(x, -deflection(mixed), 1e-8 * size);
    near(twist, 0.0, 1e-12);
    // the axis away from the centroid comes along: bending stretches it
    let turned = [-1.5 * size / LENGTH, 1.5 * x / LENGTH];
    near(turn_2, turned[1], 1e-8);
    near(z, -(turned[0] * centroid[1] - turned[1] * centroid[0]), 1e-8 * size);
}

/// Requirement: a closed cell twists by Bredt's formula, an open one by the sum of its walls; a
/// channel pushed at its web twists by the push times the distance of its shear centre,
/// 3 b^2 s / (h t + 6 b s), and not at all where the axis is the shear centre. Tolerance: 1e-9.
#[test]
fn thin_walls_twist() {
    let arbitrary = |lines: &str| {
        format!("*BEAM SECTION, SECTION=ARBITRARY, ELSET=BEAM, MATERIAL=M\n{lines}\n1., 0., 0.")
    };
    let closed = arbitrary("4, 0., 0., 2., 0., 0.1\n2., 3., 0.2\n0., 3., 0.1\n0., 0., 0.2");
    let end = run(&in_space("B31", 4, &closed, "*STEP", "TIP, 6, 0.5"));
    let torsion = 4.0 * 36.0 / (2.0 * (2.0 / 0.1 + 3.0 / 0.2));
    let expected = 0.5 * LENGTH / (SHEAR_MODULUS * torsion);
    near(tip(&end)[5], expected, 1e-9 * expected);
    let (b, h, s, t) = (2.0, 3.0, 0.15, 0.1);
    let behind = 3.0 * b * b * s / (h * t + 6.0 * b * s);
    let torsion = (2.0 * b * s * s * s + h * t * t * t) / 3.0;
    let twist = 0.01 * behind * LENGTH / (SHEAR_MODULUS * torsion);
    for (web, expected) in [(0.0, twist), (behind, 0.0)] {
        let flange = web + b;
        let channel = arbitrary(&format!(
            "3, {flange}, -1.5, {web}, -1.5, 0.15\n{web}, 1.5, 0.1\n{flange}, 1.5, 0.15"
        ));
        let end = run(&in_space("B31", 4, &channel, "*STEP", "TIP, 2, 0.01"));
        near(tip(&end)[5], expected, 1e-9 * twist);
    }
}

/// Requirement: a hot beam in space between fixed ends has the axial force -E A a T and nothing else
/// where its axis is the centroid; a free one is longer by a T and stays straight, whatever its
/// section. Moduli are those at its temperature. Tolerance: 1e-9.
#[test]
fn a_hot_beam_in_space() {
    let section = "*BEAM SECTION, SECTION=L, ELSET=BEAM, MATERIAL=M\n2., 3., 0.2, 0.3\n1., 0., 0.";
    let strain = 1e-3 * 50.0;
    for (kind, elements) in [("B31", 4), ("B32", 2)] {
        let hot = |loads: &str| {
            let deck = in_space(kind, elements, section, "*STEP", loads);
            let tables = "0.25\n*EXPANSION\n1e-3\n";
            deck.replace("0.25\n", tables).replace("*END STEP", "*TEMPERATURE\nALL, 50.\n*END STEP")
        };
        let [x, y, z, turns @ ..] = tip(&run(&hot("TIP, 1, 0.")));
        near(z, strain * LENGTH, 1e-12 * LENGTH);
        let rest = [x, y, turns[0], turns[1], turns[2]];
        assert!(rest.iter().all(|own| own.abs() < 1e-12), "{rest:?}");
        // softer by a half when hot: twice the deflection of a cold one
        let push = |table: &str| {
            let deck = in_space(kind, elements, section, "*STEP", "TIP, 2, 0.01");
            let deck = deck.replace("1000, 0.25\n", table);
            let heat = "*TEMPERATURE\nALL, 50.\n*END STEP";
            tip(&run(&deck.replace("*END STEP", heat)))[1]
        };
        let (cold, warm) = (push("1000, 0.25\n"), push("1000, 0.25, 0.\n500, 0.25, 50.\n"));
        near(warm, 2.0 * cold, 1e-9 * warm);
        let fixed = hot("TIP, 1, 0.").replace("1, 1, 6\n", "1, 1, 6\nTIP, 1, 6\n");
        let area = 2.0 * 0.2 + 2.8 * 0.3;
        let end = run(&fixed);
        near(end.energy, 0.5 * MODULUS * area * strain * strain * LENGTH, 1e-9);
    }
}

/// Requirement: a node behind those of a beam in space turns its section, as the direction of the
/// section would; elements of one set may have several, and another section's direction counts
/// for those that name none. Source: Abaqus manual, beam cross-section orientation.
#[test]
fn a_node_that_axis_1_points_to() {
    let section = |first: &str| {
        format!("*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n0.2, 0.5\n{first}")
    };
    for (kind, elements) in [("B31", 4), ("B32", 2)] {
        let deck = |first: &str| in_space(kind, elements, &section(first), "*STEP", "TIP, 2, 0.01");
        let plain = tip(&run(&deck("0., 1., 0.")));
        // beside the beam, far from its line
        let other = deck("1., 0., 0.")
            .replace("*NSET, NSET=TIP", "*NODE\n900, 0., 7., 3.\n*NSET, NSET=TIP");
        let first = if kind == "B31" { "1, 1, 2\n" } else { "1, 1, 2, 3\n" };
        let pointed = run(&other.replace(first, &first.replace('\n', ", 900\n")));
        for (own, plain) in pointed.nodes[&5].iter().zip(plain) {
            near(*own, plain, 1e-12 * plain.abs().max(1.0));
        }
        let stiff = tip(&run(&deck("1., 0., 0.")));
        assert!(plain[1] > 4.0 * stiff[1], "{plain:?} {stiff:?}");
    }
}

/// A cantilever in the plane along x.
fn in_plane(kind: &str, elements: u64, section: &str, step: &str, loads: &str) -> String {
    let space = in_space(kind.replace("B2", "B3").as_str(), elements, section, step, loads);
    let ends = space.replace(&format!("0., 0., {LENGTH}\n"), &format!("{LENGTH}, 0.\n"));
    let turned = ends.replace("1, 0., 0., 0.\n", "1, 0., 0.\n");
    turned.replace(kind.replace("B2", "B3").as_str(), kind)
}

/// Requirement: a bar of a T pulled along its foot stretches by F L (1/EA + c^2/EI) there and bends
/// by F c L^2 / 2 EI; pushed across it moves its foot along. B23 is exact with one element, B22 with
/// one too, B21 in pull. Source: docs/theory.md eq. (3.104). Tolerance: 1e-8.
#[test]
fn a_pull_beside_the_centroid_bends() {
    let section = format!(
        "*BEAM SECTION, SECTION=I, ELSET=BEAM, MATERIAL=M\n0., 2., 0., 1.5, 0., 0.3, 0.2\n\
         {SHEAR}"
    );
    let (web, flange) = (0.2 * 1.7, 1.5 * 0.3);
    let area = web + flange;
    let c: f64 = (web * 0.85 + flange * 1.85) / area;
    let own = (0.2 * 1.7_f64.powi(3) + 1.5 * 0.3_f64.powi(3)) / 12.0;
    let moment = own + web * (0.85 - c).powi(2) + flange * (1.85 - c).powi(2);
    let (ea, ei) = (MODULUS * area, MODULUS * moment);
    let force = 0.02;
    for (kind, elements) in [("B21", 5), ("B22", 1), ("B23", 1)] {
        let own = section.replace(SHEAR, if kind == "B23" { "" } else { SHEAR });
        let end = run(&in_plane(kind, elements, &own, "*STEP", &format!("TIP, 1, {force}")));
        let [x, y, _, _, _, turn] = tip(&end);
        let expected = force * LENGTH * (1.0 / ea + c * c / ei);
        near(x, expected, 1e-8 * expected);
        // the centroid lies above the axis: the pull bends the beam upwards less than its foot
        let bent = force * c * LENGTH / ei;
        near(turn, bent, 1e-8 * bent);
        near(y, 0.5 * bent * LENGTH, 1e-8 * bent * LENGTH);
        if kind == "B21" {
            continue; // its deflection by a push is that of a polygon
        }
        let end = run(&in_plane(kind, elements, &own, "*STEP", &format!("TIP, 2, {force}")));
        let [x, y, _, _, _, turn] = tip(&end);
        let expected = force * LENGTH.powi(3) / (3.0 * ei);
        let leant = if kind == "B23" { 0.0 } else { force * LENGTH / K };
        near(y, expected + leant, 1e-8 * expected);
        near(turn, 1.5 * expected / LENGTH, 1e-8 * expected);
        near(x, c * turn, 1e-8 * expected);
    }
}

/// Requirement: a moment that bends an eccentric bar round into half a circle leaves its centroid as
/// long as before: the axis is the circle beside it, however large the turn, in the plane and in
/// space. Source: pure bending. Tolerance: 1e-7 of the length.
#[test]
fn an_eccentric_bar_rolled_up() {
    let general = |line: &str| {
        format!(
            "*BEAM GENERAL SECTION, ELSET=BEAM\n1., 0.1, 0., 0.2, 0.1\n{line}\n1000., 400.\n\
             *CENTROID\n0., 0.5\n{SHEAR}"
        )
    };
    let turn = std::f64::consts::PI;
    let moment = 1000.0 * 0.1 * turn / LENGTH;
    // without a force: the strain at the centroid is nothing, the axis 0.5 below it stretches
    let radius = LENGTH / turn + 0.5;
    let step = "*STEP, NLGEOM, INC=1000";
    let plane =
        run(&in_plane("B22", 16, &general("0., 0., -1."), step, &format!("TIP, 6, {moment}")));
    let [x, y, _, _, _, own] = tip(&plane);
    near(own, turn, 1e-9);
    near(x, -LENGTH, 2e-5 * LENGTH);
    near(y, 2.0 * radius, 2e-5 * LENGTH);
    let space =
        run(&in_space("B32", 16, &general("1., 0., 0."), step, &format!("TIP, 4, {}", -moment)));
    let [_, y, z, own, ..] = tip(&space);
    near(own, -turn, 1e-9);
    near(z, -LENGTH, 2e-5 * LENGTH);
    near(y, 2.0 * radius, 2e-5 * LENGTH);
    near(space.energy, plane.energy, 1e-7 * plane.energy);
}

/// A beam whose square section goes evenly from side 3 to side 1.5, each element with a section of its own.
fn tapered(elements: u64, direction: &str) -> String {
    let side = |k: u64| 3.0 - 1.5 * k as f64 / elements as f64;
    let of = |k: u64| {
        format!(
            "*ELSET, ELSET=E{k}\n{k}\n*BEAM GENERAL SECTION, SECTION=RECT, ELSET=E{k}, TAPER\n\
             {0}, {0}\n{1}, {1}\n{direction}\n{MODULUS}, {SHEAR_MODULUS}\n{SHEAR}\n",
            side(k - 1),
            side(k)
        )
    };
    (1..=elements).map(of).collect::<String>().trim_end().to_owned()
}

/// Requirement: the deflection of a cantilever that tapers comes to the closed form with the square of the length of its
/// elements, in the plane and in space. Source: with x from the tip, I = I2 (1 + x/L)^4 and the integral of x^2/I, which
/// is L^3 / (3 I2 2^3). Tolerance: 1 % with eight elements.
#[test]
fn a_tapered_cantilever() {
    let force = 0.001;
    let tip_moment = 1.5_f64.powi(4) / 12.0;
    let expected = force * LENGTH.powi(3) / (3.0 * MODULUS * tip_moment * 8.0) + force * LENGTH / K;
    let load = format!("TIP, 2, {force}");
    let deflections = |elements: u64| {
        let plane = in_plane("B22", elements, &tapered(elements, "0., 0., -1."), "*STEP", &load);
        let space = in_space("B32", elements, &tapered(elements, "1., 0., 0."), "*STEP", &load);
        [plane, space].map(|deck| tip(&run(&deck))[1])
    };
    let off = |own: f64| (own / expected - 1.0).abs();
    let (coarse, fine) = (deflections(4), deflections(8));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(off(fine) < 1e-2 && off(coarse) > 3.5 * off(fine), "{expected} {coarse} {fine}");
    }
}

/// Requirement: one end alone is an error at the card, with its remedy.
#[test]
fn a_taper_without_its_second_end() {
    let section = "*BEAM GENERAL SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M, TAPER\n2., 2.";
    let deck = in_plane("B21", 2, section, "*STEP", "TIP, 2, 0.01");
    let read = Job::read_text("sections", &deck, &ReadOptions::default());
    let said: Vec<_> = read.diagnostics.iter().map(|own| own.message.clone()).collect();
    assert!(read.model.is_none());
    assert!(said.iter().any(|own| own.contains("second end")), "{said:?}");
}

/// Requirement: `DENSITY` of *BEAM GENERAL SECTION weighs as *DENSITY of a material does, over all elements and over a set, and in a beam
/// that tapers. It was ignored. Tolerance: rounding.
#[test]
fn sections_with_moduli_of_their_own_weigh() {
    let deck = |section: &str, on: &str| {
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 2., 0., 0.\n3, 4., 0., 0.\n*ELEMENT, TYPE=B31, ELSET=BEAM\n1, 1, 2\n2, 2, 3\n{section}\
             *BOUNDARY\n1, 1, 6\n*STEP\n*STATIC\n*DLOAD\n{on}, GRAV, 10., 0., -1., 0.\n*END STEP\n"
        )
    };
    let plain = "*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n.2, .3\n0., 0., -1.\n*MATERIAL, NAME=M\n\
                 *ELASTIC\n1000., .25\n*DENSITY\n.5\n";
    let general = |taper: &str, sizes: &str| {
        format!(
            "*BEAM GENERAL SECTION, SECTION=RECT, ELSET=BEAM, DENSITY=.5{taper}\n{sizes}0., 0., -1.\n1000., 400.\n"
        )
    };
    for on in ["", "BEAM"] {
        let exact = tip(&run(&deck(plain, on)));
        assert!(exact[1] < 0.0);
        for section in [general("", ".2, .3\n"), general(", TAPER", ".2, .3\n.2, .3\n")] {
            let own = tip(&run(&deck(&section, on)));
            for (own, exact) in own.iter().zip(exact) {
                near(*own, exact, 1e-12 * exact.abs());
            }
        }
    }
}

/// Requirement: what acts at the nodes of beams beside their centroid is told where that makes a difference: a weight across the way to the
/// centroid, not one along it, turning, forces per volume; nothing where there is no mass or no load.
#[test]
fn loads_beside_the_centroid_are_told() {
    let deck = |density: &str, load: &str| {
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 2., 0., 0.\n*ELEMENT, TYPE=B31, ELSET=BEAM\n1, 1, 2\n\
             *BEAM SECTION, SECTION=I, ELSET=BEAM, MATERIAL=M\n0., .4, .2, .2, .02, .02, .02\n0., 1., 0.\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1e9, .25\n*DENSITY\n{density}\n*BOUNDARY\n1, 1, 6\n*STEP\n*STATIC\n*DLOAD\nBEAM, {load}\n*END STEP\n"
        )
    };
    for (density, load, told) in [
        ("2.", "GRAV, 10., 0., 0., -1.", false),
        ("2.", "GRAV, 10., 0., -1., 0.", true),
        ("2.", "GRAV, 10., 1., 0., 0.", true),
        ("2.", "GRAV, 0., 0., -1., 0.", false),
        ("0.", "GRAV, 10., 0., -1., 0.", false),
        ("2.", "CENTRIF, 10., 0., 0., 0., 1., 0., 0.", true),
        ("2.", "BZ, 10.", false),
        ("2.", "BY, 10.", true),
        ("2.", "PY, 10.", false),
    ] {
        let read = Job::read_text("sections", &deck(density, load), &ReadOptions::default());
        assert!(read.model.is_some(), "{:#?}", read.diagnostics);
        let said = read.diagnostics.iter().any(|own| own.code.0 == "SL0432");
        assert_eq!(said, told, "{density} {load}: {:#?}", read.diagnostics);
    }
}

/// Requirement: sections with moduli of their own that expand are not told to expand in nothing (SL0253); one that weighs without a density
/// is told to give one, by its own name (SL0309).
#[test]
fn sections_with_moduli_of_their_own_expand() {
    let deck = |expansion: &str, load: &str| {
        format!(
            "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 2., 0., 0.\n*ELEMENT, TYPE=B31, ELSET=BEAM\n1, 1, 2\n\
             *BEAM GENERAL SECTION, SECTION=RECT, ELSET=BEAM\n.2, .3\n0., 0., -1.\n1000., 400.{expansion}\n\
             *BOUNDARY\n1, 1, 6\n*STEP\n*STATIC\n{load}*END STEP\n"
        )
    };
    let heat = "*TEMPERATURE\nALL, 10.\n";
    let said = |text: &str, code: &str| {
        let read = Job::read_text("sections", text, &ReadOptions::default());
        read.diagnostics.iter().find(|own| own.code.0 == code).map(|own| own.message.clone())
    };
    assert!(said(&deck("", heat), "SL0253").is_some());
    assert_eq!(said(&deck(", 1e-4", heat), "SL0253"), None);
    near(tip(&run(&deck(", 1e-4", heat)))[0], 1e-4 * 10.0 * 2.0, 1e-15);
    let weight = said(&deck("", "*DLOAD\nBEAM, GRAV, 10., 0., -1., 0.\n"), "SL0309");
    assert_eq!(weight.as_deref(), Some("the section has no DENSITY for this load"));
}
