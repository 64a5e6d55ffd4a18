//! Jobs: what is read, said, written, kept and added from outside.

mod advice;
mod bad_input;
mod block_of_any_type;
mod diagnosis;
mod failed_state;
mod files;
mod fuzz_corpus;
mod keyword_decks;
mod linear_system;
mod own_file;
mod requests;
mod restart;
mod section_print;
mod sensitivities;
mod sensitivity_decks;
mod solid_files;
mod taken_up;
mod time_error_bars;
mod too_large;
mod truss_files;
mod user_element;
mod user_friction;
mod user_material;
