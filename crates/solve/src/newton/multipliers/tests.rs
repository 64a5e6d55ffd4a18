//! Laws that are inserted: their tangent, and what moves their multipliers.

use super::*;
use crate::tangent::tests::{Prepared, model};
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::contact::tangential::Tangential;
use slideline_model::{Friction, Model, StickRule};

/// Differences of the unknowns [1]: their square is what truncation leaves, eps over them what
/// rounding does.
const STEP: f64 = 1e-6;

/// A way to enforce contact, with laws that it can enforce.
struct Way {
    enforcement: Enforcement,
    hard: bool,
}

const WAYS: [Way; 3] = [
    Way { enforcement: Enforcement::Penalty, hard: false },
    Way { enforcement: Enforcement::Augmented, hard: false },
    Way { enforcement: Enforcement::Augmented, hard: true },
];

impl Way {
    fn model(&self, line: bool) -> Model {
        let mut model = model(line, slideline_model::Offset::NONE);
        let interaction = &mut model.contact_pairs[0].interaction;
        if self.hard {
            interaction.normal = NormalLaw::Hard;
            let Friction::Coulomb { stick, .. } = &mut interaction.friction else { return model };
            *stick = StickRule::Lagrange;
        }
        model
    }
}

/// The committed state of a model, its points where they stand.
fn undeformed(plan: &Problem<'_>) -> State {
    let (dofs, points) = (plan.dofs.len(), plan.contact.points.len());
    let mut state = State::undeformed(dofs, points, (0, 0));
    let mut kinematics = plan.contact.nowhere();
    let positions = &mut crate::contact::MasterPositions::default();
    crate::commit::locate_points(plan.contact, None, &mut state, (positions, &mut kinematics));
    state
}

/// Room for a problem at a bent state, in which a body with its points is pressed down by `down`
/// and moved aside by `aside`; with multipliers of about the size of the pressures there.
fn work(
    prepared: &Prepared,
    (plan, committed): (&Problem<'_>, &State),
    (aside, down): (f64, f64),
) -> Scratch {
    let mut work = Scratch::default();
    let states = (&committed.displacement[..], &[][..], &committed.points[..]);
    let (values, symmetry) = ((&prepared.values, plan.contact), (plan.kind(), false));
    work.find_near(plan.contact, states);
    work.couple((&prepared.plan, 0), values, symmetry, &prepared.linear_systems);
    work.fit(plan);
    // stresses of the law: the tangent is that of the residual
    (work.line_search, work.dt) = (true, 1.0);
    let bent = |dof: usize| 0.02 * ((dof * 7919 % 13) as f64 / 6.0 - 1.0);
    work.u = (0..plan.dofs.len()).map(bent).collect();
    work.u[..3].fill(0.0);
    let body = plan.dofs.of_node(plan.model.nodes.find(100).unwrap());
    work.u[body].copy_from_slice(&[aside, down, 0.1 * aside]);
    plan.constraints.enforce(&[], &mut work.u);
    work.pressures.fill(0.5);
    work.tractions.fill(Tangential::along(0.05));
    work.hold_multipliers(plan);
    work.evaluate(plan, committed, 1.0);
    // The first tangent gives the multipliers their stiffness, the last is that of the trial. One
    // point alone need not hold the body: what is asked for is the matrix, not its factors.
    for _ in 0..2 {
        let _factored = work.factor(plan, committed);
        work.evaluate(plan, committed, 1.0);
    }
    let _factored = work.factor(plan, committed);
    work
}

/// What is unbalanced under the estimates after one unknown has moved, an equation each.
fn moved(
    (plan, committed): (&Problem<'_>, &State),
    work: &mut Scratch,
    (equation, step): (usize, f64),
) -> Vec<f64> {
    let before = work.u.clone();
    work.u[plan.constraints.dof_of_equation[equation]] += step;
    plan.constraints.enforce(&[], &mut work.u);
    work.evaluate(plan, committed, 1.0);
    work.unbalanced_by_estimates(plan);
    work.u = before;
    plan.constraints.dof_of_equation.iter().map(|&dof| work.residual[dof]).collect()
}

/// Requirement: the matrix that is factored with inserted laws is the derivative of the forces
/// under them, with beams, rigid links, curvature of the masters, stick and slip, soft and hard laws
/// about multipliers that are held. Central differences leave 1e-8; tolerance 1e-6 of the largest
/// entry of the column.
#[test]
fn the_tangent_of_inserted_laws_by_differences() {
    for way in WAYS {
        for (line, aside) in [(true, 0.3), (true, 0.005), (false, 0.3), (false, -0.005)] {
            let model = way.model(line);
            let prepared = Prepared::new(&model);
            let enforcement = Some(way.enforcement);
            let plan = Problem { enforcement, ..prepared.problem(&model) };
            let committed = undeformed(&plan);
            let mut work = work(&prepared, (&plan, &committed), (aside, -0.06));
            let pressing = work.evaluation.estimates.iter().filter(|(p, _)| *p > 0.0);
            let sheared = pressing.filter(|(_, traction)| *traction != Tangential::ZERO).count();
            assert!(sheared > 0, "{line} {aside}");
            let assembled = work.augmented.clone();
            let pattern = plan.pattern;
            // what has no stiffness at all has rounding
            let least = 1e-6 * assembled.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            for j in 0..plan.constraints.equations() {
                let [up, down] =
                    [STEP, -STEP].map(|step| moved((&plan, &committed), &mut work, (j, step)));
                let column: Vec<f64> = (0..up.len())
                    .map(|i| pattern.position(i, j).map_or(0.0, |at| assembled[at]))
                    .collect();
                let largest = column.iter().fold(least, |most, entry| most.max(entry.abs()));
                for (i, entry) in column.iter().enumerate() {
                    let difference = (up[i] - down[i]) / (2.0 * STEP);
                    let off = (entry - difference).abs() / largest;
                    let word = way.enforcement.word();
                    assert!(off < 1e-6, "{word} {line} {aside} ({i}, {j}): {entry} {difference}");
                }
            }
        }
    }
}

/// Requirement: multipliers move to the pressures found once what is unbalanced is less than that
/// changes, and not before; penalty has none to move.
#[test]
fn multipliers_move_once_forces_balance() {
    for way in WAYS {
        let model = way.model(true);
        let prepared = Prepared::new(&model);
        let plan = Problem { enforcement: Some(way.enforcement), ..prepared.problem(&model) };
        let committed = undeformed(&plan);
        let mut work = work(&prepared, (&plan, &committed), (0.3, -0.06));
        assert!(!work.move_multipliers(&plan, 0.0), "far from balance");
        let moves = work.move_multipliers(&plan, f64::MAX);
        assert_eq!(moves, way.enforcement == Enforcement::Augmented);
        let follow = |(held, p): (&HeldMultiplier, &f64)| held.pressure == *p;
        assert!(!moves || work.held.of.iter().zip(&work.pressures).all(follow));
        assert!(!work.move_multipliers(&plan, f64::MAX), "nothing is left to move");
    }
}
