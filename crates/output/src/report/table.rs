//! CSV files read back, row by row.

use super::problem::{Problem, unreadable};
use std::fs::File;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};

/// A CSV file with a heading line.
pub(crate) struct Table {
    path: PathBuf,
    reader: BufReader<File>,
    /// Names of the columns.
    pub columns: Vec<String>,
    line: usize,
    text: String,
    cells: Vec<String>,
    /// Whether the last line was cut off.
    cut: bool,
}

impl Table {
    /// Opens it; its columns must begin with `expected`.
    pub fn open(path: &Path, expected: &[&str]) -> Result<Self, Problem> {
        let file = crate::file::open(path).map_err(|reason| match reason.kind() {
            std::io::ErrorKind::NotFound => Problem::Missing(path.to_owned()),
            _ => unreadable(path, reason.to_string()),
        })?;
        let mut table = Self {
            path: path.to_owned(),
            reader: BufReader::with_capacity(1 << 16, file),
            columns: Vec::new(),
            line: 0,
            text: String::new(),
            cells: Vec::new(),
            cut: false,
        };
        if !table.advance()? {
            return Err(unreadable(path, "it is empty or ends within its first line"));
        }
        table.columns = table.cells.iter().map(|cell| cell.trim().to_owned()).collect();
        let found = table.columns.iter().map(String::as_str);
        if !found.take(expected.len()).eq(expected.iter().copied()) {
            let reason = format!("its columns do not begin with {}", expected.join(","));
            return Err(unreadable(path, reason));
        }
        Ok(table)
    }

    /// Place of a column.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// The next row; `None` at the end. A last line without its end is no row.
    pub fn row(&mut self) -> Result<Option<&[String]>, Problem> {
        if !self.advance()? {
            return Ok(None);
        }
        if self.cells.len() != self.columns.len() {
            let reason = format!(
                "line {} has {} values, its heading {}",
                self.line,
                self.cells.len(),
                self.columns.len()
            );
            return Err(unreadable(&self.path, reason));
        }
        Ok(Some(&self.cells))
    }

    /// Whether the file ended within a line.
    pub fn is_cut(&self) -> bool {
        self.cut
    }

    /// A number of the row at hand.
    pub fn number(&self, place: usize) -> Result<f64, Problem> {
        let cell = self.cells.get(place).map_or("", |cell| cell.trim());
        cell.parse().map_err(|_| {
            let reason = format!("line {}: `{cell}` is not a number", self.line);
            unreadable(&self.path, reason)
        })
    }

    /// The numbers of the row at hand from `place` on.
    pub fn numbers(&self, place: usize) -> Result<Vec<f64>, Problem> {
        (place..self.cells.len()).map(|place| self.number(place)).collect()
    }

    fn advance(&mut self) -> Result<bool, Problem> {
        loop {
            self.text.clear();
            let read = self.reader.read_line(&mut self.text);
            read.map_err(|reason| unreadable(&self.path, reason.to_string()))?;
            self.line += 1;
            if !self.text.ends_with('\n') {
                self.cut = !self.text.is_empty();
                return Ok(false);
            }
            let line = self.text.trim_end_matches(['\n', '\r']);
            // comments and blank lines stand in files of other programs
            if !line.trim().is_empty() && !line.starts_with('#') {
                split(line, &mut self.cells);
                return Ok(true);
            }
        }
    }
}

/// Cells between commas; a quoted one may hold commas and doubled quotes.
fn split(line: &str, cells: &mut Vec<String>) {
    if !line.contains('"') {
        split_plain(line, cells);
        return;
    }
    cells.clear();
    let mut cell = String::new();
    let mut quoted = false;
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                letters.next();
                cell.push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell)),
            other => cell.push(other),
        }
    }
    cells.push(cell);
}

/// The same without quotation marks: long files have no others, and the cells
/// of the line before are filled again.
fn split_plain(line: &str, cells: &mut Vec<String>) {
    let mut count = 0;
    for part in line.split(',') {
        match cells.get_mut(count) {
            Some(cell) => {
                cell.clear();
                cell.push_str(part);
            }
            None => cells.push(part.to_owned()),
        }
        count += 1;
    }
    cells.truncate(count);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quoted_cells_keep_their_commas() {
        let mut cells = Vec::new();
        split("1,\"a,\"\"b\"\"\",,x", &mut cells);
        assert_eq!(cells, ["1", "a,\"b\"", "", "x"]);
        for (line, expected) in
            [("1,,3", vec!["1", "", "3"]), ("", vec![""]), ("7,8", vec!["7", "8"])]
        {
            split(line, &mut cells);
            assert_eq!(cells, expected);
        }
    }
}
