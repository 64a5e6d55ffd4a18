//! Base64 (RFC 4648, section 4) with padding.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Appends the code of `bytes`.
pub(crate) fn push(text: &mut String, bytes: &[u8]) {
    let letter = |word: u32, place: u32| LETTERS[(word >> (6 * place)) as usize & 63];
    let mut code = Vec::with_capacity(bytes.len().div_ceil(3) * 4);
    let mut triples = bytes.chunks_exact(3);
    for triple in &mut triples {
        let word = u32::from(triple[0]) << 16 | u32::from(triple[1]) << 8 | u32::from(triple[2]);
        code.extend([3, 2, 1, 0].map(|place| letter(word, place)));
    }
    match *triples.remainder() {
        [a] => {
            let word = u32::from(a) << 16;
            code.extend([letter(word, 3), letter(word, 2), b'=', b'=']);
        }
        [a, b] => {
            let word = u32::from(a) << 16 | u32::from(b) << 8;
            code.extend([letter(word, 3), letter(word, 2), letter(word, 1), b'=']);
        }
        _ => {}
    }
    text.push_str(&String::from_utf8_lossy(&code)); // all letters are ASCII
}

/// The bytes of a code; `None` for anything that is none.
pub(crate) fn read(code: &[u8]) -> Option<Vec<u8>> {
    if !code.len().is_multiple_of(4) {
        return None;
    }
    let mut bytes = Vec::with_capacity(code.len() / 4 * 3);
    for (place, letters) in code.chunks_exact(4).enumerate() {
        let last = 4 * (place + 1) == code.len();
        let padding = letters.iter().rev().take_while(|letter| **letter == b'=').count();
        if padding > 2 || (padding > 0 && !last) {
            return None;
        }
        let mut word = 0_u32;
        for &letter in &letters[..4 - padding] {
            word = word << 6 | u32::from(value(letter)?);
        }
        word <<= 6 * padding;
        bytes.extend_from_slice(&word.to_be_bytes()[1..4 - padding]);
    }
    Some(bytes)
}

fn value(letter: u8) -> Option<u8> {
    match letter {
        b'A'..=b'Z' => Some(letter - b'A'),
        b'a'..=b'z' => Some(letter - b'a' + 26),
        b'0'..=b'9' => Some(letter - b'0' + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    /// Requirement: the test vectors of RFC 4648, section 10.
    #[test]
    fn vectors_of_the_standard() {
        let vectors = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, coded) in vectors {
            let mut text = String::new();
            super::push(&mut text, plain.as_bytes());
            assert_eq!(text, coded);
            assert_eq!(super::read(coded.as_bytes()).unwrap(), plain.as_bytes());
        }
    }

    #[test]
    fn what_is_no_code_is_refused() {
        for text in ["Zg=", "Zg", "Z===", "Zg==Zg==", "Z!==", "Zm9v\n"] {
            assert!(super::read(text.as_bytes()).is_none(), "{text}");
        }
    }
}
