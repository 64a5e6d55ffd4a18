//! Base64 (RFC 4648, section 4) with padding.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Appends the code of `bytes`.
pub(super) fn push(text: &mut String, bytes: &[u8]) {
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
        }
    }
}
