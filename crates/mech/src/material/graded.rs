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

use super::elastic::Elastic;
use super::expansion::between;
use super::hardening::{Hardening, yield_stress};
use super::hyperelastic::{Rubber, Volume};
use super::law::{Graded, Material};
use super::plastic::Plastic;
use std::cell::Cell;

thread_local! {
    /// Where constants between two rows are written, once more and again.
    static ROOM: Cell<Option<Material>> = const { Cell::new(None) };
}

impl Graded {
    /// From temperatures [theta], ascending, with the material at each; `None` where there is none
    /// or they are not of one kind.
    pub fn new(mut rows: Vec<(f64, Material)>) -> Option<Self> {
        at_all_strains(&mut rows);
        let sound = !rows.is_empty()
            && rows.windows(2).all(|pair| {
                pair[0].0 < pair[1].0 && mix(&pair[0].1, &pair[1].1, 0.5, None).is_some()
            });
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
            let strains = all_strains([soft, hard].into_iter());
            let at = |strain| {
                let [soft, hard] = [soft, hard].map(|table| yield_stress(table, strain)[0]);
                [number(soft, hard, step), strain]
            };
            let table = strains.into_iter().map(at).collect();
            Some((
                temperature,
                Material::Plastic(Plastic { elastic, table, back_stresses: Vec::new() }),
            ))
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
        if part == 0.0 {
            return Some(then(low));
        }
        let Some(mixed) = mix(low, high, part, ROOM.take()) else { return Some(then(low)) };
        let answer = then(&mixed);
        ROOM.set(Some(mixed));
        Some(answer)
    }
}

fn number(low: f64, high: f64, part: f64) -> f64 {
    low + part * (high - low)
}

/// Plastic strains of all tables, ascending.
fn all_strains<'a>(tables: impl Iterator<Item = &'a Hardening>) -> Vec<f64> {
    let mut strains: Vec<f64> = tables.flatten().map(|line| line[1]).collect();
    strains.sort_by(f64::total_cmp);
    strains.dedup();
    strains
}

/// Gives the yield stresses of every row at the plastic strains of all rows.
fn at_all_strains(rows: &mut [(f64, Material)]) {
    let tables = rows.iter().filter_map(|(_, own)| match own {
        Material::Plastic(plastic) => Some(&plastic.table),
        _ => None,
    });
    let strains = all_strains(tables);
    for (_, own) in rows {
        if let Material::Plastic(plastic) = own {
            let at = |strain: &f64| [yield_stress(&plastic.table, *strain)[0], *strain];
            plastic.table = strains.iter().map(at).collect();
        }
    }
}

/// A material between two of one kind, in the room of one that is no longer needed; `None`: they
/// are not.
fn mix(low: &Material, high: &Material, part: f64, room: Option<Material>) -> Option<Material> {
    match (low, high) {
        (Material::Elastic(a, large), Material::Elastic(b, other)) => {
            (large == other).then(|| Material::Elastic(a.towards(b, part), *large))
        }
        (Material::Rubber(a), Material::Rubber(b)) => {
            rubber(a, b, part, room).map(Material::Rubber)
        }
        (Material::Plastic(a), Material::Plastic(b)) => {
            if !(a.back_stresses.is_empty() && b.back_stresses.is_empty()) {
                return None;
            }
            let mut table = match room {
                Some(Material::Plastic(plastic)) => plastic.table,
                _ => Hardening::new(),
            };
            let line = |(a, b): (&[f64; 2], &[f64; 2])| [number(a[0], b[0], part), a[1]];
            fill(&mut table, a.table.iter().zip(&b.table).map(line));
            Some(Material::Plastic(Plastic {
                elastic: a.elastic.towards(&b.elastic, part),
                table,
                back_stresses: Vec::new(),
            }))
        }
        _ => None,
    }
}

/// Writes a list into room that may have held another.
fn fill<T>(room: &mut Vec<T>, items: impl Iterator<Item = T>) {
    room.clear();
    room.extend(items);
}

fn rubber(low: &Rubber, high: &Rubber, part: f64, room: Option<Material>) -> Option<Rubber> {
    Some(match (low, high) {
        (
            Rubber::Polynomial { terms: a, volume: v },
            Rubber::Polynomial { terms: b, volume: w },
        ) => {
            let same = a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a.0, a.1) == (b.0, b.1));
            if !same {
                return None;
            }
            let mut terms = match room {
                Some(Material::Rubber(Rubber::Polynomial { terms, .. })) => terms,
                _ => Vec::new(),
            };
            let term =
                |(a, b): (&(u8, u8, f64), &(u8, u8, f64))| (a.0, a.1, number(a.2, b.2, part));
            fill(&mut terms, a.iter().zip(b).map(term));
            Rubber::Polynomial { terms, volume: volume(v, w, part) }
        }
        (Rubber::Ogden { terms: a, volume: v }, Rubber::Ogden { terms: b, volume: w }) => {
            if a.len() != b.len() {
                return None;
            }
            let mut terms = match room {
                Some(Material::Rubber(Rubber::Ogden { terms, .. })) => terms,
                _ => Vec::new(),
            };
            let term =
                |(a, b): (&[f64; 2], &[f64; 2])| std::array::from_fn(|k| number(a[k], b[k], part));
            fill(&mut terms, a.iter().zip(b).map(term));
            Rubber::Ogden { terms, volume: volume(v, w, part) }
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
