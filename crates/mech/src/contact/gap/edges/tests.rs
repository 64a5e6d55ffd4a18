use super::*;

/// Two edges that cross, none of them along an axis.
fn example(lift: f64) -> [f64; VARIABLES] {
    [0.1, -0.9, lift, 0.3, 1.2, 0.2 + lift, -0.8, 0.15, 0.05, 1.1, -0.1, -0.12]
}

fn edges(x: &[f64; VARIABLES]) -> [[Vector; 2]; 2] {
    let at = |k: usize| [x[3 * k], x[3 * k + 1], x[3 * k + 2]];
    [[at(0), at(1)], [at(2), at(3)]]
}

fn gap(x: &[f64; VARIABLES]) -> EdgeGap {
    EdgeGap::new(edges(x), [0.0, 0.0, 1.0]).unwrap()
}

const STEP: f64 = 1e-6;

fn differences<const N: usize>(
    x: &[f64; VARIABLES],
    of: impl Fn(&[f64; VARIABLES]) -> [f64; N],
) -> [[f64; VARIABLES]; N] {
    let mut all = [[0.0; VARIABLES]; N];
    for k in 0..VARIABLES {
        let moved = [STEP, -STEP].map(|step| {
            let mut moved = *x;
            moved[k] += step;
            of(&moved)
        });
        for (row, (a, b)) in all.iter_mut().zip(moved[0].iter().zip(moved[1])) {
            row[k] = (a - b) / (2.0 * STEP);
        }
    }
    all
}

fn assert_near(own: &[f64], other: &[f64], what: &str) {
    for (k, (a, b)) in own.iter().zip(other).enumerate() {
        assert!((a - b).abs() < 1e-8, "{what} {k}: {a} {b}");
    }
}

/// Requirement: gap and normal are those of the nearest places, whichever way edges run; edges along one another do
/// not cross.
#[test]
fn the_gap_is_the_distance_of_the_nearest_places() {
    for lift in [0.3, -0.2] {
        let x = example(lift);
        let own = gap(&x);
        let way = way_between(edges(&x), own.at);
        assert_near(&way, &scale(own.normal, own.gap), "way");
        assert!(own.normal[2] > 0.9 && own.gap * lift > 0.0, "{own:?}");
        let [[a, b], [c, d]] = edges(&x);
        let turned = EdgeGap::new([[b, a], [d, c]], [0.0, 0.0, 1.0]).unwrap();
        assert!((turned.gap - own.gap).abs() < 1e-14);
        assert!((turned.at[0] + own.at[0] - 1.0).abs() < 1e-14);
        assert!(EdgeGap::new([[a, b], [a, b]], [0.0, 0.0, 1.0]).is_none());
    }
}

/// Requirement: derivatives of overclosure and directions are those of differences; the tangent is that of gradient and drags.
#[test]
fn derivatives_are_those_of_differences() {
    for lift in [0.3, -0.2] {
        let x = example(lift);
        let own = gap(&x);
        assert_near(&own.gradient(), &differences(&x, |x| [-gap(x).gap])[0], "gap");
        let vector = [0.4, -0.7, 0.3];
        for k in 0..2 {
            let of = |x: &[f64; VARIABLES]| [dot(gap(x).directions[k], vector)];
            assert_near(&own.direction_follows(k, vector), &differences(&x, of)[0], "direction");
        }
        let (normal, tangential) = (1.7, [0.6, -1.3]);
        let force = |x: &[f64; VARIABLES]| {
            let own = gap(x);
            let mut sum = own.gradient().map(|value| normal * value);
            add_to(&mut sum, &own.drag(0), tangential[0]);
            add_to(&mut sum, &own.drag(1), tangential[1]);
            sum
        };
        let mut tangent = [0.0; VARIABLES * VARIABLES];
        own.derivative(normal, tangential, &mut tangent);
        for (row, expected) in tangent.chunks(VARIABLES).zip(differences(&x, force)) {
            assert_near(row, &expected, "tangent");
        }
    }
}

/// Requirement: overclosure and drags do nothing as the whole moves as one, at any gap: forces and moments balance.
#[test]
fn forces_and_moments_balance() {
    let x = example(0.3);
    let own = gap(&x);
    for row in [own.gradient(), own.drag(0), own.drag(1)] {
        let mut moment = [0.0; 3];
        let mut force = [0.0; 3];
        for k in 0..4 {
            let at: Vector = std::array::from_fn(|axis| x[3 * k + axis]);
            let part: Vector = std::array::from_fn(|axis| row[3 * k + axis]);
            (force, moment) = (add(force, part), add(moment, cross(at, part)));
        }
        assert!(size(force) < 1e-14 && size(moment) < 1e-14, "{force:?} {moment:?}");
    }
}
