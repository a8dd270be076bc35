//! Bindings of `render::temporal`.

use nearfar_core::render::{Moving, tiles};
use numpy::{PyArray3, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::arrays::filled;
use crate::convert::run;

/// Blends a picture (H, W, 3) with the reprojected accumulation of earlier pictures; `share` is the picture's weight.
#[pyfunction]
pub(crate) fn gather_frames<'py>(
    py: Python<'py>,
    color: PyReadonlyArray3<'py, f32>,
    motion: PyReadonlyArray3<'py, f32>,
    distance: PyReadonlyArray2<'py, f32>,
    gathered: PyReadonlyArray3<'py, f32>,
    share: f32,
) -> PyResult<Bound<'py, PyArray3<f32>>> {
    let (height, width) = (color.shape()[0], color.shape()[1]);
    let (color, motion, range) =
        (color.as_slice()?.as_chunks().0, motion.as_slice()?.as_chunks().0, distance.as_slice()?);
    let (moving, gathered) = (Moving { width, color, motion, range }, gathered.as_slice()?.as_chunks().0);
    filled(py, [height, width, 3], |mixed: &mut [f32]| {
        run::long(py, None, |progress| moving.gather(gathered, share, mixed.as_chunks_mut().0, progress))
    })
}

/// Positions of a pixel's samples within it, from its upper left corner.
#[pyfunction]
pub(crate) fn sample_offsets(samples: u32) -> Vec<[f64; 2]> {
    tiles::sample_offsets(samples)
}
