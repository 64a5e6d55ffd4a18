//! The adviser's findings as diagnostics of a deck, and the deck mended.

use crate::read::Read;
use slideline_advice::Finding;
use slideline_deck::{Card, Deck};
use slideline_diag::{Diagnostic, Edit, FileId, Place, Span, Suggestion};

/// What the adviser says about a deck that was read; nothing where it has no
/// model. A finding that one card mends carries the edit.
pub fn advise(read: &Read) -> Vec<Diagnostic> {
    let Some(model) = &read.model else { return Vec::new() };
    let findings = slideline_advice::advise(model);
    findings.into_iter().map(|finding| with_edit(&read.deck, finding)).collect()
}

/// The deck with the edits of these diagnostics, each with a comment that
/// says why. `None`: there is nothing to mend in the deck itself.
pub fn mended(read: &Read, diagnostics: &[Diagnostic]) -> Option<Vec<u8>> {
    let mut places: Vec<Span> = Vec::new();
    let mut edits = Vec::new();
    for said in diagnostics {
        let by_card = || said.card.clone().and_then(|card| edit(&read.deck, &card));
        let edit = said.edit.clone().or_else(by_card);
        let Some(edit) = edit.filter(|edit| edit.span.file == FileId(0)) else {
            continue;
        };
        let whole_line = edit.replacement.ends_with('\n');
        if places.contains(&edit.span) {
            continue; // one card at a place: the first finding has it
        }
        places.push(edit.span);
        let comment = format!("** {}: {}\n", said.code, said.message.replace('\n', " "));
        let replacement =
            if whole_line { comment + &edit.replacement } else { edit.replacement.clone() };
        edits.push(Edit { span: edit.span, replacement });
    }
    (!edits.is_empty()).then(|| slideline_deck::apply(&read.deck, FileId(0), &edits).bytes)
}

fn with_edit(deck: &Deck, finding: Finding) -> Diagnostic {
    let mut said = finding.diagnostic;
    if let Some(card) = finding.card {
        said.edit = edit(deck, &card);
    }
    said
}

/// The edit that writes a card.
fn edit(deck: &Deck, card: &Suggestion) -> Option<Edit> {
    let Suggestion { place, text } = card;
    let (Place::Before(at) | Place::After(at) | Place::Instead(at) | Place::Data(at)) = *place;
    let card = deck.cards.iter().find(|card| {
        card.keyword.span.file == at.file
            && (start_of(card)..=card.full_span().end).contains(&at.start)
    })?;
    if matches!(place, Place::Data(_)) && !same_data(card, text) {
        return None; // the model remembers another card
    }
    let (start, end) = (start_of(card), end_of(deck, card));
    let span = |start, end| Span { file: at.file, start, end };
    let span = match place {
        Place::Before(_) => span(start, start),
        Place::After(_) => span(end, end),
        Place::Instead(_) => span(start, end),
        Place::Data(_) => span(line_end(deck, card.span.file, card.span.end), end),
    };
    Some(Edit { span, replacement: text.clone() })
}

/// First byte of the card's line.
fn start_of(card: &Card) -> u32 {
    card.span.start.min(card.keyword.span.start.saturating_sub(1))
}

/// Whether the data of a card begins with the first word of `text`.
fn same_data(card: &Card, text: &str) -> bool {
    let word = text.split(',').next().unwrap_or_default();
    let first = card.data.first().and_then(|line| line.fields.first());
    first.is_some_and(|field| field.text.eq_ignore_ascii_case(word))
}

/// First byte of the line behind the card and its data.
fn end_of(deck: &Deck, card: &Card) -> u32 {
    line_end(deck, card.span.file, card.full_span().end)
}

/// First byte of the line behind the one with that byte.
fn line_end(deck: &Deck, file: FileId, last: u32) -> u32 {
    let file = deck.files.iter().find(|own| own.file == file);
    let rest = file.and_then(|file| file.bytes.get(last as usize..)).unwrap_or_default();
    let line = rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |at| at + 1);
    last + u32::try_from(line).unwrap_or(0)
}
