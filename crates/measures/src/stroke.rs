//! Forces in and out of a driven part.
//!
//! ```text
//!   RF |      in (the driver pushes: RF du > 0)
//!      |    .--->
//!      |  .'  <---. out: it must be pulled (RF du > 0)
//!      |-'---------'----> u   or it comes by itself (RF du < 0)
//! ```

use crate::paired::paired;

/// A largest force and where it is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken {
    /// Its size [F] (about a rotation: [F L]).
    pub force: f64,
    /// The displacement [L] (rotation [1]).
    pub at: f64,
    /// Its place in the curve.
    pub place: usize,
    /// What may have been missed between two increments, relative to the force
    /// [-]: the smaller change to its neighbours, or how much higher the lines
    /// of both flanks meet. Zero at the end of a way, where the deck says what
    /// the displacement is.
    pub step: f64,
}

/// What the way out is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WayOut {
    /// There is none in the deck.
    None,
    /// There is one, without a reaction.
    NoReaction,
    /// It must be pulled all the way.
    Pulled,
    /// It must be pulled, but goes by itself from a displacement on.
    PulledUntil(f64),
    /// It comes back by itself.
    SpringsBack,
}

/// The stroke of a driven node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Direction of the way in: 1 or -1.
    pub inward: f64,
    /// Largest force with which it must be pushed on the way in.
    pub push: Option<Taken>,
    /// Largest force with which it must be pulled on the way out.
    pub pull: Option<Taken>,
    /// Work of the driver on the way in and on the way out [F L].
    pub work: [f64; 2],
    /// What the way out is like.
    pub way_out: WayOut,
    /// Whether the curve ends on the way out with the largest pull: it had
    /// not come out.
    pub held_at_the_end: bool,
}

impl Stroke {
    /// Pull-out force over push-in force [-].
    pub fn ratio(&self) -> Option<f64> {
        let (push, pull) = (self.push?.force, self.pull?.force);
        (push > 0.0).then(|| pull / push)
    }
}

/// Reactions smaller than this fraction of the largest are none.
const NOISE: f64 = 1e-9;

/// Judges a curve that begins at the start of the analysis; `None` without
/// motion or for lengths that differ. The way in are the increments in the
/// direction first taken. [docs/report.md: verdict]
pub fn stroke(motion: &[f64], reaction: &[f64]) -> Option<Stroke> {
    let points: Vec<(f64, f64)> = paired(motion, reaction)?.collect();
    let inward = points.windows(2).map(|w| w[1].0 - w[0].0).find(|du| *du != 0.0)?.signum();
    let floor = NOISE * reaction.iter().fold(0.0, |peak: f64, rf| peak.max(rf.abs()));
    let mut ways: [Option<Taken>; 2] = [None, None];
    let mut work = [0.0; 2];
    let mut returns = false;
    let mut pulls: Vec<(bool, f64)> = Vec::new();
    for (place, w) in points.windows(2).enumerate() {
        let ((du, now), rf) = ((w[1].0 - w[0].0, w[1].0), [w[0].1, w[1].1]);
        if du == 0.0 {
            continue;
        }
        let way = usize::from(du * inward < 0.0);
        work[way] += 0.5 * (rf[0] + rf[1]) * du;
        let drives = rf[1] * du > 0.0 && rf[1].abs() > floor;
        if drives && ways[way].is_none_or(|taken| rf[1].abs() > taken.force) {
            let step = step_at(&points, place + 1);
            ways[way] = Some(Taken { force: rf[1].abs(), at: now, place: place + 1, step });
        }
        if way == 1 {
            returns = true;
            if rf[1].abs() > floor {
                pulls.push((drives, now));
            }
        }
    }
    let way_out = match pulls.split_first() {
        None if returns => WayOut::NoReaction,
        None => WayOut::None,
        Some(((false, _), _)) => WayOut::SpringsBack,
        Some(((true, _), rest)) => match rest.iter().find(|(pulled, _)| !pulled) {
            Some((_, at)) => WayOut::PulledUntil(*at),
            None => WayOut::Pulled,
        },
    };
    let [push, pull] = ways;
    let held_at_the_end = pull.is_some_and(|pull| pull.place + 1 == points.len());
    Some(Stroke { inward, push, pull, work, way_out, held_at_the_end })
}

/// The smaller change of the reaction from a place to its neighbours on the
/// same way, or how much higher the flanks beside it meet, relative to the
/// reaction there.
fn step_at(points: &[(f64, f64)], place: usize) -> f64 {
    let Some(&(_, after)) = points.get(place + 1) else { return 0.0 };
    let [(u0, before), (u1, here)] = [points[place - 1], points[place]];
    if (points[place + 1].0 - u1) * (u1 - u0) <= 0.0 || here == 0.0 {
        return 0.0;
    }
    let change = (here - before).abs().min((here - after).abs()) / here.abs();
    let flanks = |first: Option<usize>| first.map_or(0.0, |first| meet(points, first, here));
    change.max(flanks(Some(place - 1))).max(flanks(place.checked_sub(2)))
}

/// How much higher than the peak the line through the first two of four
/// neighbours and that through the last two meet between them, relative to the
/// peak; zero where they do not, or the four are not on one way.
fn meet(points: &[(f64, f64)], first: usize, peak: f64) -> f64 {
    let Some(&[a, b, c, d]) = points.get(first..first + 4) else { return 0.0 };
    let width = c.0 - b.0;
    if (b.0 - a.0) * width <= 0.0 || (d.0 - c.0) * width <= 0.0 {
        return 0.0;
    }
    // along the middle interval, in units of the peak
    let rise = (b.1 - a.1) / (b.0 - a.0) * width / peak;
    let fall = (c.1 - d.1) / (d.0 - c.0) * width / peak;
    let part = ((c.1 - b.1) / peak + fall) / (rise + fall);
    if rise > 0.0 && fall > 0.0 && (0.0..=1.0).contains(&part) {
        (b.1 / peak + rise * part - 1.0).max(0.0)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOTION: [f64; 7] = [0.0, -1.0, -2.0, -3.0, -2.0, -1.0, 0.0];

    fn judged(reaction: [f64; 7]) -> Stroke {
        stroke(&MOTION, &reaction).unwrap()
    }

    /// Requirement: who pushes and who pulls is a matter of the signs of
    /// reaction and motion.
    #[test]
    fn the_way_out_is_a_matter_of_signs() {
        // pushed down (RF < 0); on the way up RF > 0: it must be pulled
        let pulled = judged([0.0, -5.0, -8.0, -7.0, 12.0, 3.0, 1.0]);
        assert_eq!(pulled.push.map(|t| (t.force, t.at, t.place)), Some((8.0, -2.0, 2)));
        assert_eq!(pulled.pull.map(|t| (t.force, t.at, t.place)), Some((12.0, -2.0, 4)));
        assert_eq!((pulled.way_out, pulled.ratio()), (WayOut::Pulled, Some(1.5)));
        assert_eq!(pulled.work, [2.5 + 6.5 + 7.5, 2.5 + 7.5 + 2.0]);
        assert!(!pulled.held_at_the_end && pulled.inward == -1.0);
        let free = judged([0.0, -5.0, -8.0, -7.0, -4.0, -2.0, 0.0]);
        assert_eq!((free.way_out, free.pull, free.ratio()), (WayOut::SpringsBack, None, None));
        let snaps = judged([0.0, -5.0, -8.0, 2.0, 6.0, -2.0, 0.0]);
        assert_eq!(snaps.way_out, WayOut::PulledUntil(-1.0));
        assert_eq!(judged([0.0, -5.0, -8.0, 0.0, 0.0, 0.0, 0.0]).way_out, WayOut::NoReaction);
        let one_way = stroke(&MOTION[..4], &[0.0, -5.0, -8.0, -7.0]).unwrap();
        assert_eq!(one_way.way_out, WayOut::None);
        assert!(stroke(&[0.0, 0.0], &[0.0, 1.0]).is_none());
    }

    /// Requirement: a part whose pull grows to the end of the curve had not
    /// come out.
    #[test]
    fn a_pull_that_grows_to_the_end_is_held() {
        assert!(judged([0.0, -5.0, -8.0, -7.0, 2.0, 6.0, 20.0]).held_at_the_end);
        assert!(!judged([0.0, -5.0, -8.0, -7.0, 2.0, 6.0, 5.0]).held_at_the_end);
    }

    /// Requirement: a peak between coarse increments is told by the steps to
    /// its neighbours; a jump after a smooth rise is none, and neither is a
    /// peak at the end of a way.
    #[test]
    fn a_peak_between_increments_is_told() {
        let coarse = judged([0.0, -2.0, -8.0, -3.0, 1.0, 12.0, 4.0]);
        assert_eq!(coarse.push.map(|t| t.step), Some(0.625));
        assert_eq!(coarse.pull.map(|t| t.step), Some(8.0 / 12.0));
        let way = [0.0, 1.0, 2.0, 3.0, 4.0];
        let jump = stroke(&way, &[0.0, 7.8, 7.9, 8.0, -2.0]).unwrap();
        assert!(jump.push.is_some_and(|t| t.step < 0.02));
        // two equal values beside a peak: its flanks meet higher
        let motion = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        let between = stroke(&motion, &[0.0, 0.25, 1.0, 1.0, 0.25, 0.0]).unwrap();
        assert_eq!(between.push.map(|t| t.step), Some(0.375));
        let flat = stroke(&motion, &[0.0, 0.0, 1.0, 1.0, 1.0, 0.0]).unwrap();
        assert_eq!(flat.push.map(|t| t.step), Some(0.0));
        let end = stroke(&MOTION[..4], &[0.0, -1.0, -4.0, -16.0]).unwrap();
        assert_eq!(end.push.map(|t| t.step), Some(0.0));
    }

    /// Property: the mirror image has the same forces, work and way out.
    #[test]
    fn the_mirror_image_is_judged_alike() {
        let reaction = [0.0, -5.0, -8.0, 2.0, 12.0, -1.0, 0.0];
        let plain = judged(reaction);
        let mirrored = stroke(&MOTION.map(|u| -u), &reaction.map(|rf| -rf)).unwrap();
        assert_eq!((plain.work, plain.ratio()), (mirrored.work, mirrored.ratio()));
        assert_eq!(plain.push.map(|t| t.force), mirrored.push.map(|t| t.force));
        assert_eq!(plain.way_out, WayOut::PulledUntil(-1.0));
        assert_eq!(mirrored.way_out, WayOut::PulledUntil(1.0));
    }
}
