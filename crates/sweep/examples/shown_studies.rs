//! Runs the studies of `corpus/study` and draws the figures of docs/shown-studies.md:
//! `cargo run --release -p slideline-sweep --example shown_studies -- FOLDER IMAGES`, where FOLDER
//! keeps the shards and IMAGES gets the figures.

use slideline::diag::Sources;
use slideline::output::plot::{Axis, Mark, Panel, Series, chart};
use slideline_sweep::{SweepOptions, read_study, sweep};
use std::error::Error;
use std::path::{Path, PathBuf};

type Done<T> = Result<T, Box<dyn Error>>;

/// A joined table: names of columns, rows of numbers. What is no number is not a number.
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn read(path: &Path) -> Done<Self> {
        let text = std::fs::read_to_string(path)?;
        let mut lines = text.lines();
        let names = lines.next().unwrap_or_default().split(',').map(str::to_owned).collect();
        let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
        Ok(Self { names, rows: lines.map(|line| line.split(',').map(number).collect()).collect() })
    }

    fn column(&self, name: &str) -> Done<Vec<f64>> {
        let place = self.names.iter().position(|own| own == name).ok_or("no such column")?;
        Ok(self.rows.iter().map(|row| row[place]).collect())
    }
}

/// Runs a study of the corpus, or what is missing of it.
fn made(name: &str, folder: &Path) -> Done<PathBuf> {
    let study = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/study").join(name);
    let mut sources = Sources::default();
    let study = read_study(&study, &mut sources).map_err(|said| format!("{said:?}"))?;
    let folder = folder.join(name.trim_end_matches(".toml"));
    let options = SweepOptions { folder: folder.clone(), threads: 2, part: (0, 1), csv: true };
    let told = |done, all| {
        if done == all {
            println!("{name}: {all} cases");
        }
    };
    let outcome = sweep(&study, &mut sources, &options, &told, &|| false);
    outcome.map_err(|failure| format!("{failure:?}"))?;
    Ok(folder)
}

fn series(name: &str, points: Vec<[f64; 2]>, mark: Mark, colour: usize) -> Series {
    Series { name: name.to_owned(), points, mark, colour }
}

/// Outline of the shares of values in bins of one width, per unit of the values.
#[allow(clippy::cast_precision_loss, clippy::cast_sign_loss, clippy::cast_possible_truncation)]
fn histogram(values: &[f64], bins: usize) -> Vec<[f64; 2]> {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let width = (most - least) / bins as f64;
    let mut counts = vec![0.0; bins];
    for value in values.iter().filter(|value| value.is_finite()) {
        counts[(((value - least) / width) as usize).min(bins - 1)] += 1.0;
    }
    let height = |count: &f64| count / (values.len() as f64 * width);
    let steps = counts.iter().enumerate().flat_map(|(bin, count)| {
        [bin, bin + 1].map(|at| [least + width * at as f64, height(count)])
    });
    std::iter::once([least, 0.0]).chain(steps).chain([[most, 0.0]]).collect()
}

fn tolerances(folder: &Path, images: &Path) -> Done<()> {
    let table = Table::read(&made("push.toml", folder)?.join("study.csv"))?;
    // A and B are independent; the other cases of a point repeat their values
    let force = table.column("force")?;
    let independent: Vec<f64> = force.chunks(6).flat_map(|point| &point[..2]).copied().collect();
    let mut sorted = independent.clone();
    sorted.sort_by(f64::total_cmp);
    let below = |share: f64| sorted[(share * sorted.len() as f64) as usize];
    let [low, middle, high] = [0.00135, 0.5, 0.99865].map(below);
    println!("force: {low:.2} N (0.135 %), {middle:.2} N (50 %), {high:.2} N (99.865 %)");
    let shown = series("", histogram(&independent, 80), Mark::Guide, 0);
    let panel = Panel {
        x: Axis::linear("largest force on the circle in N"),
        y: Axis::linear("density in 1/N"),
        height: 300.0,
        series: vec![shown],
    };
    let figure = chart("Force on the circle under tolerances", &[panel]);
    let png = figure.png(192.0).ok_or("the figure cannot be encoded")?;
    Ok(std::fs::write(images.join("tolerances.png"), png)?)
}

/// Width, modulus and length of the arm, height of the ramp's end: N and mm.
const ARM: [f64; 3] = [25.0, 2400.0, 50.0];

/// The calculators' rule: force to push an arm of a thickness over a ramp of an angle.
fn rule(thickness: f64, angle: f64) -> f64 {
    const MU: f64 = 0.3;
    let slope = angle.to_radians();
    let [width, modulus, length] = ARM;
    let lift = 1.8 + 0.2 * slope.cos();
    let deflection = modulus * width * thickness.powi(3) * lift / (4.0 * length.powi(3));
    deflection * (MU + slope.tan()) / (1.0 - MU * slope.tan())
}

/// Thickness at which a force that grows with it has a value; forces at thicknesses.
fn thickness_of(force: f64, curve: &[[f64; 2]]) -> Option<f64> {
    let pair = curve.windows(2).find(|pair| pair[0][1] <= force && force <= pair[1][1])?;
    // forces go with the cube of the thickness
    let cube = |t: f64| t.powi(3);
    let share = (force - pair[0][1]) / (pair[1][1] - pair[0][1]);
    Some((cube(pair[0][0]) + share * (cube(pair[1][0]) - cube(pair[0][0]))).cbrt())
}

fn snap_fit_map(folder: &Path, images: &Path) -> Done<()> {
    let table = Table::read(&made("snap_fit.toml", folder)?.join("study.csv"))?;
    let [thickness, angle] = [table.column("thickness")?, table.column("angle")?];
    let [push, ratio, margin] =
        [table.column("push_in")?, table.column("ratio")?, table.column("margin")?];
    // the angle changes first
    let same = thickness.iter().take_while(|own| **own == thickness[0]).count();
    let angles = angle[..same].to_vec();
    let of_angle = |own: f64, values: &[f64]| -> Vec<[f64; 2]> {
        let rows = thickness.iter().zip(&angle).zip(values);
        rows.filter(|((_, angle), _)| **angle == own).map(|((t, _), value)| [*t, *value]).collect()
    };
    let mut lines = Vec::new();
    for (colour, force) in [0.5, 1.0, 2.0, 5.0, 10.0].into_iter().enumerate() {
        let line = |curve: &dyn Fn(f64) -> Vec<[f64; 2]>| -> Vec<[f64; 2]> {
            angles.iter().filter_map(|&a| Some([a, thickness_of(force, &curve(a))?])).collect()
        };
        let ruled = |a: f64| -> Vec<[f64; 2]> {
            of_angle(a, &push).iter().map(|[t, _]| [*t, rule(*t, a)]).collect()
        };
        let found = line(&|a| of_angle(a, &push));
        lines.push(series(&format!("push-in force {force} N"), found, Mark::Curve, colour));
        lines.push(series("", line(&ruled), Mark::Guide, colour));
    }
    lines.push(series("dashed: the rule", Vec::new(), Mark::Guide, 7));
    let excess = |t: f64| -> Vec<[f64; 2]> {
        let rows = thickness.iter().zip(&angle).zip(&push);
        let own = rows.filter(|((own, _), _)| **own == t);
        own.map(|((_, a), force)| [*a, 100.0 * (rule(t, *a) / force - 1.0)]).collect()
    };
    let x = || Axis::linear("angle of the ramp in degrees");
    let too_much = series("", excess(2.0), Mark::Curve, 5);
    let panels = [
        Panel { x: x(), y: Axis::linear("thickness in mm"), height: 380.0, series: lines },
        Panel {
            x: x(),
            y: Axis::linear("rule too high by %"),
            height: 200.0,
            series: vec![too_much],
        },
    ];
    for a in [15.0, 31.0, 45.0, 55.0, 65.0] {
        let at = |values: &[f64]| {
            of_angle(a, values)
                .iter()
                .find(|[t, _]| *t == 2.0)
                .map_or(f64::NAN, |[_, value]| *value)
        };
        let [force, ratio, margin] = [at(&push), at(&ratio), at(&margin)];
        println!(
            "2 mm, {a} degrees: {force:.3} N, rule {:.3} N, ratio {ratio:.2}, margin {margin:.2}",
            rule(2.0, a)
        );
    }
    let figure = chart("A snap-fit: thickness against angle", &panels);
    let png = figure.png(192.0).ok_or("the figure cannot be encoded")?;
    Ok(std::fs::write(images.join("snap_fit_map.png"), png)?)
}

fn main() -> Done<()> {
    let mut given = std::env::args().skip(1).map(PathBuf::from);
    let folder = given.next().unwrap_or_else(|| PathBuf::from("target/studies"));
    let images = given.next().unwrap_or_else(|| folder.clone());
    std::fs::create_dir_all(&images)?;
    snap_fit_map(&folder, &images)?;
    tolerances(&folder, &images)
}
