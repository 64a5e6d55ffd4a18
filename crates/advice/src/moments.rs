//! What a rehearsal has seen, increment by increment.

use slideline_model::NodeIndex;

/// A pair over all increments.
#[derive(Clone, Debug, Default)]
pub struct Rehearsal {
    /// Increment by increment.
    pub moments: Vec<Moment>,
}

/// One increment.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Place of the step.
    pub step: usize,
    /// The slave that carries contact, if any is in reach of the law.
    pub carrier: Option<Carrier>,
    /// How far all that was in contact has gone beyond an end of the master
    /// [L], if that is why nothing is in contact now; and whether that is
    /// where the master starts.
    pub off: Option<(f64, bool)>,
    /// Smallest and largest overclosure of slaves that face the master [L].
    pub range: Option<(f64, f64)>,
}

/// The slave that lies deepest in its master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carrier {
    /// Its node.
    pub node: NodeIndex,
    /// Its place along the slaves, from the first of them [L].
    pub slave: f64,
    /// Where it is on the master [L].
    pub along: f64,
}

impl Rehearsal {
    /// Neighbouring increments of one step that are both in contact.
    pub fn slides(&self) -> impl Iterator<Item = (usize, Carrier, Carrier)> + '_ {
        self.moments
            .windows(2)
            .filter(|w| w[0].step == w[1].step)
            .filter_map(|w| Some((w[1].step, w[0].carrier?, w[1].carrier?)))
    }
}
