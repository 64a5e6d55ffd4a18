//! To be written.

use crate::answers::refused;
use crate::deck::Opened;
use crate::solve::Room;
use crate::values::Values;
use serde_json::Value;

/// To be written.
pub(crate) fn aim(
    _: &Opened,
    _: &Values,
    _: &mut Room,
    (id, _): (&Value, &Value),
    _: &mut dyn FnMut(&str) -> bool,
) -> Value {
    refused(id, "not yet")
}
