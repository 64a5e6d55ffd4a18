//! A thick tube that is held at its ends, under pressure from inside.
//!
//! ```text
//!      ___
//!    /  _  \      inner radius A, outer radius B; r: radius
//!   |  (p)  |     plane strain, nothing outside
//!    \ ___ /
//! ```

/// A tube of undeformed radii A < B [L].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// Inner radius [L].
    pub inner: f64,
    /// Outer radius [L].
    pub outer: f64,
}

impl Tube {
    /// Radial displacement of the outer face [L] where the inner one moves by `moved`, elastic and
    /// small: u = C (r (1 - 2 nu) + B^2/r). [Lame]
    pub fn elastic_outer(&self, moved: f64, poisson: f64) -> f64 {
        let shape = |r: f64| r * (1.0 - 2.0 * poisson) + self.outer * self.outer / r;
        moved * shape(self.outer) / shape(self.inner)
    }

    /// Pressure inside [F/L2] for that displacement of the inner face. [Lame]
    pub fn elastic_pressure(&self, moved: f64, modulus: f64, poisson: f64) -> f64 {
        let (a, b) = (self.inner, self.outer);
        let ratio = modulus / (1.0 + poisson);
        let constant = moved / (a * (1.0 - 2.0 * poisson) + b * b / a);
        ratio * constant * (b * b / (a * a) - 1.0)
    }

    /// Pressure at which all of it flows, of a yield stress without hardening [F/L2]: 2 sigma
    /// ln(B/A)/sqrt 3. [von Mises, incompressible flow in plane strain]
    pub fn limit_pressure(&self, yield_stress: f64) -> f64 {
        2.0 / 3f64.sqrt() * yield_stress * (self.outer / self.inner).ln()
    }

    /// Pressure [F/L2] for an inner radius `a` [L] of an incompressible neo-Hookean tube: mu [ln(B
    /// a/(A b)) + (c/2)(1/a^2 - 1/b^2)], c = a^2 - A^2 = b^2 - B^2. [derived]
    pub fn rubber_pressure(&self, inner: f64, shear: f64) -> f64 {
        let grown = inner * inner - self.inner * self.inner;
        let outer = (self.outer * self.outer + grown).sqrt();
        let ratio = (self.outer * inner / (self.inner * outer)).ln();
        shear * (ratio + 0.5 * grown * (1.0 / (inner * inner) - 1.0 / (outer * outer)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: small inflations of rubber are elastic with nu = 1/2. Tolerance: the square of
    /// the strain.
    #[test]
    fn small_inflations_are_elastic() {
        let tube = Tube { inner: 1.0, outer: 2.0 };
        let rubber = tube.rubber_pressure(1.0 + 1e-6, 1.0);
        let elastic = tube.elastic_pressure(1e-6, 3.0, 0.5);
        assert!((rubber / elastic - 1.0).abs() < 1e-5, "{rubber} {elastic}");
        assert!((tube.elastic_outer(1e-6, 0.5) - 0.5e-6).abs() < 1e-18);
    }
}
