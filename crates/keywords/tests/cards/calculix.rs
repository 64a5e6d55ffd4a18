//! What the dialect of CalculiX means where it differs, and where it does not.

use crate::two_squares::{A, C, deck, interpret, model, step};
use slideline_mech::element::solid::Formulation;
use slideline_model::Kinematics;

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

/// Requirement: in the dialect of CalculiX rubber, foam and deformation plasticity have nonlinear kinematics unless a step says
/// NO, with a note. Source: ccx 2.20, "nonlinear geometric effects are turned on"; a cube of rubber pulled to 1.5 carries 156.2, linear
/// 227.9.
#[test]
fn rubber_turns_nonlinear_kinematics_on_in_calculix() {
    let elastic = "*ELASTIC\n200.0, 0.3";
    let laws = [
        "*HYPERELASTIC, NEO HOOKE\n40.0, 0.01",
        "*HYPERFOAM, N=1\n10.0, 2.0, 0.0",
        "*DEFORMATION PLASTICITY\n200.0, 0.3, 2.0, 5.0, 0.4",
        elastic,
    ];
    let cards = ["", "", ", NLGEOM=NO", ""].map(|own| format!("*STEP{own}\n*STATIC\n*END STEP\n"));
    for (law, dialect) in laws.into_iter().flat_map(|law| [(law, A), (law, C)]) {
        let read = interpret(&deck(&cards.concat(), &[(elastic, law)]), dialect);
        let found: Vec<bool> = read.model.steps.iter().map(|step| step.nlgeom).collect();
        let on = law != elastic && dialect == C;
        assert_eq!(found, [on, on, false, false], "{law}");
        let says = |found: &&slideline_diag::Diagnostic| found.message.contains("turns NLGEOM on");
        let notes: Vec<_> = read.diagnostics.iter().filter(says).collect();
        assert_eq!(notes.len(), usize::from(on), "{law}");
        assert!(notes.iter().all(|note| note.severity.word() == "note"));
    }
}

/// Requirement: a first step with PERTURBATION is linear for rubber too; those behind it are not.
#[test]
fn a_perturbation_of_rubber_is_linear() {
    let cards = ["*STEP, PERTURBATION", "*STEP"].map(|own| format!("{own}\n*STATIC\n*END STEP\n"));
    let law = [("*ELASTIC\n200.0, 0.3", "*HYPERELASTIC, NEO HOOKE\n40.0, 0.01")];
    let found = model(&deck(&cards.concat(), &law), C);
    assert_eq!(found.steps.iter().map(|step| step.nlgeom).collect::<Vec<_>>(), [false, true]);
}

/// Requirement: in the dialect of CalculiX `*OUTPUT, FREQUENCY` counts for the cards of files and tables behind it. Source:
/// ccx 2.20: four increments, FREQUENCY=2: two states and two tables.
#[test]
fn a_frequency_of_all_output_counts_in_calculix() {
    let cards = "*OUTPUT, FREQUENCY=2\n*NODE FILE\nU\n*EL PRINT, ELSET=A\nS\n*EL PRINT, ELSET=B, FREQUENCY=3\nS";
    for (dialect, expected) in [(A, [1, 3]), (C, [2, 3])] {
        let model = model(&deck(&step(cards), &[]), dialect);
        let prints = &model.steps[0].output.element_prints;
        let found: Vec<usize> = prints.iter().map(|own| own.request.frequency).collect();
        assert_eq!(found, expected);
        assert_eq!(model.steps[0].output.states_every.contains(&1), dialect == A);
    }
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
