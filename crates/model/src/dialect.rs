//! Two programs that read the same keywords differently.

/// Whose reading of a keyword counts where two programs differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Dialect {
    /// Abaqus/Standard.
    #[default]
    Abaqus,
    /// CalculiX.
    Calculix,
}

impl Dialect {
    /// The word used on the command line and in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Abaqus => "abaqus",
            Self::Calculix => "calculix",
        }
    }
}
