//! Trusses among solids: what stands along them, along the axes of the model.
//!
//! ```text
//!        t              S = s t t'
//!       /  o            E = e t t' + q (1 - t t')      q: across
//!      o
//! ```

use super::points::Solid;
use crate::node::place;
use slideline_mech::element::cell::line3_slopes;
use slideline_mech::vector::{Vector, add, scale, size};

impl Solid<'_> {
    /// Cauchy stress at a point along the axes of the model: 11, 22, 33, 12, 13, 23 [F/L2].
    pub fn stress_in_space(&self, point: usize) -> [f64; 6] {
        match self.block.kind.is_truss() {
            true => about(self.way(point), self.stress(point)[0], 0.0),
            false => self.stress(point),
        }
    }

    /// Strain at a point of a truss as it tells it, along the same, shears as components of the tensor [1]; of others it is a
    /// quantity.
    pub fn truss_strain(&self, point: usize) -> Option<[f64; 6]> {
        match *self.field("E", point) {
            [along, across] if self.block.kind.is_truss() => {
                Some(about(self.way(point), along, across))
            }
            _ => None,
        }
    }

    /// The way along a truss at a point where it stands, of length one; none where it has no length.
    fn way(&self, point: usize) -> Vector {
        let nodes = self.element.nodes;
        let slopes = match nodes.len() {
            3 => line3_slopes(if point == 0 { -1.0 } else { 1.0 } / 3.0_f64.sqrt()),
            _ => [-0.5, 0.5, 0.0],
        };
        let places = nodes.iter().map(|&node| place(self.frame, node));
        let way = places.zip(slopes).fold([0.0; 3], |sum, (at, by)| add(sum, scale(at, by)));
        let long = size(way);
        if long > 0.0 { scale(way, 1.0 / long) } else { way }
    }
}

/// The tensor with that value along a way, and that across: 11, 22, 33, 12, 13, 23.
fn about(t: Vector, along: f64, across: f64) -> [f64; 6] {
    let of =
        |i: usize, j: usize| (along - across) * t[i] * t[j] + if i == j { across } else { 0.0 };
    [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(0, 2), of(1, 2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: of a bar along (3, 4, 0)/5 the tensor has the value along it, that across, and no shear between both.
    /// Tolerance: rounding.
    #[test]
    fn a_tensor_about_a_way_has_its_values() {
        let [xx, yy, zz, xy, xz, yz] = about([0.6, 0.8, 0.0], 10.0, -3.0);
        let along = 0.36 * xx + 0.64 * yy + 2.0 * 0.48 * xy;
        let across = 0.64 * xx + 0.36 * yy - 2.0 * 0.48 * xy;
        let between = 0.48 * (yy - xx) + (0.36 - 0.64) * xy;
        for (own, value) in [(along, 10.0), (across, -3.0), (between, 0.0), (zz, -3.0)] {
            assert!((own - value).abs() < 1e-13, "{own} for {value}");
        }
        assert_eq!([xz, yz], [0.0, 0.0]);
    }
}
