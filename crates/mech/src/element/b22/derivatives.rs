//! The hand-written derivatives of the energy of [`Beam22`]; tested against the energy itself.

use super::{Beam22, Station, between};
use crate::element::beam_strains::{BeamSectionForces, BeamStrains};
use crate::element::kernel::{Element, Scale};
use crate::element::mixed::{Mixed, estimate, line, tighten};

/// Derivatives at a point: the turned slopes and the strains.
struct Turned {
    /// Derivatives of eps by the nodes' ux and uy (of gam: (-y, x)).
    slopes: [[f64; 2]; 3],
    strains: BeamStrains,
    forces: BeamSectionForces,
}

impl Beam22 {
    fn turned(&self, station: &Station, strains: BeamStrains, rotation: f64) -> Turned {
        let (s, c) = rotation.sin_cos();
        let [ex, ey] = station.direction;
        let axis = [ex * c - ey * s, ey * c + ex * s];
        let slopes = station.slopes.map(|slope| axis.map(|a| a * slope));
        let forces = self.forces_of(&strains.less(&station.free));
        Turned { slopes, strains, forces }
    }

    /// Writes the internal force dW/dq into `force`: (F, F, F L) of first end, middle, second end;
    /// returns the strain energy [F L].
    pub fn force(&self, q: &[f64; 9], force: &mut [f64; 9]) -> f64 {
        *force = [0.0; 9];
        let mut energy = 0.0;
        for station in &self.stations {
            let turned = self.turned(station, station.strains(q), station.motion(q).1);
            add_force(station, &turned, force);
            energy += energy_of(station, &turned);
        }
        energy
    }

    /// Writes the internal force and the tangent d2W/dq2 (row-major, symmetric) and returns the
    /// strain energy [F L].
    pub fn force_and_tangent(
        &self,
        q: &[f64; 9],
        force: &mut [f64; 9],
        tangent: &mut [f64; 81],
    ) -> f64 {
        self.force_and_tangent_of(q, None, force, tangent)
    }

    /// `stresses`: those of the geometric stiffness at both points, where they are not those of
    /// the strains.
    #[inline]
    fn force_and_tangent_of(
        &self,
        q: &[f64; 9],
        stresses: Option<&[BeamSectionForces; 2]>,
        force: &mut [f64; 9],
        tangent: &mut [f64; 81],
    ) -> f64 {
        *force = [0.0; 9];
        *tangent = [0.0; 81];
        let mut energy = 0.0;
        for (point, station) in self.stations.iter().enumerate() {
            let turned = self.turned(station, station.strains(q), station.motion(q).1);
            add_force(station, &turned, force);
            self.add_material(station, &turned, tangent);
            let stresses = stresses.map_or(&turned.forces, |stresses| &stresses[point]);
            add_geometric(station, &turned, stresses, tangent);
            energy += energy_of(station, &turned);
        }
        mirror(tangent);
        energy
    }

    /// Strains of linear kinematics at the two integration points: B at zero displacement times q.
    fn linear_station_strains(&self, q: &[f64; 9]) -> [BeamStrains; 2] {
        self.stations.map(|station| {
            let ([wx, wy, curvature], rotation) = station.motion(q);
            let [ex, ey] = station.direction;
            BeamStrains { axial: ex * wx + ey * wy, shear: ex * wy - ey * wx - rotation, curvature }
        })
    }

    /// Strains of linear kinematics at the middle.
    pub fn linear_strains(&self, q: &[f64; 9]) -> BeamStrains {
        between(&self.linear_station_strains(q), 0.0)
    }

    /// Force and tangent of a step without NLGEOM: the tangent is that at zero displacement, the
    /// force its product with q. Returns the energy [F L].
    pub fn linear_force_and_tangent(
        &self,
        q: &[f64; 9],
        force: &mut [f64; 9],
        tangent: &mut [f64; 81],
    ) -> f64 {
        *force = [0.0; 9];
        *tangent = [0.0; 81];
        let mut energy = 0.0;
        let zero = BeamStrains { axial: 0.0, shear: 0.0, curvature: 0.0 };
        for (station, strains) in self.stations.iter().zip(self.linear_station_strains(q)) {
            // Rows of the undeformed state, forces of the linear strains.
            let forces = self.forces_of(&strains.less(&station.free));
            let straight = Turned { forces, ..self.turned(station, zero, 0.0) };
            add_force(station, &straight, force);
            self.add_material(station, &straight, tangent);
            energy += energy_of(station, &Turned { strains, ..straight });
        }
        mirror(tangent);
        energy
    }

    /// Adds l_g B' D B to the upper triangle.
    fn add_material(&self, station: &Station, turned: &Turned, tangent: &mut [f64; 81]) {
        let rows = self.stiffness.at_centroid(rows(station, turned));
        let stiffness = [self.stiffness.axial, self.stiffness.shear, self.stiffness.bending];
        for i in 0..9 {
            let scaled: [f64; 3] =
                std::array::from_fn(|r| station.length * stiffness[r] * rows[r][i]);
            for j in i..9 {
                tangent[9 * i + j] +=
                    scaled[0] * rows[0][j] + scaled[1] * rows[1][j] + scaled[2] * rows[2][j];
            }
        }
    }
}

impl Mixed<9, 81, 6> for Beam22 {
    fn force_and_mixed_tangent(
        &self,
        q: &[f64; 9],
        stresses: &[f64; 6],
        force: &mut [f64; 9],
        tangent: &mut [f64; 81],
    ) -> f64 {
        let [a, b, c, d, e, f] = *stresses;
        let stresses = [[a, b, c].into(), [d, e, f].into()];
        self.force_and_tangent_of(q, Some(&stresses), force, tangent)
    }

    fn force_of_stresses(&self, q: &[f64; 9], stresses: &[f64; 6]) -> [f64; 9] {
        let mut force = [0.0; 9];
        let [a, b, c, d, e, f] = *stresses;
        for (station, forces) in self.stations.iter().zip([[a, b, c], [d, e, f]]) {
            let turned = self.turned(station, station.strains(q), station.motion(q).1);
            add_force(station, &Turned { forces: forces.into(), ..turned }, &mut force);
        }
        force
    }

    fn stresses_after(&self, q: &[f64; 9], change: &[f64; 9]) -> [f64; 6] {
        let along = line(q, change);
        let [[a, b, c], [d, e, f]] = [&self.stations[0], &self.stations[1]].map(|station| {
            self.forces_of(&station.strains(&along).arrived().less(&station.free)).into()
        });
        [a, b, c, d, e, f]
    }
}

fn energy_of(station: &Station, turned: &Turned) -> f64 {
    let (strains, forces) = (turned.strains.less(&station.free), &turned.forces);
    0.5 * station.length
        * (forces.axial * strains.axial
            + forces.shear * strains.shear
            + forces.moment * strains.curvature)
}

/// The rows of B: derivatives of eps, gam, kap. By the rotation of the point, d eps = gam and
/// d gam = -(1 + eps). [semantics: B21, B rows; derived]
fn rows(station: &Station, turned: &Turned) -> [[f64; 9]; 3] {
    let mut rows = [[0.0; 9]; 3];
    for node in 0..3 {
        let [x, y] = turned.slopes[node];
        let (shape, first) = (station.shapes[node], 3 * node);
        rows[0][first..first + 3].copy_from_slice(&[x, y, turned.strains.shear * shape]);
        rows[1][first..first + 3].copy_from_slice(&[-y, x, -(1.0 + turned.strains.axial) * shape]);
        rows[2][first + 2] = station.slopes[node];
    }
    rows
}

/// Adds l_g B' (N, V, M): docs/theory.md eq. (3.12).
fn add_force(station: &Station, turned: &Turned, force: &mut [f64; 9]) {
    let (n, v, m) = (turned.forces.axial, turned.forces.shear, turned.forces.moment);
    let couple = n * turned.strains.shear - v * (1.0 + turned.strains.axial);
    for node in 0..3 {
        let [x, y] = turned.slopes[node];
        force[3 * node] += station.length * (x * n - y * v);
        force[3 * node + 1] += station.length * (y * n + x * v);
        force[3 * node + 2] +=
            station.length * (couple * station.shapes[node] + m * station.slopes[node]);
    }
}

/// Adds l_g (N eps'' + V gam'') to the upper triangle.
fn add_geometric(
    station: &Station,
    turned: &Turned,
    stresses: &BeamSectionForces,
    tangent: &mut [f64; 81],
) {
    let (n, v) = (stresses.axial, stresses.shear);
    let turn = -station.length * (n * (1.0 + turned.strains.axial) + v * turned.strains.shear);
    let by_slope = turned
        .slopes
        .map(|[x, y]| [station.length * (-y * n - x * v), station.length * (x * n - y * v)]);
    for i in 0..3 {
        let (shape, row) = (station.shapes[i], 3 * i + 2);
        for j in 0..3 {
            if j >= i {
                tangent[9 * row + 3 * j + 2] += turn * shape * station.shapes[j];
            }
            for (dof, &value) in (3 * j..).zip(&by_slope[j]) {
                let (a, b) = if dof < row { (dof, row) } else { (row, dof) };
                tangent[9 * a + b] += shape * value;
            }
        }
    }
}

/// Copies the upper triangle to the lower.
fn mirror(tangent: &mut [f64; 81]) {
    for i in 1..9 {
        for j in 0..i {
            tangent[9 * i + j] = tangent[9 * j + i];
        }
    }
}

impl Element<9, 81> for Beam22 {
    fn linear(&self, q: &[f64; 9], force: &mut [f64; 9], tangent: &mut [f64; 81]) -> f64 {
        self.linear_force_and_tangent(q, force, tangent)
    }

    fn exact(&self, q: &[f64; 9], force: &mut [f64; 9], tangent: &mut [f64; 81]) -> f64 {
        self.force_and_tangent(q, force, tangent)
    }

    fn exact_force(&self, q: &[f64; 9], force: &mut [f64; 9]) -> f64 {
        self.force(q, force)
    }

    fn scale(&self) -> Scale {
        // between neighbouring nodes, along chords
        let [a, b, c] = self.reference;
        let distance = |p: [f64; 2], q: [f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]);
        let half = 0.5 * (distance(a, b) + distance(b, c));
        Scale { stiffness: self.stiffness.axial / half, length: Some(half) }
    }

    /// N, V, M [F, F, F L], then eps, gam, kap [1, 1, 1/L], at the middle.
    fn results(&self, q: &[f64; 9], linear: bool, into: &mut [f64]) {
        let strains = if linear { self.linear_strains(q) } else { self.strains(q) };
        strains.write_with(&self.forces_at_middle(&strains), into);
    }

    fn estimate_size(&self) -> usize {
        6
    }

    fn mixed(
        &self,
        q: &[f64; 9],
        stresses: &[f64],
        force: &mut [f64; 9],
        tangent: &mut [f64; 81],
    ) -> f64 {
        self.force_and_mixed_tangent(q, &estimate(stresses), force, tangent)
    }

    fn force_of_stresses(&self, q: &[f64; 9], stresses: &[f64], force: &mut [f64; 9]) -> bool {
        *force = Mixed::force_of_stresses(self, q, &estimate(stresses));
        true
    }

    fn stresses_after(&self, q: &[f64; 9], change: &[f64; 9], into: &mut [f64]) {
        into.copy_from_slice(&Mixed::stresses_after(self, q, change));
    }

    fn tighten(&self, reach: f64, stresses: &mut [f64]) {
        tighten::<3>((self.stiffness.axial, self.stiffness.bending), reach, stresses);
    }
}
