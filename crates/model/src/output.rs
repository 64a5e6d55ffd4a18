//! What the deck asks to be written.

use crate::contact::ContactPair;
use crate::node::NodeIndex;
use crate::request::{Request, is_due};
use crate::section_print::SectionPrint;

/// Requests of one step.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct OutputRequests {
    /// `*RESTART, WRITE`: states to go on from.
    pub restart: Option<SavedStates>,
    /// Node tables.
    pub node_prints: Vec<NodePrint>,
    /// Element tables.
    pub element_prints: Vec<ElementPrint>,
    /// Contact tables.
    pub contact_prints: Vec<ContactPrint>,
    /// Tables of what passes through surfaces.
    pub section_prints: Vec<SectionPrint>,
    /// FREQUENCY of each card that asks for states (`*OUTPUT, FIELD`,
    /// `*NODE FILE` and the like); without any there is one in every increment.
    pub states_every: Vec<usize>,
    /// `*PRINT, CONTACT=YES`: contact status changes into the message file.
    pub contact_changes: bool,
}

/// `*RESTART, WRITE, FREQUENCY=N`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SavedStates {
    /// Every how many increments; the end of the step always; 0: never.
    pub every: usize,
    /// `OVERLAY`: only the last state of a step is kept.
    pub overlay: bool,
}

impl OutputRequests {
    /// Whether an increment leaves a state (`JOB_nnnn.vtu`).
    pub fn state_is_due(&self, increment: usize, last_of_step: bool) -> bool {
        self.states_every.is_empty() || self.states_are_asked_for(increment, last_of_step)
    }

    /// Whether a card asks for the state of an increment.
    pub fn states_are_asked_for(&self, increment: usize, last_of_step: bool) -> bool {
        self.states_every.iter().any(|&every| is_due(every, increment, last_of_step))
    }

    /// Whether any increment may leave a state.
    pub fn has_states(&self) -> bool {
        self.state_is_due(1, true)
    }
}

/// A table of nodal values.
#[derive(Clone, Debug, PartialEq)]
pub struct NodePrint {
    /// Set, frequency, file.
    pub request: Request,
    /// The nodes of the set.
    pub nodes: Vec<NodeIndex>,
    /// Columns.
    pub variables: Vec<NodeVariable>,
    /// `GLOBAL=NO`: nodes with axes of their own are printed along these.
    pub own_axes: bool,
}

/// A nodal quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeVariable {
    /// Displacements and rotations.
    U,
    /// Reactions.
    RF,
    /// Applied loads.
    CF,
    /// Current coordinates.
    COORD,
    /// Temperature.
    NT,
}

/// A table of beam results.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementPrint {
    /// Set, frequency, file.
    pub request: Request,
    /// Labels of the beams of the set, ascending.
    pub elements: Vec<u64>,
    /// Columns.
    pub variables: Vec<ElementVariable>,
    /// Section points of the stresses, from 1 to [`SECTION_POINTS`].
    pub section_points: Vec<usize>,
    /// `GLOBAL=NO`: along the axes of the material.
    pub own_axes: bool,
}

/// Section points over the height of a beam: 1 on the side against the normal
/// that stands 90 degrees counter-clockwise of the beam's direction, 5 on the
/// side of it, evenly spaced.
pub const SECTION_POINTS: usize = 5;

/// A quantity of a beam, at its middle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementVariable {
    /// Axial force SF1, shear force SF2.
    SF,
    /// Bending moment SM1.
    SM,
    /// Axial strain SE1, shear strain SE2.
    SE,
    /// Curvature SK1.
    SK,
    /// Axial stress S11 at section points; of solids all components.
    S,
    /// Strain of solids.
    E,
    /// Logarithmic strain of solids.
    LE,
    /// Plastic strain of solids.
    PE,
    /// Equivalent plastic strain of solids.
    PEEQ,
    /// Creep strain of solids.
    CE,
    /// Equivalent creep strain of solids.
    CEEQ,
    /// Mises stress; of beams at section points 1 and 5, where there is no shear stress.
    MISES,
    /// Principal stresses of solids.
    SP,
    /// Stored energy of a unit of undeformed volume of solids.
    ENER,
    /// Energy that plastic strain took of it.
    PENER,
    /// Current place of an integration point of a solid.
    COORD,
    /// Stored energy of a solid.
    ELSE,
    /// Energy that plastic strain took of it.
    ELPD,
    /// Volume of a solid.
    EVOL,
}

impl ElementVariable {
    /// Whether an element has one value, not one at every point.
    pub fn is_of_the_whole(self) -> bool {
        matches!(self, Self::ELSE | Self::ELPD | Self::EVOL)
    }
}

/// A table of contact results.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPrint {
    /// Set, frequency, file.
    pub request: Request,
    /// The nodes of the set.
    pub nodes: Vec<NodeIndex>,
    /// `SLAVE` and `MASTER`: the pairs of these surfaces; empty: all.
    pub surfaces: [String; 2],
    /// Columns.
    pub variables: Vec<ContactVariable>,
}

impl ContactPrint {
    /// Whether it is of that pair.
    pub fn wants(&self, pair: &ContactPair) -> bool {
        let name = pair.title();
        let (slave, master) = name.split_once('/').unwrap_or((name, name));
        let is = |wanted: &String, own: &str| wanted.is_empty() || wanted == own;
        is(&self.surfaces[0], slave) && is(&self.surfaces[1], master)
    }
}

/// A quantity of a contact point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactVariable {
    /// Pressure CPRESS and shear traction CSHEAR1.
    CSTRESS,
    /// Gap COPEN and slip CSLIP1.
    CDISP,
    /// Normal force CNORMF and shear force CSHEARF.
    CFORCE,
    /// Sum of the forces of pressure on the slaves of a pair.
    CFN,
    /// Sum of the forces of friction on them.
    CFS,
    /// Sum of both.
    CFT,
    /// Moment of the forces of pressure about the origin.
    CMN,
    /// Moment of the forces of friction.
    CMS,
    /// Moment of both.
    CMT,
    /// Area of the closed points of a pair.
    CAREA,
    /// Energy of the contact laws of a pair.
    CELS,
    /// Number of closed points.
    CNUM,
}

impl ContactVariable {
    /// Whether it is one of a point, not a sum over many.
    pub fn is_of_points(self) -> bool {
        matches!(self, Self::CSTRESS | Self::CDISP | Self::CFORCE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: FREQUENCY=N is every N-th increment and the last of each
    /// step, 0 is never, several requests give what any of them asks for, and
    /// without a request there is a state in every increment. Source: Abaqus
    /// manual, `*OUTPUT` and `*NODE FILE`.
    #[test]
    fn frequency_rules_the_increments() {
        let shown = |states_every: &[usize]| -> Vec<usize> {
            let states_every = states_every.to_vec();
            let requests = OutputRequests { states_every, ..OutputRequests::default() };
            (1..=10)
                .filter(|&increment| requests.state_is_due(increment, increment == 10))
                .collect()
        };
        assert_eq!(shown(&[]), (1..=10).collect::<Vec<_>>());
        assert_eq!(shown(&[4]), [4, 8, 10]);
        assert_eq!(shown(&[4, 3]), [3, 4, 6, 8, 9, 10]);
        assert_eq!(shown(&[0]), [0; 0]);
        assert_eq!(shown(&[0, 100]), [10]);
    }
}
