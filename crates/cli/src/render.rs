//! Diagnostics as text: place, code, the line itself, what to do.

use crate::screen;
use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};
use slideline::diag::{Diagnostic, Severity, Source, Sources, Span};

/// Writes diagnostics to standard error, in the order in which they are.
pub(crate) fn to_standard_error<'a>(
    diagnostics: impl IntoIterator<Item = &'a Diagnostic>,
    sources: &Sources,
) {
    let colour = screen::error_takes_colour();
    let text: String = diagnostics.into_iter().map(|said| text(said, sources, colour)).collect();
    screen::error(&text);
}

/// One diagnostic; plain ASCII without `colour`.
pub(crate) fn text(said: &Diagnostic, sources: &Sources, colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    let title = level(said.severity).primary_title(&said.message).id(said.code.0);
    let primary = said.span.and_then(|span| snippet(span, sources, AnnotationKind::Primary, None));
    let second = said.labels.iter().filter_map(|label| {
        snippet(label.span, sources, AnnotationKind::Context, Some(&label.text))
    });
    let mut group = Group::with_title(title).elements(primary).elements(second);
    if let Some(help) = &said.help {
        group = group.element(Level::HELP.message(help));
    }
    if let Some(card) = said.suggestion() {
        let card = card.trim_end().replace('\n', "\n    ");
        group = group.element(Level::HELP.message(format!("as a card:\n    {card}")));
    }
    renderer.render(&[group]) + "\n\n"
}

fn level(severity: Severity) -> Level<'static> {
    match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Advice => Level::INFO.with_name("advice"),
        Severity::Note => Level::NOTE,
    }
}

/// The lines that a span covers, three at most, with the span marked.
fn snippet<'a>(
    span: Span,
    sources: &'a Sources,
    kind: AnnotationKind,
    label: Option<&'a str>,
) -> Option<Snippet<'a, Annotation<'a>>> {
    let source = sources.get(span.file)?;
    let at = sources.locate(span)?;
    let (offset, lines) = lines_of(source, span);
    let mark = |byte: u32| boundary(lines, (byte as usize).saturating_sub(offset));
    let (start, end) = (mark(span.start), mark(span.end));
    let annotation = kind.span(start..end.max(start)).label(label);
    Some(
        Snippet::source(lines)
            .line_start(at.line)
            .path(source.name.as_str())
            .annotation(annotation),
    )
}

/// Where the first line of a span begins, and the text from there to the end
/// of its last line.
fn lines_of(source: &Source, span: Span) -> (usize, &str) {
    let text = source.text.as_str();
    let start = boundary(text, span.start as usize);
    let begin = text[..start].rfind('\n').map_or(0, |at| at + 1);
    let mut last = boundary(text, (span.end as usize).max(start));
    if last > start && text[..last].ends_with('\n') {
        last -= 1; // a span that takes the line ending in ends on that line
    }
    let end = text[last..].find('\n').map_or(text.len(), |at| last + at);
    (begin, text[begin..end].trim_end_matches('\r'))
}

/// The last place at or before `byte` where a character begins or ends.
fn boundary(text: &str, byte: usize) -> usize {
    let clipped = byte.min(text.len());
    (0..=clipped).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline::diag::Code;

    #[test]
    fn place_code_message_line_and_help() {
        let mut sources = Sources::default();
        let file = sources.add("a.inp", "*NODE\n1, x, 2\r\n");
        let said = Diagnostic::error(Code("SL0116"), "`x` is not a number")
            .at(Span::new(file, 9, 10))
            .label(Span::new(file, 0, 5), "of this card")
            .help("Write a number.");
        let text = text(&said, &sources, false);
        for part in [
            "error[SL0116]: `x` is not a number",
            "a.inp:2:4",
            "1, x, 2",
            "^",
            "of this card",
            "help: Write a number.",
        ] {
            assert!(text.contains(part), "{part} in:\n{text}");
        }
        assert!(text.is_ascii());
    }

    #[test]
    fn no_span_however_wrong_stops_the_renderer() {
        let mut sources = Sources::default();
        let file = sources.add("a.inp", "\u{e9}\u{e9}\r\n\ttab\u{0}\n");
        for start in 0..14 {
            for end in start..20 {
                let said = Diagnostic::note(Code("SL0101"), "m").at(Span::new(file, start, end));
                assert!(text(&said, &sources, false).contains("SL0101"));
            }
        }
        let empty = sources.add("empty.inp", "");
        let said = Diagnostic::note(Code("SL0101"), "m").at(Span::new(empty, 3, 7));
        assert!(text(&said, &sources, true).contains("SL0101"));
    }
}
