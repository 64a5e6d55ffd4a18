//! JSON text to values: enough to read `JOB.json` back.

/// A JSON value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Null,
    Flag(bool),
    Number(f64),
    Text(String),
    List(Vec<Value>),
    /// Members in order.
    Object(Vec<(String, Value)>),
}

/// Lists and objects nested deeper are refused.
const DEPTH: usize = 64;

impl Value {
    /// Reads a whole text.
    ///
    /// # Errors
    /// Where and why it is no JSON.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut reader = Reader { rest: text, length: text.len() };
        let value = reader.value(DEPTH)?;
        reader.blanks();
        if reader.rest.is_empty() { Ok(value) } else { Err(reader.fault("the end")) }
    }

    /// A member of an object.
    pub fn get(&self, key: &str) -> Option<&Self> {
        match self {
            Self::Object(members) => members.iter().find(|(k, _)| k == key).map(|(_, v)| v),
            _ => None,
        }
    }

    /// A member that is a text.
    pub fn text(&self, key: &str) -> Option<&str> {
        match self.get(key)? {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// A member that is a number.
    pub fn number(&self, key: &str) -> Option<f64> {
        match self.get(key)? {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// A member that is a whole number, not negative.
    pub fn count(&self, key: &str) -> Option<usize> {
        let number = self.number(key)?;
        (number >= 0.0 && number.fract() == 0.0 && number < 9e15).then_some(number as usize)
    }

    /// A member that is a list; nothing where there is none.
    pub fn list(&self, key: &str) -> &[Self] {
        match self.get(key) {
            Some(Self::List(values)) => values,
            _ => &[],
        }
    }

    /// Whether a member says true.
    pub fn flag(&self, key: &str) -> bool {
        self.get(key) == Some(&Self::Flag(true))
    }
}

struct Reader<'a> {
    rest: &'a str,
    length: usize,
}

impl Reader<'_> {
    fn fault(&self, wanted: &str) -> String {
        let at = self.length - self.rest.len();
        if self.rest.is_empty() {
            "it ends too early".to_owned()
        } else {
            format!("at byte {at} there is something else than {wanted}")
        }
    }

    fn blanks(&mut self) {
        self.rest = self.rest.trim_start_matches([' ', '\t', '\r', '\n']);
    }

    fn take(&mut self, token: &str) -> bool {
        self.blanks();
        match self.rest.strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn need(&mut self, token: &str) -> Result<(), String> {
        if self.take(token) { Ok(()) } else { Err(self.fault(&format!("`{token}`"))) }
    }

    fn value(&mut self, depth: usize) -> Result<Value, String> {
        if depth == 0 {
            return Err("it is nested too deeply".to_owned());
        }
        self.blanks();
        match self.rest.bytes().next() {
            Some(b'{') => self.object(depth),
            Some(b'[') => self.list(depth),
            Some(b'"') => self.string().map(Value::Text),
            Some(b't') => self.need("true").map(|()| Value::Flag(true)),
            Some(b'f') => self.need("false").map(|()| Value::Flag(false)),
            Some(b'n') => self.need("null").map(|()| Value::Null),
            _ => self.number(),
        }
    }

    fn object(&mut self, depth: usize) -> Result<Value, String> {
        self.need("{")?;
        let mut members = Vec::new();
        if self.take("}") {
            return Ok(Value::Object(members));
        }
        loop {
            self.blanks();
            let key = self.string()?;
            self.need(":")?;
            members.push((key, self.value(depth - 1)?));
            if !self.take(",") {
                self.need("}")?;
                return Ok(Value::Object(members));
            }
        }
    }

    fn list(&mut self, depth: usize) -> Result<Value, String> {
        self.need("[")?;
        let mut values = Vec::new();
        if self.take("]") {
            return Ok(Value::List(values));
        }
        loop {
            values.push(self.value(depth - 1)?);
            if !self.take(",") {
                self.need("]")?;
                return Ok(Value::List(values));
            }
        }
    }

    fn number(&mut self) -> Result<Value, String> {
        let end = self
            .rest
            .find(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)))
            .unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        let number = digits.parse().map_err(|_| self.fault("a value"))?;
        self.rest = rest;
        Ok(Value::Number(number))
    }

    fn string(&mut self) -> Result<String, String> {
        self.need("\"")?;
        let mut text = String::new();
        loop {
            let end = self.rest.find(['"', '\\']).ok_or("it ends within a text")?;
            text.push_str(&self.rest[..end]);
            let quoted = self.rest[end..].starts_with('"');
            self.rest = &self.rest[end + 1..];
            if quoted {
                return Ok(text);
            }
            text.push(self.escape()?);
        }
    }

    fn escape(&mut self) -> Result<char, String> {
        let mut letters = self.rest.chars();
        let letter = letters.next().ok_or("it ends within a text")?;
        self.rest = letters.as_str();
        Ok(match letter {
            'n' => '\n',
            't' => '\t',
            'r' => '\r',
            'b' => '\u{8}',
            'f' => '\u{c}',
            'u' => self.unicode()?,
            other => other,
        })
    }

    fn unicode(&mut self) -> Result<char, String> {
        let first = self.four_digits()?;
        let code = if (0xD800..0xDC00).contains(&first) && self.rest.starts_with("\\u") {
            self.rest = &self.rest[2..];
            let second = self.four_digits()?;
            0x10000 + ((first - 0xD800) << 10) + (second.wrapping_sub(0xDC00) & 0x3FF)
        } else {
            first
        };
        Ok(char::from_u32(code).unwrap_or('\u{FFFD}'))
    }

    fn four_digits(&mut self) -> Result<u32, String> {
        let digits = self.rest.get(..4).ok_or("it ends within a text")?;
        let code = u32::from_str_radix(digits, 16).map_err(|_| self.fault("four digits"))?;
        self.rest = &self.rest[4..];
        Ok(code)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_read_back() {
        let text = "{\"a\": [1, -2.5e-3, true, null], \"b\\n\\u00e9\\ud83d\\ude00\": {\"c\": \"\u{444}\"}}\n";
        let value = Value::read(text).unwrap();
        assert_eq!(value.list("a")[1], Value::Number(-2.5e-3));
        assert_eq!(value.get("b\n\u{e9}\u{1f600}").unwrap().text("c"), Some("\u{444}"));
        assert_eq!(Value::read("[]").unwrap(), Value::List(Vec::new()));
    }

    /// Requirement: a truncated file is told, whatever byte it ends at.
    #[test]
    fn no_beginning_of_a_text_is_taken_for_the_whole() {
        let text = r#"{"a":[1,{"b":"x\u00e9\\"}],"c":true}"#;
        for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)) {
            assert!(Value::read(&text[..end]).is_err(), "{}", &text[..end]);
        }
        let deep = "[".repeat(100_000);
        assert!(Value::read(&deep).is_err());
        for wrong in ["{\"a\" 1}", "[1,]", "{,}", "nul", "\"\\u12\"", "1 2"] {
            assert!(Value::read(wrong).is_err(), "{wrong}");
        }
    }
}
