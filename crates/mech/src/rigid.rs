//! How the position of a point follows dofs: the only place that knows it.
//!
//! ```text
//!   Free:  o node = point           Arm:   o node (x, y, phi)
//!                                           \  r = R(phi) arm
//!                                            x point = node + r
//! ```

/// How the position of a point follows the dofs of one node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointMap {
    /// The point is the node; dofs (x, y).
    Free,
    /// The point rides on a rigid arm of the node, x = x_node + R(phi) arm; dofs (x, y, phi).
    /// [semantics: rigid link]
    Arm {
        /// Vector from the node to the point in the undeformed state [L].
        arm: [f64; 2],
    },
}

/// A rotation in the plane with what it makes of arms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneTurn {
    angle: f64,
    sine: f64,
    cosine: f64,
    /// 1 - cos phi = 2 sin^2(phi/2), so that small rotations keep their digits.
    versine: f64,
}

impl PlaneTurn {
    /// No rotation.
    pub const NONE: Self = Self { angle: 0.0, sine: 0.0, cosine: 1.0, versine: 0.0 };

    /// The rotation by an angle [1].
    pub fn by(angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let half = (0.5 * angle).sin();
        Self { angle, sine, cosine, versine: 2.0 * half * half }
    }

    /// Becomes the rotation by an angle, if it is not already: the parts of a body share it.
    pub fn become_by(&mut self, angle: f64) -> &Self {
        if angle != self.angle {
            *self = Self::by(angle);
        }
        self
    }

    /// The arm R(phi) arm [L]; what it has across the plane does not count.
    pub fn arm(&self, arm: [f64; 3]) -> [f64; 2] {
        let (s, c) = (self.sine, self.cosine);
        [c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]]
    }

    /// By how much the end of an arm moves in the plane, its node by (x, y) [L].
    pub fn displacement(&self, [x, y]: [f64; 2], arm: [f64; 3]) -> [f64; 2] {
        let (s, versine) = (self.sine, self.versine);
        [x - versine * arm[0] - s * arm[1], y + s * arm[0] - versine * arm[1]]
    }
}

impl PointMap {
    /// Number of dofs the point follows: 2 or 3.
    pub fn width(&self) -> usize {
        match self {
            Self::Free => 2,
            Self::Arm { .. } => 3,
        }
    }

    /// Displacement of the point [L] for the node's dofs (displacements; rotation in radians).
    /// Missing dofs count as zero.
    pub fn displacement(&self, dofs: &[f64]) -> [f64; 2] {
        let at = |i: usize| dofs.get(i).copied().unwrap_or(0.0);
        match self {
            Self::Free => [at(0), at(1)],
            Self::Arm { arm: [x, y] } => {
                PlaneTurn::by(at(2)).displacement([at(0), at(1)], [*x, *y, 0.0])
            }
        }
    }

    /// The arm r = R(phi) arm in the current state [L]; zero for a free node.
    pub fn current_arm(&self, dofs: &[f64]) -> [f64; 2] {
        match self {
            Self::Free => [0.0, 0.0],
            Self::Arm { arm: [x, y] } => {
                PlaneTurn::by(dofs.get(2).copied().unwrap_or(0.0)).arm([*x, *y, 0.0])
            }
        }
    }

    /// Pushes a force on the point and its derivative by the point's position to the node's dofs:
    /// f_m = J' f, T = J' K J with -(r.f) added on (phi, phi). Adds into `force` (`width`) and
    /// `tangent` (`width` x `width`, row-major). [semantics: rigid link, tangent]
    pub fn push_forward(
        &self,
        dofs: &[f64],
        point_force: &[f64; 2],
        point_tangent: &[[f64; 2]; 2],
        force: &mut [f64],
        tangent: &mut [f64],
    ) {
        let attachment = [Attachment::Point { map: *self, first: 0 }];
        push_forward(&attachment, dofs, point_force, point_tangent.as_flattened(), force, tangent);
    }
}

/// Which local dofs one control point (or one rotation) of a contact stencil follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attachment {
    /// A position: two variables, following the dofs from `first` on by the map.
    Point {
        /// How the point follows its node.
        map: PointMap,
        /// Local number of the node's first dof.
        first: usize,
    },
    /// A rotation: one variable, equal to the dof.
    Rotation {
        /// Local number of the rotation dof.
        dof: usize,
    },
    /// A position between two nodes: two variables, following the dofs (x, y, phi) of both.
    Blend {
        /// How the point follows its nodes.
        blend: Blend,
        /// Local numbers of the nodes' first dofs.
        firsts: [usize; 2],
    },
    /// The image of a node in a plane of symmetry, x = X - 2 n n.(X - X_p): two variables, following the dofs (x, y) of
    /// the node and of one in the plane.
    Image {
        /// Unit normal n of the plane [1].
        normal: [f64; 2],
        /// Local number of the first dof of the node X.
        node: usize,
        /// Local number of the first dof of the node X_p.
        plane: usize,
    },
}

/// A point between two nodes, x = sum_k w_k X_k + R(phi_k) arm_k: a station of a smooth line whose
/// tangents turn with its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blend {
    /// Weights w_k of the two nodes' positions [1], sum 1.
    pub weights: [f64; 2],
    /// Arms that turn with the nodes, undeformed [L].
    pub arms: [[f64; 2]; 2],
}

impl Blend {
    /// Displacement of the point [L] for the dofs (x, y, phi) of both nodes.
    pub fn displacement(&self, dofs: &[f64; 6]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for k in 0..2 {
            let node = &dofs[3 * k..3 * k + 3];
            let turned = PointMap::Arm { arm: self.arms[k] }.displacement(&[0.0, 0.0, node[2]]);
            for c in 0..2 {
                sum[c] += self.weights[k] * node[c] + turned[c];
            }
        }
        sum
    }

    /// The arm of a node in the current state [L].
    fn current_arm(&self, k: usize, rotation: f64) -> [f64; 2] {
        PointMap::Arm { arm: self.arms[k] }.current_arm(&[0.0, 0.0, rotation])
    }
}

/// Derivatives of one variable of an attachment: (dof, coefficient) pairs.
struct Row {
    pairs: [(usize, f64); 4],
    count: usize,
}

impl Row {
    fn of<const N: usize>(list: [(usize, f64); N]) -> Self {
        let mut row = Self { pairs: [(0, 0.0); 4], count: N };
        row.pairs[..N].copy_from_slice(&list);
        row
    }

    fn pairs(&self) -> &[(usize, f64)] {
        &self.pairs[..self.count]
    }
}

impl Attachment {
    fn variables(&self) -> usize {
        match self {
            Self::Point { .. } | Self::Blend { .. } | Self::Image { .. } => 2,
            Self::Rotation { .. } => 1,
        }
    }

    /// Whether it is a point whose two variables are the dofs from there on.
    fn is_at(&self, dof: usize) -> bool {
        matches!(self, Self::Point { map: PointMap::Free, first } if *first == dof)
    }

    /// Derivatives of variable `component` of this attachment by the dofs.
    fn row(&self, component: usize, dofs: &[f64]) -> Row {
        let spin = |r: [f64; 2]| if component == 0 { -r[1] } else { r[0] };
        match self {
            Self::Rotation { dof } => Row::of([(*dof, 1.0)]),
            Self::Point { map: PointMap::Free, first } => Row::of([(first + component, 1.0)]),
            Self::Point { map, first } => {
                let r = map.current_arm(dofs.get(*first..).unwrap_or(&[]));
                Row::of([(first + component, 1.0), (first + 2, spin(r))])
            }
            Self::Blend { blend, firsts: [a, b] } => Row::of([
                (a + component, blend.weights[0]),
                (a + 2, spin(blend.current_arm(0, dofs[a + 2]))),
                (b + component, blend.weights[1]),
                (b + 2, spin(blend.current_arm(1, dofs[b + 2]))),
            ]),
            Self::Image { normal, node, plane } => {
                let back = |axis: usize| 2.0 * normal[component] * normal[axis];
                let own = |axis: usize| f64::from(axis == component) - back(axis);
                Row::of([
                    (*node, own(0)),
                    (node + 1, own(1)),
                    (*plane, back(0)),
                    (plane + 1, back(1)),
                ])
            }
        }
    }
}

/// Whether the `n` variables of attachments are the dofs, one after the other.
fn are_copied(attachments: &[Attachment], n: usize) -> bool {
    let mut each = attachments.iter().enumerate();
    n == 2 * attachments.len() && each.all(|(own, attachment)| attachment.is_at(2 * own))
}

/// The most variables a stencil may have in [`push_forward`].
pub const MOST_VARIABLES: usize = 16;

/// Pushes the force and tangent of a stencil of positions (and rotations) to its local dofs.
///
/// `dofs` are the local dofs, m of them; `gradient` has one entry a variable (n, in the order of the
/// attachments, at most [`MOST_VARIABLES`]), `hessian` n x n row-major, symmetric or not. *Adds* into
/// `force` (m) and `tangent` (m x m, row-major). Attachments may share dofs, as the corners of one
/// rigid body do. [semantics: rigid link, T'KT - (r.f)]
pub fn push_forward(
    attachments: &[Attachment],
    dofs: &[f64],
    gradient: &[f64],
    hessian: &[f64],
    force: &mut [f64],
    tangent: &mut [f64],
) {
    let (n, m) = (gradient.len().min(MOST_VARIABLES), dofs.len());
    if are_copied(attachments, n) {
        force.iter_mut().zip(gradient).for_each(|(into, by)| *into += by);
        for (into, row) in tangent.chunks_exact_mut(m).zip(hessian.chunks_exact(n)) {
            into.iter_mut().zip(row).for_each(|(into, by)| *into += by);
        }
        return;
    }
    let mut rows: [Row; MOST_VARIABLES] = std::array::from_fn(|_| Row::of([]));
    let mut variable = 0;
    for attachment in attachments {
        for component in 0..attachment.variables() {
            if variable < n {
                rows[variable] = attachment.row(component, dofs);
                variable += 1;
            }
        }
    }
    for i in 0..variable {
        for &(a, by_a) in rows[i].pairs() {
            force[a] += by_a * gradient[i];
            for j in 0..variable {
                for &(b, by_b) in rows[j].pairs() {
                    tangent[m * a + b] += by_a * by_b * hessian[n * i + j];
                }
            }
        }
    }
    add_turning_terms(attachments, dofs, gradient, tangent);
}

/// Pushes gradients of scalars (an overclosure, slips, drags) to the local dofs: J' g each.
/// `gradients` are lists of gradients, each with an entry a variable (n); *adds* into `into`, a row a
/// gradient in their order, of which the first ones are those of `dofs`.
pub fn push_gradients(
    attachments: &[Attachment],
    dofs: &[f64],
    (gradients, n): (&[&[f64]], usize),
    (into, width): (&mut [f64], usize),
) {
    let values = gradients.iter().flat_map(|list| list.chunks_exact(n));
    if are_copied(attachments, n) {
        for (into, gradient) in into.chunks_exact_mut(width).zip(values) {
            into.iter_mut().zip(gradient).for_each(|(into, by)| *into += by);
        }
        return;
    }
    let mut variable = 0;
    for attachment in attachments {
        for component in 0..attachment.variables() {
            if variable >= n {
                return;
            }
            let row = attachment.row(component, dofs);
            for (into, gradient) in into.chunks_exact_mut(width).zip(values.clone()) {
                for &(dof, coefficient) in row.pairs() {
                    into[dof] += coefficient * gradient[variable];
                }
            }
            variable += 1;
        }
    }
}

/// Adds -(r.f) on (phi, phi) for each arm.
fn add_turning_terms(
    attachments: &[Attachment],
    dofs: &[f64],
    gradient: &[f64],
    tangent: &mut [f64],
) {
    let m = dofs.len();
    let mut variable = 0;
    for attachment in attachments {
        let f = [gradient[variable], gradient.get(variable + 1).copied().unwrap_or(0.0)];
        let mut turn = |phi: usize, r: [f64; 2]| {
            tangent[m * phi + phi] -= r[0] * f[0] + r[1] * f[1];
        };
        match attachment {
            Attachment::Point { map: map @ PointMap::Arm { .. }, first } => {
                turn(first + 2, map.current_arm(&dofs[*first..]));
            }
            Attachment::Blend { blend, firsts } => {
                for (k, first) in firsts.iter().enumerate() {
                    turn(first + 2, blend.current_arm(k, dofs[first + 2]));
                }
            }
            _ => {}
        }
        variable += attachment.variables();
    }
}
