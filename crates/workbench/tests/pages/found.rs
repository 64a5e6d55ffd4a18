//! Sliders of decks without parameters.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)] // a test may fail where it stands

use crate::exchange::{ask, last, opened, parameter, rows};
use serde_json::{Value, json};
use slideline_workbench::Bench;

const PLAIN: &str = include_str!("../../../../corpus/tutorial/snap_fit.inp");

/// Requirement: a deck without parameters has what is found in it, the model that they make has the
/// same bits, and so has a deck saved with other values.
#[test]
fn numbers_of_a_deck_become_parameters() {
    let (mut bench, deck) = opened("snap_fit.inp", PLAIN);
    let names: Vec<&str> = deck["parameters"]
        .as_array()
        .unwrap()
        .iter()
        .map(|own| own["name"].as_str().unwrap())
        .collect();
    let all = ["width", "thickness", "modulus", "angle", "angle_2", "angle_3", "fillet", "shift_x"];
    for name in all.into_iter().chain(["shift_y", "mu", "stroke"]) {
        assert!(names.contains(&name), "{name} of {names:?}");
    }
    // the edge at the arm's end is a body that hangs on the arm: it has no place of its own
    assert!(!names.iter().any(|name| name.contains("BACK")), "{names:?}");
    assert_eq!(parameter(&deck, "angle")["value"], 30.0);
    assert_eq!(parameter(&deck, "fillet")["value"], 0.2);
    let words =
        ["angle_2", "shift_x", "thickness"].map(|name| parameter(&deck, name)["about"].clone());
    assert_eq!(words, ["segment 3 of CATCH", "along x, of CATCH", "of ARM"]);
    // a share of what is zero is no tolerance
    let band = last(&mut bench, &json!({"ask": "band", "id": 2, "tolerances": {"shift_x": 0.1}}));
    assert!(band["why"].as_str().unwrap().contains("shift_x is 0"), "{band}");
    assert_eq!(parameter(&deck, "thickness")["origin"], "found");
    let thick = parameter(&deck, "thickness")["value"].as_f64().unwrap();
    let drawn =
        json!({"angle": 33.0, "angle_3": -50.0, "fillet": 0.3, "shift_y": -0.05, "stroke": -9.5});
    for values in [json!({}), json!({"thickness": 1.1 * thick, "shift_x": 0.25}), drawn] {
        let said = ask(&mut bench, &json!({"ask": "solve", "id": 2, "values": values}));
        let asked = json!({"ask": "save", "id": 3, "what": "deck", "values": values});
        let text = last(&mut bench, &asked)["text"].as_str().unwrap().to_owned();
        assert_eq!(text == PLAIN, values == json!({}), "nothing else is rewritten");
        let (_, again) = opened("snap_fit.inp", &text);
        assert_eq!(again["sound"], true);
        let (mut second, _) = opened("snap_fit.inp", &text);
        let other = ask(&mut second, &json!({"ask": "solve", "id": 2}));
        let bits = |said: &[Value]| -> Vec<Vec<u64>> {
            rows(said).iter().map(|row| row.iter().map(|own| own.to_bits()).collect()).collect()
        };
        assert!(bits(&said).len() > 100 && bits(&said) == bits(&other));
    }
}

/// Requirement: a profile that is drawn with another angle and another radius gives the forces of the
/// deck that says the same by its parameters; one that cannot be drawn is an error with its reason.
#[test]
fn a_found_angle_is_that_of_a_deck_with_parameters() {
    let (mut bench, _) = opened("snap_fit.inp", PLAIN);
    let push = |bench: &mut Bench, values: Value| {
        let end = last(bench, &json!({"ask": "solve", "id": 2, "values": values}));
        [&end["figures"]["push_in"], &end["figures"]["pull_out"]].map(|own| own.as_f64().unwrap())
    };
    let found = push(&mut bench, json!({"angle": 36.0, "angle_3": -40.0, "fillet": 0.25}));
    let [foot, heel] =
        [(5.0, 36f64), (4.0, 40.0)].map(|(run, angle)| 2.0 - run * angle.to_radians().tan());
    let corner = 55.0 - 0.2 * 15f64.to_radians().tan();
    let other = 57.0 + 0.2 * 22.5f64.to_radians().tan();
    let (from, to) =
        (PLAIN.find("*SURFACE, NAME=CATCH").unwrap(), PLAIN.find("*RIGID BODY").unwrap());
    let drawn = format!(
        "*SURFACE, NAME=CATCH, TYPE=SEGMENTS, FILLET RADIUS=0.25\nSTART, {}, {}\nLINE, {corner}, 2.0\n\
         LINE, {other}, 2.0\nLINE, {}, {}\n",
        corner - 5.0,
        foot,
        other + 4.0,
        heel,
    );
    let text = [&PLAIN[..from], &drawn, &PLAIN[to..]].concat();
    let own = push(&mut opened("snap_fit.inp", &text).0, json!({}));
    assert!((0..2).all(|k| (found[k] / own[k] - 1.0).abs() < 1e-4), "{found:?} {own:?}");
    let wrong = json!({"ask": "solve", "id": 3, "values": {"fillet": 9.0}});
    let end = last(&mut bench, &wrong);
    assert_eq!(end["status"], "input_error");
    assert!(
        end["diagnosis"]["message"].as_str().unwrap().contains("CATCH cannot be drawn"),
        "{end}"
    );
    let saved = json!({"ask": "save", "id": 4, "what": "deck", "values": {"fillet": 9.0}});
    assert_eq!(last(&mut bench, &saved)["say"], "refused");
}

/// Requirement: radii of balls, places of surfaces in space and loads are found, and a deck saved with
/// other values is the one that was solved.
#[test]
fn balls_pipes_and_loads_are_found() {
    let corpus = [
        (
            "surface_revolution",
            include_str!("../../../../corpus/keywords/surface_revolution.inp"),
            &["radius", "shift_x", "shift_y", "shift_z"][..],
        ),
        (
            "eccentric_cam",
            include_str!("../../../../corpus/sound/eccentric_cam_mm.inp"),
            &["radius", "shift_x", "thickness"],
        ),
        ("CLOAD", include_str!("../../../../corpus/keywords/CLOAD.inp"), &["load"]),
    ];
    for (name, text, names) in corpus {
        let (mut bench, deck) = opened(&format!("{name}.inp"), text);
        for own in names {
            let found = parameter(&deck, own);
            let value = found["value"].as_f64().unwrap_or_else(|| panic!("{own} of {deck}"));
            let range = ["minimum", "maximum"].map(|end| found[end].as_f64().unwrap());
            let other = value + 0.01 * (range[1] - range[0]);
            let values = json!({*own: other});
            let said = ask(&mut bench, &json!({"ask": "solve", "id": 2, "values": values}));
            assert_eq!(said.last().unwrap()["say"], "end", "{own}");
            let saved = last(
                &mut bench,
                &json!({"ask": "save", "id": 3, "what": "deck", "values": values}),
            );
            let (mut second, again) =
                opened(&format!("{name}.inp"), saved["text"].as_str().unwrap());
            assert_eq!(again["sound"], true, "{own}");
            assert_eq!(
                rows(&said),
                rows(&ask(&mut second, &json!({"ask": "solve", "id": 2}))),
                "{own}"
            );
        }
    }
}

/// Requirement: what is wrong with a found number is said at its line of the deck.
#[test]
fn errors_stand_where_the_number_stands() {
    let (mut bench, _) = opened("snap_fit.inp", PLAIN);
    let asked = json!({"ask": "solve", "id": 2, "values": {"thickness": -1.0}});
    let end = last(&mut bench, &asked);
    let line = 1 + PLAIN.lines().position(|line| line == "25.0, 1.5").unwrap();
    assert_eq!(
        (&end["status"], &end["diagnosis"]["line"]),
        (&json!("input_error"), &json!(line)),
        "{end}"
    );
}

/// A block that a wall of rigid elements presses; the wall's middle nodes are generated.
const WALL: &str = "\
*HEADING\n\
A block that a rigid wall of elements presses\n\
*NODE\n\
1, 0.0, 0.0\n\
2, 2.0, 0.0\n\
3, 2.0, 1.0\n\
4, 0.0, 1.0\n\
5, 1.0, 0.0\n\
6, 1.0, 1.0\n\
101, -0.5, 1.05\n\
105, 2.5, 1.05\n\
110, 1.0, 1.5\n\
*NGEN\n\
101, 105, 1\n\
*ELEMENT, TYPE=CPE4, ELSET=BLOCK\n\
1, 1, 5, 6, 4\n\
2, 5, 2, 3, 6\n\
*ELEMENT, TYPE=R2D2, ELSET=WALL\n\
11, 105, 104\n\
12, 104, 103\n\
13, 103, 102\n\
14, 102, 101\n\
*SOLID SECTION, ELSET=BLOCK, MATERIAL=RUBBER\n\
1.0\n\
*MATERIAL, NAME=RUBBER\n\
*ELASTIC\n\
10.0, 0.3\n\
*RIGID BODY, REF NODE=110, ELSET=WALL\n\
*SURFACE, NAME=FACE, TYPE=ELEMENT\n\
WALL, SPOS\n\
*SURFACE, NAME=TOP, TYPE=ELEMENT\n\
BLOCK, S3\n\
*SURFACE INTERACTION, NAME=I\n\
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n\
TOP, FACE\n\
*STEP, NLGEOM\n\
*STATIC\n\
0.1, 1.0\n\
*BOUNDARY\n\
1, 1, 2\n\
2, 2\n\
5, 2\n\
110, 1, 1\n\
110, 6, 6\n\
110, 2, 2, -0.15\n\
*END STEP\n";

/// Requirement: a rigid body of elements has a place as an analytical one has: all its nodes move, those
/// that are generated too, and what was written by hand at the other place has the same forces. The
/// ends of its slider are a tenth of its size, also along the axis in which it is flat.
#[test]
fn a_body_of_elements_has_a_place() {
    let (mut bench, deck) = opened("wall.inp", WALL);
    let tenth = 0.1 * 3.0;
    for name in ["shift_x", "shift_y"] {
        let found = parameter(&deck, name);
        let ends = (&found["minimum"], &found["maximum"]);
        assert_eq!(ends, (&json!(-tenth), &json!(tenth)), "{deck}");
    }
    let lower = json!({"shift_x": 0.125, "shift_y": -0.0625});
    let said = ask(&mut bench, &json!({"ask": "solve", "id": 2, "values": lower}));
    let by_hand = WALL
        .replace("101, -0.5, 1.05", "101, -0.375, 0.9875")
        .replace("105, 2.5, 1.05", "105, 2.625, 0.9875");
    let (mut second, _) = opened("wall.inp", &by_hand);
    let other = ask(&mut second, &json!({"ask": "solve", "id": 2}));
    let forces = |said: &[Value]| rows(said).iter().map(|row| row[4]).collect::<Vec<_>>();
    let (own, other) = (forces(&said), forces(&other));
    assert!(own.len() > 5 && own.len() == other.len(), "{own:?} {other:?}");
    let most = other.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    assert!(most > 1.0 && own.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-9 * most));
    let saved = last(
        &mut bench,
        &json!({"ask": "save", "id": 3, "what": "deck", "values": {"shift_y": -0.0625}}),
    );
    let text = saved["text"].as_str().unwrap();
    assert!(text.contains("101, -0.5, 0.9875") && text.contains("110, 1.0, 1.5"), "{text}");
}

/// Requirement: a body that is part of more, or whose nodes stand where no number of the deck puts
/// them, has no place that could be moved: half of a part would stay.
#[test]
fn a_body_that_is_part_of_more_stays() {
    let none = |text: &str| {
        let (_, deck) = opened("wall.inp", text);
        assert_eq!(deck["sound"], true, "{deck}");
        assert!(parameter(&deck, "shift_y").is_null() && !parameter(&deck, "modulus").is_null());
    };
    // the foot of the block hangs on the body
    let tied = WALL
        .replace(
            "ELSET=WALL\n*SURFACE, NAME=FACE",
            "ELSET=WALL, TIE NSET=FOOT\n*SURFACE, NAME=FACE",
        )
        .replace("*ELEMENT, TYPE=CPE4", "*NSET, NSET=FOOT\n1, 5, 2\n*ELEMENT, TYPE=CPE4");
    none(&tied.replace("1, 1, 2\n2, 2\n5, 2\n", ""));
    // a node that is generated between the body and its reference node, which stays
    let copied = WALL.replace("*NGEN\n101, 105, 1\n", "*NGEN\n101, 105, 1\n105, 110, 1\n");
    none(&copied.replace("11, 105, 104", "11, 105, 104\n15, 106, 105"));
}
