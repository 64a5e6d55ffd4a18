//! Linear shear-flexible cantilever under a load at its tip, and what equal
//! two-node elements with one integration point make of it.

/// A cantilever by its stiffnesses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearBeam {
    /// Length L [L].
    pub length: f64,
    /// Bending stiffness EI [F L2].
    pub bending_stiffness: f64,
    /// Transverse shear stiffness kGA [F].
    pub shear_stiffness: f64,
}

impl ShearBeam {
    /// Tip deflection [L] of the beam itself: P L^3/(3 EI) + P L/kGA.
    pub fn deflection(&self, load: f64) -> f64 {
        self.bending(load) + load * self.length / self.shear_stiffness
    }

    /// Tip deflection [L] of `elements` equal one-point elements with the shear
    /// stiffness `shear` [F]: (P L^3/(3 EI))(1 - 1/(4 n^2)) + P L/shear, exactly
    /// [verification: Timoshenko cantilever].
    pub fn one_point_deflection(&self, load: f64, elements: usize, shear: f64) -> f64 {
        let n = elements as f64;
        self.bending(load) * (1.0 - 0.25 / (n * n)) + load * self.length / shear
    }

    /// Shear stiffness [F] with the slenderness factor f_p = 1/(1 + SCF l^2 A/(12 I)),
    /// SCF = 0.25, of one of `elements` equal elements; `area` A [L2] and `inertia` I [L4]
    /// [semantics: transverse shear].
    pub fn slenderness_stiffness(&self, elements: usize, area: f64, inertia: f64) -> f64 {
        let l = self.length / elements as f64;
        self.shear_stiffness / (1.0 + 0.25 * l * l * area / (12.0 * inertia))
    }

    /// Shear stiffness [F] that carries the whole residual bending flexibility
    /// l^2/(12 EI): with it any number of elements is exact [semantics: transverse shear].
    pub fn residual_flexibility_stiffness(&self, elements: usize) -> f64 {
        let l = self.length / elements as f64;
        1.0 / (1.0 / self.shear_stiffness + l * l / (12.0 * self.bending_stiffness))
    }

    fn bending(&self, load: f64) -> f64 {
        load * self.length.powi(3) / (3.0 * self.bending_stiffness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the table of semantics section 7 for the 1995 beam, to six decimals.
    #[test]
    fn seed_beam_table() {
        let beam = ShearBeam {
            length: 50.0493485e-3,
            bending_stiffness: 0.048515625,
            shear_stiffness: 84591.346,
        };
        let (area, inertia) = (25e-3 * 1.5e-3, 25e-3 * 1.5e-3f64.powi(3) / 12.0);
        let scale = beam.length.powi(3) / (3.0 * beam.bending_stiffness);
        let table = [
            (4, 0.997010, 0.985062),
            (12, 1.000278, 0.998951),
            (24, 1.000585, 1.000253),
            (100, 1.000681, 1.000662),
        ];
        for (n, with, without) in table {
            let factored = beam.slenderness_stiffness(n, area, inertia);
            assert!(
                (beam.one_point_deflection(1.0, n, factored) / scale - with).abs() < 6e-7,
                "{n}"
            );
            assert!(
                (beam.one_point_deflection(1.0, n, beam.shear_stiffness) / scale - without).abs()
                    < 6e-7,
                "{n}"
            );
            let residual = beam.residual_flexibility_stiffness(n);
            assert!(
                (beam.one_point_deflection(1.0, n, residual) / beam.deflection(1.0) - 1.0).abs()
                    < 1e-14
            );
        }
        assert!((beam.deflection(1.0) / scale - 1.000687).abs() < 6e-7);
        let f_p = |n| beam.slenderness_stiffness(n, area, inertia) / beam.shear_stiffness;
        assert!((f_p(4) - 0.05436).abs() < 6e-6 && (f_p(24) - 0.67422).abs() < 6e-6);
    }
}
