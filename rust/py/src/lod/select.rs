//! Bindings of `lod`: levels of objects by their size in the picture.

use glam::{DMat3, DQuat, DVec3};
use nearfar_core::camera::Fov;
use nearfar_core::lod::{
    self, Acuity, Apparent, Eye, EyeLens, Frustum, Model, Objects, Rules, SelectionCounts, SizeLimit, ThresholdLine,
};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::run;
use crate::lens::RadialLens;

/// Curves of all models (N, 4); index of the first curve of each model and the number of all curves (M + 1,); least and
/// greatest sizes, and the tangent of a pixel, NaN for none (M, 3).
pub(super) type Models<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, i64>, PyReadonlyArray2<'py, f64>);

pub(super) fn models<'a>((curves, firsts, measured): &'a Models<'_>) -> PyResult<Vec<Model<'a>>> {
    let curves = curves.as_slice()?.as_chunks::<4>().0;
    let pairs = firsts.as_slice()?.windows(2).zip(measured.as_slice()?.as_chunks::<3>().0);
    let model = |(ends, &[least, greatest, pixel]): (&[i64], &[f64; 3])| Model {
        curves: curves.get(ends[0] as usize..ends[1] as usize).unwrap_or_default(),
        range: [least, greatest],
        pixel,
    };
    Ok(pairs.map(model).collect())
}

/// Position, orientation, tangents of the view, gaze, degrees of a pixel, and its tangent in the picture's middle.
pub(super) type EyeParts = ([f64; 3], [f64; 4], [f64; 4], Option<[f64; 3]>, f64, f64);

pub(super) fn eye(
    (position, orientation, [left, right, down, up], gaze, degrees, pixel): EyeParts,
    acuity: Option<(f64, f64)>,
) -> Eye {
    let axes = DMat3::from_quat(DQuat::from_array(orientation).normalize());
    let view = Frustum::new(position.into(), axes, &Fov { left, right, down, up });
    let gaze = gaze.map_or(view.forward(), |gaze| direction(gaze.into()));
    let acuity = acuity.map(|(slope, limit)| Acuity { gaze, slope, limit, best: degrees.max(limit) });
    Eye { view, acuity, pixel }
}

/// How sizes appear, by its name.
pub(super) fn apparent<'a>(kind: &str, lens: Option<EyeLens<'a>>) -> Apparent<'a> {
    match (kind, lens) {
        ("panel", lens) => Apparent::Panel(lens),
        ("axis", Some(lens)) => Apparent::Axis(lens),
        ("area", Some(lens)) => Apparent::Area(lens),
        _ => Apparent::Own,
    }
}

/// The unit vector of a direction, computed without overflow.
fn direction(vector: DVec3) -> DVec3 {
    (vector / vector.abs().max_element()).normalize()
}

pub(super) fn listed(counts: &SelectionCounts) -> Vec<u64> {
    let SelectionCounts { culled, one_level, settled, large, asked, lens, table, formula } = *counts;
    vec![culled, one_level, settled, large, asked, lens, table, formula]
}

/// Arrays of levels and, if requested, of the additional columns, filled by a function.
pub(super) fn filled<'py, T>(
    py: Python<'py>,
    count: usize,
    full: bool,
    fill: impl FnOnce(&mut [i32], Option<[&mut [f64]; lod::COLUMNS]>) -> PyResult<T>,
) -> PyResult<(Levels<'py>, Vec<Column<'py>>, T)> {
    let level = PyArray1::<i32>::zeros(py, count, false);
    let columns: Vec<_> =
        (0..if full { lod::COLUMNS } else { 0 }).map(|_| PyArray1::<f64>::zeros(py, count, false)).collect();
    let mut write = level.readwrite();
    let mut writes: Vec<_> = columns.iter().map(|column| column.readwrite()).collect();
    let mut slices = Vec::new();
    for column in &mut writes {
        slices.push(column.as_slice_mut()?);
    }
    let result = fill(write.as_slice_mut()?, slices.try_into().ok())?;
    drop(writes);
    Ok((level, columns, result))
}

pub(super) type Levels<'py> = Bound<'py, PyArray1<i32>>;
pub(super) type Column<'py> = Bound<'py, PyArray1<f64>>;

/// Levels of objects, the additional columns if requested, and counts of the work.
type Selected<'py> = (Levels<'py>, Vec<Column<'py>>, Vec<u64>);

/// The level of each object: the finest level that any eye needs.
#[pyfunction]
#[pyo3(signature = (models, model_index, centers, radii, *, previous, eyes, line, reference, limits_seen, off, cull, apparent,
    lens, tan_omega, exact, acuity, hysteresis, fade, full))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
pub(crate) fn select_levels<'py>(
    py: Python<'py>,
    models: Models<'py>,
    model_index: PyReadonlyArray1<'py, i64>,
    centers: PyReadonlyArray2<'py, f64>,
    radii: PyReadonlyArray1<'py, f64>,
    previous: Option<PyReadonlyArray1<'py, i32>>,
    eyes: Vec<EyeParts>,
    line: (f64, f64),
    reference: f64,
    limits_seen: bool,
    off: bool,
    cull: bool,
    apparent: &str,
    lens: Option<PyRef<'py, RadialLens>>,
    tan_omega: f64,
    exact: bool,
    acuity: Option<(f64, f64)>,
    hysteresis: f64,
    fade: f64,
    full: bool,
) -> PyResult<Selected<'py>> {
    let models = self::models(&models)?;
    let objects = Objects {
        model: model_index.as_slice()?,
        centers: centers.as_slice()?.as_chunks::<3>().0,
        radii: radii.as_slice()?,
        previous: previous.as_ref().map(|previous| previous.as_slice()).transpose()?,
    };
    let eyes: Vec<Eye> = if off { Vec::new() } else { eyes.into_iter().map(|parts| eye(parts, acuity)).collect() };
    let glass = lens.as_ref().map(|lens| EyeLens { lens: lens.inner(), tan_omega, exact });
    let apparent = self::apparent(apparent, glass);
    let limit = if limits_seen { SizeLimit::Seen } else { SizeLimit::Own };
    let rules = Rules { line: ThresholdLine { level: line.0, rise: line.1 }, reference, limit, cull, hysteresis, fade };

    let (level, columns, counts) = filled(py, radii.len(), full, |to, beside| {
        run::long(py, None, |progress| lod::select(&models, &objects, &eyes, apparent, &rules, to, beside, progress))
    })?;
    Ok((level, columns, listed(&counts)))
}
