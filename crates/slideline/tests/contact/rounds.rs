//! Parts of the plane that are round where they meet, with contact at nodes: rings that are shrunk on, blocks whose
//! joint is curved, and valleys.
//!
//! ```text
//!        .--o--.
//!      o'  .-.  'o      a quarter of two rings, of chords that match or not
//!     /  o'   'o  \
//! ```
//!
//! docs/theory.md section 5.3.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::narrow_masters::told;
use crate::space_decks::{checked, size, solved};
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;

/// Radii of the bore, the joint and the outside, and by how much the rings overlap [L].
const RADII: [f64; 3] = [1.0, 2.0, 3.0];
const OVERLAP: f64 = 0.002;
const MODULUS: f64 = 1000.0;
const POISSON: f64 = 0.3;
/// Elements over the thickness of a ring.
const DEEP: usize = 8;

/// A quarter of a ring of elements CPE4.
struct Ring {
    name: &'static str,
    radii: [f64; 2],
    /// Elements around.
    around: usize,
    /// Its first node and element.
    first: usize,
    /// The face of its elements that meets the other ring, and on which of its two rows of elements.
    face: (&'static str, usize),
}

impl Ring {
    fn node(&self, out: usize, around: usize) -> usize {
        self.first + out * (self.around + 1) + around
    }

    fn element(&self, out: usize, around: usize) -> usize {
        self.first + out * self.around + around
    }

    /// Nodes, elements, surface and supports; turned by an angle, in other units.
    fn write(&self, deck: &mut String, (angle, unit): (f64, f64)) {
        let Self { name, radii: [from, to], around, face, .. } = self;
        deck.push_str("*NODE\n");
        for (i, j) in (0..=DEEP).flat_map(|i| (0..=*around).map(move |j| (i, j))) {
            let r = unit * (from + (to - from) * i as f64 / DEEP as f64);
            let (s, c) = (angle + FRAC_PI_2 * j as f64 / *around as f64).sin_cos();
            let _ = writeln!(deck, "{}, {:?}, {:?}", self.node(i, j), r * c, r * s);
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={name}");
        for (i, j) in (0..DEEP).flat_map(|i| (0..*around).map(move |j| (i, j))) {
            let nodes =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| self.node(i, j));
            let nodes = nodes.map(|node| node.to_string()).join(", ");
            let _ = writeln!(deck, "{}, {nodes}", self.element(i, j));
        }
        let _ = writeln!(deck, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n{unit:?}");
        let _ = writeln!(deck, "*SURFACE, NAME={name}");
        for j in 0..*around {
            let _ = writeln!(deck, "{}, {}", self.element(face.1, j), face.0);
        }
        for (end, j) in [("AT0", 0), ("AT90", *around)] {
            let _ = writeln!(deck, "*NSET, NSET={name}-{end}");
            (0..=DEEP).for_each(|i| {
                let _ = writeln!(deck, "{}", self.node(i, j));
            });
        }
    }
}

/// A shrink fit of rings with so many chords a quarter, the slave named.
fn fit([inner, outer]: [usize; 2], slave: &str, (angle, unit): (f64, f64)) -> String {
    let [a, b, c] = RADII;
    let rings = [
        Ring {
            name: "INNER",
            radii: [a, b + 0.5 * OVERLAP],
            around: inner,
            first: 1,
            face: ("S2", DEEP - 1),
        },
        Ring {
            name: "OUTER",
            radii: [b - 0.5 * OVERLAP, c],
            around: outer,
            first: 10_001,
            face: ("S4", 0),
        },
    ];
    let mut deck = String::from("*HEADING\nshrink fit\n");
    rings.iter().for_each(|ring| ring.write(&mut deck, (angle, unit)));
    let master = if slave == "INNER" { "OUTER" } else { "INNER" };
    let (s, c) = angle.sin_cos();
    let modulus = MODULUS / (unit * unit);
    let _ = write!(
        deck,
        "*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, {POISSON}\n*SURFACE INTERACTION, NAME=I\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n{slave}, {master}\n"
    );
    for name in ["INNER", "OUTER"] {
        for end in ["AT0", "AT90"] {
            let _ = writeln!(
                deck,
                "*TRANSFORM, NSET={name}-{end}\n{c:?}, {s:?}, 0., {:?}, {c:?}, 0.",
                -s
            );
        }
    }
    deck + "*BOUNDARY\nINNER-AT0, 2\nOUTER-AT0, 2\nINNER-AT90, 1\nOUTER-AT90, 1\n\
            *STEP\n*STATIC\n1.0, 1.0\n*END STEP\n"
}

/// The force on a quarter by Lame's thick rings in plane strain: p b sqrt 2.
fn by_lame() -> f64 {
    let [a, b, c] = RADII.map(|r| r * r);
    let modulus = MODULUS / (1.0 - POISSON * POISSON);
    let pressure = modulus * OVERLAP / RADII[1] * (b - a) * (c - b) / (2.0 * b * (c - a));
    pressure * RADII[1] * f64::sqrt(2.0)
}

/// Requirement: the force of a shrink fit is Lame's, whether chords match or not, whichever ring is the slave: within
/// what elements of that size are off (contact over faces: 0.988 with 6, 0.998 with 12 a quarter). With corners cut by
/// parabolas it was 0.3 to 4.3 times as large.
#[test]
fn shrink_fits_of_chords_have_the_force_of_rings() {
    let whole = by_lame();
    for (chords, off) in [([6, 6], 0.015), ([12, 12], 0.004), ([8, 13], 0.03), ([24, 17], 0.003)] {
        for slave in ["INNER", "OUTER"] {
            let deck = fit(chords, slave, (0.0, 1.0));
            let force = size(solved(&deck).force());
            assert!((force / whole - 1.0).abs() < off, "{chords:?} {slave}: {}", force / whole);
            let said = told(&format!("fit_{}_{}_{slave}", chords[0], chords[1]), &deck);
            assert!(!said.iter().any(|code| code == "SL0621" || code == "SL0622"), "{said:?}");
        }
    }
}

/// Requirement: the same turned, in other units: to 1e-9.
#[test]
fn a_shrink_fit_is_the_same_turned_and_in_other_units() {
    let force = |place| size(solved(&fit([8, 11], "OUTER", place)).force());
    let (here, there) = (force((0.0, 1.0)), force((0.7, 1e3)));
    assert!((here / there - 1.0).abs() < 1e-9, "{here} {there}");
}

/// Two whole rings of so many chords, one shrunk on the other, whose bore turns against the outside by 0.3 in six
/// increments; the slave named.
fn turning_rings([inner, outer]: [usize; 2], slave: &str) -> String {
    let [a, b, c] = RADII;
    let mut deck = String::from("*HEADING\nturning rings\n");
    let rings = [
        ("INNER", inner, 1, [a, b + 0.5 * OVERLAP], ("S2", DEEP - 1)),
        ("OUTER", outer, 10_001, [b - 0.5 * OVERLAP, c], ("S4", 0)),
    ];
    for (name, around, first, [from, to], (face, row)) in rings {
        let node = |i: usize, j: usize| first + i * around + j % around;
        deck.push_str("*NODE\n");
        for (i, j) in (0..=DEEP).flat_map(|i| (0..around).map(move |j| (i, j))) {
            let r = from + (to - from) * i as f64 / DEEP as f64;
            let (s, c) = (4.0 * FRAC_PI_2 * j as f64 / around as f64).sin_cos();
            let _ = writeln!(deck, "{}, {:?}, {:?}", node(i, j), r * c, r * s);
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={name}");
        for (i, j) in (0..DEEP).flat_map(|i| (0..around).map(move |j| (i, j))) {
            let nodes = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| node(i, j));
            let nodes = nodes.map(|node| node.to_string()).join(", ");
            let _ = writeln!(deck, "{}, {nodes}", first + i * around + j);
        }
        let _ =
            writeln!(deck, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.0\n*SURFACE, NAME={name}");
        (0..around).for_each(|j| {
            let _ = writeln!(deck, "{}, {face}", first + row * around + j);
        });
        let side = if name == "INNER" { node(0, 0) } else { node(DEEP, 0) };
        let _ = writeln!(deck, "*NSET, NSET={name}-HELD, GENERATE\n{side}, {}", side + around - 1);
    }
    let master = if slave == "INNER" { "OUTER" } else { "INNER" };
    deck + &format!(
        "*NODE\n99999, 0.0, 0.0\n*RIGID BODY, REF NODE=99999, TIE NSET=INNER-HELD\n\
         *MATERIAL, NAME=M\n*ELASTIC\n{MODULUS}, {POISSON}\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.1\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n{slave}, {master}\n*BOUNDARY\nOUTER-HELD, 1, 2\n\
         99999, 1, 2\n*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n99999, 6\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 0.6, , 0.1\n*BOUNDARY\n99999, 6, 6, 0.3\n*END STEP\n"
    )
}

/// Requirement: a ring that turns in another one is rubbed by mu times its pressure all round, over the seam of the
/// master too: all nodes are closed and slip, with the friction of their pressures, and both roles have one pressure.
/// At the seam a node faced nothing, or had slipped all round; 1 to 16 nodes of 32 carried the ring.
#[test]
fn rings_turn_in_one_another_over_their_seam() {
    let mean = |slave: &str| {
        let last = solved(&turning_rings([32, 44], slave));
        let nodes = if slave == "INNER" { 32 } else { 44 };
        let closed: Vec<_> = last.contact.iter().filter(|row| row.pressure > 0.0).collect();
        assert_eq!(closed.len(), nodes, "{slave}");
        for row in &closed {
            let rubbed = row.shear.0[0].abs() / row.pressure;
            assert!((rubbed - 0.1).abs() < 1e-6, "{slave}: {rubbed} at {}", row.node);
        }
        closed.iter().map(|row| row.pressure).sum::<f64>() / nodes as f64
    };
    let [inner, outer] = ["INNER", "OUTER"].map(mean);
    assert!((inner / outer - 1.0).abs() < 0.03, "{inner} {outer}");
}

/// Two blocks of five elements, as high as 1, that meet along a parabola which rises by `rise`; pressed by a fiftieth
/// and drawn along by as much.
fn curved_joint(rise: f64, (also, friction): (&str, &str)) -> String {
    let mut deck = String::from("*HEADING\ncurved joint\n");
    for (name, first, [low, high]) in [("LOWER", 1, [-1.0, 0.0]), ("UPPER", 101, [0.0, 1.0])] {
        deck.push_str("*NODE\n");
        for (row, i) in (0..3).flat_map(|row| (0..6).map(move |i| (row, i))) {
            let (x, part) = (f64::from(i), 0.5 * f64::from(row));
            let joint = rise * 4.0 * x * (5.0 - x) / 25.0;
            let (low, high) = if low == 0.0 { (joint, high) } else { (low, joint) };
            let y = low + (high - low) * part;
            let _ = writeln!(deck, "{}, {x:?}, {y:?}", first + 6 * row + i);
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={name}");
        for (row, i) in (0..2).flat_map(|row| (0..5).map(move |i| (row, i))) {
            let node = first + 6 * row + i;
            let _ = writeln!(
                deck,
                "{}, {node}, {}, {}, {}",
                first + 5 * row + i,
                node + 1,
                node + 7,
                node + 6
            );
        }
        let _ = writeln!(deck, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.0");
    }
    let faces = |from: usize, face: &str| -> String {
        (from..from + 5).map(|element| format!("{element}, {face}\n")).collect()
    };
    let (top, bottom) = (faces(6, "S3"), faces(101, "S1"));
    let _ = write!(
        deck,
        "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n*SURFACE, NAME=TOP\n{top}*SURFACE, NAME=BOTTOM\n{bottom}\
         *SURFACE INTERACTION, NAME=I\n{friction}*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE{also}\nBOTTOM, TOP\n\
         *NSET, NSET=HELD, GENERATE\n1, 6\n*NSET, NSET=MOVED, GENERATE\n113, 118\n*BOUNDARY\nHELD, 1, 2\n\
         *STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*BOUNDARY\nMOVED, 1, 1, 0.0\nMOVED, 2, 2, -0.02\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*BOUNDARY\nMOVED, 1, 1, 0.02\nMOVED, 2, 2, -0.02\n*END STEP\n"
    );
    deck
}

/// Requirement: nodes that stand on nodes of a master that hills or hollows carry what one body would, whichever way it is
/// drawn: with the master as it is (`SMOOTH=0`) and through its nodes the forces agree to 5 %, hollows hold nodes without
/// friction and with it, and no attempt is given up. Without smoothing a third of such decks found no end; with parabolas
/// the force was off by up to 2.5 times.
#[test]
fn curved_joints_of_matching_meshes_hold() {
    for rise in [-0.3, 0.3] {
        for friction in ["", "*FRICTION\n0.2\n"] {
            let [drawn, through] =
                [", SMOOTH=0", ""].map(|also| solved(&curved_joint(rise, (also, friction))));
            for last in [&drawn, &through] {
                assert!(last.worst < 1e-9, "{}", last.worst);
            }
            assert_eq!(through.given_up, 0, "{rise} {friction}");
            let pressed = [&drawn, &through].map(|last| last.forces[3][1]);
            assert!((pressed[0] / pressed[1] - 1.0).abs() < 0.05, "{rise} {friction}: {pressed:?}");
        }
    }
}

/// Requirement: the tangent of curves through nodes, of their ends and of rounded valleys is that of differences.
#[test]
fn tangents_are_those_of_differences() {
    for (rise, also) in [(0.3, ""), (-0.3, ""), (-0.3, ", SMOOTH=0")] {
        let last = checked(&curved_joint(rise, (also, "*FRICTION\n0.2\n")));
        assert!(last.off < 1e-5, "{rise} {also}: {} {}", last.off, last.told);
    }
}

/// A tip that comes down beside the bottom of a valley between two faces.
const TIP: &str = "*HEADING\na tip in the valley between two faces\n*NODE\n1, -2., -2.\n2, 0., -2.\n3, 2., -2.\n\
4, -2., 1.\n5, 0., 0.\n6, 2., 1.\n11, 0.02, 0.1\n12, 0.5, 1.1\n13, -0.5, 1.1\n*ELEMENT, TYPE=CPE4, ELSET=BED\n\
1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*ELEMENT, TYPE=CPE3, ELSET=TIP\n11, 11, 12, 13\n*SOLID SECTION, ELSET=BED, MATERIAL=M\n\
1.,\n*SOLID SECTION, ELSET=TIP, MATERIAL=M\n1.,\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=VALLEY\n\
1, S3\n2, S3\n*SURFACE, NAME=POINT\n11, S1\n11, S3\n*SURFACE INTERACTION, NAME=I\n\
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nPOINT, VALLEY\n*NSET, NSET=LOWER\n1, 2, 3\n*NSET, NSET=UPPER\n\
12, 13\n*BOUNDARY\nLOWER, 1, 2\nUPPER, 1\n*STEP, NLGEOM\n*STATIC\n0.1, 1.0\n*BOUNDARY\nUPPER, 2, 2, -0.3\n*END STEP\n";

/// Requirement: a tip is held by both flanks of a valley, even or not; neither alone holds it. Its bottom is rounded, by
/// 0.0025 of a segment in a fifth of which the tip is pressed.
#[test]
fn a_tip_in_a_valley_is_held_by_both_flanks() {
    for far in ["6, 2., 1.", "6, 2., 0.5"] {
        let deck = TIP.replace("6, 2., 1.", far);
        let last = solved(&deck);
        let bare = solved(&deck.replace("TO SURFACE\n", "TO SURFACE, SMOOTH=0\n"));
        let [held, other] = [&last, &bare].map(|last| last.force());
        assert!(held[1] > 10.0 && (held[1] / other[1] - 1.0).abs() < 0.025, "{held:?} {other:?}");
        assert!(last.given_up <= 2, "{}", last.given_up);
    }
}
