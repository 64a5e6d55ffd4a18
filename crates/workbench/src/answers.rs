//! Short answers.

use serde_json::{Value, json};

/// What is not understood, or cannot be done.
pub(crate) fn refused(id: &Value, why: &str) -> Value {
    json!({"say": "refused", "id": id, "why": why})
}

/// A solve that was left for a newer one.
pub(crate) fn overtaken(id: &Value) -> Value {
    json!({"say": "overtaken", "id": id})
}
