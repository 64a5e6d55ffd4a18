//! Hostile and broken files.
//!
//! Requirement: limits on lines, values, line length, include depth and size,
//! each with a clear error; no file makes reading hang, and what `*INCLUDE`
//! reads outside the folder of the deck is reported. Source: architecture
//! (deck is total), issue of hostile input.

#![allow(clippy::expect_used)] // a test may stop

use std::path::{Path, PathBuf};

use slideline_deck::{
    FromDisk, LoadError, Loader, MAX_LINE_BYTES, MAX_LINES, MAX_NULS, MAX_PARAMETERS, MAX_VALUES,
    NoFiles, Parsed, parse,
};
use slideline_diag::{FileId, Sources};

fn read(bytes: &[u8]) -> Parsed {
    let parsed = parse(&mut Sources::default(), "a.inp", bytes, &NoFiles);
    assert_eq!(parsed.deck.print(FileId(0)), bytes);
    parsed
}

fn codes(parsed: &Parsed) -> Vec<&'static str> {
    parsed.diagnostics.iter().map(|said| said.code.0).collect()
}

#[test]
fn too_many_lines_are_read_up_to_the_limit() {
    let text = format!("*NODE\n{}", "1\n".repeat(MAX_LINES + 10));
    let parsed = read(text.as_bytes());
    assert_eq!(codes(&parsed), ["SL0124"]);
    assert_eq!(parsed.deck.cards[0].data.len(), MAX_LINES - 1);
    assert_eq!(
        parsed.diagnostics[0].span.expect("a place").start as usize,
        6 + 2 * (MAX_LINES - 1)
    );
}

#[test]
fn too_many_values_are_read_up_to_the_limit() {
    let line = ",".repeat(16) + "\n";
    let parsed = read(format!("*NODE\n{}", line.repeat(MAX_VALUES / 16 + 10)).as_bytes());
    assert_eq!(codes(&parsed), ["SL0124"]);
    assert_eq!(parsed.deck.cards[0].data.len(), MAX_VALUES / 16);
}

#[test]
fn a_line_has_a_length_and_a_keyword_so_many_parameters() {
    let long = format!("*NODE\n{}\n2, 0.\n", "1".repeat(MAX_LINE_BYTES + 1));
    assert_eq!(codes(&read(long.as_bytes())), ["SL0112"]);
    let names: String = (0..=MAX_PARAMETERS).map(|k| format!(", P{k}")).collect();
    let parsed = read(format!("*NODE{names}\n").as_bytes());
    assert_eq!(codes(&parsed), ["SL0113"]);
    assert_eq!(parsed.deck.cards[0].parameters.len(), MAX_PARAMETERS);
    let values = read(format!("*NODE\n{}\n", "1,".repeat(1000)).as_bytes());
    assert_eq!((codes(&values), values.deck.cards[0].data[0].fields.len()), (vec!["SL0113"], 16));
}

#[test]
fn what_is_no_text_is_told_once() {
    let utf16: Vec<u8> = "*HEADING\n*NODE\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(codes(&read(&utf16)), ["SL0110"]);
    assert_eq!(codes(&read(&[0; 100_000])), ["SL0110"]);
    let some = format!("*NODE\n{}", "1\0\n".repeat(MAX_NULS));
    assert_eq!(codes(&read(some.as_bytes())).len(), MAX_NULS, "some are told one by one");
}

#[test]
fn byte_order_mark_and_line_endings_do_not_matter() {
    let parsed = read("\u{feff}*NODE\r\n1, 0.\r\n2, 1.".as_bytes());
    assert_eq!(parsed.diagnostics, []);
    assert_eq!(parsed.deck.cards[0].data.len(), 2);
}

/// A folder of its own that is removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("slideline-{name}-{}", std::process::id()));
        std::fs::create_dir_all(path.join("deck")).expect("a folder");
        Self(path)
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).expect("a file");
    }

    fn deck(&self, input: &str) -> Parsed {
        let name = self.0.join("deck/a.inp").display().to_string();
        let text = format!("*NODE\n*INCLUDE, INPUT={input}\n");
        parse(&mut Sources::default(), &name, text.as_bytes(), &FromDisk)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0); // it is the system's folder for such things
    }
}

#[test]
fn an_include_ends_whatever_it_names() {
    let folder = Folder::new("ends");
    folder.write("deck/part.inp", "1, 0.\n");
    assert_eq!(codes(&folder.deck("part.inp")), [""; 0]);
    assert_eq!(codes(&folder.deck("./../deck/part.inp")), [""; 0]);
    // a deck that was written on Windows
    assert_eq!(codes(&folder.deck("..\\deck\\part.inp")), [""; 0]);
    for (input, words) in [("..", "it is a folder"), ("part.inp/x", ""), ("none", "")] {
        let parsed = folder.deck(input);
        assert_eq!(codes(&parsed), ["SL0120"], "{input}");
        assert!(parsed.diagnostics[0].message.contains(words), "{parsed:?}");
    }
    let open = [folder.0.join("deck/a.inp").display().to_string()];
    assert_eq!(FromDisk.load(&open, "part.inp", 5).err(), Some(LoadError::TooLarge));
}

#[test]
fn a_file_outside_is_read_and_reported() {
    let folder = Folder::new("outside");
    folder.write("part.inp", "1, 0.\n");
    folder.write("deck/near.inp", "*INCLUDE, INPUT=../part.inp\n");
    let absolute = folder.0.join("part.inp").display().to_string();
    for input in ["../part.inp", &absolute, "near.inp"] {
        let parsed = folder.deck(input);
        assert_eq!(codes(&parsed), ["SL0125"], "{input}");
        assert_eq!(parsed.deck.cards[0].data.len(), 1);
    }
}

#[cfg(unix)]
#[test]
fn devices_pipes_and_links_are_seen_for_what_they_are() {
    let folder = Folder::new("devices");
    folder.write("part.inp", "1, 0.\n");
    let link = |from: &str, to: &str| {
        std::os::unix::fs::symlink(Path::new(from), folder.0.join(to)).expect("a link");
    };
    link("../part.inp", "deck/linked.inp");
    assert_eq!(codes(&folder.deck("linked.inp")), ["SL0125"]);
    link("again", "deck/again");
    assert_eq!(codes(&folder.deck("again")), ["SL0120"]);
    let made = std::process::Command::new("mkfifo").arg(folder.0.join("deck/pipe")).status();
    let mut inputs = vec![("/dev/zero", "a device"), ("/dev/null", "a device")];
    if made.is_ok_and(|status| status.success()) {
        inputs.push(("pipe", "a pipe"));
    }
    for (input, words) in inputs {
        let parsed = folder.deck(input);
        assert_eq!(codes(&parsed), ["SL0120"], "{input}");
        assert!(parsed.diagnostics[0].message.contains(words), "{parsed:?}");
    }
}

/// The same file under ever longer names, each file twice.
#[cfg(unix)]
#[test]
fn recursion_under_changing_names_ends() {
    let folder = Folder::new("recursion");
    std::os::unix::fs::symlink(".", folder.0.join("deck/x")).expect("a link");
    folder.write("deck/part.inp", "*INCLUDE, INPUT=x/part.inp\n*INCLUDE, INPUT=x/part.inp\n");
    let parsed = folder.deck("part.inp");
    assert!(codes(&parsed).iter().all(|code| *code == "SL0122" || *code == "SL0115"));
    assert!(parsed.deck.files.len() <= slideline_deck::MAX_FILES);
}
