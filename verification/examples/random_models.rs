//! Many random models, told as a table:
//! `cargo run --release -p slideline-verification --example random_models -- 10000`.
//!
//! Further arguments are the number of the first model and a folder for the
//! decks of those that are worth a look.

use slideline_verification::random::{Tally, judge, model};

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, default: u64| {
        arguments.get(place).and_then(|text| text.parse().ok()).unwrap_or(default)
    };
    let (count, first) = (number(0, 10_000), number(1, 0));
    let began = std::time::Instant::now();
    let mut tally = Tally::default();
    for number in first..first + count {
        let model = model(number);
        let judged = std::panic::catch_unwind(|| judge(&model));
        let Ok(verdict) = judged else {
            eprintln!("{number} PANICS");
            continue;
        };
        tally.add(&model, &verdict);
    }
    for (number, kind, why) in &tally.remarkable {
        println!("{number} {kind:?}: {why}");
        if let Some(folder) = arguments.get(2) {
            std::fs::create_dir_all(folder)?;
            std::fs::write(format!("{folder}/random_{number}.inp"), model(*number).text)?;
        }
    }
    println!("{tally}{:.1} s", began.elapsed().as_secs_f64());
    Ok(())
}
