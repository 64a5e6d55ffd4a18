//! Who is let in by the server, and who is not.

#![cfg(feature = "server")]
#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline_workbench::Bench;
use slideline_workbench::server::Server;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tungstenite::protocol::Role;
use tungstenite::{Message, WebSocket};

const DECK: &str = include_str!("../../../../corpus/new/snap_fit.inp");

struct Served {
    host: String,
    token: String,
    folder: PathBuf,
}

/// A server of a test's own, with a folder.
fn served(name: &str) -> Served {
    let folder =
        std::env::temp_dir().join(format!("slideline_served_{}_{name}", std::process::id()));
    std::fs::create_dir_all(folder.join("inside")).unwrap();
    let make = || Bench::new().with_deck("snap_fit.inp", DECK);
    let server = Server::begin(Box::new(make), &folder.join("inside")).unwrap();
    let rest = server.address().strip_prefix("http://").unwrap();
    let (host, token) = rest.split_once("/?token=").unwrap();
    assert!(host.starts_with("127.0.0.1:") && token.len() == 64);
    Served { host: host.to_owned(), token: token.to_owned(), folder }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

impl Served {
    fn raw(&self, request: &[u8]) -> String {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let _ = stream.write_all(request); // the server may have closed already
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer); // as above
        String::from_utf8_lossy(&answer).into_owned()
    }

    /// The answer to `GET` with these further lines.
    fn get(&self, target: &str, lines: &[&str]) -> String {
        let own = format!("Host: {}", self.host);
        let host =
            if lines.iter().any(|line| line.starts_with("Host")) { vec![] } else { vec![&*own] };
        let all: Vec<&str> = host.into_iter().chain(lines.iter().copied()).collect();
        self.raw(format!("GET {target} HTTP/1.1\r\n{}\r\n\r\n", all.join("\r\n")).as_bytes())
    }

    /// The cookie, for the token.
    fn cookie(&self) -> String {
        let answer = self.get(&format!("/?token={}", self.token), &[]);
        assert!(answer.starts_with("HTTP/1.1 303 "), "{answer}");
        let line = answer.lines().find_map(|line| line.strip_prefix("Set-Cookie: ")).unwrap();
        assert!(line.ends_with("; Path=/; HttpOnly; SameSite=Strict"), "{line}");
        format!("Cookie: {}", line.split(';').next().unwrap())
    }

    fn origin(&self) -> String {
        format!("Origin: http://{}", self.host)
    }

    /// A socket that was let in.
    fn socket(&self, cookie: &str) -> WebSocket<TcpStream> {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let lines =
            [&*format!("Host: {}", self.host), UPGRADE, cookie, &self.origin()].join("\r\n");
        stream.write_all(format!("GET /socket HTTP/1.1\r\n{lines}\r\n\r\n").as_bytes()).unwrap();
        let mut head = Vec::new();
        while !head.ends_with(b"\r\n\r\n") {
            let mut byte = [0];
            stream.read_exact(&mut byte).unwrap();
            head.push(byte[0]);
        }
        let head = String::from_utf8(head).unwrap();
        assert!(head.starts_with("HTTP/1.1 101 "), "{head}");
        // [RFC 6455, section 1.3]
        assert!(head.contains("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), "{head}");
        WebSocket::from_raw_socket(stream, Role::Client, None)
    }
}

const UPGRADE: &str = "Upgrade: websocket\r\nConnection: keep-alive, Upgrade\r\n\
                       Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==";

fn status(answer: &str) -> &str {
    answer.split(' ').nth(1).unwrap_or("closed")
}

fn is_refused(answer: &str) {
    assert_eq!(status(answer), "403", "{answer}");
    let lower = answer.to_lowercase();
    assert!(!lower.contains("access-control") && !lower.contains("set-cookie"), "{answer}");
}

/// Requirement: the token is exchanged once; without cookie, with a wrong one or one of another
/// port's name nothing is served.
#[test]
fn the_token_counts_once() {
    let served = served("token");
    for target in ["/", "/page.css", "/socket", "/?token=", "/?token=0", "/?x=1"] {
        is_refused(&served.get(target, &[]));
    }
    let wrong: String = served.token.chars().rev().collect();
    is_refused(&served.get(&format!("/?token={wrong}"), &[]));
    let cookie = served.cookie();
    is_refused(&served.get(&format!("/?token={}", served.token), &[]));
    let page = served.get("/", &[&cookie]);
    assert_eq!(status(&page), "200");
    for line in
        ["default-src 'none'", "frame-ancestors 'none'", "no-store", "nosniff", "same-origin"]
    {
        assert!(page.contains(line), "{line}");
    }
    assert!(!page.to_lowercase().contains("access-control"));
    let (name, word) = cookie.strip_prefix("Cookie: ").unwrap().split_once('=').unwrap();
    for cookie in [
        format!("{name}={wrong}"),
        format!("{name}1={word}"),
        format!("{name}="),
        format!("slideline={word}"),
        format!("{name}={}", &word[..63]),
    ] {
        is_refused(&served.get("/", &[&format!("Cookie: {cookie}")]));
    }
    // a cookie among others counts
    let among = format!("Cookie: a=b; {name}={word}; c=d");
    assert_eq!(status(&served.get("/", &[&among])), "200");
}

/// Requirement: another name that leads here (DNS rebinding) is refused even with the cookie, and with
/// the token, which stays good.
#[test]
fn other_names_are_refused() {
    let served = served("hosts");
    let port = served.host.split(':').nth(1).unwrap().to_owned();
    let good = format!("Host: {}", served.host);
    let hosts = [
        format!("Host: evil.example:{port}"),
        format!("Host: localhost:{port}"),
        format!("Host: 127.0.0.1.evil.example:{port}"),
        "Host: 127.0.0.1".to_owned(),
        format!("Host: 127.0.0.1:{port}0"),
        "Host: ".to_owned(),
        format!("{good}\r\nHost: evil.example"),
    ];
    for host in &hosts {
        is_refused(&served.get(&format!("/?token={}", served.token), &[host]));
    }
    let none = served.raw(format!("GET /?token={} HTTP/1.1\r\n\r\n", served.token).as_bytes());
    is_refused(&none);
    let cookie = served.cookie();
    for host in &hosts {
        is_refused(&served.get("/", &[host, &cookie]));
        is_refused(&served.get("/socket", &[host, &cookie, UPGRADE, &served.origin()]));
    }
}

/// Requirement: a request of the page of another origin, of none (`null`), or that the browser calls
/// one from elsewhere is refused with the cookie; a socket needs an origin.
#[test]
fn other_origins_are_refused() {
    let served = served("origins");
    let (cookie, own) = (served.cookie(), served.origin());
    let port = served.host.split(':').nth(1).unwrap();
    let origins = [
        "Origin: null".to_owned(),
        "Origin: http://evil.example".to_owned(),
        format!("Origin: http://localhost:{port}"),
        format!("Origin: https://{}", served.host),
        format!("Origin: http://{}.evil.example", served.host),
        "Origin: http://127.0.0.1".to_owned(),
        "Origin: ".to_owned(),
        format!("{own}\r\nOrigin: http://evil.example"),
        "Sec-Fetch-Site: cross-site".to_owned(),
        "Sec-Fetch-Site: same-site".to_owned(),
    ];
    for origin in &origins {
        is_refused(&served.get("/", &[&cookie, origin]));
        is_refused(&served.get("/socket", &[&cookie, origin, UPGRADE]));
    }
    assert_eq!(status(&served.get("/", &[&cookie, &own, "Sec-Fetch-Site: same-origin"])), "200");
    assert_eq!(status(&served.get("/socket", &[&cookie, UPGRADE])), "400");
    assert_eq!(status(&served.get("/socket", &[&cookie, &own])), "400");
    is_refused(&served.get("/socket", &[UPGRADE, &own]));
}

/// Requirement: heads that are too long, or no heads, are refused; other methods and bodies too.
#[test]
fn strange_requests_are_refused() {
    let served = served("strange");
    let cookie = served.cookie();
    let long = format!("X: {}", "a".repeat(20_000));
    assert!(["431", "closed"].contains(&status(&served.get("/", &[&cookie, &long]))));
    let many: Vec<String> = (0..200).map(|number| format!("X{number}: a")).collect();
    let many: Vec<&str> = many.iter().map(String::as_str).collect();
    assert!(["431", "closed"].contains(&status(&served.get("/", &many))));
    assert!(["400", "closed"].contains(&status(&served.raw(b"\x00\x01\x02\r\n\r\n"))));
    for method in ["POST", "PUT", "OPTIONS", "DELETE", "HEAD"] {
        let text = format!("{method} / HTTP/1.1\r\nHost: {}\r\n{cookie}\r\n\r\n", served.host);
        assert_eq!(status(&served.raw(text.as_bytes())), "405", "{method}");
    }
    let body = format!("GET / HTTP/1.1\r\nHost: {}\r\n{cookie}\r\n\r\nGET /", served.host);
    assert_eq!(status(&served.raw(body.as_bytes())), "400");
}

/// Requirement: no path leads out of the page's own files.
#[test]
fn no_path_leads_to_a_file_of_the_disk() {
    let served = served("paths");
    let cookie = served.cookie();
    for target in [
        "/../Cargo.toml",
        "/../../../../etc/passwd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "/..%2f..%2fetc/passwd",
        "//etc/passwd",
        "/page.css/../../Cargo.toml",
        "/snap_fit.inp",
        "/.",
        "/page.css%00",
    ] {
        assert_eq!(status(&served.get(target, &[&cookie])), "404", "{target}");
    }
    for target in ["/page.css", "/connection.js", "/report/shape.js"] {
        assert_eq!(status(&served.get(target, &[&cookie])), "200", "{target}");
    }
}

fn text(socket: &mut WebSocket<TcpStream>) -> serde_json::Value {
    loop {
        if let Message::Text(text) = socket.read().unwrap() {
            return serde_json::from_str(text.as_str()).unwrap();
        }
    }
}

/// Requirement: a socket answers; of many solves the last one alone comes to its end; a frame that is
/// too large, one that is not masked, and binary data end it.
#[test]
fn a_socket_answers_the_newest() {
    let served = served("socket");
    let cookie = served.cookie();
    let mut socket = served.socket(&cookie);
    socket.send(Message::text("{\"ask\":\"open\",\"id\":1}")).unwrap();
    assert_eq!(text(&mut socket)["say"], "deck");
    for id in 2..=30 {
        let thickness = 1.0 + 0.05 * f64::from(id);
        let ask =
            format!("{{\"ask\":\"solve\",\"id\":{id},\"values\":{{\"thickness\":{thickness}}}}}");
        socket.send(Message::text(ask)).unwrap();
    }
    let (mut overtaken, mut ended) = (0, Vec::new());
    while ended.last() != Some(&30) {
        let said = text(&mut socket);
        match said["say"].as_str().unwrap() {
            "overtaken" => overtaken += 1,
            "end" => ended.push(said["id"].as_u64().unwrap()),
            _ => {}
        }
    }
    assert!(overtaken + ended.len() == 29 && overtaken > 20, "{overtaken} overtaken, {ended:?}");
    let large = Message::text("x".repeat(9 << 20));
    let _ = socket.send(large); // it may be closed in the middle of it
    assert!(std::iter::repeat_with(|| socket.read()).take(50).any(|own| own.is_err()));
    let mut second = served.socket(&cookie);
    // a text of two letters without a mask
    second.get_mut().write_all(&[0x81, 2, b'{', b'}']).unwrap();
    assert!(std::iter::repeat_with(|| second.read()).take(5).any(|own| own.is_err()));
    let mut third = served.socket(&cookie);
    third.send(Message::binary(vec![1, 2])).unwrap();
    assert!(std::iter::repeat_with(|| third.read()).take(5).any(|own| own.is_err()));
}

/// Requirement: files are written into the folder alone.
#[test]
fn files_stay_in_the_folder() {
    let served = served("files");
    let mut socket = served.socket(&served.cookie());
    socket.send(Message::text("{\"ask\":\"open\",\"id\":1}")).unwrap();
    text(&mut socket);
    let mut save = |name: &str| {
        let ask = serde_json::json!({"ask": "save", "id": 2, "what": "deck", "write": true, "name": name});
        socket.send(Message::text(ask.to_string())).unwrap();
        text(&mut socket)
    };
    assert_eq!(save("mine.inp")["say"], "written");
    assert_eq!(std::fs::read_to_string(served.folder.join("inside/mine.inp")).unwrap(), DECK);
    for name in ["../out.inp", "..\\out.inp", "/tmp/out.inp", "a/out.inp", "out.exe", "C:out.inp"] {
        assert_eq!(save(name)["say"], "refused", "{name}");
    }
    let names = |folder: &Path| std::fs::read_dir(folder).unwrap().count();
    assert_eq!((names(&served.folder), names(&served.folder.join("inside"))), (1, 1));
}

/// Requirement: what is there is not written over under a name that is asked for, the deck above all; what
/// the bench names itself replaces a link and does not follow it.
#[cfg(unix)]
#[test]
fn nothing_is_written_through_links() {
    let served = served("links");
    let (inside, outside) = (served.folder.join("inside"), served.folder.join("outside.inp"));
    std::fs::write(&outside, "outside").unwrap();
    std::fs::write(inside.join("snap_fit.inp"), "the deck").unwrap();
    for name in ["link.inp", "snap_fit_set.inp"] {
        std::os::unix::fs::symlink(&outside, inside.join(name)).unwrap();
    }
    std::os::unix::fs::symlink(served.folder.join("gone.inp"), inside.join("gone.inp")).unwrap();
    let mut socket = served.socket(&served.cookie());
    socket.send(Message::text("{\"ask\":\"open\",\"id\":1}")).unwrap();
    text(&mut socket);
    let mut save = |name: Option<&str>| {
        let mut ask = serde_json::json!({"ask": "save", "id": 2, "what": "deck", "write": true});
        ask["name"] = name.into();
        socket.send(Message::text(ask.to_string())).unwrap();
        text(&mut socket)
    };
    for name in ["snap_fit.inp", "link.inp", "gone.inp"] {
        assert_eq!(save(Some(name))["say"], "refused", "{name}");
    }
    assert_eq!(save(None)["say"], "written");
    let read = |path: &Path| std::fs::read_to_string(path).unwrap();
    assert_eq!(read(&outside), "outside");
    assert_eq!(read(&inside.join("snap_fit.inp")), "the deck");
    assert_eq!(read(&inside.join("snap_fit_set.inp")), DECK);
    assert!(!served.folder.join("gone.inp").exists());
}
