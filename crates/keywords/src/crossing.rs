//! Outlines that cross themselves.
//!
//! ```text
//!          \   /
//!       ----\-/----.        beyond the crossing the outside of one part is the inside of the
//!            X      \       other: which of them a point faces is left to chance
//!           / \      |
//!          '---'-----'
//! ```

use slideline_model::ProfilePoint;

/// Sines that are smaller are of rounding: parts that touch do not cross [1]. (choice)
const TOUCH: f64 = 1e-9;

/// Where two parts of an outline cross.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// The place [L].
    pub at: ProfilePoint,
    /// Numbers of the parts, the earlier one first.
    pub parts: [usize; 2],
}

/// A straight piece of an outline.
#[derive(Clone, Copy)]
struct Chord {
    ends: [ProfilePoint; 2],
    part: usize,
}

impl Chord {
    /// Least and largest coordinate along an axis [L].
    fn reach(&self, axis: usize) -> (f64, f64) {
        let [a, b] = self.ends.map(|end| end[axis]);
        (a.min(b), a.max(b))
    }

    /// How far the ends of another chord are to the left, over its length [L].
    fn left_of(&self, other: &Self) -> (f64, f64) {
        let [a, b] = self.ends;
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        let left =
            |end: ProfilePoint| (along[0] * (end[1] - a[1]) - along[1] * (end[0] - a[0])) / length;
        (left(other.ends[0]), left(other.ends[1]))
    }

    /// Where both go through one another, and neither only touches.
    fn crosses(&self, other: &Self) -> Option<ProfilePoint> {
        let through = |own: &Self, by: &Self| {
            let (a, b) = own.left_of(by);
            let size = (by.ends[1][0] - by.ends[0][0]).hypot(by.ends[1][1] - by.ends[0][1]);
            let sides = a * b < 0.0 && a.abs().min(b.abs()) > TOUCH * size;
            sides.then(|| a / (a - b))
        };
        let share = through(self, other)?;
        through(other, self)?;
        let [a, b] = other.ends;
        Some([0, 1].map(|k| a[k] + share * (b[k] - a[k])))
    }
}

/// The first crossing of an outline with itself; each part is a row of points, straight between
/// them.
pub(crate) fn crossing(parts: &[Vec<ProfilePoint>]) -> Option<Crossing> {
    let numbered = parts.iter().enumerate();
    let mut chords: Vec<Chord> = numbered
        .flat_map(|(part, points)| points.windows(2).map(move |ends| (part, ends)))
        .map(|(part, ends)| Chord { ends: [ends[0], ends[1]], part })
        .filter(|chord| chord.ends[0] != chord.ends[1])
        .collect();
    chords.sort_by(|a, b| a.reach(0).0.total_cmp(&b.reach(0).0));
    let mut found: Option<Crossing> = None;
    for (number, chord) in chords.iter().enumerate() {
        let (from, until) = chord.reach(1);
        let beside = chords[number + 1..].iter().take_while(|by| by.reach(0).0 < chord.reach(0).1);
        for by in beside.filter(|by| by.reach(1).0 < until && by.reach(1).1 > from) {
            let Some(at) = chord.crosses(by) else { continue };
            let parts = [chord.part.min(by.part), chord.part.max(by.part)];
            if found.is_none_or(|known| parts < known.parts) {
                found = Some(Crossing { at, parts });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    //! Requirement: an outline that crosses itself is found, wherever it lies, however it is turned and
    //! in any units; one that only touches itself, or is closed, is not. Source: drawn by hand.

    use super::*;

    const LOOP: [ProfilePoint; 4] = [[0.0, 0.0], [3.0, 2.0], [1.0, 2.0], [2.0, -1.0]];

    fn found(points: &[ProfilePoint], turn: f64, scale: f64) -> Option<Crossing> {
        let (sin, cos) = turn.sin_cos();
        let put = |[x, y]: ProfilePoint| {
            [7.0 + scale * (cos * x - sin * y), -3.0 + scale * (sin * x + cos * y)]
        };
        let parts: Vec<_> =
            points.windows(2).map(|ends| vec![put(ends[0]), put(ends[1])]).collect();
        crossing(&parts)
    }

    #[test]
    fn a_loop_is_found_however_it_lies() {
        for (turn, scale) in [(0.0, 1.0), (0.5, 1e-3), (1.571, 1e3), (3.0, 25.4)] {
            let crossing = found(&LOOP, turn, scale);
            assert_eq!(crossing.map(|own| own.parts), Some([0, 2]), "{turn} {scale}");
        }
    }

    #[test]
    fn what_touches_or_closes_does_not_cross() {
        let closed = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]];
        let touching = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [2.0, 0.0], [1.0, 1.0]];
        let back = [[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]];
        for points in [&closed[..], &touching, &back, &LOOP[..3]] {
            for (turn, scale) in [(0.0, 1.0), (0.7, 1e-3)] {
                assert_eq!(found(points, turn, scale), None, "{points:?} {turn}");
            }
        }
    }
}
