//! What a run is differentiated by.

use slideline_model::Model;
use std::fmt;
use std::sync::Arc;

/// A number that a model depends on.
#[derive(Clone)]
pub struct Parameter {
    /// Its name, for messages.
    pub name: String,
    /// Its value, in its own unit.
    pub value: f64,
    /// What counts as a large change of it, above zero: its magnitude, where it has one.
    pub scale: f64,
    /// The model at another value near that one; `None`: there is none.
    pub model: Arc<dyn Fn(f64) -> Option<Model> + Send + Sync>,
}

impl fmt::Debug for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, value, scale, .. } = self;
        write!(f, "Parameter {{ name: {name:?}, value: {value}, scale: {scale}, .. }}")
    }
}

/// Why a model has no derivative by a parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SensitivityFault {
    /// There is no model at a value near that of the parameter.
    NoModel(String),
    /// The parameter changes the outline of the model, such as the number of its elements.
    Outline(String),
    /// The parameter changes the times of increments or of steps, which are held.
    Times(String),
}

impl SensitivityFault {
    /// The name of the parameter.
    pub fn parameter(&self) -> &str {
        match self {
            Self::NoModel(name) | Self::Outline(name) | Self::Times(name) => name,
        }
    }
}

impl fmt::Display for SensitivityFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoModel(name) => {
                write!(f, "there is no model where the parameter {name} is a little different")
            }
            Self::Outline(name) => {
                write!(f, "the parameter {name} changes the numbering of the model")
            }
            Self::Times(name) => write!(f, "the parameter {name} changes the times of a step"),
        }
    }
}

impl std::error::Error for SensitivityFault {}
