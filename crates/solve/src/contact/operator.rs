//! The contact operator: how overclosure, slip and forces of points follow unknowns.
//!
//! ```text
//!             unknowns of point i
//!           +---------------------+
//!   normal  | dh/du               |   1 row
//!   slip    | d sigma_k/du        |   a row a tangential direction
//!   force   | direction of tau_k  |   a row a tangential direction
//!           +---------------------+
//! ```
//!
//! Sparse rows over any number of unknowns, all in one list: a point takes room when the
//! operator is made or when it is added, and none in an iteration. In the plane there is one
//! tangential direction, in space there are two.

/// Rows of many points over dofs, or over equations.
#[derive(Clone, Debug, Default)]
pub struct ContactOperator {
    directions: usize,
    /// Where the unknowns of every point begin, and how many they are.
    ranges: Vec<(usize, usize)>,
    unknowns: Vec<usize>,
    /// The rows, point by point and row by row.
    values: Vec<f64>,
}

/// The rows of one point.
#[derive(Clone, Copy, Debug)]
pub struct OperatorRows<'a> {
    directions: usize,
    /// Unknowns that the point follows.
    pub unknowns: &'a [usize],
    values: &'a [f64],
}

/// The rows of one point, to be written.
#[derive(Debug)]
pub struct OperatorRowsMut<'a> {
    width: &'a mut usize,
    unknowns: &'a mut [usize],
    values: &'a mut [f64],
}

impl ContactOperator {
    /// Becomes an operator of points that follow at most `room` unknowns each, and none yet.
    pub fn fit(&mut self, points: usize, room: usize, directions: usize) {
        self.clear(directions);
        self.ranges.extend((0..points).map(|place| (place * room, 0)));
        self.unknowns.resize(points * room, 0);
        self.values.resize(points * room * rows(directions), 0.0);
    }

    /// Makes room for so many unknowns at every point, of which all have the same room.
    pub fn make_room(&mut self, unknowns: usize) {
        let points = self.ranges.len();
        let room = self.unknowns.len() / points.max(1);
        if unknowns <= room {
            return;
        }
        let before = std::mem::take(self);
        self.fit(points, 2 * unknowns, before.directions);
        for place in 0..points {
            let from = before.rows(place);
            if from.width() > 0 {
                self.rows_mut(place).start(from.unknowns).copy_from_slice(from.values);
            }
        }
    }

    /// Tangential directions of a point.
    pub fn directions(&self) -> usize {
        self.directions
    }

    /// Forgets all points, and how many directions they have.
    pub fn clear(&mut self, directions: usize) {
        self.directions = directions;
        self.ranges.clear();
        self.unknowns.clear();
        self.values.clear();
    }

    /// Room for so many points of so many unknowns each.
    pub fn reserve(&mut self, points: usize, unknowns: usize) {
        self.ranges.reserve(points);
        self.unknowns.reserve(points * unknowns);
        self.values.reserve(points * unknowns * rows(self.directions.max(1)));
    }

    /// Adds a point with its rows over these unknowns, given unknown by unknown.
    pub fn push_columns(&mut self, unknowns: &[usize], columns: &[f64]) {
        self.ranges.push((self.unknowns.len(), unknowns.len()));
        self.unknowns.extend_from_slice(unknowns);
        let count = rows(self.directions);
        for row in 0..count {
            self.values.extend(columns.chunks_exact(count).map(|column| column[row]));
        }
    }

    /// Lets nothing move a point along its tangents.
    pub fn hold_slip(&mut self, place: usize) {
        let (begin, width) = self.ranges[place];
        let first = begin * rows(self.directions) + width;
        self.values[first..][..self.directions * width].fill(0.0);
    }

    /// The same, given row by row.
    #[cfg(test)]
    pub fn push_rows(&mut self, unknowns: &[usize], rows: &[f64]) {
        self.ranges.push((self.unknowns.len(), unknowns.len()));
        self.unknowns.extend_from_slice(unknowns);
        self.values.extend_from_slice(rows);
    }

    /// The rows of a point.
    pub fn rows(&self, place: usize) -> OperatorRows<'_> {
        let (begin, width) = self.ranges[place];
        OperatorRows {
            directions: self.directions,
            unknowns: &self.unknowns[begin..][..width],
            values: &self.values[begin * rows(self.directions)..][..width * rows(self.directions)],
        }
    }

    /// The rows of a point, to be written.
    pub fn rows_mut(&mut self, place: usize) -> OperatorRowsMut<'_> {
        let (begin, _) = self.ranges[place];
        let end = self.ranges.get(place + 1).map_or(self.unknowns.len(), |(next, _)| *next);
        let count = rows(self.directions);
        OperatorRowsMut {
            width: &mut self.ranges[place].1,
            unknowns: &mut self.unknowns[begin..end],
            values: &mut self.values[begin * count..end * count],
        }
    }

    /// Takes over another operator, room kept.
    pub fn copy_from(&mut self, other: &Self) {
        self.directions = other.directions;
        self.ranges.clone_from(&other.ranges);
        self.unknowns.clone_from(&other.unknowns);
        self.values.clone_from(&other.values);
    }
}

/// Rows of a point with so many tangential directions.
const fn rows(directions: usize) -> usize {
    1 + 2 * directions
}

impl<'a> OperatorRows<'a> {
    /// Number of unknowns.
    pub fn width(&self) -> usize {
        self.unknowns.len()
    }

    /// Number of tangential directions.
    pub fn directions(&self) -> usize {
        self.directions
    }

    /// All derivatives by an unknown: overclosure, slips, forces.
    pub fn column(&self, unknown: usize) -> impl Iterator<Item = f64> + use<'a> {
        let (values, width) = (self.values, self.width());
        (0..rows(self.directions)).map(move |row| values[row * width + unknown])
    }

    /// dh/du of each unknown [1].
    pub fn normal(&self) -> &'a [f64] {
        &self.values[..self.width()]
    }

    /// d sigma/du of each unknown, along a tangential direction [1].
    pub fn slip(&self, direction: usize) -> &'a [f64] {
        &self.values[(1 + direction) * self.width()..][..self.width()]
    }

    /// Direction of the force of a traction on each unknown [1].
    pub fn force(&self, direction: usize) -> &'a [f64] {
        &self.values[(1 + self.directions + direction) * self.width()..][..self.width()]
    }
}

impl<'a> OperatorRowsMut<'a> {
    /// The point follows nothing.
    pub fn clear(&mut self) {
        *self.width = 0;
    }

    /// The rows over these unknowns, all zero: normal, slip and force.
    pub fn start(&mut self, unknowns: &[usize]) -> &mut [f64] {
        let width = unknowns.len();
        *self.width = width;
        self.unknowns[..width].copy_from_slice(unknowns);
        let count = self.values.len() / self.unknowns.len().max(1);
        let values = &mut self.values[..count * width];
        values.fill(0.0);
        values
    }

    /// The unknowns.
    pub fn unknowns(&self) -> &[usize] {
        &self.unknowns[..*self.width]
    }

    /// The rows, to be written.
    pub fn values(&mut self) -> &mut [f64] {
        let count = self.values.len() / self.unknowns.len().max(1);
        &mut self.values[..count * *self.width]
    }
}
