//! An element of the embedding program: a bar that yields.
//!
//! ```text
//!   o=======o   small strain e = (u2 - u1).t/l, stress s = E (e - ep), |s| <= yield stress
//!               state: plastic strain ep
//! ```
//!
//! A row of the element table and a kernel are all there is to it: the solver, the state that
//! restart saves and the files take it like one of their own.

use slideline::mech::element::cell::LINE2;
use slideline::mech::element::{Failure, Kernel, Response, Scale, Surroundings};
use slideline::model::{
    Dof, ElementBlock, ElementType, Field, Kinematics, Location, Section, Undeformed, mean_at_nodes,
};
use slideline::observe::Ending;
use slideline::{Event, Job, Model, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::ops::ControlFlow;

/// The row of the bar. Its section has three properties: E [F/L2], yield stress [F/L2], area [L2].
pub static YIELDING_BAR: ElementType = ElementType {
    names: ["U1"; 2],
    cell: &LINE2,
    dofs: &[Dof::U1, Dof::U2],
    kinematics: Kinematics::Other,
    points: 1,
    states: |_| 1,
    fields: &[
        Field { name: "S", components: &["S11"], unit: "[F/L2]", location: Location::Points },
        Field { name: "PE", components: &["PE11"], unit: "[1]", location: Location::Points },
    ],
    at_nodes: mean_at_nodes,
    kernel: bars,
};

fn bars(block: &Undeformed<'_>, _room: Option<Box<dyn Kernel>>) -> Option<Box<dyn Kernel>> {
    let Section::Properties(properties) = block.section else { return None };
    let [modulus, limit, area] = *properties.as_slice() else { return None };
    let bars = block.plane::<2>().map(|[a, b]| {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        ([(b[0] - a[0]) / length, (b[1] - a[1]) / length], length)
    });
    Some(Box::new(Bars { modulus, limit, area, bars: bars.collect() }))
}

/// Bars of one section: direction and length of each.
#[derive(Debug)]
struct Bars {
    modulus: f64,
    limit: f64,
    area: f64,
    bars: Vec<([f64; 2], f64)>,
}

impl Bars {
    /// Stress, its slope, and the plastic strain that goes with it.
    fn law(&self, strain: f64, plastic: f64) -> [f64; 3] {
        let trial = self.modulus * (strain - plastic);
        if trial.abs() <= self.limit {
            return [trial, self.modulus, plastic];
        }
        let stress = self.limit.copysign(trial);
        [stress, 0.0, strain - stress / self.modulus]
    }

    fn strain(&self, element: usize, q: &[f64]) -> f64 {
        let ([x, y], length) = self.bars[element];
        ((q[2] - q[0]) * x + (q[3] - q[1]) * y) / length
    }
}

impl Kernel for Bars {
    fn count(&self) -> usize {
        self.bars.len()
    }

    fn variables(&self) -> usize {
        4
    }

    fn respond(
        &self,
        element: usize,
        q: &[f64],
        committed: &[f64],
        _under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure> {
        let ([x, y], length) = self.bars[element];
        let [stress, slope, plastic] = self.law(self.strain(element, q), committed[0]);
        let rows = [-x, -y, x, y];
        for (force, row) in into.force.iter_mut().zip(rows) {
            *force = self.area * stress * row;
        }
        if let Some(tangent) = into.tangent {
            for (place, entry) in tangent.iter_mut().enumerate() {
                *entry = self.area / length * slope * rows[place / 4] * rows[place % 4];
            }
        }
        into.state[0] = plastic;
        Ok(0.5 * self.area * length * stress * stress / self.modulus)
    }

    fn scale(&self, element: usize) -> Scale {
        let length = self.bars[element].1;
        Scale { stiffness: self.modulus * self.area / length, length: Some(length) }
    }

    fn results(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        _under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        // of a committed state the law gives that state back
        let [stress, _, plastic] = self.law(self.strain(element, q), state[0]);
        into.copy_from_slice(&[stress, plastic]);
    }
}

/// A beam that is pulled to 0.02 and pushed back to 0; the bar joins its ends.
pub const DECK: &str = "*NODE
1, 0.0, 0.0
2, 1.0, 0.0
*ELEMENT, TYPE=B21, ELSET=BEAM
1, 1, 2
*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=SOFT
0.1, 0.1
*MATERIAL, NAME=SOFT
*ELASTIC
1000.0, 0.3
*STEP
*STATIC
0.1, 1.0, 0.1, 0.1
*BOUNDARY
1, 1, 6
2, 2, 6
2, 1, 1, 0.02
*END STEP
*STEP
*STATIC
0.1, 1.0, 0.1, 0.1
*BOUNDARY
2, 1, 1, 0.0
*END STEP
";

/// The deck's model with a bar between its nodes.
pub fn model() -> Option<Model> {
    let mut model = Job::read_text("bar", DECK, &ReadOptions::default()).model?;
    let origin = model.nodes.get(0).origin;
    let section = Section::Properties(vec![2000.0, 10.0, 0.05]);
    let bar = ElementBlock::new(&YIELDING_BAR, "BAR", section, origin);
    model.blocks.push(bar.with([(100, [0, 1])]));
    Some(model)
}

/// Displacement and force of node 2, stress and plastic strain of the bar, an increment a row.
#[derive(Default)]
pub struct Rows(pub Vec<[f64; 4]>);

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let of_bars = frame.elements.iter().flat_map(|block| block.elements(frame.model));
            let bar = of_bars.filter(|(element, _)| element.label == 100).map(|(_, values)| values);
            for values in bar {
                let (u, f) =
                    (frame.nodal.displacement(1, Dof::U1), frame.nodal.reaction(1, Dof::U1));
                self.0.push([u, f, values[0], values[1]]);
            }
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
    println!("{:>12} {:>12} {:>12} {:>12}", "u", "force", "stress", "plastic");
    for [u, force, stress, plastic] in rows.0 {
        println!("{u:>12.5} {force:>12.5} {stress:>12.5} {plastic:>12.5}");
    }
}
