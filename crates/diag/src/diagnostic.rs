//! What is to be said, to whom it may matter, and what to do.

use crate::source::Span;

/// A diagnostic's number, such as `SL0412`; never reused.
///
/// SL01xx syntax, SL02xx keyword meaning, SL03xx model consistency, SL04xx
/// unsound mechanics found before solving, SL05xx no convergence, SL06xx
/// suspicious result, SL07xx files, SL08xx studies and meshes, SL09xx our own fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code(pub &'static str);

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.0)
    }
}

/// How much it matters. Only errors change an exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// Something worth knowing.
    Note,
    /// Something that would be better otherwise.
    Advice,
    /// Something that is probably not meant.
    Warning,
    /// Something that cannot be done.
    Error,
}

impl Severity {
    /// The word used in messages and JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Advice => "advice",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// A second place that helps to understand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is to be seen there.
    pub text: String,
}

/// A certain mend: replace the text of `span`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What is replaced; an empty span inserts.
    pub span: Span,
    /// The new text.
    pub replacement: String,
}

/// One card that helps, and where it belongs. What knows the deck turns it
/// into an [`Edit`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// Where.
    pub place: Place,
    /// The card: keyword line and data lines, each ended by a line feed.
    pub text: String,
}

/// Where a suggested card belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In front of the card at that place.
    Before(Span),
    /// Behind the card at that place and its data; data lines prolong it.
    After(Span),
    /// Instead of the card at that place and its data.
    Instead(Span),
    /// Instead of the data of the card at that place, if they begin alike.
    Data(Span),
}

/// One thing to say about a deck, a model or a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its number.
    pub code: Code,
    /// Its weight.
    pub severity: Severity,
    /// What is the matter, one sentence, without a final stop.
    pub message: String,
    /// The primary place.
    pub span: Option<Span>,
    /// Second places.
    pub labels: Vec<Label>,
    /// What to do, one or two sentences.
    pub help: Option<String>,
    /// The mend itself, where it is certain.
    pub edit: Option<Edit>,
    /// The card that helps, where its edit has not been worked out.
    pub card: Option<Suggestion>,
}

impl Diagnostic {
    /// A diagnostic of any severity.
    pub fn new(severity: Severity, code: Code, message: impl Into<String>) -> Self {
        let message = message.into();
        let (span, labels, help, edit, card) = (None, Vec::new(), None, None, None);
        Self { code, severity, message, span, labels, help, edit, card }
    }

    /// An error.
    pub fn error(code: Code, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, message)
    }

    /// A warning.
    pub fn warning(code: Code, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, message)
    }

    /// An advice.
    pub fn advice(code: Code, message: impl Into<String>) -> Self {
        Self::new(Severity::Advice, code, message)
    }

    /// A note.
    pub fn note(code: Code, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, code, message)
    }

    /// The text of the card that helps, keyword line or data lines; none for
    /// mends within a line.
    pub fn suggestion(&self) -> Option<&str> {
        let edit = self.edit.as_ref().map(|edit| edit.replacement.as_str());
        let card = || self.card.as_ref().map(|card| card.text.as_str());
        edit.filter(|text| text.ends_with('\n')).or_else(card)
    }

    /// Says where.
    #[must_use]
    pub fn at(mut self, span: impl Into<Option<Span>>) -> Self {
        self.span = span.into();
        self
    }

    /// Points at a second place.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Suggests a card.
    #[must_use]
    pub fn card(mut self, place: Place, text: impl Into<String>) -> Self {
        self.card = Some(Suggestion { place, text: text.into() });
        self
    }

    /// Carries the mend.
    #[must_use]
    pub fn edit(mut self, span: Span, replacement: impl Into<String>) -> Self {
        self.edit = Some(Edit { span, replacement: replacement.into() });
        self
    }
}

/// Whether anything in the list forbids going on.
pub fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}
