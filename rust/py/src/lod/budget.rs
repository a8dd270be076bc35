//! Bindings of `lod`: levels under a budget of triangles.

use nearfar_core::lod::{self, Budget, BudgetRules, RatedModel, ThresholdLine, Weights};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use super::inputs::{self, EyeParts, Models};
use super::outputs::{self, Column, Levels};
use crate::convert::run;
use crate::lens::RadialLens;

/// Levels of objects, the additional columns if requested, work counters, price, triangles and mean score.
type Bought<'py> = (Levels<'py>, Vec<Column<'py>>, Vec<u64>, (f64, u64, f64));

/// Chooses levels with the greatest weighted score within a budget. `triangles` has the counts of all levels, model by
/// model.
#[pyfunction]
#[pyo3(signature = (models, triangles, model_index, centers, radii, *, previous, eyes, line, cull, apparent, lens,
    tan_omega, exact, acuity, hysteresis, budget, by_pixels, weight, floor, price, full))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
pub(crate) fn spend_triangles<'py>(
    py: Python<'py>,
    models: Models<'py>,
    triangles: PyReadonlyArray1<'py, i64>,
    model_index: PyReadonlyArray1<'py, i64>,
    centers: PyReadonlyArray2<'py, f64>,
    radii: PyReadonlyArray1<'py, f64>,
    previous: Option<PyReadonlyArray1<'py, i32>>,
    eyes: Vec<EyeParts>,
    line: (f64, f64),
    cull: bool,
    apparent: &str,
    lens: Option<PyRef<'py, RadialLens>>,
    tan_omega: f64,
    exact: bool,
    acuity: Option<(f64, f64)>,
    hysteresis: f64,
    budget: u64,
    by_pixels: bool,
    weight: Option<PyReadonlyArray1<'py, f64>>,
    floor: Option<f64>,
    price: Option<f64>,
    full: bool,
) -> PyResult<Bought<'py>> {
    let mut triangles = triangles.as_slice()?;
    let mut rated = Vec::new();
    for model in inputs::models(&models)? {
        let (own, rest) = triangles.split_at(model.curves.len() + 1);
        rated.push(RatedModel { model, triangles: own });
        triangles = rest;
    }
    let objects = inputs::objects(&model_index, &centers, &radii, previous.as_ref())?;
    let eyes = inputs::eyes(eyes, acuity);
    let apparent = inputs::apparent(apparent, lens.as_deref(), tan_omega, exact);
    let line = ThresholdLine { level: line.0, rise: line.1 };
    let rules = BudgetRules { line, apparent, cull, hysteresis };
    let weights = match &weight {
        Some(each) => Weights::Each(each.as_slice()?),
        None if by_pixels => Weights::Pixels,
        None => Weights::Object,
    };
    let budget = Budget { triangles: budget, weights, floor, price };

    let (level, columns, spent) = outputs::filled(py, radii.len(), full, |to, beside| {
        run::long(py, None, |progress| lod::spend(&rated, &objects, &eyes, &rules, &budget, to, beside, progress))
    })?;
    Ok((level, columns, outputs::count_list(&spent.counts), (spent.price, spent.triangles, spent.score)))
}

/// Fails unless all values are valid weights.
#[pyfunction]
pub(crate) fn check_weights(py: Python<'_>, weight: PyReadonlyArray1<'_, f64>) -> PyResult<()> {
    let weights = Weights::Each(weight.as_slice()?);
    run::short(py, || weights.check())
}
