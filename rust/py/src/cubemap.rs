//! Bindings of `cubemap`: look-ups of cube maps in directions, coarser levels, and maps in three layouts.

use nearfar_core::base::{Real, Result};
use nearfar_core::cubemap::{self, CubeFaces, Grid, Layout, Panorama, Reduction, TexelFilter};
use numpy::ndarray::{Ix2, Ix4};
use numpy::{Element, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::{
    BitsInOut, FloatsInOut, Points, Read2, Read4, Report, Write1, Write2, Write4, choice, run, to_python, with_array,
    with_rows,
};

fn texel_filter(name: &str) -> Result<TexelFilter> {
    use TexelFilter::{Cubic, Linear, Max, Min};
    choice("filter", name, &[("linear", Linear), ("cubic", Cubic), ("min", Min), ("max", Max)])
}

/// Faces (6, S, S, C), and an output array (N, C).
type Maps<'py> = FloatsInOut<'py, Ix4, Ix2>;
type MapBits<'py> = BitsInOut<'py, Ix4, Ix2>;
/// Faces (6, S, S, C), and an output array for the next level.
type LevelPair<'py> = FloatsInOut<'py, Ix4, Ix4>;

/// Values, size S and number of channels C of faces (6, S, S, C).
pub fn face_values<'a, T: Element + Copy>(array: &'a Read4<'_, T>) -> PyResult<(&'a [T], u32, usize)> {
    Ok((array.as_slice()?, u32::try_from(array.shape()[1]).unwrap_or(u32::MAX), array.shape()[3]))
}

fn lookup<T: Real + Element>(
    py: Python<'_>,
    (maps, out): &mut (Read4<'_, T>, Write2<'_, T>),
    directions: &Points<'_>,
    name: &str,
    radius: Option<f64>,
) -> PyResult<()> {
    let (values, size, channels) = face_values(maps)?;
    let out = out.as_slice_mut()?;
    with_rows!(directions, rows => run::long(py, None, |progress| {
        let (map, filter) = (CubeFaces::new(values, size, channels)?, texel_filter(name)?);
        match radius {
            Some(radius) => cubemap::footprint(map, rows, radius, filter, out, progress),
            None => cubemap::lookup(map, rows, filter, out, progress),
        }
    }))
}

fn lookup_nearest<T: Element + Copy + Send + Sync>(
    py: Python<'_>,
    (maps, out): &mut (Read4<'_, T>, Write2<'_, T>),
    directions: &Points<'_>,
) -> PyResult<()> {
    let (values, size, channels) = face_values(maps)?;
    let out = out.as_slice_mut()?;
    with_rows!(directions, rows => run::long(py, None, |progress| {
        cubemap::nearest(CubeFaces::new(values, size, channels)?, rows, out, progress)
    }))
}

/// Writes filtered values in directions (N, 3) or, with a radius in radians, the minimum or maximum of the texels that
/// cones about the directions touch.
#[pyfunction]
#[pyo3(signature = (maps, directions, filter, radius=None))]
pub fn cube_lookup(
    py: Python<'_>,
    mut maps: Maps<'_>,
    directions: Points<'_>,
    filter: &str,
    radius: Option<f64>,
) -> PyResult<()> {
    with_array!(Maps::{Single, Double}, &mut maps, maps => lookup(py, maps, &directions, filter, radius))
}

/// Writes the texels that directions (N, 3) pass through.
#[pyfunction]
pub fn cube_nearest(py: Python<'_>, mut maps: MapBits<'_>, directions: Points<'_>) -> PyResult<()> {
    with_array!(MapBits::{One, Two, Four, Eight}, &mut maps, maps => lookup_nearest(py, maps, &directions))
}

/// Writes the next level of a cube map.
#[pyfunction]
pub fn cube_next_level(py: Python<'_>, mut levels: LevelPair<'_>, filter: &str) -> PyResult<()> {
    with_array!(LevelPair::{Single, Double}, &mut levels, levels => reduce(py, levels, filter))
}

fn reduce<T: Real + Element>(
    py: Python<'_>,
    (maps, out): &mut (Read4<'_, T>, Write4<'_, T>),
    filter: &str,
) -> PyResult<()> {
    let reductions = [("mean", Reduction::Mean), ("min", Reduction::Min), ("max", Reduction::Max)];
    let reduction = choice("filter", filter, &reductions).map_err(to_python)?;
    let (values, size, channels) = face_values(maps)?;
    let out = out.as_slice_mut()?;
    run::long(py, None, |progress| {
        cubemap::next_level(CubeFaces::new(values, size, channels)?, reduction, out, progress)
    })
}

/// Writes the solid angle of each texel of a face (S, S), steradians.
#[pyfunction]
pub fn cube_solid_angles(py: Python<'_>, mut out: Write2<'_, f64>) -> PyResult<()> {
    let size = u32::try_from(out.shape()[0]).unwrap_or(u32::MAX);
    let out = out.as_slice_mut()?;
    run::long(py, None, |progress| cubemap::solid_angles(size, out, progress))
}

/// Layout name, number of rows (of one face) and number of columns.
pub type Shape = (String, u32, u32);

fn grid((layout, height, width): &Shape) -> Result<Grid> {
    use Layout::{Cube, Equirectangular, Octahedral};
    let layouts = [("cube", Cube), ("equirectangular", Equirectangular), ("octahedral", Octahedral)];
    let layout = choice("layout", layout, &layouts)?;
    Grid::new(layout, *height, *width)
}

/// Values (N, C) of a picture, and an output array (M, C) for another picture.
type Pictures<'py> = FloatsInOut<'py, Ix2, Ix2>;
type PictureBits<'py> = BitsInOut<'py, Ix2, Ix2>;

fn convert_filtered<T: Real + Element>(
    py: Python<'_>,
    (values, out): &mut (Read2<'_, T>, Write2<'_, T>),
    shapes: &[Shape; 2],
    settings: (&str, u32),
    report: Report,
) -> PyResult<()> {
    let channels = values.shape()[1];
    let (values, out) = (values.as_slice()?, out.as_slice_mut()?);
    run::long(py, report, |progress| {
        let picture = Panorama::new(grid(&shapes[0])?, values, channels)?;
        cubemap::convert(picture, grid(&shapes[1])?, texel_filter(settings.0)?, settings.1, out, progress)
    })
}

fn convert_nearest<T: Element + Copy + Send + Sync>(
    py: Python<'_>,
    (values, out): &mut (Read2<'_, T>, Write2<'_, T>),
    shapes: &[Shape; 2],
    report: Report,
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
pub fn convert_envmap(
    py: Python<'_>,
    mut pictures: Pictures<'_>,
    shapes: [Shape; 2],
    filter: &str,
    samples: u32,
    report: Report,
) -> PyResult<()> {
    with_array!(Pictures::{Single, Double}, &mut pictures, pictures => {
        convert_filtered(py, pictures, &shapes, (filter, samples), report)
    })
}

/// Converts a picture to another layout, with the nearest texels.
#[pyfunction]
#[pyo3(signature = (pictures, shapes, *, report=None))]
pub fn convert_envmap_nearest(
    py: Python<'_>,
    mut pictures: PictureBits<'_>,
    shapes: [Shape; 2],
    report: Report,
) -> PyResult<()> {
    with_array!(PictureBits::{One, Two, Four, Eight}, &mut pictures, pictures => {
        convert_nearest(py, pictures, &shapes, report)
    })
}

/// Writes the directions (N, 3) of all texel centres.
#[pyfunction]
pub fn envmap_directions(py: Python<'_>, shape: Shape, mut out: Write2<'_, f64>) -> PyResult<()> {
    let rows = out.as_slice_mut()?.as_chunks_mut::<3>().0;
    run::long(py, None, |progress| cubemap::grid_directions(grid(&shape)?, rows, progress))
}

/// Writes the number of the texel that each direction (N, 3) passes through.
#[pyfunction]
pub fn envmap_texels(py: Python<'_>, shape: Shape, directions: Points<'_>, mut out: Write1<'_, i64>) -> PyResult<()> {
    let out = out.as_slice_mut()?;
    with_rows!(&directions, rows => {
        run::long(py, None, |progress| cubemap::grid_texels(grid(&shape)?, rows, out, progress))
    })
}
