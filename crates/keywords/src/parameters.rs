//! Values put in place of the names of parameters: `<width>`.

use std::borrow::Cow;

use slideline_deck::{Card, Field, Word, normalise};
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::expression::{Value, is_name};

/// The card with values in place of names; the same where it names none.
pub(crate) fn put_in<'c>(card: &'c Card, draft: &mut Draft) -> Cow<'c, Card> {
    let named = |text: &str| text.contains('<');
    let values = card.parameters.iter().filter_map(|parameter| parameter.value.as_ref());
    let any = values.map(|word| &word.raw).any(|raw| named(raw))
        || card.data.iter().any(|line| named(&line.text));
    if draft.parameters.is_empty() || !any {
        return Cow::Borrowed(card);
    }
    let mut own = card.clone();
    for word in own.parameters.iter_mut().filter_map(|parameter| parameter.value.as_mut()) {
        if let Some(raw) = replaced(&word.raw, word.span, draft) {
            let name = normalise(&raw);
            *word = Word { raw, name, span: word.span };
        }
    }
    for line in &mut own.data {
        for field in &mut line.fields {
            if let Some(text) = replaced(&field.text, field.span, draft) {
                *field = Field { text, span: field.span };
            }
        }
    }
    Cow::Owned(own)
}

/// The text with values for names; `None` where it has none.
fn replaced(text: &str, span: Span, draft: &mut Draft) -> Option<String> {
    let mut whole = String::new();
    let mut rest = text;
    let mut any = false;
    while let Some((before, after)) = rest.split_once('<') {
        let Some((name, behind)) = after.split_once('>').filter(|(name, _)| is_name(name)) else {
            break;
        };
        whole.push_str(before);
        match draft.parameters.get(name).map(Value::text) {
            Some(value) => {
                whole.push_str(&value);
                draft.log.values.push((span, name.to_owned(), value));
            }
            None => {
                unknown(name, span, draft);
                return None;
            }
        }
        (rest, any) = (behind, true);
    }
    whole.push_str(rest);
    any.then_some(whole)
}

fn unknown(name: &str, span: Span, draft: &mut Draft) {
    // what follows from a value that is missing is not complained about as well
    draft.log.has_parameters = true;
    draft.mark_all_incomplete();
    if !draft.log.first_time(&format!("parameter {name}")) {
        return;
    }
    let error = Diagnostic::error(Code("SL0286"), format!("the parameter {name} has no value"));
    let mut help = "give it a value by *PARAMETER above this line".to_owned();
    let names = draft.parameters.keys().map(String::as_str);
    if let Some(near) = slideline_deck::nearest(name, names) {
        help = format!("did you mean <{near}>? Capitals and small letters differ");
    }
    draft.log.push(error.at(span).help(help));
}
