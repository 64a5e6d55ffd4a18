//! Motions that a deck prescribes.

use slideline_deck::NoFiles;
use slideline_diag::Sources;
use slideline_keywords::read;
use slideline_model::Dialect;

/// Requirement: a motion on a dof that a plane model has not is refused, as a load there is; what is merely held there
/// is passed over.
#[test]
fn motions_out_of_the_plane_are_refused() {
    for (line, is_refused) in [
        ("3, 3, 3, 0.1", true),
        ("3, 2, 3, -0.1", true),
        ("3, 5, 5, 0.1", true),
        ("3, 3, 5", false),
        ("3, 3, 3, 0.0", false),
        ("3, ENCASTRE", false),
        ("3, 2, 2, 0.1", false),
    ] {
        let deck = format!(
            "*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n3, 1.0, 1.0\n4, 0.0, 1.0\n*ELEMENT, TYPE=CPE4, ELSET=ALL\n1, 1, 2, 3, 4\n\
             *SOLID SECTION, ELSET=ALL, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1.0, 0.3\n*BOUNDARY\n1, 1, 2\n2, 2\n\
             *STEP, NLGEOM\n*STATIC\n*BOUNDARY\n{line}\n*END STEP\n"
        );
        let sources = &mut Sources::default();
        let said = read(sources, "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus).diagnostics;
        let refused = said.iter().any(|own| own.code.0 == "SL0251");
        assert_eq!(refused, is_refused, "{line} {said:?}");
    }
}
