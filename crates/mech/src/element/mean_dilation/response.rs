//! Force and tangent of [`MeanDilation`]: the law differentiated by its three invariants in forward
//! arithmetic, then carried to the nodes by hand, docs/theory.md eqs. (3.34).

use super::{MeanDilation, Point, small};
use crate::differentiate::Second;
use crate::element::kernel::{Element, Scale};
use crate::material::{PlaneInvariants, PlaneStrainLaw, SmallStrain, invariants};

/// A point at given displacements.
#[derive(Clone, Copy)]
struct State {
    /// H = du/dX.
    gradient: [[f64; 2]; 2],
    at: PlaneInvariants,
    /// Energy per volume with its derivatives by s, j, m.
    law: Second<3>,
}

/// The three rows of a point: derivatives of d1 = H11 - H22, d2 = H12 + H21 and j by the
/// displacements of a node.
fn rows<const NODES: usize>(point: &Point<NODES>, cofactor: &[[f64; 2]; 2], node: usize) -> Rows {
    let [x, y] = point.slopes[node];
    let c = cofactor;
    Rows { first: [x, -y], second: [y, x], dilation: c.map(|row| row[0] * x + row[1] * y) }
}

#[derive(Clone, Copy, Default)]
struct Rows {
    first: [f64; 2],
    second: [f64; 2],
    dilation: [f64; 2],
}

impl State {
    /// Derivatives of j by H: the cofactor of F, or the unit tensor where displacements are small.
    fn cofactor(&self, linear: bool) -> [[f64; 2]; 2] {
        let h = &self.gradient;
        if linear {
            [[1.0, 0.0], [0.0, 1.0]]
        } else {
            [[1.0 + h[1][1], -h[1][0]], [-h[0][1], 1.0 + h[0][0]]]
        }
    }

    /// d1 and d2, of which s is the sum of squares.
    fn across(&self) -> [f64; 2] {
        let h = &self.gradient;
        [h[0][0] - h[1][1], h[0][1] + h[1][0]]
    }
}

impl<L: PlaneStrainLaw, const NODES: usize, const POINTS: usize> MeanDilation<L, NODES, POINTS> {
    /// The points at displacements q, and the pressure-like sum of w W_m over the volume.
    fn states(&self, law: &impl PlaneStrainLaw, linear: bool, q: &[f64]) -> ([State; POINTS], f64) {
        let mut states = self.points.map(|point| {
            let gradient = point.gradient(q);
            let at = if linear { small(&gradient) } else { invariants(&gradient) };
            State { gradient, at, law: Second::constant(0.0) }
        });
        let sum = |of: &dyn Fn(&State) -> f64, states: &[State; POINTS]| -> f64 {
            self.points.iter().zip(states).map(|(point, state)| point.weight * of(state)).sum()
        };
        let mean = sum(&|state| state.at.dilation, &states) / self.volume;
        for state in &mut states {
            state.at.mean = mean;
            let [shear, dilation, mean] =
                Second::variables(&[state.at.shear, state.at.dilation, mean]);
            state.law = law.energy(&PlaneInvariants { shear, dilation, mean });
        }
        let pressure = sum(&|state| state.law.gradient[2], &states) / self.volume;
        (states, pressure)
    }

    /// Writes force and tangent, returns the strain energy [F L].
    fn respond(
        &self,
        law: &impl PlaneStrainLaw,
        linear: bool,
        q: &[f64],
        force: &mut [f64],
        tangent: Option<&mut [f64]>,
    ) -> f64 {
        let (states, pressure) = self.states(law, linear, q);
        force.fill(0.0);
        let mut energy = 0.0;
        for (point, state) in self.points.iter().zip(&states) {
            let [by_shear, by_dilation, _] = state.law.gradient.map(|slope| point.weight * slope);
            let (cofactor, [d1, d2]) = (state.cofactor(linear), state.across());
            let by_dilation = by_dilation + pressure * point.weight;
            for (node, force) in force.chunks_exact_mut(2).enumerate() {
                let rows = rows(point, &cofactor, node);
                for (i, force) in force.iter_mut().enumerate() {
                    *force += 2.0 * by_shear * (d1 * rows.first[i] + d2 * rows.second[i])
                        + by_dilation * rows.dilation[i];
                }
            }
            energy += point.weight * state.law.value;
        }
        if let Some(tangent) = tangent {
            self.tangent(&states, pressure, linear, tangent);
        }
        energy
    }

    /// docs/theory.md eq. (3.34), second line.
    fn tangent(&self, states: &[State; POINTS], pressure: f64, linear: bool, tangent: &mut [f64]) {
        let mut mean = [[0.0; 2]; NODES];
        let mut own = [[Rows::default(); NODES]; POINTS];
        for ((point, state), own) in self.points.iter().zip(states).zip(&mut own) {
            let cofactor = state.cofactor(linear);
            for (node, own) in own.iter_mut().enumerate() {
                *own = rows(point, &cofactor, node);
                for (mean, own) in mean[node].iter_mut().zip(own.dilation) {
                    *mean += point.weight / self.volume * own;
                }
            }
        }
        tangent.fill(0.0);
        for ((point, state), rows) in self.points.iter().zip(states).zip(&own) {
            // Without products in j its second derivative is zero.
            let turning = if linear { 0.0 } else { state.law.gradient[1] + pressure };
            add_point(point, state, (rows, &mean), turning, tangent);
        }
        mirror(tangent, 2 * NODES);
    }

    /// Cauchy stress (11, 22, 33, 12) [F/L2] and strain of every point: docs/theory.md eq. (3.40).
    fn write_results(&self, law: &impl PlaneStrainLaw, linear: bool, q: &[f64], into: &mut [f64]) {
        let (states, pressure) = self.states(law, linear, q);
        let (stresses, strains) = into.split_at_mut((4 * POINTS).min(into.len()));
        let lines = stresses.chunks_exact_mut(4).zip(strains.chunks_exact_mut(4));
        for (state, (stress, strain)) in states.iter().zip(lines) {
            let h = if linear { [[0.0; 2]; 2] } else { state.gradient };
            let f = [[1.0 + h[0][0], h[0][1]], [h[1][0], 1.0 + h[1][1]]];
            let volume = if linear { 1.0 } else { 1.0 + state.at.dilation };
            let [d1, d2] = state.across();
            let shape = 2.0 * state.law.gradient[0] / volume;
            let even = state.law.gradient[1] + pressure;
            stress.copy_from_slice(&[
                shape * (d1 * f[0][0] + d2 * f[0][1]) + even,
                shape * (d2 * f[1][0] - d1 * f[1][1]) + even,
                law.across(&state.at) / volume + pressure,
                shape * (d1 * f[1][0] + d2 * f[1][1]),
            ]);
            strain.copy_from_slice(&law.strain(&state.gradient));
        }
    }

    fn small_law(&self) -> SmallStrain {
        SmallStrain { elastic: self.elastic, engineering: self.engineering }
    }
}

/// Adds what a point contributes to the upper triangle.
fn add_point<const NODES: usize>(
    point: &Point<NODES>,
    state: &State,
    (rows, mean): (&[Rows; NODES], &[[f64; 2]; NODES]),
    turning: f64,
    tangent: &mut [f64],
) {
    let (gradient, hessian) = (&state.law.gradient, &state.law.hessian);
    let [d1, d2] = state.across();
    let twice = 2.0 * point.weight * gradient[0];
    for a in 0..NODES {
        for i in 0..2 {
            // derivatives of s, j, m by this displacement, and those of W_s, W_j, W_m
            let own = [
                2.0 * (d1 * rows[a].first[i] + d2 * rows[a].second[i]),
                rows[a].dilation[i],
                mean[a][i],
            ];
            let by: [f64; 3] = std::array::from_fn(|r| {
                point.weight
                    * (hessian[r][0] * own[0] + hessian[r][1] * own[1] + hessian[r][2] * own[2])
            });
            let row = &mut tangent[(2 * a + i) * 2 * NODES..][..2 * NODES];
            for b in a..NODES {
                for k in 0..2 {
                    let other = 2.0 * (d1 * rows[b].first[k] + d2 * rows[b].second[k]);
                    row[2 * b + k] += by[0] * other
                        + by[1] * rows[b].dilation[k]
                        + by[2] * mean[b][k]
                        + twice
                            * (rows[a].first[i] * rows[b].first[k]
                                + rows[a].second[i] * rows[b].second[k]);
                }
                // j'' = H11 H22 - H12 H21, by one component of each node
                let ([ax, ay], [bx, by]) = (point.slopes[a], point.slopes[b]);
                let crossed = point.weight * turning * (ax * by - ay * bx);
                row[2 * b + 1 - i] += if i == 0 { crossed } else { -crossed };
            }
        }
    }
}

/// Copies the upper triangle of nodes to the lower.
fn mirror(tangent: &mut [f64], width: usize) {
    for i in 0..width {
        for j in 0..i {
            tangent[width * i + j] = tangent[width * j + i];
        }
    }
}

impl<L, const NODES: usize, const POINTS: usize, const N: usize, const NN: usize> Element<N, NN>
    for MeanDilation<L, NODES, POINTS>
where
    L: PlaneStrainLaw + std::fmt::Debug + Send + Sync,
{
    fn linear(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64 {
        self.respond(&self.small_law(), true, q, force, Some(tangent))
    }

    fn exact(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64 {
        self.respond(&self.law, false, q, force, Some(tangent))
    }

    fn exact_force(&self, q: &[f64; N], force: &mut [f64; N]) -> f64 {
        self.respond(&self.law, false, q, force, None)
    }

    fn scale(&self) -> Scale {
        let bulk = self.elastic.bulk_modulus();
        let modulus = bulk + 4.0 / 3.0 * self.elastic.shear_modulus();
        let length = (self.volume / self.thickness).sqrt();
        Scale { stiffness: modulus * self.thickness, length: Some(length) }
    }

    /// S11, S22, S33, S12 [F/L2] of every point, then E11, E22, E33, E12 [1].
    fn results(&self, q: &[f64; N], linear: bool, into: &mut [f64]) {
        if linear {
            self.write_results(&self.small_law(), true, q, into);
        } else {
            self.write_results(&self.law, false, q, into);
        }
    }
}
