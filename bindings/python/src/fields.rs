//! Fields on elements.

use crate::arrays::{line, shaped};
use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;
use slideline::Model;
use slideline::model::Location;
use slideline::observe::BlockResults;

/// A field of the elements of one type and section in one state.
#[pyclass(frozen, get_all, module = "slideline")]
pub(crate) struct ElementField {
    /// Name, such as `S`.
    name: &'static str,
    /// Element type, such as `CPE4`.
    element_type: &'static str,
    /// Names of the components, such as `S11`.
    components: Vec<&'static str>,
    /// Unit tag, such as `[F/L2]`.
    unit: &'static str,
    /// `centroid`, `points` or `nodes`.
    location: &'static str,
    /// Labels of the elements, (elements,).
    labels: Py<PyArray1<i64>>,
    /// Values, (elements, places, components).
    values: Py<PyArrayDyn<f64>>,
}

#[pymethods]
impl ElementField {
    fn __repr__(&self) -> String {
        let components = self.components.join(", ");
        format!("<ElementField {} of {}: {components}>", self.name, self.element_type)
    }
}

/// Names of the fields that elements of a model offer.
pub(crate) fn names(model: &Model) -> Vec<&'static str> {
    let mut names = Vec::new();
    for field in model.blocks.iter().flat_map(|block| block.kind.fields) {
        if !names.contains(&field.name) {
            names.push(field.name);
        }
    }
    names
}

/// A field by its name, block by block.
pub(crate) fn of(
    py: Python<'_>,
    model: &Model,
    results: &[BlockResults],
    name: &str,
) -> PyResult<Vec<ElementField>> {
    let mut found = Vec::new();
    for results in results {
        let Some(block) = model.blocks.get(results.block) else { continue };
        let Some((field, first)) = block.kind.field(name) else { continue };
        let (width, components) = (block.kind.values(field), field.components);
        let (mut labels, mut values) = (Vec::new(), Vec::new());
        for (element, own) in results.elements(model) {
            labels.push(element.label.cast_signed());
            values.extend_from_slice(&own[first..first + width]);
        }
        let shape = [labels.len(), width / components.len().max(1), components.len()];
        found.push(ElementField {
            name: field.name,
            element_type: block.kind.name(),
            components: components.to_vec(),
            unit: field.unit,
            location: match field.location {
                Location::Centroid => "centroid",
                Location::Points => "points",
                Location::Nodes => "nodes",
            },
            labels: line(py, labels)?,
            values: shaped(py, &shape, values)?,
        });
    }
    Ok(found)
}
