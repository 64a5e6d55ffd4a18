//! What a model is counted under.

/// What a model is counted under.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// Class.
    pub class: &'static str,
    /// Number there.
    pub number: u64,
    /// Whether it must complete.
    pub well_posed: bool,
}
