//! Blocks that only touch: nothing presses them together, and nothing happens.

use crate::two_blocks::solved;

/// A block on a wider one, turned by an angle [rad], pressed first or not, then drawn along it at the
/// height at which both touch.
fn deck(angle: f64, kind: &str, friction: &str, is_pressed: bool) -> String {
    let (sine, cosine) = angle.sin_cos();
    let turned = |x: f64, y: f64| [cosine * x - sine * y, sine * x + cosine * y];
    let mut nodes = String::new();
    let mut elements = String::new();
    for (first, at, width, count) in [(0, [0.0, 0.0], 3.0, 6), (100, [0.5, 1.0], 1.0, 4)] {
        for row in 0..2 {
            for k in 0..=count {
                let along = at[0] + width * k as f64 / count as f64;
                let [x, y] = turned(along, at[1] + row as f64);
                nodes += &format!("{}, {x:?}, {y:?}\n", first + 20 * row + k + 1);
            }
        }
        for k in first + 1..=first + count {
            elements += &format!("{k}, {k}, {}, {}, {}\n", k + 1, k + 21, k + 20);
        }
    }
    let step = |along: f64, up: f64, increments: u32| {
        let [x, y] = turned(along, up);
        let dt = 1.0 / f64::from(increments);
        format!(
            "*STEP, NLGEOM\n*STATIC\n{dt:?}, 1.0, 1e-6, {dt:?}\n*BOUNDARY\nLOW, 1, 2\n\
             HIGH, 1, 1, {x:?}\nHIGH, 2, 2, {y:?}\n*END STEP\n"
        )
    };
    let pressed = if is_pressed { step(0.0, -0.01, 2) } else { String::new() };
    format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=CPE4, ELSET=ALL\n{elements}*ELSET, ELSET=UNDER, GENERATE\n1, 6\n\
         *ELSET, ELSET=OVER, GENERATE\n101, 104\n*NSET, NSET=LOW, GENERATE\n1, 7\n\
         *NSET, NSET=HIGH, GENERATE\n121, 125\n*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n\
         *SOLID SECTION, ELSET=ALL, MATERIAL=M\n1.0\n*SURFACE, NAME=TOP\nUNDER, S3\n\
         *SURFACE, NAME=FOOT\nOVER, S1\n*SURFACE INTERACTION, NAME=I\n1.0\n{friction}\
         *CONTACT PAIR, INTERACTION=I, TYPE={kind}\nFOOT, TOP\n{pressed}{}{}",
        step(0.3, 0.0, 5),
        step(0.9, 0.0, 5),
    )
}

/// Requirement: where surfaces only touch, rounding opens and closes points; that gives up no attempt,
/// whichever way the blocks are turned. Before, such runs took up to ten times the increments, and some
/// did not end.
#[test]
fn touching_without_a_force_takes_no_shorter_increments() {
    for angle in [0.0, 0.3, 1.1, 2.0] {
        for kind in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
            for friction in ["", "*FRICTION\n0.4\n"] {
                for (is_pressed, increments) in [(true, 12), (false, 10)] {
                    let taken = solved(&deck(angle, kind, friction, is_pressed)).force.len();
                    assert_eq!(taken, increments, "{angle} {kind} {friction} {is_pressed}");
                }
            }
        }
    }
}
