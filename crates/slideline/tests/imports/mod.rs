//! Which file of a crate imports which: read from the sources, as text.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Files of a crate by the paths of their modules, and what each imports.
pub struct Imports {
    /// Module paths such as `["contact", "pair"]`; the root is empty.
    files: BTreeMap<Vec<String>, PathBuf>,
    code: BTreeMap<Vec<String>, String>,
}

impl Imports {
    /// Reads the sources below a folder.
    pub fn of(source: &Path) -> Self {
        let mut all = Vec::new();
        super::collect(source, &mut all);
        let mut files = BTreeMap::new();
        for path in all {
            let inside = path.strip_prefix(source).unwrap().with_extension("");
            let mut module: Vec<String> =
                inside.iter().map(|part| part.to_str().unwrap().to_owned()).collect();
            if ["mod", "lib", "main"].contains(&module.last().unwrap().as_str()) {
                module.pop();
            }
            files.insert(module, path);
        }
        let code = files.iter().map(|(module, path)| (module.clone(), code(&super::read(path))));
        Self { code: code.collect(), files }
    }

    /// The file of a module.
    pub fn file(&self, module: &[String]) -> &Path {
        &self.files[module]
    }

    /// Modules with a file of their own.
    pub fn modules(&self) -> impl Iterator<Item = &Vec<String>> {
        self.files.keys()
    }

    /// Modules that one imports from, itself left out.
    pub fn targets(&self, module: &[String]) -> BTreeSet<Vec<String>> {
        let code = &self.code[module];
        let mut found = BTreeSet::new();
        for (at, _) in code.match_indices("::") {
            let Some(first) = word_before(code, at) else { continue };
            let base = match first {
                "crate" => Vec::new(),
                "self" => module.to_vec(),
                "super" => module[..module.len().saturating_sub(1)].to_vec(),
                // a module below this one
                name => {
                    let child = [module, &[name.to_owned()]].concat();
                    if !self.files.contains_key(&child) || !code.contains(&format!("mod {name};")) {
                        continue;
                    }
                    child
                }
            };
            let mut paths = Vec::new();
            expand(&code[at + 2..], &[], &mut paths);
            for path in paths {
                found.insert(self.resolve(base.clone(), &path));
            }
        }
        found.remove(module);
        found
    }

    /// The last module on a path.
    fn resolve(&self, mut module: Vec<String>, path: &[String]) -> Vec<String> {
        for part in path {
            if part == "super" {
                module.pop();
                continue;
            }
            let below = [&module[..], std::slice::from_ref(part)].concat();
            if !self.files.contains_key(&below) {
                break;
            }
            module = below;
        }
        module
    }

    /// Modules that import one another in a circle, a list each.
    pub fn circles(&self) -> Vec<Vec<Vec<String>>> {
        let mut reached: BTreeMap<&Vec<String>, BTreeSet<Vec<String>>> = BTreeMap::new();
        for module in self.files.keys() {
            let (mut seen, mut open) = (BTreeSet::new(), vec![module.clone()]);
            while let Some(next) = open.pop() {
                for target in self.targets(&next) {
                    if seen.insert(target.clone()) {
                        open.push(target);
                    }
                }
            }
            reached.insert(module, seen);
        }
        let mut circles: Vec<Vec<Vec<String>>> = Vec::new();
        for module in self.files.keys().filter(|module| reached[module].contains(*module)) {
            let own = |other: &&Vec<String>| {
                reached[module].contains(*other) && reached[*other].contains(module)
            };
            let circle: Vec<Vec<String>> = self.files.keys().filter(own).cloned().collect();
            if !circles.contains(&circle) {
                circles.push(circle);
            }
        }
        circles
    }
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

/// The first word of a path: the word before `::`, unless that follows another.
fn word_before(code: &str, at: usize) -> Option<&str> {
    let before = &code[..at];
    let start = before.rfind(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(0, |k| k + 1);
    let follows = before[..start].ends_with("::") || before[..start].ends_with('$');
    (start < at && !follows).then(|| &before[start..])
}

/// All paths of a tree such as `a::{b, c::{self, D}}`.
fn expand(tree: &str, before: &[String], into: &mut Vec<Vec<String>>) {
    let tree = tree.trim_start();
    if let Some(inner) = tree.strip_prefix('{') {
        let mut depth = 0;
        let mut start = 0;
        for (at, letter) in inner.char_indices() {
            match letter {
                '{' => depth += 1,
                ',' if depth == 0 => {
                    expand(&inner[start..at], before, into);
                    start = at + 1;
                }
                '}' if depth == 0 => {
                    expand(&inner[start..at], before, into);
                    return;
                }
                '}' => depth -= 1,
                _ => {}
            }
        }
        return;
    }
    let end = tree.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(tree.len());
    let mut path = before.to_vec();
    if end > 0 {
        path.push(tree[..end].to_owned());
    }
    match tree[end..].strip_prefix("::") {
        Some(rest) => expand(rest, &path, into),
        None => into.push(path),
    }
}
