//! Causes that lie in the structure: motions without resistance, limits of
//! its strength, steps too long for a first guess.

use super::case::{Case, reason};
use crate::problem::Problem;
use crate::restraint::{Restraint, RigidMotion};
use crate::state::State;
use slideline_diag::{Code, Diagnostic, Place, Suggestion};
use slideline_linalg::SolveError;
use slideline_model::{Dof, Kinematics, NodeIndex};

const TRANSLATIONS: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];
const ROTATIONS: [Dof; 3] = [Dof::UR1, Dof::UR2, Dof::UR3];

/// A motion that meets no resistance, as a rigid one.
struct Motion {
    /// The node that moves most.
    node: NodeIndex,
    /// Its motion [1].
    way: [f64; 3],
    /// Its turn about the axes, per size of the motion [1/L].
    turn: [f64; 3],
}

impl Case<'_> {
    /// Something can move without resistance: the tangent is singular, or iterations get nowhere and
    /// supports leave a motion to a body that nothing else holds.
    pub(super) fn unheld(&self) -> Option<Diagnostic> {
        let motion = match self.outcome.fault {
            Some(SolveError::Singular { equation, .. }) => self.motion_at(equation)?,
            Some(_) => return None,
            None => self.motion_left_by_supports()?,
        };
        let label = self.label(motion.node);
        let message = format!(
            "the body of node {label} is unsupported {}: it can {} without any resistance{}{}",
            self.beyond(),
            self.way(&motion),
            self.distance(&motion),
            match crate::stabilise::settings(self.plan, self.committed) {
                Some(_) => "; contact stabilisation held it until it had faded",
                None => "",
            }
        );
        let dof = motion.dof(self.plan);
        let said = Diagnostic::error(Code("SL0503"), message)
            .at(self.plan.model.nodes.get(motion.node).origin)
            .help(format!(
                "support it with *BOUNDARY: node {label}, degree of freedom {dof}; or attach a \
                 weak *SPRING until contact supports it"
            ));
        Some(self.with_support(said, &motion))
    }

    /// Parts of a body that supports hold move without resistance before anything has happened: the
    /// first tangent of a run is that of the unloaded structure, which no limit of strength and no
    /// load has softened.
    pub(super) fn mechanism(&self) -> Option<Diagnostic> {
        let Some(SolveError::Singular { equation, .. }) = self.outcome.fault else { return None };
        if self.committed.total_time > 0.0 || self.outcome.last.is_some() {
            return None;
        }
        let motion = self.motion(equation)?;
        let (label, dof) = (self.label(motion.node), motion.dof(self.plan));
        let message = format!(
            "supports hold the body of node {label}, but not all of its parts: node {label} can {} \
             without any resistance {}",
            self.way(&motion),
            self.beyond(),
        );
        let help = format!(
            "{}support it with *BOUNDARY: node {label}, degree of freedom {dof}",
            self.remedies(motion.node)
        );
        let said = Diagnostic::error(Code("SL0503"), message);
        let said = said.at(self.plan.model.nodes.get(motion.node).origin).help(help);
        Some(self.with_support(said, &motion))
    }

    /// The diagnosis with the card that holds the node that moves.
    fn with_support(&self, said: Diagnostic, motion: &Motion) -> Diagnostic {
        let (label, dof) = (self.label(motion.node), motion.dof(self.plan));
        match self.plan.step.procedure.origin {
            Some(origin) => {
                said.card(Place::After(origin), format!("*BOUNDARY\n{label}, {dof}, {dof}\n"))
            }
            None => said,
        }
    }

    /// What may stiffen the elements about a node, by what they lack; ends as a list goes on.
    fn remedies(&self, node: NodeIndex) -> String {
        let elements = self.plan.step.presence.elements(&self.plan.model.blocks);
        let about = elements.filter(|(_, element)| element.nodes.contains(&node));
        let mut said: Vec<String> = Vec::new();
        for (block, _) in about {
            let name = block.kind.name();
            let words = match block.kind.kinematics {
                // the wedge has two points on its axis, about which its ends turn freely
                Kinematics::Solid { .. } => match name.strip_suffix('R').or(wedge(name)) {
                    Some(full) => format!(
                        "few elements {name} have motions without energy: take {full}, or more \
                         elements over the thickness; or "
                    ),
                    None => continue,
                },
                Kinematics::Truss | Kinematics::Spring | Kinematics::Gap => format!(
                    "{name} resists along its line alone: join its ends across it, or take beams; or "
                ),
                Kinematics::SpaceBeam => format!(
                    "the ends of {name} turn freely unless something holds their rotations: "
                ),
                Kinematics::Beam { .. } | Kinematics::Other => continue,
            };
            if !said.contains(&words) {
                said.push(words);
            }
        }
        said.concat()
    }

    /// The motion of a singular tangent; `None`: supports hold the body.
    fn motion_at(&self, equation: usize) -> Option<Motion> {
        let (node, _) = self.plan.dofs.name(*self.plan.constraints.dof_of_equation.get(equation)?);
        let motion =
            self.motion(equation).unwrap_or(Motion { node, way: [0.0; 3], turn: [0.0, 0.0, 1.0] });
        // what supports hold does not move: a limit of the structure
        let held = Restraint::of(self.plan.model, self.plan.step).holds(motion.node);
        (!held).then_some(motion)
    }

    /// The motion that supports leave to a body where neither contact nor springs nor equations may
    /// hold it: loads that follow it give it a stiffness, and its tangent is not singular.
    fn motion_left_by_supports(&self) -> Option<Motion> {
        let model = self.plan.model;
        let springs = model.blocks.iter().any(|block| block.springs().is_some());
        let others = springs || !model.contact_pairs.is_empty();
        if others || !model.linear_constraints.is_empty() || self.committed.total_time > 0.0 {
            return None;
        }
        let RigidMotion { node, way, turn } = Restraint::of(model, self.plan.step).left(model)?;
        Some(Motion { node, way, turn })
    }

    fn way(&self, motion: &Motion) -> String {
        let (plan, way, turn) = (self.plan, motion.way, motion.turn);
        let in_space = plan.dofs.kinds().contains(&Dof::U3);
        if !motion.turns(plan.reach) {
            let [u, v, w] = way;
            return match in_space {
                true => format!("move along ({u:.3}, {v:.3}, {w:.3})"),
                false => format!("move along ({u:.3}, {v:.3})"),
            };
        }
        // the place that stays: x + omega x u / omega^2
        let square: f64 = turn.iter().map(|w| w * w).sum();
        let from = plan.model.nodes.position(motion.node);
        let moved = plan.dofs.translation(&self.work.u, motion.node);
        let [x, y, z] = std::array::from_fn(|axis| {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            from[axis] + moved[axis] + (turn[next] * way[last] - turn[last] * way[next]) / square
        });
        match in_space {
            true => {
                let [a, b, c] = turn.map(|w| w / square.sqrt());
                format!("turn about ({x:.4e}, {y:.4e}, {z:.4e}) along ({a:.3}, {b:.3}, {c:.3})")
            }
            false => format!("turn about ({x:.4e}, {y:.4e})"),
        }
    }

    /// How far the contact is that the motion would close or open.
    fn distance(&self, motion: &Motion) -> String {
        let carrier = |node| self.plan.constraints.carrier(node);
        let points = self.plan.contact.points.iter().zip(&self.work.evaluation.points);
        let own = points.filter(|(point, now)| {
            carrier(point.node) == carrier(motion.node) && now.opening.is_finite()
        });
        let nearest = own.min_by(|a, b| a.1.opening.total_cmp(&b.1.opening));
        match nearest {
            Some((point, now)) if !now.closed && now.opening > 0.0 => format!(
                "; its contact at node {} is still open by {:.3e}",
                self.label(point.node),
                now.opening
            ),
            _ => String::new(),
        }
    }

    /// The motion that the tangent resists least: a vector of the null space,
    /// by inverse iteration.
    fn motion(&self, equation: usize) -> Option<Motion> {
        let mode = self.work.null_mode(self.plan, equation)?;
        let reach = self.plan.reach.max(f64::MIN_POSITIVE);
        let at = |node: NodeIndex, dof: Dof| {
            let (plan, mut moved) = (self.plan, 0.0);
            let Some(dof) = plan.dofs.find(node, dof) else { return 0.0 };
            let turned = plan.dofs.place_of_turned(node).is_some();
            if turned || plan.constraints.equation(dof).is_some() {
                let add = &mut |equation: usize, a: f64| moved += a * mode[equation];
                plan.constraints.for_each_equation(&self.work.evaluation.rows, dof, add);
            }
            moved
        };
        // a turn counts where nothing moves with it
        let size = |node: NodeIndex| {
            let length = |dofs: [Dof; 3]| {
                dofs.map(|dof| at(node, dof)).iter().fold(0.0, |a: f64, b| a.hypot(*b))
            };
            length(TRANSLATIONS) + 1e-6 * length(ROTATIONS) * reach
        };
        let node = (0..self.plan.model.nodes.len()).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        let largest = size(node);
        let [way, turn] =
            [TRANSLATIONS, ROTATIONS].map(|dofs| dofs.map(|dof| at(node, dof) / largest));
        Some(Motion { node, way, turn }).filter(|_| largest > 0.0)
    }

    /// A structure that gives way under a load: its stiffness is no longer
    /// positive, and no nearby state carries more.
    pub(super) fn snap_through(&self) -> Option<Diagnostic> {
        let (plan, directions) = (self.plan, self.work.negative_pivots);
        let load = plan.step.loads.iter().max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))?;
        if directions == 0 || load.value == 0.0 {
            return None;
        }
        let (label, dof) = (self.label(load.node), load.dof);
        let own = plan.dofs.named(load.node, dof);
        let moved = own.map_or(0.0, |own| self.committed.displacement[own]);
        let message = format!(
            "the structure snaps through {}: under the load at node {label}, {} it is unstable in \
             {} direction{}, after a displacement of {moved:.4e}",
            self.beyond(),
            dof.name(),
            directions,
            if directions == 1 { "" } else { "s" }
        );
        let help = format!(
            "the results up to that time are kept; prescribe the motion instead of the load: \
             *BOUNDARY with node {label}, degree of freedom {} in place of *CLOAD, for instance \
             to {:.4e}",
            dof.number(),
            2.0 * moved
        );
        let said = Diagnostic::error(Code("SL0511"), message).at(load.origin).help(help);
        Some(match self.motion_for_load() {
            Some(own) => said.card(own.place, own.text),
            None => said,
        })
    }

    /// The card that prescribes twice the motion so far of the node of the only load in its place;
    /// `None`: there are several loads.
    pub(super) fn motion_for_load(&self) -> Option<Suggestion> {
        let [load] = &self.plan.step.loads[..] else { return None };
        let own = self.plan.dofs.named(load.node, load.dof);
        let moved = own.map_or(0.0, |own| self.committed.displacement[own]);
        let (label, number) = (self.label(load.node), load.dof.number());
        let text = format!("*BOUNDARY\n{label}, {number}, {number}, {:.6E}\n", 2.0 * moved);
        Some(Suggestion { place: Place::Instead(load.origin), text })
    }
}

/// What is as a wedge with two points of integration, without its free motion.
fn wedge(name: &str) -> Option<&'static str> {
    (name == "C3D6").then_some("C3D15")
}

impl Motion {
    fn turns(&self, reach: f64) -> bool {
        self.turn.iter().any(|turn| turn.abs() * reach > 1e-6)
    }

    /// Number of the degree of freedom that would stop it: a rotation where its node has one.
    fn dof(&self, plan: &Problem<'_>) -> usize {
        let largest = |parts: [f64; 3]| {
            (0..3).max_by(|&a, &b| parts[a].abs().total_cmp(&parts[b].abs())).unwrap_or(0)
        };
        let turn = ROTATIONS[largest(self.turn)];
        match self.turns(plan.reach) && plan.dofs.find(self.node, turn).is_some() {
            true => turn.number(),
            false => TRANSLATIONS[largest(self.way)].number(),
        }
    }
}

/// One fixed increment that is too large, as walking it in shorter ones has
/// shown: `needed` is the shortest of them [T].
pub fn step_too_large(
    plan: &Problem<'_>,
    committed: &State,
    why: &crate::newton::Outcome,
    needed: f64,
) -> Diagnostic {
    let procedure = &plan.step.procedure;
    let message = format!(
        "the fixed increment of {:.4e} beyond total time {:.6} is too large: {}; increments of \
         {needed:.3e} lead to its end",
        procedure.initial,
        committed.total_time,
        reason(plan, why)
    );
    let card = format!(
        "*STATIC\n{needed:.6E}, {:?}, {:.6E}, {:?}\n",
        procedure.period,
        1e-5 * needed.min(procedure.period),
        procedure.initial
    );
    let said = Diagnostic::error(Code("SL0512"), message)
        .at(procedure.origin.unwrap_or(plan.step.origin))
        .help(format!(
            "the results up to that time are kept; leave out DIRECT and begin with *STATIC and an \
             increment of {needed:.3e}"
        ));
    match procedure.origin {
        Some(origin) => said.card(Place::Instead(origin), card),
        None => said,
    }
}
