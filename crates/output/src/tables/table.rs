//! A table on its way to the file: rows of numbers under a title, with sums and extremes below;
//! and the solids that a request names.

use crate::number::{push_padded, push_scientific};
use slideline_model::{ElementPrint, Request, Totals};
use slideline_results::element::{Solid, solids};
use slideline_solve::observe::Frame;
use std::fmt::Write as _;

/// A table on its way to the file.
pub(super) struct Table {
    /// What stands above the places, such as `NODE`.
    pub(super) head: String,
    pub(super) names: Vec<&'static str>,
    pub(super) rows: Vec<Row>,
}

pub(super) struct Row {
    /// What stands before the values, as wide as the table's head.
    pub(super) head: String,
    /// Number of the node or element.
    pub(super) label: u64,
    pub(super) values: Vec<f64>,
    /// What of them is summed, where not the values themselves.
    pub(super) summed: Option<Vec<f64>>,
}

impl Table {
    /// Appends it under its title, then what the request wants below.
    pub(super) fn push(
        &self,
        text: &mut String,
        frame: &Frame<'_>,
        (what, request): (&str, &Request),
    ) {
        let set = &request.set;
        let of = if set.is_empty() { String::new() } else { format!(" {set}") };
        // A String takes any text.
        let _ = writeln!(
            text,
            "\nSTEP {}  INCREMENT {}  TOTAL TIME {}  {what}{of}",
            frame.step, frame.increment, frame.total_time
        );
        push_cells(text, &self.head, self.names.iter());
        if request.totals != Totals::Only {
            for row in &self.rows {
                push_values(text, &row.head, &row.values);
            }
        }
        let columns = 0..self.names.len();
        if request.totals != Totals::No {
            let own = |row: &Row, column: usize| row.summed.as_ref().unwrap_or(&row.values)[column];
            let sum = |column| self.rows.iter().map(|row| own(row, column)).sum();
            let sums: Vec<f64> = columns.clone().map(sum).collect();
            push_values(text, &self.below("TOTAL"), &sums);
        }
        if request.summary && !self.rows.is_empty() {
            self.push_extreme(text, "MAXIMUM", |value, most| value > most);
            self.push_extreme(text, "MINIMUM", |value, least| value < least);
        }
    }

    /// A row of extremes, and below it where they are: the first of equals.
    fn push_extreme(&self, text: &mut String, what: &str, beyond: fn(f64, f64) -> bool) {
        let mut extremes: Vec<(f64, u64)> = Vec::new();
        for row in &self.rows {
            for (column, &value) in row.values.iter().enumerate() {
                match extremes.get_mut(column) {
                    Some(extreme) if beyond(value, extreme.0) => *extreme = (value, row.label),
                    Some(_) => {}
                    None => extremes.push((value, row.label)),
                }
            }
        }
        let (values, labels): (Vec<f64>, Vec<u64>) = extremes.into_iter().unzip();
        push_values(text, &self.below(what), &values);
        push_cells(text, &self.below("AT"), labels.iter());
    }

    fn below(&self, what: &str) -> String {
        format!("{what:>width$}", width = self.head.chars().count())
    }
}

fn push_cells(text: &mut String, head: &str, cells: impl Iterator<Item = impl std::fmt::Display>) {
    text.push_str(head);
    for cell in cells {
        let _ = write!(text, " {cell:>15}"); // a String takes any text
    }
    text.push('\n');
}

fn push_values(text: &mut String, head: &str, values: &[f64]) {
    text.push_str(head);
    for &value in values {
        text.push(' ');
        let begin = text.len();
        push_scientific(text, value, 7);
        push_padded(text, begin, 15);
    }
    text.push('\n');
}

/// What stands above or before the values of an element, with its point where it has several.
pub(super) fn head(element: &str, point: Option<&str>) -> String {
    match point {
        Some(point) => format!("{element:>10} {point:>5}"),
        None => format!("{element:>10}"),
    }
}

/// Title of a table of elements.
pub(super) fn title(print: &ElementPrint, all: &'static str) -> &'static str {
    if print.request.set.is_empty() { all } else { "ELEMENTS" }
}

/// The solids with stresses that a request names.
pub(super) fn named<'a>(
    frame: &'a Frame<'a>,
    print: &'a ElementPrint,
) -> impl Iterator<Item = Solid<'a>> {
    let is_named = |solid: &Solid<'_>| print.elements.binary_search(&solid.element.label).is_ok();
    solids(frame).filter(move |solid| solid.points() > 0 && is_named(solid))
}
