//! Standard output and standard error. A stream that is closed is no error:
//! `slideline run job | head` goes on quietly.

use std::io::{IsTerminal as _, Write as _};

/// Writes text to standard output.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush()); // nobody left to be told
}

/// Writes text to standard error.
pub(crate) fn error(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes()); // nobody left to be told
}

/// Whether standard output is a terminal.
pub(crate) fn output_is_terminal() -> bool {
    std::io::stdout().is_terminal()
}

/// Columns of the terminal that standard output goes to; 80 where it does not
/// say.
pub(crate) fn output_width() -> usize {
    terminal_size::terminal_size_of(std::io::stdout())
        .map_or(80, |(terminal_size::Width(width), _)| usize::from(width))
}

/// Whether standard error takes colours.
pub(crate) fn error_takes_colour() -> bool {
    std::io::stderr().is_terminal()
        && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}
