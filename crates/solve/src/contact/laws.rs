//! The laws of a pair, with the lengths of its mesh filled in.

use super::master::MasterSurface;
use super::profiles::placed;
use crate::users::UserFrictions;
use slideline_mech::contact::friction::{Decay, Ellipse, FrictionLaw, Stick};
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::contact::pair::Laws;
use slideline_mech::contact::points::{average_length, chord};
use slideline_model::{
    ContactPair, ElementBlock, Formulation, Friction, Model, Section, StickRule,
};
use std::borrow::Cow;

/// State values a point of the pair keeps for a user friction law.
pub fn state_size(pair: &ContactPair) -> usize {
    match &pair.interaction.friction {
        Friction::User { state_size, .. } => *state_size,
        _ => 0,
    }
}

/// The laws of a pair whose contact elements have that mean `length` [L].
pub fn laws(model: &Model, pair: &ContactPair, length: f64, users: &UserFrictions) -> Laws {
    let user = match &pair.interaction.friction {
        Friction::User { name, .. } => users.find(name),
        _ => None,
    };
    let normal = normal((model, pair), &pair.interaction.normal, length).into_owned();
    let friction = friction((model, pair, &pair.interaction.friction), length);
    Laws { normal, friction, onset: model.friction_onset, user }
}

/// A friction law of a pair likewise.
pub(super) fn friction(
    (model, pair, law): (&Model, &ContactPair, &Friction),
    length: f64,
) -> FrictionLaw {
    let integrated = pair.formulation == Formulation::SurfaceToSurface;
    let elastic = |fraction: f64| Stick::Elastic { slip: fraction * length };
    match law {
        Friction::Frictionless => FrictionLaw::None,
        friction if !friction.acts() => FrictionLaw::None,
        Friction::Coulomb { coefficient, second, limit, decay, stick } => {
            let (largest, of_both) = match *second {
                Some(second) => Ellipse::of([*coefficient, second]),
                None => (*coefficient, Ellipse::CIRCLE),
            };
            // in the plane there is one direction, with its share of the limit
            let (coefficient, ellipse, share) = match model.is_in_space() {
                true => (largest, of_both, 1.0),
                false => (*coefficient, Ellipse::CIRCLE, of_both.coefficients(1.0)[0]),
            };
            FrictionLaw::Coulomb {
                coefficient,
                ellipse,
                limit: limit.map(|limit| share * limit),
                decay: decay.map(|decay| Decay { kinetic: decay.kinetic, rate: decay.rate }),
                stick: match stick {
                    // Exact stick at every integration point would fix more than the nodes can follow.
                    StickRule::Lagrange if integrated => elastic(0.005),
                    StickRule::Lagrange => Stick::Lagrange,
                    StickRule::ElasticSlip(slip) => Stick::Elastic { slip: *slip },
                    StickRule::Slope(stiffness) => Stick::Slope { stiffness: *stiffness },
                    StickRule::SlipTolerance(fraction) => elastic(*fraction),
                },
            }
        }
        Friction::Rough if integrated => FrictionLaw::Rough { stick: elastic(0.005) },
        Friction::Rough => FrictionLaw::Rough { stick: Stick::Lagrange },
        Friction::User { name, properties, state_size } => FrictionLaw::User {
            name: name.clone(),
            properties: properties.clone(),
            state_size: *state_size,
        },
    }
}

/// A normal law of a pair likewise.
pub(super) fn normal<'a>(
    (model, pair): (&Model, &ContactPair),
    law: &'a NormalLaw,
    length: f64,
) -> Cow<'a, NormalLaw> {
    match law {
        NormalLaw::Hard if pair.formulation == Formulation::SurfaceToSurface => {
            let stiffness = PENALTY * stiffest_face(model, pair, length);
            Cow::Owned(NormalLaw::Linear { stiffness })
        }
        other => Cow::Borrowed(other),
    }
}

/// Stiffness of an integrated hard contact, in multiples of the stiffest
/// slave element's own, per area.
const PENALTY: f64 = 10.0;

/// A modulus of the elements of a block [F/L2]; none of springs.
fn modulus(block: &ElementBlock) -> f64 {
    match &block.section {
        Section::Beam(section) => section.material.modulus,
        Section::Solid(section) => section.material.stiffest(),
        Section::Spring(_) | Section::Properties(_) => 0.0,
    }
}

/// Largest EA/l of the beams, per area of a contact element; of a profile, largest E/l of all parts, l the
/// mean length of its segments [F/L3].
fn stiffest_face(model: &Model, pair: &ContactPair, length: f64) -> f64 {
    if pair.profile.is_some() {
        return model.blocks.iter().map(modulus).fold(0.0, f64::max) / length;
    }
    let axial = |block: &ElementBlock| match block.beams() {
        Some(beams) => beams.section.material.modulus * beams.section.shape.area(),
        None => 0.0,
    };
    let largest = model.blocks.iter().map(axial).fold(0.0, f64::max);
    largest / (length * length * pair.interaction.width)
}

/// Distance of neighbouring slave points [L]: the mean `length` of the contact
/// elements, or else of the beams, or else a tenth of a rigid master.
pub(super) fn spacing(model: &Model, length: f64, master: &MasterSurface) -> f64 {
    if length > 0.0 {
        return length;
    }
    let beams = model.blocks.iter().filter_map(|block| block.beams());
    let lengths = beams
        .flat_map(|block| block.elements)
        .map(|element| chord(element.ends().map(|node| model.nodes.get(node).position)));
    let (sum, count) = lengths.fold((0.0, 0.0), |(sum, count), l| (sum + l, count + 1.0));
    match master {
        _ if count > 0.0 => sum / count,
        MasterSurface::Body { surface, .. } => 0.2 * surface.bounds().1,
        _ => 0.0,
    }
}

/// Mean length of the contact elements of a pair, of the segments of a slave profile, undeformed [L];
/// zero without.
pub fn mean_length(model: &Model, pair: &ContactPair) -> f64 {
    if let Some(profile) = &pair.profile {
        let own = placed(profile);
        return own.map_or(0.0, |own| own.length() / profile.segments.len() as f64);
    }
    let position = |node| model.nodes.get(node).position;
    let edges = pair.faces.iter().filter_map(|face| {
        let corners = face.cell()?.faces.len();
        let ends = move |k: usize| [face.nodes[k], face.nodes[(k + 1) % corners]];
        Some((0..corners).map(ends))
    });
    let elements = pair.elements.iter().map(|element| element.nodes);
    average_length(elements.chain(edges.flatten()).map(|ends| ends.map(position)))
}

/// Whether friction of a pair has a coefficient of its own along either axis of its surface, in some
/// step.
pub(super) fn is_directed(model: &Model, place: usize) -> bool {
    let changed = model.steps.iter().flat_map(|step| &step.frictions);
    let laws = changed.filter(|own| own.pair == place).flat_map(|own| [&own.from, &own.to]);
    let own = &model.contact_pairs[place].interaction.friction;
    laws.chain([own]).any(Friction::is_directed)
}
