//! Keywords of other programs that are not read here. Named, so that none of
//! them is taken for a misspelt keyword of ours: `*PLASTIC` is not `*ELASTIC`,
//! and `*DLOAD` not `*CLOAD`.

use slideline_deck::normalise;

const SOLID: &str = "the structure is made of plane beams (B21, B22, B23) and springs";
const STATIC: &str = "steps are *STATIC";

/// A keyword and what does its work here, where something does.
const FOREIGN: &[(&str, &str)] = &[
    ("BASE MOTION", STATIC),
    ("BUCKLE", STATIC),
    ("CHANGE FRICTION", "friction is a property of the model: *FRICTION before the first step"),
    ("CONTACT", "name the surfaces in contact: *SURFACE and *CONTACT PAIR"),
    ("COUPLING", "use *RIGID BODY, TIE NSET=, or *MPC of type BEAM"),
    ("CREEP", "materials are *ELASTIC"),
    ("CYCLIC SYMMETRY MODEL", ""),
    ("DAMPING", STATIC),
    ("DENSITY", STATIC),
    ("DISTRIBUTING COUPLING", ""),
    ("DLOAD", "use *CLOAD on the nodes"),
    ("DSLOAD", "use *CLOAD on the nodes"),
    ("DYNAMIC", STATIC),
    ("ENERGY FILE", "JOB.energy.csv is always written"),
    ("ENERGY OUTPUT", "JOB.energy.csv is always written"),
    ("ENERGY PRINT", "JOB.energy.csv is always written"),
    ("EQUATION", "use *MPC of type BEAM for rigid links"),
    ("EXPANSION", ""),
    ("FREQUENCY", STATIC),
    ("GAP", ""),
    ("HEAT TRANSFER", STATIC),
    ("HYPERELASTIC", "materials are *ELASTIC"),
    ("IMPERFECTION", "give the imperfect shape with *NODE"),
    ("INITIAL CONDITIONS", ""),
    ("KINEMATIC", "use *MPC of type BEAM"),
    ("MASS", STATIC),
    ("MODEL CHANGE", ""),
    ("MONITOR", "JOB.sta and JOB.history.csv grow line by line"),
    ("NCOPY", "generate nodes with *NGEN"),
    ("NFILL", "generate nodes with *NGEN"),
    ("ORIENTATION", ""),
    ("PLASTIC", "materials are *ELASTIC"),
    ("PREPRINT", ""),
    ("SHELL SECTION", SOLID),
    ("SOLID SECTION", SOLID),
    ("SYSTEM", "give global coordinates, or use *NMAP"),
    ("TEMPERATURE", ""),
    ("TIE", "use one node on both sides, or *MPC of type BEAM"),
    ("TRANSFORM", ""),
    ("USER MATERIAL", "materials are *ELASTIC"),
    ("VISCO", STATIC),
];

/// The entry of a normalised keyword.
pub(crate) fn find(word: &str) -> Option<&'static (&'static str, &'static str)> {
    FOREIGN.iter().find(|(name, _)| normalise(name) == word)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::REGISTRY;

    #[test]
    fn no_keyword_of_ours_is_foreign() {
        assert!(REGISTRY.iter().all(|keyword| find(&normalise(keyword.name())).is_none()));
    }
}
