//! A parameter whose derivative was lost on the way is said, not only left out.

use slideline_diag::{Code, Diagnostic};
use slideline_solve::observe::{Event, Observer, Stop};
use std::ops::ControlFlow;

/// Watches a differentiated run for another observer, and tells it of the first increment at which
/// a parameter has no derivative.
pub(crate) struct Lost<'a> {
    names: &'a [String],
    observer: &'a mut dyn Observer,
    /// Step and increment that were committed last.
    committed: Option<(usize, usize)>,
    /// Whether a parameter has a derivative there, and whether that it has none was said.
    told: Vec<bool>,
    said: Vec<bool>,
}

impl<'a> Lost<'a> {
    pub fn new(names: &'a [String], observer: &'a mut dyn Observer) -> Self {
        let none = vec![false; names.len()];
        Self { names, observer, committed: None, told: none.clone(), said: none }
    }

    /// Says which parameters the last increment has no derivative by.
    fn look_back(&mut self) -> ControlFlow<Stop> {
        let Some((step, increment)) = self.committed.take() else {
            return ControlFlow::Continue(());
        };
        for (place, name) in self.names.iter().enumerate() {
            if self.told[place] || self.said[place] {
                continue;
            }
            self.said[place] = true;
            let message = format!(
                "no sensitivities by {name} from step {step}, increment {increment} on: its \
                 derivative was lost there"
            );
            let help = "The increment stands where the solution branches, or where its neighbours \
                        have no equilibrium. Other increments, or a value a little different, may \
                        pass by; differences of whole runs show what is there.";
            let said = Diagnostic::warning(Code("SL0811"), message).help(help);
            self.observer.event(Event::Diagnosed(&said))?;
        }
        self.told.fill(false);
        ControlFlow::Continue(())
    }
}

impl Observer for Lost<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match &event {
            Event::Committed(frame) => {
                self.look_back()?;
                self.committed = Some((frame.step, frame.increment));
            }
            Event::Sensitivity(own) => self.told[own.parameter] = true,
            Event::End(_) => self.look_back()?,
            _ => {}
        }
        self.observer.event(event)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Heard(Vec<String>);

    impl Observer for Heard {
        fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
            if let Event::Diagnosed(said) = event {
                self.0.push(said.message.clone());
            }
            ControlFlow::Continue(())
        }
    }

    /// Requirement: a lost derivative is said once, with the increment at which it was lost.
    #[test]
    fn a_lost_derivative_is_said_once() {
        let (names, mut heard) = (["mu".to_owned(), "height".to_owned()], Heard(Vec::new()));
        let mut watch = Lost::new(&names, &mut heard);
        for (increment, told) in [(1, [true, true]), (2, [true, false]), (3, [true, false])] {
            watch.committed = Some((1, increment));
            watch.told.copy_from_slice(&told);
            assert!(watch.look_back().is_continue());
        }
        assert_eq!(heard.0.len(), 1);
        assert!(heard.0[0].contains("by height from step 1, increment 2 on"), "{}", heard.0[0]);
    }
}
