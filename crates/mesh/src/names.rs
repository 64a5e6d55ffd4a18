//! Names of groups as decks may have them, each once: gmsh knows groups of one name apart by their
//! dimension, and by letters that decks do not have.

use crate::mesh::Group;
use std::collections::BTreeSet;

/// A name that decks may have: letters, digits, `_` and `-`, a letter first; capitals.
pub(crate) fn clean(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' };
    let name: String = name.trim().chars().map(plain).collect::<String>().to_ascii_uppercase();
    match name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        true => name,
        false => format!("G_{name}"),
    }
}

/// A name that is not taken, and is from now on: the one that is wanted, or that with a number.
pub(crate) fn free(wanted: &str, taken: &mut BTreeSet<String>) -> String {
    let numbered = (2_usize..).map(|number| format!("{wanted}_{number}"));
    let mut names = std::iter::once(wanted.to_owned()).chain(numbered);
    let name = names.find(|name| !taken.contains(&clean(name))).unwrap_or_default();
    taken.insert(clean(&name));
    name
}

/// Gives groups of one name others: the largest dimension keeps it, those below it say what they are
/// of, and what is still the same gets a number.
pub(crate) fn distinguish(groups: &mut [Group]) {
    let dimensions: Vec<(String, usize)> =
        groups.iter().map(|own| (clean(&own.name), own.dimension)).collect();
    let is_below = |own: &Group| {
        let name = clean(&own.name);
        dimensions.iter().any(|(other, above)| *other == name && *above > own.dimension)
    };
    let (mut below, own): (Vec<_>, Vec<_>) = groups.iter_mut().partition(|own| is_below(own));
    let mut taken = BTreeSet::new();
    for group in own {
        group.name = free(&group.name, &mut taken);
    }
    for group in &mut below {
        let of = ["POINT", "CURVE", "SURFACE", "VOLUME"][group.dimension.min(3)];
        group.name = free(&format!("{}_{of}", group.name), &mut taken);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_decks() {
        for (name, cleaned) in [("left side", "LEFT_SIDE"), ("2nd", "G_2ND"), (" a-b ", "A-B")] {
            assert_eq!(clean(name), cleaned);
        }
    }

    /// Requirement: every group has a name of its own, and where nothing is the same nothing changes.
    #[test]
    fn groups_of_one_name_are_told_apart() {
        let group = |(name, dimension): &(&str, usize)| Group {
            name: (*name).to_owned(),
            dimension: *dimension,
            ..Group::default()
        };
        let named = |told: &[(&str, usize)]| -> Vec<String> {
            let mut groups: Vec<Group> = told.iter().map(group).collect();
            distinguish(&mut groups);
            groups.into_iter().map(|own| own.name).collect()
        };
        assert_eq!(named(&[("arm", 2), ("Root", 1)]), ["arm", "Root"]);
        let told = [("part", 0), ("part", 1), ("part", 2), ("a b", 1), ("A_b", 1)];
        assert_eq!(named(&told), ["part_POINT", "part_CURVE", "part", "a b", "A_b_2"]);
        // a name that is made is not one that is there
        let told = [("part", 1), ("part_curve", 1), ("part", 2)];
        assert_eq!(named(&told), ["part_CURVE_2", "part_curve", "part"]);
        assert_eq!(named(&[("Gräße", 1), ("Größe", 1)]), ["Gräße", "Größe_2"]);
    }
}
