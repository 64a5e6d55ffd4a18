//! `slideline import`: meshes of gmsh to decks that run. The meshes are those of
//! benches/drop-in/gmsh_meshes.py.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MODULUS: f64 = 1000.0;
const PRESSURE: f64 = 10.0;
const LENGTH: f64 = 4.0;

fn meshes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../mesh/tests/meshes")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("import").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let program = env!("CARGO_BIN_EXE_slideline");
    let Output { status, stdout, stderr } =
        Command::new(program).args(arguments).current_dir(folder).output().unwrap();
    let said = String::from_utf8(stdout).unwrap() + &String::from_utf8(stderr).unwrap();
    (status.code(), said)
}

/// The deck of a mesh of the repository.
fn imported(folder: &Path, mesh: &str, options: &[&str]) -> String {
    let path = meshes().join(mesh);
    let arguments = [&["import", path.to_str().unwrap(), "-o", "made.inp"], options].concat();
    let (code, said) = slideline(folder, &arguments);
    assert_eq!(code, Some(0), "{mesh}: {said}");
    let deck = folder.join("made.inp");
    let text = std::fs::read_to_string(&deck).unwrap();
    std::fs::remove_file(deck).unwrap();
    text
}

/// Runs a deck with its places filled in; displacements along x by nodes.
fn solved(folder: &Path, deck: &str, fill: &[(&str, &str)]) -> Vec<(u64, f64)> {
    let mut deck = deck.to_owned();
    for (mark, values) in fill {
        let at = deck.find(&format!("** FILL IN: {mark}")).unwrap_or_else(|| panic!("{deck}"));
        let end = at + deck[at..].find('\n').unwrap();
        deck.replace_range(at..end, values);
    }
    std::fs::write(folder.join("part.inp"), &deck).unwrap();
    let (code, said) = slideline(folder, &["run", "part", "--no-html"]);
    assert_eq!(code, Some(0), "{said}\n{deck}");
    let history = std::fs::read_to_string(folder.join("part.history.csv")).unwrap();
    let rows = history.lines().skip(1).map(|row| row.split(',').collect::<Vec<_>>());
    let last = rows.filter(|row| row[2] == "1");
    last.map(|row| (row[3].parse().unwrap(), row[4].parse().unwrap())).collect()
}

/// Requirement: in every format cells of every shape become the element with the same nodes in the
/// same order, and groups of faces its faces: a part without lateral strain that is pulled by a
/// pressure on one group and held by the other has u = p x / E at every node, middle nodes too.
#[test]
fn every_shape_of_every_format_passes_the_patch_test() {
    let folder = folder("patch");
    let mut count = 0;
    for entry in std::fs::read_dir(meshes()).unwrap() {
        let mesh = entry.unwrap().file_name().into_string().unwrap();
        if mesh.starts_with("line") {
            continue;
        }
        let deck = imported(&folder, &mesh, &["--fix", "held"]);
        assert!(deck.contains("*SURFACE, NAME=PULLED_END, TYPE=ELEMENT"), "{mesh}: {deck}");
        let deck = deck.replace("*NODE\n", "*NODE, NSET=ALL\n").replace("*STEP, NLGEOM", "*STEP");
        let deck = deck.replace("*NODE FILE", "*NODE PRINT, NSET=ALL");
        let load = format!("*DSLOAD\nPULLED_END, P, {}", -PRESSURE);
        let material = format!("{MODULUS}, 0.0");
        let fill = [("Young's modulus", material.as_str()), ("what is held", load.as_str())];
        let moved = solved(&folder, &deck, &fill);
        let places = places(&deck);
        assert_eq!(moved.len(), places.len(), "{mesh}");
        for (node, u) in moved {
            let exact = PRESSURE * places[&node] / MODULUS;
            assert!((u - exact).abs() < 1e-9 * LENGTH, "{mesh}: node {node} {u} {exact}");
        }
        count += 1;
    }
    assert_eq!(count, 26);
}

/// First coordinates of the nodes of a deck [L].
fn places(deck: &str) -> std::collections::BTreeMap<u64, f64> {
    let nodes = deck.split("*NODE, NSET=ALL\n").nth(1).unwrap().lines();
    let nodes = nodes.take_while(|line| !line.starts_with('*'));
    let words = nodes.map(|line| line.split(", ").collect::<Vec<_>>());
    words.map(|words| (words[0].parse().unwrap(), words[1].parse().unwrap())).collect()
}

/// Requirement: lines are beams where they are asked for, and points are sets of nodes. Source: beam
/// theory, u = F l^3 / (3 E I) and no shear in B23; the tip of the axis is moved, its force is read.
#[test]
fn lines_become_beams() {
    let folder = folder("beams");
    for (mesh, kind) in [("line2_22.msh", "B23"), ("line2_41.msh", "B23"), ("line3_41.msh", "B22")]
    {
        let beam = format!("arm={kind}");
        let deck = imported(&folder, mesh, &["--beam", &beam, "--fix", "root"]);
        assert!(deck.contains(&format!("*ELEMENT, TYPE={kind}, ELSET=ARM\n")), "{deck}");
        assert!(deck.contains("\nROOT, 1, 6\n") && deck.contains("*NSET, NSET=TIP\n"), "{deck}");
        let deck = deck.replace("*STEP, NLGEOM", "*STEP");
        let fill = [
            ("Young's modulus", "1000.0, 0.3"),
            ("width, height", "2.0, 0.1"),
            ("what is held", "TIP, 2, 2, 0.01"),
        ];
        solved(&folder, &deck, &fill);
        let history = std::fs::read_to_string(folder.join("part.history.csv")).unwrap();
        let rows: Vec<Vec<&str>> =
            history.lines().skip(1).map(|row| row.split(',').collect()).collect();
        let forces = rows.iter().filter(|row| row[2] == "1");
        let force = forces.map(|row| row[8].parse::<f64>().unwrap()).fold(0.0, f64::max);
        let stiffness = 3.0 * 1000.0 * (2.0 * 0.1_f64.powi(3) / 12.0) / LENGTH.powi(3);
        assert!((force / (0.01 * stiffness) - 1.0).abs() < 2e-3, "{mesh}: {force}");
    }
}

/// Requirement: a group may be a rigid body, of another element type, or a set of nodes alone.
#[test]
fn groups_become_what_is_asked_for() {
    let folder = folder("asked");
    let options =
        ["--solid", "part=CPE4I", "--rigid", "PULLED_END", "--nset", "held", "--fix", "held"];
    let deck = imported(&folder, "quad4_41.msh", &options);
    assert!(deck.contains("*ELEMENT, TYPE=CPE4I, ELSET=PART\n"), "{deck}");
    assert!(!deck.contains("*SURFACE, NAME=HELD"), "{deck}");
    let reference = deck.split("*NODE, NSET=PULLED_END_REF\n").nth(1).unwrap();
    let words: Vec<&str> = reference.lines().next().unwrap().split(", ").collect();
    let place: Vec<f64> = words[1..].iter().map(|word| word.parse().unwrap()).collect();
    assert!((place[0] - 4.0).abs() < 1e-12 && (place[1] - 1.0).abs() < 1e-12, "{place:?}");
    let fill = [
        ("Young's modulus", "1000.0, 0.3"),
        ("thickness", "1.0"),
        ("what is held", "PULLED_END_REF, 1, 1, 0.1\nPULLED_END_REF, 6, 6"),
    ];
    let moved = solved(&folder, &deck, &fill);
    let reference: u64 = words[0].parse().unwrap();
    assert!(moved.contains(&(reference, 0.1)), "{moved:?}");
}

/// Requirement: groups of one name, or of names that decks cannot keep apart, are different sets, and
/// each can be asked for; gmsh itself allows them.
#[test]
fn groups_of_one_name_stay_apart() {
    let folder = folder("names");
    let text = std::fs::read_to_string(meshes().join("quad4_41.msh")).unwrap();
    let text = text.replace("\"held\"", "\"part\"").replace("\"pulled end\"", "\"rest\"");
    std::fs::write(folder.join("same.msh"), text).unwrap();
    let same = folder.join("same.msh");
    let deck =
        imported(&folder, same.to_str().unwrap(), &["--fix", "part_curve", "--rigid", "rest"]);
    for part in [
        "ELSET=PART\n",
        "*NSET, NSET=PART_CURVE\n",
        "*SURFACE, NAME=PART_CURVE, TYPE=ELEMENT\n",
        "\nPART_CURVE, 1, 2\n",
        "*NODE, NSET=REST_REF\n",
    ] {
        assert_eq!(deck.matches(part).count(), 1, "{part}: {deck}");
    }
    let area = deck.split("ELSET=PART\n").nth(1).unwrap().split("\n*").next().unwrap();
    assert_eq!(area.lines().count(), 11, "{deck}");
}

/// Requirement: every bad mesh and wish is a coded error with its line, and nothing is written.
#[test]
fn bad_meshes_are_refused_with_their_line() {
    let folder = folder("bad");
    let good = std::fs::read_to_string(meshes().join("quad4_41.msh")).unwrap();
    let second = std::fs::read_to_string(meshes().join("quad8_22.msh")).unwrap();
    let five = "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n";
    let other = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    };
    let cases: Vec<(String, Vec<&str>, &str, &str)> = vec![
        (other(&good, "4.1 0 8", "4.1 1 8"), vec![], "SL0831", "bad.msh:2:1"),
        (other(&good, "4.1 0 8", "3.0 0 8"), vec![], "SL0831", "bad.msh:2:1"),
        (other(&good, "\n4 0 0\n", "\n4 x 0\n"), vec![], "SL0831", "`x`"),
        (other(&good, "\n4 0 0\n", "\n4 inf 0\n"), vec![], "SL0831", "finite"),
        (good.split_inclusive("$Nodes\n").next().unwrap().to_owned(), vec![], "SL0831", "ends"),
        ("*NODE\n1, 0., 0.\n".to_owned(), vec![], "SL0831", "no elements"),
        (
            format!("{five}5, 0., 0., 2.\n*ELEMENT, TYPE=C3D4\n7, 1, 2, 3, 4, 5\n"),
            vec![],
            "SL0831",
            "element 7 has more",
        ),
        (String::new(), vec![], "SL0101", "empty"),
        (other(&second, " 16 2", " 7 2"), vec![], "SL0833", "bad.msh:"),
        (other(&second, " 16 2", " 10 2"), vec![], "SL0831", "9 nodes"),
        (good.clone(), vec!["--rigid", "hold"], "SL0832", "Is held meant?"),
        (good.clone(), vec!["--beam", "held=B22"], "SL0834", "B21"),
        (good.clone(), vec!["--beam", "part=B21"], "SL0834", "curves"),
        (good.clone(), vec!["--solid", "part=CPX4"], "SL0834", "CPX4"),
        (good.clone(), vec!["--solid", "part=C3D8"], "SL0834", "areas of 4 nodes"),
        (other(&good, "\n4 0 0\n", "\n4 0 1\n"), vec![], "SL0834", "plane"),
    ];
    for (text, options, code, words) in cases {
        std::fs::write(folder.join("bad.msh"), &text).unwrap();
        let (exit, said) = slideline(&folder, &[&["import", "bad.msh"], &options[..]].concat());
        assert!(said.contains(&format!("error[{code}]")), "{code} {words}: {said}");
        assert!(exit == Some(1) && said.contains(words), "{code} {words}: {said}");
        assert!(!folder.join("bad_deck.inp").exists());
    }
    let (exit, said) = slideline(&folder, &["import", "nothing.msh"]);
    assert!(exit == Some(1) && said.contains("error[SL0831]"), "{said}");
}

/// Requirement: whatever bytes a mesh has, it is read or refused.
#[test]
fn no_damage_is_a_fault_of_ours() {
    let folder = folder("damage");
    for mesh in ["tri6_22.msh", "line3_41.msh", "quad8_.inp"] {
        let bytes = std::fs::read(meshes().join(mesh)).unwrap();
        let ending = mesh.rsplit('.').next().unwrap();
        for step in 0..8 {
            let at = bytes.len() * step / 8;
            for broken in [bytes[..at].to_vec(), [&bytes[..at], b" -7 ", &bytes[at..]].concat()] {
                let name = format!("m.{ending}");
                std::fs::write(folder.join(&name), broken).unwrap();
                let (exit, said) = slideline(&folder, &["import", &name, "-o", "out.inp"]);
                assert!(matches!(exit, Some(0 | 1)), "{mesh} {at}: {said}");
                let _ = std::fs::remove_file(folder.join("out.inp"));
            }
        }
    }
}

/// A deck of meshio, and decks in the forms of PrePoMax, FreeCAD and Netgen: sets of sets, surfaces of faces,
/// types without a counterpart here.
#[test]
fn meshes_of_other_programs_become_decks() {
    let folder = folder("others");
    let told: [(&str, &str, &[&str]); 4] = [
        (
            "prepomax.inp",
            "NODE_SET-1",
            &[
                "*ELEMENT, TYPE=C3D4, ELSET=SOLID_PART-1\n1, 1, 2, 3, 4\n2, 2, 3, 4, 5\n",
                "*NSET, NSET=NODE_SET-1\n1, 3, 4\n",
                "*NSET, NSET=INTERNAL_SELECTION-1\n1, 3, 4, 5\n",
                "*ELSET, ELSET=ALL_PARTS\n1, 2\n",
                "*SURFACE, NAME=SURFACE-1, TYPE=ELEMENT\n_SURFACE-1_S1, S1\n_SURFACE-1_S2, S2\n",
                "*ELSET, ELSET=_SURFACE-1_S2\n2\n",
            ],
        ),
        (
            "freecad.inp",
            "FIXED",
            &["ELSET=EVOLUMES\n1, 1, 2, 3, 4\n", "*ELSET, ELSET=EALL\n1, 2\n"],
        ),
        ("meshio.inp", "ROOT", &["*ELEMENT, TYPE=C3D8, ELSET=BODY\n1, 1, 2, 5, 4, 7, 8, 11, 10\n"]),
        (
            "netgen.inp",
            "FIX1",
            &["ELSET=PART1\n1, 1, 2, 3, 4\n", "*SURFACE, NAME=SURF_1, TYPE=ELEMENT\n"],
        ),
    ];
    for (mesh, held, parts) in told {
        let deck = imported(&folder, &format!("../others/{mesh}"), &["--fix", held]);
        for part in parts {
            assert!(deck.contains(part), "{mesh}: {part} is not in\n{deck}");
        }
        let filled = deck
            .replace("** FILL IN: Young's modulus, Poisson's ratio", "1000.0, 0.3")
            .replace("** FILL IN: what is held", "5, 1, 3, 0.001\n** FILL IN: what is held");
        std::fs::write(folder.join("part.inp"), filled).unwrap();
        let (code, said) = slideline(&folder, &["check", "part.inp"]);
        assert_eq!(code, Some(0), "{mesh}: {said}\n{deck}");
    }
}
