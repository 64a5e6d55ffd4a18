//! The page served on the loopback address, to the one who started it.
//!
//! ```text
//!   http://127.0.0.1:PORT/?token=ONCE  --> cookie, SameSite=Strict; HttpOnly --> /
//!   /, /page.css, ...   files of the page, from the program itself: no file of the disk is served
//!   /socket             WebSocket: messages to a bench, answers of it
//! ```
//!
//! Every request needs this host and no foreign origin, every one but the first the cookie. Nothing
//! is said to other origins. What is saved goes into one folder.

mod door;
mod http;
mod queue;
mod saved;
mod secret;
mod shared;
mod socket;

use door::Door;
pub use shared::Benches;
use shared::Shared;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Connections that are answered at a time; others are closed.
const MOST: usize = 64;

/// A server that answers on threads of its own until the process ends.
pub struct Server {
    address: String,
}

impl Server {
    /// Listens on a free port of the loopback address. Files that a page asks to write go into
    /// `folder` only.
    ///
    /// # Errors
    /// Where there is no port, or no randomness for its secrets.
    pub fn begin(benches: Benches, folder: &Path) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
        let port = listener.local_addr()?.port();
        let door = Door::new(port)?;
        let address = door.address();
        let (folder, open) = (folder.to_owned(), AtomicUsize::new(0));
        let shared = Arc::new(Shared { door, benches, folder, open });
        std::thread::Builder::new()
            .name("workbench".to_owned())
            .spawn(move || listen(&listener, &shared))?;
        Ok(Self { address })
    }

    /// The address to be opened; its token counts once.
    pub fn address(&self) -> &str {
        &self.address
    }
}

fn listen(listener: &TcpListener, shared: &Arc<Shared>) {
    for stream in listener.incoming().flatten() {
        if shared.open.fetch_add(1, Ordering::SeqCst) >= MOST {
            shared.open.fetch_sub(1, Ordering::SeqCst);
            continue;
        }
        let own = shared.clone();
        let spawned = std::thread::Builder::new().spawn(move || {
            // a connection that breaks has nobody to be told
            let _ = http::answer(stream, &own);
            own.open.fetch_sub(1, Ordering::SeqCst);
        });
        if spawned.is_err() {
            shared.open.fetch_sub(1, Ordering::SeqCst);
        }
    }
}
