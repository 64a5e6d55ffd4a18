//! The page as one file, with everything that it needs inside.

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderStringWriter;
use flate2::{Compression, GzBuilder};
use serde_json::json;
use slideline::output::json::text;
use slideline::output::report::DRAWING;
use std::io::{self, Write as _};

/// Files of the page: name and content.
const ASSETS: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// Nothing is loaded from anywhere; the solver is WebAssembly in a worker of the page's own.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; \
                      worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:";

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
        "txt" | "md" | "LICENSE" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    };
    Some((content, kind))
}

/// The page as one file: styles and scripts in place of their names, the solver as WebAssembly, and
/// the deck that it opens (name and text), if one.
///
/// # Errors
/// Where the solver cannot be compressed; nothing is known that would do that.
pub fn single_page(wasm: &[u8], deck: Option<(&str, &str)>) -> io::Result<String> {
    let opened = deck.map(|(name, text)| json!({"name": name, "text": text}));
    let carried = format!(
        "<script type=\"application/json\" id=\"opened\">{}</script>\n\
         <script type=\"text/plain\" id=\"module\">{}</script>\n",
        text(&opened).replace('<', "\\u003c"),
        packed(wasm)?
    );
    let policy = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">");
    let mut page = String::with_capacity(carried.len() + (1 << 18));
    let mut carried = Some(carried);
    for line in words("index.html").lines() {
        if let Some(name) = named(line, "<script src=\"", "\"></script>") {
            page.extend(carried.take());
            // a text that ends the script within it would end it on the page
            let script = words(name).replace("</script", "<\\/script");
            page.extend(["<script>\n", &script, "</script>\n"]);
        } else if let Some(name) = named(line, "<link rel=\"stylesheet\" href=\"", "\">") {
            page.extend(["<style>\n", &words(name).replace("</style", "<\\/style"), "</style>\n"]);
        } else {
            page.extend([line, "\n"]);
        }
        if line.trim_start().starts_with("<meta charset") {
            page.extend([&policy, "\n"]);
        }
    }
    Ok(page)
}

/// A module as the page unpacks it: gzip in base64. The same bytes come from the same module.
fn packed(wasm: &[u8]) -> io::Result<String> {
    let mut packing =
        GzBuilder::new().write(EncoderStringWriter::new(&STANDARD), Compression::best());
    packing.write_all(wasm)?;
    Ok(packing.finish()?.into_inner())
}

/// What a line names between two texts.
fn named<'a>(line: &'a str, before: &str, behind: &str) -> Option<&'a str> {
    line.trim().strip_prefix(before)?.strip_suffix(behind)
}

fn words(name: &str) -> String {
    asset(name).map_or_else(String::new, |(own, _)| String::from_utf8_lossy(own).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use base64::Engine as _;
    use std::io::Read as _;

    /// Requirement: every file that the page names is inside, nothing is named that would have to be
    /// loaded, and neither the deck nor a script ends the script that it stands in.
    #[test]
    fn everything_is_inside() {
        let index = words("index.html");
        let names = index.lines().filter_map(|line| {
            let script = named(line, "<script src=\"", "\"></script>");
            script.or_else(|| named(line, "<link rel=\"stylesheet\" href=\"", "\">"))
        });
        let names: Vec<&str> = names.collect();
        assert!(names.contains(&"page.css") && names.contains(&"connection.js"), "{names:?}");
        for name in &names {
            assert!(asset(name).is_some(), "{name} is named and not there");
        }
        let page = single_page(b"\0asm", Some(("a.inp", "*HEADING\n</script><b>\"\\\n"))).unwrap();
        assert!(!page.contains("<script src") && !page.contains("rel=\"stylesheet\""));
        assert_eq!(page.matches("<script").count(), page.matches("</script>").count());
        let (_, behind) = page.split_once("id=\"opened\">").unwrap();
        let (deck, _) = behind.split_once("</script>").unwrap();
        let deck: serde_json::Value = serde_json::from_str(deck).unwrap();
        assert_eq!(deck["text"], "*HEADING\n</script><b>\"\\\n");
        let empty = single_page(b"", None).unwrap();
        assert!(empty.contains("id=\"opened\">null</script>"));
    }

    /// Requirement: the module in the page is that which was given, and takes less room there than its
    /// own bytes where these repeat.
    #[test]
    fn the_module_is_packed() {
        let wasm: Vec<u8> = (0..40_000_u32).map(|k| (k / 7 % 251) as u8).collect();
        let page = single_page(&wasm, None).unwrap();
        let (_, behind) = page.split_once("id=\"module\">").unwrap();
        let (module, _) = behind.split_once("</script>").unwrap();
        assert!(module.len() < wasm.len() / 4, "{}", module.len());
        let mut own = Vec::new();
        let packed = STANDARD.decode(module).unwrap();
        flate2::read::GzDecoder::new(&*packed).read_to_end(&mut own).unwrap();
        assert!(own == wasm);
    }

    #[test]
    fn only_files_of_the_page_have_names() {
        for name in ["../Cargo.toml", "/etc/passwd", "page/index.html", "", "vendor/../index.html"]
        {
            assert!(asset(name).is_none(), "{name}");
        }
        assert!(asset("report/shape.js").is_some() && asset("index.html").is_some());
    }
}
