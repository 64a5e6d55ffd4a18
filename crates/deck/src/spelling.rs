//! Names: what counts as the same word, and which word was probably meant.

/// Upper case, blanks inside removed: `Friction  Onset` is `FRICTIONONSET`.
pub fn normalise(raw: &str) -> String {
    if raw.bytes().all(|letter| letter.is_ascii_graphic()) {
        return raw.to_ascii_uppercase();
    }
    raw.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_uppercase).collect()
}

/// The candidate nearest in spelling, if any is near enough to be meant:
/// one slip (insertion, deletion, exchange, transposition) in a short word, and
/// one for every four letters in a long one. Both sides are compared normalised.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = normalise(word);
    if word.len() > 64 {
        return None; // no keyword is that long, and the comparison is quadratic
    }
    let reach = (word.chars().count() / 4).max(1);
    candidates
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(&word, &normalise(candidate)), candidate))
        .filter(|&(distance, _)| distance <= reach)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_found_and_a_stranger_is_not() {
        let known = ["FRICTION", "BOUNDARY", "SLIDE LINE"];
        assert_eq!(nearest("FRICTON", known), Some("FRICTION"));
        assert_eq!(nearest("sildeline", known), Some("SLIDE LINE"));
        assert_eq!(nearest("HEADING", known), None);
        assert_eq!(nearest("", known), None);
    }

    #[test]
    fn case_and_blanks_do_not_matter() {
        assert_eq!(normalise(" friction\tOnset "), "FRICTIONONSET");
    }
}
