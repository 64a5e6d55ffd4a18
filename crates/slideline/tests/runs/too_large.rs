//! A large master that many points may meet.
//!
//! Requirement: memory is asked for what is near, not for every coupling there may be: such a deck
//! is read. Source: contact at scale.

use slideline::{Job, ReadOptions};

/// 2000 slaves, any of which may meet any of 200 000 segments: all couplings would
/// take 410 GiB.
#[test]
fn couplings_that_are_far_ask_for_no_memory() {
    let deck = "*HEADING\nlarge\n*NODE, NSET=LINE\n1, 0.0, 0.0\n200001, 1.0, 0.0\n\
        *NGEN, NSET=LINE\n1, 200001\n*NODE\n600000, 0.5, 0.1\n*NODE, NSET=RIM\n\
        700000, 0.4, 0.0\n702000, 0.6, 0.0\n*NGEN, NSET=RIM\n700000, 702000\n\
        *MPC\nBEAM, RIM, 600000\n*ELEMENT, TYPE=ISL21, ELSET=C\n1, 700000, 700001\n\
        *ELGEN, ELSET=C\n1, 2000\n*SLIDE LINE, TYPE=LINEAR, ELSET=C, SMOOTH=0.2, GENERATE\n\
        1, 200001, 1\n*INTERFACE, ELSET=C\n0.01\n*SURFACE CONTACT, SOFTENED\n1.0E-5, 1.0E6\n\
        *STEP, NLGEOM\n*STATIC\n0.1, 1.0\n*BOUNDARY\nLINE, 1, 6\n600000, 1, 6\n*END STEP\n";
    let read = Job::read_text("large", deck, &ReadOptions::default());
    assert!(read.model.is_some(), "{:?}", read.diagnostics);
    assert!(read.diagnostics.iter().all(|said| said.code.0 != "SL0415"));
}
