//! What writes one kind of file.

use crate::file::WriteError;
use crate::kept::Kept;
use slideline_solve::observe::Event;

/// Writes one kind of file.
pub(crate) trait Writer {
    /// Takes note of an event.
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError>;

    /// Notes what a run that goes on from here has to find.
    fn keep(&self, _kept: &mut Kept) {}
}
