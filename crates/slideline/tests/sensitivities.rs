//! Derivatives by direct differentiation against differences of whole runs.

#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout)] // a test may fail where it stands

mod sensitivity_decks;

use sensitivity_decks::{Response, Varied, motion, reaction};
use slideline::model::Dof;

/// A beam under a rigid circle that presses and is dragged.
fn leaf(law: &str, pair: &str) -> String {
    format!(
        "*PARAMETER\nthickness = 1.0\nmodulus = 210000.0\nmu = 0.2\nx = 30.0\npush = 1.0\n\
         middle = x - 0.0\nleft = x + 8.0\nright = x - 8.0\ndown = -push\n\
         *NODE, NSET=BEAM\n1, 0.0, 0.0\n31, 60.0, 0.0\n*NGEN, NSET=BEAM\n1, 31, 1\n\
         *ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 30, 1, 1\n\
         *BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n10.0, <thickness>\n\
         *MATERIAL, NAME=M\n*ELASTIC\n<modulus>, 0.3\n*NODE\n900, <x>, 8.05\n\
         *SURFACE, NAME=ROLLER, TYPE=SEGMENTS\nSTART, <left>, 8.05\n\
         CIRCL, <middle>, 0.05, <middle>, 8.05\nCIRCL, <right>, 8.05, <middle>, 8.05\n\
         *RIGID BODY, REF NODE=900, ANALYTICAL SURFACE=ROLLER\n\
         {pair}*SURFACE INTERACTION, NAME=TOUCH\n10.0\n*FRICTION\n<mu>\n{law}\
         *STEP, NLGEOM, INC=400\n*STATIC, DIRECT\n0.1, 1.0\n*BOUNDARY\n1, 1, 6\n900, 1\n900, 6\n\
         900, 2, 2, <down>\n*END STEP\n\
         *STEP, NLGEOM, INC=400\n*STATIC, DIRECT\n0.1, 1.0\n*BOUNDARY\n900, 1, 1, 1.0\n*END STEP\n"
    )
}

const PARAMETERS: [(&str, f64); 5] =
    [("thickness", 1.0), ("modulus", 210000.0), ("mu", 0.2), ("x", 30.0), ("push", 1.0)];

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
    deck.check(1e-4, 1e-6);
}

/// Requirement: the same with hard contact at nodes.
#[test]
fn nodes_on_a_hard_circle_with_friction() {
    let deck = Varied::new(&leaf("", AT_NODES), &PARAMETERS, &OF_ROLLER);
    deck.check(1e-5, 1e-6);
}
