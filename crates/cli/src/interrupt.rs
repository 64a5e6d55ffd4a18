//! Signals. Ctrl-C: the first asks the run to stop after the increment, the
//! second ends the process; files are valid either way. A limit on the size of
//! files is an error of a write, not the end of the process.

use crate::screen;
use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// Listens from now on, for a run.
pub(crate) fn listen() {
    listen_saying("\ninterrupted: finishing the increment; once more to stop at once\n");
}

/// The same with other words for who interrupts.
pub(crate) fn listen_saying(words: &'static str) {
    let heard = move || {
        if ASKED.swap(true, Ordering::SeqCst) {
            std::process::exit(crate::exit::Exit::Interrupted as i32);
        }
        screen::error(words);
    };
    let _ = ctrlc::set_handler(heard); // without it Ctrl-C ends the process, as anywhere
}

/// Under a limit on the size of files (`ulimit -f`) the system sends SIGXFSZ, which ends a process
/// that does not listen, in the middle of a line. With a listener the write fails with EFBIG
/// instead, and is reported like a full disk.
pub(crate) fn outlive_file_limits() {
    #[cfg(unix)]
    {
        use signal_hook::consts::SIGXFSZ;
        let heard = std::sync::Arc::new(AtomicBool::new(false));
        // without it the limit ends the process, as anywhere
        let _ = signal_hook::flag::register(SIGXFSZ, heard);
    }
}

/// Whether the user wants to stop.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
