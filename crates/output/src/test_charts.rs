//! Rubber and its test data, drawn: what `check --picture` adds below the model.
//!
//! ```text
//!   T |      o o   uniaxial       p |o          volumes, where they were measured
//!     |   o-'  ..o  equibiaxial     |  `o
//!     +--'--------- strain          +----`o-- J
//! ```

use slideline_figures::{Axis, Mark, Panel, Scene, Series, chart};
use slideline_mech::material::hyperelastic::Mode;
use slideline_model::{Model, Tested};

/// Points of a curve: more than discs are drawn for.
const POINTS: usize = 200;
const HEIGHT: f64 = 340.0;

/// A chart for every rubber of a model that was fitted to test data.
pub fn test_charts(model: &Model) -> Vec<Scene> {
    model.tested.iter().map(test_chart).collect()
}

fn test_chart(tested: &Tested) -> Scene {
    let mut panels = vec![Panel {
        x: Axis::linear("nominal strain"),
        y: Axis::linear(format!("nominal stress of {}", tested.material)),
        height: HEIGHT,
        series: strained(tested),
    }];
    if !tested.volumes.is_empty() {
        panels.push(Panel {
            x: Axis::linear("ratio of volumes"),
            y: Axis::linear(format!("pressure of {}", tested.material)),
            height: HEIGHT,
            series: pressed(tested),
        });
    }
    chart(format!("The rubber {} and its test data", tested.material), &panels)
}

/// Data and law of every mode that was measured.
fn strained(tested: &Tested) -> Vec<Series> {
    let modes = Mode::ALL.into_iter().enumerate();
    let pairs = modes.filter_map(|(colour, mode)| {
        let own = tested.tests.iter().filter(|own| own.mode == mode);
        let data: Vec<[f64; 2]> = own.map(|own| [own.strain, own.stress]).collect();
        let law = |strain| tested.rubber.nominal_stress(mode, strain);
        (!data.is_empty()).then(|| pair(mode.word(), colour, data, 0.0, law))
    });
    pairs.flatten().collect()
}

fn pressed(tested: &Tested) -> Vec<Series> {
    let data = tested.volumes.iter().map(|&[pressure, ratio]| [ratio, pressure]).collect();
    let law = |ratio: f64| tested.rubber.pressure(ratio - 1.0);
    pair("volumetric", Mode::ALL.len(), data, 1.0, law).into()
}

/// Data as discs and the law as a line over them, from where nothing acts.
fn pair(
    name: &str,
    colour: usize,
    data: Vec<[f64; 2]>,
    rest: f64,
    law: impl Fn(f64) -> f64,
) -> [Series; 2] {
    let low = data.iter().map(|point| point[0]).fold(rest, f64::min);
    let high = data.iter().map(|point| point[0]).fold(rest, f64::max);
    let at = |k: usize| low + (high - low) * k as f64 / POINTS as f64;
    let points = (0..=POINTS).map(|k| [at(k), law(at(k))]).collect();
    let series = |name, points, mark| Series { name, points, mark, colour };
    [
        series(format!("{name}: law"), points, Mark::Curve),
        series(format!("{name}: test data"), data, Mark::Discs),
    ]
}
