//! Markdown to a page.

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html::push_html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Storage, push_mathml};
use slideline::output::report::escaped;
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

/// A text as a part of another page: its headings are small, and links, which
/// would lead nowhere, are words.
pub(crate) fn fragment(text: &str) -> String {
    let small = |event| match event {
        Event::Start(Tag::Heading { .. }) => Some(Event::Html("<h4>".into())),
        Event::End(TagEnd::Heading(_)) => Some(Event::Html("</h4>".into())),
        Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) => None,
        other => Some(set(other)),
    };
    let mut body = String::new();
    let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
    push_html(&mut body, Parser::new_ext(text, options).filter_map(small));
    body
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

/// Formulas become MathML, and links to texts links to pages.
fn set(event: Event<'_>) -> Event<'_> {
    match event {
        Event::InlineMath(tex) => Event::InlineHtml(formula(&tex, DisplayMode::Inline).into()),
        Event::DisplayMath(tex) => Event::Html(equation(&tex).into()),
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let dest_url = leads_to(dest_url);
            Event::Start(Tag::Link { link_type, dest_url, title, id })
        }
        other => other,
    }
}

/// Where a link of a text leads from a page; sources stand in the repository.
fn leads_to(target: CowStr<'_>) -> CowStr<'_> {
    let source = target.trim_start_matches("../");
    if target.contains("://") {
        target
    } else if ["crates/", "corpus/", "verification/"].iter().any(|root| source.starts_with(root)) {
        format!("{}/blob/main/{source}", env!("CARGO_PKG_REPOSITORY")).into()
    } else {
        target.replace(".md", ".html").into()
    }
}

/// A displayed equation with its number beside it.
fn equation(tex: &str) -> String {
    let (left, number) = match tex.split_once("\\tag{") {
        Some((before, rest)) => match rest.split_once('}') {
            Some((number, after)) => (format!("{before}{after}"), Some(number)),
            None => (tex.to_owned(), None),
        },
        None => (tex.to_owned(), None),
    };
    let formula = formula(&left, DisplayMode::Block);
    match number {
        Some(number) => format!(
            "<span class=\"equation\" id=\"eq-{0}\">{formula}<span class=\"number\">({0})</span></span>",
            escaped(number)
        ),
        None => format!("<span class=\"equation\">{formula}</span>"),
    }
}

/// MathML; TeX as it stands where it cannot be set.
fn formula(tex: &str, display_mode: DisplayMode) -> String {
    let storage = Storage::new();
    let read: Result<Vec<_>, _> = pulldown_latex::Parser::new(tex, &storage).collect();
    let mut text = String::new();
    let set = read.ok().and_then(|events| {
        let events = events.into_iter().map(Ok::<_, std::fmt::Error>);
        let config = RenderConfig { display_mode, ..RenderConfig::default() };
        push_mathml(&mut text, events, config).ok()
    });
    match set {
        Some(()) => text,
        None => format!("<code class=\"tex\">{}</code>", escaped(tex)),
    }
}
