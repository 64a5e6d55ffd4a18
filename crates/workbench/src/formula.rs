//! The push-in force of the design guides for a cantilever snap-fit, beside what was solved.
//!
//! ```text
//!  |\
//!  |=============__        P = E b t^3 y/(4 L^3)
//!  |/       t      \_|     W = P (mu + tan a)/(1 - mu tan a)
//!   |<---- L ---->|
//! ```
//!
//! The rule takes a straight arm of constant section whose slope and axial force are left out, and a
//! hook that touches at its end alone. [Bayer MaterialScience, Snap-Fit Joints for Plastics, 2013;
//! BASF, Snap-Fit Design Manual, 2007; theory (11.7)]

use crate::plane::{distance, dot, minus};
use serde_json::{Value, json};
use slideline::Model;
use slideline::mech::section::Shape;
use slideline::model::{Dof, Friction, Master, NodeIndex, RigidSurface};
use slideline::output::profile;
use slideline::output::report::Told;
use slideline_theory::closed::incline::{lowering, raising};
use slideline_theory::closed::snap_fit::SnapFit;

/// Points of the curve for one way.
const POINTS: usize = 160;

/// A cantilever with a hook at its end, and a catch that is pushed along it.
struct Hook {
    arm: SnapFit,
    mu: f64,
    /// Along the arm from its support to the hook, and the way on which the hook yields.
    along: [f64; 2],
    aside: [f64; 2],
    /// The hook, along and aside.
    at: [f64; 2],
    /// Points of the catch, along and aside.
    catch: Vec<[f64; 2]>,
    /// Sign of the driven motion along the arm.
    sign: f64,
}

/// The formula where the deck is a cantilever with a hook; null where it is not.
pub(crate) fn formula(model: &Model, told: &Told) -> Value {
    let Some(hook) = Hook::of(model) else { return Value::Null };
    let ends = travel(model, hook.sign);
    let curve = hook.curve(&ends);
    let push = hook.push();
    let solved =
        told.summary.get("forces").and_then(|own| own.get(0)?.get("push_in")?.get("force"));
    let solved = solved.and_then(Value::as_f64);
    json!({
        "name": "Design-guide rule for a cantilever hook (Bayer, BASF)",
        "curve": curve,
        "value": push.map(|(force, ..)| force),
        "reason": push.map_or_else(jams, |found| hook.reason(found, solved)),
        "assumptions": [
            "the arm is straight, of one section, and clamped rigidly at its support",
            "its slope and the axial force in it are left out: P = E b t^3 y/(4 L^3)",
            "the hook touches with its end alone, and the catch is rigid",
            "friction is called in full: W = P (mu + tan a)/(1 - mu tan a)",
        ],
    })
}

fn jams() -> String {
    "by the rule the ramp is too steep for this friction: it cannot be pushed in".to_owned()
}

/// Values of the driven motion at the start and at the end of each step.
fn travel(model: &Model, sign: f64) -> Vec<f64> {
    let Some(own) = model.driven().into_iter().next() else { return Vec::new() };
    let node = own.nodes.first().copied();
    let ends = model.steps.iter().filter_map(|step| {
        let mut all = step.prescribed.iter();
        all.find(|one| Some(one.node) == node && one.dof == own.dof).map(|one| one.value)
    });
    std::iter::once(0.0).chain(ends).map(|value| sign * value).collect()
}

impl Hook {
    /// That of a model; `None`: it is none.
    fn of(model: &Model) -> Option<Self> {
        let [pair] = &model.contact_pairs[..] else { return None };
        let Master::RigidSurface(surface) = &pair.master else { return None };
        let mu = match &pair.interaction.friction {
            Friction::Frictionless => 0.0,
            Friction::Coulomb { coefficient, limit: None, decay: None, .. } => *coefficient,
            _ => return None,
        };
        let driven = model.driven().into_iter().next()?;
        let has_own_axes = driven.nodes.iter().any(|&node| model.axes_of(node).is_some());
        if driven.nodes != [surface.reference] || has_own_axes || model.is_in_space() {
            return None;
        }
        let mut beams = model.blocks.iter().filter_map(|block| block.beams());
        let block = beams.next().filter(|_| model.blocks.len() == 1)?;
        let Shape::Rectangle { width, height } = block.section.shape else { return None };
        let support = clamped(model)?;
        let at = |node: NodeIndex| {
            let [x, y, _] = model.nodes.position(node);
            [x, y]
        };
        let root = at(support);
        // the hook is the slave that is farthest from the support
        let far = |node: &NodeIndex| distance(root, at(*node));
        let members = || block.elements.iter().flat_map(|element| element.nodes);
        let tip = *members().max_by(|a, b| far(a).total_cmp(&far(b)))?;
        let slaves = pair.slave_nodes();
        slaves.contains(&tip).then_some(())?;
        let length = far(&tip);
        let along = [0, 1].map(|k| (at(tip)[k] - root[k]) / length);
        let normal = [-along[1], along[0]];
        let straight =
            |node: &NodeIndex| dot(normal, minus(at(*node), root)).abs() <= 1e-9 * length;
        members().all(straight).then_some(())?;
        let component = match driven.dof {
            Dof::U1 => along[0],
            Dof::U2 => along[1],
            _ => return None,
        };
        (component.abs() > 1.0 - 1e-9).then_some(())?;
        let arm =
            SnapFit { width, thickness: height, length, modulus: block.section.material.modulus };
        let aside = yields(surface, normal)?;
        let place = |point: [f64; 2]| [dot(along, point), dot(aside, point)];
        let catch = profile(surface).into_iter().map(place).collect();
        Some(Self { arm, mu, along, aside, at: place(at(tip)), catch, sign: component.signum() })
            .filter(|own| own.crest() > 0.0 && dot(own.along, own.aside).abs() < 1e-9)
    }

    /// How far the highest point of the catch bends the hook [L].
    fn crest(&self) -> f64 {
        self.catch.iter().fold(0.0, |most, point| f64::max(most, point[1] - self.at[1]))
    }

    /// Height of the catch over the hook [L] and its slope, where it has moved by `travel` along
    /// the arm.
    fn ramp(&self, travel: f64) -> (f64, f64) {
        let place = self.at[0] - travel;
        let sides = self.catch.windows(2).filter_map(|ends| {
            let [[a, low], [b, high]] = [ends[0], ends[1]];
            let inside = (a.min(b)..=a.max(b)).contains(&place) && a != b;
            let slope = (high - low) / (b - a);
            inside.then(|| (low + slope * (place - a) - self.at[1], slope))
        });
        let top = sides.max_by(|a, b| a.0.total_cmp(&b.0));
        top.filter(|(height, _)| *height > 0.0).unwrap_or((0.0, 0.0))
    }

    /// Force that moves the catch on [F], positive where it must be pushed on; `None`: it jams.
    fn force(&self, travel: f64, way: f64) -> Option<f64> {
        let (height, slope) = self.ramp(travel);
        let rise = -slope * way;
        let factor = match rise > 0.0 {
            true => raising(rise, self.mu).ok()?,
            false => lowering(-rise, self.mu),
        };
        Some(self.arm.deflection_force(height) * factor)
    }

    /// Largest force on the way in, with the deflection and the factor of the ramp there.
    fn push(&self) -> Option<(f64, f64, f64)> {
        let (first, last) = self.span();
        let mut most = (0.0, 0.0, 0.0);
        for number in 0..=4 * POINTS {
            let part = number as f64 / (4 * POINTS) as f64;
            let travel = first + part * (last - first);
            let force = self.force(travel, -1.0)?;
            if force > most.0 {
                let (height, _) = self.ramp(travel);
                most = (force, height, force / self.arm.deflection_force(height));
            }
        }
        Some(most)
    }

    /// Travel over which the catch is below the hook.
    fn span(&self) -> (f64, f64) {
        let places = self.catch.iter().map(|point| self.at[0] - point[0]);
        let ends = |ends: (f64, f64), own: f64| (ends.0.min(own), ends.1.max(own));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), ends);
        (high, low)
    }

    /// Travel and force as the curve of the driven motion has them; null where the rule jams.
    fn curve(&self, ends: &[f64]) -> Vec<[Option<f64>; 2]> {
        let mut curve = Vec::new();
        for way in ends.windows(2).filter(|way| way[0] != way[1]) {
            let sense = (way[1] - way[0]).signum();
            for number in 0..=POINTS {
                let travel = way[0] + (way[1] - way[0]) * number as f64 / POINTS as f64;
                let force = self.force(travel, sense).map(|own| self.sign * sense * own);
                curve.push([Some(self.sign * travel), force]);
            }
        }
        curve
    }

    /// Why what was solved is another force: a tip load W along the arm, at a deflection y, takes
    /// 6 W y/(5 L) from the transverse force. [theory (11.8)]
    fn reason(&self, (force, height, factor): (f64, f64, f64), solved: Option<f64>) -> String {
        let Some(solved) = solved.filter(|_| force > 0.0) else {
            return "there is no solved push-in force to compare it with".to_owned();
        };
        let off = 100.0 * (solved / force - 1.0);
        let axial = -100.0 * (1.0 - 1.0 / (1.0 + 1.2 * factor * height / self.arm.length));
        let slope = 1.5 * height / self.arm.length;
        let bent = slope.to_degrees();
        format!(
            "The solved push-in force is {} % off the rule. The rule leaves out that the push itself \
             bends the arm, at a lever of {} % of its length: about {} %. The rest is what else it \
             leaves out: the arm's end slopes by {} degrees, its shear, the rounded hook and the \
             softness of the contact.",
            signed(off),
            plain(100.0 * height / self.arm.length),
            signed(axial),
            plain(bent),
        )
    }
}

fn signed(value: f64) -> String {
    format!("{value:+.1}").replace('-', "\u{2212}")
}

fn plain(value: f64) -> String {
    format!("{value:.1}")
}

/// The node that is clamped, where there is only one.
fn clamped(model: &Model) -> Option<NodeIndex> {
    let step = model.steps.first()?;
    let held = |node: NodeIndex, dof: Dof| {
        step.prescribed.iter().any(|own| own.node == node && own.dof == dof && !own.moves())
    };
    let whole = |node: &NodeIndex| [Dof::U1, Dof::U2, Dof::UR3].iter().all(|dof| held(*node, *dof));
    let mut all: Vec<NodeIndex> =
        step.prescribed.iter().map(|own| own.node).filter(whole).collect();
    all.sort_unstable();
    all.dedup();
    match all[..] {
        [one] => Some(one),
        _ => None,
    }
}

/// The side of the arm's axis to which the outside of the catch looks at its crest.
fn yields(surface: &RigidSurface, normal: [f64; 2]) -> Option<[f64; 2]> {
    let points = profile(surface);
    [1.0, -1.0].into_iter().find_map(|sign| {
        let aside = normal.map(|own| sign * own);
        let height = |point: &[f64; 2]| dot(aside, *point);
        let most = points.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
        let sides = points.windows(2).filter(|ends| {
            let size = distance(ends[0], ends[1]);
            ends.iter().any(|end| most - height(end) <= 1e-9 * size)
        });
        // the outward normal stands 90 degrees counter-clockwise of travel
        let outside = sides.map(|ends| {
            let [x, y] = minus(ends[1], ends[0]);
            dot(aside, [-y, x])
        });
        (outside.sum::<f64>() > 0.0).then_some(aside)
    })
}
