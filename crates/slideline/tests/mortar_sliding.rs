//! Contact of surface with surface that slides: tangents, balance, iterations.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

mod mortar_decks;

use mortar_decks::{Block, Kind, Last, watched, checked};
use std::fmt::Write as _;

/// A block that is pressed upon a wider one and slid along it.
struct Slider {
    kinds: [Kind; 2],
    upper_is_slave: bool,
    law: &'static str,
    friction: &'static str,
    way: f64,
    press: f64,
    increments: f64,
    ring: bool,
}

impl Slider {
    fn deck(&self) -> String {
        let mut deck = String::from("*HEADING\nslider\n");
        let lower = Block { base: 0, cells: [9, 3], kind: self.kinds[0] };
        let upper = Block { base: 10_000, cells: [5, 3], kind: self.kinds[1] };
        let shift = if self.ring { 3.0 } else { 0.0 };
        let bump = |t: f64| t * (1.0 - t);
        lower.write_as(&mut deck, "LOWER", true, |[x, y]| {
            [shift + 2.0 * x, 0.5 * y * (1.0 + 0.08 * bump(x))]
        });
        upper.write_as(&mut deck, "UPPER", true, |[x, y]| {
            [shift + 0.45 + 0.6 * x, 0.512 + 0.4 * y - 0.1 * bump(x) * (1.0 - y)]
        });
        deck.push_str(&lower.surface("LOWERFACE", "top"));
        deck.push_str(&upper.surface("UPPERFACE", "bottom"));
        let (slave, master) = match self.upper_is_slave {
            true => ("UPPERFACE", "LOWERFACE"),
            false => ("LOWERFACE", "UPPERFACE"),
        };
        deck.push_str(&lower.set("BASE", |_, y| y == 0.0));
        deck.push_str(&upper.set("HEAD", |_, y| y == 1.0));
        let Self { law, friction, way, press, increments, .. } = self;
        let _ = write!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3
*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n0.7
*SOLID SECTION, ELSET=UPPER, MATERIAL=M\n0.7
*SURFACE INTERACTION, NAME=I\n{law}{friction}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
{slave}, {master}
*BOUNDARY\nBASE, 1, 2\n*STEP, NLGEOM\n*STATIC\n0.25, 1.0, , 0.25
*BOUNDARY\nHEAD, 1, 1, 0.0\nHEAD, 2, 2, {:?}\n*END STEP
*STEP, NLGEOM, INC=1000\n*STATIC\n{increments:?}, 1.0, , {increments:?}
*BOUNDARY\nHEAD, 1, 1, {way:?}\n*END STEP\n",
            -press
        );
        deck
    }

    fn name(&self) -> String {
        format!("{:?} {} {} {}", self.kinds, self.upper_is_slave, self.law, self.friction)
    }
}

fn report(slider: &Slider) -> (Last, f64) {
    let (last, off) = checked(&slider.deck(), 10_000);
    println!("{} iterations {:?} off {off:e}", slider.name(), last.iterations);
    println!("   {}", last.told.chars().take(400).collect::<String>());
    println!("   worst {:e} balance {:e} work {:e}", last.worst, last.balance, last.work);
    println!("   imbalance {:?} force {:?}", last.imbalance, last.force);
    (last, off)
}

#[test]
fn debug() {
    let slider = Slider {
        kinds: [Kind::Cpe4; 2], upper_is_slave: false, law: "", friction: "*FRICTION\n0.3\n",
        way: 0.5, press: 0.03, increments: 0.01, ring: false,
    };
    let read = slideline::Job::read_text("m", &slider.deck(), &slideline::ReadOptions::default());
    let model = read.model.unwrap();
    struct See;
    impl slideline::Observer for See {
        fn event(&mut self, event: slideline::Event<'_>) -> std::ops::ControlFlow<slideline::Stop> {
            if let slideline::Event::Committed(frame) = event {
                println!("time {} its {}", frame.total_time, frame.severe_iterations + frame.equilibrium_iterations);
                for row in frame.contact {
                    if row.ever_closed { println!("   x {:.4} {:?} p {:.3} tau {:.3} open {:.2e} slip {:.3e} along {:.4} area {:.4}", row.position[0], row.status, row.pressure, row.shear[0], row.opening, row.slip[0], row.along, row.area); }
                }
            }
            std::ops::ControlFlow::Continue(())
        }
    }
    let ending = slideline::solve(&model, &slideline::SolveOptions::default(), &mut See);
    println!("{ending:?}");
}

#[test]
fn scan() {
    for (kinds, law) in [(Kind::Cpe4, ""), (Kind::Cpe4, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e5\n")] {
    for friction in ["*FRICTION\n0.1\n", "*FRICTION\n0.2\n", "*FRICTION\n0.3\n", "*FRICTION, LAGRANGE\n0.3\n", "*FRICTION, SLIP TOLERANCE=0.05\n0.3\n"] {
        for increments in [0.1, 0.02] {
        let slider = Slider { kinds: [kinds; 2], upper_is_slave: false, law, friction,
            way: 0.5, press: 0.03, increments, ring: false };
        let read = slideline::Job::read_text("m", &slider.deck(), &slideline::ReadOptions::default());
        let model = read.model.unwrap();
        let mut last = Last::default();
        let ending = slideline::solve(&model, &slideline::SolveOptions::default(), &mut last);
        println!("{kinds:?} {law} {friction} {increments}: {}", format!("{ending:?}").chars().take(260).collect::<String>());
        println!("    {:?}", last.iterations);
        }
    }
    }
}

#[test]
fn probe() {
    let soft = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 20.0\n";
    for kinds in [[Kind::Cpe4; 2], [Kind::Cpe8; 2]] {
        for upper_is_slave in [true, false] {
            for law in ["", soft] {
                for friction in ["", "*FRICTION\n0.3\n", "*FRICTION, LAGRANGE\n0.3\n"] {
                    let slider = Slider {
                        kinds, upper_is_slave, law, friction,
                        way: 0.5, press: 0.03, increments: 0.1, ring: false,
                    };
                    report(&slider);
                }
            }
        }
    }
    let kinds = [Kind::Cax4; 2];
    let slider = Slider { kinds, upper_is_slave: true, law: soft, friction: "*FRICTION\n0.3\n", way: 0.5, press: 0.03, increments: 0.1, ring: true };
    report(&slider);
    let _ = watched;
}
