use super::{Part, RigidSegment, beyond_end, closest, is_closed};

/// The circle of the 1995 deck: two arcs, clockwise over +x, as listed there.
fn half_circle() -> Vec<RigidSegment> {
    let centre = [0.0, 45e-3];
    vec![
        RigidSegment::arc([0.0, 54e-3], [9e-3, 45e-3], centre).unwrap(),
        RigidSegment::arc([9e-3, 45e-3], [0.0, 36e-3], centre).unwrap(),
    ]
}

/// A roof: up, a convex corner at (1, 1), down, a concave corner at (2, 0), level.
fn roof() -> Vec<RigidSegment> {
    let p = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 0.0]];
    p.windows(2).map(|s| RigidSegment::Line { a: s[0], b: s[1] }).collect()
}

/// Requirement: START at the top and clockwise over +x has its normal outward. Source: semantics,
/// section 5, "rigid surface".
#[test]
fn the_1995_circle_is_convex() {
    for segment in half_circle() {
        assert!(matches!(segment, RigidSegment::Arc { convex: true, .. }));
        assert!((segment.length() - 4.5e-3 * std::f64::consts::PI).abs() < 1e-15);
    }
    // At the joint of the two arcs no vertex stands in the way.
    for (y, segment) in [(45.001e-3, 0), (45e-3, 0), (44.999e-3, 1)] {
        let facing = closest(&half_circle(), [9.1e-3, y]).unwrap();
        assert_eq!((facing.segment, facing.part), (segment, Part::Interior));
    }
}

/// Requirement: errors of segments. Source: semantics, section 5, "segments".
#[test]
fn impossible_arcs() {
    assert!(RigidSegment::arc([1.0, 0.0], [0.0, 1.001], [0.0, 0.0]).is_none());
    assert!(RigidSegment::arc([1.0, 0.0], [-1.0, 0.0], [0.0, 0.0]).is_none());
    assert!(RigidSegment::arc([1.0, 0.0], [1.0, 0.0], [0.0, 0.0]).is_none());
    assert!(RigidSegment::arc([0.0, 0.0], [0.0, 0.0], [0.0, 0.0]).is_none());
}

/// Requirement: a point in the wedge of a corner faces the vertex, on the side it is on; open ends
/// face nothing beyond.
#[test]
fn vertices() {
    let above = closest(&roof(), [1.0, 1.5]).unwrap();
    assert_eq!((above.segment, above.part), (0, Part::Vertex { convex: true }));
    let below = closest(&roof(), [1.99, -0.05]).unwrap();
    assert_eq!((below.segment, below.part), (1, Part::Vertex { convex: false }));
    assert!(closest(&roof(), [3.2, 0.1]).is_none());
    assert!(closest(&roof(), [-1.0, -0.5]).is_none());
    assert!(closest(&[], [0.0, 0.0]).is_none());
}

/// Requirement: no hole near the surface, on either side.
#[test]
fn no_hole() {
    for i in 0..=4000 {
        let x = f64::from(i) * 3.0 / 4000.0;
        let y = if x < 1.0 { x } else { (2.0 - x).max(0.0) };
        for offset in [-0.2, -0.01, 0.0, 0.01, 0.2] {
            let inside = (0.3..=2.9).contains(&x);
            assert!(!inside || closest(&roof(), [x, y + offset]).is_some(), "{x} {offset}");
        }
    }
}

/// Requirement: a surface that ends where it starts is closed.
#[test]
fn closed_surface() {
    assert!(!is_closed(&half_circle()));
    let mut whole = half_circle();
    let centre = [0.0, 45e-3];
    whole.push(RigidSegment::arc([0.0, 36e-3], [-9e-3, 45e-3], centre).unwrap());
    whole.push(RigidSegment::arc([-9e-3, 45e-3], [0.0, 54e-3], centre).unwrap());
    assert!(is_closed(&whole));
    assert!(closest(&whole, [-1e-3, 54.1e-3]).is_some());
    assert!(closest(&whole, centre).is_none());
}

/// Requirement: arc length of a parabola. Source: closed form for y = x^2 on [-1, 1]:
/// sqrt(5) + asinh(2)/2. Tolerance: the quadrature's.
#[test]
fn length_of_a_parabola() {
    let segment = RigidSegment::Parabola { start: [-1.0, 1.0], mid: [0.0, 0.0], end: [1.0, 1.0] };
    let exact = 5.0_f64.sqrt() + 0.5 * 2.0_f64.asinh();
    assert!((segment.length() - exact).abs() < 1e-12 * exact, "{}", segment.length());
    let facing = closest(&[segment], [0.3, 0.3 * 0.3]).unwrap();
    assert!((facing.parameter - 0.65).abs() < 1e-14);
}

/// Requirement: beyond an end the prolonged surface tells whether a point would still touch: on and
/// off the circle of an arc, above and below the line. Source: distances. Tolerance: rounding.
#[test]
fn beyond_an_end() {
    let quarter = [RigidSegment::arc([0.0, 1.0], [1.0, 0.0], [0.0, 0.0]).unwrap()];
    assert!(
        (beyond_end(&quarter, [0.5, -0.5]).unwrap().depth - (1.0 - 0.5f64.sqrt())).abs() < 1e-15
    );
    assert!((beyond_end(&quarter, [-1.0, 1.0]).unwrap().depth - (1.0 - 2f64.sqrt())).abs() < 1e-15);
    assert_eq!(beyond_end(&quarter, [0.5, 0.5]), None);
    let line = [RigidSegment::Line { a: [0.0, 0.0], b: [2.0, 0.0] }];
    assert!((beyond_end(&line, [2.5, -0.1]).unwrap().depth - 0.1).abs() < 1e-15);
    assert!((beyond_end(&line, [-0.5, 0.2]).unwrap().depth + 0.2).abs() < 1e-15);
    assert_eq!(beyond_end(&line, [1.0, 0.2]), None);
    let (after, before) = (beyond_end(&line, [2.5, -0.1]), beyond_end(&line, [-0.5, 0.2]));
    assert_eq!(after.map(|end| (end.at_start, end.beyond)), Some((false, 0.5)));
    assert_eq!(before.map(|end| (end.at_start, end.beyond)), Some((true, 0.5)));
}
