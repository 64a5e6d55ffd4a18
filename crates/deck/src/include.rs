//! Where included files come from.

use std::path::{Path, PathBuf};

/// A file that was found.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// Its name for messages; the same file always has the same name, so that
    /// a file that includes itself is recognised.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Why a file could not be loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LoadError {
    /// There is no such file, or it cannot be read: the reason in words.
    Unreadable(String),
    /// It is larger than what is left of [`crate::MAX_BYTES`].
    TooLarge,
}

/// Finds included files. The crate itself never touches a disk but through
/// [`FromDisk`].
pub trait Loader {
    /// Loads `input` as named in the file `including`, at most `limit` bytes.
    ///
    /// # Errors
    /// When the file cannot be read or is larger than `limit`.
    fn load(&self, including: &str, input: &str, limit: usize) -> Result<Loaded, LoadError>;
}

/// Reads from disk, relative to the folder of the including file.
#[derive(Clone, Copy, Debug, Default)]
pub struct FromDisk;

impl Loader for FromDisk {
    fn load(&self, including: &str, input: &str, limit: usize) -> Result<Loaded, LoadError> {
        use std::io::Read;
        let path = beside(including, input);
        let unreadable = |error: std::io::Error| LoadError::Unreadable(error.to_string());
        let file = std::fs::File::open(&path).map_err(unreadable)?;
        let mut bytes = Vec::new();
        file.take(limit as u64 + 1).read_to_end(&mut bytes).map_err(unreadable)?;
        if bytes.len() > limit {
            return Err(LoadError::TooLarge);
        }
        Ok(Loaded { name: plain(&path), bytes })
    }
}

/// A path as the including file names it.
fn beside(including: &str, input: &str) -> PathBuf {
    Path::new(including).parent().unwrap_or(Path::new("")).join(input)
}

/// `a/./b/../c` as `a/c`, so that one file has one name.
fn plain(path: &Path) -> String {
    use std::path::Component;
    let mut parts: Vec<Component> = Vec::new();
    for part in path.components() {
        match (part, parts.last()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.iter().collect::<PathBuf>().display().to_string()
}

/// Knows no files: every `*INCLUDE` is an error.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Loader for NoFiles {
    fn load(&self, _: &str, _: &str, _: usize) -> Result<Loaded, LoadError> {
        Err(LoadError::Unreadable("files are not read here".to_owned()))
    }
}

/// Knows the texts of a deck that was read from disk before, by name.
#[derive(Clone, Copy, Debug)]
pub struct Texts<'a>(pub &'a [(String, String)]);

impl Loader for Texts<'_> {
    fn load(&self, including: &str, input: &str, limit: usize) -> Result<Loaded, LoadError> {
        let name = plain(&beside(including, input));
        match self.0.iter().find(|(own, _)| *own == name) {
            Some((_, text)) if text.len() > limit => Err(LoadError::TooLarge),
            Some((_, text)) => Ok(Loaded { name, bytes: text.clone().into_bytes() }),
            None => {
                Err(LoadError::Unreadable("it is not among the texts that were kept".to_owned()))
            }
        }
    }
}
