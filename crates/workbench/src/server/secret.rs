//! Words that nobody guesses.

use std::io;

/// A word of 256 random bits.
#[derive(Clone)]
pub(super) struct Secret(String);

impl Secret {
    /// A new one.
    pub fn new() -> io::Result<Self> {
        let mut bytes = [0; 32];
        getrandom::fill(&mut bytes).map_err(|reason| io::Error::other(reason.to_string()))?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// The word.
    pub fn word(&self) -> &str {
        &self.0
    }

    /// Whether a word is this one; how long it takes does not tell how much of it is right.
    pub fn is(&self, word: &str) -> bool {
        let (own, other) = (self.0.as_bytes(), word.as_bytes());
        let differs = own.iter().zip(other).fold(0, |sum, (a, b)| sum | (a ^ b));
        own.len() == other.len() && differs == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_whole_word_is_right() {
        let secret = Secret::new().unwrap();
        let word = secret.word().to_owned();
        assert_eq!(word.len(), 64);
        assert!(secret.is(&word) && !secret.is("") && !secret.is(&word[1..]));
        assert!(!secret.is(&Secret::new().unwrap().0));
    }
}
