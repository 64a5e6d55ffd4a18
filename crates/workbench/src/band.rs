//! The forces that tolerances of the parameters allow.
//!
//! To first order the force at a travel is F + sum (dF/dp) e_p, the e_p spread evenly over their
//! tolerances and independent: a sum with the deviation sqrt(sum (dF/dp t_p)^2/3), taken as normal.
//! The slopes are exact derivatives of the run, taken to the same travel: dF/dp - F' du/dp, where u is
//! the travel of the row and F' the slope of the curve there. Where a parameter has none, or only that of
//! one side, they are differences of curves half a tolerance to both sides.

use crate::answers::{overtaken, refused};
use crate::deck::Opened;
use crate::rates::differentiated;
use crate::solve::{OVERTAKEN, Room, quietly};
use crate::values::Values;
use serde_json::{Value, json};

/// What 5 to 95 % of a normal distribution reach, in deviations.
const REACH: f64 = 1.644_853_626_951_472_7;

/// Lowest and highest force over the travel.
pub(crate) fn band(
    opened: &Opened,
    values: &Values,
    room: &mut Room,
    (id, asked): (&Value, &Value),
    say: &mut dyn FnMut(&str) -> bool,
) -> Value {
    let tolerances = match tolerances(opened, asked) {
        Ok(own) => own,
        Err(why) => return refused(id, &why),
    };
    let exact = asked.get("slopes").and_then(Value::as_str) != Some("differences");
    if let Some((place, _)) = tolerances.iter().find(|(place, _)| values.0[*place] == 0.0) {
        let name = &opened.sliders[*place].name;
        return refused(id, &format!("{name} is 0: a share of it is no tolerance"));
    }
    match spread(opened, values, room, (&tolerances, exact), say) {
        Ok(Spread { curve, deviations, differences }) => {
            let column = |of: &dyn Fn(&[f64; 2], f64) -> f64| -> Value {
                curve
                    .iter()
                    .zip(&deviations)
                    .map(|(own, deviation)| json!(of(own, *deviation)))
                    .collect()
            };
            json!({
                "say": "band",
                "id": id,
                "travel": column(&|own, _| own[0]),
                "low": column(&|own, deviation| own[1] - REACH * deviation),
                "high": column(&|own, deviation| own[1] + REACH * deviation),
                "share": "5 to 95 %",
                "differences": differences,
            })
        }
        Err(why) if why == OVERTAKEN => overtaken(id),
        Err(why) => refused(id, &why),
    }
}

/// Places of parameters, and their tolerances relative to the value.
fn tolerances(opened: &Opened, asked: &Value) -> Result<Vec<(usize, f64)>, String> {
    let members = asked.get("tolerances").and_then(Value::as_object).into_iter().flatten();
    let own = members.map(|(name, share)| {
        let place = opened.sliders.iter().position(|own| own.name == *name);
        let place = place.ok_or_else(|| format!("the deck has no parameter {name}"))?;
        let sound = share.as_f64().filter(|own| own.is_finite() && *own >= 0.0);
        Ok((place, sound.ok_or_else(|| format!("the tolerance of {name} is no number"))?))
    });
    let own: Result<Vec<(usize, f64)>, String> = own.collect();
    own.map(|list| list.into_iter().filter(|(_, share)| *share > 0.0).collect())
}

type Curve = Vec<[f64; 2]>;

/// The curve, the deviation of its forces, and what has no exact slopes.
struct Spread {
    curve: Curve,
    deviations: Vec<f64>,
    differences: Vec<String>,
}

fn spread(
    opened: &Opened,
    values: &Values,
    room: &mut Room,
    (tolerances, exact): (&[(usize, f64)], bool),
    say: &mut dyn FnMut(&str) -> bool,
) -> Result<Spread, String> {
    let places: Vec<usize> = tolerances.iter().map(|own| own.0).filter(|_| exact).collect();
    let (middle, rates) = differentiated(opened, values, room, &places, say)?;
    let middle = middle.curve;
    let (mut squares, mut differences) = (vec![0.0; middle.len()], Vec::new());
    for (number, &(place, share)) in tolerances.iter().enumerate() {
        let tolerance = share * values.0[place].abs();
        let rates = rates.get(number).and_then(Option::as_ref);
        let changes = match rates.filter(|own| own.one_sided >= middle.len()) {
            Some(own) => at_travel(&middle, &own.curve).map(|slope| slope * tolerance).collect(),
            None => {
                differences.push(opened.sliders[place].name.clone());
                let mut side = |sign: f64| {
                    let own = values.with(place, values.0[place] + sign * 0.5 * tolerance);
                    Ok::<_, String>(at_travels(&middle, &quietly(opened, &own, room, say)?.curve))
                };
                let (below, above) = (side(-1.0)?, side(1.0)?);
                below.iter().zip(&above).map(|(low, high)| high - low).collect::<Vec<f64>>()
            }
        };
        for (square, change) in squares.iter_mut().zip(changes) {
            // the square of the slope times the tolerance is three times that of the deviation
            *square += change.powi(2) / 3.0;
        }
    }
    let deviations = squares.into_iter().map(f64::sqrt).collect();
    Ok(Spread { curve: middle, deviations, differences })
}

/// Derivatives of the forces at the same travel, from those of travel and force row by row.
fn at_travel(curve: &[[f64; 2]], rates: &[[f64; 2]]) -> impl Iterator<Item = f64> {
    rates.iter().enumerate().map(|(row, [motion, force])| {
        let before = row.saturating_sub(1);
        let ends = curve.get(before).zip(curve.get(row)).filter(|(a, b)| a[0] != b[0]);
        let slope = ends.map_or(0.0, |(a, b)| (b[1] - a[1]) / (b[0] - a[0]));
        force - slope * motion
    })
}

/// Forces of another curve at the travels of a curve, on the same way in or out.
fn at_travels(curve: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<f64> {
    let (own, others) = (ways(curve), ways(other));
    let mut forces = Vec::with_capacity(curve.len());
    for (number, way) in own.iter().enumerate() {
        // both turn as often, or the last way serves for the rest
        let Some(same) = others.get(number).or(others.last()) else { break };
        let first = usize::from(number > 0);
        forces.extend(way[first..].iter().map(|point| at(same, point[0])));
    }
    forces
}

/// A curve cut where its travel turns; neighbours share the point where it does.
fn ways(curve: &[[f64; 2]]) -> Vec<&[[f64; 2]]> {
    let (mut all, mut begin, mut sense) = (Vec::new(), 0, 0.0);
    for (place, ends) in curve.windows(2).enumerate() {
        let way = ends[1][0] - ends[0][0];
        if way * sense < 0.0 {
            all.push(&curve[begin..=place]);
            begin = place;
        }
        if way != 0.0 {
            sense = way;
        }
    }
    all.push(&curve[begin..]);
    all
}

/// The force of a way at a travel, linear between its points; beyond its ends that of the end.
fn at(way: &[[f64; 2]], travel: f64) -> f64 {
    let between = way.windows(2).find(|ends| {
        let (a, b) = (ends[0][0], ends[1][0]);
        a != b && (a.min(b)..=a.max(b)).contains(&travel)
    });
    if let Some([[a, from], [b, to]]) = between.and_then(|own| own.first_chunk::<2>()) {
        return from + (to - from) * (travel - a) / (b - a);
    }
    let off = |own: &&[f64; 2]| (own[0] - travel).abs();
    way.iter().min_by(|a, b| off(a).total_cmp(&off(b))).map_or(0.0, |own| own[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: forces are compared at the same travel on the same way, whatever increments
    /// lead there.
    #[test]
    fn ways_are_kept_apart() {
        let curve = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [1.0, -5.0], [0.0, 0.0]];
        let other = [[0.0, 0.0], [2.5, 5.0], [1.5, -6.0], [0.0, 0.0]];
        let cut: Vec<usize> = ways(&curve).iter().map(|way| way.len()).collect();
        assert_eq!(cut, [3, 3]);
        assert_eq!(at_travels(&curve, &other), [0.0, 2.0, 4.0, -4.0, 0.0]);
        assert_eq!(at_travels(&curve, &curve), [0.0, 1.0, 2.0, -5.0, 0.0]);
        assert_eq!(at(&other[..2], 9.0), 5.0);
    }
}
