//! `slideline workbench`: the address that is served, and the page as one file.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const DECK: &str = include_str!("../../../../corpus/new/snap_fit.inp");

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("workbench").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("snap_fit.inp"), DECK).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let program = env!("CARGO_BIN_EXE_slideline");
    let Output { status, stdout, stderr } =
        Command::new(program).args(arguments).current_dir(folder).output().unwrap();
    (status.code(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

/// Requirement: without the solver as WebAssembly it is said how to get it, and nothing is written;
/// with it the page has it, the deck and everything else inside.
#[test]
fn the_page_as_one_file() {
    let folder = folder("page");
    let write = ["workbench", "snap_fit", "-o", "page.html", "--module", "slideline.wasm"];
    let (code, _, errors) = slideline(&folder, &write);
    assert_eq!(code, Some(1), "{errors}");
    assert!(errors.contains("slideline.wasm") && errors.contains("help:"), "{errors}");
    assert!(!folder.join("page.html").exists());
    std::fs::write(folder.join("slideline.wasm"), b"\0asm").unwrap();
    let (code, said, errors) = slideline(&folder, &write);
    assert_eq!((code, errors.as_str()), (Some(0), ""));
    assert!(said.contains("page.html is written"), "{said}");
    let page = std::fs::read_to_string(folder.join("page.html")).unwrap();
    // gzip begins with these three bytes [RFC 1952]
    assert!(page.contains("id=\"module\">H4sI") && page.contains("A cantilever snap-fit"));
    assert!(!page.contains("** range thickness"));
    let ranged = [&write[..], &["--range", "thickness=1:3"]].concat();
    assert_eq!(slideline(&folder, &ranged).0, Some(0));
    let page = std::fs::read_to_string(folder.join("page.html")).unwrap();
    assert!(page.contains("** range thickness 1.0 3.0"), "a page of one file has its ranges");
}

/// Requirement: decks that are not there and ranges that are none are refused.
#[test]
fn wrong_words_are_refused() {
    let folder = folder("wrong");
    let (code, _, errors) = slideline(&folder, &["workbench", "nothing", "--no-browser"]);
    assert_eq!(code, Some(1), "{errors}");
    assert!(errors.contains("SL0701") && errors.contains("nothing.inp"), "{errors}");
    for range in ["thickness", "thickness=1", "thickness=3:1", "thickness=a:b"] {
        let arguments = ["workbench", "snap_fit", "--no-browser", "--range", range];
        assert_eq!(slideline(&folder, &arguments).0, Some(64), "{range}");
    }
}

/// Requirement: a range of nothing is said before anything is served or written.
#[test]
fn a_range_of_no_parameter_is_refused() {
    let folder = folder("strange");
    let arguments = ["workbench", "snap_fit", "--no-browser", "--range", "thikness=1:3"];
    let (code, _, errors) = slideline(&folder, &arguments);
    assert_eq!(code, Some(1), "{errors}");
    assert!(errors.contains("SL0801") && errors.contains("thikness"), "{errors}");
    let alone = ["workbench", "--no-browser", "--range", "thickness=1:3"];
    assert_eq!(slideline(&folder, &alone).0, Some(64));
}

/// Requirement: the address is of the loopback and has a token; an interrupt ends the program.
#[cfg(unix)]
#[test]
fn the_address_is_printed_and_an_interrupt_ends_it() {
    let folder = folder("served");
    let mut child = Command::new(env!("CARGO_BIN_EXE_slideline"))
        .args(["workbench", "snap_fit.inp", "--no-browser"])
        .current_dir(&folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let address = lines.next().unwrap().unwrap();
    let rest = address.strip_prefix("http://127.0.0.1:").unwrap();
    let (port, token) = rest.split_once("/?token=").unwrap();
    assert!(port.parse::<u16>().is_ok() && token.len() == 64, "{address}");
    assert!(lines.next().unwrap().unwrap().contains("Ctrl-C"));
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert_eq!(child.wait().unwrap().code(), Some(0));
    // it leaves nothing behind
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
}
