//! Rubber from its test data, and what its stability is.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::material::hyperelastic::{Measured, Mode, NoFit};
use slideline_mech::material::{Rubber, Volume};
use slideline_model::Tested;

use crate::cards::hyperelastic::sound;
use crate::draft::{Draft, Elasticity, Kind, Material, Wanted};

/// Fits the laws that test data give, and says where any rubber loses its stability.
pub(super) fn rubbers(draft: &mut Draft) {
    for index in 0..draft.materials.len() {
        let material = draft.materials[index].clone();
        let mut reach = 0.0;
        match &material.elasticity {
            Some((Elasticity::Tested(wanted), card)) => {
                let fitted = fitted(&material, wanted, card.1, draft);
                reach = draft.model.tested.last().filter(|_| fitted.is_some()).map_or(0.0, reached);
                let elasticity =
                    fitted.map_or(Elasticity::Unread, |own| Elasticity::Rubber(vec![(0.0, own)]));
                draft.materials[index].elasticity = Some((elasticity, *card));
            }
            Some((Elasticity::Unread, _)) => {}
            other => {
                if needless(&material, other.is_some(), draft) {
                    let card = material.tests[0].card;
                    draft.materials[index].elasticity = Some((Elasticity::Unread, card));
                }
            }
        }
        if let Some((Elasticity::Rubber(table), card)) = &draft.materials[index].elasticity {
            let of = |(_, own): &(f64, Rubber)| stability(&material.name, own, reach, card.1);
            let said: Vec<Diagnostic> = table.iter().flat_map(of).collect();
            said.into_iter().for_each(|said| draft.log.push(said));
        }
    }
}

/// Complains about test data that no law asks for; true if there are some.
fn needless(material: &Material, has_law: bool, draft: &mut Draft) -> bool {
    let Some(test) = material.tests.first() else { return false };
    let (name, span) = test.card;
    let law = if has_law { "is given by its coefficients" } else { "is missing" };
    let message = format!("*{name} of the material {}, whose law {law}", material.name);
    let help = "write *HYPERELASTIC, TEST DATA INPUT and a form in front of the data, or leave \
                them out";
    draft.log.push(Diagnostic::error(Code("SL0282"), message).at(span).help(help));
    true
}

/// The rubber that the tests of a material give; complains where they give none.
fn fitted(material: &Material, wanted: &Wanted, at: Span, draft: &mut Draft) -> Option<Rubber> {
    let (mut tests, mut volumes) = (Vec::new(), Vec::new());
    for test in &material.tests {
        let points = test.points.as_ref()?;
        match test.kind {
            Kind::Mode(mode) => {
                let measured =
                    points.iter().map(|&[stress, strain]| Measured { mode, strain, stress });
                tests.extend(measured);
            }
            Kind::Volume => volumes.extend(points),
        }
    }
    if !material.tests.iter().any(|test| test.kind != Kind::Volume) {
        let message =
            format!("no test data of the material {} say how it is strained", material.name);
        let help = "put *UNIAXIAL TEST DATA, *BIAXIAL TEST DATA or *PLANAR TEST DATA behind it";
        draft.log.push(Diagnostic::error(Code("SL0282"), message).at(at).help(help));
        return None;
    }
    let found = wanted.form.fit(&tests).map_err(|why| (why, tests.len(), at));
    let rubber = found.map_err(|why| say(why, "stress over strain", draft)).ok()?;
    let volume = volume(material, wanted, &rubber, &volumes, draft)?;
    let rubber = sound(rubber.with_volume(volume), at, draft)?;
    let tested = Tested {
        material: material.name.clone(),
        rubber: rubber.clone(),
        tests,
        volumes,
        origin: at,
    };
    draft.log.push(note(&tested, volume != Volume::default()));
    draft.model.tested.push(tested);
    Some(rubber)
}

/// 1/D of the rubber: from its Poisson ratio, from volumes, or none.
fn volume(
    material: &Material,
    wanted: &Wanted,
    rubber: &Rubber,
    data: &[[f64; 2]],
    draft: &mut Draft,
) -> Option<Volume> {
    let test = material.tests.iter().find(|test| test.kind == Kind::Volume);
    let mut volume = Volume::default();
    match (wanted.poisson, test) {
        (Some(_), Some(test)) => {
            let message = "POISSON and volumetric test data say the same thing twice";
            let error = Diagnostic::error(Code("SL0282"), message).at(test.card.1);
            draft.log.push(error.help("leave one of them out"));
            return None;
        }
        (Some(poisson), None) if poisson < 0.5 => {
            let bulk =
                2.0 * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson)) * rubber.shear_modulus();
            volume[0] = 0.5 * bulk;
        }
        (_, None) => {}
        (None, Some(test)) => {
            let found = wanted.form.fit_volume(wanted.volumes, data);
            let found = found.map_err(|why| (why, data.len(), test.card.1));
            volume = found.map_err(|why| say(why, "pressure over volume", draft)).ok()?;
        }
    }
    Some(volume)
}

/// Says why no law comes of the data.
fn say((why, points, at): (NoFit, usize, Span), what: &str, draft: &mut Draft) {
    let more = "measure more points, in another mode too, or take a form with fewer terms";
    let (code, message, help) = match why {
        NoFit::TooFew { needed } => {
            ("SL0283", format!("{points} points of {what} for {needed} coefficients"), more)
        }
        NoFit::Undetermined => {
            let message =
                format!("the {points} points of {what} do not tell the coefficients apart");
            ("SL0283", message, more)
        }
        NoFit::NotConverged => (
            "SL0284",
            "the search for the coefficients does not arrive".to_owned(),
            "take fewer terms, or a polynomial form, whose coefficients are found without a search",
        ),
        NoFit::NoLocking => (
            "SL0284",
            "the data do not stiffen, so that no locking stretch can be found".to_owned(),
            "take NEO HOOKE, which is the same law without locking, or data of larger strains",
        ),
    };
    draft.log.push(Diagnostic::error(Code(code), message).at(at).help(help));
}

/// SL0285: coefficients and the largest error.
fn note(tested: &Tested, has_volume: bool) -> Diagnostic {
    let error = |own: &&Measured| tested.rubber.relative_error(own).abs();
    let worst = tested.tests.iter().max_by(|a, b| error(a).total_cmp(&error(b)));
    let worst = worst.map_or_else(String::new, |own| {
        let (mode, strain) = (own.mode.word(), digits(own.strain, 4));
        let percent = digits(100.0 * error(&own), 3);
        format!("; the largest error is {percent} % of the stress, {mode} at a strain of {strain}")
    });
    let (count, name) = (tested.tests.len(), &tested.material);
    let coefficients = coefficients(&tested.rubber, has_volume).join(", ");
    let message = format!("the rubber {name} is fitted to {count} points: {coefficients}{worst}");
    let note = Diagnostic::note(Code("SL0285"), message).at(tested.origin);
    note.help("`slideline check --picture` draws the data and the law")
}

/// Names and values of coefficients as the card has them.
fn coefficients(rubber: &Rubber, has_volume: bool) -> Vec<String> {
    let said = |name: &str, value: f64| format!("{name} = {}", digits(value, 6));
    let (mut list, volume): (Vec<String>, Volume) = match rubber {
        Rubber::Polynomial { terms, volume } => {
            let terms = terms.iter().map(|(i, j, own)| said(&format!("C{i}{j}"), *own));
            (terms.collect(), *volume)
        }
        Rubber::Ogden { terms, volume } => {
            let terms = terms.iter().zip(1..).flat_map(|([shear, power], k)| {
                [said(&format!("mu{k}"), *shear), said(&format!("alpha{k}"), *power)]
            });
            (terms.collect(), *volume)
        }
        Rubber::ArrudaBoyce { shear, locking, volume } => {
            let mut own = Volume::default();
            own[0] = *volume;
            (vec![said("mu", *shear), said("lambda_m", *locking)], own)
        }
    };
    let volume = volume.iter().zip(1..).filter(|(own, _)| has_volume && **own != 0.0);
    list.extend(volume.map(|(own, k)| said(&format!("D{k}"), 1.0 / own)));
    list
}

/// A number with so many digits, as short as it can be written.
fn digits(value: f64, count: usize) -> String {
    let rounded = format!("{value:.*e}", count - 1);
    let short: f64 = rounded.parse().unwrap_or(value);
    let size = short.abs();
    if size == 0.0 || (1e-3..1e7).contains(&size) {
        short.to_string()
    } else {
        format!("{short:e}")
    }
}

/// The largest logarithmic strain of the tests [1].
fn reached(tested: &Tested) -> f64 {
    tested.tests.iter().map(|own| own.strain.ln_1p().abs()).fold(0.0, f64::max)
}

/// SL0420: where a rubber loses its stability; a warning where that is within the strains of its
/// tests, in whatever mode they were made.
fn stability(name: &str, rubber: &Rubber, reach: f64, at: Span) -> Option<Diagnostic> {
    let lost = rubber.unstable_from();
    if lost.is_empty() {
        return None;
    }
    let within = lost.iter().any(|(_, strain)| strain.ln_1p().abs() < reach);
    let of = |mode: &Mode| {
        let strains = lost.iter().filter(|own| own.0 == *mode).map(|own| digits(own.1, 3));
        let strains = strains.collect::<Vec<_>>().join(" and ");
        (!strains.is_empty()).then(|| format!("{} {strains}", mode.word()))
    };
    let said = Mode::ALL.iter().filter_map(of).collect::<Vec<_>>().join(", ");
    let message = format!("the rubber {name} is unstable beyond nominal strains of: {said}");
    let found = match within {
        true => Diagnostic::warning(Code("SL0420"), message),
        false => Diagnostic::note(Code("SL0420"), message),
    };
    let help = match within {
        true => {
            "it loses stability within the strains of its tests: measure in the modes that are \
                 named, or take fewer terms or another form"
        }
        false => "keep strains below; a run says where they are not",
    };
    Some(found.at(at).help(help))
}
