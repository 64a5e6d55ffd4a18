//! `slideline explain`: pages of codes and keywords.

use crate::exit::Exit;
use crate::screen;
use slideline::deck::nearest;
use slideline::keywords::{describe, keywords};

/// Codes and their pages.
const PAGES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/pages.rs"));

/// Prints the page of `name`.
pub(crate) fn explain(name: &str) -> Exit {
    match page(name) {
        Some(page) => {
            screen::print(page);
            if !page.ends_with('\n') {
                screen::print("\n");
            }
            Exit::Completed
        }
        None => {
            screen::error(&unknown(name));
            Exit::Input
        }
    }
}

/// The page of a code, as it stands in `docs/errors`.
pub(crate) fn code_page(code: &str) -> Option<&'static str> {
    PAGES.iter().find(|(known, _)| *known == code).map(|(_, page)| *page)
}

/// All codes with their pages.
pub(crate) fn code_pages() -> &'static [(&'static str, &'static str)] {
    PAGES
}

fn page(name: &str) -> Option<&'static str> {
    let name = name.trim();
    let code = PAGES.iter().find(|(code, _)| code.eq_ignore_ascii_case(name));
    code.map(|(_, page)| *page).or_else(|| describe(name).map(|found| found.page))
}

fn unknown(name: &str) -> String {
    let codes = PAGES.iter().map(|(code, _)| *code);
    let known = codes.chain(keywords().map(|keyword| keyword.name));
    let meant = nearest(name.trim().trim_start_matches('*'), known)
        .map_or_else(String::new, |meant| format!("; did you mean {meant}?"));
    format!("error: there is no page on {name}{meant}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_keywords_are_found_however_they_are_written() {
        assert!(page("sl0601").unwrap().contains("SL0601"));
        assert_eq!(page("slide line"), page("*SLIDE LINE"));
        assert!(page("SLIDE LINE").is_some());
        assert!(page("SL9999").is_none());
        assert!(unknown("SLIDE LIME").contains("did you mean SLIDE LINE?"));
    }
}
