//! Contact of surface with surface in space against closed forms: Hertz; ripple, edges.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Block, Kind, Last, size, solved};

/// So many equal steps of a length, then as many that grow by a factor each.
fn graded(first: f64, even: usize, growing: usize, factor: f64) -> Vec<f64> {
    let (mut places, mut step) = (vec![0.0], first);
    for k in 0..even + growing {
        step *= if k < even { 1.0 } else { factor };
        places.push(places[k] + step);
    }
    places
}

/// A place of a list, by its number over that of all; between two by halves.
fn at(list: &[f64], t: f64) -> f64 {
    let place = t * (list.len() - 1) as f64;
    let k = (place.floor() as usize).min(list.len() - 2);
    list[k] + (place - k as f64) * (list[k + 1] - list[k])
}

/// A quarter of a stiff sphere of radius 5 pressed into a quarter of a block, with faces of a length at
/// the contact.
fn sphere_on_block(kind: Kind, face: f64, press: f64) -> Last {
    const RADIUS: f64 = 5.0;
    let side = graded(face, 7, 6, 1.7);
    let down: Vec<f64> = graded(face, 4, 6, 1.8).iter().rev().map(|z| -z).collect();
    let cells = [side.len() - 1, side.len() - 1, down.len() - 1];
    let block = Block { name: "BLOCK", base: 0, cells, kind };
    let cap = graded(0.83 * face, 12, 0, 1.0);
    let ball = Block { name: "BALL", base: 100_000, cells: [12, 12, 1], kind: Kind::C3d8 };
    let mut deck = String::from("*HEADING\nHertz\n");
    block.write(&mut deck, |[u, v, w]| [at(&side, u), at(&side, v), at(&down, w)]);
    ball.write(&mut deck, |[u, v, w]| {
        let [x, y] = [at(&cap, u), at(&cap, v)];
        let drop = RADIUS - (RADIUS * RADIUS - x * x - y * y).sqrt();
        [x, y, drop + 0.5 * w]
    });
    deck.push_str(&block.surface("TOP", |[_, _, w]| w == 1.0));
    deck.push_str(&ball.surface("CAP", |[_, _, w]| w == 0.0));
    deck.push_str(&block.set("BOTTOM", |[_, _, w]| w == 0.0));
    deck.push_str(&block.set("LEFT", |[u, _, _]| u == 0.0));
    deck.push_str(&block.set("FRONT", |[_, v, _]| v == 0.0));
    deck.push_str(&ball.set("ALLBALL", |_| true));
    deck += &format!(
        "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3
*SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n*SOLID SECTION, ELSET=BALL, MATERIAL=M
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nTOP, CAP
*BOUNDARY\nBOTTOM, 1, 3\nLEFT, 1, 1\nFRONT, 2, 2\nALLBALL, 1, 2
*STEP\n*STATIC\n0.5, 1.0, , 0.5\n*BOUNDARY\nALLBALL, 3, 3, {:?}\n*END STEP\n",
        -press
    );
    solved(&deck)
}

/// Requirement: a rigid sphere on a block carries Hertz' pressure with about seven faces in the radius
/// of contact: the peak within 3 % of p0 = (6 P E'^2/(pi^3 R^2))^(1/3), the radius, by the second
/// moment of the pressure, within 3 %. Source: Johnson, Contact Mechanics, 4.2.
#[test]
fn a_sphere_on_a_block_carries_hertz_pressure() {
    for (kind, face) in [(Kind::C3d8i, 0.03), (Kind::C3d20r, 0.04)] {
        let last = sphere_on_block(kind, face, 0.009);
        let force = 4.0 * last.force()[2].abs();
        let stiff = 1000.0 / (1.0 - 0.09);
        let pi = std::f64::consts::PI;
        let most = (6.0 * force * stiff * stiff / (pi.powi(3) * 25.0)).cbrt();
        let radius = (3.0 * force * 5.0 / (4.0 * stiff)).cbrt();
        let peak = last.contact.iter().map(|row| row.pressure).fold(0.0, f64::max);
        // of p0 (1 - r^2/a^2)^(1/2) the mean of r^2, weighted with the pressure, is 2/5 a^2
        let (mut whole, mut second) = (0.0, 0.0);
        for row in &last.contact {
            let [x, y, _] = row.position;
            whole += row.pressure * row.area;
            second += row.pressure * row.area * (x * x + y * y);
        }
        let width = (2.5 * second / whole).sqrt();
        let what = format!("{kind:?} peak {peak} {most} radius {width} {radius}");
        assert!((peak - most).abs() < 0.03 * most, "{what}");
        assert!((width - radius).abs() < 0.03 * radius, "{what}");
        assert!(last.iterations.iter().all(|&own| own <= 6), "{:?}", last.iterations);
        assert!(last.worst < 1e-11, "{}", last.worst);
    }
}

/// A stiff die with a round foot that is pressed into a slab and slid along it.
fn ironing(formulation: &str) -> String {
    let slab = Block { name: "SLAB", base: 0, cells: [16, 3, 3], kind: Kind::C3d8 };
    let die = Block { name: "DIE", base: 10_000, cells: [5, 2, 1], kind: Kind::C3d8 };
    let mut deck = String::from("*HEADING\nironing\n");
    let round = |x: f64| 3.0 - (9.0 - (2.4 * (x - 0.5)).powi(2)).sqrt();
    slab.write(&mut deck, |[u, v, w]| [8.0 * u, 2.0 * v, 2.0 * w]);
    die.write(&mut deck, |[u, v, w]| {
        [1.6 + 2.4 * u, 0.2 + 1.6 * v, 2.0 + round(u) * (1.0 - w) + 0.8 * w]
    });
    deck.push_str(&slab.surface("TOP", |[_, _, w]| w == 1.0));
    deck.push_str(&die.surface("FOOT", |[_, _, w]| w == 0.0));
    deck.push_str(&slab.set("BASE", |[_, _, w]| w == 0.0));
    deck.push_str(&die.set("HEAD", |[_, _, w]| w == 1.0));
    deck + &format!(
        "*MATERIAL, NAME=SOFT\n*ELASTIC\n1.0, 0.3\n*MATERIAL, NAME=STIFF\n*ELASTIC\n1000.0, 0.3
*SOLID SECTION, ELSET=SLAB, MATERIAL=SOFT\n*SOLID SECTION, ELSET=DIE, MATERIAL=STIFF
*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n*CONTACT PAIR, INTERACTION=I, TYPE={formulation}
FOOT, TOP
*BOUNDARY\nBASE, 1, 3\n*STEP, NLGEOM\n*STATIC\n0.5, 1.0, , 0.5
*BOUNDARY\nHEAD, 1, 2\nHEAD, 3, 3, -0.3\n*END STEP
*STEP, NLGEOM, INC=1000\n*STATIC\n0.025, 1.0, , 0.025
*BOUNDARY\nHEAD, 1, 1, 2.0\nHEAD, 2, 2\nHEAD, 3, 3, -0.3\n*END STEP\n"
    )
}

/// Ripple of a curve about its mean over a pitch of ten increments, over its mean.
fn ripple(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let about = |k: usize| values[k] - values[k - 5..k + 5].iter().sum::<f64>() / 10.0;
    let square: f64 = (5..values.len() - 5).map(|k| about(k).powi(2)).sum();
    (square / (values.len() - 10) as f64).sqrt() / mean.abs()
}

/// Requirement: the force of a die that irons a slab ripples at most a fifth as much as with contact
/// at the nodes, on smoothed faces; forces and moments balance; at most six iterations an increment.
#[test]
fn ironing_in_space_is_smooth() {
    let nodes = solved(&ironing("NODE TO SURFACE"));
    let faces = solved(&ironing("SURFACE TO SURFACE"));
    let along = |last: &Last| -> Vec<f64> { last.forces[12..].iter().map(|f| f[0]).collect() };
    let [rough, smooth] = [&nodes, &faces].map(|last| ripple(&along(last)));
    assert!(smooth < 0.2 * rough, "{smooth:e} {rough:e}");
    assert!(faces.iterations.iter().all(|&own| own <= 6), "{:?}", faces.iterations);
    assert!(faces.worst < 1e-11, "{}", faces.worst);
}

/// Requirement: a block that overhangs the one below it on two sides is carried where it is covered,
/// pulled by no node, with the force of both roles within 2 % of each other; sharp edges have points
/// of their own, so that a side wall does not hold the bottom off.
#[test]
fn an_overhanging_block_is_carried_where_it_is_covered() {
    let forces = [true, false].map(|upper_is_slave| {
        let lower = Block { name: "LOWER", base: 0, cells: [4, 4, 2], kind: Kind::C3d8 };
        let upper = Block { name: "UPPER", base: 10_000, cells: [3, 3, 2], kind: Kind::C3d8 };
        let mut deck = String::from("*HEADING\noverhang\n");
        lower.write(&mut deck, |[x, y, z]| [2.0 * x, 2.0 * y, z]);
        upper.write(&mut deck, |[x, y, z]| [0.93 + 1.5 * x, 0.71 + 1.5 * y, 1.0 + z]);
        deck.push_str(&lower.surface("LOWERFACE", |[_, _, z]| z == 1.0));
        // with the side walls, which face nothing
        let bottom = upper.surface("UPPERFACE", |[_, _, z]| z == 0.0);
        let wall = upper.surface("UPPERFACE", |[x, _, _]| x == 1.0);
        deck += &bottom;
        deck.extend(wall.lines().skip(1).flat_map(|line| [line, "\n"]));
        deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
        deck.push_str(&upper.set("HEAD", |[_, _, z]| z == 1.0));
        let pair = match upper_is_slave {
            true => "UPPERFACE, LOWERFACE",
            false => "LOWERFACE, UPPERFACE",
        };
        deck += &format!(
            "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3
*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n*SOLID SECTION, ELSET=UPPER, MATERIAL=M
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}
*BOUNDARY\nBASE, 1, 3\n*STEP, NLGEOM\n*STATIC\n0.25, 1.0, , 0.25
*BOUNDARY\nHEAD, 1, 2\nHEAD, 3, 3, -0.1\n*END STEP\n"
        );
        let last = solved(&deck);
        assert!(last.contact.iter().all(|row| row.pressure >= 0.0));
        assert!(last.iterations.iter().all(|&own| own <= 6), "{:?}", last.iterations);
        assert!(last.worst < 1e-11, "{}", last.worst);
        size(last.force())
    });
    assert!((forces[0] - forces[1]).abs() < 0.02 * forces[0], "{forces:?}");
}
