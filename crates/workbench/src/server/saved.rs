//! Files that a page asks to write: into one folder, under plain names.

use serde_json::{Value, json};
use slideline::output::write_file;
use std::borrow::Cow;
use std::path::Path;

/// Endings that are written.
const ENDINGS: [&str; 3] = [".inp", ".py", ".html"];

/// An answer of the bench; where it is a file, that file is written and the answer says where.
pub(super) fn written<'a>(answer: &'a str, asked: &Value, folder: &Path) -> Cow<'a, str> {
    let Ok(told) = serde_json::from_str::<Value>(answer) else { return answer.into() };
    let word = |own: &Value, key: &str| own.get(key).and_then(Value::as_str).map(str::to_owned);
    let (Some("file"), Some(text)) = (told.get("say").and_then(Value::as_str), word(&told, "text"))
    else {
        return answer.into();
    };
    let id = told.get("id").cloned().unwrap_or_default();
    let wanted = word(asked, "name");
    let is_named = wanted.is_some();
    let name = wanted.or_else(|| word(&told, "name")).unwrap_or_default();
    let refused = |why: &str| json!({"say": "refused", "id": id, "why": why}).to_string().into();
    if !is_plain(&name) {
        return refused("a file has a plain name that ends in .inp, .py or .html");
    }
    let path = folder.join(&name);
    // what the bench calls JOB_set is its own; whatever else is there is somebody's, links too
    if is_named && path.symlink_metadata().is_ok() {
        return refused("a file of that name is there already");
    }
    match write_file(&path, text.as_bytes()) {
        Ok(()) => json!({"say": "written", "id": id, "path": path.display().to_string()})
            .to_string()
            .into(),
        Err(reason) => refused(&reason.to_string()),
    }
}

/// Whether a name is one of a file in the folder, whatever the system: no way out of it, no drive,
/// no hidden file.
fn is_plain(name: &str) -> bool {
    let plain = |own: char| own.is_alphanumeric() || " ._-+".contains(own);
    ENDINGS.iter().any(|end| name.ends_with(end) && name.len() > end.len())
        && name.len() <= 200
        && name.chars().all(plain)
        && !name.starts_with(['.', '-', ' '])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_nowhere_else() {
        for name in ["a.inp", "snap fit-2.inp", "a.b.html", "ü.py"] {
            assert!(is_plain(name), "{name}");
        }
        let bad =
            ["../a.inp", "/a.inp", "a/b.inp", "..\\a.inp", "C:a.inp", ".a.inp", "a.exe", ".inp"];
        for name in bad.into_iter().chain(["a\0.inp", "a.inp/", "-a.inp", ""]) {
            assert!(!is_plain(name), "{name}");
        }
    }
}
