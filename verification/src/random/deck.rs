//! A cantilever along x and a rigid body above it, which is pressed into it,
//! dragged, turned, and drawn back.

use super::sequence::Sequence;
use super::shapes::Shape;
use std::fmt::Write as _;

/// What kind of model it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Held, finely enough divided, moderately deformed.
    WellPosed,
    /// Nothing holds the beam.
    Free,
    /// The body is drawn beyond the end of the beam.
    BeyondTheEnd,
    /// Pressed in by up to half the length.
    TooDeep,
    /// mu up to 3.
    Jamming,
    /// The body slips between the nodes.
    TooCoarse,
    /// Rigidly linked slaves under hard contact.
    Overconstrained,
    /// A law a million times too stiff or too soft.
    StrangeLaw,
    /// One fixed increment.
    OneIncrement,
    /// A large overclosure at the start.
    Overclosed,
    /// Friction without limit: a point that closes on a slope may have to
    /// pull, and then there is no equilibrium.
    Rough,
}

/// The ways of being spoilt.
const SPOILT: [Kind; 10] = [
    Kind::Free,
    Kind::BeyondTheEnd,
    Kind::TooDeep,
    Kind::Jamming,
    Kind::TooCoarse,
    Kind::Overconstrained,
    Kind::StrangeLaw,
    Kind::OneIncrement,
    Kind::Overclosed,
    Kind::Rough,
];

/// Which side carries the points, and how contact is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Method {
    /// Nodes of the beam against the surface of the body.
    Irs,
    /// Nodes of the body against the chain of the beam.
    Isl,
    /// Integrated along the beam.
    Integrated,
}

/// A model and what was drawn for it.
#[derive(Clone, Debug)]
pub struct Model {
    /// Its number.
    pub number: u64,
    /// Its kind.
    pub kind: Kind,
    /// The deck.
    pub text: String,
    /// Number of the reference node of the body.
    pub body: u64,
    /// Whether every contact point is a node with a row of its own.
    pub nodal: bool,
}

/// Number of the reference node.
const BODY: u64 = 9999;

/// The model of that number.
pub fn model(number: u64) -> Model {
    let mut s = Sequence::new(number);
    let kind = if number % 5 == 4 {
        SPOILT[(number / 5) as usize % SPOILT.len()]
    } else {
        Kind::WellPosed
    };
    let mut draft = Draft::drawn(kind, &mut s);
    draft.beam(&mut s);
    draft.contact(&mut s);
    draft.laws(&mut s);
    draft.steps(&mut s);
    let nodal = draft.method != Method::Integrated;
    Model { number, kind, text: draft.text, body: BODY, nodal }
}

/// What is drawn first, and the deck as it grows.
struct Draft {
    kind: Kind,
    method: Method,
    /// B21, B22 or B23.
    element: &'static str,
    elements: usize,
    length: f64,
    height: f64,
    modulus: f64,
    shape: Shape,
    /// Where the body stands along the beam [L].
    at: f64,
    gap: f64,
    /// Half the angle over which slaves stand [degrees].
    half_angle: f64,
    text: String,
}

impl Draft {
    fn drawn(kind: Kind, s: &mut Sequence) -> Self {
        let method = match kind {
            Kind::Overconstrained => Method::Isl,
            Kind::TooCoarse => Method::Irs,
            _ => s.one_of(&[Method::Irs, Method::Isl, Method::Integrated]),
        };
        let element = s.one_of(&["B21", "B21", "B22", "B23"]);
        let elements = 6 + s.below(if element == "B22" { 12 } else { 24 });
        let length = s.between(0.03, 0.2);
        let nodes = if element == "B22" { 2 * elements } else { elements };
        // Nodes must not pass the body between them: at least one per 0.8 r.
        let least = if method == Method::Irs { 1.25 / nodes as f64 } else { 0.05 };
        let [least, most] = match kind {
            Kind::TooCoarse => [0.005, 0.1 / nodes as f64],
            _ => [least.max(0.05), least.max(0.05) + 0.25],
        };
        let radius = length * s.between(least, most.max(least));
        let nose = method != Method::Isl && s.below(3) == 0;
        let shape = if nose {
            let (slope, fillet) = (s.between(0.5, 1.0), radius * s.between(0.3, 0.9));
            Shape::Nose { half: radius, slope, fillet }
        } else {
            Shape::Circle(radius)
        };
        let gap = match kind {
            Kind::Overclosed => -length * s.between(0.01, 0.1),
            _ => length * s.between(-1e-4, 5e-3),
        };
        Self {
            kind,
            method,
            element,
            elements,
            length,
            height: length * s.between(0.01, 0.05),
            modulus: s.power(8.5, 11.5),
            shape,
            at: length * s.between(0.4, 0.7),
            gap,
            half_angle: s.between(35.0, 60.0),
            text: String::from("*HEADING\nrandom\n"),
        }
    }

    fn beam(&mut self, s: &mut Sequence) {
        let (element, elements) = (self.element, self.elements);
        let per = if element == "B22" { 2 } else { 1 };
        let last = per * elements + 1;
        let nodes = if per == 2 { "1, 1, 2, 3" } else { "1, 1, 2" };
        let width = s.between(0.005, 0.05);
        let _ = write!(
            self.text,
            "*NODE, NSET=BEAM\n1, 0.0, 0.0\n{last}, {:.9e}, 0.0\n*NGEN, NSET=BEAM\n1, {last}\n\
             *ELEMENT, TYPE={element}, ELSET=BEAM\n{nodes}\n*ELGEN, ELSET=BEAM\n\
             1, {elements}, {per}, 1\n*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n\
             {width:.6e}, {:.9e}\n*MATERIAL, NAME=M\n*ELASTIC\n{:.9e}, 0.3\n",
            self.length, self.height, self.modulus
        );
    }

    /// Number of the last node of the beam.
    fn last(&self) -> usize {
        self.elements * if self.element == "B22" { 2 } else { 1 } + 1
    }

    fn contact(&mut self, s: &mut Sequence) {
        let (x, y) = (self.at, self.gap);
        let _ = write!(
            self.text,
            "*NODE, NSET=BODY\n{BODY}, {x:.9e}, {:.9e}\n",
            y + self.shape.reference()
        );
        match self.method {
            Method::Irs => {
                let segments = self.shape.segments([x, y]);
                let _ = write!(
                    self.text,
                    "*RIGID SURFACE, TYPE=SEGMENTS, ELSET=C\n{segments}*ELEMENT, TYPE=IRS21, \
                     ELSET=C\n1001, 2, 3, {BODY}\n*ELGEN, ELSET=C\n1001, {}\n*INTERFACE, ELSET=C\n",
                    self.last() - 2
                );
            }
            Method::Isl => self.slaves(s),
            Method::Integrated => {
                let segments = self.shape.segments([x, y]);
                let _ = write!(
                    self.text,
                    "*SURFACE, NAME=TOOL, TYPE=SEGMENTS\n{segments}*RIGID BODY, REF NODE={BODY}, \
                     ANALYTICAL SURFACE=TOOL\n*SURFACE, NAME=TOP, TYPE=ELEMENT\nBEAM, SPOS\n\
                     *CONTACT PAIR, INTERACTION=C, TYPE=SURFACE TO SURFACE, NO THICKNESS\n\
                     TOP, TOOL\n*SURFACE INTERACTION, NAME=C\n"
                );
            }
        }
        let _ = writeln!(self.text, "{:.6e}", s.between(0.005, 0.05));
    }

    /// Slaves over the lower part of the circle, tied to its centre.
    fn slaves(&mut self, s: &mut Sequence) {
        let radius = self.shape.reference();
        let intervals = 12 + 2 * s.below(8);
        self.text.push_str("*NODE, NSET=RIM\n");
        for k in 0..=intervals {
            let part = 2.0 * k as f64 / intervals as f64 - 1.0;
            let (sin, cos) = (self.half_angle * part).to_radians().sin_cos();
            let (x, y) = (self.at + radius * sin, self.gap + radius * (1.0 - cos));
            let _ = writeln!(self.text, "{}, {x:.9e}, {y:.9e}", 9000 + k);
        }
        let _ = write!(
            self.text,
            "*MPC\nBEAM, RIM, {BODY}\n*ELEMENT, TYPE=ISL21, ELSET=C\n1001, 9000, 9001\n\
             *ELGEN, ELSET=C\n1001, {intervals}\n*SLIDE LINE, TYPE=LINEAR, ELSET=C, \
             SMOOTH={:.6}, GENERATE\n1, {}, 1\n*INTERFACE, ELSET=C\n",
            s.between(0.0, 0.45),
            self.last()
        );
    }

    fn laws(&mut self, s: &mut Sequence) {
        let mu = if self.kind == Kind::Jamming { s.between(1.0, 3.0) } else { s.between(0.0, 0.6) };
        let card = match s.below(8) {
            _ if self.kind == Kind::Rough => "*FRICTION, ROUGH".to_owned(),
            0 => "*FRICTION\n0.0".to_owned(),
            1 => format!("*FRICTION, LAGRANGE\n{mu:.6}"),
            2 => format!("*FRICTION, TAUMAX={:.6e}\n{mu:.6}", self.pressure() * s.power(-1.0, 1.0)),
            3 => format!(
                "*FRICTION, ELASTIC SLIP={:.6e}\n{mu:.6}",
                self.length * s.power(-5.0, -3.0)
            ),
            4 => format!("*FRICTION, SLIP TOLERANCE={:.6e}\n{mu:.6}", s.power(-4.0, -1.5)),
            5 => {
                let kinetic = mu * s.between(0.7, 1.0);
                let rate = s.power(-1.0, 1.0) / self.length;
                format!("*FRICTION, EXPONENTIAL DECAY\n{mu:.6}, {kinetic:.6}, {rate:.6e}")
            }
            _ => format!("*FRICTION\n{mu:.6}"),
        };
        self.text.push_str(&card);
        self.text.push('\n');
        self.pressure_law(s);
        let onset = s.one_of(&["IMMEDIATE", "IMMEDIATE", "DELAYED", "MATFRU"]);
        let _ = writeln!(self.text, "*CONTACT CONTROLS, FRICTION ONSET={onset}");
    }

    /// Pressure that the beam can exert, in order of magnitude [F/L2].
    fn pressure(&self) -> f64 {
        self.modulus * (self.height / self.length).powi(3)
    }

    fn pressure_law(&mut self, s: &mut Sequence) {
        let mut pressure = self.pressure() * s.power(0.0, 2.0);
        let clearance = self.length * s.power(-4.5, -3.0);
        if self.kind == Kind::StrangeLaw {
            pressure *= s.one_of(&[1e-6, 1e6]);
        }
        // Rigid links and hard contact exclude each other: Diehl (1995), 2.0;
        // integrated contact has no hard law.
        let hard = match self.method {
            Method::Irs => s.below(3) == 0,
            _ => self.kind == Kind::Overconstrained,
        };
        let behavior = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE";
        let law = match s.below(5) {
            _ if hard => String::new(),
            0 => format!("{behavior}=LINEAR\n{:.6e}\n", pressure / clearance),
            1 => format!(
                "{behavior}=TABULAR\n0.0, {:.6e}\n{pressure:.6e}, 0.0\n{:.6e}, {clearance:.6e}\n",
                -clearance,
                4.0 * pressure
            ),
            _ => format!("{behavior}=EXPONENTIAL\n{clearance:.6e}, {pressure:.6e}\n"),
        };
        self.text.push_str(&law);
    }

    fn steps(&mut self, s: &mut Sequence) {
        let deep = if self.kind == Kind::TooDeep { 0.5 } else { 0.07 };
        let press = -self.gap.max(0.0) - self.length * s.between(0.005, deep);
        let room = (self.length - self.at - self.shape.reach()).max(0.0);
        let mut drag = if s.below(2) == 0 { -0.2 * self.length } else { 0.7 * room } * s.number();
        if self.kind == Kind::BeyondTheEnd {
            drag = self.length * s.between(0.5, 1.0);
        }
        if self.kind == Kind::Rough {
            drag *= 0.02; // the beam is stretched by it
        }
        let most = match (self.shape, self.kind == Kind::Rough) {
            (_, true) => 0.01,
            (Shape::Circle(_), _) if self.method != Method::Isl => 0.5,
            _ => 0.15,
        };
        let turn = if s.below(2) == 0 { s.between(-most, most) } else { 0.0 };
        let last = match s.below(3) {
            0 => [0.0, 0.02 * self.length, 0.0], // drawn off
            1 => [0.0, press, 0.0],              // dragged back
            _ => [drag, 0.5 * press, turn],      // half relieved
        };
        let goals = [[0.0, press, 0.0], [drag, press, turn], last];
        let count = 1 + s.below(3);
        let increment = s.one_of(&[0.05, 0.1, 0.2]);
        for (k, [x, y, turn]) in goals.iter().take(count).enumerate() {
            let held = if self.kind == Kind::Free { "1, 1\n" } else { "1, 1, 6\n" };
            let time = match self.kind {
                Kind::OneIncrement => "*STATIC, DIRECT\n1.0, 1.0".to_owned(),
                _ => format!("*STATIC\n{increment}, 1.0, 1.0E-6"),
            };
            let _ = write!(
                self.text,
                "*STEP, NLGEOM, INC=500\nstep {k}\n{time}\n*BOUNDARY\n{held}{BODY}, 1, 1, {x:.9e}\n\
                 {BODY}, 2, 2, {y:.9e}\n{BODY}, 6, 6, {turn:.9e}\n*END STEP\n"
            );
        }
    }
}
