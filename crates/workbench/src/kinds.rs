//! Decks to begin with: those of `slideline new`.

/// A deck to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// What it is called on the command line.
    pub kind: &'static str,
    /// What it is called in print.
    pub title: &'static str,
    /// One sentence.
    pub text: &'static str,
    /// Name of the file.
    pub file: &'static str,
    /// The deck.
    pub deck: &'static str,
}

/// All of them.
pub const KINDS: [Kind; 5] = [
    Kind {
        kind: "snap-fit",
        title: "Cantilever snap-fit",
        text: "A cantilever arm with a hook that a rigid catch passes: force in and out.",
        file: "snap_fit.inp",
        deck: include_str!("../../../corpus/new/snap_fit.inp"),
    },
    Kind {
        kind: "annular",
        title: "Annular snap",
        text: "A cap with a bead, pushed over the bead of a rigid spigot: rings of solids.",
        file: "annular.inp",
        deck: include_str!("../../../corpus/new/annular.inp"),
    },
    Kind {
        kind: "cam",
        title: "Cam and leaf",
        text: "A leaf that an eccentric cam lifts: moment over angle.",
        file: "cam.inp",
        deck: include_str!("../../../corpus/new/cam.inp"),
    },
    Kind {
        kind: "leaf-switch",
        title: "Leaf switch",
        text: "A leaf that a plunger bends until it closes on a fixed contact.",
        file: "leaf_switch.inp",
        deck: include_str!("../../../corpus/new/leaf_switch.inp"),
    },
    Kind {
        kind: "battery-spring",
        title: "Battery spring",
        text: "A leaf with a bump, pressed by the end of a cell and let go.",
        file: "battery_spring.inp",
        deck: include_str!("../../../corpus/new/battery_spring.inp"),
    },
];

/// That of a name; `None`: there is none.
pub fn kind(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|own| own.kind == name)
}
