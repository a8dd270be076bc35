//! Bindings of `lens`.

use glam::DVec3;
use nearfar_core::base::{Error, Real, Result, memory};
use nearfar_core::camera::Fov;
use nearfar_core::lens::{self, Image, InverseMethod, Sizes, WarpFilter, WarpPixel, WarpView};
use numpy::{
    Element, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3,
    PyUntypedArrayMethods,
};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::convert::arrays::Points;
use crate::convert::errors::to_python;
use crate::convert::run;

#[derive(FromPyObject)]
enum Radii<'py> {
    Single(PyReadonlyArray1<'py, f32>),
    Double(PyReadonlyArray1<'py, f64>),
}

#[derive(FromPyObject)]
pub(crate) enum Picture<'py> {
    Byte(PyReadonlyArray3<'py, u8>),
    Short(PyReadonlyArray3<'py, u16>),
    Single(PyReadonlyArray3<'py, f32>),
    Double(PyReadonlyArray3<'py, f64>),
}

fn method(name: &str, iterations: u32) -> Result<InverseMethod> {
    match name {
        "newton" => Ok(InverseMethod::Newton),
        "fixed_point" => Ok(InverseMethod::FixedPoint(iterations)),
        "lut" => Ok(InverseMethod::Table),
        _ => Err(Error::value("method", "'newton', 'fixed_point' or 'lut'", format!("'{name}'"))),
    }
}

fn filter(name: &str) -> Result<WarpFilter> {
    match name {
        "linear" => Ok(WarpFilter::Linear),
        "cubic" => Ok(WarpFilter::Cubic),
        _ => Err(Error::value("filter", "'linear' or 'cubic'", format!("'{name}'"))),
    }
}

fn fov([left, right, down, up]: [f64; 4]) -> Fov {
    Fov { left, right, down, up }
}

/// A lens.
#[pyclass(frozen, module = "nearfar._core")]
#[derive(Clone)]
pub(crate) struct RadialLens(lens::RadialLens);

impl RadialLens {
    pub(crate) fn inner(&self) -> &lens::RadialLens {
        &self.0
    }
}

/// An array that a kernel fills from radii.
fn radii<'py, T: Real + Element>(
    py: Python<'py>,
    from: &PyReadonlyArray1<'py, T>,
    kernel: impl FnOnce(&[T], &mut [T]) -> Result<()> + Send,
) -> PyResult<Py<PyAny>> {
    let to = PyArray1::<T>::zeros(py, from.len(), false);
    let mut write = to.readwrite();
    let (from, into) = (from.as_slice()?, write.as_slice_mut()?);
    run::short(py, || kernel(from, into))?;
    to.into_py_any(py)
}

/// An array that a kernel fills from points.
fn points<'py, T: Real + Element>(
    py: Python<'py>,
    from: &PyReadonlyArray2<'py, T>,
    kernel: impl FnOnce(&[[T; 2]], &mut [[T; 2]]) -> Result<()> + Send,
) -> PyResult<Py<PyAny>> {
    let to = PyArray2::<T>::zeros(py, [from.shape()[0], 2], false);
    let mut write = to.readwrite();
    let (from, into) = (from.as_slice()?.as_chunks::<2>().0, write.as_slice_mut()?.as_chunks_mut::<2>().0);
    run::short(py, || kernel(from, into))?;
    to.into_py_any(py)
}

#[pymethods]
impl RadialLens {
    #[new]
    fn new(k: Vec<f64>, tangential: [f64; 2]) -> PyResult<Self> {
        lens::RadialLens::new(&k, tangential).map(Self).map_err(to_python)
    }

    #[getter]
    fn r_max(&self) -> f64 {
        self.0.r_max()
    }

    #[getter]
    fn x_max(&self) -> f64 {
        self.0.x_max()
    }

    #[getter]
    fn reach(&self) -> f64 {
        self.0.reach()
    }

    fn table_bound(&self, py: Python<'_>) -> PyResult<(f64, f64)> {
        run::short(py, || Ok(self.0.table_bound()))
    }

    fn distort(&self, py: Python<'_>, r: Radii<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        match &r {
            Radii::Single(r) => radii(py, r, |from, to| self.0.distort_all(from, to, refuse)),
            Radii::Double(r) => radii(py, r, |from, to| self.0.distort_all(from, to, refuse)),
        }
    }

    fn derivative(&self, py: Python<'_>, r: Radii<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        match &r {
            Radii::Single(r) => radii(py, r, |from, to| self.0.derivative_all(from, to, refuse)),
            Radii::Double(r) => radii(py, r, |from, to| self.0.derivative_all(from, to, refuse)),
        }
    }

    fn undistort(
        &self,
        py: Python<'_>,
        r: Radii<'_>,
        method: &str,
        iterations: u32,
        refuse: bool,
    ) -> PyResult<Py<PyAny>> {
        let method = self::method(method, iterations).map_err(to_python)?;
        match &r {
            Radii::Single(r) => radii(py, r, |from, to| self.0.undistort_all(from, to, method, refuse)),
            Radii::Double(r) => radii(py, r, |from, to| self.0.undistort_all(from, to, method, refuse)),
        }
    }

    fn distort_points(&self, py: Python<'_>, places: Points<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        match &places {
            Points::Single(from) => points(py, from, |from, to| self.0.distort_points(from, to, refuse)),
            Points::Double(from) => points(py, from, |from, to| self.0.distort_points(from, to, refuse)),
        }
    }

    fn undistort_points(&self, py: Python<'_>, places: Points<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        match &places {
            Points::Single(from) => points(py, from, |from, to| self.0.undistort_points(from, to, refuse)),
            Points::Double(from) => points(py, from, |from, to| self.0.undistort_points(from, to, refuse)),
        }
    }
}

fn lenses(lenses: &[PyRef<'_, RadialLens>]) -> Vec<lens::RadialLens> {
    lenses.iter().map(|lens| lens.0.clone()).collect()
}

fn warped<'py, P: WarpPixel + Element>(
    py: Python<'py>,
    lenses: &[lens::RadialLens],
    picture: &PyReadonlyArray3<'py, P>,
    view: &WarpView,
    filter: WarpFilter,
    fill: f64,
    [width, height]: [usize; 2],
) -> PyResult<Py<PyAny>> {
    let (rows, columns, channels) = (picture.shape()[0], picture.shape()[1], picture.shape()[2]);
    memory::room_for((height * width * channels * size_of::<P>()) as u64).map_err(to_python)?;
    let to = PyArray3::<P>::zeros(py, [height, width, channels], false);
    let mut write = to.readwrite();
    let (values, into) = (picture.as_slice()?, write.as_slice_mut()?);
    let image = Image { values, width: columns, height: rows, channels };
    run::short(py, || lens::warp(lenses, &image, view, filter, P::nearest(fill), into, width))?;
    to.into_py_any(py)
}

/// A picture (H, W, C) through one lens, or one for each channel.
#[pyfunction]
#[pyo3(signature = (lenses, picture, *, from_fov, to_fov, tan_omega, size, distort, filter, fill))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
pub(crate) fn warp<'py>(
    py: Python<'py>,
    lenses: Vec<PyRef<'py, RadialLens>>,
    picture: Picture<'py>,
    from_fov: [f64; 4],
    to_fov: [f64; 4],
    tan_omega: f64,
    size: [usize; 2],
    distort: bool,
    filter: &str,
    fill: f64,
) -> PyResult<Py<PyAny>> {
    let view = WarpView { from: fov(from_fov), to: fov(to_fov), tan_omega, distort };
    let filter = self::filter(filter).map_err(to_python)?;
    let lenses = self::lenses(&lenses);
    match &picture {
        Picture::Byte(picture) => warped(py, &lenses, picture, &view, filter, fill, size),
        Picture::Short(picture) => warped(py, &lenses, picture, &view, filter, fill, size),
        Picture::Single(picture) => warped(py, &lenses, picture, &view, filter, fill, size),
        Picture::Double(picture) => warped(py, &lenses, picture, &view, filter, fill, size),
    }
}

type MeshArrays<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray3<f64>>, Bound<'py, PyArray2<u32>>, f64);

/// Places (N, 2), sources (L, N, 2), faces (F, 3) and the greatest error in pixels.
#[pyfunction]
#[pyo3(signature = (lenses, *, from_fov, to_fov, tan_omega, cells, size, distort))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
pub(crate) fn warp_mesh<'py>(
    py: Python<'py>,
    lenses: Vec<PyRef<'py, RadialLens>>,
    from_fov: [f64; 4],
    to_fov: [f64; 4],
    tan_omega: f64,
    cells: [usize; 2],
    size: [usize; 2],
    distort: bool,
) -> PyResult<MeshArrays<'py>> {
    let view = WarpView { from: fov(from_fov), to: fov(to_fov), tan_omega, distort };
    let lenses = self::lenses(&lenses);
    let mesh = run::short(py, || lens::warp_mesh(&lenses, &view, cells, size))?;
    let count = mesh.places.len();
    let sources = mesh.sources.concat().into_flattened();
    Ok((
        PyArray1::from_vec(py, mesh.places.into_flattened()).reshape([count, 2])?,
        PyArray1::from_vec(py, sources).reshape([lenses.len(), count, 2])?,
        PyArray1::from_vec(py, mesh.faces.as_flattened().to_vec()).reshape([mesh.faces.len(), 3])?,
        mesh.error,
    ))
}

/// Solid angles of spheres as a lens shows them.
#[pyfunction]
#[pyo3(signature = (lens, centers, radii, *, eye, forward, tan_omega, exact))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
pub(crate) fn corrected_solid_angles<'py>(
    py: Python<'py>,
    lens: PyRef<'py, RadialLens>,
    centers: PyReadonlyArray2<'py, f64>,
    radii: PyReadonlyArray1<'py, f64>,
    eye: [f64; 3],
    forward: [f64; 3],
    tan_omega: f64,
    exact: bool,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let to = PyArray1::<f64>::zeros(py, radii.len(), false);
    let mut write = to.readwrite();
    let (centers, radii, into) = (centers.as_slice()?.as_chunks::<3>().0, radii.as_slice()?, write.as_slice_mut()?);
    let lens = &lens.0;
    let sizes = Sizes { lens, eye: eye.into(), forward: DVec3::from_array(forward).normalize(), tan_omega, exact };
    run::short(py, || lens::corrected_solid_angles(&sizes, centers, radii, into))?;
    Ok(to)
}
