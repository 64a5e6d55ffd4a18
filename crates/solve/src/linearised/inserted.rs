//! Laws inserted: one linear system an iteration, and no problem of contact in it.
//!
//! ```text
//!   ( K_0 + sum A [ p' a a' + d (tau_s b + tau_p p' a)' ] ) du = -( r + sum A (p a + tau d) )
//!
//!   penalty:    p = p(h)                      the law at the trial
//!   augmented:  p = P(h + lambda/kappa)       its Moreau-Yosida form about a held multiplier
//! ```
//!
//! An infinite kappa makes the second line the first: one code for both. docs/theory.md eqs (8.30)
//! to (8.32).

use super::augmentation::Stiffness;
use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::laws::PointAnswer;
use super::points::{Augmentation, Kind, LinearPoints, LinearRows};
use slideline_linalg::{FactorReport, SolveError, Solver};
use slideline_mech::contact::enforcement::HeldMultiplier;
use slideline_mech::contact::tangential::Tangential;

/// Greatest stiffness between a held multiplier and its law, in stiffnesses that the point feels of
/// its own equations [1]: beyond, the rounding of an overclosure is felt in the forces.
const MOST: f64 = 10.0;
/// First stiffness, in those of the whole structure as the point feels it [1].
const FIRST: f64 = 10.0;
/// Least part of the stiffness with its slope that a point is taken to feel without it [1].
const LEAST_OWN: f64 = 1e-6;

/// Multipliers about which laws are inserted, a contact point each.
#[derive(Clone, Debug, Default)]
pub struct HeldMultipliers {
    /// The multipliers, with a stiffness of zero where they have none yet.
    pub of: Vec<HeldMultiplier>,
    /// Greatest stiffnesses that they may have [F/L3].
    most: Vec<Augmentation>,
    /// Points, of those of an iteration, that have been given a stiffness in it.
    fresh: Vec<usize>,
}

impl HeldMultipliers {
    /// Holds these multipliers.
    pub fn hold(&mut self, multipliers: impl Iterator<Item = HeldMultiplier>) {
        self.of.clear();
        self.of.extend(multipliers);
        self.most.clear();
        let most = |own: &HeldMultiplier| Augmentation {
            normal: own.normal_stiffness,
            tangential: own.tangential_stiffness,
        };
        self.most.extend(self.of.iter().map(most));
    }

    /// Room for so many points.
    pub fn fit(&mut self, points: usize) {
        self.of.clear();
        self.of.reserve(points);
        self.most.reserve(points);
        self.fresh.reserve(points);
    }

    /// Lets the multipliers stand nearer to their laws, as far as rounding allows.
    pub fn stiffen(&mut self, factor: f64) {
        for (own, most) in self.of.iter_mut().zip(&self.most) {
            own.normal_stiffness = (factor * own.normal_stiffness).min(most.normal);
            own.tangential_stiffness = (factor * own.tangential_stiffness).min(most.tangential);
        }
    }

    /// Gives points that touch, and have none, the greatest stiffness that they may have.
    fn admit(&mut self, points: &LinearPoints, stiffness: &Stiffness<'_>) {
        self.fresh.clear();
        for (index, point) in points.with_rows().enumerate() {
            let touches = point.stiffness > 0.0 || point.pressure > 0.0;
            let own = &mut self.of[point.place];
            if own.normal_stiffness > 0.0 || !touches {
                continue;
            }
            let local = stiffness.local(&point);
            // what nothing moves, or would slide, has its law as it is
            let most = |local: f64| if local > 0.0 { MOST * local } else { f64::INFINITY };
            let (normal, tangential) = (most(local.normal), most(local.tangential));
            let most = Augmentation { normal, tangential };
            (own.normal_stiffness, own.tangential_stiffness) = (most.normal, most.tangential);
            self.most[point.place] = most;
            self.fresh.push(index);
        }
    }

    /// Gives those points the stiffness of the structure as they feel it.
    fn feel(
        &mut self,
        points: &LinearPoints,
        answers: &[PointAnswer],
        (solver, response): (&mut Solver, &mut Vec<f64>),
    ) -> Result<(), SolveError> {
        for &index in &self.fresh {
            let (point, answer) = (points.at(index), &answers[index]);
            let mut own = |kind: Kind, slope: f64| {
                response.fill(0.0);
                point.push(kind, 1.0, response);
                solver.respond(response)?;
                Ok(without(slope, point.dot(kind, response)))
            };
            let (held, most) = (&mut self.of[point.place], &self.most[point.place]);
            held.normal_stiffness = own(Kind::Normal, answer.slope)?.min(most.normal);
            if point.sliding.is_some() && point.slides() {
                let mut softest = most.tangential;
                for k in 0..points.directions() {
                    let slope = answer.tangential_by_slip.at(k, k);
                    softest = softest.min(own(Kind::Tangential(k), slope)?);
                }
                held.tangential_stiffness = softest;
            }
        }
        Ok(())
    }
}

/// The first stiffness of a multiplier in a structure that yields by `compliance` with the slope of
/// the law in it: docs/theory.md eq. (8.12) [F/L3].
fn without(slope: f64, compliance: f64) -> f64 {
    match compliance > 0.0 {
        true => FIRST * (1.0 / compliance - slope).max(LEAST_OWN / compliance),
        false => f64::INFINITY,
    }
}

impl LinearisedContact {
    /// Asks the laws about held multipliers and factors the stiffness with their slopes.
    ///
    /// Errors: the solver's.
    pub fn insert(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        held: &mut HeldMultipliers,
        stiffness: &mut Stiffness<'_>,
    ) -> Result<FactorReport, SolveError> {
        held.admit(points, stiffness);
        self.ask_inserted(points, context, &held.of);
        let factored = stiffness.factor_inserted(points, &self.inserted)?;
        if held.fresh.is_empty() {
            return Ok(factored);
        }
        self.response.resize(stiffness.pattern.size(), 0.0);
        held.feel(points, &self.inserted, (stiffness.solver, &mut self.response))?;
        self.ask_inserted(points, context, &held.of);
        stiffness.factor_inserted(points, &self.inserted)
    }

    fn ask_inserted(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        held: &[HeldMultiplier],
    ) {
        self.inserted.clear();
        for index in 0..points.len() {
            if let Some(traction) = context.prescribed_sliding(&points.at(index)) {
                points[index].set_traction(traction);
            }
            let point = points.at(index);
            let held = &held[point.place];
            self.inserted.push(match held.normal_stiffness > 0.0 {
                true => context.inserted_or_touching(&point, held),
                // it is far from touching
                false => PointAnswer::default(),
            });
        }
    }

    /// As [`LinearisedContact::solve`], with the laws in the factored stiffness.
    pub(super) fn solve_inserted(
        &mut self,
        points: &mut LinearPoints,
        stiffness: &mut Stiffness<'_>,
        correction: &mut [f64],
    ) -> Result<(), SolveError> {
        for (point, answer) in points.with_rows().zip(&self.inserted) {
            for (k, &equation) in point.rows.unknowns.iter().enumerate() {
                let force = point.force_at(k, answer.normal, answer.tangential);
                correction[equation] -= point.area * force;
            }
        }
        stiffness.solver.solve(correction)?;
        for (index, answer) in self.inserted.iter().enumerate() {
            let unknowns = points.at(index).rows.unknowns;
            let (normal, slip) = points.at(index).values(|k| correction[unknowns[k]]);
            let (normal, tangential) = answer.change(normal, slip);
            points[index].pressure = answer.pressure + normal;
            points[index].set_traction(answer.traction + tangential);
        }
        Ok(())
    }
}

impl LawContext<'_> {
    /// The laws of a point where it stands. One that touches but for rounding has the slope of one
    /// that does, lest nothing hold a body that rests on others.
    fn inserted_or_touching(&self, point: &LinearRows<'_>, held: &HeldMultiplier) -> PointAnswer {
        let mut answer = self.inserted(point, (0.0, Tangential::ZERO), held);
        if answer.slope == 0.0 && answer.pressure == 0.0 {
            answer.slope = self.inserted(point, (self.rounding, Tangential::ZERO), held).slope;
        }
        answer
    }
}
