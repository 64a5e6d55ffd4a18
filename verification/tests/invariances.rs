//! The same problem told in another way, over random problems.
//!
//! The problems are drawn by a generator with a fixed seed, so that a failure
//! comes again.

use slideline_verification::{
    Claim, Curve, Group, Method, Placement, Push, Record, Units, largest, largest_difference, run,
    run_on, worst,
};

pub const GROUP: Group = Group {
    file: "invariances",
    claims: &[
        Claim {
            name: "random_problems_in_other_words",
            requirement: "Units (m-N, mm-N, inch-lbf), place, mirror image and numbers of nodes \
                          change nothing but rounding, over twelve random problems.",
            source: "Mechanics has no units, no origin, no numbers of nodes.",
            tolerance: "1e-9 of the peak force: residuals are held at 1e-12, decimal coordinates \
                        and unit factors round at 1e-16, and an equilibrium multiplies that by its \
                        condition.",
            measure: random_problems_in_other_words,
        },
        Claim {
            name: "order_of_cards",
            requirement: "Model cards may stand in any order, over six random problems.",
            source: "The manual's rules on the order of keywords.",
            tolerance: "None: bits.",
            measure: order_of_cards,
        },
        Claim {
            name: "random_problems_on_two_threads",
            requirement: "Two threads give the bits of one, over two random problems of 2100 beams.",
            source: "Sums are taken in a fixed order.",
            tolerance: "None: bits.",
            measure: random_problems_on_two_threads,
        },
    ],
};

const TOLERANCE: f64 = 1e-9;

/// A linear congruential generator.
struct Draw(u64);

impl Draw {
    /// A number from 0 to 1.
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        let place = (self.number() * values.len() as f64) as usize;
        values[place.min(values.len() - 1)]
    }

    fn problem(&mut self) -> Push {
        let method = self.one_of(&[Method::Irs, Method::Isl, Method::Surface]);
        Push {
            elements: self.one_of(&[12, 24, 40]),
            increments: self.one_of(&[20, 30]),
            mu: self.one_of(&[0.0, 0.1, 0.3, 0.45]),
            onset: self.one_of(&["IMMEDIATE", "DELAYED", "MATFRU"]),
            smooth: self.one_of(&[0.1, 0.25, 0.4]),
            tolerance: Some(1e-12),
            ..Push::paper(method)
        }
    }
}

fn forces(curve: &Curve) -> [Vec<f64>; 2] {
    [1, 2].map(|dof| curve.reaction(Push::CIRCLE, dof))
}

/// Largest difference of the forces of `other` from `expected` [of `peak`].
fn off(other: &Push, expected: &[Vec<f64>; 2], peak: f64) -> f64 {
    let found = forces(&run(&other.deck()).unwrap());
    worst(found.iter().zip(expected).map(|(found, expected)| {
        let found: Vec<f64> = found.iter().map(|force| force / other.units.force).collect();
        largest_difference(&found, expected) / peak
    }))
}

fn random_problems_in_other_words(record: &mut Record) {
    let mut draw = Draw(2);
    let inch_pound = Units { length: 1.0 / 0.0254, force: 1.0 / 4.448_221_615_260_5 };
    let millimetre = Units { length: 1e3, force: 1.0 };
    let mut found = [const { Vec::new() }; 4];
    for _ in 0..12 {
        let push = draw.problem();
        let same = forces(&run(&push.deck()).unwrap());
        let [fx, fy] = &same;
        let peak = largest(fx, fy);
        let placement = Placement {
            angle: 6.0 * draw.number() - 3.0,
            shift: [0.2 * draw.number() - 0.1, 0.2 * draw.number() - 0.1],
            mirror: draw.number() < 0.5,
        };
        let turned: Vec<[f64; 2]> =
            fx.iter().zip(fy).map(|(&x, &y)| placement.vector([x, y])).collect();
        let turned = [0, 1].map(|k| turned.iter().map(|v| v[k]).collect());
        found[0].push(off(&Push { units: millimetre, ..push }, &same, peak));
        found[1].push(off(&Push { units: inch_pound, ..push }, &same, peak));
        found[2].push(off(&Push { renumbered: true, ..push }, &same, peak));
        found[3].push(off(&Push { placement, ..push }, &turned, peak));
    }
    let names = ["mm-N", "inch-lbf", "other numbers", "elsewhere, turned, mirrored"];
    for (name, off) in names.iter().zip(found) {
        record.at_most(format!("{name}, largest difference (of peak)"), worst(off), TOLERANCE);
    }
}

/// Cards of the model part, cut before each keyword that may begin anywhere.
fn blocks(deck: &str) -> (String, Vec<String>, String) {
    let step = deck.find("*STEP").unwrap();
    let first = deck.find("*NODE").unwrap();
    let begins = [
        "*NODE",
        "*ELEMENT, TYPE=B21",
        "*BEAM SECTION",
        "*MATERIAL",
        "*MPC",
        "*RIGID SURFACE",
        "*ELEMENT, TYPE=I",
        "*SLIDE LINE",
        "*INTERFACE",
        "*SURFACE, ",
        "*SURFACE INTERACTION",
        "*RIGID BODY",
        "*CONTACT PAIR",
        "*CONTACT CONTROLS",
    ];
    let mut blocks: Vec<String> = Vec::new();
    for line in deck[first..step].lines() {
        if begins.iter().any(|begin| line.starts_with(begin)) {
            blocks.push(String::new());
        }
        let block = blocks.last_mut().unwrap();
        block.push_str(line);
        block.push('\n');
    }
    (deck[..first].to_owned(), blocks, deck[step..].to_owned())
}

fn bits(curve: &Curve) -> Vec<u64> {
    let rows = curve.rows.iter();
    rows.flat_map(|row| row.displacement.iter().chain(&row.reaction).flatten())
        .map(|value| value.to_bits())
        .collect()
}

fn order_of_cards(record: &mut Record) {
    let mut draw = Draw(5);
    let mut same = 0;
    for _ in 0..6 {
        let deck = draw.problem().deck();
        let expected = bits(&run(&deck).unwrap());
        let (head, mut blocks, step) = blocks(&deck);
        for place in (1..blocks.len()).rev() {
            let other = (draw.number() * (place + 1) as f64) as usize;
            blocks.swap(place, other.min(place));
        }
        let shuffled = format!("{head}{}{step}", blocks.concat());
        assert_ne!(shuffled, deck);
        same += usize::from(bits(&run(&shuffled).unwrap()) == expected);
    }
    record.equal("problems with the same bits", same, 6);
}

fn random_problems_on_two_threads(record: &mut Record) {
    let mut draw = Draw(9);
    let mut same = 0;
    for _ in 0..2 {
        let push = Push { elements: 2100, increments: 4, ..draw.problem() };
        let deck = Push { tolerance: None, ..push }.deck();
        same += usize::from(bits(&run_on(&deck, 1).unwrap()) == bits(&run_on(&deck, 2).unwrap()));
    }
    record.equal("problems with the same bits", same, 2);
}
