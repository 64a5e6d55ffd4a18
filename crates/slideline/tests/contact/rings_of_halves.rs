//! Rings of two halves that are joined at both seams are rings.
//!
//! ```text
//!        .-----.
//!      s'  .-.  's      the halves of the ring meet at s; the shaft in it is one part
//!      |  (   )  |
//!       '.  '  .'
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::two_blocks::solved;
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Elements around, and of one half.
const AROUND: usize = 12;
const HALF: usize = AROUND / 2;

/// A ring of one row of elements: its first number and its radii [L].
struct Ring {
    name: &'static str,
    first: usize,
    radii: [f64; 2],
    halves: bool,
}

impl Ring {
    /// Node at a corner of an element: nodes of the second half at both seams are its own.
    fn node(&self, out: usize, element: usize, end: usize) -> usize {
        let own = element + end;
        let seam = self.halves && element >= HALF && own.is_multiple_of(HALF);
        self.first + 100 * out + own % AROUND + if seam { 50 } else { 0 }
    }

    /// Nodes, elements, the face `side` of all of them, and the nodes `held` at one radius.
    fn write(&self, deck: &mut String, side: &str, held: usize) {
        let Self { name, first, radii, .. } = self;
        let mut nodes = std::collections::BTreeMap::new();
        let (mut elements, mut faces) = (String::new(), String::new());
        for own in 0..AROUND {
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
            let _ = write!(elements, "{}", first + own);
            for (out, end) in corners {
                let angle = 0.3 + TAU * (own + end) as f64 / AROUND as f64;
                let node = self.node(out, own, end);
                nodes.insert(node, (out, [radii[out] * angle.cos(), radii[out] * angle.sin()]));
                let _ = write!(elements, ", {node}");
            }
            elements.push('\n');
            let _ = writeln!(faces, "{}, {side}", first + own);
        }
        let (mut places, mut set) = (String::new(), String::new());
        for (node, (out, [x, y])) in &nodes {
            let _ = writeln!(places, "{node}, {x:?}, {y:?}");
            if *out == held {
                let _ = writeln!(set, "{node}");
            }
        }
        let _ = write!(
            deck,
            "*NODE\n{places}*NSET, NSET={name}-HELD\n{set}*ELEMENT, TYPE=CPE4, ELSET={name}\n{elements}\
             *SOLID SECTION, ELSET={name}, MATERIAL=M\n1.\n*SURFACE, NAME={name}\n{faces}"
        );
        if self.halves {
            // both seams, each between the elements before and behind it
            for (seam, before) in [HALF - 1, AROUND - 1].into_iter().enumerate() {
                let behind = (before + 1) % AROUND;
                let _ = write!(
                    deck,
                    "*SURFACE, NAME={name}-M{seam}\n{}, S3\n*SURFACE, NAME={name}-S{seam}\n{}, S1\n*TIE, \
                     NAME={name}-T{seam}\n{name}-S{seam}, {name}-M{seam}\n",
                    first + before,
                    first + behind
                );
            }
        }
    }
}

/// The shaft overlaps its ring and is pushed aside.
fn deck(halves: [bool; 2], slave: &str, kind: &str) -> String {
    let mut deck = String::from("*HEADING\nrings\n");
    let ring = Ring { name: "RING", first: 1000, radii: [1.0, 1.5], halves: halves[0] };
    ring.write(&mut deck, "S4", 1);
    let shaft = Ring { name: "SHAFT", first: 5000, radii: [0.4, 1.005], halves: halves[1] };
    shaft.write(&mut deck, "S2", 0);
    let master = if slave == "RING" { "SHAFT" } else { "RING" };
    deck + &format!(
        "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, \
         TYPE={kind} TO SURFACE\n{slave}, {master}\n*STEP, NLGEOM\n*STATIC\n0.5, 1.\n*CONTROLS, \
         PARAMETERS=FIELD\n1e-10\n*BOUNDARY\nRING-HELD, 1, 2\nSHAFT-HELD, 1, 2\nSHAFT-HELD, 1, 1, 0.02\n\
         SHAFT-HELD, 2, 2, 0.01\n*END STEP\n"
    )
}

/// Requirement: rings of halves, as slave and as master, at nodes and over faces, have the forces of whole ones;
/// as masters of nodes they were refused (SL0329). Tolerance: what iterations leave.
#[test]
fn two_halves_are_a_ring() {
    for (slave, kind) in
        ["RING", "SHAFT"].into_iter().flat_map(|own| ["NODE", "SURFACE"].map(|kind| (own, kind)))
    {
        let whole = solved(&deck([false; 2], slave, kind)).force;
        let most = whole.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
        assert!(most > 1.0, "{whole:?}");
        for halves in [[true, false], [false, true], [true, true]] {
            let own = solved(&deck(halves, slave, kind)).force;
            for (a, b) in own.iter().flatten().zip(whole.iter().flatten()) {
                assert!((a - b).abs() < 1e-7 * most, "{slave} {kind} {halves:?} {a} {b}");
            }
        }
    }
}
