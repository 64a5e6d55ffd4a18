//! Parts that grew cell by cell, with steps, hooks, hollows and walls one cell thick, beside one another.
//!
//! ```text
//!        _____              one cell at least between them everywhere
//!       |_   _|   ___
//!      __| |_    |   |_     apart:    what moves comes no nearer than a part of that gap
//!     |______|   |_____|    stepped:  it is pressed on the other by more than the gap
//! ```

use super::choices::{kinds, laws};
use super::draft::{Draft, Material, Pair, Skins, Step, Surface, World};
use super::mesh::{Kind, Part};
use crate::random::Sequence;
use crate::random::classes::Promise;
use std::collections::BTreeSet;

/// A place of the lattice.
type Place = [usize; 3];
type Cells = BTreeSet<Place>;

/// How far the moved part comes, in gaps, where the parts stay apart [1].
const APART: f64 = 0.06;
/// How far it comes where it is pressed on the other one [1].
const PRESSED: f64 = 1.4;

/// Places beside one another.
fn beside([a, b, c]: Place) -> impl Iterator<Item = Place> {
    let along = move |axis: usize, up: bool| {
        let mut at = [a, b, c];
        at[axis] = if up { at[axis] + 1 } else { at[axis].checked_sub(1)? };
        Some(at)
    };
    (0..3).flat_map(move |axis| [along(axis, false), along(axis, true)]).flatten()
}

/// Places at most one away along every axis, the place itself as well.
fn about(place: Place) -> impl Iterator<Item = Place> {
    let ways = (0..27).map(|k: usize| [k % 3, k / 3 % 3, k / 9]);
    ways.filter_map(move |way| {
        let at = |k: usize| (place[k] + way[k]).checked_sub(1);
        Some([at(0)?, at(1)?, at(2)?])
    })
}

/// Adds cells beside those that are there, of those that are free, up to so many.
fn grow(cells: &mut Cells, count: usize, free: &Cells, s: &mut Sequence) {
    for _ in 0..40 * count {
        if cells.len() >= count {
            return;
        }
        let around: Vec<Place> = cells.iter().copied().flat_map(beside).collect();
        let next = s.one_of(&around);
        if free.contains(&next) {
            cells.insert(next);
        }
    }
}

/// Adds cells where two touch at an edge or a corner alone, until none do.
fn joined(mut cells: Cells) -> Cells {
    while let Some(between) = cells.iter().find_map(|&cell| loose(&cells, cell)) {
        cells.insert(between);
    }
    cells
}

/// A free place between a cell and one that touches it at an edge or a corner alone.
fn loose(cells: &Cells, cell: Place) -> Option<Place> {
    about(cell).filter(|other| cells.contains(other)).find_map(|other| {
        let within = |at: &Place| (0..3).all(|k| at[k] == cell[k] || at[k] == other[k]);
        let mut reached = Cells::from([cell]);
        loop {
            let next: Cells = reached.iter().copied().flat_map(beside).filter(within).collect();
            let before = reached.len();
            reached.extend(next.iter().filter(|at| cells.contains(*at)));
            if reached.contains(&other) {
                return None;
            }
            if reached.len() == before {
                return next.into_iter().find(|at| !cells.contains(at));
            }
        }
    })
}

/// Cells of two parts with a cell at least between them everywhere.
fn two(ends: Place, s: &mut Sequence) -> [Cells; 2] {
    let all: Cells = (0..ends[0])
        .flat_map(|a| (0..ends[1]).flat_map(move |b| (0..ends[2]).map(move |c| [a, b, c])))
        .collect();
    loop {
        let mut first = Cells::from([ends.map(|end| end / 2)]);
        grow(&mut first, 6 + s.below(14), &all, s);
        let first = joined(first);
        let near: Cells = first.iter().copied().flat_map(about).collect();
        let free: Vec<Place> = all.difference(&near).copied().collect();
        if free.is_empty() {
            continue;
        }
        let mut second = Cells::from([s.one_of(&free)]);
        grow(&mut second, 18, &free.into_iter().collect(), s);
        let second = joined(second);
        if second.len() >= 5 && second.is_disjoint(&near) {
            return [first, second];
        }
    }
}

fn middle(cells: &Cells) -> [f64; 3] {
    [0, 1, 2].map(|k| cells.iter().map(|at| at[k] as f64).sum::<f64>() / cells.len() as f64)
}

/// Two parts, the first held at one end and the second moved at another one; `gaps`: how far.
fn draw(gaps: f64, s: &mut Sequence) -> Draft {
    let world = s.one_of(&[World::Plane, World::Plane, World::Space]);
    let mut draft = Draft::new(world);
    // rows of single C3D20R have motions without energy
    let known = kinds(world, s).iter().copied().filter(|kind| kind.name != "C3D20R");
    let known: Vec<Kind> = known.collect();
    let dimension = draft.dimension();
    let cells = two(if dimension == 3 { [9, 7, 5] } else { [14, 10, 1] }, s);
    let (bend, sides) =
        (s.one_of(&[0.0, 0.0, 0.1, 0.2]), [0; 3].map(|_| s.one_of(&[0.5, 1.0, 2.0])));
    let flat = dimension == 2;
    // bends of the lattice leave cells of the parts and of the gap between them far from folding
    let place = |[x, y, z]: [f64; 3]| {
        let third = if flat { 0.0 } else { z };
        let bent = [
            x + bend * (2.1 * y + 0.7 * third).sin(),
            y + bend * (1.7 * x + 0.4).sin(),
            third + if flat { 0.0 } else { bend * (1.3 * x + y).sin() },
        ];
        [0, 1, 2].map(|k| sides[k] * bent[k])
    };
    for own in &cells {
        let part = Part::of(s.one_of(&known), own.iter().copied(), &mut draft.nodes, place);
        draft.parts.push((part, Material::Elastic(s.power(-0.5, 0.5), s.between(0.0, 0.4))));
    }
    draft.thickness = if flat { s.power(-1.0, 1.0) } else { 1.0 };
    draft.general = s.below(2) == 0;
    draft.skins = Skins::Whole;
    let faces = [0, 1].map(|part| Surface::Side(part, (0, true)));
    let slave = s.below(2);
    let mortar = s.below(2) == 0;
    draft.pairs.push(Pair { slave: faces[slave], master: faces[1 - slave], mortar });
    laws(&mut draft, 0.4, s);
    let towards = [0, 1, 2].map(|k| middle(&cells[0])[k] - middle(&cells[1])[k]);
    let mut way: [f64; 3] =
        std::array::from_fn(|k| if k < dimension { s.between(-1.0, 1.0) } else { 0.0 });
    if (0..3).map(|k| way[k] * towards[k]).sum::<f64>() < 0.0 {
        way = way.map(|part| -part);
    }
    let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
    let least = sides[..dimension].iter().copied().fold(f64::MAX, f64::min);
    let goal = [0, 1, 2].map(|k| (k < dimension).then_some(gaps * least * way[k] / length));
    let grip = (s.below(dimension), s.below(2) == 0);
    let still = [0, 1, 2].map(|k| (k < dimension).then_some(0.0));
    draft.steps = vec![Step {
        increments: [0.05, 1e-5, 0.1],
        motions: vec![(draft.side(0, (0, false)), still), (draft.side(1, grip), goal)],
        ..Step::default()
    }];
    draft
}

/// Two parts that stay apart.
pub(super) fn apart(s: &mut Sequence) -> Draft {
    let mut draft = draw(APART, s);
    draft.apart = true;
    draft
}

/// Two parts pressed on one another, however they meet: some are driven into what cannot give way.
pub(super) fn pressed(s: &mut Sequence) -> Draft {
    let mut draft = draw(PRESSED, s);
    draft.promise = Promise::Risky;
    draft
}
