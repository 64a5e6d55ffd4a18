//! Tips over corners, beams wrapped about discs, feet, beams on beams.

use super::draft::{Body, Draft, Element, Pair, Piece, Side, Solid, Step};
use super::laws::{self, Scale};
use crate::random::Sequence;

/// An arm that looks down; a wedge is pushed under its tip and drawn back.
///
/// ```text
///   |====____
///            ====     <-  /------\
///                        /        \     ways up, top, way down
/// ```
///
/// Well-posed: ways of at most 40 degrees with mu tan a < 1/2; the arm stays
/// inclined, so that only its tip meets the wedge; the way down is steady.
pub fn corner(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let element = laws::element(s);
    let count = 8 + s.below(16);
    let slope = s.between(0.35, 0.6);
    let (sin, cos) = slope.sin_cos();
    let beam = draft.beams((element, count), s.power(-2.0, -1.3), |part| {
        [-cos * (1.0 - part), sin * (1.0 - part)]
    });
    let high = s.between(0.02, 0.08);
    let [up, down] = [s.between(0.3, 0.7), s.between(0.3, 0.7)];
    let top = s.between(0.02, 0.08);
    // the wedge stands beside the tip, its top higher by `high` less the start
    let left = 0.01;
    let depth = high + s.between(0.005, 0.05);
    let base = high - depth;
    let corners = [
        [left, base],
        [left + depth / up.tan(), high],
        [left + depth / up.tan() + top, high],
        [left + depth / up.tan() + top + depth / down.tan(), base],
    ];
    let reference = [left, base - 0.1];
    let back = [[corners[3][0], base - 0.1], [left, base - 0.1]];
    let body = if s.below(2) == 0 {
        draft.polygon(reference, &corners, &back)
    } else {
        rounded(&mut draft, reference, (&corners, s.between(0.005, 0.02)), &back)
    };
    let clamp = draft.ends(beam)[0];
    let mut end = draft.chains[beam].nodes.clone();
    end.reverse();
    end.truncate(3);
    let slave = if s.below(2) == 0 { Side::Nodes(end) } else { Side::Chain(beam) };
    draft.pairs.push(Pair { slave, master: Side::Body(body), integrated: false, smooth: 0.0 });
    let force = 3.0 * draft.bending(0) * high;
    let scale = Scale { force, length: 1.0, element: 0.5 / count as f64 };
    laws::draw(&mut draft, scale, (true, 0.5), s);
    let body = draft.bodies[body].node;
    let past = corners[3][0] - depth * s.between(0.0, 0.5) / down.tan();
    let increments = laws::increments(s);
    for x in [-past, 0.02] {
        let motions = vec![(clamp, [Some(0.0); 3]), (body, [Some(x), Some(0.0), Some(0.0)])];
        draft.steps.push(Step { increments, motions, ..Step::default() });
        if s.below(2) == 0 {
            break;
        }
    }
    draft
}

/// A polygon whose inner corners are rounded.
fn rounded(
    draft: &mut Draft,
    reference: [f64; 2],
    (corners, radius): (&[[f64; 2]; 4], f64),
    back: &[[f64; 2]],
) -> usize {
    let node = draft.node(reference);
    let (mut pieces, mut solid) = (Vec::new(), vec![corners[0]]);
    for k in 1..3 {
        let way = |a: [f64; 2], b: [f64; 2]| {
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            let size = x.hypot(y);
            ([x / size, y / size], size)
        };
        let (into, before) = way(corners[k - 1], corners[k]);
        let (out, after) = way(corners[k], corners[k + 1]);
        let turn = (into[1] * out[0] - into[0] * out[1]).asin();
        let reach = (radius * (0.5 * turn).tan()).min(0.4 * before).min(0.4 * after);
        let radius = reach / (0.5 * turn).tan();
        let from = [0, 1].map(|c| corners[k][c] - reach * into[c]);
        let to = [0, 1].map(|c| corners[k][c] + reach * out[c]);
        let centre = [from[0] + radius * into[1], from[1] - radius * into[0]];
        pieces.push(Piece { to: from, centre: None });
        pieces.push(Piece { to, centre: Some(centre) });
        for j in 0..=16 {
            let (sin, cos) = (turn * f64::from(j) / 16.0).sin_cos();
            let [x, y] = [from[0] - centre[0], from[1] - centre[1]];
            solid.push([centre[0] + cos * x + sin * y, centre[1] - sin * x + cos * y]);
        }
    }
    pieces.push(Piece { to: corners[3], centre: None });
    solid.push(corners[3]);
    solid.extend(back);
    solid.reverse();
    draft.bodies.push(Body { node, start: corners[0], pieces, solid: Solid::Convex(solid) });
    draft.bodies.len() - 1
}

/// A cantilever wrapped about a disc by a force or a way of its tip; the disc
/// then moves.
///
/// ```text
///   |==============  | F
///     (    )         v
/// ```
///
/// Well-posed: clamped as a tangent of the disc, which then draws away from the
/// clamp; the profile reaches on to where the beam hangs free.
pub fn wrap(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let element = laws::element(s);
    let count = (if element == Element::B22 { 8 } else { 16 }) + s.below(20);
    let sides = if element == Element::B22 { 2 * count } else { count };
    let beam = draft.beams((element, count), s.power(-2.5, -1.5), |part| [part, 0.0]);
    let (radius, gap) = (s.between(0.25, 0.5), s.one_of(&[0.0, 0.00025, 0.002]));
    let beside = s.between(0.0, 0.2);
    let centre = [s.one_of(&[0.0, beside]), -radius - gap];
    let disc = draft.arc(centre, radius, std::f64::consts::PI, 4);
    let integrated = s.below(2) == 0;
    let (slave, master) = (Side::Chain(beam), Side::Body(disc));
    draft.pairs.push(Pair { slave, master, integrated, smooth: 0.0 });
    let force = draft.bending(0) / (radius * radius);
    let scale = Scale { force, length: 1.0, element: 1.0 / sides as f64 };
    laws::draw(&mut draft, scale, (!integrated, 0.5), s);
    let [clamp, tip] = draft.ends(beam);
    let disc = draft.bodies[disc].node;
    let held =
        |place: f64| vec![(clamp, [Some(0.0); 3]), (disc, [Some(0.0), Some(place), Some(0.0)])];
    let increments = laws::increments(s);
    let mut first = Step { increments, motions: held(0.0), ..Step::default() };
    if s.below(2) == 0 {
        first.loads.push((tip, [0.0, -s.between(1.0, 10.0) * draft.bending(0)]));
    } else {
        first.motions.push((tip, [None, Some(-s.between(0.2, 0.6)), None]));
    }
    draft.steps.push(first);
    let motions = held(-s.between(0.0, 0.05));
    draft.steps.push(Step { increments, motions, ..Step::default() });
    draft
}

/// A beam on rigid feet that stand on a plate or a disc, which is pressed
/// against them and drawn along.
///
/// ```text
///   |=======+=======+====
///           |       |         *MPC BEAM
///       ==================  <- pressed up, drawn along
/// ```
///
/// Well-posed: clamped; the feet are shorter than what lets them tip over;
/// the plate is longer than the way.
pub fn feet(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let element = laws::element(s);
    let count = 12 + s.below(12);
    let beam = draft.beams((element, count), s.power(-2.0, -1.3), |part| [part, 0.0]);
    let (leg, number) = (s.between(0.02, 0.08), 1 + s.below(3));
    let per = (draft.chains[beam].nodes.len() - 1) / count;
    let mut soles = Vec::new();
    for k in 0..number {
        let at = draft.chains[beam].nodes[per * (count / 2 + k * count / (2 * number))];
        let [x, y] = draft.nodes[at];
        let single = number > 1 && s.below(2) == 0;
        for side in if single { vec![0.0] } else { vec![-0.01, 0.01] } {
            let foot = draft.node([x + side, y - leg]);
            draft.links.push([foot, at]);
            soles.push(foot);
        }
    }
    let (low, gap) = (-leg, s.between(0.0, 0.005));
    let level = low - gap;
    let plate =
        draft.polygon([0.5, level], &[[-1.0, level], [2.0, level]], &[[2.0, -3.0], [-1.0, -3.0]]);
    let (slave, master) = (Side::Nodes(soles.clone()), Side::Body(plate));
    draft.pairs.push(Pair { slave, master, integrated: false, smooth: 0.0 });
    let scale = Scale { force: 0.3 * draft.bending(0), length: 1.0, element: 0.5 / number as f64 };
    // rigidly linked slaves on a straight edge exclude hard contact
    laws::draw(&mut draft, scale, (false, 0.5), s);
    let clamp = draft.ends(beam)[0];
    let plate = draft.bodies[plate].node;
    let press = gap + s.between(0.005, 0.06);
    let way = s.between(-0.1, 0.1);
    let increments = laws::increments(s);
    for [x, y] in [[0.0, press], [way, press], [-0.5 * way, 0.5 * press], [0.0, -0.02]] {
        let motions = vec![(clamp, [Some(0.0); 3]), (plate, [Some(x), Some(y), Some(0.0)])];
        draft.steps.push(Step { increments, motions, ..Step::default() });
    }
    if s.below(4) == 0 {
        let load = -draft.bending(0) * s.between(0.0, 0.05);
        draft.steps[0].loads.push((soles[0], [0.0, load]));
    }
    draft
}

/// A beam that looks down on another one with its tip, is pressed and drawn
/// along, and lifted; or that lies along it.
///
/// ```text
///           ____====|     slaves
///       ====
///   |==================   master
/// ```
///
/// Well-posed: both are clamped; tip and way lie inside the master.
pub fn beam_on_beam(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let height = s.power(-2.2, -1.3);
    let count = s.one_of(&[2, 4, 8, 16, 30]);
    let low =
        draft.beams((s.one_of(&[Element::B21, Element::B23]), count), height, |part| [part, 0.0]);
    let along = s.below(3) == 0;
    let slope = if along { 0.0 } else { s.between(0.3, 0.7) };
    let (sin, cos) = slope.sin_cos();
    let (tip, gap) = (s.between(0.45, 0.6), s.between(0.0, 0.005));
    let size = if along { s.between(0.15, 0.3) } else { s.between(0.3, 1.0) };
    let element = laws::element(s);
    let sides = 10 + s.below(20);
    let high = draft.beams((element, sides), height * s.power(-0.5, 0.3), |part| {
        [tip + size * cos * part, gap + size * sin * part]
    });
    draft.chains[high].modulus = s.power(-1.5, 0.5);
    let smooth = s.between(0.0, 0.4);
    let (slave, master) = (Side::Chain(high), Side::Chain(low));
    draft.pairs.push(Pair { slave, master, integrated: false, smooth });
    let force = 0.2 * draft.bending(low);
    let scale = Scale { force, length: 1.0, element: size / sides as f64 };
    laws::draw(&mut draft, scale, (true, 0.5), s);
    let [root, end] = draft.ends(low);
    let both = s.below(2) == 0;
    let hand = draft.ends(high)[1];
    let press = -gap - s.between(0.005, if both { 0.02 } else { 0.08 });
    let way = s.between(-0.15, 0.1);
    for [x, y] in [[0.0, press], [way, press], [0.0, 0.01]] {
        let mut motions = vec![(root, [Some(0.0); 3]), (hand, [Some(x), Some(y), Some(0.0)])];
        if both {
            motions.push((end, [Some(0.0); 3]));
        }
        let increments = laws::increments(s);
        draft.steps.push(Step { increments, motions, ..Step::default() });
    }
    draft
}
