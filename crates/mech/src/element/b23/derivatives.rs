//! Force and tangent of [`Beam23`]: its energy differentiated by the three strains of the chord in
//! forward arithmetic, then carried to the dofs with the hand-written derivatives of [`Beam21`]:
//! docs/theory.md eq. (3.20).

use super::Beam23;
use crate::differentiate::Second;
use crate::element::b21::Beam21;
use crate::element::beam_strains::{BeamSectionForces, BeamStrains};
use crate::element::kernel::{Element, Scale};
use crate::element::mixed::{Mixed, arrival, estimate, line, tighten};

impl Beam23 {
    fn law(&self, chord: &BeamStrains) -> Second<3> {
        let [axial, shear, curvature] =
            Second::variables(&[chord.axial, chord.shear, chord.curvature]);
        self.energy_per_length(&BeamStrains { axial, shear, curvature })
    }

    /// Writes the internal force dW/dq into `force`: (F, F, F L) of node 1, then of node 2; returns
    /// the strain energy [F L].
    pub fn force(&self, q: &[f64; 6], force: &mut [f64; 6]) -> f64 {
        let strains = self.chord.strains(q);
        let law = self.law(&strains);
        self.chord.end_forces(
            &self.chord.frame(0.5 * (q[2] + q[5])),
            &strains,
            &forces(&law),
            force,
        );
        self.length() * law.value
    }

    /// Writes the internal force and the tangent d2W/dq2 (row-major, symmetric) and returns the
    /// strain energy [F L].
    pub fn force_and_tangent(
        &self,
        q: &[f64; 6],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        let strains = self.chord.strains(q);
        let law = self.law(&strains);
        let forces = forces(&law);
        let frame = self.chord.frame(0.5 * (q[2] + q[5]));
        self.chord.end_forces(&frame, &strains, &forces, force);
        material_tangent(self.length(), &self.chord.rows(&frame, &strains), &law.hessian, tangent);
        self.chord.geometric_tangent(&frame, &strains, &forces, tangent);
        self.length() * law.value
    }

    /// Strains of linear kinematics at the middle.
    pub fn linear_strains(&self, q: &[f64; 6]) -> BeamStrains {
        BeamStrains { shear: 0.0, ..self.chord.linear_strains(q) }
    }

    /// Section forces of linear kinematics at the middle.
    pub fn linear_section_forces(&self, q: &[f64; 6]) -> BeamSectionForces {
        self.chord.stiffness.forces(&self.chord.linear_strains(q).less(&self.chord.free))
    }

    /// Force and tangent of a step without NLGEOM: those of the Hermite beam, which is a B21 with
    /// the transverse stiffness 12 EI/l^2. Returns the energy [F L].
    pub fn linear_force_and_tangent(
        &self,
        q: &[f64; 6],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        Beam21::linear_force_and_tangent(&self.chord, q, force, tangent)
    }
}

fn forces(law: &Second<3>) -> BeamSectionForces {
    let [axial, shear, moment] = law.gradient;
    BeamSectionForces { axial, shear, moment }
}

impl Mixed<6, 36, 3> for Beam23 {
    /// The strains are eps, psi and kap, of which the first two are curved in those of the chord:
    /// docs/theory.md eq. (3.28).
    fn force_and_mixed_tangent(
        &self,
        q: &[f64; 6],
        stresses: &[f64; 3],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        let strains = self.chord.strains(q);
        let [axial, shear, curvature] =
            Second::variables(&[strains.axial, strains.shear, strains.curvature]);
        let (stretch, psi) = self.stretch_and_lean(&BeamStrains { axial, shear, curvature });
        let law = self.energy_of(&stretch, &psi, &curvature);
        let frame = self.chord.frame(0.5 * (q[2] + q[5]));
        self.chord.end_forces(&frame, &strains, &forces(&law), force);
        let bent =
            BeamStrains { axial: stretch.value, shear: psi.value, curvature: strains.curvature };
        let own = self.chord.stiffness.forces(&bent.less(&self.chord.free));
        let own = [own.axial, own.shear];
        let beyond = [stresses[0] - own[0], stresses[1] - own[1]];
        let hessian = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                law.hessian[i][j]
                    + (beyond[0] * stretch.hessian[i][j] + beyond[1] * psi.hessian[i][j])
            })
        });
        let by = |i: usize| {
            law.gradient[i] + (beyond[0] * stretch.gradient[i] + beyond[1] * psi.gradient[i])
        };
        let chord = BeamSectionForces { axial: by(0), shear: by(1), moment: by(2) };
        material_tangent(self.length(), &self.chord.rows(&frame, &strains), &hessian, tangent);
        self.chord.geometric_tangent(&frame, &strains, &chord, tangent);
        self.length() * law.value
    }

    fn force_of_stresses(&self, q: &[f64; 6], [n, v, m]: &[f64; 3]) -> [f64; 6] {
        let strains = self.chord.strains(q);
        let [axial, shear, curvature] =
            Second::variables(&[strains.axial, strains.shear, strains.curvature]);
        let (stretch, psi) = self.stretch_and_lean(&BeamStrains { axial, shear, curvature });
        let by = |i: usize| n * stretch.gradient[i] + v * psi.gradient[i];
        let chord = BeamSectionForces { axial: by(0), shear: by(1), moment: by(2) + m };
        let mut force = [0.0; 6];
        self.chord.end_forces(&self.chord.frame(0.5 * (q[2] + q[5])), &strains, &chord, &mut force);
        force
    }

    fn stresses_after(&self, q: &[f64; 6], change: &[f64; 6]) -> [f64; 3] {
        let chord = self.chord.strains_of(&line(q, change));
        let (stretch, psi) = self.stretch_and_lean(&chord);
        let arrived = BeamStrains {
            axial: arrival(&stretch),
            shear: arrival(&psi),
            curvature: arrival(&chord.curvature),
        };
        self.chord.stiffness.forces(&arrived.less(&self.chord.free)).into()
    }
}

/// l B' D B with a full symmetric D, written over `tangent`.
fn material_tangent(
    length: f64,
    rows: &[[f64; 6]; 3],
    law: &[[f64; 3]; 3],
    tangent: &mut [f64; 36],
) {
    let scaled: [[f64; 6]; 3] = std::array::from_fn(|r| {
        std::array::from_fn(|i| {
            length * (law[r][0] * rows[0][i] + law[r][1] * rows[1][i] + law[r][2] * rows[2][i])
        })
    });
    for i in 0..6 {
        for j in i..6 {
            let sum =
                rows[0][i] * scaled[0][j] + rows[1][i] * scaled[1][j] + rows[2][i] * scaled[2][j];
            tangent[6 * i + j] = sum;
            tangent[6 * j + i] = sum;
        }
    }
}

impl Element<6, 36> for Beam23 {
    fn linear(&self, q: &[f64; 6], force: &mut [f64; 6], tangent: &mut [f64; 36]) -> f64 {
        self.linear_force_and_tangent(q, force, tangent)
    }

    fn exact(&self, q: &[f64; 6], force: &mut [f64; 6], tangent: &mut [f64; 36]) -> f64 {
        self.force_and_tangent(q, force, tangent)
    }

    fn exact_force(&self, q: &[f64; 6], force: &mut [f64; 6]) -> f64 {
        self.force(q, force)
    }

    fn scale(&self) -> Scale {
        Scale { stiffness: self.stiffness().axial / self.length(), length: Some(self.length()) }
    }

    /// N, V, M [F, F, F L], then eps, gam, kap [1, 1, 1/L], at the middle.
    fn results(&self, q: &[f64; 6], linear: bool, into: &mut [f64]) {
        let (strains, forces) = if linear {
            (self.linear_strains(q), self.linear_section_forces(q))
        } else {
            (self.strains(q), self.section_forces(q))
        };
        strains.write_with(&forces, into);
    }

    fn estimate_size(&self) -> usize {
        3
    }

    fn mixed(
        &self,
        q: &[f64; 6],
        stresses: &[f64],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        self.force_and_mixed_tangent(q, &estimate(stresses), force, tangent)
    }

    fn force_of_stresses(&self, q: &[f64; 6], stresses: &[f64], force: &mut [f64; 6]) -> bool {
        *force = Mixed::force_of_stresses(self, q, &estimate(stresses));
        true
    }

    fn stresses_after(&self, q: &[f64; 6], change: &[f64; 6], into: &mut [f64]) {
        into.copy_from_slice(&Mixed::stresses_after(self, q, change));
    }

    fn tighten(&self, reach: f64, stresses: &mut [f64]) {
        let stiffness = self.stiffness();
        tighten::<3>((stiffness.axial, stiffness.bending), reach, stresses);
    }
}
