//! Decks of strokes that are easily got wrong without a word.
//!
//! ```text
//!   |/                      ( ) 900, moves along -Y by many of its radii
//!   |/o--o--o--o--o--o--o--o--o--o--o   strip 1..n, clamped
//! ```

use std::fmt::Write as _;

/// Who carries contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// Nodes of the strip against the roller.
    Nodes,
    /// Integrated along the strip.
    Integrated,
    /// Nodes on the roller against the strip.
    OnRoller,
}

/// A roller moved onto, and if nothing stopped it through, a cantilever strip.
#[derive(Clone, Copy, Debug)]
pub struct Roller {
    /// Who carries contact.
    pub contact: Contact,
    /// Elements of the strip.
    pub elements: usize,
    /// Radius of the roller, of the length of the strip [1].
    pub radius: f64,
    /// Its way down, of the length of the strip [1].
    pub stroke: f64,
    /// Its place along the strip [1].
    pub place: f64,
    /// First and largest increment, of the step.
    pub increment: f64,
    /// Smallest increment, of the step.
    pub smallest: f64,
    /// Whether the roller is a full circle, or its lower half.
    pub full: bool,
    /// Unit of length, of force.
    pub units: [f64; 2],
}

impl Default for Roller {
    fn default() -> Self {
        Self {
            contact: Contact::Nodes,
            elements: 40,
            radius: 0.08,
            stroke: 0.2,
            place: 0.6,
            increment: 1.0,
            smallest: 1e-5,
            full: true,
            units: [1.0, 1.0],
        }
    }
}

impl Roller {
    /// The node that carries the roller.
    pub const ROLLER: u64 = 900;

    /// The deck.
    pub fn deck(&self) -> String {
        let [length, force] = self.units;
        let (l, r) = (length, self.radius * length);
        let (x, y) = (self.place * length, 1.01 * self.radius * length);
        let modulus = 2.1e11 * force / (length * length);
        let n = self.elements;
        let mut deck = format!(
            "*HEADING\nroller\n*NODE\n1, 0., 0.\n{}, {l:?}, 0.\n900, {x:?}, {y:?}\n*NGEN\n1, {}\n\
             *ELEMENT, TYPE=B21, ELSET=STRIP\n1, 1, 2\n*ELGEN, ELSET=STRIP\n1, {n}\n\
             *BEAM SECTION, SECTION=RECT, ELSET=STRIP, MATERIAL=M\n{:?}, {:?}\n\
             *MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.3\n",
            n + 1,
            n + 1,
            0.1 * l,
            0.01 * l
        );
        let _ = match self.contact {
            Contact::OnRoller => self.slaves(&mut deck, (x, y), r),
            _ => self.surface(&mut deck, (x, y), r),
        };
        let stiffness = 1e10 * force / (length * length * length);
        let pair = match self.contact {
            Contact::Nodes => "*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nLINE, ROLLER\n",
            Contact::Integrated => {
                "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nLINE, ROLLER\n"
            }
            Contact::OnRoller => {
                "*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE, SMOOTH=0.2\nROLLER, LINE\n"
            }
        };
        let _ = write!(
            deck,
            "*SURFACE, NAME=LINE\nSTRIP\n*SURFACE INTERACTION, NAME=I\n{:?}\n\
             *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{stiffness:?}\n{pair}\
             *STEP, NLGEOM, INC=1000\n*STATIC\n{:?}, 1., {:?}, {:?}\n*BOUNDARY\n1, 1, 6\n900, 1\n\
             900, 6\n900, 2, 2, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1e-10\n*END STEP\n",
            0.1 * l,
            self.increment,
            self.smallest,
            self.increment,
            -self.stroke * length
        );
        deck
    }

    fn surface(&self, deck: &mut String, (x, y): (f64, f64), r: f64) -> std::fmt::Result {
        let quarters: &[[f64; 2]] = match self.full {
            true => &[[0.0, -1.0], [-1.0, 0.0], [0.0, 1.0], [1.0, 0.0]],
            false => &[[0.0, -1.0], [-1.0, 0.0]],
        };
        writeln!(deck, "*SURFACE, NAME=ROLLER, TYPE=SEGMENTS\nSTART, {:?}, {y:?}", x + r)?;
        for [c, s] in quarters {
            writeln!(deck, "CIRCL, {:?}, {:?}, {x:?}, {y:?}", x + r * c, y + r * s)?;
        }
        writeln!(deck, "*RIGID BODY, REF NODE=900, ANALYTICAL SURFACE=ROLLER")
    }

    /// Slave nodes every five degrees all round, on beams that only draw.
    fn slaves(&self, deck: &mut String, (x, y): (f64, f64), r: f64) -> std::fmt::Result {
        writeln!(deck, "*NODE, NSET=RIM")?;
        for k in 0..72 {
            let angle = (5.0 * f64::from(k)).to_radians();
            writeln!(deck, "{}, {:?}, {:?}", 1000 + k, x + r * angle.cos(), y + r * angle.sin())?;
        }
        writeln!(
            deck,
            "*SURFACE, NAME=ROLLER, TYPE=NODE\nRIM\n*RIGID BODY, REF NODE=900, TIE NSET=RIM"
        )
    }
}
