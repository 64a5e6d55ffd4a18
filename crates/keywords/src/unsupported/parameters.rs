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
        &["SUBMODEL", "STEP", "DATA SET", "USER", "SECTOR", "PHANTOM", "BLADE"],
    ),
    (
        "CHANGE FRICTION",
        "the coefficient runs straight over the step, or is there at once with *STEP, AMPLITUDE=STEP",
        &["AMPLITUDE"],
    ),
    (
        "CLOAD",
        "write the values on data lines and their time as *AMPLITUDE",
        &["USER", "SUBMODEL", "STEP", "DATA SET", "SECTOR"],
    ),
    (
        "CLEARANCE",
        "give MASTER, SLAVE and VALUE: one gap for the slaves of a pair",
        &["CPSET", "TABULAR", "BOLT", "INPUT"],
    ),
    (
        "CONTACT PAIR",
        "leave it out: every pair is told apart by its two surfaces",
        &["GEOMETRIC CORRECTION", "WEIGHT", "OP"],
    ),
    (
        "DLOAD",
        "write the values on data lines and their time as *AMPLITUDE",
        &["USER", "SUBMODEL", "STEP", "DATA SET", "SECTOR", "CYCLIC MODE"],
    ),
    ("DSLOAD", "give traction by three components (TRVEC)", &["SUBMODEL", "STEP", "DATA SET"]),
    (
        "ELEMENT",
        "write the elements on data lines, or draw them in with *INCLUDE, INPUT=",
        &["FILE", "OFFSET", "SOLID ELEMENT NUMBERING"],
    ),
    (
        "HYPERELASTIC",
        "give the coefficients of one of its forms, or TEST DATA INPUT and test data",
        &["MARLOW", "VAN DER WAALS", "USER", "PROPERTIES", "BETA", "ALL"],
    ),
    (
        "INITIAL CONDITIONS",
        "write the values on data lines",
        &["USER", "FILE", "STEP", "INC", "GEOSTATIC", "SECTION POINTS", "REBAR"],
    ),
    ("ELASTIC", "give the constants over temperature alone", &["DEPENDENCIES", "USER"]),
    ("EXPANSION", "give the coefficients over temperature alone", &["DEPENDENCIES", "USER"]),
    ("ELCOPY", "copy by numbers, and give *NCOPY the place", &["REFLECT", "SHIFT ELEMENT"]),
    ("NCOPY", "copy with SHIFT: a translation and a rotation", &["REFLECT", "POLE", "ORIENTATION"]),
    ("NFILL", "the nodes stand at equal distances", &["BIAS", "SINGULAR", "TWO STEP"]),
    (
        "PLASTIC",
        "give one table of yield stress over plastic strain",
        &["RATE", "DEPENDENCIES", "PROPERTIES"],
    ),
    ("SOLID SECTION", "make one element layer for each material", &["COMPOSITE", "REF NODE"]),
    (
        "SPRING",
        "give the spring along dofs of its nodes, or turn these by *TRANSFORM",
        &["ORIENTATION", "COMPLEX STIFFNESS", "RTOL"],
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
