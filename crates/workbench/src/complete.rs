//! Keywords to complete a line with, and pages that explain.

use crate::answers::refused;
use crate::markdown::fragment;
use serde_json::{Value, json};
use slideline::deck::normalise;
use slideline::keywords::{Takes, describe, keywords, not_read};
use slideline::page;

/// Words that may stand where the cursor is: keywords behind a star, parameters behind a comma.
pub(crate) fn complete(id: &Value, asked: &Value) -> Value {
    let line = asked.get("line").and_then(Value::as_str).unwrap_or_default();
    let column =
        asked.get("column").and_then(Value::as_u64).and_then(|own| usize::try_from(own).ok());
    let before: String = line.chars().take(column.unwrap_or(usize::MAX)).collect();
    let words = words(&before).unwrap_or_default();
    let told = words.into_iter().map(|(word, about)| json!({"word": word, "about": about}));
    json!({"say": "completions", "id": id, "words": told.collect::<Value>()})
}

/// Words for what stands before the cursor; `None`: this is no keyword line.
fn words(before: &str) -> Option<Vec<(String, String)>> {
    let line = before.trim_start().strip_prefix('*').filter(|rest| !rest.starts_with('*'))?;
    let Some((keyword, rest)) = line.split_once(',') else {
        let begun = normalise(line);
        let mut all: Vec<_> = keywords()
            .filter(|own| normalise(own.name).starts_with(&begun))
            .map(|own| (format!("*{}", own.name), meaning(own.page)))
            .collect();
        all.sort();
        return Some(all);
    };
    let begun = normalise(rest.rsplit(',').next().unwrap_or_default());
    let rules = describe(keyword)?.parameters.iter();
    let own = rules.filter(|rule| normalise(rule.name).starts_with(&begun)).map(|rule| {
        let name = match rule.takes {
            Takes::Nothing => rule.name.to_owned(),
            _ => format!("{}=", rule.name),
        };
        (name, String::new())
    });
    Some(own.collect())
}

/// The first sentence of a page.
fn meaning(page: &str) -> String {
    let paragraph = page.split("\n\n").nth(1).unwrap_or_default().replace('\n', " ");
    let end = paragraph.find(". ").unwrap_or(paragraph.trim_end_matches('.').len());
    paragraph[..end].to_owned()
}

/// The page of a keyword or of a code.
pub(crate) fn explain(id: &Value, word: &str) -> Value {
    match page(word) {
        Some(page) => json!({"say": "page", "id": id, "html": fragment(page)}),
        None => {
            let none = || format!("there is no page on {word}");
            refused(id, &not_read(word).map_or_else(none, |said| said.to_string()))
        }
    }
}
