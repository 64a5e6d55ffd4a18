//! Quadratic faces in space whose nodes carry contact one by one.
//!
//! ```text
//!   o---o---o     a uniform pressure loads a corner by -1/12 of the face and a middle node by
//!   |       |     1/3: areas of nodes, which are positive, cannot say that, and what is pressed
//!   o---o---o     flat shows waves of stress
//! ```
//!
//! In the plane the shares 1/6, 4/6, 1/6 are those of a uniform pressure.

use crate::finding::Finding;
use crate::start::Start;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Formulation, Master};

/// SL0423: slaves of quadratic faces in space with `NODE TO SURFACE`. What may meet itself does so
/// seldom: it is told when it has.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let pairs = start.model.contact_pairs.iter().filter(|pair| !pair.meets_itself());
    findings.extend(pairs.filter_map(say).map(Finding::said));
}

/// The same of one pair.
pub fn say(pair: &ContactPair) -> Option<Diagnostic> {
    // an analytical surface in space meets nodes alone
    let swept = matches!(&pair.master, Master::Faces(faces) if faces.swept.is_some());
    if pair.formulation != Formulation::NodeToSurface || swept {
        return None;
    }
    let quadratic = pair.faces.iter().filter(|face| face.nodes.len() > 4).count();
    if quadratic == 0 {
        return None;
    }
    let message = format!(
        "{quadratic} slave faces of {} are quadratic, and their nodes carry contact one by one: a \
         uniform pressure cannot be carried so, and stresses under the contact will be wavy",
        pair.name
    );
    let said = Diagnostic::warning(Code("SL0423"), message).at(pair.origin);
    let help = match pair.meets_itself() {
        true => {
            "a surface that meets itself does so at its nodes: mesh it with linear faces (C3D8I)"
        }
        false => "give *CONTACT PAIR, TYPE=SURFACE TO SURFACE",
    };
    Some(said.help(help))
}
