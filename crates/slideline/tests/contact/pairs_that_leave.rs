//! Contact pairs that leave the model and come back, and laws as CalculiX means them.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::two_blocks::{ALL, mesh, solved};
use slideline::model::{Dialect, Master, NormalLaw};
use slideline::output::report::{Options, write};
use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::path::Path;

const STEP: &str = "*STEP\n*STATIC, DIRECT\n0.5, 1.0\n";

/// Requirement: blocks pressed by d carry N = E A d/2; removed, nothing; added again, N. At nodes and
/// over faces, in the plane and in space. Tolerance: rounding.
#[test]
fn a_removed_pair_carries_nothing() {
    for (in_space, kind) in ALL {
        let up = if in_space { 3 } else { 2 };
        let change = |what: &str| {
            format!("{STEP}*MODEL CHANGE, TYPE=CONTACT PAIR, {what}\nUPPER, LOWER\n*END STEP\n")
        };
        let deck = format!(
            "{}*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nUPPER, LOWER\n\
             {STEP}*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\nHIGH, {up}, {up}, -0.01\n*END STEP\n",
            mesh(in_space, 0.0)
        ) + &change("REMOVE")
            + &change("ADD");
        let along: Vec<f64> = solved(&deck).force.iter().map(|force| force[up - 1]).collect();
        // at the ends of the steps: what ramps off or on in between is not held to this
        for (increment, wanted) in [(1, 5.0), (2, 0.0), (3, 0.0), (5, 5.0)] {
            let off = along[increment] - wanted;
            assert!(off.abs() < 1e-9, "{kind} {in_space}, {increment}: {along:?}");
        }
    }
}

/// Requirement: a pair that comes back overclosed brings the work that resolves the overclosure, so that
/// energy balances to rounding, whatever the law; without it as much as the blocks hold was missing.
#[test]
fn energy_balances_where_a_pair_comes_back_overclosed() {
    let laws = ["", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n5000.0\n"];
    for ((in_space, kind), law) in ALL.into_iter().flat_map(|own| laws.map(|law| (own, law))) {
        let up = if in_space { 3 } else { 2 };
        let change = |what: &str| {
            format!("{STEP}*MODEL CHANGE, TYPE=CONTACT PAIR, {what}\nUPPER, LOWER\n*END STEP\n")
        };
        let deck = format!(
            "{}*SURFACE INTERACTION, NAME=I\n{law}*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nUPPER, LOWER\n\
             {STEP}*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\nHIGH, {up}, {up}, -0.01\n*END STEP\n",
            mesh(in_space, 0.0)
        ) + &change("REMOVE")
            + &change("ADD");
        let balance = solved(&deck).balance;
        assert!(balance < 1e-9, "{kind} {in_space} {law:?}: {balance}");
    }
}

/// Requirement: a pair that is absent from the first step on, and comes overclosed by d with friction, carries
/// N = E A d/2 and brings its work. In space, over faces, the program fell: no faces had been placed.
#[test]
fn a_pair_may_come_first_in_a_later_step() {
    let overlap = 1e-4;
    for (in_space, kind) in ALL {
        let up = if in_space { 3 } else { 2 };
        let change =
            |what: &str| format!("*MODEL CHANGE, TYPE=CONTACT PAIR, {what}\nUPPER, LOWER\n");
        let deck = format!(
            "{}*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.3\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\n\
             UPPER, LOWER\n{STEP}*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\n{}*END STEP\n{STEP}{}*END STEP\n",
            mesh(in_space, -overlap),
            change("REMOVE"),
            change("ADD")
        );
        let curve = solved(&deck);
        let force = curve.force.last().unwrap()[up - 1];
        assert!((force / (500.0 * overlap) - 1.0).abs() < 1e-3, "{kind} {in_space}: {force}");
        assert!(curve.balance < 1e-9, "{kind} {in_space}: {}", curve.balance);
    }
}

/// Requirement: a run that ends without its pair has a report; where rows of closed points are gone
/// the contact file was cut, and there is none.
#[test]
fn a_run_that_ends_without_a_pair_has_a_report() {
    let deck = format!(
        "{}*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nUPPER, LOWER\n\
         {STEP}*BOUNDARY\nLOW, 1, 2\nHIGH, 1, 2\nHIGH, 2, 2, -0.01\n*END STEP\n\
         {STEP}*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nUPPER, LOWER\n*END STEP\n",
        mesh(false, 0.0)
    );
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("ends_without_a_pair");
    let _ = std::fs::remove_dir_all(&folder);
    let read = Job::read_text("leaves", &deck, &ReadOptions::default());
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:#?}", outcome.diagnostics);
    let report = || write(&outcome.files, &Options::default());
    assert!(report().is_ok(), "{:?}", report().err().map(|problem| problem.to_string()));
    let path = folder.join("leaves.contact.csv");
    let rows = std::fs::read_to_string(&path).unwrap();
    let closed: String =
        rows.split_inclusive('\n').filter(|row| !row.starts_with("1,2,")).collect();
    assert!(closed.len() < rows.len(), "{rows}");
    std::fs::write(
        path,
        closed.split_inclusive('\n').take_while(|row| !row.starts_with("2,")).collect::<String>(),
    )
    .unwrap();
    assert!(report().is_err(), "rows of the second increment, which are closed, are gone");
}

/// Requirement: in CalculiX the pull of a linear law counts at nodes alone (measured with ccx 2.20:
/// between faces a thousandfold pull changes no digit), and an interaction without a law is warned
/// of. In Abaqus it is hard contact and nothing is said.
#[test]
fn laws_are_those_of_calculix() {
    let read = |kind: &str, laws: &str, dialect: Dialect| {
        let deck = format!(
            "{}*SURFACE INTERACTION, NAME=I\n{laws}*CONTACT PAIR, INTERACTION=I, TYPE={kind}\n\
             UPPER, LOWER\n{STEP}*END STEP\n",
            mesh(true, 0.0)
        );
        let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
        let read = Job::read_text("laws", &deck, &options);
        let warned = read.diagnostics.iter().any(|said| said.code.0 == "SL0399");
        (read.model.unwrap().contact_pairs[0].interaction.normal.clone(), warned)
    };
    let linear = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1.0E5, 3.0\n";
    let (stiffness, tension) = (1e5, 3.0);
    let (faces, nodes) = ("SURFACE TO SURFACE", "NODE TO SURFACE");
    let ccx = Dialect::Calculix;
    assert_eq!(read(faces, linear, ccx), (NormalLaw::Linear { stiffness }, false));
    let pulls = NormalLaw::CalculixLinear { stiffness, tension, pulls: false };
    assert_eq!(read(nodes, linear, ccx), (pulls, false));
    assert_eq!(read(nodes, "", ccx), (NormalLaw::Hard, true));
    assert_eq!(read(nodes, "", Dialect::Abaqus), (NormalLaw::Hard, false));
}

/// Requirement: in CalculiX a second card adds faces to a surface (measured with ccx 2.20); in Abaqus
/// it is an error.
#[test]
fn surfaces_are_extended_in_calculix() {
    let deck = format!(
        "{}*SURFACE, NAME=LOWER\n1, S3\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, \
         TYPE=SURFACE TO SURFACE\nUPPER, LOWER\n{STEP}*END STEP\n",
        mesh(true, 0.0)
    );
    let faces = |dialect: Dialect| {
        let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
        let model = Job::read_text("surfaces", &deck, &options).model?;
        match &model.contact_pairs[0].master {
            Master::Faces(faces) => Some(faces.faces.len()),
            _ => None,
        }
    };
    assert_eq!(faces(Dialect::Calculix), Some(2));
    assert_eq!(faces(Dialect::Abaqus), None);
}

/// Requirement: what a pair brings that comes to a step overclosed counts as energy that is converted: a press fit of
/// rings that a step adds, in large motion, is not told to balance badly by 5e-4 of its energy.
#[test]
fn a_fit_that_a_step_adds_balances() {
    let change = |what: &str| {
        let step = STEP.replace("*STEP", "*STEP, NLGEOM");
        format!("{step}*MODEL CHANGE, TYPE=CONTACT PAIR, {what}\nUPPER, LOWER\n*END STEP\n")
    };
    let deck = "*NODE\n1, 1., 0.\n2, 2., 0.\n3, 2., 1.\n4, 1., 1.\n11, 1.99, 0.\n12, 3., 0.\n13, 3., 1.\n\
        14, 1.99, 1.\n*NSET, NSET=ALL\n1, 2, 3, 4, 11, 12, 13, 14\n*ELEMENT, TYPE=CAX4, ELSET=RINGS\n\
        1, 1, 2, 3, 4\n2, 11, 12, 13, 14\n*SOLID SECTION, ELSET=RINGS, MATERIAL=M\n*MATERIAL, NAME=M\n\
        *ELASTIC\n1000.0, 0.3\n*SURFACE, NAME=UPPER\n2, S4\n*SURFACE, NAME=LOWER\n1, S2\n\
        *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nUPPER, LOWER\n\
        *BOUNDARY\nALL, 2\n"
        .to_owned()
        + &change("REMOVE")
        + &change("ADD");
    let read = Job::read_text("fit", &deck, &ReadOptions::default());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("added_fit");
    let options = RunOptions { folder: Some(folder), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed);
    let said = outcome.diagnostics.iter().find(|said| said.code.0 == "SL0604");
    assert!(said.is_none(), "{said:?}");
}

/// Requirement: pairs of general contact leave with the elements of either side, whose force ramps
/// off, and come back with them; a surface that meets itself can be named alone. Blocks pressed by d
/// hold N = E A d/2. Tolerance: rounding.
#[test]
fn general_contact_leaves_with_its_elements() {
    for in_space in [false, true] {
        let up = if in_space { 3 } else { 2 };
        let change = |what: &str| format!("{STEP}*MODEL CHANGE, {what}\n2\n*END STEP\n");
        let deck = format!(
            "{}*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n{STEP}*BOUNDARY\nLOW, 1, {up}\n\
             HIGH, 1, {up}\nHIGH, {up}, {up}, -0.01\n*END STEP\n",
            mesh(in_space, 0.0)
        ) + &change("REMOVE")
            + &change("ADD=WITH STRAIN");
        let read = Job::read_text("general", &deck, &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let absent = |step: usize| model.steps[step].presence.absent_pairs.len();
        let of_lower = usize::from(model.contact_pairs.iter().any(|own| own.name == "LOWER"));
        assert!(
            absent(0) == 0 && absent(1) > of_lower && absent(2) == 0,
            "{:?}",
            [0, 1, 2].map(absent)
        );
        let along: Vec<f64> = solved(&deck).force.iter().map(|force| force[up - 1].abs()).collect();
        for (increment, wanted) in [(1, 5.0), (2, 0.0), (3, 0.0), (5, 5.0)] {
            assert!((along[increment] - wanted).abs() < 1e-9, "{in_space}, {increment}: {along:?}");
        }
    }
}

/// Requirement: in the dialect of CalculiX a linear law with a pull carries nothing where surfaces are open, however far
/// (measured with ccx 2.20: nothing beyond c0), and is below K h by the pull where they are closed.
#[test]
fn open_surfaces_carry_nothing_in_calculix() {
    for (in_space, _) in ALL {
        let up = if in_space { 3 } else { 2 };
        let deck = format!(
            "{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4, 100.0, 0.001\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nUPPER, LOWER\n{STEP}*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\n\
             HIGH, {up}, {up}, 0.1\n*END STEP\n{STEP}*BOUNDARY\nHIGH, {up}, {up}, -0.2\n*END STEP\n",
            mesh(in_space, 0.0)
        );
        let options = ReadOptions { dialect: Some(Dialect::Calculix), ..ReadOptions::default() };
        let read = Job::read_text("open", &deck, &options);
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("open_in_ccx_{up}"));
        let _ = std::fs::remove_dir_all(&folder);
        let run_options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
        let outcome = run(&read, &run_options, &mut Quiet);
        assert_eq!(outcome.status, Status::Completed, "{:?}", outcome.diagnostics);
        let table = std::fs::read_to_string(folder.join("open.pair.csv")).unwrap();
        let heads: Vec<&str> = table.lines().next().unwrap().split(',').collect();
        let name = ["force_x", "force_y", "force_z"][up - 1];
        let column = heads.iter().position(|own| *own == name).unwrap();
        let force: Vec<f64> = table
            .lines()
            .skip(1)
            .map(|line| line.split(',').nth(column).unwrap().parse().unwrap())
            .collect();
        // open by a tenth; then, by halves, pressed by 0.2: blocks of stiffness 1000 in a row with the law
        assert!(force[..2].iter().all(|own| *own == 0.0), "{force:?}");
        let last = force.last().unwrap().abs();
        let over = 0.2 - last / 500.0;
        let eps = std::f64::consts::PI * 100.0 / 1e4;
        let law = 1e4 * over * (0.5 + (over / eps).atan() / std::f64::consts::PI);
        assert!((last / law - 1.0).abs() < 1e-6, "{last} {law}");
    }
}
