//! Paths that a file names: from the root, from itself or its parents, from a module below, from
//! the crate by its own name, and from modules that it has brought into scope.

use super::{Module, in_name};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The code of a crate, file by file, and the name by which it may call itself.
pub struct Paths<'a> {
    pub code: &'a BTreeMap<Module, String>,
    pub own_name: String,
}

/// A path of a tree such as `a::{b as c, d::*}`.
struct Named {
    path: Vec<String>,
    /// The name that it gets, `*` for all that is in it.
    alias: Option<String>,
}

impl Paths<'_> {
    /// Modules that one names, itself left out.
    pub fn targets(&self, module: &Module) -> BTreeSet<Module> {
        let code = &self.code[module];
        let inline = inline_modules(code);
        let mut scope: BTreeMap<String, Module> = BTreeMap::new();
        let mut found = BTreeSet::new();
        // what is brought into scope may stand behind what uses it
        for _ in 0..2 {
            for (at, _) in code.match_indices("::") {
                let Some(first) = word_before(code, at) else { continue };
                let Some(base) = self.base(module, (first, at), &inline, &scope) else { continue };
                let mut named = Vec::new();
                expand(&code[at + 2..], &[], &mut named);
                let brings = is_use(code, at - first.len());
                for own in named {
                    let (target, whole) = self.resolve(module, base.clone(), &own.path);
                    if brings && whole {
                        self.bring(&target, &own, &mut scope);
                    }
                    found.insert(target);
                }
            }
        }
        found.remove(module);
        found
    }

    /// Where a path begins, of which the first word is known.
    fn base(
        &self,
        module: &Module,
        (first, at): (&str, usize),
        inline: &[(String, Range<usize>)],
        scope: &BTreeMap<String, Module>,
    ) -> Option<Module> {
        let here = || {
            let around = inline.iter().filter(|(_, range)| range.contains(&at));
            module.iter().cloned().chain(around.map(|(name, _)| name.clone())).collect::<Module>()
        };
        match first {
            "crate" => Some(Module::new()),
            name if name == self.own_name => Some(Module::new()),
            "self" => Some(here()),
            "super" => Some(here().split_last()?.1.to_vec()),
            name => {
                let below = [module, &[name.to_owned()][..]].concat();
                let declared = self.code[module].contains(&format!("mod {name};"));
                if declared && self.code.contains_key(&below) {
                    return Some(below);
                }
                scope.get(name).cloned()
            }
        }
    }

    /// The last module on a path, and whether the path ends there.
    fn resolve(&self, file: &Module, mut module: Module, path: &[String]) -> (Module, bool) {
        for (place, part) in path.iter().enumerate() {
            if part == "super" {
                module.pop();
                continue;
            }
            if part == "self" {
                continue;
            }
            self.leave_inline(file, &mut module);
            module.push(part.clone());
            if !self.code.contains_key(&module) {
                module.pop();
                return (module, place == path.len());
            }
        }
        self.leave_inline(file, &mut module);
        (module, true)
    }

    /// A module that is written within a file is that file.
    fn leave_inline(&self, file: &Module, module: &mut Module) {
        if !self.code.contains_key(module) {
            module.truncate(file.len());
        }
    }

    /// Takes note of modules that a `use` brings into scope.
    fn bring(&self, target: &Module, own: &Named, scope: &mut BTreeMap<String, Module>) {
        match own.alias.as_deref() {
            Some("*") => {
                let below =
                    |other: &&Module| other.len() == target.len() + 1 && other.starts_with(target);
                for module in self.code.keys().filter(below) {
                    scope.extend(module.last().map(|name| (name.clone(), module.clone())));
                }
            }
            Some(alias) => {
                scope.insert(alias.to_owned(), target.clone());
            }
            None => {
                scope.extend(target.last().map(|name| (name.clone(), target.clone())));
            }
        }
    }
}

/// Modules written within a file, each with the range of its code.
fn inline_modules(code: &str) -> Vec<(String, Range<usize>)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("mod ") {
        let name: String = code[at + 4..].chars().take_while(|&letter| in_name(letter)).collect();
        let behind = at + 4 + name.len();
        let is_word = !code[..at].ends_with(in_name);
        if name.is_empty() || !is_word || !code[behind..].trim_start().starts_with('{') {
            continue;
        }
        let mut depth = 0;
        let end = code[behind..].char_indices().find_map(|(place, letter)| {
            depth += match letter {
                '{' => 1,
                '}' => -1,
                _ => 0,
            };
            (letter == '}' && depth == 0).then_some(behind + place)
        });
        found.push((name, at..end.unwrap_or(code.len())));
    }
    found
}

/// The first word of a path: the word before `::`, unless that follows another.
fn word_before(code: &str, at: usize) -> Option<&str> {
    let before = &code[..at];
    let start = before.rfind(|letter| !in_name(letter)).map_or(0, |place| place + 1);
    let word = &before[start..];
    let follows = before[..start].ends_with("::");
    let of_macro = before[..start].ends_with('$') && word != "crate";
    (!word.is_empty() && !follows && !of_macro).then_some(word)
}

/// Whether the path that begins there is that of a `use`.
fn is_use(code: &str, start: usize) -> bool {
    code[..start].trim_end().ends_with("use") && code[..start].ends_with(' ')
}

/// All paths of a tree such as `a::{b, c::{self, D}}`.
fn expand(tree: &str, before: &[String], into: &mut Vec<Named>) {
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
    let end = tree.find(|letter| !in_name(letter)).unwrap_or(tree.len());
    let mut path = before.to_vec();
    if end > 0 {
        path.push(tree[..end].to_owned());
    }
    let rest = tree[end..].trim_start();
    match rest.strip_prefix("::") {
        Some(rest) => expand(rest, &path, into),
        None => {
            let alias = rest.strip_prefix("as ").map(|rest| {
                rest.trim_start().chars().take_while(|&letter| in_name(letter)).collect()
            });
            let all = (end == 0 && rest.starts_with('*')).then(|| "*".to_owned());
            into.push(Named { path, alias: alias.or(all) });
        }
    }
}
