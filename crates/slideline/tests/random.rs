//! Random small models: beams pushed and dragged by rigid circles and lines,
//! all laws, with and without friction; and random bytes as decks.
//!
//! Requirement: of models well posed by construction at least 98 % converge
//! and balance; the rest end in a named diagnosis, none hangs, panics or gives
//! NaN. The numbers come from a fixed sequence, so a failure can be repeated:
//! `SLIDELINE_RANDOM=count` runs more, and the decks of failures are printed.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::time::Instant;

/// Seconds that the test may take.
const SECONDS: f64 = 20.0;
/// Iterations after which a run counts as hanging.
const HANGS: usize = 20_000;

/// A fixed sequence of numbers (Knuth's multiplier).
struct Sequence(u64);

impl Sequence {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn one_of(&mut self, count: usize) -> usize {
        ((self.next() * count as f64) as usize).min(count - 1)
    }
}

/// A cantilever along x and a rigid circle above it, which is pressed into it
/// and dragged along; the circle has the master surface, or carries slaves.
fn deck(s: &mut Sequence) -> String {
    let elements = 4 + s.one_of(20);
    let length = s.between(0.03, 0.2);
    let height = length * s.between(0.01, 0.05);
    let radius = length * s.between(0.05, 0.4);
    let modulus = 10f64.powf(s.between(8.5, 11.5));
    let at = length * s.between(0.4, 0.75);
    let gap = length * s.between(-1e-4, 5e-3);
    let isl = s.one_of(2) == 1;
    let mut text = format!(
        "*HEADING\nrandom\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n{last}, {length:.9e}, 0.0\n*NGEN, NSET=BEAM\n\
         1, {last}\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, {elements}\n\
         *BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n0.01, {height:.9e}\n*MATERIAL, NAME=M\n\
         *ELASTIC\n{modulus:.9e}, 0.3\n",
        last = elements + 1
    );
    let y = radius + gap;
    if isl {
        circle_of_slaves(&mut text, s, [at, y], radius, elements);
    } else {
        let _ = write!(
            text,
            "*NODE\n9999, {at:.9e}, {y:.9e}\n*RIGID SURFACE, TYPE=SEGMENTS, ELSET=C\nSTART, {:.9e}, {y:.9e}\n\
             CIRCL, {at:.9e}, {:.9e}, {at:.9e}, {y:.9e}\nCIRCL, {:.9e}, {y:.9e}, {at:.9e}, {y:.9e}\n\
             *ELEMENT, TYPE=IRS21, ELSET=C\n1001, 2, 3, 9999\n*ELGEN, ELSET=C\n1001, {}\n",
            at + radius,
            y - radius,
            at - radius,
            elements - 1
        );
    }
    laws(&mut text, s, isl, length, modulus, height);
    step(&mut text, s, length, gap, isl);
    text
}

/// Thirteen slaves over the lower part of the circle, tied to its centre.
fn circle_of_slaves(
    text: &mut String,
    s: &mut Sequence,
    centre: [f64; 2],
    radius: f64,
    elements: usize,
) {
    let half = s.between(20.0, 60.0);
    let _ = write!(text, "*NODE\n9999, {:.9e}, {:.9e}\n*NODE, NSET=RIM\n", centre[0], centre[1]);
    for k in 0..13 {
        let angle = (half * (k as f64 / 6.0 - 1.0)).to_radians();
        let (x, y) = (centre[0] + radius * angle.sin(), centre[1] - radius * angle.cos());
        let _ = writeln!(text, "{}, {x:.9e}, {y:.9e}", 9000 + k);
    }
    let smooth = s.between(0.0, 0.45);
    let _ = write!(
        text,
        "*MPC\nBEAM, RIM, 9999\n*ELEMENT, TYPE=ISL21, ELSET=C\n1001, 9000, 9001\n*ELGEN, ELSET=C\n\
         1001, 12\n*SLIDE LINE, TYPE=LINEAR, ELSET=C, SMOOTH={smooth:.6}, GENERATE\n1, {}, 1\n",
        elements + 1
    );
}

fn laws(text: &mut String, s: &mut Sequence, isl: bool, length: f64, modulus: f64, height: f64) {
    text.push_str("*INTERFACE, ELSET=C\n0.01\n");
    let mu = s.between(0.0, 0.6);
    let _ = match s.one_of(4) {
        0 => writeln!(text, "*FRICTION\n0.0"),
        1 => writeln!(text, "*FRICTION, LAGRANGE\n{mu:.6}"),
        _ => writeln!(text, "*FRICTION\n{mu:.6}"),
    };
    // rigid links and hard contact exclude each other: Diehl (1995), 2.0
    if isl || s.one_of(2) == 0 {
        let pressure = modulus * (height / length).powi(3) * 10f64.powf(s.between(0.0, 2.0));
        let clearance = length * 10f64.powf(s.between(-4.5, -3.0));
        let _ = write!(text, "*SURFACE CONTACT, SOFTENED\n{clearance:.6e}, {pressure:.6e}\n");
    }
}

fn step(text: &mut String, s: &mut Sequence, length: f64, gap: f64, isl: bool) {
    let press = gap.max(0.0) + length * s.between(0.005, 0.08);
    let drag = length * s.between(-0.2, if isl { 0.1 } else { 0.15 });
    let increment = [0.05, 0.1, 0.2][s.one_of(3)];
    let steps = [("PRESS", 0.0), ("DRAG", drag)];
    for (name, along) in steps {
        let _ = write!(
            text,
            "*STEP, NLGEOM, INC=500\n{name}\n*STATIC\n{increment}, 1.0, 1.0E-6\n*BOUNDARY\n1, 1, 6\n\
             9999, 6\n9999, 1, 1, {along:.9e}\n9999, 2, 2, {:.9e}\n*END STEP\n",
            -press
        );
    }
}

/// Balance of the supports and whether any number is none.
#[derive(Default)]
struct Judge {
    iterations: usize,
    /// Sum of all reactions and sum of their magnitudes, per increment [F].
    states: Vec<(f64, f64)>,
    nan: bool,
}

impl Judge {
    /// Largest sum of reactions, relative to their size; forces a thousand
    /// times below the peak (contact has just been lost) are held against it.
    fn unbalanced(&self) -> f64 {
        let peak = self.states.iter().map(|state| state.1).fold(0.0, f64::max);
        let ratio = |&(sum, size): &(f64, f64)| sum / (size + 1e-3 * peak).max(f64::MIN_POSITIVE);
        self.states.iter().map(ratio).fold(0.0, f64::max)
    }
}

impl Observer for Judge {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(_) => {
                self.iterations += 1;
                if self.iterations > HANGS {
                    return ControlFlow::Break(Stop::Interrupted);
                }
            }
            Event::Committed(frame) => {
                let all = |dof| {
                    let values = (0..frame.model.nodes.len()).map(|i| frame.nodal.reaction(i, dof));
                    values.fold((0.0, 0.0), |(sum, size), v: f64| (sum + v, size + v.abs()))
                };
                let ((x, size_x), (y, size_y)) = (all(Dof::U1), all(Dof::U2));
                let size = size_x + size_y;
                self.nan |= !size.is_finite();
                self.states.push((x.hypot(y), size));
                self.nan |= frame.contact.iter().any(|row| row.pressure.is_nan());
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

#[test]
fn random_models_converge_and_balance_or_say_why() {
    let asked = std::env::var("SLIDELINE_RANDOM").ok().and_then(|count| count.parse().ok());
    let count: usize = asked.unwrap_or(500);
    let began = Instant::now();
    let (mut ran, mut converged) = (0, 0);
    let mut failures: Vec<String> = Vec::new();
    for number in 0..count {
        if asked.is_none() && began.elapsed().as_secs_f64() > SECONDS {
            break;
        }
        let text = deck(&mut Sequence(number as u64 * 7919 + 17));
        let read = Job::read_text("random", &text, &ReadOptions::default());
        let Some(model) = &read.model else {
            panic!("model {number} does not read: {:?}\n{text}", read.diagnostics)
        };
        let mut judge = Judge::default();
        ran += 1;
        let ending = solve(model, &SolveOptions::default(), &mut judge);
        assert!(!judge.nan, "model {number} gives NaN\n{text}");
        match ending {
            Ending::Completed(_) if judge.unbalanced() < 1e-4 => converged += 1,
            Ending::Completed(_) => {
                failures.push(format!("model {number}: unbalanced by {:e}", judge.unbalanced()));
            }
            Ending::NotConverged(_, why) => {
                assert!(!why.message.is_empty() && why.code.0 < "SL09", "{number}: {why:?}");
                failures.push(format!("model {number}: {} {}", why.code, why.message));
            }
            Ending::Stopped(..) => panic!("model {number} hangs\n{text}"),
        }
    }
    println!("{ran} models, {converged} converged and balanced; {}", failures.join("\n"));
    if let Ok(folder) = std::env::var("SLIDELINE_RANDOM_DECKS") {
        for failure in &failures {
            let number: u64 = failure[6..failure.find(':').unwrap()].parse().unwrap();
            let text = deck(&mut Sequence(number * 7919 + 17));
            std::fs::write(format!("{folder}/random_{number}.inp"), text).unwrap();
        }
    }
    assert!(converged * 100 >= ran * 98, "{converged} of {ran}:\n{}", failures.join("\n"));
}

/// Cards cut, joined and shuffled: reading ends, and never in a panic.
#[test]
fn mangled_decks_are_read_to_their_end() {
    let mut s = Sequence(3);
    let began = Instant::now();
    let mut read = 0;
    while read < 2000 && began.elapsed().as_secs_f64() < 5.0 {
        let mut bytes = deck(&mut s).into_bytes();
        for _ in 0..=s.one_of(6) {
            let (a, b) = (s.one_of(bytes.len()), s.one_of(bytes.len()));
            match s.one_of(4) {
                0 => bytes[a] = s.one_of(256) as u8,
                1 => bytes.swap(a, b),
                2 => drop(bytes.drain(a.min(b)..(a.min(b) + s.one_of(40)).min(bytes.len()))),
                _ => {
                    let piece = bytes[a.min(b)..(a.min(b) + 30).min(bytes.len())].to_vec();
                    bytes.splice(a..a, piece);
                }
            }
        }
        let text = String::from_utf8_lossy(&bytes);
        let deck = Job::read_text("mangled", &text, &ReadOptions::default());
        assert!(deck.model.is_some() || !deck.diagnostics.is_empty());
        let _ = slideline::advise(&deck); // must not panic either
        read += 1;
    }
    println!("{read} mangled decks");
}
