//! What tied nodes follow as means of the master over the faces around them.
//!
//! ```text
//!   slave    o---------o---------o     the row of a node: shares of the master's nodes over both
//!   master   o----o-------o------o     faces that it belongs to, over its area of them
//! ```
//!
//! docs/theory.md section 4.11

use std::collections::{BTreeMap, HashMap, HashSet};

use slideline_mech::contact::pair::mortar_faces::{Cover, FaceEnds, FacePlaces, Faced};
use slideline_mech::contact::pair::{TiedFace, own_part, share_of_corner};
use slideline_mech::pressure::{Face, MOST_NODES};
use slideline_model::NodeIndex;

use super::master::Master;
use crate::draft::Draft;

/// Part of its area that a node must have before the master, to follow a mean [1]. (choice)
const COVERED: f64 = 0.01;

/// Nodes with their shares in what follows them.
pub(super) type Shares = Vec<(NodeIndex, f64)>;

/// Rows of the nodes that follow means, an axis each.
pub(super) type Means = [HashMap<NodeIndex, Shares>; 3];

/// A slave face with its integrals.
struct Slave {
    nodes: Vec<NodeIndex>,
    tied: TiedFace,
}

/// The rows of those nodes of slave faces that a mean holds. `follows` says whether a node may follow
/// a mean along an axis.
pub(super) fn means(
    faces: &[Vec<NodeIndex>],
    (masters, tolerance): (&[Master], Option<f64>),
    follows: impl Fn(NodeIndex, usize) -> bool,
    draft: &Draft,
) -> Means {
    let slaves = slaves(faces, (masters, tolerance), draft);
    let covered = covered(&slaves);
    let mut means = Means::default();
    let mut known: Vec<(HashSet<NodeIndex>, usize)> = Vec::new();
    for axis in 0..if draft.model.is_in_space() { 3 } else { 2 } {
        let may = |node: &NodeIndex| covered.contains(node) && follows(*node, axis);
        let mut all: HashSet<NodeIndex> =
            slaves.iter().flat_map(|own| &own.nodes).copied().filter(|node| may(node)).collect();
        leave_corners(&slaves, &mut all);
        match known.iter().find(|(own, _)| *own == all) {
            Some(&(_, same)) => means[axis] = means[same].clone(),
            None => means[axis] = rows(&slaves, masters, &all),
        }
        known.push((all, axis));
    }
    means
}

/// How much of a uniform pressure on the slave reaches other nodes of the master than it should,
/// where the slave's nodes follow these shares, over all of it [1].
pub(super) fn misplaced(
    faces: &[Vec<NodeIndex>],
    (masters, tolerance): (&[Master], Option<f64>),
    shares: &HashMap<NodeIndex, Shares>,
    draft: &Draft,
) -> f64 {
    let mut off: BTreeMap<NodeIndex, f64> = BTreeMap::new();
    let mut whole = 0.0;
    for own in slaves(faces, (masters, tolerance), draft) {
        let (forces, of_master) = own.tied.pressed();
        for (node, force) in own.nodes.iter().zip(forces) {
            let Some(shares) = shares.get(node) else { continue };
            whole += force;
            for &(of, share) in shares {
                *off.entry(of).or_default() += share * force;
            }
        }
        for (master, forces) in of_master {
            for (&node, force) in masters[master].nodes.iter().zip(forces) {
                *off.entry(node).or_default() -= force;
            }
        }
    }
    // what is missing at one node is too much at others
    let sum: f64 = off.values().map(|off| off.abs()).sum();
    if whole > 0.0 { 0.5 * sum / whole } else { 0.0 }
}

fn slaves(faces: &[Vec<NodeIndex>], of: (&[Master], Option<f64>), draft: &Draft) -> Vec<Slave> {
    let mut cover = Cover::default();
    faces.iter().filter_map(|nodes| slave(nodes, of, &mut cover, draft)).collect()
}

fn slave(
    nodes: &[NodeIndex],
    (masters, tolerance): (&[Master], Option<f64>),
    cover: &mut Cover,
    draft: &Draft,
) -> Option<Slave> {
    let x: Vec<[f64; 3]> = nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
    let in_space = draft.model.is_in_space();
    let edge = match draft.model.is_of_rings() {
        true => Face::of_ring(nodes.len()),
        false => Face::of(if in_space { 3 } else { 2 }, nodes.len(), 1.0),
    }?;
    let own = Master::new(edge, nodes.to_vec(), draft);
    let near = masters.iter().enumerate().filter(|(_, master)| {
        let reach = master.reach(tolerance) + 0.25 * (master.size + own.size);
        (0..3).all(|k| master.low[k] - reach <= own.high[k] && own.low[k] - reach <= master.high[k])
    });
    let near: Vec<(usize, &Master)> = near.collect();
    let mut tied = match in_space {
        true => {
            let faced = near.iter().map(|(_, master)| (faced(master), master.reach(tolerance)));
            TiedFace::in_space(&x, &faced.collect::<Vec<_>>(), cover)
        }
        false => {
            let faced = near.iter().map(|(_, own)| (own.face, own.x.clone(), own.reach(tolerance)));
            TiedFace::in_plane(edge, &x, &faced.collect::<Vec<_>>())
        }
    };
    tied.number_masters(|place| near[place].0);
    Some(Slave { nodes: nodes.to_vec(), tied })
}

fn faced(master: &Master) -> Faced {
    let places = FacePlaces::new(&master.x);
    Faced {
        face: 0,
        nodes: [0; MOST_NODES],
        places,
        ends: FaceEnds::default(),
        thickness: f64::INFINITY,
    }
}

/// The nodes that have enough of their area before the master.
fn covered(slaves: &[Slave]) -> HashSet<NodeIndex> {
    let mut areas: HashMap<NodeIndex, (f64, f64)> = HashMap::new();
    for own in slaves {
        for (place, &node) in own.nodes.iter().enumerate() {
            let [whole, before] = own.tied.areas(place);
            let sum = areas.entry(node).or_default();
            *sum = (sum.0 + whole, sum.1 + before);
        }
    }
    let enough = areas.into_iter().filter(|(_, (whole, before))| *before > COVERED * whole);
    enough.map(|(node, _)| node).collect()
}

/// Corners beside a middle node that follows no mean do not either: what is that node's own is told
/// with its corners.
fn leave_corners(slaves: &[Slave], all: &mut HashSet<NodeIndex>) {
    let mut left = HashSet::new();
    for own in slaves {
        for (place, node) in own.nodes.iter().enumerate() {
            if let Some(corners) = own_part(own.nodes.len(), place).1
                && !all.contains(node)
            {
                left.extend(corners.map(|corner| own.nodes[corner]));
            }
        }
    }
    all.retain(|node| !left.contains(node));
}

/// The rows of all nodes that follow.
fn rows(
    slaves: &[Slave],
    masters: &[Master],
    all: &HashSet<NodeIndex>,
) -> HashMap<NodeIndex, Shares> {
    let mut sums: HashMap<NodeIndex, (f64, Shares)> = HashMap::new();
    for own in slaves {
        let follows = std::array::from_fn(|k| own.nodes.get(k).is_some_and(|n| all.contains(n)));
        for (place, row) in own.tied.rows(&follows).into_iter().flatten() {
            let (area, shares) = sums.entry(own.nodes[place]).or_default();
            *area += row.area;
            for (master, of) in &row.master {
                let nodes = masters[*master].nodes.iter().zip(of);
                nodes.for_each(|(&node, &share)| add(shares, node, share));
            }
            for (other, &share) in row.own.iter().enumerate().filter(|(_, share)| **share != 0.0) {
                own_terms(own, other, -share, shares);
            }
        }
    }
    let mean = |(area, shares): (f64, Shares)| {
        shares.into_iter().map(|(node, share)| (node, share / area)).collect::<Shares>()
    };
    let mut rows: HashMap<NodeIndex, Shares> = sums
        .into_iter()
        .filter(|(_, (area, _))| *area > 0.0)
        .map(|(node, sum)| (node, mean(sum)))
        .collect();
    middle_nodes(slaves, &mut rows);
    rows
}

/// What is a node's own as the functions of its face have it.
fn own_terms(own: &Slave, place: usize, share: f64, shares: &mut Shares) {
    let (part, corners) = own_part(own.nodes.len(), place);
    add(shares, own.nodes[place], share / part);
    for corner in corners.into_iter().flatten() {
        add(shares, own.nodes[corner], -share * share_of_corner() / part);
    }
}

/// From what is their own to the middle nodes themselves.
fn middle_nodes(slaves: &[Slave], rows: &mut HashMap<NodeIndex, Shares>) {
    let mut done = HashSet::new();
    for own in slaves {
        for (place, &node) in own.nodes.iter().enumerate() {
            let (part, Some(corners)) = own_part(own.nodes.len(), place) else { continue };
            let Some(row) = rows.get(&node).filter(|_| done.insert(node)) else { continue };
            let mut whole: Shares = row.iter().map(|&(of, share)| (of, part * share)).collect();
            for corner in corners.map(|corner| own.nodes[corner]) {
                match rows.get(&corner) {
                    Some(row) => row
                        .iter()
                        .for_each(|&(of, share)| add(&mut whole, of, share_of_corner() * share)),
                    None => add(&mut whole, corner, share_of_corner()),
                }
            }
            rows.insert(node, whole);
        }
    }
}

fn add(shares: &mut Shares, node: NodeIndex, share: f64) {
    match shares.iter_mut().find(|(own, _)| *own == node) {
        Some((_, sum)) => *sum += share,
        None => shares.push((node, share)),
    }
}
