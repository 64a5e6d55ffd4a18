//! Our own `.vtu` files read back.
//!
//! ```text
//!   <DataArray type="Float64" Name="Points" ...>length bytes, base64</DataArray>
//! ```

use super::problem::{Problem, bytes, unreadable};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use std::path::{Path, PathBuf};

/// The arrays of a state, wherever they are.
pub(crate) trait State {
    /// Where it stands.
    fn path(&self) -> &Path;
    /// Doubles of an array.
    fn doubles(&self, name: &str) -> Result<Vec<f64>, Problem>;
    /// Whole numbers of an array.
    fn long(&self, name: &str) -> Result<Vec<i64>, Problem>;
    /// Short whole numbers of an array.
    fn short(&self, name: &str) -> Result<Vec<i32>, Problem>;
    /// Whole numbers of one byte of an array.
    fn tiny(&self, name: &str) -> Result<Vec<u8>, Problem>;
}

/// A state file.
pub(crate) struct StateFile {
    path: PathBuf,
    text: Vec<u8>,
}

impl StateFile {
    /// Reads a file as this program writes it.
    pub fn open(path: &Path) -> Result<Self, Problem> {
        let text = bytes(path)?;
        let file = Self { path: path.to_owned(), text };
        let head = &file.text[..file.text.len().min(400)];
        let is_ours = [&b"<VTKFile type=\"UnstructuredGrid\""[..], b"header_type=\"UInt32\""]
            .iter()
            .all(|mark| find(head, mark).is_some());
        if !is_ours {
            return Err(unreadable(path, "it is not a state written by this program"));
        }
        if !file.text.trim_ascii_end().ends_with(b"</VTKFile>") {
            return Err(unreadable(path, "it is truncated"));
        }
        Ok(file)
    }

    fn array<T, const N: usize>(
        &self,
        name: &str,
        kind: &str,
        value: impl Fn([u8; N]) -> T,
    ) -> Result<Vec<T>, Problem> {
        let fault = |what: &str| unreadable(&self.path, format!("its array {name} {what}"));
        let mark = format!("<DataArray type=\"{kind}\" Name=\"{name}\"");
        let start = find(&self.text, mark.as_bytes()).ok_or_else(|| fault("is missing"))?;
        let rest = &self.text[start + mark.len()..];
        let open = rest.iter().position(|b| *b == b'>').ok_or_else(|| fault("has no end"))?;
        let rest = &rest[open + 1..];
        let close = rest.iter().position(|b| *b == b'<').ok_or_else(|| fault("has no end"))?;
        let data = STANDARD.decode(&rest[..close]).map_err(|_| fault("is not base64"))?;
        let (length, data) = data.split_first_chunk().ok_or_else(|| fault("has no length"))?;
        if u32::from_le_bytes(*length) as usize != data.len() || data.len() % N != 0 {
            return Err(fault("has another length than it says"));
        }
        Ok(data.as_chunks().0.iter().map(|chunk| value(*chunk)).collect())
    }
}

impl State for StateFile {
    fn path(&self) -> &Path {
        &self.path
    }

    fn doubles(&self, name: &str) -> Result<Vec<f64>, Problem> {
        self.array(name, "Float64", f64::from_le_bytes)
    }

    fn long(&self, name: &str) -> Result<Vec<i64>, Problem> {
        self.array(name, "Int64", i64::from_le_bytes)
    }

    fn short(&self, name: &str) -> Result<Vec<i32>, Problem> {
        self.array(name, "Int32", i32::from_le_bytes)
    }

    fn tiny(&self, name: &str) -> Result<Vec<u8>, Problem> {
        self.array(name, "UInt8", u8::from_le_bytes)
    }
}

fn find(text: &[u8], mark: &[u8]) -> Option<usize> {
    let first = *mark.first()?;
    let mut from = 0;
    while let Some(at) = text.get(from..)?.iter().position(|b| *b == first) {
        let at = from + at;
        if text[at..].starts_with(mark) {
            return Some(at);
        }
        from = at + 1;
    }
    None
}
