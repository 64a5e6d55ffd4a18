//! Parameters of our keywords that other programs know and that are not read here: named, so that
//! none of them is taken for a slip of the pen.

/// Parameters that are treated alike: of which keyword, what to do instead, names.
type Group = (&'static str, &'static str, &'static [&'static str]);

const GROUPS: &[Group] = &[
    ("AMPLITUDE", "write the points of the curve on data lines", &["USER", "VARIABLES"]),
    (
        "BEAM SECTION",
        "give the nodes of the axis where the centre line of the beam runs",
        &["OFFSET1", "OFFSET2"],
    ),
    (
        "BOUNDARY",
        "give the values of this deck on data lines",
        &[
            "SUBMODEL",
            "STEP",
            "INC",
            "DATA SET",
            "USER",
            "SECTOR",
            "PHANTOM",
            "BLADE",
            "FILE",
            "BSTEP",
            "MODE",
            "TIMESCALE",
            "SCALE",
            "GLOBAL ELSET",
            "IMAGINARY",
        ],
    ),
    (
        "CHANGE FRICTION",
        "the coefficient runs straight over the step, or is there at once with *STEP, AMPLITUDE=STEP",
        &["AMPLITUDE"],
    ),
    (
        "CLOAD",
        "write the values on data lines and their time as *AMPLITUDE",
        &["USER", "SUBMODEL", "STEP", "DATA SET", "SECTOR", "IMAGINARY"],
    ),
    (
        "CLEARANCE",
        "give MASTER, SLAVE and VALUE: one gap for the slaves of a pair",
        &["CPSET", "TABULAR", "BOLT", "INPUT"],
    ),
    ("CONTACT PAIR", "leave it out: every pair is told apart by its two surfaces", &["OP"]),
    (
        "CONTACT PAIR",
        "name the slave first and the master second: either surface is one or the other, whatever the weight",
        &["WEIGHT"],
    ),
    (
        "CONTACT PAIR",
        "facets of a round master are smoothed by SMOOTH= with TYPE=NODE TO SURFACE; or mesh the round more finely, \
         or describe it with *RIGID SURFACE",
        &["GEOMETRIC CORRECTION"],
    ),
    (
        "CONTACT INCLUSIONS",
        "write ALL EXTERIOR, or name two *SURFACEs a line",
        &["ALL ELEMENT BASED", "SURFACE PAIRS"],
    ),
    (
        "DLOAD",
        "write the values on data lines and their time as *AMPLITUDE",
        &["USER", "SUBMODEL", "STEP", "DATA SET", "SECTOR", "CYCLIC MODE", "IMAGINARY", "REF NODE"],
    ),
    (
        "DSLOAD",
        "write the values on data lines and their time as *AMPLITUDE; give traction by three components (TRVEC)",
        &["SUBMODEL", "STEP", "DATA SET", "USER", "FIELD", "REF NODE", "CYCLIC MODE", "IMAGINARY"],
    ),
    (
        "ELEMENT",
        "write the elements on data lines, or draw them in with *INCLUDE, INPUT=",
        &["FILE", "OFFSET", "SOLID ELEMENT NUMBERING"],
    ),
    (
        "HYPERELASTIC",
        "give the coefficients of one of its forms, or TEST DATA INPUT and test data",
        &[
            "MARLOW",
            "VAN DER WAALS",
            "VALANIS-LANDEL",
            "USER",
            "PROPERTIES",
            "BETA",
            "ALL",
            "DEPENDENCIES",
        ],
    ),
    (
        "INITIAL CONDITIONS",
        "write the values on data lines",
        &[
            "USER",
            "FILE",
            "STEP",
            "INC",
            "SECTION POINTS",
            "REBAR",
            "DRIVING ELSETS",
            "INTERPOLATE",
            "MIDSIDE",
            "OUTPUT VARIABLE",
            "EXTERIOR TOLERANCE",
            "ABSOLUTE EXTERIOR TOLERANCE",
            "ELEMENT AVERAGE",
        ],
    ),
    (
        "INITIAL CONDITIONS",
        "it gives stresses that grow with depth: write them element by element as TYPE=STRESS on data \
         lines, and the weight as *DLOAD of type GRAV in the first step",
        &["GEOSTATIC"],
    ),
    (
        "INITIAL CONDITIONS",
        "leave it out: what the stresses leave unbalanced ramps off over the first step",
        &["UNBALANCED STRESS"],
    ),
    (
        "ELASTIC",
        "give the constants over temperature alone",
        &["DEPENDENCIES", "USER", "COMPRESSION FACTOR"],
    ),
    (
        "EXPANSION",
        "give the coefficients over temperature alone",
        &["DEPENDENCIES", "USER", "PORE FLUID"],
    ),
    ("ELCOPY", "copy by numbers, and give *NCOPY the place", &["REFLECT", "SHIFT ELEMENT"]),
    ("NCOPY", "copy with SHIFT: a translation and a rotation", &["REFLECT", "POLE", "ORIENTATION"]),
    ("NFILL", "the nodes stand at equal distances", &["BIAS", "SINGULAR", "TWO STEP"]),
    (
        "PLASTIC",
        "give one table of yield stress over plastic strain",
        &["RATE", "DEPENDENCIES", "PROPERTIES", "SCALESTRESS"],
    ),
    (
        "PLASTIC",
        "leave it out: beyond the table its last yield stress holds; give a further line for another one",
        &["EXTRAPOLATION"],
    ),
    (
        "ANISOTROPIC HYPERELASTIC",
        "give the coefficients of HOLZAPFEL",
        &[
            "FUNG-ANISOTROPIC",
            "FUNG-ORTHOTROPIC",
            "USER",
            "PROPERTIES",
            "FORMULATION",
            "TYPE",
            "BETA",
            "MODULI",
        ],
    ),
    ("ANISOTROPIC HYPERELASTIC", "give the coefficients over temperature alone", &["DEPENDENCIES"]),
    (
        "BEAM GENERAL SECTION",
        "give one section along an element, with its constants over temperature alone",
        &["DEPENDENCIES", "COMPOSITE", "OFFSET1", "OFFSET2"],
    ),
    (
        "CONTACT CONTROLS",
        "write STABILIZE, which holds parts until they touch",
        &["APPROACH", "SLIDE DISTANCE"],
    ),
    (
        "CONTACT INITIALIZATION DATA",
        "give SEARCH ABOVE and SEARCH BELOW in place of a set of nodes",
        &["SEARCH NSET"],
    ),
    (
        "COUPLING",
        "give the reference node the place of the middle of the surface with *NODE",
        &["ADJUST"],
    ),
    ("CREEP", "give the constants over temperature alone", &["DEPENDENCIES", "SCALING"]),
    (
        "CYCLIC HARDENING",
        "give the constants over temperature alone",
        &["DEPENDENCIES", "USER", "PROPERTIES"],
    ),
    ("DENSITY", "give the density of the solid over temperature", &["PORE FLUID", "USER"]),
    (
        "FRICTION",
        "give one coefficient, or the lines that its parameters ask for",
        &["DEPENDENCIES"],
    ),
    ("FRICTION", "give mu_s, mu_k and the decay themselves on the data line", &["TEST DATA"]),
    (
        "FRICTION",
        "give ELASTIC SLIP: the slope is the friction limit over it",
        &["SHEAR TRACTION SLOPE"],
    ),
    (
        "HYPERFOAM",
        "give the coefficients: N, and `mu1, alpha1, ..., nu1, ...`",
        &["TEST DATA INPUT", "POISSON", "MODULI", "DEPENDENCIES"],
    ),
    ("KINEMATIC COUPLING", "write *COUPLING, ORIENTATION= with *KINEMATIC", &["ORIENTATION"]),
    ("MASS", "give one mass: in a static step only its weight counts", &["ORIENTATION"]),
    ("MPC", "write the constraint as *EQUATION", &["USER", "MODE"]),
    ("NGEN", "give the nodes in the system of *SYSTEM", &["SYSTEM"]),
    ("NMAP", "give the points of the old and of the new place", &["DEFINITION"]),
    ("NODAL THICKNESS", "write a line for each node or set of nodes", &["GENERATE"]),
    (
        "RIGID BODY",
        "give a weight by *MASS at the reference node, and mesh the surfaces where they touch",
        &["DENSITY", "OFFSET", "NODAL THICKNESS"],
    ),
    ("SOLID SECTION", "make one element layer for each material", &["COMPOSITE", "REF NODE"]),
    (
        "SPRING",
        "give the spring along dofs of its nodes, or turn these by *TRANSFORM",
        &["ORIENTATION", "COMPLEX STIFFNESS", "RTOL", "DEPENDENCIES"],
    ),
    (
        "STATIC",
        "drive the part by a displacement (*BOUNDARY) where the load has a peak",
        &["RIKS", "ADIABATIC"],
    ),
    (
        "STEP",
        "steps are *STATIC and *VISCO; submodels and changes of the design are not read",
        &["SENSITIVITY", "SHOCK"],
    ),
    (
        "SURFACE",
        "name the faces themselves, with S1 to S6 or a set of elements",
        &["CROP", "MAX RATIO", "REGION TYPE", "PROPERTY", "TRIM"],
    ),
    (
        "SURFACE",
        "write NO THICKNESS on *CONTACT PAIR where beams shall touch at their axes",
        &["NO THICK", "NO OFFSET", "SCALE THICK"],
    ),
    (
        "SURFACE INTERACTION",
        "a layer between the surfaces is a clearance that closes before they touch: mesh the surfaces where they \
         touch, or give *CLEARANCE, VALUE= with their distance less the thickness",
        &["PAD THICKNESS"],
    ),
    (
        "SURFACE INTERACTION",
        "give the law by *SURFACE BEHAVIOR and *FRICTION",
        &["USER", "PROPERTIES", "DEPVAR"],
    ),
    (
        "TEMPERATURE",
        "results of other jobs cannot be read: write the temperatures on data lines, `node or set, value`, in a \
         file of their own if need be (INPUT=), and their time as *AMPLITUDE",
        &[
            "FILE",
            "BSTEP",
            "BINC",
            "ESTEP",
            "EINC",
            "STEP",
            "INC",
            "INTERPOLATE",
            "MIDSIDE",
            "DRIVING ELSETS",
            "GLOBAL ELSET",
            "OUTPUT VARIABLE",
            "EXTERIOR TOLERANCE",
            "ABSOLUTE EXTERIOR TOLERANCE",
        ],
    ),
    ("TEMPERATURE", "write the values on data lines and their time as *AMPLITUDE", &["USER"]),
    ("TIE", "model the whole, not a sector of it", &["CYCLIC SYMMETRY", "MULTISTAGE"]),
    (
        "VISCOELASTIC",
        "give a Prony series: TIME=PRONY and lines `g, k, tau`",
        &["FREQUENCY", "PROPERTIES"],
    ),
    (
        "BIAXIAL TEST DATA",
        "give data that are smooth, at one temperature: one card a test",
        &["SMOOTH", "DEPENDENCIES", "RTOL"],
    ),
    (
        "PLANAR TEST DATA",
        "give data that are smooth, at one temperature: one card a test",
        &["SMOOTH", "DEPENDENCIES", "RTOL"],
    ),
    (
        "UNIAXIAL TEST DATA",
        "give data that are smooth, at one temperature: one card a test",
        &["SMOOTH", "DEPENDENCIES", "RTOL"],
    ),
    (
        "VOLUMETRIC TEST DATA",
        "give data that are smooth, at one temperature: one card a test",
        &["SMOOTH", "DEPENDENCIES", "RTOL"],
    ),
];

/// What to do instead of a parameter of a keyword; `None` where no program knows it.
pub(crate) fn parameter(keyword: &str, normalised: &str) -> Option<&'static str> {
    let own = GROUPS.iter().filter(|group| group.0 == keyword);
    let is_it = |name: &&'static str| slideline_deck::normalise(name) == normalised;
    own.into_iter().find(|group| group.2.iter().any(is_it)).map(|group| group.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::REGISTRY;

    /// Requirement: the table speaks of keywords that are read, of parameters that are not, and of
    /// each once.
    #[test]
    fn the_table_holds_what_is_not_read() {
        for (keyword, _, names) in GROUPS {
            let own = REGISTRY.iter().find(|own| own.name() == *keyword);
            assert!(own.is_some(), "{keyword}");
            for name in *names {
                let known = own.is_some_and(|own| {
                    own.parameters().iter().any(|rule| rule.name == *name)
                        || own.without_effect().contains(name)
                });
                assert!(!known, "{keyword} {name}");
                let of_keyword = GROUPS.iter().filter(|group| group.0 == *keyword);
                let times = of_keyword.filter(|group| group.2.contains(name)).count();
                assert_eq!(times, 1, "{keyword} {name}");
            }
        }
    }
}
