//! The program as its users run it: every command, its words and exit codes.

mod check;
mod command_line;
mod dakota;
mod docs;
mod drop_in;
mod error_bars;
mod faults;
mod further;
mod import;
mod jobs;
mod machine;
mod memory;
mod new;
mod replayed;
mod report;
mod restart;
mod sensitivities;
mod settings;
mod sweep;
mod theory;
mod workbench;
