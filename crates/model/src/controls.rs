//! `*CONTROLS`: when an iteration has converged and how increments adapt.
//! Defaults and their sources: semantics of Newton and increments.

/// All controls of a step.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Controls {
    /// `PARAMETERS=FIELD`.
    pub field: FieldControls,
    /// `PARAMETERS=TIME INCREMENTATION`.
    pub time: TimeIncrementation,
    /// `ANALYSIS=DISCONTINUOUS`: I_0 = 8, I_R = 10, overriding the above.
    pub discontinuous: bool,
}

impl Controls {
    /// The iteration limits that rule, `ANALYSIS=DISCONTINUOUS` applied.
    pub fn effective_time(&self) -> TimeIncrementation {
        if self.discontinuous {
            TimeIncrementation { i_0: 8, i_r: 10, ..self.time }
        } else {
            self.time
        }
    }
}

/// Tolerances on residual and correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldControls {
    /// R_n: residual against time-averaged flux [1].
    pub r_n: f64,
    /// C_n: correction against the largest increment [1].
    pub c_n: f64,
    /// Initial time-averaged flux, where the deck gives it [F].
    pub initial_flux: Option<f64>,
    /// Fixed flux, where the deck gives it [F].
    pub fixed_flux: Option<f64>,
    /// R_p: residual tolerance after I_P iterations [1].
    pub r_p: f64,
    /// epsilon: fraction of the flux below which there is none [1].
    pub epsilon: f64,
    /// C_epsilon: correction tolerance where there is no flux [1].
    pub c_epsilon: f64,
    /// R_l: residual at which one linear iteration suffices [1].
    pub r_l: f64,
    /// Whether the deck set R_n (the report says which tolerance ruled).
    pub set_by_deck: bool,
}

impl Default for FieldControls {
    /// The manual's values, but R_n = 1e-6 and R_p = 4 R_n (ours: results
    /// must not depend on where Newton happened to stop).
    fn default() -> Self {
        Self {
            r_n: 1e-6,
            c_n: 1e-2,
            initial_flux: None,
            fixed_flux: None,
            r_p: 4e-6,
            epsilon: 1e-5,
            c_epsilon: 1e-3,
            r_l: 1e-8,
            set_by_deck: false,
        }
    }
}

/// Iteration limits and cutback factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeIncrementation {
    /// I_0: first iteration at which divergence is looked for.
    pub i_0: u32,
    /// I_R: first iteration at which the rate is extrapolated.
    pub i_r: u32,
    /// I_P: iteration after which R_p replaces R_n.
    pub i_p: u32,
    /// I_C: largest number of iterations.
    pub i_c: u32,
    /// I_L: more iterations than this shorten the next increment.
    pub i_l: u32,
    /// I_G: at most this many, twice running, lengthen it.
    pub i_g: u32,
    /// I_S: largest number of severe discontinuity iterations.
    pub i_s: u32,
    /// I_A: largest number of attempts for one increment.
    pub i_a: u32,
    /// D_f: cut after divergence [1].
    pub d_f: f64,
    /// D_C: cut after too slow a rate [1].
    pub d_c: f64,
    /// D_B: shortening after many iterations [1].
    pub d_b: f64,
    /// D_D: lengthening after few [1].
    pub d_d: f64,
}

impl Default for TimeIncrementation {
    fn default() -> Self {
        Self {
            i_0: 4,
            i_r: 8,
            i_p: 9,
            i_c: 16,
            i_l: 10,
            i_g: 4,
            i_s: 12,
            i_a: 5,
            d_f: 0.25,
            d_c: 0.5,
            d_b: 0.75,
            d_d: 1.5,
        }
    }
}
