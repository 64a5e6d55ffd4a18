//! Classes of solids in contact, each drawn from its number.
//!
//! ```text
//!   blocks    crowned     crossing      rolled      hooks          rings
//!    ___        ___         ___          ___       =======\        |_|/
//!   |___|      (___)       |___|_       |___|         o   \|       |_|
//!  =======    =======     =======        (o)
//! ```

use super::cells::{apart, pressed};
use super::choices::{increments, kinds, laws, material, stiffness};
use super::draft::{Disc, Draft, Material, Pair, Step, Surface, World};
use super::mesh::{Kind, PLANE_STRAIN, PLANE_STRESS, Part, RINGS};
use super::touching::touching;
use crate::random::Sequence;
use crate::random::classes::Promise;

/// A class: its name and how a model of it is drawn.
#[derive(Clone, Copy)]
pub struct Class {
    /// Name.
    pub name: &'static str,
    /// Draws a model.
    pub(super) draw: fn(&mut Sequence) -> Draft,
}

/// All classes.
pub const CLASSES: [Class; 12] = [
    Class { name: "blocks", draw: |s| blocks(World::Plane, s) },
    Class { name: "crowned", draw: |s| crowned(World::Plane, s) },
    Class { name: "crossing", draw: |s| crossing(World::Plane, s) },
    Class { name: "loaded", draw: |s| loaded(World::Plane, s) },
    Class { name: "drawn", draw: drawn_over_disc },
    Class { name: "hooks", draw: hook },
    Class { name: "sleeves", draw: sleeve },
    Class { name: "space", draw: |s| blocks(World::Space, s) },
    Class { name: "touching", draw: touching },
    Class { name: "domes", draw: |s| crowned(World::Space, s) },
    Class { name: "apart", draw: apart },
    Class { name: "stepped", draw: pressed },
];

/// A side of a body from which the other one lies up or down.
const BELOW: (usize, bool) = (1, false);
const ABOVE: (usize, bool) = (1, true);
/// The same in space, where up is the third axis.
const UNDER: (usize, bool) = (2, false);
const OVER: (usize, bool) = (2, true);

/// How far a block that is pressed by forces is drawn [L].
const DRAWN: f64 = 0.2;

/// Sizes of two bodies, the lower one first.
struct Stack {
    width: [f64; 2],
    height: [f64; 2],
    counts: [[usize; 3]; 2],
    /// Sagitta of the lower face of the upper body.
    crown: f64,
    /// Where the upper body stands.
    at: [f64; 2],
    gap: f64,
}

impl Stack {
    fn drawn(world: World, s: &mut Sequence) -> Self {
        let solid = world == World::Space;
        let most = if solid { 3 } else { 7 };
        let mut count = |wide: usize| {
            let along = 2 + s.below(wide);
            let up = 1 + s.below(if solid { 2 } else { 4 });
            if solid { [along, 2 + s.below(2), up] } else { [along, up, 0] }
        };
        let counts = [count(most + 2), count(most)];
        let wide = s.between(1.6, 2.6);
        Self {
            width: [wide, s.between(0.5, 0.9)],
            height: [s.between(0.4, 1.0), s.between(0.3, 0.8)],
            counts,
            crown: 0.0,
            at: [s.between(-0.2, 0.2), if solid { s.between(-0.2, 0.2) } else { 0.0 }],
            gap: if s.below(2) == 0 { 0.0 } else { s.between(0.0, 0.02) },
        }
    }

    /// Both bodies, sides of contact last: lower, upper, and the pair.
    fn build(&self, world: World, s: &mut Sequence) -> Draft {
        let mut draft = Draft::new(world);
        let kinds = kinds(world, s);
        let [lower, upper] = [0, 1].map(|_| s.one_of(kinds));
        let up = if world == World::Space { 2 } else { 1 };
        for (k, kind) in [lower, upper].into_iter().enumerate() {
            let shape = |at: [f64; 3]| self.place(k, up, at);
            let part = Part::block(kind, self.counts[k], &mut draft.nodes, shape);
            let material = material(kind, s);
            draft.parts.push((part, material));
        }
        draft.thickness = if world == World::Plane { s.power(-1.0, 1.0) } else { 1.0 };
        let faces = [Surface::Side(0, (up, true)), Surface::Side(1, (up, false))];
        let mortar = s.below(2) == 0;
        // areas of the corners of quadratic faces in space are none or negative: poor slaves
        let poor = |kind: Kind| kind.quadratic && !mortar && world == World::Space;
        let master = match [lower, upper].map(poor) {
            [true, false] => 0,
            [false, true] => 1,
            both => {
                let risky = both[0];
                draft.promise = if risky { Promise::Risky } else { Promise::WellPosed };
                s.below(2)
            }
        };
        draft.pairs.push(Pair { slave: faces[1 - master], master: faces[master], mortar });
        draft
    }

    /// Makes the foot of the upper block the slave where contact is at the nodes and fewer than three
    /// of the lower one stay below it all the way: a load on one or two nodes rests on nothing else.
    fn carry(&self, draft: &mut Draft) {
        let below = |node: &usize| {
            let off = (draft.nodes[*node][0] - self.at[0]).abs();
            off < 0.5 * self.width[1] - DRAWN
        };
        let carrying = draft.side(0, ABOVE).iter().filter(|node| below(node)).count();
        for pair in draft.pairs.iter_mut().filter(|pair| !pair.mortar && carrying < 3) {
            if matches!(pair.slave, Surface::Side(0, _)) {
                std::mem::swap(&mut pair.slave, &mut pair.master);
            }
        }
    }

    fn place(&self, body: usize, up: usize, unit: [f64; 3]) -> [f64; 3] {
        let mut at = [0.0; 3];
        for k in 0..up {
            at[k] = (unit[k] - 0.5) * self.width[body] + if body == 1 { self.at[k] } else { 0.0 };
        }
        let off: f64 = (0..up).map(|k| (2.0 * unit[k] - 1.0).powi(2)).sum();
        at[up] = match body {
            0 => (unit[up] - 1.0) * self.height[0],
            _ => {
                let foot = self.gap + self.crown * off;
                foot + unit[up] * (self.gap + self.height[1] - foot)
            }
        };
        at
    }
}

fn sides(world: World) -> [(usize, bool); 2] {
    if world == World::Space { [UNDER, OVER] } else { [BELOW, ABOVE] }
}

/// Presses by a depth, draws along, and lifts at times.
fn press_and_draw(draft: &mut Draft, depth: f64, way: [f64; 2], s: &mut Sequence) {
    let [bottom, top] = sides(draft.world);
    let [base, head] = [draft.side(0, bottom), draft.side(1, top)];
    let held = |x: f64, y: f64, z: f64| match draft.world {
        World::Space => [Some(x), Some(y), Some(z)],
        _ => [Some(x), Some(z), None],
    };
    let still = (base, held(0.0, 0.0, 0.0));
    let mut goals = vec![held(0.0, 0.0, -depth), held(way[0], way[1], -depth)];
    match s.below(3) {
        0 => goals.push(held(way[0], way[1], 0.05)),
        1 => goals.push(held(0.0, 0.0, -depth)),
        _ => {}
    }
    let increments = increments(s);
    draft.steps = goals
        .into_iter()
        .map(|goal| Step {
            increments,
            motions: vec![still.clone(), (head.clone(), goal)],
            ..Step::default()
        })
        .collect();
}

/// A block pressed flat on a wider one and drawn along it.
fn blocks(world: World, s: &mut Sequence) -> Draft {
    let stack = Stack::drawn(world, s);
    let mut draft = stack.build(world, s);
    laws(&mut draft, 0.5, s);
    let depth = stack.gap + s.between(0.003, 0.02);
    let way = [s.between(-0.2, 0.2), s.between(-0.2, 0.2)];
    press_and_draw(&mut draft, depth, way, s);
    draft
}

/// A crowned body pressed on a flat one and drawn along it.
fn crowned(world: World, s: &mut Sequence) -> Draft {
    let mut stack = Stack::drawn(world, s);
    stack.crown = s.between(0.02, 0.12);
    stack.counts[1][0] += 2;
    let mut draft = stack.build(world, s);
    laws(&mut draft, 0.5, s);
    let depth = stack.gap + s.between(0.005, 0.03);
    let way = [s.between(-0.25, 0.25), s.between(-0.25, 0.25)];
    press_and_draw(&mut draft, depth, way, s);
    draft
}

/// A block that is drawn over the end of the lower one.
fn crossing(world: World, s: &mut Sequence) -> Draft {
    let mut stack = Stack::drawn(world, s);
    stack.crown = if s.below(2) == 0 { s.between(0.02, 0.1) } else { 0.0 };
    let mut draft = stack.build(world, s);
    laws(&mut draft, 0.3, s);
    let depth = stack.gap + s.between(0.003, 0.015);
    let beyond = 0.5 * stack.width[0] - stack.at[0] + s.between(-0.3, 0.3) * stack.width[1];
    press_and_draw(&mut draft, depth, [beyond, 0.0], s);
    draft
}

/// A block on which forces press while its head is drawn along.
fn loaded(world: World, s: &mut Sequence) -> Draft {
    let mut stack = Stack::drawn(world, s);
    stack.gap = 0.0; // what forces press together must touch
    let mut draft = stack.build(world, s);
    stack.carry(&mut draft);
    laws(&mut draft, 0.4, s);
    let [bottom, top] = sides(world);
    let [base, head] = [draft.side(0, bottom), draft.side(1, top)];
    let modulus = draft.parts.iter().map(|part| stiffness(part.1)).fold(f64::MAX, f64::min);
    let force = modulus * s.power(-3.0, -2.0) * stack.width[1] * draft.thickness;
    let share = force / head.len() as f64;
    let loads: Vec<_> = head.iter().map(|&node| (node, [0.0, -share, 0.0])).collect();
    let step = |x: f64| Step {
        increments: [0.1, 1e-7, 0.1],
        motions: vec![
            (base.clone(), [Some(0.0), Some(0.0), None]),
            (head.clone(), [Some(x), None, None]),
        ],
        loads: loads.clone(),
    };
    draft.steps = vec![step(0.0), step(s.between(-DRAWN, DRAWN))];
    draft
}

/// A block pressed on a rigid disc and drawn over it.
fn drawn_over_disc(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(World::Plane);
    let kinds = kinds(World::Plane, s);
    let kind = s.one_of(kinds);
    let (length, height) = (s.between(1.5, 2.5), s.between(0.25, 0.6));
    let counts = [8 + s.below(12), 2 + s.below(3), 0];
    let part = Part::block(kind, counts, &mut draft.nodes, |[x, y, _]| {
        [(x - 0.5) * length, y * height, 0.0]
    });
    let made_of = material(kind, s);
    draft.parts.push((part, made_of));
    draft.thickness = s.power(-1.0, 1.0);
    let radius = s.between(0.4, 1.5);
    let gap = s.between(0.0, 0.01);
    draft.nodes.push([s.between(-0.2, 0.2), -gap - radius, 0.0]);
    draft.discs.push(Disc { node: draft.nodes.len() - 1, radius });
    let mortar = s.below(2) == 0;
    let slave = Surface::Side(0, BELOW);
    draft.pairs.push(Pair { slave, master: Surface::Disc(0), mortar });
    laws(&mut draft, 0.4, s);
    let (head, centre) = (draft.side(0, ABOVE), draft.discs[0].node);
    let depth = gap + s.between(0.01, 0.06) * height;
    let way = s.between(-0.25, 0.25) * length;
    let increments = increments(s);
    let step = |x: f64| Step {
        increments,
        motions: vec![
            (head.clone(), [Some(0.0), Some(0.0), None]),
            (vec![centre], [Some(x), Some(depth), Some(0.0)]),
        ],
        ..Step::default()
    };
    draft.steps = vec![step(0.0), step(way)];
    draft
}

/// A cantilever whose nose is drawn over a rigid disc, and back.
fn hook(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(World::Plane);
    let kind = s.one_of(&[PLANE_STRAIN[1], PLANE_STRESS[1], PLANE_STRAIN[4], PLANE_STRESS[4]]);
    let (length, height) = (s.between(4.0, 8.0), s.between(0.4, 0.7));
    let (nose, half) = (s.between(0.2, 0.5) * height, s.between(0.8, 1.2));
    let counts = [16 + s.below(24), 2 + s.below(2), 0];
    let tip = length - half;
    let part = Part::block(kind, counts, &mut draft.nodes, |[x, y, _]| {
        let at = x * length;
        let off = ((at - tip) / half).abs().min(1.0);
        let foot = -nose * 0.5 * (1.0 + (std::f64::consts::PI * off).cos());
        [at, foot + y * (height - foot), 0.0]
    });
    draft.parts.push((part, Material::Elastic(1.0, s.between(0.2, 0.4))));
    draft.thickness = s.power(-1.0, 1.0);
    let radius = s.between(0.5, 2.0);
    let lap = s.between(0.3, 0.8) * nose;
    let start = length + 1.5 * half + radius;
    draft.nodes.push([start, lap - nose - radius, 0.0]);
    draft.discs.push(Disc { node: draft.nodes.len() - 1, radius });
    let mortar = s.below(2) == 0;
    draft.pairs.push(Pair { slave: Surface::Side(0, BELOW), master: Surface::Disc(0), mortar });
    laws(&mut draft, 0.25, s);
    let (root, centre) = (draft.side(0, (0, false)), draft.discs[0].node);
    let way = start - tip + 2.0 * half;
    let step = |x: f64| Step {
        increments: [0.02, 1e-7, 0.04],
        motions: vec![
            (root.clone(), [Some(0.0), Some(0.0), None]),
            (vec![centre], [Some(-x), Some(0.0), Some(0.0)]),
        ],
        ..Step::default()
    };
    draft.steps = vec![step(way), step(0.0)];
    draft
}

/// A sleeve with a taper pushed on a shaft.
fn sleeve(s: &mut Sequence) -> Draft {
    let mut draft = Draft::new(World::Rings);
    let [inner, outer] = [0, 1].map(|_| s.one_of(&RINGS));
    let (bore, radius) = (s.between(0.0, 0.6), 1.0);
    let (wall, slope) = (s.between(0.3, 0.8), s.between(0.01, 0.06));
    let (shaft, hub) = (s.between(1.5, 2.5), s.between(0.6, 1.0));
    let mut counts = || [1 + s.below(3), 4 + s.below(6), 0];
    let [a, b] = [counts(), counts()];
    let part = Part::block(inner, a, &mut draft.nodes, |[x, y, _]| {
        let rim = radius + slope * (1.0 - y) * shaft;
        [bore + x * (rim - bore), (y - 1.0) * shaft, 0.0]
    });
    let made_of = material(inner, s);
    draft.parts.push((part, made_of));
    let gap = s.between(0.0, 0.002);
    let start = -s.between(0.3, 0.6) * hub;
    let part = Part::block(outer, b, &mut draft.nodes, |[x, y, _]| {
        let along = start + y * hub;
        let rim = radius + gap - slope * start.min(0.0) - slope * (along - start);
        [rim + x * wall, along, 0.0]
    });
    let made_of = material(outer, s);
    draft.parts.push((part, made_of));
    let faces = [Surface::Side(0, (0, true)), Surface::Side(1, (0, false))];
    let master = s.below(2);
    let mortar = s.below(2) == 0;
    draft.pairs.push(Pair { slave: faces[1 - master], master: faces[master], mortar });
    laws(&mut draft, 0.3, s);
    let (base, head) = (draft.side(0, BELOW), draft.side(1, ABOVE));
    let way = gap / slope + s.between(0.1, 0.4);
    let increments = increments(s);
    let step = |y: f64| Step {
        increments,
        motions: vec![
            (base.clone(), [None, Some(0.0), None]),
            (head.clone(), [None, Some(y), None]),
        ],
        ..Step::default()
    };
    draft.steps = vec![step(-way)];
    if s.below(2) == 0 {
        draft.steps.push(step(0.0));
    }
    draft
}
