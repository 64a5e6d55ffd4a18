//! When an iteration counts as converged: forces and moments apart.
//!
//! Semantics of Newton and increments (manual). With q the average nodal
//! force of the elements now, qt its average over the increments of the
//! step, r the largest nodal residual, c the largest correction and Du the
//! largest increment:
//!
//! ```text
//!   r <= R qt   and   ( c <= C Du   or   r c / min(r_-1, r_-2) < C Du   or   r <= R_l qt )
//! ```
//!
//! Norms are those of nodal vectors, so that a rotated deck takes the same
//! iterations. Below the floor of rounding nothing can be asked.

use crate::dofs::DofMap;
use crate::observe::reports::FieldReport;
use serde::{Deserialize, Serialize};
use slideline_model::FieldControls;

/// What a field remembers from iteration to iteration.
#[derive(Clone, Copy, Debug, Default)]
pub struct FieldHistory {
    /// Residuals of the last two iterations, the latest first [F or F L].
    last: [Option<f64>; 2],
    /// How often the residual has grown in a row.
    pub growing: u32,
}

impl FieldHistory {
    /// Takes an equilibrium iteration in.
    pub fn push(&mut self, residual: f64) {
        self.growing = match self.last[0] {
            Some(before) if residual > before => self.growing + 1,
            _ => 0,
        };
        self.last = [Some(residual), self.last[0]];
    }

    /// r_i / r_{i-1}, where both are known.
    pub fn rate(&self) -> Option<f64> {
        match self.last {
            [Some(now), Some(before)] if before > 0.0 => Some(now / before),
            _ => None,
        }
    }

    fn smallest_before(&self) -> Option<f64> {
        match self.last {
            [Some(a), Some(b)] => Some(a.min(b)),
            [Some(a), None] => Some(a),
            _ => None,
        }
    }
}

/// Time average of the flux of one field over a step, and the largest flux of
/// the analysis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FluxAverage {
    sum: f64,
    count: f64,
    largest: f64,
}

impl FluxAverage {
    /// A step averages anew; what the analysis has seen at most is kept.
    pub fn begin_step(&mut self) {
        (self.sum, self.count) = (0.0, 0.0);
    }

    /// The largest flux of the analysis, with the present one [F or F L].
    pub fn largest_with(&self, now: f64) -> f64 {
        self.largest.max(now)
    }

    /// qt with the present flux counted in [F or F L]; increments without
    /// flux do not dilute it.
    pub fn with(&self, now: f64, controls: &FieldControls) -> f64 {
        match controls.fixed_flux {
            Some(fixed) => fixed,
            None if self.count == 0.0 && controls.initial_flux.is_some() => {
                controls.initial_flux.unwrap_or(now)
            }
            None if now <= controls.epsilon * self.mean() => self.mean(),
            None => (self.sum + now) / (self.count + 1.0),
        }
    }

    /// Takes a committed increment in.
    pub fn commit(&mut self, now: f64, controls: &FieldControls) {
        self.largest = self.largest_with(now);
        if now > controls.epsilon * self.mean() {
            self.sum += now;
            self.count += 1.0;
        }
    }

    fn mean(&self) -> f64 {
        if self.count > 0.0 { self.sum / self.count } else { 0.0 }
    }
}

/// The numbers an iteration is judged by.
#[derive(Clone, Copy, Debug)]
pub struct Measures {
    /// Flux now [F or F L].
    pub flux: f64,
    /// Time-averaged flux [F or F L].
    pub average: f64,
    /// Rounding floor of the residual [F or F L].
    pub floor: f64,
    /// Number of the equilibrium iteration, from 1.
    pub iteration: u32,
    /// I_P.
    pub late: u32,
}

/// Fills in the verdict on one field.
pub fn judge(
    report: &mut FieldReport,
    history: &FieldHistory,
    measures: &Measures,
    controls: &FieldControls,
) {
    let Measures { flux, average, floor, .. } = *measures;
    let r = if measures.iteration <= measures.late { controls.r_n } else { controls.r_p };
    report.average = average;
    if flux <= controls.epsilon * average {
        report.allowed = (controls.epsilon * average).max(floor);
        report.converged = report.residual <= report.allowed
            || report.residual <= r * average
                && report.correction <= controls.c_epsilon * report.increment;
        return;
    }
    report.allowed = (r * average).max(floor);
    let small_step = report.correction <= controls.c_n * report.increment;
    let promised = history.smallest_before().is_some_and(|before| {
        before > 0.0
            && report.residual * report.correction / before < controls.c_n * report.increment
    });
    let tiny = report.residual <= (controls.r_l * average).max(floor);
    report.converged = report.residual <= report.allowed && (small_step || promised || tiny);
}

/// The largest nodal vector of displacements or forces and that of rotations or moments, and where
/// the largest component of each stands. Only dofs that `value` gives a value take part; one that is
/// no number is the largest.
pub fn largest_nodal(
    dofs: &DofMap,
    value: impl Fn(usize) -> Option<f64>,
) -> [(f64, Option<usize>); 2] {
    let mut largest = [(0.0_f64, None); 2];
    for node in 0..dofs.nodes() {
        let mut square = [0.0; 2];
        for dof in dofs.named_of_node(node) {
            if let Some(value) = value(dof) {
                square[usize::from(dofs.is_rotation(dof))] += value * value;
            }
        }
        for field in 0..2 {
            let (now, most) = (square[field], largest[field].0);
            if now > most || now.is_nan() && !most.is_nan() {
                largest[field] = (now, Some(node));
            }
        }
    }
    [0, 1].map(|field| {
        let (square, node) = largest[field];
        let own = |dof: &usize| usize::from(dofs.is_rotation(*dof)) == field;
        let of_node = node.into_iter().flat_map(|node| dofs.named_of_node(node)).filter(own);
        let sizes = of_node.filter_map(|dof| Some((value(dof)?.abs(), Some(dof))));
        let larger = |largest: (f64, Option<usize>), own: (f64, Option<usize>)| {
            if own.0 > largest.0 || own.0.is_nan() { own } else { largest }
        };
        (square.sqrt(), sizes.fold((0.0, None), larger).1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(residual: f64, correction: f64) -> FieldReport {
        FieldReport { residual, correction, increment: 1.0, ..FieldReport::default() }
    }

    fn verdict(residual: f64, correction: f64, flux: f64) -> bool {
        let mut report = report(residual, correction);
        let measures = Measures { flux, average: 1.0, floor: 1e-12, iteration: 1, late: 9 };
        judge(&mut report, &FieldHistory::default(), &measures, &FieldControls::default());
        report.converged
    }

    /// Semantics, section 9, each alternative once.
    #[test]
    fn each_alternative_of_the_test() {
        assert!(verdict(0.9e-6, 0.9e-2, 1.0), "residual and correction small");
        assert!(!verdict(1.1e-6, 0.9e-2, 1.0), "residual too large");
        assert!(!verdict(0.9e-6, 1.1e-2, 1.0), "correction too large");
        assert!(verdict(0.9e-8, 1.0, 1.0), "residual tiny");
        assert!(verdict(0.9e-5, 1.0, 0.0), "no flux: epsilon");
    }

    #[test]
    fn growth_is_counted_in_a_row() {
        let mut history = FieldHistory::default();
        for residual in [1.0, 2.0, 3.0] {
            history.push(residual);
        }
        assert_eq!((history.growing, history.rate()), (2, Some(1.5)));
        history.push(1.0);
        assert_eq!(history.growing, 0);
    }

    #[test]
    fn increments_without_flux_do_not_dilute_the_average() {
        let controls = FieldControls::default();
        let mut average = FluxAverage::default();
        average.commit(0.0, &controls);
        average.commit(2.0, &controls);
        assert_eq!(average.with(4.0, &controls), 3.0);
        assert_eq!(average.with(0.0, &controls), 2.0);
    }
}
