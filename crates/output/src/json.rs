//! JSON: values as `serde_json` has them, numbers as our files have them.

use crate::number::push_shortest;
use serde::Serialize;
use serde_json::ser::{CharEscape, Formatter, Serializer};
use std::io::{self, Write};

pub use serde_json::{Map, Value, json};

/// A value on one line: numbers as short as they can be read back, null where
/// they are not finite.
pub fn text(value: &impl Serialize) -> String {
    let mut bytes = Vec::new();
    // values of ours are not refused, and a Vec takes any bytes
    let _ = value.serialize(&mut Serializer::with_formatter(&mut bytes, Plain));
    String::from_utf8(bytes).unwrap_or_default()
}

/// An object with what `more` has behind its own members.
#[must_use]
pub fn joined(mut object: Value, more: Value) -> Value {
    if let (Value::Object(members), Value::Object(more)) = (&mut object, more) {
        members.extend(more);
    }
    object
}

struct Plain;

impl Formatter for Plain {
    fn write_f64<W: ?Sized + Write>(&mut self, into: &mut W, value: f64) -> io::Result<()> {
        let mut text = String::new();
        push_shortest(&mut text, value);
        into.write_all(text.as_bytes())
    }

    fn write_char_escape<W: ?Sized + Write>(
        &mut self,
        into: &mut W,
        escape: CharEscape,
    ) -> io::Result<()> {
        match escape {
            CharEscape::Backspace => into.write_all(b"\\u0008"),
            CharEscape::FormFeed => into.write_all(b"\\u000c"),
            other => serde_json::ser::CompactFormatter.write_char_escape(into, other),
        }
    }
}

/// Members of an object that was read; nothing where it has none of that kind.
pub trait Members {
    /// A member that is a text.
    fn text(&self, key: &str) -> Option<&str>;
    /// A member that is a number.
    fn number(&self, key: &str) -> Option<f64>;
    /// A member that is a whole number, not negative.
    fn count(&self, key: &str) -> Option<usize>;
    /// A member that is a list.
    fn list(&self, key: &str) -> &[Value];
    /// Whether a member says true.
    fn flag(&self, key: &str) -> bool;
}

impl Members for Value {
    fn text(&self, key: &str) -> Option<&str> {
        self.get(key)?.as_str()
    }

    fn number(&self, key: &str) -> Option<f64> {
        self.get(key)?.as_f64()
    }

    fn count(&self, key: &str) -> Option<usize> {
        let number = self.number(key)?;
        (number >= 0.0 && number.fract() == 0.0 && number < 9e15).then_some(number as usize)
    }

    fn list(&self, key: &str) -> &[Value] {
        self.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
    }

    fn flag(&self, key: &str) -> bool {
        self.get(key) == Some(&Value::Bool(true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_stay_in_order_and_texts_are_escaped() {
        let object = json!({
            "z": "a \"quoted\" \\ line\nend\t\u{1}\u{8}\u{c}\u{e9}",
            "a": [1, 2],
            "x": 1e-5,
            "y": f64::NAN,
            "whole": 3.0,
            "n": null,
        });
        assert_eq!(
            text(&object),
            "{\"z\":\"a \\\"quoted\\\" \\\\ line\\nend\\t\\u0001\\u0008\\u000c\u{e9}\",\
             \"a\":[1,2],\"x\":1e-5,\"y\":null,\"whole\":3,\"n\":null}"
        );
        let more = joined(json!({"b": 1}), json!({"a": -0.0}));
        assert_eq!(text(&more), "{\"b\":1,\"a\":-0}");
    }

    /// Requirement: every double comes back as it was.
    #[test]
    fn numbers_come_back() {
        for value in [0.1 + 0.2, 5e-324, f64::MAX, 123_456_789.123_456_78, 2.0f64.powi(60)] {
            let back: Value = serde_json::from_str(&text(&json!({ "x": value }))).unwrap();
            assert_eq!(back.number("x").map(f64::to_bits), Some(value.to_bits()), "{value}");
        }
        let read: Value = serde_json::from_str("{\"a\": 3, \"b\": 2.5, \"c\": true}").unwrap();
        assert_eq!((read.count("a"), read.count("b"), read.flag("c")), (Some(3), None, true));
        assert!(read.list("a").is_empty() && read.text("a").is_none());
    }
}
