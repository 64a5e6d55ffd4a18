//! A block of two cells as solids of any type, as a deck that faults are put into.

/// How a cell becomes elements.
#[derive(Clone, Copy, PartialEq)]
pub enum Shape {
    Quad,
    Triangle,
    Brick,
    Wedge,
    Tetrahedron,
}

/// A type of solids.
#[derive(Clone, Copy)]
pub struct Family {
    pub name: &'static str,
    pub shape: Shape,
    pub quadratic: bool,
}

impl Family {
    pub fn in_space(self) -> bool {
        matches!(self.shape, Shape::Brick | Shape::Wedge | Shape::Tetrahedron)
    }

    pub fn is_ring(self) -> bool {
        self.name.starts_with("CAX")
    }

    pub fn corners(self) -> usize {
        match self.shape {
            Shape::Quad | Shape::Tetrahedron => 4,
            Shape::Triangle => 3,
            Shape::Brick => 8,
            Shape::Wedge => 6,
        }
    }

    pub fn faces(self) -> usize {
        match self.shape {
            Shape::Triangle => 3,
            Shape::Quad | Shape::Tetrahedron => 4,
            Shape::Wedge => 5,
            Shape::Brick => 6,
        }
    }
}

const fn family(name: &'static str, shape: Shape, quadratic: bool) -> Family {
    Family { name, shape, quadratic }
}

/// One of every kind of cell, formulation and dimension.
pub const FAMILIES: [Family; 23] = [
    family("CPS4", Shape::Quad, false),
    family("CPS4R", Shape::Quad, false),
    family("CPE4", Shape::Quad, false),
    family("CPE4I", Shape::Quad, false),
    family("CAX4", Shape::Quad, false),
    family("CPS3", Shape::Triangle, false),
    family("CPE3", Shape::Triangle, false),
    family("CAX3", Shape::Triangle, false),
    family("CPS8", Shape::Quad, true),
    family("CPE8R", Shape::Quad, true),
    family("CAX8R", Shape::Quad, true),
    family("CPE8H", Shape::Quad, true),
    family("CPS6", Shape::Triangle, true),
    family("CPE6", Shape::Triangle, true),
    family("CAX6", Shape::Triangle, true),
    family("C3D8", Shape::Brick, false),
    family("C3D8I", Shape::Brick, false),
    family("C3D20", Shape::Brick, true),
    family("C3D20R", Shape::Brick, true),
    family("C3D6", Shape::Wedge, false),
    family("C3D15", Shape::Wedge, true),
    family("C3D4", Shape::Tetrahedron, false),
    family("C3D10", Shape::Tetrahedron, true),
];

const QUAD: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
const BRICK: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 1.0],
    [0.0, 1.0, 1.0],
];

impl Shape {
    /// The elements of a cell, by its corners.
    fn parts(self) -> &'static [&'static [usize]] {
        match self {
            Self::Quad => &[&[0, 1, 2, 3]],
            Self::Triangle => &[&[0, 1, 2], &[0, 2, 3]],
            Self::Brick => &[&[0, 1, 2, 3, 4, 5, 6, 7]],
            Self::Wedge => &[&[0, 1, 2, 4, 5, 6], &[0, 2, 3, 4, 6, 7]],
            Self::Tetrahedron => &[
                &[0, 1, 2, 6],
                &[0, 2, 3, 6],
                &[0, 3, 7, 6],
                &[0, 7, 4, 6],
                &[0, 4, 5, 6],
                &[0, 5, 1, 6],
            ],
        }
    }

    /// The corners beside each middle node.
    fn edges(self) -> &'static [[usize; 2]] {
        match self {
            Self::Quad => &[[0, 1], [1, 2], [2, 3], [3, 0]],
            Self::Triangle => &[[0, 1], [1, 2], [2, 0]],
            Self::Tetrahedron => &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
            Self::Wedge => {
                &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]]
            }
            Self::Brick => &[
                [0, 1],
                [1, 2],
                [2, 3],
                [3, 0],
                [4, 5],
                [5, 6],
                [6, 7],
                [7, 4],
                [0, 4],
                [1, 5],
                [2, 6],
                [3, 7],
            ],
        }
    }

    /// Corners that make the element run the wrong way round.
    pub fn turned(self) -> &'static [usize] {
        match self {
            Self::Quad => &[0, 3, 2, 1],
            Self::Triangle => &[0, 2, 1],
            Self::Brick => &[4, 5, 6, 7, 0, 1, 2, 3],
            Self::Wedge => &[3, 4, 5, 0, 1, 2],
            Self::Tetrahedron => &[0, 2, 1, 3],
        }
    }
}

/// A deck in pieces.
#[derive(Clone)]
pub struct Deck {
    pub family: Family,
    pub kind: String,
    /// Places of the nodes; their numbers are one more.
    pub nodes: Vec<[f64; 3]>,
    /// Numbers of the nodes of the elements.
    pub elements: Vec<Vec<usize>>,
    pub left: Vec<usize>,
    pub right: Vec<usize>,
    pub section: String,
    pub material: String,
    pub support: String,
    /// Cards in front of the step.
    pub more: String,
    pub load: String,
}

impl Deck {
    /// A sound block of two cells in a row: held at its left end, loaded at its right.
    pub fn new(family: Family) -> Self {
        let mut own = Self {
            family,
            kind: family.name.to_owned(),
            nodes: Vec::new(),
            elements: Vec::new(),
            left: Vec::new(),
            right: Vec::new(),
            section: "*SOLID SECTION, ELSET=ALL, MATERIAL=M\n".to_owned(),
            material: "*ELASTIC\n200.0, 0.3\n".to_owned(),
            support: format!("LEFT, 1, {}\n", if family.in_space() { 3 } else { 2 }),
            more: String::new(),
            load: "*CLOAD\nRIGHT, 2, 1.0E-3\n".to_owned(),
        };
        if !family.in_space() && !family.is_ring() {
            own.section += "1.0\n";
        }
        let begin = own.begin();
        for cell in 0..2 {
            for part in family.shape.parts() {
                let place = |corner: usize| {
                    let [x, y, z] = if family.in_space() { BRICK[corner] } else { QUAD[corner] };
                    [begin + f64::from(cell) + x, y, z]
                };
                let corners: Vec<[f64; 3]> = part.iter().map(|&corner| place(corner)).collect();
                own.element(&corners);
            }
        }
        own.left = own.at(begin);
        own.right = own.at(begin + 2.0);
        own
    }

    /// Where the block begins; rings have a hole.
    pub fn begin(&self) -> f64 {
        f64::from(u8::from(self.family.is_ring()))
    }

    fn at(&self, x: f64) -> Vec<usize> {
        (1..=self.nodes.len()).filter(|node| (self.nodes[node - 1][0] - x).abs() < 1e-9).collect()
    }

    fn element(&mut self, corners: &[[f64; 3]]) {
        let mut places = corners.to_vec();
        if self.family.quadratic {
            places.extend(self.family.shape.edges().iter().map(|&[a, b]| {
                std::array::from_fn::<f64, 3, _>(|axis| 0.5 * (corners[a][axis] + corners[b][axis]))
            }));
        }
        let nodes = places.iter().map(|place| self.node(*place)).collect();
        self.elements.push(nodes);
    }

    fn node(&mut self, place: [f64; 3]) -> usize {
        let is_it = |own: &[f64; 3]| own.iter().zip(&place).all(|(a, b)| (a - b).abs() < 1e-9);
        let found = self.nodes.iter().position(is_it);
        found.unwrap_or_else(|| {
            self.nodes.push(place);
            self.nodes.len() - 1
        }) + 1
    }

    /// The middle node of the first edge of the first element, with the corners beside it.
    pub fn first_edge(&self) -> [usize; 3] {
        let own = &self.elements[0];
        [own[0], own[self.family.corners()], own[1]]
    }

    /// Its text.
    pub fn text(&self) -> String {
        let list =
            |nodes: &[usize]| nodes.iter().map(|node| format!("{node},\n")).collect::<String>();
        let nodes = self.nodes.iter().enumerate();
        let nodes: String =
            nodes.map(|(k, [x, y, z])| format!("{}, {x:?}, {y:?}, {z:?}\n", k + 1)).collect();
        let mut elements = String::new();
        for (label, own) in self.elements.iter().enumerate() {
            let words: Vec<String> =
                [label + 1].iter().chain(own).map(ToString::to_string).collect();
            let lines: Vec<String> = words.chunks(10).map(|line| line.join(", ")).collect();
            elements += &(lines.join(",\n") + "\n");
        }
        format!(
            "*HEADING\na block\n*NODE\n{nodes}*ELEMENT, TYPE={}, ELSET=ALL\n{elements}*NSET, \
             NSET=LEFT\n{}*NSET, NSET=RIGHT\n{}{}*MATERIAL, NAME=M\n{}{}*BOUNDARY\n{}*STEP, \
             NLGEOM\n*STATIC\n1.0, 1.0\n{}*END STEP\n",
            self.kind,
            list(&self.left),
            list(&self.right),
            self.section,
            self.material,
            self.more,
            self.support,
            self.load
        )
    }
}
