//! Runs decks and measures what comes out, for the claims in `tests/`; makes
//! the verification report of what they measured.
//!
//! ```text
//!   deck builder --> text --> slideline --> Curve --> metrics --> Record --> report
//!                                                       ^            ^
//!                     slideline-theory: closed form ----+   Claim ---+
//! ```
//!
//! Nothing here shares code with what it checks: the metrics are written
//! again, and every reference comes from `slideline-theory`, which shares no
//! code with the solver either.

mod cam;
mod claim;
mod curve;
mod derivatives;
mod interpolation;
pub mod many_points;
mod metrics;
mod nodal;
mod push;
pub mod random;
mod record;
mod report;
mod solids;
pub mod strokes;

pub use cam::Cam;
pub use claim::{Chapter, Claim, Group, Outcome};
pub use curve::{Curve, Row, run, run_on};
pub use derivatives::{Held, derivatives};
pub use interpolation::{Elasticity, Errors, Field, errors};
pub use metrics::{
    Difference, differ, largest, largest_difference, peak, reversals, roughness, trapezoid, worst,
};
pub use nodal::nodal_stress;
pub use push::{Beam, Method, Placement, Push, Slaves, Units};
pub use record::{Chart, Limit, Measured, Record, Study, series};
pub use report::{write_record, write_report};
pub use solids::{Meshed, Solid};

/// The decks of the 1995 paper as shipped in the corpus.
pub mod paper {
    /// Circle on a cantilever, contact elements on the beam, 24 beams.
    pub const IRS_COARSE: &str = include_str!("../../corpus/diehl1995/irs_coarse.inp");
    /// The same with 99 beams.
    pub const IRS_FINE: &str = include_str!("../../corpus/diehl1995/irs_fine.inp");
    /// Circle on a cantilever, contact elements on the circle, 24 beams.
    pub const ISL_COARSE: &str = include_str!("../../corpus/diehl1995/isl_coarse.inp");
    /// The circle on the cantilever there and back, ISL, mu = 0.3.
    pub const ISL_PUSH_PULL: &str =
        include_str!("../../corpus/diehl1995/isl_coarse_push_pull_mu03.inp");
    /// The same without friction.
    pub const ISL_PUSH_PULL_SMOOTH: &str =
        include_str!("../../corpus/diehl1995/isl_coarse_push_pull.inp");
    /// The cam turned into the cantilever and back, mu = 0.3.
    pub const CAM_PUSH_PULL: &str =
        include_str!("../../corpus/diehl1995/cam_isl_push_pull_mu03.inp");
    /// The same without friction.
    pub const CAM_PUSH_PULL_SMOOTH: &str =
        include_str!("../../corpus/diehl1995/cam_isl_push_pull.inp");
    /// Circle on a cantilever, contact integrated along 24 beams.
    pub const SURFACE_COARSE: &str = include_str!("../../corpus/diehl1995/surface_coarse.inp");
    /// The same with friction.
    pub const SURFACE_COARSE_MU03: &str =
        include_str!("../../corpus/diehl1995/surface_coarse_mu03.inp");
    /// Cam turned into a cantilever, contact integrated along 24 beams.
    pub const CAM_SURFACE: &str = include_str!("../../corpus/diehl1995/cam_surface.inp");
    /// The same with friction.
    pub const CAM_SURFACE_MU03: &str = include_str!("../../corpus/diehl1995/cam_surface_mu03.inp");
    /// `ISL_COARSE` as the paper prints it, page furniture included.
    pub const ISL_AS_PRINTED: &str = include_str!("../../corpus/bad/isl_as_printed.inp");
}
