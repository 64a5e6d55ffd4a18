//! Takes the pages of `docs/errors` into the program.

use std::fmt::Write as _;
use std::path::Path;

fn main() -> std::io::Result<()> {
    // asked when it runs: a script may have been compiled in another checkout
    let crate_folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    let folder = Path::new(&crate_folder).join("../../docs/errors");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut codes = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let path = entry?.path();
        let code = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default().to_owned();
        if code.starts_with("SL") && path.extension().is_some_and(|ending| ending == "md") {
            codes.push((code, path.canonicalize()?));
        }
    }
    codes.sort();
    let mut table = "&[\n".to_owned();
    for (code, path) in codes {
        let _ = writeln!(table, "    ({code:?}, include_str!({path:?})),");
    }
    table.push(']');
    let out = std::env::var_os("OUT_DIR").unwrap_or_default();
    std::fs::write(Path::new(&out).join("pages.rs"), table)
}
