//! How deep a point lies in a part: in which simplex, and how far from the boundary.

use super::mesh::Part;

/// A part as it stands.
pub struct Body {
    simplices: Vec<Vec<[f64; 3]>>,
    boundary: Vec<Vec<[f64; 3]>>,
    box_of: [[f64; 3]; 2],
}

/// Distance of two points.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    length(minus(a, b))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Body {
    /// The corners of a part at their places.
    pub fn new(part: &Part, at: &impl Fn(usize) -> [f64; 3]) -> Self {
        let shape = part.kind.shape;
        let simplices: Vec<Vec<_>> = part
            .cells
            .iter()
            .flat_map(|cell| {
                let places = |simplex: &&[usize]| simplex.iter().map(|&k| at(cell[k])).collect();
                shape.simplices().iter().map(places).collect::<Vec<_>>()
            })
            .collect();
        let facets = part.boundary().into_iter().flat_map(|face| {
            let p: Vec<_> = face.iter().map(|&node| at(node)).collect();
            match p.len() {
                4 => vec![vec![p[0], p[1], p[2]], vec![p[0], p[2], p[3]]],
                _ => vec![p],
            }
        });
        let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
        for corner in simplices.iter().flatten() {
            for k in 0..3 {
                (low[k], high[k]) = (low[k].min(corner[k]), high[k].max(corner[k]));
            }
        }
        let boundary = facets.collect();
        Self { simplices, boundary, box_of: [low, high] }
    }

    /// Depth of a point; 0 outside.
    pub fn of(&self, at: [f64; 3]) -> f64 {
        let [low, high] = self.box_of;
        let outside = (0..3).any(|k| at[k] < low[k] || at[k] > high[k]);
        if outside || !self.simplices.iter().any(|simplex| holds(simplex, at)) {
            return 0.0;
        }
        self.boundary.iter().map(|facet| from_facet(facet, at)).fold(f64::MAX, f64::min)
    }
}

/// Whether a triangle of the plane or a tetrahedron holds a point.
fn holds(simplex: &[[f64; 3]], at: [f64; 3]) -> bool {
    let volume = |p: &[[f64; 3]]| {
        let (a, b) = (minus(p[1], p[0]), minus(p[2], p[0]));
        if p.len() == 3 { cross(a, b)[2] } else { dot(cross(a, b), minus(p[3], p[0])) }
    };
    let all = volume(simplex);
    (0..simplex.len()).all(|k| {
        let mut part = simplex.to_vec();
        part[k] = at;
        volume(&part) / all > 0.0
    })
}

fn from_segment([a, b]: [[f64; 3]; 2], at: [f64; 3]) -> f64 {
    let along = minus(b, a);
    let t = (dot(minus(at, a), along) / dot(along, along).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    distance(at, [0, 1, 2].map(|k| a[k] + t * along[k]))
}

fn from_facet(facet: &[[f64; 3]], at: [f64; 3]) -> f64 {
    if facet.len() == 2 {
        return from_segment([facet[0], facet[1]], at);
    }
    let normal = cross(minus(facet[1], facet[0]), minus(facet[2], facet[0]));
    let inside = (0..3).all(|k| {
        let edge = minus(facet[(k + 1) % 3], facet[k]);
        dot(cross(edge, minus(at, facet[k])), normal) >= 0.0
    });
    if inside {
        return dot(minus(at, facet[0]), normal).abs() / length(normal).max(f64::MIN_POSITIVE);
    }
    (0..3).map(|k| from_segment([facet[k], facet[(k + 1) % 3]], at)).fold(f64::MAX, f64::min)
}
