//! Markdown to a page.

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html::push_html};
use slideline::output::report::escaped;
use slideline_workbench::markdown::set;
use std::fmt::Write as _;

/// A page before it is set: where it goes, without ending, and its Markdown.
pub(crate) struct Page {
    /// `theory`, `errors/SL0101`.
    pub path: String,
    /// Markdown.
    pub text: String,
}

const STYLE: &str = include_str!("page.css");

/// The menu: where a line leads and what it says.
const MENU: &[(&str, &str)] = &[
    ("getting-started", "Getting started"),
    ("snap-fit", "A snap-fit"),
    ("paper", "The paper's problem"),
    ("workbench", "The workbench"),
    ("files", "Result files"),
    ("report", "The report"),
    ("studies", "Studies"),
    ("reproduce", "The 1995 study"),
    ("keywords/index", "Keywords"),
    ("errors/index", "Errors"),
    ("user-friction", "User friction"),
    ("theory", "Theory"),
];

/// A page of the site: menu, text, style; nothing is loaded from elsewhere
/// but pictures of the site itself.
pub(super) fn html(page: &Page) -> String {
    let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
    let mut events: Vec<Event<'_>> = Parser::new_ext(&page.text, options).collect();
    name_headings(&mut events);
    let root = if page.path.contains('/') { "../" } else { "" };
    let mut body = String::new();
    push_html(&mut body, events.into_iter().map(set));
    let mut menu = String::new();
    for (path, says) in MENU {
        let here = if *path == page.path { " aria-current=\"page\"" } else { "" };
        let _ = writeln!(menu, "<a href=\"{root}{path}.html\"{here}>{says}</a>"); // a String takes any text
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{} - Slideline</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <nav>\n<a class=\"home\" href=\"{root}index.html\">Slideline</a>\n{menu}</nav>\n\
         <main>\n{body}</main>\n</body>\n</html>\n",
        escaped(title(&page.text)),
    )
}

/// Text of the first heading.
fn title(text: &str) -> &str {
    let line = text.lines().find(|line| line.starts_with("# "));
    line.map_or("", |line| line.trim_start_matches("# "))
}

/// Gives every heading the name that links within the texts use: lower case,
/// blanks as hyphens, other signs left out.
fn name_headings(events: &mut [Event<'_>]) {
    for at in 0..events.len() {
        if !matches!(events[at], Event::Start(Tag::Heading { .. })) {
            continue;
        }
        let mut words = String::new();
        for event in &events[at + 1..] {
            match event {
                Event::End(TagEnd::Heading(_)) => break,
                Event::Text(text) | Event::Code(text) => words.push_str(text),
                _ => {}
            }
        }
        let name: String = words
            .to_lowercase()
            .chars()
            .filter_map(|sign| match sign {
                ' ' => Some('-'),
                sign if sign.is_alphanumeric() || sign == '-' || sign == '_' => Some(sign),
                _ => None,
            })
            .collect();
        if let Event::Start(Tag::Heading { id, .. }) = &mut events[at] {
            *id = Some(CowStr::from(name));
        }
    }
}
