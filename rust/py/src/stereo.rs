//! Bindings of `stereo`.

use glam::{DQuat, DVec2, DVec3};
use nearfar_core::camera::Fov;
use nearfar_core::render::RenderView;
use nearfar_core::stereo::{Axis, Contents, Eye, FarPicture, Head, Planes, Rig, Side, Triangles};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2, PyReadonlyArray3, PyReadwriteArray3,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::convert::arrays::filled;
use crate::convert::errors::to_python;
use crate::convert::names::choice;
use crate::convert::run;
use crate::render::frame::{Settings, images};
use crate::scene::Scene;

/// Tangents (left, right, down, up), position and orientation of an eye.
type View = ([f64; 4], [f64; 3], [f64; 4]);

/// Geometry of hybrid mono-stereo rendering.
#[pyclass(frozen, module = "nearfar._core")]
pub(crate) struct HybridRig(Rig);

fn side(name: &str) -> PyResult<Side> {
    choice("eye", name, &Side::BOTH.map(|side| (side.name(), side))).map_err(to_python)
}

fn eye(([left, right, down, up], position, orientation): View) -> Eye {
    let (position, orientation) = (DVec3::from_array(position), DQuat::from_array(orientation));
    Eye { fov: Fov { left, right, down, up }, position, orientation }
}

fn head(position: [f64; 3], orientation: [f64; 4], (near, far): (f64, f64)) -> Head {
    Head { position: DVec3::from_array(position), orientation: DQuat::from_array(orientation), near, far }
}

#[pymethods]
impl HybridRig {
    #[new]
    fn new(left: View, right: View, planes: (f64, f64), size: (u32, u32)) -> PyResult<Self> {
        let (begin, end) = planes;
        Rig::new([left, right].map(eye), Planes { begin, end }, size).map(Self).map_err(to_python)
    }

    /// The same rig with the sample positions of all pictures shifted right and down by a fraction of a pixel.
    fn jittered(&self, jitter: [f64; 2]) -> PyResult<Self> {
        self.0.jittered(DVec2::from_array(jitter)).map(Self).map_err(to_python)
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

    /// Distance of the plane on which the pictures meet, metres.
    #[getter]
    fn mono(&self) -> f64 {
        self.0.planes().mono()
    }

    /// Distance of the third camera behind the midpoint between the eyes, metres.
    #[getter]
    fn setback(&self) -> f64 {
        self.0.setback()
    }

    /// Midpoint between the eyes in head axes, metres.
    #[getter]
    fn middle(&self) -> [f64; 3] {
        self.0.middle().to_array()
    }

    /// Distance in front of the plane from which the third camera draws, metres.
    #[getter]
    fn overlap(&self) -> f64 {
        self.0.overlap()
    }

    /// Rows of the plane's homography from pixels of the third camera to pixels of an eye.
    fn homography(&self, eye: &str) -> PyResult<[[f64; 3]; 3]> {
        Ok(self.0.homography(side(eye)?).transpose().to_cols_array_2d())
    }

    /// Tangents at which an eye is shown a point that it would see at the tangents `at`.
    fn displayed_tangents(&self, eye: &str, at: [f64; 2], depth: f64) -> PyResult<[f64; 2]> {
        Ok(self.0.displayed_tangents(side(eye)?, DVec2::from_array(at), depth).to_array())
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

    /// Bit mask of the views that may show each instance of a scene, (N,): 1 the left eye's, 2 the right eye's, 4 the
    /// third camera's; whether an eye has own surfaces to draw; whether the third camera has any.
    fn contents<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        position: [f64; 3],
        orientation: [f64; 4],
        depths: (f64, f64),
        traced: bool,
    ) -> PyResult<(Bound<'py, PyArray1<u8>>, bool, bool)> {
        let head = head(position, orientation, depths);
        let Contents { instances, near, far } =
            run::long(py, None, |progress| self.0.contents(&scene.0, &head, traced, progress))?;
        Ok((instances.into_pyarray(py), near, far))
    }

    /// Triangles in the views of the left eye, the right eye and the third camera, those that all three draw, and those
    /// of each eye's full view.
    #[pyo3(signature = (scene, position, orientation, depths, report=None))]
    fn triangles(
        &self,
        py: Python<'_>,
        scene: &Scene,
        position: [f64; 3],
        orientation: [f64; 4],
        depths: (f64, f64),
        report: Option<Py<PyAny>>,
    ) -> PyResult<([u64; 3], u64, [u64; 2])> {
        let head = head(position, orientation, depths);
        let Triangles { views, thrice, plain } =
            run::long(py, report, |progress| self.0.triangles(&scene.0, &head, progress))?;
        Ok((views, thrice, plain))
    }

    /// Renders an eye's own picture up to the plane m₂, as images by name; the settings cut off everything beyond m₁.
    #[expect(clippy::too_many_arguments, reason = "a picture of a scene with its settings")]
    #[pyo3(signature = (eye, scene, camera, settings, position, orientation, depths, report=None))]
    fn render_zone<'py>(
        &self,
        py: Python<'py>,
        eye: &str,
        scene: &Scene,
        camera: &Camera,
        settings: Settings<'py>,
        position: [f64; 3],
        orientation: [f64; 4],
        depths: (f64, f64),
        report: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (side, head, scene, camera) = (side(eye)?, head(position, orientation, depths), &scene.0, &camera.0);
        let view = RenderView {
            camera,
            origin: scene.origin,
            channels: settings.channels()?,
            samples: settings.samples,
            limits: settings.limits()?,
            pixels: settings.pixels()?,
        };
        let frame = run::long(py, report, |progress| self.0.render_zone(side, scene, &view, &head, progress))?;
        images(py, frame, (camera.height as usize, camera.width as usize))
    }

    /// Mask of the third camera's pixels, (H, W), that an eye looks up; `left` and `right` are the shares of each eye's
    /// pixels that its own surfaces cover.
    fn needed<'py>(
        &self,
        py: Python<'py>,
        left: PyReadonlyArray2<'py, f32>,
        right: PyReadonlyArray2<'py, f32>,
        samples: u32,
    ) -> PyResult<Bound<'py, PyArray2<bool>>> {
        let (coverage, (width, height)) = ([left.as_slice()?, right.as_slice()?], self.0.center_size());
        let mask = run::long(py, None, |progress| self.0.needed(coverage, samples, progress))?;
        mask.into_pyarray(py).reshape([height as usize, width as usize])
    }

    /// Composites the third camera's picture behind an eye's own, in place.
    fn assemble<'py>(
        &self,
        py: Python<'py>,
        eye: &str,
        coverage: PyReadonlyArray2<'py, f32>,
        center: PyReadonlyArray3<'py, f32>,
        mut color: PyReadwriteArray3<'py, f32>,
    ) -> PyResult<()> {
        let (side, coverage, center) = (side(eye)?, coverage.as_slice()?, center.as_slice()?.as_chunks().0);
        let color = color.as_slice_mut()?.as_chunks_mut().0;
        run::long(py, None, |progress| self.0.assemble(side, coverage, center, color, progress))
    }

    /// Composites the surfaces that the third camera sees behind an eye's own picture, in place; `color` and `faces`
    /// are the third camera's.
    #[expect(clippy::too_many_arguments, reason = "a picture of a scene with its settings")]
    fn resolve<'py>(
        &self,
        py: Python<'py>,
        eye: &str,
        coverage: PyReadonlyArray2<'py, f32>,
        scene: &Scene,
        camera: &Camera,
        settings: Settings<'py>,
        center: (PyReadonlyArray3<'py, f32>, PyReadonlyArray2<'py, i64>),
        mut color: PyReadwriteArray3<'py, f32>,
    ) -> PyResult<()> {
        let (side, coverage) = (side(eye)?, coverage.as_slice()?);
        let far = FarPicture {
            scene: &scene.0,
            camera: &camera.0,
            limits: settings.limits()?,
            color: center.0.as_slice()?.as_chunks().0,
            faces: center.1.as_slice()?,
        };
        let color = color.as_slice_mut()?.as_chunks_mut().0;
        run::long(py, None, |progress| self.0.resolve(side, coverage, &far, settings.samples, color, progress))
    }

    /// Numbers (H, W) of the third camera's pixels with the greatest weight in the look-up of each of an eye's pixels.
    fn nearest<'py>(
        &self,
        py: Python<'py>,
        eye: &str,
        coverage: PyReadonlyArray2<'py, f32>,
    ) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let (side, (width, height), coverage) = (side(eye)?, self.0.size(), coverage.as_slice()?);
        filled(py, [height as usize, width as usize], |numbers: &mut [u32]| {
            run::long(py, None, |progress| self.0.nearest(side, coverage, numbers, progress))
        })
    }
}
