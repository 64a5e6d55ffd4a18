//! Two-node beams whose tension is not small against their shear stiffness.
//!
//! ```text
//!    N <---o=======/=====o---> N     along a section that leans by gam the tension does less work:
//!                 / gam              the shear stiffness that is left is K - N
//! ```
//!
//! K falls with the square of the length of these elements, so that a few long ones come to N ~ K at strains of a
//! thousandth. docs/theory.md section 3, under tension. (derived)

use crate::observe::results::BlockResults;
use crate::problem::Problem;
use crate::target::Target;
use serde::{Deserialize, Serialize};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{BeamSection, ElementBlock, Kinematics, Model, NodeIndex, Section};

/// Part by which moments at a clamp may be short [1].
const SHORT: f64 = 0.05;
/// Part from which on they are wrong [1].
const WRONG: f64 = 0.5;
/// Energy of bending and shear against that of the tension, below which a beam is straight [1].
const STRAIGHT: f64 = 1e-6;

/// An element whose tension counts against its shear stiffness.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Overpulled {
    /// Index of its block.
    block: usize,
    /// Its index there.
    member: usize,
    /// N [F].
    tension: f64,
    /// K, reduced by its length [F].
    shear: f64,
    /// N (1/K - 1/kGA): what the reduction adds to N over the shear stiffness [1].
    added: f64,
    /// Undeformed length [L].
    length: f64,
}

impl Overpulled {
    /// The one with the largest N/K among results of elements.
    pub fn worst(plan: &Problem<'_>, results: &[BlockResults]) -> Option<Self> {
        let all = results.iter().flat_map(|results| of_block(plan.model, results));
        all.max_by(|a, b| a.ratio().total_cmp(&b.ratio()))
    }

    /// N/K [1].
    pub fn ratio(&self) -> f64 {
        self.tension / self.shear
    }

    /// Whether bending there is wrong by half and more.
    pub fn is_wrong(&self) -> bool {
        self.ratio() > pull(WRONG)
    }

    /// SL0625 where bending is wrong, SL0624 where it is doubtful.
    fn code(&self) -> Code {
        if self.is_wrong() { Code("SL0625") } else { Code("SL0624") }
    }

    /// The element with its N and K, in words that follow a place in the run.
    pub fn words(&self, model: &Model) -> String {
        let block = &model.blocks[self.block];
        let element = block.elements.get(self.member);
        format!(
            "element {} ({}) bears a tension of {:.4e}, {:.3} of its shear stiffness of {:.4e}",
            element.label,
            block.word(),
            self.tension,
            self.ratio(),
            self.shear
        )
    }

    /// How to be rid of it.
    pub fn remedy(&self, model: &Model) -> String {
        let others = match model.blocks[self.block].kind.is_space_beam() {
            true => "B32",
            false => "B22 or B23",
        };
        format!(
            "make elements there shorter than {:.3e} ({:.3e} now: their shear stiffness grows with the inverse square of \
             their length), or take {others}",
            self.length * (pull(SHORT) / self.added).sqrt(),
            self.length
        )
    }

    /// Whether it is an element of the model, with numbers that a run can reach.
    fn is_sound(&self, model: &Model) -> bool {
        let numbers = [self.tension, self.shear, self.added, self.length];
        let block = model.blocks.get(self.block);
        let is_element = block.is_some_and(|block| self.member < block.elements.len());
        is_element && numbers.iter().all(|own| own.is_finite())
    }

    /// The warning: where in the run it was found is given in words.
    fn warning(&self, model: &Model, at: &str) -> Diagnostic {
        let what = match self.is_wrong() {
            true => "its sections turn away from its axis, and bending there is wrong".to_owned(),
            false => {
                let short = 100.0 * (1.0 - (1.0 - self.ratio()).sqrt());
                format!("bending moments at supports and loads are short by about {short:.0} %")
            }
        };
        let message = format!("{} {at}: {what}", self.words(model));
        let element = model.blocks[self.block].elements.get(self.member);
        Diagnostic::warning(self.code(), message).at(element.origin).help(self.remedy(model))
    }

    /// What stopped a run, with this element as its likely cause.
    pub fn blamed_in(&self, model: &Model, said: Diagnostic) -> Diagnostic {
        let message = format!(
            "{}; the likely cause: {}, which beams of two nodes are unstable beyond ({})",
            said.message,
            self.words(model),
            self.code().0
        );
        let help = self.remedy(model);
        let help = said.help.map_or_else(|| help.clone(), |own| format!("{help}; else: {own}"));
        Diagnostic { message, help: Some(help), card: None, ..said }
    }
}

/// Where in a run an increment ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moment {
    /// Number of the step, from 1.
    step: usize,
    /// Its increment, from 1.
    increment: usize,
    /// [T]
    total_time: f64,
}

impl Moment {
    /// The end of a committed increment.
    pub fn of(target: &Target, total_time: f64) -> Self {
        Self { step: target.step, increment: target.increment, total_time }
    }

    /// In words that follow what was found.
    fn words(&self) -> String {
        let Self { step, increment, total_time } = self;
        format!("in step {step}, increment {increment}, at total time {total_time:.6}")
    }
}

/// Elements that the increments of a step have found, part of what a run goes on from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OverpulledBeams {
    /// That of the committed state.
    pub now: Option<Overpulled>,
    /// The worst of the step, and where in the run.
    worst: Option<(Overpulled, Moment)>,
    /// Whether it was said in the run that bending is doubtful, and that it is wrong.
    told: [bool; 2],
}

impl OverpulledBeams {
    /// Takes note of the worst element of a committed increment.
    pub fn take(&mut self, found: Option<Overpulled>, at: Moment) {
        self.now = found;
        let Some(found) = found else { return };
        if self.worst.is_none_or(|(known, _)| found.ratio() > known.ratio()) {
            self.worst = Some((found, at));
        }
    }

    /// What is to be said of what was found since it last was asked, each warning once in a run.
    pub fn take_warning(&mut self, model: &Model) -> Option<Diagnostic> {
        let (found, at) = self.worst.take()?;
        let is_known = std::mem::replace(&mut self.told[usize::from(found.is_wrong())], true);
        (!is_known).then(|| found.warning(model, &at.words()))
    }

    /// Whether its elements are such of the model, with numbers that a run can reach.
    pub fn fit(&self, model: &Model) -> bool {
        let worst = self.worst.map(|(found, _)| found);
        [self.now, worst].into_iter().flatten().all(|found| found.is_sound(model))
    }
}

/// N/K at which moments at a clamp are short by such a part.
fn pull(short: f64) -> f64 {
    1.0 - (1.0 - short) * (1.0 - short)
}

fn of_block<'a>(
    model: &'a Model,
    results: &'a BlockResults,
) -> impl Iterator<Item = Overpulled> + 'a {
    let block = model.blocks.get(results.block).filter(|block| block.kind.cell.nodes == 2);
    let section = block.and_then(|block| match &block.section {
        Section::Beam(section) => Some((block, section)),
        _ => None,
    });
    section.into_iter().flat_map(move |beams| {
        let width = beams.0.kind.all_values().max(1);
        let values = results.members.iter().zip(results.values.chunks_exact(width));
        let pulled = values.filter(|(_, values)| values[0] > 0.0 && !is_straight(values));
        pulled.filter_map(move |(&member, values)| {
            let ends = beams.0.elements.get(member).nodes;
            let length = distance(model, *ends.first()?, *ends.last()?);
            let all = (0..2).filter_map(|axis| {
                let [shear, whole] = [length, 0.0].map(|length| stiffness(beams, length, axis));
                let (tension, shear) = (values[0], shear?);
                let (block, added) = (results.block, tension * (1.0 / shear - 1.0 / whole?));
                let found = Overpulled { block, member, tension, shear, added, length };
                (added > pull(SHORT)).then_some(found)
            });
            all.max_by(|a, b| a.ratio().total_cmp(&b.ratio()))
        })
    })
}

/// Shear stiffness of an element of that length across an axis of its section [F], in the plane that of both; `None`:
/// beams that do not shear.
fn stiffness(
    (block, section): (&ElementBlock, &BeamSection),
    length: f64,
    axis: usize,
) -> Option<f64> {
    if block.kind.is_space_beam() {
        return section.space_stiffness(length, false).shear.get(axis).copied();
    }
    let sheared = block.kind.kinematics == Kinematics::Beam { sheared: true };
    sheared.then(|| section.stiffness(length, false).shear)
}

/// Whether next to nothing bends or shears: forces, behind them as many strains.
fn is_straight(values: &[f64]) -> bool {
    let (forces, strains) = values.split_at(values.len() / 2);
    let mut work = forces.iter().zip(strains).map(|(force, strain)| (force * strain).abs());
    let along = work.next().unwrap_or(0.0);
    work.sum::<f64>() <= STRAIGHT * along
}

fn distance(model: &Model, a: NodeIndex, b: NodeIndex) -> f64 {
    let [a, b] = [a, b].map(|node| model.nodes.position(node));
    (0..3).map(|axis| b[axis] - a[axis]).fold(0.0, f64::hypot)
}
