//! What a keyword says of itself: where it stands, what it knows, what it is for.

/// Where a keyword may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Before the first `*STEP`.
    Model,
    /// Between `*STEP` and `*END STEP`.
    History,
    /// Anywhere.
    Both,
}

/// What follows a parameter's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// Nothing: `GENERATE`.
    Nothing,
    /// A value: `ELSET=BEAM`.
    Value,
    /// Either: `NLGEOM`, `NLGEOM=YES`.
    Maybe,
}

/// A parameter that a keyword knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    /// Its name, spelt out.
    pub name: &'static str,
    /// What follows it.
    pub takes: Takes,
    /// Whether the keyword means nothing without it.
    pub required: bool,
}

impl Rule {
    /// A parameter without value.
    pub const fn flag(name: &'static str) -> Self {
        Self { name, takes: Takes::Nothing, required: false }
    }

    /// A parameter with a value.
    pub const fn value(name: &'static str) -> Self {
        Self { name, takes: Takes::Value, required: false }
    }

    /// A parameter with a value that must be given.
    pub const fn required(name: &'static str) -> Self {
        Self { name, takes: Takes::Value, required: true }
    }

    /// A parameter with or without a value.
    pub const fn maybe(name: &'static str) -> Self {
        Self { name, takes: Takes::Maybe, required: false }
    }
}

/// What a card contributes to. Where cards of a subject had errors, nothing
/// is said about things that may be missing only because of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    Nodes,
    Elements,
    /// Sections, and which materials there are.
    Sections,
    /// What materials are like; nothing is known of it where sections are not complete.
    Properties,
    Contact,
    Links,
    Amplitudes,
    Steps,
    Other,
}

/// A keyword as its cards are held against it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Form {
    /// Its name without the star, upper case, spelt out.
    pub name: &'static str,
    /// The parameters it knows.
    pub parameters: &'static [Rule],
    /// Parameters that change no result: accepted with a note.
    pub without_effect: &'static [&'static str],
}
