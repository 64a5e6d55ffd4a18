use super::super::nearest::Nearby;
use super::{Chain, PieceKind, raised};

fn zigzag() -> Vec<[f64; 3]> {
    [[0.0, 0.0], [1.0, 0.0], [2.0, 0.5], [3.5, 0.0]].map(raised).to_vec()
}

/// Requirement: corners join straight parts with continuous arc coordinate; pieces tile the chain.
#[test]
fn kinds_along_the_chain() {
    let chain = Chain::new(&zigzag(), Some(0.25), 0.1).unwrap();
    let at = |x: f64, y: f64| chain.closest(&zigzag(), Nearby::Positions, [x, y, 0.0]).unwrap();
    assert_eq!((at(0.5, 0.1).index, at(0.5, 0.1).kind), (0, PieceKind::Straight));
    assert_eq!((at(1.0, 0.1).index, at(1.0, 0.1).kind), (1, PieceKind::Corner));
    assert_eq!(at(1.0, 0.1).nodes(), 0..3);
    assert_eq!((at(2.0, 0.5).index, at(2.0, 0.5).kind), (2, PieceKind::Corner));
    assert_eq!(at(-0.05, 0.1).kind, PieceKind::Straight);
    assert!(at(-0.05, 0.1).parameter < 0.0);
}

/// Requirement: beyond the extension there is no contact, and it is told apart from far away.
#[test]
fn sliding_off_the_end() {
    let chain = Chain::new(&zigzag(), Some(0.25), 0.1).unwrap();
    let x = zigzag();
    assert!(chain.closest(&x, Nearby::Positions, [-0.11, 0.02, 0.0]).is_none());
    assert!((chain.beyond_end(&x, [-0.11, 0.02, 0.0]).unwrap() + 0.02).abs() < 1e-15);
    assert!(chain.beyond_end(&x, [3.9, -0.1, 0.0]).is_some());
    assert!(chain.beyond_end(&x, [-7.0, 0.0, 0.0]).is_some());
    assert_eq!(chain.beyond_end(&x, [0.5, 0.0, 0.0]), None);
}

/// Requirement: no hole within 0.1 of the chain on either side, smoothed or not, and the distance
/// found changes continuously along a line of points.
#[test]
fn no_hole() {
    let x = zigzag();
    for smoothing in [0.0, 0.1, 0.25, 0.49] {
        let chain = Chain::new(&x, Some(smoothing), 0.1).unwrap();
        for segment in 0..3 {
            let (a, b) = (x[segment], x[segment + 1]);
            for i in 0..=2000 {
                let s = f64::from(i) / 2000.0;
                for offset in [-0.1, -0.01, 0.0, 0.01, 0.1] {
                    let p = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]) + offset, 0.0];
                    let piece = chain.closest(&x, Nearby::Positions, p);
                    assert!(piece.is_some_and(|q| q.parameter.is_finite()), "{smoothing} {p:?}");
                }
            }
        }
    }
}

/// Requirement: a tree of the parts changes no answer: not the piece, not on ties, not for points
/// that face nothing, on a line that folds back on itself.
#[test]
fn the_tree_changes_no_answer() {
    let x: Vec<[f64; 3]> = (0..200)
        .map(|k| {
            let t = f64::from(k) * 0.05;
            [
                t.sin() * (4.0 + (3.1 * t).cos()),
                (1.7 * t).cos() * 3.0 + 0.02 * f64::from(k % 3),
                0.0,
            ]
        })
        .collect();
    let (mut facing, mut none) = (0, 0);
    for (smoothing, extension) in [(0.0, 0.1), (0.25, 0.0), (0.49, 2.0)] {
        let chain = Chain::new(&x, Some(smoothing), extension).unwrap();
        let tree = chain.tree(&x);
        for k in 0..4000 {
            let (a, b) = (f64::from(k) * 0.37, f64::from(k) * 0.61);
            let p = [6.0 * a.sin(), 5.0 * b.cos(), 0.0];
            let (slow, quick) = (
                chain.closest(&x, Nearby::Positions, p),
                chain.closest(&x, Nearby::Tree(&tree), p),
            );
            assert_eq!(slow, quick, "{p:?}");
            facing += i32::from(slow.is_some());
            none += i32::from(slow.is_none());
        }
        for node in &x {
            assert_eq!(
                chain.closest(&x, Nearby::Positions, *node),
                chain.closest(&x, Nearby::Tree(&tree), *node)
            );
        }
    }
    let x: Vec<[f64; 3]> = (0..70).map(|k| [f64::from(k), 0.1 * f64::from(k % 2), 0.0]).collect();
    let chain = Chain::new(&x, Some(0.2), 0.1).unwrap();
    let tree = chain.tree(&x);
    for k in 0..400 {
        let p = [-10.0 + 0.25 * f64::from(k), 3.0 * f64::from(k).sin(), 0.0];
        let (slow, quick) =
            (chain.closest(&x, Nearby::Positions, p), chain.closest(&x, Nearby::Tree(&tree), p));
        assert_eq!(slow, quick, "{p:?}");
        none += i32::from(slow.is_none());
    }
    assert!(facing > 6000 && none > 10, "{facing} {none}");
}

/// Requirement: the pieces tile the chain: along the line itself the arc coordinate grows without
/// a jump from piece to piece, and no point of it lies off the piece that it faces. Steps of 1/4000 of
/// a segment; between them the coordinate grows by no more than the longest segment's share.
#[test]
fn pieces_tile_the_chain() {
    let x = zigzag();
    for smoothing in [0.0, 0.1, 0.25, 0.49] {
        let chain = Chain::new(&x, Some(smoothing), 0.0).unwrap();
        let mut last: Option<f64> = None;
        for k in 0..=3 * 4000 {
            let (segment, s) = ((k / 4000).min(2), f64::from(k) / 4000.0);
            let s = s - f64::from(segment);
            let (a, b) = (x[segment as usize], x[segment as usize + 1]);
            let p = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), 0.0];
            let piece = chain.closest(&x, Nearby::Positions, p).unwrap();
            let (index, t) = (piece.index, piece.parameter);
            let along = match piece.kind {
                PieceKind::Straight | PieceKind::Curve { .. } => {
                    chain.arc_coordinate(index) + t * chain.reference_length(index)
                }
                PieceKind::Corner | PieceKind::Nose { .. } => {
                    let (before, after) =
                        (chain.reference_length(index - 1), chain.reference_length(index));
                    let fraction = chain.corner_fraction();
                    let (a1, a2) = (fraction * before, fraction * after);
                    chain.arc_coordinate(index) - a1 + 2.0 * a1 * t + (a2 - a1) * t * t
                }
            };
            if let Some(before) = last {
                let grown = along - before;
                assert!((-1e-9..1.5e-3).contains(&grown), "{smoothing} {p:?}: {grown}");
            }
            last = Some(along);
        }
        assert!((last.unwrap() - chain.arc_coordinate(3)).abs() < 1e-9);
    }
}

/// Requirement: degenerate input gives no chain or no piece, never NaN.
#[test]
fn degenerate_input() {
    assert!(Chain::new(&[[0.0; 3]], Some(0.0), 0.1).is_none());
    assert!(Chain::new(&[[0.0; 3]; 2], Some(0.0), 0.1).is_none());
    assert!(Chain::new(&zigzag(), Some(0.5), 0.1).is_none());
    let chain = Chain::new(&zigzag(), Some(0.2), 0.1).unwrap();
    assert!(chain.closest(&[[1.0, 1.0, 0.0]; 4], Nearby::Positions, [1.0, 1.0, 0.0]).is_none());
    assert!(chain.closest(&zigzag()[..2], Nearby::Positions, [1.0, 1.0, 0.0]).is_none());
    assert!(chain.closest(&zigzag(), Nearby::Positions, [f64::NAN, 1.0, 0.0]).is_none());
}
