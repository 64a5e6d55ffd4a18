//! What is kept of the tangent of a converged trial beside its equations: what it says of dofs that are
//! prescribed or follow others.

/// Tangents of the elements at the border and of closed points, and the forces of all elements.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    /// The elements that are kept, ascending.
    pub elements: Vec<usize>,
    /// Their tangents, one after the other, row by row.
    pub tangents: Vec<f64>,
    /// Closed contact points, and where their geometric tangents end.
    pub points: Vec<(usize, usize)>,
    /// These tangents, row by row.
    pub geometry: Vec<f64>,
    /// Forces of all elements, a dof each, not carried [F or F L].
    pub force: Vec<f64>,
}

impl Kept {
    /// Forgets all but which elements are kept.
    pub fn begin(&mut self, dofs: usize) {
        self.tangents.clear();
        self.points.clear();
        self.geometry.clear();
        self.force.clear();
        self.force.resize(dofs, 0.0);
    }

    /// Keeps the geometric tangent of a closed point.
    pub fn keep_point(&mut self, place: usize, tangent: &[f64]) {
        self.geometry.extend_from_slice(tangent);
        self.points.push((place, self.geometry.len()));
    }

    /// Closed points with their geometric tangents.
    pub fn points(&self) -> impl Iterator<Item = (usize, &[f64])> {
        let mut begin = 0;
        self.points.iter().map(move |&(place, end)| {
            let own = &self.geometry[begin..end];
            begin = end;
            (place, own)
        })
    }
}
