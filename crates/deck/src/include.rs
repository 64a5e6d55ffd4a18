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
    /// Whether it really lies outside the folder of the deck.
    pub outside: bool,
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
    /// Loads `input` as named in the last of the files that are `open` (the
    /// deck is the first), at most `limit` bytes.
    ///
    /// # Errors
    /// When the file cannot be read or is larger than `limit`.
    fn load(&self, open: &[String], input: &str, limit: usize) -> Result<Loaded, LoadError>;
}

/// What a path leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathKind {
    /// A file, which ends.
    File,
    /// A folder.
    Folder,
    /// A device, such as `/dev/zero`: it may never end.
    Device,
    /// A pipe, a socket and the like: it may never begin.
    Pipe,
}

impl PathKind {
    /// What there is at `path`, symbolic links followed.
    ///
    /// # Errors
    /// The system's: there is nothing, or it must not be seen.
    pub fn of(path: &Path) -> std::io::Result<Self> {
        let kind = std::fs::metadata(path)?.file_type();
        Ok(if kind.is_file() {
            Self::File
        } else if kind.is_dir() {
            Self::Folder
        } else if is_device(kind) {
            Self::Device
        } else {
            Self::Pipe
        })
    }

    /// As in "it is a folder".
    pub fn words(self) -> &'static str {
        match self {
            Self::File => "a file",
            Self::Folder => "a folder",
            Self::Device => "a device, not a file",
            Self::Pipe => "a pipe or a socket, not a file",
        }
    }
}

#[cfg(unix)]
fn is_device(kind: std::fs::FileType) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    kind.is_char_device() || kind.is_block_device()
}

#[cfg(not(unix))]
fn is_device(_: std::fs::FileType) -> bool {
    false
}

/// Reads from disk, relative to the folder of the including file. Only files
/// are read: a device or a pipe may have no end.
#[derive(Clone, Copy, Debug, Default)]
pub struct FromDisk;

impl Loader for FromDisk {
    fn load(&self, open: &[String], input: &str, limit: usize) -> Result<Loaded, LoadError> {
        use std::io::Read;
        let including = open.last().map_or("", String::as_str);
        let path = beside(including, input);
        let unreadable = |error: std::io::Error| LoadError::Unreadable(error.to_string());
        let kind = PathKind::of(&path).map_err(unreadable)?;
        if kind != PathKind::File {
            return Err(LoadError::Unreadable(format!("it is {}", kind.words())));
        }
        let file = std::fs::File::open(&path).map_err(unreadable)?;
        let mut bytes = Vec::new();
        file.take(limit as u64 + 1).read_to_end(&mut bytes).map_err(unreadable)?;
        if bytes.len() > limit {
            return Err(LoadError::TooLarge);
        }
        let deck = open.first().map_or("", String::as_str);
        Ok(Loaded { name: plain(&path), bytes, outside: outside(deck, &path) })
    }
}

fn folder_of(file: &str) -> &Path {
    Path::new(file).parent().unwrap_or(Path::new(""))
}

/// Whether `path` really lies outside the folder of the deck.
fn outside(deck: &str, path: &Path) -> bool {
    let folder = folder_of(deck);
    let folder = if folder == Path::new("") { Path::new(".") } else { folder };
    match (folder.canonicalize(), path.canonicalize()) {
        (Ok(folder), Ok(path)) => !path.starts_with(folder),
        _ => false,
    }
}

/// A path as the including file names it; folders may be written as on Windows.
fn beside(including: &str, input: &str) -> PathBuf {
    folder_of(including).join(input.replace('\\', std::path::MAIN_SEPARATOR_STR))
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
    fn load(&self, _: &[String], _: &str, _: usize) -> Result<Loaded, LoadError> {
        Err(LoadError::Unreadable("files are not read here".to_owned()))
    }
}

/// Knows the texts of a deck that was read from disk before, by name.
#[derive(Clone, Copy, Debug)]
pub struct Texts<'a>(pub &'a [(String, String)]);

impl Loader for Texts<'_> {
    fn load(&self, open: &[String], input: &str, limit: usize) -> Result<Loaded, LoadError> {
        let including = open.last().map_or("", String::as_str);
        let name = plain(&beside(including, input));
        match self.0.iter().find(|(own, _)| *own == name) {
            Some((_, text)) if text.len() > limit => Err(LoadError::TooLarge),
            Some((_, text)) => {
                Ok(Loaded { name, bytes: text.clone().into_bytes(), outside: false })
            }
            None => {
                Err(LoadError::Unreadable("it is not among the texts that were kept".to_owned()))
            }
        }
    }
}
