//! Who carries the points in general contact: the side whose nodes stand closer together.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Job, ReadOptions};
use std::fmt::Write;

/// Bricks in a row along x, C3D8 or C3D20, from a corner: `(name, first number, type)`.
struct Row {
    name: &'static str,
    base: usize,
    element: &'static str,
    count: usize,
    length: f64,
    /// From and to along y, and along z.
    across: [[f64; 2]; 2],
}

impl Row {
    fn write(&self, deck: &mut String) {
        let [[y0, y1], [z0, z1]] = self.across;
        let corner = |i: usize, k: usize| {
            let [y, z] = [(y0, z0), (y1, z0), (y1, z1), (y0, z1)].map(|(y, z)| [y, z])[k];
            ([self.length * i as f64, y, z], self.base + 4 * i + k + 1)
        };
        let mut middles = 0;
        deck.push_str("*NODE\n");
        for (at, label) in (0..=self.count).flat_map(|i| (0..4).map(move |k| corner(i, k))) {
            writeln!(deck, "{label}, {:?}, {:?}, {:?}", at[0], at[1], at[2]).unwrap();
        }
        let mut elements = String::new();
        for i in 0..self.count {
            let places = [(i, 0), (i + 1, 0), (i + 1, 1), (i, 1), (i, 3), (i + 1, 3), (i + 1, 2)];
            let nodes: Vec<_> =
                places.into_iter().chain([(i, 2)]).map(|(i, k)| corner(i, k)).collect();
            let mut labels: Vec<usize> = nodes.iter().map(|(_, label)| *label).collect();
            if self.element == "C3D20" {
                let ends = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)];
                for (a, b) in ends.into_iter().chain((0..4).map(|k| (k, k + 4))) {
                    middles += 1;
                    let at = [0, 1, 2].map(|c| 0.5 * (nodes[a].0[c] + nodes[b].0[c]));
                    let label = self.base + 500 + middles;
                    writeln!(deck, "{label}, {:?}, {:?}, {:?}", at[0], at[1], at[2]).unwrap();
                    labels.push(label);
                }
            }
            let labels: Vec<String> = labels.iter().map(usize::to_string).collect();
            let (first, rest) = labels.split_at(8);
            let own = self.base + i + 1;
            write!(elements, "{own}, {}", first.join(", ")).unwrap();
            let rest =
                if rest.is_empty() { String::new() } else { format!(",\n{}", rest.join(", ")) };
            elements.push_str(&rest);
            elements.push('\n');
        }
        writeln!(deck, "*ELEMENT, TYPE={}, ELSET={}\n{elements}", self.element, self.name).unwrap();
        writeln!(deck, "*SOLID SECTION, ELSET={}, MATERIAL=M", self.name).unwrap();
    }
}

/// What general contact of two rows says about roles, in either order of their cards.
fn said(rows: [&Row; 2], inclusions: &str) -> String {
    let mut deck = String::from("*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n");
    for row in rows {
        row.write(&mut deck);
    }
    deck.push_str("*SURFACE, NAME=UNDER\nUPPER, S1\n*SURFACE, NAME=OVER\nLOWER, S2\n");
    write!(deck, "*CONTACT\n*CONTACT INCLUSIONS{inclusions}\n*STEP, NLGEOM\n*STATIC\n1., 1.\n")
        .unwrap();
    deck.push_str("*BOUNDARY\n1, 1, 3\n*END STEP\n");
    let read = Job::read_text("roles", &deck, &ReadOptions::default());
    let roles = read.diagnostics.iter().find(|said| said.code.0 == "SL0395");
    roles.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics)).message.clone()
}

fn lower() -> Row {
    let across = [[0.0, 0.75], [-0.7, 0.0]];
    Row { name: "LOWER", base: 1000, element: "C3D8", count: 4, length: 0.75, across }
}

/// Requirement: middle nodes count, for they carry contact too: bricks of twenty nodes of length 1
/// are slaves of bricks of eight nodes of length 0.75, whichever come first in the deck.
#[test]
fn middle_nodes_make_a_mesh_finer() {
    let across = [[0.0, 1.0], [0.0, 1.0]];
    let upper = Row { name: "UPPER", base: 0, element: "C3D20", count: 2, length: 1.0, across };
    for rows in [[&upper, &lower()], [&lower(), &upper]] {
        for inclusions in [", ALL EXTERIOR", "\nUNDER, OVER"] {
            let said = said(rows, inclusions);
            assert!(said.contains("UPPER on LOWER"), "{said}");
        }
    }
}

/// Requirement: of surfaces that are named their own faces count, not the rest of the part: a tall
/// block with a fine foot is the slave.
#[test]
fn faces_that_may_meet_decide() {
    let across = [[0.0, 0.5], [0.0, 9.0]];
    let upper = Row { name: "UPPER", base: 0, element: "C3D8", count: 4, length: 0.5, across };
    for rows in [[&upper, &lower()], [&lower(), &upper]] {
        let said = said(rows, "\nUNDER, OVER");
        assert!(said.contains("UPPER on LOWER"), "{said}");
    }
}
