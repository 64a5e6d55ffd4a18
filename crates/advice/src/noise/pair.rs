//! What one pair does over a run, and what that asks to be said.

use super::facets::Facets;
use super::unseen::{Deep, Unseen};
use slideline_diag::{Code, Diagnostic, Span};
use slideline_measures::PairNoise;
use slideline_model::{ContactPair, Formulation, Master, Model, NodeIndex, NormalLaw, Vocabulary};
use slideline_solve::observe::PairRow;
use std::collections::BTreeSet;
use std::ops::Range;

/// Penetration above which a softened law has been pressed too far, in c0 [1].
const DEEP: f64 = 3.0;
/// Forces of one pair that are left over, relative to their magnitudes [1]:
/// thousands of times what rounding leaves.
const UNBALANCED: f64 = 1e-9;

/// How far the master may fall away within a slave face, over the way by which the parts have come together [1]:
/// below, forces in the plane are off by a few hundredths, by a sixth at times; middle nodes of quadratic elements by a
/// third, and bricks under round bodies by up to a half (measured).
const FALLS: f64 = 0.4;

/// What smoothing may take off the corners of a master, over the same way [1]: forces are off by about that.
const SMOOTHED: f64 = 0.1;

/// Part of the force of a pair that straight faces in the place of rounds may make [1].
const FACETS: f64 = 0.05;

/// A pair where it presses most, whichever way its forces point.
#[derive(Clone, Copy, Debug, Default)]
struct Pressed {
    /// Sum of the forces of pressure [F].
    force: f64,
    /// How much deeper straight faces stand in one another than the rounds that they are drawn for [L].
    deeper: f64,
    /// The way by which the parts have come together [L].
    approach: f64,
    increment: usize,
}

/// A pair where its resultant is largest.
#[derive(Clone, Copy, Debug, Default)]
struct Largest {
    force: f64,
    falls_away: f64,
    smoothed_away: f64,
    approach: f64,
    increment: usize,
}

#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub name: String,
    pub origin: Span,
    vocabulary: Vocabulary,
    clearance: Option<f64>,
    /// Whether contact is sampled at nodes that hand the force on; stations of
    /// integrated contact come and go without pressure.
    hands_over: bool,
    /// Whether its slaves stand on the side along which contact wanders.
    wanders: bool,
    /// Whether it was ever closed.
    pub touched: bool,
    changes: usize,
    penetration: f64,
    deepest: u64,
    /// What its faces do not see.
    pub unseen: Unseen,
    /// Where it carries most.
    largest: Largest,
    /// Where it presses most.
    pressed_most: Pressed,
    /// Of rounds in one another that are drawn with straight faces.
    facets: Option<Facets>,
    /// The node that carries most in each increment, where one touches.
    pub carriers: Vec<Option<NodeIndex>>,
    /// Largest imbalance of forces and of moments, and its increment.
    imbalance: [(f64, usize); 2],
}

impl Pair {
    pub fn new(model: &Model, pair: &ContactPair) -> Self {
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
            unseen: Unseen::of(model, pair),
            largest: Largest::default(),
            pressed_most: Pressed::default(),
            facets: Facets::of(model, pair),
            carriers: Vec::new(),
            imbalance: [(0.0, 0); 2],
        }
    }

    /// Over how many slave nodes contact has moved in a range of increments.
    pub fn passed(&self, range: Range<usize>) -> usize {
        let seen = self.carriers.get(range).unwrap_or_default().iter().flatten();
        seen.collect::<BTreeSet<_>>().len()
    }

    pub fn follow(
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
        let force = row.force.iter().map(|own| own * own).sum::<f64>().sqrt();
        let carries_most = force > self.largest.force;
        if carries_most {
            let PairRow { falls_away, smoothed_away, approach, .. } = *row;
            self.largest = Largest { force, falls_away, smoothed_away, approach, increment };
        }
        self.unseen.follow(model, row, increment, [self.touched, carries_most]);
        let now = [row.force_imbalance, row.moment_imbalance];
        for (largest, now) in self.imbalance.iter_mut().zip(now) {
            if now > largest.0 || now.is_nan() {
                *largest = (now, increment);
            }
        }
    }

    /// How much deeper straight faces stand in one another about a slave node than the rounds that they are drawn for [L].
    pub fn deeper(&self, node: NodeIndex) -> f64 {
        self.facets.as_ref().map_or(0.0, |own| own.deeper(node))
    }

    /// Takes in what presses on its slave nodes, the sum of the forces and that of these by how much deeper faces stand
    /// there [F, F L], with the energy of the model [F L].
    pub fn press(&mut self, (force, work): (f64, f64), energy: f64, increment: usize) {
        if force > self.pressed_most.force {
            let approach = 2.0 * energy.max(0.0) / force;
            self.pressed_most = Pressed { force, deeper: work / force, approach, increment };
        }
    }

    /// The way by which the parts have come together where the pair carries most [L]. Forces of a ring make up for one
    /// another; those of pressure are not known of increments before a saved state.
    fn approach(&self) -> Option<f64> {
        let both = [self.largest.approach, self.pressed_most.approach];
        both.into_iter().filter(|own| *own > 0.0).reduce(f64::min)
    }

    pub fn noise(&self, increments: usize) -> PairNoise {
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

    /// What its measures ask to be said.
    pub fn findings(&self, noise: &PairNoise, increments: usize) -> Vec<Diagnostic> {
        let said = [
            self.changing(noise, increments),
            self.pressed(noise),
            self.unbalanced(),
            self.unseen(),
            self.too_wide(),
            self.smoothed(),
            self.straight(),
        ];
        said.into_iter().flatten().collect()
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

    /// SL0615: an edge, a corner or a round in the other side, which the mean over faces does not show.
    pub fn unseen(&self) -> Option<Diagnostic> {
        let (Deep { depth, node, increment }, held) =
            self.unseen.told(self.touched, self.approach())?;
        let message = format!(
            "an edge, a corner or a round goes through {}: in increment {increment} the slave face of node {node} and \
             the master stand in one another by {depth:.2} of the size of the face, and the mean gap over \
             the face does not show it; {held}",
            self.name
        );
        Some(Diagnostic::warning(Code("SL0615"), message).at(self.origin).help(
            "mesh the edge with elements no longer than the faces that it stands in: nodes of sharp edges are \
             held by themselves; against a round and against the edge of an analytical surface give the slave \
             smaller faces, or round the edge with FILLET RADIUS",
        ))
    }

    /// SL0621: a master that falls away within a slave face by much of what the parts have come together.
    fn too_wide(&self) -> Option<Diagnostic> {
        let Largest { falls_away: falls, approach, increment, .. } = self.largest;
        if approach <= 0.0 || falls <= FALLS * approach {
            return None;
        }
        let message = format!(
            "slave faces of {} are wide for what they meet: where it carries most, in increment {increment}, its \
             master falls away by {falls:.3e} within a face, and the parts have come together by {approach:.3e}: \
             contact is at the nodes, and forces may be off by a tenth and more",
            self.name
        );
        Some(Diagnostic::warning(Code("SL0621"), message).at(self.origin).help(
            "make the slave elements where they meet shorter until the forces stay, or round the edge of the master",
        ))
    }

    /// SL0626: rounds in one another whose straight faces are not alike.
    fn straight(&self) -> Option<Diagnostic> {
        let Pressed { deeper, approach, increment, .. } = self.pressed_most;
        let of_rounds = approach - deeper;
        // nothing answers to an approach where nothing is elastic
        if approach <= 0.0 || deeper.abs() <= FACETS * of_rounds.abs() {
            return None;
        }
        let (sense, what) = if deeper > 0.0 {
            ("deeper in one another", "large")
        } else {
            ("less deep in one another", "small")
        };
        let effect = if of_rounds > 0.0 {
            format!(
                "what they press with for a given overlap is about {:.0} % too {what}",
                100.0 * deeper.abs() / of_rounds
            )
        } else {
            "there would be no force without them".to_owned()
        };
        let message = format!(
            "the rounds of {} have straight faces, longer on one side than on the other: where it carries most, in increment \
             {increment}, these stand {:.3e} {sense} than the rounds, and the parts have come together by {approach:.3e}: \
             {effect}",
            self.name,
            deeper.abs(),
        );
        Some(Diagnostic::warning(Code("SL0626"), message).at(self.origin).help(
            "divide both rounds into as many faces, make the elements shorter or give them middle nodes, or let contact be at \
             the nodes (NODE TO SURFACE), which draws the master round",
        ))
    }

    /// SL0622: smoothing that takes off a corner of the master much of what the parts have come together.
    fn smoothed(&self) -> Option<Diagnostic> {
        let Largest { smoothed_away: cut, approach, increment, .. } = self.largest;
        if approach <= 0.0 || cut <= SMOOTHED * approach {
            return None;
        }
        let message = format!(
            "smoothing moves the corners of the master of {} by {cut:.3e} where it carries most, in increment \
             {increment}, and the parts have come together by {approach:.3e}: it takes a fraction (SMOOTH) of each \
             segment, and these are long",
            self.name
        );
        Some(Diagnostic::warning(Code("SL0622"), message).at(self.origin).help(
            "leave SMOOTH out where the corner is one of the part (*SLIDE LINE: SMOOTH=0), or mesh the master with shorter \
             segments at the corner",
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

    /// One for tests.
    #[cfg(test)]
    pub fn example() -> Self {
        Self {
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
            unseen: Unseen::example(),
            largest: Largest::default(),
            pressed_most: Pressed::default(),
            facets: None,
            carriers: Vec::new(),
            imbalance: [(0.0, 0); 2],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a pair out of balance is found, wherever in the run, and
    /// told with its increment; rounding is not.
    #[test]
    fn a_pair_out_of_balance_is_found() {
        let model = Model::default();
        let mut pair = Pair::example();
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

    /// Requirement: faces that are wide for what they meet, and corners that are smoothed away, are told by what
    /// the pair is where it carries most; nothing is where there is no approach to hold them against.
    #[test]
    fn wide_faces_and_smoothed_corners_are_told_where_the_pair_carries_most() {
        let model = Model::default();
        let told = |rows: &[(f64, f64, f64, f64)]| {
            let mut pair = Pair::example();
            for (place, &(force, falls_away, smoothed_away, approach)) in rows.iter().enumerate() {
                let force = [0.0, force, 0.0];
                let row =
                    PairRow { force, falls_away, smoothed_away, approach, ..PairRow::default() };
                pair.follow(&model, &row, None, place + 1);
            }
            [pair.too_wide(), pair.smoothed()].map(|said| said.map(|own| own.code.0))
        };
        let first = (1.0, 0.1, 0.1, 0.01);
        assert_eq!(told(&[first]), [Some("SL0621"), Some("SL0622")]);
        assert_eq!(told(&[first, (2.0, 0.1, 0.02, 0.3)]), [None, None]);
        assert_eq!(told(&[first, (2.0, 0.1, 0.04, 0.3)]), [None, Some("SL0622")]);
        assert_eq!(told(&[(-2.0, 0.13, 0.0, 0.3), first]), [Some("SL0621"), None]);
        assert_eq!(told(&[(1.0, 9.0, 0.1, 0.0)]), [None, None]);
    }

    /// Requirement: the deepest place that faces do not see is told with its increment, and what the
    /// coarse mesh of a round part makes is not.
    #[test]
    fn what_faces_do_not_see_is_told() {
        let model = Model::default();
        let mut pair = Pair::example();
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

    /// Requirement: a corner that no node holds, in the other part while the pair is open, is told of long before; round
    /// parts are where the pair never closes, and not where it does later.
    #[test]
    fn a_corner_in_faces_that_are_open_is_told() {
        let model = Model::default();
        let mut pair = Pair::example();
        let row = |unseen_depth, closed| PairRow { unseen_depth, closed, ..PairRow::default() };
        pair.follow(&model, &row(0.015, 0), None, 1);
        pair.follow(&model, &row(0.06, 1), None, 2);
        assert_eq!(pair.unseen(), None);
        pair.follow(&model, &row(0.047, 0), None, 3);
        let text = pair.unseen().unwrap().message;
        assert!(text.contains("increment 3") && text.contains("is open"), "{text}");
        let mut round = Pair::example();
        round.unseen.has_corner = false;
        round.follow(&model, &row(0.047, 0), None, 1);
        let text = round.unseen().unwrap().message;
        assert!(text.contains("never closes"), "{text}");
        round.follow(&model, &row(0.05, 1), None, 2);
        assert_eq!(round.unseen(), None);
    }

    #[test]
    fn penetration_is_held_against_c0() {
        let model = Model::default();
        let mut pair = Pair::example();
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
