//! The page as one file, with everything that it needs inside.

use base64::{Engine as _, engine::general_purpose::STANDARD};
use slideline::output::report::DRAWING;

/// Files of the page: name and content.
const ASSETS: &[(&str, &[u8])] = &[
    ("aim.js", include_bytes!("../page/aim.js")),
    ("band.js", include_bytes!("../page/band.js")),
    ("connection.js", include_bytes!("../page/connection.js")),
    ("curve.js", include_bytes!("../page/curve.js")),
    ("deck.js", include_bytes!("../page/deck.js")),
    ("figures.js", include_bytes!("../page/figures.js")),
    ("history.js", include_bytes!("../page/history.js")),
    ("index.html", include_bytes!("../page/index.html")),
    ("live.js", include_bytes!("../page/live.js")),
    ("main.js", include_bytes!("../page/main.js")),
    ("page.css", include_bytes!("../page/page.css")),
    ("parameters.js", include_bytes!("../page/parameters.js")),
    ("pins.js", include_bytes!("../page/pins.js")),
    ("plot.js", include_bytes!("../page/plot.js")),
    ("run.js", include_bytes!("../page/run.js")),
    ("save.js", include_bytes!("../page/save.js")),
    ("solver.js", include_bytes!("../page/solver.js")),
    ("start.js", include_bytes!("../page/start.js")),
    ("state.js", include_bytes!("../page/state.js")),
    ("words.js", include_bytes!("../page/words.js")),
    ("worker.js", include_bytes!("../page/worker.js")),
];

/// The content of a file of the page, and its kind.
pub fn asset(name: &str) -> Option<(&'static [u8], &'static str)> {
    let report = name.strip_prefix("report/");
    let drawing = report.and_then(|name| DRAWING.iter().find(|(own, _)| *own == name));
    let own = ASSETS.iter().find(|(own, _)| *own == name).map(|(_, content)| *content);
    let content = drawing.map(|(_, text)| text.as_bytes()).or(own)?;
    let kind = match name.rsplit('.').next().unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "svg" => "image/svg+xml",
        _ => "application/octet-stream",
    };
    Some((content, kind))
}

/// To be written.
pub fn single_page(wasm: &[u8], _deck: Option<(&str, &str)>) -> String {
    STANDARD.encode(wasm)
}
