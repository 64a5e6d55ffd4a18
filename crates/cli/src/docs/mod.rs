//! `slideline docs`: the documentation as a folder of pages that need no
//! network.
//!
//! ```text
//!   docs/*.md, docs/guide/*.md  --+
//!   pages of the keywords       --+--> page::html --> DIR/*.html, keywords/, errors/
//!   pages of the codes          --+
//! ```

mod page;

use crate::exit::Exit;
use crate::screen;
use clap::{Args, ValueHint};
use page::Page;
use slideline::keywords::keywords;
use slideline::output::{WriteError, write_file};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// `slideline docs`.
#[derive(Args, Debug)]
pub(crate) struct DocsArguments {
    /// Folder of the pages, made if missing.
    #[arg(long, value_name = "DIR", default_value = "site", value_hint = ValueHint::DirPath)]
    out: PathBuf,
}

/// Pages that stand in the repository, in the order of the menu.
const WRITTEN: &[(&str, &str)] = &[
    ("index", include_str!("../../../../docs/guide/index.md")),
    ("getting-started", include_str!("../../../../docs/guide/getting-started.md")),
    ("snap-fit", include_str!("../../../../docs/guide/snap-fit.md")),
    ("field/index", include_str!("../../../../docs/field/index.md")),
    ("field/hook", include_str!("../../../../docs/field/hook.md")),
    ("field/hook_in_space", include_str!("../../../../docs/field/hook_in_space.md")),
    ("field/annular", include_str!("../../../../docs/field/annular.md")),
    ("field/rail_clip", include_str!("../../../../docs/field/rail_clip.md")),
    ("field/cam_latch", include_str!("../../../../docs/field/cam_latch.md")),
    ("field/o_ring", include_str!("../../../../docs/field/o_ring.md")),
    ("field/door_seal", include_str!("../../../../docs/field/door_seal.md")),
    ("field/press_fit", include_str!("../../../../docs/field/press_fit.md")),
    ("field/battery_contact", include_str!("../../../../docs/field/battery_contact.md")),
    ("paper", include_str!("../../../../docs/guide/paper.md")),
    ("limits-of-use", include_str!("../../../../docs/limits-of-use.md")),
    ("ccx", include_str!("../../../../docs/ccx.md")),
    ("meshes", include_str!("../../../../docs/meshes.md")),
    ("files", include_str!("../../../../docs/files.md")),
    ("workbench", include_str!("../../../../docs/workbench.md")),
    ("sensitivities", include_str!("../../../../docs/sensitivities.md")),
    ("report", include_str!("../../../../docs/report.md")),
    ("restart", include_str!("../../../../docs/restart.md")),
    ("studies", include_str!("../../../../docs/studies.md")),
    ("python", include_str!("../../../../docs/python.md")),
    ("optimisers", include_str!("../../../../docs/optimisers.md")),
    ("shown-studies", include_str!("../../../../docs/shown-studies.md")),
    ("scaling", include_str!("../../../../docs/scaling.md")),
    ("cluster", include_str!("../../../../docs/cluster.md")),
    ("reproduce", include_str!("../../../../docs/reproduce.md")),
    ("verification", include_str!("../../../../docs/verification.md")),
    ("user-friction", include_str!("../../../../docs/user-friction.md")),
    ("theory", include_str!("../../../../docs/theory.md")),
];

const IMAGES: &[(&str, &[u8])] = &[
    ("images/methods.png", include_bytes!("../../../../docs/images/methods.png")),
    ("images/workbench.png", include_bytes!("../../../../docs/images/workbench.png")),
    ("images/friction-dropped.png", include_bytes!("../../../../docs/images/friction-dropped.png")),
    ("images/field/hook.png", include_bytes!("../../../../docs/images/field/hook.png")),
    (
        "images/field/hook_in_space.png",
        include_bytes!("../../../../docs/images/field/hook_in_space.png"),
    ),
    ("images/field/annular.png", include_bytes!("../../../../docs/images/field/annular.png")),
    ("images/field/rail_clip.png", include_bytes!("../../../../docs/images/field/rail_clip.png")),
    ("images/field/cam_latch.png", include_bytes!("../../../../docs/images/field/cam_latch.png")),
    ("images/field/o_ring.png", include_bytes!("../../../../docs/images/field/o_ring.png")),
    ("images/field/door_seal.png", include_bytes!("../../../../docs/images/field/door_seal.png")),
    ("images/field/press_fit.png", include_bytes!("../../../../docs/images/field/press_fit.png")),
    (
        "images/field/battery_contact.png",
        include_bytes!("../../../../docs/images/field/battery_contact.png"),
    ),
    (
        "images/studies/tolerances.png",
        include_bytes!("../../../../docs/images/studies/tolerances.png"),
    ),
    (
        "images/studies/snap_fit_map.png",
        include_bytes!("../../../../docs/images/studies/snap_fit_map.png"),
    ),
];

/// Writes the pages.
pub(crate) fn docs(arguments: &DocsArguments) -> Exit {
    let pages = pages();
    match write(&arguments.out, &pages) {
        Ok(()) => {
            let index = arguments.out.join("index.html");
            screen::print(&format!("{} pages; begin with {}\n", pages.len(), index.display()));
            Exit::Completed
        }
        Err(error) => {
            screen::error(&format!("error[SL0702]: the pages could not be written: {error}\n"));
            Exit::Output
        }
    }
}

fn write(folder: &Path, pages: &[Page]) -> Result<(), WriteError> {
    let save = |name: &str, content: &[u8]| {
        let path = folder.join(name);
        let parent = path.parent().unwrap_or(folder);
        std::fs::create_dir_all(parent)
            .map_err(|reason| WriteError { path: parent.to_owned(), reason })?;
        write_file(&path, content)
    };
    for (name, content) in IMAGES {
        save(name, content)?;
    }
    for page in pages {
        save(&format!("{}.html", page.path), page::html(page).as_bytes())?;
    }
    Ok(())
}

/// Every page of the site.
fn pages() -> Vec<Page> {
    let written = WRITTEN.iter();
    let mut pages: Vec<Page> = written
        .map(|(path, text)| Page { path: (*path).to_owned(), text: (*text).to_owned() })
        .collect();
    let mut list = "# Keywords\n\n| keyword | |\n|---|---|\n".to_owned();
    let mut described: Vec<_> = keywords().collect();
    described.sort_by_key(|keyword| keyword.name);
    for keyword in described {
        let file = keyword.name.replace(' ', "-");
        let says = first_sentence(keyword.page);
        let _ = writeln!(list, "| [*{}]({file}.md) | {says} |", keyword.name); // a String takes any text
        pages.push(Page { path: format!("keywords/{file}"), text: keyword.page.to_owned() });
    }
    pages.push(Page { path: "keywords/index".to_owned(), text: list });
    let mut list = "# Errors, warnings and notes\n\n| code | |\n|---|---|\n".to_owned();
    for (code, text) in slideline::CODE_PAGES {
        let title = text.lines().next().unwrap_or_default();
        let says = title.split_once(": ").map_or("", |(_, says)| says);
        let _ = writeln!(list, "| [{code}]({code}.md) | {says} |"); // a String takes any text
        pages.push(Page { path: format!("errors/{code}"), text: (*text).to_owned() });
    }
    pages.push(Page { path: "errors/index".to_owned(), text: list });
    pages
}

/// What stands below the title, up to the first full stop.
fn first_sentence(page: &str) -> String {
    let body = page.lines().skip(1).find(|line| !line.is_empty()).unwrap_or_default();
    body.split_once(". ").map_or(body, |(sentence, _)| sentence).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Requirement: a link within the site leads to a page or picture of it.
    #[test]
    fn links_lead_to_pages() {
        let pages = pages();
        let names: BTreeSet<String> = pages
            .iter()
            .map(|page| format!("{}.html", page.path))
            .chain(IMAGES.iter().map(|(name, _)| (*name).to_owned()))
            .collect();
        for page in &pages {
            let html = page::html(page);
            let folder = page.path.rsplit_once('/').map_or("", |(folder, _)| folder);
            for target in html.split("href=\"").chain(html.split("src=\"")).skip(1) {
                let target = target.split('"').next().unwrap_or_default();
                if !target.ends_with(".html") && !target.ends_with(".png") {
                    continue;
                }
                if target.starts_with("http") {
                    continue;
                }
                let whole = match target.strip_prefix("../") {
                    Some(above) => above.to_owned(),
                    None if folder.is_empty() => target.to_owned(),
                    None => format!("{folder}/{target}"),
                };
                assert!(names.contains(&whole), "{} links to {target}", page.path);
            }
        }
    }

    /// Requirement: every equation becomes MathML; none is left as TeX.
    #[test]
    fn every_equation_is_set() {
        for page in pages() {
            let html = page::html(&page);
            assert!(!html.contains("class=\"tex\""), "{} has TeX left", page.path);
            assert!(!html.contains("<merror"), "{} has an error in MathML", page.path);
        }
        let theory = pages().into_iter().find(|page| page.path == "theory").unwrap();
        assert_eq!(
            page::html(&theory).matches("class=\"number\"").count(),
            theory.text.matches("\\tag{").count()
        );
    }
}
