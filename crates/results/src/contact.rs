//! Fields on contact points.

use slideline_model::{ContactVariable, NodeIndex};
use slideline_solve::observe::{ContactRow, Frame};
use std::collections::BTreeMap;

/// A component of a field on contact points.
#[derive(Clone, Copy, Debug)]
pub struct ContactComponent {
    /// Name, such as `CPRESS`.
    pub name: &'static str,
    /// Unit tag.
    pub unit: &'static str,
    /// Whether it is along the second direction of the master, which only space has.
    pub in_space: bool,
    /// Its value at a point.
    pub value: fn(&ContactRow) -> f64,
}

/// A field on contact points.
#[derive(Clone, Copy, Debug)]
pub struct ContactField {
    /// Name, as decks ask for it.
    pub name: &'static str,
    /// What decks ask for; `None` for what is in files alone.
    pub variable: Option<ContactVariable>,
    /// Its components.
    pub components: &'static [ContactComponent],
}

const fn component(
    name: &'static str,
    unit: &'static str,
    value: fn(&ContactRow) -> f64,
) -> ContactComponent {
    ContactComponent { name, unit, in_space: false, value }
}

const fn across(
    name: &'static str,
    unit: &'static str,
    value: fn(&ContactRow) -> f64,
) -> ContactComponent {
    ContactComponent { name, unit, in_space: true, value }
}

/// All fields.
pub const CONTACT_FIELDS: [ContactField; 4] = [
    ContactField {
        name: "CSTRESS",
        variable: Some(ContactVariable::CSTRESS),
        components: &[
            component("CPRESS", "[F/L2]", |row| row.pressure),
            component("CSHEAR1", "[F/L2]", |row| row.shear[0]),
            across("CSHEAR2", "[F/L2]", |row| row.shear[1]),
        ],
    },
    ContactField {
        name: "CDISP",
        variable: Some(ContactVariable::CDISP),
        components: &[
            component("COPEN", "[L]", |row| row.opening),
            component("CSLIP1", "[L]", |row| row.slip[0]),
            across("CSLIP2", "[L]", |row| row.slip[1]),
        ],
    },
    ContactField {
        name: "CFORCE",
        variable: Some(ContactVariable::CFORCE),
        components: &[
            component("CNORMF", "[F]", |row| row.pressure * row.area),
            component("CSHEARF", "[F]", |row| row.shear[0] * row.area),
        ],
    },
    ContactField {
        name: "CPOINT",
        variable: None,
        components: &[
            component("x", "[L]", |row| row.position[0]),
            component("y", "[L]", |row| row.position[1]),
            component("z", "[L]", |row| row.position[2]),
            component("normal_x", "[1]", |row| row.normal[0]),
            component("normal_y", "[1]", |row| row.normal[1]),
            component("normal_z", "[1]", |row| row.normal[2]),
            component("t1_x", "[1]", |row| row.directions[0][0]),
            component("t1_y", "[1]", |row| row.directions[0][1]),
            component("t1_z", "[1]", |row| row.directions[0][2]),
            component("t2_x", "[1]", |row| row.directions[1][0]),
            component("t2_y", "[1]", |row| row.directions[1][1]),
            component("t2_z", "[1]", |row| row.directions[1][2]),
            component("area", "[L2]", |row| row.area),
        ],
    },
];

/// A component by its name.
pub fn contact_component(name: &str) -> Option<&'static ContactComponent> {
    CONTACT_FIELDS.iter().flat_map(|field| field.components).find(|own| own.name == name)
}

/// The row that a slave node shows: of several pairs that where it is pressed
/// most, and among those alike that where it is nearest.
pub fn shown<'a>(frame: &Frame<'a>) -> BTreeMap<NodeIndex, &'a ContactRow> {
    let mut shown: BTreeMap<NodeIndex, &ContactRow> = BTreeMap::new();
    for row in frame.contact {
        let kept = shown.entry(row.node).or_insert(row);
        if row.pressure >= kept.pressure && row.opening < kept.opening {
            *kept = row;
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_are_found_by_their_names() {
        let row = ContactRow { pressure: 2.0, area: 3.0, ..ContactRow::default() };
        let value = |name| contact_component(name).map(|own| (own.value)(&row));
        assert_eq!((value("CPRESS"), value("CNORMF"), value("none")), (Some(2.0), Some(6.0), None));
    }
}
