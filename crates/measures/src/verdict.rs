//! Whether a run can be trusted, in three colours.
//!
//! | colour | when |
//! |---|---|
//! | green | every measure is clean |
//! | amber | something is doubtful: noise, energy, a peak between increments, strain, overlap, a warning |
//! | red | the run did not complete, or its numbers are wrong |
//!
//! One table of rules, one row each; the worst row gives the colour, and every
//! row that objects gives its reason. A measure that is missing objects only
//! where its absence is itself doubtful.

/// The three colours, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colour {
    /// Every measure is clean.
    Green,
    /// Something is doubtful.
    Amber,
    /// Not completed, or wrong.
    Red,
}

impl Colour {
    /// The word of `JOB.json`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Green => "green",
            Self::Amber => "amber",
            Self::Red => "red",
        }
    }
}

/// What is held against the rules.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunMeasures {
    /// Why the run did not complete; none where it did.
    pub unfinished: Option<String>,
    /// Largest part of contact forces or moments that one side does not feel [-].
    pub pair_imbalance: Option<f64>,
    /// Largest energy out of balance over the largest energy [-].
    pub energy: Option<f64>,
    /// Largest roughness that the mesh makes in a driven reaction [-].
    pub noise: Option<f64>,
    /// Largest step of a force next to its peak, over the peak [-].
    pub peak_step: Option<f64>,
    /// Largest strain of a fibre, or principal one of a solid with a linear law [-].
    pub strain: Option<f64>,
    /// Largest nominal strain of a rubber where its law is unstable [-].
    pub unstable: Option<f64>,
    /// How far an element turned or strained under linear kinematics [-].
    pub linear: Option<f64>,
    /// Largest strain or stress over the allowable one [-], where there is one.
    pub utilisation: Option<f64>,
    /// Deepest penetration in c0 of a softened law [-].
    pub penetration: Option<f64>,
    /// Codes of the warnings.
    pub said: Vec<String>,
    /// Codes of the advice that casts doubt.
    pub advised: Vec<String>,
}

/// A colour with what it is owed to.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The worst of the rows.
    pub colour: Colour,
    /// Every row that objects, the worst first.
    pub reasons: Vec<(Colour, String)>,
}

/// Forces of a pair that are left over are wrong above this: thousands of
/// times what rounding leaves.
const UNBALANCED: f64 = 1e-9;
/// Energy out of balance: doubtful, wrong.
const ENERGY: [f64; 2] = [0.05, 0.5];
/// Roughness of a noisy reaction (SL0610).
const NOISE: f64 = 0.01;
/// Step next to a peak above which the true peak is not known.
pub const COARSE_PEAK: f64 = 0.1;
/// Beams whose sections turn away from their axis.
const OVERPULLED: &str = "SL0625";
/// Fibre strain above which a linear law is doubtful for most materials.
const STRAIN: f64 = 0.05;
/// Turn or strain that linear kinematics follow: errors are half its square.
const LINEAR: f64 = 0.1;
/// Penetration in c0 (SL0612).
const PENETRATION: f64 = 3.0;

/// A row of the table: a colour, and why where it objects.
type Rule = (Colour, Option<String>);

/// Judges a run: the table of rules. [docs/report.md: verdict]
pub fn verdict(measures: &RunMeasures) -> Verdict {
    let rules = wrong(measures).into_iter().chain(doubtful(measures));
    let mut reasons: Vec<(Colour, String)> =
        rules.filter_map(|(colour, reason)| Some((colour, reason?))).collect();
    reasons.sort_by_key(|(colour, _)| std::cmp::Reverse(*colour));
    let colour = reasons.first().map_or(Colour::Green, |(colour, _)| *colour);
    Verdict { colour, reasons }
}

/// A measure where it lies above a limit; what is no number is never clean.
fn above(value: Option<f64>, limit: f64) -> Option<f64> {
    value.filter(|value| value.is_nan() || *value > limit)
}

/// What makes a result wrong; energy is red far out of balance, amber before.
fn wrong(measures: &RunMeasures) -> [Rule; 6] {
    let energy = |left: f64| {
        format!("energy: {} % of it does not balance; use shorter increments", percent(left))
    };
    let lost = above(measures.energy, ENERGY[1]);
    [
        (Colour::Red, measures.unfinished.clone()),
        (
            Colour::Red,
            measures.said.iter().any(|code| code == OVERPULLED).then(|| {
                format!(
                    "beams: the tension of one is too large for its shear stiffness ({OVERPULLED})"
                )
            }),
        ),
        (
            Colour::Red,
            above(measures.pair_imbalance, UNBALANCED)
                .map(|_| "the two sides of a contact pair do not feel the same force".to_owned()),
        ),
        (Colour::Red, lost.map(energy)),
        (Colour::Amber, above(measures.energy, ENERGY[0]).xor(lost).map(energy)),
        (
            Colour::Red,
            above(measures.utilisation, 1.0).map(|used| {
                format!(
                    "allowable: the part is at {} % of it; beyond it elastic results are not valid",
                    percent(used)
                )
            }),
        ),
    ]
}

/// What makes a result doubtful.
fn doubtful(measures: &RunMeasures) -> [Rule; 8] {
    let strain = above(measures.strain, STRAIN).filter(|_| measures.utilisation.is_none());
    [
        strain.map(|strain| {
            format!(
                "strain: {} %, large for an elastic law, and no allowable is given (*ALLOWABLE)",
                percent(strain)
            )
        }),
        measures.unstable.map(|strain| {
            format!(
                "rubber: strained by {} % where its law is unstable (SL0420)",
                percent(strain)
            )
        }),
        above(measures.linear, LINEAR).map(|turned| {
            format!(
                "kinematics: an element turns or strains by {} % in a step without NLGEOM (SL0247)",
                percent(turned)
            )
        }),
        above(measures.noise, NOISE)
            .map(|rough| format!("noise: the reaction is rough by {} % of its peak", percent(rough))),
        above(measures.peak_step, COARSE_PEAK).map(|step| {
            format!(
                "increments: next to its peak the force changes by {} %, so the true peak may be higher",
                percent(step)
            )
        }),
        above(measures.penetration, PENETRATION)
            .map(|ratio| format!("overlap: the contact is pressed in by {ratio:.1} times c0")),
        listed(&measures.said, ["warning", "warnings"]),
        listed(&measures.advised, ["advice", "advice"]),
    ]
    .map(|reason| (Colour::Amber, reason))
}

/// Per cent with three digits.
fn percent(value: f64) -> String {
    let value = 100.0 * value;
    let digits = if value.abs() < 1.0 {
        3
    } else if value.abs() < 100.0 {
        1
    } else {
        0
    };
    let text = format!("{value:.digits$}");
    let short = if digits > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    short.to_owned()
}

/// Codes in order, each once with how often, behind a noun for one and for more.
fn listed(said: &[String], [one_said, more]: [&str; 2]) -> Option<String> {
    let mut codes: Vec<(&str, usize)> = Vec::new();
    for code in said {
        match codes.iter_mut().find(|(known, _)| known == code) {
            Some((_, count)) => *count += 1,
            None => codes.push((code, 1)),
        }
    }
    let one = |(code, count): &(&str, usize)| match count {
        1 => (*code).to_owned(),
        many => format!("{code} ({many} times)"),
    };
    let list: Vec<String> = codes.iter().map(one).collect();
    let noun = if said.len() == 1 { one_said } else { more };
    (!list.is_empty()).then(|| format!("{noun}: {}", list.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clean() -> RunMeasures {
        RunMeasures {
            unfinished: None,
            pair_imbalance: Some(1e-14),
            energy: Some(0.01),
            noise: None,
            peak_step: Some(0.02),
            strain: Some(0.01),
            unstable: None,
            linear: Some(0.05),
            utilisation: Some(0.5),
            penetration: Some(0.9),
            said: Vec::new(),
            advised: Vec::new(),
        }
    }

    /// Requirement: row by row, each rule alone decides the colour and gives
    /// its one reason.
    #[test]
    fn every_row_of_the_table() {
        assert_eq!(verdict(&clean()), Verdict { colour: Colour::Green, reasons: Vec::new() });
        assert_eq!(verdict(&RunMeasures::default()).colour, Colour::Green);
        let nan = Some(f64::NAN);
        let said = |code: &str| RunMeasures { said: vec![code.into()], ..clean() };
        let rows: Vec<(Colour, &str, RunMeasures)> = vec![
            (
                Colour::Red,
                "not converged",
                RunMeasures { unfinished: Some("not converged".into()), ..clean() },
            ),
            (Colour::Red, "two sides", RunMeasures { pair_imbalance: Some(1e-5), ..clean() }),
            (Colour::Red, "two sides", RunMeasures { pair_imbalance: nan, ..clean() }),
            (Colour::Red, "energy: 58 %", RunMeasures { energy: Some(0.58), ..clean() }),
            (Colour::Red, "energy", RunMeasures { energy: nan, ..clean() }),
            (Colour::Amber, "energy: 6 %", RunMeasures { energy: Some(0.06), ..clean() }),
            (Colour::Red, "at 120 % of it", RunMeasures { utilisation: Some(1.2), ..clean() }),
            (Colour::Red, "allowable", RunMeasures { utilisation: nan, ..clean() }),
            (
                Colour::Amber,
                "*ALLOWABLE",
                RunMeasures { strain: Some(0.06), utilisation: None, ..clean() },
            ),
            (Colour::Amber, "warning: SL0624", said("SL0624")),
            (Colour::Amber, "rubber: ", RunMeasures { unstable: Some(2.0), ..clean() }),
            (Colour::Amber, "NLGEOM", RunMeasures { linear: Some(0.2), ..clean() }),
            (Colour::Amber, "noise: ", RunMeasures { noise: Some(0.02), ..clean() }),
            (Colour::Amber, "increments: ", RunMeasures { peak_step: Some(0.2), ..clean() }),
            (Colour::Amber, "overlap: ", RunMeasures { penetration: Some(4.0), ..clean() }),
            (Colour::Amber, "warning: SL0402", said("SL0402")),
            (
                Colour::Amber,
                "advice: SL0614",
                RunMeasures { advised: vec!["SL0614".into()], ..clean() },
            ),
        ];
        for (colour, reason, measures) in rows {
            let found = verdict(&measures);
            assert_eq!((found.colour, found.reasons.len()), (colour, 1), "{reason}: {found:?}");
            assert!(found.reasons[0].1.contains(reason), "{reason}: {found:?}");
        }
        let beams = verdict(&said("SL0625"));
        assert_eq!((beams.colour, beams.reasons.len()), (Colour::Red, 2), "{beams:?}");
        // strain is judged by its allowable where there is one
        let strained = RunMeasures { strain: Some(0.06), utilisation: Some(0.9), ..clean() };
        assert_eq!(verdict(&strained).colour, Colour::Green);
    }

    /// Requirement: the worst row gives the colour and stands first; none is
    /// lost, and a code said twice is one entry.
    #[test]
    fn the_worst_row_rules() {
        let said = ["SL0405", "SL0403", "SL0405"].map(str::to_owned).to_vec();
        let found = verdict(&RunMeasures { noise: Some(0.05), energy: Some(0.9), said, ..clean() });
        let colours: Vec<Colour> = found.reasons.iter().map(|(colour, _)| *colour).collect();
        assert_eq!(found.colour, Colour::Red);
        assert_eq!(colours, [Colour::Red, Colour::Amber, Colour::Amber]);
        assert_eq!(found.reasons[2].1, "warnings: SL0405 (2 times), SL0403");
    }
}
