//! Messages that wait for the bench. What is newer ends what it makes useless.

use serde_json::Value;
use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Most messages that wait; a page that asks for more is not ours.
const MOST: usize = 256;

/// A message that waits.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Message {
    pub text: String,
    pub asked: Value,
}

impl Message {
    fn word(&self, key: &str) -> &str {
        self.asked.get(key).and_then(Value::as_str).unwrap_or_default()
    }

    /// Whether it ends the solve that runs.
    fn ends(&self) -> bool {
        ["solve", "stop", "deck", "new"].contains(&self.word("ask"))
    }

    /// Whether a later message can make it useless.
    fn solves(&self) -> bool {
        ["solve", "aim", "band"].contains(&self.word("ask"))
    }
}

#[derive(Default)]
struct Waiting {
    list: VecDeque<Message>,
    is_closed: bool,
}

/// The queue of a socket.
#[derive(Default)]
pub(super) struct Queue {
    waiting: Mutex<Waiting>,
    changed: Condvar,
}

/// What comes next.
#[derive(Debug, PartialEq)]
pub(super) enum Next {
    /// To be answered.
    Message(Message),
    /// A solve that a newer one has overtaken before it began.
    Overtaken(Value),
    /// Nothing will come any more.
    End,
}

impl Queue {
    fn lock(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes a message in; `false`: there are too many.
    pub fn push(&self, text: String) -> bool {
        let asked = serde_json::from_str(&text).unwrap_or_default();
        let mut waiting = self.lock();
        waiting.list.push_back(Message { text, asked });
        self.changed.notify_all();
        waiting.list.len() <= MOST
    }

    /// Nothing comes any more, and what waits is left.
    pub fn close(&self) {
        let mut waiting = self.lock();
        waiting.is_closed = true;
        waiting.list.clear();
        self.changed.notify_all();
    }

    /// Whether the solve that runs is still wanted.
    pub fn goes_on(&self) -> bool {
        let waiting = self.lock();
        !waiting.is_closed && !waiting.list.iter().any(Message::ends)
    }

    /// Waits for what comes next.
    pub fn next(&self) -> Next {
        let mut waiting = self.lock();
        loop {
            if let Some(first) = waiting.list.pop_front() {
                let overtaken = first.solves() && waiting.list.iter().any(Message::ends);
                let id = || first.asked.get("id").cloned().unwrap_or_default();
                return if overtaken { Next::Overtaken(id()) } else { Next::Message(first) };
            }
            if waiting.is_closed {
                return Next::End;
            }
            waiting = self.changed.wait(waiting).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: of many solves only the newest is begun, in order with everything else, and a
    /// running one hears of it.
    #[test]
    fn the_newest_solve_is_the_one_that_counts() {
        let queue = Queue::default();
        assert!(queue.goes_on());
        for (ask, id) in [("solve", 1), ("complete", 2), ("solve", 3), ("solve", 4)] {
            assert!(queue.push(format!("{{\"ask\":\"{ask}\",\"id\":{id}}}")));
        }
        assert!(!queue.goes_on());
        let mut told = Vec::new();
        for _ in 0..4 {
            told.push(match queue.next() {
                Next::Message(own) => format!("{} {}", own.word("ask"), own.asked["id"]),
                Next::Overtaken(id) => format!("overtaken {id}"),
                Next::End => "end".to_owned(),
            });
        }
        assert_eq!(told, ["overtaken 1", "complete 2", "overtaken 3", "solve 4"]);
        assert!(queue.goes_on());
        queue.close();
        assert!(!queue.goes_on() && queue.next() == Next::End);
    }

    #[test]
    fn a_queue_has_an_end() {
        let queue = Queue::default();
        assert!((0..MOST).all(|_| queue.push("{}".to_owned())));
        assert!(!queue.push("{}".to_owned()));
    }
}
