//! What is asked of every case.

use crate::expression::Term;
use crate::history::History;

/// A response: an expression that was read.
#[derive(Clone, Debug)]
pub(crate) struct Response {
    pub term: Term,
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
