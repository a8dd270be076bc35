//! Bindings of `cubemap`: environment maps in three layouts.

use nearfar_core::base::{Real, Result};
use nearfar_core::cubemap::{self, Grid, Layout, Panorama};
use numpy::{Element, PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use super::directions::filter;
use crate::convert::arrays::{Points, with_array, with_rows};
use crate::convert::names::choice;
use crate::convert::one_of::one_of;
use crate::convert::run;

/// Layout name, number of rows (of one face) and number of columns.
pub(crate) type Shape = (String, u32, u32);

fn grid((layout, height, width): &Shape) -> Result<Grid> {
    use Layout::{Cube, Equirectangular, Octahedral};
    let layouts = [("cube", Cube), ("equirectangular", Equirectangular), ("octahedral", Octahedral)];
    let layout = choice("layout", layout, &layouts)?;
    Grid::new(layout, *height, *width)
}

one_of! {
    /// Values (N, C) of a picture, and an output array (M, C) for another picture.
    pub(crate) enum Pictures<'py> {
        Single((PyReadonlyArray2<'py, f32>, PyReadwriteArray2<'py, f32>)),
        Double((PyReadonlyArray2<'py, f64>, PyReadwriteArray2<'py, f64>)),
    }
}

one_of! {
    /// Pictures with values of any type, by the size of the type.
    pub(crate) enum PictureBits<'py> {
        One((PyReadonlyArray2<'py, u8>, PyReadwriteArray2<'py, u8>)),
        Two((PyReadonlyArray2<'py, u16>, PyReadwriteArray2<'py, u16>)),
        Four((PyReadonlyArray2<'py, u32>, PyReadwriteArray2<'py, u32>)),
        Eight((PyReadonlyArray2<'py, u64>, PyReadwriteArray2<'py, u64>)),
    }
}

fn filtered<T: Real + Element>(
    py: Python<'_>,
    (values, out): &mut (PyReadonlyArray2<'_, T>, PyReadwriteArray2<'_, T>),
    shapes: &[Shape; 2],
    settings: (&str, u32),
    report: Option<Py<PyAny>>,
) -> PyResult<()> {
    let channels = values.shape()[1];
    let (values, out) = (values.as_slice()?, out.as_slice_mut()?);
    run::long(py, report, |progress| {
        let picture = Panorama::new(grid(&shapes[0])?, values, channels)?;
        cubemap::convert(picture, grid(&shapes[1])?, filter(settings.0)?, settings.1, out, progress)
    })
}

fn copied<T: Element + Copy + Send + Sync>(
    py: Python<'_>,
    (values, out): &mut (PyReadonlyArray2<'_, T>, PyReadwriteArray2<'_, T>),
    shapes: &[Shape; 2],
    report: Option<Py<PyAny>>,
) -> PyResult<()> {
    let channels = values.shape()[1];
    let (values, out) = (values.as_slice()?, out.as_slice_mut()?);
    run::long(py, report, |progress| {
        let picture = Panorama::new(grid(&shapes[0])?, values, channels)?;
        cubemap::convert_nearest(picture, grid(&shapes[1])?, out, progress)
    })
}

/// Converts a picture to another layout; `shapes` are the shapes of both.
#[pyfunction]
#[pyo3(signature = (pictures, shapes, *, filter, samples, report=None))]
pub(crate) fn convert_envmap(
    py: Python<'_>,
    mut pictures: Pictures<'_>,
    shapes: [Shape; 2],
    filter: &str,
    samples: u32,
    report: Option<Py<PyAny>>,
) -> PyResult<()> {
    with_array!(Pictures::{Single, Double}, &mut pictures, pictures => {
        filtered(py, pictures, &shapes, (filter, samples), report)
    })
}

/// Converts a picture to another layout, with the nearest texels.
#[pyfunction]
#[pyo3(signature = (pictures, shapes, *, report=None))]
pub(crate) fn convert_envmap_nearest(
    py: Python<'_>,
    mut pictures: PictureBits<'_>,
    shapes: [Shape; 2],
    report: Option<Py<PyAny>>,
) -> PyResult<()> {
    with_array!(PictureBits::{One, Two, Four, Eight}, &mut pictures, pictures => copied(py, pictures, &shapes, report))
}

/// Writes the directions (N, 3) of all texel centres.
#[pyfunction]
pub(crate) fn envmap_directions(py: Python<'_>, shape: Shape, mut out: PyReadwriteArray2<'_, f64>) -> PyResult<()> {
    let rows = out.as_slice_mut()?.as_chunks_mut::<3>().0;
    run::long(py, None, |progress| cubemap::grid_directions(grid(&shape)?, rows, progress))
}

/// Writes the number of the texel that each direction (N, 3) passes through.
#[pyfunction]
pub(crate) fn envmap_texels(
    py: Python<'_>,
    shape: Shape,
    directions: Points<'_>,
    mut out: PyReadwriteArray1<'_, i64>,
) -> PyResult<()> {
    let out = out.as_slice_mut()?;
    with_rows!(&directions, rows => {
        run::long(py, None, |progress| cubemap::grid_texels(grid(&shape)?, rows, out, progress))
    })
}
