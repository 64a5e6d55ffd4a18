//! Bodies that are tied to one another in some directions and free in others.
//!
//! ```text
//!   body 1 o====o     o======o body 2     6 motions each; a row for every direction that is tied,
//!               |-----|                   the motion of the one there less that of the other
//! ```

use super::bodies::{Bodies, Tied};
use super::rigid_motions::{DEPENDENT, Motion, nothing_among, null_motions, rigid_motion, seen};
use crate::leading::masters;
use slideline_linalg::reduce_rows;
use slideline_model::{Dof, Model, NodeIndex};
use std::collections::{BTreeMap, HashMap, HashSet};

/// What holds each body, by its root.
pub type Rows = HashMap<NodeIndex, Vec<Motion>>;

/// Rows of the motions of two bodies.
type Between = [f64; 12];

/// What ties bodies in part.
#[derive(Default)]
pub struct Ties(BTreeMap<[NodeIndex; 2], Vec<Between>>);

impl Ties {
    /// Those of a model of some size [L]; what nothing follows of a lone master stays where it is.
    pub fn of((model, size): (&Model, f64), bodies: &mut Bodies, rows: &mut Rows) -> Self {
        let mut new = Self::default();
        if bodies.tied.is_empty() {
            return new;
        }
        for Tied { own, master } in bodies.tied.clone() {
            let roots = [own.0, master].map(|node| bodies.root(node));
            let origins = roots.map(|root| model.nodes.position(root));
            let [one, other] = origins.map(|origin| seen(model, own, (origin, size)));
            let row = std::array::from_fn(|k| if k < 6 { one[k] } else { -other[k - 6] });
            new.0.entry(roots).or_default().push(row);
        }
        new.0.values_mut().for_each(reduce);
        let elements = model.blocks.iter().flat_map(|block| block.elements.iter());
        let of_elements: HashSet<NodeIndex> = elements.flat_map(|own| own.nodes).copied().collect();
        for (master, used) in masters(model) {
            if bodies.root(master) == master && !of_elements.contains(&master) {
                let idle = Dof::ALL.into_iter().filter(|dof| !used[*dof as usize]);
                let stays = idle.map(|dof| rigid_motion(dof, [0.0; 3]));
                rows.entry(master).or_default().extend(stays);
            }
        }
        new
    }

    /// The bodies that ties join to that of a root, itself first.
    pub fn group(&self, root: NodeIndex) -> Vec<NodeIndex> {
        let mut group = vec![root];
        let mut at = 0;
        while let Some(&body) = group.get(at) {
            for [one, other] in self.0.keys().filter(|own| own.contains(&body)) {
                let next = if *one == body { *other } else { *one };
                if !group.contains(&next) {
                    group.push(next);
                }
            }
            at += 1;
        }
        group
    }

    /// A base of the motions, along some unknowns, that are left to the first body of a group.
    pub fn motions(&self, group: &[NodeIndex], rows: &Rows, unknowns: &[usize]) -> Vec<Motion> {
        let (width, mut all) = (6 * group.len(), Vec::new());
        let mut add = |places: &[usize], row: &[f64]| {
            let from = all.len();
            all.resize(from + width, 0.0);
            for (&place, part) in places.iter().zip(row.chunks_exact(6)) {
                all[from + 6 * place..][..6].copy_from_slice(part);
            }
        };
        for (place, body) in group.iter().enumerate() {
            rows.get(body).into_iter().flatten().for_each(|row| add(&[place], row));
        }
        let place = |body: NodeIndex| group.iter().position(|own| *own == body);
        for (bodies, rows) in &self.0 {
            if let [Some(one), Some(other)] = bodies.map(place) {
                rows.iter().for_each(|row| add(&[one, other], row));
            }
        }
        let columns =
            (0..group.len()).flat_map(|place| unknowns.iter().map(move |own| 6 * place + own));
        let zero = nothing_among(&all);
        let motions = null_motions((all, width), columns, zero);
        let of_first = motions.into_iter().map(|motion| std::array::from_fn(|k| motion[k]));
        of_first.filter(|own: &Motion| own.iter().any(|part| part.abs() > DEPENDENT)).collect()
    }
}

/// Leaves as many rows as are independent.
fn reduce(rows: &mut Vec<Between>) {
    let zero = nothing_among(rows.as_flattened());
    let mut pivots = Vec::with_capacity(12);
    reduce_rows(rows.as_flattened_mut(), 12, zero, &mut pivots);
    rows.truncate(pivots.len());
}
