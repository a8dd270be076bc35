//! Bindings of `metrics`.

use std::slice;

use glam::DVec3;
use nearfar_core::base::{Error, Result};
use nearfar_core::metrics::{
    self, Border, Comparison, Neighbourhood, Pixel, PixelRows, Plane, Similarity, SimilaritySums, Stacks, Window,
};
use numpy::{Element, IntoPyArray, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::convert::{Array1, Read1, Read3, ReadAny, Report, argument_enum, run, to_python, zeros};

argument_enum! {
    /// Stacks of images of any type, with the image in the last two axes; strides are non-negative multiples of the
    /// element size.
    pub enum Images<'py> {
        Bytes(ReadAny<'py, u8>),
        Shorts(ReadAny<'py, u16>),
        Floats(ReadAny<'py, f32>),
        Doubles(ReadAny<'py, f64>),
    }
}

/// Evaluates `$body` with the arrays of two stacks of the same type.
macro_rules! with_arrays {
    ($references:expr, $tests:expr, ($a:ident, $b:ident) => $body:expr) => {
        match ($references, $tests) {
            (Images::Bytes($a), Images::Bytes($b)) => $body,
            (Images::Shorts($a), Images::Shorts($b)) => $body,
            (Images::Floats($a), Images::Floats($b)) => $body,
            (Images::Doubles($a), Images::Doubles($b)) => $body,
            _ => Err(to_python(Error::value("test", "the reference's type", "another one"))),
        }
    };
}

fn planes<'a, T: Element + Pixel>(array: &'a ReadAny<'_, T>) -> Result<Vec<Plane<'a, T>>> {
    let size = size_of::<T>() as isize;
    let step = |&bytes: &isize| {
        let is_multiple = bytes >= 0 && bytes % size == 0;
        let error = || Error::value("image", "steps of whole values", bytes);
        is_multiple.then_some((bytes / size) as usize).ok_or_else(error)
    };
    let steps = array.strides().iter().map(step).collect::<Result<Vec<_>>>()?;
    let last = array.shape().iter().zip(&steps).map(|(&length, &step)| length.saturating_sub(1) * step).sum::<usize>();
    let length = if array.is_empty() { 0 } else { last + 1 };
    // SAFETY: the array holds its first value at `data` and its last value `length - 1` values behind it. It is
    // borrowed for reading as long as the slice lives.
    let values = unsafe { slice::from_raw_parts(array.data(), length) };
    Plane::stack(values, array.shape(), &steps)
}

fn stacks<'a, T: Element + Pixel>(
    references: &'a ReadAny<'_, T>,
    tests: &'a ReadAny<'_, T>,
    masks: Option<&'a ReadAny<'_, u8>>,
) -> PyResult<Stacks<'a, T>> {
    let masks = masks.map(planes).transpose().map_err(to_python)?;
    Ok(Stacks { references: planes(references).map_err(to_python)?, tests: planes(tests).map_err(to_python)?, masks })
}

/// Mean squared difference, and the least and the greatest value of both images.
type MeanSquare = (f64, f64, f64);

/// Mean squared error of each pair of images and, if requested, the range of their values.
#[pyfunction]
#[pyo3(signature = (references, tests, *, ranges))]
pub fn mean_squared_errors(
    py: Python<'_>,
    references: Images<'_>,
    tests: Images<'_>,
    ranges: bool,
) -> PyResult<Vec<MeanSquare>> {
    with_arrays!(&references, &tests, (a, b) => {
        let stacks = stacks(a, b, None)?;
        let errors = run::long(py, None, |progress| stacks.mean_squared_errors(ranges, progress))?;
        Ok(errors.iter().map(|error| (error.mean, error.range.least, error.range.greatest)).collect())
    })
}

/// Settings of a comparison: window, its size and σ, (c1, c2), the factor by which images are shrunk first, whether
/// to include windows across the image's border, whether windows ignore masked pixels, and whether the ranges of values
/// are requested.
type Settings = (String, usize, f64, (f64, f64), usize, bool, bool, bool);

fn comparison(
    (window, size, sigma, (c1, c2), shrink, includes_border, masks_windows, ranges): Settings,
) -> Result<Comparison> {
    let window = match window.as_str() {
        "gaussian" => Window::gaussian(size, sigma),
        "uniform" => Window::uniform(size),
        "global" => Window::Global,
        _ => return Err(Error::value("window", "'gaussian', 'uniform' or 'global'", format!("'{window}'"))),
    };
    Ok(Comparison { window, constants: Similarity { c1, c2 }, shrink, includes_border, masks_windows, ranges })
}

/// Sums of similarity and of pixels, the least and the greatest value of both images; and similarity maps.
type Compared<'py> = (Vec<[f64; 4]>, Option<Bound<'py, PyAny>>);

fn compare<'py, P: PixelRows<Real: PixelRows<Real = P::Real> + Element> + Element>(
    py: Python<'py>,
    stacks: &Stacks<'_, P>,
    comparison: &Comparison,
    map_shape: Option<Vec<usize>>,
    report: Report,
) -> PyResult<Compared<'py>> {
    let maps = map_shape.map(|shape| zeros::<P::Real, _>(py, shape)).transpose()?;
    let mut writer = maps.as_ref().map(|maps| maps.readwrite());
    let out = writer.as_mut().map(|writer| writer.as_slice_mut()).transpose()?;
    let sums = run::long(py, report, |progress| stacks.compare(comparison, out, progress))?;
    drop(writer);
    let row = |sums: &SimilaritySums| [sums.similarity, sums.pixels, sums.range.least, sums.range.greatest];
    Ok((sums.iter().map(row).collect(), maps.map(Bound::into_any)))
}

/// Sums of similarity, numbers of pixels and ranges of values for each pair and, if requested, maps of `map_shape`.
#[pyfunction]
#[pyo3(signature = (references, tests, *, settings, masks=None, map_shape=None, report=None))]
pub fn similarity<'py>(
    py: Python<'py>,
    references: Images<'py>,
    tests: Images<'py>,
    settings: Settings,
    masks: Option<ReadAny<'py, u8>>,
    map_shape: Option<Vec<usize>>,
    report: Report,
) -> PyResult<Compared<'py>> {
    let comparison = comparison(settings).map_err(to_python)?;
    with_arrays!(&references, &tests, (a, b) => {
        compare(py, &stacks(a, b, masks.as_ref())?, &comparison, map_shape, report)
    })
}

/// Means of similarity and of its contrast–structure factor at each scale, and the least and greatest value of both images.
type AtScales = (Vec<[f64; 2]>, f64, f64);

/// Compares each pair of images at each of `scales` scales.
#[pyfunction]
#[pyo3(signature = (references, tests, *, settings, scales))]
pub fn multiscale(
    py: Python<'_>,
    references: Images<'_>,
    tests: Images<'_>,
    settings: Settings,
    scales: usize,
) -> PyResult<Vec<AtScales>> {
    let comparison = comparison(settings).map_err(to_python)?;
    with_arrays!(&references, &tests, (a, b) => {
        let stacks = stacks(a, b, None)?;
        let pairs = run::long(py, None, |progress| stacks.multiscale(&comparison, scales, progress))?;
        Ok(pairs.into_iter().map(|pair| (pair.means, pair.range.least, pair.range.greatest)).collect())
    })
}

/// Discontinuity of each pixel, as a flat array; positions (H, W, 3) are relative to `origin`.
#[pyfunction]
#[pyo3(signature = (position, *, origin, camera, epsilon, min_distance, report=None))]
pub fn discontinuity<'py>(
    py: Python<'py>,
    position: Read3<'py, f32>,
    origin: [f64; 3],
    camera: &Camera,
    epsilon: f64,
    min_distance: f64,
    report: Report,
) -> PyResult<Array1<'py, f32>> {
    let (rows, width) = (position.as_slice()?.as_chunks::<3>().0, position.shape()[1]);
    let (origin, neighbourhood) = (DVec3::from_array(origin), Neighbourhood { epsilon, least: min_distance });
    let map = run::long(py, report, |progress| {
        metrics::discontinuity(rows, origin, width, &camera.0, neighbourhood, progress)
    })?;
    Ok(map.into_pyarray(py))
}

/// Tears, and the mask of pixels whose neighbourhoods are partly inside and partly outside the mask `side`.
type Torn<'py> = (Array1<'py, f32>, Array1<'py, bool>);

/// Tear of each pixel in pixels, as a flat array. `side` is a mask that divides the frame's surfaces, such as those with
/// ρ > r₂; if it is given, also whether a pixel's neighbourhood is partly inside and partly outside it.
#[pyfunction]
#[pyo3(signature = (position, *, origin, camera, epsilon, side=None, mask=None, report=None))]
pub fn tear<'py>(
    position: Read3<'py, f32>,
    origin: [f64; 3],
    camera: &Bound<'py, Camera>,
    epsilon: f64,
    side: Option<Read1<'py, bool>>,
    mask: Option<Read1<'py, bool>>,
    report: Report,
) -> PyResult<Torn<'py>> {
    let (py, camera, origin) = (camera.py(), &camera.get().0, DVec3::from_array(origin));
    let (rows, width) = (position.as_slice()?.as_chunks::<3>().0, position.shape()[1]);
    let border = Border {
        side: side.as_ref().map(Read1::as_slice).transpose()?,
        mask: mask.as_ref().map(Read1::as_slice).transpose()?,
    };
    let tears =
        run::long(py, report, |progress| metrics::tear(rows, origin, width, camera, epsilon, border, progress))?;
    Ok((tears.tear.into_pyarray(py), tears.spans_sides.into_pyarray(py)))
}

/// Shares of visible objects and of their visible pixels; `None` without objects.
#[pyfunction]
pub fn object_completion(
    py: Python<'_>,
    reference: Read1<'_, i32>,
    test: Read1<'_, i32>,
) -> PyResult<Option<(f64, f64)>> {
    let (reference, test) = (reference.as_slice()?, test.as_slice()?);
    run::short(py, || Ok(metrics::object_completion(reference, test)))
}
