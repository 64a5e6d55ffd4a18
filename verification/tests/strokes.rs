//! No stroke goes wrong silently: contact that is never missed, springback,
//! loads and bodies that are what the deck says, whatever the units.

use slideline_verification::strokes::{Contact, Roller};
use slideline_verification::{Claim, Group, Record, run, worst};

pub const GROUP: Group = Group {
    file: "strokes",
    claims: &[
        Claim {
            name: "a_body_is_not_passed_through",
            requirement: "A roller that moves by more than its size in an increment presses on the \
                          strip as it does in many increments: slave nodes on the strip, contact \
                          integrated along it, full and half circles, first increments up to the \
                          whole step.",
            source: "Without friction the end state does not depend on the way (derived).",
            tolerance: "1e-8 of the force, with residuals held at 1e-10.",
            measure: a_body_is_not_passed_through,
        },
        Claim {
            name: "what_cannot_be_resolved_is_said",
            requirement: "Where no increment allowed catches contact, or a pin is narrower than the \
                          distance of slave nodes, the run ends with a diagnosis.",
            source: "docs/theory.md section 5.8.",
            tolerance: "None: codes.",
            measure: what_cannot_be_resolved_is_said,
        },
        Claim {
            name: "units_change_nothing",
            requirement: "In random units of length and force a stroke takes the same increments and \
                          iterations, and gives the same force.",
            source: "No number in the program has a dimension.",
            tolerance: "None: counts; 1e-9 of the force, for decimal numbers round differently.",
            measure: units_change_nothing,
        },
        Claim {
            name: "released_supports_ramp_off",
            requirement: "A tip that is lifted and let go with OP=NEW is halfway down at half the step \
                          and at rest at its end.",
            source: "[abaqus2006]: released supports let go over the step; small lift, so that the \
                     way is linear.",
            tolerance: "1e-6 of the lift at the half, for the lift is 1e-4 of the length; 1e-12 at \
                        the end.",
            measure: released_supports_ramp_off,
        },
        Claim {
            name: "a_load_on_a_dependent_node",
            requirement: "A force on a node tied by MPC BEAM acts as force and moment on its master.",
            source: "Statics: M = arm x F; small displacements of Timoshenko's beam.",
            tolerance: "1e-3: 20 elements leave 3e-4 where force and moment nearly cancel.",
            measure: a_load_on_a_dependent_node,
        },
        Claim {
            name: "steep_faces_of_a_catch",
            requirement: "Retention faces of 45 to 120 degrees give the same push-in; those that lock \
                          are pulled to a force far beyond it.",
            source: "The hook touches the face behind the crest only after the peak.",
            tolerance: "1e-6 of the peak.",
            measure: steep_faces_of_a_catch,
        },
    ],
};

fn force(roller: &Roller) -> f64 {
    let curve = run(&roller.deck()).unwrap();
    *curve.reaction(Roller::ROLLER, 2).last().unwrap()
}

fn a_body_is_not_passed_through(record: &mut Record) {
    for (contact, full) in [
        (Contact::Nodes, true),
        (Contact::Nodes, false),
        (Contact::Integrated, true),
        (Contact::Integrated, false),
        (Contact::OnRoller, true),
    ] {
        for stroke in [0.1, 0.25] {
            let roller = Roller { contact, full, stroke, ..Roller::default() };
            let reference = force(&Roller { increment: 0.01, ..roller });
            for increment in [0.1, 0.4, 1.0] {
                let off = (force(&Roller { increment, ..roller }) / reference - 1.0).abs();
                let what = format!("{contact:?}, full {full}, stroke {stroke}, from {increment}");
                record.at_most(format!("{what}: force (of that in 100 increments)"), off, 1e-8);
            }
            record.holds(format!("{contact:?}, stroke {stroke}: it presses"), reference < 0.0);
        }
    }
}

fn what_cannot_be_resolved_is_said(record: &mut Record) {
    let said = |roller: Roller| run(&roller.deck()).err().unwrap_or_default();
    for contact in [Contact::Nodes, Contact::Integrated] {
        let roller = Roller { contact, stroke: 0.3, smallest: 1.0, ..Roller::default() };
        record
            .holds(format!("{contact:?}, one increment: SL0519"), said(roller).contains("SL0519"));
    }
    for (radius, place) in [(0.02, 0.55), (0.01, 0.57), (0.03, 0.55)] {
        let roller = Roller { elements: 10, radius, place, increment: 0.02, ..Roller::default() };
        record.holds(format!("pin of radius {radius}: SL0520"), said(roller).contains("SL0520"));
    }
}

fn units_change_nothing(record: &mut Record) {
    for contact in [Contact::Nodes, Contact::Integrated, Contact::OnRoller] {
        let roller = Roller { contact, increment: 0.05, ..Roller::default() };
        let reference = run(&roller.deck()).unwrap();
        let forces = reference.reaction(Roller::ROLLER, 2);
        for units in [[3.7e-6, 1.0], [1e-9, 5.3e-4], [2.3e3, 8.1e5], [0.7, 1.3e-7]] {
            let scaled = run(&Roller { units, ..roller }.deck()).unwrap();
            let counts = |curve: &slideline_verification::Curve| {
                [curve.totals.increments, curve.totals.cutbacks, curve.totals.iterations]
            };
            let what = format!("{contact:?}, units {units:?}");
            let names = ["increments", "cutbacks", "iterations"].into_iter();
            for (name, (own, other)) in
                names.zip(counts(&scaled).into_iter().zip(counts(&reference)))
            {
                record.equal(format!("{what}: {name}"), own, other);
            }
            let own = scaled.reaction(Roller::ROLLER, 2);
            let off = own.iter().zip(&forces).map(|(a, b)| (a / units[1] - b).abs());
            let peak = forces.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
            record.at_most(format!("{what}: force (of peak)"), worst(off) / peak, 1e-9);
        }
    }
}

fn cantilever(steps: &str, more: &str) -> String {
    format!(
        "*HEADING\ncantilever\n*NODE\n1, 0., 0.\n21, 1., 0.\n30, 1., 0.07\n*NGEN\n1, 21\n\
         *ELEMENT, TYPE=B21, ELSET=B\n1, 1, 2\n*ELGEN, ELSET=B\n1, 20\n\
         *BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n0.1, 0.02\n*MATERIAL, NAME=M\n*ELASTIC\n\
         2e9, 0.3\n{more}{steps}"
    )
}

fn released_supports_ramp_off(record: &mut Record) {
    let lift = 1e-4;
    let steps = format!(
        "*STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\n1, 1, 6\n21, 2, 2, {lift:?}\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC, DIRECT\n0.5, 1.\n*BOUNDARY, OP=NEW\n1, 1, 6\n*END STEP\n"
    );
    let curve = run(&cantilever(&steps, "")).unwrap();
    let tip: Vec<f64> = curve.displacement(21, 2);
    let [half, end] = [tip[tip.len() - 2], tip[tip.len() - 1]];
    record.at_most("tip at the half, from half the lift (of it)", (half / lift - 0.5).abs(), 1e-6);
    record.at_most("tip at the end (of the lift)", (end / lift).abs(), 1e-12);
}

fn a_load_on_a_dependent_node(record: &mut Record) {
    let step = "*STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\n1, 1, 6\n*CLOAD\n30, 1, 5e-4\n\
                30, 2, 1e-4\n*END STEP\n";
    let curve = run(&cantilever(step, "*MPC\nBEAM, 30, 21\n")).unwrap();
    // EI, kGA of 0.1 x 0.02; force F at the tip with the moment -0.07 x 5e-4
    let (ei, f, m) = (2e9 * 0.1 * 0.02f64.powi(3) / 12.0, 1e-4, -0.07 * 5e-4);
    let shear = 0.85 * 2e9 / 2.6 * 0.1 * 0.02;
    let expected = f / (3.0 * ei) + f / shear + m / (2.0 * ei);
    let tip = *curve.displacement(21, 2).last().unwrap();
    record.at_most("deflection of the tip (relative)", (tip / expected - 1.0).abs(), 1e-3);
    let moment = *curve.reaction(1, 6).last().unwrap();
    record.at_most("moment of the clamp (relative)", (moment / (-f - m) - 1.0).abs(), 1e-3);
}

/// The tutorial's snap-fit with another face behind the crest, which goes on so
/// far that no hook slides out under it.
fn catch(angle: f64) -> String {
    let deck = include_str!("../../corpus/tutorial/snap_fit.inp");
    let (sin, cos) = angle.to_radians().sin_cos();
    let [x, y] = [57.0 + 0.2 * sin, 1.8 + 0.2 * cos];
    let long = (y + 20.0) / sin;
    let from = deck.find("CIRCL, 57.1").unwrap();
    let to = deck.find("*RIGID BODY, REF NODE=100").unwrap();
    let face = format!(
        "CIRCL, {x:?}, {y:?}, 57.0, 1.8\nLINE, {:?}, {:?}\n",
        x + long * cos,
        y - long * sin
    );
    [&deck[..from], &face, &deck[to..]].concat()
}

fn steep_faces_of_a_catch(record: &mut Record) {
    let peak = |angle: f64| {
        let curve = run(&catch(angle)).unwrap();
        let force = curve.reaction(100, 1);
        let step = |number| {
            let own = curve.rows.iter().zip(&force).filter(move |(row, _)| row.step == number);
            own.map(|(_, force)| *force)
        };
        (step(1).fold(0.0, f64::min), step(2).fold(0.0, f64::max))
    };
    let (reference, _) = peak(45.0);
    for angle in [60.0, 72.0, 75.0, 85.0, 90.0, 105.0, 120.0] {
        let (push, pull) = peak(angle);
        let off = (push / reference - 1.0).abs();
        record.at_most(format!("{angle} degrees: push-in (of that at 45)"), off, 1e-6);
        if angle > 74.0 {
            record.holds(format!("{angle} degrees: locks"), pull > 100.0 * reference.abs());
        }
    }
}
