//! Contact between sides that equations, links or rigid bodies join, all of them or in part.
//!
//! ```text
//!    +----+----+----+
//!    o    o    |    |       joined at the first nodes: contact there would act on nothing, and must
//!    +----+----+----+       hold beside them
//! ```
//!
//! docs/theory.md section 8.3

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::plane_blocks::{GENERAL, MATERIAL, block, step};
use crate::space_decks::solved;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// All displacements at the end of a run.
struct End(Vec<f64>);

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.0 = frame.nodal.all().map(|(_, _, [own, ..])| own).collect();
        }
        ControlFlow::Continue(())
    }
}

fn displacements(deck: &str) -> Vec<f64> {
    let read = Job::read_text("joined", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}\n{deck}", read.diagnostics));
    let mut end = End(Vec::new());
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    end.0
}

/// Requirement: contact between nodes that are one already, by *MPC, *EQUATION or a rigid body, does nothing, pressed or pulled.
/// Source: the same strips without contact. Tolerance: 1e-9. Contact had forces of 1e12, or SL0501.
#[test]
fn joined_sides_do_not_touch() {
    let pairs: Vec<[usize; 2]> = (0..5).map(|k| [1001 + k, 11 + k]).collect();
    let mpc = |kind: &str| {
        let lines = pairs.iter().map(|[a, b]| format!("{kind}, {a}, {b}\n"));
        format!("*MPC\n{}", lines.collect::<String>())
    };
    let equations: String = pairs
        .iter()
        .flat_map(|[a, b]| {
            [1, 2].map(|dof| format!("*EQUATION\n2\n{a}, {dof}, 1., {b}, {dof}, -1.\n"))
        })
        .collect();
    let rigid = "*NODE\n9000, 0., 1.\n*NSET, NSET=SEAM, GENERATE\n11, 15\n1001, 1005\n*RIGID BODY, REF NODE=9000, TIE NSET=SEAM\n";
    for join in [mpc("TIE"), mpc("PIN"), equations, rigid.to_owned()] {
        for way in [-0.01, 0.01_f64] {
            let ends = [false, true].map(|contact| {
                let mut text = "*HEADING\njoined\n".to_owned();
                block(&mut text, ("LOW", 1), [4, 2], [[-2.0, -1.0], [2.0, 1.0]]);
                block(&mut text, ("UP", 1001), [4, 2], [[-2.0, 1.0], [2.0, 3.0]]);
                text += "*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n";
                text += &join;
                if contact {
                    text += "*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n";
                    text += GENERAL;
                }
                let _ = write!(
                    text,
                    "*NSET, NSET=BASE, GENERATE\n1, 5\n*NSET, NSET=TOP, GENERATE\n1011, 1015\n*BOUNDARY\nBASE, 1, 2\n\
                     *STEP, NLGEOM\n*STATIC\n.5, 1.\n*BOUNDARY\nTOP, 1, 1\nTOP, 2, 2, {way:?}\n*END STEP\n"
                );
                displacements(&text)
            });
            let [alone, contact] = &ends;
            let off = alone.iter().zip(contact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9 * way.abs(), "{way} {off}: {join}");
        }
    }
}

/// Requirement: sides that are joined at the first nodes press one another beyond the last of these, and not there: the force is that
/// of the length that is left, with half of the face beside the joint or all of it: 2.5 to 3 of 4. Source: the same sides without a
/// joint. The last joined node carried 12.9 where 2.4 is right, the next one nothing, and all 1.7 times the whole.
#[test]
fn sides_that_are_joined_in_part_press_beside_that() {
    let force = |join: &str, contact: &str| {
        let mut text = "*HEADING\nseam\n".to_owned();
        block(&mut text, ("LOW", 1), [4, 2], [[-2.0, -1.0], [2.0, 1.0]]);
        block(&mut text, ("UP", 1001), [4, 2], [[-2.0, 1.0], [2.0, 3.0]]);
        text += MATERIAL;
        let _ = write!(
            text,
            "{join}{contact}*NSET, NSET=BASE, GENERATE\n1, 5\n*NSET, NSET=TOP, GENERATE\n1011, 1015\n*BOUNDARY\nBASE, 1, 2\n{}",
            step(2, "*BOUNDARY\nTOP, 1, 1\nTOP, 2, 2, -0.01\n")
        );
        solved(&text).force()[1].abs()
    };
    let tied = "*MPC\nTIE, 1001, 11\nTIE, 1002, 12\n";
    let equations = [1, 2].map(|dof| {
        format!("*EQUATION\n2\n1001, {dof}, 1., 11, {dof}, -1.\n*EQUATION\n2\n1002, {dof}, 1., 12, {dof}, -1.\n")
    });
    let pair = |kind: &str| {
        format!(
            "*SURFACE, NAME=A\nLOW,\n*SURFACE, NAME=B\nUP,\n*CONTACT PAIR, INTERACTION=I, TYPE={kind} TO SURFACE\nA, B\n"
        )
    };
    for contact in [GENERAL.to_owned(), pair("SURFACE"), pair("NODE")] {
        let whole = force("", &contact);
        for join in [tied.to_owned(), equations.concat()] {
            let own = force(&join, &contact);
            let part = own / whole;
            assert!(part > 2.5 / 4.0 - 0.01 && part < 3.0 / 4.0, "{own} {whole}: {join}{contact}");
        }
    }
}

/// Requirement: slave nodes that equations put upon faces of the master, at nodes of it and between, carry nothing: what is left of a
/// load of 10 on a width of 1 goes through the rest. Source: areas of the other nodes, 5/8 at nodes, and with half or all of the face
/// beside the joint. One of them carried 13.3, so that the equations pulled.
#[test]
fn nodes_that_follow_their_master_carry_nothing() {
    for kind in ["SURFACE", "NODE"] {
        for cells in [4, 6, 8] {
            let mut text = "*HEADING\njoined\n".to_owned();
            block(&mut text, ("UP", 1), [4, 2], [[0.0, 0.0], [1.0, 0.5]]);
            block(&mut text, ("LOW", 1001), [cells, 2], [[0.0, -0.5], [1.0, 0.0]]);
            let first = 1001 + 2 * (cells + 1);
            for (node, x) in [(1, 0.0), (2, 0.25 * cells as f64)] {
                let (place, part) = (x as usize, x.fract());
                let (a, b) = (first + place, first + (place + 1).min(cells));
                for dof in [1, 2] {
                    let _ = match part > 0.0 {
                        true => write!(
                            text,
                            "*EQUATION\n3\n{node}, {dof}, 1., {a}, {dof}, {:?}, {b}, {dof}, {:?}\n",
                            part - 1.0,
                            -part
                        ),
                        false => write!(text, "*EQUATION\n2\n{node}, {dof}, 1., {a}, {dof}, -1.\n"),
                    };
                }
            }
            let _ = write!(
                text,
                "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SURFACE INTERACTION, NAME=I\n*SURFACE, NAME=A\nUP,\n*SURFACE, NAME=B\nLOW,\n\
                 *CONTACT PAIR, INTERACTION=I, TYPE={kind} TO SURFACE\nA, B\n*NSET, NSET=GROUND, GENERATE\n1001, {}\n\
                 *BOUNDARY\nGROUND, 2\n1001, 1\n{}",
                1001 + cells,
                // elements of a block have the numbers of their first nodes
                step(1, "*DLOAD\n6, P3, 10.\n7, P3, 10.\n8, P3, 10.\n9, P3, 10.\n")
            );
            let force = solved(&text).force()[1];
            assert!(force > 5.5 && force < 7.5, "{kind} {cells}: {force}");
        }
    }
}
