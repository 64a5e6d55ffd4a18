//! Result files of any bytes: the report and plots are made of them, or say
//! what is wrong.
//!
//! An input is a list of files, each behind a line `%% ENDING`; those that it
//! does not name are those of a small job that was run.

use super::restart::DECK;
use slideline::output::JobFiles;
use slideline::output::plot::{Question, csv, curve, figure};
use slideline::output::report::{Options, write};
use slideline::{Job, Quiet, ReadOptions, RunOptions, run};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock};

/// What stands in front of the ending of a file.
const MARK: &[u8] = b"%% ";

/// The small job: its files by their endings, and where they are.
struct Base {
    folder: PathBuf,
    files: BTreeMap<String, Vec<u8>>,
}

fn base() -> &'static Mutex<Base> {
    static BASE: OnceLock<Mutex<Base>> = OnceLock::new();
    BASE.get_or_init(|| {
        let name = format!("slideline-fuzz-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        let read = Job::read_text("tiny", DECK, &ReadOptions::default());
        let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
        let _ = run(&read, &options, &mut Quiet);
        let mut files = BTreeMap::new();
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            if let Some(ending) = name.strip_prefix("tiny") {
                files.insert(ending.to_owned(), std::fs::read(entry.path()).unwrap_or_default());
            }
        }
        assert!(files.contains_key(".history.csv"), "the small job leaves its files");
        Mutex::new(Base { folder, files })
    })
}

/// Endings that an input may replace: what the readers open.
const ENDINGS: [&str; 9] = [
    ".json",
    ".history.csv",
    ".contact.csv",
    ".energy.csv",
    ".msg",
    ".dat",
    "_0000.vtu",
    "_0004.vtu",
    ".overlay",
];

/// Makes a report and two plots.
pub fn check(bytes: &[u8]) {
    let Ok(base) = base().lock() else { return };
    let given = given(bytes);
    let path = |ending: &str| base.folder.join(format!("tiny{ending}"));
    for (ending, content) in &given {
        let _ = std::fs::write(path(ending), content);
    }
    let files = JobFiles::new(base.folder.clone(), "tiny");
    let overlay = path(".overlay");
    let overlay = given.contains_key(".overlay").then_some(overlay.as_path());
    for unfinished in [false, true] {
        let _ = write(&files, &Options { unfinished, overlay, ..Options::default() });
        let question = Question { x: "U2".into(), y: "RF2".into(), node: Some(9), unfinished };
        plot(&files, &question);
        plot(&files, &Question { x: "time".into(), node: None, ..question });
    }
    for ending in given.keys() {
        let _ = match base.files.get(*ending) {
            Some(content) => std::fs::write(path(ending), content),
            None => std::fs::remove_file(path(ending)),
        };
    }
}

fn plot(files: &JobFiles, question: &Question) {
    if let Ok(one) = curve(files, question) {
        let _ = csv(question, &one, Some(&one));
        let figure = figure(question, &one, Some(&one));
        let _ = figure.svg();
    }
}

/// The files that an input names.
fn given(bytes: &[u8]) -> BTreeMap<&'static str, Vec<u8>> {
    let mut given: BTreeMap<&'static str, Vec<u8>> = BTreeMap::new();
    let mut now = None;
    for line in bytes.split_inclusive(|&byte| byte == b'\n') {
        let named = line.strip_prefix(MARK).map(<[u8]>::trim_ascii_end);
        let known = |named: &[u8]| ENDINGS.into_iter().find(|known| known.as_bytes() == named);
        if let Some(ending) = named.and_then(known) {
            now = Some(ending);
            given.insert(ending, Vec::new());
        } else if let Some(content) = now.and_then(|ending| given.get_mut(ending)) {
            content.extend(line);
        }
    }
    given
}
