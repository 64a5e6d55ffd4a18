//! All keywords.

use slideline_deck::normalise;
use slideline_model::Numbered;
use std::sync::LazyLock;

use crate::cards::{
    allowable, amplitude, anisotropic_hyperelastic, assembly, beam_general_section, beam_section,
    biaxial_test_data, boundary, centroid, change_friction, change_material, change_plastic,
    change_solid_section, change_surface_behavior, clearance, cload, contact, contact_controls,
    contact_exclusions, contact_file, contact_inclusions, contact_initialization_assignment,
    contact_initialization_data, contact_interference, contact_output, contact_pair, contact_print,
    contact_property_assignment, controls, coupling, creep, cyclic_hardening,
    deformation_plasticity, density, distributing, distributing_coupling, distribution,
    distribution_table, dload, dsload, el_file, el_print, elastic, elcopy, element, element_output,
    elgen, elset, embedded_element, end_assembly, end_instance, end_part, end_step, equation,
    expansion, friction, gap, heading, hyperelastic, hyperfoam, initial_conditions, instance,
    interface, kinematic, kinematic_coupling, mass, material, model_change, mpc, ncopy, nfill,
    ngen, nmap, nodal_thickness, node, node_file, node_output, node_print, normal, nset,
    orientation, output, parameter, parameter_range, part, physical_constants, planar_test_data,
    plastic, pre_tension_section, print, restart, rigid_body, rigid_surface, section_print,
    shear_center, slide_line, solid_section, spring, static_, step, surface, surface_behavior,
    surface_contact, surface_interaction, surface_property_assignment, system, temperature, tie,
    transform, transverse_shear, uniaxial_test_data, visco, viscoelastic, volumetric_test_data,
};
use crate::keyword::Keyword;
use crate::reading::{Match, resolve};
use crate::rule::{Level, Rule};

/// The keyword that a normalised word stands for.
pub(crate) fn keyword_of(word: &str) -> Match<&'static dyn Keyword> {
    static BY_NAME: LazyLock<Numbered<String, &'static dyn Keyword>> =
        LazyLock::new(|| REGISTRY.iter().map(|&own| (normalise(own.name()), own)).collect());
    match BY_NAME.get(word) {
        Some(&keyword) => Match::Exact(keyword),
        None => resolve(word, REGISTRY, |keyword| keyword.name()),
    }
}

/// One line for each keyword, in the order of a deck.
pub(crate) const REGISTRY: &[&'static dyn Keyword] = &[
    &heading::Heading,
    &parameter::Parameter,
    &parameter_range::OfParameters,
    &restart::Restart,
    &part::Part,
    &end_part::EndPart,
    &assembly::Assembly,
    &end_assembly::EndAssembly,
    &instance::Instance,
    &end_instance::EndInstance,
    &system::System,
    &node::Node,
    &ngen::Ngen,
    &nfill::Nfill,
    &ncopy::Ncopy,
    &nmap::Nmap,
    &nset::Nset,
    &transform::Transform,
    &elset::Elset,
    &element::Element,
    &elgen::Elgen,
    &elcopy::Elcopy,
    &beam_section::BeamSection,
    &beam_general_section::BeamGeneralSection,
    &centroid::Centroid,
    &shear_center::ShearCenter,
    &transverse_shear::TransverseShearStiffness,
    &normal::Normal,
    &distribution_table::DistributionTable,
    &distribution::Distribution,
    &orientation::Orientation,
    &solid_section::SolidSection,
    &nodal_thickness::NodalThickness,
    &spring::Spring,
    &gap::Gap,
    &mass::Mass,
    &material::Material,
    &elastic::Elastic,
    &density::Density,
    &expansion::Expansion,
    &hyperelastic::Hyperelastic,
    &hyperfoam::Hyperfoam,
    &anisotropic_hyperelastic::AnisotropicHyperelastic,
    &deformation_plasticity::DeformationPlasticity,
    &uniaxial_test_data::UniaxialTestData,
    &biaxial_test_data::BiaxialTestData,
    &planar_test_data::PlanarTestData,
    &volumetric_test_data::VolumetricTestData,
    &plastic::Plastic,
    &cyclic_hardening::CyclicHardening,
    &viscoelastic::Viscoelastic,
    &creep::Creep,
    &allowable::Allowable,
    &rigid_surface::RigidSurface,
    &slide_line::SlideLine,
    &interface::Interface,
    &surface::Surface,
    &rigid_body::RigidBody,
    &surface_interaction::SurfaceInteraction,
    &surface_property_assignment::SurfacePropertyAssignment,
    &friction::Friction,
    &surface_contact::SurfaceContact,
    &surface_behavior::SurfaceBehavior,
    &contact_pair::ContactPair,
    &clearance::Clearance,
    &contact::Contact,
    &contact_inclusions::ContactInclusions,
    &contact_exclusions::ContactExclusions,
    &contact_property_assignment::ContactPropertyAssignment,
    &contact_initialization_data::ContactInitializationData,
    &contact_initialization_assignment::ContactInitializationAssignment,
    &contact_controls::ContactControls,
    &mpc::Mpc,
    &tie::Tie,
    &equation::Equation,
    &embedded_element::EmbeddedElement,
    &coupling::Coupling,
    &kinematic::Kinematic,
    &distributing::Distributing,
    &kinematic_coupling::KinematicCoupling,
    &distributing_coupling::DistributingCoupling,
    &pre_tension_section::PreTensionSection,
    &amplitude::Amplitude,
    &physical_constants::PhysicalConstants,
    &initial_conditions::InitialConditions,
    &step::Step,
    &static_::Static,
    &visco::Visco,
    &boundary::Boundary,
    &cload::Cload,
    &dload::Dload,
    &dsload::Dsload,
    &temperature::Temperature,
    &model_change::ModelChange,
    &change_solid_section::ChangeSolidSection,
    &change_material::ChangeMaterial,
    &change_plastic::ChangePlastic,
    &change_friction::ChangeFriction,
    &change_surface_behavior::ChangeSurfaceBehavior,
    &contact_interference::ContactInterference,
    &controls::Controls,
    &print::Print,
    &output::Output,
    &node_print::NodePrint,
    &node_file::NodeFile,
    &node_output::NodeOutput,
    &el_print::ElPrint,
    &el_file::ElFile,
    &element_output::ElementOutput,
    &contact_print::ContactPrint,
    &section_print::SectionPrint,
    &contact_file::ContactFile,
    &contact_output::ContactOutput,
    &end_step::EndStep,
];

/// A keyword as people look it up.
#[derive(Clone, Copy, Debug)]
pub struct Description {
    /// Its name without the star.
    pub name: &'static str,
    /// Where it may stand.
    pub level: Level,
    /// The parameters it knows.
    pub parameters: &'static [Rule],
    /// Its page in Markdown: meaning, formula, default, source, example.
    pub page: &'static str,
}

/// `*INCLUDE` is carried out while the deck is parsed; only its page is here.
const INCLUDE: Description = Description {
    name: "INCLUDE",
    level: Level::Both,
    parameters: &[Rule::required("INPUT")],
    page: include_str!("../../../docs/keywords/INCLUDE.md"),
};

/// All keywords in the order of a deck.
pub fn keywords() -> impl Iterator<Item = Description> {
    let described = REGISTRY.iter().map(|keyword| Description {
        name: keyword.name(),
        level: keyword.level(),
        parameters: keyword.parameters(),
        page: keyword.page(),
    });
    described.chain(std::iter::once(INCLUDE))
}

/// The keyword of that name, with or without its star, case and blanks not
/// counted; a unique beginning is enough.
pub fn describe(name: &str) -> Option<Description> {
    let word = normalise(name.trim_start_matches('*'));
    let all: Vec<Description> = keywords().collect();
    match resolve(&word, &all, |description| description.name) {
        Match::Exact(found) | Match::Abbreviation(found) => Some(found),
        _ => None,
    }
}
