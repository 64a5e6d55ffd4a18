//! The table of errors: how far every curve is from theory, and what it cost.

use crate::cases::{Case, Stick};
use crate::curve::Curve;
use crate::study::Study;
use crate::theory::Theory;
use slideline::Onset;
use slideline_measures as measures;
use std::fmt::Write as _;

/// Measures of one run.
#[derive(Clone, Debug)]
pub struct Row {
    /// The run.
    pub case: Case,
    /// RMS and largest difference from linear theory [% of its peak].
    pub linear: [f64; 2],
    /// RMS and largest difference from the shear-flexible beam with softened
    /// contact [% of its peak].
    pub softened: [f64; 2],
    /// RMS and largest difference from the shear-flexible beam with pressure
    /// spread along it [% of its peak].
    pub continuum: [f64; 2],
    /// Roughness against the exact reference of the model's kind, softened or
    /// continuum [% of its peak].
    pub roughness: f64,
    /// Changes of direction of the curve.
    pub reversals: usize,
    /// Changes of direction of the exact curve.
    pub reversals_exact: usize,
    /// Work over that of the exact curve [1].
    pub work_ratio: f64,
    /// Largest magnitude [F or F L].
    pub peak: f64,
    /// Share of the friction work that was kept [%]; `None` without friction.
    pub friction_kept: Option<f64>,
    /// Iterations an increment.
    pub mean_iterations: f64,
    /// Attempts that were given up.
    pub cutbacks: usize,
    /// Points and increments in which friction was not called.
    pub dropped_points: usize,
    /// Friction work not called [F L].
    pub dropped_work: f64,
}

/// One row a run. A measure that does not exist is NaN.
pub fn rows(study: &Study) -> Vec<Row> {
    study.curves.iter().map(|curve| row(study, curve)).collect()
}

fn row(study: &Study, curve: &Curve) -> Row {
    let case = curve.case;
    let (found, motions) = (curve.reactions(), curve.motions());
    let reference = |theory| study.references.get(case.model, theory, case.friction());
    let (linear, softened) = (reference(Theory::Linear), reference(Theory::Softened));
    let exact = reference(Theory::exact(case.model));
    let percent = |value: Option<f64>| 100.0 * value.unwrap_or(f64::NAN);
    let errors = |reference| {
        [measures::rms_error(&found, reference), measures::max_error(&found, reference)]
            .map(percent)
    };
    let count = curve.increments.len().max(1) as f64;
    Row {
        case,
        linear: errors(linear),
        softened: errors(softened),
        continuum: errors(reference(Theory::Continuum)),
        roughness: percent(measures::roughness_against(&found, exact)),
        reversals: measures::reversals(&found, measures::DEFAULT_NOISE_FLOOR),
        reversals_exact: measures::reversals(exact, measures::DEFAULT_NOISE_FLOOR),
        work_ratio: measures::work_ratio(&found, exact, &motions).unwrap_or(f64::NAN),
        peak: measures::maximum(&found).unwrap_or(f64::NAN),
        friction_kept: friction_kept(study, curve),
        mean_iterations: curve.increments.iter().map(|i| i.iterations).sum::<usize>() as f64
            / count,
        cutbacks: curve.totals.cutbacks,
        dropped_points: curve.totals.dropped_points,
        dropped_work: curve.dropped_work,
    }
}

/// Share of the work of friction, W(mu) - W(0), that a run did, in percent of
/// the run of the same model in which friction is called at once.
fn friction_kept(study: &Study, curve: &Curve) -> Option<f64> {
    let case = curve.case;
    if case.stick == Stick::Frictionless {
        return None;
    }
    let work = |curve: &Curve| measures::work(&curve.reactions(), &curve.motions());
    let none = work(study.curve(case.model, Stick::Frictionless, Onset::Immediate)?)?;
    let full = work(study.curve(case.model, case.stick, Onset::Immediate)?)?;
    Some(100.0 * (work(curve)? - none) / (full - none))
}

/// `errors.csv`.
pub fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "problem,model,deck,friction,stick,onset,rms_linear_percent,max_linear_percent,\
         rms_softened_percent,max_softened_percent,rms_continuum_percent,max_continuum_percent,\
         roughness_percent,reversals,reversals_exact,work_ratio,peak,friction_kept_percent,mean_iterations,cutbacks,\
         dropped_points,dropped_work\n",
    );
    for row in rows {
        let case = &row.case;
        let onset = slideline::output::onset_word(case.onset);
        // a String takes any text, here and below
        let _ = write!(
            text,
            "{},{},{},{},{},{onset}",
            case.model.problem(),
            case.model.name(),
            case.deck.name,
            case.friction(),
            case.stick.word(),
        );
        let errors = [row.linear, row.softened, row.continuum];
        for value in errors.into_iter().flatten().chain([row.roughness]) {
            let _ = write!(text, ",{value:.4}"); // as above
        }
        let _ = write!(
            text,
            ",{},{},{:.5},{:.6},{},{:.2},{},{},{:.6e}",
            row.reversals,
            row.reversals_exact,
            row.work_ratio,
            row.peak,
            row.friction_kept.map_or_else(String::new, |kept| format!("{kept:.3}")),
            row.mean_iterations,
            row.cutbacks,
            row.dropped_points,
            row.dropped_work,
        ); // as above
        text.push('\n');
    }
    text
}

/// `curves.csv`: every point of every curve, with theory beside it.
pub fn curves_csv(study: &Study) -> String {
    let mut text = String::from("deck,onset,increment,motion,reaction,linear,softened,continuum\n");
    for curve in &study.curves {
        let case = &curve.case;
        let onset = slideline::output::onset_word(case.onset);
        let reference = |theory| study.references.get(case.model, theory, case.friction());
        let theories = [Theory::Linear, Theory::Softened, Theory::Continuum].map(reference);
        for (place, row) in curve.increments.iter().enumerate() {
            let _ = write!(
                text,
                "{},{onset},{},{:?},{:?}",
                case.deck.name,
                place + 1,
                row.motion,
                row.reaction,
            ); // as above
            for values in theories {
                let _ = write!(text, ",{:?}", values.get(place).copied().unwrap_or(f64::NAN)); // as above
            }
            text.push('\n');
        }
    }
    text
}
