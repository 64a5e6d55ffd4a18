//! Any bytes are interpreted to their end, in both dialects.

use slideline::deck::NoFiles;
use slideline::diag::Sources;
use slideline::keywords::read;
use slideline::model::Dialect;

/// Reads the deck; every place that a diagnostic names lies in the text.
pub fn check(bytes: &[u8]) {
    for dialect in [Dialect::Abaqus, Dialect::Calculix] {
        let mut sources = Sources::default();
        let found = read(&mut sources, "a.inp", bytes, &NoFiles, dialect);
        for said in &found.diagnostics {
            let Some(span) = said.span else { continue };
            let text = sources.files().get(span.file.0 as usize).map_or("", |file| &file.text);
            let place = text.get(span.start as usize..span.end as usize);
            assert!(place.is_some(), "{said:?} points outside the text");
        }
    }
}
