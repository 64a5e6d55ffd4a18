//! The equations of a mean motion at a configuration, with their derivatives.
//!
//! ```text
//!   shift    e . (u_ref - sum w u - (R L - L))
//!   fit      e . sum B R' (x - x_c)     B u = w r x u, or what the turn of a face is
//!   turning  s - (R p) . u
//! ```
//!
//! Bilinear in the rotation matrix and the displacements; docs/theory.md section 4.2.

use super::cloud::CloudNumbers;
use slideline_mech::best_fit::{Matrix, Moments, Rotation, times};
use slideline_mech::frame_turn::FrameTurn;
use slideline_mech::turn::Turn;
use slideline_mech::vector::{Vector, add, dot, scale, sub};

/// Dofs of a node, along its own axes where it has some.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Member {
    /// Displacements.
    pub dofs: [Option<usize>; 3],
    /// Its place among the nodes with axes of their own.
    pub axes: Option<usize>,
}

/// What takes part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum What {
    /// The displacement of the reference node along an axis.
    Shift(usize),
    /// The rotation about one.
    Angle(usize),
    /// The displacement of a node of the cloud along an axis.
    Place(usize, usize),
    /// A dof along an axis that turns.
    Turning(usize),
}

/// What takes part, as a dof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    /// What it is.
    pub what: What,
    /// Its dof; a turn may have none.
    pub dof: Option<usize>,
}

/// What is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Equation {
    /// The reference node stands where the cloud takes it, along an axis.
    Shift(usize),
    /// The turn is that of the cloud, about an axis.
    Fit(usize),
    /// The dof of this place is the displacement of a node along an axis that turns.
    Turning(usize, usize, usize),
}

/// A configuration.
#[derive(Debug)]
pub(super) struct At<'a> {
    of: CloudNumbers<'a>,
    members: &'a [Member],
    start: Turn,
    /// Displacements of the cloud, and what the reference node has of them [L].
    moved: Vec<Vector>,
    mean: Vector,
    /// Displacement of the weighted centre [L].
    centre: Vector,
    /// What nodes of the cloud make of a turn, where this counts from [L].
    turns: Vec<Matrix>,
    frame: FrameTurn,
    rotation: Rotation,
    /// The same as they are turned [L].
    turned: Vec<Matrix>,
}

/// What multipliers make of the equations.
#[derive(Debug)]
pub(super) struct Pull {
    /// Of the shifts and of the fits.
    shift: Vector,
    fit: Vector,
    /// Of dofs along axes that turn: node, axis where the turn counts from, multiplier.
    turning: Vec<(usize, Vector, f64)>,
}

impl<'a> At<'a> {
    /// That of displacements; the reference node has not turned yet.
    pub fn new((of, members): (CloudNumbers<'a>, &'a [Member]), start: Turn, u: &[f64]) -> Self {
        let cloud = of.cloud;
        let displaced = |member: &Member| {
            let axes = of.axes_of(member.axes);
            let along = member.dofs.iter().zip(axes);
            along.fold([0.0; 3], |sum, (dof, axis)| {
                add(sum, scale(axis, dof.map_or(0.0, |own| u[own])))
            })
        };
        let moved: Vec<Vector> = members[..cloud.arms.len()].iter().map(displaced).collect();
        let weighted = cloud.weights.iter().zip(&moved);
        let centre = weighted.fold([0.0; 3], |sum, (&w, &own)| add(sum, scale(own, w)));
        let shared = cloud.shares.iter().zip(&moved);
        let mean = shared.fold([0.0; 3], |sum, (share, own)| {
            std::array::from_fn(|k| sum[k] + share[k] * own[k])
        });
        let turns = cloud.turns.iter().map(|turns| turns.map(|row| start.arm(row).0));
        let turns: Vec<Matrix> = turns.collect();
        let rotation = Rotation::of([0.0; 3]);
        let (turned, frame) = (turns.clone(), FrameTurn::default());
        let mut at =
            Self { of, members, start, moved, mean, centre, turns, frame, rotation, turned };
        for member in 0..at.turns.len() {
            let (arm, moved) = at.arm(member);
            at.frame.add(&at.turns[member], arm, moved);
        }
        at
    }

    /// The arm of a node where the turn counts from, and how its end has moved since [L].
    fn arm(&self, member: usize) -> (Vector, Vector) {
        let (arm, before) = self.start.arm(self.of.cloud.arms[member]);
        (arm, sub(sub(self.moved[member], self.centre), before))
    }

    /// Turns the reference node to these rotations.
    pub fn turn(&mut self, angles: Vector) {
        self.rotation = Rotation::of(self.start.vector(angles));
        for (turned, rows) in self.turned.iter_mut().zip(&self.turns) {
            *turned = rows.map(|row| add(row, times(&self.rotation.moved, row)));
        }
    }

    /// Turns it as the cloud has turned; these rotations, the nearest to some.
    pub fn fit(&mut self, near: Vector, in_space: bool) -> Option<Vector> {
        let mut moments = Moments::default();
        for (member, &weight) in self.of.cloud.weights.iter().enumerate() {
            let (arm, moved) = self.arm(member);
            moments.add(weight, arm, moved);
        }
        let mut found = moments.fit(self.start.vector(near), in_space);
        if self.of.cloud.is_of_faces {
            found = found.and_then(|vector| self.frame.refined(vector, in_space));
        }
        let angles = found.map(|vector| add(vector, self.start.start));
        self.turn(angles.unwrap_or([f64::NAN; 3]));
        angles
    }

    /// An axis in which rotations and displacements of the reference node are named.
    pub fn axis_of_reference(&self, axis: usize) -> Vector {
        self.axis(self.members.len() - 1, axis)
    }

    fn axis(&self, member: usize, axis: usize) -> Vector {
        self.of.axes_of(self.members[member].axes)[axis]
    }

    /// An axis that turns, where the turn counts from.
    fn axis_at_start(&self, member: usize, axis: usize) -> Vector {
        self.start.arm(self.axis(member, axis)).0
    }

    /// What makes an equation a number without dimension.
    pub fn row_scale(&self, equation: Equation) -> f64 {
        let size = self.of.cloud.size;
        match equation {
            Equation::Shift(_) | Equation::Turning(..) => 1.0 / size,
            Equation::Fit(_) => 1.0 / (size * size),
        }
    }

    /// How far an equation is from zero, without dimension; `own`: the dof that it alone has.
    pub fn value(&self, equation: Equation, own: f64) -> f64 {
        let value = match equation {
            Equation::Shift(axis) => {
                let levers = self.of.cloud.levers.map(|lever| self.start.arm(lever));
                let turned = self.levers_by(&self.rotation.moved);
                let turned = std::array::from_fn(|k| self.mean[k] + turned[k] + levers[k].1[k]);
                own - dot(self.axis_of_reference(axis), turned)
            }
            Equation::Fit(axis) => self.frame.value(&self.rotation.moved)[axis],
            Equation::Turning(_, member, axis) => {
                let along = self.axis_at_start(member, axis);
                let along = add(along, times(&self.rotation.moved, along));
                own - dot(along, self.moved[member])
            }
        };
        value * self.row_scale(equation)
    }

    /// Derivative of an equation by a part, both without dimensions.
    pub fn slope(&self, equation: Equation, what: What) -> f64 {
        let value = match what {
            What::Angle(axis) => {
                return self.slope_by_turn(equation, axis) * self.row_scale(equation);
            }
            What::Shift(axis) => f64::from(equation == Equation::Shift(axis)),
            What::Turning(place) => match equation {
                Equation::Turning(own, ..) => f64::from(own == place),
                Equation::Shift(_) | Equation::Fit(_) => 0.0,
            },
            What::Place(member, axis) => self.slope_by_place(equation, (member, axis)),
        };
        value * self.row_scale(equation) * self.of.cloud.size
    }

    /// What a matrix makes of the levers, the part of each along its axis [L].
    fn levers_by(&self, matrix: &Matrix) -> Vector {
        let along = |k: usize| dot(matrix[k], self.start.arm(self.of.cloud.levers[k]).0);
        [0, 1, 2].map(along)
    }

    fn slope_by_place(&self, equation: Equation, (member, axis): (usize, usize)) -> f64 {
        let (along, shares) = (self.axis(member, axis), self.of.cloud.shares[member]);
        match equation {
            Equation::Shift(axis) => {
                let shared = std::array::from_fn(|k| shares[k] * along[k]);
                -dot(self.axis_of_reference(axis), shared)
            }
            Equation::Fit(axis) => dot(self.turned[member][axis], along),
            Equation::Turning(_, own, _) if own != member => 0.0,
            Equation::Turning(_, own, axis) => {
                let turning = self.axis_at_start(own, axis);
                -dot(add(turning, times(&self.rotation.moved, turning)), along)
            }
        }
    }

    fn slope_by_turn(&self, equation: Equation, about: usize) -> f64 {
        let along = self.axis_of_reference(about);
        let by = |k: usize| {
            let slope = &self.rotation.slopes[k];
            match equation {
                Equation::Shift(axis) => -dot(self.axis_of_reference(axis), self.levers_by(slope)),
                Equation::Fit(axis) => self.frame.change(slope)[axis],
                Equation::Turning(_, member, axis) => {
                    -dot(times(slope, self.axis_at_start(member, axis)), self.moved[member])
                }
            }
        };
        (0..3).filter(|k| along[*k] != 0.0).map(|k| along[k] * by(k)).sum()
    }

    /// Gathers multipliers.
    pub fn pull(&self, equations: &[Equation], multipliers: &[f64]) -> Pull {
        let mut pull = Pull { shift: [0.0; 3], fit: [0.0; 3], turning: Vec::new() };
        for (&equation, &own) in equations.iter().zip(multipliers) {
            match equation {
                Equation::Shift(axis) => {
                    pull.shift = add(pull.shift, scale(self.axis_of_reference(axis), own));
                }
                Equation::Fit(axis) => pull.fit[axis] += own,
                Equation::Turning(_, member, axis) => {
                    pull.turning.push((member, self.axis_at_start(member, axis), own));
                }
            }
        }
        pull
    }

    /// Second derivative by a part of the rotation vector and the displacement of a node.
    pub fn bend(&self, pull: &Pull, about: usize, (member, axis): (usize, usize)) -> f64 {
        let (slope, along) = (&self.rotation.slopes[about], self.axis(member, axis));
        let fit = pull.fit.iter().zip(&self.turns[member]);
        let fit: f64 = fit.map(|(force, row)| force * dot(times(slope, *row), along)).sum();
        let own = pull.turning.iter().filter(|(node, ..)| *node == member);
        let of_axes = own.map(|&(_, axis, force)| force * dot(times(slope, axis), along));
        fit - of_axes.sum::<f64>()
    }

    /// Second derivative by two parts of the rotation vector.
    pub fn bend_of_turn(&self, pull: &Pull, [one, other]: [usize; 2]) -> f64 {
        let bend = &self.rotation.bends[one][other];
        let of_axes = pull.turning.iter();
        let of_axes =
            of_axes.map(|&(node, axis, force)| force * dot(times(bend, axis), self.moved[node]));
        dot(pull.fit, self.frame.change(bend))
            - dot(pull.shift, self.levers_by(bend))
            - of_axes.sum::<f64>()
    }
}
