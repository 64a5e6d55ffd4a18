//! Classes of models that must run, each drawn by a file of its own.
//!
//! ```text
//!   class, number -> Draft -> Placement -> text -> slideline -> files
//!                      \----------\--------------------------------> judge
//! ```

mod between;
mod draft;
mod laws;
mod rings;
mod rollers;
mod tips;
mod write;

pub use draft::{Chain, Draft, Friction, Normal, Pair, Promise, Side, Solid, Spring, Step, Stick};
pub use write::{Placement, Units, laws as write_laws, line, write};

use super::Sequence;
use super::label::Label;

/// A class: its name and how a model of it is drawn.
#[derive(Clone, Copy)]
pub struct Class {
    /// Name.
    pub name: &'static str,
    /// Draws a model.
    draw: fn(&mut Sequence) -> Draft,
}

/// All classes. That of units draws from the others and compares.
pub const CLASSES: [Class; 15] = [
    Class { name: "rings", draw: rings::ring },
    Class { name: "pinch", draw: between::pinch },
    Class { name: "release", draw: rollers::release },
    Class { name: "cyclic", draw: rollers::cyclic },
    Class { name: "corner", draw: tips::corner },
    Class { name: "wrap", draw: tips::wrap },
    Class { name: "walls", draw: between::walls },
    Class { name: "springs", draw: rollers::springs },
    Class { name: "beams", draw: tips::beam_on_beam },
    Class { name: "feet", draw: tips::feet },
    Class { name: "deep", draw: rollers::deep },
    Class { name: "pass", draw: rollers::pass_through },
    Class { name: "coarse", draw: rollers::coarse },
    Class { name: "restraint", draw: rollers::restraint },
    Class { name: "units", draw: any },
];

/// A model of any other class.
fn any(s: &mut Sequence) -> Draft {
    let class = CLASSES[s.below(CLASSES.len() - 1)];
    (class.draw)(s)
}

/// A model and where it stands.
#[derive(Clone, Debug)]
pub struct Case {
    /// Class.
    pub class: &'static str,
    /// Its number there.
    pub number: u64,
    /// The model in natural units.
    pub draft: Draft,
    /// Units and place.
    pub placed: Placement,
}

impl Case {
    /// The model of that number.
    pub fn drawn(class: &Class, number: u64) -> Self {
        let name = class.name.bytes().fold(7, |sum, byte| sum * 31 + u64::from(byte));
        let mut s = Sequence::new(number.wrapping_mul(1_000_003).wrapping_add(name));
        for _ in 0..4 {
            s.number(); // neighbouring numbers begin alike
        }
        let mut draft = (class.draw)(&mut s);
        // What has no friction ends in one state, but for buckling and for
        // rings, which may come to rest on one node or another.
        let unique = !["walls", "rings", "units"].contains(&class.name) && number.is_multiple_of(3);
        draft.reversible |= unique && draft.friction.mu == 0.0;
        let placed = Placement::drawn(&draft, &mut s);
        Self { class: class.name, number, draft, placed }
    }

    /// What it is counted under.
    pub fn label(&self) -> Label {
        let well_posed = self.draft.promise == Promise::WellPosed;
        Label { class: self.class, number: self.number, well_posed }
    }

    /// Its deck.
    pub fn text(&self) -> String {
        write(&self.draft, &self.placed, &format!("{} {}", self.class, self.number))
    }
}
