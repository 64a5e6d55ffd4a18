//! Decks of parts against the same decks written flat: random families.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands
#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Model, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// Random numbers, the same in every run (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A bent arm: its nodes with their numbers, and the type of its elements.
struct Part {
    nodes: Vec<(u64, [f64; 2])>,
    kind: &'static str,
    height: f64,
}

impl Part {
    fn random(random: &mut Random) -> Self {
        let kind = ["B21", "B22", "B23"][random.below(3) as usize];
        let count = 2 + 2 * random.below(3);
        let (first, step) = (1 + random.below(7), 1 + random.below(3));
        let direction = random.between(-0.4, 0.4);
        let node = |k: u64| {
            let along = 10.0 * k as f64 / count as f64;
            (first + k * step, [along, direction * along + 0.01 * along * along])
        };
        let nodes = (0..=count).map(node).collect();
        Self { nodes, kind, height: random.between(0.5, 1.0) }
    }

    /// Cards in the numbers of the part plus `offset`, names behind `prefix`.
    fn cards(&self, offset: u64, prefix: &str, place: impl Fn([f64; 2]) -> [f64; 2]) -> String {
        let mut text = format!("*NODE, NSET={prefix}ALL\n");
        for (label, at) in &self.nodes {
            let [x, y] = place(*at);
            let _ = writeln!(text, "{}, {x:?}, {y:?}", label + offset);
        }
        let (root, tip) = (self.nodes[0].0 + offset, self.nodes.last().unwrap().0 + offset);
        let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET={prefix}ARM", self.kind);
        let reach = if self.kind == "B22" { 2 } else { 1 };
        for (k, piece) in self.nodes.windows(reach + 1).step_by(reach).enumerate() {
            let nodes: Vec<String> = piece.iter().map(|n| (n.0 + offset).to_string()).collect();
            let _ = writeln!(text, "{}, {}", k as u64 + 1 + offset, nodes.join(", "));
        }
        let _ = write!(
            text,
            "*BEAM SECTION, SECTION=RECT, ELSET={prefix}ARM, MATERIAL=M\n2.0, {:?}\n\
             *NSET, NSET={prefix}ROOT\n{root}\n*NSET, NSET={prefix}TIP, GENERATE\n{tip}, {tip}\n\
             *ELEMENT, TYPE=SPRING1, ELSET={prefix}SPRING\n{}, {tip}\n\
             *SPRING, ELSET={prefix}SPRING\n1\n3.0\n",
            self.height,
            500 + offset,
        );
        text
    }
}

/// A deck of parts, the same flat, and the numbers of the same nodes in both models.
struct Twins {
    parts: String,
    flat: String,
    numbers: Vec<[u64; 2]>,
}

const STRIDE: u64 = 1000;

fn twins(random: &mut Random) -> Twins {
    let parts: Vec<Part> = (0..=random.below(3)).map(|_| Part::random(random)).collect();
    let mut twins =
        Twins { parts: "*HEADING\n".into(), flat: "*HEADING\n".into(), numbers: vec![] };
    for (k, part) in parts.iter().enumerate() {
        let _ = write!(twins.parts, "*PART, NAME=P{k}\n{}*END PART\n", part.cards(0, "", |x| x));
    }
    twins.parts += "*ASSEMBLY, NAME=A\n";
    let count = 2 + random.below(3);
    for instance in 1..=count {
        let place = random.below(parts.len() as u64) as usize;
        let part = &parts[place];
        let shift = [random.between(-50.0, 50.0), random.between(-50.0, 50.0)];
        let centre = [random.between(-50.0, 50.0), random.between(-50.0, 50.0)];
        let angle = if random.below(4) == 0 { 90.0 } else { random.between(-180.0, 180.0) };
        let turns = random.below(3) > 0;
        let _ = write!(
            twins.parts,
            "*INSTANCE, NAME=I-{instance}, PART=P{place}\n{:?}, {:?}\n",
            shift[0], shift[1]
        );
        if turns {
            let [x, y] = centre;
            let _ = writeln!(twins.parts, "{x:?}, {y:?}, 0., {x:?}, {y:?}, 2., {angle:?}");
        }
        twins.parts += "*END INSTANCE\n";
        let (sin, cos) = angle.to_radians().sin_cos();
        let moved = |[x, y]: [f64; 2]| {
            let [x, y] = [x + shift[0], y + shift[1]];
            let [a, b] = [x - centre[0], y - centre[1]];
            let turned = [centre[0] + cos * a - sin * b, centre[1] + sin * a + cos * b];
            if turns { turned } else { [x, y] }
        };
        let offset = instance * 777;
        twins.flat += &part.cards(offset, &format!("I-{instance}."), moved);
        let pairs = part.nodes.iter().map(|(own, _)| [own + instance * STRIDE, own + offset]);
        twins.numbers.extend(pairs);
    }
    // a node of the assembly, linked rigidly to the tip of the first instance
    let end = "*NODE\n1, 1.0, 2.0\n*MPC\nBEAM, 1, I-1.TIP\n";
    twins.parts += &format!("{end}*NSET, NSET=ROOTS, INSTANCE=I-1\nROOT\n");
    (2..=count).for_each(|k| {
        let _ = writeln!(twins.parts, "*NSET, NSET=ROOTS\nI-{k}.ROOT");
    });
    twins.parts += "*END ASSEMBLY\n";
    twins.flat += end;
    (1..=count).for_each(|k| {
        let _ = writeln!(twins.flat, "*NSET, NSET=ROOTS\nI-{k}.ROOT");
    });
    let mut history = "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*STEP, NLGEOM\n*STATIC\n0.5, 1.\n\
                       *BOUNDARY\nROOTS, ENCASTRE\n*CLOAD\n1, 2, 0.3\n"
        .to_owned();
    for k in 1..=count {
        let (direction, force) = (1 + random.below(2), random.between(-0.5, 0.5));
        let _ = writeln!(history, "I-{k}.TIP, {direction}, {force:?}");
    }
    history += "*END STEP\n";
    twins.parts += &history;
    twins.flat += &history;
    twins
}

/// Displacements and reactions of all nodes at the end.
#[derive(Default)]
struct End(Vec<[f64; 6]>);

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let of_node = |node| {
                let [a, b, c] = Dof::PLANE.map(|dof| frame.nodal.displacement(node, dof));
                let [d, e, f] = Dof::PLANE.map(|dof| frame.nodal.reaction(node, dof));
                [a, b, c, d, e, f]
            };
            self.0 = (0..frame.model.nodes.len()).map(of_node).collect();
        }
        ControlFlow::Continue(())
    }
}

fn run(deck: &str) -> (Model, Vec<[f64; 6]>) {
    let read = Job::read_text("parts", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-11;
    }
    let mut end = End::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    (model, end.0)
}

/// Requirement: parts, instances, rotations, sets by instance and links of the assembly give the
/// model that the flat deck gives: the same displacements and reactions at every node, to 1e-9
/// of the largest (rounded positions differ in the last digit). Forty families.
#[test]
fn parts_give_what_the_flat_deck_gives() {
    let mut random = Random(12);
    for _ in 0..40 {
        let Twins { parts, flat, numbers } = twins(&mut random);
        let ((left, of_parts), (right, of_flat)) = (run(&parts), run(&flat));
        assert_eq!(left.nodes.len(), right.nodes.len());
        let mut scale = [0.0_f64; 2];
        for (k, value) in of_flat.iter().flat_map(|all| all.iter().enumerate()) {
            scale[k / 3] = scale[k / 3].max(value.abs());
        }
        for [own, other] in numbers {
            let (own, other) = (left.nodes.find(own).unwrap(), right.nodes.find(other).unwrap());
            for (k, (a, b)) in of_parts[own].iter().zip(of_flat[other]).enumerate() {
                assert!((a - b).abs() <= 1e-9 * scale[k / 3], "{a} {b}\n{parts}\n{flat}");
            }
        }
    }
}

/// Requirement: where no two scopes use a number it stays that of the deck; where they do, nodes
/// and elements are found behind a round number, and messages name the instance.
#[test]
fn numbers_can_be_found_again() {
    let part = "*PART, NAME=P\n*NODE\n1, 0.\n25, 1.\n*ELEMENT, TYPE=B21, ELSET=E\n7, 1, 25\n\
                *BEAM SECTION, SECTION=RECT, ELSET=E, MATERIAL=M\n1., .1\n*END PART\n*ASSEMBLY\n";
    let history = "*END ASSEMBLY\n*MATERIAL, NAME=M\n*ELASTIC\n1.,0.\n*STEP, NLGEOM\n*STATIC\n\
                   *BOUNDARY\nA.1, 1, 6\n*END STEP\n";
    let once = format!("{part}*INSTANCE, NAME=A, PART=P\n*END INSTANCE\n{history}");
    let (model, _) = run(&once);
    assert!(model.nodes.find(25).is_some());
    let boundary = history.replace("A.1, 1, 6\n", "A.1, 1, 6\nB.1, 1, 6\n");
    let twice = format!(
        "{part}*INSTANCE, NAME=A, PART=P\n*END INSTANCE\n*INSTANCE, NAME=B, PART=P\n\
         *END INSTANCE\n{boundary}"
    );
    let (model, _) = run(&twice);
    let node = model.nodes.find(225).unwrap();
    assert_eq!(model.nodes.name(node).to_string(), "B.25");
    let labels: Vec<u64> = model.blocks.iter().flat_map(|b| &b.elements).map(|e| e.label).collect();
    assert_eq!(labels, [107, 207]);
    let missing = twice.replace("B.1, 1, 6", "B.3, 1, 6");
    let read = Job::read_text("parts", &missing, &ReadOptions::default());
    let said = read.diagnostics.iter().find(|said| said.code.0 == "SL0304").unwrap();
    assert_eq!(said.message, "node B.3 is not defined");
}
