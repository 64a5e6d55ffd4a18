//! Keywords of Abaqus and CalculiX that are not read here. Named, so that none
//! of them is taken for a misspelt keyword of ours: `*PLASTIC` is not
//! `*ELASTIC`, and `*DLOAD` not `*CLOAD`.
//!
//! ```text
//!   *PREPRINT, ECHO=NO     changes no result of a static step: passed over, one note
//!   *SUBMODEL              changes the model: an error under its own name
//! ```

use std::collections::HashMap;
use std::sync::LazyLock;

use slideline_deck::normalise;

mod names;
mod parameters;
mod passed_over;
mod variables;

use names::Group;
pub(crate) use names::Treatment;
pub(crate) use parameters::parameter;
pub(crate) use variables::variable;

/// A keyword of another program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Other {
    /// Its name without the star.
    pub name: &'static str,
    /// What becomes of it.
    pub treatment: Treatment,
    /// Why it has no effect, or what to do instead; may be empty.
    pub help: &'static str,
}

/// All groups: those that change the model, those that do not.
fn groups() -> impl Iterator<Item = &'static Group> {
    names::GROUPS.iter().chain(passed_over::GROUPS)
}

/// The entry of a normalised keyword.
pub(crate) fn find(word: &str) -> Option<Other> {
    static BY_NAME: LazyLock<HashMap<String, Other>> = LazyLock::new(|| {
        let entries = groups().flat_map(|&(treatment, help, names)| {
            names.iter().map(move |&name| (normalise(name), Other { name, treatment, help }))
        });
        entries.collect()
    });
    BY_NAME.get(word).copied()
}

/// What to say of a keyword that is known but not read, with or without its
/// star; `None` for any other word.
pub fn not_read(name: &str) -> Option<String> {
    let other = find(&normalise(name.trim().trim_start_matches('*')))?;
    let name = other.name;
    Some(match (other.treatment, other.help) {
        (Treatment::Ignored, why) => format!("*{name} is ignored: {why}."),
        (_, "") => format!("*{name} is not supported."),
        (_, help) => format!("*{name} is not supported: {help}."),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::REGISTRY;

    #[test]
    fn no_keyword_of_ours_is_another_programs() {
        let own = REGISTRY.iter().map(|keyword| normalise(keyword.name()));
        for (own, group) in own.flat_map(|own| groups().map(move |g| (own.clone(), g))) {
            // *CONTACT is a keyword, and no abbreviation of *CONTACT PAIR.
            let hides = |name: &&&str| own.starts_with(&normalise(name)) && **name != "CONTACT";
            assert_eq!(group.2.iter().find(hides), None, "{own}");
        }
    }

    #[test]
    fn every_name_stands_in_one_group() {
        let all: Vec<_> = groups().flat_map(|group| group.2).collect();
        let once: std::collections::HashSet<_> = all.iter().map(|name| normalise(name)).collect();
        let twice: Vec<_> =
            all.iter().filter(|a| all.iter().filter(|b| b == a).count() > 1).collect();
        assert_eq!(all.len(), once.len(), "{twice:?}");
    }

    #[test]
    fn keywords_that_public_decks_use_are_known() {
        for name in ["SUBMODEL", "tied contact", "global damping"] {
            assert!(not_read(name).is_some(), "{name}");
        }
    }
}
