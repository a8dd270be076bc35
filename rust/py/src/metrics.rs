//! Bindings of `metrics`.

use glam::DVec3;
use nearfar_core::base::{Error, Result};
use nearfar_core::metrics::{self, Neighbourhood, Similarity, Window};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::run;

/// Mean of squared differences.
#[pyfunction]
fn mean_squared_error(
    py: Python<'_>,
    reference: PyReadonlyArray1<'_, f64>,
    test: PyReadonlyArray1<'_, f64>,
) -> PyResult<f64> {
    let (reference, test) = (reference.as_slice()?, test.as_slice()?);
    run::short(py, || metrics::mean_squared_error(reference, test))
}

fn window(name: &str, size: usize, sigma: f64) -> Result<Window> {
    match name {
        "gaussian" => Ok(Window::gaussian(size, sigma)),
        "uniform" => Ok(Window::uniform(size)),
        "global" => Ok(Window::Global),
        _ => Err(Error::value("window", "'gaussian', 'uniform' or 'global'", format!("'{name}'"))),
    }
}

/// Structural similarity around each pixel of one channel, flat; `constants` are c1 and c2.
#[pyfunction]
#[pyo3(signature = (reference, test, *, width, window, size, sigma, constants))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
fn similarity<'py>(
    py: Python<'py>,
    reference: PyReadonlyArray1<'py, f64>,
    test: PyReadonlyArray1<'py, f64>,
    width: usize,
    window: &str,
    size: usize,
    sigma: f64,
    constants: (f64, f64),
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (reference, test) = (reference.as_slice()?, test.as_slice()?);
    let constants = Similarity { c1: constants.0, c2: constants.1 };
    let map =
        run::short(py, || metrics::similarity(reference, test, width, &self::window(window, size, sigma)?, constants))?;
    Ok(map.into_pyarray(py))
}

/// Discontinuity of each pixel, flat; positions are rows, relative to `origin`.
#[pyfunction]
#[pyo3(signature = (position, *, origin, width, camera, epsilon, min_distance, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
fn discontinuity<'py>(
    py: Python<'py>,
    position: PyReadonlyArray2<'py, f32>,
    origin: [f64; 3],
    width: usize,
    camera: &Camera,
    epsilon: f64,
    min_distance: f64,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    let rows = position.as_slice()?.as_chunks::<3>().0;
    let (origin, neighbourhood) = (DVec3::from_array(origin), Neighbourhood { epsilon, least: min_distance });
    let map = run::long(py, report, |progress| {
        metrics::discontinuity(rows, origin, width, &camera.0, neighbourhood, progress)
    })?;
    Ok(map.into_pyarray(py))
}

/// Shares of objects and of their pixels that are visible; none without objects.
#[pyfunction]
fn object_completion(
    py: Python<'_>,
    reference: PyReadonlyArray1<'_, i32>,
    test: PyReadonlyArray1<'_, i32>,
) -> PyResult<Option<(f64, f64)>> {
    let (reference, test) = (reference.as_slice()?, test.as_slice()?);
    run::short(py, || Ok(metrics::object_completion(reference, test)))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(mean_squared_error, module)?)?;
    module.add_function(wrap_pyfunction!(similarity, module)?)?;
    module.add_function(wrap_pyfunction!(discontinuity, module)?)?;
    module.add_function(wrap_pyfunction!(object_completion, module)?)
}
