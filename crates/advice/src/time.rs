//! Materials that creep or relax, in a deck that never lets time pass.

use crate::finding::Finding;
use crate::start::Start;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Passage, Section};

/// SL0421: materials that take time, and no step in which it passes.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let model = start.model;
    if model.steps.iter().any(|step| step.procedure.passage != Passage::Still) {
        return;
    }
    let takes_time = |section: &Section| match section {
        Section::Solid(section) => section.material.takes_time(),
        _ => false,
    };
    let blocks = model.blocks.iter().filter(|block| !block.elements.is_empty());
    let Some(block) = blocks.into_iter().find(|block| takes_time(&block.section)) else { return };
    let message = format!(
        "the material of {} creeps or relaxes, and in no step does time pass for it: *STATIC takes \
         it as elastic",
        block.name
    );
    let said = Diagnostic::advice(Code("SL0421"), message).at(block.origin);
    findings.push(Finding::said(said.help(
        "put a step with *VISCO and the time that the part is held behind the others, or write \
         *STATIC, LONG TERM for the state when all has relaxed",
    )));
}
