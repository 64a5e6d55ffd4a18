//! A `*DISTRIBUTING` coupling that turns far: it is exact, and told where it is not.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::path::Path;

/// What a node does: place, displacement with rotation, force with moment of supports and loads.
type Node = ([f64; 3], [f64; 6], [f64; 6]);

/// What is said, and all nodes at the end.
#[derive(Default)]
struct Watch {
    said: Vec<&'static str>,
    nodes: BTreeMap<u64, Node>,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Diagnosed(said) => self.said.push(said.code.0),
            Event::Committed(frame) => {
                for (node, own) in frame.model.nodes.iter().enumerate() {
                    let motion = Dof::ALL.map(|dof| frame.nodal.displacement(node, dof));
                    let force = |dof| frame.nodal.reaction(node, dof) + frame.nodal.load(node, dof);
                    self.nodes.insert(own.label, (own.position, motion, Dof::ALL.map(force)));
                }
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

impl Watch {
    /// The sums of forces and of moments, over the largest of either.
    fn unbalanced(&self) -> f64 {
        let (mut sums, mut largest) = ([[0.0; 3]; 2], [0.0_f64; 2]);
        for (place, motion, pull) in self.nodes.values() {
            let at: [f64; 3] = std::array::from_fn(|k| place[k] + motion[k]);
            let turned = |k: usize| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                at[i] * pull[j] - at[j] * pull[i] + pull[3 + k]
            };
            for k in 0..3 {
                sums[0][k] += pull[k];
                sums[1][k] += turned(k);
                largest[0] = largest[0].max(pull[k].abs());
                largest[1] = largest[1].max(turned(k).abs());
            }
        }
        let over = |which: usize| {
            sums[which].iter().fold(0.0_f64, |most, own| most.max(own.abs())) / largest[which]
        };
        over(0).max(over(1))
    }
}

fn run(deck: &str) -> Watch {
    let read = Job::read_text("deck", deck, &ReadOptions::default());
    let mut watch = Watch::default();
    let ending = solve(&read.model.unwrap(), &SolveOptions::default(), &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    watch
}

/// A bar along the first axis, in the plane or in space, that is coupled at its end.
struct Bar {
    in_space: bool,
    elements: usize,
    length: f64,
    depth: f64,
    stiffness: f64,
    reference: [f64; 3],
    coupling: &'static str,
    /// All nodes are coupled, and not those of the end alone.
    whole: bool,
    /// What turns the model, and what a length is measured in.
    turn: fn([f64; 3]) -> [f64; 3],
    unit: f64,
}

const BAR: Bar = Bar {
    in_space: false,
    elements: 4,
    length: 8.0,
    depth: 1.0,
    stiffness: 3000.0,
    reference: [9.0, 1.5, 0.5],
    coupling: "*DISTRIBUTING\n1, 6",
    whole: false,
    turn: |place| place,
    unit: 1.0,
};

impl Bar {
    /// The deck with the lines of its step.
    fn deck(&self, step: &str, lines: &str) -> String {
        let (row, layers) = (self.elements + 1, if self.in_space { 2 } else { 1 });
        let mut deck = String::from("*HEADING\nA bar that turns far\n*NODE, NSET=BAR\n");
        let mut add = |label: usize, place: [f64; 3]| {
            let [x, y, z] = (self.turn)(place.map(|part| self.unit * part));
            deck += &format!("{label}, {x:.16e}, {y:.16e}, {z:.16e}\n");
        };
        for k in 0..2 * layers * row {
            let (i, j, layer) = (k % row, k / row % 2, k / row / 2);
            let x = self.length * i as f64 / self.elements as f64;
            add(1 + k, [x, self.depth * j as f64, layer as f64]);
        }
        let flat = |[x, y, z]: [f64; 3]| [x, y, if self.in_space { z } else { 0.0 }];
        add(1000, flat(self.reference));
        let of = if self.in_space { "C3D8I" } else { "CPS4I" };
        deck += &format!("*ELEMENT, TYPE={of}, ELSET=BAR\n");
        for i in 1..=self.elements {
            let own = [i, i + 1, i + 1 + row, i + row];
            let all = (0..layers).flat_map(|layer| own.map(|node| node + 2 * row * layer));
            let all: Vec<String> = all.map(|node| node.to_string()).collect();
            deck += &format!("{i}, {}\n", all.join(", "));
        }
        let ends = |first: usize| {
            let nodes = (0..2 * layers).map(|k| format!("{},\n", first + k * row));
            nodes.collect::<String>()
        };
        let cloud = match self.whole {
            true => (1..=2 * layers * row).map(|node| format!("{node},\n")).collect(),
            false => ends(row),
        };
        let (stiffness, coupling) = (self.stiffness, self.coupling);
        deck + &format!(
            "*SOLID SECTION, ELSET=BAR, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n{stiffness:e}, 0.3\n*NSET, NSET=ROOT\n\
             {}*NSET, NSET=CLOUD\n{cloud}*SURFACE, NAME=S, TYPE=NODE\nCLOUD,\n*COUPLING, CONSTRAINT NAME=C, REF \
             NODE=1000, SURFACE=S\n{coupling}\n*STEP, INC=400{step}\n*STATIC\n0.1, 1.\n{lines}\n*END STEP\n",
            ends(1)
        )
    }

    fn run(&self, lines: &str) -> Watch {
        run(&self.deck(", NLGEOM", lines))
    }
}

/// Requirement: a body that a reference node turns by 2 radians, and in space by 9.5 about an axis askew, stays
/// without stress, whether all of its nodes are coupled or an end of it. Reactions 1e-9 of the stiffness; places 1e-9.
#[test]
fn what_is_turned_stays_without_stress() {
    for (in_space, whole) in [(false, false), (false, true), (true, false), (true, true)] {
        let axis = if in_space { [0.48, -0.6, 0.64] } else { [0.0, 0.0, 1.0] };
        let angle = if in_space { 9.5 } else { 2.0 };
        let bar = Bar { in_space, whole, ..BAR };
        let shifts = if in_space { 3 } else { 2 };
        let turns = (0..3).filter(|k| axis[*k] != 0.0);
        let turns = turns.map(|k| format!("1000, {0}, {0}, {1}\n", 4 + k, angle * axis[k]));
        let lines = format!("*BOUNDARY\n1000, 1, {shifts}\n{}", turns.collect::<String>());
        let watch = bar.run(lines.trim_end());
        let (centre, _, pull) = watch.nodes[&1000];
        assert!(pull.iter().all(|own| own.abs() < 1e-9 * bar.stiffness), "{pull:?}");
        let (sin, cos) = f64::sin_cos(angle);
        for (place, motion, _) in watch.nodes.values() {
            let arm: [f64; 3] = std::array::from_fn(|k| place[k] - centre[k]);
            let along: f64 = (0..3).map(|k| arm[k] * axis[k]).sum();
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let across = axis[i] * arm[j] - axis[j] * arm[i];
                let turned = cos * arm[k] + sin * across + (1.0 - cos) * along * axis[k];
                assert!((motion[k] - (turned - arm[k])).abs() < 1e-9, "{in_space} {whole}");
            }
        }
    }
}

/// Requirement: a strip under the moment 2 pi EI/L at its end becomes a circle: the reference node turns by 2 pi
/// and comes back to the root, 1 %, where a linear coupling sees the sine of its turn.
#[test]
fn a_strip_becomes_a_circle() {
    let bar = Bar { elements: 40, length: 40.0, reference: [40.0, 0.5, 0.0], ..BAR };
    let moment = 2.0 * PI * bar.stiffness / 12.0 / bar.length;
    let watch = bar.run(&format!("*BOUNDARY\nROOT, 1, 2\n*CLOAD\n1000, 6, {moment}"));
    let (_, motion, _) = watch.nodes[&1000];
    assert!((motion[5] / (2.0 * PI) - 1.0).abs() < 1e-2, "{motion:?}");
    assert!((motion[0] / bar.length + 1.0).abs() < 1e-2 && motion[1].abs() < 1e-2 * bar.length);
    assert!(watch.unbalanced() < 1e-6, "{}", watch.unbalanced());
    assert!(!watch.said.contains(&"SL0623"));
}

/// Requirement: whatever of the reference node is loaded and whatever is held, in the plane and in space, with
/// its rotations and without, forces and moments balance about the places where the nodes have come to; 1e-6.
#[test]
fn what_turns_far_balances() {
    let loads = "*CLOAD\n1000, 1, -2.\n1000, 2, 6.\n1000, 6, 40.";
    for held in ["", "\n1000, 6, 6, 1.2", "\n1000, 1, 1, -3.", "\n1000, 1, 2, 1.5"] {
        for in_space in [false, true] {
            let bar = Bar { in_space, ..BAR };
            let aside = if in_space { "\n1000, 3, 1.\n1000, 4, 9.\n1000, 5, -5." } else { "" };
            let root = if in_space { "ROOT, 1, 3" } else { "ROOT, 1, 2" };
            let watch = bar.run(&format!("*BOUNDARY\n{root}{held}\n{loads}{aside}"));
            let turn = watch.nodes[&1000].1[5].abs();
            assert!(turn > 0.25, "{held} {in_space}: {turn}");
            assert!(watch.unbalanced() < 1e-6, "{held} {in_space}: {}", watch.unbalanced());
        }
    }
    let aside = Bar { coupling: "*DISTRIBUTING\n1, 2", ..BAR };
    let watch = aside.run("*BOUNDARY\nROOT, 1, 2\n1000, 2, 2, 4.");
    assert!(watch.unbalanced() < 1e-6 && !watch.said.contains(&"SL0623"));
}

/// Requirement: a model that lies another way, or is written in another unit, does the same; 1e-7.
#[test]
fn no_axis_and_no_unit_matters() {
    let lines = |unit: f64, held: &str, pull: [f64; 2]| {
        let [x, y] = pull.map(|own| own * unit);
        let moment = 40.0 * unit * unit;
        format!(
            "*BOUNDARY\nROOT, 1, 2\n{held}*CLOAD\n1000, 1, {x}\n1000, 2, {y}\n1000, 6, {moment}"
        )
    };
    for held in ["", "1000, 6, 6, 1.2\n"] {
        let own = BAR.run(&lines(1.0, held, [-2.0, 6.0])).nodes[&1000].1;
        let small = Bar { unit: 1e-3, ..BAR };
        let small = small.run(&lines(1e-3, held, [-2.0, 6.0])).nodes[&1000].1;
        let standing = Bar { turn: |[x, y, z]| [-y, x, z], ..BAR };
        let standing = standing.run(&lines(1.0, held, [-6.0, -2.0])).nodes[&1000].1;
        let same = |a: f64, b: f64| (a - b).abs() < 1e-7 * own[1].abs();
        assert!(same(small[0] * 1e3, own[0]) && same(small[1] * 1e3, own[1]), "{small:?} {own:?}");
        assert!(same(standing[1], own[0]) && same(-standing[0], own[1]), "{standing:?} {own:?}");
        assert!(same(small[5], own[5]) && same(standing[5], own[5]));
    }
}

/// Requirement: small turns are those of the linear coupling, but for their square.
#[test]
fn small_turns_are_linear() {
    for held in ["", "\n1000, 6, 6, 1e-6"] {
        let lines = format!("*BOUNDARY\nROOT, 1, 2{held}\n*CLOAD\n1000, 2, 1e-6\n1000, 6, 1e-5");
        let [large, small] = [", NLGEOM", ""].map(|step| run(&BAR.deck(step, &lines)).nodes[&1000]);
        for k in [1, 5] {
            assert!((large.1[k] / small.1[k] - 1.0).abs() < 1e-5, "{large:?} {small:?}");
        }
    }
}

/// Requirement: one rotation of three is coupled as for small turns: that it has turned far is told, once, and
/// not where it has not.
#[test]
fn a_part_of_a_turn_is_told() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/run/SL0623-turned.inp");
    let deck = std::fs::read_to_string(path).unwrap();
    let told = |deck: &str| run(deck).said.iter().filter(|code| **code == "SL0623").count();
    assert_eq!(told(&deck), 1);
    assert_eq!(told(&deck.replace("200, 6, 160.", "200, 6, 40.")), 0);
    assert_eq!(told(&deck.replace("*DISTRIBUTING\n1, 3\n6, 6", "*DISTRIBUTING\n1, 6")), 0);
}
