//! Cards and what they mean.

mod as_cae_writes;
mod calculix;
mod corpus;
mod distributions;
mod general_contact;
mod generated_lines;
mod limits_of_use;
mod links;
mod loads;
mod meaning;
mod motions;
mod pairs;
mod paper;
mod parameters;
mod refusals;
mod total;
mod two_squares;
