//! Parts of an increment, walked on their own, and what each leaves over.

use crate::commit::commit;
use crate::constraints::Role;
use crate::increments::Verdict;
use crate::newton::{Scratch, attempt};
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;

/// How near a limit is walked up to, as a part of what was to be halved.
const SHORTEST: f64 = 1.0 / 256.0;

/// Part of what an increment left over that its halves leave where no jump is:
/// the rule's error falls by four.
pub(super) const FALLS: f64 = 0.4;

/// A part of an increment with the states at both ends.
pub(super) struct Part {
    pub from: State,
    pub to: State,
    /// Time in the step at its end, and its length [T].
    pub end: f64,
    pub dt: f64,
    /// What the rest of the increment turned over.
    pub rest: Rest,
}

/// Sums over the parts of an increment that hold no jump [F L].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rest {
    pub work: f64,
    pub dissipation: f64,
    pub left: f64,
}

impl Rest {
    pub fn with(mut self, part: &Part) -> Self {
        self.work += part.change(|state| state.energy.external_work);
        self.dissipation += part.change(|state| state.energy.friction_dissipation);
        self.left += part.to.books.left;
        self
    }
}

impl Part {
    fn change(&self, of: impl Fn(&State) -> f64) -> f64 {
        of(&self.to) - of(&self.from)
    }

    /// What it leaves over if points that opened did not slide on before:
    /// in a jump they do not.
    pub fn left(&self) -> f64 {
        self.to.books.left + self.to.books.opening
    }

    /// A part from a state on; `None` where it has no end.
    fn solve(
        plan: &Problem<'_>,
        from: &State,
        aim: &Target,
        rest: Rest,
        work: &mut Scratch,
    ) -> Option<Self> {
        let outcome = attempt(plan, from, aim, work, &mut |_| {});
        let found = matches!(outcome.verdict, Verdict::Converged { .. }).then(|| {
            let mut to = work.copy(from);
            commit(plan, from, aim, work, &mut to);
            Self { from: work.copy(from), to, end: aim.step_time, dt: aim.dt, rest }
        });
        work.take_back(outcome);
        found
    }

    /// Its states are no longer needed.
    pub fn spare(self, work: &mut Scratch) {
        [self.from, self.to].into_iter().for_each(|state| work.spare(state));
    }

    /// The jump of a part whose halves have no end: the path is walked up to
    /// its limit, and from the end back to the loads and supports of there.
    pub fn over_the_limit(
        &self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
        enough: f64,
    ) -> Option<Self> {
        let (mut limit, mut rest) = (self.from.clone(), self.rest);
        let mut dt = 0.5 * self.dt;
        while dt > SHORTEST * self.dt {
            let aim = Target { step_time: limit.step_time + dt, dt, ..*target };
            let nearer = match aim.step_time < self.end {
                true => Self::solve(plan, &limit, &aim, rest, work),
                false => None,
            };
            match nearer.filter(|nearer| nearer.left().abs() <= enough) {
                Some(nearer) => {
                    rest = rest.with(&nearer);
                    limit = nearer.to;
                }
                None => dt *= 0.5,
            }
        }
        let end = limit.step_time;
        let back = Target { step_time: end, dt: end - self.end, ..*target };
        // Not guessed from the increment that jumped: that would lead back.
        let from = State { increment_time: (0.0, 0.0), ..self.to.clone() };
        let back = Self::solve(plan, &from, &back, Rest::default(), work)?;
        let beyond = Rest::default().with(&back);
        rest.work -= beyond.work;
        rest.dissipation -= beyond.dissipation;
        rest.left -= beyond.left;
        let mut landed = back.to;
        let done = done_between(plan, &limit, &landed);
        landed.books.left = done - (kept(&landed) - kept(&limit));
        (landed.books.opening, landed.books.opening_dissipation) = (0.0, 0.0);
        landed.energy.external_work = limit.energy.external_work + done;
        landed.energy.friction_dissipation = limit.energy.friction_dissipation;
        Some(Self { from: limit, to: landed, end, dt: 0.0, rest })
    }

    /// Its second half without a walk: from the end of the first to its own, where nothing that
    /// the way leaves behind stands between them and both halves leave what a smooth path leaves.
    fn known_half(&self, plan: &Problem<'_>, first: &Self, work: &mut Scratch) -> Option<Self> {
        let (middle, end) = (&first.to, &self.to);
        let forgets = !plan.model.remembers();
        let apart = |state: &&State| {
            state.temperatures.is_empty() && state.points.iter().all(|point| !point.closed)
        };
        let left = done_between(plan, middle, end) - (kept(end) - kept(middle));
        let smooth = (first.left() + left).abs() <= FALLS * self.left().abs();
        (smooth && forgets && [&self.from, middle, end].iter().all(apart)).then(|| {
            let (from, mut to) = (work.copy(middle), work.copy(end));
            to.books.left = left;
            Self { from, to, end: self.end, dt: first.dt, rest: self.rest }
        })
    }

    /// Its half that leaves more over, and what both leave [F L]; `None` where a
    /// half has no end.
    pub fn sharper_half(
        &self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
    ) -> Option<(Self, f64)> {
        let dt = 0.5 * self.dt;
        let aim = |step_time: f64| Target { step_time, dt, ..*target };
        let first = Self::solve(plan, &self.from, &aim(self.end - dt), self.rest, work)?;
        let known = self.known_half(plan, &first, work);
        let solved = || Self::solve(plan, &first.to, &aim(self.end), self.rest, work);
        let Some(second) = known.or_else(solved) else {
            first.spare(work);
            return None;
        };
        let both = first.left() + second.left();
        let (mut sharper, other) = match first.left().abs() >= second.left().abs() {
            true => (first, second),
            false => (second, first),
        };
        sharper.rest = self.rest.with(&other);
        other.spare(work);
        Some((sharper, both))
    }

    /// Whether something that is prescribed or applied makes most of its own
    /// change in this part of `whole`: not the structure jumps then.
    pub fn is_driven(&self, plan: &Problem<'_>, whole: &Self) -> bool {
        let change = |part: &Self, dof: usize| match plan.constraints.roles[dof] {
            Role::Prescribed(_) => part.to.displacement[dof] - part.from.displacement[dof],
            _ => {
                let force = |state: &State| state.load[dof] + state.reaction[dof];
                force(&part.to) - force(&part.from)
            }
        };
        let mut dofs = 0..plan.dofs.len().min(self.from.load.len());
        dofs.any(|dof| change(self, dof).abs() > 0.5 * change(whole, dof).abs())
    }
}

/// Work of loads and supports from one state to another by the trapezoidal rule [F L].
fn done_between(plan: &Problem<'_>, from: &State, to: &State) -> f64 {
    let force = |state: &State, dof: usize| state.load[dof] + state.reaction[dof];
    let done = |dof: usize| {
        let mean = 0.5 * (force(from, dof) + force(to, dof));
        mean * (to.displacement[dof] - from.displacement[dof])
    };
    (0..plan.dofs.len()).map(done).sum()
}

/// Energy that a state keeps [F L].
fn kept(state: &State) -> f64 {
    state.energy.of_the_model()
}
