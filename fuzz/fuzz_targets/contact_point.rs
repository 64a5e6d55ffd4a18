//! A contact point never gives NaN for finite input of any size that a model
//! can hold.
#![no_main]

use libfuzzer_sys::fuzz_target;
use slideline_mech::contact::friction::{FrictionLaw, Stick};
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::contact::search::chain::Chain;

/// Numbers of magnitude 1e-9 to 1e9, both signs.
fn numbers(bytes: &[u8]) -> Vec<f64> {
    let read = |chunk: &[u8]| i32::from_le_bytes([chunk[0], chunk[1], chunk[2], chunk[3]]);
    let scaled = |n: i32| f64::from(n) * 10f64.powi(n.rem_euclid(9) - 9);
    bytes.chunks_exact(4).map(read).map(scaled).collect()
}

fuzz_target!(|bytes: &[u8]| {
    let v = numbers(bytes);
    if v.len() < 12 {
        return;
    }
    let law = NormalLaw::Exponential { clearance: v[0].abs() + 1e-9, pressure: v[1].abs() + 1e-9 };
    let (p, slope) = law.pressure(v[2]).unwrap_or_default();
    assert!(!p.is_nan() && !slope.is_nan() && !law.energy(v[2]).is_nan());
    let friction = FrictionLaw::Coulomb {
        coefficient: v[3].abs().min(10.0),
        limit: None,
        decay: None,
        stick: Stick::Lagrange,
    };
    assert!(!friction.limit_traction(p, v[4], 1.0).is_nan());
    let nodes: Vec<[f64; 2]> = v[6..].chunks_exact(2).map(|xy| [xy[0], xy[1]]).collect();
    if let Some(chain) = Chain::new(&nodes, 0.25, 0.1) {
        let piece = chain.closest(&nodes, [v[4], v[5]], None);
        assert!(piece.is_none_or(|piece| piece.nodes().end <= nodes.len()));
    }
});
