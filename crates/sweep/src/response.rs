//! What is asked of every case.

use crate::expression::Term;
use crate::history::{AT_END, History};
use slideline::Model;
use slideline::diag::Span;

/// A response: an expression that was read.
#[derive(Clone, Debug)]
pub(crate) struct Response {
    pub term: Term,
    /// Where it is said.
    pub place: Span,
}

impl Response {
    /// Why a model has no moment that it names, and what to do; `None`: it has.
    pub fn objection(&self, model: &Model) -> Option<[String; 2]> {
        let ((step, time), steps) = (self.term.latest(), model.steps.len());
        let end: f64 = model.steps.iter().map(|step| step.procedure.period).sum();
        if step > steps {
            let message = format!("a response names step {step}, but the deck has {steps} steps");
            return Some([
                message,
                format!("Name a step from 1 to {steps}, or none for all of them."),
            ]);
        }
        (time > end * (1.0 + AT_END)).then(|| {
            let message = format!("a response names time {time}, but the analysis ends at {end}");
            [message, format!("Name a total time from 0 to {end}.")]
        })
    }
}

/// The value of every response in a run; `None` where it has none, such as a time that was not reached.
pub(crate) fn evaluate(
    responses: &[Response],
    parameters: &[f64],
    history: &History,
) -> Vec<Option<f64>> {
    let mut values: Vec<Option<f64>> = Vec::with_capacity(responses.len());
    for response in responses {
        let value = value(&response.term, &(parameters, &values, history));
        values.push(value.filter(|value| value.is_finite()));
    }
    values
}

/// The derivative of every response by every parameter, response by response; `None` where there is
/// none: of counts, of roughness, of verdicts, and by what the model cannot be differentiated by.
pub(crate) fn gradients(
    responses: &[Response],
    parameters: &[f64],
    (values, history): (&[Option<f64>], &History),
) -> Vec<Option<f64>> {
    let seen = (parameters, values, history);
    let by = |parameter: usize| {
        let mut rates: Vec<Option<f64>> = Vec::with_capacity(responses.len());
        for response in responses {
            let found = rate(&response.term, &seen, (parameter, &rates));
            rates.push(found.filter(|rate| rate.is_finite()));
        }
        rates
    };
    let all: Vec<Vec<Option<f64>>> = (0..parameters.len()).map(by).collect();
    (0..responses.len()).flat_map(|own| all.iter().map(move |rates| rates[own])).collect()
}

/// The derivative of a term by a parameter, those of the responses before it being there.
fn rate(term: &Term, seen: &Seen<'_>, by: (usize, &[Option<f64>])) -> Option<f64> {
    let (parameter, rates) = by;
    let history = seen.2;
    match term {
        Term::Number(_) => Some(0.0),
        Term::Parameter(place) => Some(if *place == parameter { 1.0 } else { 0.0 }),
        Term::Response(place) => rates[*place],
        Term::Count(count) => history.rate_counted(*count, parameter),
        Term::Measured(measure, curve, step) => {
            history.rate_measured(*measure, *curve, *step, parameter)
        }
        Term::At(curve, time) => history.rate_at(*curve, *time, parameter),
        Term::Work(curves, step) => history.rate_of_work(*curves, *step, parameter),
        Term::Absolute(inner) => Some(value(inner, seen)?.signum() * rate(inner, seen, by)?),
        Term::Root(inner) => Some(0.5 * rate(inner, seen, by)? / value(inner, seen)?.sqrt()),
        Term::Joined(sign, both) => {
            let [a, b] = [value(&both[0], seen)?, value(&both[1], seen)?];
            let [da, db] = [rate(&both[0], seen, by)?, rate(&both[1], seen, by)?];
            Some(match sign {
                '+' => da + db,
                '-' => da - db,
                '*' => da * b + a * db,
                _ => (da - a / b * db) / b,
            })
        }
    }
}

/// What an expression may look at.
type Seen<'a> = (&'a [f64], &'a [Option<f64>], &'a History);

fn value(term: &Term, seen: &Seen<'_>) -> Option<f64> {
    let (parameters, responses, history) = *seen;
    match term {
        Term::Number(number) => Some(*number),
        Term::Parameter(place) => Some(parameters[*place]),
        Term::Response(place) => responses[*place],
        Term::Count(count) => history.counted(*count),
        Term::Measured(measure, curve, step) => history.measured(*measure, *curve, *step),
        Term::At(curve, time) => history.at(*curve, *time),
        Term::Work(curves, step) => history.work(*curves, *step),
        Term::Absolute(inner) => value(inner, seen).map(f64::abs),
        Term::Root(inner) => value(inner, seen).map(f64::sqrt),
        Term::Joined(sign, both) => {
            let [a, b] = [value(&both[0], seen)?, value(&both[1], seen)?];
            Some(match sign {
                '+' => a + b,
                '-' => a - b,
                '*' => a * b,
                _ => a / b,
            })
        }
    }
}
