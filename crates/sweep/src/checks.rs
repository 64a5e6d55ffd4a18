//! What stands against a layout, before hours are spent.

use crate::design::{Design, Kind, cases_a_point, factored};
use crate::layout::{Layout, MOST_CASES, Parameter};
use crate::sobol;
use crate::spread::Spread;
use slideline::Diagnostic;
use slideline::diag::Code;

type Checked<T> = Result<T, Box<Diagnostic>>;

fn refused(message: String, help: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(Code("SL0803"), message).help(help))
}

/// At least one parameter, each once.
pub(crate) fn checked_names(parameters: &[Parameter]) -> Checked<()> {
    if parameters.is_empty() {
        let help = "name a parameter of the deck and its values";
        return Err(refused("the study varies nothing".to_owned(), help));
    }
    for (place, own) in parameters.iter().enumerate() {
        if parameters[..place].iter().any(|earlier| earlier.name == own.name) {
            let message = format!("the parameter {} is varied twice", own.name);
            return Err(refused(message, "give all its values in one place"));
        }
    }
    Ok(())
}

/// Values that are finite, ends in order.
pub(crate) fn checked_spread(parameter: &Parameter) -> Checked<()> {
    let in_order = |ends: &[f64; 2]| ends.iter().all(|end| end.is_finite()) && ends[0] < ends[1];
    let fault = match &parameter.spread {
        Spread::List(values) if values.is_empty() => Some("a list without values"),
        Spread::List(values) if values.iter().any(|value| !value.real().is_finite()) => {
            Some("a value that is not finite")
        }
        Spread::Levels { count: 0 | 1, .. } => Some("levels of which there are fewer than two"),
        Spread::Levels { ends, .. } | Spread::Uniform(ends) if !in_order(ends) => {
            Some("a first value that is not below the last one")
        }
        Spread::Normal { mean, deviation, .. }
            if !mean.is_finite() || !deviation.is_finite() || *deviation <= 0.0 =>
        {
            Some("a deviation that is not positive, or a mean that is not finite")
        }
        Spread::Normal { within: Some(ends), .. } if !in_order(ends) => {
            Some("limits of which the first is not below the second")
        }
        _ => None,
    };
    fault.map_or(Ok(()), |fault| {
        let message = format!("the parameter {} has {fault}", parameter.name);
        Err(refused(message, "give finite numbers, the smaller one first"))
    })
}

/// The design of a layout that can be.
pub(crate) fn checked_design(parameters: &[Parameter], layout: &Layout) -> Checked<Design> {
    let cases = match layout.kind {
        Kind::Grid => checked_grid(&counts(parameters)?)?,
        Kind::Together => checked_lists(&counts(parameters)?)?,
        Kind::Random | Kind::Latin | Kind::Sobol | Kind::Saltelli => layout.cases,
    };
    if cases == 0 || cases > MOST_CASES {
        return Err(too_many(&cases.to_string()));
    }
    checked_directions(parameters.len(), layout.kind)?;
    if layout.kind == Kind::Saltelli {
        checked_points(cases, cases_a_point(parameters.len()), layout)?;
    }
    let factor = checked_correlations(parameters.len(), layout)?;
    Ok(Design { kind: layout.kind, cases, seed: layout.seed, factor })
}

/// Few enough for the sequence of Sobol, of which Saltelli's design takes two for each parameter.
fn checked_directions(parameters: usize, kind: Kind) -> Checked<()> {
    let directions = match kind {
        Kind::Sobol => parameters,
        Kind::Saltelli => 2 * parameters,
        Kind::Grid | Kind::Together | Kind::Random | Kind::Latin => 0,
    };
    if directions > sobol::MOST {
        let message = format!(
            "the sequence of Sobol is known in {} directions, and {directions} are needed",
            sobol::MOST
        );
        return Err(refused(message, "vary fewer parameters, or take a Latin hypercube"));
    }
    Ok(())
}

/// Whole points of Saltelli's design, of parameters that are independent.
fn checked_points(cases: u64, each: u64, layout: &Layout) -> Checked<()> {
    if !cases.is_multiple_of(each) {
        let message =
            format!("{cases} cases are no whole number of points, with {each} cases each");
        let next = each * cases.div_ceil(each);
        return Err(refused(message, &format!("say cases = {next}")));
    }
    if !layout.correlations.is_empty() {
        let message = "shares of the variance belong to independent parameters".to_owned();
        return Err(refused(message, "leave [[correlated]] out, or choose another design"));
    }
    Ok(())
}

/// Numbers of values of the parameters, which must be counted.
fn counts(parameters: &[Parameter]) -> Checked<Vec<u64>> {
    let count = |own: &Parameter| {
        own.spread.count().ok_or_else(|| {
            let message = format!("the parameter {} has a distribution, no values", own.name);
            refused(message, "give it a list or levels, or lay the cases out at random")
        })
    };
    parameters.iter().map(count).collect()
}

fn checked_grid(counts: &[u64]) -> Checked<u64> {
    let all = counts.iter().try_fold(1_u64, |all, &count| all.checked_mul(count));
    all.ok_or_else(|| too_many("more than 10^19"))
}

fn checked_lists(counts: &[u64]) -> Checked<u64> {
    // one number goes with all values of the others
    let most = counts.iter().copied().max().unwrap_or(0);
    if counts.iter().any(|count| ![1, most].contains(count)) {
        let message = format!("lists side by side have {counts:?} values");
        let help = "give all lists the same number of values or one, or make a grid";
        return Err(refused(message, help));
    }
    Ok(most)
}

fn too_many(cases: &str) -> Box<Diagnostic> {
    let message =
        format!("the study would have {cases} cases; from 1 to {MOST_CASES} are possible");
    refused(message, "give fewer values, or lay fewer cases out by Sobol or a Latin hypercube")
}

/// The factor of correlations that there can be.
fn checked_correlations(count: usize, layout: &Layout) -> Checked<Vec<Vec<f64>>> {
    let matrix = &layout.correlations;
    if matrix.is_empty() {
        return Ok(Vec::new());
    }
    let help = "give a row for each parameter: ones on the diagonal, the same number on both sides of \
                it, and correlations that contradict one another nowhere";
    let square = matrix.len() == count && matrix.iter().all(|row| row.len() == count);
    let finite = matrix.iter().flatten().all(|value| value.abs() <= 1.0);
    #[allow(clippy::float_cmp)] // numbers as they were given
    let mirrored = square && (0..count).all(|i| (0..=i).all(|j| matrix[i][j] == matrix[j][i]));
    #[allow(clippy::float_cmp)] // as above
    let unit = square && (0..count).all(|i| matrix[i][i] == 1.0);
    if matches!(layout.kind, Kind::Grid | Kind::Together) {
        let message = "values that are listed cannot be correlated".to_owned();
        return Err(refused(message, "lay the cases out at random"));
    }
    match factored(matrix).filter(|_| finite && mirrored && unit) {
        Some(factor) => Ok(factor),
        None => Err(refused("the matrix of correlations is none".to_owned(), help)),
    }
}
