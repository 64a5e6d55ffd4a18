//! What a summary remembers of the states of a run: the largest of everything.

use crate::json::{Value, json};
use crate::outline::edges;
use crate::section::space_beams;
use serde::{Deserialize, Serialize};
use slideline_mech::element::cell::Piece;
use slideline_model::Limit;
use slideline_results::element::{Quantity, mises, solids};
use slideline_results::place;
use slideline_solve::observe::Frame;
use std::collections::BTreeMap;
use std::time::Duration;

/// Smallest and largest value of a curve, each with its time.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Peak {
    pub least: (f64, f64),
    pub most: (f64, f64),
}

/// A value, the number of whom it belongs to, and its total time.
pub(super) type Largest = Option<(f64, u64, f64)>;

/// What a summary remembers of the events of a run.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Memory {
    /// Wall time of the runs that this one goes on from; with its own, where
    /// it is saved.
    pub(super) before: Duration,
    /// JSON text of each.
    pub(super) warnings: Vec<String>,
    pub(super) peaks: Vec<Option<Peak>>,
    /// Largest fibre strain of a beam.
    pub(super) strain: Largest,
    /// Largest strain over the allowable one.
    pub(super) used: Largest,
    /// Largest normal force of a contact pair.
    pub(super) normal: Largest,
    /// Largest turn or strain of an element under linear kinematics.
    pub(super) linear: Largest,
    /// Largest Mises stress at a point of a solid.
    pub(super) mises: Largest,
    /// Largest equivalent plastic strain there.
    pub(super) plastic: Largest,
    /// Largest principal strain there, where the law is linear.
    pub(super) principal: Largest,
    /// Largest nominal strain where a rubber is beyond its stability.
    pub(super) unstable: Largest,
    /// The most that rounding may have made of energies [F L].
    pub(super) energy_rounding: f64,
    /// The most that energies which do not balance say nothing by [F L].
    pub(super) energy_unsure: f64,
}

impl Memory {
    /// Largest strain, its share of the allowable one, stress, largest normal force, and what
    /// rounding may have made of energies.
    pub fn say(&self, object: &mut Value, pairs: &[String]) {
        object["energy_rounding"] = json!(self.energy_rounding);
        object["energy_unsure"] = json!(self.energy_unsure);
        let own = [
            ("mises", self.mises),
            ("plastic_strain", self.plastic),
            ("principal_strain", self.principal),
            ("unstable_strain", self.unstable),
            ("linear_motion", self.linear),
        ];
        for (key, largest) in own {
            if let Some((max, element, time)) = largest {
                object[key] = json!({"max": max, "element": element, "time": time});
            }
        }
        if let Some((max, element, time)) = self.strain {
            object["fibre_strain"] = json!({"max": max, "element": element, "time": time});
        }
        if let Some((used, element, time)) = self.used {
            object["allowable"] = json!({
                "utilisation": used,
                "margin": 1.0 / used - 1.0,
                "pass": used <= 1.0,
                "element": element,
                "time": time,
            });
        }
        if let Some((max, pair, time)) = self.normal {
            let pair = pairs.get(pair as usize).map_or("?", String::as_str);
            object["normal_force"] = json!({"max": max, "pair": pair, "time": time});
        }
    }

    /// Takes in strains of beams, and what of their allowable that is.
    pub(super) fn follow_beams(&mut self, frame: &Frame<'_>, allowable: &BTreeMap<u64, f64>) {
        let time = frame.total_time;
        let plane = frame.beams.iter().map(|beam| (beam.fibre_strain, beam.label));
        let space = space_beams(frame).map(|beam| (beam.fibre_strain(), beam.element.label));
        for (strain, label) in plane.chain(space) {
            keep_larger(&mut self.strain, (strain, label, time));
            if let Some(allowable) = allowable.get(&label) {
                keep_larger(&mut self.used, (strain / allowable, label, time));
            }
        }
    }

    /// Takes in stresses and strains of solids, and what of their allowables that is.
    pub(super) fn follow_solids(&mut self, frame: &Frame<'_>) {
        let mut plastic = Vec::new();
        for solid in solids(frame).filter(|solid| !solid.block.kind.is_truss()) {
            let at = |value| (value, solid.element.label, frame.total_time);
            let limits = frame.model.allowables.iter().filter(|own| own.block == solid.number);
            for point in 0..solid.points() {
                let stress = mises(solid.stress(point));
                keep_larger(&mut self.mises, at(stress));
                plastic.clear();
                solid.push(Quantity::Field("PEEQ"), point, &mut plastic);
                let own = plastic.first().copied().filter(|own| *own > 0.0);
                own.into_iter().for_each(|own| keep_larger(&mut self.plastic, at(own)));
                let largest = self.principal.map_or(0.0, |(largest, ..)| largest);
                // most points are far below the largest
                let bound = solid.strain_bound(point);
                let counts = solid.is_linear() && (bound > largest || bound.is_nan());
                let strain = match counts || limits.clone().next().is_some() {
                    true => solid.principal_strain(point),
                    false => 0.0,
                };
                if counts {
                    keep_larger(&mut self.principal, at(strain));
                }
                let beyond = solid.unstable_strain(point);
                beyond.into_iter().for_each(|own| keep_larger(&mut self.unstable, at(own)));
                for limit in limits.clone() {
                    let used = match limit.limit {
                        Limit::Strain(limit) => strain / limit,
                        Limit::Stress(limit) => stress / limit,
                    };
                    keep_larger(&mut self.used, at(used));
                }
            }
        }
    }

    /// Takes in how far elements turn under linear kinematics.
    pub(super) fn follow_turns(&mut self, frame: &Frame<'_>) {
        let time = frame.total_time;
        let step = frame.model.steps.get(frame.step.wrapping_sub(1));
        if step.is_some_and(|step| !step.nlgeom) {
            let most = most_turned(frame).map(|(most, label)| (most, label, time));
            most.into_iter().for_each(|most| keep_larger(&mut self.linear, most));
        }
    }
}

/// How far the element that turns or strains most does so: the change of an edge over its length,
/// and the element. Springs and rigid parts do not count.
fn most_turned(frame: &Frame<'_>) -> Option<(f64, u64)> {
    let mut most: Option<(f64, u64)> = None;
    for results in frame.elements {
        let Some(block) = frame.model.blocks.get(results.block).filter(|own| own.kind.joins())
        else {
            continue;
        };
        let edges: Vec<[usize; 2]> = block.kind.cell.pieces.iter().flat_map(ends).collect();
        for &member in &results.members {
            let element = block.elements.get(member);
            for ends in &edges {
                let [a, b] = ends.map(|end| element.nodes[end]);
                let (still, now) = (
                    [a, b].map(|node| frame.model.nodes.position(node)),
                    [a, b].map(|node| place(frame, node)),
                );
                let [mut length, mut change] = [0.0; 2];
                for axis in 0..3 {
                    let before = still[1][axis] - still[0][axis];
                    length += before * before;
                    change += (now[1][axis] - now[0][axis] - before).powi(2);
                }
                let turned = (change / length).sqrt();
                if length > 0.0 && most.is_none_or(|(most, _)| turned > most) {
                    most = Some((turned, element.label));
                }
            }
        }
    }
    most
}

/// First and last node of every edge of a piece.
fn ends(piece: &Piece) -> impl Iterator<Item = [usize; 2]> + use<'_> {
    let edges = edges(piece.vtk).iter();
    edges.filter_map(|edge| Some([piece.nodes[*edge.first()?], piece.nodes[*edge.last()?]]))
}

/// Keeps the larger one; what is no number is the largest.
pub(super) fn keep_larger(largest: &mut Largest, now: (f64, u64, f64)) {
    if largest.is_none_or(|(value, ..)| now.0 > value || now.0.is_nan()) {
        *largest = Some(now);
    }
}
