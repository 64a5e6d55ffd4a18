//! The pages of `docs/errors` and of keywords, as they stand in the program.

use slideline_keywords::describe;

/// Codes and their pages, in the order of the codes.
pub const CODE_PAGES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/pages.rs"));

/// The page of a code, as it stands in `docs/errors`.
pub fn code_page(code: &str) -> Option<&'static str> {
    CODE_PAGES.iter().find(|(known, _)| known.eq_ignore_ascii_case(code)).map(|(_, page)| *page)
}

/// The page of a code or of a keyword, with or without its star; `None`: there is none.
pub fn page(name: &str) -> Option<&'static str> {
    let name = name.trim();
    code_page(name).or_else(|| describe(name).map(|found| found.page))
}
