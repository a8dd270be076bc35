//! Converts Python's arrays and numbers to the selection kernels' models, objects and eyes.

use glam::{DMat3, DQuat, DVec3};
use nearfar_core::camera::Fov;
use nearfar_core::lod::{Acuity, Apparent, Eye, EyeLens, Frustum, Model, Objects};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::lens::RadialLens;

/// Curves of all models (N, 4); index of the first curve of each model, then the number of all curves (M + 1,);
/// least and greatest sizes, and the tangent of a pixel, NaN for none (M, 3).
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

pub(super) fn objects<'a>(
    model_index: &'a PyReadonlyArray1<'_, i64>,
    centers: &'a PyReadonlyArray2<'_, f64>,
    radii: &'a PyReadonlyArray1<'_, f64>,
    previous: Option<&'a PyReadonlyArray1<'_, i32>>,
) -> PyResult<Objects<'a>> {
    Ok(Objects {
        model: model_index.as_slice()?,
        centers: centers.as_slice()?.as_chunks::<3>().0,
        radii: radii.as_slice()?,
        previous: previous.map(|previous| previous.as_slice()).transpose()?,
    })
}

/// Position, orientation, tangents of the view, gaze, degrees per pixel, and a pixel's tangent in the image centre.
pub(super) type EyeParts = ([f64; 3], [f64; 4], [f64; 4], Option<[f64; 3]>, f64, f64);

pub(super) fn eyes(parts: Vec<EyeParts>, acuity: Option<(f64, f64)>) -> Vec<Eye> {
    parts.into_iter().map(|parts| eye(parts, acuity)).collect()
}

fn eye(
    (position, orientation, [left, right, down, up], gaze, degrees, pixel): EyeParts,
    acuity: Option<(f64, f64)>,
) -> Eye {
    let axes = DMat3::from_quat(DQuat::from_array(orientation).normalize());
    let view = Frustum::new(position.into(), axes, &Fov { left, right, down, up });
    let gaze = gaze.map_or(view.forward(), |gaze| direction(gaze.into()));
    let acuity = acuity.map(|(slope, limit)| Acuity { gaze, slope, limit, best: degrees.max(limit) });
    Eye { view, acuity, pixel }
}

/// Measure of apparent size, by name.
pub(super) fn apparent<'a>(kind: &str, lens: Option<&'a RadialLens>, tan_omega: f64, exact: bool) -> Apparent<'a> {
    let lens = lens.map(|lens| EyeLens { lens: lens.inner(), tan_omega, exact });
    match (kind, lens) {
        ("panel", lens) => Apparent::Panel(lens),
        ("axis", Some(lens)) => Apparent::Axis(lens),
        ("area", Some(lens)) => Apparent::Area(lens),
        _ => Apparent::Own,
    }
}

/// Normalises a direction without overflow.
fn direction(vector: DVec3) -> DVec3 {
    (vector / vector.abs().max_element()).normalize()
}
