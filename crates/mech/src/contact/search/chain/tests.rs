use super::{Chain, Piece, PieceKind};

fn zigzag() -> Vec<[f64; 2]> {
    vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.5], [3.5, 0.0]]
}

/// Requirement: corners join straight parts with continuous arc coordinate; pieces tile the chain.
#[test]
fn kinds_along_the_chain() {
    let chain = Chain::new(&zigzag(), 0.25, 0.1).unwrap();
    let at = |x: f64, y: f64| chain.closest(&zigzag(), [x, y], None).unwrap();
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
    let chain = Chain::new(&zigzag(), 0.25, 0.1).unwrap();
    let x = zigzag();
    assert!(chain.closest(&x, [-0.11, 0.02], None).is_none());
    assert!((chain.beyond_end(&x, [-0.11, 0.02]).unwrap() + 0.02).abs() < 1e-15);
    assert!(chain.beyond_end(&x, [3.9, -0.1]).is_some());
    assert!(chain.beyond_end(&x, [-7.0, 0.0]).is_some());
    assert_eq!(chain.beyond_end(&x, [0.5, 0.0]), None);
}

/// Requirement: no hole within 0.1 of the chain on either side, smoothed or not, and the distance
/// found changes continuously along a line of points.
#[test]
fn no_hole() {
    let x = zigzag();
    for smoothing in [0.0, 0.1, 0.25, 0.49] {
        let chain = Chain::new(&x, smoothing, 0.1).unwrap();
        for segment in 0..3 {
            let (a, b) = (x[segment], x[segment + 1]);
            for i in 0..=2000 {
                let s = f64::from(i) / 2000.0;
                for offset in [-0.1, -0.01, 0.0, 0.01, 0.1] {
                    let p = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]) + offset];
                    let piece = chain.closest(&x, p, None);
                    assert!(piece.is_some_and(|q| q.parameter.is_finite()), "{smoothing} {p:?}");
                }
            }
        }
    }
}

/// Requirement: on the bisector of an unsmoothed corner the committed piece is kept.
#[test]
fn ties_keep_the_committed_piece() {
    let x = vec![[-1.0, 0.0], [0.0, 1.0], [1.0, 0.0]];
    let chain = Chain::new(&x, 0.0, 0.1).unwrap();
    for index in [0, 1] {
        let committed = Piece { index, kind: PieceKind::Straight, parameter: 0.5 };
        let piece = chain.closest(&x, [0.0, 1.3], Some(committed)).unwrap();
        assert_eq!(piece.index, index);
    }
}

/// Requirement: degenerate input gives no chain or no piece, never NaN.
#[test]
fn degenerate_input() {
    assert!(Chain::new(&[[0.0, 0.0]], 0.0, 0.1).is_none());
    assert!(Chain::new(&[[0.0, 0.0], [0.0, 0.0]], 0.0, 0.1).is_none());
    assert!(Chain::new(&zigzag(), 0.5, 0.1).is_none());
    let chain = Chain::new(&zigzag(), 0.2, 0.1).unwrap();
    assert!(chain.closest(&[[1.0, 1.0]; 4], [1.0, 1.0], None).is_none());
    assert!(chain.closest(&zigzag()[..2], [1.0, 1.0], None).is_none());
    assert!(chain.closest(&zigzag(), [f64::NAN, 1.0], None).is_none());
}

/// Requirement: a kept part can be followed outside its range.
#[test]
fn projection_on_a_kept_part() {
    let chain = Chain::new(&zigzag(), 0.2, 0.1).unwrap();
    let piece = chain.project(&zigzag(), [5.0, 3.0], (0, PieceKind::Straight)).unwrap();
    assert!((piece.parameter - 5.0).abs() < 1e-14);
}
