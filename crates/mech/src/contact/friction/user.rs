//! A friction law of the embedding program, called in batches.

use super::super::tangential::Tangential;
use super::traction::Traction;
use std::fmt;
use std::sync::Arc;

/// What a user law is told about one closed point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionPoint {
    /// Pressure p > 0 [F/L2].
    pub pressure: f64,
    /// Slip of the increment [L].
    pub slip: Tangential,
    /// Committed elastic slip [L].
    pub elastic_slip: Tangential,
}

/// One call: all closed points of one interaction.
#[derive(Debug)]
pub struct FrictionBatch<'a> {
    /// Properties of the deck.
    pub properties: &'a [f64],
    /// Total time at the end of the increment [T].
    pub time: f64,
    /// Increment [T].
    pub dt: f64,
    /// The points.
    pub points: &'a [FrictionPoint],
    /// Committed state, `state_size` values a point.
    pub committed: &'a [f64],
    /// New state, to be written in full.
    pub state: &'a mut [f64],
    /// Tractions with their derivatives, to be written in full, one a point.
    pub tractions: &'a mut [Traction],
}

/// Why a user law gave no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UserFrictionError {
    /// In the words of the law.
    pub message: String,
}

impl fmt::Display for UserFrictionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "user friction law: {}", self.message)
    }
}

impl std::error::Error for UserFrictionError {}

/// A friction law of the embedding program. The answer must depend on the batch alone.
pub trait UserFriction: Send + Sync {
    /// Writes tractions and state of every point of the batch.
    ///
    /// # Errors
    /// If the law has no answer; the increment is then cut back.
    fn update(&self, batch: &mut FrictionBatch<'_>) -> Result<(), UserFrictionError>;
}

/// A law in the registry of a run; two are equal when they are the same object.
#[derive(Clone)]
pub struct Registered(pub Arc<dyn UserFriction>);

impl fmt::Debug for Registered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Registered(..)")
    }
}

impl PartialEq for Registered {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
