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
use super::enhancement::{Modes, Sums, add, dot, turn};
use super::gather;
use super::pivoted::{Factors, MOST};
use super::place::{Apart, NO_STRAIN, Place, apart};
use super::point::{Point, States, energy};
use super::solids::Solids;
use crate::element::kernel::{Failure, Response, Surroundings};
use crate::material::tensor::Matrix;

/// Most corrections of the parameters.
const CORRECTIONS: usize = 60;
/// Most halvings of a correction.
const HALVINGS: u32 = 12;
/// Change of the parameters, relative to the strains, behind which the last linear correction is
/// exact to rounding [1].
const CLOSE: f64 = 1e-8;

/// The centre of a deformed element.
struct Core<'a, const D: usize, const N: usize> {
    /// Before.
    own: &'a Centre<D, N>,
    /// F of the displacements.
    deformation: [[f64; D]; D],
    /// J0^-1 grad0, a node each [1/L].
    carried: [[f64; N]; D],
}

/// A point as displacements and modes move it.
#[derive(Clone, Copy)]
struct Enhanced<const D: usize, const N: usize> {
    /// Its slopes are those with which nodes move the modes along.
    place: Place<D, N>,
    gradient: Matrix,
    modes: Modes<D, N>,
}

fn unit<const D: usize>() -> [[f64; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
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
        let mut carried = [[0.0; N]; D];
        for (row, inverse) in carried.iter_mut().zip(&own.inverse) {
            for (slopes, inverse) in own.place.slopes.iter().zip(inverse) {
                row.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += inverse * slope);
            }
        }
        Core { own, deformation, carried }
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
        let inverse = &core.own.inverse;
        let mut scales = [core.own.place.weight / density; D];
        scales.iter_mut().zip(&self.tables.points[point].at).for_each(|(scale, at)| *scale *= at);
        // F0 x_a, and the sum of the y_b that belong to it
        let (mut ends, mut along) = ([[0.0; D]; D], [[0.0; D]; D]);
        for a in 0..D {
            for (end, row) in ends[a].iter_mut().zip(&core.deformation) {
                *end = scales[a] * dot(row, &inverse[a]);
            }
            for (parameter, inverse) in parameters[a * D..].iter().zip(inverse) {
                add(&mut along[a], *parameter, inverse);
            }
        }
        let mut carried = core.carried;
        for (row, scale) in carried.iter_mut().zip(scales) {
            row.iter_mut().for_each(|entry| *entry *= scale);
        }
        let mut with = Enhanced {
            place: *place,
            gradient: *gradient,
            modes: Modes { ends, ways: *inverse, carried },
        };
        for (end, along) in ends.iter().zip(&along) {
            for (row, end) in with.gradient.iter_mut().zip(end) {
                row.iter_mut().zip(along).for_each(|(h, along)| *h += end * along);
            }
        }
        if large {
            // nodes move the modes along: slopes += M' slopes at the centre
            for (carried, along) in carried.iter().zip(&along) {
                for (slopes, along) in with.place.slopes.iter_mut().zip(along) {
                    slopes.iter_mut().zip(carried).for_each(|(slope, own)| *slope += along * own);
                }
            }
            turn(&with.gradient, &mut with.modes.ways);
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
            let mut sums = Sums::ZERO;
            let moved = self.moved(element, (q, &parameters), states, (points, Some(&mut sums)));
            let size = moved.as_ref().map_or(f64::INFINITY, |()| norm(&sums.force));
            if !search.is_better(size) {
                search.go_back(&mut parameters)?;
                continue;
            }
            moved?;
            sums.mirror();
            let Some(factors) = Factors::new(D * D, &sums.own) else { break };
            let step = factors.solve(&sums.force.map(|f| [-f]));
            search.step(&mut parameters, &step, size);
            let change = step.iter().fold(0.0_f64, |most, [step]| most.max(step.abs()));
            let size = self.centres[element].size(&parameters, points);
            if change <= CLOSE * size {
                let room = into.state.get_mut(first..first + D * D).unwrap_or_default();
                room.iter_mut().zip(&parameters).for_each(|(to, own)| *to = *own);
                gather::force(points, into.force);
                self.eliminate(points, (&sums, &factors), &step, (into.force, into.tangent));
                return Ok(energy(points));
            }
            if !change.is_finite() {
                break;
            }
        }
        Err(Failure::NoEquilibrium)
    }

    /// Writes all points, and adds to the sums of the modes where they are wanted.
    #[inline(always)]
    fn moved(
        &self,
        element: usize,
        (q, parameters): (&[f64], &[f64; MOST]),
        (under, committed, state): States<'_, '_>,
        (points, mut sums): (&mut [Point<D, N>; P], Option<&mut Sums<D, N>>),
    ) -> Result<(), Failure> {
        let large = under.is_large();
        let apart = apart(q);
        let core = self.core(element, &apart, large);
        for (k, (place, point)) in self.places[element].iter().zip(points).enumerate() {
            let gradient = self.gradient([element, k], place, (q, &apart));
            let with = self.enhanced(k, (place, &gradient), (&core, large), parameters);
            let states = (under, committed, &mut *state);
            self.answer([element, k], (&with.place, &with.gradient), states, point)?;
            if let Some(sums) = sums.as_deref_mut() {
                sums.add(point, &with.modes);
            }
        }
        Ok(())
    }

    /// Eliminates the parameters, whose last correction is `step`.
    #[inline(always)]
    fn eliminate(
        &self,
        points: &[Point<D, N>; P],
        (sums, factors): (&Sums<D, N>, &Factors),
        step: &[[f64; 1]; MOST],
        (force, tangent): (&mut [f64], Option<&mut [f64]>),
    ) {
        for (a, node) in force.chunks_exact_mut(D).enumerate() {
            for (i, force) in node.iter_mut().enumerate() {
                *force += (0..D * D).map(|m| sums.joint[m][i][a] * step[m][0]).sum::<f64>();
            }
        }
        let Some(tangent) = tangent else { return };
        gather::tangent(points, self.is_ring(), &[], tangent);
        let mut solved = [[[0.0; N]; MOST]; D];
        for (i, solved) in solved.iter_mut().enumerate() {
            let mut sides = [[0.0; N]; MOST];
            sides.iter_mut().zip(&sums.joint).for_each(|(side, joint)| *side = joint[i]);
            *solved = factors.solve(&sides);
        }
        // the matrix is symmetric: a pair of axes gives the entries of the pair turned round too
        let width = D * N;
        for i in 0..D {
            for (k, a) in (i..D).flat_map(|k| (0..N).map(move |a| (k, a))) {
                let mut less = [0.0; N];
                for (solved, joint) in solved[i].iter().zip(&sums.joint).take(D * D) {
                    add(&mut less, solved[a], &joint[k]);
                }
                for (b, less) in less.into_iter().enumerate() {
                    tangent[width * (D * a + i) + D * b + k] -= less;
                    if i != k {
                        tangent[width * (D * b + k) + D * a + i] -= less;
                    }
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
        self.moved(element, (q, &parameters), (under, committed, state), (points, None))
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
