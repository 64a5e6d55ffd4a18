//! Beams between two bodies: pinched by discs, buckling between walls.

use super::draft::{Draft, Element, Pair, Promise, Side, Step};
use super::laws::{self, Scale};
use crate::random::Sequence;

/// A cantilever between two discs, pressed together and drawn along.
///
/// ```text
///        (  )
///   |============      discs apart along the beam: it is bent to an S
///            (  )
/// ```
///
/// Well-posed: pressed by less than what would make the discs overlap. Every
/// eighth is pressed further, and the discs would have to meet through the
/// beam: there is no equilibrium of a line, though nodes may find one.
pub fn pinch(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let element = s.one_of(&[Element::B21, Element::B22, Element::B23, Element::B23]);
    let count = (if element == Element::B22 { 8 } else { 16 }) + s.below(24);
    let sides = if element == Element::B22 { 2 * count } else { count };
    let radius = s.between(0.08, 0.2).max(1.25 / sides as f64);
    let beam = draft.beams((element, count), s.power(-1.9, -1.2), |part| [part, 0.0]);
    let (at, apart, gap) = (s.between(0.4, 0.55), s.between(0.03, 0.3), 0.001);
    let above = draft.disc([at, radius + gap], radius, 4);
    let below = draft.arc([at + apart, -radius - gap], radius, std::f64::consts::PI, 4);
    let integrated = s.below(3) == 0;
    for body in [above, below] {
        let (slave, master) = (Side::Chain(beam), Side::Body(body));
        draft.pairs.push(Pair { slave, master, integrated, smooth: 0.0 });
    }
    let force = draft.bending(0) * 5.0;
    let scale = Scale { force, length: 1.0, element: 1.0 / sides as f64 };
    laws::draw(&mut draft, scale, (!integrated, 0.5), s);
    // pressed until the discs would meet
    let most = 2.0 * (radius + gap) - (4.0 * radius * radius - apart * apart).max(0.0).sqrt();
    let depth = if s.below(8) == 0 {
        draft.promise = Promise::Risky;
        most + 0.02
    } else {
        (most * s.between(0.3, 0.8)).min(0.08)
    };
    let way = s.between(-0.2, 0.2);
    let [above, below] = [above, below].map(|body| draft.bodies[body].node);
    let clamp = draft.ends(beam)[0];
    for x in [0.0, way, -0.5 * way] {
        let motions = vec![
            (clamp, [Some(0.0); 3]),
            (below, [Some(x), Some(0.0), Some(0.0)]),
            (above, [Some(x), Some(-depth), Some(0.0)]),
        ];
        let increments = laws::increments(s);
        draft.steps.push(Step { increments, motions, ..Step::default() });
    }
    draft
}

/// A column, clamped and guided, shortened between two walls.
///
/// ```text
///   ==================
///   |~~~~~~~~~~~~~~~~| <-
///   ==================
/// ```
///
/// Well-posed: bowed towards one wall at the start; shortened by less than
/// what makes the part that lies on the wall buckle in its turn, 4.5 g^2/L
/// (two bows of length L/3 each, then).
pub fn walls(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let element = laws::element(s);
    let count = (if element == Element::B22 { 10 } else { 20 }) + s.below(30);
    let gap = s.between(0.03, 0.1);
    let bow = gap * s.between(0.02, 0.2) * s.one_of(&[-1.0, 1.0]);
    let beam = draft.beams((element, count), gap * s.between(0.1, 0.4), |part| {
        [part, 0.5 * bow * (1.0 - (std::f64::consts::TAU * part).cos())]
    });
    let (low, high, far) = (-gap, gap, 1.0);
    let floor = &[[2.0, -far], [-1.0, -far]];
    let below = draft.polygon([0.5, low], &[[-1.0, low], [2.0, low]], floor);
    let roof = &[[-1.0, far], [2.0, far]];
    let above = draft.polygon([0.5, high], &[[2.0, high], [-1.0, high]], roof);
    let integrated = s.below(2) == 0;
    for body in [below, above] {
        let (slave, master) = (Side::Chain(beam), Side::Body(body));
        draft.pairs.push(Pair { slave, master, integrated, smooth: 0.0 });
    }
    let sides = if element == Element::B22 { 2 * count } else { count };
    let force = draft.bending(0) * 40.0 * gap;
    let scale = Scale { force, length: 1.0, element: 1.0 / sides as f64 };
    laws::draw(&mut draft, scale, (!integrated, 0.4), s);
    let [clamp, guide] = draft.ends(beam);
    let [below, above] = [below, above].map(|body| draft.bodies[body].node);
    let short = gap * gap * s.between(1.0, 3.8);
    for x in [-short, s.one_of(&[0.0, -0.5 * short])] {
        let mut motions: Vec<_> =
            [clamp, below, above].iter().map(|&node| (node, [Some(0.0); 3])).collect();
        motions.push((guide, [Some(x), Some(0.0), Some(0.0)]));
        let increments = laws::increments(s);
        draft.steps.push(Step { increments, motions, ..Step::default() });
    }
    draft
}
