//! What the groups of a mesh are to become.

use crate::fault::misfit;
use crate::mesh::{Group, Mesh};
use crate::names::clean;
use slideline_diag::{Code, Diagnostic};

/// What is asked for, by the names of groups.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wishes {
    /// Lines that are beams, with the element type.
    pub beams: Vec<(String, String)>,
    /// Areas or volumes with the element type.
    pub solids: Vec<(String, String)>,
    /// Nodes that are one rigid body.
    pub rigid: Vec<String>,
    /// Groups that become sets of nodes alone.
    pub node_sets: Vec<String>,
    /// Groups that are held.
    pub fixed: Vec<String>,
}

/// The place of the group that a wish names.
pub(crate) fn find(mesh: &Mesh, name: &str) -> Result<usize, Box<Diagnostic>> {
    let same = |group: &Group| clean(&group.name) == clean(name);
    mesh.groups.iter().position(same).ok_or_else(|| {
        let names: Vec<&str> = mesh.groups.iter().map(|group| group.name.as_str()).collect();
        let help = match slideline_deck::nearest(name, names.iter().copied()) {
            Some(near) => format!("Is {near} meant?"),
            None if names.is_empty() => {
                "The mesh has no groups: give names to parts as physical groups in gmsh.".to_owned()
            }
            None => format!("The mesh has {}.", names.join(", ")),
        };
        let message = format!("the mesh has no group {name}");
        Box::new(Diagnostic::error(Code("SL0832"), message).help(help))
    })
}

/// Wishes by the places of their groups.
pub(crate) struct Asked {
    /// Element type of each group, if one is asked for; whether of beams.
    pub kinds: Vec<Option<(String, bool)>>,
    pub rigid: Vec<bool>,
    pub node_set: Vec<bool>,
    pub fixed: Vec<bool>,
}

impl Asked {
    /// Finds the groups; every name that is none is told.
    pub fn of(mesh: &Mesh, wishes: &Wishes) -> Result<Self, Vec<Diagnostic>> {
        let count = mesh.groups.len();
        let mut kinds = vec![None; count];
        let mut said = Vec::new();
        let typed = wishes.beams.iter().map(|own| (own, true));
        for ((name, kind), beam) in typed.chain(wishes.solids.iter().map(|own| (own, false))) {
            match find(mesh, name) {
                Ok(place) if kinds[place].is_some() => {
                    let message = format!("the group {name} has two element types");
                    said.push(*misfit(message, "Leave one of them out."));
                }
                Ok(place) => kinds[place] = Some((kind.to_ascii_uppercase(), beam)),
                Err(error) => said.push(*error),
            }
        }
        let mut marked = |names: &[String]| {
            let mut marks = vec![false; count];
            for name in names {
                match find(mesh, name) {
                    Ok(place) => marks[place] = true,
                    Err(error) => said.push(*error),
                }
            }
            marks
        };
        let (rigid, node_set) = (marked(&wishes.rigid), marked(&wishes.node_sets));
        let fixed = marked(&wishes.fixed);
        if said.is_empty() { Ok(Self { kinds, rigid, node_set, fixed }) } else { Err(said) }
    }
}
