//! Materials of sections: what suits their elements.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::solid;
use slideline_model::{ElementType, Elements, Kinematics};

use crate::draft::{Body, Draft, Elasticity, Section, Yielding};
use crate::rule::Subject;

/// Complains about trusses and beams of a material with directions: they know their own alone.
pub(super) fn lines_have_no_axes(
    section: &Section,
    claimed: &[(&'static ElementType, Elements)],
    draft: &mut Draft,
) {
    let any = |is: fn(&ElementType) -> bool| {
        claimed.iter().any(|(row, elements)| is(row) && !elements.is_empty())
    };
    let (bars, beams) = (any(ElementType::is_truss), any(ElementType::is_beam));
    let Some(material) = draft.materials.iter().find(|own| own.name == section.material) else {
        return;
    };
    let elasticity = material.elasticity.as_ref().map(|own| &own.0);
    let directed = matches!(
        elasticity,
        Some(Elasticity::Anisotropic(_) | Elasticity::Ply(_) | Elasticity::Fibrous(_))
    );
    let expansion = material.expansion.as_ref().and_then(|(own, card)| Some((own.as_ref()?, card)));
    let uneven = expansion.filter(|(own, _)| !own.is_even()).map(|(_, card)| card.1);
    if bars && directed {
        let message = format!("the material {} is anisotropic; trusses are not", section.material);
        let error = Diagnostic::error(Code("SL0309"), message).at(section.material_span);
        let help = "give trusses a material of *ELASTIC: E, nu";
        draft.consequence(Subject::Properties, error.help(help));
    } else if let Some(card) = uneven.filter(|_| bars || beams) {
        let message = format!(
            "the material {} expands along three axes; trusses and beams have their own alone",
            section.material
        );
        let error = Diagnostic::error(Code("SL0309"), message).at(section.material_span);
        let error = error.label(card, "three coefficients");
        draft.consequence(Subject::Properties, error.help("give them one: *EXPANSION, TYPE=ISO"));
    }
}

/// Complains about elements of a ply that are not in plane stress.
pub(super) fn in_plane_stress(
    section: &Section,
    claimed: &[(&'static ElementType, Elements)],
    draft: &mut Draft,
) {
    let of_section = draft.materials.iter().find(|own| own.name == section.material);
    let elasticity = of_section.and_then(|own| own.elasticity.as_ref());
    if !matches!(elasticity, Some((Elasticity::Ply(_), _))) {
        return;
    }
    let plane = |row: &ElementType| matches!(row.kinematics, Kinematics::Solid { strains, .. } if strains == solid::Kinematics::PlaneStress);
    if let Some((row, _)) =
        claimed.iter().find(|(row, elements)| !plane(row) && !elements.is_empty())
    {
        let message = format!(
            "the material {} is TYPE=LAMINA, for plane stress; elements of type {} are not in it",
            section.material,
            row.name()
        );
        let error = Diagnostic::error(Code("SL0309"), message).at(section.material_span);
        let help = "give all nine constants: *ELASTIC, TYPE=ENGINEERING CONSTANTS";
        draft.consequence(Subject::Properties, error.help(help));
    }
}

/// The section with its material, along the axes of the model.
pub(super) fn material(section: &Section, draft: &mut Draft) -> Option<slideline_model::Section> {
    if let Body::Beam { elastic: Some(_), .. } = section.body {
        let own = crate::draft::Material::new(String::new(), section.origin);
        return section.body.clone().of(&own, draft.dialect);
    }
    let found = draft.materials.iter().find(|material| material.name == section.material).cloned();
    let Some(material) = found else {
        no_material(&section.material, section.material_span, draft);
        return None;
    };
    let of_beam = matches!(section.body, Body::Beam { .. });
    let Some((elasticity, card)) = &material.elasticity else {
        let others =
            [material.hardening.is_some(), material.relaxation.is_some(), material.creep.is_some()];
        let names = ["*PLASTIC but no", "*VISCOELASTIC but no", "*CREEP but no"];
        let card = others.iter().zip(names).find(|own| *own.0).map_or("no", |own| own.1);
        let message = format!("the material {} has {card} *ELASTIC", material.name);
        let error = Diagnostic::error(Code("SL0309"), message).at(material.origin);
        draft.consequence(Subject::Properties, error.help("put *ELASTIC behind *MATERIAL: E, nu"));
        return None;
    };
    let isotropic = matches!(elasticity, Elasticity::Isotropic(_) | Elasticity::Unread);
    if let Some((_, plastic)) = material.hardening.as_ref().filter(|_| !isotropic) {
        let message = format!("the material {} {} and yields", material.name, elasticity.word());
        let error = Diagnostic::error(Code("SL0309"), message).at(plastic.1);
        let error = error.label(card.1, "its elasticity");
        draft.consequence(Subject::Properties, error.help("*PLASTIC goes with *ELASTIC: E, nu"));
        return None;
    }
    if !is_sound_metal(&material, draft) || !takes_time_soundly(&material, draft) {
        return None;
    }
    let takes_time = material.relaxation.is_some() || material.creep.is_some();
    if of_beam && (material.hardening.is_some() || takes_time || !isotropic) {
        let what = match &material {
            own if own.hardening.is_some() => "yields",
            own if own.creep.is_some() => "creeps",
            own if own.relaxation.is_some() => "relaxes",
            _ => elasticity.word(),
        };
        let message = format!("the material {} {what}; beams are elastic", material.name);
        let error = Diagnostic::error(Code("SL0309"), message).at(section.material_span);
        draft.consequence(
            Subject::Properties,
            error.help("give beams a material of *ELASTIC: E, nu"),
        );
        return None;
    }
    section.body.clone().of(&material, draft.dialect)
}

/// Whether what hardens a metal goes together; complains if not.
fn is_sound_metal(material: &crate::draft::Material, draft: &mut Draft) -> bool {
    let yielding = material.hardening.as_ref().and_then(|(own, _)| own.as_ref());
    let moves = yielding.is_some_and(|own| !own.back_stresses.is_empty());
    let combined = match &material.hardening {
        Some(_) => yielding.is_none_or(|own| own.combined),
        None => false,
    };
    if let Some((_, growth)) = material.growth.as_ref().filter(|_| !combined) {
        let message = "*CYCLIC HARDENING belongs to *PLASTIC, HARDENING=COMBINED";
        let error = Diagnostic::error(Code("SL0309"), message).at(growth.1);
        let help = "write HARDENING=COMBINED on *PLASTIC, or leave *CYCLIC HARDENING out";
        draft.consequence(Subject::Properties, error.help(help));
        return false;
    }
    if moves && material.isotropic().is_some_and(|table| table.len() > 1) {
        let message = format!(
            "the yield surface of {} moves, and its elasticity depends on temperature",
            material.name
        );
        let error = Diagnostic::error(Code("SL0309"), message).at(material.origin);
        let help = "kinematic hardening takes constants of one temperature";
        draft.consequence(Subject::Properties, error.help(help));
        return false;
    }
    true
}

/// Whether what time makes of a material goes with the rest of it; complains if not.
fn takes_time_soundly(material: &crate::draft::Material, draft: &mut Draft) -> bool {
    let Some((elasticity, _)) = &material.elasticity else { return true };
    let moves = |own: &Yielding| !own.back_stresses.is_empty() || own.combined;
    let yielding = material.hardening.as_ref();
    let moving =
        yielding.and_then(|(own, card)| own.as_ref().filter(|own| moves(own)).and(Some(card)));
    let other =
        [&material.hardening.as_ref().map(|own| own.1), &material.creep.as_ref().map(|own| own.1)];
    let relaxes = match elasticity {
        Elasticity::Anisotropic(_)
        | Elasticity::Ply(_)
        | Elasticity::Foam(_)
        | Elasticity::Fibrous(_)
        | Elasticity::Deformation(_) => false,
        Elasticity::Isotropic(_)
        | Elasticity::Rubber(_)
        | Elasticity::Tested(_)
        | Elasticity::Unread => true,
    };
    let is_linear = matches!(elasticity, Elasticity::Isotropic(_) | Elasticity::Unread);
    let refused = match (&material.relaxation, &material.creep) {
        (Some((_, own)), _) if !relaxes => {
            Some((own, format!("relaxes and {}", elasticity.word())))
        }
        (Some((_, own)), _) => {
            let beside = other.into_iter().flatten().next();
            beside.map(|(name, _)| (own, format!("relaxes, and has *{name}")))
        }
        (None, Some((_, own))) if !is_linear => {
            Some((own, format!("creeps and {}", elasticity.word())))
        }
        (None, Some((_, own))) if moving.is_some() => {
            Some((own, "creeps, and its yield surface moves".to_owned()))
        }
        (None, None) => yielding
            .filter(|(own, _)| own.as_ref().is_some_and(Yielding::is_none))
            .map(|(_, own)| (own, "yields at no stress and does not creep".to_owned())),
        _ => None,
    };
    let Some((card, what)) = refused else { return true };
    let message = format!("the material {} {what}, which is not supported", material.name);
    let error = Diagnostic::error(Code("SL0309"), message).at(card.1);
    let help = "*VISCOELASTIC goes with *ELASTIC: E, nu or *HYPERELASTIC; *CREEP with *ELASTIC: E, nu \
                and with *PLASTIC of isotropic hardening";
    draft.consequence(Subject::Properties, error.help(help));
    false
}

pub(super) fn no_material(name: &str, span: Span, draft: &mut Draft) {
    let message = format!("there is no material {name}");
    let mut error = Diagnostic::error(Code("SL0308"), message).at(span);
    let names = draft.materials.iter().map(|material| material.name.as_str());
    if let Some(near) = slideline_deck::nearest(name, names) {
        error = error.help(format!("did you mean {near}?"));
    }
    draft.consequence(Subject::Sections, error);
}
