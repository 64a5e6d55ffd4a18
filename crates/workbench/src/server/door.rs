//! Who may come in.

use super::secret::Secret;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};

/// What a request says of itself, as far as it decides who it is from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Caller {
    /// `Host`, every one of them.
    pub hosts: Vec<String>,
    /// `Origin`, every one of them.
    pub origins: Vec<String>,
    /// `Sec-Fetch-Site`.
    pub site: Option<String>,
    /// `Cookie`, every one of them.
    pub cookies: Vec<String>,
}

/// The token of the address, the cookie that it is exchanged for, and the names of this server.
pub(super) struct Door {
    port: u16,
    token: Secret,
    is_used: AtomicBool,
    session: Secret,
}

impl Door {
    /// That of a server on a port of the loopback address.
    pub fn new(port: u16) -> io::Result<Self> {
        let is_used = AtomicBool::new(false);
        Ok(Self { port, token: Secret::new()?, is_used, session: Secret::new()? })
    }

    /// The address to be opened.
    pub fn address(&self) -> String {
        format!("http://{}/?token={}", self.host(), self.token.word())
    }

    /// The only `Host` there is.
    pub fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    /// Whether a request is meant for this server and comes from nowhere else: another name that
    /// leads here (DNS rebinding) is as strange as the page of another origin.
    pub fn knows(&self, caller: &Caller) -> bool {
        let host = self.host();
        let origin = format!("http://{host}");
        let site = caller.site.as_deref();
        caller.hosts == [host]
            && (caller.origins.is_empty() || caller.origins == [origin])
            && site.is_none_or(|site| ["same-origin", "none"].contains(&site))
    }

    /// Exchanges the token for a cookie, once: the value of `Set-Cookie`.
    pub fn exchange(&self, token: &str) -> Option<String> {
        if !self.token.is(token) || self.is_used.swap(true, Ordering::SeqCst) {
            return None;
        }
        let (name, word) = (self.cookie(), self.session.word());
        Some(format!("{name}={word}; Path=/; HttpOnly; SameSite=Strict"))
    }

    /// Whether a request has the cookie.
    pub fn is_open_to(&self, caller: &Caller) -> bool {
        let name = self.cookie();
        let all = caller.cookies.iter().flat_map(|own| own.split(';'));
        let mut own = all.filter_map(|own| own.trim().split_once('='));
        own.any(|(key, word)| key == name && self.session.is(word))
    }

    /// Name of the cookie: browsers keep no ports apart.
    fn cookie(&self) -> String {
        format!("slideline-{}", self.port)
    }
}
