//! Bindings of `cubemap`: look-ups of cube maps in directions, and coarser levels.

use nearfar_core::base::Real;
use nearfar_core::cubemap::{self, CubeFaces, Reduction};
use numpy::{Element, PyReadonlyArray4, PyReadwriteArray2, PyReadwriteArray4, PyUntypedArrayMethods};
use pyo3::prelude::*;

use super::directions::filter;
use crate::convert::arrays::{Points, with_array, with_rows};
use crate::convert::errors::to_python;
use crate::convert::names::choice;
use crate::convert::one_of::one_of;
use crate::convert::run;

one_of! {
    /// Faces (6, S, S, C), and an output array (N, C) of the same type.
    pub(crate) enum Maps<'py> {
        Single((PyReadonlyArray4<'py, f32>, PyReadwriteArray2<'py, f32>)),
        Double((PyReadonlyArray4<'py, f64>, PyReadwriteArray2<'py, f64>)),
    }
}

one_of! {
    /// Faces and values of any type, by the size of the type.
    pub(crate) enum MapBits<'py> {
        One((PyReadonlyArray4<'py, u8>, PyReadwriteArray2<'py, u8>)),
        Two((PyReadonlyArray4<'py, u16>, PyReadwriteArray2<'py, u16>)),
        Four((PyReadonlyArray4<'py, u32>, PyReadwriteArray2<'py, u32>)),
        Eight((PyReadonlyArray4<'py, u64>, PyReadwriteArray2<'py, u64>)),
    }
}

fn faces<'a, T: Element + Copy>(array: &'a PyReadonlyArray4<'_, T>) -> PyResult<(&'a [T], u32, usize)> {
    Ok((array.as_slice()?, u32::try_from(array.shape()[1]).unwrap_or(u32::MAX), array.shape()[3]))
}

fn look<T: Real + Element>(
    py: Python<'_>,
    (maps, out): &mut (PyReadonlyArray4<'_, T>, PyReadwriteArray2<'_, T>),
    directions: &Points<'_>,
    name: &str,
) -> PyResult<()> {
    let (values, size, channels) = faces(maps)?;
    let out = out.as_slice_mut()?;
    with_rows!(directions, rows => run::long(py, None, |progress| {
        cubemap::lookup(CubeFaces::new(values, size, channels)?, rows, filter(name)?, out, progress)
    }))
}

fn pick<T: Element + Copy + Send + Sync>(
    py: Python<'_>,
    (maps, out): &mut (PyReadonlyArray4<'_, T>, PyReadwriteArray2<'_, T>),
    directions: &Points<'_>,
) -> PyResult<()> {
    let (values, size, channels) = faces(maps)?;
    let out = out.as_slice_mut()?;
    with_rows!(directions, rows => run::long(py, None, |progress| {
        cubemap::nearest(CubeFaces::new(values, size, channels)?, rows, out, progress)
    }))
}

/// Writes filtered values in directions (N, 3).
#[pyfunction]
pub(crate) fn cube_lookup(py: Python<'_>, mut maps: Maps<'_>, directions: Points<'_>, filter: &str) -> PyResult<()> {
    with_array!(Maps::{Single, Double}, &mut maps, maps => look(py, maps, &directions, filter))
}

/// Writes the texels that directions (N, 3) pass through.
#[pyfunction]
pub(crate) fn cube_nearest(py: Python<'_>, mut maps: MapBits<'_>, directions: Points<'_>) -> PyResult<()> {
    with_array!(MapBits::{One, Two, Four, Eight}, &mut maps, maps => pick(py, maps, &directions))
}

/// Writes the minimum or maximum of the texels that cones about directions (N, 3) touch.
#[pyfunction]
pub(crate) fn cube_footprint(
    py: Python<'_>,
    mut maps: Maps<'_>,
    directions: Points<'_>,
    filter: &str,
    radius: f64,
) -> PyResult<()> {
    with_array!(Maps::{Single, Double}, &mut maps, maps => touch(py, maps, &directions, filter, radius))
}

fn touch<T: Real + Element>(
    py: Python<'_>,
    (maps, out): &mut (PyReadonlyArray4<'_, T>, PyReadwriteArray2<'_, T>),
    directions: &Points<'_>,
    name: &str,
    radius: f64,
) -> PyResult<()> {
    let (values, size, channels) = faces(maps)?;
    let out = out.as_slice_mut()?;
    with_rows!(directions, rows => run::long(py, None, |progress| {
        cubemap::footprint(CubeFaces::new(values, size, channels)?, rows, radius, filter(name)?, out, progress)
    }))
}

one_of! {
    /// Faces (6, S, S, C), and an output array for the next level.
    pub(crate) enum LevelPair<'py> {
        Single((PyReadonlyArray4<'py, f32>, PyReadwriteArray4<'py, f32>)),
        Double((PyReadonlyArray4<'py, f64>, PyReadwriteArray4<'py, f64>)),
    }
}

/// Writes the next level of a cube map.
#[pyfunction]
pub(crate) fn cube_next_level(py: Python<'_>, mut levels: LevelPair<'_>, filter: &str) -> PyResult<()> {
    with_array!(LevelPair::{Single, Double}, &mut levels, levels => reduce(py, levels, filter))
}

fn reduce<T: Real + Element>(
    py: Python<'_>,
    (maps, out): &mut (PyReadonlyArray4<'_, T>, PyReadwriteArray4<'_, T>),
    filter: &str,
) -> PyResult<()> {
    let reductions = [("mean", Reduction::Mean), ("min", Reduction::Min), ("max", Reduction::Max)];
    let reduction = choice("filter", filter, &reductions).map_err(to_python)?;
    let (values, size, channels) = faces(maps)?;
    let out = out.as_slice_mut()?;
    run::long(py, None, |progress| {
        cubemap::next_level(CubeFaces::new(values, size, channels)?, reduction, out, progress)
    })
}

/// Writes the solid angle of each texel of a face (S, S), steradians.
#[pyfunction]
pub(crate) fn cube_solid_angles(py: Python<'_>, mut out: PyReadwriteArray2<'_, f64>) -> PyResult<()> {
    let size = u32::try_from(out.shape()[0]).unwrap_or(u32::MAX);
    let out = out.as_slice_mut()?;
    run::long(py, None, |progress| cubemap::solid_angles(size, out, progress))
}
