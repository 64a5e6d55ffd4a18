//! Data arrays: the number of bytes and the bytes, as one base64 text.

use base64::{Engine as _, engine::general_purpose::STANDARD};

/// Zeros that are worth a text of their own [bytes].
const RUN: usize = 48;

/// Takes arrays of a state.
pub(crate) trait Arrays {
    /// Appends doubles, so many a row.
    fn push_floats(&mut self, name: &str, components: usize, values: &[f64]);
    /// Appends whole numbers.
    fn push_long(&mut self, name: &str, values: impl Iterator<Item = u64>);
    /// Appends short whole numbers.
    fn push_short(&mut self, name: &str, values: &[i32]);
    /// Appends types of cells.
    fn push_types(&mut self, values: &[u8]);
}

/// The text of a file on its way.
#[derive(Default)]
pub(super) struct Text {
    pub letters: Vec<u8>,
    /// Bytes that wait to be coded.
    bytes: Vec<u8>,
}

impl Text {
    /// Appends text as it is.
    pub fn push(&mut self, text: &[u8]) {
        self.letters.extend_from_slice(text);
    }

    /// The head of an array, then the number of bytes that follow.
    fn begin(&mut self, kind: &str, name: &str, components: usize, length: usize) {
        for part in ["<DataArray type=\"", kind, "\" Name=\"", name, "\""] {
            self.push(part.as_bytes());
        }
        if components > 1 {
            self.push(format!(" NumberOfComponents=\"{components}\"").as_bytes());
        }
        self.push(b" format=\"binary\">");
        self.bytes.clear();
        self.bytes.extend(u32::try_from(length).unwrap_or(u32::MAX).to_le_bytes());
    }

    /// Zeros: three bytes are four letters A.
    fn code_zeros(&mut self, count: usize) {
        let first = (3 - self.bytes.len() % 3) % 3; // so that nothing is padded between
        self.bytes.extend(&[0; 2][..first]);
        self.code();
        let (threes, rest) = ((count - first) / 3, (count - first) % 3);
        self.letters.resize(self.letters.len() + 4 * threes, b'A');
        self.bytes.extend(&[0; 2][..rest]);
    }

    /// Codes what waits, right into the text.
    fn code(&mut self) {
        let begin = self.letters.len();
        self.letters.resize(begin + self.bytes.len().div_ceil(3) * 4, b'=');
        // the place is as long as the code
        let _ = STANDARD.encode_slice(&self.bytes, &mut self.letters[begin..]);
        self.bytes.clear();
    }

    fn end(&mut self) {
        self.code();
        self.push(b"</DataArray>\n");
    }
}

impl Arrays for Text {
    fn push_floats(&mut self, name: &str, components: usize, values: &[f64]) {
        self.begin("Float64", name, components, 8 * values.len());
        for same in values.chunk_by(|a, b| a.to_bits() == b.to_bits()) {
            if same[0].to_bits() == 0 && 8 * same.len() >= RUN {
                self.code_zeros(8 * same.len());
            } else {
                same.iter().for_each(|value| self.bytes.extend_from_slice(&value.to_le_bytes()));
            }
        }
        self.end();
    }

    fn push_long(&mut self, name: &str, values: impl Iterator<Item = u64>) {
        let values: Vec<u64> = values.map(|value| value.min(i64::MAX as u64)).collect();
        self.begin("Int64", name, 1, 8 * values.len());
        self.bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        self.end();
    }

    fn push_short(&mut self, name: &str, values: &[i32]) {
        self.begin("Int32", name, 1, 4 * values.len());
        self.bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        self.end();
    }

    fn push_types(&mut self, values: &[u8]) {
        self.begin("UInt8", "types", 1, values.len());
        self.bytes.extend_from_slice(values);
        self.end();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the text is the base64 of the count and the bytes, wherever
    /// zeros stand in them.
    #[test]
    fn runs_of_zeros_are_coded_as_anything_else() {
        for length in 0..40 {
            for from in 0..length {
                for to in [from, from + 5, from + 6, from + 7, from + 11, length] {
                    let zero = |k: &usize| (from..to).contains(k);
                    let values: Vec<f64> =
                        (0..length).map(|k| if zero(&k) { 0.0 } else { 0.1 + k as f64 }).collect();
                    let mut text = Text::default();
                    text.push_floats("x", 1, &values);
                    let bytes = values.iter().flat_map(|value| value.to_le_bytes());
                    let count = (8 * length as u32).to_le_bytes();
                    let code = STANDARD.encode(count.into_iter().chain(bytes).collect::<Vec<_>>());
                    let text = String::from_utf8(text.letters).unwrap();
                    assert!(text.contains(&format!(">{code}<")), "{text}");
                }
            }
        }
    }
}
