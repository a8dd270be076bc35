//! Bindings of `bounds`.

use nearfar_core::base::Result;
use nearfar_core::bounds::{self, Sphere, SphereMethod};
use pyo3::prelude::*;

use crate::convert::{Array1, Points, Read1, Read2, Report, choice, filled, run, to_python, with_rows};

fn method(name: &str) -> Result<SphereMethod> {
    use SphereMethod::{Average, Best, Exact, MinMax, Ritter};
    let choices = [("exact", Exact), ("ritter", Ritter), ("average", Average), ("minmax", MinMax), ("best", Best)];
    choice("method", name, &choices)
}

fn row(sphere: &Sphere) -> [f64; 4] {
    let [x, y, z] = sphere.center.to_array();
    [x, y, z, sphere.radius]
}

/// Centre and radius of the bounding sphere of each group of points.
#[pyfunction]
#[pyo3(signature = (points, offsets, *, method, report=None))]
pub fn bounding_spheres(
    py: Python<'_>,
    points: Points<'_>,
    offsets: Read1<'_, i64>,
    method: &str,
    report: Report,
) -> PyResult<Vec<[f64; 4]>> {
    let method = self::method(method).map_err(to_python)?;
    let offsets = offsets.as_slice()?;
    let spheres = with_rows!(&points, points => {
        run::long(py, report, |progress| bounds::bounding_spheres(points, offsets, method, progress))
    })?;
    Ok(spheres.iter().map(row).collect())
}

/// Centre and radius of the bounding sphere of points.
#[pyfunction]
#[pyo3(signature = (points, *, method))]
pub fn bounding_sphere(py: Python<'_>, points: Points<'_>, method: &str) -> PyResult<[f64; 4]> {
    let method = self::method(method).map_err(to_python)?;
    let sphere = with_rows!(&points, points => {
        run::long(py, None, |progress| bounds::bounding_sphere(points, method, progress))
    })?;
    Ok(row(&sphere))
}

/// Solid angles of spheres in steradians.
#[pyfunction]
pub fn solid_angles<'py>(
    py: Python<'py>,
    centers: Read2<'py, f64>,
    radii: Read1<'py, f64>,
    eye: [f64; 3],
) -> PyResult<Array1<'py, f64>> {
    let (centers, radii) = (centers.as_slice()?.as_chunks::<3>().0, radii.as_slice()?);
    filled(py, radii.len(), |to| {
        run::long(py, None, |progress| bounds::solid_angles(centers, radii, eye.into(), to, progress))
    })
}
