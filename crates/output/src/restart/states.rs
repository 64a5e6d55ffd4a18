//! The layout of `JOB.rst`, and how states are found in it.
//!
//! ```text
//!   head    "slideline.rst\n"  format  mark  mark
//!           mark: valid length, checksum
//!   section length  checksum | preface: program, options, texts of the decks
//!   section length  checksum | step, increment | result files, summary, state
//!   section ...                                          <- valid length
//! ```
//!
//! A state is appended behind the valid length; then one of the two marks, in
//! turn, makes it count. Contents are those of `postcard`; whoever changes a
//! type that is saved counts the format up. Whenever a process ends, one mark at least is whole
//! and says where a whole state ends.

use super::preface::Preface;
use crate::job::is_ending;
use crate::kept::Kept;
use crate::summary::Memory;
use serde::{Deserialize, Serialize};
use slideline_solve::Checkpoint;
use std::io::{ErrorKind, Read, Seek, SeekFrom};

/// How every such file begins.
const MAGIC: &[u8; 14] = b"slideline.rst\n";
/// Version of the layout, and of the bytes of a state.
const FORMAT: u64 = 21;
/// Bytes before the marks.
const MARKS: usize = 22;
/// Bytes of a mark: a length and its checksum.
const MARK: usize = 12;
/// Bytes of the head.
pub(super) const HEAD: usize = MARKS + 2 * MARK;
/// Bytes before the content of a section: its length and a checksum of both.
const SECTION: usize = 12;
/// Bytes of step and increment, with which the content of a state begins.
const NUMBERS: usize = 16;

/// Why a file holds no states, in words.
pub(super) type Reason = String;

/// A saved state that was read.
#[derive(Clone, Debug)]
pub struct Saved {
    /// Where the run goes on.
    pub checkpoint: Checkpoint<'static>,
    pub(super) preface: Preface,
    pub(crate) kept: Kept,
    pub(crate) memory: Memory,
    pub(crate) place: Place,
    /// The mark of the file to write next.
    pub(super) next_mark: usize,
}

/// What a state consists of.
#[derive(Serialize, Deserialize)]
pub(super) struct Content<'a> {
    pub kept: Kept,
    pub memory: Memory,
    pub checkpoint: Checkpoint<'a>,
}

/// The head of a file that is valid up to that length.
pub(super) fn head(valid: u64) -> Vec<u8> {
    [&MAGIC[..], &FORMAT.to_le_bytes(), &mark(valid), &mark(valid)].concat()
}

/// A mark that says so.
pub(super) fn mark(valid: u64) -> Vec<u8> {
    let valid = valid.to_le_bytes();
    [&valid[..], &sum(&[&valid]).to_le_bytes()].concat()
}

/// Where the mark of that number begins.
pub(super) fn mark_at(number: usize) -> u64 {
    (MARKS + number % 2 * MARK) as u64
}

/// A section of what stands before the states.
pub(super) fn section_of_preface(preface: &Preface) -> Vec<u8> {
    section(&[], preface)
}

/// A state as a section.
pub(super) fn section_of_state(content: &Content<'_>) -> Vec<u8> {
    let Checkpoint { step, increment, .. } = content.checkpoint;
    let numbers = [step, increment].map(|number| (number as u64).to_le_bytes());
    section(&numbers.concat(), content)
}

fn section(first: &[u8], content: &impl Serialize) -> Vec<u8> {
    let mut bytes = vec![0; SECTION];
    bytes.extend(first);
    // a Vec takes any bytes, and values of ours are not refused
    let mut bytes = postcard::to_extend(content, bytes).unwrap_or_default();
    let length = (bytes.len().saturating_sub(SECTION) as u64).to_le_bytes();
    let sum = sum(&[&length, bytes.get(SECTION..).unwrap_or_default()]).to_le_bytes();
    let head = length.iter().chain(&sum);
    bytes.iter_mut().zip(head).for_each(|(byte, own)| *byte = *own);
    bytes
}

/// CRC-32 (IEEE): any single changed byte changes it.
fn sum(parts: &[&[u8]]) -> u32 {
    let mut sum = crc32fast::Hasher::new();
    parts.iter().for_each(|part| sum.update(part));
    sum.finalize()
}

/// A number at the beginning of bytes.
fn number(bytes: &[u8]) -> Option<u64> {
    bytes.first_chunk().map(|bytes| u64::from_le_bytes(*bytes))
}

/// A number and the checksum behind it.
fn summed(bytes: &[u8]) -> Option<(u64, u32)> {
    let said = bytes.get(8..)?.first_chunk()?;
    Some((number(bytes)?, u32::from_le_bytes(*said)))
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
        let preface = whole(&content)?;
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
        let Content { kept, memory, checkpoint } =
            whole(content.get(NUMBERS..).unwrap_or_default())?;
        let fits = (place.step, place.increment) == (checkpoint.step, checkpoint.increment);
        let known = kept.lengths.iter().all(|(ending, _)| is_ending(ending));
        if !(fits && known && kept.states.are_sound() && checkpoint.is_sound()) {
            return Err(SENSELESS.to_owned());
        }
        let (preface, next_mark) = (self.preface.clone(), self.next_mark);
        Ok(Saved { checkpoint, preface, kept, memory, place, next_mark })
    }
}

/// A value that takes all bytes.
fn whole<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Result<T, Reason> {
    match postcard::take_from_bytes(bytes) {
        Ok((value, [])) => Ok(value),
        _ => Err(SENSELESS.to_owned()),
    }
}

const SENSELESS: &str = "its content is not valid";
const SHORT: &str = "it is shorter than it says";
const SHORT_HEAD: &str = "it is shorter than its own heading";

/// What the marks say; `None` for one that was damaged.
fn marks(file: &mut (impl Read + Seek)) -> Result<[Option<u64>; 2], Reason> {
    file.rewind().map_err(|reason| reason.to_string())?;
    let mut bytes = Vec::with_capacity(HEAD);
    file.take(HEAD as u64).read_to_end(&mut bytes).map_err(|reason| reason.to_string())?;
    let rest = bytes.strip_prefix(MAGIC).ok_or("it was not written by this program")?;
    match number(rest) {
        Some(FORMAT) => {}
        Some(_) => return Err("it was written by another version of this program".to_owned()),
        None => return Err(SHORT_HEAD.to_owned()),
    }
    let valid = |at: usize| {
        let bytes = bytes.get(at..)?;
        let (valid, said) = summed(bytes)?;
        Some((sum(&[&valid.to_le_bytes()]) == said).then_some(valid))
    };
    let marks = valid(MARKS).zip(valid(MARKS + MARK));
    marks.map(|(a, b)| [a, b]).ok_or(SHORT_HEAD.to_owned())
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
    Ok((content, start + SECTION as u64 + length))
}

/// Length and checksum of the section that begins at `start`.
fn section_head(
    file: &mut (impl Read + Seek),
    start: u64,
    limit: u64,
) -> Result<(u64, u32), Reason> {
    let mut head = [0; SECTION];
    let read = file.seek(SeekFrom::Start(start)).and_then(|_| file.read_exact(&mut head));
    read.map_err(|reason| match reason.kind() {
        ErrorKind::UnexpectedEof => SHORT.to_owned(),
        _ => reason.to_string(),
    })?;
    let room = limit.checked_sub(start + SECTION as u64).ok_or(SHORT)?;
    match summed(&head) {
        Some((length, sum)) if length <= room => Ok((length, sum)),
        _ => Err("a section is longer than the file".to_owned()),
    }
}

/// Where the states stand, from their headings alone.
fn places(file: &mut (impl Read + Seek), first: u64, valid: u64) -> Result<Vec<Place>, Reason> {
    let mut places = Vec::new();
    let mut start = first;
    while start < valid {
        let (length, _) = section_head(file, start, valid)?;
        let mut numbers = [0; NUMBERS];
        if length < NUMBERS as u64 {
            return Err(SENSELESS.to_owned());
        }
        file.read_exact(&mut numbers).map_err(|reason| reason.to_string())?;
        let number = |at: usize| number(numbers.get(at..)?).and_then(|n| usize::try_from(n).ok());
        let (step, increment) = number(0).zip(number(8)).ok_or(SENSELESS)?;
        let end = start + SECTION as u64 + length;
        places.push(Place { step, increment, start, end });
        start = end;
    }
    Ok(places)
}
