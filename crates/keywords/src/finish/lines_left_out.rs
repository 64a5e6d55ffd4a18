//! Beams and trusses that general contact would meet elsewhere, and does not here.
//!
//! ```text
//!      [ block ] v         the inclusions name all there is, or the surface of the beam itself:
//!    =============== beam  nothing would be said as the block goes through it
//! ```

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};

use super::meetings::both;
use super::skin::Skin;
use crate::draft::{Draft, Element, ElementKind};
use crate::surfaces::{Extent, GeneralContact};

/// Says which beams and trusses the inclusions take in that are left out: all that do not lie in solids, or those of a
/// surface of lines.
pub(super) fn note_lines(general: &GeneralContact, skin: &Skin, draft: &mut Draft) {
    let named = named_lines(general, skin, draft);
    let message = match named.first() {
        Some(name) => {
            format!("surface {name} of beams or trusses is left out of this general contact")
        }
        None => {
            let takes_all = general.inclusions.iter().any(|two| two.first.is_none());
            let free = free_lines(draft);
            let Some(first) = free.first().filter(|_| takes_all) else { return };
            let label = draft.elements[*first].label;
            match free.len() {
                1 => format!(
                    "element {label}, a beam or a truss, is left out of this general contact"
                ),
                count => format!(
                    "{count} beams and trusses are left out of this general contact, the first one is element {label}"
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

/// Names of surfaces of the inclusions that have no faces of solids and no analytical surface.
fn named_lines(general: &GeneralContact, skin: &Skin, draft: &mut Draft) -> Vec<String> {
    let mut found = Vec::new();
    for two in &general.inclusions {
        let Some(sides) = both(two, skin, draft) else { continue };
        let names = [two.first.as_ref(), two.second.as_ref().or(two.first.as_ref())];
        for (named, own) in names.into_iter().zip(sides) {
            let Some(named) = named.filter(|_| own.is_empty()) else { continue };
            let is_of_nodes = draft.named_surfaces.iter().any(|surface| {
                surface.named.name == named.name && matches!(surface.extent, Extent::Nodes(_))
            });
            if !is_of_nodes && !found.contains(&named.name) {
                found.push(named.name.clone());
            }
        }
    }
    found
}

/// Elements that are beams or trusses and do not lie in solids.
fn free_lines(draft: &Draft) -> Vec<usize> {
    let of_solids = |element: &&Element| matches!(element.kind, ElementKind::Structural(row) if !row.cell.faces.is_empty());
    let inside: HashSet<u64> =
        draft.elements.iter().filter(of_solids).flat_map(|own| own.nodes.iter().copied()).collect();
    let is_line = |kind: ElementKind| matches!(kind, ElementKind::Structural(row) if row.is_beam() || row.is_space_beam() || row.is_truss());
    let all = draft.elements.iter().enumerate();
    let free = all.filter(|(_, own)| is_line(own.kind));
    free.filter(|(_, own)| own.nodes.iter().any(|node| !inside.contains(node)))
        .map(|(place, _)| place)
        .collect()
}
