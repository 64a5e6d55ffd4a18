//! Results of a committed state: points, pairs, elements and energies.

use serde::{Deserialize, Serialize};
use slideline_mech::contact::tangential::Tangential;
use slideline_model::{BeamSection, Element, Model, NodeIndex, Shape};

/// Contact status of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Status {
    /// No pressure.
    #[default]
    Open,
    /// Pressure, no sliding.
    Stick,
    /// Pressure, sliding (also a closed point without friction).
    Slip,
}

impl Status {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Stick => "stick",
            Self::Slip => "slip",
        }
    }
}

/// Whether friction acted at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum FrictionCall {
    /// Open, or frictionless.
    #[default]
    None,
    /// Called.
    Called,
    /// Closed with friction, but the onset did not call it.
    Dropped,
}

impl FrictionCall {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Called => "called",
            Self::Dropped => "dropped",
        }
    }
}

/// A contact point in a committed state.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ContactRow {
    /// Place of the pair in the model.
    pub pair: usize,
    /// The slave node.
    pub node: NodeIndex,
    /// Open, stick or slip.
    pub status: Status,
    /// Whether it is or ever was closed.
    pub ever_closed: bool,
    /// Gap, open positive [L]; infinite where the point faces no master.
    pub opening: f64,
    /// Contact pressure [F/L2].
    pub pressure: f64,
    /// Shear traction along the master's directions [F/L2].
    pub shear: Tangential,
    /// Accumulated slip along them while closed [L].
    pub slip: Tangential,
    /// These directions [1].
    pub directions: [[f64; 3]; 2],
    /// Tributary area, of slave faces that are covered in part the part that is covered [L2].
    pub area: f64,
    /// Whether friction was called.
    pub friction: FrictionCall,
    /// Current position of the point [L].
    pub position: [f64; 3],
    /// Outward normal of the master there; of a closed point that is spread over faces the force on the slave of a normal force
    /// of one [1].
    pub normal: [f64; 3],
    /// Place on the master along its direction of travel; of contact over faces the slip since it closed [L].
    pub along: f64,
    /// Friction work that this increment dropped [F L]; see the ledger.
    pub dropped_work: f64,
}

impl ContactRow {
    /// Shear traction as a vector [F/L2].
    pub fn shear_in_space(&self) -> [f64; 3] {
        self.in_space(self.shear)
    }

    /// Accumulated slip as a vector, along the directions that the master has now [L].
    pub fn slip_in_space(&self) -> [f64; 3] {
        self.in_space(self.slip)
    }

    fn in_space(&self, along: Tangential) -> [f64; 3] {
        let [one, other] = self.directions;
        std::array::from_fn(|axis| along[0] * one[axis] + along[1] * other[axis])
    }
}

/// A sum of forces.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Resultant {
    /// The force [F].
    pub force: [f64; 3],
    /// Its moment about the origin [F L].
    pub moment: [f64; 3],
}

impl Resultant {
    /// Adds a force that acts at a place.
    pub(crate) fn add(&mut self, force: [f64; 3], place: [f64; 3]) {
        let [[x, y, z], [fx, fy, fz]] = [place, force];
        let moment = [y * fz - z * fy, z * fx - x * fz, x * fy - y * fx];
        self.force.iter_mut().zip(force).for_each(|(sum, own)| *sum += own);
        self.moment.iter_mut().zip(moment).for_each(|(sum, own)| *sum += own);
    }

    /// Its moment about another place [F L].
    pub fn moment_about(&self, place: [f64; 3]) -> [f64; 3] {
        let mut own = *self;
        own.add(self.force.map(|force| -force), place);
        own.moment
    }
}

/// A contact pair in a committed state.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct PairRow {
    /// Rows of its points that are closed.
    pub closed: usize,
    /// Rows, other than those of held edges, that opened or closed in the increment.
    pub changes: usize,
    /// Deepest overclosure of a closed point [L]; zero without.
    pub penetration: f64,
    /// Its node.
    pub deepest: Option<NodeIndex>,
    /// How deep a slave face of contact that is spread over faces lies in the master beyond
    /// what the mean over it shows, in sizes of the face [1]; zero without.
    pub unseen_depth: f64,
    /// A node of that face.
    pub unseen: Option<NodeIndex>,
    /// Of contact at nodes: how far the master falls away from where it is met within a face of the slave, a
    /// mean over closed nodes by their forces, where the pair has carried most so far in the run [L].
    pub falls_away: f64,
    /// Of contact at nodes: how far the smoothed corners that they face lie off the corners of the master, in the
    /// same mean [L].
    pub smoothed_away: f64,
    /// Way by which the parts have come together: twice the energy of the model over the force of the pair [L];
    /// zero without force.
    pub approach: f64,
    /// Sum of the forces on the slaves [F].
    pub force: [f64; 3],
    /// Their moment about the origin [F L].
    pub moment: [f64; 3],
    /// What of both is of pressures.
    pub of_pressure: Resultant,
    /// What of both is of friction.
    pub of_friction: Resultant,
    /// Energy of the laws of its points [F L].
    pub energy: f64,
    /// Area of its closed points [L2].
    pub area: f64,
    /// Centre of that area [L]; zero without.
    pub centre: [f64; 3],
    /// Mean outward normal of the master over that area [1]; zero without.
    pub mean_normal: [f64; 3],
    /// What is left of all forces on slaves, masters and reference nodes
    /// together, relative to the sum of their magnitudes [1]: rounding.
    pub force_imbalance: f64,
    /// The same of moments [1].
    pub moment_imbalance: f64,
}

/// What passes through a surface of `*SECTION PRINT` in a committed state.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct SectionRow {
    /// Forces that act on the elements behind the surface at its nodes, and their moment.
    pub carried: Resultant,
    /// Its area [L2].
    pub area: f64,
    /// Centre of that area [L].
    pub centre: [f64; 3],
    /// Mean outward normal, of length one [1]; zero of a closed surface.
    pub normal: [f64; 3],
}

/// Section results of a beam element at its middle.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct BeamRow {
    /// Element label.
    pub label: u64,
    /// Its nodes.
    pub nodes: [NodeIndex; 2],
    /// Axial force N [F].
    pub axial_force: f64,
    /// Shear force V [F].
    pub shear_force: f64,
    /// Bending moment M [F L].
    pub bending_moment: f64,
    /// Axial strain, shear strain [1], curvature [1/L].
    pub strains: [f64; 3],
    /// Largest fibre strain, |axial| + |curvature| height / 2 [1].
    pub fibre_strain: f64,
}

impl BeamRow {
    /// That of a beam of a section with its results, in the order of its fields.
    pub(crate) fn of(beam: Element<'_>, section: &BeamSection, values: &[f64]) -> Self {
        let at = |place: usize| values.get(place).copied().unwrap_or_default();
        let strains = [at(3), at(4), at(5)];
        Self {
            label: beam.label,
            nodes: beam.ends(),
            axial_force: at(0),
            shear_force: at(1),
            bending_moment: at(2),
            strains,
            fibre_strain: fibre_strain(strains[0], strains[2], &section.shape),
        }
    }
}

/// Largest strain of a fibre [1] of the strain of the axis and its curvature.
fn fibre_strain(axial: f64, curvature: f64, shape: &Shape) -> f64 {
    let bottom = shape.bottom();
    let at = |height: f64| (axial - height * curvature).abs();
    at(bottom).max(at(bottom + shape.height()))
}

/// Results of the elements of a block. Elements that belong to one rigid body have
/// none.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct BlockResults {
    /// Index of the block in the model.
    pub block: usize,
    /// Index in the block of each element that has results.
    pub members: Vec<usize>,
    /// Values, element by element, each in the order of the fields of its type.
    pub values: Vec<f64>,
}

impl BlockResults {
    /// The elements with all their values.
    pub fn elements<'a>(
        &'a self,
        model: &'a Model,
    ) -> impl Iterator<Item = (Element<'a>, &'a [f64])> {
        let block = model.blocks.get(self.block);
        let width = block.map_or(1, |block| block.kind.all_values().max(1));
        let values = self.values.chunks_exact(width);
        block.into_iter().flat_map(move |block| {
            let members = self.members.iter().map(|&member| block.elements.get(member));
            members.zip(values.clone())
        })
    }
}

/// Energies since time 0 [F L].
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Energies {
    /// Work of supports and loads, trapezoidal rule over each increment.
    pub external_work: f64,
    /// Work of heat: what changes of temperature add to the strain energy.
    pub thermal_work: f64,
    /// Strain energy that the elements would give back.
    pub strain_energy: f64,
    /// Taken by their material for good, such as by plastic strain.
    pub material_dissipation: f64,
    /// Energy of the contact laws.
    pub contact_energy: f64,
    /// Dissipated by sliding.
    pub friction_dissipation: f64,
    /// Stored in elastic slip.
    pub friction_elastic: f64,
    /// Friction work that the onset dropped (the ledger).
    pub dropped_friction: f64,
    /// Dissipated by contact stabilisation.
    pub stabilisation: f64,
    /// Released where the structure jumped to another equilibrium.
    pub released_energy: f64,
    /// What removed elements and contact pairs held when they left, less what those brought that
    /// came back with strain.
    pub removed_energy: f64,
    /// External work and work of heat minus the change of everything else since the first
    /// converged state.
    pub balance: f64,
}

impl Energies {
    /// What elements and contact laws hold, or have taken for good: a function of their state.
    pub fn of_the_model(&self) -> f64 {
        self.strain_energy + self.material_dissipation + self.contact_energy
    }

    /// What supports, loads and heat have given.
    pub fn supplied(&self) -> f64 {
        self.external_work + self.thermal_work
    }

    /// What is stored, dissipated, released or removed: where the work went.
    pub fn taken(&self) -> f64 {
        self.of_the_model()
            + self.friction_elastic
            + self.friction_dissipation
            + self.stabilisation
            + self.released_energy
            + self.removed_energy
    }
}
