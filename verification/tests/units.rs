//! The same deck in other units.

use slideline_verification::{
    Claim, Group, Method, Push, Record, Units, largest_difference, peak, run, worst,
};

pub const GROUP: Group = Group {
    file: "units",
    claims: &[
        Claim {
            name: "millimetres",
            requirement: "In millimetres reactions are the same forces.",
            source: "No number in the program has a dimension.",
            tolerance: "1e-9 of the peak: decimal numbers of the deck round differently.",
            measure: millimetres,
        },
        Claim {
            name: "powers_of_two_to_the_bit",
            requirement: "Scaled by powers of two, reactions scale bit for bit.",
            source: "No number in the program has a dimension.",
            tolerance: "None: bits.",
            measure: powers_of_two_to_the_bit,
        },
    ],
};

fn forces(push: &Push) -> Vec<f64> {
    let curve = run(&push.deck()).unwrap();
    let mut forces = curve.reaction(Push::CIRCLE, 2);
    forces.extend(curve.reaction(Push::CIRCLE, 1));
    forces
}

fn millimetres(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-12), ..Push::paper(method) };
            let (metre, units) = (forces(&push), Units { length: 1e3, force: 1.0 });
            let off = largest_difference(&metre, &forces(&Push { units, ..push })) / peak(&metre);
            record.at_most(format!("{method:?}, mu {mu}, largest difference (of peak)"), off, 1e-9);
        }
    }
}

fn powers_of_two_to_the_bit(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, ..Push::paper(method) };
            let metre = forces(&push);
            for (length, force) in [(1024.0, 1.0), (1.0, 0.125), (0.25, 64.0)] {
                let scaled = forces(&Push { units: Units { length, force }, ..push });
                let off = worst(metre.iter().zip(&scaled).map(|(a, b)| (a * force - b).abs()));
                let what = format!("{method:?}, mu {mu}, lengths x {length}, forces x {force}");
                record.at_most(format!("{what}: largest difference"), off, 0.0);
            }
        }
    }
}
