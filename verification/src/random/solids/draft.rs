//! A model of solids in natural units: what every class draws, before it is placed and scaled.

use super::mesh::{Part, SideOf};
use crate::random::classes::{Friction, Normal, Promise, Stick};

/// What a part is made of; moduli in natural units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Material {
    /// Young's modulus and Poisson's ratio.
    Elastic(f64, f64),
    /// Neo-Hooke: shear modulus and bulk modulus.
    Rubber(f64, f64),
    /// Young's modulus, Poisson's ratio, yield stress, hardening modulus.
    Plastic(f64, f64, f64, f64),
}

/// Kind of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum World {
    /// In the plane.
    Plane,
    /// Around the axis.
    Rings,
    /// In space.
    Space,
}

/// A side of a part, or the profile of a disc.
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    /// Part and side.
    Side(usize, SideOf),
    /// Disc.
    Disc(usize),
}

/// A rigid disc in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Node at its centre.
    pub node: usize,
    /// Radius.
    pub radius: f64,
}

/// A pair of contact.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// Slave.
    pub slave: Surface,
    /// Master.
    pub master: Surface,
    /// Surface to surface instead of node to surface.
    pub mortar: bool,
}

/// What the surfaces of pairs are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skins {
    /// The sides that face one another.
    Facing,
    /// All outer faces of both parts.
    Whole,
}

/// What is prescribed along the axes.
pub type Prescribed = [Option<f64>; 3];

/// A step of period 1.
#[derive(Clone, Debug, Default)]
pub struct Step {
    /// First, smallest and largest increment.
    pub increments: [f64; 3],
    /// Motions of nodes.
    pub motions: Vec<(Vec<usize>, Prescribed)>,
    /// Forces on nodes, kept by later steps.
    pub loads: Vec<(usize, [f64; 3])>,
}

/// A model in natural units: moduli about 1, lengths about 1.
#[derive(Clone, Debug)]
pub struct Draft {
    /// Where it lives.
    pub world: World,
    /// Coordinates.
    pub nodes: Vec<[f64; 3]>,
    /// Parts and what they are made of.
    pub parts: Vec<(Part, Material)>,
    /// Thickness in the plane.
    pub thickness: f64,
    /// Rigid discs.
    pub discs: Vec<Disc>,
    /// Pairs.
    pub pairs: Vec<Pair>,
    /// What their surfaces are.
    pub skins: Skins,
    /// General contact instead of the pairs, which say where parts meet.
    pub general: bool,
    /// Whether it may be turned by right angles although not all that is held is held along all axes.
    pub quarter: bool,
    /// Whether the parts never meet: no contact may carry anything.
    pub apart: bool,
    /// The least force that must act at the end; zero: none need.
    pub least_force: f64,
    /// Law of pressure.
    pub normal: Normal,
    /// Friction.
    pub friction: Friction,
    /// Steps.
    pub steps: Vec<Step>,
    /// What may be asked.
    pub promise: Promise,
}

impl Draft {
    /// Nothing yet.
    pub fn new(world: World) -> Self {
        Self {
            world,
            nodes: Vec::new(),
            parts: Vec::new(),
            thickness: 1.0,
            discs: Vec::new(),
            pairs: Vec::new(),
            skins: Skins::Facing,
            general: false,
            quarter: false,
            apart: false,
            least_force: 0.0,
            normal: Normal::Hard,
            friction: Friction { mu: 0.0, stick: Stick::Default },
            steps: Vec::new(),
            promise: Promise::WellPosed,
        }
    }

    /// Number of coordinates.
    pub fn dimension(&self) -> usize {
        if self.world == World::Space { 3 } else { 2 }
    }

    /// Nodes of a side of a part.
    pub fn side(&self, part: usize, side: SideOf) -> Vec<usize> {
        self.parts[part].0.side(side)
    }

    /// The same with increments at most a fourth as long.
    pub fn finer(&self) -> Self {
        let mut finer = self.clone();
        for step in &mut finer.steps {
            let [first, least, most] = step.increments;
            step.increments = [0.25 * first, least, 0.25 * first.max(most).min(1.0)];
        }
        finer
    }
}
