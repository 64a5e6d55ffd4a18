//! Contact of a surface with itself: a tube pinched onto itself against its upper half on a rigid
//! plane, in plane strain and as a ring.
//!
//! ```text
//!      \_/  tool            \_/
//!    .-----.              .-----.
//!   (       )     =      (       )
//!    '-----'             ---------  plane of symmetry
//!      / \
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{Ending, Frame};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// What a run left: time and force on the tool of every increment, balance of the hollow's pair.
#[derive(Default)]
struct Course {
    forces: Vec<[f64; 2]>,
    /// Force and moment that the pair leaves, over the force of the tool.
    imbalance: f64,
    closed: usize,
    deepest: f64,
    iterations: usize,
    cutbacks: usize,
}

impl Observer for Course {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => self.take(frame),
            Event::AttemptFailed(_) => self.cutbacks += 1,
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

impl Course {
    fn take(&mut self, frame: &Frame<'_>) {
        let tool = frame.model.nodes.find(90001).unwrap();
        let force = frame.nodal.reaction(tool, slideline::model::Dof::U2);
        self.forces.push([frame.total_time, force]);
        let (place, hollow) = (frame.pairs.len() - 1, &frame.pairs[frame.pairs.len() - 1]);
        let own = hollow.force_imbalance.max(hollow.moment_imbalance);
        self.imbalance = self.imbalance.max(own / force.abs().max(1e-9));
        let mut points: Vec<_> = frame.contact.iter().filter(|row| row.pair == place).collect();
        points.retain(|row| row.pressure > 0.0);
        self.closed = points.len();
        self.deepest = points.iter().map(|row| -row.opening).fold(0.0, f64::max);
        self.iterations += frame.severe_iterations + frame.equilibrium_iterations;
    }
}

const INNER: f64 = 8.5;
const OUTER: f64 = 10.0;
const TOOL: f64 = 5.0;

/// A tube of `upper` and `lower` elements in its halves and `layers` in its wall about a centre on
/// axis 1; without a lower half it stands on the plane of symmetry.
struct Tube {
    upper: usize,
    lower: Option<usize>,
    layers: usize,
    /// Distance of its centre from axis 2 [L]; none: plane strain.
    ring: Option<f64>,
    friction: f64,
    /// First face of the hollow.
    seam: usize,
}

impl Tube {
    fn deck(&self) -> String {
        let mut deck = String::from("*HEADING\na tube pinched onto itself\n*NODE\n");
        self.mesh(&mut deck);
        let centre = self.ring.unwrap_or(0.0);
        let kind = if self.ring.is_some() { "CAX4" } else { "CPE4" };
        let thickness = if self.ring.is_some() { "" } else { "1.0" };
        deck = deck.replace("KIND", kind);
        let _ = write!(
            deck,
            "*MATERIAL, NAME=RUBBER
*HYPERELASTIC, NEO HOOKE
0.5, 0.02
*SOLID SECTION, ELSET=TUBE, MATERIAL=RUBBER
{thickness}
*SURFACE, NAME=HOLLOW
IN, S4
*SURFACE, NAME=SKIN
OUT, S2
*SURFACE INTERACTION, NAME=I
{thickness}
*FRICTION
{:?}
*SURFACE INTERACTION, NAME=O
{thickness}
",
            self.friction
        );
        tool(&mut deck, ("UPPER", 90001), (centre, OUTER, 1.0));
        match self.lower {
            Some(_) => tool(&mut deck, ("LOWER", 90002), (centre, -OUTER, -1.0)),
            None => {
                let _ = write!(
                    deck,
                    "*SURFACE, TYPE=SEGMENTS, NAME=PLANE
START, {:?}, 0.0
LINE, {:?}, 0.0
*RIGID BODY, ANALYTICAL SURFACE=PLANE, REF NODE=90002
",
                    centre - 15.0,
                    centre + 15.0
                );
            }
        }
        deck.push_str("*CONTACT PAIR, INTERACTION=O\nSKIN, UPPER\n");
        deck.push_str(match self.lower {
            Some(_) => "SKIN, LOWER\n*CONTACT PAIR, INTERACTION=I\nHOLLOW\n",
            None => "*CONTACT PAIR, INTERACTION=I\nHOLLOW, PLANE\n",
        });
        self.motion(&mut deck);
        deck
    }

    fn columns(&self) -> usize {
        self.upper + self.lower.unwrap_or(1)
    }

    fn node(&self, column: usize, layer: usize) -> usize {
        1 + 1000 * layer + column % self.columns()
    }

    fn mesh(&self, deck: &mut String) {
        let centre = self.ring.unwrap_or(0.0);
        for layer in 0..=self.layers {
            let radius = INNER + (OUTER - INNER) * layer as f64 / self.layers as f64;
            for column in 0..self.columns() {
                let angle = match column.checked_sub(self.upper) {
                    None => PI * column as f64 / self.upper as f64,
                    Some(k) => PI * (1.0 + k as f64 / self.lower.unwrap_or(1) as f64),
                };
                let (sin, cos) = if column == self.upper { (0.0, -1.0) } else { angle.sin_cos() };
                let (x, y) = (centre + radius * cos, radius * sin);
                let _ = writeln!(deck, "{}, {x:?}, {y:?}", self.node(column, layer));
            }
        }
        let faces = if self.lower.is_some() { self.columns() } else { self.upper };
        deck.push_str("*ELEMENT, TYPE=KIND, ELSET=TUBE\n");
        for layer in 0..self.layers {
            for column in 0..faces {
                let corners = [(0, 0), (0, 1), (1, 1), (1, 0)]
                    .map(|(i, j)| self.node(column + i, layer + j).to_string());
                let _ = writeln!(deck, "{}, {}", 1 + 1000 * layer + column, corners.join(", "));
            }
        }
        // what stands on the plane of symmetry is held by it
        let held = usize::from(self.lower.is_none());
        deck.push_str("*ELSET, ELSET=IN\n");
        for k in held..faces - held {
            let _ = writeln!(deck, "{}", 1 + (k + self.seam) % faces);
        }
        let last = 1 + 1000 * (self.layers - 1);
        let _ = writeln!(deck, "*ELSET, ELSET=OUT, GENERATE\n{last}, {}", last + faces - 1);
        let _ =
            writeln!(deck, "*NODE\n90001, {centre:?}, {OUTER:?}\n90002, {centre:?}, -{OUTER:?}");
    }

    fn motion(&self, deck: &mut String) {
        deck.push_str("*BOUNDARY\n90001, 1, 1\n90001, 6, 6\n90002, 1, 6\n");
        for layer in 0..=self.layers {
            if self.ring.is_none() {
                let _ = writeln!(deck, "{}, 1, 1", self.node(self.upper / 2, layer));
            }
            match self.lower {
                Some(lower) if self.ring.is_none() => {
                    let bottom = self.node(self.upper + lower / 2, layer);
                    let _ = writeln!(deck, "{bottom}, 1, 1");
                }
                Some(_) => {}
                None => {
                    let [a, b] = [0, self.upper].map(|column| self.node(column, layer));
                    let _ = writeln!(deck, "{a}, 2, 2\n{b}, 2, 2");
                }
            }
        }
        let travel = (2.0 * OUTER - 2.8) / if self.lower.is_some() { 1.0 } else { 2.0 };
        let _ = write!(
            deck,
            "*STEP, NLGEOM, INC=200\n*STATIC\n0.02, 1.0, 1.0E-6, 0.02
*BOUNDARY\n90001, 2, 2, {:?}\n*END STEP\n",
            -travel
        );
    }

    fn run(&self) -> Course {
        let read = Job::read_text("tube", &self.deck(), &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let mut course = Course::default();
        let ending = slideline::solve(&model, &SolveOptions::default(), &mut course);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
        course
    }
}

/// A rigid tool, round towards the tube, whose outermost point stands at a place.
fn tool(deck: &mut String, (name, node): (&str, u64), (x, y, side): (f64, f64, f64)) {
    let centre = y + side * TOOL;
    let at = |turn: f64| [x + side * TOOL * turn.sin(), centre - side * TOOL * turn.cos()];
    let [[a, b], [c, d], [e, f]] = [1.4, 0.0, -1.4].map(at);
    let _ = write!(
        deck,
        "*SURFACE, TYPE=SEGMENTS, NAME={name}
START, {a:?}, {b:?}
CIRCL, {c:?}, {d:?}, {x:?}, {centre:?}
CIRCL, {e:?}, {f:?}, {x:?}, {centre:?}
*RIGID BODY, ANALYTICAL SURFACE={name}, REF NODE={node}
"
    );
}

/// Largest difference of two courses at the times of both over the largest force.
fn apart(one: &Course, other: &Course) -> f64 {
    let peak = other.forces.iter().fold(0.0_f64, |most, [_, force]| most.max(force.abs()));
    let differences = one.forces.iter().filter_map(|[time, force]| {
        let same = other.forces.iter().find(|[own, _]| (own - time).abs() < 1e-9)?;
        Some((force - same[1]).abs())
    });
    let all: Vec<f64> = differences.collect();
    assert!(all.len() > 45, "{} increments", all.len());
    all.into_iter().fold(0.0, f64::max) / peak
}

/// Requirement: a tube pinched between two round tools until its hollow meets itself carries what
/// its upper half carries on a rigid plane, with meshes that do not match: within 3 % with 40
/// elements in a half, and with 80 within 1 %. Forces and moments cancel, nothing sinks in, no
/// increment is cut, at most 4 iterations an increment in the mean. Friction on the line of symmetry
/// does nothing.
#[test]
fn a_pinched_tube_is_its_half_on_a_plane() {
    let tube = Tube { upper: 40, lower: Some(44), layers: 3, ring: None, friction: 0.0, seam: 33 };
    let half = Tube { lower: None, seam: 0, ..tube };
    let mut errors = Vec::new();
    for factor in [1, 2] {
        let fine = |tube: &Tube| Tube {
            upper: factor * tube.upper,
            lower: tube.lower.map(|lower| factor * lower),
            layers: factor * tube.layers,
            seam: tube.seam.min(25),
            ..*tube
        };
        let (whole, half) = (fine(&tube).run(), fine(&half).run());
        errors.push(apart(&whole, &half));
        assert!(whole.closed >= 3 && whole.imbalance < 1e-9 && whole.deepest < 1e-9 * OUTER);
        assert!(whole.cutbacks == 0 && whole.iterations <= 4 * (whole.forces.len() - 1));
    }
    assert!(errors[0] < 0.03 && errors[1] < 0.01 && errors[1] < errors[0], "{errors:?}");
    let rough = Tube { friction: 0.3, ..tube }.run();
    let smooth = tube.run();
    assert!(apart(&rough, &smooth) < 0.03, "{}", apart(&rough, &smooth));
}

/// Requirement: the same of a hollow ring: its areas go all round the axis, whatever the face
/// that the surface begins with. Tolerance: that of the coarse tube and what the axis adds (measured
/// 3.3 to 4.2 %, one increment cut: where it is cut rounding decides).
#[test]
fn a_pinched_ring_is_its_half_on_a_plane() {
    let ring =
        Tube { upper: 40, lower: Some(44), layers: 3, ring: Some(30.0), friction: 0.0, seam: 0 };
    let half = Tube { lower: None, ..ring }.run();
    for seam in [0, 21] {
        let whole = Tube { seam, ..ring }.run();
        let error = apart(&whole, &half);
        assert!(error < 0.06 && whole.closed >= 3, "{error} {}", whole.closed);
        assert!(whole.imbalance < 1e-9 && whole.cutbacks <= 2, "{}", whole.cutbacks);
    }
}
