//! Noise, measured while a run goes on.
//!
//! ```text
//!   RF |  /\/\/\    roughness and reversals of driven reactions
//!      | /          contact changes, penetration/c0 and balance of every pair
//!      +--------> t
//! ```

mod facets;
mod pair;
mod unseen;

use crate::quadratic;
use pair::Pair;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_measures::{NoiseSummary, ReactionNoise};
use slideline_model::{Dof, Driven, Model, NodeIndex, Vocabulary};
use slideline_solve::observe::{Event, Frame, Observer, PairRow, Stop};
use std::ops::{ControlFlow, Range};

/// Roughness above which a driven reaction is called noisy [1].
const ROUGH: f64 = 0.01;
/// Watches a run and measures its noise: one row per pair and increment, a
/// few numbers kept for each.
#[derive(Clone, Debug, Default)]
pub struct Noise {
    curves: Vec<Curve>,
    pairs: Vec<Pair>,
    /// What is told of a pair that meets itself once it has: its place, SL0423.
    of_own: Vec<(usize, Diagnostic)>,
    increments: usize,
}

#[derive(Clone, Debug)]
struct Curve {
    nodes: Vec<NodeIndex>,
    name: String,
    dof: Dof,
    origin: Span,
    vocabulary: Vocabulary,
    motion: Vec<f64>,
    reaction: Vec<f64>,
}

impl Noise {
    /// Ready to watch a run of the model.
    pub fn of(model: &Model) -> Self {
        let curves = model.driven().into_iter().map(|own| Curve::of(model, own)).collect();
        let pairs = model.contact_pairs.iter().map(|pair| Pair::new(model, pair)).collect();
        let own = model.contact_pairs.iter().enumerate().filter(|(_, pair)| pair.meets_itself());
        let of_own = own.filter_map(|(place, pair)| Some((place, quadratic::say(pair)?))).collect();
        Self { curves, pairs, of_own, ..Self::default() }
    }

    /// Takes in what a run that goes on from a saved state has told before:
    /// the motion and reaction of a driven dof along the axes of its node, and
    /// the rows of the pairs with the nodes that carried most, increment by
    /// increment.
    pub fn recall(
        &mut self,
        model: &Model,
        mut curve: impl FnMut(NodeIndex, Dof) -> Option<[Vec<f64>; 2]>,
        pairs: &[Vec<PairRow>],
        carriers: &[Vec<Option<NodeIndex>>],
    ) {
        let mut longest = pairs.len();
        for own in &mut self.curves {
            let all = own.nodes.iter().map(|&node| curve(node, own.dof));
            let Some(all) = all.collect::<Option<Vec<_>>>() else { continue };
            let Some([motion, first]) = all.first() else { continue };
            let sum = |place| all.iter().filter_map(|[_, own]| own.get::<usize>(place)).sum();
            own.motion.extend(motion);
            own.reaction.extend((0..first.len()).map(|place| -> f64 { sum(place) }));
            longest = longest.max(first.len());
        }
        for (place, rows) in pairs.iter().enumerate() {
            for (number, (pair, row)) in self.pairs.iter_mut().zip(rows).enumerate() {
                let carrier =
                    carriers.get(place).and_then(|all| all.get(number).copied().flatten());
                pair.follow(model, row, carrier, place + 1);
            }
        }
        self.increments += longest;
    }

    /// The measures so far.
    pub fn summary(&self) -> NoiseSummary {
        NoiseSummary {
            increments: self.increments,
            reactions: self.curves.iter().map(|curve| curve.noise(&self.pairs)).collect(),
            pairs: self.pairs.iter().map(|pair| pair.noise(self.increments)).collect(),
        }
    }

    /// What the measures ask to be said.
    pub fn findings(&self, summary: &NoiseSummary) -> Vec<Diagnostic> {
        let curves = self.curves.iter().zip(&summary.reactions);
        let mut said: Vec<Diagnostic> =
            curves.filter_map(|(curve, noise)| curve.noisy(noise)).collect();
        for (pair, noise) in self.pairs.iter().zip(&summary.pairs) {
            said.extend(pair.findings(noise, self.increments));
        }
        let of_own = self.of_own.iter().filter(|(place, _)| self.pairs[*place].touched);
        said.extend(of_own.map(|(_, own)| own.clone()));
        said.extend(self.untouched());
        said
    }

    /// SL0614: not one pair of the model was ever closed, and none should have been (SL0615).
    fn untouched(&self) -> Option<Diagnostic> {
        let first = self.pairs.first()?;
        let meets = |pair: &Pair| pair.touched || pair.unseen().is_some();
        if self.increments == 0 || self.pairs.iter().any(meets) {
            return None;
        }
        let message = match self.pairs.len() {
            1 => format!("nothing touched: {} was never closed in this run", first.name),
            many => format!(
                "nothing touched: none of the {many} contact pairs was ever closed in this run"
            ),
        };
        let help = "look where the parts are (`slideline check`), at the way and the direction of the motion, and \
                    at the side that each surface shows to the other";
        Some(Diagnostic::advice(Code("SL0614"), message).at(first.origin).help(help))
    }

    /// Takes note of an event that others watch as well.
    pub fn watch(&mut self, event: &Event<'_>) {
        if let Event::Committed(frame) = event {
            self.follow(frame);
        }
    }

    fn follow(&mut self, frame: &Frame<'_>) {
        self.increments += 1;
        for curve in &mut self.curves {
            let mut sum = 0.0;
            for (place, &node) in curve.nodes.iter().enumerate() {
                let [moved, reaction, _] = frame.nodal.named(node, curve.dof);
                if place == 0 {
                    curve.motion.push(moved);
                }
                sum += reaction;
            }
            curve.reaction.push(sum);
        }
        let carriers = carriers(frame, self.pairs.len());
        for ((pair, row), carrier) in self.pairs.iter_mut().zip(frame.pairs).zip(carriers) {
            pair.follow(frame.model, row, carrier, self.increments);
        }
        let energy = frame.energy.of_the_model();
        let mut pressed = vec![(0.0, 0.0); self.pairs.len()];
        for row in frame.contact {
            if let Some((pair, sums)) = self.pairs.get(row.pair).zip(pressed.get_mut(row.pair)) {
                let force = row.pressure * row.area;
                sums.0 += force;
                sums.1 += force * pair.deeper(row.node);
            }
        }
        for (pair, pressed) in self.pairs.iter_mut().zip(pressed) {
            pair.press(pressed, energy, self.increments);
        }
    }
}

/// The slave node of every pair that carries most.
fn carriers(frame: &Frame<'_>, count: usize) -> Vec<Option<NodeIndex>> {
    let mut found = vec![(0.0, None); count];
    for row in frame.contact {
        let force = row.pressure * row.area;
        if let Some(most) = found.get_mut(row.pair).filter(|most| force > most.0) {
            *most = (force, Some(row.node));
        }
    }
    found.into_iter().map(|(_, node)| node).collect()
}

impl Curve {
    fn of(model: &Model, driven: Driven) -> Self {
        Self {
            nodes: driven.nodes,
            name: driven.name,
            dof: driven.dof,
            origin: driven.origin,
            vocabulary: model.vocabulary(),
            motion: Vec::new(),
            reaction: Vec::new(),
        }
    }

    fn noise(&self, pairs: &[Pair]) -> ReactionNoise {
        let name = format!("{}.{}", self.name, self.dof.reaction_name());
        let passed = |range: Range<usize>| {
            pairs.iter().map(|pair| pair.passed(range.clone())).max().unwrap_or(0)
        };
        ReactionNoise::of(name, &self.reaction, &self.motion, passed)
    }

    /// SL0610: a driven reaction that the mesh makes rough, whichever
    /// differences are taken. A physical reversal is none of it.
    fn noisy(&self, noise: &ReactionNoise) -> Option<Diagnostic> {
        let of_mesh = noise.of_mesh.filter(|found| found.roughness > ROUGH)?;
        let message = format!(
            "the reaction {} of {} {} is noisy: roughness {:.1} % of its peak of {:.3e}, {} \
             reversals in {} increments",
            self.dof.reaction_name(),
            if self.nodes.len() == 1 { "node" } else { "nodes" },
            self.name,
            100.0 * of_mesh.roughness,
            noise.peak,
            of_mesh.reversals,
            self.reaction.len()
        );
        Some(Diagnostic::advice(Code("SL0610"), message).at(self.origin).help(format!(
            "{}, {}, or refine the side with the slaves",
            self.vocabulary.swap_roles(),
            self.vocabulary.integrate()
        )))
    }
}

impl Observer for Noise {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.watch(&event);
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::Node;

    /// Requirement: a history of known noise raises SL0610, the same amplitude
    /// as a smooth wave does not. Closed form: a zigzag of amplitude a over a
    /// peak p has roughness 4 a/sqrt(6)/p.
    #[test]
    fn a_noisy_curve_is_told_from_a_wavy_one() {
        let curve = |reaction: Vec<f64>| Curve {
            nodes: vec![0],
            name: "9999".into(),
            vocabulary: Vocabulary::default(),
            dof: Dof::U2,
            origin: Span::default(),
            motion: (1..=reaction.len()).map(|k| -(k as f64)).collect(),
            reaction,
        };
        let zigzag: Vec<f64> = (0..40).map(|k| -1.0 - 0.02 * f64::from(k % 2)).collect();
        let noisy = curve(zigzag);
        let mut passed = Pair::example();
        passed.carriers = (0..40).map(Some).collect();
        let noise = noisy.noise(&[passed.clone()]);
        let expected = 4.0 * 0.01 / 6f64.sqrt() / 1.02;
        assert!((noise.roughness.unwrap_or(0.0) / expected - 1.0).abs() < 1e-12);
        assert_eq!(noise.reversals, 38);
        assert!(noisy.noisy(&noise).is_some_and(|said| said.message.contains("9999")));
        let wave = curve((0..40).map(|k| (0.3 * f64::from(k)).sin()).collect());
        assert_eq!(wave.noisy(&wave.noise(&[passed])), None);
    }

    /// Requirement: a pair whose sides stood in one another by much of the way by which they come together before it closed
    /// is told (SL0615), one whose sides come together much further is not, nor one that opens again; where forces go
    /// round a ring and make up for one another their sizes tell that way.
    #[test]
    fn what_closes_late_is_said() {
        let mut model = Model::default();
        model.nodes.insert(Node { label: 7, position: [0.0; 3], origin: Span::default() });
        let said = |closes_first: bool, approach: f64, pressed: Option<f64>| {
            // a face of it is one long
            let mut pair = Pair::example();
            pair.unseen.has_corner = false;
            let open = PairRow { unseen_depth: 0.06, unseen: Some(0), ..PairRow::default() };
            let closed =
                PairRow { closed: 1, force: [1.0, 0.0, 0.0], approach, ..PairRow::default() };
            let rows = if closes_first { [&closed, &open] } else { [&open, &closed] };
            rows.into_iter().zip(1..).for_each(|(row, k)| pair.follow(&model, row, None, k));
            // twice the energy over the force is the way
            let energy = pressed.unwrap_or_default() / 2.0;
            pair.press((pressed.map_or(0.0, |_| 1.0), 0.0), energy, 2);
            pair.unseen().is_some()
        };
        assert!(said(false, 0.3, None) && !said(false, 3.0, None) && !said(true, 0.3, None));
        assert!(said(false, 300.0, Some(0.3)) && !said(false, 300.0, Some(3.0)));
    }

    /// Requirement: what stands in faces beyond their mean gap by much of the way by which the parts have come together,
    /// where the pair carries most, is told with what it takes off the force; one that is little of that way is not.
    #[test]
    fn what_takes_much_of_the_way_is_said() {
        let mut model = Model::default();
        model.nodes.insert(Node { label: 7, position: [0.0; 3], origin: Span::default() });
        let said = |rows: &[(f64, f64, f64)]| {
            let mut pair = Pair::example();
            for (k, &(force, unseen_depth, approach)) in rows.iter().enumerate() {
                let force = [0.0, force, 0.0];
                let of = PairRow { force, unseen_depth, approach, ..PairRow::default() };
                let row = PairRow { closed: 1, unseen: Some(0), ..of };
                pair.follow(&model, &row, None, k + 1);
            }
            pair.unseen().map(|said| said.message)
        };
        // a face of it is one long
        let told = said(&[(1.0, 0.06, 0.14)]).unwrap();
        assert!(told.contains("node 7") && told.contains("30 %"), "{told}");
        assert!(said(&[(1.0, 0.06, 0.3)]).is_none());
        assert!(said(&[(1.0, 0.06, 0.14), (2.0, 0.01, 0.3)]).is_none());
    }

    /// Requirement: a run in which no pair was ever closed is told so, one in which one was is not, nor is one
    /// without pairs or without increments.
    #[test]
    fn what_never_touches_is_said() {
        let model = Model::default();
        let said = |noise: &Noise| {
            noise.findings(&noise.summary()).iter().any(|own| own.code.0 == "SL0614")
        };
        let mut noise = Noise { pairs: vec![Pair::example(), Pair::example()], ..Noise::default() };
        assert!(!said(&noise), "before the run");
        noise.increments = 3;
        assert!(said(&noise));
        noise.pairs[1].follow(&model, &PairRow { closed: 1, ..PairRow::default() }, None, 1);
        noise.pairs[1].follow(&model, &PairRow::default(), None, 2);
        assert!(!said(&noise));
        assert!(!said(&Noise { increments: 3, ..Noise::default() }));
    }
}
