//! What ccx is called with.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// What a caller asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    /// Nothing: how it is used.
    Usage,
    /// Which version it is.
    Version,
    /// To run a job; arguments that mean nothing here.
    Job(PathBuf, Vec<String>),
}

/// Whether a program of that name is to behave as ccx: `ccx`, `ccx_2.20_MT`, `CCX.exe`.
pub(crate) fn is_name(program: &OsStr) -> bool {
    let name = Path::new(program).file_name().unwrap_or_default();
    name.to_string_lossy().to_ascii_lowercase().starts_with("ccx")
}

impl Asked {
    /// Reads `JOB`, `-i JOB`, `"-i " JOB` (FreeCAD ends the option with a blank) and `-v`.
    pub fn read(arguments: &[OsString]) -> Self {
        let option = |argument: &OsString| argument.to_string_lossy().trim().to_owned();
        if arguments.iter().any(|argument| option(argument) == "-v") {
            return Self::Version;
        }
        let mut ignored = Vec::new();
        let (mut named, mut plain) = (None, None);
        let mut rest = arguments.iter();
        while let Some(argument) = rest.next() {
            match option(argument).as_str() {
                "-i" => named = rest.next(),
                // the format of results: here it is always .frd
                "-o" => ignored.extend(rest.next().map(|format| format!("-o {}", option(format)))),
                other if other.starts_with('-') => ignored.push(other.to_owned()),
                _ => plain = plain.or(Some(argument)),
            }
        }
        match named.or(plain) {
            Some(job) => Self::Job(PathBuf::from(job), ignored),
            None => Self::Usage,
        }
    }
}

/// Number of threads that `OMP_NUM_THREADS` asks for; one where it says nothing that can be read.
/// It may be a list, of which the first counts. [OpenMP 5.2, section 21.1.2]
pub(super) fn threads(asked: Option<&str>) -> usize {
    let first = asked.unwrap_or_default().split(',').next().unwrap_or_default();
    crate::threads::count(first.trim()).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the calls of PrePoMax and FreeCAD, and ccx' own.
    #[test]
    fn calls_of_ccx_are_understood() {
        let read = |arguments: &[&str]| {
            Asked::read(&arguments.iter().map(OsString::from).collect::<Vec<_>>())
        };
        let job = |name: &str| Asked::Job(name.into(), Vec::new());
        assert_eq!(read(&[]), Asked::Usage);
        assert_eq!(read(&["-i"]), Asked::Usage);
        assert_eq!(read(&["-v"]), Asked::Version);
        assert_eq!(read(&["beam"]), job("beam"));
        assert_eq!(read(&["-i", "beam"]), job("beam"));
        assert_eq!(read(&["-i ", "/a folder/beam"]), job("/a folder/beam"));
        assert_eq!(read(&["beam", "-o", "exo"]), Asked::Job("beam".into(), vec!["-o exo".into()]));
    }

    #[test]
    fn names_that_stand_in_for_ccx() {
        for name in ["ccx", "/usr/bin/ccx", "ccx_2.20_MT", "CCX.exe", "./ccx-link"] {
            assert!(is_name(OsStr::new(name)), "{name}");
        }
        for name in ["slideline", "", "/opt/ccx/slideline", "accx"] {
            assert!(!is_name(OsStr::new(name)), "{name}");
        }
    }

    #[test]
    fn threads_are_those_of_the_environment() {
        let cases = [(None, 1), (Some("4"), 4), (Some(" 3,2"), 3), (Some("0"), 1), (Some("x"), 1)];
        for (asked, count) in cases {
            assert_eq!(threads(asked), count, "{asked:?}");
        }
    }
}
