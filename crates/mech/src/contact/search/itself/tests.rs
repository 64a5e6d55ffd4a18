use super::super::chain::raised;
use super::{Chain, ChainTree, Itself, Placed, Run, at_piece, flat, listed};

type Plane = [f64; 2];

/// A surface of runs at its undeformed place, to be searched where it stands.
struct Surface {
    own: Itself,
    chain: Chain,
    list: Vec<usize>,
    runs: Vec<Run>,
}

impl Surface {
    fn new(runs: &[(&[Plane], bool)]) -> Self {
        Self::smoothed(runs, 0.2)
    }

    /// The same with a part of each face for the corners.
    fn smoothed(runs: &[(&[Plane], bool)], smoothing: f64) -> Self {
        let nodes: Vec<Plane> = runs.iter().flat_map(|(nodes, _)| nodes.to_vec()).collect();
        let runs: Vec<Run> =
            runs.iter().map(|&(nodes, is_closed)| Run { nodes: nodes.len(), is_closed }).collect();
        let list = listed(&runs);
        let reference: Vec<_> = list.iter().map(|&k| raised(nodes[k])).collect();
        let (own, chain) = Itself::new(&runs, &reference, (smoothing, 0.1)).unwrap();
        Self { own, chain, list, runs }
    }

    /// What the node of a number meets at these positions: the numbers of the nodes of the piece.
    fn met(&self, nodes: &[Plane], number: usize) -> Option<Vec<usize>> {
        let at: Vec<_> = self.list.iter().map(|&k| raised(nodes[k])).collect();
        let tree: ChainTree = self.own.tree(&self.chain, &at);
        let placed = Placed { chain: &self.chain, positions: &at, tree: &tree };
        let found = self.own.closest(placed, self.own.seat(number))?;
        Some(found.nodes().map(|place| self.list[place]).collect())
    }

    fn count(&self) -> usize {
        self.runs.iter().map(|run| run.nodes).sum()
    }
}

/// The wall of a hole, travelled with the material on the right: counter-clockwise.
fn hole(count: usize, (a, b): (f64, f64)) -> Vec<Plane> {
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
    (0..count).map(|k| [a * angle(k).cos(), b * angle(k).sin()]).collect()
}

/// The rim of a disk: clockwise.
fn rim(count: usize, axes: (f64, f64)) -> Vec<Plane> {
    hole(count, axes).into_iter().rev().collect()
}

/// Requirement: in a flat hole every node of one side meets the other side and none of its own,
/// the node first in order is the slave, and never are both; the seam changes nothing.
#[test]
fn sides_of_a_hole_meet_once() {
    for seam in [0, 5, 10, 17] {
        let turned = |mut nodes: Vec<Plane>| {
            nodes.rotate_left(seam);
            nodes
        };
        let (round, flat) = (turned(hole(40, (1.0, 1.0))), turned(hole(40, (1.4, 0.02))));
        let hole = Surface::new(&[(&round, true)]);
        let met: Vec<_> = (0..40).map(|k| hole.met(&flat, k)).collect();
        let slaves = met.iter().filter(|met| met.is_some()).count();
        assert!((16..=21).contains(&slaves), "{slaves}");
        for (k, own) in met.iter().enumerate() {
            for &other in own.iter().flatten() {
                assert!(flat[k][1] * flat[other][1] <= 1e-12, "{k} meets its own side: {other}");
            }
            let nearest = |k: usize| {
                let apart =
                    |&node: &usize| (flat[k][0] - flat[node][0]).hypot(flat[k][1] - flat[node][1]);
                let nodes = met[k].iter().flatten().copied();
                nodes.min_by(|a, b| apart(a).total_cmp(&apart(b)))
            };
            let back = nearest(k).and_then(nearest);
            assert!(back != Some(k), "{k} and {:?} are both slaves", nearest(k));
        }
    }
}

/// Requirement: nothing on the rim of a part meets the rim on its other side, from behind through
/// the part: neither undeformed nor flattened to a fifth.
#[test]
fn a_part_does_not_meet_its_own_inside() {
    let round = rim(40, (1.0, 1.0));
    let part = Surface::new(&[(&round, true)]);
    for flat in [1.0, 0.6, 0.2] {
        let pressed = rim(40, (1.0 / flat, flat));
        assert!((0..part.count()).all(|k| part.met(&pressed, k).is_none()), "{flat}");
    }
}

/// Requirement: the same through the wall of a tube, whose hole and rim are two runs; when the
/// tube is flat the sides of its hole meet, and nothing meets through both walls.
#[test]
fn walls_stand_between() {
    let (inner, outer) = (hole(40, (1.0, 1.0)), rim(40, (1.1, 1.1)));
    let tube = Surface::new(&[(&outer, true), (&inner, true)]);
    let all = |a: Vec<Plane>, b: Vec<Plane>| [a, b].concat();
    let flat = all(rim(40, (1.5, 0.11)), hole(40, (1.4, 0.01)));
    for k in 0..40 {
        assert_eq!(tube.met(&flat, k), None, "rim {k}");
    }
    let inside: Vec<_> = (40..80).filter_map(|k| tube.met(&flat, k)).collect();
    assert!(inside.len() > 14 && inside.iter().flatten().all(|&node| node >= 40));
}

/// Requirement: of two runs that come near each other a node meets the other one, in front of it
/// or sunk in up to half the thickness, and not deeper.
#[test]
fn runs_meet_one_another() {
    let block = |y: f64| vec![[-2.0, y], [-2.0, y + 1.0], [2.0, y + 1.0], [2.0, y]];
    let tip = |y: f64| vec![[1.0, y], [0.0, y - 1.0], [-1.0, y]];
    let parts = Surface::new(&[(&block(0.0), true), (&tip(3.0), false)]);
    let placed = |y: f64| [block(0.0), tip(y)].concat();
    for (height, meets) in [(3.0, true), (2.001, true), (1.6, true), (1.4, false)] {
        let met = parts.met(&placed(height), 5);
        assert_eq!(met == Some(vec![1, 2]), meets, "{height}");
    }
}

/// Requirement: slips go the short way round a closed run, and start anew on another one.
#[test]
fn slips_know_the_seam() {
    let (one, two) = (hole(8, (1.0, 1.0)), hole(8, (3.0, 3.0)));
    let own = Surface::new(&[(&one, true), (&two, true)]);
    let side = own.chain.reference_length(1);
    let [begin, end] = [1, 9].map(|place| own.chain.arc_coordinate(place));
    let slip = |from: f64, to: f64| own.own.slip(&own.chain, from, to);
    assert!((slip(end - 0.1 * side, begin + 0.2 * side) - 0.3 * side).abs() < 1e-12);
    assert!((slip(begin + side, begin + 3.0 * side) - 2.0 * side).abs() < 1e-12);
    assert_eq!(slip(begin + side, own.chain.arc_coordinate(15)), 0.0);
}

/// Requirement: runs too short for a surface and faces without length are refused.
#[test]
fn what_is_no_surface_is_refused() {
    let make = |run: Run, nodes: &[Plane]| {
        let list = listed(&[run]);
        let at: Vec<_> = list.iter().map(|&k| raised(nodes[k])).collect();
        Itself::new(&[run], &at, (0.2, 0.1)).is_some()
    };
    let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.5]];
    assert!(make(Run { nodes: 3, is_closed: false }, &line));
    assert!(!make(Run { nodes: 1, is_closed: false }, &line));
    assert!(!make(Run { nodes: 2, is_closed: true }, &line));
    assert!(!make(Run { nodes: 3, is_closed: false }, &[[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]]));
    assert!(Itself::new(&[], &[], (0.2, 0.1)).is_none());
}

/// Requirement: faces at a right angle do not look at one another, however the strip is turned and as
/// exactly as a deck gives its nodes: the nodes of a long thin strip meet nothing, its ends least of all.
#[test]
fn faces_at_a_right_angle_do_not_meet() {
    let mut nodes: Vec<Plane> = (0..20).map(|k| [2.0 * f64::from(k), 1.0]).collect();
    nodes.extend((1..=20).rev().map(|k| [2.0 * f64::from(k), 0.0]));
    nodes.insert(20, [40.0, 1.0]);
    nodes.push([0.0, 0.0]);
    for turn in [0.0_f64, 0.3, 0.7, 1.1, 2.0] {
        let (s, c) = turn.sin_cos();
        let turned: Vec<Plane> = nodes
            .iter()
            .map(|&[x, y]| [c * x - s * y, s * x + c * y].map(|x| (x * 1e6).round() / 1e6))
            .collect();
        for smoothing in [0.2, 0.0] {
            let strip = Surface::smoothed(&[(&turned, true)], smoothing);
            for node in 0..strip.count() {
                assert_eq!(strip.met(&turned, node), None, "{turn} {smoothing} {node}");
            }
        }
    }
}

/// Requirement: a node in a valley, where a hook begins below an arm, does not meet the far flank of the
/// hook through it: the way there leaves one of its faces by a little and goes in through the other.
#[test]
fn a_node_in_a_valley_does_not_see_through_its_part() {
    for height in [0.5, 0.8, 1.0, 1.15, 1.3, 1.6, 2.0] {
        let below = |x: f64| {
            -0.5 * height * (1.0 + (std::f64::consts::PI * (x - 10.8).abs().min(1.0)).cos())
        };
        let along = |k: u16| f64::from(k) * 12.0 / 112.0;
        let mut arm: Vec<Plane> = (0..=112).map(|k| [along(k), 1.0]).collect();
        arm.extend((0..=112).rev().map(|k| [along(k), below(along(k))]));
        let own = Surface::new(&[(&arm, true)]);
        for (node, at) in arm.iter().enumerate() {
            assert_eq!(own.met(&arm, node), None, "{height} {at:?}");
        }
    }
}

/// Requirement: nor do the sides of a strip that is bent a little meet its ends, through its length.
#[test]
fn the_sides_of_a_bent_strip_do_not_meet_its_ends() {
    let mut nodes: Vec<Plane> = (0..=20).map(|k| [2.0 * f64::from(k), 1.0]).collect();
    nodes.extend((0..=20).rev().map(|k| [2.0 * f64::from(k), 0.0]));
    let strip = Surface::new(&[(&nodes, true)]);
    for curvature in [-0.02, -0.004, -0.001, 0.001, 0.004, 0.02_f64] {
        let bent: Vec<Plane> = nodes
            .iter()
            .map(|&[x, y]| {
                let (s, c) = (curvature * x).sin_cos();
                [s / curvature - y * s, (1.0 - c) / curvature + y * c]
            })
            .collect();
        for node in 0..strip.count() {
            assert_eq!(strip.met(&bent, node), None, "{curvature} {node}");
        }
    }
}

/// A part of columns side by side on one base, each of its own height, with nodes on all borders of columns, and on the
/// walls every `rise` at random: L, T, steps, combs, thin webs. Clockwise from the left below.
fn columns(heights: &[f64], width: f64, rise: f64, noise: &mut impl FnMut() -> f64) -> Vec<Plane> {
    let mut outline = vec![[0.0, 0.0]];
    let mut level = 0.0;
    for (k, height) in heights.iter().chain([&0.0]).enumerate() {
        let count = ((height - level) / rise).abs().round() as usize;
        let split = noise() > 0.5;
        for step in (1..count).filter(|_| split) {
            let part = step as f64 / count as f64;
            outline.push([k as f64 * width, level + part * (height - level)]);
        }
        if count > 0 {
            outline.push([k as f64 * width, *height]);
        }
        if k < heights.len() {
            outline.push([(k + 1) as f64 * width, *height]);
        }
        level = *height;
    }
    outline.extend((1..heights.len()).rev().map(|k| [k as f64 * width, 0.0]));
    outline
}

/// Whether a place is within an outline and away from it, by a hundredth of the least width: a foot on a wall is not
/// within. By the count of crossings.
fn is_within(outline: &[Plane], [x, y]: Plane) -> bool {
    let edges = || outline.iter().zip(outline.iter().cycle().skip(1));
    let away = |(a, b): (&Plane, &Plane)| {
        let (edge, way) = ([b[0] - a[0], b[1] - a[1]], [x - a[0], y - a[1]]);
        let along = (edge[0] * way[0] + edge[1] * way[1]) / (edge[0].powi(2) + edge[1].powi(2));
        let along = along.clamp(0.0, 1.0);
        (way[0] - along * edge[0]).hypot(way[1] - along * edge[1]) > 1e-3
    };
    let crosses = |(a, b): &(&Plane, &Plane)| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    edges().all(away) && edges().filter(crosses).count() % 2 == 1
}

/// Requirement: no node of a part has sunk in anywhere, nor comes near a face in whose line it stands through the part,
/// undeformed and a little bent, wherever its nodes stand below its valleys. Source: the parts touch nowhere; the count of
/// crossings of the outline, half way from the node to what it meets.
#[test]
fn nothing_is_met_through_the_part() {
    let mut seed = 1_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 40) as f64 / (1_u64 << 24) as f64
    };
    let mut met = 0;
    for case in 0..400 {
        let heights: Vec<f64> =
            (0..2 + case % 9).map(|_| 0.3 * (1.0 + (4.0 * noise()).floor())).collect();
        let width = 0.1 + 0.4 * noise();
        let mut outline = columns(&heights, width, 0.3, &mut noise);
        outline.rotate_left(case % 3);
        let smoothing = [0.0, 0.2, 0.45][case % 3];
        let part = Surface::smoothed(&[(&outline, true)], smoothing);
        let (bend, slant) = (0.06 * (noise() - 0.5), 0.06 * (noise() - 0.5));
        let bent =
            outline.iter().map(|[x, y]| [x + slant * y, y + slant * x + bend * x * x]).collect();
        for nodes in [outline, bent] {
            met += met_in_sight(&part, &nodes, case);
        }
    }
    assert!(met > 500, "{met}");
}

/// How many nodes meet something; none through the part.
fn met_in_sight(part: &Surface, nodes: &[Plane], case: usize) -> usize {
    let at: Vec<_> = part.list.iter().map(|&k| raised(nodes[k])).collect();
    let tree = part.own.tree(&part.chain, &at);
    let placed = Placed { chain: &part.chain, positions: &at, tree: &tree };
    let found = (0..nodes.len()).filter_map(|k| Some((k, part.own.met(placed, part.own.seat(k))?)));
    let found = found.inspect(|(node, piece)| {
        let (foot, along) = at_piece(&part.chain, &at, piece).unwrap();
        let foot = match piece.kind {
            super::PieceKind::Straight => {
                let s = piece.parameter.clamp(0.0, 1.0);
                let a = flat(at[piece.index]);
                [a[0] + s * along[0], a[1] + s * along[1]]
            }
            _ => foot,
        };
        let [x, y] = nodes[*node];
        let middle = [0.5 * (foot[0] + x), 0.5 * (foot[1] + y)];
        let way = [x - foot[0], y - foot[1]];
        let gap = (along[0] * way[1] - along[1] * way[0]) / along[0].hypot(along[1]);
        // a gap that is much shorter than the way to the face itself is one to its line, beyond its end
        let is_near = gap < 0.3 * way[0].hypot(way[1]);
        assert!(gap >= 0.0, "{case}: node {node} overlaps {piece:?} by {gap}: {nodes:?}");
        assert!(!is_near || !is_within(nodes, middle), "{case}: {node} {piece:?} {nodes:?}");
    });
    found.count()
}
