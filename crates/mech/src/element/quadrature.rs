//! Gauss's rules: where an element is integrated.

/// Abscissa of the two-point rule, 1/sqrt 3; both points have weight 1.
pub const GAUSS_2: f64 = 0.577_350_269_189_625_8;

/// Abscissae of the four-point rule on [-1, 1].
pub const GAUSS_4: [f64; 4] = [
    -0.861_136_311_594_052_6,
    -0.339_981_043_584_856_26,
    0.339_981_043_584_856_26,
    0.861_136_311_594_052_6,
];

/// Weights of the four-point rule for a mean value [1].
pub const GAUSS_4_MEAN: [f64; 4] = [
    0.173_927_422_568_726_93,
    0.326_072_577_431_273_07,
    0.326_072_577_431_273_07,
    0.173_927_422_568_726_93,
];

/// The product of two two-point rules on the square, xi running first; every weight is 1.
pub const SQUARE_2X2: [[f64; 2]; 4] =
    [[-GAUSS_2, -GAUSS_2], [GAUSS_2, -GAUSS_2], [-GAUSS_2, GAUSS_2], [GAUSS_2, GAUSS_2]];

/// Values at the corners of the square, counter-clockwise from (-1, -1), of the bilinear function
/// through those at [`SQUARE_2X2`].
pub fn square_corners(points: &[f64], corners: &mut [f64]) {
    let Ok(points) = <&[f64; 4]>::try_from(points) else { return };
    let reach = 1.0 / GAUSS_2;
    for (corner, place) in
        corners.iter_mut().zip([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    {
        // the points are the corners of a square of half the side GAUSS_2
        let [a, b, c, d] = super::cell::quad4_shapes(place.map(|x: f64| x * reach));
        *corner = a * points[0] + b * points[1] + c * points[3] + d * points[2];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a bilinear function is carried to the corners exactly. Tolerance: rounding.
    #[test]
    fn corners_of_a_bilinear_function() {
        let of = |[x, y]: [f64; 2]| 2.0 + x - 3.0 * y + 0.5 * x * y;
        let mut corners = [0.0; 4];
        square_corners(&SQUARE_2X2.map(of), &mut corners);
        let exact = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(of);
        assert!(corners.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-14), "{corners:?}");
    }

    /// Requirement: n points integrate polynomials of degree 2 n - 1. Tolerance: rounding.
    #[test]
    fn degrees_of_exactness() {
        for degree in 0..8 {
            let exact = if degree % 2 == 0 { 1.0 / f64::from(degree + 1) } else { 0.0 };
            let four: f64 = GAUSS_4.iter().zip(GAUSS_4_MEAN).map(|(x, w)| w * x.powi(degree)).sum();
            assert!((four - exact).abs() < 1e-15, "{degree}");
            let two: f64 = SQUARE_2X2.iter().map(|[x, _]| 0.25 * x.powi(degree)).sum();
            assert_eq!((two - exact).abs() < 1e-15, degree < 4 || degree % 2 == 1, "{degree}");
        }
    }
}
