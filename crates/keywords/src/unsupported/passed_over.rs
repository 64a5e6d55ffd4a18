//! The keywords that have no effect in a static step.

use super::names::Group;
use super::names::Treatment::Ignored;

pub(super) const GROUPS: &[Group] = &[
    (
        Ignored,
        "a static step has no inertia and no damping",
        &[
            "DAMPING",
            "GLOBAL DAMPING",
            "CONTACT DAMPING",
            "DASHPOT",
            "ROTARY INERTIA",
            "NONSTRUCTURAL MASS",
            "MASS ADJUST",
            "FIXED MASS SCALING",
            "VARIABLE MASS SCALING",
            "BULK VISCOSITY",
        ],
    ),
    (
        Ignored,
        "roles, edges and the way contact is imposed are those of docs/keywords/CONTACT.md, solids \
         have no thickness to set",
        &["CONTACT FORMULATION", "CONTACT CONTROLS ASSIGNMENT"],
    ),
    (
        Ignored,
        "the program chooses how the equations are solved",
        &["SOLVER CONTROLS", "SOLUTION TECHNIQUE", "WAVEFRONT MINIMIZATION"],
    ),
    (
        Ignored,
        "elements of one integration point keep their own hourglass control",
        &["SECTION CONTROLS", "HOURGLASS STIFFNESS"],
    ),
    (Ignored, "no constant here depends on a field variable", &["FIELD"]),
    (
        Ignored,
        "temperatures are given here, not computed",
        &[
            "CONDUCTIVITY",
            "SPECIFIC HEAT",
            "LATENT HEAT",
            "INELASTIC HEAT FRACTION",
            "GAP CONDUCTANCE",
            "GAP HEAT GENERATION",
        ],
    ),
    (
        Ignored,
        "it changes printed or progress output only; JOB.sta and JOB.history.csv grow line by line",
        &["PREPRINT", "MONITOR", "DIAGNOSTICS", "USER OUTPUT VARIABLES"],
    ),
    (
        Ignored,
        "results stand at the ends of increments; for some at these times let *STATIC, DIRECT have increments that end there",
        &["TIME POINTS"],
    ),
    (Ignored, "histories are written as they are computed, unfiltered", &["FILTER"]),
    (
        Ignored,
        "no such table is written; JOB.history.csv has the forces of the supports and \
         JOB.pair.csv those of every contact",
        &[
            "SECTION FILE",
            "INTEGRATED OUTPUT",
            "INTEGRATED OUTPUT SECTION",
            "FACE PRINT",
            "FACE FILE",
            "INCREMENTATION OUTPUT",
            "MODAL OUTPUT",
            "MODAL PRINT",
            "MODAL FILE",
            "RADIATION OUTPUT",
            "RADIATION PRINT",
            "RADIATION FILE",
            "SURFACE OUTPUT",
            "ELEMENT MATRIX OUTPUT",
            "ELEMENT OPERATOR OUTPUT",
        ],
    ),
    (
        Ignored,
        "it says how constraints are checked and printed, and all are checked here anyway",
        &["CONSTRAINT CONTROLS"],
    ),
    (
        Ignored,
        "JOB.energy.csv is always written",
        &["ENERGY FILE", "ENERGY OUTPUT", "ENERGY PRINT"],
    ),
    (
        Ignored,
        "result files have fixed formats (docs/files.md)",
        &["FILE FORMAT", "FILE OUTPUT", "POST OUTPUT"],
    ),
];
