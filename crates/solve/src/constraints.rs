//! Which dofs are unknown, and how all others follow: u = u0 + T q, and its
//! derivatives.
//!
//! ```text
//!   unknowns q        node dofs u
//!   o free  --------> u = q                         row of T: 1
//!   | prescribed ---> u = u0(t)                     empty
//!   o==o rigid -----> x = x_m + R(phi_m) arm        1 and the turning of the arm
//!   o--o equation --> u = c + sum a_k u_k           the coefficients a_k
//!   o--o shape ----> g(u) = 0                      - g_k / g_d, as they turn
//!   o::o mean -----> g(u) = 0, as many as follow   - G_d^-1 G_k, as they turn
//!   o own axes -----> u = sum q_i e_i               the axes e_i
//! ```
//!
//! Elements, contact and loads speak of the dofs of their own nodes alone. A
//! force f on those acts on the unknowns as T' f, a tangent K as T' K T, and
//! where T turns with the unknowns, f . d2u/dq2 is added: docs/theory.md
//! eqs (4.1) to (4.4), (4.18).

mod carried;
mod cloud;
mod deserted;
mod following;
mod joined;
mod linear;
mod mean;
mod mean_slopes;
#[cfg(test)]
mod mean_tests;
mod motion;
mod numbering;
mod rigid;
mod rows;
mod shapes;
#[cfg(test)]
mod tests;
mod turning;

pub use carried::Carried;
pub use following::Constraints;
pub use motion::Motion;
pub use numbering::{ConstraintNumbering, Role};
pub use rows::Rows;
