//! Bindings of `stereo`.

use glam::{DQuat, DVec2, DVec3};
use nearfar_core::camera::Fov;
use nearfar_core::render::RenderView;
use nearfar_core::stereo::{Axis, Contents, Eye, FarPicture, Head, Planes, Rig, Side, Triangles};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::convert::{Array1, Array2, Array3, Read2, Read3, Report, Write3, choice, filled, run, to_python};
use crate::render::frame::{Settings, images};
use crate::scene::Scene;

/// Tangents (left, right, down, up), position and orientation of an eye.
type View = ([f64; 4], [f64; 3], [f64; 4]);

/// Geometry of hybrid mono-stereo rendering.
#[pyclass(frozen, module = "nearfar._core")]
pub struct HybridRig(Rig);

fn side(name: &str) -> PyResult<Side> {
    choice("eye", name, &Side::BOTH.map(|side| (side.name(), side))).map_err(to_python)
}

fn eye(([left, right, down, up], position, orientation): View) -> Eye {
    let (position, orientation) = (DVec3::from_array(position), DQuat::from_array(orientation));
    Eye { fov: Fov { left, right, down, up }, position, orientation }
}

/// Position and orientation of the head, and the nearest and the farthest drawn depth.
type HeadParts = ([f64; 3], [f64; 4], (f64, f64));

fn head((position, orientation, (near, far)): HeadParts) -> Head {
    Head { position: DVec3::from_array(position), orientation: DQuat::from_array(orientation), near, far }
}

#[pymethods]
impl HybridRig {
    #[new]
    fn new(left: View, right: View, planes: (f64, f64), size: (u32, u32)) -> PyResult<Self> {
        let (begin, end) = planes;
        Rig::new([left, right].map(eye), Planes { begin, end }, size).map(Self).map_err(to_python)
    }

    /// Creates the rig with the sample positions of all pictures shifted right and down by a fraction of a pixel.
    fn jittered(&self, jitter: [f64; 2]) -> PyResult<Self> {
        self.0.jittered(DVec2::from_array(jitter)).map(Self).map_err(to_python)
    }

    /// Tangents (left, right, down, up) of the third camera.
    #[getter]
    fn center_fov(&self) -> [f64; 4] {
        let Fov { left, right, down, up } = self.0.center_fov;
        [left, right, down, up]
    }

    /// Size of the third camera's picture, pixels.
    #[getter]
    fn center_size(&self) -> (u32, u32) {
        self.0.center_size
    }

    /// Distance of the plane on which the pictures meet, metres.
    #[getter]
    fn mono(&self) -> f64 {
        self.0.planes.mono()
    }

    /// Distance of the third camera behind the midpoint between the eyes, metres.
    #[getter]
    fn setback(&self) -> f64 {
        self.0.setback
    }

    /// Midpoint between the eyes in head axes, metres.
    #[getter]
    fn middle(&self) -> [f64; 3] {
        self.0.middle.to_array()
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

    /// Tangents at which the hybrid picture shows an eye a point that it would see at `tangents`.
    fn displayed_tangents(&self, eye: &str, tangents: [f64; 2], depth: f64) -> PyResult<[f64; 2]> {
        Ok(self.0.displayed_tangents(side(eye)?, DVec2::from_array(tangents), depth).to_array())
    }

    /// Greatest error over both eyes, pixels.
    fn max_error(&self, depth: f64, axis: &str) -> PyResult<f64> {
        let named = [("horizontal", Axis::Horizontal), ("vertical", Axis::Vertical), ("both", Axis::Both)];
        choice("axis", axis, &named).and_then(|axis| self.0.max_error(depth, axis)).map_err(to_python)
    }

    /// Errors at the centres of an eye's pixels, (H, W, 2), pixels to the right and upwards.
    fn error_field<'py>(&self, py: Python<'py>, eye: &str, depth: f64) -> PyResult<Array3<'py, f64>> {
        let (side, (width, height)) = (side(eye)?, self.0.size);
        filled(py, [height as usize, width as usize, 2], |field: &mut [f64]| {
            run::long(py, None, |progress| self.0.error_field(side, depth, field.as_chunks_mut().0, progress))
        })
    }

    /// Bit mask of the views that may show each instance of a scene, (N,): 1 for the left eye, 2 for the right eye, 4
    /// for the third camera; whether an eye draws any surfaces; whether the third camera does.
    fn contents<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        head: HeadParts,
        traced: bool,
    ) -> PyResult<(Array1<'py, u8>, bool, bool)> {
        let head = self::head(head);
        let Contents { instances, near, far } =
            run::long(py, None, |progress| self.0.contents(&scene.0, &head, traced, progress))?;
        Ok((instances.into_pyarray(py), near, far))
    }

    /// Numbers of triangles in the views of the left eye, the right eye and the third camera; of triangles that all
    /// three draw; and of triangles in each eye's full view.
    #[pyo3(signature = (scene, head, report=None))]
    fn triangles(
        &self,
        py: Python<'_>,
        scene: &Scene,
        head: HeadParts,
        report: Report,
    ) -> PyResult<([u64; 3], u64, [u64; 2])> {
        let head = self::head(head);
        let Triangles { views, thrice, plain } =
            run::long(py, report, |progress| self.0.triangles(&scene.0, &head, progress))?;
        Ok((views, thrice, plain))
    }

    /// Renders an eye's own picture up to the plane m₂, as images by name; the settings cut off everything beyond m₁.
    #[pyo3(signature = (eye, scene, camera, settings, head, report=None))]
    fn render_zone<'py>(
        &self,
        eye: &str,
        scene: &Bound<'py, Scene>,
        camera: &Camera,
        settings: Settings<'py>,
        head: HeadParts,
        report: Report,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (py, scene, camera) = (scene.py(), &scene.get().0, &camera.0);
        let (side, head) = (side(eye)?, self::head(head));
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

    /// Mask (H, W) of the third camera's pixels that an eye looks up; `left` and `right` have for each pixel of an eye
    /// the share that its own surfaces cover.
    fn needed<'py>(
        &self,
        py: Python<'py>,
        left: Read2<'py, f32>,
        right: Read2<'py, f32>,
        samples: u32,
    ) -> PyResult<Array2<'py, bool>> {
        let (coverage, (width, height)) = ([left.as_slice()?, right.as_slice()?], self.0.center_size);
        let mask = run::long(py, None, |progress| self.0.needed(coverage, samples, progress))?;
        mask.into_pyarray(py).reshape([height as usize, width as usize])
    }

    /// Composites the third camera's picture behind an eye's own, in place.
    fn assemble(
        &self,
        py: Python<'_>,
        eye: &str,
        coverage: Read2<'_, f32>,
        center: Read3<'_, f32>,
        mut color: Write3<'_, f32>,
    ) -> PyResult<()> {
        let (side, coverage, center) = (side(eye)?, coverage.as_slice()?, center.as_slice()?.as_chunks().0);
        let color = color.as_slice_mut()?.as_chunks_mut().0;
        run::long(py, None, |progress| self.0.assemble(side, coverage, center, color, progress))
    }

    /// Composites the surfaces that the third camera sees behind an eye's own picture, in place; `center` has the third
    /// camera, its colours and its faces.
    fn resolve(
        &self,
        eye: &str,
        coverage: Read2<'_, f32>,
        scene: &Bound<'_, Scene>,
        settings: Settings<'_>,
        center: (PyRef<'_, Camera>, Read3<'_, f32>, Read2<'_, i64>),
        mut color: Write3<'_, f32>,
    ) -> PyResult<()> {
        let (side, py, coverage) = (side(eye)?, scene.py(), coverage.as_slice()?);
        let far = FarPicture {
            scene: &scene.get().0,
            camera: &center.0.0,
            limits: settings.limits()?,
            color: center.1.as_slice()?.as_chunks().0,
            faces: center.2.as_slice()?,
        };
        let color = color.as_slice_mut()?.as_chunks_mut().0;
        run::long(py, None, |progress| self.0.resolve(side, coverage, &far, settings.samples, color, progress))
    }

    /// For each pixel of an eye (H, W), the number of the third camera's pixel with the greatest weight in its look-up.
    fn nearest<'py>(&self, py: Python<'py>, eye: &str, coverage: Read2<'py, f32>) -> PyResult<Array2<'py, u32>> {
        let (side, (width, height), coverage) = (side(eye)?, self.0.size, coverage.as_slice()?);
        filled(py, [height as usize, width as usize], |numbers: &mut [u32]| {
            run::long(py, None, |progress| self.0.nearest(side, coverage, numbers, progress))
        })
    }
}
