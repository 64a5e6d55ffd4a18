//! Vectors handed to NumPy without copies; nobody may write into them.

use numpy::ndarray::{ArrayD, IxDyn};
use numpy::{Element, PyArray1, PyArrayDyn, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The vector as an array of one dimension that cannot be written.
pub(crate) fn line<T: Element>(py: Python<'_>, values: Vec<T>) -> PyResult<Py<PyArray1<T>>> {
    let array = PyArray1::from_vec(py, values);
    locked(py, array.as_any())?;
    Ok(array.unbind())
}

/// The vector as an array of this shape, the last index fastest, that cannot be written.
pub(crate) fn shaped<T: Element>(
    py: Python<'_>,
    shape: &[usize],
    values: Vec<T>,
) -> PyResult<Py<PyArrayDyn<T>>> {
    let array = ArrayD::from_shape_vec(IxDyn(shape), values)
        .map_err(|reason| PyValueError::new_err(reason.to_string()))?;
    let array = PyArrayDyn::from_owned_array(py, array);
    locked(py, array.as_any())?;
    Ok(array.unbind())
}

/// The values of an array of one or more dimensions, the last index fastest.
pub(crate) fn values(given: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<f64>> {
    let py = given.py();
    let double = PyDict::new(py);
    double.set_item("dtype", "float64")?;
    let array = py.import("numpy")?.call_method("ascontiguousarray", (given,), Some(&double))?;
    let array: Bound<'_, PyArrayDyn<f64>> = array.cast_into().map_err(PyErr::from)?;
    array.to_vec().map_err(|_| PyValueError::new_err(format!("{what} is no array of numbers")))
}

fn locked(py: Python<'_>, array: &Bound<'_, PyAny>) -> PyResult<()> {
    let never = PyDict::new(py);
    never.set_item("write", false)?;
    array.call_method("setflags", (), Some(&never)).map(drop)
}
