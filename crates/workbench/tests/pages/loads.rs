//! Decks that loads drive: no motion is prescribed.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)] // a test may fail where it stands

use crate::exchange::{ask, last, opened, rows};
use serde_json::{Value, json};

/// A cantilever under a load at its end (length, height, width 1; mm, N, MPa).
const CANTILEVER: &str = "*HEADING
a cantilever
*NODE, NSET=ALL
1, 0.0, 0.0
11, 100.0, 0.0
*NGEN, NSET=ALL
1, 11
*ELEMENT, TYPE=B21, ELSET=ARM
1, 1, 2
*ELGEN, ELSET=ARM
1, 10
*BEAM SECTION, SECTION=RECT, ELSET=ARM, MATERIAL=STEEL
10.0, 2.0
*MATERIAL, NAME=STEEL
*ELASTIC
200000.0, 0.3
*STEP
*STATIC
0.25, 1.0, 0.25, 0.25
*BOUNDARY
1, 1, 6
*CLOAD
11, 2, -4.0
6, 2, -1.0
*END STEP
";

fn end(bench: &mut slideline_workbench::Bench, values: &Value) -> (Vec<Value>, Value) {
    let said = ask(bench, &json!({"ask": "solve", "id": 2, "values": values}));
    let end = said.last().unwrap().clone();
    (said, end)
}

/// Requirement: the curve is the sum of the loads over the way of the point that moves most, the
/// figures are those of beam theory, and what is solved for is reached.
#[test]
fn a_load_over_the_way_of_its_point() {
    let (mut bench, deck) = opened("cantilever.inp", CANTILEVER);
    assert_eq!(deck["responses"][0]["name"], "deflection");
    let (said, end) = end(&mut bench, &json!({}));
    let curves = said[0]["curves"].as_array().unwrap();
    let place = end["places"]["curve"].as_u64().unwrap() as usize;
    assert_eq!(
        curves[place],
        json!({"node": 11, "who": "node 11", "motion": "U2", "reaction": "CF2"})
    );
    assert_eq!(end["places"]["inward"], -1.0);
    let own: Vec<[f64; 2]> =
        rows(&said).iter().map(|row| [row[3 + 2 * place], row[4 + 2 * place]]).collect();
    assert_eq!(own.len(), 5);
    // P l^3/(3 E I), and the share of the load in the middle, with shear 1/1000 more
    let stiffness = 200_000.0 * 10.0 * 8.0 / 12.0;
    let expected =
        4.0 * 1e6 / (3.0 * stiffness) + 50f64.powi(2) * (3.0 * 100.0 - 50.0) / (6.0 * stiffness);
    let found = end["figures"]["deflection"].as_f64().unwrap();
    assert!((found / expected - 1.0).abs() < 3e-3, "{found} {expected}");
    for (number, [way, load]) in own.iter().enumerate() {
        let part = number as f64 / 4.0;
        assert!((load + 5.0 * part).abs() < 1e-12 && (way + found * part).abs() < 1e-9, "{own:?}");
    }
    assert!(end["key"][0]["name"] == "largest deflection" && end["key"][1]["text"] == "5");
    let lines = end["verdict"]["lines"].to_string();
    assert!(!lines.contains("no force in or out") && lines.contains("moves by"), "{lines}");
    let aim = json!({"ask": "aim", "id": 3, "parameter": "thickness", "response": "deflection", "wanted": 1.0});
    let aimed = last(&mut bench, &aim);
    assert_eq!((&aimed["say"], &aimed["slopes"]), (&json!("aimed"), &json!("exact")), "{aimed}");
    let thick = aimed["value"].as_f64().unwrap();
    assert!((thick / 2.0 - found.cbrt()).abs() < 2e-3, "{thick}");
    let band = last(&mut bench, &json!({"ask": "band", "id": 4, "tolerances": {"modulus": 0.1}}));
    let of = |name: &str| band[name][4].as_f64().unwrap();
    let half = 0.5 * (of("high") - of("low"));
    assert!((half / (5.0 * 0.1 * 1.644_853_6 / 3f64.sqrt()) - 1.0).abs() < 1e-3, "{half}");
}

/// Requirement: pressures and steps that go on have their curve too, and so has a moment.
#[test]
fn pressures_and_moments_have_a_curve() {
    let second = "*STEP\n*STATIC\n0.5, 1.0, 0.5, 0.5\n*CLOAD\n11, 2, -8.0\n*END STEP\n";
    let moment = CANTILEVER.replace("11, 2, -4.0\n6, 2, -1.0", "11, 6, 20.0") + second;
    let (mut bench, _) = opened("moment.inp", &moment);
    let (said, end) = end(&mut bench, &json!({}));
    let place = end["places"]["curve"].as_u64().unwrap() as usize;
    assert_eq!(said[0]["curves"][place]["reaction"], "CF2", "{end}");
    assert_eq!(said[0]["curves"].as_array().unwrap().len(), 2);
    let last_row = rows(&said).pop().unwrap();
    let both = |place: usize| last_row[4 + 2 * place];
    assert_eq!([both(0).abs().max(both(1).abs()), both(0).abs().min(both(1).abs())], [20.0, 8.0]);
    let text = include_str!("../../../../corpus/keywords/DLOAD.inp");
    let (mut bench, _) = opened("DLOAD.inp", text);
    let said = ask(&mut bench, &json!({"ask": "solve", "id": 2}));
    assert!(!said[0]["curves"].as_array().unwrap().is_empty(), "{}", said[0]["curves"]);
    assert!(said.last().unwrap()["figures"]["deflection"].as_f64().unwrap() > 0.0);
}

/// Requirement: what is driven or loaded along axes of `*TRANSFORM` has its curve along these: that of
/// the model that is not turned. 1e-9.
#[test]
fn curves_are_along_the_axes_of_the_nodes() {
    let driven = CANTILEVER.replace("*CLOAD\n11, 2, -4.0\n6, 2, -1.0\n", "11, 2, 2, -1.0\n");
    for deck in [CANTILEVER, &driven] {
        let turned = deck
            .replace("11, 100.0, 0.0\n", "11, 80.0, 60.0\n")
            .replace("*STEP", "*TRANSFORM, NSET=ALL\n0.8, 0.6, 0.0, -0.6, 0.8, 0.0\n*STEP");
        let curves = [deck, &turned].map(|deck| {
            let (mut bench, _) = opened("cantilever.inp", deck);
            let (said, end) = end(&mut bench, &json!({}));
            let place = end["places"]["curve"].as_u64().unwrap() as usize;
            rows(&said).iter().map(|row| [row[3 + 2 * place], row[4 + 2 * place]]).collect()
        });
        let [plain, turned]: [Vec<[f64; 2]>; 2] = curves;
        assert!(plain.len() == 5 && plain[4].iter().all(|value| value.abs() > 0.1), "{plain:?}");
        for (a, b) in plain.iter().flatten().zip(turned.iter().flatten()) {
            assert!((a - b).abs() < 1e-9, "{plain:?} {turned:?}");
        }
    }
}
