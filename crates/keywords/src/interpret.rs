//! The pass over the cards.

use std::borrow::Cow;

use slideline_deck::{Card, Deck, Loader, Parsed, nearest, normalise, parse};
use slideline_diag::{Code, Diagnostic, Severity, Sources, Span};
use slideline_model::{Dialect, Model};

use crate::draft::{Draft, Owner};
use crate::earlier::{Earlier, MAY_FOLLOW};
use crate::keyword::Keyword;
use crate::log::Log;
use crate::overrides::{Overrides, Setting};
use crate::reading::{Match, Reading, note_abbreviation};
use crate::registry::{REGISTRY, keyword_of};
use crate::rule::Level;
use crate::unsupported::{self, Other, Treatment};
use crate::{finish, parameters, traps};

/// What a deck means.
#[derive(Clone, Debug)]
pub struct Interpreted {
    /// The model; complete only where no diagnostic is an error.
    pub model: Model,
    /// Everything there is to say about syntax, cards and the model as a
    /// whole, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// Parameters that the deck, or a setting, gives a number that follows from no other parameter:
    /// names and values, in the order of the text.
    pub numbers: Vec<(String, f64)>,
}

/// Reads and interprets a deck in one go.
pub fn read(
    sources: &mut Sources,
    name: &str,
    bytes: &[u8],
    loader: &dyn Loader,
    dialect: Dialect,
) -> Interpreted {
    interpret(&parse(sources, name, bytes, loader), dialect)
}

/// Gives a parsed deck its meaning. Total: any deck, every error in one pass,
/// the syntax errors of `parsed` included.
pub fn interpret(parsed: &Parsed, dialect: Dialect) -> Interpreted {
    interpret_with(&[], parsed, dialect)
}

/// Gives a parsed deck its meaning, with values of `settings` for its parameters.
pub fn interpret_with(settings: &[Setting], parsed: &Parsed, dialect: Dialect) -> Interpreted {
    interpret_after(&[], settings, parsed, dialect)
}

/// A parsed deck whose misprints were looked for, to be given its meaning with many values.
#[derive(Clone, Debug)]
pub struct Prepared {
    parsed: Parsed,
    dialect: Dialect,
    has_misprints: bool,
}

impl Prepared {
    /// That of a parsed deck.
    pub fn new(parsed: Parsed, dialect: Dialect) -> Self {
        let has_misprints = traps::has_misprints(&parsed.deck);
        Self { parsed, dialect, has_misprints }
    }

    /// Gives it its meaning, as [`interpret_with`] does.
    pub fn interpret_with(&self, settings: &[Setting]) -> Interpreted {
        let mend = if self.has_misprints { traps::mend } else { as_they_are };
        interpret_mended((&[], settings), &self.parsed, (self.dialect, mend))
    }
}

/// How misprints of cards are mended.
type Mend = for<'d> fn(&'d Deck, &mut Log) -> Vec<Cow<'d, Card>>;

fn as_they_are<'d>(deck: &'d Deck, _: &mut Log) -> Vec<Cow<'d, Card>> {
    deck.cards.iter().map(Cow::Borrowed).collect()
}

/// Gives a deck with `*RESTART, READ` its meaning: the cards of the decks it
/// goes on from, as far as they were walked, then its own.
pub fn interpret_after(
    earlier: &[Earlier<'_>],
    settings: &[Setting],
    parsed: &Parsed,
    dialect: Dialect,
) -> Interpreted {
    interpret_mended((earlier, settings), parsed, (dialect, traps::mend))
}

fn interpret_mended(
    (earlier, settings): (&[Earlier<'_>], &[Setting]),
    parsed: &Parsed,
    (dialect, mend): (Dialect, Mend),
) -> Interpreted {
    let mut draft = Draft::new(dialect);
    for (place, part) in earlier.iter().enumerate() {
        draft.goes_on = place > 0;
        draft.overrides = Overrides::of(part.settings, &mut draft.log);
        let cards = traps::mend(&part.parsed.deck, &mut draft.log);
        read_cards(&cards, &mut draft, part.steps);
    }
    draft.log.keep_errors(); // the rest was said when those decks were run
    draft.goes_on = !earlier.is_empty();
    draft.earlier_steps = draft.steps.len();
    if slideline_diag::has_errors(&parsed.diagnostics) {
        draft.mark_all_incomplete();
    }
    draft.overrides = Overrides::of(settings, &mut draft.log);
    let cards = mend(&parsed.deck, &mut draft.log);
    let stray_history = read_cards(&cards, &mut draft, usize::MAX);
    draft.overrides.complain_of_unmet(&draft.parameters, &mut draft.log);
    let nothing = cards.is_empty();
    let model = finish::finish(&mut draft, stray_history || nothing);
    let diagnostics = together(parsed, draft.log.into_diagnostics());
    Interpreted { model, diagnostics, numbers: draft.numbers }
}

/// Reads cards until so many steps are closed. Whether cards of a step stand
/// where no step was ever opened.
fn read_cards(cards: &[Cow<'_, Card>], draft: &mut Draft, steps: usize) -> bool {
    let mut stray_history = false;
    for card in cards {
        if draft.steps.len() >= steps && !draft.in_step {
            break;
        }
        let card = parameters::put_in(card, draft);
        if let Some(keyword) = find_keyword(&card, draft) {
            read_card(&card, keyword, draft, &mut stray_history);
        }
    }
    stray_history
}

/// Syntax and meaning in one list, in the order of the text. Where the syntax
/// of a place is wrong, its meaning is not complained about as well.
fn together(parsed: &Parsed, meaning: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let syntax = &parsed.diagnostics;
    let errors = syntax.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
    let broken: Vec<Span> = errors.filter_map(|error| spoilt(parsed, error)).collect();
    let follows = |diagnostic: &Diagnostic| {
        diagnostic.span.is_some_and(|span| {
            let end = span.end.max(span.start + 1);
            let meets = |at: &Span| at.file == span.file && at.start < end && span.start < at.end;
            broken.iter().any(meets)
        })
    };
    let own = |said: &Diagnostic| {
        let here = |span: Span| parsed.deck.files.iter().any(|lines| lines.file == span.file);
        said.severity == Severity::Error || said.span.is_none_or(here)
    };
    let meaning = meaning.into_iter().filter(|said| own(said) && !follows(said));
    let mut all: Vec<Diagnostic> = syntax.iter().cloned().chain(meaning).collect();
    all.sort_by_key(|diagnostic| {
        diagnostic.span.map_or((u32::MAX, 0), |span| (span.file.0, span.start))
    });
    all
}

/// What a syntax error makes unreadable: its place, or the whole line where
/// bytes or quotation marks are at fault.
fn spoilt(parsed: &Parsed, error: &Diagnostic) -> Option<Span> {
    let span = error.span?;
    if !matches!(error.code.0, "SL0103" | "SL0109" | "SL0110" | "SL0111") {
        return Some(span);
    }
    let file = parsed.deck.files.iter().find(|lines| lines.file == span.file)?;
    let after = file.lines.partition_point(|line| line.span.start <= span.start);
    after.checked_sub(1).map(|index| file.lines[index].span)
}

fn read_card(
    card: &Card,
    keyword: &'static dyn Keyword,
    draft: &mut Draft,
    stray_history: &mut bool,
) {
    let errors = draft.log.errors();
    if !keyword.is_suboption() {
        draft.owner = Owner::Nobody;
    }
    if misplaced(card, keyword, draft, stray_history) {
        return;
    }
    match Reading::new(card, keyword.form(), &mut draft.log) {
        Some(reading) => keyword.read(&reading, draft),
        None if !keyword.is_suboption() => draft.owner = Owner::Broken,
        None => {}
    }
    if draft.log.errors() > errors {
        draft.mark_incomplete(keyword.subject());
    }
}

/// Whether the card cannot be read where it stands.
fn misplaced(
    card: &Card,
    keyword: &dyn Keyword,
    draft: &mut Draft,
    stray_history: &mut bool,
) -> bool {
    let name = keyword.name();
    if name == "STEP" {
        draft.close_forgotten("*STEP", card.span);
    }
    match (keyword.level(), draft.in_step) {
        (Level::Model, true) => {
            let message = format!("*{name} belongs before the first *STEP");
            draft.log.error("SL0214", message, card.span);
            false
        }
        (Level::Model | Level::Both, false) if draft.goes_on && !MAY_FOLLOW.contains(&name) => {
            let message = format!("*{name} belongs to the deck of the previous job");
            let error = Diagnostic::error(Code("SL0214"), message).at(card.span);
            let help = format!(
                "the model comes from the saved state; before *STEP only {} are allowed here",
                MAY_FOLLOW.map(|name| format!("*{name}")).join(", ")
            );
            draft.log.push(error.help(help));
            true
        }
        (Level::History, false) if name != "STEP" => {
            if !*stray_history {
                *stray_history = draft.steps.is_empty();
                let message = format!("*{name} belongs between *STEP and *END STEP");
                draft.log.error("SL0214", message, card.span);
            }
            true
        }
        _ => false,
    }
}

fn find_keyword(card: &Card, draft: &mut Draft) -> Option<&'static dyn Keyword> {
    let word = &card.keyword;
    let name = normalise(&word.raw);
    let found = keyword_of(&name);
    if let Match::Exact(keyword) = found {
        return Some(keyword);
    }
    if let Some(other) = unsupported::find(&name) {
        not_read(&other, word.span, draft);
        return None;
    }
    match found {
        Match::Exact(keyword) => Some(keyword),
        Match::Abbreviation(keyword) => {
            let full = format!("*{}", keyword.name());
            note_abbreviation(&mut draft.log, &format!("*{}", word.raw), &full, word.span);
            Some(keyword)
        }
        Match::Ambiguous(found) => {
            let names: Vec<String> = found.iter().map(|k| format!("*{}", k.name())).collect();
            let message = format!("*{} may be {}", word.raw, names.join(" or "));
            draft.log.error("SL0203", message, word.span);
            unread(draft);
            None
        }
        Match::Unknown => unknown_keyword(card, draft),
    }
}

/// A keyword of another program: a note or an error, once for each cause.
fn not_read(other: &Other, span: Span, draft: &mut Draft) {
    let Other { name, treatment, help } = *other;
    if treatment == Treatment::Ignored {
        if matches!(name, "NONSTRUCTURAL MASS" | "MASS ADJUST") {
            draft.added_mass = Some(span);
        }
        if draft.log.first_time(&format!("ignored {name}")) {
            let message = format!("*{name} has no effect here and is ignored: {help}");
            draft.log.note("SL0257", message, span);
        }
        return;
    }
    unread(draft);
    draft.log.has_parameters |= treatment == Treatment::Parameters;
    if !draft.log.first_time(&format!("unsupported {name}")) {
        return;
    }
    let error = Diagnostic::error(Code("SL0221"), format!("*{name} is not supported")).at(span);
    draft.log.push(if help.is_empty() { error } else { error.help(help) });
}

/// An unknown keyword is read as the nearest known one, so that one slip
/// gives one error.
fn unknown_keyword(card: &Card, draft: &mut Draft) -> Option<&'static dyn Keyword> {
    let word = &card.keyword;
    let error = Diagnostic::error(Code("SL0201"), format!("*{} is not a known keyword", word.raw));
    let error = error.at(word.span);
    let compared = REGISTRY.iter().take(draft.log.names_to_compare());
    let Some(near) = nearest(&word.raw, compared.map(|keyword| keyword.name())) else {
        draft.log.push(error.help("`slideline explain` lists the keywords that are read"));
        unread(draft);
        return None;
    };
    draft.log.push(error.help(format!("did you mean *{near}?")).edit(word.span, near));
    REGISTRY.iter().find(|keyword| keyword.name() == near).copied()
}

fn unread(draft: &mut Draft) {
    draft.owner = Owner::Broken;
    draft.mark_all_incomplete();
}
