//! Tables: named columns, for NumPy without copies, for all others by the Arrow PyCapsule interface.

use crate::arrays::line;
use arrow_array::StringArray;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, RecordBatchIterator};
use arrow_schema::ffi::FFI_ArrowSchema;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict};
use slideline::Model;
use slideline::observe::ContactRow;
use slideline::output::contact_columns;
use std::sync::Arc;

/// Values of a column that is to be.
pub(crate) enum Values {
    Real(Vec<f64>),
    Whole(Vec<i64>),
    Word(Vec<Option<String>>),
}

enum Column {
    Real(Py<PyArray1<f64>>),
    Whole(Py<PyArray1<i64>>),
    Word(Vec<Option<String>>),
}

/// Named columns of equal length. Columns of numbers are NumPy arrays that are not copied; the
/// whole is an Arrow stream for whoever reads one (pandas, polars, pyarrow, DuckDB).
#[pyclass(frozen, module = "slideline")]
pub(crate) struct Table {
    names: Vec<String>,
    columns: Vec<Column>,
    rows: usize,
}

impl Table {
    pub fn new(py: Python<'_>, given: Vec<(String, Values)>) -> PyResult<Self> {
        let (mut names, mut columns, mut rows) = (Vec::new(), Vec::new(), 0);
        for (name, values) in given {
            names.push(name);
            let (column, length) = match values {
                Values::Real(values) => {
                    let length = values.len();
                    (Column::Real(line(py, values)?), length)
                }
                Values::Whole(values) => {
                    let length = values.len();
                    (Column::Whole(line(py, values)?), length)
                }
                Values::Word(values) => {
                    let length = values.len();
                    (Column::Word(values), length)
                }
            };
            columns.push(column);
            rows = length;
        }
        Ok(Self { names, columns, rows })
    }

    /// Contact points before anything moves.
    pub fn of_gaps(py: Python<'_>, model: &Model, points: &[ContactRow]) -> PyResult<Self> {
        let pairs = points.iter().map(|row| Some(model.contact_pairs[row.pair].name.clone()));
        let labels = points.iter().map(|row| model.nodes.label(row.node).cast_signed());
        let mut columns = vec![
            ("pair".to_owned(), Values::Word(pairs.collect())),
            ("node".to_owned(), Values::Whole(labels.collect())),
        ];
        for own in contact_columns(model.is_in_space()).concat() {
            let values = points.iter().map(|row| (own.value)(row)).collect();
            columns.push((own.name.to_owned(), Values::Real(values)));
        }
        Self::new(py, columns)
    }

    fn schema(&self) -> Schema {
        let field = |(name, column): (&String, &Column)| match column {
            Column::Real(_) => Field::new(name, DataType::Float64, false),
            Column::Whole(_) => Field::new(name, DataType::Int64, false),
            Column::Word(_) => Field::new(name, DataType::Utf8, true),
        };
        Schema::new(self.names.iter().zip(&self.columns).map(field).collect::<Vec<_>>())
    }

    fn batch(&self, py: Python<'_>) -> PyResult<RecordBatch> {
        let refused = |what: String| PyValueError::new_err(what);
        let mut arrays: Vec<ArrayRef> = Vec::with_capacity(self.columns.len());
        for column in &self.columns {
            arrays.push(match column {
                Column::Real(own) => {
                    let values = own.bind(py).to_vec().map_err(|why| refused(why.to_string()))?;
                    Arc::new(Float64Array::from(values))
                }
                Column::Whole(own) => {
                    let values = own.bind(py).to_vec().map_err(|why| refused(why.to_string()))?;
                    Arc::new(Int64Array::from(values))
                }
                Column::Word(own) => Arc::new(StringArray::from_iter(own)),
            });
        }
        RecordBatch::try_new(Arc::new(self.schema()), arrays).map_err(|why| arrow(&why))
    }
}

fn arrow(why: &ArrowError) -> PyErr {
    PyValueError::new_err(why.to_string())
}

#[pymethods]
impl Table {
    /// Names of the columns, in their order.
    #[getter]
    fn columns(&self) -> Vec<String> {
        self.names.clone()
    }

    fn __len__(&self) -> usize {
        self.rows
    }

    /// A column: an array of numbers, or a list of words.
    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        let place = self.names.iter().position(|own| own == name).ok_or_else(|| {
            PyKeyError::new_err(format!("{name}; there are {}", self.names.join(", ")))
        })?;
        Ok(match &self.columns[place] {
            Column::Real(own) => own.clone_ref(py).into_any(),
            Column::Whole(own) => own.clone_ref(py).into_any(),
            Column::Word(own) => own.clone().into_pyobject(py)?.unbind(),
        })
    }

    /// The columns by their names.
    fn to_dict(&self, py: Python<'_>) -> PyResult<Py<PyDict>> {
        let found = PyDict::new(py);
        for name in &self.names {
            found.set_item(name, self.__getitem__(py, name)?)?;
        }
        Ok(found.unbind())
    }

    /// A pandas.DataFrame (extra `pandas`).
    fn to_pandas(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let frame = py.import("pandas")?.getattr("DataFrame")?;
        Ok(frame.call1((self.to_dict(py)?,))?.unbind())
    }

    /// A polars.DataFrame (extra `polars`).
    fn to_polars(own: &Bound<'_, Self>) -> PyResult<Py<PyAny>> {
        let frame = own.py().import("polars")?.getattr("DataFrame")?;
        Ok(frame.call1((own,))?.unbind())
    }

    /// The Arrow schema as a capsule.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(&self.schema()).map_err(|why| arrow(&why))?;
        PyCapsule::new_with_value(py, schema, c"arrow_schema")
    }

    /// The rows as a capsule with an Arrow stream. Another schema that is asked for is not looked
    /// at, as the interface allows.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        drop(requested_schema);
        let batch = self.batch(py)?;
        let schema = batch.schema();
        let batches = RecordBatchIterator::new([Ok(batch)], schema);
        let stream = FFI_ArrowArrayStream::new(Box::new(batches));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    fn __repr__(&self) -> String {
        format!("<Table of {} rows: {}>", self.rows, self.names.join(", "))
    }
}
