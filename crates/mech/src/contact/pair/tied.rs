//! What the nodes of a slave face that is tied follow: means of the master over the face.
//!
//! ```text
//!   slave    o---------o---------o     int Phi_j (u_s - u_m) dA = 0, with functions Phi_j that are
//!   master   o----o-------o------o     dual to those of the slave: each node has a row of its own
//! ```
//!
//! A node that follows the place nearest to it hands its force on there: a uniform pressure becomes
//! forces of the master that are none of a uniform pressure. Means keep it. docs/theory.md
//! section 4.11.

use super::mortar_faces::{
    Couple, Cover, Ends, FaceEnds, FacePlaces, Faced, Looking, reference_areas,
};
use crate::element::quadrature::{GAUSS_4, GAUSS_4_MEAN};
use crate::pressure::{Face, MOST_NODES};

/// Share of a middle node's function that each of its corners takes on faces whose corners have none
/// of a uniform pressure, or less [1]. [popp2012]
const MIDDLE: f64 = 0.2;
/// Part of a face that must be covered for its functions to be told apart [1]. (choice)
const LEAST: f64 = 1e-3;

/// Functions of the nodes of a face, of either side [1].
type Shapes = [f64; MOST_NODES];

/// Integrals of a slave face over what of it faces the master.
#[derive(Clone, Debug, Default)]
pub struct TiedFace {
    nodes: usize,
    /// Area of the face, and what of it faces the master [L2].
    area: [f64; 2],
    /// int N_i dA over the face, and over what faces the master [L2].
    areas: [Shapes; 2],
    /// int N_i N_j dA over what faces the master [L2].
    mass: [Shapes; MOST_NODES],
    /// int N_i N_k dA with the nodes of a face of the master, by its place in the list [L2].
    shared: Vec<(usize, [Shapes; MOST_NODES])>,
}

/// What a node of a slave face takes of others: it is the sum over both, over its own area.
#[derive(Clone, Debug, Default)]
pub struct TiedRow {
    /// Its area [L2].
    pub area: f64,
    /// Shares of the nodes of faces of the master, by their places in the list [L2].
    pub master: Vec<(usize, Shapes)>,
    /// Shares of the nodes of its own face that follow nothing in this way [L2].
    pub own: Shapes,
}

/// What becomes of the displacement of a node of a slave face in its functions: a middle node of a
/// face in space is written as a mean of its corners and of what is its own.
/// [docs/theory.md, eq. (4.27)]
pub fn own_part(nodes: usize, node: usize) -> (f64, Option<[usize; 2]>) {
    let corners = match nodes {
        6 => 3,
        8 => 4,
        _ => return (1.0, None),
    };
    match node.checked_sub(corners) {
        Some(edge) => (1.0 - 2.0 * MIDDLE, Some([edge, (edge + 1) % corners])),
        None => (1.0, None),
    }
}

/// The share of a middle node's corners in it [1].
pub const fn share_of_corner() -> f64 {
    MIDDLE
}

/// The functions of the nodes of a slave face, all of them positive in the mean.
fn lifted(nodes: usize, shapes: &Shapes) -> Shapes {
    let mut lifted = *shapes;
    for node in 0..nodes {
        let (own, corners) = own_part(nodes, node);
        if let Some(corners) = corners {
            lifted[node] = own * shapes[node];
            corners.into_iter().for_each(|corner| lifted[corner] += MIDDLE * shapes[node]);
        }
    }
    lifted
}

impl TiedFace {
    /// A face of a volume, over what of it faces the masters no further away than each of them
    /// ties [L].
    pub fn in_space(slave: &[[f64; 3]], masters: &[(Faced, f64)], cover: &mut Cover) -> Self {
        let own = FacePlaces::new(slave);
        let mut tied = Self { nodes: slave.len(), ..Self::default() };
        let measure = reference_areas(&own);
        own.each_place(&measure, |weight, _, shapes| tied.add_own(weight, shapes));
        let faced: Vec<Faced> = masters.iter().map(|(faced, _)| *faced).collect();
        let mut overlaps = Vec::new();
        let ends = FaceEnds::default();
        let looking = Looking { places: &own, ends: &ends, thickness: f64::INFINITY };
        cover.find(looking, &faced, &mut overlaps);
        for overlap in &overlaps {
            let (master, reach) = &masters[overlap.master];
            let couple = Couple {
                slave: &own,
                measure: &measure,
                master: &master.places,
                ends: Ends::default(),
            };
            couple.each_meeting(overlap, |weight, shapes, gap, of_master| {
                if gap.abs() <= *reach {
                    tied.add(weight, shapes, (overlap.master, of_master));
                }
            });
        }
        tied
    }

    /// An edge of an area or of a ring; it is cut where ends of masters are nearest to it.
    pub fn in_plane(
        edge: Face,
        slave: &[[f64; 3]],
        masters: &[(Face, Vec<[f64; 3]>, f64)],
    ) -> Self {
        let mut tied = Self { nodes: slave.len(), ..Self::default() };
        each_point(edge, slave, [-1.0, 1.0], |weight, shapes, _| tied.add_own(weight, shapes));
        let mut cuts = vec![-1.0, 1.0];
        for (_, master, _) in masters {
            let ends = [master.first(), master.last()];
            cuts.extend(ends.into_iter().flatten().map(|&end| edge.nearest_place(slave, end)[0]));
        }
        cuts.sort_by(f64::total_cmp);
        for piece in cuts.windows(2).filter(|piece| piece[1] - piece[0] > LEAST * LEAST) {
            each_point(edge, slave, [piece[0], piece[1]], |weight, shapes, place| {
                let near = masters.iter().enumerate().map(|(number, (face, master, reach))| {
                    (number, face.nearest(master, place), *reach)
                });
                let nearest = near.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
                if let Some((number, near, _)) = nearest.filter(|own| own.1.distance <= own.2) {
                    tied.add(weight, shapes, (number, &near.shapes));
                }
            });
        }
        tied
    }

    fn add_own(&mut self, weight: f64, shapes: &Shapes) {
        self.area[0] += weight;
        let own = lifted(self.nodes, shapes);
        self.areas[0].iter_mut().zip(own).for_each(|(sum, own)| *sum += weight * own);
    }

    fn add(&mut self, weight: f64, shapes: &Shapes, (master, of_master): (usize, &Shapes)) {
        self.area[1] += weight;
        let own = lifted(self.nodes, shapes);
        let place = self.shared.iter().position(|(number, _)| *number == master);
        let place = place.unwrap_or_else(|| {
            self.shared.push((master, [[0.0; MOST_NODES]; MOST_NODES]));
            self.shared.len() - 1
        });
        let add = |into: &mut Shapes, factor: f64, of: &Shapes| {
            into.iter_mut().zip(of).for_each(|(into, of)| *into += factor * of);
        };
        for node in 0..self.nodes {
            add(&mut self.mass[node], weight * own[node], &own);
            add(&mut self.shared[place].1[node], weight * own[node], of_master);
        }
        add(&mut self.areas[1], weight, &own);
    }

    /// Gives faces of the master the numbers that they have elsewhere.
    pub fn number_masters(&mut self, number: impl Fn(usize) -> usize) {
        self.shared.iter_mut().for_each(|(master, _)| *master = number(*master));
    }

    /// The area that a node has of the face, and what of it faces the master [L2].
    pub fn areas(&self, node: usize) -> [f64; 2] {
        self.areas.map(|of| of[node])
    }

    /// Forces of a unit pressure on what faces the master: of the nodes of the face, and of those of
    /// the master's faces, by their places in the list [L2].
    pub fn pressed(&self) -> (Shapes, Vec<(usize, Shapes)>) {
        let mut own = self.areas[1];
        for node in 0..self.nodes {
            if let (part, Some(corners)) = own_part(self.nodes, node) {
                own[node] /= part;
                corners.into_iter().for_each(|corner| own[corner] -= MIDDLE * own[node]);
            }
        }
        let sum = |shared: &[Shapes; MOST_NODES]| {
            std::array::from_fn(|k| shared.iter().map(|of| of[k]).sum())
        };
        (own, self.shared.iter().map(|(master, shared)| (*master, sum(shared))).collect())
    }

    /// Rows of the nodes that follow; the functions of the others are shared among theirs, so that
    /// all together are one. `None` where no node follows or the functions cannot be told apart.
    pub fn rows(&self, follows: &[bool; MOST_NODES]) -> Option<Vec<(usize, TiedRow)>> {
        let followers: Vec<usize> = (0..self.nodes).filter(|&node| follows[node]).collect();
        if followers.is_empty() || self.area[1] <= LEAST * self.area[0] {
            return None;
        }
        let dual = self.dual()?;
        let left = 1.0 / followers.len() as f64;
        let rows = followers.iter().map(|&node| {
            let mut function = dual[node];
            let mut row = TiedRow { area: self.areas[1][node], ..TiedRow::default() };
            for other in (0..self.nodes).filter(|&other| !follows[other]) {
                function.iter_mut().zip(dual[other]).for_each(|(sum, of)| *sum += left * of);
                row.own[other] = left * self.areas[1][other];
            }
            row.master.extend(self.shared.iter().map(|(master, shared)| {
                let mut shares = [0.0; MOST_NODES];
                for (by, of) in function.iter().zip(shared).take(self.nodes) {
                    shares.iter_mut().zip(of).for_each(|(sum, of)| *sum += by * of);
                }
                (*master, shares)
            }));
            (node, row)
        });
        Some(rows.collect())
    }

    /// The dual functions by those of the nodes: areas times the inverse of the mass, a row each.
    fn dual(&self) -> Option<[Shapes; MOST_NODES]> {
        let inverse = inverse(&self.mass, self.nodes)?;
        let areas = self.areas[1];
        let row = |node: usize| inverse[node].map(|own| areas[node] * own);
        Some(std::array::from_fn(row))
    }
}

/// The inverse of the first rows and columns of a symmetric matrix, by elimination without pivots;
/// `None` where it has hardly one.
fn inverse(matrix: &[Shapes; MOST_NODES], size: usize) -> Option<[Shapes; MOST_NODES]> {
    let mut left = *matrix;
    let mut inverse = [[0.0; MOST_NODES]; MOST_NODES];
    (0..size).for_each(|k| inverse[k][k] = 1.0);
    for k in 0..size {
        let pivot = left[k][k];
        if pivot.is_nan() || pivot <= LEAST.powi(4) * matrix[k][k] {
            return None;
        }
        let (own, of_inverse) = (left[k].map(|x| x / pivot), inverse[k].map(|x| x / pivot));
        (left[k], inverse[k]) = (own, of_inverse);
        for row in (0..size).filter(|&row| row != k) {
            let factor = left[row][k];
            left[row].iter_mut().zip(own).for_each(|(to, from)| *to -= factor * from);
            inverse[row].iter_mut().zip(of_inverse).for_each(|(to, from)| *to -= factor * from);
        }
    }
    Some(inverse)
}

/// Calls with weight, shape functions and place of points of a piece of an edge.
fn each_point(
    edge: Face,
    x: &[[f64; 3]],
    [from, to]: [f64; 2],
    mut call: impl FnMut(f64, &Shapes, [f64; 3]),
) {
    let long = to - from;
    for (at, mean) in GAUSS_4.into_iter().zip(GAUSS_4_MEAN) {
        let (measure, shapes, place) = edge.measured(x, from + 0.5 * long * (1.0 + at));
        call(mean * long * measure, &shapes, place);
    }
}
