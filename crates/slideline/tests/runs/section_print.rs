//! What passes through a surface, against the loads beyond it.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Dialect, Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::path::Path;

/// The file of tables of a run.
fn tables(name: &str, deck: &str, dialect: Dialect) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("section-print").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("job", deck, &options);
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", read.diagnostics);
    std::fs::read_to_string(folder.join("job.dat")).unwrap()
}

/// Numbers of the last line behind one that holds these words, so many lines below it.
fn below(text: &str, words: &str, lines: usize) -> Vec<f64> {
    let all: Vec<&str> = text.lines().collect();
    let at = all.iter().rposition(|line| line.contains(words)).unwrap_or_else(|| panic!("{text}"));
    all[at + lines].split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

/// Numbers of the last line that begins so.
fn row(text: &str, name: &str) -> Vec<f64> {
    let line = text.lines().rfind(|line| line.starts_with(name));
    let line = line.unwrap_or_else(|| panic!("{text}"));
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

fn is(found: &[f64], wanted: &[f64], tolerance: f64) {
    let off = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(found.len() == wanted.len() && off < tolerance, "{found:?} for {wanted:?}");
}

/// A column of three bricks on the plane z = 0 with loads (1, 0, 2) on each corner of its head; cut
/// between the first and the second one, told from below and from above.
fn column(step: &str) -> String {
    let mut nodes = String::new();
    for level in 0..4 {
        for (corner, (x, y)) in [(0, 0), (1, 0), (1, 1), (0, 1)].into_iter().enumerate() {
            nodes += &format!("{}, {x}., {y}., {level}.\n", 4 * level + corner + 1);
        }
    }
    format!(
        "*NODE, NSET=ALL\n{nodes}*NSET, NSET=FOOT\n1, 2, 3, 4\n*NSET, NSET=HEAD\n13, 14, 15, 16\n\
         *ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n2, 5, 6, 7, 8, 9, 10, 11, 12\n\
         3, 9, 10, 11, 12, 13, 14, 15, 16\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., 0.3\n*SURFACE, NAME=CUT\n1, S2\n*SURFACE, NAME=BACK\n2, S1\n{step}\n*STATIC\n\
         0.5, 1.\n*BOUNDARY\nFOOT, 1, 3\n*CLOAD\nHEAD, 1, 1.\nHEAD, 3, 2.\n*NODE PRINT, NSET=HEAD\nCOORD\n\
         *SECTION PRINT, SURFACE=CUT, NAME=LOWER\nSOF, SOM, SOAREA\n\
         *SECTION PRINT, SURFACE=BACK\nSOM2, SOF3\n*END STEP\n"
    )
}

/// Requirement: a cut carries the loads beyond it, force and moment, in small and in large motion, on
/// a mesh that is far too coarse for its stresses; both sides of it the opposite. Equilibrium, to the
/// residual of the iteration.
#[test]
fn a_cut_carries_what_is_beyond() {
    for step in ["*STEP", "*STEP, NLGEOM"] {
        let text = tables("cut", &column(step), Dialect::Abaqus);
        // where the loads act: (x, y, z) of the corners of the head
        let mut moment = [0.0; 3];
        let mut places = [[0.0, 0.0, 3.0], [1.0, 0.0, 3.0], [1.0, 1.0, 3.0], [0.0, 1.0, 3.0]];
        if step.contains("NLGEOM") {
            for (place, at) in places.iter_mut().enumerate() {
                at.copy_from_slice(&below(&text, "COOR1", 1 + place)[1..]);
            }
        }
        for [x, y, z] in places {
            moment[0] += 2.0 * y;
            moment[1] += z - 2.0 * x;
            moment[2] -= y;
        }
        let size = |own: [f64; 3]| own[0].hypot(own[1]).hypot(own[2]);
        let [x, y, z] = moment;
        let wanted = [80_f64.sqrt(), 4.0, 0.0, 8.0, size(moment), x, y, z];
        let (lower, back) = (row(&text, "LOWER"), row(&text, "BACK"));
        is(&lower[..8], &wanted, 1e-4);
        is(&back, &[size(moment), -x, -y, -z, 80_f64.sqrt(), -4.0, 0.0, -8.0], 1e-4);
        if !step.contains("NLGEOM") {
            is(&lower[8..], &[1.0], 1e-12);
        }
    }
}

/// Requirement: in the dialect of CalculiX the block of ccx 2.20: its titles and their order (read
/// from a run of ccx); centre, normal, area, pull, shear, torque and bending by hand.
#[test]
fn a_cut_in_the_dialect_of_calculix() {
    let text = tables("ccx", &column("*STEP"), Dialect::Calculix);
    let titles = [
        " statistics for surface set CUT and time  0.1000000E+01",
        "   total surface force (fx,fy,fz) and moment about the origin(mx,my,mz)",
        "   center of gravity and mean normal",
        "   moment about the center of gravity(mx,my,mz)",
        "   area, normal force (+ = tension), shear force (size), torque and bending moment (size)",
    ];
    let begin = text.find(titles[0]).unwrap_or_else(|| panic!("{text}"));
    let places = titles.iter().map(|title| text[begin..].find(title).unwrap());
    assert!(places.is_sorted_by(|a, b| a < b));
    let own = &text[begin..begin + text[begin..].find("set BACK").unwrap()];
    // 4 along x and 8 along z at the head, whose centre is (1/2, 1/2, 3)
    is(&below(own, titles[1], 2), &[4.0, 0.0, 8.0, 4.0, 8.0, -2.0], 1e-5);
    is(&below(own, titles[2], 2), &[0.5, 0.5, 1.0, 0.0, 0.0, 1.0], 1e-6);
    is(&below(own, titles[3], 2), &[0.0, 8.0, 0.0], 1e-5);
    is(&below(own, titles[4], 2), &[1.0, 8.0, 4.0, 0.0, 8.0], 1e-5);
}

/// Requirement: in the plane the thickness counts; a surface under a pressure hands that pressure over.
#[test]
fn a_cut_in_the_plane() {
    let deck = "*NODE\n1, 0., 0.\n2, 2., 0.\n3, 2., 1.\n4, 0., 1.\n5, 0., 2.\n6, 2., 2.\n\
        *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n2, 4, 3, 6, 5\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
        0.25\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SURFACE, NAME=CUT\n1, S3\n*SURFACE, NAME=TOP\n\
        2, S3\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 2\n2, 2\n*DSLOAD\nTOP, P, 3.\n\
        *SECTION PRINT, SURFACE=CUT, NAME=MIDDLE\nSOF, SOM, SOAREA\n\
        *SECTION PRINT, SURFACE=TOP\nSOF\n*END STEP\n";
    let text = tables("plane", deck, Dialect::Abaqus);
    is(&row(&text, "MIDDLE"), &[1.5, 0.0, -1.5, -1.5, 0.5], 1e-6);
    is(&row(&text, "TOP"), &[1.5, 0.0, -1.5], 1e-6);
}

/// Requirement: surfaces that have no faces of solids, and that do not exist, are told of.
#[test]
fn surfaces_that_nothing_passes_through() {
    let deck = column("*STEP");
    let said = |deck: &str| {
        format!("{:?}", Job::read_text("job", deck, &ReadOptions::default()).diagnostics)
    };
    assert!(said(&deck.replace("SURFACE=CUT,", "SURFACE=CUTS,")).contains("SL0327"));
    let nodes = deck.replace("*SURFACE, NAME=CUT\n1, S2", "*SURFACE, NAME=CUT, TYPE=NODE\nFOOT");
    assert!(said(&nodes).contains("SL0332"));
    assert!(said(&deck.replace("NAME=LOWER", "NAME=LOWER, AXES=LOCAL")).contains("SL0252"));
    assert!(!said(&deck).contains("SL0257"), "{}", said(&deck));
}

/// Bricks 2 x 2 x 4 of half a unit, each of six tetrahedra about its diagonal: nodes, elements, and the
/// faces on the plane of the middle from below and from above.
fn tetrahedra() -> (String, String, [Vec<String>; 2]) {
    let label = |[i, j, k]: [usize; 3]| 9 * k + 3 * j + i + 1;
    let corners =
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    let (mut nodes, mut elements) = (String::new(), String::new());
    let mut sides = [Vec::new(), Vec::new()];
    for place in (0..45).map(|n| [n % 3, n / 3 % 3, n / 9]) {
        let [x, y, z] = place.map(|k| 0.5 * k as f64);
        nodes += &format!("{}, {x:?}, {y:?}, {z:?}\n", label(place));
    }
    let middle = 19..=27;
    for brick in (0..16).map(|n| [n % 2, n / 2 % 2, n / 4]) {
        let corner = |c: usize| label(std::array::from_fn(|k| brick[k] + corners[c][k]));
        for [a, b] in [[1, 2], [2, 3], [3, 7], [7, 4], [4, 5], [5, 1]] {
            let own = [0, a, b, 6].map(corner);
            let element = elements.lines().count() + 1;
            elements += &format!("{element}, {}, {}, {}, {}\n", own[0], own[1], own[2], own[3]);
            for (face, of) in [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]].iter().enumerate() {
                if of.iter().all(|&n| middle.contains(&own[n])) {
                    sides[brick[2] - 1].push(format!("{element}, S{}\n", face + 1));
                }
            }
        }
    }
    (nodes, elements, sides)
}

/// Requirement: elements that touch a cut at an edge or a corner alone carry their part of what passes:
/// tetrahedra hand over all that is loaded beyond. Faces named from both sides take from one another
/// what they give, and have no normal. Equilibrium, 1e-6.
#[test]
fn tetrahedra_hand_over_all_that_passes() {
    let (nodes, elements, [below_it, above_it]) = tetrahedra();
    let deck = format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=C3D4, ELSET=E\n{elements}*NSET, NSET=FOOT, GENERATE\n1, 9\n\
         *NSET, NSET=HEAD, GENERATE\n37, 45\n*SURFACE, NAME=CUT\n{}*SURFACE, NAME=BOTH\n{}{}\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*STEP\n*STATIC\n\
         *BOUNDARY\nFOOT, 1, 3\n*CLOAD\nHEAD, 1, 4.\nHEAD, 3, 8.\n*SECTION PRINT, SURFACE=CUT\n\
         SOF, SOM, SOAREA\n*SECTION PRINT, SURFACE=BOTH\nSOF\n*END STEP\n",
        below_it.concat(),
        below_it.concat(),
        above_it.concat(),
    );
    let text = tables("tetrahedra", &deck, Dialect::Abaqus);
    let size = (36.0_f64 * 36.0 + 72.0 * 72.0).sqrt();
    // moments about the origin of forces at (0.5, 0.5, 2) on the mean
    let moment = [36.0, 0.5 * -72.0 + 2.0 * 36.0, -18.0];
    let whole = moment.iter().map(|m| m * m).sum::<f64>().sqrt();
    let wanted = [size, 36.0, 0.0, 72.0, whole, moment[0], moment[1], moment[2], 1.0];
    is(&row(&text, "CUT"), &wanted, 1e-6);
    is(&row(&text, "BOTH"), &[0.0; 4], 1e-6);
    let text = tables("tetrahedra-ccx", &deck, Dialect::Calculix);
    let both = text.rsplit("statistics for surface set BOTH").next().unwrap();
    is(&below(both, "mean normal", 2)[3..], &[0.0; 3], 1e-12);
}

/// Requirement: patches of the skin that lie side by side hand over what the whole of them does: what comes over common
/// nodes counts once, though solids meet there through their inside. Equilibrium, 1e-6.
#[test]
fn patches_side_by_side_sum_to_the_whole() {
    let deck = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n4, 0., 1.\n5, 1., 1.\n6, 2., 1.\n\
        *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
        *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=WEST\n1, S1\n*SURFACE, NAME=EAST\n2, S1\n\
        *SURFACE, NAME=WHOLE\nE, S1\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n3, 1, 2\n\
        *CLOAD\n4, 2, -1.\n6, 2, -3.\n*SECTION PRINT, SURFACE=WEST\nSOF\n*SECTION PRINT, SURFACE=EAST\nSOF\n\
        *SECTION PRINT, SURFACE=WHOLE\nSOF\n*END STEP\n";
    let text = tables("patches", deck, Dialect::Abaqus);
    let [west, east, whole] = ["WEST", "EAST", "WHOLE"].map(|name| row(&text, name));
    // the size comes first
    let sum: Vec<f64> = west.iter().zip(&east).skip(1).map(|(a, b)| a + b).collect();
    assert!((whole[2].abs() - 4.0).abs() < 1e-6, "{whole:?}");
    is(&sum, &whole[1..], 1e-6);
}

/// Requirement: what passes between surfaces of a tied pair is printed where contact is asked for, by either name,
/// and a request for a section of an earlier step stays. It printed an empty table, or no such pair.
#[test]
fn tied_pairs_print_what_passes() {
    let deck = |names: &str, first: &str| {
        format!(
            "*NODE, NSET=ALL\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n5, 0., 1.\n6, 1., 1.\n7, 1., 2.\n\
             8, 0., 2.\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n2, 5, 6, 7, 8\n*SOLID SECTION, ELSET=E, \
             MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=LOW\n1, S3\n\
             *SURFACE, NAME=UP\n2, S1\n*SURFACE INTERACTION, NAME=I\n1.\n*CONTACT PAIR, INTERACTION=I, TIED\n\
             UP, LOW\n*STEP\n*STATIC\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n*CLOAD\n7, 1, 3.\n8, 2, 5.\n{first}*END STEP\n\
             *STEP\n*STATIC\n*CONTACT PRINT{names}\nCFN, CFT, CMT, CAREA, CSTRESS\n*END STEP\n"
        )
    };
    for names in ["", ", SLAVE=UP, MASTER=LOW"] {
        let section = "*SECTION PRINT, SURFACE=LOW\nSOF1\n";
        let text = tables("tied", &deck(names, section), Dialect::Abaqus);
        is(&row(&text, "UP/LOW"), &[34.0_f64.sqrt(), -3.0, -5.0, 6.0, 1.0], 1e-6);
        let (_, last) = text.split_once("STEP 2  INCREMENT").unwrap();
        is(&row(last, "LOW"), &[34.0_f64.sqrt(), 3.0, 5.0], 1e-6);
    }
}

/// Requirement: a slave that is tied to two masters has one table, of all that passes; a rigid one has none, for
/// zeros stood there.
#[test]
fn slaves_of_two_tied_pairs_print_once_and_rigid_ones_nothing() {
    let deck = |body: &str, held: &str| {
        format!(
            "*NODE, NSET=ALL\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n5, 0., 1.\n6, 2., 1.\n7, 2., 2.\n\
             8, 0., 2.\n11, 1., 0.\n12, 2., 0.\n13, 2., 1.\n14, 1., 1.\n99, 1., 3.\n\
             *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n3, 11, 12, 13, 14\n2, 5, 6, 7, 8\n\
             *SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1000., 0.3\n*SURFACE, NAME=LEFT\n1, S3\n*SURFACE, NAME=RIGHT\n3, S3\n\
             *SURFACE, NAME=UP\n2, S1\n*SURFACE INTERACTION, NAME=I\n1.\n\
             *CONTACT PAIR, INTERACTION=I, TIED\nUP, LEFT\nUP, RIGHT\n{body}*STEP\n*STATIC\n*BOUNDARY\n\
             {held}*CONTACT PRINT\nCFN, CAREA\n*CLOAD\n"
        )
    };
    let text = tables(
        "two",
        &(deck("", "1, 1, 2\n2, 1, 2\n11, 1, 2\n12, 1, 2\n") + "7, 1, 3.\n8, 2, 5.\n*END STEP\n"),
        Dialect::Abaqus,
    );
    is(&row(&text, "UP "), &[34.0_f64.sqrt(), -3.0, -5.0, 2.0], 1e-6);
    assert!(!text.contains("UP/"), "{text}");
    let body = "*RIGID BODY, REF NODE=99, TIE NSET=ALL\n";
    let rigid = deck(body, "99, 1, 2\n99, 6, 6\n") + "99, 1, 3.\n*END STEP\n";
    let read = Job::read_text("job", &rigid, &ReadOptions::default());
    let said = |text: &str| read.diagnostics.iter().any(|said| said.message.contains(text));
    assert!(said("nothing is printed of it"), "{:?}", read.diagnostics);
    let model = read.model.unwrap();
    assert!(model.steps.iter().all(|step| step.output.section_prints.is_empty()));
}
