//! The verdict: what a designer wants to know first.
//!
//! ```text
//!   RF |      in (driver pushes: RF du > 0)
//!      |    .--->
//!      |  .'  <---. out: pull it (RF du > 0: self-locking)
//!      |-'---------'----> U   or hold it back (RF du < 0: it comes by itself)
//! ```

use super::results::{Driven, Results};
use crate::number::general;

/// A largest force and where it is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Taken {
    /// Its size [F] (about a rotation: [F L]).
    pub force: f64,
    /// The displacement [L] (rotation [1]).
    pub at: f64,
}

/// What the way back says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Locking {
    /// There is none in the deck.
    NoReturn,
    /// There is one, without a reaction.
    NoReaction,
    /// It must be pulled out all the way.
    Locked,
    /// It must be pulled, but goes by itself from a displacement on.
    LockedUntil(f64),
    /// It comes back by itself.
    Free,
}

/// The stroke of a driven node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stroke {
    /// Largest force with which it must be pushed on the way in.
    pub insertion: Option<Taken>,
    /// Largest force with which it must be pulled on the way out.
    pub retention: Option<Taken>,
    /// Work of the driver on the way in and on the way out [F L].
    pub work: [f64; 2],
    /// Self-locking or not.
    pub locking: Locking,
}

/// Reactions smaller than this fraction of the largest are none.
const NOISE: f64 = 1e-9;

/// Judges a curve that begins at the start of the analysis; `None` without
/// motion. The way in are the steps in the direction first taken.
/// [docs/report.md: verdict]
pub(crate) fn stroke(motion: &[f64], reaction: &[f64]) -> Option<Stroke> {
    let steps = motion.windows(2).zip(reaction.windows(2));
    let inward = motion.windows(2).map(|u| u[1] - u[0]).find(|du| *du != 0.0)?.signum();
    let floor = NOISE * reaction.iter().fold(0.0, |peak: f64, rf| peak.max(rf.abs()));
    let mut ways: [Option<Taken>; 2] = [None, None];
    let mut work = [0.0; 2];
    let mut returns = false;
    let mut pulls: Vec<(bool, f64)> = Vec::new();
    for (u, rf) in steps {
        let du = u[1] - u[0];
        if du == 0.0 {
            continue;
        }
        let way = usize::from(du * inward < 0.0);
        work[way] += 0.5 * (rf[0] + rf[1]) * du;
        let drives = rf[1] * du > 0.0 && rf[1].abs() > floor;
        if drives && ways[way].is_none_or(|taken| rf[1].abs() > taken.force) {
            ways[way] = Some(Taken { force: rf[1].abs(), at: u[1] });
        }
        if way == 1 {
            returns = true;
            if rf[1].abs() > floor {
                pulls.push((drives, u[1]));
            }
        }
    }
    let locking = match pulls.split_first() {
        None if returns => Locking::NoReaction,
        None => Locking::NoReturn,
        Some(((false, _), _)) => Locking::Free,
        Some(((true, _), rest)) => match rest.iter().find(|(pulled, _)| !pulled) {
            Some((_, at)) => Locking::LockedUntil(*at),
            None => Locking::Locked,
        },
    };
    Some(Stroke { insertion: ways[0], retention: ways[1], work, locking })
}

/// The verdict in short sentences, the first on how the run ended.
pub(crate) fn sentences(results: &Results) -> Vec<String> {
    let mut said = vec![ending(results)];
    let mut strokes: Vec<(&Driven, Stroke)> = Vec::new();
    for driven in &results.driven {
        let motion = results.curve(driven.node, &driven.motion);
        let reaction = results.curve(driven.node, &driven.reaction);
        if let (Some(motion), Some(reaction)) = (motion, reaction)
            && let Some(stroke) = stroke(&motion, &reaction)
        {
            strokes.push((driven, stroke));
        }
    }
    // what does most work is what the part is about
    let size = |stroke: &Stroke| stroke.work[0].abs() + stroke.work[1].abs();
    strokes.sort_by(|a, b| size(&b.1).total_cmp(&size(&a.1)));
    if let Some((driven, stroke)) = strokes.first() {
        said.extend(of_stroke(driven, stroke));
        if strokes.len() > 1 {
            said.push(format!("{} further driven motions are shown below", strokes.len() - 1));
        }
    } else if results.driven.is_empty() {
        said.push("no node is driven, so there is no insertion or retention force".to_owned());
    }
    said.push(strain(results));
    said.iter().map(|sentence| capital(sentence)).collect()
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn ending(results: &Results) -> String {
    let summary = &results.summary;
    let count = |key: &str| summary.count(key).unwrap_or_default();
    let (increments, cutbacks) = (results.energies.times.len(), count("cutbacks"));
    let cutbacks = match cutbacks {
        0 => "no cutback".to_owned(),
        1 => "1 cutback".to_owned(),
        many => format!("{many} cutbacks"),
    };
    let plural = if increments == 1 { "" } else { "s" };
    let counts =
        format!("{increments} increment{plural}, {} iterations, {cutbacks}", count("iterations"));
    let diagnosis = summary.get("diagnosis");
    let because = diagnosis.map_or_else(String::new, |said| {
        let (code, message) = (said.text("code"), said.text("message"));
        format!(" because {} ({})", message.unwrap_or("?"), code.unwrap_or("?"))
    });
    match summary.text("status").unwrap_or_default() {
        "completed" => format!("Completed: {counts}"),
        "not_converged" => format!("Not converged{because}; kept are {counts}"),
        "interrupted" => format!("Interrupted on request; kept are {counts}"),
        "output_error" => format!("Results could not be written to the end; kept are {counts}"),
        "running" => {
            format!("Not finished: running or killed; written so far are {increments} increments")
        }
        _ => format!("Ended by a fault of the program{because}; kept are {counts}"),
    }
}

fn of_stroke(driven: &Driven, stroke: &Stroke) -> Vec<String> {
    let Driven { node, motion, reaction } = driven;
    let kind = if reaction.starts_with("RM") { "moment" } else { "force" };
    let number = |value: f64| general(value, 5);
    let taken =
        |taken: &Taken| format!("{} at {motion} = {}", number(taken.force), number(taken.at));
    let mut said = vec![match &stroke.insertion {
        Some(found) => format!("peak insertion {kind} {} (node {node}, {reaction})", taken(found)),
        None => format!("no insertion {kind} (node {node}, {reaction})"),
    }];
    if stroke.locking == Locking::NoReturn {
        said.push(format!("work in {}", number(stroke.work[0])));
        said.push(
            "this deck has no return stroke, so retention and self-locking are not known"
                .to_owned(),
        );
        return said;
    }
    said.push(match &stroke.retention {
        Some(found) => format!("peak retention {kind} {}", taken(found)),
        None => format!("no retention {kind}"),
    });
    said.push(format!("work in {}, work out {}", number(stroke.work[0]), number(stroke.work[1])));
    said.push(match stroke.locking {
        Locking::Locked => "self-locking: it must be pulled out all the way".to_owned(),
        Locking::LockedUntil(at) => {
            format!("self-locking until {motion} = {}, from there it goes by itself", number(at))
        }
        Locking::Free => "not self-locking: it comes back by itself".to_owned(),
        _ => "the return stroke has no reaction, so self-locking is not known".to_owned(),
    });
    said
}

fn strain(results: &Results) -> String {
    let said = results.summary.get("fibre_strain").and_then(|strain| {
        Some((strain.number("max")?, strain.count("element")?, strain.number("time")?))
    });
    let shown = || {
        let (value, element, state) = results.frames.strain?;
        let time = state.checked_sub(1).and_then(|place| results.energies.times.get(place));
        Some((value, usize::try_from(element).ok()?, time.copied().unwrap_or(0.0)))
    };
    match said.or_else(shown) {
        Some((value, element, time)) if value > 0.0 => format!(
            "peak fibre strain {} % in element {element} at time {}",
            general(100.0 * value, 4),
            general(time, 5)
        ),
        _ => "no beam is strained".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOTION: [f64; 7] = [0.0, -1.0, -2.0, -3.0, -2.0, -1.0, 0.0];

    /// Requirement: issue text, "defined by the signs of reaction and motion".
    #[test]
    fn self_locking_is_a_matter_of_signs() {
        let judged = |reaction: [f64; 7]| stroke(&MOTION, &reaction).unwrap();
        // pushed down (RF < 0); on the way up RF > 0: it must be pulled
        let locked = judged([0.0, -5.0, -8.0, -7.0, 12.0, 3.0, 1.0]);
        assert_eq!(locked.insertion, Some(Taken { force: 8.0, at: -2.0 }));
        assert_eq!(locked.retention, Some(Taken { force: 12.0, at: -2.0 }));
        assert_eq!(locked.locking, Locking::Locked);
        assert_eq!(locked.work, [2.5 + 6.5 + 7.5, 2.5 + 7.5 + 2.0]);
        let free = judged([0.0, -5.0, -8.0, -7.0, -4.0, -2.0, 0.0]);
        assert_eq!((free.locking, free.retention), (Locking::Free, None));
        let snaps = judged([0.0, -5.0, -8.0, 2.0, 6.0, -2.0, 0.0]);
        assert_eq!(snaps.locking, Locking::LockedUntil(-1.0));
        assert_eq!(judged([0.0, -5.0, -8.0, 0.0, 0.0, 0.0, 0.0]).locking, Locking::NoReaction);
        let one_way = stroke(&MOTION[..4], &[0.0, -5.0, -8.0, -7.0]).unwrap();
        assert_eq!(one_way.locking, Locking::NoReturn);
        assert!(stroke(&[0.0, 0.0], &[0.0, 1.0]).is_none());
    }

    /// Property: the mirror image has the same forces, work and locking.
    #[test]
    fn the_mirror_image_is_judged_alike() {
        let reaction = [0.0, -5.0, -8.0, 2.0, 12.0, -1.0, 0.0];
        let plain = stroke(&MOTION, &reaction).unwrap();
        let mirrored = stroke(&MOTION.map(|u| -u), &reaction.map(|rf| -rf)).unwrap();
        assert_eq!(plain.work, mirrored.work);
        assert_eq!(plain.insertion.map(|t| t.force), mirrored.insertion.map(|t| t.force));
        assert_eq!(plain.locking, Locking::LockedUntil(-1.0));
        assert_eq!(mirrored.locking, Locking::LockedUntil(1.0));
    }
}
