//! Which cell a type of Abaqus and CalculiX names. A mesh is read for its cells: that a type has no
//! counterpart among the elements here does not stand against it.

use slideline_model::element_type;

/// Families of types with the dimension of their cells; behind them stands the number of nodes.
/// Longer names come first. [Abaqus 6.14 Analysis User's Guide, Elements; CalculiX 2.20 manual,
/// section 6.2]
const FAMILIES: &[(&str, usize)] = &[
    ("DC3D", 3),
    ("AC3D", 3),
    ("C3D", 3),
    ("DC2D", 2),
    ("AC2D", 2),
    ("DCAX", 2),
    ("ACAX", 2),
    ("CGAX", 2),
    ("CPEG", 2),
    ("CAX", 2),
    ("CPE", 2),
    ("CPS", 2),
    ("M3D", 2),
    ("R3D", 2),
    ("SFM3D", 2),
    ("STRI", 2),
    ("DS", 2),
    ("SC", 3),
    ("S", 2),
    ("T2D", 1),
    ("T3D", 1),
    ("R2D", 1),
    ("RAX", 1),
];

/// Dimension and number of nodes of the cell of a type, whose name is in capitals; `None`: unknown.
pub(crate) fn shape(kind: &str) -> Option<(usize, usize)> {
    if let Some(own) = element_type(kind) {
        return Some((own.cell.dimension, own.cell.nodes));
    }
    // the number of a beam is that of its dimension and that of its shape functions
    if let Some(order) = kind.strip_prefix("B2").or_else(|| kind.strip_prefix("B3")) {
        return Some((1, if order.starts_with('2') { 3 } else { 2 }));
    }
    if kind == "STRI65" {
        return Some((2, 6)); // six nodes with five dofs
    }
    let count = |rest: &str| {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        rest[..digits].parse().ok()
    };
    let (rest, dimension) = FAMILIES
        .iter()
        .find_map(|(family, dimension)| Some((kind.strip_prefix(family)?, *dimension)))?;
    Some((dimension, count(rest)?))
}

/// Nodes of every face of a cell, by their places in it; none where elements here have no such cell.
pub(crate) fn faces(dimension: usize, nodes: usize) -> &'static [&'static [usize]] {
    let family = if dimension == 3 { "C3D" } else { "CPS" };
    element_type(&format!("{family}{nodes}"))
        .filter(|own| own.cell.dimension == dimension)
        .map_or(&[], |own| own.cell.faces)
}

#[cfg(test)]
mod tests {
    use super::shape;

    #[test]
    fn types_of_other_programs_have_shapes() {
        let told = [
            ("C3D8RH", (3, 8)),
            ("C3D20R", (3, 20)),
            ("CAX4P", (2, 4)),
            ("CPEG4R", (2, 4)),
            ("DC2D3", (2, 3)),
            ("R3D3", (2, 3)),
            ("S4R5", (2, 4)),
            ("S8R", (2, 8)),
            ("STRI3", (2, 3)),
            ("STRI65", (2, 6)),
            ("SC8R", (3, 8)),
            ("SFM3D4R", (2, 4)),
            ("M3D6", (2, 6)),
            ("B31H", (1, 2)),
            ("B32OS", (1, 3)),
            ("B33", (1, 2)),
            ("T3D2H", (1, 2)),
        ];
        for (kind, cell) in told {
            assert_eq!(shape(kind), Some(cell), "{kind}");
        }
        assert_eq!(shape("MASS"), None);
    }
}
