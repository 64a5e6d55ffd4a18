//! Contact stabilisation: dashpots that fade to nothing by the end of a step.
//!
//! Source: docs/theory.md, section 8.12; the issue. Requirement: the end of a
//! step does not depend on it, its tractions are c phi dh/dt, its tangent is
//! exact, its energy is accounted for, and it is used unasked only where a
//! body that open contact will hold makes the equations singular, or where contact
//! that presses leaves one a motion (`unopposed.rs`).

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Energies, Event, Observer, Stop};
use slideline::{Checkpoint, Diagnostic, Job, Model, ReadOptions, SolveOptions, TangentCheck};
use slideline::{resume, solve};
use std::ops::ControlFlow;
use std::path::Path;

/// What a run shows: motion and reaction of one node, energies, what is said.
#[derive(Default)]
struct Watch {
    label: u64,
    rows: Vec<[f64; 4]>,
    energies: Vec<Energies>,
    said: Vec<Diagnostic>,
    tangents: Vec<f64>,
    /// The state after this increment.
    keep: usize,
    kept: Option<Checkpoint<'static>>,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                let node = frame.model.nodes.find(self.label).unwrap();
                let nodal = &frame.nodal;
                let [u1, u2] = [Dof::U1, Dof::U2].map(|dof| nodal.displacement(node, dof));
                let [r1, r2] = [Dof::U1, Dof::U2].map(|dof| nodal.reaction(node, dof));
                self.rows.push([u1, u2, r1, r2]);
                self.energies.push(frame.energy);
            }
            Event::Checkpoint(checkpoint) if checkpoint.increment == self.keep => {
                self.kept = Some(checkpoint.owned());
            }
            Event::Diagnosed(said) => self.said.push(said.clone()),
            Event::Tangent(report) => self.tangents.push(report.off),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

impl Watch {
    fn of(label: u64) -> Self {
        Self { label, ..Self::default() }
    }

    fn codes(&self) -> Vec<&'static str> {
        self.said.iter().map(|said| said.code.0).collect()
    }
}

fn model(text: &str) -> Model {
    let read = Job::read_text("stabilised", text, &ReadOptions::default());
    read.model.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

fn corpus(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn run(text: &str, watch: &mut Watch) -> Ending {
    solve(&model(text), &SolveOptions::default(), watch)
}

/// The deck with contact stabilised in its steps.
fn stabilised(text: &str, card: &str) -> String {
    text.replace("*END STEP", &format!("*CONTACT CONTROLS, {card}\n*END STEP"))
}

/// Requirement: the end state is that of the run without, in decks of either
/// method that run without. They have no friction, so the way there leaves
/// nothing. Tolerance: R_n = 1e-6 of the average force, at each end.
#[test]
fn the_end_of_the_step_does_not_depend_on_it() {
    for name in ["diehl1995/irs_coarse.inp", "diehl1995/isl_coarse.inp"] {
        let text = corpus(name);
        let (mut plain, mut damped) = (Watch::of(9999), Watch::of(9999));
        assert!(matches!(run(&text, &mut plain), Ending::Completed(_)));
        let with = stabilised(&text, "STABILIZE=10.0");
        assert!(matches!(run(&with, &mut damped), Ending::Completed(_)));
        let peak = plain.rows.iter().map(|row| row[3].abs()).fold(0.0, f64::max);
        let (end, other) = (plain.rows.last().unwrap(), damped.rows.last().unwrap());
        for (a, b) in end.iter().zip(other) {
            assert!((a - b).abs() < 4e-6 * peak.max(1.0), "{name}: {end:?} {other:?}");
        }
        // it did act on the way, and its energy stands in the balance
        let halfway = plain.rows.len() / 2;
        let off = (plain.rows[halfway][3] - damped.rows[halfway][3]).abs();
        assert!(off > 1e-4 * peak, "{name}: {off}");
        let (last, without) = (damped.energies.last().unwrap(), plain.energies.last().unwrap());
        assert!(last.stabilisation > 0.0 && without.stabilisation == 0.0);
        // both balances miss what the trapezoidal rule misses of a softened law
        let difference = (last.balance - without.balance).abs();
        assert!(difference < 0.02 * last.external_work, "{name}: {last:?} {without:?}");
        assert!(!damped.codes().contains(&"SL0517"), "{:?}", damped.said);
    }
}

/// A point under a growing load, far above a floor, with c given: phi falls
/// from increment to increment, and G(t) = A c phi dh/dt gives its way, on
/// which all the work goes into the dashpot. With the last increment it is
/// gone, and the floor holds the point.
#[test]
fn its_traction_is_proportional_to_the_rate() {
    const C: f64 = 40.0;
    const AREA: f64 = 0.5;
    const LOAD: f64 = 2.0;
    let text = format!(
        "*HEADING\na point above a floor\n*NODE\n1, 0.0, 3.0\n2, 1.0, 9.0\n99, 0.0, -1.0\n\
         *RIGID SURFACE, ELSET=FLOOR, TYPE=SEGMENTS\nSTART, -5.0, 0.0\nLINE, 5.0, 0.0\n\
         *ELEMENT, TYPE=IRS21, ELSET=FLOOR\n11, 1, 2, 99\n*INTERFACE, ELSET=FLOOR\n{width:?}\n\
         *STEP, NLGEOM\n*STATIC, DIRECT\n0.05, 1.0\n*BOUNDARY\n1, 1\n1, 6\n2, 1, 6\n99, 1, 6\n\
         *CLOAD\n1, 2, {load:?}\n*CONTACT CONTROLS, STABILIZE\n{C:?}\n*END STEP\n",
        // half of a contact element of this length belongs to the point
        width = 2.0 * AREA / 37.0_f64.sqrt(),
        load = -LOAD
    );
    let mut watch = Watch::of(1);
    assert!(matches!(run(&text, &mut watch), Ending::Completed(_)));
    let mut fallen = 0.0;
    for (k, row) in watch.rows.iter().take(19).enumerate() {
        let t = 0.05 * (k + 1) as f64;
        fallen += LOAD * t / (AREA * C * (1.0 - t)) * 0.05;
        // tolerance: the residual's
        assert!((row[1] + fallen).abs() < 1e-6 * fallen, "{k}: {row:?} {fallen}");
        let energy = &watch.energies[k];
        assert!((energy.stabilisation - energy.external_work).abs() < 1e-6 * energy.external_work);
    }
    assert!((watch.rows[19][1] + 3.0).abs() < 1e-9, "{:?}", watch.rows[19]);
    assert!(fallen < 3.0 && watch.codes() == ["SL0618"], "{fallen} {:?}", watch.said);
}

/// Requirement: the tangent with dashpots is the derivative of the residual in
/// every increment, with friction, for both methods. Tolerance as that of
/// `--check-tangent`, 1e-5 of the largest entry of its kind.
#[test]
fn its_tangent_is_exact() {
    for name in ["diehl1995/irs_coarse_mu03.inp", "diehl1995/isl_coarse_mu03.inp"] {
        let text = stabilised(&corpus(name), "STABILIZE=1000.0");
        let mut watch = Watch::of(9999);
        let options =
            SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() };
        assert!(matches!(solve(&model(&text), &options, &mut watch), Ending::Completed(_)));
        let worst = watch.tangents.iter().copied().fold(0.0, f64::max);
        assert!(watch.tangents.len() >= 20 && worst < 1e-5, "{name}: {worst}");
        assert!(watch.codes().contains(&"SL0618"), "{name}: {:?}", watch.said);
    }
}

/// A ball above a bowl: one point, one normal, nothing along the tangent. The
/// program stabilises by itself and says so once; the ball ends at the bottom,
/// where a deck that asks for it ends as well. Without friction the bottom is
/// x = 0, to what the residual allows: |dx| = R_n / 2.
#[test]
fn a_body_that_only_open_contact_holds_is_stabilised_and_told() {
    let asked = corpus("keywords/contact_controls_stabilize.inp");
    let unasked = asked.replace("*CONTACT CONTROLS, STABILIZE\n", "");
    assert!(asked != unasked);
    for (text, codes) in [(&asked, vec!["SL0618"]), (&unasked, vec!["SL0517", "SL0618"])] {
        let mut watch = Watch::of(1);
        let ending = run(text, &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?} {:?}", watch.rows);
        let [u1, u2, ..] = *watch.rows.last().unwrap();
        assert!((u1 + 0.2).abs() < 1e-5 && (u2 + 0.1).abs() < 1e-9, "{u1} {u2}");
        assert_eq!(watch.codes(), codes);
        let last = watch.energies.last().unwrap();
        assert!(last.stabilisation > 0.0 && last.strain_energy == 0.0, "{last:?}");
    }
}

/// Requirement: an equation to a node that is held is a support of its dof and of no other: what it leaves free is
/// stabilised, as with the support.
#[test]
fn equations_to_a_held_node_are_supports() {
    let asked = corpus("keywords/contact_controls_stabilize.inp");
    let by_support = asked.replace("*CONTACT CONTROLS, STABILIZE\n", "");
    let by_equation = by_support
        .replace("*STEP", "*EQUATION\n2\n1, 6, 1.0, 2, 6, -1.0\n*STEP")
        .replace("1, 6\n2, 1, 6", "2, 1, 6");
    let ends = [by_support, by_equation].map(|text| {
        let mut watch = Watch::of(1);
        let ending = run(&text, &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?} {:?}", watch.said);
        assert_eq!(watch.codes(), ["SL0517", "SL0618"]);
        *watch.rows.last().unwrap()
    });
    assert!((ends[0][0] - ends[1][0]).abs() < 1e-9, "{ends:?}");
}

/// Requirement: a block that floats above a floor, however far, with contact over its face, comes down upon it in one
/// increment: the contact step closes the gap, although no row feels a stiffness but its own augmentation. The floor has
/// EA/l = 3000, nu = 0: it yields by 2/3000.
#[test]
fn a_floating_block_comes_down() {
    for gap in [0.03, 0.5] {
        let (foot, head) = (1.0 + gap, 2.0 + gap);
        let text = format!(
            "*NODE\n1, 0., 0.\n2, 3., 0.\n3, 3., 1.\n4, 0., 1.\n11, 0., {foot:?}\n12, 3., {foot:?}\n\
             13, 3., {head:?}\n14, 0., {head:?}\n*ELEMENT, TYPE=CPE4, ELSET=E\n1, 1, 2, 3, 4\n2, 11, 12, 13, 14\n\
             *SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
             *SURFACE, NAME=LOW\n1, S3\n*SURFACE, NAME=UP\n2, S1\n*SURFACE INTERACTION, NAME=I\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nUP, LOW\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n3, 1\n4, 1\n11, 1\n\
             14, 1\n*STEP, NLGEOM=NO\n*STATIC\n0.25, 1.\n*CLOAD\n13, 2, -1.\n14, 2, -1.\n*END STEP\n"
        );
        let mut watch = Watch::of(14);
        let ending = run(&text, &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{gap} {ending:?}");
        let down = watch.rows.last().unwrap()[1];
        assert!((down + gap + 4.0 / 3000.0).abs() < 1e-9, "{gap} {down}");
        assert_eq!(watch.rows.len(), 4, "{gap}");
    }
}

/// Requirement: nothing is stabilised unasked where contact was closed, or
/// where no contact would oppose the motion; SL0503 says what moves.
#[test]
fn it_is_no_cure_for_what_contact_does_not_hold() {
    let mut hinged = Watch::of(5);
    let ending = run(&corpus("bad/SL0503-hinged-beam.inp"), &mut hinged);
    assert!(matches!(ending, Ending::NotConverged(_, why) if why.code.0 == "SL0503"));
    assert!(!hinged.codes().contains(&"SL0517"));
    let mut block = Watch::of(100);
    let ending = run(&corpus("bad/SL0503-sliding-block.inp"), &mut block);
    let Ending::NotConverged(_, why) = ending else { panic!("{ending:?}") };
    assert!(why.code.0 == "SL0503" && why.message.contains("until it had faded"), "{why:?}");
    assert_eq!(block.codes(), ["SL0517", "SL0503"]);
}

/// Requirement: a run that goes on from a saved state is bit for bit the run
/// that was never left, the forces of the dashpots included.
#[test]
fn a_run_that_goes_on_is_the_same() {
    let text = corpus("keywords/contact_controls_stabilize.inp")
        .replace("*CONTACT CONTROLS, STABILIZE\n", "");
    let model = model(&text);
    let mut whole = Watch { keep: 7, ..Watch::of(1) };
    let options = SolveOptions::default();
    assert!(matches!(solve(&model, &options, &mut whole), Ending::Completed(_)));
    let mut rest = Watch::of(1);
    let ending = resume(&model, &options, whole.kept.unwrap(), &mut rest).unwrap();
    assert!(matches!(ending, Ending::Completed(_)));
    assert_eq!(whole.rows[7..], rest.rows[..]);
    assert_eq!(whole.energies[7..], rest.energies[..]);
    assert_eq!(rest.codes(), ["SL0618"], "stabilised already");
}

/// Requirement: `JOB.energy.csv` has the column where it can be needed, and
/// the paper's decks keep their files as they were.
#[test]
fn the_energy_has_a_column_where_it_is_needed() {
    let header = |text: &str, name: &str| {
        let read = Job::read_text(name, text, &ReadOptions::default());
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stabilisation");
        let options = slideline::RunOptions { folder: Some(folder), ..Default::default() };
        let outcome = slideline::run(&read, &options, &mut slideline::Quiet);
        let file = std::fs::read_to_string(outcome.files.path(".energy.csv")).unwrap();
        let rows: Vec<usize> = file.lines().map(|line| line.split(',').count()).collect();
        assert!(rows.iter().all(|&count| count == rows[0]));
        file.lines().next().unwrap().to_owned()
    };
    let bowl = corpus("keywords/contact_controls_stabilize.inp");
    assert!(header(&bowl, "bowl").ends_with(",balance,stabilisation,released_energy"));
    assert!(
        header(&corpus("diehl1995/irs_coarse.inp"), "irs").ends_with(",balance,released_energy")
    );
    assert!(
        header(&corpus("diehl1995/isl_coarse.inp"), "isl").ends_with(",balance,released_energy")
    );
}
