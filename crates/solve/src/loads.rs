//! Pressures and tractions that follow their faces, forces per length that turn with beams, and
//! centrifugal forces of elements where they are.
//!
//! ```text
//!     p |||        o---o   forces at the current shape, their derivative in the tangent
//!    o-----o  ->  /  p /
//! ```

use crate::constraints::{Constraints, Rows};
use crate::dofs::DofMap;
use crate::section_loads::SectionLoad;
use slideline_linalg::{Kind, Pattern};
use slideline_mech::pressure::Face;
use slideline_mech::traction;
use slideline_mech::turn::Turn;
use slideline_mech::turning::Turning;
use slideline_mech::volume::MOST as MOST_NODES;
use slideline_model::{self as model, Dof, Model, NodeIndex, Step};

/// A face, or an element that turns, with its dofs.
#[derive(Clone, Debug)]
struct Pressed {
    by: By,
    /// Undeformed positions [L].
    reference: Vec<[f64; 3]>,
    /// Displacements, node by node; `None` where a node lacks one.
    dofs: Vec<[Option<usize>; 3]>,
    /// Those that there are, and their places among all of the face.
    own: (Vec<usize>, Vec<usize>),
}

/// What acts on it.
#[derive(Clone, Debug)]
enum By {
    Pressure(Face),
    Traction(traction::Placed),
    Turning(Turning),
}

/// What a load follows.
#[derive(Clone, Debug)]
enum Followed {
    Face(Pressed),
    Sections(SectionLoad),
}

/// The most entries of the derivative of the forces on a face or an element.
const MOST_ENTRIES: usize = 9 * MOST_NODES * MOST_NODES;

/// The faces that a step presses.
#[derive(Clone, Debug, Default)]
pub struct FaceLoads {
    faces: Vec<Followed>,
    nonlinear: bool,
}

impl Pressed {
    /// Forces on the nodes at `x` [L]: adds to `force` [F].
    fn press(&self, size: f64, x: &[[f64; 3]], force: &mut [[f64; 3]]) {
        match &self.by {
            By::Pressure(face) => face.press(size, x, force),
            By::Traction(traction) => traction.pull(size, x, force),
            By::Turning(turning) => turning.push(size, x, force),
        }
    }

    /// Their derivative by the positions: adds to `tangent` [F/L].
    fn stiffness(&self, size: f64, x: &[[f64; 3]], tangent: &mut [f64]) {
        match &self.by {
            By::Pressure(face) => face.stiffness(size, x, tangent),
            By::Traction(traction) => traction.stiffness(size, x, tangent),
            By::Turning(turning) => turning.stiffness(size, x.len(), tangent),
        }
    }
}

impl FaceLoads {
    /// Those of a step.
    pub fn new(model: &Model, step: &Step, dofs: &DofMap) -> Self {
        let place = |&node: &NodeIndex| model.nodes.get(node).position;
        let faces = step.distributed.pressures.iter().map(|load| {
            let reference: Vec<[f64; 3]> = load.nodes.iter().map(place).collect();
            let by = match &load.on {
                model::Pressed::Face(face) => By::Pressure(*face),
                model::Pressed::Traction(traction) => By::Traction(traction.at_rest(&reference)),
                model::Pressed::Turning(turning) => By::Turning(turning.clone()),
                model::Pressed::Sections(shares) => {
                    return Followed::Sections(SectionLoad::new(&load.nodes, shares, dofs));
                }
            };
            let of =
                |&node: &NodeIndex| [Dof::U1, Dof::U2, Dof::U3].map(|dof| dofs.find(node, dof));
            let dofs: Vec<[Option<usize>; 3]> = load.nodes.iter().map(of).collect();
            let all = dofs.as_flattened().iter().enumerate();
            let own = all.filter_map(|(place, dof)| Some(((*dof)?, place))).unzip();
            Followed::Face(Pressed { by, reference, dofs, own })
        });
        Self { faces: faces.collect(), nonlinear: step.nlgeom }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty()
    }

    fn places(&self, pressed: &Pressed, u: &[f64]) -> [[f64; 3]; MOST_NODES] {
        let mut x = [[0.0; 3]; MOST_NODES];
        for ((x, reference), dofs) in x.iter_mut().zip(&pressed.reference).zip(&pressed.dofs) {
            for ((x, reference), dof) in x.iter_mut().zip(reference).zip(dofs) {
                let moved = dof.filter(|_| self.nonlinear).map_or(0.0, |dof| u[dof]);
                *x = reference + moved;
            }
        }
        x
    }

    /// Forces of these pressures and tractions [F/L2 or F/L] on the dofs [F]: adds to `force`.
    pub fn press(&self, pressures: &[f64], (u, turns): (&[f64], &[Turn]), force: &mut [f64]) {
        for (followed, &pressure) in self.faces.iter().zip(pressures) {
            let pressed = match followed {
                Followed::Face(pressed) => pressed,
                Followed::Sections(load) => {
                    load.press(pressure, self.nonlinear.then_some((u, turns)), force);
                    continue;
                }
            };
            let count = pressed.reference.len();
            let mut own = [[0.0; 3]; MOST_NODES];
            let x = self.places(pressed, u);
            pressed.press(pressure, &x[..count], &mut own[..count]);
            for (dofs, own) in pressed.dofs.iter().zip(own) {
                for (dof, own) in dofs.iter().zip(own) {
                    if let Some(dof) = *dof {
                        force[dof] += own;
                    }
                }
            }
        }
    }

    /// Takes the derivative of the forces from the tangent; half of it and of its transpose where
    /// the matrix is `symmetric`.
    pub fn stiffen(
        &self,
        (constraints, pattern, kind): (Constraints<'_>, &Pattern, Kind),
        rows: &Rows,
        (pressures, u, turns): (&[f64], &[f64], &[Turn]),
        values: &mut [f64],
    ) {
        if !self.nonlinear || self.faces.is_empty() {
            return;
        }
        let symmetric = kind == Kind::Symmetric;
        let mut room = [0.0; MOST_ENTRIES];
        for (followed, &pressure) in self.faces.iter().zip(pressures) {
            if pressure == 0.0 {
                continue;
            }
            let pressed = match followed {
                Followed::Face(pressed) => pressed,
                Followed::Sections(load) => {
                    load.for_each_slope(pressure, (u, turns), |dofs, slope| {
                        let entry = |i: usize, j: usize| match symmetric {
                            true => -0.5 * (slope(i, j) + slope(j, i)),
                            false => -slope(i, j),
                        };
                        constraints.scatter((rows, pattern), dofs, entry, values);
                    });
                    continue;
                }
            };
            let count = pressed.reference.len();
            let width = 3 * count;
            let x = self.places(pressed, u);
            let tangent = &mut room[..width * width];
            tangent.fill(0.0);
            pressed.stiffness(pressure, &x[..count], tangent);
            let (dofs, own) = &pressed.own;
            let entry = |i: usize, j: usize| -> f64 {
                let (i, j) = (own[i], own[j]);
                let value = tangent[i * width + j];
                if symmetric { -0.5 * (value + tangent[j * width + i]) } else { -value }
            };
            constraints.scatter((rows, pattern), dofs, entry, values);
        }
    }
}
