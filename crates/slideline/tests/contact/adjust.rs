//! `ADJUST`: slave nodes begin on the master, without strain.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::ops::ControlFlow;

/// A block whose underside is rough, over a rigid cylinder or plane.
fn block(adjust: &str, ground: &str) -> String {
    format!(
        "*NODE
1, -1.0, 0.004
2, 0.0, -0.003
3, 1.0, 0.0
4, 2.0, 0.3
11, -1.0, 1.0
12, 0.0, 1.0
13, 1.0, 1.0
14, 2.0, 1.0
99, 0.0, -5.0
*NSET, NSET=ALL
1, 2, 3, 4, 11, 12, 13, 14
*NSET, NSET=SOME
1, 4
*ELEMENT, TYPE=CPE4, ELSET=BLOCK
1, 1, 2, 12, 11
2, 2, 3, 13, 12
3, 3, 4, 14, 13
*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*SOLID SECTION, ELSET=BLOCK, MATERIAL=M
1.0
*SURFACE, NAME=UNDERSIDE
BLOCK, S1
*SURFACE, NAME=GROUND, TYPE=SEGMENTS
{ground}
*RIGID BODY, ANALYTICAL SURFACE=GROUND, REF NODE=99
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE{adjust}
UNDERSIDE, GROUND
*BOUNDARY
99, 1, 6
11, 1, 2
14, 1, 2
*STEP
*STATIC
1.0, 1.0
*NODE PRINT
U
*END STEP
"
    )
}

const PLANE: &str = "START, -9.0, 0.0\nLINE, 9.0, 0.0";
const CYLINDER: &str = "START, -5.0, -5.0\nCIRCL, 0.0, 0.0, 0.0, -5.0\nCIRCL, 5.0, -5.0, 0.0, -5.0";

/// Places of the nodes of the underside, and what was said with the code of adjusted nodes.
fn underside(deck: &str) -> (Vec<[f64; 3]>, Vec<String>) {
    let read = Job::read_text("block", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let at = |label| model.nodes.position(model.nodes.find(label).unwrap());
    let said = read.diagnostics.iter().filter(|said| said.code.0 == "SL0417");
    ((1..=4).map(at).collect(), said.map(|said| said.message.clone()).collect())
}

/// Requirement: nodes that overlap and nodes within the distance are moved onto the master, straight
/// or round; nodes further away are not; one note says how many and how far.
#[test]
fn nodes_near_the_master_are_moved_onto_it() {
    let (places, said) = underside(&block(", ADJUST=0.01", PLANE));
    let heights: Vec<f64> = places.iter().map(|place| place[1]).collect();
    assert!(heights[..3].iter().all(|z| z.abs() < 1e-14) && heights[3] == 0.3, "{heights:?}");
    assert_eq!(said.len(), 1);
    assert!(
        said[0].contains("moved 2 slave nodes") && said[0].contains("node 1 by 4.0000e-3"),
        "{said:?}"
    );

    let (places, _) = underside(&block(", ADJUST=0.0", PLANE));
    assert_eq!(places[0][1], 0.004);
    assert!(places[1][1].abs() < 1e-14);

    let (places, _) = underside(&block(", ADJUST=0.5", CYLINDER));
    for place in &places[..3] {
        assert!((place[0].hypot(place[1] + 5.0) - 5.0).abs() < 1e-12, "{place:?}");
    }

    let (places, _) = underside(&block(", ADJUST=SOME", PLANE));
    let heights: Vec<f64> = places.iter().map(|place| place[1]).collect();
    assert!(heights[0].abs() < 1e-14 && heights[3].abs() < 1e-14, "{heights:?}");
    assert_eq!(heights[1], -0.003);

    let (places, said) = underside(&block("", PLANE));
    assert!(places[1][1] == -0.003 && said.is_empty());
}

/// Requirement: with *CLEARANCE nodes begin at the gap that is asked for, above the master or within it;
/// what is further from it than half a face stays, and that is said.
#[test]
fn a_clearance_is_the_gap_at_the_start() {
    for value in [0.02, -0.01, 0.0] {
        let card =
            format!("*CLEARANCE, SLAVE=UNDERSIDE, MASTER=GROUND, VALUE={value:?}\n*BOUNDARY");
        let deck = block("", PLANE).replacen("*BOUNDARY", &card, 1);
        let (places, said) = underside(&deck);
        for place in &places {
            assert!((place[1] - value).abs() < 1e-12, "{place:?} beside {value}");
        }
        assert!(said.len() == 1 && said[0].contains("*CLEARANCE moved"), "{said:?}");
    }
    let far = block("", PLANE)
        .replace("*BOUNDARY", "*CLEARANCE, SLAVE=UNDERSIDE, MASTER=GROUND, VALUE=2.0\n*BOUNDARY");
    let read = Job::read_text("block", &far, &ReadOptions::default());
    assert!(read.diagnostics.iter().any(|said| said.code.0 == "SL0418"));
    let (places, _) = underside(&far);
    assert_eq!(places[3][1], 0.3);
}

#[derive(Default)]
struct Largest(f64, f64);

impl Observer for Largest {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let pressures = frame.contact.iter().map(|row| row.pressure);
            self.0 = pressures.fold(self.0, f64::max);
            self.1 = self.1.max(frame.energy.strain_energy);
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: adjusted contact begins without pressure and without strain; what is not adjusted is
/// pressed out with strain.
#[test]
fn an_adjusted_start_has_no_strain() {
    for (adjust, strained) in [(", ADJUST=0.01", false), ("", true)] {
        let read = Job::read_text("block", &block(adjust, PLANE), &ReadOptions::default());
        let mut largest = Largest::default();
        let ending = slideline::solve(&read.model.unwrap(), &SolveOptions::default(), &mut largest);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
        assert_eq!(largest.0 > 1e-9, strained, "{}", largest.0);
        assert_eq!(largest.1 > 1e-12, strained, "{}", largest.1);
    }
}

/// Requirement: in space nodes are moved onto faces, along their normal.
#[test]
fn nodes_in_space_are_moved_onto_faces() {
    let mut deck = String::from("*NODE\n");
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for (base, low, high, size, off) in [(0, -1.0, 0.0, 2.0, -0.5), (10, 0.02, 1.0, 1.0, 0.0)] {
        for (k, z) in [low, high].into_iter().enumerate() {
            for (n, [x, y]) in square.into_iter().enumerate() {
                let rough = if base == 10 && k == 0 { 0.01 * n as f64 } else { 0.0 };
                let (x, y) = (off + size * x, off + size * y);
                deck += &format!("{}, {x:?}, {y:?}, {:?}\n", base + 4 * k + n + 1, z - rough);
            }
        }
    }
    deck += "*ELEMENT, TYPE=C3D8, ELSET=LOWER
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D8, ELSET=UPPER
2, 11, 12, 13, 14, 15, 16, 17, 18
*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*SOLID SECTION, ELSET=LOWER, MATERIAL=M
*SOLID SECTION, ELSET=UPPER, MATERIAL=M
*SURFACE, NAME=DOWN
UPPER, S1
*SURFACE, NAME=UP
LOWER, S2
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE, ADJUST=0.05
DOWN, UP
*BOUNDARY
LOWER, 1, 3
15, 1, 3
16, 1, 3
17, 1, 3
18, 1, 3
*STEP
*STATIC
1.0, 1.0
*END STEP
";
    let deck = deck.replace("LOWER, 1, 3\n", "1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n");
    let read = Job::read_text("blocks", &deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    for label in 11..15 {
        let place = model.nodes.position(model.nodes.find(label).unwrap());
        assert!(place[2].abs() < 1e-13, "{label} {place:?}");
    }
}

/// Requirement: of quadratic faces that contact is spread over every node is moved by its own
/// distance, middle nodes too: with corners 0.004 and middle nodes 0.012 away, 0.02 moves all of
/// them and 0.01 the corners. A clearance too is one of every node: mean gaps alone, brought about by
/// the corners, moved these by several tenths.
#[test]
fn nodes_of_quadratic_faces_are_moved_one_by_one() {
    let placed = |adjust: &str, clearance: &str| -> Vec<f64> {
        let mut deck = String::from(
            "*NODE\n1, -1.0, -1.0, -1.0\n2, 2.0, -1.0, -1.0\n3, 2.0, 2.0, -1.0\n4, -1.0, 2.0, -1.0\n\
             5, -1.0, -1.0, 0.0\n6, 2.0, -1.0, 0.0\n7, 2.0, 2.0, 0.0\n8, -1.0, 2.0, 0.0\n",
        );
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let middle = [[0.5, 0.0], [1.0, 0.5], [0.5, 1.0], [0.0, 0.5]];
        let layers =
            [(square, 0.004), (square, 1.0), (middle, 0.012), (middle, 1.0), (square, 0.5)];
        let all = layers.iter().flat_map(|(places, z)| places.map(|[x, y]| [x, y, *z]));
        for (n, [x, y, z]) in all.enumerate() {
            deck += &format!("{}, {x:?}, {y:?}, {z:?}\n", 11 + n);
        }
        deck += "*ELEMENT, TYPE=C3D8, ELSET=LOWER
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D20, ELSET=UPPER
2, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
21, 22, 23, 24, 25, 26, 27, 28, 29, 30
*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*SOLID SECTION, ELSET=LOWER, MATERIAL=M
*SOLID SECTION, ELSET=UPPER, MATERIAL=M
*SURFACE, NAME=DOWN
UPPER, S1
*SURFACE, NAME=UP
LOWER, S2
*SURFACE INTERACTION, NAME=I
";
        deck += &format!(
            "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE{adjust}\nDOWN, UP\n\
             {clearance}*STEP\n*STATIC\n1.0, 1.0\n*END STEP\n"
        );
        let read = Job::read_text("blocks", &deck, &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let height = |label| model.nodes.position(model.nodes.find(label).unwrap())[2];
        (11..15).chain(19..23).map(height).collect()
    };
    let moved = |distance: &str| placed(&format!(", ADJUST={distance}"), "");
    assert!(moved("0.02").iter().all(|z| z.abs() < 1e-13), "{:?}", moved("0.02"));
    let near = moved("0.01");
    assert!(near[..4].iter().all(|z| z.abs() < 1e-13), "{near:?}");
    assert!(near[4..].iter().all(|z| *z == 0.012), "{near:?}");
    for gap in [0.003, -0.002] {
        let clearance = format!("*CLEARANCE, SLAVE=DOWN, MASTER=UP, VALUE={gap}\n");
        let heights = placed("", &clearance);
        assert!(heights.iter().all(|z| (z - gap).abs() < 1e-13), "{heights:?}");
    }
}
