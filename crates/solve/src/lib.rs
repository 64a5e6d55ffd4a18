//! Model to committed states.
//!
//! ```text
//!   Model --> Plan --> Workspace --> attempt (Newton) --> commit --> observers
//!                      (takes the      ^      |
//!                       values)        +------+ cutback: a value is dropped
//! ```
//!
//! A pure evaluation of a trial state gives forces and tangents; Newton
//! linearises structure and geometry and solves contact exactly in every
//! linearisation; the increment control is a pure machine; commit is a swap.

mod account;
mod adjust;
mod balance;
mod books;
mod checkpoint;
mod commit;
mod constraints;
mod contact;
mod continued;
mod convergence;
mod diagnose;
mod dofs;
mod evaluate;
mod heaviest;
mod history;
mod idle;
mod increments;
mod iteration_history;
mod joined_forces;
mod leading;
mod linear_systems;
mod linearised;
mod loads;
mod memory;
mod moments;
mod newton;
pub mod observe;
mod overpulled;
mod plan;
mod predict;
mod problem;
mod restraint;
mod rows;
mod run;
mod section_forces;
mod section_loads;
mod sensitivity;
mod stabilise;
mod start;
mod state;
mod structure;
mod tangent;
mod target;
mod users;
mod values;
mod workspace;

pub use adjust::adjust;
pub use checkpoint::Checkpoint;
pub use commit::initial_contact;
pub use contact::placed as rigid_surface;
pub use idle::{Idle, without_effect};
pub use increments::{Control, Decision, StopReason, Verdict};
pub use linear_systems::LinearSystems;
pub use memory::objection as memory_objection;
pub use plan::{Part, Plan, PlanMismatch};
pub use run::{Options, TangentCheck, resume, run, run_from};
pub use sensitivity::{Parameter, SensitivityFault, Varied};
pub use slideline_linalg as linalg;
pub use slideline_mech::contact::enforcement::Enforcement;
pub use slideline_mech::contact::friction;
pub use stabilise::may_stabilise;
pub use users::UserFrictions;
pub use workspace::Workspace;
