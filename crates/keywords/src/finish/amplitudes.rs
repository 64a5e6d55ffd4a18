//! Amplitudes by their names, and those that stand in place of numbers.

use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::rule::Subject;

/// The amplitude of that name, by its place in the list of the model; complains where there is
/// none.
pub(super) fn amplitude((name, span): &(String, Span), draft: &mut Draft) -> Option<usize> {
    let list = &draft.model.amplitudes;
    let found = list.iter().rposition(|amplitude| amplitude.name == *name);
    if found.is_none() {
        let mut error =
            Diagnostic::error(Code("SL0321"), format!("there is no amplitude {name}")).at(*span);
        let names = list.iter().map(|amplitude| amplitude.name.as_str());
        if let Some(near) = slideline_deck::nearest(name, names) {
            error = error.help(format!("did you mean {near}?"));
        }
        draft.consequence(Subject::Amplitudes, error);
    }
    found
}

/// Makes the number of every line whose amplitude is absolute one.
pub(super) fn absolute(draft: &mut Draft) {
    if draft.absolute_amplitudes.is_empty() {
        return;
    }
    let names = std::mem::take(&mut draft.absolute_amplitudes);
    let is_absolute =
        |own: &Option<(String, Span)>| own.as_ref().is_some_and(|(name, _)| names.contains(name));
    let mut sloped = Vec::new();
    for step in &mut draft.steps {
        let motions = step.boundary.iter_mut().filter(|line| !line.is_named);
        let lines = motions.chain(&mut step.loads);
        let lines = lines.map(|line| (&mut line.value, &line.amplitude));
        let rest = step.distributed.iter_mut().map(|line| (&mut line.value, &line.amplitude));
        let ways = step.interferences.iter_mut();
        let ways = ways.filter_map(|line| Some((line.value.as_mut()?, &line.amplitude)));
        let given = lines.chain(rest).chain(ways);
        given.filter(|own| is_absolute(own.1)).for_each(|(value, _)| *value = 1.0);
        for line in step.temperatures.iter_mut().filter(|line| is_absolute(&line.amplitude)) {
            line.temperature.value = 1.0;
            let other = line.other_slope.filter(|_| line.temperature.slopes[1] != 0.0);
            sloped.extend(line.slope.or(other));
        }
    }
    for span in sloped {
        let message = "a slope of the temperature with an amplitude that is absolute";
        let error = Diagnostic::error(Code("SL0221"), format!("{message} is not supported"));
        let help = "give the amplitude VALUE=RELATIVE: the slope follows it then";
        draft.log.push(error.at(span).help(help));
    }
}
