//! `*CLEARANCE`: pairs whose slaves begin at a given gap.

use slideline_diag::{Code, Diagnostic};
use slideline_model::Adjust;

use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::Clearance;

/// `*CLEARANCE`: the pairs whose slaves begin at a given gap.
pub(super) fn clearances(draft: &mut Draft) {
    for clearance in std::mem::take(&mut draft.clearances) {
        let Clearance { slave, master, value, origin } = clearance;
        let name = format!("{}/{}", slave.name, master.name);
        let pairs = draft.model.contact_pairs.iter().enumerate();
        let own: Vec<usize> = pairs.filter(|own| own.1.is_called(&name)).map(|own| own.0).collect();
        let Some(pair) = own.first().map(|&first| &draft.model.contact_pairs[first]) else {
            let message = format!("there is no contact pair of {} on {}", slave.name, master.name);
            let error = Diagnostic::error(Code("SL0392"), message).at(origin);
            let help = "SLAVE and MASTER are the surfaces of a line of *CONTACT PAIR";
            draft.consequence(Subject::Contact, error.help(help));
            continue;
        };
        if pair.adjust != Adjust::Nothing {
            let message = format!("the slaves of {name} cannot begin at a clearance");
            let error = Diagnostic::error(Code("SL0392"), message).at(origin);
            let error = error.label(pair.origin, "the pair");
            let help = "leave ADJUST, or another *CLEARANCE, of this pair out";
            draft.consequence(Subject::Contact, error.help(help));
            continue;
        }
        if pair.profile.is_some() {
            let message = format!("{} has no nodes that could be moved to a clearance", slave.name);
            let error = Diagnostic::error(Code("SL0392"), message).at(origin);
            let error = error.label(pair.origin, "it is the profile of a rigid body");
            let help = "move its points and its reference node in the deck";
            draft.consequence(Subject::Contact, error.help(help));
            continue;
        }
        for place in own {
            draft.model.contact_pairs[place].adjust = Adjust::Clearance(value);
        }
    }
}
