//! Bindings of `lod`: selection of objects' levels by their size in the picture.

use nearfar_core::lod::{self, Rules, SizeLimit, ThresholdLine};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use super::inputs::{self, EyeParts, Models};
use super::outputs::{self, Column, Levels};
use crate::convert::run;
use crate::lens::RadialLens;

/// Levels of objects, the additional columns if requested, and work counters.
type Selected<'py> = (Levels<'py>, Vec<Column<'py>>, Vec<u64>);

/// Selects the level of each object: the finest level that any eye needs.
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
    let models = inputs::models(&models)?;
    let objects = inputs::objects(&model_index, &centers, &radii, previous.as_ref())?;
    let eyes = if off { Vec::new() } else { inputs::eyes(eyes, acuity) };
    let apparent = inputs::apparent(apparent, lens.as_deref(), tan_omega, exact);
    let limit = if limits_seen { SizeLimit::Seen } else { SizeLimit::Own };
    let rules = Rules { line: ThresholdLine { level: line.0, rise: line.1 }, reference, limit, cull, hysteresis, fade };

    let (level, columns, counts) = outputs::filled(py, radii.len(), full, |to, beside| {
        run::long(py, None, |progress| lod::select(&models, &objects, &eyes, apparent, &rules, to, beside, progress))
    })?;
    Ok((level, columns, outputs::count_list(&counts)))
}
