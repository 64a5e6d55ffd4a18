//! Temperatures as cards give them.

use slideline_deck::{DataLine, Field};
use slideline_model::Temperature;

use crate::draft::{Draft, Heat};
use crate::reading::Reading;

/// The lines `node or set, temperature, slope along axis 2 of the section of a beam, along axis 1` of a card.
pub(crate) fn lines(card: &Reading<'_>, draft: &mut Draft) -> Vec<Heat> {
    card.data().iter().filter_map(|line| heat(line, draft)).collect()
}

fn heat(line: &DataLine, draft: &mut Draft) -> Option<Heat> {
    let target = draft.log.target(line, 0, "the node or set")?;
    let value = draft.log.number(line, 1, "the temperature")?;
    let slopes = [draft.log.number_or(line, 2, 0.0)?, draft.log.number_or(line, 3, 0.0)?];
    let given = |field: &&Field| !field.text.is_empty();
    Some(Heat {
        target,
        target_span: line.fields[0].span,
        temperature: Temperature { value, slopes },
        slope: line.field(2).filter(|_| slopes[0] != 0.0).map(|field| field.span),
        other_slope: line.field(3).filter(given).map(|field| field.span),
        further: line.fields.iter().skip(4).find(given).map(|field| field.span),
        amplitude: None,
        origin: line.span,
    })
}
