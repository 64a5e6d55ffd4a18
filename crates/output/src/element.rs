//! `JOB.element.csv` and `JOB.beam.csv`: results of the solids and beams that `*EL FILE` or
//! `*ELEMENT OUTPUT` name, of every increment that they want.
//!
//! ```text
//!   deck with          JOB.element.csv               JOB.beam.csv
//!   beams              a row a beam                  -
//!   solids             a row an integration point    -
//!   both               a row an integration point    a row a beam
//! ```

use crate::rows::{Rows, Sheet};
use crate::section::{axial_stresses, beams, most_points, outer_mises, space_beams};
use slideline_model::{
    Dialect, ElementPrint, ElementType, ElementVariable, Model, PrintTarget, types,
};
use slideline_results::element::{Quantity, solids};
use slideline_solve::observe::{Frame, StepReport};

const SOLIDS: &str = ".element.csv";
const BEAMS: &str = ".beam.csv";

/// The requests for result files of all steps.
fn asked(model: &Model) -> impl Iterator<Item = &ElementPrint> {
    let prints = model.steps.iter().flat_map(|step| &step.output.element_prints);
    prints.filter(|print| print.request.target.is_file() && print.request.frequency > 0)
}

/// The requests that are due in an increment.
fn due<'a>(frame: &Frame<'a>) -> Vec<&'a ElementPrint> {
    let (increment, last) = (frame.increment, frame.last_of_step);
    let step = frame.model.steps.get(frame.step.wrapping_sub(1)).into_iter();
    let prints = step.flat_map(|step| &step.output.element_prints);
    prints.filter(|print| print.request.is_due(PrintTarget::is_file, increment, last)).collect()
}

fn is_named(prints: &[&ElementPrint], label: u64) -> bool {
    prints.iter().any(|print| print.elements.binary_search(&label).is_ok())
}

/// Types of a model that have rows of integration points.
fn solid_types(model: &Model) -> impl Iterator<Item = &'static ElementType> {
    let types = model.blocks.iter().map(|block| block.kind).filter(|kind| !kind.is_beam());
    types.filter(|kind| !Quantity::Mises.components(kind, Dialect::Abaqus).is_empty())
}

/// Rows of beams.
#[derive(Default)]
pub(crate) struct Beams {
    /// Whether the deck has solids too.
    beside_solids: bool,
    /// Whether its beams stand in space.
    in_space: bool,
    /// The most points of their sections.
    points: usize,
}

impl Rows for Beams {
    fn ending(&self) -> &'static str {
        if self.beside_solids { BEAMS } else { SOLIDS }
    }

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        let has = |is: fn(&ElementType) -> bool| {
            let mut blocks = report.model.blocks.iter();
            blocks.any(|block| is(block.kind) && !block.elements.is_empty())
        };
        let has_beams = has(ElementType::is_beam);
        self.in_space = has(ElementType::is_space_beam) && !has_beams;
        self.beside_solids = solid_types(report.model).next().is_some();
        let wanted = (has_beams || self.in_space) && asked(report.model).next().is_some();
        if self.in_space {
            let fields = types::B31.fields.iter().flat_map(|field| field.components);
            self.points = most_points(report.model);
            let stresses = (1..=self.points).map(|point| format!("S11_{point}"));
            let names = fields.map(|name| (*name).to_owned()).chain(stresses);
            return wanted.then(|| names.fold("element".to_owned(), |all, name| all + "," + &name));
        }
        let columns = "element,SF1,SF2,SM1,SE1,SE2,SK1,S11_1,S11_2,S11_3,S11_4,S11_5,MISES";
        wanted.then(|| columns.to_owned())
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        let due = due(frame);
        if self.in_space {
            for beam in space_beams(frame).filter(|beam| is_named(&due, beam.element.label)) {
                // what a section of fewer points than another one has not is zero
                let mut stresses = beam.stresses();
                stresses.resize(self.points, 0.0);
                sheet.row().cell(beam.element.label);
                sheet.numbers(beam.values.iter().copied()).numbers(stresses).end();
            }
            return;
        }
        for (row, _, section) in beams(frame).filter(|(row, ..)| is_named(&due, row.label)) {
            let stresses = axial_stresses([row.axial_force, row.bending_moment], section);
            sheet.row().cell(row.label);
            sheet.numbers([row.axial_force, row.shear_force, row.bending_moment]);
            sheet.numbers(row.strains).numbers(stresses);
            sheet.numbers([outer_mises(&stresses)]).end();
        }
    }
}

/// Columns that are there in any case; what a plane element has not is zero.
const ALWAYS: [&str; 8] = ["S11", "S22", "S33", "S12", "S13", "S23", "MISES", "PEEQ"];

/// Rows of integration points.
#[derive(Default)]
pub(crate) struct Solids {
    /// What else a deck asks for, with the names of its columns.
    more: Vec<(Quantity, Vec<&'static str>)>,
}

impl Rows for Solids {
    fn ending(&self) -> &'static str {
        SOLIDS
    }

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        let types: Vec<&ElementType> = solid_types(report.model).collect();
        let always = |variable: &ElementVariable| {
            matches!(variable, ElementVariable::S | ElementVariable::MISES | ElementVariable::PEEQ)
        };
        let variables = asked(report.model).flat_map(|print| &print.variables);
        for &variable in variables.filter(|variable| !always(variable)) {
            let Some(quantity) = Quantity::of(variable) else { continue };
            let of = |kind: &&ElementType| quantity.components(kind, report.model.dialect);
            let widest = types.iter().map(of).max_by_key(|names| names.len()).unwrap_or_default();
            let known = self.more.iter().any(|(own, _)| *own == quantity);
            if !known && !widest.is_empty() {
                self.more.push((quantity, widest.to_vec()));
            }
        }
        let wanted = !types.is_empty() && asked(report.model).next().is_some();
        let more = self.more.iter().flat_map(|(_, names)| names).copied();
        let names: Vec<&str> = ALWAYS.into_iter().chain(more).collect();
        wanted.then(|| format!("element,point,{}", names.join(",")))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        let (due, mut values) = (due(frame), Vec::new());
        for solid in solids(frame).filter(|solid| is_named(&due, solid.element.label)) {
            for point in 0..solid.points() {
                values.clear();
                values.extend(solid.stress(point));
                solid.push(Quantity::Mises, point, &mut values);
                solid.push(Quantity::Field("PEEQ"), point, &mut values);
                let mut width = ALWAYS.len();
                for (quantity, names) in &self.more {
                    values.resize(width, 0.0);
                    solid.push(*quantity, point, &mut values);
                    width += names.len();
                }
                values.resize(width, 0.0);
                sheet.row().cell(solid.element.label).cell(point + 1);
                sheet.numbers(values.iter().copied()).end();
            }
        }
    }
}
