//! Tables of solids and trusses: a row an integration point; what an element has once, a row an element.
//! Elements whose columns are not the same have tables of their own.

use super::calculix;
use super::table::{Row, Table, head, named, title};
use slideline_model::{Dialect, ElementPrint, ElementVariable};
use slideline_results::element::Quantity;
use slideline_solve::observe::Frame;

/// How many solids a request names.
pub(super) fn count(frame: &Frame<'_>, print: &ElementPrint) -> usize {
    named(frame, print).count()
}

/// The tables of a request with their titles; those that CalculiX prints stand in `text` already.
pub(super) fn tables(
    text: &mut String,
    frame: &Frame<'_>,
    print: &ElementPrint,
) -> Vec<(&'static str, Table)> {
    let as_calculix = frame.model.dialect == Dialect::Calculix;
    if as_calculix {
        calculix::push_elements(text, frame, print);
    }
    let own = |variable: &&ElementVariable| !(as_calculix && calculix::has_element(**variable));
    let variables = || print.variables.iter().copied().filter(|variable| own(&variable));
    let (whole, at_points): (Vec<_>, Vec<_>) = variables().partition(|own| own.is_of_the_whole());
    let mut tables = tables_of(frame, print, (&at_points, true));
    tables.extend(tables_of(frame, print, (&whole, false)));
    tables
}

fn tables_of(
    frame: &Frame<'_>,
    print: &ElementPrint,
    (variables, pointed): (&[ElementVariable], bool),
) -> Vec<(&'static str, Table)> {
    let mut tables: Vec<(&'static str, Table)> = Vec::new();
    let quantities: Vec<Quantity> =
        variables.iter().filter_map(|&variable| Quantity::of(variable)).collect();
    for solid in named(frame, print) {
        let of = |quantity: &Quantity| {
            quantity.components(solid.block.kind, frame.model.dialect).iter().copied()
        };
        let names: Vec<&'static str> = quantities.iter().flat_map(of).collect();
        if names.is_empty() {
            continue;
        }
        let all = match solid.block.kind.is_truss() {
            true => "ELEMENTS all trusses",
            false => "ELEMENTS all solids",
        };
        let what = title(print, all);
        let mut each = tables.iter();
        let known = each.position(|(own, table)| *own == what && table.names == names);
        let known = known.unwrap_or_else(|| {
            let head = head("ELEMENT", pointed.then_some("POINT"));
            let table = Table { head, names: names.clone(), rows: Vec::new() };
            tables.push((what, table));
            tables.len() - 1
        });
        for point in 0..if pointed { solid.points() } else { 1 } {
            let mut values = Vec::with_capacity(names.len());
            quantities.iter().for_each(|quantity| solid.push(*quantity, point, &mut values));
            let label = solid.element.label;
            let shown = (point + 1).to_string();
            let head = head(&label.to_string(), pointed.then_some(shown.as_str()));
            tables[known].1.rows.push(Row { head, label, values, summed: None });
        }
    }
    tables
}
