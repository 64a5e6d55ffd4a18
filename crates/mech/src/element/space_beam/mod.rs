//! B31 and B32: geometrically exact (Simo-Reissner) beams in space, of two and three nodes.
//!
//! ```text
//!      n2 ^  ^ n1                  dofs of each node: displacements, rotations
//!         | /                      x: integration points, one (B31) or two (B32)
//!   1 o---|/--x-------o 2          a section turns by R and may lean over the axis
//!         +--> t
//! ```
//!
//! Rotations are interpolated as turns against one node, psi = sum N_a psi_a: strains do not change
//! when all of it turns, and do not depend on how it came there [crisfield1999]. docs/theory.md
//! section 3.7.

mod change;
mod posture;
mod station;

pub use station::Strains as SpaceStrains;

use super::cell::{line3_shapes, line3_slopes};
use super::heated::{BeamHeat, weighted};
use super::kernel::{Failure, Kernel, Response, Scale, Strains, Surroundings};
use super::quadrature::GAUSS_2;
use crate::axes::PLAIN;
use crate::section::SpaceStiffness;
use crate::turn::Turn;
use change::Change;
use posture::Posture;
use station::{MOST, Station};

/// Beams in space of `N` nodes and `P` integration points: two and one, or three and two.
#[derive(Clone, Debug)]
pub struct SpaceBeams<const N: usize, const P: usize> {
    elements: Vec<SpaceBeam<N, P>>,
    /// What temperature does to them; `None`: nothing.
    heat: Option<BeamHeat>,
}

/// One of them.
#[derive(Clone, Copy, Debug)]
pub struct SpaceBeam<const N: usize, const P: usize> {
    stations: [Station<N>; P],
    /// Section stiffness, in the order of [`SpaceStrains`].
    section: [[f64; 6]; 6],
    /// What it is made of.
    stiffness: SpaceStiffness,
    /// Strains of the free element at each point, hot as it is.
    free: [SpaceStrains; P],
}

/// Shape functions of a line and their derivatives by xi, which runs from -1 to 1.
fn line<const N: usize>(xi: f64) -> ([f64; N], [f64; N]) {
    let (mut shapes, mut slopes) = ([0.0; N], [0.0; N]);
    if N == 3 {
        shapes.copy_from_slice(&line3_shapes(xi));
        slopes.copy_from_slice(&line3_slopes(xi));
    } else {
        shapes[..2].copy_from_slice(&[0.5 * (1.0 - xi), 0.5 * (1.0 + xi)]);
        slopes[..2].copy_from_slice(&[-0.5, 0.5]);
    }
    (shapes, slopes)
}

/// The unit vectors t, n1, n2 of a section whose axis has the direction `along`, n1 the part of
/// `first` across it and n2 = t x n1; `None` where `first` runs along the axis.
pub fn section_axes(along: [f64; 3], first: [f64; 3]) -> Option<[[f64; 3]; 3]> {
    let unit = |v: [f64; 3]| {
        let size = v[0].hypot(v[1]).hypot(v[2]);
        (size > 0.0 && size.is_finite()).then(|| v.map(|part| part / size))
    };
    let (t, first) = (unit(along)?, unit(first)?);
    let part: f64 = (0..3).map(|k| t[k] * first[k]).sum();
    let across: [f64; 3] = std::array::from_fn(|k| first[k] - part * t[k]);
    if across[0].hypot(across[1]).hypot(across[2]) < ALONG {
        return None;
    }
    let n1 = unit(across)?;
    Some([t, n1, crate::rotation::cross(&t, &n1)])
}

/// Sine of the angle to the axis below which a direction has no part across it [1].
const ALONG: f64 = 1e-6;

impl<const N: usize, const P: usize> SpaceBeam<N, P> {
    /// The element on undeformed positions [L] with n1 along `first`; `None` where that runs along
    /// its axis or the axis has no length.
    pub fn new(nodes: [[f64; 3]; N], first: [f64; 3], section: &SpaceStiffness) -> Option<Self> {
        let mut sound = true;
        let stations = std::array::from_fn(|point| {
            let (xi, weight) = match P {
                1 => (0.0, 2.0),
                _ => ([-GAUSS_2, GAUSS_2][point % 2], 1.0),
            };
            let (shapes, slopes) = line::<N>(xi);
            let plain = Station { length: weight, axes: PLAIN, shapes, slopes };
            let along = plain.slope(|a| nodes[a]);
            let grown = along[0].hypot(along[1]).hypot(along[2]);
            let axes = section_axes(along, first);
            sound &= axes.is_some();
            Station {
                length: weight * grown,
                axes: axes.unwrap_or(PLAIN),
                slopes: slopes.map(|slope| slope / grown),
                ..plain
            }
        });
        let (stiffness, free) = (*section, [[0.0; 6]; P]);
        sound.then_some(Self { stations, section: section.matrix(), stiffness, free })
    }

    /// The same element at its temperatures: those of the integration points by the shape
    /// functions, the stiffness at their mean. docs/theory.md eq. (3.109).
    fn warmed(&self, heat: &BeamHeat, under: &Surroundings<'_>) -> Self {
        let at = |nodes, station: &Station<N>| weighted(&station.shapes, nodes);
        let free = std::array::from_fn(|point| {
            let station = &self.stations[point];
            let [now, initial] = [under.temperatures, under.initial].map(|own| at(own, station));
            heat.free_in_space(&self.stiffness, now, initial)
        });
        let sum: f64 = self.stations.iter().map(|own| at(under.temperatures, own).value).sum();
        let stiffness = heat.space_stiffness(&self.stiffness, sum / P as f64);
        Self { free, section: stiffness.matrix(), stiffness, ..*self }
    }

    /// Undeformed length of the axis [L], by the integration points.
    pub fn length(&self) -> f64 {
        self.stations.iter().map(|station| station.length).sum()
    }

    /// Strains at a point that the free element does not have.
    fn elastic(&self, point: usize, mut strains: SpaceStrains) -> SpaceStrains {
        strains.iter_mut().zip(self.free[point]).for_each(|(own, free)| *own -= free);
        strains
    }

    /// Section forces of such strains: N, V1, V2 [F], torque, M1, M2 [F L] about t, n1, n2.
    fn forces(&self, strains: &SpaceStrains) -> [f64; 6] {
        self.section.map(|row| row.iter().zip(strains).map(|(d, e)| d * e).sum())
    }

    /// Strains at an integration point of small displacements.
    fn linear_strains(&self, point: usize, q: &[f64]) -> SpaceStrains {
        let rows = self.stations[point].linear();
        rows.map(|row| row.iter().zip(q).map(|(b, q)| b * q).sum())
    }

    fn linear(&self, q: &[f64], force: &mut [f64], tangent: Option<&mut [f64]>) -> f64 {
        let mut change = Change::default();
        for (point, station) in self.stations.iter().enumerate() {
            let strains = self.elastic(point, self.linear_strains(point, q));
            let rows = station.linear();
            let stresses = self.forces(&strains);
            change.energy += 0.5 * station.length * product(&stresses, &strains);
            for (row, stress) in rows.iter().zip(stresses) {
                (0..6 * N).for_each(|i| change.force[i] += station.length * stress * row[i]);
            }
            if tangent.is_some() {
                change.stiffen(station.length, &rows, &self.section, 6 * N);
            }
        }
        change.write(6 * N, force, tangent);
        change.energy
    }

    /// Energy, force and tangent by displacements and further turns of the nodes; `estimated`
    /// stresses make the geometric stiffness, where there are some.
    fn exact(
        &self,
        q: &[f64],
        posture: &Posture<N>,
        estimated: Option<&[f64]>,
        stiffen: bool,
    ) -> Change {
        let mut change = Change::default();
        // what the turns of each node against the reference node carry, by force and by estimate
        let mut carried = [[0.0; 3]; N];
        for (point, station) in self.stations.iter().enumerate() {
            let sensed = station.sense(q, posture);
            let strains = self.elastic(point, sensed.strains());
            let stresses = self.forces(&strains);
            let rates = station.rates(posture);
            change.energy += 0.5 * station.length * product(&stresses, &strains);
            let pull = sensed.pull(&stresses);
            change.add_force(station.length, &pull, &rates, 6 * N);
            if !stiffen {
                continue;
            }
            let geometric = estimate(estimated, point).unwrap_or(stresses);
            let pull = sensed.pull(&geometric);
            change.add_carried(station.length, &pull, &rates, 6 * N);
            for (a, carried) in carried.iter_mut().enumerate() {
                for (k, sum) in carried.iter_mut().enumerate() {
                    let both = station.shapes[a] * pull[station::PSI + k]
                        + station.slopes[a] * pull[station::PSI + 3 + k];
                    *sum += station.length * both;
                }
            }
            let stiffness = sensed.stiffness(&geometric, &self.section);
            change.stiffen(station.length, &rates, &stiffness, 6 * N);
        }
        if stiffen {
            change.stiffen_by_relative(&carried, posture);
        }
        change
    }

    /// Where a linear solution with the change `change` arrives: D (eps + B dq).
    fn arrive(&self, q: &[f64], change: &[f64], posture: &Posture<N>, into: &mut [f64]) {
        let mut turned = [0.0; MOST];
        turned[..6 * N].copy_from_slice(&change[..6 * N]);
        change::spin(&mut turned, posture);
        let stations = self.stations.iter().zip(into.as_chunks_mut::<6>().0);
        for (point, (station, into)) in stations.enumerate() {
            let sensed = station.sense(q, posture);
            let rates = station.rates(posture);
            let moved = rates.map(|row| row.iter().zip(turned).map(|(r, t)| r * t).sum::<f64>());
            let mut strains = sensed.strains();
            for (strain, value) in strains.iter_mut().enumerate() {
                *value +=
                    sensed.gradient(strain).iter().zip(moved).map(|(g, m)| g * m).sum::<f64>();
            }
            *into = self.forces(&self.elastic(point, strains));
        }
    }
}

fn product(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The estimated stresses of a point; `None`: there are none.
fn estimate(stresses: Option<&[f64]>, point: usize) -> Option<[f64; 6]> {
    stresses?.as_chunks::<6>().0.get(point).copied()
}

impl<const N: usize, const P: usize> FromIterator<SpaceBeam<N, P>> for SpaceBeams<N, P> {
    fn from_iter<I: IntoIterator<Item = SpaceBeam<N, P>>>(elements: I) -> Self {
        Self { elements: elements.into_iter().collect(), heat: None }
    }
}

impl<const N: usize, const P: usize> SpaceBeams<N, P> {
    /// The same under temperatures that count.
    pub fn heated(self, heat: Option<BeamHeat>) -> Self {
        Self { heat, ..self }
    }

    fn warmed(&self, element: usize, under: &Surroundings<'_>) -> SpaceBeam<N, P> {
        let element = &self.elements[element];
        self.heat.as_ref().map_or(*element, |heat| element.warmed(heat, under))
    }
}

impl<const N: usize, const P: usize> Kernel for SpaceBeams<N, P> {
    fn count(&self) -> usize {
        self.elements.len()
    }

    fn variables(&self) -> usize {
        6 * N
    }

    fn estimate_size(&self) -> usize {
        6 * P
    }

    fn respond(
        &self,
        element: usize,
        q: &[f64],
        _committed: &[f64],
        under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure> {
        let element = self.warmed(element, under);
        let Response { force, tangent, .. } = into;
        let estimated = match under.strains {
            Strains::Linear => return Ok(element.linear(q, force, tangent)),
            Strains::Mixed(stresses) => Some(stresses),
            Strains::Exact => None,
        };
        let posture = Posture::new(q, under.turns);
        let mut change = element.exact(q, &posture, estimated, tangent.is_some());
        change.take_rotation_vectors(&posture, tangent.is_some());
        change.write(6 * N, force, tangent);
        Ok(change.energy)
    }

    fn force_of_stresses(
        &self,
        element: usize,
        (q, turns): (&[f64], &[Turn]),
        stresses: &[f64],
        force: &mut [f64],
    ) -> bool {
        let element = &self.elements[element];
        let posture = Posture::new(q, turns);
        let mut change = Change::default();
        for (point, station) in element.stations.iter().enumerate() {
            let pull = station
                .sense(q, &posture)
                .pull(&estimate(Some(stresses), point).unwrap_or_default());
            change.add_force(station.length, &pull, &station.rates(&posture), 6 * N);
        }
        change.take_rotation_vectors(&posture, false);
        change.write(6 * N, force, None);
        true
    }

    fn stresses_after(
        &self,
        element: usize,
        q: &[f64],
        change: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        self.warmed(element, under).arrive(q, change, &Posture::new(q, under.turns), into);
    }

    fn tighten(&self, element: usize, reach: f64, stresses: &mut [f64]) {
        let element = &self.elements[element];
        let stiffness = &element.stiffness;
        let own = (stiffness.axial, stiffness.least_bending());
        super::mixed::tighten::<6>(own, reach, stresses);
    }

    fn scale(&self, element: usize) -> Scale {
        let element = &self.elements[element];
        let length = element.length();
        Scale { stiffness: element.section[0][0] / length, length: Some(length) }
    }

    /// Section forces and moments SF1 (axial), SF2, SF3 (along n2, n1) [F], SM1, SM2 (about -n1 and
    /// n2), SM3 (torque) [F L], then the strains of these, at the middle: docs/theory.md eq. (3.78).
    fn results(
        &self,
        element: usize,
        q: &[f64],
        _state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let element = self.warmed(element, under);
        let posture = under.is_large().then(|| Posture::new(q, under.turns));
        let (mut middle, mut elastic) = ([0.0; 6], [0.0; 6]);
        for (point, station) in element.stations.iter().enumerate() {
            let strains = match &posture {
                Some(posture) => station.sense(q, posture).strains(),
                None => element.linear_strains(point, q),
            };
            let mean = |into: &mut SpaceStrains, own: SpaceStrains| {
                into.iter_mut().zip(own).for_each(|(sum, own)| *sum += own / P as f64);
            };
            mean(&mut middle, strains);
            mean(&mut elastic, element.elastic(point, strains));
        }
        let told = |[n, v1, v2, t, m1, m2]: [f64; 6]| [n, v2, v1, -m1, m2, t];
        let values = [told(element.forces(&elastic)), told(middle)];
        into.iter_mut().zip(values.as_flattened()).for_each(|(into, value)| *into = *value);
    }
}
