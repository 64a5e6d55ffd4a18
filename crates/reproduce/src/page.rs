//! `diehl1995.html`: the paper's argument with our numbers, on one page.
//!
//! ```text
//!   page.html   words, and places such as {{isl immediate linear 2}}
//!                 model, run, measure, decimals --> row of the table --> number
//! ```

use crate::cases::{FINE, FRICTION, INCREMENTS, ModelKind, Stick};
use crate::figures::{self, Figure};
use crate::fine::{self, Errors};
use crate::study::Study;
use crate::table::Row;
use crate::theory::{THEORIES, Theory};
use slideline::Onset;
use slideline::output::report::filled;
use slideline_figures::escaped;
use slideline_theory::FirstProblem;

/// What a page cannot say.
const DASH: &str = "\u{2013}";

/// The whole page.
pub(crate) fn page(study: &Study, rows: &[Row], figures: &[Figure]) -> String {
    let page = Page { study, rows, figures };
    filled(include_str!("page.html"), |place| page.place(place))
}

struct Page<'a> {
    study: &'a Study,
    rows: &'a [Row],
    figures: &'a [Figure],
}

impl Page<'_> {
    /// What stands in a place of the template.
    fn place(&self, place: &str) -> Option<String> {
        let words: Vec<&str> = place.split(' ').collect();
        Some(match words[..] {
            ["version"] => slideline::VERSION.to_owned(),
            ["runs"] => self.rows.len().to_string(),
            ["increments"] => INCREMENTS.to_string(),
            ["fine", "increments"] => FINE.to_string(),
            ["friction"] => FRICTION.to_string(),
            ["rows", "of", "formulations"] => self.formulations(),
            ["rows", "of", "theories"] => self.theories(),
            ["rows", "of", "runs"] => self.runs(),
            ["algorithms", "apart"] => self.algorithms_apart(),
            ["cutbacks"] => match self.rows.iter().map(|row| row.cutbacks).sum() {
                0_usize => "none".to_owned(),
                cutbacks => cutbacks.to_string(),
            },
            ["worst", "increment"] => figures::worst_increment(self.study)?.to_string(),
            ["turns", model] => self.errors(self::model(model)?, 0.0)?.reversals.to_string(),
            [name] => self.figure(name)?,
            [.., decimals] => {
                let number = self.number(&words[..words.len() - 1]);
                number.map_or(DASH.to_owned(), |number| fixed(number, decimals))
            }
            [] => return None,
        })
    }

    /// A number of the study, as the template asks for it.
    fn number(&self, words: &[&str]) -> Option<f64> {
        let problem = FirstProblem::diehl();
        let half_angle = 2f64.to_radians();
        Some(match *words {
            ["most", "iterations"] => {
                self.rows.iter().map(|row| row.mean_iterations).fold(0.0, f64::max)
            }
            ["tilt", model] => {
                let [irs, isl, integrated] = figures::tilts(self.study)?;
                match model {
                    "irs" => irs.abs(),
                    "isl" => isl.abs(),
                    _ => integrated.abs(),
                }
            }
            ["largest", model] => self.errors(self::model(model)?, 0.0)?.largest,
            ["half", "element"] => 0.5e3 * problem.beam.length() / 24.0,
            ["half", "spacing"] => 1e3 * problem.radius * half_angle.sin(),
            ["sagitta"] => 1e6 * problem.radius * (1.0 - half_angle.cos()),
            // contact begins at the clearance c0: h = c0 - s^2/2r of a straight beam
            ["closed", "length"] => 2e3 * (2.0 * problem.radius * problem.law.clearance).sqrt(),
            [model, run, measure] => {
                let (model, (stick, onset)) = (self::model(model)?, self::run(run)?);
                let mut rows = self.rows.iter().filter(|row| row.case.model == model);
                let row = rows.find(|row| row.case.stick == stick && row.case.onset == onset)?;
                self::measure(row, measure)?
            }
            _ => return None,
        })
    }

    fn figure(&self, name: &str) -> Option<String> {
        let figure = self.figures.iter().find(|figure| figure.name == name)?;
        let title = match name {
            "linear_theory" => "Linear theory against exact references.".to_owned(),
            "formulations" => "Errors of three formulations.".to_owned(),
            _ => format!("Figure {}.", name.trim_matches(char::is_alphabetic)),
        };
        let (svg, caption) = (figure.scene.svg(), escaped(&figure.caption));
        Some(format!(
            "<figure id=\"{name}\">\n{svg}<figcaption><b>{title}</b> {caption}</figcaption>\n\
             </figure>"
        ))
    }

    /// How far penalty and Lagrange are apart in the first problem, in words.
    fn algorithms_apart(&self) -> String {
        let mut most: f64 = 0.0;
        for model in [ModelKind::IrsCoarse, ModelKind::IrsFine, ModelKind::Isl] {
            let of = |stick| self.study.curve(model, stick, Onset::Immediate);
            if let (Some(a), Some(b)) = (of(Stick::Penalty), of(Stick::Lagrange)) {
                for (a, b) in a.reactions().iter().zip(b.reactions()) {
                    most = most.max((a - b).abs());
                }
            }
        }
        if most == 0.0 {
            "to the last digit, for every point slides in every increment".to_owned()
        } else {
            format!("at most {most:.0e} N apart")
        }
    }

    fn errors(&self, model: ModelKind, friction: f64) -> Option<&Errors> {
        let mut fine = self.study.fine.iter();
        fine.find(|errors| errors.model == model && errors.friction == friction)
    }

    /// RMS, largest error, roughness and reversals in small increments.
    fn formulations(&self) -> String {
        let both = [0.0, FRICTION].into_iter();
        let all = both.flat_map(|friction| fine::MODELS.map(|model| (model, friction)));
        let rows = all.filter_map(|(model, friction)| {
            let errors = self.errors(model, friction)?;
            let numbers = [(errors.rms, "3"), (errors.largest, "2"), (errors.roughness, "4")];
            let numbers = numbers.map(|(number, decimals)| fixed(number, decimals));
            let first = [model.name().to_owned(), friction.to_string()];
            Some(row(first.into_iter().chain(numbers).chain([errors.reversals.to_string()])))
        });
        rows.collect()
    }

    /// Force at the end of the stroke by theory, and how far linear theory is off.
    fn theories(&self) -> String {
        let rows = THEORIES.into_iter().map(|theory| {
            let numbers = [0.0, FRICTION].map(|friction| {
                let last = |theory| {
                    let values = self.study.references.get(ModelKind::Isl, theory, friction);
                    values.last().copied().unwrap_or(f64::NAN)
                };
                let (linear, exact) = (last(Theory::Linear), last(theory));
                [fixed(exact, "3"), fixed(100.0 * (linear / exact - 1.0), "2")]
            });
            row([words(theory).to_owned()].into_iter().chain(numbers.into_iter().flatten()))
        });
        rows.collect()
    }

    fn runs(&self) -> String {
        let rows = self.rows.iter().map(|own| {
            let called = match own.case.stick {
                Stick::Frictionless => DASH,
                _ => slideline::output::onset_word(own.case.onset),
            };
            let first = [own.case.model.name(), own.case.stick.word(), called].map(str::to_owned);
            let errors = [own.linear, own.softened, own.continuum].into_iter().flatten();
            let errors = errors.chain([own.roughness]).map(|value| fixed(value, "2"));
            let last = [
                own.reversals.to_string(),
                fixed(own.work_ratio, "3"),
                own.friction_kept.map_or_else(|| DASH.to_owned(), |kept| fixed(kept, "1")),
                fixed(own.mean_iterations, "2"),
                own.dropped_points.to_string(),
            ];
            row(first.into_iter().chain(errors).chain(last))
        });
        rows.collect()
    }
}

/// A row of a table.
fn row(cells: impl Iterator<Item = String>) -> String {
    format!("<tr>{}</tr>\n", cells.map(|cell| format!("<td>{cell}</td>")).collect::<String>())
}

fn model(word: &str) -> Option<ModelKind> {
    const WORDS: [&str; 7] = ["irs", "fine", "isl", "integrated", "cam", "wide", "integrated-cam"];
    Some(ModelKind::ALL[WORDS.iter().position(|own| *own == word)?])
}

fn run(word: &str) -> Option<(Stick, Onset)> {
    match word {
        "none" => Some((Stick::Frictionless, Onset::Immediate)),
        "immediate" => Some((Stick::Penalty, Onset::Immediate)),
        "lagrange" => Some((Stick::Lagrange, Onset::Immediate)),
        "matfru" => Some((Stick::Penalty, Onset::Matfru)),
        _ => None,
    }
}

fn measure(row: &Row, word: &str) -> Option<f64> {
    match word {
        "linear" => Some(row.linear[0]),
        "linear-most" => Some(row.linear[1]),
        "softened" => Some(row.softened[0]),
        "softened-most" => Some(row.softened[1]),
        "continuum" => Some(row.continuum[0]),
        "roughness" => Some(row.roughness),
        "reversals" => Some(row.reversals as f64),
        "iterations" => Some(row.mean_iterations),
        "dropped" => Some(row.dropped_points as f64),
        "kept" => row.friction_kept,
        _ => None,
    }
}

fn words(theory: Theory) -> &'static str {
    match theory {
        Theory::Linear => "linear (the paper's)",
        Theory::Elastica => "large deflections",
        Theory::Reissner => "and shear and stretching",
        Theory::Softened => "and softened contact at one point",
        Theory::Continuum => "and pressure along the beam",
    }
}

/// A number with so many decimals and a proper minus; never minus zero.
fn fixed(value: f64, decimals: &str) -> String {
    let text = format!("{value:.*}", decimals.parse().unwrap_or(0));
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        Some(digits) => format!("\u{2212}{digits}"),
        None => text,
    }
}
