//! A result file of the embedding program beside those of the job.
//!
//! ```text
//!   run --event--> files of the job
//!            `---> JOB.pressure.csv    the largest contact pressure of every pair
//! ```
//!
//! Whoever watches a run may write what it sees: an observer borrows every committed state.
//!
//! ```sh
//! cargo run --release -p slideline --example own_file -- DECK.inp
//! ```

use slideline::output::number::shortest;
use slideline::{Event, Job, Observer, ReadOptions, RunOptions, Stop, run};
use std::fs::File;
use std::io::{self, BufWriter, Write as _};
use std::ops::ControlFlow;
use std::path::Path;

/// Writes the file as the run goes.
pub struct PressureFile {
    file: BufWriter<File>,
    /// Why it is incomplete, if it is.
    pub failure: Option<io::Error>,
}

impl PressureFile {
    /// Makes it.
    ///
    /// # Errors
    /// Those of the folder.
    pub fn create(path: &Path) -> io::Result<Self> {
        let mut file = BufWriter::new(File::create(path)?);
        writeln!(file, "step,increment,pair,node,pressure")?;
        Ok(Self { file, failure: None })
    }

    fn write(&mut self, event: &Event<'_>) -> io::Result<()> {
        let Event::Committed(frame) = event else { return Ok(()) };
        for (place, pair) in frame.model.contact_pairs.iter().enumerate() {
            let own = frame.contact.iter().filter(|row| row.pair == place);
            let Some(most) = own.max_by(|a, b| a.pressure.total_cmp(&b.pressure)) else { continue };
            let (step, increment) = (frame.step, frame.increment);
            let (node, pressure) = (frame.model.nodes.label(most.node), shortest(most.pressure));
            writeln!(self.file, "{step},{increment},{},{node},{pressure}", pair.name)?;
        }
        self.file.flush()
    }
}

impl Observer for PressureFile {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if self.failure.is_none() {
            self.failure = self.write(&event).err();
        }
        ControlFlow::Continue(())
    }
}

fn main() -> io::Result<()> {
    let Some(deck) = std::env::args().nth(1) else {
        println!("the deck is missing: own_file DECK.inp");
        return Ok(());
    };
    let read = Job::read(deck.as_ref(), &ReadOptions::default());
    let mut file = PressureFile::create(&Path::new(&deck).with_extension("pressure.csv"))?;
    println!("{}", run(&read, &RunOptions::default(), &mut file).status.word());
    file.failure.map_or(Ok(()), Err)
}
