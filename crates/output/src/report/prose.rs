//! The pages of codes as HTML: headings, paragraphs, code, bold.

use slideline_figures::escaped;

/// A page in the few marks that the pages use, as HTML.
pub(crate) fn html(page: &str) -> String {
    let mut text = String::new();
    let mut paragraph: Vec<&str> = Vec::new();
    let mut code: Option<Vec<&str>> = None;
    for line in page.lines().chain([""]) {
        if line.starts_with("```") {
            flush(&mut text, &mut paragraph);
            match code.take() {
                Some(lines) => {
                    text.push_str(&format!("<pre>{}</pre>", escaped(&lines.join("\n"))));
                }
                None => code = Some(Vec::new()),
            }
        } else if let Some(lines) = &mut code {
            lines.push(line);
        } else if let Some(title) = line.strip_prefix("# ") {
            flush(&mut text, &mut paragraph);
            text.push_str(&format!("<h4>{}</h4>", inline(title)));
        } else if line.trim().is_empty() {
            flush(&mut text, &mut paragraph);
        } else {
            paragraph.push(line);
        }
    }
    text
}

fn flush(text: &mut String, paragraph: &mut Vec<&str>) {
    if !paragraph.is_empty() {
        text.push_str(&format!("<p>{}</p>", inline(&paragraph.join(" "))));
        paragraph.clear();
    }
}

/// `code`, **bold** and *slanted*; a mark without a partner is a letter.
fn inline(text: &str) -> String {
    let mut out = String::new();
    for (place, part) in text.split('`').enumerate() {
        if place % 2 == 1 {
            out.push_str(&format!("<code>{}</code>", escaped(part)));
        } else {
            out.push_str(&paired(&paired(&escaped(part), "**", "b"), "*", "i"));
        }
    }
    out
}

fn paired(text: &str, mark: &str, tag: &str) -> String {
    let parts: Vec<&str> = text.split(mark).collect();
    if parts.len().is_multiple_of(2) {
        return text.to_owned();
    }
    let wrap = |(place, part): (usize, &&str)| match place % 2 {
        1 => format!("<{tag}>{part}</{tag}>"),
        _ => (*part).to_owned(),
    };
    parts.iter().enumerate().map(wrap).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_become_tags_and_nothing_else_does() {
        let page =
            "# SL1: a <b>\n\n**What.** Of `*NODE` & *so*\non.\n\n```\n*CARD, <x>\n\n1\n```\n";
        assert_eq!(
            html(page),
            "<h4>SL1: a &lt;b&gt;</h4><p><b>What.</b> Of <code>*NODE</code> &amp; <i>so</i> on.</p>\
             <pre>*CARD, &lt;x&gt;\n\n1</pre>"
        );
    }
}
