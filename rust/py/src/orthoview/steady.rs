//! Bindings of `orthoview::steady`.

use nearfar_core::camera;
use nearfar_core::orthoview::steady::{Fade, Image, Past, blur};
use numpy::PyArrayMethods;
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::convert::{Array2, Array3, Read2, Read3, filled, run, zeros};

/// A camera with its colours (H, W, 3) and ranges (H, W).
type Picture<'py> = (PyRef<'py, Camera>, Read3<'py, f32>, Read2<'py, f32>);

fn image<'a>((camera, color, range): &'a Picture<'_>) -> PyResult<Image<'a>> {
    Ok(Image { camera: &camera.0, color: color.as_slice()?.as_chunks().0, range: range.as_slice()? })
}

type Colors<'py> = Array3<'py, f32>;

/// Blends a picture's colours (H, W, 3) with those of an earlier one, and returns a mask (H, W) of pixels where both
/// show the same surface; with `motion` (H, W, 2) their distances must agree, too. `fade` has the exponents for static
/// and for moving pixels.
#[pyfunction]
#[pyo3(signature = (past, now, *, fade, motion=None))]
pub fn blend_past<'py>(
    py: Python<'py>,
    past: Picture<'py>,
    now: Picture<'py>,
    fade: (f64, f64),
    motion: Option<Read3<'py, f32>>,
) -> PyResult<(Colors<'py>, Array2<'py, bool>)> {
    let (past, now) = (image(&past)?, image(&now)?);
    let motion = motion.as_ref().map(|motion| motion.as_slice()).transpose()?.map(|motion| motion.as_chunks().0);
    let shape = [now.camera.height as usize, now.camera.width as usize];
    let agrees = zeros(py, shape)?;
    let mixed = filled(py, [shape[0], shape[1], 3], |mixed: &mut [f32]| {
        let mut agrees = agrees.readwrite();
        let (agrees, mixed) = (agrees.as_slice_mut()?, mixed.as_chunks_mut().0);
        run::long(py, None, |progress| {
            let fade = Fade { still: fade.0, moving: fade.1 };
            Past::new(past)?.blend(&now, motion, fade, mixed, agrees, progress)
        })
    })?;
    Ok((mixed, agrees))
}

/// Colours (H, W, 3) of a picture, averaged over camera poses.
#[pyfunction]
pub fn blur_motion<'py>(
    py: Python<'py>,
    picture: Picture<'py>,
    poses: Vec<PyRef<'py, Camera>>,
) -> PyResult<Colors<'py>> {
    let picture = image(&picture)?;
    let poses: Vec<&camera::Camera> = poses.iter().map(|pose| &pose.0).collect();
    let shape = [picture.camera.height as usize, picture.camera.width as usize, 3];
    filled(py, shape, |blurred: &mut [f32]| {
        run::long(py, None, |progress| blur(&picture, &poses, blurred.as_chunks_mut().0, progress))
    })
}
