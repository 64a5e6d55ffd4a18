//! Beams and trusses that general contact would meet elsewhere, and does not here.
//!
//! ```text
//!      [ block ] v         the inclusions name all there is, or the surface of the beam itself:
//!    =============== beam  nothing would be said as the block goes through it
//! ```

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};

use crate::draft::{Draft, ElementKind};
use crate::surfaces::{Extent, GeneralContact};

/// Says which beams and trusses the inclusions take in that are left out: those of a surface that they name, or all
/// that do not lie in solids.
pub(super) fn note_lines(general: &GeneralContact, draft: &mut Draft) {
    let message = match named_lines(general, draft) {
        Some(name) => {
            format!("surface {name} of beams or trusses is left out of this general contact")
        }
        None => {
            let takes_all = general.inclusions.iter().any(|two| two.first.is_none());
            let Some((count, first)) = free_lines(draft).filter(|_| takes_all) else { return };
            match count {
                1 => format!(
                    "element {first}, a beam or a truss, is left out of this general contact"
                ),
                _ => format!(
                    "{count} beams and trusses are left out of this general contact, the first one is element {first}"
                ),
            }
        }
    };
    let warning = Diagnostic::warning(Code("SL0386"), message).at(general.origin).help(
        "nothing keeps other parts from going through it; where it may be met, give a *CONTACT PAIR whose slave is a \
         surface of nodes of the beam",
    );
    draft.log.push(warning);
}

/// The first surface of the inclusions that has beams or trusses.
fn named_lines(general: &GeneralContact, draft: &mut Draft) -> Option<String> {
    let sides = general.inclusions.iter().flat_map(|two| [&two.first, &two.second]);
    let names: Vec<String> = sides.flatten().map(|named| named.name.clone()).collect();
    names.into_iter().find(|name| {
        let same = draft.named_surfaces.iter().find(|surface| surface.named.name == *name);
        let Some(Extent::Elements(stretches)) = same.map(|own| own.extent.clone()) else {
            return false;
        };
        stretches.iter().any(|stretch| {
            let found = draft.elements_at(&stretch.elements, stretch.span);
            found.into_iter().any(|element| is_line(draft.elements[element].kind))
        })
    })
}

/// How many beams and trusses there are that do not lie in solids, and the label of the first one; `None`: none.
fn free_lines(draft: &Draft) -> Option<(usize, u64)> {
    let elements = || draft.elements.iter();
    let solids = elements().filter(|own| has_faces(own.kind));
    let inside: HashSet<u64> = solids.flat_map(|own| own.nodes.iter().copied()).collect();
    let lies_inside = |nodes: &[u64]| nodes.iter().all(|node| inside.contains(node));
    let free = || elements().filter(|own| is_line(own.kind) && !lies_inside(&own.nodes));
    Some((free().count(), free().next()?.label))
}

fn has_faces(kind: ElementKind) -> bool {
    matches!(kind, ElementKind::Structural(row) if !row.cell.faces.is_empty())
}

fn is_line(kind: ElementKind) -> bool {
    matches!(kind, ElementKind::Structural(row) if row.is_beam() || row.is_space_beam() || row.is_truss())
}
