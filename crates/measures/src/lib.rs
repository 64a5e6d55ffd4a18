//! Measures on finished curves: pure functions on slices.
//!
//! ```text
//!   RF |  .-.      peak
//!      | /   `.    reversal: the slope changes sign
//!      |/      `-- work: the area below
//!      +---------> U
//! ```
//!
//! A curve is a slice of values, one for each increment; where positions or
//! times matter they are a second slice of the same length. A measure that does
//! not exist (too few values, lengths that differ, a peak of zero) is `None`,
//! never a number made up.

// dimension tags such as [F] are not links
#![allow(rustdoc::broken_intra_doc_links)]

mod difference;
mod error_bar;
mod friction;
mod noise;
mod paired;
mod peak;
mod shape;
mod stroke;
mod variance;
mod verdict;
mod work;

pub use difference::{max_error, maximum, rms, rms_error};
pub use error_bar::error_bar;
pub use friction::friction_kept;
pub use noise::{MeshNoise, NoiseSummary, PairNoise, ReactionNoise};
pub use peak::{Peak, Peaks, SnapForces, peaks, snap_forces};
pub use shape::{
    DEFAULT_NOISE_FLOOR, pushes, reversals, roughness, roughness_against, stroke_reversals,
    stroke_roughness, strokes,
};
pub use stroke::{Stroke, Taken, WayOut, stroke};
pub use variance::{Moments, Share, Shares};
pub use verdict::{COARSE_PEAK, Colour, RunMeasures, Verdict, verdict};
pub use work::{work, work_ratio};
