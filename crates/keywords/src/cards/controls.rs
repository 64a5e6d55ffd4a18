//! `*CONTROLS`: tolerances and limits of the iteration.

use slideline_deck::DataLine;
use slideline_model::{self as model, FieldControls, TimeIncrementation};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CONTROLS`.
pub(crate) struct Controls;

impl Keyword for Controls {
    fn name(&self) -> &'static str {
        "CONTROLS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("ANALYSIS"),
            Rule::value("PARAMETERS"),
            Rule::value("FIELD"),
            Rule::flag("RESET"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["TYPE"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("CONTROLS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let analysis = card.choice("ANALYSIS", &["DISCONTINUOUS"], &mut draft.log);
        let known = &["FIELD", "TIME INCREMENTATION", "CONSTRAINTS", "LINE SEARCH", "CONTACT"];
        let parameters = card.choice("PARAMETERS", known, &mut draft.log);
        card.choice("FIELD", &["DISPLACEMENT", "ROTATION", "GLOBAL"], &mut draft.log);
        let before = draft.step().and_then(|step| step.controls);
        let inherited = draft.steps.iter().rev().find_map(|step| step.controls);
        let mut controls = before.or(inherited).unwrap_or_default();
        if card.has("RESET") {
            controls = model::Controls::default();
        }
        controls.discontinuous |= analysis.is_some();
        match parameters {
            Some("FIELD") => field(card.data(), &mut controls.field, draft),
            Some("TIME INCREMENTATION") => time(card.data(), &mut controls.time, draft),
            Some("CONSTRAINTS") => {
                let message = "PARAMETERS=CONSTRAINTS is read, but changes nothing here: \
                               contact is imposed to the accuracy of the residual";
                draft.log.note("SL0253", message, card.span_of("PARAMETERS"));
            }
            Some(other) => {
                let message = format!(
                    "PARAMETERS={other} is read, but changes nothing here: the way to \
                     equilibrium has settings of its own"
                );
                draft.log.note("SL0253", message, card.span_of("PARAMETERS"));
            }
            None if card.has("RESET") => {}
            None => draft.log.at_most_lines(card.data(), 0, self.name()),
        }
        if let Some(step) = draft.step() {
            step.controls = Some(controls);
        }
    }
}

/// R_n, C_n, initial and fixed flux, R_p, epsilon, C_epsilon, R_l.
fn field(data: &[DataLine], controls: &mut FieldControls, draft: &mut Draft) {
    draft.log.at_most_lines(data, 1, "CONTROLS, PARAMETERS=FIELD");
    let Some(line) = data.first() else { return };
    draft.log.at_most(line, 8);
    controls.set_by_deck |= line.field(0).is_some();
    if line.field(0).is_some() && line.field(4).is_none() {
        controls.r_p = 4.0 * positive(line, 0, draft).unwrap_or(controls.r_n);
    }
    let targets: [(usize, &mut f64); 6] = [
        (0, &mut controls.r_n),
        (1, &mut controls.c_n),
        (4, &mut controls.r_p),
        (5, &mut controls.epsilon),
        (6, &mut controls.c_epsilon),
        (7, &mut controls.r_l),
    ];
    for (at, target) in targets {
        set(target, positive(line, at, draft));
    }
    controls.initial_flux = positive(line, 2, draft).or(controls.initial_flux);
    controls.fixed_flux = positive(line, 3, draft).or(controls.fixed_flux);
}

/// I_0, I_R, I_P, I_C, I_L, I_G, I_S, I_A, I_J, I_T; D_f, D_C, D_B, D_A, D_S,
/// D_H, D_D. Those without a place in the model are checked and passed over.
fn time(data: &[DataLine], controls: &mut TimeIncrementation, draft: &mut Draft) {
    draft.log.at_most_lines(data, 2, "CONTROLS, PARAMETERS=TIME INCREMENTATION");
    if let Some(line) = data.first() {
        let targets: [&mut u32; 8] = [
            &mut controls.i_0,
            &mut controls.i_r,
            &mut controls.i_p,
            &mut controls.i_c,
            &mut controls.i_l,
            &mut controls.i_g,
            &mut controls.i_s,
            &mut controls.i_a,
        ];
        for (at, target) in targets.into_iter().enumerate() {
            set(target, count(line, at, draft));
        }
    }
    if let Some(line) = data.get(1) {
        let targets: [(usize, &mut f64); 4] = [
            (0, &mut controls.d_f),
            (1, &mut controls.d_c),
            (2, &mut controls.d_b),
            (6, &mut controls.d_d),
        ];
        for (at, target) in targets {
            set(target, positive(line, at, draft));
        }
    }
}

fn set<T>(target: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *target = value;
    }
}

fn positive(line: &DataLine, at: usize, draft: &mut Draft) -> Option<f64> {
    let value = draft.log.maybe_number(line, at)??;
    if value <= 0.0 {
        draft.log.error("SL0210", "this control must be positive", line.fields[at].span);
        return None;
    }
    Some(value)
}

fn count(line: &DataLine, at: usize, draft: &mut Draft) -> Option<u32> {
    line.field(at)?;
    let value = draft.log.integer_or(line, at, 1)?;
    let count = u32::try_from(value).ok().filter(|&value| value >= 1);
    if count.is_none() {
        let message = "this number of iterations must be at least 1";
        draft.log.error("SL0210", message, line.fields[at].span);
    }
    count
}
