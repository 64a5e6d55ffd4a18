//! Noise, measured while a run goes on.
//!
//! ```text
//!   RF |  /\/\/\    roughness and reversals of driven reactions
//!      | /          contact changes, penetration/c0 and balance of every pair
//!      +--------> t
//! ```

use slideline_diag::{Code, Diagnostic, Span};
use slideline_measures::{NoiseSummary, PairNoise, ReactionNoise};
use slideline_model::{
    ContactPair, Dof, Driven, Formulation, Master, Model, NodeIndex, NormalLaw, Vocabulary,
};
use slideline_solve::observe::{Event, Frame, Observer, PairRow, Stop};
use std::collections::BTreeSet;
use std::ops::{ControlFlow, Range};

/// Roughness above which a driven reaction is called noisy [1].
const ROUGH: f64 = 0.01;
/// Penetration above which a softened law has been pressed too far, in c0 [1].
const DEEP: f64 = 3.0;
/// Depth beyond the mean over a slave face above which a face does not see what lies in it, in sizes of
/// the face [1]: edges and corners make 0.1 and more, round parts on coarse meshes up to 0.085 (measured).
const UNSEEN: f64 = 0.1;
/// The same while the pair is open, when nothing but a part that is hardly rounder than a face is long makes as much
/// [1]: l/24R at a radius R.
const UNSEEN_AND_OPEN: f64 = 0.02;
/// Forces of one pair that are left over, relative to their magnitudes [1]:
/// thousands of times what rounding leaves.
const UNBALANCED: f64 = 1e-9;

/// Watches a run and measures its noise: one row per pair and increment, a
/// few numbers kept for each.
#[derive(Clone, Debug, Default)]
pub struct Noise {
    curves: Vec<Curve>,
    pairs: Vec<Pair>,
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

#[derive(Clone, Debug)]
struct Pair {
    name: String,
    origin: Span,
    vocabulary: Vocabulary,
    clearance: Option<f64>,
    /// Whether contact is sampled at nodes that hand the force on; stations of
    /// integrated contact come and go without pressure.
    hands_over: bool,
    /// Whether its slaves stand on the side along which contact wanders.
    wanders: bool,
    /// Whether it was ever closed.
    touched: bool,
    changes: usize,
    penetration: f64,
    deepest: u64,
    /// Largest depth that faces do not see, with a node of the face and the increment.
    unseen: (f64, u64, usize),
    /// The same of increments in which the pair is open.
    unseen_and_open: (f64, u64, usize),
    /// The node that carries most in each increment, where one touches.
    carriers: Vec<Option<NodeIndex>>,
    /// Largest imbalance of forces and of moments, and its increment.
    imbalance: [(f64, usize); 2],
}

impl Noise {
    /// Ready to watch a run of the model.
    pub fn of(model: &Model) -> Self {
        let curves = model.driven().into_iter().map(|own| Curve::of(model, own)).collect();
        let pairs = model.contact_pairs.iter().map(Pair::new).collect();
        Self { curves, pairs, ..Self::default() }
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
            said.extend(pair.changing(noise, self.increments));
            said.extend(pair.pressed(noise));
            said.extend(pair.unbalanced());
            said.extend(pair.unseen());
        }
        said.extend(self.untouched());
        said
    }

    /// SL0614: not one pair of the model was ever closed.
    fn untouched(&self) -> Option<Diagnostic> {
        let first = self.pairs.first()?;
        if self.increments == 0 || self.pairs.iter().any(|pair| pair.touched) {
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

impl Pair {
    fn new(pair: &ContactPair) -> Self {
        let clearance = match pair.interaction.normal {
            NormalLaw::Exponential { clearance, .. }
            | NormalLaw::CalculixExponential { clearance, .. } => Some(clearance),
            _ => None,
        };
        Self {
            name: pair.name.clone(),
            origin: pair.origin,
            vocabulary: pair.vocabulary,
            clearance,
            hands_over: pair.formulation == Formulation::NodeToSurface,
            wanders: pair.formulation == Formulation::NodeToSurface
                && matches!(pair.master, Master::RigidSurface(_)),
            touched: false,
            changes: 0,
            penetration: 0.0,
            deepest: 0,
            unseen: (0.0, 0, 0),
            unseen_and_open: (0.0, 0, 0),
            carriers: Vec::new(),
            imbalance: [(0.0, 0); 2],
        }
    }

    /// Over how many slave nodes contact has moved in a range of increments.
    fn passed(&self, range: Range<usize>) -> usize {
        let seen = self.carriers.get(range).unwrap_or_default().iter().flatten();
        seen.collect::<BTreeSet<_>>().len()
    }

    fn follow(
        &mut self,
        model: &Model,
        row: &PairRow,
        carrier: Option<NodeIndex>,
        increment: usize,
    ) {
        self.touched |= row.closed > 0;
        self.changes += row.changes;
        self.carriers.resize(increment.saturating_sub(1), None);
        self.carriers.push(carrier);
        if row.penetration > self.penetration {
            self.penetration = row.penetration;
            self.deepest = row.deepest.map_or(0, |node| model.nodes.label(node));
        }
        let node = row.unseen.map_or(0, |node| model.nodes.label(node));
        for (is_told, deepest) in
            [(true, &mut self.unseen), (row.closed == 0, &mut self.unseen_and_open)]
        {
            if is_told && row.unseen_depth > deepest.0 {
                *deepest = (row.unseen_depth, node, increment);
            }
        }
        let now = [row.force_imbalance, row.moment_imbalance];
        for (largest, now) in self.imbalance.iter_mut().zip(now) {
            if now > largest.0 || now.is_nan() {
                *largest = (now, increment);
            }
        }
    }

    fn noise(&self, increments: usize) -> PairNoise {
        PairNoise {
            name: self.name.clone(),
            changes: self.changes,
            changes_per_increment: self.changes as f64 / increments.max(1) as f64,
            penetration: self.penetration,
            penetration_over_c0: self.clearance.map(|c0| self.penetration / c0),
            force_imbalance: self.imbalance[0].0,
            moment_imbalance: self.imbalance[1].0,
        }
    }

    /// SL0611: contact moves to other points in nearly every increment.
    fn changing(&self, noise: &PairNoise, increments: usize) -> Option<Diagnostic> {
        let rate = noise.changes_per_increment;
        if !self.hands_over || rate <= 1.0 || increments < 5 {
            return None;
        }
        let message = format!(
            "contact of {} changed at {rate:.1} points per increment: the force moves from node \
             to node, and a friction onset other than IMMEDIATE would drop its friction",
            self.name
        );
        let help = if self.wanders {
            format!(
                "keep FRICTION ONSET=IMMEDIATE; for a smoother force put the slaves on the body \
                 on which the contact point does not move, or {}",
                self.vocabulary.integrate()
            )
        } else {
            "keep FRICTION ONSET=IMMEDIATE; shorter increments on *STATIC show the changes one by \
             one"
            .to_owned()
        };
        Some(Diagnostic::advice(Code("SL0611"), message).at(self.origin).help(help))
    }

    /// SL0612: a softened law pressed beyond what it was made for.
    fn pressed(&self, noise: &PairNoise) -> Option<Diagnostic> {
        let ratio = noise.penetration_over_c0.filter(|&ratio| ratio > DEEP)?;
        let message = format!(
            "node {} of {} penetrates by {:.3e}, {ratio:.1} times c0: the contact is softer than \
             intended",
            self.deepest, self.name, self.penetration
        );
        Some(Diagnostic::advice(Code("SL0612"), message).at(self.origin).help(format!(
            "raise p0 on {} to the order of the contact pressure",
            self.vocabulary.softened()
        )))
    }

    /// SL0615: an edge or a corner in the other side, which the mean over faces does not show.
    fn unseen(&self) -> Option<Diagnostic> {
        let is_open = self.unseen.0 <= UNSEEN;
        let ((depth, node, increment), held) = match is_open {
            false => (self.unseen, "contact forces there are too small"),
            true => (self.unseen_and_open, "the pair is open"),
        };
        if is_open && depth <= UNSEEN_AND_OPEN {
            return None;
        }
        let message = format!(
            "an edge or a corner goes through {}: in increment {increment} the slave face of node {node} and \
             the master stand in one another by {depth:.2} of the size of the face, and the mean gap over \
             the face does not show it; {held}",
            self.name
        );
        Some(Diagnostic::warning(Code("SL0615"), message).at(self.origin).help(
            "mesh the edge with elements no longer than the faces that it stands in: nodes of sharp edges are \
             held by themselves; against the edge of an analytical surface give the slave smaller faces, or \
             round the edge with FILLET RADIUS",
        ))
    }

    /// SL0613: forces on one side of the pair that the other does not feel.
    fn unbalanced(&self) -> Option<Diagnostic> {
        let [force, moment] = self.imbalance;
        let balances = |(left, _): (f64, usize)| left <= UNBALANCED; // not so for what is no number
        let (what, (left, increment)) = match (balances(force), balances(moment)) {
            (true, true) => return None,
            (false, _) => ("forces", force),
            (true, false) => ("moments", moment),
        };
        let message = format!(
            "the {what} that the two sides of {} exert on one another do not cancel: {left:.1e} \
             of their magnitude remains in increment {increment}",
            self.name
        );
        Some(Diagnostic::warning(Code("SL0613"), message).at(self.origin).help(
            "do not use this run: action and reaction must cancel to rounding; please report the \
             deck",
        ))
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

    fn pair() -> Pair {
        Pair {
            name: "IRS".into(),
            origin: Span::default(),
            clearance: Some(1e-5),
            vocabulary: Vocabulary::default(),
            hands_over: true,
            wanders: true,
            touched: false,
            changes: 0,
            penetration: 0.0,
            deepest: 0,
            unseen: (0.0, 0, 0),
            unseen_and_open: (0.0, 0, 0),
            carriers: Vec::new(),
            imbalance: [(0.0, 0); 2],
        }
    }

    /// Requirement: a pair out of balance is found, wherever in the run, and
    /// told with its increment; rounding is not.
    #[test]
    fn a_pair_out_of_balance_is_found() {
        let model = Model::default();
        let mut pair = pair();
        for increment in 1..=20 {
            let row =
                PairRow { force_imbalance: 1e-15, moment_imbalance: 3e-13, ..PairRow::default() };
            pair.follow(&model, &row, None, increment);
        }
        assert_eq!(pair.unbalanced(), None);
        let row = PairRow { moment_imbalance: 1e-5, ..PairRow::default() };
        pair.follow(&model, &row, None, 21);
        let said = pair.unbalanced().map(|said| (said.code, said.message));
        let (code, message) = said.unwrap_or((Code(""), String::new()));
        assert_eq!(code, Code("SL0613"));
        assert!(message.contains("moments") && message.contains("increment 21"), "{message}");
        let row = PairRow { force_imbalance: f64::NAN, ..PairRow::default() };
        pair.follow(&model, &row, None, 22);
        assert!(pair.unbalanced().is_some_and(|said| said.message.contains("forces")));
    }

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
        let mut passed = pair();
        passed.carriers = (0..40).map(Some).collect();
        let noise = noisy.noise(&[passed.clone()]);
        let expected = 4.0 * 0.01 / 6f64.sqrt() / 1.02;
        assert!((noise.roughness.unwrap_or(0.0) / expected - 1.0).abs() < 1e-12);
        assert_eq!(noise.reversals, 38);
        assert!(noisy.noisy(&noise).is_some_and(|said| said.message.contains("9999")));
        let wave = curve((0..40).map(|k| (0.3 * f64::from(k)).sin()).collect());
        assert_eq!(wave.noisy(&wave.noise(&[passed])), None);
    }

    /// Requirement: a run in which no pair was ever closed is told so, one in which one was is not, nor is one
    /// without pairs or without increments.
    #[test]
    fn what_never_touches_is_said() {
        let model = Model::default();
        let said = |noise: &Noise| {
            noise.findings(&noise.summary()).iter().any(|own| own.code.0 == "SL0614")
        };
        let mut noise = Noise { pairs: vec![pair(), pair()], ..Noise::default() };
        assert!(!said(&noise), "before the run");
        noise.increments = 3;
        assert!(said(&noise));
        noise.pairs[1].follow(&model, &PairRow { closed: 1, ..PairRow::default() }, None, 1);
        noise.pairs[1].follow(&model, &PairRow::default(), None, 2);
        assert!(!said(&noise));
        assert!(!said(&Noise { increments: 3, ..Noise::default() }));
    }

    /// Requirement: the deepest place that faces do not see is told with its increment, and what the
    /// coarse mesh of a round part makes is not.
    #[test]
    fn what_faces_do_not_see_is_told() {
        let model = Model::default();
        let mut pair = pair();
        let row = |unseen_depth| PairRow { unseen_depth, closed: 1, ..PairRow::default() };
        pair.follow(&model, &row(0.085), None, 1);
        assert_eq!(pair.unseen(), None);
        pair.follow(&model, &row(0.4), None, 2);
        pair.follow(&model, &row(0.2), None, 3);
        let said = pair.unseen().unwrap();
        assert_eq!(said.code, Code("SL0615"));
        let text = &said.message;
        assert!(text.contains("increment 2") && text.contains("0.40"), "{text}");
    }

    /// Requirement: parts that stand in one another while their pair is open are told of long before.
    #[test]
    fn a_corner_in_faces_that_are_open_is_told() {
        let model = Model::default();
        let mut pair = pair();
        let row = |unseen_depth, closed| PairRow { unseen_depth, closed, ..PairRow::default() };
        pair.follow(&model, &row(0.015, 0), None, 1);
        pair.follow(&model, &row(0.06, 1), None, 2);
        assert_eq!(pair.unseen(), None);
        pair.follow(&model, &row(0.047, 0), None, 3);
        let text = pair.unseen().unwrap().message;
        assert!(text.contains("increment 3") && text.contains("is open"), "{text}");
    }

    #[test]
    fn penetration_is_held_against_c0() {
        let model = Model::default();
        let mut pair = pair();
        let row = PairRow { penetration: 2.9e-5, changes: 2, ..PairRow::default() };
        pair.follow(&model, &row, None, 1);
        assert_eq!(pair.pressed(&pair.noise(1)), None);
        let row = PairRow { penetration: 4e-5, ..PairRow::default() };
        pair.follow(&model, &row, None, 2);
        let noise = pair.noise(2);
        assert_eq!(noise.changes_per_increment, 1.0);
        assert_eq!(noise.penetration_over_c0, Some(4e-5 / 1e-5));
        assert!(pair.pressed(&noise).is_some());
    }
}
