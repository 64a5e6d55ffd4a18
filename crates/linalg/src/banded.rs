//! Banded back end: band factorisation and dense border.
//!
//! ```text
//!   | A  B | |x|   |f|      A banded, B and C few columns and rows (border)
//!   | C  D | |y| = |g|      S = D - C inv(A) B,  S y = g - C inv(A) f,  x = inv(A)(f - B y)
//! ```

use crate::band_ldlt::{BandLdlt, Pivots};
use crate::band_lu::{BandLu, SmallestPivot};
use crate::border::Border;
use crate::error::{FactorReport, SolveError};
use crate::kernel::LANES;
use crate::ordering::{Layout, positions};
use crate::pattern::{Matrix, Pattern};
use crate::scaling::equilibrate;
use crate::system::{BackEnd, Description, Kind, LinearSystem};

/// Pivot ratio below which the unpivoted symmetric factorisation gives way to partial pivoting.
const SMALLEST_SYMMETRIC: f64 = 1e-13;
/// Pivot ratio below which the system is scaled and factored again.
const SUSPICIOUS: f64 = 1e-12;
/// Pivot ratio of the scaled system below which it is singular: what a few hundred roundings leave.
const SINGULAR: f64 = 1e-14;

/// Right-hand sides that are left over and substituted together all the same.
const PAIR: usize = 2;

/// Which of its factorisations the back end holds.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Held {
    Nothing,
    Symmetric,
    Pivoted { scaled: bool },
    Wide,
}

/// Banded back end.
pub(crate) struct Banded {
    layout: Layout,
    kind: Kind,
    ldlt: BandLdlt,
    ldlt_place: Vec<u32>,
    lu: BandLu,
    lu_place: Vec<u32>,
    border: Option<Border>,
    held: Held,
    size: Vec<f64>,
    scale: Vec<f64>,
    scaled_values: Vec<f64>,
    work: Vec<f64>,
    /// The same system without a border, for bands that are singular without it.
    wide: Option<Box<Banded>>,
}

impl Banded {
    pub fn new(pattern: &Pattern, kind: Kind, layout: Layout) -> Self {
        let n = pattern.size();
        let place = positions(n, &layout.order);
        let (band, width) = (layout.band, layout.half_bandwidth);
        let symmetric = kind == Kind::Symmetric;
        let ldlt = if symmetric { BandLdlt::new(band, width) } else { BandLdlt::default() };
        let within = |i: usize, j: usize| place[i] < band && place[j] < band;
        let ldlt_place = match symmetric {
            true => entry_places(pattern, |i, j| match within(i, j) && place[i] >= place[j] {
                true => ldlt.place(place[i], place[j]),
                false => ldlt.nowhere(),
            }),
            false => Vec::new(),
        };
        let border = (band < n).then(|| Border::new(pattern, &place, band));
        let mut banded = Self {
            layout,
            kind,
            ldlt,
            ldlt_place,
            lu: BandLu::default(),
            lu_place: Vec::new(),
            border,
            held: Held::Nothing,
            size: vec![0.0; n],
            scale: vec![1.0; n],
            scaled_values: Vec::new(),
            work: vec![0.0; n],
            wide: None,
        };
        if !symmetric {
            banded.prepare_pivoted(pattern);
        }
        banded
    }

    /// Memory for partial pivoting, which symmetric systems seldom need.
    fn prepare_pivoted(&mut self, pattern: &Pattern) {
        if self.lu_place.len() == pattern.entries() {
            return;
        }
        let (band, width) = (self.layout.band, self.layout.half_bandwidth);
        let place = positions(pattern.size(), &self.layout.order);
        let lu = BandLu::new(band, width);
        self.lu_place = entry_places(pattern, |i, j| match place[i] < band && place[j] < band {
            true => lu.place(place[i], place[j]),
            false => lu.nowhere(),
        });
        self.lu = lu;
    }

    fn scatter_pivoted(&mut self, pattern: &Pattern, values: &[f64]) {
        self.prepare_pivoted(pattern);
        scatter(values, &self.lu_place, self.lu.clear());
    }

    fn set_sizes(&mut self, row_size: &[f64]) {
        for (size, &i) in self.size.iter_mut().zip(&self.layout.order) {
            *size = row_size[i];
        }
    }

    /// Symmetric factorisation; `None` when it would not be safe.
    fn factor_symmetric(&mut self, values: &[f64]) -> Option<FactorReport> {
        let (band, size) = (self.layout.band, &self.size);
        let mut pivots = self.ldlt.factor(|j| size[j])?;
        if pivots.smallest_ratio < SMALLEST_SYMMETRIC {
            return None;
        }
        if let Some(border) = &mut self.border {
            border.load(values);
            border.reduce(|x| self.ldlt.solve(x));
            let inertia = border.factor_symmetric(|j| size[band + j])?;
            let pivoted = border.factor(|j| size[band + j]);
            if inertia.smallest_ratio < SMALLEST_SYMMETRIC || pivoted.ratio < SUSPICIOUS {
                return None;
            }
            pivots = join(pivots, inertia, band);
        }
        Some(FactorReport {
            negative_pivots: Some(pivots.negative),
            smallest_pivot_ratio: pivots.smallest_ratio,
            smallest_pivot: self.layout.order[pivots.smallest],
        })
    }

    /// Factorisation with partial pivoting; a ratio of zero means that it came to a stop.
    fn factor_pivoted(&mut self, values: &[f64]) -> SmallestPivot {
        let (band, size) = (self.layout.band, &self.size);
        let mut smallest = self.lu.factor(|j| size[j]);
        if let Some(border) = self.border.as_mut().filter(|_| smallest.ratio > 0.0) {
            border.load(values);
            border.reduce(|x| self.lu.solve(x));
            let last = border.factor(|j| size[band + j]);
            if last.ratio < smallest.ratio {
                smallest = SmallestPivot { ratio: last.ratio, at: band + last.at };
            }
        }
        smallest
    }

    fn factor_scaled(&mut self, matrix: Matrix<'_>) -> SmallestPivot {
        let n = self.size.len();
        equilibrate(matrix, &mut self.scale, &mut self.work[..n]);
        let mut scaled = std::mem::take(&mut self.scaled_values);
        scaled.resize(matrix.values.len(), 0.0);
        for (at, &i) in self.layout.order.iter().enumerate() {
            let (columns, values) = matrix.row(i);
            let start = matrix.pattern.row_start()[i];
            self.size[at] = 0.0;
            for (p, (&j, &a)) in columns.iter().zip(values).enumerate() {
                let value = a * self.scale[i] * self.scale[j];
                scaled[start + p] = value;
                self.size[at] += value.abs();
            }
        }
        self.scatter_pivoted(matrix.pattern, &scaled);
        let smallest = self.factor_pivoted(&scaled);
        self.scaled_values = scaled;
        smallest
    }

    fn report(&self, smallest: SmallestPivot) -> FactorReport {
        FactorReport {
            negative_pivots: None,
            smallest_pivot_ratio: smallest.ratio,
            smallest_pivot: self.layout.order[smallest.at],
        }
    }

    fn factor_wide(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError> {
        let wide = self.wide.get_or_insert_with(|| {
            let layout = Layout::with_border(matrix.pattern, &[]);
            Box::new(Banded::new(matrix.pattern, Kind::Unsymmetric, layout))
        });
        wide.scatter(matrix);
        let report = wide.factor(matrix, row_size)?;
        self.held = Held::Wide;
        Ok(report)
    }

    /// Solves for M right-hand sides of a block, interleaved.
    fn solve_lanes<const M: usize>(&mut self, block: &mut [f64], transposed: bool) {
        let n = self.layout.order.len();
        let scaled = self.held == Held::Pivoted { scaled: true };
        let held = self.held;
        let Self { layout, ldlt, lu, border, work, scale, .. } = self;
        let work = &mut work.as_chunks_mut::<M>().0[..n];
        for (w, &i) in work.iter_mut().zip(&layout.order) {
            let factor = if scaled { scale[i] } else { 1.0 };
            for (lane, w) in w.iter_mut().enumerate() {
                *w = block[lane * n + i] * factor;
            }
        }
        let (x, y) = work.split_at_mut(layout.band);
        match (held, transposed) {
            (Held::Symmetric, false) => ldlt.solve(x),
            (_, false) => lu.solve(x),
            _ => {}
        }
        match (border, transposed) {
            (Some(border), false) => border.solve(x, y),
            (Some(border), true) => border.solve_transpose(x, y),
            _ => {}
        }
        match (held, transposed) {
            (Held::Symmetric, true) => ldlt.solve(x),
            (_, true) => lu.solve_transpose(x),
            _ => {}
        }
        for (w, &i) in work.iter().zip(&layout.order) {
            let factor = if scaled { scale[i] } else { 1.0 };
            for (lane, w) in w.iter().enumerate() {
                block[lane * n + i] = w * factor;
            }
        }
    }

    fn solve_block(
        &mut self,
        block: &mut [f64],
        columns: usize,
        transposed: bool,
    ) -> Result<(), SolveError> {
        if let (Held::Wide, Some(wide)) = (self.held, &mut self.wide) {
            return wide.solve_block(block, columns, transposed);
        }
        let n = self.layout.order.len();
        if n == 0 || columns == 0 {
            return Ok(());
        }
        if self.held == Held::Nothing {
            return Err(SolveError::NotFactored);
        }
        if columns >= PAIR && self.work.len() < n * LANES {
            self.work.resize(n * LANES, 0.0);
        }
        let mut whole = block.chunks_exact_mut(n * LANES);
        (&mut whole).for_each(|lanes| self.solve_lanes::<LANES>(lanes, transposed));
        let mut pairs = whole.into_remainder().chunks_exact_mut(n * PAIR);
        (&mut pairs).for_each(|lanes| self.solve_lanes::<PAIR>(lanes, transposed));
        match pairs.into_remainder() {
            [] => {}
            column => self.solve_lanes::<1>(column, transposed),
        }
        Ok(())
    }
}

impl LinearSystem for Banded {
    fn scatter(&mut self, matrix: Matrix<'_>) {
        self.held = Held::Nothing;
        match self.kind {
            Kind::Symmetric => scatter(matrix.values, &self.ldlt_place, self.ldlt.clear()),
            Kind::Unsymmetric => scatter(matrix.values, &self.lu_place, self.lu.clear()),
        }
    }

    fn factor(&mut self, matrix: Matrix<'_>, row_size: &[f64]) -> Result<FactorReport, SolveError> {
        if self.size.is_empty() {
            return Ok(FactorReport::EMPTY);
        }
        self.set_sizes(row_size);
        if self.kind == Kind::Symmetric {
            if let Some(report) = self.factor_symmetric(matrix.values) {
                self.held = Held::Symmetric;
                return Ok(report);
            }
            self.scatter_pivoted(matrix.pattern, matrix.values);
        }
        let plain = self.factor_pivoted(matrix.values);
        if plain.ratio >= SUSPICIOUS {
            self.held = Held::Pivoted { scaled: false };
            return Ok(self.report(plain));
        }
        let scaled = self.factor_scaled(matrix);
        let needed = if self.border.is_some() { SUSPICIOUS } else { SINGULAR };
        if scaled.ratio >= needed {
            self.held = Held::Pivoted { scaled: true };
            return Ok(self.report(scaled));
        }
        if self.border.is_some() {
            return self.factor_wide(matrix, row_size);
        }
        let equation = self.layout.order[scaled.at];
        Err(SolveError::Singular { equation, ratio: scaled.ratio })
    }

    fn solve(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve_block(block, columns, false)
    }

    fn solve_transpose(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve_block(block, columns, true)
    }

    fn description(&self) -> Description {
        Description {
            back_end: BackEnd::Banded,
            kind: self.kind,
            equations: self.layout.order.len(),
            half_bandwidth: self.layout.half_bandwidth,
            border: self.layout.order.len() - self.layout.band,
            predicted_entries: self.layout.entries(self.kind),
            predicted_operations: self.layout.operations(self.kind),
            bytes: 8.0 * self.layout.entries(self.kind),
        }
    }
}

fn entry_places(pattern: &Pattern, place: impl Fn(usize, usize) -> usize) -> Vec<u32> {
    let mut places = Vec::with_capacity(pattern.entries());
    for i in 0..pattern.size() {
        places.extend(pattern.row(i).iter().map(|&j| place(i, j) as u32));
    }
    places
}

/// Every entry has a place, if only one behind the matrix: no branch that could be mispredicted.
fn scatter(values: &[f64], place: &[u32], storage: &mut [f64]) {
    for (&value, &at) in values.iter().zip(place) {
        storage[at as usize] = value;
    }
}

/// Pivots of band and border together (Haynsworth: the numbers of negative ones add).
fn join(band: Pivots, border: Pivots, offset: usize) -> Pivots {
    let negative = band.negative + border.negative;
    if border.smallest_ratio < band.smallest_ratio {
        Pivots { negative, smallest: offset + border.smallest, ..border }
    } else {
        Pivots { negative, ..band }
    }
}
