//! A diagnostic as a JSON object.

use crate::json::{Value, json};
use slideline_diag::{Diagnostic, Location, Sources, Span};

/// The members `code`, `severity`, `message`, `file`, `line`, `columns` (the
/// first and one past the last, counted from 1, on that line), `card`, and
/// `help` and `suggestion` (the text of a card) where there is one; null where a diagnostic has no place.
pub fn record(diagnostic: &Diagnostic, sources: &Sources) -> Value {
    let at = diagnostic.span.and_then(|span| sources.locate(span));
    let mut object = json!({
        "code": diagnostic.code.0,
        "severity": diagnostic.severity.word(),
        "message": diagnostic.message,
        "file": at.as_ref().map(|at| at.file.as_str()),
        "line": at.as_ref().map(|at| at.line),
        "columns": at.as_ref().map(|at| columns(at, sources, diagnostic.span)),
        "card": card(diagnostic.span, sources),
    });
    let more = [("help", diagnostic.help.as_deref()), ("suggestion", diagnostic.suggestion())];
    for (key, text) in more.into_iter().filter_map(|(key, text)| Some((key, text?))) {
        object[key] = text.into();
    }
    object
}

/// The first column and one past the last, on the first line of a place.
pub fn columns(at: &Location, sources: &Sources, span: Option<Span>) -> [usize; 2] {
    let end = if at.end_line == at.line {
        at.end_column
    } else {
        let source = span.and_then(|span| sources.get(span.file));
        source.map_or(at.column, |source| source.line(at.line).chars().count() + 1)
    };
    [at.column, at.column.max(end)]
}

/// The keyword, with its star, of the card that a place lies in.
pub fn card(span: Option<Span>, sources: &Sources) -> Option<String> {
    let span = span?;
    let line = sources.locate(span)?.line;
    let source = sources.get(span.file)?;
    (1..=line).rev().map(|number| source.line(number).trim_start()).find_map(|line| {
        let is_keyword = line.starts_with('*') && !line.starts_with("**");
        is_keyword.then(|| line.split(',').next().unwrap_or(line).trim_end().to_ascii_uppercase())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::text;
    use slideline_diag::Code;

    #[test]
    fn a_place_is_told_by_file_line_columns_and_card() {
        let mut sources = Sources::default();
        let file = sources.add("a.inp", "*Node, nset=A\n** comment\n1, x, 2\n");
        let at = Span::new(file, 28, 29);
        assert_eq!(sources.text(at), "x");
        let diagnostic = Diagnostic::error(Code("SL0110"), "not a number").at(at).help("Give one.");
        assert_eq!(
            text(&record(&diagnostic, &sources)),
            r#"{"code":"SL0110","severity":"error","message":"not a number","file":"a.inp","line":3,"columns":[4,5],"card":"*NODE","help":"Give one."}"#
        );
        let nowhere = Diagnostic::note(Code("SL0111"), "m");
        assert_eq!(
            text(&record(&nowhere, &sources)),
            r#"{"code":"SL0111","severity":"note","message":"m","file":null,"line":null,"columns":null,"card":null}"#
        );
    }
}
