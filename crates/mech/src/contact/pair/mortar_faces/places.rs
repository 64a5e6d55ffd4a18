//! Places and directions of space, of any number type.

use crate::differentiate::Real;

/// A place or a direction of space.
pub type Place<R> = [R; 3];

/// a - b.
pub fn sub<R: Real>(a: Place<R>, b: Place<R>) -> Place<R> {
    std::array::from_fn(|k| a[k] - b[k])
}

/// a + factor b.
pub fn add_scaled<R: Real>(a: Place<R>, factor: R, b: Place<R>) -> Place<R> {
    std::array::from_fn(|k| a[k] + factor * b[k])
}

/// factor a.
pub fn scale<R: Real>(factor: R, a: Place<R>) -> Place<R> {
    a.map(|own| factor * own)
}

/// a . b.
pub fn dot<R: Real>(a: Place<R>, b: Place<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a x b.
pub fn cross<R: Real>(a: Place<R>, b: Place<R>) -> Place<R> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The zero vector.
pub fn zero<R: Real>() -> Place<R> {
    [R::from_f64(0.0); 3]
}

/// a x b on the reference cell.
pub fn flat_cross<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    a[0] * b[1] - a[1] * b[0]
}

/// a - b on the reference cell.
pub fn flat_sub<R: Real>(a: [R; 2], b: [R; 2]) -> [R; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// a + factor b on the reference cell.
pub fn flat_add<R: Real>(a: [R; 2], factor: R, b: [R; 2]) -> [R; 2] {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}
