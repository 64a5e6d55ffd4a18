//! Whatever way a file takes to another, it is seen.

use super::Imports;

/// Circles of a crate of these files, written as their modules.
fn circles(name: &str, files: &[(&str, &str)]) -> Vec<String> {
    let folder = std::env::temp_dir().join(format!("imports-{}-{name}", std::process::id()));
    std::fs::create_dir_all(folder.join("src/a")).unwrap();
    std::fs::write(folder.join("Cargo.toml"), "[package]\nname = \"own-name\"\n").unwrap();
    for (file, text) in files {
        std::fs::write(folder.join("src").join(file), text).unwrap();
    }
    let found = Imports::of(&folder.join("src")).circles();
    std::fs::remove_dir_all(&folder).unwrap();
    let named = |module: &Vec<String>| module.join("::");
    found.iter().map(|circle| circle.iter().map(named).collect::<Vec<_>>().join(" ")).collect()
}

/// Files of which `b` uses `c`, and `c` uses `b` in a way of its own.
fn there_and_back(name: &str, back: &str) -> Vec<String> {
    let root = ("lib.rs", "mod a;\nmod b;\nmod c;\n");
    let there =
        "\nuse crate::c::Other;\n\npub struct Own;\n\npub fn made() -> Other {\n    Other\n}\n";
    let back = format!("\npub struct Other;\n{back}\n");
    circles(name, &[root, ("a.rs", "mod d;\n"), ("b.rs", there), ("c.rs", &back)])
}

#[test]
fn circles_by_paths_of_every_kind() {
    let ways = [
        ("root", "use crate::b::Own;"),
        ("beside", "use super::b::Own;"),
        ("tree", "use super::{a, b::{self, Own}};"),
        ("no_use", "fn back() -> crate::b::Own {\n    crate::b::Own\n}"),
        ("own_name", "use own_name::b::Own;"),
        ("alias", "use super::b as other;\nfn back() -> other::Own {\n    other::Own\n}"),
        ("all", "use super::*;\nfn back() -> b::Own {\n    b::Own\n}"),
        ("inline", "mod within {\n    use super::super::b::Own;\n}"),
        ("macro", "macro_rules! back {\n    () => {\n        $crate::b::Own\n    };\n}"),
    ];
    for (name, way) in ways {
        assert_eq!(there_and_back(name, way), ["b c"], "{name}");
    }
}

#[test]
fn no_circles_where_there_are_none() {
    let ways = [
        ("nothing", ""),
        ("comment", "// use super::b::Own;"),
        ("test", "#[cfg(test)]\nmod tests {\n    use crate::b::Own;\n}"),
        ("other_crate", "use b_other::b::Own;"),
        ("own_inline", "mod within {\n    use super::Other;\n}"),
    ];
    for (name, way) in ways {
        assert!(there_and_back(name, way).is_empty(), "{name}");
    }
}

/// A parent that hands on what a child holds is imported by no child.
#[test]
fn circles_through_a_parent() {
    let files = [
        ("lib.rs", "mod a;\n"),
        ("a.rs", "mod d;\nmod e;\npub use d::Own;\n"),
        ("a/d.rs", "use super::e::Other;\n\npub struct Own(Other);\n"),
        ("a/e.rs", "use super::Own;\n\npub struct Other;\n\nfn back(_: Own) {}\n"),
    ];
    assert_eq!(circles("parent", &files), ["a a::d a::e"]);
}

/// A method that a file gives to a type of another one is imported by who calls it.
#[test]
fn circles_by_methods() {
    let files = |call: &'static str| {
        [
            ("lib.rs", "mod b;\nmod c;\n"),
            ("b.rs", call),
            ("c.rs", "use crate::b::Own;\n\nimpl Own {\n    pub fn further(&self) {}\n}\n"),
        ]
    };
    let calls = "\npub struct Own;\n\npub fn made(own: &Own) {\n    own.further();\n}\n";
    assert_eq!(circles("calls", &files(calls)), ["b c"]);
    assert!(
        circles("is_silent", &files("\npub struct Own;\n\npub fn further_on() {}\n")).is_empty()
    );
}
