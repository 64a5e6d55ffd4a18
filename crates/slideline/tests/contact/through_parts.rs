//! What is behind a part is not in it: neither the far side of the master's part, nor a master behind the slave's.
//!
//! ```text
//!        | hub |                  slave
//!     pin|_____|                +-------+
//!        |  x                   +-------+      seen along the normal of the slave's back the nearest face
//!     ___|  a node below             ________  that looks at it is one below its front
//!                                   |
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::noise::{codes, folder, run_in};
use slideline::{Job, ReadOptions, Status};
use std::fmt::Write as _;

const MATERIAL: &str = "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=A, MATERIAL=M\n1.\n\
                        *SURFACE INTERACTION, NAME=I\n1.\n";

/// Nodes of a grid from a number on, row by row, and its elements.
fn grid(first: usize, xs: &[f64], ys: &[f64]) -> [String; 2] {
    let (mut nodes, mut elements) = (String::new(), String::new());
    for (j, y) in ys.iter().enumerate() {
        for (i, x) in xs.iter().enumerate() {
            writeln!(nodes, "{}, {x:?}, {y:?}", first + j * xs.len() + i).unwrap();
        }
    }
    let across = xs.len() - 1;
    for element in 0..across * (ys.len() - 1) {
        let low = first + element / across * xs.len() + element % across;
        let high = low + xs.len();
        writeln!(elements, "{}, {low}, {}, {}, {high}", first + element, low + 1, high + 1)
            .unwrap();
    }
    [nodes, elements]
}

/// A pin that overlaps the bore of a hub and stands out of it at both ends; the hub's surface is its bore, or has its top too.
fn pin_in_a_hub(has_top: bool, adjust: &str) -> String {
    let quarter = |k: i32| 0.25 * f64::from(k);
    let heights = |from: i32, to: i32| (from..=to).map(quarter).collect::<Vec<_>>();
    let [pin, of_pin] = grid(1, &[0.0, 0.5, 1.01], &heights(-2, 6));
    let [hub, of_hub] = grid(101, &[1.0, 2.0, 3.0], &heights(0, 4));
    let side: String = (1..=8).map(|k| format!("{}, S2\n", 2 * k)).collect();
    let bore: String = (0..4).map(|k| format!("{}, S4\n", 101 + 2 * k)).collect();
    let top = if has_top { "107, S3\n108, S3\n" } else { "" };
    format!(
        "*HEADING\npin\n*NODE\n{pin}{hub}*ELEMENT, TYPE=CPS4, ELSET=A\n{of_pin}{of_hub}{MATERIAL}\
         *SURFACE, NAME=PIN\n{side}*SURFACE, NAME=HUB\n{bore}{top}\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE{adjust}\nPIN, HUB\n\
         *NSET, NSET=AXIS, GENERATE\n1, 25, 3\n*NSET, NSET=BACK, GENERATE\n103, 115, 3\n\
         *BOUNDARY\nAXIS, 1, 2\nBACK, 1, 2\n*STEP, NLGEOM\n*STATIC\n1., 1.\n*END STEP\n"
    )
}

/// The last row of `JOB.pair.csv`.
fn last_row(name: &str, deck: &str) -> Vec<String> {
    let folder = folder(name);
    let read = Job::read_text("part", deck, &ReadOptions::default());
    let outcome = run_in(&folder, &read);
    assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", codes(&outcome));
    let text = std::fs::read_to_string(folder.join("part.pair.csv")).unwrap();
    text.lines().last().unwrap().split(',').map(str::to_owned).collect()
}

/// Requirement: nodes of the pin below the hub are not in its top, from behind through all of it: the pin presses as it
/// does where the bore alone is the surface, also where the pair is there from a second step on, and `ADJUST` leaves these
/// nodes where they are.
#[test]
fn nodes_behind_a_part_are_not_in_it() {
    let [top, bore] = [true, false].map(|has_top| pin_in_a_hub(has_top, ""));
    let change = |how: &str| format!("*MODEL CHANGE, TYPE=CONTACT PAIR, {how}\nPIN, HUB\n");
    let step = |how: &str| format!("*STEP, NLGEOM\n*STATIC\n1., 1.\n{}*END STEP\n", change(how));
    let steps = top.find("*STEP").unwrap();
    let later = format!("{}{}{}", &top[..steps], step("REMOVE"), step("ADD"));
    let [top, bore, later] = [("top", top), ("bore", bore), ("later", later)]
        .map(|(name, deck)| last_row(&format!("hub_{name}"), &deck)[4..].to_vec());
    let force = |row: &[String]| row[4].parse::<f64>().unwrap();
    for row in [top, later] {
        assert_eq!(row[0], "5");
        assert!(force(&bore).abs() > 1.0 && (force(&row) / force(&bore) - 1.0).abs() < 1e-4);
    }
    let read = Job::read_text("hub", &pin_in_a_hub(true, ", ADJUST=0.02"), &ReadOptions::default());
    let said = read.diagnostics.iter().find(|said| said.code.0 == "SL0417").unwrap();
    assert!(said.message.contains("moved 5 slave nodes"), "{}", said.message);
}

/// Requirement: a strip whose outline is the surface does not meet a rigid profile that passes far below it, looking down,
/// from behind through the strip; nor when the next step begins.
#[test]
fn a_strip_does_not_face_through_itself() {
    let [nodes, elements] = grid(1, &[0.0, 0.5, 1.0, 1.5, 2.0], &[0.0, 0.5]);
    let step = |way: f64| {
        format!(
            "*STEP, NLGEOM\n*STATIC\n0.1, 1., 1e-5, 0.1\n*BOUNDARY\n90, 1, 1, {way:?}\n*END STEP\n"
        )
    };
    let deck = format!(
        "*HEADING\nstrip\n*NODE\n{nodes}90, 3., 0.\n*ELEMENT, TYPE=CPS4, ELSET=A\n{elements}{MATERIAL}\
         *SURFACE, NAME=S\nA,\n*SURFACE, NAME=R, TYPE=SEGMENTS\nSTART, 3., -1.\nLINE, 3., -3.\nLINE, 2.4, -3.\n\
         *RIGID BODY, REF NODE=90, ANALYTICAL SURFACE=R\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nS, R\n\
         *BOUNDARY\n1, 1, 2\n6, 1, 2\n90, 2\n90, 6\n{}{}",
        step(-1.2),
        step(-1.3)
    );
    let row = last_row("strip_through", &deck);
    let [closed, unseen] = [4, 18].map(|place: usize| row[place].parse::<f64>().unwrap());
    assert_eq!((closed, unseen), (0.0, 0.0), "{row:?}");
}

/// Requirement: a block that begins deeper in a thin plate than that is thick, by all of its nodes or, tilted, by some, is
/// pressed out as the advice says (SL0402); no node stays in the plate as if nothing touched.
#[test]
fn what_begins_deeper_than_a_part_is_thick_is_pressed_out() {
    let [plate, of_plate] =
        grid(1, &[-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0], &[0.0, 0.2]);
    let [block, of_block] = grid(101, &[-1.0, -0.5, 0.0, 0.5, 1.0], &[-0.1, 0.4, 0.9]);
    let placed = |[lift, tilt]: [f64; 2]| -> String {
        let line = |line: &str| {
            let [label, x, y] =
                [0, 1, 2].map(|k| line.split(", ").nth(k).unwrap().parse::<f64>().unwrap());
            format!("{label}, {x:?}, {:?}\n", y + lift + tilt * x)
        };
        block.lines().map(line).collect()
    };
    let deck = format!(
        "*HEADING\nblock\n*NODE\n{plate}BLOCK*ELEMENT, TYPE=CPS4, ELSET=A\n{of_plate}{of_block}{MATERIAL}\
         *SURFACE, NAME=PLATE\n1, S3\n2, S3\n3, S3\n4, S3\n5, S3\n6, S3\n7, S3\n8, S3\n\
         *SURFACE, NAME=BLOCK\n101, S1\n102, S1\n103, S1\n104, S1\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nBLOCK, PLATE\n\
         *NSET, NSET=LOW, GENERATE\n1, 9, 1\n*NSET, NSET=TOP, GENERATE\n111, 115, 1\n\
         *BOUNDARY\nLOW, 1, 2\nTOP, 1, 2\n*STEP, NLGEOM\n*STATIC\n1., 1.\n*END STEP\n"
    );
    for (name, at) in [("block_in_plate", [0.0; 2]), ("tilted_block_in_plate", [0.1, 0.05])] {
        let deck = deck.replacen("BLOCK", &placed(at), 1);
        let read = Job::read_text("part", &deck, &ReadOptions::default());
        let said = slideline::advise(&read);
        assert!(said.iter().any(|own| own.code.0 == "SL0402"), "{name}: {said:?}");
        assert_eq!(last_row(name, &deck)[4], "5", "{name}");
    }
}

/// A wall, or a thick ring, that overlaps the lip of a sleeve about it; of their surfaces the sides that touch, those that look
/// away from one another, or all.
fn wall_and_sleeve(kind: &str, surfaces: &str) -> String {
    let [wall, of_wall] = grid(1, &[5.0, 8.0, 10.82], &[0.0, 1.5, 2.25, 3.0]);
    let inside = [[0.75, 11.4], [1.15, 11.4], [2.25, 10.8], [3.35, 11.4], [8.95, 11.4]];
    let [_, of_sleeve] = grid(101, &[0.0, 1.0, 2.0], &inside.map(|[y, _]| y));
    let across = inside.iter().flat_map(|&[y, x]| [x, 0.5 * (x + 12.2), 12.2].map(|x| [x, y]));
    let sleeve: String =
        (101..).zip(across).map(|(node, [x, y])| format!("{node}, {x:?}, {y:?}\n")).collect();
    let side = |of: &[usize], face: &str| -> String {
        of.iter().map(|element| format!("{element}, {face}\n")).collect()
    };
    let [wall_side, sleeve_side] = match surfaces {
        "sides" => [side(&[2, 4, 6], "S2"), side(&[101, 103, 105, 107], "S4")],
        "backs" => [side(&[1, 3, 5], "S4"), side(&[102, 104, 106, 108], "S2")],
        _ => ["WALL,\n".to_owned(), "SLEEVE,\n".to_owned()],
    };
    format!(
        "*HEADING\nwall\n*NODE\n{wall}{sleeve}*ELEMENT, TYPE={kind}, ELSET=WALL\n{of_wall}\
         *ELEMENT, TYPE={kind}, ELSET=SLEEVE\n{of_sleeve}*ELSET, ELSET=A\nWALL, SLEEVE\n{MATERIAL}\
         *SURFACE, NAME=W\n{wall_side}*SURFACE, NAME=S\n{sleeve_side}\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nW, S\n\
         *NSET, NSET=HELD\n2, 5, 8, 11, 102, 105, 108, 111, 114\n\
         *BOUNDARY\nHELD, 1, 2\n*STEP, NLGEOM\n*STATIC\n1., 1.\n*END STEP\n"
    )
}

/// Requirement: the back of a wall is not in what touches its front, deeper than both parts are thick: whole outlines press as
/// the sides that touch do, and nothing is said of a part in the wrong place. Where backs alone are the surfaces, it is said.
#[test]
fn backs_of_parts_whose_fronts_touch_are_not_in_one_another() {
    for kind in ["CPS4", "CAX4"] {
        let [sides, outlines] = ["sides", "outlines"].map(|surfaces| {
            let deck = wall_and_sleeve(kind, surfaces);
            let said = slideline::advise(&Job::read_text("wall", &deck, &ReadOptions::default()));
            assert!(said.iter().all(|own| own.code.0 != "SL0425"), "{kind} {surfaces}: {said:?}");
            last_row(&format!("wall_{kind}_{surfaces}"), &deck)[4..9].to_vec()
        });
        let force = |row: &[String]| row[4].parse::<f64>().unwrap();
        assert!(force(&sides).abs() > 1.0, "{kind}: {sides:?}");
        assert!((force(&outlines) / force(&sides) - 1.0).abs() < 1e-6, "{kind}: {outlines:?}");
        let deck = wall_and_sleeve(kind, "backs");
        let said = slideline::advise(&Job::read_text("wall", &deck, &ReadOptions::default()));
        assert!(said.iter().any(|own| own.code.0 == "SL0425"), "{kind}: {said:?}");
    }
}
