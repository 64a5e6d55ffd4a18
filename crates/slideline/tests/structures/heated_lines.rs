//! Bars, trusses and rows of beams at temperatures: closed forms, tables, units.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::heat::run;
use slideline::{Job, ReadOptions};
use std::fmt::Write as _;

const EXPANSION: f64 = 2e-3;
/// Of strips: so little that rigid bars, which turn exactly, turn linearly.
const HEAT: f64 = 5e-3;

/// A bar from x = 0 to 2 of one type, its ends' nodes in LEFT and RIGHT, all nodes in ALL, its area
/// or thickness 0.5 on a height of 1.
fn bar(kind: &str) -> String {
    let (nodes, element) = match kind {
        "T2D2" | "T3D2" => ("1, 0, 0\n2, 2, 0\n", "1, 1, 2"),
        "T2D3" | "T3D3" => ("1, 0, 0\n3, 1, 0\n2, 2, 0\n", "1, 1, 3, 2"),
        "CPS4" => ("1, 0, 0\n2, 2, 0\n3, 2, 1\n4, 0, 1\n", "1, 1, 2, 3, 4"),
        _ => (
            "1, 0, 0\n2, 2, 0\n3, 2, 1\n4, 0, 1\n5, 0, 0, 0.5\n6, 2, 0, 0.5\n7, 2, 1, 0.5\n\
             8, 0, 1, 0.5\n",
            "1, 1, 2, 3, 4, 5, 6, 7, 8",
        ),
    };
    let (left, right) = match kind {
        "CPS4" => ("1, 4", "2, 3"),
        "C3D8" => ("1, 4, 5, 8", "2, 3, 6, 7"),
        _ => ("1", "2"),
    };
    format!(
        "*NODE, NSET=ALL\n{nodes}*NSET, NSET=LEFT\n{left}\n*NSET, NSET=RIGHT\n{right}\n\
         *ELEMENT, TYPE={kind}, ELSET=E\n{element}\n*SOLID SECTION, ELSET=E, MATERIAL=M\n0.5\n\
         *MATERIAL, NAME=M\n"
    )
}

/// What keeps a bar on its line; `ends`: where it is held along it.
fn supports(kind: &str, ends: &str) -> String {
    let across = match kind {
        "T2D2" | "T2D3" => "ALL, 2\n",
        "T3D2" | "T3D3" => "ALL, 2, 3\n",
        "CPS4" => "1, 2\n2, 2\n",
        _ => "1, 2, 3\n2, 2, 3\n3, 3\n4, 3\n",
    };
    format!("*BOUNDARY\n{ends}{across}")
}

const KINDS: [&str; 6] = ["T2D2", "T2D3", "T3D2", "T3D3", "CPS4", "C3D8"];

/// Requirement: a bar between fixed ends has the stress -E(T) a T, at large strain of logarithmic
/// measure times the growth of the free body; a free one is longer by a T, or exp(a T), and has none.
/// Source: docs/theory.md eqs. (3.60) to (3.62). Tolerance: rounding.
#[test]
fn bars_between_fixed_ends_and_free() {
    let law = format!("*ELASTIC\n300.0, 0.3, 0.\n100.0, 0.3, 100.\n*EXPANSION\n{EXPANSION}\n");
    let strain = EXPANSION * 50.0;
    let heat = "*TEMPERATURE\nALL, 50.\n*END STEP\n";
    for kind in KINDS {
        for (nlgeom, factor, grown) in
            [("", 1.0, 2.0 * strain), (", NLGEOM", (3.0 * strain).exp(), 2.0 * strain.exp_m1())]
        {
            let step = format!("*STEP{nlgeom}\n*STATIC\n0.5, 1.0\n");
            let held = supports(kind, "LEFT, 1\nRIGHT, 1\n");
            let watch = run(&format!("{}{law}{step}{held}{heat}", bar(kind)));
            let pushed: f64 = watch.reactions.values().map(|own| own[0].max(0.0)).sum();
            let exact = 200.0 * 0.5 * strain * factor;
            assert!((pushed - exact).abs() < 1e-12 * exact, "{kind}{nlgeom} {pushed} {exact}");
            let free = supports(kind, "LEFT, 1\n");
            let watch = run(&format!("{}{law}{step}{free}{heat}", bar(kind)));
            let error = watch.u[&2][0] - grown;
            assert!(error.abs() < 1e-13, "{kind}{nlgeom} {error}");
            let most = watch.reactions.values().map(|own| own[0].abs()).fold(0.0, f64::max);
            assert!(most < 1e-11, "{kind}{nlgeom} {most}");
        }
    }
}

/// Requirement: a hot truss whose end is pulled has the Cauchy stress E ln(l/l_th) of a section that
/// keeps its hot volume. Source: docs/theory.md section 3.7. Tolerance: rounding.
#[test]
fn stress_of_a_hot_truss() {
    let law = format!("*ELASTIC\n200.0, 0.3\n*EXPANSION\n{EXPANSION}\n");
    let step = "*STEP, NLGEOM\n*STATIC\n0.5, 1.0\n";
    let held = supports("T2D2", "LEFT, 1\nRIGHT, 1, 1, 0.6\n");
    let watch =
        run(&format!("{}{law}{step}{held}*TEMPERATURE\nALL, 50.\n*END STEP\n", bar("T2D2")));
    let exact = 200.0 * (1.3_f64.ln() - EXPANSION * 50.0);
    let stress = watch.elements[0];
    assert!((stress - exact).abs() < 1e-12 * exact, "{stress} {exact}");
}

/// Requirement: a bar between fixed ends yields at the yield stress of its temperature, and of the
/// elasticity of its temperature before. Source: closed form. Tolerance: rounding.
#[test]
fn a_bar_yields_at_its_temperature() {
    let law = "*ELASTIC\n100.0, 0.3\n*PLASTIC\n8.0, 0.0, 0.0\n4.0, 0.0, 100.0\n*EXPANSION\n1e-3\n";
    let step = "*STEP\n*STATIC, DIRECT\n0.25, 1.0\n";
    for kind in ["T2D2", "CPS4", "C3D8"] {
        for (heat, exact) in [(50.0, 5.0), (80.0, 4.8)] {
            let held = supports(kind, "LEFT, 1\nRIGHT, 1\n");
            let watch = run(&format!(
                "{}{law}{step}{held}*TEMPERATURE\nALL, {heat}\n*END STEP\n",
                bar(kind)
            ));
            let pushed: f64 =
                watch.reactions.values().map(|own| own[0].max(0.0)).sum::<f64>() / 0.5;
            assert!((pushed - exact).abs() < 1e-11 * exact, "{kind} {heat} {pushed}");
        }
    }
}

/// A strip of two rows of beams of a type, joined by rigid bars, in units of length, force and
/// temperature of its own.
fn strip(kind: &str, [length, force, theta]: [f64; 3]) -> String {
    let mut text = String::from("*NODE\n");
    for k in 0..=8 {
        let x = 1.25 * f64::from(k) * length;
        let half = 0.25 * length;
        let _ = writeln!(text, "{}, {x}, {}\n{}, {x}, {half}", k + 1, -half, k + 101);
    }
    for (row, first) in [("LOW", 1), ("HIGH", 101)] {
        let _ = writeln!(text, "*ELEMENT, TYPE={kind}, ELSET={row}");
        for k in 0..8 {
            let _ = writeln!(text, "{}, {}, {}", first + k, first + k, first + k + 1);
        }
    }
    for (row, young, expansion) in [("LOW", 100.0, 3e-5), ("HIGH", 200.0, 1e-5)] {
        let _ = writeln!(
            text,
            "*BEAM SECTION, SECTION=RECT, ELSET={row}, MATERIAL={row}\n{}, {}\n\
             *MATERIAL, NAME={row}\n*ELASTIC\n{}, 0.3\n*EXPANSION\n{}",
            0.2 * length,
            0.5 * length,
            young * force / (length * length),
            expansion / theta
        );
    }
    text.push_str("*MPC\n");
    for k in 0..=8 {
        let _ = writeln!(text, "BEAM, {}, {}", k + 101, k + 1);
    }
    let _ = write!(
        text,
        "*NSET, NSET=ALL, ELSET=LOW\n*NSET, NSET=ALL, ELSET=HIGH\n*STEP, NLGEOM=NO\n*STATIC\n\
         1.0, 1.0\n*BOUNDARY\n1, 1, 6\n*TEMPERATURE\nALL, {}\n*END STEP\n",
        HEAT * theta
    );
    text
}

/// Requirement: two rows of beams that are joined bend with the curvature of Timoshenko (1925) for a
/// strip of two metals. Tolerance: rounding.
#[test]
fn bimetal_strip_of_beams() {
    let (m, n) = (1.0_f64, 0.5);
    let part = 3.0 * (1.0 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n));
    let exact = 6.0 * 2e-5 * HEAT * (1.0 + m).powi(2) / part;
    for kind in ["B21", "B23"] {
        let watch = run(&strip(kind, [1.0; 3]));
        let curvature = watch.u[&9][5] / 10.0;
        assert!((curvature - exact).abs() < 1e-10 * exact, "{kind} {curvature} {exact}");
    }
}

/// Requirement: results are the same in all units of length, force and temperature. Tolerance: those
/// of powers of two and ten, rounding.
#[test]
fn units_of_temperature_mean_nothing() {
    let own = run(&strip("B21", [1.0; 3]));
    for units @ [length, force, _] in [[1e-3, 1e-6, 1.8], [1000.0, 1e9, 1e-4], [1.0, 1.0, 1e6]] {
        let other = run(&strip("B21", units));
        for node in [5, 9, 109] {
            for (dof, unit) in [(0, length), (1, length), (5, 1.0)] {
                let (a, b) = (own.u[&node][dof], other.u[&node][dof] / unit);
                assert!((a - b).abs() < 1e-10 * a.abs(), "{units:?} {node} {a} {b}");
            }
        }
        let works = [&own, &other].map(|watch| watch.energies.last().unwrap().thermal_work);
        let unit = length * force;
        assert!((works[1] / unit - works[0]).abs() < 1e-10 * works[0], "{works:?}");
    }
}

/// Requirement: in a section whose expansion grows with temperature a slope through the beam makes
/// the mean strain and the curvature of its parabola. Source: docs/theory.md eq. (3.63), integrated
/// by hand over a rectangle of height h: f = c T^2, mean c (T^2 + s^2 h^2/12), curvature -2 c T s.
/// Tolerance: rounding.
#[test]
fn a_slope_through_a_beam_whose_expansion_grows() {
    let text = "*NODE\n1, 0, 0\n2, 2, 0\n*ELEMENT, TYPE=B23, ELSET=B\n1, 1, 2\n\
         *BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n0.3, 0.6\n*MATERIAL, NAME=M\n*ELASTIC\n\
         200.0, 0.3\n*EXPANSION\n0.0, 0.0\n4e-5, 400.0\n*NSET, NSET=ALL\n1, 2\n*STEP, NLGEOM=NO\n\
         *STATIC\n1.0, 1.0\n*BOUNDARY\n1, 1, 6\n*TEMPERATURE\nALL, 100., 50.\n*END STEP\n";
    let watch = run(text);
    let c = 1e-7;
    let stretch = 2.0 * c * (100.0_f64.powi(2) + 2500.0 * 0.36 / 12.0);
    let turn = -2.0 * 2.0 * c * 100.0 * 50.0;
    assert!((watch.u[&2][0] - stretch).abs() < 1e-12 * stretch, "{:?}", watch.u[&2]);
    assert!((watch.u[&2][5] - turn).abs() < 1e-12 * turn.abs(), "{:?}", watch.u[&2]);
}

/// A cantilever of two beams of a type along x, its sizes along axes 1 and 2, axis 1, and the line of a temperature.
fn sloped(kind: &str, sizes: [f64; 2], axis: &str, line: &str) -> String {
    let [width, height] = sizes;
    format!(
        "*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n*ELEMENT, TYPE={kind}, ELSET=B\n1, 1, 2\n2, 2, 3\n\
         *BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n{width}, {height}\n{axis}\n*MATERIAL, NAME=M\n*ELASTIC\n\
         200.0, 0.3\n*EXPANSION\n0.0, 0.0\n4e-5, 400.0\n*NSET, NSET=ALL\n1, 2, 3\n*STEP, NLGEOM=NO\n*STATIC\n\
         1.0, 1.0\n*BOUNDARY\n1, 1, 6\n*TEMPERATURE\nALL, {line}\n*END STEP\n"
    )
}

/// Requirement: slopes of the temperature bend beams in space as they bend one in the plane, along either axis of the
/// section; both at once superpose where the expansion is even. They were left out. Source: the beam in the plane, whose parabola
/// is integrated by hand above; theory eq. (3.109). Tolerance: rounding.
#[test]
fn slopes_bend_beams_in_space() {
    let plane = run(&sloped("B21", [0.3, 0.6], "0, 0, -1", "100., 50.")).u[&3];
    let in_2 = run(&sloped("B31", [0.3, 0.6], "0, 0, -1", "100., 50.")).u[&3];
    // axis 1 along y, so axis 2 along z
    let in_1 = run(&sloped("B31", [0.6, 0.3], "0, 1, 0", "100., 0., 50.")).u[&3];
    let both = run(&sloped("B31", [0.3, 0.6], "0, 0, -1", "100., 50., 30.")).u[&3];
    for (name, own) in [("axis 2", in_2), ("axis 1", in_1)] {
        for dof in [0, 1, 5] {
            let off = (own[dof] - plane[dof]).abs();
            assert!(off < 1e-12 * plane[dof].abs(), "{name}: {own:?} {plane:?}");
        }
    }
    // along z against axis 1: fibres there get longer, the tip goes away from them
    let alone = run(&sloped("B31", [0.3, 0.6], "0, 0, -1", "100., 0., 30.")).u[&3];
    for (dof, one) in [(1, in_2), (5, in_2), (2, alone), (4, alone)] {
        assert!((both[dof] - one[dof]).abs() < 1e-12 * one[dof].abs(), "{both:?}");
    }
    let curvature = 2.0 * 1e-7 * 100.0 * 30.0;
    assert!((alone[2] - 0.5 * curvature * 4.0).abs() < 1e-12 * curvature, "{alone:?}");
}

/// Requirement: a slope along either axis with an amplitude that is absolute is refused: one number cannot be both. That along axis 1 was
/// taken times it.
#[test]
fn slopes_follow_no_absolute_amplitude() {
    for (line, refused) in
        [("10.", false), ("10., 0., 0.", false), ("10., 5.", true), ("10., 0., 30.", true)]
    {
        let text = sloped("B31", [0.3, 0.6], "0, 0, -1", line)
            .replace("*STEP", "*AMPLITUDE, NAME=A, VALUE=ABSOLUTE\n0., 1., 1., 2.\n*STEP")
            .replace("*TEMPERATURE", "*TEMPERATURE, AMPLITUDE=A");
        let read = Job::read_text("slopes", &text, &ReadOptions::default());
        let said = read.diagnostics.iter().any(|own| own.code.0 == "SL0221");
        assert_eq!(said, refused, "{line}: {:#?}", read.diagnostics);
    }
}

/// Requirement: a free beam in space whose nodes are not its centroid bends by slopes about both axes without forces, as long as
/// its line of nodes is hot. Source: its fibres are as long as they want. Tolerance: rounding.
#[test]
fn free_sections_beside_their_nodes_have_no_forces() {
    let text = "*NODE\n1, 0, 0, 0\n2, 2, 0, 0\n*ELEMENT, TYPE=B31, ELSET=B\n1, 1, 2\n\
         *BEAM SECTION, SECTION=L, ELSET=B, MATERIAL=M\n.4, .5, .05, .06\n0, 0, -1\n\
         *MATERIAL, NAME=M\n*ELASTIC\n200.0, 0.3\n*EXPANSION\n1e-4\n*NSET, NSET=ALL\n1, 2\n*STEP, NLGEOM=NO\n\
         *STATIC\n1.0, 1.0\n*BOUNDARY\n1, 1, 6\n*TEMPERATURE\nALL, 10., 50., 30.\n*END STEP\n";
    let tip = run(text).u[&2];
    let (stretch, up, aside) = (1e-4 * 10.0 * 2.0, 1e-4 * 50.0, 1e-4 * 30.0);
    let exact = [stretch, -0.5 * up * 4.0, 0.5 * aside * 4.0];
    for (own, exact) in tip.iter().zip(exact) {
        assert!((own - exact).abs() < 1e-12 * exact.abs(), "{tip:?} {exact}");
    }
}
