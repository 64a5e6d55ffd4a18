//! Materials whose constants depend on temperature.
//!
//! ```text
//!   E |  o
//!     |   \___o          straight between the temperatures of the table,
//!     |        \__o___   constant outside
//!     +---------------- T
//! ```
//!
//! The constants are taken at the temperature, then the law answers as it does with any constants.

use super::expansion::between;
use super::hyperelastic::{Rubber, Volume};
use super::plastic::{Hardening, Plastic, yield_stress};
use super::{Elastic, Material};

/// One law with the constants of several temperatures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Graded(Vec<(f64, Material)>);

impl Graded {
    /// From temperatures [theta], ascending, with the material at each; `None` where there is none
    /// or they are not of one kind.
    pub fn new(rows: Vec<(f64, Material)>) -> Option<Self> {
        let sound = !rows.is_empty()
            && rows
                .windows(2)
                .all(|pair| pair[0].0 < pair[1].0 && mix(&pair[0].1, &pair[1].1, 0.5).is_some());
        sound.then_some(Self(rows))
    }

    /// Rows of a metal whose elasticity and hardening are given at temperatures of their own: at
    /// all of both. Between rows both run straight, as they do in their own tables.
    pub fn metal(
        elastic: &[(f64, Elastic)],
        hardening: &[(f64, Hardening)],
    ) -> Vec<(f64, Material)> {
        let mut temperatures: Vec<f64> = elastic.iter().map(|row| row.0).collect();
        temperatures.extend(hardening.iter().map(|row| row.0));
        temperatures.sort_by(f64::total_cmp);
        temperatures.dedup();
        let at = |temperature: f64| {
            let (low, high, part) = between(elastic, temperature)?;
            let (soft, hard, step) = between(hardening, temperature)?;
            let elastic = low.towards(high, part);
            let table = self::hardening(soft, hard, step);
            Some((temperature, Material::Plastic(Plastic { elastic, table, kinematic: 0.0 })))
        };
        // one line of each holds for all temperatures
        let count = if elastic.len().max(hardening.len()) == 1 { 1 } else { temperatures.len() };
        temperatures.into_iter().take(count).filter_map(at).collect()
    }

    /// The material at each temperature of the table.
    pub fn rows(&self) -> impl Iterator<Item = &Material> {
        self.0.iter().map(|(_, material)| material)
    }

    /// Whatever is made of the material at a temperature; `None`: the table is empty.
    pub fn at<R>(&self, temperature: f64, then: impl FnOnce(&Material) -> R) -> Option<R> {
        let (low, high, part) = between(&self.0, temperature)?;
        match mix(low, high, part).filter(|_| part != 0.0) {
            Some(mixed) => Some(then(&mixed)),
            None => Some(then(low)),
        }
    }
}

fn number(low: f64, high: f64, part: f64) -> f64 {
    low + part * (high - low)
}

/// A material between two of one kind; `None`: they are not.
fn mix(low: &Material, high: &Material, part: f64) -> Option<Material> {
    match (low, high) {
        (Material::Elastic(a, large), Material::Elastic(b, other)) => {
            (large == other).then(|| Material::Elastic(a.towards(b, part), *large))
        }
        (Material::Rubber(a), Material::Rubber(b)) => rubber(a, b, part).map(Material::Rubber),
        (Material::Plastic(a), Material::Plastic(b)) => Some(Material::Plastic(Plastic {
            elastic: a.elastic.towards(&b.elastic, part),
            table: hardening(&a.table, &b.table, part),
            kinematic: number(a.kinematic, b.kinematic, part),
        })),
        _ => None,
    }
}

/// Yield stresses over all plastic strains of two tables.
fn hardening(low: &Hardening, high: &Hardening, part: f64) -> Hardening {
    let mut strains: Vec<f64> = low.iter().chain(high).map(|line| line[1]).collect();
    strains.sort_by(f64::total_cmp);
    strains.dedup();
    let at = |table: &Hardening, strain| yield_stress(table, strain)[0];
    strains
        .into_iter()
        .map(|strain| [number(at(low, strain), at(high, strain), part), strain])
        .collect()
}

fn rubber(low: &Rubber, high: &Rubber, part: f64) -> Option<Rubber> {
    Some(match (low, high) {
        (
            Rubber::Polynomial { terms: a, volume: v },
            Rubber::Polynomial { terms: b, volume: w },
        ) => {
            let same = a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a.0, a.1) == (b.0, b.1));
            let term =
                |(a, b): (&(u8, u8, f64), &(u8, u8, f64))| (a.0, a.1, number(a.2, b.2, part));
            let terms = a.iter().zip(b).map(term).collect();
            return same.then(|| Rubber::Polynomial { terms, volume: volume(v, w, part) });
        }
        (Rubber::Ogden { terms: a, volume: v }, Rubber::Ogden { terms: b, volume: w }) => {
            let term =
                |(a, b): (&[f64; 2], &[f64; 2])| std::array::from_fn(|k| number(a[k], b[k], part));
            let terms = a.iter().zip(b).map(term).collect();
            let same = a.len() == b.len();
            return same.then(|| Rubber::Ogden { terms, volume: volume(v, w, part) });
        }
        (
            Rubber::ArrudaBoyce { shear: a, locking: l, volume: v },
            Rubber::ArrudaBoyce { shear: b, locking: m, volume: w },
        ) => Rubber::ArrudaBoyce {
            shear: number(*a, *b, part),
            locking: number(*l, *m, part),
            volume: inverse(*v, *w, part),
        },
        _ => return None,
    })
}

/// D is what tables give, and 1/D what is kept.
fn volume(low: &Volume, high: &Volume, part: f64) -> Volume {
    std::array::from_fn(|k| inverse(low[k], high[k], part))
}

/// 1/D between two: D runs straight; a term that one of them lacks fades.
fn inverse(low: f64, high: f64, part: f64) -> f64 {
    if low == 0.0 || high == 0.0 {
        number(low, high, part)
    } else {
        1.0 / number(1.0 / low, 1.0 / high, part)
    }
}
