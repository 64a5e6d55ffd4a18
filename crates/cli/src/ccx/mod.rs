//! Started in place of ccx, as `slideline ccx ...` or under a name that begins with `ccx`
//! (docs/ccx.md): its arguments, what it answers to probes, its words on standard output, its files.
//!
//! ```text
//!   ccx                  Usage: CalculiX.exe -i jobname      201
//!   ccx -v               This is Version 2.20                201
//!   ccx -i JOB, ccx JOB  ... Job finished                    0
//! ```
//!
//! Words, formats and codes measured with ccx 2.20.

mod arguments;
mod observer;
mod run;
mod words;

pub(crate) use arguments::is_name;
pub(crate) use run::ccx;
