//! Rubber from test data, foam and metals of a curved law, through decks: what is read, drawn, and
//! answered by elements.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::diag::Severity;
use slideline::mech::material::hyperelastic::Mode;
use slideline::output::test_charts;
use slideline::{Dialect, Job, Quiet, Read, ReadOptions, RunOptions, Status};
use std::path::PathBuf;

/// Data in three modes: Treloar's, a few of them [MPa].
const DATA: &str = "*UNIAXIAL TEST DATA\n0.14, 0.12\n0.23, 0.24\n0.41, 0.61\n0.58, 1.17\n0.85, 2.01\n\
    1.21, 3.03\n1.58, 3.76\n2.29, 4.76\n4.12, 6.05\n5.57, 6.5\n*BIAXIAL TEST DATA\n0.24, 0.12\n0.33, 0.20\n0.51, 0.42\n0.77, 0.94\n\
    1.24, 2.03\n*PLANAR TEST DATA\n0.16, 0.14\n0.24, 0.21\n0.42, 0.46\n0.76, 1.40\n1.11, 2.48\n";

/// A unit cube whose faces at x, y, z = 0 are held along their normals; `{law}` and `{moved}` differ.
const CUBE: &str = "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n\
    5, 0., 0., 1.\n6, 1., 0., 1.\n7, 1., 1., 1.\n8, 0., 1., 1.\n\
    *ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
    *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n{law}\
    *NSET, NSET=X0\n1, 4, 5, 8\n*NSET, NSET=Y0\n1, 2, 5, 6\n*NSET, NSET=Z0\n1, 2, 3, 4\n\
    *NSET, NSET=X1\n2, 3, 6, 7\n*NSET, NSET=Y1\n3, 4, 7, 8\n\
    *STEP, NLGEOM\n*STATIC\n0.1, 1.0\n*BOUNDARY\nX0, 1\nY0, 2\nZ0, 3\n{moved}\
    *NODE PRINT, NSET=X1\nRF\n*EL PRINT, ELSET=E\nS\n*END STEP\n";

fn deck(law: &str, moved: &str) -> String {
    CUBE.replace("{law}", law).replace("{moved}", moved)
}

fn read(deck: &str, dialect: Dialect) -> Read {
    Job::read_text("job", deck, &ReadOptions { dialect: Some(dialect), ..ReadOptions::default() })
}

/// Runs a deck; the text of its file with that ending.
fn run(name: &str, read: &Read) -> impl Fn(&str) -> String + use<> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("rubber").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = slideline::run(read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:#?} {:#?}", read.diagnostics, outcome);
    move |ending| std::fs::read_to_string(folder.join(format!("job{ending}"))).unwrap_or_default()
}

fn motion(mode: Mode, strain: f64) -> String {
    match mode {
        Mode::Uniaxial => format!("X1, 1, 1, {strain}\n"),
        Mode::Biaxial => format!("X1, 1, 1, {strain}\nY1, 2, 2, {strain}\n"),
        Mode::Planar => format!("X1, 1, 1, {strain}\nY1, 2\n"),
    }
}

/// Requirement: an element in each mode answers with the nominal stress of the fitted law, whatever
/// its form. Source: the sum of reactions of a unit face; the rest is the change of volume, 1e-4 of
/// the stress.
#[test]
fn a_cube_answers_as_its_fit() {
    for (number, form) in ["OGDEN, N=3", "YEOH", "MOONEY-RIVLIN", "ARRUDA-BOYCE"].iter().enumerate()
    {
        let law = format!("*HYPERELASTIC, TEST DATA INPUT, {form}\n{DATA}");
        for mode in Mode::ALL {
            for strain in [1.0, -0.3] {
                let read = read(&deck(&law, &motion(mode, strain)), Dialect::Abaqus);
                let model =
                    read.model.as_ref().unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
                let expected = model.tested[0].rubber.nominal_stress(mode, strain);
                let name = format!("{number}-{}-{strain}", mode.word());
                let history = run(&name, &read)(".history.csv");
                let force = total(&history);
                assert!((force / expected - 1.0).abs() < 2e-3, "{name}: {force} {expected}");
            }
        }
    }
}

/// The reaction of the moved face in the last increment.
fn total(history: &str) -> f64 {
    let heading: Vec<&str> = history.lines().next().unwrap().split(',').collect();
    let place = |name: &str| heading.iter().position(|own| *own == name).unwrap();
    let (node, force) = (place("node"), place("RF1"));
    let rows: Vec<Vec<&str>> =
        history.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let latest = |label: &str| rows.iter().rev().find(|row| row[node] == label).unwrap();
    ["2", "3", "6", "7"].map(|label| latest(label)[force].parse::<f64>().unwrap()).iter().sum()
}

/// Requirement: a run whose rubber goes beyond its stability is amber and says so, one that stays
/// within is green; in both dialects, whose strains differ. Source: C10 = 1, C20 = -.1 (planar) by
/// eq. (3.64).
#[test]
fn rubber_beyond_its_stability_is_amber() {
    let law = "*HYPERELASTIC, REDUCED POLYNOMIAL, N=2\n1., -0.1, 0.002, 0.\n";
    for (number, dialect) in [Dialect::Abaqus, Dialect::Calculix].into_iter().enumerate() {
        let limit = {
            let read = read(&deck(law, &motion(Mode::Planar, 0.1)), dialect);
            let said = read.diagnostics.iter().find(|said| said.code.0 == "SL0420").unwrap();
            assert_eq!(said.severity, Severity::Note, "{said:?}");
            let (_, planar) = said.message.split_once("planar ").unwrap();
            planar.split(' ').next().unwrap().parse::<f64>().unwrap()
        };
        for (by, colour) in [(0.97, "green"), (1.03, "amber")] {
            let read = read(&deck(law, &motion(Mode::Planar, by * limit)), dialect);
            let summary = run(&format!("stable-{number}-{by}"), &read)(".json");
            assert!(summary.contains(&format!("\"colour\":\"{colour}\"")), "{by}: {summary}");
            assert_eq!(summary.contains("where its law is unstable"), by > 1.0, "{summary}");
            assert_eq!(summary.contains("\"unstable_strain\""), by > 1.0, "{summary}");
        }
    }
}

/// Requirement: Poisson's ratio and volumes give the bulk modulus. Source: K = 2 G (1 + nu)/(3 (1 -
/// 2 nu)); p = K (1 - J) of one coefficient.
#[test]
fn the_change_of_volume_is_that_of_the_data() {
    let bulk = |law: &str| {
        let read = read(&deck(law, &motion(Mode::Uniaxial, 0.1)), Dialect::Abaqus);
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let rubber = model.tested[0].rubber.clone();
        (rubber.bulk_modulus(), rubber.shear_modulus())
    };
    let (k, g) = bulk(&format!("*HYPERELASTIC, TEST DATA INPUT, OGDEN, POISSON=0.49\n{DATA}"));
    assert!((k / g - 2.0 * 1.49 / (3.0 * 0.02)).abs() < 1e-9, "{k} {g}");
    let volumes = "*VOLUMETRIC TEST DATA\n2.0, 0.999\n20.0, 0.99\n60.0, 0.97\n";
    let (k, _) = bulk(&format!("*HYPERELASTIC, TEST DATA INPUT, NEO HOOKE\n{DATA}{volumes}"));
    assert!((k - 2000.0).abs() < 1e-9 * k, "{k}");
    let (k, g) =
        bulk(&format!("*HYPERELASTIC, TEST DATA INPUT, ARRUDA-BOYCE, POISSON=0.5\n{DATA}"));
    assert!((k / g - 1e4).abs() < 1e-6, "{k} {g}");
}

/// Requirement: the chart has data and law of each mode that was measured, and the volumes.
#[test]
fn the_chart_shows_data_and_law() {
    let volumes = "*VOLUMETRIC TEST DATA\n2.0, 0.999\n20.0, 0.99\n";
    let law = format!("*HYPERELASTIC, TEST DATA INPUT, MOONEY-RIVLIN\n{DATA}{volumes}");
    let read = read(&deck(&law, &motion(Mode::Uniaxial, 0.1)), Dialect::Abaqus);
    let charts = test_charts(read.model.as_ref().unwrap());
    let svg = charts[0].svg();
    for words in ["uniaxial: law", "equibiaxial: test data", "planar: law", "volumetric: test data"]
    {
        assert!(svg.contains(words), "{words}");
    }
    assert_eq!(
        svg.matches("<circle").count(),
        10 + 5 + 5 + 2 + 4,
        "a disc a point, and the legend"
    );
    assert_eq!(charts.len(), 1);
}

/// Requirement: data in any order and in several cards are the same data, and the unloaded state
/// counts for nothing.
#[test]
fn the_order_of_the_data_does_not_matter() {
    let rubber = |data: &str| {
        let law = format!("*HYPERELASTIC, TEST DATA INPUT, YEOH, POISSON=0.49\n{data}");
        let read = read(&deck(&law, &motion(Mode::Uniaxial, 0.1)), Dialect::Abaqus);
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let rubber = &model.tested[0].rubber;
        [0.3, 2.0].map(|strain| rubber.nominal_stress(Mode::Planar, strain))
    };
    let one =
        rubber("*UNIAXIAL TEST DATA\n0., 0.\n0.14, 0.12\n0.23, 0.24\n0.41, 0.61\n0.58, 1.17\n");
    let two = rubber(
        "*UNIAXIAL TEST DATA\n0.58, 1.17\n0.23, 0.24\n*UNIAXIAL TEST DATA\n0.41, 0.61\n0.14, 0.12\n",
    );
    assert!(one.iter().zip(two).all(|(a, b)| (a / b - 1.0).abs() < 1e-9), "{one:?} {two:?}");
}

/// Requirement: a cube of foam that is crushed or pulled along one axis has the nominal stress
/// 2 mu/(alpha l) (l^alpha - J^(-alpha beta)) and J = l^(1 - 2 nu), in both dialects; two equal terms
/// of half the size are one. Source: docs/theory.md eq. (3.100). Tolerance: that of the equilibrium.
#[test]
fn a_cube_of_foam() {
    let (shear, power) = (0.4, 8.0);
    for dialect in [Dialect::Abaqus, Dialect::Calculix] {
        for (poisson, strain) in [(0.0, -0.6), (0.25, -0.3), (0.25, 0.4)] {
            let stretch = 1.0 + strain;
            let beta = poisson / (1.0 - 2.0 * poisson);
            let volume = f64::powf(stretch, 1.0 - 2.0 * poisson);
            let expected = 2.0 * shear / (power * stretch)
                * (f64::powf(stretch, power) - volume.powf(-power * beta));
            let one = format!("*HYPERFOAM\n{shear}, {power}, {poisson}\n");
            let (half, two) = (0.5 * shear, format!("{power}, {poisson}, {poisson}"));
            let two = format!("*HYPERFOAM, N=2\n{half}, {power}, {half}, {two}\n");
            for (terms, law) in [(1, one), (2, two)] {
                let read = read(&deck(&law, &motion(Mode::Uniaxial, strain)), dialect);
                let name = format!("foam-{terms}-{poisson}-{strain}-{dialect:?}");
                let force = total(&run(&name, &read)(".history.csv"));
                assert!((force / expected - 1.0).abs() < 1e-6, "{name}: {force} {expected}");
            }
        }
    }
}

/// Requirement: a cube by deformation plasticity that is pulled far beyond its yield stress answers
/// with Kirchhoff's stress of E e = s + alpha (s/s0)^(n-1) s, e the logarithmic strain, in both
/// dialects. Source: docs/theory.md eq. (3.101), by bisection. Tolerance: that of the
/// equilibrium.
#[test]
fn a_cube_by_deformation_plasticity() {
    let (modulus, yields, exponent, offset) = (200.0, 0.3, 5.0, 0.4);
    let stress = |strain: f64| {
        let (mut low, mut high) = (0.0, modulus * strain);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            let bent = offset * f64::powf(middle / yields, exponent - 1.0) * middle;
            if middle + bent < modulus * strain { low = middle } else { high = middle }
        }
        low
    };
    let law = format!("*DEFORMATION PLASTICITY\n{modulus}, 0.3, {yields}, {exponent}, {offset}\n");
    for strain in [1e-3, 0.02, 0.2] {
        let stretch = 1.0 + strain;
        let expected = stress(f64::ln(stretch)) / stretch;
        for dialect in [Dialect::Abaqus, Dialect::Calculix] {
            let read = read(&deck(&law, &motion(Mode::Uniaxial, strain)), dialect);
            let name = format!("deformation-{strain}-{dialect:?}");
            let force = total(&run(&name, &read)(".history.csv"));
            assert!((force / expected - 1.0).abs() < 1e-5, "{name}: {force} {expected}");
        }
    }
}

/// Shear modulus of chains that lock at a stretch of 5 over mu: 1 + 3/(5 l^2) + 99/(175 l^4) + 513/(875 l^6) + 42039/(67375 l^8).
/// Source: [arruda1993], five terms.
const OF_CHAINS: f64 = 1.0
    + 0.6 / 25.0
    + 99.0 / 175.0 / 625.0
    + 513.0 / 875.0 / 15_625.0
    + 42_039.0 / 67_375.0 / 390_625.0;

/// Requirement: laws of chains and of terms answer in plane stress and in a truss at strains down to 1e-8 with E times strain, and stand a
/// small initial stress. Those of chains found no thickness free of stress (SL0522), or no deformation of that stress (SL0385).
/// Source: E = 9 K G / (3 K + G). Tolerance: the strain itself, and ten times that of forces, 1e-6.
#[test]
fn small_strains_of_chains() {
    let laws = ["ARRUDA-BOYCE\n300., 5., .002\n", "NEO HOOKE\n150., .002\n"];
    for (number, law) in laws.iter().enumerate() {
        for (kind, corners) in [("CPS4", "1, 2, 3, 4"), ("T2D2", "1, 2")] {
            for strain in [1e-3, -1e-5, 1e-8] {
                let text = format!(
                    "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n*ELEMENT, TYPE={kind}, ELSET=E\n1, {corners}\n\
                     *SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*HYPERELASTIC, {law}*NSET, NSET=X1\n{}\n\
                     *STEP, NLGEOM\n*STATIC\n0.5, 1.0\n*BOUNDARY\n1, 1, 2\n2, 2\n{}X1, 1, 1, {strain:e}\n*END STEP\n",
                    if kind == "CPS4" { "2, 3" } else { "2" },
                    if kind == "CPS4" { "4, 1\n" } else { "" },
                );
                let files = run(&format!("small-{number}-{kind}"), &read(&text, Dialect::Abaqus));
                let table = files(".history.csv");
                let mut lines = table.lines();
                let column = lines.next().unwrap().split(',').position(|own| own == "RF1").unwrap();
                let last = lines.next_back().unwrap().split(',').nth(2).unwrap().to_owned();
                let rows = table.lines().filter(|row| row.split(',').nth(2) == Some(last.as_str()));
                let ends = rows.filter(|row| matches!(row.split(',').nth(3), Some("2" | "3")));
                let pull: f64 = ends
                    .map(|row| row.split(',').nth(column).unwrap().parse::<f64>().unwrap())
                    .sum();
                let (shear, bulk) = ([300.0 * OF_CHAINS, 300.0][number], 1000.0);
                let modulus = 9.0 * bulk * shear / (3.0 * bulk + shear);
                let off = (pull / (modulus * strain) - 1.0).abs();
                assert!(off < 2.0 * strain.abs() + 1e-5, "{law} {kind} {strain}: {pull}");
            }
        }
    }
    // the last two are next to incompressible: a small stress is the difference of large ones
    let stiff = ["ARRUDA-BOYCE\n1., 2.8, .001\n", "NEO HOOKE\n.5, .001\n"];
    let laws = ["ARRUDA-BOYCE\n300., 3., .002\n", stiff[0], stiff[1]];
    for (law, stress) in laws.iter().flat_map(|law| ["0.1", "1e-4"].map(|stress| (law, stress))) {
        let law = &format!("*HYPERELASTIC, {law}");
        let text = deck(law, "X1, 1\n").replace(
            "*STEP, NLGEOM",
            &format!(
                "*INITIAL CONDITIONS, TYPE=STRESS\nE, {stress}, 0., 0., 0., 0., 0.\n*STEP, NLGEOM"
            ),
        );
        let files = run("initial-chains", &read(&text, Dialect::Abaqus));
        assert!(files(".history.csv").lines().count() > 1);
    }
}
