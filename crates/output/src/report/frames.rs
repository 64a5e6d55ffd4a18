//! Deformed states for the animation, thinned where there are many.

use super::problem::{Problem, unreadable};
use super::state::StateFile;
use crate::job::JobFiles;

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
    /// Pairs of points that are joined.
    pub cells: Vec<i64>,
    /// Kinds of cells: 0 beam, 1 spring, 2 slave surface, 3 rigid surface.
    pub kinds: Vec<i32>,
    /// Numbers of elements.
    pub elements: Vec<i64>,
    /// Number of the state of each frame; 0 is the start.
    pub states: Vec<usize>,
    /// x and y of the displacements in turn, frame by frame.
    pub displacement: Vec<Vec<f32>>,
    /// Largest fibre strain that the frames show, with element and state.
    pub strain: Option<(f64, i64, usize)>,
}

impl Frames {
    /// Reads the start and of `candidates`, ascending, as many as can be drawn.
    /// States that are missing are left out if `lenient`.
    pub fn read(job: &JobFiles, candidates: &[usize], lenient: bool) -> Result<Self, Problem> {
        let mut frames = Self::default();
        let first = match frames.open(job, 0) {
            Ok(file) => file,
            Err(Problem::Missing(_)) if lenient => return Ok(frames),
            Err(problem) => return Err(problem),
        };
        frames.topology(job, &first)?;
        for place in chosen(candidates.len().saturating_sub(1), frames.reference.len()) {
            let state = candidates[place];
            let file = match frames.open(job, state) {
                Err(Problem::Missing(_)) if lenient => continue,
                other => other?,
            };
            frames.add(job, state, &file)?;
        }
        Ok(frames)
    }

    fn open(&self, job: &JobFiles, state: usize) -> Result<StateFile, Problem> {
        StateFile::open(&job.folder().join(job.state_name(state)))
    }

    fn topology(&mut self, job: &JobFiles, file: &StateFile) -> Result<(), Problem> {
        let positions = plane(&file.doubles("Points")?);
        let moved = plane(&file.doubles("displacement")?);
        self.reference = positions.iter().zip(&moved).map(|(x, u)| x - u).collect();
        self.labels = file.long("node")?;
        self.cells = file.long("connectivity")?;
        self.kinds = file.short("kind")?;
        self.elements = file.long("element")?;
        let points = self.reference.len() / 2;
        let inside = |point: &i64| usize::try_from(*point).is_ok_and(|point| point < points);
        let fits = self.labels.len() == points
            && self.cells.len() == 2 * self.kinds.len()
            && self.elements.len() == self.kinds.len()
            && self.cells.iter().all(inside);
        let path = job.folder().join(job.state_name(0));
        if fits { Ok(()) } else { Err(unreadable(&path, "its arrays do not fit one another")) }
    }

    fn add(&mut self, job: &JobFiles, state: usize, file: &StateFile) -> Result<(), Problem> {
        let moved = plane(&file.doubles("displacement")?);
        if moved.len() != self.reference.len() {
            let path = job.folder().join(job.state_name(state));
            return Err(unreadable(&path, "it has other points than the first state"));
        }
        for (value, &element) in file.doubles("fibre_strain")?.iter().zip(&self.elements) {
            if *value > 0.0 && self.strain.is_none_or(|(largest, ..)| *value > largest) {
                self.strain = Some((*value, element, state));
            }
        }
        self.states.push(state);
        self.displacement.push(moved.into_iter().map(|u| u as f32).collect());
        Ok(())
    }
}

/// x and y of every point.
fn plane(values: &[f64]) -> Vec<f64> {
    values.as_chunks::<3>().0.iter().flat_map(|point| [point[0], point[1]]).collect()
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
