//! A model in natural units: what every class draws, before it is placed and
//! scaled.
//!
//! ```text
//!   class -> Draft (lengths about 1, E = 1) -> Placement -> deck text
//!              \------------------------------------------> judge
//! ```

/// Type of beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// Two nodes, shear-flexible.
    B21,
    /// Three nodes, shear-flexible.
    B22,
    /// Two nodes, shear-rigid.
    B23,
}

impl Element {
    /// Its keyword.
    pub fn word(self) -> &'static str {
        match self {
            Self::B21 => "B21",
            Self::B22 => "B22",
            Self::B23 => "B23",
        }
    }
}

/// A row of beams.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Type.
    pub element: Element,
    /// Nodes in order; of a ring the first one is not repeated.
    pub nodes: Vec<usize>,
    /// Whether the last node is joined to the first.
    pub closed: bool,
    /// Height of the section.
    pub height: f64,
    /// Modulus in moduli of the first chain.
    pub modulus: f64,
}

/// A piece of a profile.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// Where it ends.
    pub to: [f64; 2],
    /// Centre of an arc; a line without.
    pub centre: Option<[f64; 2]>,
}

/// What a profile bounds, for the judge: convex.
#[derive(Clone, Debug)]
pub enum Solid {
    /// Centre and radius.
    Disc([f64; 2], f64),
    /// Corners, counter-clockwise.
    Convex(Vec<[f64; 2]>),
}

/// A rigid body; its profile is run through with the material on the right.
#[derive(Clone, Debug)]
pub struct Body {
    /// Reference node.
    pub node: usize,
    /// Where the profile starts.
    pub start: [f64; 2],
    /// Its pieces.
    pub pieces: Vec<Piece>,
    /// What it bounds.
    pub solid: Solid,
}

/// Pressure over overclosure.
#[derive(Clone, Debug, PartialEq)]
pub enum Normal {
    /// No overclosure.
    Hard,
    /// Stiffness.
    Linear(f64),
    /// Clearance and pressure at touch.
    Exponential(f64, f64),
    /// Pressures and overclosures.
    Tabular(Vec<[f64; 2]>),
}

/// How sticking is treated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stick {
    /// As the program has it by default.
    Default,
    /// A length of elastic slip.
    ElasticSlip(f64),
    /// A fraction of the contact elements.
    Tolerance(f64),
    /// Exactly.
    Lagrange,
    /// Limit of the shear traction.
    Limit(f64),
    /// Kinetic coefficient and decay by slip rate.
    Decay(f64, f64),
}

/// Friction; none at mu = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Coefficient, the static one where there are two.
    pub mu: f64,
    /// Sticking.
    pub stick: Stick,
}

/// What lies on which side of a pair.
#[derive(Clone, Debug)]
pub enum Side {
    /// A row of beams.
    Chain(usize),
    /// A rigid body.
    Body(usize),
    /// Nodes alone.
    Nodes(Vec<usize>),
}

/// A contact pair.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Slave.
    pub slave: Side,
    /// Master.
    pub master: Side,
    /// Surface to surface instead of node to surface.
    pub integrated: bool,
    /// Smoothing of a master of beams.
    pub smooth: f64,
}

/// A spring: from a node to the ground along an axis (0, 1), or between two
/// nodes.
#[derive(Clone, Copy, Debug)]
pub enum Spring {
    /// Node, axis, stiffness.
    Ground(usize, usize, f64),
    /// Nodes, stiffness.
    Between(usize, usize, f64),
}

/// What a step prescribes at a node: displacements and rotation.
pub type Prescribed = [Option<f64>; 3];

/// A step of period 1.
#[derive(Clone, Debug, Default)]
pub struct Step {
    /// First, smallest and largest increment.
    pub increments: [f64; 3],
    /// Increments of fixed size.
    pub direct: bool,
    /// Drops what earlier steps prescribed.
    pub anew: bool,
    /// Motions.
    pub motions: Vec<(usize, Prescribed)>,
    /// Forces, kept by later steps.
    pub loads: Vec<(usize, [f64; 2])>,
}

/// What may be asked of the run beyond completing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Promise {
    /// Held, resolved, with an equilibrium that moves without a jump.
    WellPosed,
    /// May end in a diagnosis, but not wrong.
    Risky,
}

/// A model in natural units: modulus 1, lengths about 1.
#[derive(Clone, Debug)]
pub struct Draft {
    /// Coordinates.
    pub nodes: Vec<[f64; 2]>,
    /// Beams.
    pub chains: Vec<Chain>,
    /// Width of all sections and of contact.
    pub width: f64,
    /// Rigid bodies.
    pub bodies: Vec<Body>,
    /// Rigid links: dependent node, master.
    pub links: Vec<[usize; 2]>,
    /// Springs.
    pub springs: Vec<Spring>,
    /// Law of pressure of all pairs.
    pub normal: Normal,
    /// Friction of all pairs.
    pub friction: Friction,
    /// Pairs.
    pub pairs: Vec<Pair>,
    /// Steps.
    pub steps: Vec<Step>,
    /// What may be asked.
    pub promise: Promise,
    /// Whether the final state does not depend on the increments.
    pub reversible: bool,
}

impl Draft {
    /// Nothing yet.
    pub fn new(width: f64) -> Self {
        Self {
            nodes: Vec::new(),
            chains: Vec::new(),
            width,
            bodies: Vec::new(),
            links: Vec::new(),
            springs: Vec::new(),
            normal: Normal::Hard,
            friction: Friction { mu: 0.0, stick: Stick::Default },
            pairs: Vec::new(),
            steps: Vec::new(),
            promise: Promise::WellPosed,
            reversible: false,
        }
    }

    /// A further node.
    pub fn node(&mut self, at: [f64; 2]) -> usize {
        self.nodes.push(at);
        self.nodes.len() - 1
    }

    /// Beams of one type along a curve over 0 to 1.
    pub fn beams(
        &mut self,
        (element, count): (Element, usize),
        height: f64,
        curve: impl Fn(f64) -> [f64; 2],
    ) -> usize {
        let intervals = if element == Element::B22 { 2 * count } else { count };
        let points = (0..=intervals).map(|k| curve(k as f64 / intervals as f64));
        let nodes = points.map(|at| self.node(at)).collect();
        self.chains.push(Chain { element, nodes, closed: false, height, modulus: 1.0 });
        self.chains.len() - 1
    }

    /// A disc; `quarters` of its rim from +x over -y are its profile.
    pub fn disc(&mut self, centre: [f64; 2], radius: f64, quarters: usize) -> usize {
        self.arc(centre, radius, 0.0, quarters)
    }

    /// A disc whose profile begins at an angle, clockwise, by quarters.
    pub fn arc(&mut self, centre: [f64; 2], radius: f64, angle: f64, quarters: usize) -> usize {
        let node = self.node(centre);
        let rim = |k: usize| {
            let (sin, cos) = (angle - k as f64 * std::f64::consts::FRAC_PI_2).sin_cos();
            [centre[0] + radius * cos, centre[1] + radius * sin]
        };
        let pieces = (1..=quarters).map(|k| Piece { to: rim(k), centre: Some(centre) }).collect();
        let solid = Solid::Disc(centre, radius);
        self.bodies.push(Body { node, start: rim(0), pieces, solid });
        self.bodies.len() - 1
    }

    /// A body of straight edges; the solid is the profile, closed over
    /// `back`, corners in the order of travel.
    pub fn polygon(&mut self, reference: [f64; 2], edge: &[[f64; 2]], back: &[[f64; 2]]) -> usize {
        let node = self.node(reference);
        let pieces = edge[1..].iter().map(|&to| Piece { to, centre: None }).collect();
        let mut corners: Vec<_> = edge.iter().chain(back).copied().collect();
        corners.reverse();
        let solid = Solid::Convex(corners);
        self.bodies.push(Body { node, start: edge[0], pieces, solid });
        self.bodies.len() - 1
    }

    /// Bending stiffness of a row.
    pub fn bending(&self, chain: usize) -> f64 {
        let Chain { height, modulus, .. } = self.chains[chain];
        modulus * self.width * height.powi(3) / 12.0
    }

    /// First and last node of a row.
    pub fn ends(&self, chain: usize) -> [usize; 2] {
        let nodes = &self.chains[chain].nodes;
        [nodes[0], nodes[nodes.len() - 1]]
    }

    /// The same with increments at most a fourth as long.
    pub fn finer(&self) -> Self {
        let mut finer = self.clone();
        for step in &mut finer.steps {
            let largest = step.increments[0].max(step.increments[2]).min(1.0);
            step.increments = [0.25 * step.increments[0], step.increments[1], 0.25 * largest];
        }
        finer
    }
}
