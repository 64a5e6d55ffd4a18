//! Decks with as many closed contact points as wanted: beams on a flat, and two
//! beams on one another.
//!
//! ```text
//!   | | | | | | | |  loads                o--o--o--o--o  upper beam, loaded
//!   v v v v v v v v                       v  v  v  v  v
//!   o-o-o-o-o-o-o-o  beam              o--o--o--o--o--o  lower beam, held below
//!   ===============  flat -> slides
//! ```
//!
//! Elements of 1 mm by 1 mm by 10 mm of steel; mm, N, MPa.

/// A soft law: 10 MPa at no gap, contact from 0.02 mm on.
pub const SOFT: &str = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.02, 10.0";
/// The hard law.
pub const HARD: &str = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD";

/// Nodes and B21 elements of a beam from `first` on, from `start` to the right.
fn beam(name: &str, first: usize, nodes: usize, [x, y]: [f64; 2]) -> String {
    let (last, elements) = (first + nodes - 1, nodes - 1);
    let (next, end) = (first + 1, x + elements as f64);
    format!(
        "*NODE, NSET={name}\n{first}, {x:?}, {y:?}\n{last}, {end:?}, {y:?}\n\
         *NGEN, NSET={name}\n{first}, {last}, 1\n*ELEMENT, TYPE=B21, ELSET={name}\n\
         {first}, {first}, {next}\n*ELGEN, ELSET={name}\n{first}, {elements}, 1, 1\n\
         *BEAM SECTION, SECTION=RECT, ELSET={name}, MATERIAL=M\n10.0, 1.0\n"
    )
}

const MATERIAL: &str = "*MATERIAL, NAME=M\n*ELASTIC\n210000.0, 0.3\n";

/// A beam of `nodes` nodes loaded onto a rigid flat, under a law; with a
/// coefficient of friction the flat slides by 0.5 mm in a second step.
pub fn beam_on_flat(nodes: usize, law: &str, friction: Option<f64>) -> String {
    let length = nodes as f64;
    let rough = friction.map_or(String::new(), |mu| format!("*FRICTION\n{mu:?}\n"));
    let mut deck = format!(
        "{}{MATERIAL}*NODE, NSET=REF\n9000000, 0.0, -1.0\n\
         *SURFACE, NAME=FLAT, TYPE=SEGMENTS\nSTART, {:?}, 0.0\nLINE, {:?}, 0.0\n\
         *RIGID BODY, REF NODE=9000000, ANALYTICAL SURFACE=FLAT\n\
         *SURFACE, NAME=UNDER, TYPE=ELEMENT\nBEAM, SNEG\n*SURFACE INTERACTION, NAME=TOUCH\n\
         10.0\n{rough}{law}\n\
         *CONTACT PAIR, INTERACTION=TOUCH, TYPE=NODE TO SURFACE, NO THICKNESS\nUNDER, FLAT\n\
         *STEP, NLGEOM, INC=400\n*STATIC\n0.2, 1.0, 1.0E-6, 0.2\n*BOUNDARY\n1, 1\n\
         9000000, 1\n9000000, 6\n9000000, 2, 2\n*CLOAD\nBEAM, 2, -20.0\n\
         *NODE PRINT, NSET=REF\nRF\n*END STEP\n",
        beam("BEAM", 1, nodes, [0.0, 0.0]),
        -length,
        2.0 * length,
    );
    if friction.is_some() {
        deck.push_str(
            "*STEP, NLGEOM, INC=400\n*STATIC\n0.2, 1.0, 1.0E-6, 0.2\n*BOUNDARY\n\
             9000000, 1, 1, 0.5\n*END STEP\n",
        );
    }
    deck
}

/// A beam of `nodes` nodes loaded onto another one of as many, with friction.
pub fn beam_on_beam(nodes: usize) -> String {
    format!(
        "{}{}{MATERIAL}*SURFACE, NAME=ABOVE, TYPE=ELEMENT\nUPPER, SNEG\n\
         *SURFACE, NAME=BELOW, TYPE=ELEMENT\nLOWER, SPOS\n*SURFACE INTERACTION, NAME=TOUCH\n\
         10.0\n*FRICTION\n0.2\n{SOFT}\n\
         *CONTACT PAIR, INTERACTION=TOUCH, TYPE=NODE TO SURFACE, SMOOTH=0.2\nABOVE, BELOW\n\
         *STEP, NLGEOM, INC=400\n*STATIC\n0.2, 1.0, 1.0E-6, 0.2\n*BOUNDARY\n1, 1, 6\n\
         1000001, 1, 6\nLOWER, 2\n*CLOAD\nUPPER, 2, -20.0\n*END STEP\n",
        beam("UPPER", 1, nodes, [0.0, 0.01]),
        beam("LOWER", 1_000_001, nodes, [-0.3, 0.0]),
    )
}
