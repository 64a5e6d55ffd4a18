//! Decks of the paper's first problem, with everything that a claim varies.
//!
//! ```text
//!   Y   ( O )  circle 9999, moves along -Y
//!   |    \_/ /
//!   |       / beam, clamped at node 0
//!   +------/------- X
//! ```
//!
//! Nodes and elements are written one by one, so that these decks do not
//! depend on the generating keywords that the paper's decks use.

use std::fmt::Write as _;

/// Who carries the contact elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The beam (IRS21 against an analytic circle).
    Irs,
    /// The circle (ISL21 against a slide line on the beam).
    Isl,
    /// The beam, integrated along it (SURFACE TO SURFACE).
    Surface,
}

/// What the beam is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beam {
    /// Two nodes, shear-flexible.
    B21,
    /// Three nodes, shear-flexible.
    B22,
    /// Two nodes, without shear.
    B23,
}

/// Slave nodes on the circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slaves {
    /// The paper's: every 6 degrees to 60, then every 4 to 100.
    Paper,
    /// Equally spaced from 60 to 110 degrees; the spacing [degree].
    Every(f64),
}

/// A rigid motion of the whole deck; the mirror image comes first.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Placement {
    /// Turned about the origin by [rad].
    pub angle: f64,
    /// Then shifted by [L].
    pub shift: [f64; 2],
    /// Mirror image, x to -x, with the order of both surfaces reversed.
    pub mirror: bool,
}

impl Placement {
    /// A vector of the original deck in this one.
    pub fn vector(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let x = if self.mirror { -x } else { x };
        let (s, c) = self.angle.sin_cos();
        [c * x - s * y, s * x + c * y]
    }

    fn point(&self, p: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.vector(p);
        [x + self.shift[0], y + self.shift[1]]
    }
}

/// Units in which a deck is written, as multiples of metre and newton.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Units of length in a metre [1].
    pub length: f64,
    /// Units of force in a newton [1].
    pub force: f64,
}

/// The first problem's deck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// Who carries the contact elements.
    pub method: Method,
    /// Which beams.
    pub beam: Beam,
    /// How many.
    pub elements: usize,
    /// Equal increments of the push.
    pub increments: usize,
    /// Coefficient of friction [1].
    pub mu: f64,
    /// What stands behind `*FRICTION`, such as `, LAGRANGE`.
    pub friction: &'static str,
    /// Friction onset.
    pub onset: &'static str,
    /// Softened contact as in the paper; hard if not.
    pub softened: bool,
    /// `SMOOTH` of the slide line [1].
    pub smooth: f64,
    /// Slave nodes on the circle.
    pub slaves: Slaves,
    /// Where the deck stands.
    pub placement: Placement,
    /// Its units.
    pub units: Units,
    /// R_n, where the default will not do [1].
    pub tolerance: Option<f64>,
    /// A second step goes back to the start.
    pub returns: bool,
    /// Other labels in another order.
    pub renumbered: bool,
}

impl Push {
    /// The paper's coarse models, without friction, in 20 increments.
    pub fn paper(method: Method) -> Self {
        Self {
            method,
            beam: Beam::B21,
            elements: 24,
            increments: 20,
            mu: 0.0,
            friction: "",
            onset: "IMMEDIATE",
            softened: true,
            smooth: 0.25,
            slaves: Slaves::Paper,
            placement: Placement::default(),
            units: Units { length: 1.0, force: 1.0 },
            tolerance: None,
            returns: false,
            renumbered: false,
        }
    }

    /// Label of the reference node of the circle.
    pub const CIRCLE: u64 = 9999;

    /// Label of beam node `k`, counted from 0 at the clamp.
    pub fn beam_label(&self, k: usize) -> u64 {
        let (k, last) = (k as u64, (self.elements * self.nodes_a_beam()) as u64);
        if self.renumbered { 20_000 + (last - k) * 7 } else { 1 + k }
    }

    /// Nodes from one beam to the next.
    fn nodes_a_beam(&self) -> usize {
        if self.beam == Beam::B22 { 2 } else { 1 }
    }

    /// The deck.
    pub fn deck(&self) -> String {
        let mut text = String::from("*HEADING\ncircle on a cantilever\n");
        self.nodes(&mut text);
        self.beam(&mut text);
        match self.method {
            Method::Irs => self.rigid_surface(&mut text),
            Method::Isl => self.slide_line(&mut text),
            Method::Surface => self.surfaces(&mut text),
        }
        if self.method == Method::Surface {
            self.pair(&mut text);
        } else {
            self.laws(&mut text);
        }
        self.step(&mut text, 1.0);
        if self.returns {
            self.step(&mut text, 0.0);
        }
        text
    }

    fn length(&self, value: f64) -> f64 {
        value * self.units.length
    }

    fn modulus(&self, value: f64) -> f64 {
        value * self.units.force / (self.units.length * self.units.length)
    }

    fn place(&self, p: [f64; 2]) -> String {
        let [x, y] = self.placement.point(p);
        format!("{:?}, {:?}", self.length(x), self.length(y))
    }

    fn nodes(&self, text: &mut String) {
        let last = self.elements * self.nodes_a_beam();
        let at = |k: usize| {
            let t = k as f64 / last as f64;
            [7.0e-3 + t * 2.222e-3, t * 50.0e-3]
        };
        let mut lines = vec![format!("9999, {}", self.place([0.0, 45.0e-3]))];
        for k in 0..=last {
            lines.push(format!("{}, {}", self.beam_label(k), self.place(at(k))));
        }
        for (label, degrees) in self.slave_nodes() {
            let (s, c) = f64::to_radians(degrees).sin_cos();
            lines.push(format!("{label}, {}", self.place([9.0e-3 * s, 45.0e-3 - 9.0e-3 * c])));
        }
        if self.renumbered {
            // every fifth first, then those before them ...
            let (n, old) = (lines.len(), lines.clone());
            lines = (0..5).rev().flat_map(|r| (r..n).step_by(5)).map(|i| old[i].clone()).collect();
        }
        let _ = writeln!(text, "*NODE\n{}", lines.join("\n")); // a String takes any text
    }

    fn slave_nodes(&self) -> Vec<(u64, f64)> {
        let angles: Vec<f64> = match (self.method, self.slaves) {
            (Method::Irs | Method::Surface, _) => Vec::new(),
            (_, Slaves::Paper) => {
                let lower = (0..10).map(|k| 6.0 * f64::from(k));
                lower.chain((0..=10).map(|k| 60.0 + 4.0 * f64::from(k))).collect()
            }
            (_, Slaves::Every(step)) => {
                (0..=(50.0 / step).round() as usize).map(|k| 60.0 + step * k as f64).collect()
            }
        };
        (9000..).zip(angles).collect()
    }

    fn beam(&self, text: &mut String) {
        let _ = writeln!(text, "*ELEMENT, TYPE={:?}, ELSET=BEAM", self.beam);
        let step = self.nodes_a_beam();
        for k in 0..self.elements {
            let nodes = (0..=step).map(|n| self.beam_label(step * k + n).to_string());
            let nodes: Vec<String> = nodes.collect();
            let _ = writeln!(text, "{}, {}", 100_001 + k, nodes.join(", "));
        }
        let _ = writeln!(
            text,
            "*BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=POLYCARB\n{:?}, {:?}\n\
             *MATERIAL, NAME=POLYCARB\n*ELASTIC\n{:?}, 0.3",
            self.length(25.0e-3),
            self.length(1.5e-3),
            self.modulus(6.9e9)
        );
    }

    /// Two arcs of the circle, as the lines of a surface.
    fn arcs(&self) -> String {
        let (top, side, bottom) = ([0.0, 54.0e-3], [9.0e-3, 45.0e-3], [0.0, 36.0e-3]);
        let (first, last) = if self.placement.mirror { (bottom, top) } else { (top, bottom) };
        let centre = self.place([0.0, 45.0e-3]);
        format!(
            "START, {}\nCIRCL, {}, {centre}\nCIRCL, {}, {centre}",
            self.place(first),
            self.place(side),
            self.place(last)
        )
    }

    fn surfaces(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "*SURFACE, NAME=CIRCLE, TYPE=SEGMENTS\n{}\n\
             *RIGID BODY, REF NODE=9999, ANALYTICAL SURFACE=CIRCLE\n\
             *SURFACE, NAME=BEAM, TYPE=ELEMENT\nBEAM, {}",
            self.arcs(),
            if self.placement.mirror { "SNEG" } else { "SPOS" }
        );
    }

    fn pair(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "*SURFACE INTERACTION, NAME=SLIDING\n{:?}\n*FRICTION{}\n{:?}",
            self.length(25.0e-3),
            self.friction,
            self.mu
        );
        if self.softened {
            let (c0, p0) = (self.length(1.0e-5), self.modulus(4.8e6));
            let _ = writeln!(
                text,
                "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n{c0:?}, {p0:?}"
            );
        }
        let _ = writeln!(
            text,
            "*CONTACT PAIR, INTERACTION=SLIDING, TYPE=SURFACE TO SURFACE, NO THICKNESS\n\
             BEAM, CIRCLE\n*CONTACT CONTROLS, FRICTION ONSET={}",
            self.onset
        );
    }

    fn rigid_surface(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "*RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\n{}\n\
             *ELEMENT, TYPE=IRS21, ELSET=CONTACT",
            self.arcs()
        );
        for k in 1..self.elements {
            let ends = [self.beam_label(k), self.beam_label(k + 1)];
            let _ = writeln!(text, "{}, {}, {}, 9999", 200_000 + k, ends[0], ends[1]);
        }
    }

    fn slide_line(&self, text: &mut String) {
        let labels: Vec<u64> = self.slave_nodes().iter().map(|&(label, _)| label).collect();
        let _ = writeln!(text, "*MPC");
        for label in &labels {
            let _ = writeln!(text, "BEAM, {label}, 9999");
        }
        let _ = writeln!(text, "*ELEMENT, TYPE=ISL21, ELSET=CONTACT");
        for (k, pair) in labels.windows(2).enumerate() {
            let _ = writeln!(text, "{}, {}, {}", 200_000 + k, pair[0], pair[1]);
        }
        let mut line: Vec<String> =
            (1..=self.elements).map(|k| self.beam_label(k).to_string()).collect();
        if self.placement.mirror {
            line.reverse();
        }
        let _ = writeln!(text, "*SLIDE LINE, TYPE=LINEAR, ELSET=CONTACT, SMOOTH={:?}", self.smooth);
        for part in line.chunks(16) {
            let _ = writeln!(text, "{}", part.join(", "));
        }
    }

    fn laws(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "*INTERFACE, ELSET=CONTACT\n{:?}\n*FRICTION{}\n{:?}",
            self.length(25.0e-3),
            self.friction,
            self.mu
        );
        if self.softened {
            let (c0, p0) = (self.length(1.0e-5), self.modulus(4.8e6));
            let _ = writeln!(text, "*SURFACE CONTACT, SOFTENED\n{c0:?}, {p0:?}");
        }
        let _ = writeln!(text, "*CONTACT CONTROLS, FRICTION ONSET={}", self.onset);
    }

    fn step(&self, text: &mut String, end: f64) {
        let dt = 1.0 / self.increments as f64;
        let [x, y] = self.placement.vector([0.0, -30.0e-3 * end]).map(|v| self.length(v));
        let _ = writeln!(
            text,
            "*STEP, NLGEOM, INC=100000\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n*BOUNDARY\n\
             {}, 1, 6\n9999, 1, 1, {x:?}\n9999, 2, 2, {y:?}\n9999, 6, 6\n\
             *CONTROLS, ANALYSIS=DISCONTINUOUS",
            self.beam_label(0)
        );
        if let Some(tolerance) = self.tolerance {
            let _ = writeln!(text, "*CONTROLS, PARAMETERS=FIELD\n{tolerance:?}");
        }
        let _ = writeln!(text, "*END STEP");
    }
}
