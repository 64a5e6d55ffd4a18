//! Curves in a frame, and their difference in a second one below.

use super::curve::{Curve, Question, difference};
use slideline_figures::{Axis, CURVES, Mark, Panel, Scene, Series, chart};

/// Draws a curve, or two over each other with the difference below.
pub fn figure(question: &Question, one: &Curve, other: Option<&Curve>) -> Scene {
    let title = match other {
        Some(other) => {
            format!("{} against {}: {} and {}", question.y, question.x, one.name, other.name)
        }
        None => format!("{} against {}: {}", question.y, question.x, one.name),
    };
    let panel = |title: &str, height, series| Panel {
        x: Axis::linear(question.x.as_str()),
        y: Axis::linear(title),
        height,
        series,
    };
    let mut shown = vec![series(&one.name, [&one.x, &one.y], Mark::Curve, 0)];
    shown.extend(other.map(|other| series(&other.name, [&other.x, &other.y], Mark::Dashed, 1)));
    let mut panels = vec![panel(&question.y, 350.0, shown)];
    if let Some(other) = other {
        let rest = series("", [&one.x, &difference(one, other)], Mark::Curve, 2);
        panels.push(panel("difference", 170.0, vec![rest]));
    }
    chart(title, &panels)
}

/// Draws curves of several jobs over each other.
pub fn curves(question: &Question, all: &[Curve]) -> Scene {
    let own = |(place, own): (usize, &Curve)| {
        // behind the last colour they begin again, dashed
        let mark =
            if (place / CURVES.len()).is_multiple_of(2) { Mark::Curve } else { Mark::Dashed };
        series(&own.name, [&own.x, &own.y], mark, place)
    };
    let panel = Panel {
        x: Axis::linear(question.x.as_str()),
        y: Axis::linear(question.y.as_str()),
        height: 350.0,
        series: all.iter().enumerate().map(own).collect(),
    };
    chart(format!("{} against {}", question.y, question.x), &[panel])
}

fn series(name: &str, [x, y]: [&[f64]; 2], mark: Mark, colour: usize) -> Series {
    let points = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
    Series { name: name.to_owned(), points, mark, colour }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_escape_names_and_survive_curves_without_extent() {
        let question = Question { x: "U2".into(), y: "RF2".into(), node: None, unfinished: false };
        let name = "</title><script>\u{44f}".to_owned();
        let flat = Curve { name, times: vec![0.0, 1.0], x: vec![0.0; 2], y: vec![f64::NAN, 0.0] };
        let figure = figure(&question, &flat, Some(&flat));
        let svg = figure.svg();
        assert!(!svg.contains("<script>") && svg.contains("&lt;script&gt;\u{44f}"), "{svg}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        let png = figure.png(192.0).unwrap();
        assert_eq!(&png[1..4], b"PNG");
    }
}
