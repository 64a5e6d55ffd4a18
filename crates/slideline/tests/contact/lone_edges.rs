//! Edges that stand alone are held where contact is at nodes, although they turn by less than 45 degrees; what goes through
//! between slave nodes is told.
//!
//! ```text
//!     |  slave, wide  |        +---------+              the master goes in between two slave nodes
//!     o---------------o      o-|---------|-------o
//!          .-^-.               |  master |
//! ```
//!
//! docs/theory.md section 5.17

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::narrow_masters::told;
use crate::space_decks::{Block, Kind, solved};
use std::fmt::Write as _;

/// Nodes and elements of a plane block from its columns, each from its foot to its head, of two layers.
fn plane_block(text: &mut String, name: &str, base: usize, columns: &[[[f64; 2]; 2]]) {
    let _ = writeln!(text, "*NODE");
    for (k, [foot, head]) in columns.iter().enumerate() {
        for layer in 0..3 {
            let part = layer as f64 / 2.0;
            let [x, y] = [0, 1].map(|axis| (1.0 - part) * foot[axis] + part * head[axis]);
            let _ = writeln!(text, "{}, {x:?}, {y:?}", base + 10 * k + layer);
        }
    }
    let _ = writeln!(text, "*ELEMENT, TYPE=CPE4, ELSET={name}");
    for k in 0..columns.len() - 1 {
        for layer in 0..2 {
            let a = base + 10 * k + layer;
            let _ = writeln!(text, "{a}, {a}, {}, {}, {}", a + 10, a + 11, a + 1);
        }
    }
}

/// Element faces of the foot or the head of a block of so many columns.
fn side(name: &str, base: usize, columns: usize, is_head: bool) -> String {
    let mut text = format!("*SURFACE, NAME={name}\n");
    for k in 0..columns - 1 {
        let _ = match is_head {
            true => writeln!(text, "{}, S3", base + 10 * k + 1),
            false => writeln!(text, "{}, S1", base + 10 * k),
        };
    }
    text
}

/// A flat block of three wide elements pressed on a lower one; the force on the upper one.
fn pressed(profile: &[[f64; 2]], [slave, master]: [&str; 2]) -> f64 {
    let upper: Vec<_> =
        (0..4).map(|k| 0.7 * f64::from(k) - 1.05).map(|x| [[x, 0.002], [x, 1.002]]).collect();
    let lower: Vec<_> = profile.iter().map(|&[x, y]| [[x, -1.0], [x, y]]).collect();
    let mut text = "*HEADING\nedge\n".to_owned();
    plane_block(&mut text, "UP", 1000, &upper);
    plane_block(&mut text, "LOW", 2000, &lower);
    text += &side("FOOT", 1000, upper.len(), false);
    text += &side("TOP", 2000, lower.len(), true);
    let list = |first: usize, count: usize| {
        (0..count).map(|k| format!("{}, ", first + 10 * k)).collect::<String>()
    };
    let _ = write!(
        text,
        "*NSET, NSET=HEAD\n{}\n*NSET, NSET=BASE\n{}\n*SOLID SECTION, ELSET=UP, MATERIAL=M\n\
         *SOLID SECTION, ELSET=LOW, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n{slave}, \
         {master}\n*BOUNDARY\nBASE, 1, 2\nHEAD, 1, 1\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\n\
         HEAD, 2, 2, -.03\n*END STEP\n",
        list(1002, upper.len()),
        list(2000, lower.len()),
    );
    let force = solved(&text).force()[1];
    if slave == "FOOT" { force } else { -force }
}

/// Requirement: a ridge of 22 to 44 degrees presses on a wide face whichever side is named first. Source: with the other role
/// it is a slave node. Tolerance: 1e-6. It carried nothing.
#[test]
fn ridges_press_whichever_side_is_named_first() {
    let ridge = |degrees: f64| {
        let fall = (degrees.to_radians() / 2.0).tan();
        [-1.0, -0.5, 0.0, 0.5, 1.0].map(|x: f64| [x + 0.05, -fall * x.abs()])
    };
    for degrees in [22.0, 30.0, 38.0, 44.0] {
        let [one, other] =
            [["FOOT", "TOP"], ["TOP", "FOOT"]].map(|roles| pressed(&ridge(degrees), roles));
        assert!(one > 1.0 && (one - other).abs() < 1e-6 * one, "{degrees}: {one} {other}");
    }
}

/// A wide block of elements across its whole width, below a narrower one.
fn narrow_on_wide(form: &str, roles: &str) -> String {
    let lower = Block { name: "LOW", base: 1000, cells: [4, 1, 1], kind: Kind::C3d8 };
    let upper = Block { name: "UP", base: 2000, cells: [4, 1, 1], kind: Kind::C3d8 };
    let mut text = "*HEADING\nnarrow\n".to_owned();
    lower.write(&mut text, |[x, y, z]| [4.0 * x, 3.0 * y - 0.5, z - 1.0]);
    upper.write(&mut text, |[x, y, z]| [1.0 + 2.0 * x, 2.0 * y, z + 0.01]);
    text += &lower.surface("TOP", |at| at[2] == 1.0);
    text += &upper.surface("FOOT", |at| at[2] == 0.0);
    text += &lower.set("BASE", |at| at[2] == 0.0);
    text += &upper.set("HEAD", |at| at[2] == 1.0);
    let _ = write!(
        text,
        "*SOLID SECTION, ELSET=LOW, MATERIAL=M\n*SOLID SECTION, ELSET=UP, MATERIAL=M\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={form}\n\
         {roles}\n*BOUNDARY\nBASE, 1, 3\nHEAD, 1, 2\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\n\
         HEAD, 3, 3, -.2\n*END STEP\n"
    );
    text
}

/// Requirement: a master that is narrower than every face of the slave goes through between their nodes, and is told of; it is
/// not where it is the slave, or contact is spread over faces, which both hold it.
#[test]
fn a_master_narrower_than_the_slave_faces_is_told() {
    let said = |form: &str, roles: &str| {
        let name = format!("narrow_{}", roles.replace(", ", "_"));
        told(&name, &narrow_on_wide(form, roles)).contains(&"SL0620".to_owned())
    };
    assert!(said("NODE TO SURFACE", "TOP, FOOT"));
    for (form, roles) in [("NODE TO SURFACE", "FOOT, TOP"), ("SURFACE TO SURFACE", "TOP, FOOT")] {
        assert!(
            !said(form, roles) && solved(&narrow_on_wide(form, roles)).force()[2].abs() > 100.0
        );
    }
}

/// A rigid patch so wide pressed on the wide block.
fn patch(half: f64) -> String {
    let lower = Block { name: "LOW", base: 1000, cells: [4, 1, 1], kind: Kind::C3d8 };
    let mut text = "*HEADING\npatch\n".to_owned();
    lower.write(&mut text, |[x, y, z]| [4.0 * x, 3.0 * y - 0.5, z - 1.0]);
    text += &lower.surface("TOP", |at| at[2] == 1.0);
    text += &lower.set("BASE", |at| at[2] == 0.0);
    let [low, high] = [1.0 - half, 1.0 + half];
    text + &format!(
        "*NODE\n9000, 2., 1., 1.\n9001, 1., {low:?}, .01\n9002, 1., {high:?}, .01\n9003, 3., {high:?}, .01\n\
             9004, 3., {low:?}, .01\n*ELEMENT, TYPE=R3D4, ELSET=PATCH\n9000, 9001, 9002, 9003, 9004\n\
             *RIGID BODY, ELSET=PATCH, REF NODE=9000\n*SURFACE, NAME=FOOT\nPATCH, SPOS\n\
             *SOLID SECTION, ELSET=LOW, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
             *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nTOP, FOOT\n\
             *BOUNDARY\nBASE, 1, 3\n9000, 1, 2\n9000, 4, 6\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\n\
             9000, 3, 3, -.2\n*END STEP\n"
    )
}

/// Requirement: a rigid patch, whose edges no solid has, goes through between slave nodes and is told of, with a node of it;
/// one that is wider than the slave is not.
#[test]
fn a_rigid_patch_that_goes_through_is_told() {
    assert!(told("narrow_patch", &patch(0.8)).contains(&"SL0620".to_owned()));
    assert!(!told("wide_patch", &patch(1.8)).contains(&"SL0620".to_owned()));
}

/// A block of so many C3D20R along a ridge of 90 degrees, whose middle node stands below it, pressed on it.
fn ridge_with_middle_nodes(along: usize, roles: &str) -> String {
    let ridge = Block { name: "LOW", base: 1000, cells: [4, 1, along], kind: Kind::C3d20r };
    let block = Block { name: "UP", base: 3000, cells: [2, 1, 2], kind: Kind::C3d20r };
    let mut text = "*HEADING\nmiddle\n".to_owned();
    ridge.write(&mut text, |[x, y, z]| {
        let x = 4.0 * x - 2.0;
        [x, -x.abs() * y - 3.0 * (1.0 - y), 4.0 * z - 2.0]
    });
    // a little aside, so that no node of the block is upon the ridge
    block.write(&mut text, |[x, y, z]| [1.5 * x - 0.55, y, 0.9 * z - 0.42]);
    text += &ridge.surface("TOP", |at| at[1] == 1.0);
    text += &block.surface("FOOT", |at| at[1] == 0.0);
    text += &ridge.set("BASE", |at| at[1] == 0.0);
    text += &block.set("HEAD", |at| at[1] == 1.0);
    let _ = write!(
        text,
        "*SOLID SECTION, ELSET=LOW, MATERIAL=M\n*SOLID SECTION, ELSET=UP, MATERIAL=M\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n\
         {roles}\n*BOUNDARY\nBASE, 1, 3\nHEAD, 1, 1\nHEAD, 3, 3\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\n\
         HEAD, 2, 2, -.06\n*END STEP\n"
    );
    text
}

/// Requirement: a middle node of a sharp edge of the master is held as a corner of it is, where contact is at nodes. Source: the
/// same ridge of two elements, which has a corner there. Tolerance: 30 %, meshes differ. It was not held, and the force far less.
#[test]
fn middle_nodes_of_edges_are_held() {
    let force = |along: usize| solved(&ridge_with_middle_nodes(along, "FOOT, TOP")).force()[1];
    let [one, two] = [force(1), force(2)];
    assert!(one > 1.0 && (one - two).abs() < 0.3 * two, "{one} {two}");
}

/// Requirement: middle nodes at the rim of a quadratic slave press what its faces look at, and not the sides of a flush part:
/// along the sides nothing acts. Source: the faces that meet look up and down. A dozen had normals across.
#[test]
fn middle_nodes_at_the_rim_do_not_press_sides() {
    let lower = Block { name: "LOW", base: 1000, cells: [3, 2, 1], kind: Kind::C3d20r };
    let upper = Block { name: "UP", base: 3000, cells: [4, 3, 1], kind: Kind::C3d20r };
    let mut text = "*HEADING\nrim\n".to_owned();
    // flush sides, and a face that is round
    let round = |x: f64| 0.6 * (1.0 - (2.0 * x - 1.0) * (2.0 * x - 1.0));
    lower.write(&mut text, |[x, y, z]| [4.0 * x, 2.0 * y, (1.0 + round(x)) * z]);
    upper.write(&mut text, |[x, y, z]| [4.0 * x, 2.0 * y, 1.0 + round(x) + z * (1.0 - round(x))]);
    text += &lower.set("BASE", |at| at[2] == 0.0);
    text += &upper.set("HEAD", |at| at[2] == 1.0);
    text += &upper.set("WARM", |_| true);
    text += "*SOLID SECTION, ELSET=LOW, MATERIAL=M\n*SOLID SECTION, ELSET=UP, MATERIAL=M\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1000., .3\n*EXPANSION\n1.E-4\n*SURFACE INTERACTION, NAME=I\n*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n\
             *CONTACT PROPERTY ASSIGNMENT\n, , I\n*BOUNDARY\nBASE, 1, 3\nHEAD, 1, 3\n*STEP, NLGEOM\n*STATIC\n1., 1.\n\
             *TEMPERATURE\nWARM, 100.\n*END STEP\n";
    let last = solved(&text);
    let pressing = last.contact.iter().filter(|row| row.pressure > 0.0);
    let aside = pressing.clone().filter(|row| row.normal[1].abs() > 0.5).count();
    assert!(pressing.count() > 9 && aside == 0, "{aside}");
}
