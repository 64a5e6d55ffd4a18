//! Running the program, timed and weighed.

use std::ffi::OsString;
use std::process::{Command, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_slideline");
const TIME: &str = "/usr/bin/time";

/// Runs the program, which must come to a good end and is not listened to.
pub fn run(arguments: &[OsString]) {
    let mut command = Command::new(PROGRAM);
    let status = command.args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).status();
    assert!(status.is_ok_and(|status| status.success()), "{arguments:?}");
}

/// Says the largest resident memory of five runs.
pub fn tell_memory(name: &str, arguments: &[OsString]) {
    let once = || {
        let mut command = Command::new(TIME);
        command.args(["-f", "%M", PROGRAM]).args(arguments).stdout(Stdio::null());
        let said = String::from_utf8(command.output().ok()?.stderr).ok()?;
        said.lines().last()?.trim().parse::<u64>().ok()
    };
    match (0..5).map(|_| once()).max().flatten() {
        Some(peak) => println!("{name}: peak memory {:.1} MB", peak as f64 / 1024.0),
        None => println!("{name}: peak memory not measured, {TIME} is missing"),
    }
}
