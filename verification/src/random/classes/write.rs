//! A draft as the text of a deck: placed, scaled, numbered.

use super::draft::{
    Body, Chain, Draft, Element, Friction, Normal, Pair, Prescribed, Side, Spring, Step, Stick,
};
use crate::random::Sequence;
use std::fmt::Write as _;

/// Units and place of a model, and the numbers of its nodes.
#[derive(Clone, Debug)]
pub struct Placement {
    /// Length of the natural length.
    pub length: f64,
    /// Force of the natural force: modulus times length squared.
    pub force: f64,
    /// Period of a step.
    pub time: f64,
    /// Rows of the rotation, mirrored or not.
    turn: [[f64; 2]; 2],
    /// Whether it is a mirror image.
    mirrored: bool,
    shift: [f64; 2],
    /// Number of each node.
    pub numbers: Vec<u64>,
}

impl Placement {
    /// As drafted.
    pub fn natural(draft: &Draft) -> Self {
        Self {
            length: 1.0,
            force: 1.0,
            time: 1.0,
            turn: [[1.0, 0.0], [0.0, 1.0]],
            mirrored: false,
            shift: [0.0; 2],
            numbers: (1..=draft.nodes.len() as u64).collect(),
        }
    }

    /// Any units, any place; turned by any angle where the supports allow it.
    pub fn drawn(draft: &Draft, s: &mut Sequence) -> Self {
        let mut placed = Self::natural(draft);
        if s.below(2) == 0 {
            let Units { length, force, time } = Units::drawn(s);
            (placed.length, placed.force, placed.time) = (length, force, time);
        }
        let quarters = s.below(4) as f64;
        let angle = match free_of_axes(draft) {
            true if s.below(2) == 0 => s.between(-3.1, 3.1),
            _ => quarters * std::f64::consts::FRAC_PI_2,
        };
        let (sin, cos) = if angle == quarters * std::f64::consts::FRAC_PI_2 {
            [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarters as usize]
        } else {
            angle.sin_cos()
        };
        placed.mirrored = s.below(2) == 0;
        let side = if placed.mirrored { -1.0 } else { 1.0 };
        placed.turn = [[cos, -sin * side], [sin, cos * side]];
        if s.below(3) == 0 {
            placed.shift = [s.between(-2.0, 2.0), s.between(-2.0, 2.0)];
        }
        if s.below(3) == 0 {
            for k in (1..placed.numbers.len()).rev() {
                placed.numbers.swap(k, s.below(k + 1));
            }
            let step = 1 + s.below(7) as u64;
            placed.numbers.iter_mut().for_each(|number| *number *= step);
        }
        placed
    }

    /// The same place in natural units.
    pub fn unscaled(&self) -> Self {
        Self { length: 1.0, force: 1.0, time: 1.0, ..self.clone() }
    }

    /// A vector as it stands in the deck, unscaled.
    fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.turn.map(|[a, b]| a * x + b * y)
    }

    /// A vector of the deck in the axes of the draft.
    pub fn back(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[a, b], [c, d]] = self.turn;
        [a * x + c * y, b * x + d * y]
    }

    /// Sign of rotations.
    pub fn sense(&self) -> f64 {
        if self.mirrored { -1.0 } else { 1.0 }
    }

    fn point(&self, at: [f64; 2]) -> String {
        let [x, y] = self.turned(at);
        let [x, y] = [x + self.shift[0], y + self.shift[1]].map(|part| part * self.length);
        format!("{x:.16e}, {y:.16e}")
    }

    fn units(&self) -> Units {
        Units { length: self.length, force: self.force, time: self.time }
    }

    fn pressure(&self, natural: f64) -> f64 {
        self.units().pressure(natural)
    }
}

/// What natural units are in those of a deck.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// Length.
    pub length: f64,
    /// Force.
    pub force: f64,
    /// Period of a step.
    pub time: f64,
}

impl Units {
    /// Those of the draft.
    pub const NATURAL: Self = Self { length: 1.0, force: 1.0, time: 1.0 };

    /// Any, over many decades.
    pub fn drawn(s: &mut Sequence) -> Self {
        let length = s.power(-9.0, 3.0);
        let force = s.power(-12.0, 9.0) / 1e-6;
        Self { length, force, time: s.power(-6.0, 4.0) }
    }

    /// The nearest powers of two: numbers in them round as in natural units, so that a run must not
    /// differ in a single bit.
    pub fn exact(self) -> Self {
        let near = |x: f64| x.log2().round().exp2();
        Self { length: near(self.length), force: near(self.force), time: near(self.time) }
    }

    /// A pressure in the units of the deck.
    pub fn pressure(&self, natural: f64) -> f64 {
        natural * self.force / (self.length * self.length)
    }
}

/// Whether nothing is held along one axis alone.
fn free_of_axes(draft: &Draft) -> bool {
    let motions = draft.steps.iter().flat_map(|step| &step.motions);
    let both = motions.clone().all(|(_, [x, y, _])| x.is_some() == y.is_some());
    both && !draft.springs.iter().any(|spring| matches!(spring, Spring::Ground(..)))
}

/// The deck.
pub fn write(draft: &Draft, placed: &Placement, name: &str) -> String {
    let mut text = format!("*HEADING\n{name}\n*NODE, NSET=ALL\n");
    let mut order: Vec<usize> = (0..draft.nodes.len()).collect();
    order.sort_by_key(|&node| placed.numbers[node]);
    for node in order {
        let at = placed.point(draft.nodes[node]);
        line(&mut text, &format!("{}, {at}", placed.numbers[node]));
    }
    let mut element = 1;
    for (k, chain) in draft.chains.iter().enumerate() {
        beams(&mut text, (draft, placed), (k, chain), &mut element);
    }
    for (k, body) in draft.bodies.iter().enumerate() {
        profile(&mut text, placed, (k, body));
    }
    if !draft.links.is_empty() {
        line(&mut text, "*MPC");
        for [foot, master] in &draft.links {
            let [foot, master] = [foot, master].map(|&node| placed.numbers[node]);
            line(&mut text, &format!("BEAM, {foot}, {master}"));
        }
    }
    springs(&mut text, draft, placed);
    if !draft.pairs.is_empty() {
        let of = (&draft.normal, &draft.friction, draft.width);
        laws(&mut text, of, placed.units());
    }
    for (k, pair) in draft.pairs.iter().enumerate() {
        contact(&mut text, placed, (k, pair));
    }
    for (k, step) in draft.steps.iter().enumerate() {
        history(&mut text, placed, (k, step));
    }
    text
}

/// A line more.
pub fn line(text: &mut String, more: &str) {
    text.push_str(more);
    text.push('\n');
}

fn beams(
    text: &mut String,
    (draft, placed): (&Draft, &Placement),
    (k, chain): (usize, &Chain),
    element: &mut usize,
) {
    line(text, &format!("*ELEMENT, TYPE={}, ELSET=S{k}", chain.element.word()));
    let mut nodes: Vec<u64> = chain.nodes.iter().map(|&node| placed.numbers[node]).collect();
    if chain.closed {
        nodes.push(nodes[0]);
    }
    let per = if chain.element == Element::B22 { 2 } else { 1 };
    for first in (0..nodes.len() - 1).step_by(per) {
        let names: Vec<_> = nodes[first..=first + per].iter().map(u64::to_string).collect();
        line(text, &format!("{element}, {}", names.join(", ")));
        *element += 1;
    }
    line(text, &format!("*BEAM SECTION, SECTION=RECT, ELSET=S{k}, MATERIAL=M{k}"));
    let [width, height] = [draft.width, chain.height].map(|size| size * placed.length);
    line(text, &format!("{width:e}, {height:e}\n*MATERIAL, NAME=M{k}\n*ELASTIC"));
    line(text, &format!("{:e}, 0.3", placed.pressure(chain.modulus)));
}

fn profile(text: &mut String, placed: &Placement, (k, body): (usize, &Body)) {
    // A mirror image is run through from its other end.
    let mut corners = vec![(body.start, None)];
    corners.extend(body.pieces.iter().map(|piece| (piece.to, piece.centre)));
    if placed.mirrored {
        let ends: Vec<_> = corners.iter().rev().map(|corner| corner.0).collect();
        let centres = corners.iter().skip(1).rev().map(|corner| corner.1);
        corners = std::iter::once(None).chain(centres).zip(ends).map(|(c, to)| (to, c)).collect();
    }
    line(text, &format!("*SURFACE, NAME=R{k}, TYPE=SEGMENTS"));
    line(text, &format!("START, {}", placed.point(corners[0].0)));
    for (to, centre) in &corners[1..] {
        let to = placed.point(*to);
        match centre {
            Some(centre) => line(text, &format!("CIRCL, {to}, {}", placed.point(*centre))),
            None => line(text, &format!("LINE, {to}")),
        }
    }
    let number = placed.numbers[body.node];
    line(text, &format!("*RIGID BODY, REF NODE={number}, ANALYTICAL SURFACE=R{k}"));
}

fn springs(text: &mut String, draft: &Draft, placed: &Placement) {
    for (k, spring) in draft.springs.iter().enumerate() {
        let element = 900_000 + k;
        let unit = placed.force / placed.length;
        let (kind, nodes, dof, stiffness) = match *spring {
            Spring::Ground(node, axis, stiffness) => {
                let dof = if placed.turn[axis][axis] == 0.0 { 1 - axis } else { axis } + 1;
                ("SPRING1", placed.numbers[node].to_string(), dof.to_string(), stiffness)
            }
            Spring::Between(a, b, stiffness) => {
                let nodes = format!("{}, {}", placed.numbers[a], placed.numbers[b]);
                ("SPRINGA", nodes, String::new(), stiffness)
            }
        };
        line(text, &format!("*ELEMENT, TYPE={kind}, ELSET=SP{k}\n{element}, {nodes}"));
        line(text, &format!("*SPRING, ELSET=SP{k}\n{dof}\n{:e}", stiffness * unit));
    }
}

/// The interaction I0: width, pressure, friction.
pub fn laws(text: &mut String, (normal, friction, width): (&Normal, &Friction, f64), units: Units) {
    let length = units.length;
    let pressure = |natural: f64| units.pressure(natural);
    line(text, &format!("*SURFACE INTERACTION, NAME=I0\n{:e}", width * length));
    let Friction { mu, stick } = *friction;
    match stick {
        _ if mu == 0.0 => {}
        Stick::Default => line(text, &format!("*FRICTION\n{mu}")),
        Stick::ElasticSlip(slip) => {
            line(text, &format!("*FRICTION, ELASTIC SLIP={:e}\n{mu}", slip * length));
        }
        Stick::Tolerance(part) => {
            line(text, &format!("*FRICTION, SLIP TOLERANCE={part:e}\n{mu}"));
        }
        Stick::Lagrange => line(text, &format!("*FRICTION, LAGRANGE\n{mu}")),
        Stick::Limit(most) => {
            line(text, &format!("*FRICTION, TAUMAX={:e}\n{mu}", pressure(most)));
        }
        Stick::Decay(kinetic, rate) => {
            let rate = rate * units.time / length;
            line(text, &format!("*FRICTION, EXPONENTIAL DECAY\n{mu}, {kinetic}, {rate:e}"));
        }
    }
    let word = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE";
    match normal {
        Normal::Hard => line(text, &format!("{word}=HARD")),
        Normal::Linear(k) => line(text, &format!("{word}=LINEAR\n{:e}", pressure(*k) / length)),
        Normal::Exponential(c, p) => {
            let data = format!("{:e}, {:e}", c * length, pressure(*p));
            line(text, &format!("{word}=EXPONENTIAL\n{data}"));
        }
        Normal::Tabular(rows) => {
            line(text, &format!("{word}=TABULAR"));
            for [p, h] in rows {
                line(text, &format!("{:e}, {:e}", pressure(*p), h * length));
            }
        }
    }
}

fn contact(text: &mut String, placed: &Placement, (k, pair): (usize, &Pair)) {
    let mut side = |side: &Side, letter: &str| match side {
        Side::Body(body) => format!("R{body}"),
        Side::Chain(chain) => {
            let _ = writeln!(text, "*SURFACE, NAME={letter}{k}\nS{chain}");
            format!("{letter}{k}")
        }
        Side::Nodes(nodes) => {
            let _ = writeln!(text, "*SURFACE, NAME={letter}{k}, TYPE=NODE");
            for &node in nodes {
                let _ = writeln!(text, "{}", placed.numbers[node]);
            }
            format!("{letter}{k}")
        }
    };
    let (slave, master) = (side(&pair.slave, "SL"), side(&pair.master, "MA"));
    let kind = if pair.integrated { "SURFACE TO SURFACE" } else { "NODE TO SURFACE" };
    let smooth = match pair.master {
        Side::Chain(_) => format!(", SMOOTH={:.3}", pair.smooth),
        _ => String::new(),
    };
    line(text, &format!("*CONTACT PAIR, INTERACTION=I0, TYPE={kind}{smooth}\n{slave}, {master}"));
}

fn history(text: &mut String, placed: &Placement, (k, step): (usize, &Step)) {
    let direct = if step.direct { ", DIRECT" } else { "" };
    let [first, least, most] = step.increments.map(|part| part * placed.time);
    line(text, &format!("*STEP, NLGEOM, INC=2000\nstep {k}\n*STATIC{direct}"));
    let _ = match step.direct {
        true => writeln!(text, "{first:e}, {:e}", placed.time),
        false => writeln!(text, "{first:e}, {:e}, {least:e}, {most:e}", placed.time),
    };
    line(text, if step.anew { "*BOUNDARY, OP=NEW" } else { "*BOUNDARY" });
    for (node, held) in &step.motions {
        boundary(text, placed, (placed.numbers[*node], held));
    }
    if !step.loads.is_empty() {
        line(text, "*CLOAD");
        for (node, load) in &step.loads {
            let turned = placed.turned(*load);
            for (axis, part) in turned.iter().enumerate() {
                if *part != 0.0 {
                    let value = part * placed.force;
                    line(text, &format!("{}, {}, {value:e}", placed.numbers[*node], axis + 1));
                }
            }
        }
    }
    if k == 0 {
        line(text, "*NODE PRINT, NSET=ALL, FREQUENCY=0\nU");
    }
    line(text, "*OUTPUT, FIELD, FREQUENCY=0\n*END STEP");
}

fn boundary(text: &mut String, placed: &Placement, (number, held): (u64, &Prescribed)) {
    let [x, y] = [held[0], held[1]].map(|value| value.unwrap_or(0.0) * placed.length);
    let turned = placed.turned([x, y]);
    for (axis, value) in turned.iter().enumerate() {
        // the axis of the draft that lies along this one of the deck
        let own = if placed.turn[axis][axis] == 0.0 { 1 - axis } else { axis };
        if held[own].is_some() {
            line(text, &format!("{number}, {0}, {0}, {value:e}", axis + 1));
        }
    }
    if let Some(angle) = held[2] {
        line(text, &format!("{number}, 6, 6, {:e}", angle * placed.sense()));
    }
}
