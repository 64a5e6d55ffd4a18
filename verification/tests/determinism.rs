//! The same bits on a second run and on any number of threads.

use slideline_verification::{Claim, Curve, Group, Method, Push, Record, run, run_on};

pub const GROUP: Group = Group {
    file: "determinism",
    claims: &[
        Claim {
            name: "second_run",
            requirement: "A second run gives the same bits of all displacements and reactions.",
            source: "A run is a function of its deck.",
            tolerance: "None: bits.",
            measure: second_run,
        },
        Claim {
            name: "threads",
            requirement: "Two and three threads give the bits of one, with more than 2000 \
                          elements, so that elements are evaluated on all threads.",
            source: "Sums are taken in a fixed order.",
            tolerance: "None: bits.",
            measure: threads,
        },
    ],
};

fn bits(curve: &Curve) -> Vec<u64> {
    let rows = curve.rows.iter();
    rows.flat_map(|row| row.displacement.iter().chain(&row.reaction).flatten())
        .map(|value| value.to_bits())
        .collect()
}

fn second_run(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        let deck = Push { mu: 0.3, ..Push::paper(method) }.deck();
        let same = bits(&run(&deck).unwrap()) == bits(&run(&deck).unwrap());
        record.holds(format!("{method:?}: every bit is the same"), same);
    }
}

fn threads(record: &mut Record) {
    let deck = Push { elements: 2400, increments: 5, mu: 0.3, ..Push::paper(Method::Isl) }.deck();
    let one = bits(&run_on(&deck, 1).unwrap());
    for threads in [2, 3] {
        let same = one == bits(&run_on(&deck, threads).unwrap());
        record.holds(format!("{threads} threads: every bit is the same"), same);
    }
}
