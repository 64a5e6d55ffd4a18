//! Expressions of responses: measures of histories, and arithmetic between them.
//!
//! ```text
//!   peak(RF2@PIVOT, 1) / max(U1@100)      a measure, a curve, its node; a step
//!   at(RF2@100, 0.5) - 2*push_in          a value at a time; a response before it
//! ```

use crate::curve::Curve;
use std::ops::Range;

/// What is measured on a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    Max,
    Min,
    /// Largest magnitude.
    Peak,
    Last,
    Roughness,
}

/// Totals of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Count {
    Increments,
    Iterations,
    Cutbacks,
    FibreStrain,
    /// Largest strain or stress over the allowable one.
    Utilisation,
    /// What is left of the allowable one, as a share of what is used.
    StrainMargin,
    /// 0 green, 1 amber, 2 red.
    Verdict,
}

/// An expression that was read. Curves are places in the list of all curves of the study.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Term {
    Number(f64),
    Parameter(usize),
    Response(usize),
    Count(Count),
    Measured(Measure, usize, Option<usize>),
    /// Value at a total time.
    At(usize, f64),
    /// Work of a force over a motion.
    Work([usize; 2], Option<usize>),
    Absolute(Box<Term>),
    Root(Box<Term>),
    Joined(char, Box<[Term; 2]>),
}

/// What a run must be watched for beside its curves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Watched {
    #[default]
    Curves,
    /// Shares of allowable strains and stresses.
    Limits,
    /// Everything that colours the verdict.
    Verdict,
}

impl Term {
    /// What it asks for.
    pub fn watched(&self) -> Watched {
        match self {
            Self::Count(Count::Verdict) => Watched::Verdict,
            Self::Count(Count::Utilisation | Count::StrainMargin) => Watched::Limits,
            Self::Absolute(inner) | Self::Root(inner) => inner.watched(),
            Self::Joined(_, both) => both[0].watched().max(both[1].watched()),
            _ => Watched::Curves,
        }
    }

    /// The last step that it names, 0 for none, and the latest total time [T].
    pub fn latest(&self) -> (usize, f64) {
        match self {
            Self::Measured(_, _, step) | Self::Work(_, step) => (step.unwrap_or(0), 0.0),
            Self::At(_, time) => (0, *time),
            Self::Absolute(inner) | Self::Root(inner) => inner.latest(),
            Self::Joined(_, both) => {
                let [a, b] = [both[0].latest(), both[1].latest()];
                (a.0.max(b.0), a.1.max(b.1))
            }
            Self::Number(_) | Self::Parameter(_) | Self::Response(_) | Self::Count(_) => (0, 0.0),
        }
    }
}

/// What stands against an expression, and where in it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Objection {
    pub message: String,
    pub place: Range<usize>,
}

/// Words that stand for something else than a parameter or a response.
pub(crate) const COUNTS: [(&str, Count); 7] = [
    ("increments", Count::Increments),
    ("iterations", Count::Iterations),
    ("cutbacks", Count::Cutbacks),
    ("fibre_strain", Count::FibreStrain),
    ("utilisation", Count::Utilisation),
    ("strain_margin", Count::StrainMargin),
    ("verdict", Count::Verdict),
];
const MEASURES: [(&str, Measure); 5] = [
    ("max", Measure::Max),
    ("min", Measure::Min),
    ("peak", Measure::Peak),
    ("last", Measure::Last),
    ("roughness", Measure::Roughness),
];
/// Brackets and signs within one another that are followed.
const DEEPEST: usize = 100;

/// Names that an expression may use, and the curves found so far.
pub(crate) struct Known<'a> {
    pub parameters: &'a [String],
    pub responses: &'a [String],
    /// With the place in the text where each is named first.
    pub curves: &'a mut Vec<(Curve, Range<usize>)>,
}

/// Reads an expression.
pub(crate) fn read(text: &str, known: Known<'_>) -> Result<Term, Objection> {
    let mut reader = Reader { text, at: 0, known, depth: 0 };
    let term = reader.sum()?;
    reader.skip();
    if reader.at < text.len() {
        return Err(reader.unexpected("the end, or an operator"));
    }
    Ok(term)
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    known: Known<'t>,
    depth: usize,
}

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn skip(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    fn takes(&mut self, sign: char) -> bool {
        self.skip();
        let found = self.rest().starts_with(sign);
        self.at += if found { sign.len_utf8() } else { 0 };
        found
    }

    /// Takes as many letters as suit.
    fn word(&mut self, suits: impl Fn(char) -> bool) -> (&'t str, Range<usize>) {
        self.skip();
        let rest = self.rest();
        let end = rest.find(|letter| !suits(letter)).unwrap_or(rest.len());
        let place = self.at..self.at + end;
        self.at += end;
        (&rest[..end], place)
    }

    fn unexpected(&self, wanted: &str) -> Objection {
        let next = self.rest().chars().next();
        let found = next.map_or("it ends".to_owned(), |next| format!("`{next}` stands there"));
        let end = self.at + next.map_or(0, char::len_utf8);
        Objection { message: format!("{wanted} is expected, but {found}"), place: self.at..end }
    }

    fn needs(&mut self, sign: char) -> Result<(), Objection> {
        if self.takes(sign) { Ok(()) } else { Err(self.unexpected(&format!("`{sign}`"))) }
    }

    fn sum(&mut self) -> Result<Term, Objection> {
        self.depth += 1;
        if self.depth > DEEPEST {
            let message = "it is nested too deeply".to_owned();
            return Err(Objection { message, place: self.at..self.at });
        }
        let mut term = self.product()?;
        while let Some(sign) = ['+', '-'].into_iter().find(|&sign| self.takes(sign)) {
            term = Term::Joined(sign, Box::new([term, self.product()?]));
        }
        self.depth -= 1;
        Ok(term)
    }

    fn product(&mut self) -> Result<Term, Objection> {
        let mut term = self.signed()?;
        while let Some(sign) = ['*', '/'].into_iter().find(|&sign| self.takes(sign)) {
            term = Term::Joined(sign, Box::new([term, self.signed()?]));
        }
        Ok(term)
    }

    fn signed(&mut self) -> Result<Term, Objection> {
        if self.takes('-') {
            return Ok(Term::Joined('-', Box::new([Term::Number(0.0), self.single()?])));
        }
        self.single()
    }

    fn single(&mut self) -> Result<Term, Objection> {
        if self.takes('(') {
            let term = self.sum()?;
            self.needs(')')?;
            return Ok(term);
        }
        match self.rest().chars().next() {
            Some(first) if first.is_ascii_digit() || first == '.' => {
                self.number().map(Term::Number)
            }
            Some(first) if is_letter(first) => self.named(),
            _ => Err(self.unexpected("a number, a name or a bracket")),
        }
    }

    fn number(&mut self) -> Result<f64, Objection> {
        self.skip();
        let rest = self.rest().as_bytes();
        let suits = |at: usize| match rest[at] {
            b'0'..=b'9' | b'.' | b'e' | b'E' => true,
            b'+' | b'-' => at == 0 || matches!(rest[at - 1], b'e' | b'E'),
            _ => false,
        };
        let end = (0..rest.len()).find(|&at| !suits(at)).unwrap_or(rest.len());
        let (text, place) = (&self.rest()[..end], self.at..self.at + end);
        self.at += end;
        match text.parse() {
            Ok(number) if f64::is_finite(number) => Ok(number),
            _ => Err(Objection { message: format!("`{text}` is not a number"), place }),
        }
    }

    fn named(&mut self) -> Result<Term, Objection> {
        let (word, place) = self.word(is_in_name);
        if self.takes('(') {
            let term = self.function(word, place)?;
            self.needs(')')?;
            return Ok(term);
        }
        let of = |names: &[String]| names.iter().position(|name| name == word);
        let counted = COUNTS.iter().find(|(name, _)| *name == word).map(|(_, of)| Term::Count(*of));
        counted
            .or_else(|| of(self.known.parameters).map(Term::Parameter))
            .or_else(|| of(self.known.responses).map(Term::Response))
            .ok_or_else(|| self.unknown(word, place))
    }

    fn unknown(&self, word: &str, place: Range<usize>) -> Objection {
        let counts = COUNTS.iter().map(|(name, _)| *name);
        let own = self.known.parameters.iter().chain(self.known.responses).map(String::as_str);
        let near = slideline::deck::nearest(word, counts.chain(own));
        let near = near.map_or_else(String::new, |near| format!("; did you mean {near}?"));
        let message =
            format!("`{word}` is no parameter of the study and no response before this one{near}");
        Objection { message, place }
    }

    fn function(&mut self, word: &str, place: Range<usize>) -> Result<Term, Objection> {
        if let Some((_, measure)) = MEASURES.iter().find(|(name, _)| *name == word) {
            return Ok(Term::Measured(*measure, self.curve()?, self.step()?));
        }
        match word {
            "at" => {
                let curve = self.curve()?;
                self.needs(',')?;
                Ok(Term::At(curve, self.number()?))
            }
            "work" => {
                let force = self.curve()?;
                self.needs(',')?;
                Ok(Term::Work([force, self.curve()?], self.step()?))
            }
            "abs" => Ok(Term::Absolute(Box::new(self.sum()?))),
            "sqrt" => Ok(Term::Root(Box::new(self.sum()?))),
            _ => {
                let all = "max, min, peak, last, roughness, at, work, abs and sqrt";
                let message = format!("there is no function {word}; there are {all}");
                Err(Objection { message, place })
            }
        }
    }

    /// The number of a step, from 1, where one is said.
    fn step(&mut self) -> Result<Option<usize>, Objection> {
        if !self.takes(',') {
            return Ok(None);
        }
        let (text, place) = self.word(|letter| letter.is_ascii_digit());
        match text.parse() {
            Ok(step) if step > 0 => Ok(Some(step)),
            _ => {
                let message = "the number of a step is expected, from 1".to_owned();
                Err(Objection { message, place })
            }
        }
    }

    fn curve(&mut self) -> Result<usize, Objection> {
        let (word, place) = self.word(is_in_name);
        let whose = if self.takes('@') { Some(self.owner()?) } else { None };
        let Some(curve) = Curve::named(word, whose) else {
            let message = format!(
                "`{word}` is no history: of a node there are U1, U2, U3, UR1 ... and RF1, RF2, RF3, \
                 RM1 ..., of a contact pair normal_force and the columns of JOB.pair.csv, then @ and \
                 the node or the pair, such as RF2@100; without @ the columns of JOB.energy.csv"
            );
            return Err(Objection { message, place });
        };
        match (curve.has_owner(), whose) {
            (true, None) => Err(self.unexpected("`@` and the node or the contact pair")),
            (false, Some(_)) => {
                let message = format!("`{word}` belongs to the whole model: leave @ out");
                Err(Objection { message, place: place.start..self.at })
            }
            _ => Ok(self.place_of(curve, place.start..self.at)),
        }
    }

    /// A label or a name, in quotation marks or without.
    fn owner(&mut self) -> Result<&'t str, Objection> {
        if self.takes('\'') {
            let (name, _) = self.word(|letter| letter != '\'');
            self.needs('\'')?;
            return Ok(name);
        }
        let (name, _) = self.word(|letter| is_in_name(letter) || letter == '-');
        match name.is_empty() {
            true => Err(self.unexpected("a label or a name")),
            false => Ok(name),
        }
    }

    fn place_of(&mut self, curve: Curve, place: Range<usize>) -> usize {
        let curves = &mut self.known.curves;
        curves.iter().position(|(own, _)| *own == curve).unwrap_or_else(|| {
            curves.push((curve, place));
            curves.len() - 1
        })
    }
}

fn is_letter(letter: char) -> bool {
    letter.is_ascii_alphabetic() || letter == '_'
}

fn is_in_name(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// Whether a word can name a response.
pub(crate) fn is_name(word: &str) -> bool {
    word.starts_with(is_letter) && word.chars().all(is_in_name)
}
