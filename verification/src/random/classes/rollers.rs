//! Beams that are met by discs.
//!
//! ```text
//!          (  )   pressed, drawn along, lifted
//!   |=================   or held at both ends
//! ```
//!
//! Well-posed: the beam is clamped; the disc is wider than an element and
//! stays above the span; pressed in by less than a tenth of the length.

use super::draft::{Draft, Element, Pair, Prescribed, Promise, Side, Spring, Step};
use super::laws::{self, Scale};
use crate::random::Sequence;

/// Held in every dof.
const HELD: Prescribed = [Some(0.0); 3];

/// What is drawn for a beam along x from 0 to 1 and a disc above it.
struct Bench {
    draft: Draft,
    left: usize,
    right: usize,
    /// Held at both ends.
    both: bool,
    disc: usize,
    /// Where the disc stands along the beam.
    at: f64,
    gap: f64,
    increments: [f64; 3],
}

/// The beam, the disc and their law.
fn bench(radius: [f64; 2], gap: f64, (hard, most): (bool, f64), s: &mut Sequence) -> Bench {
    let mut draft = Draft::new(s.power(-1.5, -0.3));
    let element = laws::element(s);
    let count = (if element == Element::B22 { 6 } else { 12 }) + s.below(20);
    let sides = if element == Element::B22 { 2 * count } else { count };
    let radius = s.between(radius[0], radius[1]).max(1.25 / sides as f64);
    let beam = draft.beams((element, count), s.power(-2.2, -1.2), |part| [part, 0.0]);
    let both = s.below(2) == 0;
    let at = if both { s.between(0.4, 0.6) } else { s.between(0.45, 0.7) };
    let disc = draft.disc([at, radius + gap], radius, 4);
    let integrated = s.below(2) == 0;
    let (slave, master) = (Side::Chain(beam), Side::Body(disc));
    draft.pairs.push(Pair { slave, master, integrated, smooth: 0.0 });
    let force = 0.15 * draft.bending(0) * if both { 64.0 } else { 3.0 };
    let scale = Scale { force, length: 1.0, element: 1.0 / sides as f64 };
    laws::draw(&mut draft, scale, (hard && !integrated, most), s);
    let [left, right] = draft.ends(beam);
    let disc = draft.bodies[disc].node;
    Bench { draft, left, right, both, disc, at, gap, increments: laws::increments(s) }
}

impl Bench {
    fn supports(&self) -> Vec<(usize, Prescribed)> {
        let mut held = vec![(self.left, HELD)];
        if self.both {
            held.push((self.right, HELD));
        }
        held
    }

    /// A step that brings the disc to a place.
    fn go(&mut self, [x, y]: [f64; 2]) {
        let mut motions = self.supports();
        motions.push((self.disc, [Some(x), Some(y), Some(0.0)]));
        let increments = self.increments;
        self.draft.steps.push(Step { increments, motions, ..Step::default() });
    }

    /// Depth that a beam of this kind takes: membrane forces rule where both
    /// ends are held.
    fn depth(&self, s: &mut Sequence) -> f64 {
        -self.gap.max(0.0) - if self.both { s.between(0.005, 0.03) } else { s.between(0.01, 0.1) }
    }
}

/// Pressed, dragged to and fro, lifted.
pub fn cyclic(s: &mut Sequence) -> Draft {
    let gap = s.between(0.0, 0.005);
    let mut bench = bench([0.06, 0.2], gap, (true, 0.6), s);
    let depth = bench.depth(s);
    let way = s.between(0.02, if bench.both { 0.15 } else { 0.2 });
    bench.go([0.0, depth]);
    for k in 0..2 + s.below(4) {
        bench.go([if k % 2 == 0 { -way } else { 0.4 * way }, depth]);
    }
    bench.go([0.0, 0.02]);
    bench.draft
}

/// Overclosed at the start, by up to a twentieth of the length.
pub fn deep(s: &mut Sequence) -> Draft {
    let gap = -s.between(0.003, 0.03);
    let mut bench = bench([0.08, 0.25], gap, (true, 0.5), s);
    bench.go([0.0, -s.between(0.0, 0.02)]);
    bench.go([s.between(-0.05, 0.05), 0.05]);
    bench.draft
}

/// Pressed in an increment as long as the step, or a third of it.
pub fn pass_through(s: &mut Sequence) -> Draft {
    let gap = s.between(0.0, 0.3);
    let mut bench = bench([0.05, 0.15], gap, (true, 0.3), s);
    bench.increments = s.one_of(&[[1.0, 1e-6, 1.0], [0.34, 1e-6, 0.5], [0.5, 1e-6, 1.0]]);
    let depth = bench.depth(s);
    bench.go([0.0, depth]);
    if s.below(2) == 0 {
        bench.go([s.between(-0.1, 0.1), depth]);
    }
    bench.go([0.0, 0.1]);
    bench.draft.reversible = bench.draft.friction.mu == 0.0;
    bench.draft
}

/// As before, but the disc is smaller than the elements, and slaves are nodes.
pub fn coarse(s: &mut Sequence) -> Draft {
    let mut draft = pass_through(s);
    let count = 4 + s.below(4);
    let mut coarse = Draft::new(draft.width);
    let height = draft.chains[0].height;
    let beam = coarse.beams((Element::B21, count), height, |part| [part, 0.0]);
    let radius = s.between(0.2, 0.6) / count as f64;
    let disc = coarse.disc([s.between(0.4, 0.7), radius + 0.01], radius, 4);
    let (slave, master) = (Side::Chain(beam), Side::Body(disc));
    coarse.pairs.push(Pair { slave, master, integrated: false, smooth: 0.0 });
    (coarse.normal, coarse.friction) = (draft.normal.clone(), draft.friction);
    let motions = vec![
        (coarse.ends(beam)[0], HELD),
        (coarse.bodies[disc].node, [Some(0.0), Some(-s.between(0.03, 0.1)), Some(0.0)]),
    ];
    let increments = draft.steps.swap_remove(0).increments;
    coarse.steps.push(Step { increments, motions, ..Step::default() });
    coarse.promise = Promise::Risky;
    coarse
}

/// The tip is driven or the beam pressed; then all but the clamp is dropped.
pub fn release(s: &mut Sequence) -> Draft {
    let gap = s.between(0.0, 0.02);
    let mut bench = bench([0.06, 0.2], gap, (true, 0.5), s);
    let with_disc = s.below(3) > 0;
    let [left, right, disc] = [bench.left, bench.right, bench.disc];
    let increments = bench.increments;
    let lift = s.between(0.02, 0.2) * s.one_of(&[-1.0, 1.0]);
    let mut step = |motions, anew| {
        bench.draft.steps.push(Step { increments, motions, anew, ..Step::default() });
    };
    let rest = (disc, HELD);
    if with_disc {
        // the tip is drawn against the disc or away from it
        step(vec![(left, HELD), rest, (right, [None, Some(lift), None])], false);
    } else {
        let high = (disc, [Some(0.0), Some(1.0), Some(0.0)]);
        step(vec![(left, HELD), high], false);
        step(vec![(left, HELD), high, (right, [None, Some(lift), None])], false);
    }
    let rest = if with_disc { rest } else { (disc, [Some(0.0), Some(1.0), Some(0.0)]) };
    step(vec![(left, HELD), rest], true);
    if s.below(2) == 0 {
        step(vec![(left, HELD), rest, (right, [None, Some(-0.5 * lift), None])], false);
        step(vec![(left, HELD), rest], true);
    }
    bench.draft
}

/// Pressed, lifted, taken aside, pressed again; the end of a driven beam is
/// held or let go while the disc is away.
pub fn restraint(s: &mut Sequence) -> Draft {
    let gap = s.between(0.0, 0.01);
    let mut bench = bench([0.06, 0.2], gap, (true, 0.3), s);
    let depth = bench.depth(s);
    let aside = s.between(-0.1, 0.1);
    bench.go([0.0, depth]);
    bench.go([0.0, s.between(0.02, 0.3)]);
    bench.go([aside, 0.1]);
    if s.below(2) == 0 {
        let [right, disc] = [bench.right, bench.disc];
        let shift = s.between(0.01, 0.04) * s.one_of(&[-1.0, 1.0]);
        let mut motions = bench.supports();
        motions.push((disc, [Some(aside), Some(0.1), Some(0.0)]));
        motions.retain(|(node, _)| *node != right);
        motions.push((right, [None, Some(shift), bench.both.then_some(0.0)]));
        let (increments, anew) = (bench.increments, true);
        bench.draft.steps.push(Step { increments, motions, anew, ..Step::default() });
        bench.both = false;
        let mut motions = bench.supports();
        motions.push((disc, [Some(aside), Some(0.1), Some(0.0)]));
        bench.draft.steps.push(Step { increments, motions, anew, ..Step::default() });
        bench.go([aside, depth.max(-0.03)]);
    } else {
        bench.go([aside, depth]);
    }
    bench.draft
}

/// The disc is pressed by a force and drawn by a spring, and a spring holds
/// it up.
pub fn springs(s: &mut Sequence) -> Draft {
    let mut bench = bench([0.1, 0.3], s.between(0.0, 0.01), (true, 0.4), s);
    let rate = bench.draft.bending(0) * if bench.both { 192.0 } else { 12.0 };
    let stiffness = rate * s.power(-1.0, 1.0);
    let y = bench.draft.nodes[bench.disc][1];
    let reach = s.one_of(&[0.5, 1.0, 2.0]);
    let hand = bench.draft.node([bench.at + reach, y]);
    bench.draft.springs.push(Spring::Ground(bench.disc, 1, stiffness));
    bench.draft.springs.push(Spring::Between(bench.disc, hand, stiffness));
    // what presses the beam by at most a tenth, the spring included
    let force = -(rate + stiffness) * if bench.both { 0.02 } else { s.between(0.01, 0.1) };
    let way = s.between(0.03, 0.13) * s.one_of(&[-1.0, 1.0]);
    let increments = bench.increments;
    for (x, part) in [(0.0, 1.0), (way, 1.0), (-way, 0.5)] {
        let mut motions = bench.supports();
        motions.push((bench.disc, [None, None, Some(0.0)]));
        motions.push((hand, [Some(x), Some(0.0), Some(0.0)]));
        let loads = vec![(bench.disc, [0.0, part * force])];
        bench.draft.steps.push(Step { increments, motions, loads, ..Step::default() });
    }
    bench.draft
}
