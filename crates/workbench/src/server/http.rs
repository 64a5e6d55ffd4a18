//! Requests: one a connection, without a body.

use super::door::Caller;
use super::shared::Shared;
use super::socket;
use crate::single::asset;
use std::io::{self, Read as _, Write as _};
use std::net::TcpStream;
use std::time::Duration;

/// Longest head of a request [bytes], and most of its lines.
const HEAD: usize = 16 * 1024;
const LINES: usize = 64;
/// How long a request may take to come, and an answer to go.
const PATIENCE: Duration = Duration::from_secs(10);

/// The head of a request.
#[derive(Default)]
struct Request {
    method: String,
    target: String,
    caller: Caller,
    /// The key of a WebSocket that is asked for.
    socket: Option<String>,
}

/// Answers the request of a connection; one for a socket is answered until it closes.
pub(super) fn answer(mut stream: TcpStream, shared: &Shared) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    stream.set_nodelay(true)?;
    let request = match head(&mut stream)? {
        Ok(request) => request,
        Err(status) => return refuse(&mut stream, status),
    };
    let door = &shared.door;
    if !door.knows(&request.caller) {
        return refuse(&mut stream, "403 Forbidden");
    }
    if request.method != "GET" {
        return refuse(&mut stream, "405 Method Not Allowed");
    }
    let (path, question) = request.target.split_once('?').unwrap_or((&request.target, ""));
    if let Some(token) = question.strip_prefix("token=").filter(|_| path == "/") {
        return match door.exchange(token) {
            Some(cookie) => {
                let lines = format!("Location: /\r\nSet-Cookie: {cookie}\r\n");
                reply(&mut stream, ("303 See Other", &lines), ("text/plain", b""), &door.host())
            }
            None => refuse(&mut stream, "403 Forbidden"),
        };
    }
    if !door.is_open_to(&request.caller) {
        return refuse(&mut stream, "403 Forbidden");
    }
    if path == "/socket" {
        // a page has an origin, and that was looked at
        return match request.socket.filter(|_| !request.caller.origins.is_empty()) {
            Some(key) => socket::answer(stream, &key, shared),
            None => refuse(&mut stream, "400 Bad Request"),
        };
    }
    let name = if path == "/" { "index.html" } else { path.trim_start_matches('/') };
    match asset(name) {
        Some((content, kind)) => reply(&mut stream, ("200 OK", ""), (kind, content), &door.host()),
        None => refuse(&mut stream, "404 Not Found"),
    }
}

/// Reads the head of a request. `Err`: what it is answered.
fn head(stream: &mut TcpStream) -> io::Result<Result<Request, &'static str>> {
    let mut bytes = Vec::new();
    let mut chunk = [0; 2048];
    loop {
        let count = stream.read(&mut chunk)?;
        if count == 0 {
            return Ok(Err("400 Bad Request"));
        }
        bytes.extend_from_slice(&chunk[..count]);
        if let Some(read) = parsed(&bytes) {
            return Ok(read);
        }
        if bytes.len() > HEAD {
            return Ok(Err("431 Request Header Fields Too Large"));
        }
    }
}

/// The request that stands in the bytes; `None`: more must come.
fn parsed(bytes: &[u8]) -> Option<Result<Request, &'static str>> {
    let mut lines = [httparse::EMPTY_HEADER; LINES];
    let mut head = httparse::Request::new(&mut lines);
    let end = match head.parse(bytes) {
        Ok(httparse::Status::Complete(end)) => end,
        Ok(httparse::Status::Partial) => return None,
        Err(httparse::Error::TooManyHeaders) => {
            return Some(Err("431 Request Header Fields Too Large"));
        }
        Err(_) => return Some(Err("400 Bad Request")),
    };
    if end > HEAD {
        return Some(Err("431 Request Header Fields Too Large"));
    }
    // nothing here takes a body, and none may be taken for another request
    if end < bytes.len() {
        return Some(Err("400 Bad Request"));
    }
    let all = |name: &str| -> Vec<String> {
        let own = head.headers.iter().filter(|own| own.name.eq_ignore_ascii_case(name));
        own.map(|own| String::from_utf8_lossy(own.value).into_owned()).collect()
    };
    let first = |name: &str| all(name).into_iter().next();
    let caller = Caller {
        hosts: all("Host"),
        origins: all("Origin"),
        site: first("Sec-Fetch-Site"),
        cookies: all("Cookie"),
    };
    let has = |name: &str, word: &str| {
        all(name).iter().any(|own| own.split(',').any(|own| own.trim().eq_ignore_ascii_case(word)))
    };
    let upgrades = has("Upgrade", "websocket") && has("Connection", "Upgrade");
    let is_known = first("Sec-WebSocket-Version").as_deref() == Some("13");
    let socket = first("Sec-WebSocket-Key").filter(|_| upgrades && is_known);
    let [method, target] = [head.method, head.path].map(|own| own.unwrap_or_default().to_owned());
    Some(Ok(Request { method, target, caller, socket }))
}

fn refuse(stream: &mut TcpStream, status: &str) -> io::Result<()> {
    let text = format!(
        "{status}\n\nThis is the workbench of slideline. It answers only the page that was opened \
         with the address that the program printed.\n"
    );
    reply(stream, (status, ""), ("text/plain; charset=utf-8", text.as_bytes()), "127.0.0.1")
}

/// An answer; nothing of it is kept, framed, guessed or told to other origins.
fn reply(
    stream: &mut TcpStream,
    (status, lines): (&str, &str),
    (kind, content): (&str, &[u8]),
    host: &str,
) -> io::Result<()> {
    let head = format!(
        "HTTP/1.1 {status}\r\n{lines}Content-Type: {kind}\r\nContent-Length: {}\r\n\
         Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; \
         img-src 'self' data:; connect-src 'self' ws://{host}; base-uri 'none'; \
         form-action 'none'; frame-ancestors 'none'\r\n\
         X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
         Referrer-Policy: no-referrer\r\nCache-Control: no-store\r\n\
         Cross-Origin-Resource-Policy: same-origin\r\nCross-Origin-Opener-Policy: same-origin\r\n\
         Connection: close\r\n\r\n",
        content.len()
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(content)?;
    stream.flush()
}
