//! The report as one page.

use super::wording::{chapters, verdict, words};
use crate::claim::Outcome;
use crate::record::{Chart, Measured};
use slideline::output::plot;
use slideline::output::report::{STYLE, escaped};
use std::fmt::Write as _;

const OWN_STYLE: &str = include_str!("style.css");

/// The whole page; a String takes any text, here and below.
pub(super) fn page(outcomes: &[Outcome]) -> String {
    let good = outcomes.iter().all(Outcome::holds);
    let mut text = String::with_capacity(1 << 20);
    let _ = write!(
        text,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
         style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>Verification report - slideline</title>\n<style>\n{STYLE}{OWN_STYLE}</style>\n\
         </head>\n<body>\n<h1>Verification report</h1>\n\
         <p class=\"verdict {}\"><strong>{}</strong> Slideline {}.</p>\n\
         <p>Every claim states what is required, where the requirement or the reference comes \
         from, and why its limits are what they are. The values were measured by the tests \
         themselves. The bar beside a value is the part of the limit that it uses.</p>\n",
        if good { "good" } else { "bad" },
        escaped(&verdict(outcomes)),
        slideline::VERSION,
    );
    contents(&mut text, outcomes);
    for chapter in chapters(outcomes) {
        let title = chapter.first().map_or("", |outcome| outcome.chapter);
        let _ = writeln!(text, "<section>\n<h2>{}</h2>", escaped(title));
        for outcome in chapter {
            article(&mut text, outcome);
        }
        text.push_str("</section>\n");
    }
    text.push_str("</body>\n</html>\n");
    text
}

fn contents(text: &mut String, outcomes: &[Outcome]) {
    text.push_str("<table class=\"contents\">\n");
    for chapter in chapters(outcomes) {
        let title = chapter.first().map_or("", |outcome| outcome.chapter);
        let holding = chapter.iter().filter(|outcome| outcome.holds()).count();
        let _ = writeln!(
            text,
            "<tr class=\"chapter\"><td>{}</td><td colspan=\"2\">{holding} of {}</td></tr>",
            escaped(title),
            chapter.len()
        );
        for outcome in chapter {
            let tightest = outcome.record.measured().iter().filter_map(Measured::used);
            let tightest = tightest.fold(None, |most: Option<f64>, used| {
                Some(most.map_or(used, |most| most.max(used)))
            });
            let _ = writeln!(
                text,
                "<tr><td><a href=\"#{}\">{}</a></td><td>{}</td><td class=\"used\">{}</td></tr>",
                escaped(&outcome.id()),
                escaped(&words(outcome)),
                badge(outcome.holds()),
                tightest.map_or_else(String::new, bar),
            );
        }
    }
    text.push_str("</table>\n");
}

fn badge(holds: bool) -> &'static str {
    if holds { "<span class=\"yes\">holds</span>" } else { "<span class=\"no\">fails</span>" }
}

/// The part of a limit that is used, as a bar and in words.
fn bar(used: f64) -> String {
    let percent = 100.0 * used;
    let said = match percent {
        p if p < 0.1 => "&lt; 0.1".to_owned(),
        p if p < 1.0 => format!("{p:.1}"),
        p => format!("{p:.0}"),
    };
    format!("<i style=\"width:{:.2}rem\"></i>{said} %", 0.05 * percent.min(110.0))
}

fn article(text: &mut String, outcome: &Outcome) {
    let claim = &outcome.claim;
    let _ = write!(
        text,
        "<article id=\"{}\"{}>\n<h3>{} {}</h3>\n<p>{}</p>\n<dl><dt>source</dt><dd>{}</dd>\
         <dt>tolerance</dt><dd>{}</dd><dt>test</dt><dd><code>{}</code></dd></dl>\n",
        escaped(&outcome.id()),
        if outcome.holds() { "" } else { " class=\"bad\"" },
        escaped(&words(outcome)),
        badge(outcome.holds()),
        escaped(claim.requirement),
        escaped(claim.source),
        escaped(claim.tolerance),
        escaped(&outcome.id()),
    );
    if let Some(reason) = &outcome.broken {
        let _ = writeln!(text, "<div class=\"said error\"><p>{}</p></div>", escaped(reason));
    }
    values(text, outcome.record.measured());
    for chart in outcome.record.charts() {
        figure(text, chart);
    }
    text.push_str("</article>\n");
}

fn values(text: &mut String, measured: &[Measured]) {
    if measured.is_empty() {
        return;
    }
    text.push_str(
        "<table>\n<tr><th>measured</th><th>value</th><th>required</th><th></th><th></th></tr>\n",
    );
    for one in measured {
        let said = if one.required().is_empty() { "" } else { badge(one.holds()) };
        let _ = writeln!(
            text,
            "<tr><td>{}</td><td class=\"value\">{}</td><td class=\"value\">{}</td>\
             <td class=\"used\">{}</td><td>{said}</td></tr>",
            escaped(&one.quantity),
            one.found(),
            one.required(),
            one.used().map_or_else(String::new, bar),
        );
    }
    text.push_str("</table>\n");
}

fn figure(text: &mut String, chart: &Chart) {
    let svg = plot::chart(chart.title.as_str(), &chart.panels).inline();
    let _ = writeln!(
        text,
        "<figure><figcaption>{}</figcaption>\n{svg}</figure>",
        escaped(&chart.title)
    );
}
