//! The bench of the workbench as a WebAssembly module: texts in, texts out.
//!
//! ```text
//!   page --postMessage--> worker --room(length), answer(length)--> Bench
//!                           ^-------------- bench.say(text) ----------'
//! ```
//!
//! The module has one bench and one room for messages. Nothing is decided here.

use slideline_workbench::Bench;
use std::cell::RefCell;

// What the worker gives the module.
#[link(wasm_import_module = "bench")]
#[allow(unsafe_code)]
unsafe extern "C" {
    // Takes a text of `length` bytes of UTF-8 that stands at `start`; 0: the work is to end.
    fn say(start: *const u8, length: usize) -> i32;
}

thread_local! {
    static ROOM: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static BENCH: RefCell<Bench> = RefCell::new(Bench::default());
}

/// The place where the worker writes its next message of `length` bytes.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    ROOM.with_borrow_mut(|room| {
        room.clear();
        room.resize(length, 0);
        room.as_mut_ptr()
    })
}

/// Answers the message that stands in the room.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn answer() {
    let message = ROOM.take();
    let message = String::from_utf8_lossy(&message);
    BENCH.with_borrow_mut(|bench| {
        bench.answer(&message, &mut |text: &str| {
            // SAFETY: the worker copies the text before it returns
            unsafe { say(text.as_ptr(), text.len()) != 0 }
        });
    });
}
