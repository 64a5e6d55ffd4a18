//! Files that grow by whole lines, and files that appear whole.

use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

/// A file that could not be written.
#[derive(Debug)]
pub struct WriteError {
    /// The file or folder.
    pub path: PathBuf,
    /// The system's reason.
    pub reason: io::Error,
}

impl std::fmt::Display for WriteError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.reason)
    }
}

impl std::error::Error for WriteError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.reason)
    }
}

/// Turns the system's reason into one that names the file.
pub(crate) fn at(path: &Path) -> impl FnOnce(io::Error) -> WriteError + '_ {
    move |reason| WriteError { path: path.to_owned(), reason }
}

/// Name under which a file is written before it takes its own.
pub(crate) fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(PART);
    PathBuf::from(name)
}

/// Ending of files that are not finished.
pub(crate) const PART: &str = ".part";

/// Writes a file whole: under another name first, then renamed. Nothing is
/// left where that fails.
///
/// # Errors
/// When the file cannot be written or renamed.
pub fn replace(path: &Path, content: &[u8]) -> Result<(), WriteError> {
    let part = beside(path);
    let written = std::fs::write(&part, content).and_then(|()| std::fs::rename(&part, path));
    if written.is_err() {
        let _ = std::fs::remove_file(&part); // the first error is the one to tell
    }
    written.map_err(at(path))
}

/// Opens a file to be read. Anything else is refused: a pipe may never begin, a
/// device never end.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    if !std::fs::metadata(path)?.is_file() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a regular file"));
    }
    File::open(path)
}

/// The bytes of a file.
pub(crate) fn read(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open(path)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The text of a file.
pub(crate) fn read_text(path: &Path) -> io::Result<String> {
    io::read_to_string(open(path)?)
}

/// Waits until what was written is on the disk, where the file system can say
/// so. A folder keeps the names of its files.
pub(crate) fn synchronise(path: &Path) -> Result<(), WriteError> {
    use io::ErrorKind::{InvalidInput, NotFound, PermissionDenied, Unsupported};
    match File::open(path).and_then(|file| file.sync_all()) {
        Err(reason)
            if matches!(
                reason.kind(),
                InvalidInput | NotFound | PermissionDenied | Unsupported
            ) =>
        {
            Ok(())
        }
        other => other.map_err(at(path)),
    }
}

/// Room that a file keeps for its next lines [bytes]: a large model has results of megabytes, which
/// would wait for the end of the run.
const KEPT: usize = 1 << 16;

/// A text file that grows by whole lines and is valid after every
/// [`Growing::flush`], however the program ends.
#[derive(Debug)]
pub(crate) struct Growing {
    path: PathBuf,
    file: File,
    length: u64,
    /// Lines that wait for the next flush.
    pub text: String,
}

impl Growing {
    /// Creates the file, empty.
    pub fn create(path: PathBuf) -> Result<Self, WriteError> {
        let file = File::create(&path).map_err(at(&path))?;
        Ok(Self { path, file, length: 0, text: String::new() })
    }

    /// Opens a file, cut back to a length.
    pub fn reopen(path: PathBuf, length: u64) -> Result<Self, WriteError> {
        let open = || {
            let mut file = File::options().write(true).open(&path)?;
            file.set_len(length)?;
            file.seek(SeekFrom::Start(length))?;
            Ok(file)
        };
        let file = open().map_err(at(&path))?;
        Ok(Self { path, file, length, text: String::new() })
    }

    /// Bytes handed to the system.
    pub fn length(&self) -> u64 {
        self.length
    }

    /// Hands the waiting lines to the system; a line that does not fit on a
    /// full disk is taken back whole.
    pub fn flush(&mut self) -> Result<(), WriteError> {
        if self.text.is_empty() {
            return Ok(());
        }
        if let Err(reason) = self.file.write_all(self.text.as_bytes()) {
            // The first error is the one to tell.
            let back = SeekFrom::Start(self.length);
            let _ = self.file.set_len(self.length).and_then(|()| self.file.seek(back));
            return Err(at(&self.path)(reason));
        }
        self.length += self.text.len() as u64;
        self.text.clear();
        self.text.shrink_to(KEPT);
        Ok(())
    }

    /// Gives the file its final name.
    pub fn rename(mut self, path: &Path) -> Result<(), WriteError> {
        self.flush()?;
        std::fs::rename(&self.path, path).map_err(at(path))
    }
}
