//! Numbers as bytes and back, bit for bit.
//!
//! ```text
//!   f64, counts, flags, text, lists --Packed--> bytes --Unpacking--> the same
//! ```
//!
//! Little-endian, without names or alignment. Reading is bounded by the bytes
//! there are: a list cannot claim more than that, so that a hostile file costs
//! neither memory nor a panic.

/// The largest count that a file may hold; beyond it sums could overflow.
const MOST: u64 = 1 << 48;

/// Bytes that grow.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Packed(pub Vec<u8>);

impl Packed {
    /// Appends a number, bit for bit.
    pub fn number(&mut self, value: f64) {
        self.0.extend(value.to_bits().to_le_bytes());
    }

    /// Appends numbers, their count left out.
    pub fn numbers(&mut self, values: &[f64]) {
        values.iter().for_each(|&value| self.number(value));
    }

    /// Appends a number that may be missing.
    pub fn optional(&mut self, value: Option<f64>) {
        self.flag(value.is_some());
        self.number(value.unwrap_or(0.0));
    }

    /// Appends a count.
    pub fn count(&mut self, value: usize) {
        self.0.extend((value as u64).to_le_bytes());
    }

    /// Appends a flag.
    pub fn flag(&mut self, value: bool) {
        self.0.push(u8::from(value));
    }

    /// Appends one of few.
    pub fn choice(&mut self, value: u8) {
        self.0.push(value);
    }

    /// Appends a list of numbers with its length.
    pub fn list(&mut self, values: &[f64]) {
        self.count(values.len());
        self.numbers(values);
    }

    /// Appends a text with its length.
    pub fn text(&mut self, value: &str) {
        self.count(value.len());
        self.0.extend(value.as_bytes());
    }
}

/// Bytes that are read from their beginning. Every answer is `None` where
/// they do not hold what is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Unpacking<'a>(pub &'a [u8]);

impl Unpacking<'_> {
    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*first)
    }

    /// A number.
    pub fn number(&mut self) -> Option<f64> {
        self.array().map(|bytes| f64::from_bits(u64::from_le_bytes(bytes)))
    }

    /// So many numbers.
    pub fn numbers<const N: usize>(&mut self) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = self.number()?;
        }
        Some(values)
    }

    /// A number that may be missing.
    pub fn optional(&mut self) -> Option<Option<f64>> {
        let there = self.flag()?;
        let value = self.number()?;
        Some(there.then_some(value))
    }

    /// A count, not larger than any run can reach.
    pub fn count(&mut self) -> Option<usize> {
        let value = self.array().map(u64::from_le_bytes)?;
        (value < MOST).then_some(value).and_then(|value| usize::try_from(value).ok())
    }

    /// The length of a list whose members take at least `size` bytes each.
    pub fn length(&mut self, size: usize) -> Option<usize> {
        self.count().filter(|&length| length <= self.0.len() / size.max(1))
    }

    /// A flag.
    pub fn flag(&mut self) -> Option<bool> {
        match self.choice()? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }

    /// One of few.
    pub fn choice(&mut self) -> Option<u8> {
        self.array::<1>().map(|[byte]| byte)
    }

    /// A list of numbers.
    pub fn list(&mut self) -> Option<Vec<f64>> {
        let length = self.length(8)?;
        (0..length).map(|_| self.number()).collect()
    }

    /// A text.
    pub fn text(&mut self) -> Option<String> {
        let length = self.length(1)?;
        let (text, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        String::from_utf8(text.to_vec()).ok()
    }

    /// Whether nothing is left.
    pub fn is_done(&self) -> bool {
        self.0.is_empty()
    }
}
