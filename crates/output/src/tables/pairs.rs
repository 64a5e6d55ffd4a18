//! What whole contact pairs carry: a row a pair, or as CalculiX prints it.
//!
//! ```text
//!   PAIR             CFNM   CFN1 ...       statistics for slave set S, master set M and time ...
//!   S/M              ...                     total surface force (fx,fy,fz) and moment ...
//! ```

use super::calculix::push_numbers;
use super::table::{Row, Table};
use crate::fortran::push_fortran;
use slideline_model::{ContactPair, ContactPrint, ContactVariable, Dialect, Totals};
use slideline_solve::observe::{Frame, PairRow, Resultant};
use std::fmt::Write as _;

/// What a request wants of whole pairs.
pub(super) fn push(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    let as_calculix = frame.model.dialect == Dialect::Calculix;
    let mut own = Vec::new();
    for &variable in print.variables.iter().filter(|variable| !variable.is_of_points()) {
        match (as_calculix, resultant(variable)) {
            (true, Some(of)) if has_statistics(variable) => push_statistics(text, frame, print, of),
            (true, _) if variable == ContactVariable::CELS => push_energy(text, frame, print),
            (true, _) if variable == ContactVariable::CNUM => push_count(text, frame, print),
            _ => own.push(variable),
        }
    }
    if !own.is_empty() {
        push_table(text, frame, (print, &own));
    }
}

/// The pairs of a request with what they carry.
fn rows<'a>(
    frame: &Frame<'a>,
    print: &'a ContactPrint,
) -> impl Iterator<Item = (&'a ContactPair, &'a PairRow)> {
    let all = frame.model.contact_pairs.iter().zip(frame.pairs);
    all.filter(|(pair, _)| print.wants(pair))
}

/// A sum of forces on the slaves of a pair.
type Sum = fn(&PairRow) -> Resultant;

/// The sum of which a variable is the force or the moment.
fn resultant(variable: ContactVariable) -> Option<Sum> {
    use ContactVariable as V;
    match variable {
        V::CFN | V::CMN => Some(|row| row.of_pressure),
        V::CFS | V::CMS => Some(|row| row.of_friction),
        V::CFT | V::CMT => Some(|row| Resultant { force: row.force, moment: row.moment }),
        _ => None,
    }
}

/// Whether CalculiX prints that.
fn has_statistics(variable: ContactVariable) -> bool {
    matches!(variable, ContactVariable::CFN | ContactVariable::CFS | ContactVariable::CFT)
}

/// The table of pairs of Abaqus' variables.
fn push_table(
    text: &mut String,
    frame: &Frame<'_>,
    (print, variables): (&ContactPrint, &[ContactVariable]),
) {
    let in_space = frame.model.is_in_space();
    let row = |(pair, row): (&ContactPair, &PairRow)| {
        let values = variables.iter().flat_map(|&variable| {
            let columns = columns(variable, in_space).len();
            let mut values = values(row, variable);
            match (is_moment(variable), columns) {
                (true, 1) => values = vec![values[3]],
                _ => values.truncate(columns),
            }
            values
        });
        Row { head: format!("{:<16}", pair.name), label: 0, values: values.collect(), summed: None }
    };
    let table = Table {
        head: format!("{:<16}", "PAIR"),
        names: variables.iter().flat_map(|&own| columns(own, in_space)).copied().collect(),
        rows: rows(frame, print).map(row).collect(),
    };
    // sums over pairs stand on demand only, and extremes of sums mean nothing
    let mut request = print.request.clone();
    (request.summary, request.set) = (false, String::new());
    if request.totals == Totals::Only {
        request.totals = Totals::No;
    }
    table.push(text, frame, ("CONTACT PAIRS", &request));
}

fn is_moment(variable: ContactVariable) -> bool {
    matches!(variable, ContactVariable::CMN | ContactVariable::CMS | ContactVariable::CMT)
}

/// Columns of a variable: size and components, in the plane those that it has.
fn columns(variable: ContactVariable, in_space: bool) -> &'static [&'static str] {
    use ContactVariable as V;
    let (of_plane, of_space): (&[_], &[_]) = match variable {
        V::CFN => (&["CFNM", "CFN1", "CFN2"], &["CFNM", "CFN1", "CFN2", "CFN3"]),
        V::CFS => (&["CFSM", "CFS1", "CFS2"], &["CFSM", "CFS1", "CFS2", "CFS3"]),
        V::CFT => (&["CFTM", "CFT1", "CFT2"], &["CFTM", "CFT1", "CFT2", "CFT3"]),
        V::CMN => (&["CMN3"], &["CMNM", "CMN1", "CMN2", "CMN3"]),
        V::CMS => (&["CMS3"], &["CMSM", "CMS1", "CMS2", "CMS3"]),
        V::CMT => (&["CMT3"], &["CMTM", "CMT1", "CMT2", "CMT3"]),
        V::CAREA => (&["CAREA"], &["CAREA"]),
        V::CELS => (&["CELS"], &["CELS"]),
        V::CNUM => (&["CNUM"], &["CNUM"]),
        V::CSTRESS | V::CDISP | V::CFORCE => (&[], &[]),
    };
    if in_space { of_space } else { of_plane }
}

/// Size and three components of a force or a moment, or the one value that there is.
fn values(row: &PairRow, variable: ContactVariable) -> Vec<f64> {
    match (resultant(variable), variable) {
        (Some(of), _) => {
            let sum = of(row);
            let vector = if is_moment(variable) { sum.moment } else { sum.force };
            std::iter::once(size(vector)).chain(vector).collect()
        }
        (None, ContactVariable::CAREA) => vec![row.area],
        (None, ContactVariable::CNUM) => vec![row.closed as f64],
        (None, _) => vec![row.energy],
    }
}

fn size(vector: [f64; 3]) -> f64 {
    vector[0].hypot(vector[1]).hypot(vector[2])
}

/// CalculiX' block of a pair; measured with ccx 2.20 (docs/keywords/CONTACT-PRINT.md). The slave
/// looks outward against the normal of its master. A String takes any text.
fn push_statistics(text: &mut String, frame: &Frame<'_>, print: &ContactPrint, of: Sum) {
    for (pair, row) in rows(frame, print) {
        let sum = of(row);
        let (slave, master) = pair.name.split_once('/').unwrap_or((&pair.name, &pair.name));
        let mut time = String::new();
        push_fortran(&mut time, frame.total_time, 7);
        let _ = writeln!(
            text,
            "\n\n statistics for slave set {slave}, master set {master} and time {time}"
        );
        let mut part = |title: &str, values: &[f64]| {
            let _ = write!(text, "\n   {title}\n\n  ");
            push_numbers(text, values.iter().copied());
        };
        let whole = size(row.mean_normal);
        let outward = row.mean_normal.map(|own| if whole > 0.0 { 0.0 - own / whole } else { 0.0 });
        let along: f64 = sum.force.iter().zip(outward).map(|(force, own)| force * own).sum();
        let shear: [f64; 3] = std::array::from_fn(|k| sum.force[k] - along * outward[k]);
        part(
            "total surface force (fx,fy,fz) and moment about the origin (mx,my,mz)",
            &[sum.force, sum.moment].concat(),
        );
        part("center of gravity and mean normal", &[row.centre, outward].concat());
        part("moment about the center of gravity(mx,my,mz)", &sum.moment_about(row.centre));
        part(
            "area,  normal force (+ = tension) and shear force (size)",
            &[row.area, along, size(shear)],
        );
    }
}

/// CalculiX' total energy of contact.
fn push_energy(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    push_time(text, "total contact spring energy", frame);
    text.push_str("      ");
    push_numbers(text, [rows(frame, print).map(|(_, row)| row.energy).sum()]);
}

/// CalculiX' number of closed points.
fn push_count(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    push_time(text, "total number of contact elements", frame);
    let count: usize = rows(frame, print).map(|(_, row)| row.closed).sum();
    let _ = writeln!(text, "{count:>17}"); // a String takes any text
}

fn push_time(text: &mut String, what: &str, frame: &Frame<'_>) {
    let mut time = String::new();
    push_fortran(&mut time, frame.total_time, 7);
    let _ = writeln!(text, "\n {what} for time {time}\n"); // a String takes any text
}
