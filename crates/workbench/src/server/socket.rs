//! A page that is connected: its messages to a bench, the answers back.
//!
//! ```text
//!   reading thread --> Queue --> bench --> writing half
//!                        ^------ goes_on: whether something newer waits
//! ```

use super::queue::{Next, Queue};
use super::saved::written;
use super::shared::Shared;
use serde_json::{Value, json};
use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};
use tungstenite::handshake::derive_accept_key;
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Message, WebSocket};

/// Longest message of a page [bytes]: a deck.
const MOST: usize = 8 << 20;
/// How long a page may take to read what it is sent.
const PATIENCE: Duration = Duration::from_secs(30);

/// Answers a socket until it closes.
pub(super) fn answer(mut stream: TcpStream, key: &str, shared: &Shared) -> io::Result<()> {
    let accepted = derive_accept_key(key.as_bytes());
    let head = format!(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
         Sec-WebSocket-Accept: {accepted}\r\n\r\n"
    );
    stream.write_all(head.as_bytes())?;
    stream.set_read_timeout(None)?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let config = WebSocketConfig::default().max_message_size(Some(MOST)).max_frame_size(Some(MOST));
    let reader =
        WebSocket::from_raw_socket(ReadOnly(stream.try_clone()?), Role::Server, Some(config));
    let writer = WebSocket::from_raw_socket(stream.try_clone()?, Role::Server, Some(config));
    let queue = Queue::default();
    std::thread::scope(|scope| {
        let reading = std::thread::Builder::new().spawn_scoped(scope, || read(reader, &queue));
        if reading.is_ok() {
            work(writer, &queue, shared);
        }
        // wakes the thread that reads
        let _ = stream.shutdown(std::net::Shutdown::Both);
    });
    Ok(())
}

/// Hands messages on until there are none.
fn read(mut socket: WebSocket<ReadOnly>, queue: &Queue) {
    // a frame that is too large, or not masked, is an error: the socket is closed
    while let Ok(message) = socket.read() {
        let goes_on = match message {
            Message::Text(text) => queue.push(text.as_str().to_owned()),
            Message::Close(_) | Message::Binary(_) => false,
            _ => true,
        };
        if !goes_on {
            break;
        }
    }
    queue.close();
}

/// Answers messages until there are none.
fn work(mut socket: WebSocket<TcpStream>, queue: &Queue, shared: &Shared) {
    let began = Instant::now();
    let clock = Box::new(move || 1e3 * began.elapsed().as_secs_f64());
    let mut bench = (shared.benches)().with_clock(clock);
    let mut is_broken = false;
    let mut send = |text: &str| {
        if !text.is_empty() && !is_broken {
            is_broken = socket.send(Message::text(text)).is_err();
        }
        !is_broken
    };
    loop {
        match queue.next() {
            Next::End => break,
            Next::Overtaken(id) => {
                send(&json!({"say": "overtaken", "id": id}).to_string());
            }
            Next::Message(message) => {
                let writes = message.asked.get("write").and_then(Value::as_bool) == Some(true);
                let mut say = |text: &str| {
                    let text = match writes {
                        true => written(text, &message.asked, &shared.folder),
                        false => text.into(),
                    };
                    send(&text) && queue.goes_on()
                };
                bench.answer(&message.text, &mut say);
            }
        }
        if !send("") {
            break;
        }
    }
    let _ = socket.close(None); // who has gone is not told
    let _ = socket.flush(); // as above
}

/// The half of a stream that is read: answers to pings would stand in the middle of what the other
/// half writes, and browsers send none.
struct ReadOnly(TcpStream);

impl Read for ReadOnly {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        self.0.read(into)
    }
}

impl Write for ReadOnly {
    fn write(&mut self, from: &[u8]) -> io::Result<usize> {
        Ok(from.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
