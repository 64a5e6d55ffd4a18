//! The same bits on a second run and on any number of threads.
//!
//! Source: verification section 7. Equality of bits: no tolerance. More than
//! 2000 elements, so that elements are evaluated on all threads.

use slideline_verification::{Curve, Method, Push, run, run_on};

fn bits(curve: &Curve) -> Vec<u64> {
    let rows = curve.rows.iter();
    rows.flat_map(|row| row.displacement.iter().chain(&row.reaction).flatten())
        .map(|value| value.to_bits())
        .collect()
}

#[test]
fn second_run() {
    for method in [Method::Irs, Method::Isl] {
        let deck = Push { mu: 0.3, ..Push::paper(method) }.deck();
        assert!(bits(&run(&deck).unwrap()) == bits(&run(&deck).unwrap()), "{method:?}");
    }
}

#[test]
fn threads() {
    let deck = Push { elements: 2400, increments: 5, mu: 0.3, ..Push::paper(Method::Isl) }.deck();
    let one = bits(&run_on(&deck, 1).unwrap());
    assert!(one == bits(&run_on(&deck, 2).unwrap()), "two threads");
    assert!(one == bits(&run_on(&deck, 3).unwrap()), "three threads");
}
