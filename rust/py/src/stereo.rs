//! Bindings of `stereo`.

use glam::{DQuat, DVec2, DVec3};
use nearfar_core::camera::Fov;
use nearfar_core::stereo::{Axis, Eye, Planes, Rig, Side};
use numpy::PyArray3;
use pyo3::prelude::*;

use crate::convert::arrays::filled;
use crate::convert::errors::to_python;
use crate::convert::names::choice;
use crate::convert::run;

/// Tangents (left, right, down, up), position and orientation of an eye.
type View = ([f64; 4], [f64; 3], [f64; 4]);

/// The geometry of hybrid mono-stereo rendering.
#[pyclass(frozen, module = "nearfar._core")]
pub(crate) struct HybridRig(Rig);

fn side(name: &str) -> PyResult<Side> {
    choice("eye", name, &Side::BOTH.map(|side| (side.name(), side))).map_err(to_python)
}

fn eye(([left, right, down, up], position, orientation): View) -> Eye {
    let (position, orientation) = (DVec3::from_array(position), DQuat::from_array(orientation));
    Eye { fov: Fov { left, right, down, up }, position, orientation }
}

#[pymethods]
impl HybridRig {
    #[new]
    fn new(left: View, right: View, planes: (f64, f64), size: (u32, u32)) -> PyResult<Self> {
        let (mono, stereo) = planes;
        Rig::new([left, right].map(eye), Planes { mono, stereo }, size).map(Self).map_err(to_python)
    }

    /// Tangents (left, right, down, up) of the third camera.
    #[getter]
    fn center_fov(&self) -> [f64; 4] {
        let Fov { left, right, down, up } = self.0.center_fov();
        [left, right, down, up]
    }

    /// Size of the third camera's picture, pixels.
    #[getter]
    fn center_size(&self) -> (u32, u32) {
        self.0.center_size()
    }

    /// Distance of the third camera behind the middle between the eyes, metres.
    #[getter]
    fn setback(&self) -> f64 {
        self.0.setback()
    }

    /// The middle between the eyes in head axes, metres.
    #[getter]
    fn middle(&self) -> [f64; 3] {
        self.0.middle().to_array()
    }

    /// By so much nearer than the plane does the third camera begin to draw, metres.
    #[getter]
    fn overlap(&self) -> f64 {
        self.0.overlap()
    }

    /// Rows of the homography of the plane, from pixels of the third camera to pixels of an eye.
    fn homography(&self, eye: &str) -> PyResult<[[f64; 3]; 3]> {
        Ok(self.0.homography(side(eye)?).transpose().to_cols_array_2d())
    }

    /// Tangents at which an eye is shown a point that it would see at the tangents `at`.
    fn shown(&self, eye: &str, at: [f64; 2], depth: f64) -> PyResult<[f64; 2]> {
        Ok(self.0.shown(side(eye)?, DVec2::from_array(at), depth).to_array())
    }

    /// Greatest error over both eyes, pixels.
    fn max_error(&self, depth: f64, axis: &str) -> PyResult<f64> {
        let named = [("horizontal", Axis::Horizontal), ("vertical", Axis::Vertical), ("both", Axis::Both)];
        choice("axis", axis, &named).and_then(|axis| self.0.max_error(depth, axis)).map_err(to_python)
    }

    /// Errors at the centres of an eye's pixels, (H, W, 2), pixels to the right and upwards.
    fn error_field<'py>(&self, py: Python<'py>, eye: &str, depth: f64) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let (side, (width, height)) = (side(eye)?, self.0.size());
        filled(py, [height as usize, width as usize, 2], |field: &mut [f64]| {
            run::long(py, None, |progress| self.0.error_field(side, depth, field.as_chunks_mut().0, progress))
        })
    }
}
