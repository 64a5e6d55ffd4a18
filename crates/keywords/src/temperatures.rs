//! Temperatures as cards give them.

use slideline_deck::DataLine;
use slideline_model::Temperature;

use crate::draft::{Draft, Heat};
use crate::reading::Reading;

/// The lines `node or set, temperature, slope` of a card.
pub(crate) fn lines(card: &Reading<'_>, draft: &mut Draft) -> Vec<Heat> {
    card.data().iter().filter_map(|line| heat(line, draft)).collect()
}

fn heat(line: &DataLine, draft: &mut Draft) -> Option<Heat> {
    let target = draft.log.target(line, 0, "the node or set")?;
    let value = draft.log.number(line, 1, "the temperature")?;
    let slope = draft.log.number_or(line, 2, 0.0)?;
    Some(Heat {
        target,
        target_span: line.fields[0].span,
        temperature: Temperature { value, slope },
        slope: line.field(2).filter(|_| slope != 0.0).map(|field| field.span),
        further: line.fields.iter().skip(3).find(|field| !field.text.is_empty()).map(|f| f.span),
        amplitude: None,
        origin: line.span,
    })
}
