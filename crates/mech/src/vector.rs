//! Vectors of space.

/// A vector of space.
pub type Vector = [f64; 3];

/// a + b.
pub fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + b[k])
}

/// a - b.
pub fn sub(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

/// factor a.
pub fn scale(a: Vector, factor: f64) -> Vector {
    a.map(|value| factor * value)
}

/// a . b.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a x b.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Length of a.
pub fn size(a: Vector) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}
