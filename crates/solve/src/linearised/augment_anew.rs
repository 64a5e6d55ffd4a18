//! The condensed problem placed on the stiffness of an iteration, and its augmentation taken anew
//! from the laws at an estimate.

use super::augmentation::{Stiffness, within};
use super::compliance::{Compliance, MatrixFree};
use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::points::{Augmentation, Kind, LinearPoints};
use super::rows::{Row, RowSlopes, Unknown, share_among_directions};
use slideline_linalg::SolveError;

/// Change of an augmentation that is worth a factorisation [1].
const WORTHWHILE: f64 = 1.5;

impl LinearisedContact {
    /// What does not depend on the estimate: starts, local stiffnesses, weights.
    pub(super) fn place_rows(
        &mut self,
        points: &LinearPoints,
        stiffness: &Stiffness<'_>,
        work: &MatrixFree,
    ) {
        for row in &mut self.rows {
            match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    let point = points.at(point);
                    let (local, augmentation) = (stiffness.local(&point), point.augmentation());
                    let (own, augmentation) = match kind {
                        Kind::Tangential(_) => (local.tangential, augmentation.tangential),
                        Kind::Normal => (local.normal, augmentation.normal),
                    };
                    row.free = row.start + point.dot(kind, &work.base);
                    (row.own, row.augmentation, row.felt) = (own, augmentation, own);
                    // what supports hold along its normal presses by the law alone
                    row.kappa = if own > 0.0 { own } else { f64::INFINITY };
                    let felt = own + augmentation;
                    let felt = if felt > 0.0 { felt } else { local.tangential };
                    row.weight = if felt > 0.0 { point.area / felt } else { point.area };
                }
                Unknown::Interface { equation } => {
                    let at = stiffness.pattern.position(equation, equation);
                    let own = at.map_or(0.0, |at| stiffness.augmented[at].abs());
                    row.free = work.base[equation];
                    (row.own, row.kappa, row.felt) = (own, own, own);
                    row.weight = if own > 0.0 { 1.0 / own } else { 1.0 };
                }
            }
        }
        share_among_directions(&mut self.rows);
    }

    /// e = free - C (q - anchor).
    pub(super) fn displace(
        &mut self,
        points: &LinearPoints,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        q: &[f64],
    ) -> Result<(), SolveError> {
        let MatrixFree { full, yielded, values, solves, base, .. } = work;
        let on_interface = work.on_interface;
        let rows = &self.rows;
        let mut c = Compliance { rows, points, full, on_interface, solves, fault: None };
        let anchor = &self.anchor;
        c.push(|i| q[i] - anchor[i]);
        match q != &anchor[..] {
            true => c.respond(stiffness, yielded),
            false => yielded.fill(0.0),
        }
        let fault = c.fault;
        for ((value, row), y) in values.iter_mut().zip(&self.rows).zip(yielded) {
            *value = row.free - *y;
        }
        self.moved.clear();
        self.moved.extend(base.iter().zip(&*full).map(|(base, yielded)| base - yielded));
        fault.map_or(Ok(()), Err)
    }

    /// Takes the augmentation from the laws at the present estimate and factors
    /// anew; the multipliers and displacements stay. False: nothing to gain.
    pub(super) fn augment_anew(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        q: &mut [f64],
    ) -> Result<bool, SolveError> {
        let wanted = self.wanted(points, stiffness, work);
        let changes = |now: f64, then: f64| {
            let (low, high) = (now.min(then), now.max(then));
            high > 0.0 && high > WORTHWHILE * low
        };
        let any = wanted.iter().any(|&(place, new)| {
            let old = points[place].augmentation();
            changes(old.normal, new.normal) || changes(old.tangential, new.tangential)
        });
        if !any {
            return Ok(false);
        }
        let multipliers: Vec<f64> = (0..q.len())
            .map(|i| q[i] + self.rows[i].augmentation * (work.values[i] - self.rows[i].start))
            .collect();
        wanted.into_iter().for_each(|(place, new)| points[place].set_augmentation(new));
        stiffness.factor(points)?;
        work.find_base(stiffness)?;
        self.anchor.fill(0.0);
        self.place_rows(points, stiffness, work);
        for (i, row) in self.rows.iter().enumerate() {
            if row.point().is_some() {
                q[i] = multipliers[i] - row.augmentation * (work.values[i] - row.start);
            }
        }
        for integration_point in self.integration_points.iter() {
            integration_point.rows.iter().for_each(|&i| q[i] = 0.0);
        }
        for integration_point in self.integration_points.iter() {
            let point = points.at(integration_point.point);
            let answer = context.integration_point(integration_point, &point, &work.values);
            for (a, &i) in integration_point.rows.iter().enumerate() {
                q[i] += point.area * point.force_at(a, answer.normal, answer.tangential);
            }
        }
        self.displace(points, stiffness, work, q)?;
        Ok(true)
    }

    /// The augmentation of every point with rows that makes the operator of GMRES
    /// diagonal at the present estimate: docs/theory.md eq. (8.28).
    fn wanted(
        &self,
        points: &LinearPoints,
        stiffness: &Stiffness<'_>,
        work: &MatrixFree,
    ) -> Vec<(usize, Augmentation)> {
        let slope =
            |of: &RowSlopes, own: usize| of.by_value[own] / (1.0 - of.by_multiplier[own]).max(0.0);
        let mut wanted = Vec::with_capacity(self.rows.len());
        for (i, row) in self.rows.iter().enumerate() {
            let Some((place, Kind::Normal)) = row.point() else { continue };
            let local = stiffness.local(&points.at(place));
            let next = self.rows.get(i + 1).and_then(Row::point);
            // where it slides in space, nothing stiffens it along its way
            let along = |direction: usize| slope(&work.laws.rows[i + 1 + direction], direction);
            let sticks =
                |direction: usize| work.laws.rows[i + 1 + direction].by_multiplier[direction];
            let tangential = match next == Some((place, Kind::Tangential(0))) {
                true => (0..points.directions())
                    .min_by(|&a, &b| sticks(a).total_cmp(&sticks(b)))
                    .map_or(0.0, |least| within(along(least), local.tangential, 0.0)),
                false => 0.0,
            };
            let normal = within(slope(&work.laws.rows[i], 0), local.normal, 0.0);
            wanted.push((place, Augmentation { normal, tangential }));
        }
        for (integration_point, answer) in self.integration_points.iter().zip(&work.laws.points) {
            let point = points.at(integration_point.point);
            let (local, augmentation) = (stiffness.local(&point), point.augmentation());
            let by_slip = |direction| answer.tangential_by_slip.at(direction, direction);
            let least = (0..points.directions()).map(by_slip).fold(f64::INFINITY, f64::min);
            let normal = within(answer.slope + augmentation.normal, local.normal, 0.0);
            let tangential = within(least + augmentation.tangential, local.tangential, 0.0);
            wanted.push((integration_point.point, Augmentation { normal, tangential }));
        }
        wanted
    }
}
