//! Which card the next suboption belongs to.

/// The card that a suboption belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) enum Owner {
    #[default]
    Nobody,
    Interface(usize),
    Interaction(usize),
    /// `*CHANGE FRICTION` of the step that is open.
    FrictionChange,
    /// `*CHANGE SURFACE BEHAVIOR` of the step that is open.
    PressureChange,
    /// `*CHANGE MATERIAL` of the step that is open.
    MaterialChange,
    Material(usize),
    Section(usize),
    Coupling(usize),
    /// The owner is broken or missing, and that has been said.
    Broken,
}

impl Owner {
    /// The section, if it is one.
    pub fn section(self) -> Option<usize> {
        match self {
            Self::Section(index) => Some(index),
            _ => None,
        }
    }
}
