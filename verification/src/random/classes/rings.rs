//! Rings between plates.
//!
//! ```text
//!   ==============  <- pressed, drawn aside and back, lifted
//!        (    )        springs at three nodes hold the ring
//!   ==============
//! ```
//!
//! Well-posed: the springs hold every rigid motion of the ring; the plates are
//! longer than the way; a ring pressed by less than a fourth of its radius
//! moves without a jump.

use super::draft::{Chain, Draft, Element, Pair, Side, Spring, Step};
use super::laws::{self, Scale};
use crate::random::Sequence;
use std::f64::consts::TAU;

/// A ring of radius 1.
pub fn ring(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(s.power(-1.0, 0.0));
    let element = s.one_of(&[Element::B21, Element::B21, Element::B22, Element::B23]);
    let count = 2 * (8 + s.below(18));
    let any = s.number();
    let phase = s.one_of(&[0.0, 0.5, any]) / count as f64;
    let nodes: Vec<usize> = (0..count)
        .map(|k| {
            let (sin, cos) = (TAU * (k as f64 / count as f64 + phase)).sin_cos();
            draft.node([sin, cos])
        })
        .collect();
    let height = s.power(-1.7, -1.0);
    draft.chains.push(Chain { element, nodes, closed: true, height, modulus: 1.0 });
    let gap = s.one_of(&[0.0, 0.003]);
    let (low, high) = (-1.0 - gap, 1.0 + gap);
    let bottom =
        draft.polygon([0.0, low], &[[-8.0, low], [8.0, low]], &[[8.0, -9.0], [-8.0, -9.0]]);
    let top = draft.polygon([0.0, high], &[[8.0, high], [-8.0, high]], &[[-8.0, 9.0], [8.0, 9.0]]);
    let integrated = s.below(3) == 0;
    for body in [bottom, top] {
        let (slave, master) = (Side::Chain(0), Side::Body(body));
        draft.pairs.push(Pair { slave, master, integrated, smooth: 0.0 });
    }
    let stiffness = draft.bending(0) * s.power(-1.5, -0.3);
    for part in [0, count / 4, count / 2] {
        let node = draft.chains[0].nodes[part];
        draft.springs.extend([0, 1].map(|axis| Spring::Ground(node, axis, stiffness)));
    }
    let scale = Scale { force: draft.bending(0), length: 1.0, element: TAU / count as f64 };
    laws::draw(&mut draft, scale, (!integrated, 0.8), s);
    steps(&mut draft, [bottom, top], s);
    draft
}

fn steps(draft: &mut Draft, [bottom, top]: [usize; 2], s: &mut Sequence) {
    let [bottom, top] = [bottom, top].map(|body| draft.bodies[body].node);
    let press = -s.between(0.02, 0.2);
    let aside = s.between(-1.5, 1.5);
    let mut goals = vec![[0.0, press]];
    if s.below(2) == 0 {
        goals.extend([[aside, press], [-0.3 * aside, press]]);
    }
    goals.push([goals[goals.len() - 1][0], s.one_of(&[0.5 * press, 0.05])]);
    for [x, y] in goals {
        let motions = vec![(bottom, [Some(0.0); 3]), (top, [Some(x), Some(y), Some(0.0)])];
        let increments = laws::increments(s);
        draft.steps.push(Step { increments, motions, ..Step::default() });
    }
}
