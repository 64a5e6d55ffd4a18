//! The layout of `JOB.rst`, and how states are found in it.
//!
//! ```text
//!   head    "slideline.rst\n"  format  mark  mark
//!           mark: valid length, checksum
//!   section length  checksum | preface: program, options, texts of the decks
//!   section length  checksum | step, increment, result files, summary, state
//!   section ...                                          <- valid length
//! ```
//!
//! A state is appended behind the valid length; then one of the two marks, in
//! turn, makes it count. Whenever a process ends, one mark at least is whole
//! and says where a whole state ends.

use super::{Kept, Preface, Saved};
use crate::summary::Memory;
use slideline_solve::Checkpoint;
use slideline_solve::bytes::{Packed, Unpacking};
use std::io::{ErrorKind, Read, Seek, SeekFrom};

/// How every such file begins.
const MAGIC: &[u8; 14] = b"slideline.rst\n";
/// Version of the layout.
const FORMAT: usize = 3;
/// Bytes before the marks.
const MARKS: usize = 22;
/// Bytes of a mark.
const MARK: usize = 16;
/// Bytes of the head.
pub(super) const HEAD: usize = MARKS + 2 * MARK;
/// Bytes before the content of a section.
const SECTION: u64 = 16;

/// Why a file holds no states, in words.
pub(super) type Reason = String;

/// The head of a file that is valid up to that length.
pub(super) fn head(valid: u64) -> Vec<u8> {
    let mut head = Packed(MAGIC.to_vec());
    head.count(FORMAT);
    [head.0, mark(valid).to_vec(), mark(valid).to_vec()].concat()
}

/// A mark that says so.
pub(super) fn mark(valid: u64) -> [u8; MARK] {
    let valid = valid.to_le_bytes();
    let sum = sum(&[&valid]).to_le_bytes();
    std::array::from_fn(|place| if place < 8 { valid[place] } else { sum[place - 8] })
}

/// Where the mark of that number begins.
pub(super) fn mark_at(number: usize) -> u64 {
    (MARKS + number % 2 * MARK) as u64
}

/// Content as a section.
pub(super) fn section(content: &[u8]) -> Vec<u8> {
    let length = (content.len() as u64).to_le_bytes();
    let mut section = length.to_vec();
    section.extend(sum(&[&length, content]).to_le_bytes());
    section.extend(content);
    section
}

/// FNV-1a, 64 bits: any single changed byte changes it. [manual]
fn sum(parts: &[&[u8]]) -> u64 {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    parts.iter().copied().flatten().fold(0xcbf2_9ce4_8422_2325, step)
}

/// Where a state stands in the file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Place {
    pub step: usize,
    pub increment: usize,
    /// First byte of its section.
    pub start: u64,
    /// One past its last byte.
    pub end: u64,
}

/// A file of states.
pub(super) struct States<R> {
    file: R,
    pub preface: Preface,
    /// In the order in which they were saved.
    pub places: Vec<Place>,
    /// The mark to write next.
    next_mark: usize,
}

impl<R: Read + Seek> States<R> {
    /// Reads everything but the states themselves.
    pub fn open(mut file: R) -> Result<Self, Reason> {
        let size = file.seek(SeekFrom::End(0)).map_err(|reason| reason.to_string())?;
        let (valid, next_mark) = valid_length(&mut file, size)?;
        if valid > size {
            return Err(format!("it has {size} bytes and should have {valid}"));
        }
        let (content, end) = content(&mut file, HEAD as u64, valid)?;
        let mut bytes = Unpacking(&content);
        let preface = Preface::unpack(&mut bytes).filter(|_| bytes.is_done()).ok_or(SENSELESS)?;
        let places = places(&mut file, end, valid)?;
        Ok(Self { file, preface, places, next_mark })
    }

    /// The last state of a step and increment, where they are said.
    pub fn find(&self, step: Option<usize>, increment: Option<usize>) -> Option<Place> {
        let asked = |place: &&Place| {
            step.is_none_or(|step| step == place.step)
                && increment.is_none_or(|increment| increment == place.increment)
        };
        self.places.iter().rev().find(asked).copied()
    }

    /// The state at a place.
    pub fn load(&mut self, place: Place) -> Result<Saved, Reason> {
        let (content, _) = content(&mut self.file, place.start, place.end)?;
        let mut bytes = Unpacking(&content);
        let saved = self.unpack(&mut bytes, place).filter(|_| bytes.is_done());
        saved.ok_or(SENSELESS.to_owned())
    }

    fn unpack(&self, bytes: &mut Unpacking<'_>, place: Place) -> Option<Saved> {
        let said = (bytes.count()?, bytes.count()?);
        let kept = Kept::unpack(bytes)?;
        let memory = Memory::unpack(bytes)?;
        let checkpoint = Checkpoint::unpack(bytes)?;
        let fits = said == (checkpoint.step, checkpoint.increment);
        let preface = self.preface.clone();
        let next_mark = self.next_mark;
        fits.then_some(Saved { checkpoint, preface, kept, memory, place, next_mark })
    }
}

const SENSELESS: &str = "its content is not valid";
const SHORT: &str = "it is shorter than it says";

/// What the marks say; `None` for one that was damaged.
fn marks(file: &mut (impl Read + Seek)) -> Result<[Option<u64>; 2], Reason> {
    file.rewind().map_err(|reason| reason.to_string())?;
    let mut bytes = Vec::with_capacity(HEAD);
    file.take(HEAD as u64).read_to_end(&mut bytes).map_err(|reason| reason.to_string())?;
    let rest = bytes.strip_prefix(MAGIC).ok_or("it was not written by this program")?;
    let mut head = Unpacking(rest);
    match head.count() {
        Some(FORMAT) => {}
        Some(_) => return Err("it was written by another version of this program".to_owned()),
        None => return Err("it is shorter than its own heading".to_owned()),
    }
    let mut valid = || {
        let said = head.count()? as u64;
        let whole = sum(&[&said.to_le_bytes()]) == head.number()?.to_bits();
        Some(whole.then_some(said))
    };
    let marks = valid().zip(valid());
    marks.map(|(a, b)| [a, b]).ok_or("it is shorter than its own heading".to_owned())
}

/// The end of the last state that counts, and the mark to write next. Where a
/// mark was torn the state that it was to speak of is there, whole.
fn valid_length(file: &mut (impl Read + Seek), size: u64) -> Result<(u64, usize), Reason> {
    let (said, next) = match marks(file)? {
        [Some(a), Some(b)] => return Ok((a.max(b), usize::from(a > b))),
        [Some(a), None] => (a, 1),
        [None, Some(b)] => (b, 0),
        [None, None] => return Err("its heading is damaged".to_owned()),
    };
    let mut valid = said;
    while let Ok((_, end)) = content(file, valid, size) {
        valid = end;
    }
    Ok((valid, next))
}

/// The content of the section that begins at `start` and ends at `limit` at
/// the latest, and where it ends. Never more memory than the file has bytes.
fn content(
    file: &mut (impl Read + Seek),
    start: u64,
    limit: u64,
) -> Result<(Vec<u8>, u64), Reason> {
    let (length, said) = section_head(file, start, limit)?;
    let mut content = Vec::new();
    file.take(length).read_to_end(&mut content).map_err(|reason| reason.to_string())?;
    if content.len() as u64 != length {
        return Err(SHORT.to_owned());
    }
    if sum(&[&length.to_le_bytes(), &content]) != said {
        return Err("a checksum is wrong: it was damaged or changed".to_owned());
    }
    Ok((content, start + SECTION + length))
}

/// Length and checksum of the section that begins at `start`.
fn section_head(
    file: &mut (impl Read + Seek),
    start: u64,
    limit: u64,
) -> Result<(u64, u64), Reason> {
    let mut head = [0; 16];
    let read = file.seek(SeekFrom::Start(start)).and_then(|_| file.read_exact(&mut head));
    read.map_err(|reason| match reason.kind() {
        ErrorKind::UnexpectedEof => SHORT.to_owned(),
        _ => reason.to_string(),
    })?;
    let word =
        |place: usize| head[place..].first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes));
    let room = limit.checked_sub(start + SECTION).ok_or(SHORT)?;
    if word(0) > room {
        return Err("a section is longer than the file".to_owned());
    }
    Ok((word(0), word(8)))
}

/// Where the states stand, from their headings alone.
fn places(file: &mut (impl Read + Seek), first: u64, valid: u64) -> Result<Vec<Place>, Reason> {
    let mut places = Vec::new();
    let mut start = first;
    while start < valid {
        let (length, _) = section_head(file, start, valid)?;
        let mut numbers = [0; 16];
        if length < numbers.len() as u64 {
            return Err(SENSELESS.to_owned());
        }
        file.read_exact(&mut numbers).map_err(|reason| reason.to_string())?;
        let mut numbers = Unpacking(&numbers);
        let (step, increment) = numbers.count().zip(numbers.count()).ok_or(SENSELESS)?;
        let end = start + SECTION + length;
        places.push(Place { step, increment, start, end });
        start = end;
    }
    Ok(places)
}
