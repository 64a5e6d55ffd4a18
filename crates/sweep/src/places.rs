//! Places in responses as places in the study file.

use slideline::diag::{FileId, Sources, Span};
use std::ops::Range;

/// Texts of responses: where each stands in the study file, in the order in which they were added to
/// the sources.
pub(crate) struct Places {
    /// The study file.
    pub file: FileId,
    /// Number of the first response among the sources.
    pub first: usize,
    /// Values with their quotation marks.
    pub values: Vec<Range<usize>>,
}

impl Places {
    /// The place in the study file of one in a response; other places are as they were. Where
    /// letters are written in another way (`\u0040`), that is the whole value.
    pub fn in_file(&self, span: Span, sources: &Sources) -> Span {
        let own = (span.file.0 as usize).checked_sub(self.first);
        let Some(value) = own.and_then(|own| self.values.get(own)) else { return span };
        let whole = Span::new(self.file, value.start, value.end);
        let text = |file| sources.get(file).map(|source| source.text.as_str());
        let written = text(self.file).and_then(|text| text.get(value.clone()));
        match (written, text(span.file)) {
            (Some(written), Some(text)) if written.len() >= text.len() => {
                let marks = (written.len() - text.len()) / 2;
                let same = written.get(marks..marks + text.len()) == Some(text);
                let at = |place: u32| value.start + marks + place as usize;
                if same { Span::new(self.file, at(span.start), at(span.end)) } else { whole }
            }
            _ => whole,
        }
    }
}
