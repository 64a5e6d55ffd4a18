//! Numerical tools of the references: roots, quadrature, small dense systems
//! and an integrator of high order. All of them work in plain `f64`.

pub(crate) mod gauss;
pub(crate) mod newton;
pub(crate) mod root;
