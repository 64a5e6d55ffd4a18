//! Mends: the edits carried by diagnostics, applied to the bytes of a file.

use slideline_diag::{Edit, FileId};

use crate::card::Deck;

/// A file after its edits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Applied {
    /// The new bytes.
    pub bytes: Vec<u8>,
    /// Edits left out: they overlap an earlier one or point outside the text.
    pub refused: Vec<Edit>,
}

/// Applies the edits that concern `file`; everything else in the file stays
/// as it was, byte by byte. Equal edits are applied once.
pub fn apply(deck: &Deck, file: FileId, edits: &[Edit]) -> Applied {
    let old = deck.print(file);
    let mut order: Vec<&Edit> = edits.iter().filter(|edit| edit.span.file == file).collect();
    order.sort_by_key(|edit| (edit.span.start, edit.span.end));
    order.dedup();
    let mut applied = Applied { bytes: Vec::with_capacity(old.len()), refused: Vec::new() };
    let mut done = 0;
    for edit in order {
        let (start, end) = (edit.span.start as usize, edit.span.end as usize);
        if start < done || end < start || end > old.len() {
            applied.refused.push(edit.clone());
            continue;
        }
        applied.bytes.extend_from_slice(&old[done..start]);
        applied.bytes.extend_from_slice(edit.replacement.as_bytes());
        done = end;
    }
    applied.bytes.extend_from_slice(&old[done..]);
    applied
}

#[cfg(test)]
mod tests {
    use slideline_diag::{Sources, Span};

    use super::*;
    use crate::{NoFiles, parse};

    #[test]
    fn edits_change_only_what_they_name() {
        let mut sources = Sources::default();
        let parsed = parse(&mut sources, "a.inp", b"**INTERFACE\r\n*FRICTON\n\xe9", &NoFiles);
        let file = FileId(0);
        let edit = |start, end, text: &str| Edit {
            span: Span::new(file, start, end),
            replacement: text.to_owned(),
        };
        let edits =
            [edit(13, 21, "*FRICTION"), edit(0, 2, "*"), edit(14, 16, "x"), edit(0, 2, "*")];
        let applied = apply(&parsed.deck, file, &edits);
        assert_eq!(applied.bytes, b"*INTERFACE\r\n*FRICTION\n\xe9");
        assert_eq!(applied.refused.len(), 1);
    }
}
