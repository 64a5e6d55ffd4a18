//! A draft of solids as the text of a deck: placed, scaled, numbered.

use super::draft::{Draft, Material, Prescribed, Skins, Step, Surface, World};
use crate::random::Sequence;
use crate::random::classes::{Units, line, write_laws};

/// Units and place of a model, and its numbers.
#[derive(Clone, Debug)]
pub struct Placement {
    /// Units of the deck.
    pub units: Units,
    /// Rows of the rotation.
    turn: [[f64; 3]; 3],
    shift: [f64; 3],
    /// Number of each node.
    pub numbers: Vec<u64>,
}

const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Placement {
    /// Any units, any place; turned by any angle where the supports allow it.
    pub fn drawn(draft: &Draft, s: &mut Sequence) -> Self {
        let units = if s.below(2) == 0 { Units::drawn(s).exact() } else { Units::NATURAL };
        let motions = draft.steps.iter().flat_map(|step| &step.motions);
        let dimension = draft.dimension();
        let all_held =
            motions.clone().all(|(_, held)| held[..dimension].iter().all(Option::is_some));
        let turn = match draft.world {
            World::Plane if !all_held && draft.quarter => quarter(s.below(4)),
            World::Plane if all_held => about_the_third(s.between(-3.1, 3.1)),
            World::Space if all_held => rotation(s),
            _ => UPRIGHT,
        };
        let mut shift = [0.0; 3];
        if s.below(3) == 0 {
            shift = [0; 3].map(|_| s.between(-2.0, 2.0));
        }
        match draft.world {
            World::Plane => shift[2] = 0.0,
            World::Rings => shift = [0.0, shift[1], 0.0],
            World::Space => {}
        }
        let mut numbers: Vec<u64> = (1..=draft.nodes.len() as u64).collect();
        if s.below(3) == 0 {
            for k in (1..numbers.len()).rev() {
                numbers.swap(k, s.below(k + 1));
            }
            let step = 1 + s.below(7) as u64;
            numbers.iter_mut().for_each(|number| *number *= step);
        }
        Self { units, turn, shift, numbers }
    }

    /// The same place in natural units.
    pub fn unscaled(&self) -> Self {
        Self { units: Units::NATURAL, ..self.clone() }
    }

    fn turned(&self, at: [f64; 3]) -> [f64; 3] {
        self.turn.map(|row| row.iter().zip(&at).map(|(a, b)| a * b).sum())
    }

    /// A vector of the deck in the axes of the draft.
    pub fn back(&self, v: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| (0..3).map(|row| self.turn[row][k] * v[row]).sum())
    }

    fn point(&self, at: [f64; 3], dimension: usize) -> String {
        let turned = self.turned(at);
        let parts = (0..dimension).map(|k| (turned[k] + self.shift[k]) * self.units.length);
        parts.map(|part| format!("{part:.16e}")).collect::<Vec<_>>().join(", ")
    }
}

/// A rotation by so many right angles.
fn quarter(count: usize) -> [[f64; 3]; 3] {
    let (sin, cos) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][count];
    [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]
}

fn about_the_third(angle: f64) -> [[f64; 3]; 3] {
    let (sin, cos) = angle.sin_cos();
    [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]
}

/// Any rotation, by a quaternion.
fn rotation(s: &mut Sequence) -> [[f64; 3]; 3] {
    let q: [f64; 4] = [0; 4].map(|_| s.between(-1.0, 1.0));
    let size = q.iter().map(|part| part * part).sum::<f64>().sqrt().max(1e-3);
    let [w, x, y, z] = q.map(|part| part / size);
    if w * w + x * x + y * y + z * z < 0.99 {
        return UPRIGHT;
    }
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// The deck.
pub fn write(draft: &Draft, placed: &Placement, name: &str) -> String {
    let mut text = format!("*HEADING\n{name}\n*NODE, NSET=ALL\n");
    let mut order: Vec<usize> = (0..draft.nodes.len()).collect();
    order.sort_by_key(|&node| placed.numbers[node]);
    for node in order {
        let at = placed.point(draft.nodes[node], draft.dimension());
        line(&mut text, &format!("{}, {at}", placed.numbers[node]));
    }
    parts(&mut text, draft, placed);
    for (k, disc) in draft.discs.iter().enumerate() {
        let centre = draft.nodes[disc.node];
        profile(&mut text, placed, (k, centre, disc.radius));
        let number = placed.numbers[disc.node];
        line(&mut text, &format!("*RIGID BODY, REF NODE={number}, ANALYTICAL SURFACE=D{k}"));
    }
    write_laws(&mut text, (&draft.normal, &draft.friction, draft.thickness), placed.units);
    pairs(&mut text, draft);
    for (k, step) in draft.steps.iter().enumerate() {
        history(&mut text, (draft, placed), (k, step));
    }
    text
}

fn pairs(text: &mut String, draft: &Draft) {
    if draft.general {
        let all =
            "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I0";
        line(text, all);
        return;
    }
    for (k, pair) in draft.pairs.iter().enumerate() {
        let slave = surface(text, draft, (format!("SL{k}"), pair.slave));
        let master = surface(text, draft, (format!("MA{k}"), pair.master));
        let kind = if pair.mortar { "SURFACE TO SURFACE" } else { "NODE TO SURFACE" };
        line(text, &format!("*CONTACT PAIR, INTERACTION=I0, TYPE={kind}\n{slave}, {master}"));
    }
}

/// First element of a part.
fn first_element(draft: &Draft, part: usize) -> usize {
    1 + draft.parts[..part].iter().map(|part| part.0.cells.len()).sum::<usize>()
}

fn parts(text: &mut String, draft: &Draft, placed: &Placement) {
    for (k, (part, made_of)) in draft.parts.iter().enumerate() {
        line(text, &format!("*ELEMENT, TYPE={}, ELSET=P{k}", part.kind.name));
        for (cell, nodes) in part.cells.iter().enumerate() {
            let mut names = vec![(first_element(draft, k) + cell).to_string()];
            names.extend(nodes.iter().map(|&node| placed.numbers[node].to_string()));
            for (row, names) in names.chunks(12).enumerate() {
                let last = (row + 1) * 12 > nodes.len();
                line(text, &format!("{}{}", names.join(", "), if last { "" } else { "," }));
            }
        }
        line(text, &format!("*SOLID SECTION, ELSET=P{k}, MATERIAL=M{k}"));
        if draft.world == World::Plane {
            line(text, &format!("{:e}", draft.thickness * placed.units.length));
        }
        line(text, &format!("*MATERIAL, NAME=M{k}"));
        let pressure = |natural: f64| placed.units.pressure(natural);
        match *made_of {
            Material::Elastic(e, nu) => line(text, &format!("*ELASTIC\n{:e}, {nu}", pressure(e))),
            Material::Rubber(shear, bulk) => {
                let (c10, d1) = (pressure(0.5 * shear), 2.0 / pressure(bulk));
                line(text, &format!("*HYPERELASTIC, NEO HOOKE\n{c10:e}, {d1:e}"));
            }
            Material::Plastic(e, nu, yields, hardening) => {
                line(text, &format!("*ELASTIC\n{:e}, {nu}\n*PLASTIC", pressure(e)));
                line(text, &format!("{:e}, 0.0", pressure(yields)));
                line(text, &format!("{:e}, 1.0", pressure(yields + hardening)));
            }
        }
    }
}

/// The rim of a disc, from its top clockwise and all round.
fn profile(text: &mut String, placed: &Placement, (k, centre, radius): (usize, [f64; 3], f64)) {
    let rim = |quarter: usize| {
        let (sin, cos) = (std::f64::consts::FRAC_PI_2 * quarter as f64).sin_cos();
        placed.point([centre[0] - radius * cos, centre[1] + radius * sin, 0.0], 2)
    };
    line(text, &format!("*SURFACE, NAME=D{k}, TYPE=SEGMENTS\nSTART, {}", rim(3)));
    let centre = placed.point(centre, 2);
    for quarter in 0..4 {
        line(text, &format!("CIRCL, {}, {centre}", rim(quarter)));
    }
}

fn surface(text: &mut String, draft: &Draft, (name, surface): (String, Surface)) -> String {
    match surface {
        Surface::Disc(disc) => format!("D{disc}"),
        Surface::Side(part, side) => {
            line(text, &format!("*SURFACE, NAME={name}"));
            if draft.skins == Skins::Whole {
                line(text, &format!("P{part}"));
                return name;
            }
            for (cell, face) in draft.parts[part].0.faces(side) {
                line(text, &format!("{}, S{face}", first_element(draft, part) + cell));
            }
            name
        }
    }
}

fn history(text: &mut String, (draft, placed): (&Draft, &Placement), (k, step): (usize, &Step)) {
    let [first, least, most] = step.increments.map(|part| part * placed.units.time);
    line(text, &format!("*STEP, NLGEOM, INC=2000\nstep {k}\n*STATIC"));
    line(text, &format!("{first:e}, {:e}, {least:e}, {most:e}", placed.units.time));
    line(text, "*BOUNDARY");
    for (nodes, held) in &step.motions {
        for &node in nodes {
            boundary(text, (draft, placed), (node, held));
        }
    }
    if !step.loads.is_empty() {
        line(text, "*CLOAD");
        for (node, load) in &step.loads {
            for (axis, part) in placed.turned(*load).iter().enumerate() {
                if *part != 0.0 {
                    let value = part * placed.units.force;
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

/// A node that is held; the third motion of a disc is its rotation.
fn boundary(
    text: &mut String,
    (draft, placed): (&Draft, &Placement),
    (node, held): (usize, &Prescribed),
) {
    let number = placed.numbers[node];
    let dimension = draft.dimension();
    let turned = placed.turned(held.map(|value| value.unwrap_or(0.0)));
    for (axis, row) in placed.turn[..dimension].iter().enumerate() {
        let own = row.iter().zip(held);
        if own.filter(|(by, _)| **by != 0.0).all(|(_, value)| value.is_some()) {
            let value = turned[axis] * placed.units.length;
            line(text, &format!("{number}, {0}, {0}, {value:e}", axis + 1));
        }
    }
    if let (2, Some(angle)) = (dimension, held[2]) {
        line(text, &format!("{number}, 6, 6, {angle:e}"));
    }
}
