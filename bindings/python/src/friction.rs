//! Friction laws that are functions of Python, called for all closed points of an interaction at a
//! time.

use crate::arrays::{shaped, values};
use pyo3::exceptions::{PyArithmeticError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use slideline::UserFrictions;
use slideline::friction::{FrictionBatch, Status, Tangential, TangentialMap};
use slideline::friction::{Traction, UserFriction, UserFrictionError};
use std::sync::{Arc, Mutex, PoisonError};

/// What laws raised that they should not; the first one counts.
#[derive(Default)]
pub(crate) struct Failures(Mutex<Option<PyErr>>);

impl Failures {
    fn keep(&self, raised: PyErr) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(raised);
    }

    pub fn any(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    pub fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// The registry of laws by their names.
pub(crate) fn frictions(
    laws: &Bound<'_, PyDict>,
    failures: &Arc<Failures>,
) -> PyResult<UserFrictions> {
    let mut found = UserFrictions::default();
    for (name, law) in laws.iter() {
        if !law.is_callable() {
            return Err(PyTypeError::new_err(format!("the friction law {name} is no function")));
        }
        let law = PythonLaw { law: law.unbind(), failures: failures.clone() };
        found.register(&name.extract::<String>()?, Arc::new(law));
    }
    Ok(found)
}

struct PythonLaw {
    law: Py<PyAny>,
    failures: Arc<Failures>,
}

impl UserFriction for PythonLaw {
    fn update(&self, batch: &mut FrictionBatch<'_>) -> Result<(), UserFrictionError> {
        let refused = |py: Python<'_>, raised: PyErr| {
            let message = raised.value(py).to_string();
            // no answer here asks for a smaller increment, all else is a fault of the law
            if !raised.is_instance_of::<PyArithmeticError>(py) {
                self.failures.keep(raised);
            }
            UserFrictionError { message }
        };
        Python::attach(|py| self.answer(py, batch).map_err(|raised| refused(py, raised)))
    }
}

impl PythonLaw {
    fn answer(&self, py: Python<'_>, batch: &mut FrictionBatch<'_>) -> PyResult<()> {
        let said = self.law.bind(py).call((), Some(&question(py, batch)?))?;
        let said = said
            .cast_into::<PyDict>()
            .map_err(|_| PyTypeError::new_err("a friction law returns a dict"))?;
        let count = batch.points.len();
        let part = |name: &str, each: usize| part(&said, name, count, each);
        let traction = part("traction", 2)?;
        let by_slip = part("d_traction_d_slip", 4)?;
        let by_pressure = part("d_traction_d_pressure", 2)?;
        let elastic = part("elastic_slip", 2)?;
        let dissipated = part("dissipated_slip", 1)?;
        let slips = part("slips", 1)?;
        let pair = |list: &[f64], k: usize| Tangential([list[2 * k], list[2 * k + 1]]);
        for (k, own) in batch.tractions.iter_mut().enumerate() {
            let [a, b, c, d] = [0, 1, 2, 3].map(|place| by_slip[4 * k + place]);
            *own = Traction {
                tau: pair(&traction, k),
                d_tau_d_slip: TangentialMap([[a, b], [c, d]]),
                d_tau_d_pressure: pair(&by_pressure, k),
                elastic_slip: pair(&elastic, k),
                dissipated_slip: dissipated[k],
                status: if slips[k] == 0.0 { Status::Stick } else { Status::Slip },
            };
        }
        let each = batch.state.len() / count.max(1);
        if each > 0 {
            batch.state.copy_from_slice(&part("state", each)?);
        }
        Ok(())
    }
}

/// What a law is asked, by the names of its arguments.
fn question<'py>(py: Python<'py>, batch: &FrictionBatch<'_>) -> PyResult<Bound<'py, PyDict>> {
    let (points, count) = (batch.points, batch.points.len());
    let each = batch.committed.len() / count.max(1);
    let question = PyDict::new(py);
    let pressure = points.iter().map(|point| point.pressure).collect();
    question.set_item("pressure", shaped(py, &[count], pressure)?)?;
    let slip = points.iter().flat_map(|point| point.slip.0).collect();
    question.set_item("slip", shaped(py, &[count, 2], slip)?)?;
    let elastic = points.iter().flat_map(|point| point.elastic_slip.0).collect();
    question.set_item("elastic_slip", shaped(py, &[count, 2], elastic)?)?;
    question.set_item("state", shaped(py, &[count, each], batch.committed.to_vec())?)?;
    let properties = batch.properties.to_vec();
    question.set_item("properties", shaped(py, &[properties.len()], properties)?)?;
    question.set_item("time", batch.time)?;
    question.set_item("dt", batch.dt)?;
    Ok(question)
}

/// A part of the answer: so many finite numbers a point.
fn part(said: &Bound<'_, PyDict>, name: &str, count: usize, each: usize) -> PyResult<Vec<f64>> {
    let given = said.get_item(name)?.ok_or_else(|| {
        PyValueError::new_err(format!("the answer of the friction law has no `{name}`"))
    })?;
    let found = values(&given, name)?;
    if found.len() != count * each {
        let message = format!(
            "`{name}` of the friction law has {} numbers instead of {each} for each of {count} points",
            found.len()
        );
        return Err(PyValueError::new_err(message));
    }
    if found.iter().any(|value| !value.is_finite()) {
        let message = format!("`{name}` of the friction law is not finite");
        return Err(PyArithmeticError::new_err(message));
    }
    Ok(found)
}
