//! Types of Abaqus and CalculiX that are another type of this program by another name.
//!
//! ```text
//!   CPE4RH ---> CPE4R    its one pressure is that of its one point
//!   C3D10M ---> C3D10    solved as the quadratic tetrahedron that it is
//! ```

use super::element_type::ElementType;
use super::table::element_type;

/// Types that are read as others for one reason: the reason, and both names of each.
type Group = (&'static str, &'static [(&'static str, &'static str)]);

/// All of them.
const GROUPS: &[Group] = &[
    (
        "the pressure of a hybrid element of one point is that of the point",
        &[
            ("CPE3H", "CPE3"),
            ("CPE4RH", "CPE4R"),
            ("CAX3H", "CAX3"),
            ("CAX4RH", "CAX4R"),
            ("C3D8RH", "C3D8R"),
        ],
    ),
    (
        "a wedge of one pressure has free motions; where a wedge locks, SL0416 says so",
        &[("C3D6H", "C3D6"), ("C3D15H", "C3D15")],
    ),
    (
        "one pressure an element; incompatible modes lose stability where the volume is kept",
        &[("CPE4IH", "CPE4H"), ("CAX4IH", "CAX4H"), ("C3D8IH", "C3D8H")],
    ),
    (
        "with fewer points a hybrid element has motions without stiffness: all points are taken",
        &[("CPE8RH", "CPE8H"), ("CAX8RH", "CAX8H"), ("C3D20RH", "C3D20H")],
    ),
    (
        "its few points keep it from locking where the volume is kept",
        &[
            ("CPE6H", "CPE6"),
            ("CPE6MH", "CPE6"),
            ("CAX6H", "CAX6"),
            ("CAX6MH", "CAX6"),
            ("C3D20RI", "C3D20R"),
        ],
    ),
    (
        "quadratic elements need no modification for contact here",
        &[
            ("CPS6M", "CPS6"),
            ("CPE6M", "CPE6"),
            ("CAX6M", "CAX6"),
            ("C3D10M", "C3D10"),
            ("C3D10MH", "C3D10H"),
        ],
    ),
    (
        "stresses at nodes come from all integration points",
        &[
            ("C3D8S", "C3D8"),
            ("C3D8HS", "C3D8H"),
            ("C3D10HS", "C3D10H"),
            ("C3D10I", "C3D10"),
            ("C3D10T", "C3D10"),
        ],
    ),
    (
        "a beam or a truss has no stress that its nodes do not give",
        &[
            ("B21H", "B21"),
            ("B22H", "B22"),
            ("B31H", "B31"),
            ("B32H", "B32"),
            ("T2D2H", "T2D2"),
            ("T2D3H", "T2D3"),
            ("T3D2H", "T3D2"),
            ("T3D3H", "T3D3"),
        ],
    ),
    ("of CalculiX, with as many points", &[("B31R", "B31"), ("B32R", "B32")]),
    (
        "its section says that it is a pipe; pressure inside does not load it",
        &[("PIPE21", "B21"), ("PIPE22", "B22"), ("PIPE31", "B31"), ("PIPE32", "B32")],
    ),
];

/// The row that a type of another program is read as, and why it may be.
pub fn read_as(name: &str) -> Option<(&'static ElementType, &'static str)> {
    let mut all = GROUPS.iter().flat_map(|(why, pairs)| pairs.iter().map(move |pair| (pair, *why)));
    let (&(_, row), why) = all.find(|(pair, _)| pair.0 == name)?;
    Some((element_type(row)?, why))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_mech::element::cell::Cell;

    /// Requirement: every other name leads to a row of the same family with as many nodes, and is
    /// no name of a row.
    #[test]
    fn other_names_lead_to_rows() {
        for (name, row) in GROUPS.iter().flat_map(|(_, pairs)| *pairs) {
            assert!(element_type(name).is_none(), "{name}");
            let (found, why) = read_as(name).unwrap();
            assert_eq!(found.name(), *row);
            assert!(!why.is_empty());
            let Cell { nodes, .. } = found.cell;
            let digits = |text: &str| -> String {
                let text = text.trim_start_matches("C3D").trim_start_matches("PIPE");
                text.chars().filter(char::is_ascii_digit).collect()
            };
            assert!(digits(name) == digits(row) && *nodes > 0, "{name} {row}");
        }
    }
}
