//! Faces that general contact leaves to a tie, to a pair of their own, or out: they still hide the far
//! sides of their part.
//!
//! ```text
//!      |  upper |
//!   +--+~~~~~~~~+--+    nodes of the upper block within ~~~ must not meet the sides of the lower one
//!   |    lower     |
//!   +--------------+
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::fmt::Write;
use std::ops::ControlFlow;

/// What is said of the faces between both blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Said {
    /// They are tied, and there is no general contact.
    TiedAlone,
    Tied,
    Pair,
    Excluded,
    /// They have a surface interaction of their own.
    Assigned,
    /// They are in general contact like all others.
    Nothing,
}

/// Two blocks of so many elements along each side, the lower one as wide as the upper one or wider.
#[derive(Clone, Copy, Debug)]
struct Blocks {
    in_space: bool,
    across: [u32; 2],
    wide: bool,
    said: Said,
}

/// Adds a block, its nodes and elements counted from `base`; gives the nodes at its ends, below and above.
fn block(
    deck: &mut String,
    own: &Blocks,
    (name, base, count): (&str, u32, u32),
    (low, width, from): (f64, f64, f64),
) -> [Vec<u32>; 2] {
    let deep = if own.in_space { count } else { 0 };
    let node = |i: u32, j: u32, k: u32| base + i + 10 * j + 100 * k;
    let at = |i: u32| low + width * f64::from(i) / f64::from(count);
    deck.push_str("*NODE\n");
    let mut ends = [Vec::new(), Vec::new()];
    for k in 0..=2 {
        for (i, j) in (0..=deep).flat_map(|j| (0..=count).map(move |i| (i, j))) {
            let (own_node, height) = (node(i, j, k), from + 0.5 * f64::from(k));
            match own.in_space {
                true => writeln!(deck, "{own_node}, {}, {}, {height}", at(i), at(j)).unwrap(),
                false => writeln!(deck, "{own_node}, {}, {height}", at(i)).unwrap(),
            }
            match k {
                0 => ends[0].push(own_node),
                2 => ends[1].push(own_node),
                _ => {}
            }
        }
    }
    for (k, layer) in ["BOTTOM", "TOP"].into_iter().enumerate() {
        let kind = if own.in_space { "C3D8" } else { "CPE4" };
        writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET={name}-{layer}").unwrap();
        let k = k as u32;
        for (i, j) in (0..deep.max(1)).flat_map(|j| (0..count).map(move |i| (i, j))) {
            let [a, b] = [k, k + 1].map(|k| {
                [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)]
            });
            let cell = match own.in_space {
                true => [a, b].concat(),
                false => vec![a[0], a[1], b[1], b[0]],
            };
            let cell: Vec<String> = cell.iter().map(u32::to_string).collect();
            writeln!(deck, "{}, {}", node(i, j, k), cell.join(", ")).unwrap();
        }
    }
    write!(deck, "*ELSET, ELSET={name}\n{name}-BOTTOM, {name}-TOP\n").unwrap();
    write!(deck, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.\n").unwrap();
    ends
}

/// What the deck says of the faces between both blocks.
fn contact(own: &Blocks) -> String {
    let between = "LOW-FACE, UP-FACE";
    let general = |more: &str| {
        format!(
            "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n{more}*CONTACT PROPERTY ASSIGNMENT\n, , DRY\n"
        )
    };
    match own.said {
        Said::TiedAlone => "*TIE, NAME=T\nUP-FACE, LOW-FACE\n".to_owned(),
        Said::Tied => format!("*TIE, NAME=T\nUP-FACE, LOW-FACE\n{}", general("")),
        Said::Pair => {
            format!("*CONTACT PAIR, INTERACTION=DRY\nUP-FACE, LOW-FACE\n{}", general(""))
        }
        Said::Excluded => general(&format!("*CONTACT EXCLUSIONS\n{between}\n")),
        Said::Assigned => format!("{}{between}, OTHER\n", general("")),
        Said::Nothing => general(""),
    }
}

impl Blocks {
    /// The deck, with the nodes that are driven: by that much along the height.
    fn deck(&self, driven: f64) -> (String, Vec<u32>) {
        let mut deck = String::from("*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n");
        let (low, width) = if self.wide { (-0.5, 3.0) } else { (0.0, 2.0) };
        let lower = block(&mut deck, self, ("LOW", 1000, self.across[1]), (low, width, 0.0));
        let upper = block(&mut deck, self, ("UP", 2000, self.across[0]), (0.0, 2.0, 1.0));
        let [under, over] = if self.in_space { ["S1", "S2"] } else { ["S1", "S3"] };
        write!(deck, "*SURFACE, NAME=UP-FACE\nUP-BOTTOM, {under}\n").unwrap();
        write!(deck, "*SURFACE, NAME=LOW-FACE\nLOW-TOP, {over}\n").unwrap();
        for name in ["DRY", "OTHER"] {
            write!(deck, "*SURFACE INTERACTION, NAME={name}\n*FRICTION\n.3\n").unwrap();
        }
        deck.push_str(&contact(self));
        let last = if self.in_space { 3 } else { 2 };
        deck.push_str("*STEP, NLGEOM\n*STATIC\n.25, 1., 1.E-6, .25\n*BOUNDARY\n");
        for node in &lower[0] {
            writeln!(deck, "{node}, 1, {last}").unwrap();
        }
        for node in &upper[1] {
            writeln!(deck, "{node}, 1, {}\n{node}, {last}, {last}, {driven}", last - 1).unwrap();
        }
        deck.push_str("*END STEP\n");
        (deck, upper[1].clone())
    }

    /// The force on what is driven, along its way.
    fn force(&self, driven: f64) -> f64 {
        let (deck, nodes) = self.deck(driven);
        let read = Job::read_text("left_out", &deck, &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
        let axis = if self.in_space { Dof::U3 } else { Dof::U2 };
        let mut seen = Force { nodes, axis, sum: 0.0 };
        let ending = solve(&model, &SolveOptions::default(), &mut seen);
        assert!(matches!(ending, Ending::Completed(_)), "{self:?}: {ending:?}");
        seen.sum
    }
}

struct Force {
    nodes: Vec<u32>,
    axis: Dof,
    sum: f64,
}

impl Observer for Force {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        let Event::Committed(frame) = event else { return ControlFlow::Continue(()) };
        let place = |&node: &u32| frame.model.nodes.find(u64::from(node)).unwrap();
        let reaction = |node| frame.nodal.reaction(node, self.axis);
        self.sum = self.nodes.iter().map(place).map(reaction).sum();
        ControlFlow::Continue(())
    }
}

fn all() -> impl Iterator<Item = Blocks> {
    let meshes = [[2, 2], [3, 2]];
    let kinds = [false, true].into_iter().flat_map(|in_space| [false, true].map(|w| (in_space, w)));
    let said = Said::Nothing;
    kinds.flat_map(move |(in_space, wide)| {
        meshes.map(|across| Blocks { in_space, across, wide, said })
    })
}

/// Requirement: general contact beside a tie changes no force of what is tied.
#[test]
fn general_contact_leaves_ties_alone() {
    for own in all() {
        let [tied, alone] =
            [Said::Tied, Said::TiedAlone].map(|said| Blocks { said, ..own }.force(-0.02));
        assert!((tied - alone).abs() <= 1e-9 * alone.abs(), "{own:?}: {tied} {alone}");
    }
}

/// Requirement: faces that a pair has, or another line of properties, carry as in general contact alone.
#[test]
fn faces_of_a_pair_or_of_a_line_carry_what_they_carried() {
    for own in all() {
        let expected = own.force(-0.02);
        assert!(expected < 0.0);
        // a coarse slave that is wider than its master, cut by lines of properties, finds no equilibrium
        let said = if own.wide { vec![Said::Pair] } else { vec![Said::Pair, Said::Assigned] };
        for said in said {
            let force = Blocks { said, ..own }.force(-0.02);
            assert!((force / expected - 1.0).abs() < 0.07, "{own:?} {said:?}: {force} {expected}");
        }
    }
}

/// Requirement: excluded faces carry nothing, and nodes behind them meet no other face through them.
#[test]
fn excluded_faces_carry_nothing() {
    for own in all() {
        for driven in [-0.02, 0.02] {
            let force = Blocks { said: Said::Excluded, ..own }.force(driven);
            assert!(force.abs() < 1e-9, "{own:?}: {force}");
        }
    }
}
