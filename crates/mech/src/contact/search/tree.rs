//! A tree of boxes: which parts of a large master are near?
//!
//! ```text
//!   +-----------------------+        a box holds the boxes below it; where a box is too
//!   | +--------+  +------+  |        far away, nothing below it is looked at
//!   | | o--o--o|  |o--o  |  |
//!   | +--------+  +------+  |        built once over the parts, fitted anew to where they
//!   +-----------------------+        stand; generic in the dimension
//! ```

/// Part of a way that is rounding [1].
const ROUNDING: f64 = 1e-9;
/// Parts of a leaf.
const LEAF: usize = 4;

/// A box: its lowest and highest corner [L].
pub type Bounds<const D: usize> = ([f64; D], [f64; D]);

#[derive(Clone, Debug, PartialEq)]
struct Branch<const D: usize> {
    bounds: Bounds<D>,
    /// First part of a leaf, and how many; none: an inner branch.
    parts: (u32, u32),
    /// The second branch below an inner one; the first lies directly behind it.
    second: u32,
}

/// The tree.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct BoxTree<const D: usize> {
    /// From the root down, each branch before those below it.
    branches: Vec<Branch<D>>,
    /// Parts in the order of the leaves.
    parts: Vec<u32>,
}

fn nothing<const D: usize>() -> Bounds<D> {
    ([f64::INFINITY; D], [f64::NEG_INFINITY; D])
}

fn join<const D: usize>(into: &mut Bounds<D>, other: &Bounds<D>) {
    for axis in 0..D {
        into.0[axis] = into.0[axis].min(other.0[axis]);
        into.1[axis] = into.1[axis].max(other.1[axis]);
    }
}

/// Square of the distance of a point from a box [L2].
fn distance_squared<const D: usize>(bounds: &Bounds<D>, point: &[f64; D]) -> f64 {
    (0..D).map(|k| (bounds.0[k] - point[k]).max(point[k] - bounds.1[k]).max(0.0).powi(2)).sum()
}

fn overlap<const D: usize>(a: &Bounds<D>, b: &Bounds<D>) -> bool {
    (0..D).all(|k| a.0[k] <= b.1[k] && b.0[k] <= a.1[k])
}

impl<const D: usize> BoxTree<D> {
    /// The tree over parts 0..`count` with these bounds: halved along the longest axis of their
    /// centres until a few are left.
    pub fn new(count: usize, bounds: impl Fn(usize) -> Bounds<D>) -> Self {
        let mut tree = Self { branches: Vec::new(), parts: (0..count as u32).collect() };
        let centre = |part: u32, axis: usize| {
            let (low, high) = bounds(part as usize);
            0.5 * (low[axis] + high[axis])
        };
        if count > 0 {
            tree.split((0, count), &centre);
            tree.fit(bounds);
        }
        tree
    }

    fn split(&mut self, (from, to): (usize, usize), centre: &impl Fn(u32, usize) -> f64) {
        let own = self.branches.len();
        let mut branch = Branch { bounds: nothing(), parts: (0, 0), second: 0 };
        if to - from <= LEAF {
            branch.parts = (from as u32, (to - from) as u32);
            self.branches.push(branch);
            return;
        }
        self.branches.push(branch);
        let parts = &mut self.parts[from..to];
        let extent = |axis: usize| {
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for &part in parts.iter() {
                (low, high) = (low.min(centre(part, axis)), high.max(centre(part, axis)));
            }
            high - low
        };
        let longest = (0..D).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
        let middle = parts.len() / 2;
        // equal centres stay in the order of their numbers: the tree depends on nothing else
        parts.select_nth_unstable_by(middle, |&a, &b| {
            centre(a, longest).total_cmp(&centre(b, longest)).then(a.cmp(&b))
        });
        self.split((from, from + middle), centre);
        self.branches[own].second = self.branches.len() as u32;
        self.split((from + middle, to), centre);
    }

    /// Fits the boxes to where the parts stand now.
    pub fn fit(&mut self, bounds: impl Fn(usize) -> Bounds<D>) {
        for own in (0..self.branches.len()).rev() {
            let (first, count) = self.branches[own].parts;
            let mut all = nothing();
            if count > 0 {
                for &part in &self.parts[first as usize..(first + count) as usize] {
                    join(&mut all, &bounds(part as usize));
                }
            } else {
                let second = self.branches[own].second as usize;
                join(&mut all, &self.branches[own + 1].bounds);
                join(&mut all, &self.branches[second].bounds);
            }
            self.branches[own].bounds = all;
        }
    }

    /// The box about all parts; `None` where there are none.
    pub fn bounds(&self) -> Option<Bounds<D>> {
        self.branches.first().map(|root| root.bounds)
    }

    /// Calls back with every part of a leaf whose box `enters`, tested from the root down.
    fn visit(&self, enters: impl Fn(&Bounds<D>) -> bool, mut call: impl FnMut(usize)) {
        let mut open = [0u32; 64];
        let mut count = usize::from(!self.branches.is_empty());
        while count > 0 {
            count -= 1;
            let own = open[count] as usize;
            let branch = &self.branches[own];
            if !enters(&branch.bounds) {
                continue;
            }
            let (first, parts) = branch.parts;
            if parts > 0 {
                let list = &self.parts[first as usize..(first + parts) as usize];
                list.iter().for_each(|&part| call(part as usize));
            } else {
                // the first branch is looked at first; depth is the logarithm of the parts
                open[count] = branch.second;
                open[count + 1] = own as u32 + 1;
                count += 2;
            }
        }
    }

    /// Calls back with all parts that a line from a place may meet on its way, up to `least` lengths of that [1],
    /// which may fall meanwhile.
    pub fn along(
        &self,
        (from, way): ([f64; D], [f64; D]),
        least: &std::cell::Cell<f64>,
        call: impl FnMut(usize),
    ) {
        let enters = |(low, high): &Bounds<D>| {
            let (mut begin, mut end) = (0.0_f64, least.get());
            for axis in 0..D {
                if way[axis] == 0.0 {
                    if from[axis] < low[axis] || from[axis] > high[axis] {
                        return false;
                    }
                    continue;
                }
                let [a, b] = [low, high].map(|bound| (bound[axis] - from[axis]) / way[axis]);
                begin = begin.max(a.min(b));
                end = end.min(a.max(b));
            }
            // boxes of flat faces have no depth
            begin <= end + ROUNDING * begin.abs()
        };
        self.visit(enters, call);
    }

    /// Calls back with all parts that may lie within `reach` of a point, and perhaps others near.
    pub fn within(&self, point: [f64; D], reach: f64, call: impl FnMut(usize)) {
        self.visit(|bounds| distance_squared(bounds, &point) <= reach * reach, call);
    }

    /// Calls back with all parts that may share space with a box, and perhaps others near.
    pub fn overlapping(&self, with: Bounds<D>, call: impl FnMut(usize)) {
        self.visit(|bounds| overlap(bounds, &with), call);
    }

    /// The part with the least `measure`, the lowest number among equals; `measure` is a squared
    /// distance of the point, no less than that of the part's box [L2].
    pub fn nearest(&self, point: [f64; D], measure: impl Fn(usize) -> f64) -> Option<(usize, f64)> {
        self.nearest_within(point, f64::INFINITY, measure)
    }

    /// The same among parts that are no farther away than `reach` [L].
    pub fn nearest_within(
        &self,
        point: [f64; D],
        reach: f64,
        measure: impl Fn(usize) -> f64,
    ) -> Option<(usize, f64)> {
        let (mut best, mut least) = (usize::MAX, reach * reach);
        // branches with the distance of their boxes; the nearer one is looked at first
        let mut open = [(0u32, 0.0f64); 64];
        let mut count = usize::from(!self.branches.is_empty());
        while count > 0 {
            count -= 1;
            let (own, distance) = open[count];
            if distance > least {
                continue;
            }
            let branch = &self.branches[own as usize];
            // an inner branch has none of its own
            let (first, parts) = branch.parts;
            for &part in &self.parts[first as usize..(first + parts) as usize] {
                let value = measure(part as usize);
                if value < least || (value == least && (part as usize) < best) {
                    (best, least) = (part as usize, value);
                }
            }
            if parts == 0 {
                let below = [own + 1, branch.second].map(|below| {
                    (below, distance_squared(&self.branches[below as usize].bounds, &point))
                });
                let nearer = usize::from(below[1].1 < below[0].1);
                (open[count], open[count + 1]) = (below[1 - nearer], below[nearer]);
                count += 2;
            }
        }
        (best != usize::MAX).then_some((best, least))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of space in no order, with boxes of different size about them.
    fn boxes(count: usize) -> Vec<Bounds<3>> {
        (0..count)
            .map(|k| {
                let at = [0.7, 1.3, 2.1].map(|f| (k as f64 * f).sin() * 10.0);
                let half = 0.05 + 0.3 * ((k * 7 % 5) as f64);
                (at.map(|x| x - half), at.map(|x| x + half))
            })
            .collect()
    }

    /// Requirement: no part that is near or that overlaps is missed, and the nearest is the one
    /// that looking at all of them finds; also after all have moved.
    #[test]
    fn the_tree_finds_what_a_loop_finds() {
        for count in [0, 1, 4, 5, 33, 500] {
            let mut all = boxes(count);
            let mut tree = BoxTree::<3>::new(count, |k| all[k]);
            for round in 0..2 {
                let point = [1.0 + f64::from(round), -2.0, 3.0];
                let mut near = Vec::new();
                tree.within(point, 4.0, |part| near.push(part));
                let mut common = Vec::new();
                let with = (point.map(|x| x - 2.0), point.map(|x| x + 2.0));
                tree.overlapping(with, |part| common.push(part));
                for (k, own) in all.iter().enumerate() {
                    assert!(distance_squared(own, &point) > 16.0 || near.contains(&k), "{k}");
                    assert!(!overlap(own, &with) || common.contains(&k), "{k}");
                }
                let measure = |k: usize| distance_squared(&all[k], &point);
                let least = (0..count).map(|k| (k, measure(k)));
                let least = least.fold(None, |best: Option<(usize, f64)>, own| match best {
                    Some(best) if best.1 <= own.1 => Some(best),
                    _ => Some(own),
                });
                assert_eq!(tree.nearest(point, measure), least);
                assert!(count < 500 || near.len() < count / 2, "nothing was left out");
                for own in &mut all {
                    own.0.iter_mut().chain(&mut own.1).for_each(|x| *x += 1.5);
                }
                tree.fit(|k| all[k]);
            }
        }
    }
}
