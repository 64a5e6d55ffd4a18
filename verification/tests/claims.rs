//! All claims, one file each, named by source and figure. Every test states
//! what is required, where that comes from, and why its tolerance is what it is.

// a claim that cannot be run has failed: helpers of tests may unwrap
#![allow(clippy::unwrap_used)]

mod amplitudes_and_springs;
mod bad_friction;
mod balance;
mod beams_bisshopp_drucker;
mod beams_quadratic_and_cubic;
mod beams_roll_up;
mod beams_timoshenko;
mod beams_williams_toggle;
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
mod objectivity;
mod path_independence;
mod push_and_pull;
mod return_stroke;
mod rigid_link;
mod stick_slip;
mod sticking;
mod units;
mod unsymmetric_storage;
