//! How much is read. Each limit has its own error; nothing is cut silently.

/// Longest keyword or data line in bytes, line ending excluded.
pub const MAX_LINE_BYTES: usize = 10_000;

/// Most bytes of a deck, all included files together.
pub const MAX_BYTES: usize = 256 << 20;

/// Most values on one data line (Abaqus manual, input syntax rules).
pub const MAX_VALUES_PER_LINE: usize = 16;

/// Most lines of a deck, all included files together.
pub const MAX_LINES: usize = 5_000_000;

/// Most values on all data lines of a deck; each takes some sixty bytes of
/// memory.
pub const MAX_VALUES: usize = 10_000_000;

/// Most parameters on one keyword line.
pub const MAX_PARAMETERS: usize = 100;

/// NUL bytes that are told one by one; a file with more is no text.
pub const MAX_NULS: usize = 8;

/// Deepest nesting of `*INCLUDE`.
pub const MAX_DEPTH: usize = 16;

/// Most files of one deck, counted each time one is included.
pub const MAX_FILES: usize = 1000;
