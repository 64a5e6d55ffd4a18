//! The hand-written derivatives of the energy of [`Beam21`]; tested against the energy itself.

use super::Beam21;
use crate::element::beam_strains::{BeamSectionForces, BeamStrains};
use crate::element::kernel::{Element, Scale};
use crate::element::mixed::{Mixed, estimate, tighten};

/// Cosine and sine of the angle of the section, mean rotation included.
pub(in crate::element) struct Frame {
    c: f64,
    s: f64,
}

impl Beam21 {
    pub(in crate::element) fn frame(&self, mean: f64) -> Frame {
        self.frame_turned(mean.sin_cos())
    }

    fn frame_turned(&self, (s, c): (f64, f64)) -> Frame {
        let [ex, ey] = self.direction;
        Frame { c: ex * c - ey * s, s: ey * c + ex * s }
    }

    /// Strains, and the frame of the section.
    fn strains_and_frame(&self, q: &[f64; 6]) -> (BeamStrains, Frame) {
        let mean = (q[2] + q[5]) * 0.5;
        let turned = mean.sin_cos();
        (self.strains_turned(q, mean, turned), self.frame_turned(turned))
    }

    /// Internal force dW/dq: F2 = (cN - sV, sN + cV), F1 = -F2, moments -M + b and M + b with
    /// b = (l/2)[N gam - V(1 + eps)]. [semantics: B21, end forces]
    pub(in crate::element) fn end_forces(
        &self,
        frame: &Frame,
        strains: &BeamStrains,
        forces: &BeamSectionForces,
        into: &mut [f64; 6],
    ) {
        let (n, v, m) = (forces.axial, forces.shear, forces.moment);
        let (fx, fy) = (frame.c * n - frame.s * v, frame.s * n + frame.c * v);
        let couple = 0.5 * self.length * (n * strains.shear - v * (1.0 + strains.axial));
        *into = [-fx, -fy, couple - m, fx, fy, couple + m];
    }

    /// Writes the internal force dW/dq into `force`: (F, F, F L) of node 1, then of node 2; returns
    /// the strain energy [F L].
    pub fn force(&self, q: &[f64; 6], force: &mut [f64; 6]) -> f64 {
        let (strains, frame) = self.strains_and_frame(q);
        let forces = self.forces_of(&strains);
        self.end_forces(&frame, &strains, &forces, force);
        self.energy_of(&strains, &forces)
    }

    /// Writes the internal force and the tangent d2W/dq2 (row-major, symmetric) and returns the
    /// strain energy [F L]. [semantics: B21, tangent]
    pub fn force_and_tangent(
        &self,
        q: &[f64; 6],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        self.force_and_tangent_of(q, None, force, tangent)
    }

    /// `stresses`: those of the geometric stiffness, where they are not those of the strains.
    #[inline]
    fn force_and_tangent_of(
        &self,
        q: &[f64; 6],
        stresses: Option<&BeamSectionForces>,
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        let (strains, frame) = self.strains_and_frame(q);
        let forces = self.forces_of(&strains);
        self.end_forces(&frame, &strains, &forces, force);
        self.material_tangent(&frame, &strains, tangent);
        self.geometric_tangent(&frame, &strains, stresses.unwrap_or(&forces), tangent);
        self.energy_of(&strains, &forces)
    }

    /// The rows of B: derivatives of eps, gam, kap. [semantics: B21, B rows]
    pub(in crate::element) fn rows(&self, frame: &Frame, strains: &BeamStrains) -> [[f64; 6]; 3] {
        let (c, s) = (frame.c * self.inverse, frame.s * self.inverse);
        let (lean, stretch) = (0.5 * strains.shear, 0.5 * (1.0 + strains.axial));
        let inverse = self.inverse;
        [
            [-c, -s, lean, c, s, lean],
            [s, -c, -stretch, -s, c, -stretch],
            [0.0, 0.0, -inverse, 0.0, 0.0, inverse],
        ]
    }

    /// l B' D B, written over `tangent`.
    fn material_tangent(&self, frame: &Frame, strains: &BeamStrains, tangent: &mut [f64; 36]) {
        let rows = self.stiffness.at_centroid(self.rows(frame, strains));
        let weights = [self.stiffness.axial, self.stiffness.shear, self.stiffness.bending];
        let scaled: [[f64; 6]; 3] =
            std::array::from_fn(|r| std::array::from_fn(|i| self.length * weights[r] * rows[r][i]));
        for i in 0..6 {
            for j in i..6 {
                let sum = scaled[0][i] * rows[0][j]
                    + scaled[1][i] * rows[1][j]
                    + scaled[2][i] * rows[2][j];
                tangent[6 * i + j] = sum;
                tangent[6 * j + i] = sum;
            }
        }
    }

    /// Adds l (N eps'' + V gam'').
    pub(in crate::element) fn geometric_tangent(
        &self,
        frame: &Frame,
        strains: &BeamStrains,
        forces: &BeamSectionForces,
        tangent: &mut [f64; 36],
    ) {
        let (n, v) = (forces.axial, forces.shear);
        let turn = -0.25 * self.length * (n * (1.0 + strains.axial) + v * strains.shear);
        let gx = 0.5 * (-frame.s * n - frame.c * v);
        let gy = 0.5 * (frame.c * n - frame.s * v);
        for rotation in [2, 5] {
            tangent[6 * rotation + 2] += turn;
            tangent[6 * rotation + 5] += turn;
            for (dof, value) in [(0, -gx), (1, -gy), (3, gx), (4, gy)] {
                tangent[6 * rotation + dof] += value;
                tangent[6 * dof + rotation] += value;
            }
        }
    }

    /// Strains of linear kinematics: B at zero displacement times q.
    pub fn linear_strains(&self, q: &[f64; 6]) -> BeamStrains {
        let [ex, ey] = self.direction;
        let (wx, wy) = ((q[3] - q[0]) * self.inverse, (q[4] - q[1]) * self.inverse);
        BeamStrains {
            axial: ex * wx + ey * wy,
            shear: ex * wy - ey * wx - 0.5 * (q[2] + q[5]),
            curvature: (q[5] - q[2]) * self.inverse,
        }
    }

    /// Force and tangent of a step without NLGEOM: the tangent is that at zero displacement, the
    /// force its product with q. Returns the energy [F L].
    pub fn linear_force_and_tangent(
        &self,
        q: &[f64; 6],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        let strains = self.linear_strains(q);
        let forces = self.forces_of(&strains);
        let frame = self.frame(0.0);
        let zero = BeamStrains { axial: 0.0, shear: 0.0, curvature: 0.0 };
        self.end_forces(&frame, &zero, &forces, force);
        self.material_tangent(&frame, &zero, tangent);
        self.energy_of(&strains, &forces)
    }
}

impl Mixed<6, 36, 3> for Beam21 {
    fn force_and_mixed_tangent(
        &self,
        q: &[f64; 6],
        stresses: &[f64; 3],
        force: &mut [f64; 6],
        tangent: &mut [f64; 36],
    ) -> f64 {
        let stresses = BeamSectionForces::from(*stresses);
        self.force_and_tangent_of(q, Some(&stresses), force, tangent)
    }

    fn force_of_stresses(&self, q: &[f64; 6], stresses: &[f64; 3]) -> [f64; 6] {
        let (strains, frame) = self.strains_and_frame(q);
        let mut force = [0.0; 6];
        self.end_forces(&frame, &strains, &(*stresses).into(), &mut force);
        force
    }

    fn stresses_after(&self, q: &[f64; 6], change: &[f64; 6]) -> [f64; 3] {
        let (strains, frame) = self.strains_and_frame(q);
        let [axial, shear, curvature] = self.rows(&frame, &strains);
        let by = |row: [f64; 6]| row.iter().zip(change).map(|(b, dq)| b * dq).sum::<f64>();
        let arrived = BeamStrains {
            axial: strains.axial + by(axial),
            shear: strains.shear + by(shear),
            curvature: strains.curvature + by(curvature),
        };
        self.forces_of(&arrived).into()
    }
}

impl Element<6, 36> for Beam21 {
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
        Scale { stiffness: self.stiffness.axial / self.length, length: Some(self.length) }
    }

    /// N, V, M [F, F, F L], then eps, gam, kap [1, 1, 1/L], at the middle.
    fn results(&self, q: &[f64; 6], linear: bool, into: &mut [f64]) {
        let strains = if linear { self.linear_strains(q) } else { self.strains(q) };
        strains.write_with(&self.forces_of(&strains), into);
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
        tighten::<3>((self.stiffness.axial, self.stiffness.bending), reach, stresses);
    }
}
