use super::super::chain::{Chain, PieceKind};
use super::super::nearest::Nearby;
use super::*;

/// Nodes of a circle about the origin at these angles [degrees].
fn on_circle(radius: f64, angles: impl Iterator<Item = f64>) -> Vec<[f64; 3]> {
    let at = |angle: f64| {
        let (s, c) = angle.to_radians().sin_cos();
        [radius * c, radius * s, 0.0]
    };
    angles.map(at).collect()
}

fn drawn(nodes: &[[f64; 3]]) -> Chain {
    Chain::new(nodes, None, 0.1).unwrap()
}

fn joined(nodes: &[[f64; 2]]) -> Vec<bool> {
    let nodes: Vec<_> = nodes.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let lengths: Vec<f64> = nodes
        .windows(2)
        .map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]))
        .collect();
    let mut through = Through::default();
    through.draw(nodes.iter().copied(), &lengths);
    (0..nodes.len()).map(|node| through.is_joined(node)).collect()
}

/// Requirement: the curve passes its nodes, and leaves a circle between them with the fourth power of the chord at
/// even nodes: a quarter of the angle, 256 times nearer.
#[test]
fn it_passes_the_nodes_of_a_circle_and_stays_near_it() {
    let off = |step: f64| {
        let nodes = on_circle(2.0, (0..9).map(|k| step * f64::from(k)));
        let chain = drawn(&nodes);
        let curve = chain.curve(4).unwrap();
        for (s, node) in [(0.0, 4), (1.0, 5)] {
            let (place, _) = curve.place(&nodes, s);
            assert!((place[0] - nodes[node][0]).abs() < 1e-15);
            assert!((place[1] - nodes[node][1]).abs() < 1e-15);
        }
        let (place, _) = curve.place(&nodes, 0.5);
        (place[0].hypot(place[1]) - 2.0).abs()
    };
    let (coarse, fine) = (off(20.0), off(5.0));
    // the chord is 0.03 off
    assert!(coarse < 8e-4, "{coarse}");
    assert!((230.0..280.0).contains(&(coarse / fine)), "{}", coarse / fine);
}

/// Requirement: two curves that meet at a node have one tangent there, whatever the segments are long, and wherever
/// the nodes have moved.
#[test]
fn curves_join_with_one_tangent() {
    let nodes = on_circle(1.0, [0.0, 10.0, 14.0, 33.0, 40.0, 60.0].into_iter());
    let chain = drawn(&nodes);
    let moved: Vec<_> =
        nodes.iter().map(|&[x, y, z]| [1.3 * x + 0.2 * y * y, 0.8 * y, z]).collect();
    for node in 1..nodes.len() - 1 {
        let ends = [(node - 1, 1.0), (node, 0.0)];
        let [a, b] = ends.map(|(part, s)| chain.curve(part).unwrap().place(&moved, s).1);
        let turn = cross(a, b) / (a[0].hypot(a[1]) * b[0].hypot(b[1]));
        assert!(turn.abs() < 1e-14 && dot(a, b) > 0.0, "{node}: {turn}");
    }
}

/// Requirement: what is round on three nodes or more is joined; ridges, chamfers and corners of 45 degrees are drawn,
/// and an arc between straight parts is joined at its ends too.
#[test]
fn ridges_and_chamfers_are_drawn() {
    let ridge = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.3], [4.0, 0.6], [5.0, 0.9]];
    assert_eq!(joined(&ridge), [false, true, false, true, true, false]);
    let chamfer = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.4], [3.5, 1.4], [4.0, 2.4]];
    assert_eq!(joined(&chamfer), [false, true, false, false, true, false]);
    let corner = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [2.0, 3.0]];
    assert_eq!(joined(&corner), [false, true, false, true, true, false]);
    let zigzag = [[0.0, 0.0], [1.0, 0.2], [2.0, 0.0], [3.0, 0.2], [4.0, 0.0], [5.0, 0.2]];
    assert_eq!(joined(&zigzag), [false; 6]);
    // two segments have a corner between them, not a curve
    assert_eq!(joined(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), [false; 3]);
    let arc = [
        [-2.0, -1.0],
        [-1.0, -1.0],
        [0.0, -1.0],
        [0.5, -0.866],
        [0.866, -0.5],
        [1.0, 0.0],
        [1.0, 1.0],
    ];
    assert_eq!(joined(&arc), [false, true, true, true, true, true, false]);
}

/// Requirement: every point near a round chain faces a piece of it, at right angles; beyond its ends by the extension
/// alone.
#[test]
fn every_point_faces_the_curve() {
    let nodes = on_circle(1.0, (0..7).map(|k| 15.0 * f64::from(k)));
    let chain = drawn(&nodes);
    for radius in [0.9, 0.999, 1.001, 1.2, 3.0] {
        for k in 0..=900 {
            let [point] = on_circle(radius, std::iter::once(0.1 * f64::from(k)))[..] else {
                panic!()
            };
            let piece = chain.closest(&nodes, Nearby::Positions, point).unwrap();
            assert!(matches!(piece.kind, PieceKind::Curve { .. }));
            let (foot, tangent) = chain.curve(piece.index).unwrap().place(&nodes, piece.parameter);
            let apart = sub(flat(point), foot);
            assert!(dot(apart, tangent).abs() < 1e-12, "{radius} {k}");
            assert!((apart[0].hypot(apart[1]) - (radius - 1.0).abs()).abs() < 1e-3);
        }
    }
    let far = on_circle(1.0, [-10.0].into_iter())[0];
    assert_eq!(chain.closest(&nodes, Nearby::Positions, far), None);
}

/// Requirement: every place about a valley between two domes, and about a ridge between two hollows, outside and inside,
/// faces a piece: curves, roundings and wedges leave no sector between them. (Nearer to the bottom of so steep a valley than
/// its rounding reaches, places outside have none.)
#[test]
fn nothing_is_left_between_curves_and_corners() {
    let arc = |mirrored: bool, k: i32| {
        let (s, c) = f64::to_radians(165.0 - 15.0 * f64::from(k)).sin_cos();
        [c + if mirrored { 1.0 } else { -1.0 }, s - f64::to_radians(15.0).sin(), 0.0]
    };
    let out = f64::to_radians(15.0).cos();
    // two domes side by side meet at the origin
    let domes: Vec<_> = (0..=10)
        .map(|k| [arc(false, k)[0] + 1.0 - out, arc(false, k)[1], 0.0])
        .chain((1..=10).map(|k| [arc(true, k)[0] - 1.0 + out, arc(true, k)[1], 0.0]))
        .collect();
    let hollows: Vec<_> = domes.iter().map(|&[x, y, z]| [x, -y, z]).collect();
    for (name, nodes) in [("domes", domes), ("hollows", hollows)] {
        let chain = drawn(&nodes);
        assert!(!chain.is_joined(10) && chain.is_joined(9) && chain.is_joined(11), "{name}");
        for radius in [0.01, 0.1] {
            for k in 0..3600 {
                let [point] = on_circle(radius, std::iter::once(0.1 * f64::from(k)))[..] else {
                    panic!()
                };
                let piece = chain.closest(&nodes, Nearby::Positions, point);
                assert!(piece.is_some(), "{name} {radius} {k}");
            }
        }
    }
}

/// Requirement: a tree of the segments changes no answer of a chain of curves, ridges and valleys, nor do reaches.
#[test]
fn a_tree_changes_no_answer() {
    let nodes: Vec<[f64; 3]> = (0..120)
        .map(|k| {
            let (turn, bump) = (f64::from(k) * 0.05, f64::from(u8::from(k % 17 == 0)));
            let radius = 4.0 + 0.3 * bump + (3.0 * turn).cos();
            [radius * turn.cos(), radius * turn.sin(), 0.0]
        })
        .collect();
    let chain = drawn(&nodes);
    assert!((0..119).any(|part| chain.curve(part).is_some()));
    assert!((0..119).any(|part| chain.curve(part).is_none()));
    let tree = chain.tree(&nodes);
    let reaches: Vec<_> = (0..119).map(|part| chain.reach(&nodes, part)).collect();
    let mut curved = 0;
    for k in 0..3000 {
        let (a, b) = (f64::from(k) * 0.37, f64::from(k) * 0.61);
        let p = [6.0 * a.sin(), 6.0 * b.cos(), 0.0];
        let all = chain.closest(&nodes, Nearby::Positions, p);
        assert_eq!(all, chain.closest(&nodes, Nearby::Tree(&tree), p), "{p:?}");
        assert_eq!(all, chain.closest(&nodes, Nearby::Reaches(&reaches), p), "{p:?}");
        let on_curve =
            |piece: &super::super::chain::Piece| matches!(piece.kind, PieceKind::Curve { .. });
        curved += usize::from(all.as_ref().is_some_and(on_curve));
    }
    assert!(curved > 500, "{curved}");
}
