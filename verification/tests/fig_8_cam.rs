//! Diehl (1995) Fig. 8: a cam turned into a cantilever, with the project's
//! dimensions (the paper's are lost).

use crate::references::second_continuum;
use slideline::output::plot::Axis;
use slideline_theory::{Reference, SecondProblem};
use slideline_verification::{Cam, Claim, Curve, Group, Record, differ, paper, run, series};

const FIGURE: &str =
    "Diehl (1995), Fig. 8 and its text; linear theory, the softened Reissner beam.";

pub const GROUP: Group = Group {
    file: "fig_8_cam",
    claims: &[
        Claim {
            name: "immediate_follows_theory",
            requirement: "With friction called at once the drive moment follows theory, with \
                          slaves 3 and 4 degrees apart and every degree.",
            source: FIGURE,
            tolerance: "Slaves 3 or 4 degrees apart carry the force up to half a spacing beside \
                        the true point of contact: 0.24 or 0.31 mm times 12 N is 4 or 5 % of the \
                        peak moment with friction; in the mean 1.5 % RMS. Every degree: 0.5 %.",
            measure: immediate_follows_theory,
        },
        Claim {
            name: "fine_cam_meets_the_continuum",
            requirement: "Slaves every half degree share the load as spread pressure does.",
            source: "The continuum C (docs/theory.md).",
            tolerance: "0.3 % of the peak everywhere.",
            measure: fine_cam_meets_the_continuum,
        },
        Claim {
            name: "matfru_loses_most_friction",
            requirement: "With the logic of 1995 most friction is lost, irregularly: every \
                          increment brings a new slave node into contact.",
            source: FIGURE,
            tolerance: "Less than half is kept, and at least two neighbouring increments differ by \
                        30 %.",
            measure: matfru_loses_most_friction,
        },
        Claim {
            name: "integrated_cam_follows_the_continuum",
            requirement: "Contact integrated along 24 B21 has no slave nodes to jump between: the \
                          drive moment follows C with and without friction.",
            source: "The continuum C, the limit of the formulation (docs/theory.md).",
            tolerance: "0.1 % RMS and 0.4 % maximum of the peak, as asked of the first problem.",
            measure: integrated_cam_follows_the_continuum,
        },
    ],
};

const AXES: [&str; 2] = ["turn of the cam (degree)", "RM3 (N m)"];

fn turned() -> Vec<f64> {
    (1..=20).map(|k| 3.0 * f64::from(k)).collect()
}

fn turn(mu: f64, onset: &'static str, spacing: f64) -> Curve {
    let curve = run(&Cam { increments: 20, mu, onset, spacing }.deck()).unwrap();
    assert_eq!(curve.rows.len(), 20, "no cutback");
    curve
}

fn moment(curve: &Curve) -> Vec<f64> {
    curve.reaction(Cam::PIVOT, 6)
}

fn theory(mu: f64, reference: Reference) -> Vec<f64> {
    let rows = SecondProblem::project().rows(mu, 20, reference).unwrap();
    rows[1..].iter().map(|row| row.rm3).collect()
}

fn immediate_follows_theory(record: &mut Record) {
    for (spacing, mu, limit) in
        [(3.0_f64, 0.3, 1.5), (4.0, 0.3, 1.5), (1.0, 0.3, 0.5), (1.0, 0.0, 0.5)]
    {
        let found = moment(&turn(mu, "IMMEDIATE", spacing));
        let linear = differ(&found, &theory(mu, Reference::Linear));
        let area = SecondProblem::project().slave_area(spacing.to_radians());
        let softened = theory(mu, Reference::Softened { area });
        let exact = differ(&found, &softened);
        let what = format!("slaves every {spacing} degrees, mu {mu}, RMS against");
        record.at_most(format!("{what} linear theory (% of peak)"), 100.0 * linear.rms, limit);
        record.at_most(format!("{what} the softened beam (% of peak)"), 100.0 * exact.rms, limit);
        if spacing != 4.0 {
            let title = format!("Drive moment, slaves every {spacing} degrees, mu {mu}");
            let reference: (&str, &[f64]) = ("softened Reissner", &softened);
            record.comparison(title, AXES, &turned(), &[("ISL", &found)], reference);
        }
    }
}

fn fine_cam_meets_the_continuum(record: &mut Record) {
    for mu in [0.0, 0.3] {
        let exact = second_continuum(mu);
        let off = differ(&moment(&turn(mu, "IMMEDIATE", 0.5)), &exact);
        record.tell(format!("mu {mu}, RMS (% of peak)"), 100.0 * off.rms);
        record.at_most(format!("mu {mu}, largest error (% of peak)"), 100.0 * off.max, 0.3);
    }
}

fn matfru_loses_most_friction(record: &mut Record) {
    let [none, full, lost] = [(0.0, "IMMEDIATE"), (0.3, "IMMEDIATE"), (0.3, "MATFRU")]
        .map(|(mu, onset)| moment(&turn(mu, onset, 3.0)));
    // from the second row on the cam touches
    let kept: Vec<f64> =
        (1..20).map(|k| 100.0 * (lost[k] - none[k]) / (full[k] - none[k])).collect();
    let mean = kept.iter().sum::<f64>() / kept.len() as f64;
    record.at_most("friction that is kept, mean (%)", mean, 50.0);
    let jumps = kept.windows(2).filter(|pair| (pair[0] - pair[1]).abs() > 30.0).count();
    record.at_least("neighbouring increments that differ by 30 %", jumps as f64, 2.0);
    let curves: [(&str, &[f64]); 3] =
        [("IMMEDIATE", &full), ("MATFRU (1995)", &lost), ("no friction", &none)];
    let curves = curves.map(|curve| series(&turned(), curve)).to_vec();
    let (x, y) = (Axis::linear(AXES[0]), Axis::linear(AXES[1]));
    record.chart("Drive moment, slaves every 3 degrees, mu 0.3", x, y, curves);
}

fn integrated_cam_follows_the_continuum(record: &mut Record) {
    for (mu, deck) in [(0.0, paper::CAM_SURFACE), (0.3, paper::CAM_SURFACE_MU03)] {
        let (found, exact) = (moment(&run(deck).unwrap()), second_continuum(mu));
        let off = differ(&found, &exact);
        record.at_most(format!("mu {mu}, RMS (% of peak)"), 100.0 * off.rms, 0.1);
        record.at_most(format!("mu {mu}, largest error (% of peak)"), 100.0 * off.max, 0.4);
        let title = format!("Drive moment, integrated contact, mu {mu}");
        let reference: (&str, &[f64]) = ("continuum C", &exact);
        record.comparison(title, AXES, &turned(), &[("24 B21", &found)], reference);
    }
}
