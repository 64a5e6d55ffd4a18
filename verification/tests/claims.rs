//! All claims, a file each, named by source and figure; measured side by side,
//! then reported in `target/verification`.
//!
//! Every claim states what is required, where that comes from, and why its
//! tolerance is what it is: see [`slideline_verification::Claim`].

// a claim that cannot be run has failed: its helpers may unwrap
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use libtest_mimic::{Arguments, Failed, Trial};
use slideline_verification::{Chapter, Claim, Outcome, write_record, write_report};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

mod again;
mod amplitudes_and_springs;
mod bad_friction;
mod balance;
mod beams_bisshopp_drucker;
mod beams_follower_load;
mod beams_lee_frame;
mod beams_quadratic_and_cubic;
mod beams_roll_up;
mod beams_timoshenko;
mod beams_williams_toggle;
mod capstan;
mod comb;
mod determinism;
mod energy;
mod error_bars;
mod fig_4_methods_without_friction;
mod fig_6_methods_with_friction;
mod fig_8_cam;
mod free_circle;
mod friction_laws;
mod incline;
mod integrated_contact;
mod invariances;
mod jamming;
mod ledger;
mod literal_deck;
mod newton;
mod no_allocation;
mod objectivity;
mod path_independence;
mod push_and_pull;
mod references;
mod return_stroke;
mod rigid_link;
mod solids_beams;
mod solids_cook;
mod solids_frame;
mod solids_nafems;
mod solids_necking;
mod solids_orders;
mod solids_patch;
mod solids_ring;
mod solids_ties;
mod solids_torsion;
mod solids_torus;
mod solids_tubes;
mod stick_slip;
mod sticking;
mod strokes;
mod units;
mod unsymmetric_storage;

/// The report's chapters.
const CHAPTERS: &[Chapter] = &[
    Chapter { title: "References", groups: &[references::GROUP] },
    Chapter {
        title: "Problem 1: a circle pushed along a cantilever",
        groups: &[
            fig_4_methods_without_friction::GROUP,
            fig_6_methods_with_friction::GROUP,
            push_and_pull::GROUP,
            return_stroke::GROUP,
            ledger::GROUP,
        ],
    },
    Chapter { title: "Problem 2: a cam turned into a cantilever", groups: &[fig_8_cam::GROUP] },
    Chapter { title: "Contact integrated along the beam", groups: &[integrated_contact::GROUP] },
    Chapter { title: "No stroke goes wrong silently", groups: &[strokes::GROUP] },
    Chapter { title: "Error bars", groups: &[error_bars::GROUP] },
    Chapter {
        title: "Contact and friction against closed forms",
        groups: &[
            comb::GROUP,
            stick_slip::GROUP,
            sticking::GROUP,
            friction_laws::GROUP,
            incline::GROUP,
            capstan::GROUP,
            jamming::GROUP,
            free_circle::GROUP,
        ],
    },
    Chapter {
        title: "Beams, links and springs",
        groups: &[
            beams_roll_up::GROUP,
            beams_follower_load::GROUP,
            beams_timoshenko::GROUP,
            beams_bisshopp_drucker::GROUP,
            beams_williams_toggle::GROUP,
            beams_lee_frame::GROUP,
            beams_quadratic_and_cubic::GROUP,
            rigid_link::GROUP,
            amplitudes_and_springs::GROUP,
        ],
    },
    Chapter {
        title: "Balance, energy, path",
        groups: &[balance::GROUP, energy::GROUP, path_independence::GROUP],
    },
    Chapter {
        title: "Invariances",
        groups: &[objectivity::GROUP, units::GROUP, invariances::GROUP, determinism::GROUP],
    },
    Chapter {
        title: "The solver",
        groups: &[newton::GROUP, unsymmetric_storage::GROUP, no_allocation::GROUP, again::GROUP],
    },
    Chapter {
        title: "Solids",
        groups: &[
            solids_patch::GROUP,
            solids_ties::GROUP,
            solids_orders::GROUP,
            solids_beams::GROUP,
            solids_cook::GROUP,
            solids_tubes::GROUP,
            solids_nafems::GROUP,
            solids_torus::GROUP,
            solids_ring::GROUP,
            solids_frame::GROUP,
            solids_torsion::GROUP,
            solids_necking::GROUP,
        ],
    },
    Chapter { title: "Bad input", groups: &[literal_deck::GROUP, bad_friction::GROUP] },
];

/// Beside `target/tmp`, wherever the target is.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("verification")
}

/// Measured claims with their places in [`CHAPTERS`].
type Measured = Arc<Mutex<Vec<(usize, Outcome)>>>;

fn main() {
    let arguments = Arguments::from_args();
    if !arguments.list {
        // counts what the whole process allocates: before there are other threads
        no_allocation::count();
        again::count();
    }
    let measured = Measured::default();
    let groups = CHAPTERS.iter().flat_map(|chapter| {
        chapter.groups.iter().map(move |group| (chapter.title, group.file, group.claims))
    });
    let claims = groups.flat_map(|(chapter, file, claims)| {
        claims.iter().map(move |claim| (chapter, file, *claim))
    });
    let trial = |(place, (chapter, file, claim)): (usize, (&'static str, &'static str, Claim))| {
        let measured = Arc::clone(&measured);
        Trial::test(format!("{file}::{}", claim.name), move || {
            judge(place, Outcome::of(chapter, file, claim), &measured)
        })
    };
    let trials: Vec<Trial> = claims.enumerate().map(trial).collect();
    let count = trials.len();
    let conclusion = libtest_mimic::run(&arguments, trials);
    if let Err(reason) = report(count, &measured) {
        eprintln!("the report could not be written: {reason}");
        std::process::exit(101);
    }
    conclusion.exit();
}

fn judge(place: usize, outcome: Outcome, measured: &Measured) -> Result<(), Failed> {
    write_record(&folder(), &outcome)?;
    let said = if outcome.holds() { Ok(()) } else { Err(outcome.objections().into()) };
    measured.lock().unwrap().push((place, outcome));
    said
}

/// Writes the report where all claims were measured, not only a selection.
fn report(count: usize, measured: &Measured) -> std::io::Result<()> {
    let mut measured = std::mem::take(&mut *measured.lock().unwrap());
    if measured.len() == count {
        measured.sort_by_key(|(place, _)| *place);
        let outcomes: Vec<Outcome> = measured.into_iter().map(|(_, outcome)| outcome).collect();
        write_report(&folder(), &outcomes)?;
        println!("report: {}", folder().join("report.html").display());
    }
    Ok(())
}
