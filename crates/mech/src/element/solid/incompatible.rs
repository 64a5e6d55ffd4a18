//! Incompatible modes, transposed: bending without locking, stable in compression.
//!
//! ```text
//!    H = H_u + F0 M(alpha),   M = (w0/w) J0^-T [alpha_ab xi_a] J0^-1
//!
//!    ___                      F0: deformation at the centre, so that a turn changes nothing
//!   (___)  bends like a beam  J0: dX/dxi there; w: volume of a point by its weight
//! ```
//!
//! The parameters alpha are the element's own: they are found where their force vanishes, and
//! eliminated. Usual modes carry xi_b in the place of xi_a and lose stability in
//! compression [korelc1996], [glaser1997]. docs/theory.md eqs. (3.51) to (3.53).

use super::centre::Centre;
use super::gather;
use super::place::{Apart, NO_STRAIN, Place, apart, invert};
use super::point::{Point, States, energy};
use super::solids::Solids;
use crate::element::kernel::{Failure, Response, Surroundings};
use crate::material::tensor::{INDEX, Matrix};

/// Most modes: three times three.
const MOST: usize = 9;
/// Most corrections of the parameters.
const CORRECTIONS: usize = 60;
/// Most halvings of a correction.
const HALVINGS: u32 = 12;
/// Change of the parameters, relative to the strains, behind which the last linear correction is
/// exact to rounding [1].
const CLOSE: f64 = 1e-8;

/// What the modes do at a point.
#[derive(Clone, Copy)]
struct Mode<const D: usize, const N: usize> {
    /// Gradient of a mode by deformed position.
    gradient: [[f64; D]; D],
    /// What turns when a mode and a node move together, axis by axis [1/L].
    turning: [[f64; N]; D],
}

/// The centre of a deformed element.
struct Core<'a, const D: usize, const N: usize> {
    /// Before.
    own: &'a Centre<D, N>,
    /// F of the displacements.
    deformation: [[f64; D]; D],
}

/// A point as displacements and modes move it.
#[derive(Clone, Copy)]
struct Enhanced<const D: usize, const N: usize> {
    /// Its slopes are those with which nodes move the modes along.
    place: Place<D, N>,
    gradient: Matrix,
    modes: [Mode<D, N>; MOST],
}

/// Forces and tangents of nodes and modes.
struct Sums<const D: usize, const N: usize> {
    force: [f64; MOST],
    own: [[f64; MOST]; MOST],
    /// By the displacements of the nodes, axis by axis.
    joint: [[[f64; N]; D]; MOST],
}

fn unit<const D: usize>() -> [[f64; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
}

fn product<const D: usize>(a: &[[f64; D]; D], b: &[[f64; D]; D]) -> [[f64; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..D).map(|k| a[i][k] * b[k][j]).sum()))
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Where the parameters stand among an element's state variables.
    fn first_parameter(&self) -> usize {
        P * self.point_states()
    }

    #[inline(always)]
    fn core(&self, element: usize, apart: &Apart<D, N>, large: bool) -> Core<'_, D, N> {
        let own = &self.centres[element];
        let mut deformation = unit();
        if large {
            for (row, own) in deformation.iter_mut().zip(&own.place.gradient(apart)) {
                row.iter_mut().zip(own).for_each(|(f, h)| *f += h);
            }
        }
        Core { own, deformation }
    }

    /// M of one mode at a point.
    fn mode(
        &self,
        mode: usize,
        point: usize,
        density: f64,
        centre: &Centre<D, N>,
    ) -> [[f64; D]; D] {
        let (a, b) = (mode / D, mode % D);
        let scale = centre.place.weight / density * self.tables.points[point].at[a];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| scale * centre.inverse[a][i] * centre.inverse[b][j])
        })
    }

    /// A point with the gradients of the parameters added, and what the modes do there.
    #[inline(always)]
    fn enhanced(
        &self,
        point: usize,
        (place, gradient): (&Place<D, N>, &Matrix),
        (core, large): (&Core<'_, D, N>, bool),
        parameters: &[f64],
    ) -> Enhanced<D, N> {
        let density = place.weight / self.tables.points[point].weight;
        let none = Mode { gradient: [[0.0; D]; D], turning: [[0.0; N]; D] };
        let mut with = Enhanced { place: *place, gradient: *gradient, modes: [none; MOST] };
        let mut sum = [[0.0; D]; D];
        for (mode, into) in with.modes.iter_mut().take(D * D).enumerate() {
            into.gradient = self.mode(mode, point, density, core.own);
            for (sum, row) in sum.iter_mut().zip(&into.gradient) {
                sum.iter_mut().zip(row).for_each(|(sum, m)| *sum += parameters[mode] * m);
            }
        }
        let added = product(&core.deformation, &sum);
        for (row, own) in with.gradient.iter_mut().zip(&added) {
            row.iter_mut().zip(own).for_each(|(h, m)| *h += m);
        }
        if large {
            carry_back(&mut with.place.slopes, &sum, &core.own.place.slopes);
            turn(&with.gradient, core, &mut with.modes);
        }
        with
    }

    /// Force, tangent, trial state and energy of an element with modes.
    #[inline(always)]
    pub(super) fn with_modes(
        &self,
        element: usize,
        q: &[f64],
        (committed, under): (&[f64], &Surroundings<'_>),
        (points, into): (&mut [Point<D, N>; P], Response<'_>),
    ) -> Result<f64, Failure> {
        let first = self.first_parameter();
        let mut parameters = [0.0; MOST];
        parameters
            .iter_mut()
            .zip(&committed[first.min(committed.len())..])
            .for_each(|(p, c)| *p = *c);
        let mut search = Search::default();
        for _ in 0..CORRECTIONS {
            let states = (under, committed, &mut *into.state);
            let moved = self.moved(element, q, &parameters, states, points);
            let size = moved.as_ref().map_or(f64::INFINITY, |sums| norm(&sums.force));
            if !search.is_better(size) {
                search.go_back(&mut parameters)?;
                continue;
            }
            let sums = moved?;
            let step = solve::<1>(D * D, &sums.own, &sums.force.map(|f| [-f]));
            let Some(step) = step else { break };
            search.step(&mut parameters, &step, size);
            let change = step.iter().fold(0.0_f64, |most, [step]| most.max(step.abs()));
            let size = self.centres[element].size(&parameters, points);
            if change <= CLOSE * size {
                let room = into.state.get_mut(first..first + D * D).unwrap_or_default();
                room.iter_mut().zip(&parameters).for_each(|(to, own)| *to = *own);
                gather::force(points, into.force);
                self.eliminate(points, &sums, &step, (into.force, into.tangent));
                return Ok(energy(points));
            }
            if !change.is_finite() {
                break;
            }
        }
        Err(Failure::NoEquilibrium)
    }

    /// Writes all points; the sums of the modes.
    #[inline(always)]
    fn moved(
        &self,
        element: usize,
        q: &[f64],
        parameters: &[f64; MOST],
        (under, committed, state): States<'_, '_>,
        points: &mut [Point<D, N>; P],
    ) -> Result<Sums<D, N>, Failure> {
        let large = under.is_large();
        let apart = apart(q);
        let core = self.core(element, &apart, large);
        let mut sums =
            Sums { force: [0.0; MOST], own: [[0.0; MOST]; MOST], joint: [[[0.0; N]; D]; MOST] };
        for (k, (place, point)) in self.places[element].iter().zip(points).enumerate() {
            let gradient = self.gradient([element, k], place, (q, &apart));
            let with = self.enhanced(k, (place, &gradient), (&core, large), parameters);
            let states = (under, committed, &mut *state);
            self.answer([element, k], (&with.place, &with.gradient), states, point)?;
            sums.add(point, &with.modes);
        }
        Ok(sums)
    }

    /// Eliminates the parameters, whose last correction is `step`.
    fn eliminate(
        &self,
        points: &[Point<D, N>; P],
        sums: &Sums<D, N>,
        step: &[[f64; 1]; MOST],
        (force, tangent): (&mut [f64], Option<&mut [f64]>),
    ) {
        for (a, node) in force.chunks_exact_mut(D).enumerate() {
            for (i, force) in node.iter_mut().enumerate() {
                *force += (0..D * D).map(|m| sums.joint[m][i][a] * step[m][0]).sum::<f64>();
            }
        }
        let Some(tangent) = tangent else { return };
        gather::tangent(points, self.is_ring(), None, tangent);
        for i in 0..D {
            let sides: [[f64; N]; MOST] = std::array::from_fn(|m| sums.joint[m][i]);
            let Some(solved) = solve::<N>(D * D, &sums.own, &sides) else { return };
            for (b, k) in (0..N).flat_map(|b| (0..D).map(move |k| (b, k))) {
                for a in 0..N {
                    let less: f64 = (0..D * D).map(|m| solved[m][a] * sums.joint[m][k][b]).sum();
                    tangent[D * N * (D * a + i) + D * b + k] -= less;
                }
            }
        }
    }

    /// Writes all points as the parameters of a state move them, for results.
    pub(super) fn enhanced_points(
        &self,
        element: usize,
        q: &[f64],
        (under, committed, state): States<'_, '_>,
        points: &mut [Point<D, N>; P],
    ) -> Result<(), Failure> {
        let mut parameters = [0.0; MOST];
        let first = self.first_parameter().min(committed.len());
        parameters.iter_mut().zip(&committed[first..]).for_each(|(p, own)| *p = *own);
        self.moved(element, q, &parameters, (under, committed, state), points).map(|_| ())
    }
}

/// Where the parameters came from: a correction that lessens nothing is halved.
#[derive(Default)]
struct Search {
    from: [f64; MOST],
    step: [f64; MOST],
    /// Size of the forces before the step; `None`: there was none.
    size: Option<f64>,
    halved: u32,
}

impl Search {
    /// Whether forces of that size are no more than those before the step.
    fn is_better(&self, size: f64) -> bool {
        self.size.is_none_or(|before| size <= before)
    }

    /// Half of the last step; an error: it was halved often enough.
    fn go_back(&mut self, parameters: &mut [f64; MOST]) -> Result<(), Failure> {
        self.halved += 1;
        if self.halved > HALVINGS {
            return Err(Failure::NoEquilibrium);
        }
        for ((own, from), step) in parameters.iter_mut().zip(&self.from).zip(&mut self.step) {
            *step *= 0.5;
            *own = from + *step;
        }
        Ok(())
    }

    /// Takes a whole step, from where forces have that size.
    fn step(&mut self, parameters: &mut [f64; MOST], step: &[[f64; 1]; MOST], size: f64) {
        *self =
            Self { from: *parameters, step: step.map(|[step]| step), size: Some(size), halved: 0 };
        parameters.iter_mut().zip(step).for_each(|(own, [step])| *own += step);
    }
}

fn norm(list: &[f64; MOST]) -> f64 {
    list.iter().map(|x| x * x).sum::<f64>().sqrt()
}

impl<const D: usize, const N: usize> Centre<D, N> {
    /// What changes of the parameters are held against: themselves and the strains, in the units
    /// of the parameters [L2].
    fn size(&self, parameters: &[f64; MOST], points: &[Point<D, N>]) -> f64 {
        let largest = |list: &[f64]| list.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        // what is strained without moving, by heat, has stresses
        let strain_of = |point: &Point<D, N>| {
            let elastic = largest(&point.stress) / largest(point.moduli.as_flattened());
            largest(point.gradient.as_flattened()).max(elastic)
        };
        let strain = points.iter().map(strain_of).fold(NO_STRAIN, f64::max);
        let inverse = largest(self.inverse.as_flattened());
        largest(parameters).max(strain / (inverse * inverse))
    }
}

/// slopes += M' slopes at the centre: nodes move the modes along.
fn carry_back<const D: usize, const N: usize>(
    slopes: &mut [[f64; N]; D],
    modes: &[[f64; D]; D],
    centre: &[[f64; N]; D],
) {
    for (j, slopes) in slopes.iter_mut().enumerate() {
        for (k, centre) in centre.iter().enumerate() {
            slopes.iter_mut().zip(centre).for_each(|(s, c)| *s += modes[k][j] * c);
        }
    }
}

/// Makes the gradients of modes those by deformed position: F0 M F^-1, and M' grad0 F^-1.
fn turn<const D: usize, const N: usize>(
    gradient: &Matrix,
    core: &Core<'_, D, N>,
    modes: &mut [Mode<D, N>; MOST],
) {
    let f: [[f64; D]; D] = std::array::from_fn(|i| {
        std::array::from_fn(|j| gradient[i][j] + f64::from(u8::from(i == j)))
    });
    let (back, _) = invert(&f);
    for mode in modes.iter_mut().take(D * D) {
        let behind = product(&mode.gradient, &back);
        for (j, row) in mode.turning.iter_mut().enumerate() {
            for (k, slopes) in core.own.place.slopes.iter().enumerate() {
                row.iter_mut().zip(slopes).for_each(|(t, s)| *t += behind[k][j] * s);
            }
        }
        mode.gradient = product(&core.deformation, &behind);
    }
}

impl<const D: usize, const N: usize> Sums<D, N> {
    /// Adds a point: docs/theory.md eq. (3.53).
    fn add(&mut self, point: &Point<D, N>, modes: &[Mode<D, N>; MOST]) {
        let w = point.weight;
        // w (c_ijkl + 1_ik tau_jl) l_kl of every mode
        let mut products = [[[0.0; D]; D]; MOST];
        let mut of_hoop = [0.0; MOST];
        for (m, mode) in modes.iter().enumerate().take(D * D) {
            for i in 0..D {
                for j in 0..D {
                    let moduli = &point.moduli[INDEX[i][j]];
                    let mut sum = 0.0;
                    for l in 0..D {
                        for k in 0..D {
                            sum += moduli[INDEX[k][l]] * mode.gradient[k][l];
                        }
                        sum += point.turning[INDEX[j][l]] * mode.gradient[i][l];
                    }
                    products[m][i][j] = w * sum;
                    self.force[m] += w * point.stress[INDEX[i][j]] * mode.gradient[i][j];
                    of_hoop[m] += w * point.moduli[2][INDEX[i][j]] * mode.gradient[i][j];
                }
            }
        }
        for (m, product) in products.iter().enumerate().take(D * D) {
            for (own, mode) in self.own[m].iter_mut().zip(modes).take(D * D) {
                let pairs = product.as_flattened().iter().zip(mode.gradient.as_flattened());
                *own += pairs.map(|(p, l)| p * l).sum::<f64>();
            }
            for (i, row) in self.joint[m].iter_mut().enumerate() {
                for j in 0..D {
                    let turned: f64 = w * point.turning[INDEX[i][j]];
                    let pairs = point.slopes[j].iter().zip(&modes[m].turning[j]);
                    for (sum, (slope, turning)) in row.iter_mut().zip(pairs) {
                        *sum += product[i][j] * slope + turned * turning;
                    }
                }
            }
            if D == 2 {
                let row = &mut self.joint[m][0];
                row.iter_mut().zip(&point.hoop).for_each(|(sum, hoop)| *sum += of_hoop[m] * hoop);
            }
        }
    }
}

/// Solves a small dense system for `S` right sides by elimination with row pivots; `None`: it is
/// singular.
fn solve<const S: usize>(
    size: usize,
    matrix: &[[f64; MOST]; MOST],
    sides: &[[f64; S]; MOST],
) -> Option<[[f64; S]; MOST]> {
    let (mut a, mut x) = (*matrix, *sides);
    for k in 0..size {
        let pivot = (k..size).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        x.swap(k, pivot);
        let (row, side, head) = (a[k], x[k], a[k][k]);
        if head == 0.0 || head.is_nan() {
            return None;
        }
        for i in k + 1..size {
            let factor = a[i][k] / head;
            a[i].iter_mut().zip(&row).skip(k).for_each(|(entry, own)| *entry -= factor * own);
            x[i].iter_mut().zip(&side).for_each(|(entry, own)| *entry -= factor * own);
        }
    }
    for k in (0..size).rev() {
        let head = a[k][k];
        x[k].iter_mut().for_each(|entry| *entry /= head);
        let side = x[k];
        for i in 0..k {
            let factor = a[i][k];
            x[i].iter_mut().zip(&side).for_each(|(entry, own)| *entry -= factor * own);
        }
    }
    (size..MOST).for_each(|k| x[k] = [0.0; S]);
    Some(x)
}
