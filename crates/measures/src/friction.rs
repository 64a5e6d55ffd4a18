//! How much friction an onset rule kept.

/// Friction kept in each increment [-]:
/// (RF - RF at mu = 0)/(RF IMMEDIATE - RF at mu = 0) [verification: metrics].
///
/// 1 where all of it acts, 0 where it was dropped. An entry is `None` where friction is
/// less than `noise_floor` times the largest friction of the curve: there is
/// nothing to keep. `None` as a whole for lengths that differ.
pub fn friction_kept(
    values: &[f64],
    immediate: &[f64],
    frictionless: &[f64],
    noise_floor: f64,
) -> Option<Vec<Option<f64>>> {
    if values.len() != immediate.len() || values.len() != frictionless.len() {
        return None;
    }
    let full: Vec<f64> = immediate.iter().zip(frictionless).map(|(a, b)| a - b).collect();
    let floor = noise_floor * crate::difference::maximum(&full)?;
    let kept = |i: usize| (full[i].abs() > floor).then(|| (values[i] - frictionless[i]) / full[i]);
    Some((0..values.len()).map(kept).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn share_of_each_increment() {
        let kept = friction_kept(
            &[0.0, -1.0, -2.0, -5.0],
            &[0.0, -2.0, -4.0, -5.0],
            &[0.0, -1.0, -1.0, -1.0],
            1e-9,
        );
        assert_eq!(kept, Some(vec![None, Some(0.0), Some(1.0 / 3.0), Some(1.0)]));
        assert_eq!(friction_kept(&[0.0], &[0.0, 1.0], &[0.0], 1e-9), None);
    }
}
