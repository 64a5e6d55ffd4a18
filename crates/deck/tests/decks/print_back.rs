//! Requirement: a deck prints back to the bytes that were read, whatever they
//! are, and reading never panics (architecture: "pure and total"). Exact
//! equality: there is nothing to tolerate.

#![allow(clippy::expect_used)] // a test may stop

use proptest::prelude::*;
use slideline_deck::{NoFiles, parse};
use slideline_diag::{FileId, Sources};

fn printed(bytes: &[u8]) -> Vec<u8> {
    let mut sources = Sources::default();
    let parsed = parse(&mut sources, "a.inp", bytes, &NoFiles);
    for diagnostic in &parsed.diagnostics {
        let span = diagnostic.span.expect("a syntax error has a place");
        assert!(span.start <= span.end && span.end as usize <= bytes.len(), "{diagnostic:?}");
        assert!(sources.locate(span).is_some());
    }
    assert_tiled(&parsed.deck.files[0].lines, bytes.len());
    parsed.deck.print(FileId(0))
}

fn assert_tiled(lines: &[slideline_deck::Line], length: usize) {
    let mut at = 0;
    for line in lines {
        assert_eq!(line.span.start, at, "lines follow one another without gap");
        at = line.span.end;
    }
    assert_eq!(at as usize, length);
}

#[test]
fn odd_decks_print_back() {
    let decks: [&[u8]; 9] = [
        b"",
        b"\0\0\n*\n**\n",
        b"*HEADING\r\nd\xfcse\r\n*NODE\r\n1, 0.\r\n",
        b"*NODE,\n NSET=A,\n\n1,2,3",
        b"\xef\xbb\xbf*HEADING\rold\rends",
        b"*INCLUDE\n*INCLUDE, INPUT=x\n1,2\n",
        b"*NODE, NSET=\"a, b\n1, \"\n",
        b"*, NSET=A\n1\n",
        b"*NODE, N\xff=\xff\n\xff,\xfe\n",
    ];
    for deck in decks {
        assert_eq!(printed(deck), deck, "{:?}", String::from_utf8_lossy(deck));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes_print_back(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        prop_assert_eq!(printed(&bytes), bytes);
    }

    #[test]
    fn anything_made_of_deck_characters_prints_back(
        bytes in proptest::collection::vec(
            proptest::sample::select(b"*=,\"\r\n AaE1.-\xc3\xa9\xff\0\t".to_vec()), 0..200)
    ) {
        prop_assert_eq!(printed(&bytes), bytes);
    }
}
