//! Files that a command makes for the user to go on with: never over another one.

use crate::exit::Exit;
use crate::render;
use slideline::diag::{Code, Diagnostic, Sources};
use slideline::output::write_file;
use std::path::Path;

/// Writes a file that is not there yet; what stands against it is said.
pub(crate) fn write(path: &Path, content: &str) -> Exit {
    if path.exists() {
        let message = format!("{} is there already and is kept", path.display());
        let said = Diagnostic::error(Code("SL0719"), message)
            .help("Name another file with -o, or remove that one.");
        render::to_standard_error([&said], &Sources::default());
        return Exit::Input;
    }
    if let Err(failure) = write_file(path, content.as_bytes()) {
        let message = format!("the deck could not be written: {failure}");
        let said = Diagnostic::error(Code("SL0702"), message)
            .help("Name a file in a folder that exists with -o.");
        render::to_standard_error([&said], &Sources::default());
        return Exit::Output;
    }
    Exit::Completed
}
