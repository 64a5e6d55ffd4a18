//! Elements, materials, constraints and loads, each judged on what runs leave.

mod axes_of_elements;
mod balance;
mod beam_sections;
mod beam_stresses;
mod coupling_weights;
mod couplings;
mod creep_and_relaxation;
mod hardening;
mod heat;
mod heated_lines;
mod initial_stress;
mod joined_forces;
mod kept_shapes;
mod lines;
mod loads;
mod loads_over_steps;
mod middle_nodes;
mod model_change;
mod parts;
mod rubber;
mod solids;
mod space_beams;
mod stabilisation;
mod temperatures;
mod tractions;
mod transform;
