//! `slideline import`: a mesh turned into a deck.

use crate::exit::Exit;
use crate::{fresh_file, render, screen};
use clap::{Args, ValueHint};
use slideline::diag::{Code, Diagnostic, Sources};
use slideline_mesh::Wishes;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// `slideline import`.
#[derive(Args, Debug)]
pub(crate) struct ImportArguments {
    /// What gmsh wrote: .msh (2.2 or 4.1, text) or .inp.
    #[arg(value_name = "MESH", value_hint = ValueHint::FilePath)]
    mesh: PathBuf,
    /// The lines of this group are beams.
    #[arg(long, value_name = "NAME=B21", value_parser = typed)]
    beam: Vec<(String, String)>,
    /// The areas or volumes of this group have this element type [default: CPS..., C3D...].
    #[arg(long, value_name = "NAME=CPE4I", value_parser = typed)]
    solid: Vec<(String, String)>,
    /// The nodes of this group are a rigid body, with a reference node in their middle.
    #[arg(long, value_name = "NAME")]
    rigid: Vec<String>,
    /// This group becomes a set of nodes, without a surface.
    #[arg(long, value_name = "NAME")]
    nset: Vec<String>,
    /// The nodes of this group are held.
    #[arg(long, value_name = "NAME")]
    fix: Vec<String>,
    /// The deck, a file that is not there yet [default: MESH_deck.inp].
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,
}

fn typed(text: &str) -> Result<(String, String), String> {
    match text.split_once('=').map(|(name, kind)| (name.trim(), kind.trim())) {
        Some((name, kind)) if !name.is_empty() && !kind.is_empty() => {
            Ok((name.to_owned(), kind.to_owned()))
        }
        _ => Err("a group and its element type: NAME=TYPE".to_owned()),
    }
}

/// Writes the deck of a mesh.
pub(crate) fn import(arguments: &ImportArguments) -> Exit {
    let mut sources = Sources::default();
    let deck = match deck(arguments, &mut sources) {
        Ok(deck) => deck,
        Err(said) => {
            render::to_standard_error(&said, &sources);
            return Exit::Input;
        }
    };
    let path = arguments.output.clone().unwrap_or_else(|| beside(&arguments.mesh));
    let exit = fresh_file::write(&path, &deck);
    if exit == Exit::Completed {
        let deck = path.display();
        screen::print(&format!(
            "{deck} is written; fill in what is marked by FILL IN, then: slideline check {deck}\n"
        ));
    }
    exit
}

fn deck(arguments: &ImportArguments, sources: &mut Sources) -> Result<String, Vec<Diagnostic>> {
    let name = arguments.mesh.display().to_string();
    let bytes = std::fs::read(&arguments.mesh).map_err(|reason| {
        let message = format!("the mesh {name} cannot be read: {reason}");
        let help = "Name a file that gmsh wrote, with its ending.";
        vec![Diagnostic::error(Code("SL0831"), message).help(help)]
    })?;
    let mesh = slideline_mesh::read(sources, &name, &bytes).map_err(|said| vec![*said])?;
    let wishes = Wishes {
        beams: arguments.beam.clone(),
        solids: arguments.solid.clone(),
        rigid: arguments.rigid.clone(),
        node_sets: arguments.nset.clone(),
        fixed: arguments.fix.clone(),
    };
    let file = arguments.mesh.file_name().unwrap_or_default().to_string_lossy().into_owned();
    slideline_mesh::deck(&mesh, &wishes, &file)
}

/// `part_deck.inp` beside `part.msh`.
fn beside(mesh: &Path) -> PathBuf {
    let mut name = OsString::from(mesh.file_stem().unwrap_or_default());
    name.push("_deck.inp");
    mesh.with_file_name(name)
}
