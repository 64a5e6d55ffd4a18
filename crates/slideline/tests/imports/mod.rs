//! Which file of a crate imports which: read from the sources, as text.
//!
//! ```text
//!   use super::a::{b, C};  crate::a::d()  own_name::a  alias::d()    paths, see paths.rs
//!   value.method()   where one file alone has that method            see methods.rs
//! ```

mod methods;
mod paths;
mod tests;

use methods::Methods;
use paths::Paths;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A module by its names from the root on, such as `["contact", "pair"]`; the root is empty.
pub type Module = Vec<String>;

/// Files of a crate by the paths of their modules, and what each imports.
pub struct Imports {
    files: BTreeMap<Module, PathBuf>,
    targets: BTreeMap<Module, BTreeSet<Module>>,
}

impl Imports {
    /// Reads the sources below a folder.
    pub fn of(source: &Path) -> Self {
        let mut all = Vec::new();
        super::collect(source, &mut all);
        let mut files = BTreeMap::new();
        for path in all {
            let inside = path.strip_prefix(source).unwrap().with_extension("");
            let mut module: Module =
                inside.iter().map(|part| part.to_str().unwrap().to_owned()).collect();
            if ["mod", "lib", "main"].contains(&module.last().unwrap().as_str()) {
                module.pop();
            }
            files.insert(module, path);
        }
        let code = files.iter().map(|(module, path)| (module.clone(), code(&super::read(path))));
        let code: BTreeMap<Module, String> = code.collect();
        let paths = Paths { code: &code, own_name: own_name(source) };
        let by_path = code.keys().map(|module| (module.clone(), paths.targets(module)));
        let mut targets: BTreeMap<Module, BTreeSet<Module>> = by_path.collect();
        let reached = all_reached(&targets);
        for (caller, target) in Methods::of(&code).calls(&code, &reached) {
            targets.entry(caller).or_default().insert(target);
        }
        Self { targets, files }
    }

    /// The file of a module.
    pub fn file(&self, module: &[String]) -> &Path {
        &self.files[module]
    }

    /// Modules with a file of their own.
    pub fn modules(&self) -> impl Iterator<Item = &Module> {
        self.files.keys()
    }

    /// Modules that one imports from, or whose methods it calls, itself left out.
    pub fn targets(&self, module: &[String]) -> &BTreeSet<Module> {
        &self.targets[module]
    }

    /// Modules that import one another in a circle, a list each.
    pub fn circles(&self) -> Vec<Vec<Module>> {
        let reached = all_reached(&self.targets);
        let mut circles: Vec<Vec<Module>> = Vec::new();
        for module in self.files.keys().filter(|module| reached[*module].contains(*module)) {
            let own = |other: &&Module| {
                reached[module].contains(*other) && reached[*other].contains(module)
            };
            let circle: Vec<Module> = self.files.keys().filter(own).cloned().collect();
            if !circles.contains(&circle) {
                circles.push(circle);
            }
        }
        circles
    }
}

/// All modules that each reaches by imports of imports.
fn all_reached(targets: &BTreeMap<Module, BTreeSet<Module>>) -> BTreeMap<Module, BTreeSet<Module>> {
    let of = |module: &Module| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![module]);
        while let Some(next) = open.pop() {
            open.extend(targets[next].iter().filter(|target| seen.insert((*target).clone())));
        }
        seen
    };
    targets.keys().map(|module| (module.clone(), of(module))).collect()
}

/// The name by which a crate may import itself; the manifest lies beside its sources.
fn own_name(source: &Path) -> String {
    let manifest = source.parent().map(|folder| folder.join("Cargo.toml")).unwrap_or_default();
    let manifest = std::fs::read_to_string(manifest).unwrap_or_default();
    let name = manifest.lines().find_map(|line| line.strip_prefix("name = "));
    name.unwrap_or_default().trim_matches('"').replace('-', "_")
}

/// What is compiled outside of tests, without comments.
fn code(text: &str) -> String {
    let mut kept = String::new();
    let mut skipped: Option<usize> = None; // indent of a test item
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        if let Some(depth) = skipped {
            let ends =
                indent == depth && (line.trim_start().starts_with('}') || line.ends_with(';'));
            if ends {
                skipped = None;
            }
            continue;
        }
        if line.trim() == "#[cfg(test)]" {
            skipped = Some(indent);
            continue;
        }
        kept.push_str(line.split("//").next().unwrap_or_default());
        kept.push('\n');
    }
    kept
}

/// Whether a letter may stand in a name.
fn in_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}
