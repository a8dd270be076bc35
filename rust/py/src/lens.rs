//! Bindings of `lens`.

use glam::DVec3;
use nearfar_core::base::{Progress, Real, Result, memory};
use nearfar_core::camera::Fov;
use nearfar_core::lens::{self, Image, InverseMethod, Sizes, WarpFilter, WarpPixel, WarpView};
use numpy::ndarray::Ix1;
use numpy::{Element, PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::convert::{
    Array1, Array2, Array3, Floats, Points, Read1, Read2, Read3, argument_enum, array_of_rows, choice, filled, run,
    to_python, with_array,
};

type Radii<'py> = Floats<'py, Ix1>;

argument_enum! {
    pub enum Picture<'py> {
        Byte(Read3<'py, u8>),
        Short(Read3<'py, u16>),
        Single(Read3<'py, f32>),
        Double(Read3<'py, f64>),
    }
}

fn method(name: &str, iterations: u32) -> Result<InverseMethod> {
    use InverseMethod::{FixedPoint, Newton, Table};
    choice("method", name, &[("newton", Newton), ("fixed_point", FixedPoint(iterations)), ("lut", Table)])
}

/// View of a warp, by the names in the result of `_view`, and its direction.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ViewArguments {
    from_fov: [f64; 4],
    to_fov: [f64; 4],
    tan_omega: f64,
    distort: bool,
}

impl ViewArguments {
    fn convert(&self) -> WarpView {
        let [from, to] = [self.from_fov, self.to_fov].map(|[left, right, down, up]| Fov { left, right, down, up });
        WarpView { from, to, tan_omega: self.tan_omega, distort: self.distort }
    }
}

#[pyclass(frozen, module = "nearfar._core")]
#[derive(Clone)]
pub struct RadialLens(pub lens::RadialLens);

/// Applies a kernel to an array of radii.
fn map_radii<'py, T: Real + Element>(
    py: Python<'py>,
    from: &Read1<'py, T>,
    kernel: impl FnOnce(&[T], &mut [T], &Progress) -> Result<()> + Send,
) -> PyResult<Py<PyAny>> {
    let from = from.as_slice()?;
    filled(py, from.len(), |to| run::long(py, None, |progress| kernel(from, to, progress)))?.into_py_any(py)
}

/// Applies a kernel to an array of points.
fn map_points<'py, T: Real + Element>(
    py: Python<'py>,
    from: &Read2<'py, T>,
    kernel: impl FnOnce(&[[T; 2]], &mut [[T; 2]], &Progress) -> Result<()> + Send,
) -> PyResult<Py<PyAny>> {
    let from = from.as_slice()?.as_chunks::<2>().0;
    filled(py, [from.len(), 2], |to| run::long(py, None, |progress| kernel(from, to.as_chunks_mut().0, progress)))?
        .into_py_any(py)
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
        self.0.reach
    }

    fn table_bound(&self, py: Python<'_>) -> PyResult<(f64, f64)> {
        run::short(py, || Ok(self.0.table_bound()))
    }

    fn distort(&self, py: Python<'_>, r: Radii<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        with_array!(Floats::{Single, Double}, &r, r => {
            map_radii(py, r, |from, to, progress| self.0.distort_all(from, to, refuse, progress))
        })
    }

    fn derivative(&self, py: Python<'_>, r: Radii<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        with_array!(Floats::{Single, Double}, &r, r => {
            map_radii(py, r, |from, to, progress| self.0.derivative_all(from, to, refuse, progress))
        })
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
        with_array!(Floats::{Single, Double}, &r, r => {
            map_radii(py, r, |from, to, progress| self.0.undistort_all(from, to, method, refuse, progress))
        })
    }

    fn distort_points(&self, py: Python<'_>, places: Points<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        with_array!(Floats::{Single, Double}, &places, from => {
            map_points(py, from, |from, to, progress| self.0.distort_points(from, to, refuse, progress))
        })
    }

    fn undistort_points(&self, py: Python<'_>, places: Points<'_>, refuse: bool) -> PyResult<Py<PyAny>> {
        with_array!(Floats::{Single, Double}, &places, from => {
            map_points(py, from, |from, to, progress| self.0.undistort_points(from, to, refuse, progress))
        })
    }
}

fn lenses(lenses: &[PyRef<'_, RadialLens>]) -> Vec<lens::RadialLens> {
    lenses.iter().map(|lens| lens.0.clone()).collect()
}

fn warp_picture<'py, P: WarpPixel + Element>(
    py: Python<'py>,
    lenses: &[lens::RadialLens],
    picture: &Read3<'py, P>,
    view: &WarpView,
    filter: WarpFilter,
    fill: f64,
    [width, height]: [usize; 2],
) -> PyResult<Py<PyAny>> {
    let (rows, columns, channels) = (picture.shape()[0], picture.shape()[1], picture.shape()[2]);
    memory::room_for((height * width * channels * size_of::<P>()) as u64).map_err(to_python)?;
    let image = Image { values: picture.as_slice()?, width: columns, height: rows, channels };
    let warp = |to: &mut [P]| {
        run::long(py, None, |progress| lens::warp(lenses, &image, view, filter, P::nearest(fill), to, width, progress))
    };
    filled(py, [height, width, channels], warp)?.into_py_any(py)
}

/// Warps a picture (H, W, C) by one lens, or by one lens per channel.
#[pyfunction]
#[pyo3(signature = (lenses, picture, view, *, size, filter, fill))]
pub fn warp(
    py: Python<'_>,
    lenses: Vec<PyRef<'_, RadialLens>>,
    picture: Picture<'_>,
    view: ViewArguments,
    size: [usize; 2],
    filter: &str,
    fill: f64,
) -> PyResult<Py<PyAny>> {
    let filter = choice("filter", filter, &[("linear", WarpFilter::Linear), ("cubic", WarpFilter::Cubic)]);
    let (filter, lenses, view) = (filter.map_err(to_python)?, self::lenses(&lenses), view.convert());
    with_array!(Picture::{Byte, Short, Single, Double}, &picture, picture => {
        warp_picture(py, &lenses, picture, &view, filter, fill, size)
    })
}

type MeshArrays<'py> = (Array2<'py, f64>, Array3<'py, f64>, Array2<'py, u32>, f64);

/// Positions (N, 2), source positions (L, N, 2), faces (F, 3) and the greatest error in pixels.
#[pyfunction]
#[pyo3(signature = (lenses, view, *, cells, size))]
pub fn warp_mesh<'py>(
    py: Python<'py>,
    lenses: Vec<PyRef<'py, RadialLens>>,
    view: ViewArguments,
    cells: [usize; 2],
    size: [usize; 2],
) -> PyResult<MeshArrays<'py>> {
    let (lenses, view) = (self::lenses(&lenses), view.convert());
    let mesh = run::long(py, None, |progress| lens::warp_mesh(&lenses, &view, cells, size, progress))?;
    let count = mesh.places.len();
    let sources = mesh.sources.concat().into_flattened();
    Ok((
        array_of_rows(py, mesh.places)?,
        PyArray1::from_vec(py, sources).reshape([lenses.len(), count, 2])?,
        array_of_rows(py, mesh.faces.to_vec())?,
        mesh.error,
    ))
}

/// Solid angles of the images of spheres through a lens.
#[pyfunction]
#[pyo3(signature = (lens, centers, radii, *, eye, forward, tan_omega, exact))]
pub fn corrected_solid_angles<'py>(
    lens: &Bound<'py, RadialLens>,
    centers: Read2<'py, f64>,
    radii: Read1<'py, f64>,
    eye: [f64; 3],
    forward: [f64; 3],
    tan_omega: f64,
    exact: bool,
) -> PyResult<Array1<'py, f64>> {
    let (centers, radii) = (centers.as_slice()?.as_chunks::<3>().0, radii.as_slice()?);
    let (py, lens, forward) = (lens.py(), &lens.get().0, DVec3::from_array(forward).normalize());
    let sizes = Sizes { lens, eye: eye.into(), forward, tan_omega, exact };
    filled(py, radii.len(), |to| {
        run::long(py, None, |progress| lens::corrected_solid_angles(&sizes, centers, radii, to, progress))
    })
}
