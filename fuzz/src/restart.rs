//! A saved state of any bytes: refused, or gone on from.

use super::bounded::Bounded;
use slideline::output::restart::unpack;
use slideline::{Job, Model, ReadOptions, SolveOptions, resume};
use std::sync::OnceLock;

/// The deck whose states are the seeds.
pub const DECK: &str = include_str!("../tiny.inp");

fn model() -> &'static Model {
    static MODEL: OnceLock<Model> = OnceLock::new();
    MODEL.get_or_init(|| {
        let read = Job::read_text("tiny", DECK, &ReadOptions::default());
        read.model.expect("the deck of the fuzz targets reads")
    })
}

/// Reads the bytes as a file, and as the content of one whose checksum is
/// right; goes on from what is read.
pub fn check(bytes: &[u8]) {
    go_on(bytes);
    go_on(&sealed(bytes));
}

fn go_on(bytes: &[u8]) {
    let Ok(saved) = unpack(bytes) else { return };
    let _ = resume(model(), &SolveOptions::default(), saved.checkpoint, &mut Bounded::default());
}

/// The content with the heading that makes it a file: format 1, its length,
/// its FNV-1a checksum.
fn sealed(content: &[u8]) -> Vec<u8> {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let sum = content.iter().fold(0xcbf2_9ce4_8422_2325, step);
    let mut file = b"slideline.rst\n".to_vec();
    for number in [1, content.len() as u64, sum] {
        file.extend(number.to_le_bytes());
    }
    file.extend(content);
    file
}
