//! What faces a slave face.

use super::*;

/// Requirement: of two masters on a line the nearer one counts, and one that turns its back hides what
/// lies behind it.
#[test]
fn the_nearest_counts() {
    let slave = paved(4, 1, 0.0, false)[0];
    let faced = |heights: &[(f64, bool)]| {
        let masters: Vec<Faced> = heights
            .iter()
            .enumerate()
            .map(|(face, &(height, down))| {
                let places = paved(4, 1, height, down)[0];
                Faced {
                    face,
                    nodes: [0; MOST_NODES],
                    places,
                    ends: FaceEnds::default(),
                    thickness: f64::INFINITY,
                }
            })
            .collect();
        let mut overlaps = Vec::new();
        Cover::default().find(looking(&slave, &FaceEnds::default()), &masters, &mut overlaps);
        overlaps.iter().map(|own| own.master).collect::<Vec<_>>()
    };
    assert_eq!(faced(&[(0.4, true), (0.3, true)]), [1]);
    assert_eq!(faced(&[(-0.4, true), (-0.1, false)]), Vec::<usize>::new());
    assert_eq!(faced(&[(-0.1, true), (-0.4, false)]), [0]);
    assert_eq!(faced(&[(0.1, true), (9.0, true)]), [0]);
    assert!(dot(sub(slave.nodes[0], slave.nodes[2]), [1.0, 1.0, 0.0]) < 0.0);
}

/// Requirement: what lies along an end of the slave and is deeper than it is wide is not covered, whether it is one face
/// of the master or several; what covers all of the slave, is as wide as it is deep, or lies along no end, is.
#[test]
fn an_end_that_went_in_elsewhere_meets_nothing() {
    let slave = paved(4, 1, 0.0, false)[0];
    // one edge is an end: y = -1
    let mut ends = FaceEnds::default();
    (ends.edges[0], ends.nodes[0], ends.nodes[1]) = (true, true, true);
    let found = |ends: &FaceEnds, cells: usize, depth: f64, [from, to]: [f64; 2]| {
        let place = |mut own: FacePlaces<f64>| {
            for node in &mut own.nodes[..own.count] {
                node[1] = from + 0.5 * (1.0 + node[1]) * (to - from);
            }
            Faced {
                face: 0,
                nodes: [0; MOST_NODES],
                places: own,
                ends: FaceEnds::default(),
                thickness: f64::INFINITY,
            }
        };
        let masters: Vec<Faced> = paved(4, cells, -depth, true).into_iter().map(place).collect();
        let mut overlaps = Vec::new();
        Cover::default().find(looking(&slave, ends), &masters, &mut overlaps);
        overlaps
    };
    let covered = |ends: &FaceEnds, cells: usize, depth: f64, across: [f64; 2]| {
        found(ends, cells, depth, across).len()
    };
    // from as deep as wide, 0.4, to twice that it counts less and less, without a leap
    let counts = |step: i32| {
        let depth = 0.3 + 0.001 * f64::from(step);
        found(&ends, 1, depth, [-2.0, -0.6]).first().map_or(0.0, |own| own.counts)
    };
    let all: Vec<f64> = (0..=600).map(counts).collect();
    assert!(all[..100].iter().all(|&own| own == 1.0) && all[501..].iter().all(|&own| own == 0.0));
    assert!(all.windows(2).all(|two| (two[0] - two[1]).abs() < 0.005));
    for cells in [1, 3] {
        let all = cells * cells;
        assert_eq!(covered(&ends, cells, 0.5, [-2.0, -0.9]), 0);
        assert!(covered(&ends, cells, 0.5, [-2.0, -0.4]) > 0);
        assert!(covered(&ends, cells, 0.05, [-2.0, -0.9]) > 0);
        assert_eq!(covered(&ends, cells, 0.5, [-1.0, 1.0]), all);
        assert_eq!(covered(&ends, cells, 3.0, [-1.0, 1.0]), all);
        assert!(covered(&FaceEnds::default(), cells, 0.5, [-2.0, -0.9]) > 0);
        assert!(covered(&ends, cells, 0.5, [0.9, 2.0]) > 0);
    }
}

/// Requirement: a face as deep in a part as that, or its own part, is thick was not gone through: it is seen through it.
#[test]
fn what_is_seen_through_a_part_is_not_met() {
    let (slave, ends) = (paved(4, 1, 0.0, false)[0], FaceEnds::default());
    let covered = |depth: f64, [own, other]: [f64; 2]| {
        let places = paved(4, 1, -depth, true)[0];
        let masters = [Faced { face: 0, nodes: [0; MOST_NODES], places, ends, thickness: other }];
        let mut overlaps = Vec::new();
        let looking = Looking { thickness: own, ..looking(&slave, &ends) };
        Cover::default().find(looking, &masters, &mut overlaps);
        overlaps.len()
    };
    let open = f64::INFINITY;
    for (thick, is_met) in [([open, open], 1), ([0.6, open], 1), ([0.4, open], 0), ([open, 0.4], 0)]
    {
        assert_eq!(covered(0.4, thick), is_met, "{thick:?}");
    }
    // what is in front is met however thin both are
    assert_eq!(covered(-0.4, [0.1, 0.1]), 1);
}

/// Requirement: surfaces that end together, to less than a hundredth of a piece, cover one another whole, along one end
/// and where two of them meet.
#[test]
fn surfaces_that_end_together_cover_one_another_whole() {
    let mut random = Random(5);
    for nodes in [3, 4, 6, 8] {
        let slave = face(nodes, [0.0; 3], 0.0, false, &mut random);
        let measure = reference_areas(&slave);
        let ends = Ends { slave: ALL_ENDS, master: ALL_ENDS };
        let whole: f64 = slave.corner_areas(&measure)[..corners(nodes)].iter().sum();
        let lows = (0..2).map(|axis| slave.nodes[..nodes].iter().map(move |at| at[axis]));
        let lows: Vec<f64> = lows.map(|all| all.fold(f64::INFINITY, f64::min)).collect();
        for within in [0.0, 1e-9, 1e-4, 4e-3] {
            // beyond the other ends it goes on
            for sides in [[true, false], [false, true], [true, true]] {
                let mut master = face(4, [0.0, 0.0, 0.1], 0.0, true, &mut random);
                for node in &mut master.nodes[..4] {
                    for axis in 0..2 {
                        let low = lows[axis] + if sides[axis] { within } else { -1.0 };
                        node[axis] = if node[axis] < 0.5 * (lows[axis] + 1.0) { low } else { 3.0 };
                    }
                }
                let case = Case { slave, master, measure, ends };
                let covered: f64 = case.sums(&case.overlaps()).areas.iter().sum();
                assert!(
                    (covered - whole).abs() < 1e-12 * whole,
                    "{nodes} {within} {sides:?}: {covered}"
                );
            }
        }
    }
}
