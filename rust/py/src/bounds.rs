//! Bindings of `bounds`.

use nearfar_core::base::{Error, Result};
use nearfar_core::bounds::{self, Sphere, SphereMethod};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::arrays::Points;
use crate::convert::errors::to_python;
use crate::convert::run;

fn method(name: &str) -> Result<SphereMethod> {
    match name {
        "exact" => Ok(SphereMethod::Exact),
        "ritter" => Ok(SphereMethod::Ritter),
        "average" => Ok(SphereMethod::Average),
        "minmax" => Ok(SphereMethod::MinMax),
        "best" => Ok(SphereMethod::Best),
        _ => Err(Error::value("method", "'exact', 'ritter', 'average', 'minmax' or 'best'", format!("'{name}'"))),
    }
}

fn row(sphere: &Sphere) -> [f64; 4] {
    let [x, y, z] = sphere.center.to_array();
    [x, y, z, sphere.radius]
}

/// Centre and radius of the sphere about each group of points.
#[pyfunction]
#[pyo3(signature = (points, offsets, *, method, report=None))]
pub(crate) fn bounding_spheres(
    py: Python<'_>,
    points: Points<'_>,
    offsets: PyReadonlyArray1<'_, i64>,
    method: &str,
    report: Option<Py<PyAny>>,
) -> PyResult<Vec<[f64; 4]>> {
    let method = self::method(method).map_err(to_python)?;
    let offsets = offsets.as_slice()?;
    let spheres = match &points {
        Points::Single(points) => {
            let points = points.as_slice()?.as_chunks::<3>().0;
            run::long(py, report, |progress| bounds::bounding_spheres(points, offsets, method, progress))
        }
        Points::Double(points) => {
            let points = points.as_slice()?.as_chunks::<3>().0;
            run::long(py, report, |progress| bounds::bounding_spheres(points, offsets, method, progress))
        }
    }?;
    Ok(spheres.iter().map(row).collect())
}

/// Centre and radius of the sphere about points.
#[pyfunction]
#[pyo3(signature = (points, *, method))]
pub(crate) fn bounding_sphere(py: Python<'_>, points: Points<'_>, method: &str) -> PyResult<[f64; 4]> {
    let method = self::method(method).map_err(to_python)?;
    let sphere = match &points {
        Points::Single(points) => {
            let points = points.as_slice()?.as_chunks::<3>().0;
            run::short(py, || bounds::bounding_sphere(points, method))
        }
        Points::Double(points) => {
            let points = points.as_slice()?.as_chunks::<3>().0;
            run::short(py, || bounds::bounding_sphere(points, method))
        }
    }?;
    Ok(row(&sphere))
}

/// Solid angles of spheres in steradians.
#[pyfunction]
pub(crate) fn solid_angles<'py>(
    py: Python<'py>,
    centers: PyReadonlyArray2<'py, f64>,
    radii: PyReadonlyArray1<'py, f64>,
    eye: [f64; 3],
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let to = PyArray1::<f64>::zeros(py, radii.len(), false);
    let mut write = to.readwrite();
    let (centers, radii, into) = (centers.as_slice()?.as_chunks::<3>().0, radii.as_slice()?, write.as_slice_mut()?);
    run::short(py, || bounds::solid_angles(centers, radii, eye.into(), into))?;
    Ok(to)
}
