//! A material of the embedding program: it softens by the largest strain energy that it has had.
//!
//! ```text
//!   stress |      __/   first loading: (1 - d) of the elastic stress, d = m (1 - exp(-k/e))
//!          |    _/ /    k: largest elastic energy so far, the state of a point
//!          |  _/  /     unloading and loading again: d stays
//!          |_/___/____ stretch
//! ```
//!
//! The law is given to the section of a model that was read; the solver, the state that restart
//! saves and the files take it like one of their own.
//!
//! ```sh
//! cargo run --release -p slideline --example user_material
//! ```

use slideline::mech::material::tensor::{Matrix, add_dyad, symmetric};
use slideline::mech::material::{Answer, Conditions, Elastic, Law, Material};
use slideline::model::{Dof, Section};
use slideline::observe::Ending;
use slideline::{Event, Job, Model, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::ops::ControlFlow;
use std::sync::Arc;

/// Constants of the law.
#[derive(Clone, Copy, Debug)]
pub struct Softening {
    /// What it is while nothing has softened.
    pub elastic: Elastic,
    /// Largest softening m [1].
    pub most: f64,
    /// Energy e after which most of it is there [F/L2].
    pub energy: f64,
}

/// Those of the example.
pub const SOFTENING: Softening =
    Softening { elastic: Elastic { modulus: 7.0, poisson: 0.3 }, most: 0.4, energy: 0.05 };

impl Softening {
    /// Softening d by the largest energy k [F/L2].
    pub fn softening(&self, largest: f64) -> f64 {
        self.most * -(-largest / self.energy).exp_m1()
    }

    /// Integral of 1 - d over k: the work of a first loading [F/L2].
    fn first_work(&self, largest: f64) -> f64 {
        largest - self.most * (largest + self.energy * (-largest / self.energy).exp_m1())
    }
}

impl Law for Softening {
    fn states(&self) -> usize {
        1
    }

    fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer {
        let elastic = match under.large {
            true => self.elastic.hencky(gradient),
            false => self.elastic.small(&symmetric(gradient)),
        };
        let largest = elastic.energy.max(committed[0]);
        state[0] = largest;
        let kept = 1.0 - self.softening(largest);
        let mut answer = elastic;
        answer.stress = elastic.stress.map(|stress| kept * stress);
        answer.moduli = elastic.moduli.map(|row| row.map(|entry| kept * entry));
        if elastic.energy >= committed[0] {
            let slope = self.most / self.energy * (-largest / self.energy).exp();
            add_dyad(&mut answer.moduli, -slope, &elastic.stress);
        }
        answer.energy = self.first_work(largest) - kept * (largest - elastic.energy);
        answer.dissipation = answer.energy - kept * elastic.energy;
        answer
    }

    fn stiffest(&self) -> f64 {
        self.elastic.bulk_modulus() + 4.0 / 3.0 * self.elastic.shear_modulus()
    }

    fn shear_modulus(&self) -> f64 {
        self.elastic.shear_modulus()
    }
}

/// A cube between walls that is pulled to 0.3, let back to 0.1 and pulled to 0.4.
pub const DECK: &str = "*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*NSET, NSET=ALL
1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=HELD
1, 4, 5, 8
*NSET, NSET=PULLED
2, 3, 6, 7
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*SOLID SECTION, ELSET=CUBE, MATERIAL=SOFT
*MATERIAL, NAME=SOFT
*ELASTIC
7.0, 0.3
*BOUNDARY
ALL, 2, 3
HELD, 1
*STEP, NLGEOM
*STATIC
0.1, 1.0, 0.1, 0.1
*BOUNDARY
PULLED, 1, 1, 0.3
*END STEP
*STEP, NLGEOM
*STATIC
0.1, 1.0, 0.1, 0.1
*BOUNDARY
PULLED, 1, 1, 0.1
*END STEP
*STEP, NLGEOM
*STATIC
0.1, 1.0, 0.1, 0.1
*BOUNDARY
PULLED, 1, 1, 0.4
*END STEP
";

/// The deck's model of that material.
pub fn model() -> Option<Model> {
    let mut model = Job::read_text("cube", DECK, &ReadOptions::default()).model?;
    for block in &mut model.blocks {
        if let Section::Solid(section) = &mut block.section {
            section.material = Material::User(Arc::new(SOFTENING));
        }
    }
    Some(model)
}

/// Displacement and force of the pulled face, an increment a row.
#[derive(Default)]
pub struct Rows(pub Vec<[f64; 2]>);

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let pulled = [1, 2, 5, 6];
            let force = pulled.iter().map(|&node| frame.nodal.reaction(node, Dof::U1)).sum();
            self.0.push([frame.nodal.displacement(pulled[0], Dof::U1), force]);
        }
        ControlFlow::Continue(())
    }
}

fn main() {
    let Some(model) = model() else { return };
    let mut rows = Rows::default();
    if let Ending::Completed(totals) = solve(&model, &SolveOptions::default(), &mut rows) {
        println!("{} increments, {} iterations", totals.increments, totals.iterations);
    }
    println!("{:>12} {:>12}", "u", "force");
    for [u, force] in rows.0 {
        println!("{u:>12.5} {force:>12.5}");
    }
}
