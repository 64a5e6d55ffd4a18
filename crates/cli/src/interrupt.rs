//! Ctrl-C: the first asks the run to stop after the increment, the second
//! ends the process; files are valid either way.

use crate::screen;
use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// Listens from now on.
pub(crate) fn listen() {
    let heard = || {
        if ASKED.swap(true, Ordering::SeqCst) {
            std::process::exit(crate::exit::Exit::Interrupted as i32);
        }
        screen::error("\ninterrupted: finishing the increment; once more to stop at once\n");
    };
    let _ = ctrlc::set_handler(heard); // without it Ctrl-C ends the process, as anywhere
}

/// Whether the user wants to stop.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
