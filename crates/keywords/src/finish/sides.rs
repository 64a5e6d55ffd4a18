//! Both sides of a contact pair while it is put together.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    ContactElement, ContactFace, Interaction, Master, NodeIndex, NormalLaw, RigidSurface,
};

use super::surfaces::Found;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::NamedSurface;

/// Both surfaces of a pair.
pub(super) struct Sides {
    pub slave: NamedSurface,
    pub master: NamedSurface,
}

/// Whether a side is made of faces of solids.
pub(super) fn is_of_solids(side: &Found) -> bool {
    match side {
        Found::Facets(facets) => facets.iter().any(|facet| facet.face.is_some()),
        Found::Faces(_) => true,
        _ => false,
    }
}

/// What carries the points of a pair.
#[derive(Default)]
pub(super) struct Slaves {
    pub elements: Vec<ContactElement>,
    /// Whether these are faces of solids.
    pub of_solids: bool,
    pub faces: Vec<ContactFace>,
    /// The nodes of the faces that are slaves; empty: all.
    pub nodes: Vec<NodeIndex>,
    /// Whether they have shares of faces that do not look at the master.
    pub counts_sides: bool,
    /// The profile that is the slave.
    pub profile: Option<RigidSurface>,
}

pub(super) type Parts = Option<(Slaves, Master)>;

/// Says why the sides make no pair.
pub(super) fn refuse(
    span: Span,
    message: impl Into<String>,
    help: &str,
    draft: &mut Draft,
) -> Parts {
    let error = Diagnostic::error(Code("SL0332"), message).at(span);
    draft.consequence(Subject::Contact, error.help(help));
    None
}

/// Complains about areas given for slave nodes where a pressure decides about forces.
pub(super) fn areas_of_nodes(slave: &NamedSurface, interaction: &Interaction, draft: &mut Draft) {
    let Some(span) = slave.areas else { return };
    let (code, message) = ("SL0257", "the area given for the nodes of this surface is not used");
    let help = "the area of a node is half the distance to its neighbours times the thickness of \
                *SURFACE INTERACTION, or its share of faces; with hard contact it changes no force";
    if interaction.normal == NormalLaw::Hard {
        draft.log.push(Diagnostic::note(Code(code), message).at(span).help(help));
        return;
    }
    let message = "an area given for the nodes of a surface is not supported";
    let error = Diagnostic::error(Code("SL0221"), message).at(span);
    let help = "remove it: the area of a node is half the distance to its neighbours times the \
                thickness of *SURFACE INTERACTION";
    draft.consequence(Subject::Contact, error.help(help));
}
