//! Loads from one step to the next: what is applied at a time, by hand, for every family of loads.
//!
//! Source: docs/theory.md eq. (9.5); Abaqus manual, `*CLOAD`, `*DLOAD`, `*DSLOAD`.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof, Model};
use slideline::observe::{Ending, Frame};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, resume, solve};
use std::ops::ControlFlow;

/// A committed increment: vectors have two entries a node, in the order of the nodes.
#[derive(Clone, Debug)]
struct Row {
    step: usize,
    time: f64,
    load: Vec<f64>,
    motion: Vec<f64>,
    reaction: Vec<f64>,
    work: f64,
    strain: f64,
    iterations: usize,
}

#[derive(Default)]
struct Rows {
    rows: Vec<Row>,
    unsymmetric: Vec<bool>,
}

fn each(frame: &Frame<'_>, of: impl Fn(usize, Dof) -> f64) -> Vec<f64> {
    let nodes = 0..frame.model.nodes.len();
    nodes.flat_map(|node| [Dof::U1, Dof::U2].map(|dof| of(node, dof))).collect()
}

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::StepBegin(report) => self.unsymmetric.push(report.unsymmetric),
            Event::Committed(frame) => self.rows.push(Row {
                step: frame.step,
                time: frame.step_time,
                load: each(frame, |node, dof| frame.nodal.load(node, dof)),
                motion: each(frame, |node, dof| frame.nodal.displacement(node, dof)),
                reaction: each(frame, |node, dof| frame.nodal.reaction(node, dof)),
                work: frame.energy.external_work,
                strain: frame.energy.strain_energy,
                iterations: frame.equilibrium_iterations,
            }),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// A block of 2 by 1 in four elements, thickness 3, E = 1000, nu = 0.25, density 0.5, held along
/// its left and lower sides. UP is 1/4 + t/4, DOWN 1 - t/4 over the time of a step, TOT the total
/// time.
fn model(history: &str, dialect: Dialect) -> Model {
    let mut nodes = String::new();
    for j in 0..3 {
        for i in 0..3 {
            nodes += &format!("{}, {:?}, {:?}\n", 1 + i + 3 * j, f64::from(i), 0.5 * f64::from(j));
        }
    }
    let deck = format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=CPE4, ELSET=B\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n3, 4, 5, 8, 7\n\
         4, 5, 6, 9, 8\n*ELSET, ELSET=R\n2, 4\n*ELSET, ELSET=L\n1, 3\n*SOLID SECTION, ELSET=B, \
         MATERIAL=M\n3.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.25\n*DENSITY\n0.5\n\
         *SURFACE, NAME=RIGHT, TYPE=ELEMENT\nR, S2\n\
         *AMPLITUDE, NAME=UP\n0., 0.25, 2., 0.75\n*AMPLITUDE, NAME=DOWN\n0., 1., 2., 0.5\n\
         *AMPLITUDE, NAME=TOT, TIME=TOTAL TIME\n0., 0., 9., 9.\n\
         *BOUNDARY\n1, 1, 2\n4, 1\n7, 1\n2, 2\n3, 2\n{history}"
    );
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("loads", &deck, &options);
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-12;
    }
    model
}

fn walked(model: &Model) -> Rows {
    let mut rows = Rows::default();
    match solve(model, &SolveOptions::default(), &mut rows) {
        Ending::Completed(_) => rows,
        other => panic!("{other:?}"),
    }
}

/// A step of increments of 1/2 with these parameters and cards.
fn step(period: f64, parameters: &str, cards: &str) -> String {
    format!("*STEP{parameters}\n*STATIC, DIRECT\n0.5, {period:?}\n{cards}*END STEP\n")
}

fn run(history: &str, dialect: Dialect) -> Vec<Row> {
    walked(&model(history, dialect)).rows
}

/// Loads, motions and reactions of a load of size 1, by itself.
fn unit(card: &str, dialect: Dialect) -> Row {
    run(&step(1.0, "", card), dialect).pop().unwrap()
}

type Vector = fn(&Row) -> &[f64];

/// What is wrong with a row whose vectors should be the sums of the unit ones by these factors, and
/// whose work should be stored: small displacements, linear elasticity. 1e-9 of the largest.
fn fault(row: &Row, parts: &[(f64, &Row)], about: &str) -> Option<String> {
    let vectors: [(&str, Vector); 3] = [
        ("load", |row| &row.load),
        ("motion", |row| &row.motion),
        ("reaction", |row| &row.reaction),
    ];
    for (name, vector) in vectors {
        let size = |row: &Row| vector(row).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let most = parts.iter().map(|(_, unit)| size(unit)).fold(0.0, f64::max);
        for (place, &found) in vector(row).iter().enumerate() {
            let expected: f64 = parts.iter().map(|(f, unit)| f * vector(unit)[place]).sum();
            if (found - expected).abs() > 1e-9 * most {
                let at = row.time;
                return Some(format!("{about}: {name} {place} at {at}: {found} for {expected}"));
            }
        }
    }
    let balanced = (row.work - row.strain).abs() < 1e-9 * (1.0 + row.strain);
    (!balanced).then(|| format!("{about}: work {} stored {}", row.work, row.strain))
}

fn none(faults: &[String]) {
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// A card of a family with these parameters; without a size no lines.
type Family = (&'static str, fn(&str, Option<f64>) -> String);

const FAMILIES: [Family; 7] = [
    ("force", |p, size| card("*CLOAD", p, size, &["9, 1, ", "6, 1, "], "")),
    ("weight", |p, size| card("*DLOAD", p, size, &["B, GRAV, "], ", 0., -1., 0.")),
    ("force per volume", |p, size| card("*DLOAD", p, size, &["B, BX, "], "")),
    ("turning", |p, size| card("*DLOAD", p, size, &["B, CENTRIF, "], ", -1., 0., 0., 0., 1., 0.")),
    ("pressure", |p, size| card("*DLOAD", p, size, &["R, P2, "], "")),
    ("pressure on a surface", |p, size| card("*DSLOAD", p, size, &["RIGHT, P, "], "")),
    ("traction", |p, size| card("*DSLOAD", p, size, &["RIGHT, TRVEC, "], ", 1., 0., 0.")),
];

fn card(name: &str, parameters: &str, size: Option<f64>, lines: &[&str], rest: &str) -> String {
    let lines = lines.iter().filter_map(|line| Some(format!("{line}{:?}{rest}\n", size?)));
    format!("{name}{parameters}\n{}", lines.collect::<String>())
}

/// Parameters of a step, and its cards: parameters and size.
type Said = (&'static str, &'static [(&'static str, Option<f64>)]);

/// What the steps say, and the factor by the time of the last one, which is 2 long.
type Case = (&'static str, &'static [Said], fn(f64) -> f64);

const UP: &str = ", AMPLITUDE=UP";
const DOWN: &str = ", AMPLITUDE=DOWN";
const TOT: &str = ", AMPLITUDE=TOT";
const NEW: &str = ", OP=NEW";
const AT_ONCE: &str = ", AMPLITUDE=STEP";
const FOUR: Said = ("", &[("", Some(4.0))]);
const FOUR_UP: Said = ("", &[(UP, Some(4.0))]);
const BOTH: Said = ("", &[("", Some(4.0)), (UP, Some(8.0))]);
const NOTHING: Said = ("", &[]);
const REMOVED: Said = ("", &[(NEW, None)]);

fn up(t: f64) -> f64 {
    0.25 + 0.25 * t
}

fn down(t: f64) -> f64 {
    1.0 - 0.25 * t
}

const CASES: [Case; 24] = [
    ("kept", &[FOUR, NOTHING], |_| 4.0),
    ("said again", &[FOUR, FOUR], |_| 4.0),
    ("changed", &[FOUR, ("", &[("", Some(10.0))])], |t| 4.0 + 3.0 * t),
    ("first in step 2", &[NOTHING, FOUR], |t| 2.0 * t),
    ("curve in step 2", &[FOUR, ("", &[(UP, Some(8.0))])], |t| 8.0 * up(t)),
    ("curve in step 1, kept", &[FOUR_UP, NOTHING], |_| 2.0),
    ("curve in step 1 alone", &[FOUR_UP, ("", &[("", Some(10.0))])], |t| 2.0 + 4.0 * t),
    ("curve in both", &[FOUR_UP, ("", &[(UP, Some(8.0))])], |t| 8.0 * up(t)),
    ("another curve", &[FOUR_UP, ("", &[(DOWN, Some(8.0))])], |t| 8.0 * down(t)),
    ("removed", &[FOUR, REMOVED], |t| 4.0 - 2.0 * t),
    ("removed and said again", &[FOUR, ("", &[(NEW, Some(10.0))])], |t| 4.0 + 3.0 * t),
    ("curve in step 1, removed", &[FOUR_UP, REMOVED], |t| 2.0 - t),
    ("two, kept", &[BOTH, NOTHING], |_| 8.0),
    ("two, said again", &[BOTH, BOTH], |t| 4.0 + 8.0 * up(t)),
    ("a second one with a curve", &[FOUR, ("", &[("", Some(2.0)), (UP, Some(8.0))])], |t| {
        4.0 - t + 8.0 * up(t)
    }),
    ("one of two goes", &[BOTH, ("", &[("", Some(2.0))])], |t| 8.0 - 3.0 * t),
    ("a curve for two", &[BOTH, ("", &[(DOWN, Some(6.0))])], |t| 6.0 * down(t)),
    ("over the total time", &[("", &[(TOT, Some(4.0))]), NOTHING], |t| 4.0 * (1.0 + t)),
    ("one over the total time", &[("", &[("", Some(4.0)), (TOT, Some(2.0))]), NOTHING], |t| {
        4.0 + 2.0 * (1.0 + t)
    }),
    ("over the total time, removed", &[("", &[(TOT, Some(4.0))]), REMOVED], |t| 4.0 - 2.0 * t),
    ("at once", &[FOUR, (AT_ONCE, &[("", Some(10.0))])], |_| 10.0),
    ("removed at once", &[FOUR, (AT_ONCE, &[(NEW, None)])], |_| 0.0),
    ("curve, then kept", &[FOUR, ("", &[(UP, Some(8.0))]), NOTHING], |_| 4.0),
    ("removed, then said again", &[FOUR, REMOVED, FOUR], |t| 2.0 * t),
];

/// Requirement: a load without a curve goes linearly from what it was at the end of the step before
/// to its value, one with a curve follows that from the beginning, one that is removed ramps off;
/// several on one place go on each by itself. The same for all families and in both dialects.
#[test]
fn every_load_goes_on_from_its_own_value() {
    let mut faults = Vec::new();
    for dialect in [Dialect::Abaqus, Dialect::Calculix] {
        for (family, card) in FAMILIES {
            let unit = unit(&card("", Some(1.0)), dialect);
            for (case, steps, factor) in &CASES {
                let count = steps.len();
                let history: String = steps
                    .iter()
                    .enumerate()
                    .map(|(k, (parameters, cards))| {
                        let period = if k + 1 == count { 2.0 } else { 1.0 };
                        let cards: String = cards.iter().map(|(p, size)| card(p, *size)).collect();
                        step(period, parameters, &cards)
                    })
                    .collect();
                let about = format!("{dialect:?}, {family}, {case}");
                let rows = run(&history, dialect);
                let last: Vec<&Row> = rows.iter().filter(|row| row.step == count).collect();
                assert_eq!(last.len(), 4, "{about}");
                let wrong = |row: &&Row| fault(row, &[(factor(row.time), &unit)], &about);
                faults.extend(last.iter().find_map(wrong));
            }
        }
    }
    none(&faults);
}

/// Requirement: a load goes on from the one of its own place and kind. Weight of a part of the
/// elements; a weight that turns (Abaqus knows one of an element); a pressure of `*DLOAD` beside one
/// of `*DSLOAD`, which CalculiX does not tell apart.
#[test]
fn loads_are_matched_by_place_and_kind() {
    use Dialect::{Abaqus, Calculix};
    let mut faults = Vec::new();
    let weight = |set: &str, parameters: &str, size: f64, way: &str| {
        format!("*DLOAD{parameters}\n{set}, GRAV, {size:?}, {way}\n")
    };
    let [below, aside] = ["0., -1., 0.", "1., 0., 0."];
    let of = |dialect: Dialect, set: &str, way: &str| unit(&weight(set, "", 1.0, way), dialect);
    let two = |first: &str, second: &str, dialect| {
        let rows = run(&(step(1.0, "", first) + &step(2.0, "", second)), dialect);
        rows.into_iter().filter(|row| row.step == 2).collect::<Vec<_>>()
    };
    for dialect in [Abaqus, Calculix] {
        let [left, right] = ["L", "R"].map(|set| of(dialect, set, below));
        let all = weight("B", "", 4.0, below);
        for row in two(&all, &weight("R", UP, 8.0, below), dialect) {
            faults.extend(fault(
                &row,
                &[(4.0, &left), (8.0 * up(row.time), &right)],
                "part, curve",
            ));
        }
        for row in two(&all, &weight("R", "", 8.0, below), dialect) {
            faults.extend(fault(&row, &[(4.0, &left), (4.0 + 2.0 * row.time, &right)], "part"));
        }
    }
    let [down, along] = [below, aside].map(|way| of(Abaqus, "B", way));
    let first = weight("B", "", 4.0, below);
    for row in two(&first, &weight("B", "", 6.0, aside), Abaqus) {
        faults.extend(fault(
            &row,
            &[(4.0 - 2.0 * row.time, &down), (3.0 * row.time, &along)],
            "turned",
        ));
    }
    for row in two(&first, &weight("B", UP, 6.0, aside), Abaqus) {
        faults.extend(fault(&row, &[(0.0, &down), (6.0 * up(row.time), &along)], "turned, curve"));
    }
    let [down, along] = [below, aside].map(|way| of(Calculix, "B", way));
    for row in two(&first, &weight("B", UP, 6.0, aside), Calculix) {
        faults.extend(fault(&row, &[(4.0, &down), (6.0 * up(row.time), &along)], "beside"));
    }
    let pressure = unit("*DLOAD\nR, P2, 1.\n", Abaqus);
    let first = "*DLOAD\nR, P2, 4.\n*DSLOAD\nRIGHT, P, 2.\n";
    let second = "*DLOAD, OP=NEW\n*DSLOAD, AMPLITUDE=UP\nRIGHT, P, 8.\n";
    for row in two(first, second, Abaqus) {
        let factor = 4.0 - 2.0 * row.time + 8.0 * up(row.time);
        faults.extend(fault(&row, &[(factor, &pressure)], "both cards"));
    }
    for row in two(first, second, Calculix) {
        faults.extend(fault(&row, &[(8.0 * up(row.time), &pressure)], "one list"));
    }
    none(&faults);
}

const BENT: &str = ", NLGEOM";

/// The state under this pressure on the upper side of the right half, in one step.
fn under(pressure: f64) -> Row {
    run(&step(1.0, BENT, &format!("*DLOAD\n4, P3, {pressure:?}\n")), Dialect::Abaqus).pop().unwrap()
}

fn are_near(a: &[f64], b: &[f64], tolerance: f64, about: &str) {
    let most = b.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let off = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= tolerance * most, "{about}: {off} of {most}");
}

/// Requirement: at large displacements a pressure that goes on leaves the state as it is; one that
/// changes or is removed follows its face all the while, so that the state under it is that of a
/// single step to the same pressure (elastic: no history), found with the whole tangent. 1e-9.
#[test]
fn a_pressure_follows_its_face_while_it_goes_on() {
    let first = step(1.0, BENT, "*DLOAD\n4, P3, 240.\n");
    let end = under(240.0);
    let most = end.motion.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    assert!(most > 0.1, "far from small: {most}");
    let same = walked(&model(&(first.clone() + &step(2.0, BENT, "")), Dialect::Abaqus));
    for row in same.rows.iter().filter(|row| row.step == 2) {
        are_near(&row.motion, &end.motion, 1e-12, "motion kept");
        are_near(&row.load, &end.load, 1e-12, "load kept");
        assert!(row.iterations <= 1, "{}", row.iterations);
    }
    type Pressure = fn(f64) -> f64;
    let cases: [(&str, Pressure); 3] = [
        ("*DLOAD\n4, P3, 120.\n", |t| 240.0 - 60.0 * t),
        ("*DLOAD, OP=NEW\n", |t| 240.0 - 120.0 * t),
        ("*DLOAD, AMPLITUDE=DOWN\n4, P3, 200.\n", |t| 200.0 * (1.0 - 0.25 * t)),
    ];
    for (cards, pressure) in cases {
        let found = walked(&model(&(first.clone() + &step(2.0, BENT, cards)), Dialect::Abaqus));
        assert_eq!(found.unsymmetric, [true, true], "{cards}");
        for row in found.rows.iter().filter(|row| row.step == 2) {
            let expected = under(pressure(row.time));
            if pressure(row.time) > 0.0 {
                are_near(&row.motion, &expected.motion, 1e-9, cards);
                are_near(&row.load, &expected.load, 1e-9, cards);
                are_near(&row.reaction, &expected.reaction, 1e-9, cards);
            }
            assert!(row.iterations <= 6, "{cards}: {}", row.iterations);
        }
    }
}

/// Requirement: what a pressure does on its way up it takes back on its way down: after it is gone
/// nothing is left of motion, work and energy. The increments are the same both ways, and so are the
/// trapezoids of the work. 1e-7 of the most there was: an increment that ends without forces is
/// judged by 1e-5 of those of its step (docs/theory.md section 9).
#[test]
fn a_pressure_that_is_removed_takes_its_work_back() {
    let loaded = step(2.0, BENT, "*DLOAD\n4, P3, 240.\n");
    let rows = run(&(loaded + &step(2.0, BENT, "*DLOAD, OP=NEW\n")), Dialect::Abaqus);
    let (top, last) = (&rows[3], rows.last().unwrap());
    let most = top.motion.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    assert!(last.motion.iter().all(|u| u.abs() < 1e-7 * most), "{:?}", last.motion);
    assert!(last.work.abs() < 1e-7 * top.work, "{} of {}", last.work, top.work);
    assert!(last.strain.abs() < 1e-7 * top.strain, "{} of {}", last.strain, top.strain);
}

/// Keeps what a run of two steps could go on from in the middle of the second.
#[derive(Default)]
struct Kept(Rows, Option<slideline::Checkpoint<'static>>);

impl Observer for Kept {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Checkpoint(at) = event
            && (at.step, at.increment) == (2, 2)
        {
            self.1 = Some(at.owned());
        }
        self.0.event(event)
    }
}

/// Requirement: a run that goes on from the middle of a step whose loads ramp has the same bits.
#[test]
fn ramps_go_on_after_a_restart() {
    let first = "*CLOAD\n9, 1, 4.\n*DLOAD\n4, P3, 100.\nB, GRAV, 3., 0., -1., 0.\n";
    let second = "*CLOAD\n9, 1, 8.\n*DLOAD, OP=NEW\nB, GRAV, 1., 0., -1., 0.\n";
    let history = step(1.0, BENT, first) + &step(2.0, BENT, second);
    let model = model(&history, Dialect::Abaqus);
    let mut kept = Kept::default();
    solve(&model, &SolveOptions::default(), &mut kept);
    let mut rest = Rows::default();
    resume(&model, &SolveOptions::default(), kept.1.unwrap(), &mut rest).unwrap();
    assert_eq!(rest.rows.len(), 2);
    for (a, b) in rest.rows.iter().zip(&kept.0.rows[4..]) {
        assert_eq!((&a.motion, &a.load, a.time), (&b.motion, &b.load, b.time));
    }
}

/// Requirement: linear steps with PERTURBATION answer to their own loads and motions, whatever those
/// before did, under the supports before the first step. Source: Abaqus manual, linear perturbation;
/// each step against a deck that has it alone. 1e-9.
#[test]
fn perturbations_answer_to_their_own_loads() {
    let cards = [
        "*CLOAD\n9, 1, 2.\n",
        "*DLOAD\nB, GRAV, 3., 0., -1., 0.\n",
        "*BOUNDARY\n9, 1, 1, 0.02\n6, 2, 2, -0.01\n",
        "*DSLOAD\nRIGHT, P, 4.\n",
        "*CLOAD\n9, 2, 1.\n",
    ];
    let linear = ", NLGEOM=NO, PERTURBATION";
    let history: String = cards.map(|card| step(1.0, linear, card)).concat();
    let rows = run(&history, Dialect::Abaqus);
    let ends = rows.iter().filter(|row| row.time == 1.0);
    let alone = cards.map(|card| unit(card, Dialect::Abaqus));
    let faults = ends.zip(&alone).zip(cards);
    let faults: Vec<String> =
        faults.filter_map(|((row, own), card)| fault(row, &[(1.0, own)], card)).collect();
    none(&faults);
    assert_eq!(rows.last().map(|row| row.step), Some(5));
}

/// Requirement: in the dialect of CalculiX P with the number of a face loads surfaces as P, and elements
/// as `*DLOAD` does. Source: ccx 2.20. 1e-9.
#[test]
fn numbered_pressures_of_calculix() {
    let dialect = Dialect::Calculix;
    let plain = unit("*DSLOAD\nRIGHT, P, 4.\n", dialect);
    let cards = ["RIGHT, P2, 4.", "R, P2, 4.", "2, P2, 4.\n4, P2, 4."];
    let faults = cards.map(|lines| {
        let row = unit(&format!("*DSLOAD\n{lines}\n"), dialect);
        fault(&row, &[(1.0, &plain)], lines)
    });
    none(&faults.into_iter().flatten().collect::<Vec<_>>());
}

/// Requirement: `VALUE=ABSOLUTE` gives the values themselves, of loads and motions, and the numbers on the lines do
/// not count; in the dialect of CalculiX all amplitudes are factors. Source: Abaqus manual, `*AMPLITUDE`. 1e-9.
#[test]
fn absolute_amplitudes_stand_for_the_numbers() {
    let curve = "*AMPLITUDE, NAME=ABS, VALUE=ABSOLUTE\n0., 0., 1., 3.\n";
    let mut faults = Vec::new();
    for (dialect, factor) in [(Dialect::Abaqus, 1.0), (Dialect::Calculix, 4.0)] {
        let motion = |p: &str, size: Option<f64>| card("*BOUNDARY", p, size, &["9, 1, 1, "], "");
        let families =
            FAMILIES.into_iter().chain([("motion", motion as fn(&str, Option<f64>) -> String)]);
        for (name, family) in families {
            let own = unit(&family("", Some(1.0)), dialect);
            // a named support holds, whatever the curve
            let cards = curve.to_owned()
                + &family(", AMPLITUDE=ABS", Some(4.0))
                + "*BOUNDARY, AMPLITUDE=ABS\n1, PINNED\n";
            for row in run(&step(1.0, "", &cards), dialect) {
                faults.extend(fault(&row, &[(3.0 * factor * row.time, &own)], name));
            }
        }
    }
    none(&faults);
}

/// Requirement: what `OP=NEW` drops of supports lets go over the step, and in the dialect of CalculiX when the step
/// begins. Source: docs/theory.md section 9; ccx 2.20. 1e-9.
#[test]
fn supports_that_are_dropped_let_go() {
    let held = "*BOUNDARY, OP=NEW\n1, 1, 2\n4, 1\n7, 1\n2, 2\n3, 2\n";
    let steps = step(1.0, "", "*BOUNDARY\n9, 1, 1, 0.01\n") + &step(1.0, "", held);
    for (dialect, left) in [(Dialect::Abaqus, [0.5, 0.0]), (Dialect::Calculix, [0.0, 0.0])] {
        let rows = run(&steps, dialect);
        let moved = |row: &Row| row.motion[16];
        assert!((moved(&rows[1]) - 0.01).abs() < 1e-15);
        for (row, left) in rows[2..].iter().zip(left) {
            assert!(
                (moved(row) - 0.01 * left).abs() < 1e-11,
                "{dialect:?} {} {}",
                row.time,
                moved(row)
            );
        }
    }
}
