//! The bench: a deck, and answers to what a page asks.

use crate::answers::refused;
use crate::deck::Opened;
use crate::kinds::{KINDS, kind};
use crate::slider::Range;
use crate::solve::Room;
use crate::values::Values;
use crate::{aim, band, complete, save, solve};
use serde_json::{Value, json};
use slideline::output::json::text;
use slideline::output::picture;
use slideline::{Job, Read, ReadOptions};

/// Reads a deck: name and text.
pub type Reader = Box<dyn Fn(&str, &str) -> Read + Send>;

/// A deck whose numbers follow sliders.
///
/// Messages are JSON texts (`protocol.md`). What the bench says goes to a function that tells whether
/// to go on: `false` ends a solve, because a newer one is asked for. It is also asked with an empty
/// text, which is no message, only to hear that.
pub struct Bench {
    opened: Option<Opened>,
    /// The deck that it was started with.
    first: Option<(String, String)>,
    ranges: Vec<Range>,
    read: Reader,
    clock: Option<Box<dyn Fn() -> f64 + Send>>,
    room: Room,
}

impl Default for Bench {
    fn default() -> Self {
        Self::new()
    }
}

impl Bench {
    /// One without a deck, which reads decks from memory: they include nothing.
    pub fn new() -> Self {
        let read = |name: &str, text: &str| {
            Job::read_text(name.strip_suffix(".inp").unwrap_or(name), text, &ReadOptions::default())
        };
        Self {
            opened: None,
            first: None,
            ranges: Vec::new(),
            read: Box::new(read),
            clock: None,
            room: Room::default(),
        }
    }

    /// The same with a deck: its name, with `.inp`, and its text.
    #[must_use]
    pub fn with_deck(mut self, name: &str, text: &str) -> Self {
        self.first = Some((name.to_owned(), text.to_owned()));
        self
    }

    /// The same with ends of sliders that stand above those of the deck.
    #[must_use]
    pub fn with_ranges(mut self, ranges: Vec<Range>) -> Self {
        self.ranges = ranges;
        self
    }

    /// The same with another reader, such as one of decks that include files.
    #[must_use]
    pub fn with_reader(mut self, read: Reader) -> Self {
        self.read = read;
        self
    }

    /// The same with a clock [ms], by which rows are sent in batches.
    #[must_use]
    pub fn with_clock(mut self, clock: Box<dyn Fn() -> f64 + Send>) -> Self {
        self.clock = Some(clock);
        self
    }

    /// Names of said ranges that are no parameters of the deck that it was started with; none where
    /// there is no sound deck.
    pub fn strange_ranges(&self) -> Vec<&str> {
        let Some((name, text)) = &self.first else { return Vec::new() };
        let opened = Opened::new(name, text, &self.ranges, &*self.read);
        let known = |own: &Range| opened.sliders.iter().any(|slider| slider.name == own.name);
        let strange = self.ranges.iter().filter(|own| opened.parametric.is_some() && !known(own));
        strange.map(|own| own.name.as_str()).collect()
    }

    /// Answers a message.
    pub fn answer(&mut self, message: &str, say: &mut dyn FnMut(&str) -> bool) {
        let asked: Value = match serde_json::from_str(message) {
            Ok(asked) => asked,
            Err(reason) => {
                say(&text(&refused(&Value::Null, &format!("this is no JSON: {reason}"))));
                return;
            }
        };
        let id = asked.get("id").cloned().unwrap_or(Value::Null);
        if let Some(answer) = self.answered(&asked, &id, say) {
            say(&text(&answer));
        }
    }

    /// The last or only answer; `None`: everything was said.
    fn answered(
        &mut self,
        asked: &Value,
        id: &Value,
        say: &mut dyn FnMut(&str) -> bool,
    ) -> Option<Value> {
        let word = |key: &str| asked.get(key).and_then(Value::as_str);
        Some(match word("ask").unwrap_or_default() {
            "open" => self.open(id),
            "new" => match word("kind").and_then(kind) {
                Some(own) => self.put(id, own.file, own.deck),
                None => refused(id, "there is no deck of that kind"),
            },
            "deck" => {
                let known = self.opened.as_ref().map(|own| own.name.clone());
                let name = word("name").map(str::to_owned).or(known);
                let name = name.unwrap_or_else(|| "deck.inp".to_owned());
                match word("text") {
                    Some(text) => self.put(id, &name, text),
                    None => refused(id, "the text of the deck is missing"),
                }
            }
            "complete" => complete::complete(id, asked),
            "explain" => complete::explain(id, word("word").unwrap_or_default()),
            "stop" => return None,
            other => return self.with_values(other, asked, id, say),
        })
    }

    /// What asks for values of the parameters.
    fn with_values(
        &mut self,
        what: &str,
        asked: &Value,
        id: &Value,
        say: &mut dyn FnMut(&str) -> bool,
    ) -> Option<Value> {
        if !["solve", "aim", "band", "save"].contains(&what) {
            return Some(refused(id, &format!("`{what}` is not understood")));
        }
        let Some(opened) = &self.opened else { return Some(refused(id, "there is no deck")) };
        let values = match Values::of(&opened.sliders, asked.get("values")) {
            Ok(values) => values,
            Err(why) => return Some(refused(id, &why)),
        };
        let (room, clock) = (&mut self.room, self.clock.as_deref());
        Some(match what {
            "solve" => return solve::solve(opened, &values, room, (id, clock), say),
            "aim" => aim::aim(opened, &values, room, (id, asked), say),
            "band" => band::band(opened, &values, room, (id, asked), say),
            _ => save::save(opened, &values, (room, &*self.read), (id, asked), say),
        })
    }

    /// The deck that it was started with, or decks to begin with.
    fn open(&mut self, id: &Value) -> Value {
        match self.first.clone() {
            Some((name, text)) => self.put(id, &name, &text),
            None => {
                let kinds = KINDS.iter().map(|own| {
                    let read = (self.read)(own.file, own.deck);
                    let drawn = read.model.as_ref().map(|model| picture(model, &[]).inline());
                    json!({
                        "kind": own.kind,
                        "title": own.title,
                        "text": own.text,
                        "picture": drawn,
                    })
                });
                json!({"say": "start", "id": id, "kinds": kinds.collect::<Value>()})
            }
        }
    }

    fn put(&mut self, id: &Value, name: &str, text: &str) -> Value {
        let opened = Opened::new(name, text, &self.ranges, &*self.read);
        let told = opened.told(id);
        self.opened = Some(opened);
        told
    }
}
