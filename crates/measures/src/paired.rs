//! Curves that belong together.

/// Two slices of equal length, not empty.
pub(crate) fn paired<'a>(
    a: &'a [f64],
    b: &'a [f64],
) -> Option<impl Iterator<Item = (f64, f64)> + 'a> {
    (a.len() == b.len() && !a.is_empty()).then(|| a.iter().copied().zip(b.iter().copied()))
}
