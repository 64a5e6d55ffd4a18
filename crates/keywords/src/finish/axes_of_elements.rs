//! Axes of the materials of a section: the same for all, or from a distribution.
//!
//! ```text
//!   *DISTRIBUTION   12: a, b   13: a, b   all others: a, b
//!   elements of the section     12   13   14   15     ->  axes of each
//! ```

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::orientation::{Basis, Orientation, Orientations};
use slideline_model::{self as model, Elements};

use super::orientations::{of_name, of_section, unknown};
use crate::axes::{Distribution, Given, Numbers, system_of};
use crate::draft::Draft;
use crate::rule::Subject;

/// The axes of a section.
pub(super) enum SectionAxes {
    /// Those of the model.
    Plain,
    /// The same for all elements.
    All(Orientation),
    /// Those of elements, by their places in the draft, and of all others.
    Each(HashMap<usize, Orientation>, Orientation),
}

impl SectionAxes {
    /// Those that a section names; `None` after an error.
    pub fn named(named: Option<&(String, Span)>, draft: &mut Draft) -> Option<Self> {
        let Some((name, span)) = named else { return Some(Self::Plain) };
        let found = of_name((name, *span), draft)?;
        let Given::Distribution(system, distribution) = &found.given else {
            return Some(
                of_section(Some(&(name.clone(), *span)), draft)?.map_or(Self::Plain, Self::All),
            );
        };
        let own = distribution_of((distribution, found.line), draft)?;
        let made = |numbers: &Numbers, draft: &mut Draft| {
            let basis = Basis::System(system_at(system, &own, numbers, draft)?);
            Some(Orientation { basis, turn: found.turn })
        };
        let default = made(&own.default, draft)?;
        let mut each = HashMap::new();
        for (target, numbers) in &own.lines {
            let axes = made(numbers, draft)?;
            each.extend(draft.elements_at(target, numbers.span).into_iter().map(|own| (own, axes)));
        }
        Some(Self::Each(each, default))
    }

    /// Those of an element, by its place in the draft.
    pub fn of(&self, element: usize) -> Option<Orientation> {
        match self {
            Self::Plain => None,
            Self::All(axes) => Some(*axes),
            Self::Each(each, others) => Some(*each.get(&element).unwrap_or(others)),
        }
    }

    /// The section of these elements with their axes.
    pub fn put_on(
        &self,
        mut section: model::Section,
        elements: &Elements,
        draft: &Draft,
    ) -> model::Section {
        if let model::Section::Solid(solid) = &mut section {
            let place = |label| draft.element_by_label.get(&label).copied();
            let each = || elements.iter().filter_map(|own| self.of(place(own.label)?));
            solid.orientation = match self {
                Self::Plain => None,
                Self::All(axes) => Some(Orientations::All(*axes)),
                Self::Each(..) => Some(Orientations::Each(each().collect())),
            };
        }
        section
    }
}

/// The distribution of that name, whose table there must be; a part may use one that stands outside
/// of it.
fn distribution_of((name, span): (&str, Span), draft: &mut Draft) -> Option<Distribution> {
    let plain = name.rsplit('.').next().unwrap_or(name);
    let find = |name: &str| draft.distributions.iter().find(|own| own.name == name).cloned();
    let Some(found) = find(name).or_else(|| find(plain)) else {
        let names = draft.distributions.iter().map(|own| own.name.as_str());
        let error = unknown("*DISTRIBUTION", (name, span), names);
        draft.consequence(Subject::Sections, error);
        return None;
    };
    let (table, span) = &found.table;
    if !draft.distribution_tables.contains(table) {
        let names = draft.distribution_tables.iter().map(String::as_str);
        let error = unknown("*DISTRIBUTION TABLE", (table, *span), names);
        draft.consequence(Subject::Sections, error);
        return None;
    }
    Some(found)
}

/// The system through the points of a line.
fn system_at(
    system: &str,
    own: &Distribution,
    numbers: &Numbers,
    draft: &mut Draft,
) -> Option<model::System> {
    let [ax, ay, az, bx, by, bz] = numbers.first;
    let Some(made) = system_of(system, [[ax, ay, az], [bx, by, bz], [0.0; 3]]) else {
        let message = "these points give no direction, or the same one";
        let error = Diagnostic::error(Code("SL0232"), message).at(numbers.span);
        let help = "give a on axis 1 and b beside it: , 1., 0., 0., 0., 1., 0.";
        draft.consequence(Subject::Sections, error.help(help));
        return None;
    };
    Some(match own.motion {
        Some(motion) => made.moved(|x| motion.point(x), |way| motion.direction(way)),
        None => made,
    })
}
