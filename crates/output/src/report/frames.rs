//! Deformed states for the animation, thinned where there are many.

use crate::job::JobFiles;
use crate::outline;
use crate::reading::problem::{self, Problem, unreadable};
use crate::reading::state::{State, StateFile};
use crate::report::skin::{Triangle, is_volume, surface};

/// Kind of a solid, as files number it.
const SOLID: i32 = 4;
/// The field that says which cells are there.
const ACTIVE: &str = "active";
/// Most states that are drawn.
const MOST: usize = 201;
/// Most numbers that displacements may take.
const NUMBERS: usize = 100_000;

/// Shapes over the increments.
#[derive(Clone, Debug, Default)]
pub(crate) struct Frames {
    /// Numbers of nodes; 0 for points of rigid surfaces.
    pub labels: Vec<i64>,
    /// x and y of the undeformed points in turn.
    pub reference: Vec<f64>,
    /// Pairs of points that are joined: lines, and the edges of solids.
    pub cells: Vec<i64>,
    /// Kinds of what they belong to: 0 beam, 1 spring, 2 slave surface, 3 rigid
    /// surface, 4 solid.
    pub kinds: Vec<i32>,
    /// Numbers of elements.
    pub elements: Vec<i64>,
    /// Index of each pair's cell among those of the files.
    of_cell: Vec<usize>,
    /// The surface of solids, all of them there.
    pub skin: Vec<Triangle>,
    /// Where a step removes something: what is drawn without it.
    pub changes: Vec<Changed>,
    /// Of every frame the number of those that it is drawn by, from 1; 0: all is there. Empty
    /// where nothing is ever removed.
    pub changed: Vec<usize>,
    /// Whether solids fill space.
    pub in_space: bool,
    /// z of the undeformed points, where they do.
    pub depth: Vec<f64>,
    /// z of the displacements, frame by frame.
    pub depth_moved: Vec<Vec<f32>>,
    /// Mises stress and equivalent plastic strain at the points, frame by frame, where there are
    /// solids.
    pub values: [Vec<Vec<f32>>; 2],
    /// Which points of the files are drawn: of solids in space those of the surface.
    kept: Vec<usize>,
    /// Number of the state of each frame; 0 is the start.
    pub states: Vec<usize>,
    /// Numbers of all states that were written.
    pub written: Vec<usize>,
    /// x and y of the displacements in turn, frame by frame.
    pub displacement: Vec<Vec<f32>>,
    /// Bending moment and the outer stress of larger size, in turn, of every
    /// beam cell, frame by frame.
    pub sections: Vec<Vec<f32>>,
    /// Largest fibre strain that the frames show, with element and state.
    pub strain: Option<(f64, i64, usize)>,
}

/// What is drawn while something is absent.
#[derive(Clone, Debug, Default)]
pub(crate) struct Changed {
    /// Whether each cell of the files is there.
    there: Vec<bool>,
    /// The surface of the solids that are.
    pub skin: Vec<Triangle>,
}

impl Frames {
    /// Reads as many as can be drawn of the states `written`, ascending, that
    /// are among those `drawable`.
    pub fn read(
        job: &JobFiles,
        written: Vec<usize>,
        drawable: impl Fn(usize) -> bool,
    ) -> Result<Self, Problem> {
        let mut frames = Self::default();
        let Some(&first) = written.first() else { return Ok(frames) };
        let candidates: Vec<usize> =
            written.iter().copied().filter(|state| drawable(*state)).collect();
        frames.presence(job, first, &candidates)?;
        frames.topology(&open(job, first)?)?;
        let numbers = frames.reference.len() + frames.depth.len();
        for place in chosen(candidates.len().saturating_sub(1), numbers) {
            if let Some(&state) = candidates.get(place) {
                frames.add(&open(job, state)?, state)?;
            }
        }
        frames.written = written;
        Ok(frames)
    }

    /// Finds what is absent in the states, where the first one tells.
    fn presence(&mut self, job: &JobFiles, first: usize, all: &[usize]) -> Result<(), Problem> {
        if open(job, first)?.short(ACTIVE).is_err() {
            return Ok(());
        }
        for &state in all {
            self.change(there(&open(job, state)?)?);
        }
        Ok(())
    }

    /// Takes in what is there in some states, before [`topology`](Self::topology).
    pub fn change(&mut self, there: Vec<bool>) {
        let known = self.changes.iter().any(|own| own.there == there);
        if !known && there.contains(&false) {
            self.changes.push(Changed { there, skin: Vec::new() });
        }
    }

    /// Pairs of points whose cell is absent, of what is drawn while something is.
    pub fn gone(&self, changed: &Changed) -> Vec<usize> {
        let cells = self.of_cell.iter().enumerate();
        let gone = cells.filter(|(_, cell)| changed.there.get(**cell) == Some(&false));
        gone.map(|(pair, _)| pair).collect()
    }

    /// Takes in what all states have alike.
    pub fn topology(&mut self, file: &impl State) -> Result<(), Problem> {
        let (positions, moved) = (file.doubles("Points")?, file.doubles("displacement")?);
        let still: Vec<f64> = positions.iter().zip(&moved).map(|(x, u)| x - u).collect();
        self.labels = file.long("node")?;
        let (connectivity, ends) = (file.long("connectivity")?, file.long("offsets")?);
        let (kinds, elements) = (file.short("kind")?, file.long("element")?);
        let types = file.tiny("types")?;
        let points = still.len() / 3;
        let inside = |point: &i64| usize::try_from(*point).is_ok_and(|point| point < points);
        let fits = self.labels.len() == points
            && ends.len() == kinds.len()
            && types.len() == kinds.len()
            && elements.len() == kinds.len()
            && connectivity.iter().all(inside);
        let mut cells: Vec<(usize, (u8, &[i64]))> = Vec::new();
        let mut begin = 0;
        for (cell, (end, (&kind, &element))) in
            ends.iter().zip(kinds.iter().zip(&elements)).enumerate()
        {
            let end = usize::try_from(*end).unwrap_or(0);
            let points = connectivity.get(begin..end).unwrap_or_default();
            let shape = types.get(cell).copied().unwrap_or_default();
            if kind == SOLID {
                cells.push((cell, (shape, points)));
            }
            // what fills space is drawn by its surface
            let edges = if is_volume(shape) { &[][..] } else { outline::edges(shape) };
            self.join((points, edges), (cell, kind, element));
            begin = end;
        }
        if fits {
            self.skin = surface(cells.iter().map(|(_, own)| *own), &self.labels);
            for changed in &mut self.changes {
                let there = |(cell, _): &&(usize, _)| changed.there.get(*cell) != Some(&false);
                let own = cells.iter().filter(there).map(|(_, own)| *own);
                changed.skin = surface(own, &self.labels);
            }
            self.in_space = cells.iter().any(|(_, (shape, _))| is_volume(*shape));
            let inner = cells.iter().filter(|(_, (shape, _))| is_volume(*shape));
            self.keep(&still, inner.flat_map(|(_, (_, points))| points.iter().copied()));
        }
        let whole = fits && begin == connectivity.len();
        let fault = || unreadable(file.path(), "its arrays do not fit one another");
        if whole { Ok(()) } else { Err(fault()) }
    }

    /// Leaves the points out that are `inside` of solids in space, and numbers the others anew.
    fn keep(&mut self, still: &[f64], inside: impl Iterator<Item = i64>) {
        let mut is_kept = vec![true; still.len() / 3];
        let place = |point: i64| usize::try_from(point).unwrap_or(usize::MAX);
        for point in inside {
            if let Some(own) = is_kept.get_mut(place(point)) {
                *own = false;
            }
        }
        let skins = self.changes.iter().map(|own| &own.skin).chain([&self.skin]);
        let drawn: Vec<usize> = skins.flatten().flat_map(|(points, _)| *points).collect();
        for point in drawn.into_iter().chain(self.cells.iter().map(|&point| place(point))) {
            if let Some(own) = is_kept.get_mut(point) {
                *own = true;
            }
        }
        self.kept = (0..is_kept.len()).filter(|point| is_kept[*point]).collect();
        let mut number = vec![0; is_kept.len()];
        self.kept.iter().enumerate().for_each(|(new, &old)| number[old] = new);
        self.labels = self.kept.iter().filter_map(|&old| self.labels.get(old).copied()).collect();
        let skins = self.changes.iter_mut().map(|own| &mut own.skin).chain([&mut self.skin]);
        skins.flatten().for_each(|(points, _)| *points = points.map(|old| number[old]));
        let new = |old: &i64| number.get(place(*old)).map_or(0, |new| *new as i64);
        self.cells = self.cells.iter().map(new).collect();
        self.reference = self.along(still, &[0, 1]);
        self.depth = if self.in_space { self.along(still, &[2]) } else { Vec::new() };
    }

    /// Some coordinates of the points that are drawn, point by point.
    fn along(&self, values: &[f64], axes: &[usize]) -> Vec<f64> {
        let own = |&point: &usize| axes.iter().map(move |axis| values[3 * point + axis]);
        self.kept.iter().flat_map(own).collect()
    }

    /// Takes in the edges of a cell.
    fn join(
        &mut self,
        (points, edges): (&[i64], &[&[usize]]),
        (cell, kind, element): (usize, i32, i64),
    ) {
        for ends in edges.iter().flat_map(|edge| edge.windows(2)) {
            let [Some(from), Some(to)] = [ends[0], ends[1]].map(|end| points.get(end)) else {
                continue;
            };
            self.cells.extend([from, to]);
            self.kinds.push(kind);
            self.elements.push(element);
            self.of_cell.push(cell);
        }
    }

    /// Takes a state in.
    pub fn add(&mut self, file: &impl State, state: usize) -> Result<(), Problem> {
        let moved = file.doubles("displacement")?;
        if self.kept.last().is_some_and(|last| 3 * last + 2 >= moved.len()) {
            return Err(unreadable(file.path(), "it has other points than the first state"));
        }
        let fibre_strain = file.doubles("fibre_strain")?;
        for (&cell, &element) in self.of_cell.iter().zip(&self.elements) {
            let value = fibre_strain.get(cell).copied().unwrap_or_default();
            if value > 0.0 && self.strain.is_none_or(|(largest, ..)| value > largest) {
                self.strain = Some((value, element, state));
            }
        }
        let [moment, first, last] =
            ["bending_moment", "S11_1", "S11_5"].map(|name| file.doubles(name));
        let (moment, first, last) = (moment?, first?, last?);
        let outer = |cell: usize| {
            if last[cell].abs() > first[cell].abs() { last[cell] } else { first[cell] }
        };
        let cells = self.of_cell.last().map_or(0, |last| last + 1);
        let short = [&moment, &first, &last].iter().any(|column| column.len() < cells);
        let beams = self.of_cell.iter().zip(&self.kinds).filter(|(_, kind)| **kind == 0 && !short);
        let beams = beams.map(|(&cell, _)| cell);
        let values = beams.flat_map(|cell| [moment[cell] as f32, outer(cell) as f32]);
        self.sections.push(values.collect());
        self.states.push(state);
        if !self.changes.is_empty() {
            let there = there(file)?;
            let known = self.changes.iter().position(|own| own.there == there);
            self.changed.push(known.map_or(0, |known| known + 1));
        }
        let short = |values: Vec<f64>| values.into_iter().map(|value| value as f32).collect();
        self.displacement.push(short(self.along(&moved, &[0, 1])));
        if self.in_space {
            self.depth_moved.push(short(self.along(&moved, &[2])));
        }
        if !self.skin.is_empty() {
            for (values, name) in self.values.iter_mut().zip(["mises_stress", "plastic_strain"]) {
                // earlier versions wrote none
                let Ok(own) = file.doubles(name) else { continue };
                let at = |point: &usize| own.get(*point).map_or(f32::NAN, |value| *value as f32);
                values.push(self.kept.iter().map(at).collect());
            }
        }
        Ok(())
    }
}

fn open(job: &JobFiles, state: usize) -> Result<StateFile, Problem> {
    StateFile::open(&job.folder().join(job.state_name(state)))
}

/// Whether each cell of a state is there.
fn there(file: &impl State) -> Result<Vec<bool>, Problem> {
    Ok(file.short(ACTIVE)?.into_iter().map(|own| own != 0).collect())
}

/// Numbers of the states that a job has, of at most `last` increments. A job
/// that is over lists them, one that is not may be ahead of its list.
///
/// # Errors
/// A list that is missing, foreign, or shorter or longer than `expected`.
pub(crate) fn written(
    job: &JobFiles,
    last: usize,
    expected: Option<usize>,
) -> Result<Vec<usize>, Problem> {
    let Some(expected) = expected else {
        let mut numbers = job.states().map_err(Problem::Write)?;
        numbers.retain(|number| *number <= last);
        return Ok(numbers);
    };
    if expected == 0 {
        return Ok(Vec::new());
    }
    let path = job.path(".pvd");
    let list = problem::text(&path)?;
    if !list.contains("<VTKFile type=\"Collection\"") {
        return Err(unreadable(&path, "it is not a list written by this program"));
    }
    let files = list.split("<DataSet ").skip(1);
    let number = |entry: &str| -> Option<usize> {
        let (before, _) = entry.split_once(".vtu\"")?;
        before.rsplit_once('_')?.1.parse().ok()
    };
    let numbers: Vec<usize> = files.map_while(number).collect();
    if numbers.len() != expected {
        let found = numbers.len();
        return Err(unreadable(&path, format!("it lists {found} states instead of {expected}")));
    }
    match numbers.is_sorted_by(|a, b| a < b) && numbers.last().is_some_and(|most| *most <= last) {
        true => Ok(numbers),
        false => Err(unreadable(&path, "its states are not those of this job")),
    }
}

/// Places of the states to draw, first and last among them.
fn chosen(last: usize, numbers: usize) -> Vec<usize> {
    let most = (NUMBERS / numbers.max(1)).clamp(2, MOST);
    if last < most {
        return (0..=last).collect();
    }
    let mut states: Vec<usize> = (0..most).map(|frame| frame * last / (most - 1)).collect();
    states.dedup();
    states
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_thinned_evenly_between_the_first_and_the_last() {
        assert_eq!(chosen(3, 100), [0, 1, 2, 3]);
        let many = chosen(1000, 100);
        assert_eq!((many.len(), many[0], many[200]), (MOST, 0, 1000));
        assert!(many.windows(2).all(|pair| pair[1] - pair[0] == 5));
        assert_eq!(chosen(1000, 1_000_000), [0, 1000]);
    }
}
