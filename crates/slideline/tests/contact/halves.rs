//! Halves and quarters of symmetric models, with contact at nodes of smoothed masters: what lies beyond a plane of symmetry
//! is the image of the model.
//!
//! ```text
//!            |o--o--o            :  half of a block on half of a round one; the nodes in the plane are
//!            |o--o--o--o         :  held across it
//!            |o--o--o--o_        :
//!            |o--o--o--o-'o
//! ```
//!
//! docs/theory.md sections 5.3 and 5.9.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::space_decks::{Last, checked, size, solved};
use slideline::{Job, ReadOptions};
use std::fmt::Write as _;

/// Cells of a half of the master and of the slave along an axis, and their lengths [L].
const CELLS: [(i64, f64); 2] = [(4, 0.5), (3, 0.4)];
/// Layers of each.
const LAYERS: i64 = 2;

/// A symmetric model, or a part of one.
#[derive(Clone, Copy)]
struct Cut {
    /// In the plane or in space.
    is_in_space: bool,
    /// Across which axes it is cut.
    across: [bool; 2],
    /// How round the master is: out, or in [1/L].
    bend: f64,
    /// Whether it is a roof of two straight sides instead, which fall by half of that.
    is_roof: bool,
    /// By how much it is turned in the plane of x and y [rad].
    angle: f64,
    laws: &'static str,
}

const WHOLE: Cut = Cut {
    is_in_space: false,
    across: [false; 2],
    bend: -0.15,
    is_roof: false,
    angle: 0.0,
    laws: "",
};

impl Cut {
    /// Numbers along both axes of the nodes of a body.
    fn reach(&self, body: usize) -> [std::ops::RangeInclusive<i64>; 2] {
        let count = CELLS[body].0;
        [0, 1].map(|axis| match (axis == 1 && !self.is_in_space, self.across[axis]) {
            (true, _) => 0..=0,
            (_, true) => 0..=count,
            (_, false) => -count..=count,
        })
    }

    fn label([i, j, k]: [i64; 3], body: usize) -> i64 {
        1 + (i + 4) + 9 * (j + 4) + 81 * (k + 3 * body as i64)
    }

    fn nodes(&self, body: usize) -> Vec<[i64; 3]> {
        let [x, y] = self.reach(body);
        let plane = x.flat_map(|i| y.clone().map(move |j| [i, j]));
        plane.flat_map(|[i, j]| (0..=LAYERS).map(move |k| [i, j, k])).collect()
    }

    fn place(&self, [i, j, k]: [i64; 3], body: usize) -> [f64; 3] {
        let [x, y] = [i, j].map(|n| n as f64 * CELLS[body].1);
        let rise = if self.is_roof { x.abs() } else { x * x + y * y };
        let (top, t) = (0.5 * self.bend * rise, k as f64 / LAYERS as f64);
        // the slave is flatter: it is met in the middle first
        let z =
            if body == 0 { -1.0 + t * (1.0 + top) } else { (1.0 - t) * (0.8 * top).max(top) + t };
        let (s, c) = self.angle.sin_cos();
        match self.is_in_space {
            true => [c * x - s * y, s * x + c * y, z],
            false => [c * x - s * z, s * x + c * z, 0.0],
        }
    }

    fn elements(&self, body: usize, deck: &mut String) {
        let [x, y] = self.reach(body);
        let last = |reach: &std::ops::RangeInclusive<i64>| *reach.end();
        for (i, k) in x.clone().flat_map(|i| (0..LAYERS).map(move |k| (i, k))) {
            for j in y.clone() {
                let ends = i == last(&x) || (self.is_in_space && j == last(&y));
                if ends {
                    continue;
                }
                let at = |di, dj, dk| Self::label([i + di, j + dj, k + dk], body).to_string();
                let nodes = match self.is_in_space {
                    true => [0, 1]
                        .map(|k| [at(0, 0, k), at(1, 0, k), at(1, 1, k), at(0, 1, k)])
                        .concat(),
                    false => vec![at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)],
                };
                let _ = writeln!(deck, "{}, {}", Self::label([i, j, k], body), nodes.join(", "));
            }
        }
    }

    /// Sets of the nodes in the planes of the cut.
    fn planes(&self, deck: &mut String) {
        for (axis, name) in
            ["X0", "Y0"].into_iter().enumerate().filter(|(axis, _)| self.across[*axis])
        {
            let _ = writeln!(deck, "*NSET, NSET={name}");
            for body in 0..2 {
                for node in self.nodes(body).into_iter().filter(|node| node[axis] == 0) {
                    let _ = writeln!(deck, "{}", Self::label(node, body));
                }
            }
        }
    }

    /// The deck, pushed together; `held` says how the nodes in the planes of the cut are.
    fn deck(&self, held: &str) -> String {
        let (mut deck, up) =
            (String::from("*NODE, NSET=ALL\n"), if self.is_in_space { 3 } else { 2 });
        let (kind, faces) =
            if self.is_in_space { ("C3D8", ["S2", "S1"]) } else { ("CPS4", ["S3", "S1"]) };
        for (body, node) in
            [0, 1].into_iter().flat_map(|b| self.nodes(b).into_iter().map(move |n| (b, n)))
        {
            let [x, y, z] = self.place(node, body);
            let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", Self::label(node, body));
        }
        for (body, face) in faces.into_iter().enumerate() {
            let _ = writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET=B{body}");
            self.elements(body, &mut deck);
            let _ = writeln!(deck, "*SOLID SECTION, ELSET=B{body}, MATERIAL=M\n1.");
            let (layer, low) = if body == 0 { (LAYERS - 1, 0) } else { (0, LAYERS) };
            let _ = writeln!(deck, "*SURFACE, NAME=F{body}");
            let mut rest = String::new();
            self.elements(body, &mut rest);
            for line in rest.lines() {
                let label: i64 = line.split(',').next().unwrap().trim().parse().unwrap();
                if (label - 1) / 81 == layer + 3 * body as i64 {
                    let _ = writeln!(deck, "{label}, {face}");
                }
            }
            let _ = writeln!(deck, "*NSET, NSET=END{body}");
            for node in self.nodes(body).into_iter().filter(|node| node[2] == low) {
                let _ = writeln!(deck, "{}", Self::label(node, body));
            }
        }
        self.planes(&mut deck);
        let (s, c) = self.angle.sin_cos();
        let _ = writeln!(
            deck,
            "*TRANSFORM, NSET=ALL\n{c:?}, {s:?}, 0., {:?}, {c:?}, 0.\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE INTERACTION, NAME=I\n{}\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nF1, F0\n*BOUNDARY\nEND0, 1, 3\n{held}\
             *STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\nEND1, 1, {}\nEND1, {up}, {up}, -0.06\n*END STEP",
            -s,
            self.laws,
            up - 1
        );
        deck
    }

    /// What is left of it where the nodes in the planes of the cut are held across these.
    fn left(&self) -> Last {
        let held = [(self.across[0], "X0, 1, 1\n"), (self.across[1], "Y0, 2, 2\n")];
        let held: String =
            held.iter().filter(|(is_cut, _)| *is_cut).map(|(_, line)| *line).collect();
        let deck = self.deck(&held);
        if self.across[0] { checked(&deck) } else { solved(&deck) }
    }

    /// The force along the stroke.
    fn force(&self, last: &Last) -> f64 {
        let (s, c) = self.angle.sin_cos();
        let [x, y, z] = last.force();
        if self.is_in_space { z } else { c * y - s * x }
    }
}

/// Force of friction, and an overclosure that presses softly.
const LAWS: [&str; 3] = [
    "",
    "*FRICTION\n0.4\n",
    "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 5.\n*FRICTION\n0.2\n",
];

/// Requirement: half of a model in the plane has half of its force, with an exact tangent and forces in balance, however
/// it is turned. One-sided curves at the plane missed it by a thousandth and more.
#[test]
fn half_of_a_model_has_half_of_its_force() {
    for ((bend, angle), laws) in [(-0.15, 0.0), (0.15, 0.7), (-0.3, -2.0)].into_iter().zip(LAWS) {
        let whole = Cut { bend, angle, laws, ..WHOLE };
        let half = Cut { across: [true, false], ..whole };
        let (of_half, of_whole) = (half.left(), whole.left());
        let [own, expected] = [half.force(&of_half), 0.5 * whole.force(&of_whole)];
        assert!((own - expected).abs() < 1e-8 * expected.abs(), "{bend}: {own} {expected}");
        assert!(of_half.off < 1e-5 && of_half.worst < 1e-10, "{} {}", of_half.off, of_half.worst);
    }
}

/// Requirement: a node upon the ridge of a roof, in the middle of a model, keeps a side while it sticks, whatever rounding
/// tells of the nearer one. It went to and fro between both, and no increment ended.
#[test]
fn a_node_on_a_ridge_keeps_its_side() {
    let laws = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 5.\n*FRICTION\n0.4\n";
    for (bend, angle) in [(-0.02, 0.0), (-0.15, 0.3), (-0.3, -2.0)] {
        let whole = Cut { is_roof: true, bend, angle, laws, ..WHOLE };
        let half = Cut { across: [true, false], ..whole };
        let (last, expected) = (whole.left(), 2.0 * half.force(&half.left()));
        let own = whole.force(&last);
        assert!((own - expected).abs() < 1e-3 * expected.abs(), "{bend}: {own} {expected}");
        assert!(last.worst < 1e-10, "{}", last.worst);
    }
}

/// The same on a rigid roof in place of the lower body.
fn on_a_rigid_roof(whole: &Cut) -> String {
    let deck = whole.deck(if whole.across[0] { "X0, 1, 1\n" } else { "" });
    let [from, to] =
        ["B0", "B1"].map(|body| deck.find(&format!("*ELEMENT, TYPE=CPS4, ELSET={body}")).unwrap());
    let (s, c) = whole.angle.sin_cos();
    let [left, right] = [-2.0, 2.0].map(|x: f64| {
        let z = 0.5 * whole.bend * x.abs();
        format!("{:?}, {:?}", c * x - s * z, s * x + c * z)
    });
    let roof = format!(
        "*SURFACE, TYPE=SEGMENTS, NAME=F0\nSTART, {left}\nLINE, 0., 0.\nLINE, {right}\n\
         *NODE\n9000, 0., -1.\n*RIGID BODY, ANALYTICAL SURFACE=F0, REF NODE=9000\n"
    );
    [&deck[..from], &roof, &deck[to..].replace("END0, 1, 3", "9000, 1, 6")].concat()
}

/// Requirement: a node upon the corner of an analytical surface keeps its side too.
#[test]
fn a_node_on_a_rigid_corner_keeps_its_side() {
    let laws = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 5.\n*FRICTION\n0.4\n";
    for (bend, angle) in [(-0.02, 0.0), (-0.15, 0.3), (-0.3, -2.0)] {
        let whole = Cut { is_roof: true, bend, angle, laws, ..WHOLE };
        let half = Cut { across: [true, false], ..whole };
        let last = solved(&on_a_rigid_roof(&whole));
        let own = whole.force(&last);
        let expected = 2.0 * half.force(&solved(&on_a_rigid_roof(&half)));
        assert!((own - expected).abs() < 1e-3 * expected, "{bend}: {own} {expected}");
        assert!(last.worst < 1e-10, "{bend}: {}", last.worst);
    }
}

/// Requirement: a half and a quarter of a model in space have their parts of its force, to what a node between the corners
/// of a face in the plane tells of its side (1e-5).
#[test]
fn a_quarter_of_a_model_has_a_quarter_of_its_force() {
    for ((bend, angle), laws) in [(-0.15, 0.4), (0.15, 0.0)].into_iter().zip([LAWS[0], LAWS[2]]) {
        let whole = Cut { is_in_space: true, bend, angle, laws, ..WHOLE };
        let expected = whole.force(&whole.left());
        for (across, parts) in [([true, false], 2.0), ([true, true], 4.0)] {
            let part = Cut { across, ..whole };
            let last = part.left();
            let own = parts * part.force(&last);
            assert!((own - expected).abs() < 2e-5 * expected.abs(), "{bend}: {own} {expected}");
            assert!(last.off < 1e-5 && last.worst < 1e-10, "{} {}", last.off, last.worst);
        }
    }
}

/// Planes of symmetry that are found in a half that is held like this.
fn planes(half: &Cut, held: &str) -> usize {
    let read = Job::read_text("half", &half.deck(held), &ReadOptions::default());
    let model = read.model.unwrap();
    model.planes_beyond(model.contact_pairs.iter().map(|pair| pair.met_at_nodes()))[0].len()
}

/// Requirement: a plane is one of symmetry where all nodes in it are held across it and not all of them along it, by
/// supports, and the model lies on one side of it; a clamped or a driven end is none.
#[test]
fn clamped_ends_are_no_planes_of_symmetry() {
    let half = Cut { across: [true, false], angle: 0.3, ..WHOLE };
    assert_eq!(planes(&half, "X0, 1, 1\n"), 1);
    assert_eq!(planes(&half, "X0, XSYMM\n"), 1);
    assert_eq!(planes(&half, "X0, 1, 1\nX0, 2, 2\n"), 0);
    assert_eq!(planes(&half, "X0, ENCASTRE\n"), 0);
    assert_eq!(planes(&half, "X0, 2, 2\n"), 0);
    assert_eq!(planes(&half, ""), 0);
    let top = Cut::label([0, 0, LAYERS], 0);
    assert_eq!(planes(&half, &format!("{top}, 1, 1\n")), 0, "one node alone");
    let whole = Cut { across: [false; 2], ..half };
    assert_eq!(planes(&whole, &format!("{top}, 1, 1\n")), 0);
    let quarter = Cut { is_in_space: true, across: [true; 2], ..WHOLE };
    assert_eq!(planes(&quarter, "X0, 1, 1\nY0, 2, 2\n"), 2);
    assert_eq!(planes(&quarter, "X0, 1, 1\n"), 1);
}

/// Requirement: what is held about another part counts, and what the end of the master itself does: one that is clamped, in
/// whichever step, is no plane though a part beside it rolls there; nor is the outer side of a disc that is held all round.
#[test]
fn what_ends_there_is_asked_itself() {
    let half = Cut { across: [true, false], ..WHOLE };
    let rim = Cut::label([0, 0, LAYERS], 0);
    let clamped = |step: &str| format!("X0, 1, 1\n{step}{rim}, 2, 2\n");
    assert_eq!(planes(&half, &clamped("")), 0, "the rim itself");
    let found = |deck: &str| {
        let model = Job::read_text("half", deck, &ReadOptions::default()).model.unwrap();
        model.planes_beyond(model.contact_pairs.iter().map(|pair| pair.met_at_nodes()))[0].len()
    };
    let deck = half.deck("X0, 1, 1\n");
    assert_eq!(found(&deck), 1);
    let later =
        format!("{deck}\n*STEP, NLGEOM\n*STATIC\n1., 1.\n*BOUNDARY\n{rim}, 2, 2\n*END STEP");
    assert_eq!(found(&later), 0, "in a later step");
    // what is there in no step bounds nothing
    let beyond = "*NODE\n9001, -1., 0.\n9002, -0.5, 0.\n9003, -0.5, 1.\n9004, -1., 1.\n\
                  *ELEMENT, TYPE=CPS4, ELSET=BEYOND\n9001, 9001, 9002, 9003, 9004\n\
                  *SOLID SECTION, ELSET=BEYOND, MATERIAL=M\n1.\n*STEP";
    let with = deck.replace("*STEP", beyond);
    assert_eq!(found(&with), 0, "a part beyond the plane");
    let removed = with.replace("*END STEP", "*MODEL CHANGE, REMOVE\nBEYOND\n*END STEP");
    assert_eq!(found(&removed), 1, "one that is removed");
    let rings = deck.replace("CPS4", "CAX4");
    assert_eq!(found(&rings), 1, "the axis");
    let moved: String = rings.lines().map(|line| moved_off(line) + "\n").collect();
    assert_eq!(found(&moved), 0, "a cylinder");
}

/// A line of a deck, its node moved away from the axis.
fn moved_off(line: &str) -> String {
    let parts: Vec<&str> = line.split(',').map(str::trim).collect();
    match parts[..] {
        [label, x, y, _] if label.parse::<u64>().is_ok() && x.contains('.') => {
            format!("{label}, {:?}, {y}", x.parse::<f64>().unwrap() + 5.0)
        }
        _ => line.to_owned(),
    }
}

/// A ring of four-node elements about a disc with a hole that is pushed aside in it; the ring begins at a place of its own.
fn rings(begin: usize, laws: &str) -> String {
    const AROUND: usize = 24;
    let mut deck = String::from("*NODE\n");
    let (mut elements, mut faces, mut ends) =
        ([const { String::new() }; 2], [const { String::new() }; 2], [const { String::new() }; 2]);
    for (body, radii) in [[1.0, 1.25, 1.5], [0.6, 0.8, 0.98]].into_iter().enumerate() {
        let label = |around: usize, out: usize| 1 + 100 * (3 * body + out) + around % AROUND;
        for (k, out) in (0..AROUND).flat_map(|k| (0..3).map(move |out| (k, out))) {
            let first = if body == 0 { begin } else { 0 };
            let (s, c) =
                (std::f64::consts::TAU * ((k + first) % AROUND) as f64 / AROUND as f64).sin_cos();
            let _ = writeln!(deck, "{}, {:?}, {:?}", label(k, out), radii[out] * c, radii[out] * s);
            if out < 2 {
                let nodes =
                    [label(k, out), label(k, out + 1), label(k + 1, out + 1), label(k + 1, out)];
                let nodes = nodes.map(|node| node.to_string()).join(", ");
                let _ = writeln!(elements[body], "{}, {nodes}", label(k, out));
            }
        }
        let (layer, face, end) = if body == 0 { (0, "S4", 2) } else { (1, "S2", 0) };
        for k in 0..AROUND {
            let _ = writeln!(faces[body], "{}, {face}", label(k, layer));
            let _ = writeln!(ends[body], "{}", label(k, end));
        }
    }
    for body in 0..2 {
        let _ = writeln!(
            deck,
            "*ELEMENT, TYPE=CPS4, ELSET=B{body}\n{}*SOLID SECTION, ELSET=B{body}, MATERIAL=M\n1.\n\
             *SURFACE, NAME=F{body}\n{}*NSET, NSET=END{body}\n{}",
            elements[body].trim_start(),
            faces[body],
            ends[body].trim_end()
        );
    }
    let _ = writeln!(
        deck,
        "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE INTERACTION, NAME=I\n{laws}\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nF1, F0\n*BOUNDARY\nEND0, 1, 2\n\
         *STEP, NLGEOM\n*STATIC\n0.25, 1.\n*BOUNDARY\nEND1, 1, 1, 0.05\nEND1, 2, 2, 0.02\n*END STEP"
    );
    deck
}

/// Requirement: where the list of the nodes of a ring begins says nothing of its forces. Curves that ended there missed
/// them by a hundredth, and a node at the seam found no equilibrium.
#[test]
fn rings_have_no_seam() {
    for laws in LAWS {
        let expected = solved(&rings(11, laws)).force();
        for begin in [0, 1, 2, 23] {
            let last = solved(&rings(begin, laws));
            let off: [f64; 3] = std::array::from_fn(|axis| last.force()[axis] - expected[axis]);
            assert!(size(off) < 1e-8 * size(expected), "{begin} {laws}: {off:?} {expected:?}");
            assert!(last.worst < 1e-10, "{}", last.worst);
        }
    }
}
