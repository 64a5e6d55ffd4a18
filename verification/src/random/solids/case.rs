//! A model by its number, and where it stands.

use super::classes::Class;
use super::draft::Draft;
use super::write::{self, Placement};
use crate::random::Sequence;
use crate::random::classes::Promise;
use crate::random::label::Label;

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
        let name = class.name.bytes().fold(11, |sum, byte| sum * 31 + u64::from(byte));
        let mut s = Sequence::new(number.wrapping_mul(1_000_003).wrapping_add(name));
        for _ in 0..4 {
            s.number(); // neighbouring numbers begin alike
        }
        let draft = (class.draw)(&mut s);
        let placed = Placement::drawn(&draft, &mut s);
        Self { class: class.name, number, draft, placed }
    }

    /// Its deck.
    pub fn text(&self) -> String {
        write::write(&self.draft, &self.placed, &format!("{} {}", self.class, self.number))
    }

    /// The same in natural units.
    pub fn natural(&self) -> Self {
        Self { placed: self.placed.unscaled(), ..self.clone() }
    }

    /// What it is counted under.
    pub fn label(&self) -> Label {
        let well_posed = self.draft.promise == Promise::WellPosed;
        Label { class: self.class, number: self.number, well_posed }
    }
}
