//! What is common to all contact points of an increment.

use slideline_mech::contact::pair::Laws;

/// What is common to all points of an increment.
#[derive(Debug)]
pub struct LawContext<'a> {
    /// Laws, a pair each.
    pub laws: &'a [Laws],
    /// Total time at the end of the increment [T].
    pub time: f64,
    /// The increment [T].
    pub dt: f64,
    /// Committed state values of user friction laws.
    pub committed: &'a [f64],
    /// `UNSYMM=NO`: tractions take their limit from the pressure of the last
    /// iteration, which is what a symmetrised tangent amounts to.
    pub symmetrised: bool,
    /// What rounding leaves of a slip [L].
    pub rounding: f64,
    /// Natural unit of each equation's displacement, as in the plan.
    pub units: &'a [f64],
}
