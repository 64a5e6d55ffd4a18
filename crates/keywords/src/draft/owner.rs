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
    /// A gap, which takes no law of contact.
    Gap,
    /// The owner is broken or missing, and that has been said.
    Broken,
}

impl Owner {
    /// Why a law of contact does not belong to it: code, message and remedy.
    pub fn without_interaction(self, keyword: &str) -> (&'static str, String, &'static str) {
        match self {
            Self::Gap => (
                "SL0221",
                format!("*{keyword} of *GAP is not supported: gaps do not rub"),
                "contact with friction is a *CONTACT PAIR of a node and a face",
            ),
            _ => (
                "SL0213",
                format!("*{keyword} has no *INTERFACE or *SURFACE INTERACTION to belong to"),
                "put it directly behind the card whose law it is",
            ),
        }
    }

    /// The section, if it is one.
    pub fn section(self) -> Option<usize> {
        match self {
            Self::Section(index) => Some(index),
            _ => None,
        }
    }
}
