//! The decks of the study, as they lie in `corpus/diehl1995`.

/// A deck with the name of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Deck {
    /// Name of the file, without `.inp`.
    pub name: &'static str,
    /// The cards.
    pub text: &'static str,
}

macro_rules! deck {
    ($name:literal) => {
        Deck {
            name: $name,
            text: include_str!(concat!("../../../corpus/diehl1995/", $name, ".inp")),
        }
    };
}

/// A model's decks: without friction, with penalty stick, with Lagrange stick.
pub(crate) type Family = [Deck; 3];

/// First problem, contact elements on the beam, 24 beams.
pub(crate) const IRS_COARSE: Family =
    [deck!("irs_coarse"), deck!("irs_coarse_mu03"), deck!("irs_coarse_mu03_lagrange")];
/// The same with 99 beams.
pub(crate) const IRS_FINE: Family =
    [deck!("irs_fine"), deck!("irs_fine_mu03"), deck!("irs_fine_mu03_lagrange")];
/// First problem, contact elements on the circle, 24 beams.
pub(crate) const ISL: Family =
    [deck!("isl_coarse"), deck!("isl_coarse_mu03"), deck!("isl_coarse_mu03_lagrange")];
/// First problem, contact integrated along 24 beams. Not in the paper.
pub(crate) const INTEGRATED: Family =
    [deck!("surface_coarse"), deck!("surface_coarse_mu03"), deck!("surface_coarse_mu03_lagrange")];
/// Second problem, slave nodes every 3 degrees of the cam.
pub(crate) const CAM: Family =
    [deck!("cam_isl"), deck!("cam_isl_mu03"), deck!("cam_isl_mu03_lagrange")];
/// The same with slave nodes every 4 degrees.
pub(crate) const CAM_WIDE: Family =
    [deck!("cam_isl_4deg"), deck!("cam_isl_4deg_mu03"), deck!("cam_isl_4deg_mu03_lagrange")];
/// Second problem, contact integrated along 24 beams. Not in the paper.
pub(crate) const CAM_INTEGRATED: Family =
    [deck!("cam_surface"), deck!("cam_surface_mu03"), deck!("cam_surface_mu03_lagrange")];
