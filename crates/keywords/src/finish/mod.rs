//! What can be said only when the whole deck is known: references by name,
//! and whether the parts make a model.

mod along_beams;
mod amplitudes;
mod axes;
mod axes_of_elements;
mod beam_normals;
mod behind;
mod bodies;
mod chain;
mod changed_sections;
mod clearances;
mod contact;
mod coupling;
mod dimension;
mod distributed;
mod distributing;
mod embedded;
mod equations;
mod faces;
mod facing;
mod fibres;
mod frictions;
mod gaps;
mod general_contact;
mod half_thickness;
mod in_space;
mod initial_stresses;
mod inner_faces;
mod interferences;
mod laws_of_pairs;
mod line_loads;
mod links;
mod load_forces;
mod lookup;
mod loops;
mod master_chain;
mod materials;
mod meetings;
mod middle_nodes;
mod model_changes;
mod nodes;
mod one_node;
mod orientations;
mod own_contact;
mod own_surface;
mod owners;
mod perturbation;
mod point_masses;
mod pre_tension;
mod pressures;
mod reference_nodes;
mod remarks;
mod requests;
mod resting;
mod rigid_faces;
mod rigid_link;
mod rubber;
mod section_prints;
mod sections;
mod shape_mpc;
mod sides;
mod skin;
mod space_beams;
mod spread;
mod springs;
mod standing;
mod steps;
mod supports;
mod surface_pairs;
mod surfaces;
mod swept;
mod temperatures;
mod thicknesses;
mod tied_pairs;
mod ties;
mod tributary;
mod unit_systems;
mod unknown;

use slideline_model::Model;
pub(crate) use unknown::unknown_set;

use crate::draft::Draft;
use crate::parts::renumber;

/// Completes the model. `steps_doubted`: a step has been asked for already,
/// or there are no cards at all.
pub(crate) fn finish(draft: &mut Draft, steps_doubted: bool) -> Model {
    draft.end_parts();
    dimension::dimension(draft);
    nodes::sets(draft);
    nodes::elements(draft);
    reference_nodes::reference_nodes(draft);
    let parted = pre_tension::cut(draft);
    rubber::rubbers(draft);
    thicknesses::of_nodes(draft);
    sections::sections(draft);
    initial_stresses::stresses(draft);
    springs::springs(draft);
    gaps::gaps(draft);
    point_masses::masses(draft);
    faces::check(draft);
    axes::transforms(draft);
    coupling::axes_of_references(draft);
    contact::pairs(draft);
    surface_pairs::pairs(draft);
    pre_tension::tie(&parted, draft);
    links::links(draft);
    one_node::in_contact(draft);
    temperatures::initial(draft);
    temperatures::without_expansion(draft);
    temperatures::out_of_plane(draft);
    steps::steps(draft, steps_doubted);
    renumber(&mut draft.model);
    draft.model.find_edges();
    std::mem::take(&mut draft.model)
}
