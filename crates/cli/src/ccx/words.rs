//! What ccx says, in its words: programs look for some of them.

use slideline::VERSION;
use slideline::diag::{Diagnostic, Severity, Sources};

/// The answer to a call without arguments: FreeCAD looks for `CalculiX` in it.
pub(super) const USAGE: &str = "Usage: CalculiX.exe -i jobname\n";

/// The answer to `-v`. The version is that of the ccx whose behaviour this is: FreeCAD takes
/// the first two numbers and refuses old ones.
pub(super) fn version() -> String {
    format!("\nThis is Version 2.20\n\nslideline {VERSION} in place of CalculiX\n\n")
}

/// The head of every run.
pub(super) fn head() -> String {
    let line = "************************************************************";
    format!(
        "\n{line}\n\nCalculiX Version 2.20: slideline {VERSION} in its place\n\
         (CalculiX itself is another program: https://www.calculix.de)\n\n{line}\n\n"
    )
}

/// The last words of a run that came to its end.
pub(super) fn finished(seconds: f64) -> String {
    let line = "________________________________________";
    format!("\n Job finished\n\n{line}\n\nTotal CalculiX Time: {seconds:.6}\n{line}\n")
}

/// One diagnostic: severity, place and code on a line, then what it says. `*ERROR` anywhere makes
/// PrePoMax and FreeCAD call a run failed, so that nothing but an error has it.
pub(super) fn said(said: &Diagnostic, sources: &Sources) -> String {
    let word = match said.severity {
        Severity::Error => "*ERROR",
        Severity::Warning => "*WARNING",
        Severity::Advice | Severity::Note => "*INFO",
    };
    let place = said.span.and_then(|span| {
        let line = sources.locate(span)?.line;
        Some(format!(" in {}, line {line}", sources.get(span.file)?.name))
    });
    let mut text = format!(" {word}{} ({})\n", place.unwrap_or_default(), said.code.0);
    let help = said.help.as_deref().unwrap_or_default();
    for line in said.message.lines().chain(help.lines()) {
        let line = if said.severity == Severity::Error {
            line.to_owned()
        } else {
            line.replace("*ERROR", "ERROR")
        };
        text.push_str(&format!("       {line}\n"));
    }
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline::diag::{Code, Span};

    /// Requirement: only an error has the word that makes a run failed, whatever it quotes.
    #[test]
    fn only_errors_are_called_so() {
        let mut sources = Sources::default();
        let file = sources.add("a.inp", "*NODE\n*ERROR\n");
        let at = |said: Diagnostic| said.at(Span::new(file, 6, 12)).help("Leave it out.");
        let note = at(Diagnostic::note(Code("SL0257"), "*ERROR has no effect"));
        let shown = " *INFO in a.inp, line 2 (SL0257)\n       ERROR has no effect\n       Leave it out.\n\n";
        assert_eq!(said(&note, &sources), shown);
        let error = at(Diagnostic::error(Code("SL0201"), "no such card"));
        assert!(said(&error, &sources).starts_with(" *ERROR in a.inp, line 2 (SL0201)\n"));
    }
}
