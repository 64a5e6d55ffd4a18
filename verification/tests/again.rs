//! A plan serves other values of the same outline: nothing is allocated, and the results are
//! those of a run of its own.
//!
//! The first run and the changed model come before other threads, as in `no_allocation`.

use crate::no_allocation::allocations;
use slideline::model::{Friction, Section, Shape};
use slideline::observe::{Ending, Event};
use slideline::{
    Enforcement, Job, Model, Observer, Part, Plan, Quiet, ReadOptions, SolveOptions, Stop,
    Workspace, solve,
};
use slideline_verification::{Claim, Group, Method, Push, Record, many_points, paper};
use std::ops::ControlFlow;
use std::sync::OnceLock;

pub const GROUP: Group = Group {
    file: "again",
    claims: &[
        Claim {
            name: "a_second_run_allocates_nothing",
            requirement: "A second run with the same plan and workspace, of a model with another \
                          section, friction, motion and other positions, allocates no memory.",
            source: "The design of the solver: numbering, pattern and orders belong to the plan, \
                     values and scratch to the workspace.",
            tolerance: "None: zero. (What is done once in a while is left aside: the search for \
                        a jump, a diagnosis.)",
            measure: a_second_run_allocates_nothing,
        },
        Claim {
            name: "a_first_run_allocates_little",
            requirement: "A first run of the paper's problem, its plan and workspace included, \
                          allocates memory at most 310 times.",
            source: "Lists are made with the room that they need.",
            tolerance: "None.",
            measure: a_first_run_allocates_little,
        },
        Claim {
            name: "a_second_run_is_a_run_of_its_own",
            requirement: "Its displacements, reactions and iterations are those of a fresh run \
                          of the changed model.",
            source: "An evaluation depends on its arguments alone.",
            tolerance: "None: the same bits.",
            measure: a_second_run_is_a_run_of_its_own,
        },
        Claim {
            name: "another_outline_is_refused",
            requirement: "A model with other elements, supports or contact is refused, and the \
                          part in which it differs is named.",
            source: "The numbering of a plan is that of one outline.",
            tolerance: "None.",
            measure: another_outline_is_refused,
        },
    ],
};

/// Of a deck: allocations of the first run and of the second, whether the bits are those of a fresh run, and
/// its increments.
type Counted = (&'static str, [usize; 2], bool, usize);

static COUNTS: OnceLock<Vec<Counted>> = OnceLock::new();

/// Bits of all committed displacements and reactions, and iterations.
#[derive(Default, PartialEq)]
struct Bits {
    values: Vec<u64>,
    iterations: usize,
    increments: usize,
}

impl Observer for Bits {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(_) => self.iterations += 1,
            Event::Committed(frame) => {
                self.increments += 1;
                for node in 0..frame.model.nodes.len() {
                    for &dof in frame.nodal.dofs() {
                        let own =
                            [frame.nodal.displacement(node, dof), frame.nodal.reaction(node, dof)];
                        self.values.extend(own.map(f64::to_bits));
                    }
                }
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// The same outline with other values.
fn change(model: &mut Model) {
    for block in &mut model.blocks {
        if let Section::Beam(section) = &mut block.section
            && let Shape::Rectangle { height, .. } = &mut section.shape
        {
            *height *= 1.01;
        }
    }
    for pair in &mut model.contact_pairs {
        if let Friction::Coulomb { coefficient, .. } = &mut pair.interaction.friction {
            *coefficient *= 0.9;
        }
    }
    for step in &mut model.steps {
        step.prescribed.iter_mut().for_each(|prescribed| prescribed.value *= 0.98);
    }
    for node in 0..model.nodes.len() {
        let [x, y, z] = model.nodes.get(node).position;
        model.nodes.place(node, [x, 1.0001 * y, z]);
    }
}

/// Runs, counts; to be called while no other thread runs.
pub fn count() {
    let free = None;
    let friction = Push { mu: 0.3, ..Push::paper(Method::Isl) }.deck();
    let there_and_back = Push { mu: 0.3, returns: true, ..Push::paper(Method::Isl) }.deck();
    let roaming = many_points::beam_on_beam(110);
    let decks = [
        ("softened, ISL", paper::ISL_COARSE, free),
        ("softened, friction, ISL", &friction, free),
        ("softened, friction, two steps", &there_and_back, free),
        ("softened, IRS", paper::IRS_COARSE, free),
        ("hard, no matrix of contact", paper::ISL_PUSH_PULL, Some(Enforcement::MatrixFree)),
        ("beam on beam, 110 nodes", &roaming, free),
    ];
    let counted = decks.map(|(name, deck, enforcement)| {
        let model = Job::read_text("again", deck, &ReadOptions::default()).model.unwrap();
        let mut changed = model.clone();
        change(&mut changed);
        let options = SolveOptions { enforcement, ..SolveOptions::default() };
        let before = allocations();
        let mut workspace = Workspace::new(&Plan::of(&model), &options);
        workspace.run(&model, &mut Quiet).unwrap();
        let first = allocations() - before;
        // another path may need more room, the same values never
        workspace.run(&changed, &mut Quiet).unwrap();
        workspace.run(&model, &mut Quiet).unwrap();
        let before = allocations();
        workspace.run(&changed, &mut Quiet).unwrap();
        let made = allocations() - before;
        let (mut fresh, mut again) = (Bits::default(), Bits::default());
        workspace.run(&changed, &mut again).unwrap();
        solve(&changed, &options, &mut fresh);
        (name, [first, made], fresh == again, fresh.increments)
    });
    COUNTS.get_or_init(|| counted.to_vec());
}

fn a_second_run_allocates_nothing(record: &mut Record) {
    for (name, [_, made], _, increments) in COUNTS.get().unwrap() {
        record.at_least(format!("{name}: increments"), *increments as f64, 1.0);
        record.equal(format!("{name}: allocations"), *made, 0);
    }
}

fn a_first_run_allocates_little(record: &mut Record) {
    let of_the_paper = |own: &&Counted| own.0.contains("ISL") || own.0.contains("IRS");
    for (name, [made, _], ..) in COUNTS.get().unwrap().iter().filter(of_the_paper) {
        record.at_most(format!("{name}: allocations"), *made as f64, 310.0);
    }
}

fn a_second_run_is_a_run_of_its_own(record: &mut Record) {
    for (name, _, same, _) in COUNTS.get().unwrap() {
        record.holds(format!("{name}: the same bits"), *same);
    }
}

fn another_outline_is_refused(record: &mut Record) {
    let model = Job::read_text("again", paper::ISL_COARSE, &ReadOptions::default()).model.unwrap();
    let plan = Plan::of(&model);
    let mut workspace = Workspace::new(&plan, &SolveOptions::default());
    let refused = |model: &Model| plan.mismatch(model).map(|mismatch| mismatch.part);
    let mut held = model.clone();
    held.steps[0].prescribed.pop();
    let mut fewer = model.clone();
    fewer.contact_pairs[0].elements.pop();
    let mut linear = model.clone();
    linear.steps[0].nlgeom = false;
    let cases = [
        ("a support less", refused(&held), Some(Part::Step(1))),
        ("a contact element less", refused(&fewer), Some(Part::Contact(0))),
        ("small displacements", refused(&linear), Some(Part::Step(1))),
        ("the model itself", refused(&model), None),
    ];
    for (name, found, expected) in cases {
        record.holds(format!("{name}: named"), found == expected);
    }
    let refusal = workspace.run(&held, &mut Quiet).err().map(|mismatch| mismatch.part);
    record.holds("another outline is not run", refusal == Some(Part::Step(1)));
    let done = matches!(workspace.run(&model, &mut Quiet), Ok(Ending::Completed(_)));
    record.holds("the model itself is", done);
}
