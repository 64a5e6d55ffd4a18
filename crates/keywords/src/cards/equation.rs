//! `*EQUATION`: dofs that follow others linearly.
//!
//! ```text
//!   a1 u1 + a2 u2 + ... = 0       the first dof is eliminated: u1 = -(a2 u2 + ...)/a1
//! ```

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};

use crate::constraints::{Equation as Terms, Term};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*EQUATION`.
pub(crate) struct Equation;

impl Keyword for Equation {
    fn name(&self) -> &'static str {
        "EQUATION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::value("INPUT"), Rule::flag("REMOVE"), Rule::flag("REMOVE ALL")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("EQUATION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.in_step || card.has("REMOVE") || card.has("REMOVE ALL") {
            changes(card, draft);
            return;
        }
        if card.first_line("the number of terms", &mut draft.log).is_none() {
            return;
        }
        let mut lines = card.data().iter();
        while let Some(line) = lines.next() {
            let Some(count) = count(line, draft) else { return };
            let mut terms = Vec::with_capacity(count.min(1000));
            while terms.len() < count {
                let Some(line) = lines.next() else {
                    let message = format!("{} of {count} terms are given", terms.len());
                    draft.log.error("SL0208", message, card.span());
                    return;
                };
                let Some(read) = terms_of(line, count - terms.len(), draft) else { return };
                terms.extend(read);
            }
            draft.equations.push(Terms { terms, origin: line.span });
        }
    }
}

/// Equations are those of all steps; complains about what begins or ends with one.
fn changes(card: &Reading<'_>, draft: &mut Draft) {
    let (code, message) = match ["REMOVE", "REMOVE ALL"].into_iter().find(|name| card.has(name)) {
        Some(name) => {
            ("SL0221", format!("*EQUATION, {name} is not supported: equations hold in all steps"))
        }
        None => ("SL0214", "*EQUATION belongs before the first *STEP".to_owned()),
    };
    let help = "for one that ends, give its last term the dof of a further node, hold that by *BOUNDARY, and \
                let it go with *BOUNDARY, OP=NEW";
    draft.log.push(Diagnostic::error(Code(code), message).at(card.span()).help(help));
}

/// The line before the terms: how many there are.
fn count(line: &DataLine, draft: &mut Draft) -> Option<usize> {
    draft.log.at_most(line, 1);
    let value = draft.log.integer_or(line, 0, 0)?;
    let count = usize::try_from(value).ok().filter(|&count| count > 0);
    if count.is_none() {
        let message = format!("{value} is not a number of terms");
        draft.log.error("SL0210", message, line.span);
    }
    count
}

/// The terms of a line: node or set, dof, factor, and again.
fn terms_of(line: &DataLine, left: usize, draft: &mut Draft) -> Option<Vec<Term>> {
    let mut terms = Vec::new();
    draft.log.at_most(line, 3 * left);
    for at in (0..line.fields.len().min(3 * left)).step_by(3) {
        let node = draft.log.target(line, at, "a node or set")?;
        let span = line.fields[at].span;
        let number = draft.log.integer_or(line, at + 1, 0)?;
        let dof = draft.dof(number, line, at + 1)?;
        let factor = draft.log.number(line, at + 2, "the factor of the term")?;
        terms.push(Term { node, span, dof, factor });
    }
    if terms.is_empty() {
        nothing(line.span, draft);
        return None;
    }
    Some(terms)
}

fn nothing(span: Span, draft: &mut Draft) {
    let error = Diagnostic::error(Code("SL0208"), "a term is missing here").at(span);
    draft.log.push(error.help("a term is three values: node or set, dof, factor"));
}
