//! What stands against a mesh or a wish.

use slideline_diag::{Code, Diagnostic, Span};

/// SL0831: the text is no mesh, or is damaged.
pub(crate) fn unreadable(message: impl Into<String>, at: Option<Span>) -> Box<Diagnostic> {
    let help = "Write the mesh again as text, with gmsh for instance: \
                `gmsh -3 part.geo -format msh41 -o part.msh`.";
    Box::new(Diagnostic::error(Code("SL0831"), message).at(at).help(help))
}

/// SL0833: a cell that no element here has.
pub(crate) fn no_element(message: impl Into<String>, at: Option<Span>) -> Box<Diagnostic> {
    let help = "In gmsh set Mesh.ElementOrder to 1 or 2, and mesh volumes with tetrahedra, wedges \
                or bricks.";
    Box::new(Diagnostic::error(Code("SL0833"), message).at(at).help(help))
}

/// SL0834: a group that cannot become what was asked for.
pub(crate) fn misfit(message: impl Into<String>, help: impl Into<String>) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(Code("SL0834"), message).help(help))
}
