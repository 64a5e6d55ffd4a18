//! CSV files read back, row by row.

use super::problem::{Problem, bytes, unreadable};
use csv::{ErrorKind, Reader, ReaderBuilder, StringRecord};
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// A CSV file with a heading line. Comments (`#`) and blank lines of other
/// programs are passed over; a last line without its end is no row.
pub(crate) struct Table {
    path: PathBuf,
    reader: Reader<Cursor<Vec<u8>>>,
    /// Names of the columns.
    pub columns: Vec<String>,
    row: StringRecord,
    cut: bool,
}

impl Table {
    /// Opens it; its columns must begin with `expected`.
    pub fn open(path: &Path, expected: &[&str]) -> Result<Self, Problem> {
        let mut content = bytes(path)?;
        let whole = content.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
        let cut = whole < content.len();
        content.truncate(whole);
        let mut reader = ReaderBuilder::new().comment(Some(b'#')).from_reader(Cursor::new(content));
        let heading = reader.headers().map_err(|reason| unreadable(path, reason.to_string()))?;
        let columns: Vec<String> = heading.iter().map(|cell| cell.trim().to_owned()).collect();
        if columns.is_empty() {
            return Err(unreadable(path, "it is empty or ends within its first line"));
        }
        let found = columns.iter().map(String::as_str);
        if !found.take(expected.len()).eq(expected.iter().copied()) {
            let reason = format!("its columns do not begin with {}", expected.join(","));
            return Err(unreadable(path, reason));
        }
        Ok(Self { path: path.to_owned(), reader, columns, row: StringRecord::new(), cut })
    }

    /// Index of a column.
    pub fn index(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// The next row; `None` at the end.
    pub fn row(&mut self) -> Result<Option<&StringRecord>, Problem> {
        let there = self.reader.read_record(&mut self.row).map_err(|reason| {
            let reason = match reason.kind() {
                ErrorKind::UnequalLengths { pos, expected_len, len } => format!(
                    "line {} has {len} values, its heading {expected_len}",
                    pos.as_ref().map_or(0, csv::Position::line)
                ),
                _ => reason.to_string(),
            };
            unreadable(&self.path, reason)
        })?;
        Ok(there.then_some(&self.row))
    }

    /// Whether the file ended within a line.
    pub fn is_cut(&self) -> bool {
        self.cut
    }

    /// A cell of the row at hand.
    pub fn cell(&self, index: usize) -> &str {
        self.row.get(index).unwrap_or_default().trim()
    }

    /// A number of the row at hand, of whatever kind.
    pub fn number<T: std::str::FromStr>(&self, index: usize) -> Result<T, Problem> {
        let cell = self.cell(index);
        cell.parse().map_err(|_| {
            let line = self.row.position().map_or(0, csv::Position::line);
            unreadable(&self.path, format!("line {line}: `{cell}` is not a number"))
        })
    }

    /// The numbers of the row at hand from `index` on.
    pub fn numbers(&self, index: usize) -> Result<Vec<f64>, Problem> {
        (index..self.row.len()).map(|index| self.number(index)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: quoted cells keep their commas, comments and blank lines
    /// are none, a row of another length and a cut one are told.
    #[test]
    fn rows_are_read_as_they_were_written() {
        let path = std::env::temp_dir().join(format!("slideline-table-{}", std::process::id()));
        let text = "# other\na, b,c\n\n1,\"a,\"\"b\"\"\",2.5\n3,,-1e-3\n4,5\n6,7,8";
        std::fs::write(&path, text).unwrap();
        let mut table = Table::open(&path, &["a", "b"]).unwrap();
        assert!(table.is_cut() && table.index("c") == Some(2));
        assert!(table.row().unwrap().is_some());
        assert_eq!((table.cell(1), table.number(2).unwrap()), ("a,\"b\"", 2.5));
        assert!(table.row().unwrap().is_some());
        assert!(table.number::<f64>(1).unwrap_err().to_string().contains("line 5: `` is not"));
        let short = table.row().unwrap_err().to_string();
        assert!(short.contains("line 6 has 2 values, its heading 3"), "{short}");
        assert!(table.row().unwrap().is_none(), "a cut line is no row");
        assert!(Table::open(&path, &["b"]).is_err());
        std::fs::write(&path, "a,b").unwrap();
        assert!(Table::open(&path, &[]).is_err());
        std::fs::remove_file(&path).unwrap();
    }
}
