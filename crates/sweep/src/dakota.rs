//! What Dakota asks of a simulation, and the answer, as texts.
//!
//! ```text
//!   2 variables            { DAKOTA_VARS = 2 }
//!   1.5 thickness          { thickness = 1.5 }       Asked --Evaluator--> Row --> 0.79 push
//!   30.0 lead              { lead = 30.0 }
//!   1 functions            { DAKOTA_FNS = 1 }
//!   1 ASV_1:push           { ASV_1:push = 1 }
//! ```

use crate::case::Row;
use crate::spread::Number;
use crate::study_file::StudyFile;
use slideline::diag::{Code, Diagnostic, FileId, Sources, Span};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const HELP: &str = "Dakota writes such files: interface with fork, in its standard format or with \
                    aprepro.";

/// Bits of an active set.
const VALUE: u64 = 1;
const GRADIENT: u64 = 2;

type Found<T> = Result<T, Box<Diagnostic>>;

/// A file of parameters: what Dakota wants to know at which point.
#[derive(Clone, Debug)]
pub struct Asked {
    variables: Vec<(String, String, Span)>,
    /// Label, active set and place of every function.
    functions: Vec<(String, u64, Span)>,
    /// Variables by which derivatives are wanted.
    derivatives: Vec<String>,
    /// The study, where Dakota names it as its analysis component.
    pub study: Option<PathBuf>,
}

/// Reads a file of parameters in either format. The text is added to `sources`.
///
/// # Errors
/// A file that cannot be read (SL0701), or is none that Dakota writes (SL0820).
pub fn read_asked(path: &Path, sources: &mut Sources) -> Found<Asked> {
    let text = std::fs::read_to_string(path).map_err(|reason| {
        let message = format!("the parameters {} cannot be read: {reason}", path.display());
        Box::new(
            Diagnostic::error(Code("SL0701"), message).help("Name the file that Dakota wrote."),
        )
    })?;
    let file = sources.add(path.display().to_string(), text.as_str());
    let mut lines = Lines::of(file, &text)?;
    let count = lines.count(&["variables", "DAKOTA_VARS"])?;
    let variables = lines.take(count)?;
    let count = lines.count(&["functions", "DAKOTA_FNS"])?;
    let functions = lines.take(count)?.into_iter().map(function).collect::<Found<_>>()?;
    let count = lines.count(&["derivative_variables", "DAKOTA_DER_VARS"])?;
    let derivatives = lines.take(count)?.into_iter().map(derivative).collect::<Found<_>>()?;
    let count = lines.count(&["analysis_components", "DAKOTA_AN_COMPS"])?;
    let study = lines.take(count)?.into_iter().next();
    Ok(Asked { variables, functions, derivatives, study: study.map(|(_, value, _)| value.into()) })
}

/// A variable by which derivatives are wanted, by its label.
fn derivative((name, _, span): (String, String, Span)) -> Found<String> {
    let label = name.strip_prefix("DVV_").and_then(|rest| Some(rest.split_once(':')?.1.to_owned()));
    label.ok_or_else(|| refused("a variable is a line such as `1 DVV_1:thickness`".into(), span))
}

/// A function by its label, with its active set.
fn function((name, value, span): (String, String, Span)) -> Found<(String, u64, Span)> {
    let label = name.strip_prefix("ASV_").and_then(|rest| Some(rest.split_once(':')?.1.to_owned()));
    match (label, value.parse()) {
        (Some(label), Ok(active)) => Ok((label, active, span)),
        _ => Err(refused("a function is a line such as `1 ASV_1:push`".into(), span)),
    }
}

fn refused(message: String, span: Span) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(Code("SL0820"), message).at(span).help(HELP))
}

/// Names and values, line by line.
struct Lines {
    left: std::vec::IntoIter<(String, String, Span)>,
    end: Span,
}

impl Lines {
    fn of(file: FileId, text: &str) -> Found<Self> {
        let (mut left, mut begin) = (Vec::new(), 0);
        for line in text.split_inclusive('\n') {
            let span = Span::new(file, begin, begin + line.trim_end().len());
            begin += line.len();
            if line.trim().is_empty() {
                continue;
            }
            let (name, value) = pair(line.trim())
                .ok_or_else(|| refused("a line here has a value and a name".into(), span))?;
            left.push((name, value, span));
        }
        Ok(Self { left: left.into_iter(), end: Span::new(file, text.len(), text.len()) })
    }

    fn next(&mut self) -> Found<(String, String, Span)> {
        let ended = || refused("the file ends here: more lines were announced".into(), self.end);
        self.left.next().ok_or_else(ended)
    }

    /// The number of lines that follow of a kind.
    fn count(&mut self, names: &[&str]) -> Found<usize> {
        let (name, value, span) = self.next()?;
        let wanted = || refused(format!("the number of {} is expected here", names[0]), span);
        if names.contains(&name.as_str()) {
            value.parse().map_err(|_| wanted())
        } else {
            Err(wanted())
        }
    }

    fn take(&mut self, count: usize) -> Found<Vec<(String, String, Span)>> {
        let mut taken = Vec::new();
        for _ in 0..count {
            taken.push(self.next()?);
        }
        Ok(taken)
    }
}

/// Name and value of a line: `value name`, or `{ name = value }`.
fn pair(line: &str) -> Option<(String, String)> {
    let (name, value) = match line.strip_prefix('{') {
        Some(rest) => rest.strip_suffix('}')?.split_once('=')?,
        None => line.rsplit_once(char::is_whitespace).map(|(value, name)| (name, value))?,
    };
    let (name, value) = (name.trim(), value.trim().trim_matches('"'));
    (!name.is_empty() && !value.is_empty()).then(|| (name.to_owned(), value.to_owned()))
}

impl Asked {
    /// Values of the parameters of a study, in its order.
    ///
    /// # Errors
    /// A variable that the study does not have or that is no number, a parameter that has no
    /// value, a function that is no response, second derivatives (SL0820).
    pub fn point(&self, study: &StudyFile) -> Found<Vec<Number>> {
        let known: Vec<&str> = study.parameters.iter().map(|(name, _)| name.as_str()).collect();
        let strange = self.variables.iter().find(|(name, ..)| !known.contains(&name.as_str()));
        if let Some((name, _, span)) = strange {
            let message = format!("the study has no parameter {name}");
            let help = format!("Name the variables as it does: {}.", known.join(", "));
            return Err(Box::new(refused(message, *span).help(help)));
        }
        self.checked_functions(study)?;
        known.iter().map(|name| self.value(name)).collect()
    }

    fn value(&self, name: &str) -> Found<Number> {
        let Some((_, text, span)) = self.variables.iter().find(|(own, ..)| own == name) else {
            let message = format!("Dakota gives the parameter {name} of the study no value");
            let help = "Make it a variable of Dakota, or leave it out of the study.";
            return Err(Box::new(Diagnostic::error(Code("SL0820"), message).help(help)));
        };
        let real = || text.parse().ok().filter(|value: &f64| value.is_finite()).map(Number::Real);
        let number = text.parse().ok().map(Number::Whole).or_else(real);
        number.ok_or_else(|| refused(format!("{text} is no finite number"), *span))
    }

    fn checked_functions(&self, study: &StudyFile) -> Found<()> {
        let is_known = |own: &String| study.parameters.iter().any(|(name, _)| name == own);
        for (label, active, span) in &self.functions {
            if !study.responses.contains(label) {
                let message = format!("the study has no response {label}");
                let names = study.responses.join("' '");
                let help = format!("Write `descriptors '{names}'` below `responses`.");
                return Err(Box::new(refused(message, *span).help(help)));
            }
            let strange = self
                .derivatives
                .iter()
                .find(|own| !is_known(own))
                .filter(|_| active & GRADIENT > 0);
            if let Some(name) = strange {
                let message =
                    format!("Dakota asks for a derivative by {name}, no parameter of the study");
                return Err(refused(message, *span));
            }
            if *active > VALUE + GRADIENT {
                let message = format!("Dakota asks for second derivatives of {label}");
                let help = "Write `no_hessians`, or `quasi_hessians bfgs`.";
                return Err(Box::new(refused(message, *span).help(help)));
            }
        }
        Ok(())
    }

    /// Whether derivatives are wanted.
    pub fn wants_gradients(&self) -> bool {
        self.functions.iter().any(|(_, active, _)| active & GRADIENT > 0)
    }

    /// The derivatives of a response of a row; `None` where one is missing.
    fn gradient(&self, study: &StudyFile, place: usize, row: &Row) -> Option<String> {
        let (responses, parameters) = (study.study.responses.len(), &study.parameters);
        let mut text = "[".to_owned();
        for own in &self.derivatives {
            let by = parameters.iter().position(|(name, _)| name == own)?;
            let value = row.responses.get(responses + place * parameters.len() + by)?;
            let _ = write!(text, " {:e}", (*value)?); // a String takes any text
        }
        Some(text + " ]\n")
    }

    /// The text of the results: values of the functions in their order, their gradients, or `FAIL` and the code of
    /// what stands against the case, which Dakota takes for a failed evaluation.
    pub fn answer(&self, study: &StudyFile, row: &Row) -> String {
        let mut text = String::new();
        let place = |label: &String| study.responses.iter().position(|own| own == label);
        let fails = |label: &String| format!("FAIL {}\n", row.code.as_deref().unwrap_or(label));
        for (label, ..) in self.functions.iter().filter(|(_, active, _)| active & VALUE > 0) {
            let place = place(label);
            match place.and_then(|place| row.responses[place]) {
                // a String takes any text
                Some(value) => drop(writeln!(text, "{value:e} {label}")),
                None => return fails(label),
            }
        }
        for (label, ..) in self.functions.iter().filter(|(_, active, _)| active & GRADIENT > 0) {
            match place(label).and_then(|place| self.gradient(study, place, row)) {
                Some(gradient) => text.push_str(&gradient),
                None => return fails(label),
            }
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STANDARD: &str = "    2 variables\n 1.5e+00 thickness\n 30 lead\n 2 functions\n 1 ASV_1:push\n \
        0 ASV_2:pull\n 2 derivative_variables\n 1 DVV_1:thickness\n 2 DVV_2:lead\n \
        1 analysis_components\n my study.toml AC_1:slideline\n 7 eval_id\n";
    const APREPRO: &str = "{ DAKOTA_VARS = 2 }\n{ thickness = 1.5e+00 }\n{ lead = 30 }\n{ DAKOTA_FNS = 2 }\n\
        { ASV_1:push = 1 }\n{ ASV_2:pull = 0 }\n{ DAKOTA_DER_VARS = 2 }\n{ DVV_1:thickness = 1 }\n\
        { DVV_2:lead = 2 }\n{ DAKOTA_AN_COMPS = 1 }\n{ AC_1:slideline = \"my study.toml\" }\n\
        { DAKOTA_EVAL_ID = 7 }\n";
    const STUDY: &str = "deck = \"a.inp\"\nparameters = { lead = 1.0, thickness = 1.0 }\n\
        responses = { pull = \"peak(RF1@1)\", push = \"last(RF1@1)\" }\n";

    fn read(text: &str, name: &str) -> (Found<Asked>, StudyFile) {
        let path = std::env::temp_dir().join(format!("dakota-{}-{name}", std::process::id()));
        std::fs::write(&path, text).unwrap();
        let mut sources = Sources::default();
        let asked = read_asked(&path, &mut sources);
        std::fs::remove_file(&path).unwrap();
        let study = crate::read_study_text(Path::new("s.toml"), STUDY, &mut sources).unwrap();
        (asked, study)
    }

    /// Source: both formats as the manual of Dakota has them.
    #[test]
    fn both_formats_say_the_same() {
        for (text, name) in [(STANDARD, "standard"), (APREPRO, "aprepro")] {
            let (asked, study) = read(text, name);
            let asked = asked.unwrap();
            assert_eq!(asked.study, Some("my study.toml".into()));
            let point = asked.point(&study).unwrap();
            assert_eq!(point, [Number::Whole(30), Number::Real(1.5)]);
            let responses = vec![Some(3.0), Some(-0.25)];
            let row = Row { case: 0, values: vec![30.0, 1.5], responses, code: None };
            assert_eq!(asked.answer(&study, &row), "-2.5e-1 push\n");
            let failed = Row { responses: vec![None; 2], code: Some("SL0501".into()), ..row };
            assert_eq!(asked.answer(&study, &failed), "FAIL SL0501\n");
        }
    }

    /// Source: gradients stand in brackets behind all values, in the manual of Dakota.
    #[test]
    fn gradients_stand_behind_the_values() {
        let text = STANDARD.replace("1 ASV_1:push", "3 ASV_1:push");
        let (asked, study) = read(&text, "gradients");
        let asked = asked.unwrap();
        assert!(asked.wants_gradients() && asked.point(&study).is_ok());
        // pull and push, then each by lead and by thickness
        let responses = [3.0, -0.25, 1.0, 2.0, 3.0, 4.0].map(Some).to_vec();
        let row = Row { case: 0, values: vec![30.0, 1.5], responses, code: None };
        assert_eq!(asked.answer(&study, &row), "-2.5e-1 push\n[ 4e0 3e0 ]\n");
    }

    #[test]
    fn what_cannot_be_answered_is_told() {
        let cases = [
            ("ASV_1:push", "ASV_1:pish", "no response pish"),
            ("1 ASV_1:push", "5 ASV_1:push", "second derivatives of push"),
            ("30 lead", "30 load", "no parameter load"),
            ("30 lead", "steel lead", "no finite number"),
            ("2 variables\n", "1 variables\n", "number of functions"),
            ("2 variables\n", "200 variables\n", "file ends here"),
            ("2 variables\n", "variables\n", "a value and a name"),
        ];
        for (place, (old, new, told)) in cases.into_iter().enumerate() {
            let (asked, study) = read(&STANDARD.replace(old, new), &place.to_string());
            let said = asked.and_then(|asked| asked.point(&study)).unwrap_err();
            assert!(said.message.contains(told), "{}", said.message);
        }
    }
}
