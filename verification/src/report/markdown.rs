//! The measured numbers as a table in Markdown.

use super::wording::verdict;
use crate::claim::Outcome;

pub(super) fn page(outcomes: &[Outcome]) -> String {
    let mut text = format!(
        "# Verification report\n\nSlideline {}. {}\n\n\
         | claim | measured | value | required | holds |\n|---|---|---|---|---|\n",
        slideline::VERSION,
        verdict(outcomes)
    );
    for outcome in outcomes {
        for one in outcome.record.measured() {
            let holds = if one.holds() { "yes" } else { "**no**" };
            let cells = [&outcome.id(), &one.quantity, &one.found(), &one.required()];
            let cells = cells.map(|cell| cell.replace('|', "\\|").replace('\n', " "));
            text.push_str(&format!("| {} | {holds} |\n", cells.join(" | ")));
        }
        if let Some(reason) = &outcome.broken {
            let reason = reason.replace('|', "\\|").replace('\n', " ");
            text.push_str(&format!("| {} | {reason} | | | **no** |\n", outcome.id()));
        }
    }
    text
}
