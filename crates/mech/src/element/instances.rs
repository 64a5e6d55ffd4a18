//! A block of elements of fixed size as a [`Kernel`].

use super::kernel::{Element, Failure, Kernel, Response, Scale, Strains, Surroundings};
use crate::turn::Turn;
use std::any::Any;

/// Elements of one type with `N` variables each; `NN` is `N` squared.
#[derive(Clone, Debug)]
pub struct Instances<E, const N: usize, const NN: usize> {
    elements: Vec<E>,
}

impl<E, const N: usize, const NN: usize> FromIterator<E> for Instances<E, N, NN> {
    fn from_iter<I: IntoIterator<Item = E>>(elements: I) -> Self {
        Self { elements: elements.into_iter().collect() }
    }
}

impl<E: Element<N, NN> + 'static, const N: usize, const NN: usize> Instances<E, N, NN> {
    /// A block of elements in the room of a kernel that is no longer needed, where that one is of
    /// the same type: then nothing is allocated.
    pub fn in_room(
        room: Option<Box<dyn Kernel>>,
        elements: impl Iterator<Item = E>,
    ) -> Box<dyn Kernel> {
        let room = room.and_then(|room| (room as Box<dyn Any>).downcast::<Self>().ok());
        let mut block = room.unwrap_or_else(|| Box::new(Self { elements: Vec::new() }));
        block.elements.clear();
        block.elements.extend(elements);
        block
    }
}

/// Response of an element without state.
pub(super) fn respond<E: Element<N, NN>, const N: usize, const NN: usize>(
    element: &E,
    q: &[f64],
    strains: Strains<'_>,
    into: Response<'_>,
) -> Result<f64, Failure> {
    let (Ok(q), Ok(force)) = (q.try_into(), into.force.try_into()) else { return Ok(0.0) };
    let tangent = into.tangent.and_then(|tangent| <&mut [f64; NN]>::try_from(tangent).ok());
    let energy = match (strains, tangent) {
        (Strains::Linear, Some(tangent)) => element.linear(q, force, tangent),
        (Strains::Linear, None) => element.linear(q, force, &mut [0.0; NN]),
        (Strains::Mixed(stresses), Some(tangent)) => element.mixed(q, stresses, force, tangent),
        (Strains::Exact, Some(tangent)) => element.exact(q, force, tangent),
        (_, None) => element.exact_force(q, force),
    };
    Ok(energy)
}

/// `list` as an array; only a list of another length gives zeros.
pub(super) fn array<const N: usize>(list: &[f64]) -> [f64; N] {
    list.try_into().unwrap_or([0.0; N])
}

impl<E: Element<N, NN> + 'static, const N: usize, const NN: usize> Kernel for Instances<E, N, NN> {
    fn count(&self) -> usize {
        self.elements.len()
    }

    fn variables(&self) -> usize {
        N
    }

    fn estimate_size(&self) -> usize {
        self.elements.first().map_or(0, Element::estimate_size)
    }

    fn respond(
        &self,
        element: usize,
        q: &[f64],
        _committed: &[f64],
        under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure> {
        respond(&self.elements[element], q, under.strains, into)
    }

    fn force_of_stresses(
        &self,
        element: usize,
        (q, _): (&[f64], &[Turn]),
        stresses: &[f64],
        force: &mut [f64],
    ) -> bool {
        let Ok(force) = force.try_into() else { return false };
        self.elements[element].force_of_stresses(&array(q), stresses, force)
    }

    fn stresses_after(
        &self,
        element: usize,
        q: &[f64],
        change: &[f64],
        _under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        self.elements[element].stresses_after(&array(q), &array(change), into);
    }

    fn tighten(&self, element: usize, reach: f64, stresses: &mut [f64]) {
        self.elements[element].tighten(reach, stresses);
    }

    fn scale(&self, element: usize) -> Scale {
        self.elements[element].scale()
    }

    fn results(
        &self,
        element: usize,
        q: &[f64],
        _state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let linear = under.strains == Strains::Linear;
        self.elements[element].results(&array(q), linear, into);
    }
}
