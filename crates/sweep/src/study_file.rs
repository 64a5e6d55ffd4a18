//! The study as a text: TOML with places, every error in one go.

use crate::design::Kind;
use crate::layout::{Layout, Parameter};
use crate::places::Places;
use crate::spread::{Number, Spread};
use crate::study::Study;
use slideline::deck::nearest;
use slideline::diag::{Code, Diagnostic, FileId, Sources, Span};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

type Value<'a> = Spanned<DeValue<'a>>;

/// A study as its file says it.
#[derive(Clone, Debug)]
pub struct StudyFile {
    /// The deck.
    pub deck: PathBuf,
    /// What varies, and what is asked for.
    pub study: Study,
    /// Names of the parameters and where they stand.
    pub parameters: Vec<(String, Span)>,
    /// Names of the responses, and of their derivatives behind them where these are asked for.
    pub responses: Vec<String>,
}

/// Words of the first level.
const WORDS: [&str; 8] =
    ["deck", "design", "cases", "seed", "gradients", "parameters", "correlated", "responses"];
const KINDS: [(&str, Kind); 6] = [
    ("grid", Kind::Grid),
    ("together", Kind::Together),
    ("random", Kind::Random),
    ("latin", Kind::Latin),
    ("sobol", Kind::Sobol),
    ("saltelli", Kind::Saltelli),
];

/// Reads a study; its deck is beside it. The text is added to `sources`.
///
/// # Errors
/// Everything that stands against it: a file that cannot be read (SL0701), what is no study
/// (SL0806), values and layouts that cannot be (SL0803), responses (SL0804), gradients (SL0809).
pub fn read_study(path: &Path, sources: &mut Sources) -> Result<StudyFile, Vec<Diagnostic>> {
    let text = std::fs::read_to_string(path).map_err(|reason| {
        let message = format!("the study {} cannot be read: {reason}", path.display());
        vec![Diagnostic::error(Code("SL0701"), message).help("Name an existing study file.")]
    })?;
    read_study_text(path, &text, sources)
}

/// Reads the text of a study as if it stood at `path`. The text is added to `sources`.
///
/// # Errors
/// Those of [`read_study`], but of the file.
pub fn read_study_text(
    path: &Path,
    text: &str,
    sources: &mut Sources,
) -> Result<StudyFile, Vec<Diagnostic>> {
    let file = sources.add(path.display().to_string(), text);
    let mut reader = Reader { file, said: Vec::new() };
    let (table, errors) = DeTable::parse_recoverable(text);
    for error in &errors {
        let place = error.span().unwrap_or(0..0);
        reader.refuse("SL0806", error.message(), place, "Mend the line: a study is a TOML file.");
    }
    if !errors.is_empty() {
        return Err(reader.said);
    }
    let study = reader.study(path, table.get_ref(), sources);
    study.filter(|_| reader.said.is_empty()).ok_or(reader.said)
}

/// Names of responses, and of their derivatives by all parameters behind them.
fn with_gradients(mut responses: Vec<String>, parameters: &[String]) -> Vec<String> {
    let by = |response: &String| {
        let name = |parameter: &String| format!("d({response})/d({parameter})");
        parameters.iter().map(name).collect::<Vec<_>>()
    };
    let rates: Vec<String> = responses.iter().flat_map(by).collect();
    responses.extend(rates);
    responses
}

struct Reader {
    file: FileId,
    said: Vec<Diagnostic>,
}

impl Reader {
    fn span(&self, place: Range<usize>) -> Span {
        Span::new(self.file, place.start, place.end)
    }

    fn refuse(&mut self, code: &'static str, message: &str, place: Range<usize>, help: &str) {
        let said = Diagnostic::error(Code(code), message).at(self.span(place)).help(help);
        self.said.push(said);
    }

    fn study(
        &mut self,
        path: &Path,
        table: &DeTable<'_>,
        sources: &mut Sources,
    ) -> Option<StudyFile> {
        self.only_known(table, &WORDS);
        let gradients = self.gradients(table);
        let (parameters, spans) = self.parameters(table);
        let (responses, values) = self.responses(table);
        let layout = self.layout(table, &parameters);
        let Some(deck) = table.get("deck") else {
            self.missing("deck", "deck = \"snapfit.inp\"");
            return None;
        };
        let deck = path.parent().unwrap_or(Path::new("")).join(self.text(deck)?);
        let layout = layout.filter(|_| self.said.is_empty())?;
        let names: Vec<String> = parameters.iter().map(|own| own.name.clone()).collect();
        let places = Places { file: self.file, first: sources.files().len(), values };
        match Study::new(parameters, &layout, &responses, sources) {
            Ok(mut study) => {
                let own = study.places.iter_mut();
                own.for_each(|place| *place = places.in_file(*place, sources));
                let own = study.responses.iter_mut();
                own.for_each(|own| own.place = places.in_file(own.place, sources));
                let mut responses: Vec<String> =
                    responses.into_iter().map(|(name, _)| name).collect();
                if gradients {
                    study = study.with_gradients();
                    responses = with_gradients(responses, &names);
                }
                let parameters = names.into_iter().zip(spans).collect();
                Some(StudyFile { deck, study, parameters, responses })
            }
            Err(said) => {
                let named = |name: &String| said.message.contains(&format!("parameter {name} "));
                let place = names.iter().position(named).map(|place| spans[place]);
                let design = table
                    .get("design")
                    .or(table.get("parameters"))
                    .map(|own| self.span(own.span()));
                let own = said.span.map(|own| places.in_file(own, sources));
                self.said.push(said.at(own.or(place).or(design)));
                None
            }
        }
    }

    fn gradients(&mut self, table: &DeTable<'_>) -> bool {
        let Some(value) = table.get("gradients") else { return false };
        value.get_ref().as_bool().unwrap_or_else(|| {
            let help = "Write `gradients = true` for the derivatives of all responses.";
            self.refuse("SL0809", "gradients are true or false", value.span(), help);
            false
        })
    }

    fn missing(&mut self, word: &str, example: &str) {
        let help = format!("Write a line such as `{example}`.");
        self.refuse("SL0806", &format!("the study has no {word}"), 0..0, &help);
    }

    fn only_known(&mut self, table: &DeTable<'_>, words: &[&str]) {
        for key in table.keys().filter(|key| !words.contains(&key.get_ref().as_ref())) {
            let near = nearest(key.get_ref(), words.iter().copied());
            let near = near.map_or_else(String::new, |near| format!("Did you mean {near}? "));
            let help = format!("{near}Here may stand: {}.", words.join(", "));
            let message = format!("the study knows no `{}` here", key.get_ref());
            self.refuse("SL0806", &message, key.span(), &help);
        }
    }

    fn text<'v>(&mut self, value: &'v Value<'_>) -> Option<&'v str> {
        let text = value.get_ref().as_str();
        if text.is_none() {
            self.wrong(value, "a text in quotation marks");
        }
        text
    }

    fn wrong(&mut self, value: &Value<'_>, wanted: &str) {
        let message = format!("{wanted} is expected here, not a {}", value.get_ref().type_str());
        self.refuse("SL0806", &message, value.span(), &format!("Write {wanted}."));
    }

    fn table<'v, 'a>(&mut self, table: &'v DeTable<'a>, word: &str) -> Option<&'v DeTable<'a>> {
        let value = table.get(word)?;
        let own = value.get_ref().as_table();
        if own.is_none() {
            self.wrong(value, "a table");
        }
        own
    }

    fn number(&mut self, value: &Value<'_>) -> Option<Number> {
        let found = match value.get_ref() {
            DeValue::Integer(own) => {
                i64::from_str_radix(own.as_str(), own.radix()).ok().map(Number::Whole)
            }
            DeValue::Float(own) => {
                own.as_str().parse().ok().filter(|n: &f64| n.is_finite()).map(Number::Real)
            }
            _ => None,
        };
        if found.is_none() {
            self.wrong(value, "a finite number");
        }
        found
    }

    fn real(&mut self, table: &DeTable<'_>, word: &str) -> Option<f64> {
        let value = table.get(word)?;
        self.number(value).map(Number::real)
    }

    fn count(&mut self, value: &Value<'_>) -> Option<u64> {
        match self.number(value)? {
            Number::Whole(count) if count >= 0 => Some(count.unsigned_abs()),
            _ => {
                self.refuse(
                    "SL0806",
                    "a whole number is expected here",
                    value.span(),
                    "Write a whole number, not below 0.",
                );
                None
            }
        }
    }

    fn parameters(&mut self, table: &DeTable<'_>) -> (Vec<Parameter>, Vec<Span>) {
        let Some(own) = self.table(table, "parameters").filter(|own| !own.is_empty()) else {
            self.missing("parameters", "parameters.mu = [0.1, 0.2, 0.3]");
            return (Vec::new(), Vec::new());
        };
        let mut found = (Vec::new(), Vec::new());
        for (key, value) in own {
            if let Some(spread) = self.spread(value) {
                found.0.push(Parameter { name: key.get_ref().to_string(), spread });
                found.1.push(self.span(key.span()));
            }
        }
        found
    }

    fn spread(&mut self, value: &Value<'_>) -> Option<Spread> {
        if let Some(list) = value.get_ref().as_array() {
            let numbers: Vec<Number> = list.iter().filter_map(|own| self.number(own)).collect();
            return (numbers.len() == list.len()).then_some(Spread::List(numbers));
        }
        let Some(table) = value.get_ref().as_table() else {
            return self.number(value).map(|number| Spread::List(vec![number]));
        };
        let before = self.said.len();
        self.only_known(table, &["from", "to", "count", "mean", "deviation"]);
        let said = ["from", "to", "mean", "deviation"].map(|word| self.real(table, word));
        let count = table.get("count").and_then(|count| self.count(count));
        if self.said.len() > before {
            return None;
        }
        let found = distribution(said, count);
        if found.is_none() {
            let help = "Write { from, to }, { from, to, count }, { mean, deviation } or \
                        { mean, deviation, from, to }.";
            self.refuse("SL0803", "values that are no distribution", value.span(), help);
        }
        found
    }

    /// Names and expressions, and where these stand.
    fn responses(&mut self, table: &DeTable<'_>) -> (Vec<(String, String)>, Vec<Range<usize>>) {
        let Some(own) = self.table(table, "responses").filter(|own| !own.is_empty()) else {
            self.missing("responses", "responses.force = \"peak(RF2@100)\"");
            return (Vec::new(), Vec::new());
        };
        let mut found = (Vec::new(), Vec::new());
        for (key, value) in own {
            let name = key.get_ref().to_string();
            if ["case", "code"].contains(&name.as_str()) {
                let message = format!("no response can be named {name}");
                let help = "These columns are there already: choose another name.";
                self.refuse("SL0804", &message, key.span(), help);
            }
            if let Some(text) = self.text(value).map(str::to_owned) {
                found.0.push((name, text));
                found.1.push(value.span());
            }
        }
        found
    }

    fn layout(&mut self, table: &DeTable<'_>, parameters: &[Parameter]) -> Option<Layout> {
        let kind = self.kind(table)?;
        let seed = table.get("seed").map_or(Some(0), |seed| self.count(seed))?;
        let cases = table.get("cases");
        let is_counted = matches!(kind, Kind::Grid | Kind::Together);
        if let (Some(cases), true) = (cases, is_counted) {
            let help = "Leave the line out, or say design = \"latin\".";
            let message = "the number of cases follows from the values here";
            self.refuse("SL0806", message, cases.span(), help);
        }
        let cases = match cases {
            Some(cases) => self.count(cases)?,
            None if is_counted => 0,
            None => {
                self.missing("number of cases", "cases = 1000");
                return None;
            }
        };
        let correlations = self.correlations(table, parameters);
        Some(Layout { kind, cases, seed, correlations })
    }

    fn kind(&mut self, table: &DeTable<'_>) -> Option<Kind> {
        let Some(value) = table.get("design") else { return Some(Kind::Grid) };
        let word = self.text(value)?;
        let found = KINDS.iter().find(|(name, _)| *name == word).map(|(_, kind)| *kind);
        if found.is_none() {
            let help = "Write grid, together, random, latin, sobol or saltelli.";
            self.refuse("SL0806", &format!("there is no design {word}"), value.span(), help);
        }
        found
    }

    /// The matrix of correlations; empty where there are none.
    fn correlations(&mut self, table: &DeTable<'_>, all: &[Parameter]) -> Vec<Vec<f64>> {
        let Some(value) = table.get("correlated") else { return Vec::new() };
        let Some(list) = value.get_ref().as_array() else {
            self.wrong(value, "[[correlated]] with between and coefficient");
            return Vec::new();
        };
        let mut matrix: Vec<Vec<f64>> = (0..all.len())
            .map(|i| (0..all.len()).map(|j| f64::from(u8::from(i == j))).collect())
            .collect();
        for own in list.iter() {
            if let Some(([i, j], coefficient)) = self.correlation(own, all) {
                (matrix[i][j], matrix[j][i]) = (coefficient, coefficient);
            }
        }
        matrix
    }

    fn correlation(&mut self, value: &Value<'_>, all: &[Parameter]) -> Option<([usize; 2], f64)> {
        let Some(table) = value.get_ref().as_table() else {
            self.wrong(value, "a table");
            return None;
        };
        self.only_known(table, &["between", "coefficient"]);
        let coefficient = self.real(table, "coefficient").filter(|own| own.abs() < 1.0);
        let between = table.get("between").and_then(|own| own.get_ref().as_array());
        let places: Vec<usize> = between
            .into_iter()
            .flat_map(|own| own.iter())
            .filter_map(|own| {
                all.iter().position(|known| Some(known.name.as_str()) == own.get_ref().as_str())
            })
            .collect();
        match (<[usize; 2]>::try_from(&places[..]), coefficient) {
            (Ok([i, j]), Some(coefficient)) if i != j => Some(([i, j], coefficient)),
            _ => {
                let help = "Write between = [\"a\", \"b\"] with two parameters of the study, and a \
                            coefficient between -1 and 1.";
                self.refuse("SL0803", "a correlation that is none", value.span(), help);
                None
            }
        }
    }
}

/// The distribution of first, last, mean and deviation.
fn distribution(said: [Option<f64>; 4], count: Option<u64>) -> Option<Spread> {
    let within = match said {
        [Some(from), Some(to), ..] => Some([from, to]),
        [None, None, ..] => None,
        _ => return None,
    };
    match (within, said[2], said[3], count) {
        (Some(ends), None, None, None) => Some(Spread::Uniform(ends)),
        (Some(ends), None, None, Some(count)) => Some(Spread::Levels { ends, count }),
        (within, Some(mean), Some(deviation), None) => {
            Some(Spread::Normal { mean, deviation, within })
        }
        _ => None,
    }
}
