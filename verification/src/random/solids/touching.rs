//! Blocks that touch: at faces, at shared corners, with small gaps and overclosures.
//!
//! ```text
//!     stacked            flush              beside              corner
//!      _____             _____            ____ ____              ____
//!     |_____|           |_____|          |    |    |         ___|    |
//!    |___|              |_____|         _|____|____|_       |   |____|
//!    |_______|          |_____|        |_____________|      |___|
//! ```

use super::choices::{increments, kinds, laws, material, stiffness};
use super::draft::{Draft, Pair, Prescribed, Skins, Step, Surface, World};
use super::mesh::{Kind, Part};
use crate::random::Sequence;
use crate::random::classes::Promise;

const LEFT: (usize, bool) = (0, false);
const RIGHT: (usize, bool) = (0, true);
const BELOW: (usize, bool) = (1, false);
const ABOVE: (usize, bool) = (1, true);

/// How far a block is pressed, in its size [1].
const PRESS: [f64; 2] = [0.003, 0.02];
/// Part of the force of a block that is pressed flat that must be there [1].
const LEAST: f64 = 0.05;

/// A block: its lower left corner and its size.
#[derive(Clone, Copy)]
struct Block {
    at: [f64; 2],
    size: [f64; 2],
}

/// What lies between two faces: none, a small gap, or a small overclosure.
fn clearance(s: &mut Sequence) -> f64 {
    match s.below(4) {
        0 | 1 => 0.0,
        2 => s.power(-4.0, -2.0),
        _ => -s.power(-4.0, -2.3),
    }
}

/// Types of element, and so many elements along an edge of length one, where meshes are alike.
type Mesh = (&'static [Kind], Option<f64>);

/// Adds a block.
fn add(draft: &mut Draft, block: Block, (known, matching): Mesh, s: &mut Sequence) {
    let kind = s.one_of(known);
    let counts = match matching {
        Some(density) => block.size.map(|length| ((length * density).round() as usize).max(1)),
        None if s.below(3) == 0 => [1, 1], // as coarse as can be
        None => [1 + s.below(6), 1 + s.below(3)],
    };
    let part = Part::block(kind, [counts[0], counts[1], 0], &mut draft.nodes, |[x, y, _]| {
        [block.at[0] + x * block.size[0], block.at[1] + y * block.size[1], 0.0]
    });
    let made_of = material(kind, s);
    draft.parts.push((part, made_of));
}

/// The force of a block that is pressed by a strain, of the softest of the parts.
fn least_force(draft: &mut Draft, block: Block, strain: f64) {
    let softest = draft.parts.iter().map(|part| stiffness(part.1)).fold(f64::MAX, f64::min);
    draft.least_force = softest * strain * block.size[0];
}

/// A width that fits on another one, and where it stands on it.
fn width_on(below: Block, s: &mut Sequence) -> (f64, f64) {
    let [wide, _] = below.size;
    let left = below.at[0];
    match s.below(4) {
        0 => (wide, left),
        1 => {
            let own = s.between(0.4, 0.9) * wide;
            let room = wide - own;
            (own, left + s.one_of(&[0.0, room, 0.5 * room, 0.3 * room]))
        }
        2 => {
            let own = s.between(1.1, 1.4) * wide;
            let room = own - wide;
            (own, left - s.one_of(&[0.0, room, 0.5 * room]))
        }
        // half on, half off, as bricks in a wall
        _ => (wide, left + s.between(-0.3, 0.3) * wide),
    }
}

/// How pairs are made: general contact, sides that face one another, or whole skins.
fn connect(draft: &mut Draft, meetings: &[[Surface; 2]], s: &mut Sequence) {
    draft.general = s.below(2) == 0;
    let skins = !draft.general && s.below(3) == 0;
    draft.skins = if skins { Skins::Whole } else { Skins::Facing };
    for &[one, other] in meetings {
        let (slave, master) = if s.below(2) == 0 { (one, other) } else { (other, one) };
        let mortar = s.below(2) == 0;
        draft.pairs.push(Pair { slave, master, mortar });
    }
}

/// Two or three blocks on one another, or two beside one another on a third.
pub(super) fn touching(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(World::Plane);
    draft.quarter = true;
    let known = kinds(World::Plane, s);
    let density = (s.below(3) == 0).then(|| s.between(1.5, 5.0));
    let mesh = (known, density);
    let base = Block { at: [0.0; 2], size: [s.between(1.2, 2.4), s.between(0.3, 0.9)] };
    add(&mut draft, base, mesh, s);
    match s.below(3) {
        0 => beside(&mut draft, base, mesh, s),
        more => stacked(&mut draft, (base, more), mesh, s),
    }
    draft.thickness = s.power(-1.0, 1.0);
    draft.least_force *= LEAST * draft.thickness;
    laws(&mut draft, 0.4, s);
    draft.promise = Promise::WellPosed;
    draft
}

/// `more` blocks on the base.
fn stacked(draft: &mut Draft, (base, more): (Block, usize), mesh: Mesh, s: &mut Sequence) {
    let (mut below, mut sunk, mut meetings) = (base, 0.0, Vec::new());
    let mut free = true;
    let mut ways = Vec::new();
    for part in 1..=more {
        let gap = clearance(s);
        let (wide, left) = width_on(below, s);
        let top = below.at[1] + below.size[1];
        let own = Block { at: [left, top + gap], size: [wide, s.between(0.3, 0.8)] };
        add(draft, own, mesh, s);
        meetings.push([Surface::Side(part - 1, ABOVE), Surface::Side(part, BELOW)]);
        free &= gap <= 0.0;
        sunk += gap.max(0.0) + s.between(PRESS[0], PRESS[1]) * own.size[1];
        ways.push(sunk);
        below = own;
    }
    connect(draft, &meetings, s);
    least_force(draft, base, PRESS[0]);
    let still = (draft.side(0, BELOW), [Some(0.0), Some(0.0), None]);
    let (head, aside) = (draft.side(more, ABOVE), s.between(-0.02, 0.02));
    // what lies between is held along the faces by its left side, and across them by contact alone
    // where that is there from the beginning
    let mut grips: Vec<(Vec<usize>, Prescribed)> = Vec::new();
    let held = !free || s.below(2) == 0;
    for (part, &way) in (1..more).zip(&ways) {
        let down = held.then_some(-way);
        grips.push((draft.side(part, LEFT), [Some(0.0), down, None]));
    }
    let increments = increments(s);
    let step = |x: f64| {
        let mut motions = vec![still.clone(), (head.clone(), [Some(x), Some(-sunk), None])];
        motions.extend(grips.iter().cloned());
        Step { increments, motions, ..Step::default() }
    };
    draft.steps = vec![step(0.0), step(aside)];
}

/// Two blocks beside one another on the base, or one on it and one beside that in the air.
fn beside(draft: &mut Draft, base: Block, mesh: Mesh, s: &mut Sequence) {
    let [wide, high] = base.size;
    let split = s.one_of(&[0.5, 0.3, 0.6]) * wide;
    let gaps = [clearance(s), clearance(s), clearance(s)];
    let heights = [s.between(0.3, 0.8), s.between(0.3, 0.8)];
    let hangs = s.below(4) == 0;
    let start = if s.below(2) == 0 { 0.0 } else { 0.2 * split };
    let first = Block { at: [start, high + gaps[0]], size: [split - start, heights[0]] };
    let end = match s.below(3) {
        0 => wide,
        1 => 0.9 * wide,
        _ => 1.15 * wide,
    };
    let from = split + gaps[1];
    let foot = if hangs { 0.5 * heights[0] } else { gaps[2] };
    let second = Block { at: [from, high + foot], size: [end - from, heights[1]] };
    add(draft, first, mesh, s);
    add(draft, second, mesh, s);
    let mut meetings = vec![
        [Surface::Side(0, ABOVE), Surface::Side(1, BELOW)],
        [Surface::Side(1, RIGHT), Surface::Side(2, LEFT)],
    ];
    if !hangs {
        meetings.push([Surface::Side(0, ABOVE), Surface::Side(2, BELOW)]);
    }
    connect(draft, &meetings, s);
    least_force(draft, first, PRESS[0]);
    let mut press = |gap: f64, size: f64| -(gap.max(0.0) + s.between(PRESS[0], PRESS[1]) * size);
    let down = press(gaps[0], heights[0]);
    let across = press(gaps[1], second.size[0]);
    let sinks = if hangs { 0.0 } else { press(gaps[2], heights[1]) };
    let increments = increments(s);
    let motions = vec![
        (draft.side(0, BELOW), [Some(0.0), Some(0.0), None]),
        (draft.side(1, LEFT), [Some(0.0), Some(down), None]),
        (draft.side(2, RIGHT), [Some(across), Some(sinks), None]),
    ];
    draft.steps = vec![Step { increments, motions, ..Step::default() }];
}
