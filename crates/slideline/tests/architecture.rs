//! ARCHITECTURE.md is true: its floors are the crates' imports, every code
//! and keyword has its page.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

mod imports;

use imports::Imports;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|reason| panic!("{}: {reason}", path.display()))
}

struct Row {
    floor: u32,
    imports: BTreeSet<String>,
}

/// Words between backticks.
fn quoted(cell: &str) -> BTreeSet<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// The table of floors.
fn table() -> BTreeMap<String, Row> {
    let page = read(&root().join("ARCHITECTURE.md"));
    let rows = page.lines().filter_map(|line| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let floor = cells.get(1)?.parse().ok()?;
        let name = quoted(cells.get(2)?).into_iter().next()?;
        Some((name, Row { floor, imports: quoted(cells.get(4)?) }))
    });
    rows.collect()
}

/// Crates that stand beside the others, not among them: the unpublished tests, and what other
/// languages import.
const BESIDE: [&str; 3] = ["verification", "bindings/python", "bindings/wasm"];

fn folder(crate_name: &str) -> PathBuf {
    if BESIDE.contains(&crate_name) {
        root().join(crate_name)
    } else {
        root().join("crates").join(crate_name)
    }
}

/// Crates of ours that a manifest names, in whatever kind of dependency.
fn imports(crate_name: &str) -> BTreeSet<String> {
    let manifest = read(&folder(crate_name).join("Cargo.toml"));
    let mut section = String::new();
    let mut found = BTreeSet::new();
    for line in manifest.lines().map(str::trim) {
        if line.starts_with('[') {
            section = line.to_owned();
        } else if section.contains("dependencies") {
            let key = line.split(['.', '=', ' ']).next().unwrap_or_default();
            let own = key.strip_prefix("slideline-").or((key == "slideline").then_some(key));
            found.extend(own.map(str::to_owned));
        }
    }
    found
}

fn crates() -> BTreeSet<String> {
    let folders = std::fs::read_dir(root().join("crates")).unwrap();
    let manifests = folders.map(|entry| entry.unwrap().path().join("Cargo.toml"));
    manifests
        .filter(|manifest| manifest.exists())
        .map(|manifest| {
            manifest.parent().unwrap().file_name().unwrap().to_str().unwrap().to_owned()
        })
        .chain(BESIDE.map(str::to_owned))
        .collect()
}

#[test]
fn the_table_lists_the_crates_and_nothing_else() {
    let listed: BTreeSet<String> = table().into_keys().collect();
    assert_eq!(listed, crates());
}

#[test]
fn every_crate_imports_only_what_its_row_allows() {
    let table = table();
    for name in crates() {
        let row = &table[&name];
        let strange: Vec<String> = imports(&name).difference(&row.imports).cloned().collect();
        assert!(strange.is_empty(), "{name} imports {strange:?}, which its row does not allow");
    }
}

/// The bindings have lock files of their own: what they share with the workspace has the same
/// versions, or their results would be those of another program.
#[test]
fn the_locks_agree() {
    let versions = |path: &str| -> BTreeSet<(String, String)> {
        let lock = read(&root().join(path));
        let packages = lock.split("[[package]]").skip(1).filter_map(|package| {
            let value = |key: &str| {
                let line = package.lines().find_map(|line| line.strip_prefix(key))?;
                Some(line.trim_matches('"').to_owned())
            };
            Some((value("name = ")?, value("version = ")?))
        });
        packages.collect()
    };
    let own = versions("Cargo.lock");
    let names: BTreeSet<&String> = own.iter().map(|(name, _)| name).collect();
    for lock in ["bindings/python/Cargo.lock", "bindings/wasm/Cargo.lock"] {
        let other = versions(lock);
        let shared = other.iter().filter(|(name, _)| names.contains(name));
        let strange: Vec<_> = shared.filter(|package| !own.contains(package)).collect();
        assert!(strange.is_empty(), "{lock} has other versions: {strange:?}");
    }
}

#[test]
fn rows_allow_only_lower_floors() {
    let table = table();
    for (name, row) in &table {
        for import in &row.imports {
            let floor = table.get(import).map(|row| row.floor);
            assert!(floor.is_some_and(|floor| floor < row.floor), "{name} may import {import}");
        }
    }
}

#[test]
fn axes_of_contact_are_the_folders_and_never_import_one_another() {
    let folder = root().join("crates/mech/src/contact");
    let page = read(&root().join("ARCHITECTURE.md"));
    let listed: BTreeSet<String> = page
        .lines()
        .skip_while(|line| !line.starts_with("| axis"))
        .skip(2)
        .take_while(|line| line.starts_with('|'))
        .flat_map(|line| quoted(line.split('|').nth(1).unwrap_or_default()))
        .collect();
    let entries = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let axes: BTreeSet<String> = entries
        .filter(|path| path.is_dir())
        .map(|path| path.file_name().unwrap().to_str().unwrap().to_owned())
        .filter(|name| name != "pair") // composes the others
        .collect();
    assert_eq!(listed, axes);
    let imports = Imports::of(&root().join("crates/mech/src"));
    let axis = |module: &[String]| match module {
        [contact, axis, ..] if contact == "contact" => Some(axis.clone()),
        _ => None,
    };
    for module in imports.modules() {
        let Some(own) = axis(module).filter(|own| axes.contains(own)) else { continue };
        for target in imports.targets(module) {
            let other = axis(target).filter(|other| axes.contains(other) && *other != own);
            let file = imports.file(module).display();
            assert!(other.is_none(), "{file} imports {}", target.join("::"));
        }
    }
}

/// Crates above the mechanics that know no dimension; drawings and the 1995 study are plane by
/// nature.
const WITHOUT_DIMENSION: [&str; 8] =
    ["model", "keywords", "solve", "results", "advice", "slideline", "deck", "cli"];

/// Where two numbers are no vector of the plane, or what is described is plane by nature.
const PAIRS: [(&str, &str); 12] = [
    ("crates/model/src/contact.rs", "shares of two nodes; two coefficients"),
    ("crates/model/src/surface.rs", "points of a profile"),
    ("crates/model/src/friction.rs", "two coefficients"),
    ("crates/model/src/element/", "kernels of plane elements"),
    ("crates/solve/src/newton/measures.rs", "forces and moments"),
    ("crates/solve/src/contact/shear.rs", "two ends of a segment"),
    ("crates/advice/src/roles.rs", "radius and spacing"),
    ("crates/cli/src/live.rs", "motion and reaction"),
    ("crates/model/src/tested.rs", "nominal strain and stress"),
    ("crates/keywords/src/finish/rubber.rs", "nominal strain and stress"),
    ("crates/keywords/src/test_data.rs", "nominal strain and stress"),
    ("crates/keywords/src/draft/sections.rs", "nominal strain and stress"),
];

/// Nothing above the mechanics holds a vector of the plane, or the dofs of a plane model.
#[test]
fn no_plane_above_the_mechanics() {
    for name in WITHOUT_DIMENSION {
        let mut files = Vec::new();
        collect(&root().join("crates").join(name).join("src"), &mut files);
        for file in files.iter().filter(|file| file.extension().is_some_and(|end| end == "rs")) {
            let place = file.strip_prefix(root()).unwrap().display().to_string();
            let allowed = PAIRS.iter().any(|(known, _)| place.starts_with(known));
            let text = read(file);
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let is_test = place.ends_with("tests.rs") || place.contains("/tests/");
            for word in ["[f64; 2]", "Dof::PLANE", ".plane("].iter().filter(|_| !is_test) {
                assert!(allowed || !code.contains(word), "{place} holds {word}");
            }
        }
    }
}

/// Every file can be read before those that import it.
#[test]
fn no_files_import_one_another_in_circles() {
    let mut found = Vec::new();
    for name in &crates() {
        let imports = Imports::of(&folder(name).join("src"));
        for circle in imports.circles() {
            let names: Vec<String> = circle.iter().map(|module| module.join("::")).collect();
            found.push(format!("{name}: {}", names.join(", ")));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// Files are modules of their names, nothing is pasted in and no root has another name: else the
/// test above is blind.
#[test]
fn files_hide_no_imports() {
    let mut files = Vec::new();
    for name in crates() {
        collect(&folder(&name).join("src"), &mut files);
    }
    for file in files {
        let text = read(&file);
        for word in ["#[path", "include!(\"", "use crate as ", "use super as ", "extern crate self"]
        {
            assert!(!text.contains(word), "{} holds {word}", file.display());
        }
    }
}

#[test]
fn every_code_has_a_page_and_every_page_a_code() {
    let folder = root().join("docs/errors");
    let codes: BTreeSet<String> =
        slideline::diag::CATALOGUE.iter().map(|entry| entry.code.0.to_owned()).collect();
    let pages: BTreeSet<String> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    let difference: Vec<&String> = codes.symmetric_difference(&pages).collect();
    assert!(difference.is_empty(), "code without page, or page without code: {difference:?}");
    for code in &codes {
        let page = read(&folder.join(format!("{code}.md")));
        assert!(page.starts_with(&format!("# {code}")), "docs/errors/{code}.md has another title");
    }
}

/// Codes that the sources use stand in the catalogue.
#[test]
fn no_code_is_used_that_the_catalogue_lacks() {
    let mut files = Vec::new();
    for name in crates() {
        collect(&folder(&name).join("src"), &mut files);
    }
    for file in files {
        let text = read(&file);
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        for used in code.split("\"SL").skip(1).filter_map(|rest| rest.get(..5)) {
            if let Some(digits) = used.strip_suffix('"') {
                let known = slideline::diag::entry(&format!("SL{digits}")).is_some();
                assert!(known, "{} uses the unknown code SL{digits}", file.display());
            }
        }
    }
}

fn collect(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            into.push(path);
        }
    }
}

#[test]
fn every_keyword_has_a_page_and_a_deck() {
    let mut missing = Vec::new();
    for keyword in slideline::keywords::keywords() {
        let name = keyword.name.replace(' ', "-");
        for path in [format!("docs/keywords/{name}.md"), format!("corpus/keywords/{}.inp", name)] {
            if !root().join(&path).exists() {
                missing.push(path);
            }
        }
        assert!(!keyword.page.trim().is_empty(), "the page of {} is empty", keyword.name);
    }
    assert!(missing.is_empty(), "missing: {missing:?}");
}

/// Requirement: files that the page names are there, and every example of the library is run by a
/// test of its name.
#[test]
fn what_is_added_from_outside_is_there_and_tested() {
    let page = quoted(&read(&root().join("ARCHITECTURE.md")).replace("```", ""));
    let named = page.iter().filter(|own| own.ends_with(".rs") && own.starts_with("crates/"));
    let missing: Vec<&String> = named.clone().filter(|own| !root().join(own).is_file()).collect();
    assert!(named.count() > 3 && missing.is_empty(), "{missing:?}");
    let mut examples = Vec::new();
    collect(&folder("slideline").join("examples"), &mut examples);
    for example in examples {
        let name = example.file_name().unwrap().to_string_lossy();
        let test = read(&folder("slideline").join("tests/runs").join(&*name));
        assert!(test.contains(&format!("../../examples/{name}")), "{name}");
        let shown = page.iter().any(|own| own.ends_with(&format!("examples/{name}")));
        assert!(shown, "ARCHITECTURE.md does not name {name}");
    }
}

/// Programs of tests that have a process of their own, with the reason; all other tests of a crate
/// are modules of a `tests/PROGRAM/main.rs`.
const ALONE: [(&str, &str); 3] = [
    ("crates/slideline/tests/architecture.rs", "reads the tree and runs nothing"),
    ("crates/linalg/tests/allocation.rs", "counts what the process allocates"),
    ("crates/reproduce/tests/study.rs", "the only one of its crate"),
];

/// Every program of tests is linked with the whole library: a file each made the build twice as
/// long.
#[test]
fn tests_share_a_few_programs() {
    for name in crates() {
        let tests = folder(&name).join("tests");
        let manifest = read(&folder(&name).join("Cargo.toml"));
        if !tests.is_dir() || manifest.contains("autotests = false") {
            continue;
        }
        for entry in std::fs::read_dir(&tests).unwrap().map(|entry| entry.unwrap().path()) {
            let place = entry.strip_prefix(root()).unwrap().display().to_string();
            let alone = ALONE.iter().any(|(known, _)| place == *known);
            let file = entry.extension().is_some_and(|ending| ending == "rs");
            assert!(!file || alone, "{place} is a program of its own: move it below a program");
            if entry.join("main.rs").is_file() {
                every_file_is_a_module(&entry);
            }
        }
    }
}

/// A file that no `mod` names would be no test.
fn every_file_is_a_module(program: &Path) {
    let main = read(&program.join("main.rs"));
    for entry in std::fs::read_dir(program).unwrap().map(|entry| entry.unwrap().path()) {
        let module = entry.file_stem().unwrap().to_str().unwrap();
        let holds_code = entry.extension().is_some_and(|ending| ending == "rs")
            || entry.join("mod.rs").is_file();
        let named = module == "main" || main.contains(&format!("mod {module};"));
        assert!(!holds_code || named, "{} is no module of its program", entry.display());
    }
}

/// A heading that a reader sees first: every crate says what it is for.
#[test]
fn every_crate_has_a_description() {
    for name in crates() {
        let manifest = read(&folder(&name).join("Cargo.toml"));
        assert!(manifest.contains("\ndescription = \""), "{name} has no description");
    }
}
