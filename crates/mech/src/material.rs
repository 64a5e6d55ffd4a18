//! Materials: pure functions of a strain and a committed state.
//!
//! ```text
//!   displacement gradient H, committed state, conditions (kinematics, temperatures, time)
//!        |
//!        v      +--> stress      Cauchy's where strains are small, Kirchhoff's where large
//!     respond --+--> moduli      consistent with the trial state
//!        |      +--> trial state
//!        v
//!   energy, dissipation
//! ```
//!
//! All in three dimensions; plane stress and plane strain are the element's. Tensors are made by
//! hand; where a law is differentiated it is by three invariants or stretches at most. Moduli at
//! large strain: with C' = (1 + l)'(1 + l) the energy grows by tau:eps + eps:c:eps/2, eps = (C' -
//! 1)/2, docs/theory.md eq. (3.39).

mod answer;
mod back_stress;
mod begun;
pub mod creep;
mod elastic;
mod expansion;
mod fibrous;
mod foam;
mod graded;
mod hardening;
mod hencky;
pub mod hyperelastic;
mod law;
mod limit;
mod logarithmic;
pub mod plastic;
mod prestressed;
mod principal;
mod ramberg_osgood;
mod respond;
pub mod tensor;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod time_tests;
mod uniaxial;
mod viscoelastic;

pub use answer::{Answer, Clock, Conditions, Law};
pub use back_stress::BackStress;
pub use creep::{CreepHardening, Creeping, PowerLaw};
pub use elastic::{Anisotropic, Elastic, LargeStrain, Unsound};
pub use expansion::{Expanding, Expansion, Growth, between};
pub use fibrous::Fibrous;
pub use foam::{Foam, Term};
pub use hardening::Hardening;
pub use hyperelastic::{MOST_TERMS, Rubber, Volume};
pub use law::{Graded, Material};
pub use limit::HardeningEnd;
pub use plastic::Plastic;
pub use prestressed::Prestressed;
pub use principal::Axes;
pub use ramberg_osgood::RambergOsgood;
pub use uniaxial::Uniaxial;
pub use viscoelastic::{Relaxation, Viscoelastic};
