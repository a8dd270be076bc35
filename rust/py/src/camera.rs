//! Bindings of `camera`.

use glam::{DQuat, DVec3};
use nearfar_core::base::{Error, Result};
use nearfar_core::camera::{self, Depth, Fov, Planes, Projection, Ranged};
use numpy::ndarray::Ix3;
use numpy::{Element, PyArrayMethods};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::convert::{Array2, Array3, Floats, Read2, Read3, argument_enum, filled, run, to_python, with_array, zeros};

/// A validated camera.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Camera(pub camera::Camera);

fn projection(kind: &str, bounds: [f64; 4], face: u8) -> Result<Projection> {
    let [left, right, down, up] = bounds;
    let fov = Fov { left, right, down, up };
    match kind {
        "perspective" => Ok(Projection::Perspective(fov)),
        "orthographic" => Ok(Projection::Orthographic(fov)),
        "cube" => Ok(Projection::CubeFace(face)),
        _ => Err(Error::value("kind", "perspective, orthographic or cube", kind)),
    }
}

type Image<'py> = Array3<'py, f64>;

#[pymethods]
impl Camera {
    /// `kind` is "perspective" or "orthographic" with bounds (left, right, down, up), or "cube" with a face.
    #[new]
    #[pyo3(signature = (position, orientation, size, *, kind, bounds=[0.0; 4], face=0))]
    fn new(
        position: [f64; 3],
        orientation: [f64; 4],
        size: (u32, u32),
        kind: &str,
        bounds: [f64; 4],
        face: u8,
    ) -> PyResult<Self> {
        let projection = projection(kind, bounds, face);
        let (position, orientation) = (DVec3::from_array(position), DQuat::from_array(orientation));
        projection
            .and_then(|projection| camera::Camera::new(position, orientation, projection, size.0, size.1))
            .map(Self)
            .map_err(to_python)
    }

    /// Pixel x, y and depth of world points (N, 3); NaN for points behind the camera.
    fn project<'py>(&self, py: Python<'py>, points: Read2<'py, f64>) -> PyResult<Array2<'py, f64>> {
        let rows = points.as_slice()?.as_chunks::<3>().0;
        filled(py, [rows.len(), 3], |to: &mut [f64]| {
            run::long(py, None, |progress| self.0.project_all(rows, to.as_chunks_mut().0, progress))
        })
    }

    /// World starts and unit directions of the rays through all pixel centres, (H, W, 3) each.
    fn rays<'py>(&self, py: Python<'py>) -> PyResult<(Image<'py>, Image<'py>)> {
        let shape = [self.0.height as usize, self.0.width as usize, 3];
        self.0.room_for_rays().map_err(to_python)?;
        let starts = zeros(py, shape)?;
        let directions = filled(py, shape, |directions: &mut [f64]| {
            let mut starts = starts.readwrite();
            let (starts, directions) = (starts.as_slice_mut()?.as_chunks_mut().0, directions.as_chunks_mut().0);
            run::long(py, None, |progress| self.0.pixel_rays(starts, directions, progress))
        })?;
        Ok((starts, directions))
    }

    #[getter]
    fn is_parallel(&self) -> bool {
        self.0.is_parallel()
    }

    /// Lower bound of the angle between neighbouring pixels, radians; metres for parallel rays.
    #[getter]
    fn least_pixel_angle(&self) -> f64 {
        self.0.least_pixel_angle()
    }
}

/// A conversion between a depth buffer's values and distances.
#[pyclass(frozen, module = "nearfar._core")]
pub struct DepthBuffer(camera::DepthBuffer);

argument_enum! {
    enum Values<'py> {
        Single(Read3<'py, f32>),
        Double(Read3<'py, f64>),
        Bits16(Read3<'py, u16>),
        Bits24(Read3<'py, u32>),
    }
}

#[pymethods]
impl DepthBuffer {
    /// `kind` and `bounds` are as for `Camera`.
    #[new]
    #[pyo3(signature = (size, *, kind, bounds=[0.0; 4], near, far, reverse))]
    fn new(size: (usize, usize), kind: &str, bounds: [f64; 4], near: f64, far: f64, reverse: bool) -> PyResult<Self> {
        let planes = Planes { near, far, reverse };
        projection(kind, bounds, 0)
            .and_then(|projection| camera::DepthBuffer::new(projection, planes, size.0, size.1))
            .map(Self)
            .map_err(to_python)
    }

    /// Creates the depth buffer of a projection matrix, given as rows, whose depths run from `low` to 1.
    #[staticmethod]
    fn from_matrix(size: (usize, usize), rows: [[f64; 4]; 4], low: f64) -> PyResult<Self> {
        camera::DepthBuffer::from_matrix(rows, low, size.0, size.1).map(Self).map_err(to_python)
    }

    /// Distances from the eye, (N, H, W).
    fn ranges(&self, py: Python<'_>, depth: Values<'_>) -> PyResult<Py<PyAny>> {
        with_array!(Values::{Single, Double, Bits16, Bits24}, &depth, depth => self.ranges_of(py, depth))
    }

    /// Depth buffer values at distances from the eye, (N, H, W).
    fn depths(&self, py: Python<'_>, ranges: Floats<'_, Ix3>) -> PyResult<Py<PyAny>> {
        with_array!(Floats::{Single, Double}, &ranges, ranges => self.depths_of(py, ranges))
    }
}

impl DepthBuffer {
    fn ranges_of<T>(&self, py: Python<'_>, depth: &Read3<'_, T>) -> PyResult<Py<PyAny>>
    where
        T: Depth<Range: Element> + Element,
    {
        let from = depth.as_slice()?;
        filled::<T::Range, _>(py, depth.dims(), |to| run::long(py, None, |progress| self.0.ranges(from, to, progress)))?
            .into_py_any(py)
    }

    fn depths_of<T: Ranged + Element>(&self, py: Python<'_>, ranges: &Read3<'_, T>) -> PyResult<Py<PyAny>> {
        let from = ranges.as_slice()?;
        filled::<T, _>(py, ranges.dims(), |to| run::long(py, None, |progress| self.0.depths(from, to, progress)))?
            .into_py_any(py)
    }
}
