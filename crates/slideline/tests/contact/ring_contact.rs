//! Contact of parts that go all round axis 2: their faces have areas 2 pi r.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{ContactRow, Ending, Frame};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// What the last increment left: the force along the axis on a node, contact points, balance.
#[derive(Default)]
struct Last {
    node: u64,
    axial: f64,
    contact: Vec<ContactRow>,
    imbalance: f64,
    energy: [f64; 2],
    iterations: usize,
    increments: usize,
}

impl Observer for Last {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.take(frame);
        }
        ControlFlow::Continue(())
    }
}

impl Last {
    fn take(&mut self, frame: &Frame<'_>) {
        let node = frame.model.nodes.find(self.node).unwrap();
        self.axial = frame.nodal.reaction(node, slideline::model::Dof::U2);
        self.contact = frame.contact.to_vec();
        self.imbalance = self.imbalance.max(frame.pairs[0].force_imbalance);
        self.energy = [frame.energy.external_work, frame.energy.balance];
        self.iterations += frame.severe_iterations + frame.equilibrium_iterations;
        self.increments += usize::from(frame.increment > 0);
    }
}

fn solved(deck: &str, node: u64) -> Last {
    let read = Job::read_text("rings", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    // nothing is thick out of the plane
    assert!(read.diagnostics.iter().all(|said| said.code.0 != "SL0255"));
    let mut last = Last { node, ..Last::default() };
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut last);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    last
}

/// A grid of CAX4 or CAX8 over the corners given, numbered row by row; its nodes by place.
struct Grid {
    deck: String,
    columns: usize,
    rows: usize,
    base: usize,
    fine: usize,
}

impl Grid {
    fn new(kind: &str, base: usize, [r, z]: [&[f64]; 2], set: &str) -> Self {
        let fine = if kind == "CAX8" { 2 } else { 1 };
        let all = |corners: &[f64]| -> Vec<f64> {
            let between = corners.windows(2).flat_map(|pair| {
                (0..fine).map(|k| pair[0] + (pair[1] - pair[0]) * k as f64 / fine as f64)
            });
            between.chain(corners.last().copied()).collect()
        };
        let (r, z) = (all(r), all(z));
        let mut grid = Self { deck: "*NODE\n".into(), columns: r.len(), rows: z.len(), base, fine };
        for (j, z) in z.iter().enumerate() {
            for (i, r) in r.iter().enumerate() {
                if fine == 1 || i.is_multiple_of(2) || j.is_multiple_of(2) {
                    let _ = writeln!(grid.deck, "{}, {r:?}, {z:?}", grid.node(i, j));
                }
            }
        }
        let _ = writeln!(grid.deck, "*ELEMENT, TYPE={kind}, ELSET={set}");
        for j in (0..grid.rows - 1).step_by(fine) {
            for i in (0..grid.columns - 1).step_by(fine) {
                let corners = [[0, 0], [fine, 0], [fine, fine], [0, fine]];
                let middles = [[1, 0], [2, 1], [1, 2], [0, 1]];
                let of = |[a, b]: [usize; 2]| grid.node(i + a, j + b).to_string();
                let mut nodes: Vec<String> = corners.into_iter().map(of).collect();
                nodes.extend(middles.into_iter().filter(|_| fine == 2).map(of));
                let label = grid.node(i, j);
                let _ = writeln!(grid.deck, "{label}, {}", nodes.join(", "));
            }
        }
        grid
    }

    fn node(&self, i: usize, j: usize) -> usize {
        self.base + i + self.columns * j
    }

    fn exists(&self, i: usize, j: usize) -> bool {
        self.fine == 1 || i.is_multiple_of(2) || j.is_multiple_of(2)
    }

    fn set(&mut self, card: &str, numbers: impl Iterator<Item = usize>) {
        let _ = writeln!(self.deck, "{card}");
        numbers.for_each(|number| {
            let _ = writeln!(self.deck, "{number}");
        });
    }

    fn row(&mut self, card: &str, j: usize) {
        let all: Vec<_> =
            (0..self.columns).filter(|&i| self.exists(i, j)).map(|i| self.node(i, j)).collect();
        self.set(card, all.into_iter());
    }

    fn column(&mut self, card: &str, i: usize) {
        let all: Vec<_> =
            (0..self.rows).filter(|&j| self.exists(i, j)).map(|j| self.node(i, j)).collect();
        self.set(card, all.into_iter());
    }

    fn elements_of_row(&mut self, card: &str, j: usize) {
        let all: Vec<_> =
            (0..self.columns - 1).step_by(self.fine).map(|i| self.node(i, j)).collect();
        self.set(card, all.into_iter());
    }

    fn elements_of_column(&mut self, card: &str, i: usize) {
        let all: Vec<_> = (0..self.rows - 1).step_by(self.fine).map(|j| self.node(i, j)).collect();
        self.set(card, all.into_iter());
    }
}

fn even(n: usize, from: f64, to: f64) -> Vec<f64> {
    (0..=n).map(|k| from + (to - from) * k as f64 / n as f64).collect()
}

/// Requirement: a ring that is pressed flat on a rigid plane presses alike everywhere, p = E eps, and
/// its force is that of the whole ring, with linear and with quadratic elements.
#[test]
fn a_ring_presses_alike_everywhere() {
    for kind in ["CAX4", "CAX8", "CAX4R", "CAX8R"] {
        let like = if kind.starts_with("CAX8") { "CAX8" } else { "CAX4" };
        let mut grid = Grid::new(like, 1, [&[1.0, 1.3, 1.9, 2.5], &even(2, 0.0, 1.0)], "RING");
        let top = grid.rows - 1;
        grid.row("*NSET, NSET=TOP", top);
        grid.elements_of_row("*ELSET, ELSET=UNDER", 0);
        let deck = grid.deck.replace(like, kind)
            + "*NODE
9999, 0.0, 0.0
*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*SOLID SECTION, ELSET=RING, MATERIAL=M
*SURFACE, NAME=FACE
UNDER, S1
*SURFACE, NAME=PLANE, TYPE=SEGMENTS
START, 0.1, 0.0
LINE, 4.0, 0.0
*RIGID BODY, ANALYTICAL SURFACE=PLANE, REF NODE=9999
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
FACE, PLANE
*BOUNDARY
9999, 1, 6
*STEP
*STATIC
1.0, 1.0
*BOUNDARY
TOP, 2, 2, -0.01
*END STEP
";
        let last = solved(&deck, 9999);
        assert!(!last.contact.is_empty());
        for point in &last.contact {
            assert!((point.pressure - 10.0).abs() < 1e-7, "{kind} {point:?}");
        }
        let exact = 10.0 * PI * (2.5 * 2.5 - 1.0);
        assert!((last.axial - exact).abs() < 1e-7 * exact, "{kind} {} {exact}", last.axial);
        assert!(last.imbalance < 1e-12, "{kind} {}", last.imbalance);
    }
}

/// So many equal steps of a length, then as many that grow by 22 % each.
fn graded(first: f64, even: usize, growing: usize) -> Vec<f64> {
    let (mut places, mut step) = (vec![0.0], first);
    for k in 0..even + growing {
        step *= if k < even { 1.0 } else { 1.22 };
        places.push(places[k] + step);
    }
    places
}

/// Requirement: a rigid sphere pressed into a half-space carries Hertz' pressure,
/// p0 sqrt(1 - r2/a2) with a3 = 3 P R/(4 E') and p0 = 3 P/(2 pi a2), E' = E/(1 - nu2), also at the
/// axis, where a node's area is that of a small disc. Source: Johnson, Contact Mechanics, 4.2.
#[test]
fn a_sphere_on_a_block_carries_hertz_pressure() {
    let (e, nu, radius) = (1000.0, 0.3, 5.0);
    let out = graded(0.012, 20, 19);
    let down: Vec<f64> = graded(0.012, 14, 19).iter().rev().map(|z| -z).collect();
    let mut grid = Grid::new("CAX4", 1, [&out, &down], "BLOCK");
    let top = grid.rows - 2;
    grid.row("*NSET, NSET=BOTTOM", 0);
    grid.column("*NSET, NSET=AXIS", 0);
    grid.elements_of_row("*ELSET, ELSET=TOP", top);
    let deck = grid.deck
        + &format!(
            "*NODE
99999, 0.0, {radius:?}
*MATERIAL, NAME=M
*ELASTIC
{e:?}, {nu:?}
*SOLID SECTION, ELSET=BLOCK, MATERIAL=M
*SURFACE, NAME=FACE
TOP, S3
*SURFACE, NAME=SPHERE, TYPE=SEGMENTS
START, {radius:?}, {radius:?}
CIRCL, 0.0, 0.0, 0.0, {radius:?}
CIRCL, -{radius:?}, {radius:?}, 0.0, {radius:?}
*RIGID BODY, ANALYTICAL SURFACE=SPHERE, REF NODE=99999
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
FACE, SPHERE
*BOUNDARY
BOTTOM, 1, 2
AXIS, 1, 1
99999, 1, 1
99999, 6, 6
*STEP, NLGEOM
*STATIC
0.25, 1.0
*BOUNDARY
99999, 2, 2, -0.008
*END STEP
"
        );
    let last = solved(&deck, 99999);
    let force = -last.axial;
    let edge = (3.0 * force * radius * (1.0 - nu * nu) / (4.0 * e)).cbrt();
    let most = 1.5 * force / (PI * edge * edge);
    assert!(edge > 10.0 * 0.012 && edge < 20.0 * 0.012, "{edge}");
    let inside = last.contact.iter().filter(|point| point.position[0] < edge - 0.018);
    let mut count = 0;
    for point in inside {
        let exact = most * (1.0 - (point.position[0] / edge).powi(2)).sqrt();
        let off = (point.pressure - exact) / most;
        // lumped areas: a few parts in a hundred on the axis itself
        let allowed = if point.position[0] < 0.006 { 0.04 } else { 0.02 };
        assert!(off.abs() < allowed, "{point:?} {exact} {off}");
        count += 1;
    }
    assert!(count > 10, "{count}");
    // approach of a sphere: a2/R; the block is 20 contact radii deep, not a half-space
    assert!((edge * edge / radius - 0.008).abs() < 0.06 * 0.008, "{}", edge * edge / radius);
}

/// Requirement: a hub pressed into a ring that is too small by an interference carries Lame's
/// pressure, and the mean of the faces converges to it.
#[test]
fn a_press_fit_carries_lame_pressure() {
    let (e, nu, too_large) = (1000.0, 0.3, 1e-3);
    let [inner, fit, outer] = [1.0_f64, 2.0, 3.5];
    let mut errors = Vec::new();
    for n in [2, 4, 8] {
        let mut hub =
            Grid::new("CAX4", 1, [&even(n, inner, fit + too_large), &even(n, 0.0, 0.5)], "HUB");
        let last_column = hub.columns - 2;
        hub.elements_of_column("*ELSET, ELSET=OUT", last_column);
        hub.row("*NSET, NSET=LOW", 0);
        let z = even(n + 1, 0.0, 0.5);
        let mut ring = Grid::new("CAX4", 1001, [&even(n, fit, outer), &z], "RING");
        ring.elements_of_column("*ELSET, ELSET=IN", 0);
        ring.row("*NSET, NSET=FOOT", 0);
        let deck = hub.deck
            + &ring.deck
            + &format!(
                "*MATERIAL, NAME=M
*ELASTIC
{e:?}, {nu:?}
*SOLID SECTION, ELSET=HUB, MATERIAL=M
*SOLID SECTION, ELSET=RING, MATERIAL=M
*SURFACE, NAME=OUTER
OUT, S2
*SURFACE, NAME=BORE
IN, S4
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
OUTER, BORE
*BOUNDARY
LOW, 2, 2
FOOT, 2, 2
*STEP
*STATIC
1.0, 1.0
*END STEP
"
            );
        let last = solved(&deck, 1);
        let force: f64 = last.contact.iter().map(|point| point.pressure * point.area).sum();
        let area: f64 = last.contact.iter().map(|point| point.area).sum();
        assert!((area - TAU * (fit + too_large) * 0.5).abs() < 1e-9, "{area}");
        let square = |a: f64| a * a;
        let of_ring = (square(outer) + square(fit)) / (square(outer) - square(fit)) + nu;
        let of_hub = (square(fit) + square(inner)) / (square(fit) - square(inner)) - nu;
        let exact = too_large * e / (fit * (of_ring + of_hub));
        errors.push((force / area / exact - 1.0).abs());
        assert!(last.imbalance < 1e-12, "{}", last.imbalance);
    }
    assert!(errors[2] < 2e-3 && errors[1] < 0.35 * errors[0], "{errors:?}");
    assert!(errors[2] < 0.35 * errors[1], "{errors:?}");
}

/// Requirement: an elastic collar is pushed onto a rigid bead (r = 2.15), without
/// friction: forces balance in every increment, and no energy is lost but what it keeps itself.
#[test]
fn a_collar_snaps_over_a_bead() {
    let mut grid = Grid::new("CAX4", 1, [&even(3, 2.0, 2.3), &even(24, 0.0, 3.0)], "COLLAR");
    let top = grid.rows - 1;
    grid.row("*NSET, NSET=TOP", top);
    grid.elements_of_column("*ELSET, ELSET=IN", 0);
    let deck = grid.deck
        + "*NODE
9999, 0.0, 0.0
*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*SOLID SECTION, ELSET=COLLAR, MATERIAL=M
*SURFACE, NAME=BORE
IN, S4
*SURFACE, NAME=BEAD, TYPE=SEGMENTS
START, 1.7, -0.05
CIRCL, 2.15, -0.5, 1.7, -0.5
CIRCL, 1.7, -0.95, 1.7, -0.5
*RIGID BODY, ANALYTICAL SURFACE=BEAD, REF NODE=9999
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
BORE, BEAD
*BOUNDARY
9999, 1, 6
TOP, 1, 1
*STEP, NLGEOM, INC=200
*STATIC, DIRECT
0.02, 1.0
*BOUNDARY
TOP, 2, 2, -0.8
*END STEP
";
    let last = solved(&deck, 9999);
    assert!(last.imbalance < 1e-12, "{}", last.imbalance);
    assert!(last.contact.iter().any(|point| point.pressure > 0.0));
    let [work, balance] = last.energy;
    assert!(work > 0.0 && balance.abs() < 0.01 * work, "{work} {balance}");
    assert!(last.iterations <= 6 * last.increments, "{} {}", last.iterations, last.increments);
}
