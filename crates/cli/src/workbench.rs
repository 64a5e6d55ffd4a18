//! `slideline workbench`: the workbench in the browser, or as one file.

use crate::exit::Exit;
use crate::{interrupt, screen};
use clap::{Args, ValueHint};
use slideline::output::write_file;
use slideline::{Job, ReadOptions};
use slideline_workbench::server::{Benches, Server};
use slideline_workbench::{Bench, Range, range, single_page};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// `slideline workbench`.
#[derive(Args, Debug)]
pub(crate) struct WorkbenchArguments {
    /// The deck [default: a choice of decks to begin with].
    #[arg(value_name = "JOB", value_hint = ValueHint::FilePath)]
    job: Option<PathBuf>,
    /// Write the page as one file with the solver inside, and serve nothing.
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,
    /// Ends of the slider of a parameter, such as thickness=1:3.
    #[arg(long, value_name = "NAME=FROM:TO", value_parser = range_of, requires = "job")]
    range: Vec<Range>,
    /// Only print the address; open no browser.
    #[arg(long)]
    no_browser: bool,
    /// The solver as WebAssembly, for -o [default: slideline.wasm beside the program].
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    module: Option<PathBuf>,
}

fn range_of(text: &str) -> Result<Range, String> {
    range(text).ok_or_else(|| "a range is NAME=FROM:TO with FROM less than TO".to_owned())
}

/// A deck by its file.
struct Deck {
    job: Job,
    name: String,
    text: String,
}

impl Deck {
    /// The folder that it stands in.
    fn folder(&self) -> PathBuf {
        let own = self.job.deck.parent().filter(|own| *own != Path::new(""));
        own.unwrap_or(Path::new(".")).to_owned()
    }
}

/// A bench with a deck; what that includes stands beside it.
fn bench(deck: &Deck, folder: &Path, ranges: &[Range]) -> Bench {
    reading(folder, ranges).with_deck(&deck.name, &deck.text)
}

/// A bench that reads decks of a folder.
fn reading(folder: &Path, ranges: &[Range]) -> Bench {
    let folder = folder.to_owned();
    let read = move |name: &str, text: &str| {
        let job = Job::named(&folder.join(name));
        Job::read_bytes(job, text.as_bytes(), &ReadOptions::default())
    };
    Bench::new().with_ranges(ranges.to_vec()).with_reader(Box::new(read))
}

/// Opens the workbench.
pub(crate) fn workbench(arguments: &WorkbenchArguments) -> Exit {
    let deck = match arguments.job.as_deref().map(deck).transpose() {
        Ok(deck) => deck,
        Err(exit) => return exit,
    };
    if let Some(own) = &deck
        && let [strange, ..] = bench(own, &own.folder(), &arguments.range).strange_ranges()[..]
    {
        screen::error(&format!(
            "error[SL0801]: --range names {strange}, which is no parameter of {}\n  = help: name one \
             of its *PARAMETER cards or, where it has none, one that its page shows\n",
            own.name
        ));
        return Exit::Input;
    }
    match &arguments.output {
        Some(path) => page(path, arguments, deck.as_ref()),
        None => serve(arguments, deck),
    }
}

fn deck(path: &Path) -> Result<Deck, Exit> {
    let job = Job::named(path);
    match std::fs::read(&job.deck) {
        Ok(bytes) => {
            let name = job.deck.file_name().unwrap_or_default().to_string_lossy().into_owned();
            Ok(Deck { name, text: String::from_utf8_lossy(&bytes).into_owned(), job })
        }
        Err(reason) => {
            let path = job.deck.display();
            screen::error(&format!(
                "error[SL0701]: the deck {path} cannot be read: {reason}\n  = help: name an \
                 existing deck, or none to choose one to begin with\n"
            ));
            Err(Exit::Input)
        }
    }
}

fn serve(arguments: &WorkbenchArguments, deck: Option<Deck>) -> Exit {
    let ranges = arguments.range.clone();
    let folder = deck.as_ref().map_or_else(|| PathBuf::from("."), Deck::folder);
    let beside = folder.clone();
    let benches: Benches = Box::new(move || match &deck {
        Some(own) => bench(own, &beside, &ranges),
        None => reading(&beside, &ranges),
    });
    let server = match Server::begin(benches, &folder) {
        Ok(server) => server,
        Err(reason) => {
            screen::error(&format!("error: the workbench cannot be served: {reason}\n"));
            return Exit::Output;
        }
    };
    interrupt::listen();
    screen::print(&format!(
        "{}\nThe address opens once. Ctrl-C ends the workbench.\n",
        server.address()
    ));
    if !arguments.no_browser {
        open(server.address());
    }
    while !interrupt::asked() {
        std::thread::sleep(Duration::from_millis(100));
    }
    Exit::Completed
}

/// Asks the system to open an address; where it cannot, the address was printed.
fn open(address: &str) {
    let mut command = if cfg!(target_os = "windows") {
        let mut command = Command::new("rundll32");
        command.arg("url.dll,FileProtocolHandler");
        command
    } else {
        Command::new(if cfg!(target_os = "macos") { "open" } else { "xdg-open" })
    };
    let quiet = command.arg(address).stdin(Stdio::null()).stdout(Stdio::null());
    if quiet.stderr(Stdio::null()).spawn().is_err() {
        screen::error("no browser could be opened: open the address above\n");
    }
}

fn page(path: &Path, arguments: &WorkbenchArguments, deck: Option<&Deck>) -> Exit {
    let beside = || Some(std::env::current_exe().ok()?.parent()?.join("slideline.wasm"));
    let module =
        arguments.module.clone().or_else(beside).unwrap_or_else(|| "slideline.wasm".into());
    let wasm = match std::fs::read(&module) {
        Ok(wasm) => wasm,
        Err(reason) => {
            screen::error(&format!(
                "error[SL0701]: the solver as WebAssembly, {}, cannot be read: {reason}\n  = help: \
                 bindings/wasm/build makes it; name it with --module, or put it beside the program\n",
                module.display()
            ));
            return Exit::Input;
        }
    };
    let text = deck.map(|own| with_ranges(&own.text, &arguments.range));
    let deck = deck.zip(text.as_ref()).map(|(own, text)| (own.name.as_str(), text.as_str()));
    let page = single_page(&wasm, deck).map_err(|reason| reason.to_string());
    let write = |page: String| write_file(path, page.as_bytes()).map_err(|own| own.to_string());
    let written = page.and_then(write);
    match written {
        Ok(()) => {
            screen::print(&format!("{} is written; open it in a browser\n", path.display()));
            Exit::Completed
        }
        Err(reason) => {
            screen::error(&format!("error[SL0702]: {reason}\n"));
            Exit::Output
        }
    }
}

/// A deck with ranges as comments: a page of one file has no command line.
fn with_ranges(text: &str, ranges: &[Range]) -> String {
    let mut text = text.to_owned();
    if !ranges.is_empty() && !text.ends_with('\n') {
        text.push('\n');
    }
    for Range { name, minimum, maximum } in ranges {
        text.push_str(&format!("** range {name} {minimum:?} {maximum:?}\n"));
    }
    text
}
