//! JSON text, key by key in the order in which it is said.

use crate::number::push_shortest;
use std::fmt::Write as _;

/// An object under construction.
#[derive(Clone, Debug)]
pub struct Object {
    text: String,
}

impl Default for Object {
    fn default() -> Self {
        Self { text: "{".to_owned() }
    }
}

impl Object {
    /// An object without members.
    pub fn new() -> Self {
        Self::default()
    }

    /// A member whose value is JSON text already.
    #[must_use]
    pub fn raw(mut self, key: &str, value: &str) -> Self {
        if self.text.len() > 1 {
            self.text.push(',');
        }
        push_text(&mut self.text, key);
        self.text.push(':');
        self.text.push_str(value);
        self
    }

    /// A text.
    #[must_use]
    pub fn text(self, key: &str, value: &str) -> Self {
        self.raw(key, &text(value))
    }

    /// A text or null.
    #[must_use]
    pub fn optional_text(self, key: &str, value: Option<&str>) -> Self {
        match value {
            Some(value) => self.text(key, value),
            None => self.raw(key, "null"),
        }
    }

    /// A number; null where it is not finite.
    #[must_use]
    pub fn number(self, key: &str, value: f64) -> Self {
        self.raw(key, &number(value))
    }

    /// A whole number.
    #[must_use]
    pub fn count(self, key: &str, value: usize) -> Self {
        self.raw(key, &value.to_string())
    }

    /// True or false.
    #[must_use]
    pub fn flag(self, key: &str, value: bool) -> Self {
        self.raw(key, if value { "true" } else { "false" })
    }

    /// An array of values that are JSON text already.
    #[must_use]
    pub fn array(self, key: &str, values: impl IntoIterator<Item = String>) -> Self {
        self.raw(key, &array(values))
    }

    /// The finished text, on one line.
    pub fn finish(mut self) -> String {
        self.text.push('}');
        self.text
    }
}

/// An array of values that are JSON text already.
pub fn array(values: impl IntoIterator<Item = String>) -> String {
    let values: Vec<String> = values.into_iter().collect();
    format!("[{}]", values.join(","))
}

/// A number; null where it is not finite.
pub fn number(value: f64) -> String {
    let mut text = String::new();
    if value.is_finite() {
        push_shortest(&mut text, value);
    } else {
        text.push_str("null");
    }
    text
}

/// A quoted text.
pub fn text(value: &str) -> String {
    let mut quoted = String::new();
    push_text(&mut quoted, value);
    quoted
}

fn push_text(into: &mut String, value: &str) {
    into.push('"');
    for c in value.chars() {
        match c {
            '"' => into.push_str("\\\""),
            '\\' => into.push_str("\\\\"),
            '\n' => into.push_str("\\n"),
            '\r' => into.push_str("\\r"),
            '\t' => into.push_str("\\t"),
            c if u32::from(c) < 0x20 => {
                let _ = write!(into, "\\u{:04x}", u32::from(c)); // a String takes any text
            }
            c => into.push(c),
        }
    }
    into.push('"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_keep_their_order_and_texts_are_escaped() {
        let inner = Object::new().number("min", -0.5).number("never", f64::NAN).finish();
        let object = Object::new()
            .text("job", "a \"b\"\\\u{1}\n")
            .count("increments", 20)
            .flag("done", true)
            .optional_text("card", None)
            .array("list", [inner])
            .finish();
        assert_eq!(
            object,
            r#"{"job":"a \"b\"\\\u0001\n","increments":20,"done":true,"card":null,"list":[{"min":-0.5,"never":null}]}"#
        );
        assert_eq!(Object::new().finish(), "{}");
    }
}
