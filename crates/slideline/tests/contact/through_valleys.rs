//! Parts that meet themselves, and do not: nodes below valleys, in line with one of their faces.
//!
//! ```text
//!        | thick  |        the wall of the thick part, prolonged, ends at a node below: what is behind
//!   _____|        |        the valley for that node is the web, and no overlap
//!   |_web_________|
//!         ^
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// Reaction of the moved face and the force of the pair at the end.
#[derive(Default)]
struct End {
    reaction: f64,
    paired: f64,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let moved = (9001..).map_while(|label| frame.model.nodes.find(label));
            self.reaction = moved.map(|node| frame.nodal.reaction(node, Dof::U2)).sum();
            self.paired = frame.pairs.iter().map(|pair| pair.force[1].abs()).sum();
        }
        ControlFlow::Continue(())
    }
}

/// Columns of so many layers, in cells of one size; the left end is held, the right end moved up. The pair is the outside with itself, or there is none.
fn deck(kind: &str, layers: &[usize], (cell, shift): ([f64; 2], f64), pair: &str) -> String {
    let width = layers.len();
    let height = layers.iter().copied().max().unwrap();
    let label = |i: usize, j: usize| if i == width { 9001 + j } else { 1 + i + (width + 1) * j };
    let full = |i: usize, j: usize| i < width && layers[i] > j;
    let mut text = "*NODE\n".to_owned();
    for j in 0..=height {
        for i in 0..=width {
            let of_cell = |(a, b): (usize, usize)| a <= i && b <= j && full(i - a, j - b);
            if [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter().any(of_cell) {
                // nodes of the lowest row beside the line of the wall
                let aside = if j == 0 && i > 0 && i < width { shift } else { 0.0 };
                let at = [cell[0] * (i as f64 + aside), cell[1] * j as f64];
                writeln!(text, "{}, {}, {}", label(i, j), at[0], at[1]).unwrap();
            }
        }
    }
    writeln!(text, "*ELEMENT, TYPE={kind}, ELSET=ALL").unwrap();
    let cells = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    for (number, (i, j)) in cells.filter(|&(i, j)| full(i, j)).enumerate() {
        let corners = [label(i, j), label(i + 1, j), label(i + 1, j + 1), label(i, j + 1)];
        writeln!(
            text,
            "{}, {}, {}, {}, {}",
            number + 1,
            corners[0],
            corners[1],
            corners[2],
            corners[3]
        )
        .unwrap();
    }
    let (held, moved): (String, String) = (
        (0..=layers[0]).map(|j| format!("{}, 1, 2\n", label(0, j))).collect(),
        (0..=layers[width - 1])
            .map(|j| format!("{}, 2, 2, {}\n", label(width, j), 0.03 * cell[1]))
            .collect(),
    );
    write!(
        text,
        "*SURFACE, NAME=OUTSIDE\nALL\n*SOLID SECTION, ELSET=ALL, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n\
         *ELASTIC\n200., .4\n*SURFACE INTERACTION, NAME=I\n{pair}*BOUNDARY\n{held}*STEP, NLGEOM\n*STATIC\n\
         1., 1.\n*BOUNDARY\n{moved}*END STEP\n"
    )
    .unwrap();
    text
}

fn end(deck: &str) -> End {
    let read = Job::read_text("valley", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}\n{deck}", read.diagnostics));
    let mut end = End::default();
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    end
}

/// Requirement: steps, L, T and thin webs that meet themselves and touch nowhere are as stiff as those that do not,
/// and no force is between them, wherever the nodes below the valleys stand. Source: the deck without the pair.
#[test]
fn a_part_without_stress_does_not_meet_itself() {
    let pairs = [
        "*CONTACT PAIR, INTERACTION=I\nOUTSIDE,\n",
        "*CONTACT PAIR, INTERACTION=I, SMOOTH=0.\nOUTSIDE,\n",
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n",
    ];
    let shapes: [&[usize]; 4] = [
        &[1, 1, 1, 1, 1, 1, 4, 4, 4],
        &[4, 4, 1, 1, 1, 4, 4],
        &[1, 1, 3, 3, 1, 1],
        &[1, 2, 3, 5, 5],
    ];
    for kind in ["CPE4", "CAX4", "CPS4I"] {
        for shape in shapes {
            for shift in [0.0, 0.04, -0.04] {
                let at = ([0.5, 0.3], shift);
                let free = end(&deck(kind, shape, at, ""));
                for pair in pairs {
                    let own = end(&deck(kind, shape, at, pair));
                    assert_eq!(own.paired, 0.0, "{kind} {shape:?} {shift} {pair}");
                    let apart = (own.reaction - free.reaction).abs();
                    assert!(apart < 1e-9 * free.reaction.abs(), "{kind} {shape:?} {shift} {pair}");
                }
            }
        }
    }
}
