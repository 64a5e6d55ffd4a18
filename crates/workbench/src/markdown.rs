//! Pages of Markdown as HTML, formulas as MathML.

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html::push_html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Storage, push_mathml};
use slideline::output::report::escaped;

/// A text as a part of another page: its headings are small, and links, which
/// would lead nowhere, are words.
pub fn fragment(text: &str) -> String {
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

/// Formulas become MathML, and links to texts links to pages.
pub fn set(event: Event<'_>) -> Event<'_> {
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
