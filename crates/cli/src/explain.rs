//! `slideline explain`: pages of codes and keywords.

use crate::exit::Exit;
use crate::screen;
use slideline::deck::nearest;
use slideline::diag::CATALOGUE;
use slideline::keywords::{keywords, not_read};
use slideline::{CODE_PAGES, page};
use std::fmt::Write as _;

/// The page of the result files.
const FILES: &str = include_str!("../../../docs/files.md");

/// Prints the page of `name`; without a name, what there are pages on.
pub(crate) fn explain(name: &str) -> Exit {
    if name.trim().is_empty() {
        screen::print(&list());
        return Exit::Completed;
    }
    if let (None, Some(said)) = (page(name), not_read(name).or_else(|| column(name))) {
        screen::print(&format!("{said}\n"));
        return Exit::Completed;
    }
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

/// What docs/files.md says of a column of a result file.
fn column(name: &str) -> Option<String> {
    let rows = FILES.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| row.split_once("` | ")).find_map(|(names, meaning)| {
        let own = names.split("`, `").any(|own| own.eq_ignore_ascii_case(name.trim()));
        own.then(|| format!("{names}: {}", meaning.trim_end_matches(['|', ' ']).replace('`', "")))
    })
}

/// Letters of a keyword that the list makes room for.
const USUAL_NAME: usize = 24;

/// All keywords and codes, a line each.
fn list() -> String {
    let mut text = String::from("Keywords (slideline explain KEYWORD prints the page):\n\n");
    let mut all: Vec<_> = keywords().collect();
    all.sort_by_key(|keyword| keyword.name);
    // longer names stand out, or every meaning would begin behind the longest of them
    let widths = all.iter().map(|keyword| keyword.name.len()).filter(|&width| width <= USUAL_NAME);
    let width = widths.max().unwrap_or_default();
    for keyword in all {
        let _ = writeln!(text, "  *{:width$}  {}", keyword.name, meaning(keyword.page)); // a String takes any text
    }
    text.push_str("\nDiagnostic codes (slideline explain CODE prints the page):\n\n");
    for entry in CATALOGUE {
        let _ = writeln!(text, "  {}  {}", entry.code, entry.title); // as above
    }
    text
}

/// The first sentence of a page.
fn meaning(page: &str) -> String {
    let paragraph = page.split("\n\n").nth(1).unwrap_or_default().replace('\n', " ");
    let end = paragraph.find(". ").unwrap_or(paragraph.trim_end_matches('.').len());
    paragraph[..end].to_owned()
}

fn unknown(name: &str) -> String {
    let codes = CODE_PAGES.iter().map(|(code, _)| *code);
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

    #[test]
    fn columns_of_result_files_are_explained() {
        let said = column("copen").unwrap();
        assert!(
            said.starts_with("COPEN: gap") && said.contains("inf: the point faces no"),
            "{said}"
        );
        assert_eq!(column("NOTHING"), None);
    }

    /// Requirement: without a word every keyword and every code stands in the list, each with a
    /// meaning that fits a line.
    #[test]
    fn the_list_has_everything() {
        let list = list();
        for keyword in keywords() {
            let line = list.lines().find(|line| {
                line.trim_start().strip_prefix('*').is_some_and(|rest| {
                    rest.strip_prefix(keyword.name).is_some_and(|rest| rest.starts_with("  "))
                })
            });
            let line = line.unwrap_or_default();
            assert!(
                line.len() > keyword.name.len() + 10 && line.len() < 100,
                "{}: {line}",
                keyword.name
            );
        }
        assert!(CATALOGUE.iter().all(|entry| list.contains(entry.code.0)));
    }
}
