//! `slideline new`: a commented deck with parameters, to begin with.

use crate::exit::Exit;
use crate::{fresh_file, screen};
use clap::{Args, ValueEnum, ValueHint};
use slideline_workbench::kind;
use std::fmt::Write as _;
use std::path::PathBuf;

/// `slideline new`.
#[derive(Args, Debug)]
pub(crate) struct NewArguments {
    /// What the deck shows [default: a list of all].
    #[arg(value_name = "KIND")]
    kind: Option<Kind>,
    /// The deck, a file that is not there yet [default: KIND.inp].
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// A cantilever arm with a hook that a rigid catch passes: force in and out.
    SnapFit,
    /// A cap with a bead, pushed over the bead of a rigid spigot: rings of solids.
    Annular,
    /// A leaf that an eccentric cam lifts: moment over angle.
    Cam,
    /// A leaf that a plunger bends until it closes on a fixed contact.
    LeafSwitch,
    /// A leaf with a bump, pressed by the end of a cell and let go.
    BatterySpring,
}

impl Kind {
    fn deck(self) -> &'static str {
        kind(&self.name()).map_or("", |own| own.deck)
    }

    fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }

    fn help(self) -> String {
        let value = self.to_possible_value();
        let help = value.as_ref().and_then(|value| value.get_help());
        help.map_or_else(String::new, ToString::to_string)
    }
}

/// Writes a deck, or lists all kinds.
pub(crate) fn new(arguments: &NewArguments) -> Exit {
    let Some(kind) = arguments.kind else {
        screen::print(&list());
        return Exit::Completed;
    };
    let named = || PathBuf::from(format!("{}.inp", kind.name()));
    let path = arguments.output.clone().unwrap_or_else(named);
    let exit = fresh_file::write(&path, kind.deck());
    if exit == Exit::Completed {
        let deck = path.display();
        screen::print(&format!("{deck} is written; to solve it: slideline run {deck}\n"));
    }
    exit
}

fn list() -> String {
    let mut text = "Decks to begin with, by `slideline new KIND`:\n\n".to_owned();
    for kind in Kind::value_variants() {
        let _ = writeln!(text, "  {:<16}{}", kind.name(), kind.help()); // a String takes any text
    }
    text
}
