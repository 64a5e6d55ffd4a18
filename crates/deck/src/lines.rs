//! Bytes to lines, and what is wrong with the bytes of a line.

/// The text of a file with every broken byte replaced by `?`, so that byte
/// positions in text and file agree; and the positions of those bytes.
pub(crate) fn aligned(bytes: &[u8]) -> (String, Vec<usize>) {
    let mut text = String::with_capacity(bytes.len());
    let mut broken = Vec::new();
    for chunk in bytes.utf8_chunks() {
        text.push_str(chunk.valid());
        for _ in chunk.invalid() {
            broken.push(text.len());
            text.push('?');
        }
    }
    (text, broken)
}

/// A line as byte positions: `start..content_end` without its ending,
/// `start..end` with it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RawLine {
    pub start: usize,
    pub content_end: usize,
    pub end: usize,
}

/// The line that begins at `start`. Lines end in LF or CR LF.
pub(crate) fn line_at(text: &str, start: usize) -> RawLine {
    let bytes = text.as_bytes();
    let feed = bytes[start..].iter().position(|&byte| byte == b'\n').map(|found| start + found);
    let end = feed.map_or(bytes.len(), |feed| feed + 1);
    let mut content_end = feed.unwrap_or(bytes.len());
    if feed.is_some() && content_end > start && bytes[content_end - 1] == b'\r' {
        content_end -= 1;
    }
    RawLine { start, content_end, end }
}

/// What kind of line this is at first sight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Look {
    Blank,
    Comment,
    Keyword,
    Data,
}

pub(crate) fn look(content: &str) -> Look {
    let content = strip(content);
    if content.is_empty() {
        Look::Blank
    } else if content.starts_with("**") {
        Look::Comment
    } else if content.starts_with('*') {
        Look::Keyword
    } else {
        Look::Data
    }
}

/// Blanks at both ends and a byte order mark in front taken off.
pub(crate) fn strip(content: &str) -> &str {
    content.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}')
}

/// The position of `part` in `whole`, of which it is a piece.
pub(crate) fn offset(whole: &str, part: &str) -> usize {
    (part.as_ptr() as usize).wrapping_sub(whole.as_ptr() as usize).min(whole.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_bytes_keep_their_place() {
        assert_eq!(aligned(b"a\xffb\xe2\x82"), ("a?b??".to_owned(), vec![1, 3, 4]));
    }

    #[test]
    fn line_endings_are_not_content() {
        let line = line_at("ab\r\nc", 0);
        assert_eq!((line.content_end, line.end), (2, 4));
        let last = line_at("ab\r\nc\r", 4);
        assert_eq!((last.content_end, last.end), (6, 6));
    }
}
