//! Bindings of `lod`: selection of objects' levels by their size in the picture, or under a budget of triangles.

use glam::{DMat3, DQuat, DVec3};
use nearfar_core::camera::Fov;
use nearfar_core::lod::{
    self, Acuity, Apparent, Budget, BudgetRules, Eye, EyeLens, Frustum, Model, Objects, RatedModel, Rules,
    SelectionCounts, SizeLimit, ThresholdLine, Weights,
};
use numpy::PyArrayMethods;
use pyo3::prelude::*;

use crate::convert::{Array1, Read1, Read2, run, zeros};
use crate::lens::RadialLens;

/// Curves of all models (N, 4); index of the first curve of each model, then the number of all curves (M + 1,);
/// least and greatest sizes, and the tangent of a pixel, NaN for none (M, 3).
type Models<'py> = (Read2<'py, f64>, Read1<'py, i64>, Read2<'py, f64>);

/// Position, orientation, tangents of the view, gaze, degrees per pixel, and a pixel's tangent in the image centre.
type EyeParts = ([f64; 3], [f64; 4], [f64; 4], Option<[f64; 3]>, f64, f64);

/// Models, objects, eyes and rules, by the names in `Selector.select`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Inputs<'py> {
    models: Models<'py>,
    model_index: Read1<'py, i64>,
    centers: Read2<'py, f64>,
    radii: Read1<'py, f64>,
    previous: Option<Read1<'py, i32>>,
    eyes: Vec<EyeParts>,
    line: (f64, f64),
    cull: bool,
    apparent: String,
    lens: Option<Py<RadialLens>>,
    tan_omega: f64,
    exact: bool,
    acuity: Option<(f64, f64)>,
    hysteresis: f64,
    full: bool,
}

impl Inputs<'_> {
    fn models(&self) -> PyResult<Vec<Model<'_>>> {
        let (curves, firsts, measured) = &self.models;
        let curves = curves.as_slice()?.as_chunks::<4>().0;
        let pairs = firsts.as_slice()?.windows(2).zip(measured.as_slice()?.as_chunks::<3>().0);
        let model = |(ends, &[least, greatest, pixel]): (&[i64], &[f64; 3])| Model {
            curves: curves.get(ends[0] as usize..ends[1] as usize).unwrap_or_default(),
            range: [least, greatest],
            pixel,
        };
        Ok(pairs.map(model).collect())
    }

    fn objects(&self) -> PyResult<Objects<'_>> {
        Ok(Objects {
            model: self.model_index.as_slice()?,
            centers: self.centers.as_slice()?.as_chunks::<3>().0,
            radii: self.radii.as_slice()?,
            previous: self.previous.as_ref().map(|previous| previous.as_slice()).transpose()?,
        })
    }

    fn eyes(&self) -> Vec<Eye> {
        let eye = |&(position, orientation, [left, right, down, up], gaze, degrees, pixel): &EyeParts| {
            let axes = DMat3::from_quat(DQuat::from_array(orientation).normalize());
            let view = Frustum::new(position.into(), axes, &Fov { left, right, down, up });
            let gaze = gaze.map_or(view.forward(), |gaze| direction(gaze.into()));
            let acuity = self.acuity.map(|(slope, limit)| Acuity { gaze, slope, limit, best: degrees.max(limit) });
            Eye { view, acuity, pixel }
        };
        self.eyes.iter().map(eye).collect()
    }

    fn line(&self) -> ThresholdLine {
        ThresholdLine { level: self.line.0, rise: self.line.1 }
    }

    /// Measure of apparent size.
    fn apparent(&self) -> Apparent<'_> {
        let lens = self.lens.as_ref();
        let lens = lens.map(|lens| EyeLens { lens: &lens.get().0, tan_omega: self.tan_omega, exact: self.exact });
        match (self.apparent.as_str(), lens) {
            ("panel", lens) => Apparent::Panel(lens),
            ("axis", Some(lens)) => Apparent::Axis(lens),
            ("area", Some(lens)) => Apparent::Area(lens),
            _ => Apparent::Own,
        }
    }
}

/// Normalises a direction without overflow.
fn direction(vector: DVec3) -> DVec3 {
    (vector / vector.abs().max_element()).normalize()
}

type Levels<'py> = Array1<'py, i32>;

fn count_list(counts: &SelectionCounts) -> Vec<u64> {
    let SelectionCounts { culled, one_level, settled, large, asked, lens, table, formula } = *counts;
    vec![culled, one_level, settled, large, asked, lens, table, formula]
}

/// Creates the arrays of levels and, if `full`, of the additional columns; `fill` writes their values.
fn create_columns<'py, T>(
    py: Python<'py>,
    count: usize,
    full: bool,
    fill: impl FnOnce(&mut [i32], Option<[&mut [f64]; lod::COLUMNS]>) -> PyResult<T>,
) -> PyResult<(Levels<'py>, Vec<Array1<'py, f64>>, T)> {
    let level = zeros::<i32, _>(py, count)?;
    let columns = (0..lod::COLUMNS).filter(|_| full).map(|_| zeros::<f64, _>(py, count));
    let columns = columns.collect::<PyResult<Vec<_>>>()?;
    let mut level_writer = level.readwrite();
    let mut writers: Vec<_> = columns.iter().map(|column| column.readwrite()).collect();
    let slices = writers.iter_mut().map(|writer| writer.as_slice_mut()).collect::<Result<Vec<_>, _>>()?;
    let result = fill(level_writer.as_slice_mut()?, slices.try_into().ok())?;
    drop(writers);
    Ok((level, columns, result))
}

/// Levels of objects, the additional columns if requested, and work counters.
type Selected<'py> = (Levels<'py>, Vec<Array1<'py, f64>>, Vec<u64>);

/// Selects the level of each object: the finest level that any eye needs.
#[pyfunction]
#[pyo3(signature = (inputs, *, reference, limits_seen, off, fade))]
pub fn select_levels<'py>(
    py: Python<'py>,
    inputs: Inputs<'py>,
    reference: f64,
    limits_seen: bool,
    off: bool,
    fade: f64,
) -> PyResult<Selected<'py>> {
    let (models, objects, apparent) = (inputs.models()?, inputs.objects()?, inputs.apparent());
    let eyes = if off { Vec::new() } else { inputs.eyes() };
    let limit = if limits_seen { SizeLimit::Seen } else { SizeLimit::Own };
    let (line, cull, hysteresis) = (inputs.line(), inputs.cull, inputs.hysteresis);
    let rules = Rules { line, reference, limit, cull, hysteresis, fade };

    let (level, columns, counts) = create_columns(py, objects.radii.len(), inputs.full, |levels, columns| {
        run::long(py, None, |progress| {
            lod::select(&models, &objects, &eyes, apparent, &rules, levels, columns, progress)
        })
    })?;
    Ok((level, columns, count_list(&counts)))
}

/// Triangles of a picture and their distribution, by the names in `Selector.select`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct BudgetArguments<'py> {
    budget: u64,
    by_pixels: bool,
    weight: Option<Read1<'py, f64>>,
    floor: Option<f64>,
    price: Option<f64>,
}

impl BudgetArguments<'_> {
    fn convert(&self) -> PyResult<Budget<'_>> {
        let weights = match &self.weight {
            Some(weight) => Weights::Each(weight.as_slice()?),
            None if self.by_pixels => Weights::Pixels,
            None => Weights::Object,
        };
        Ok(Budget { triangles: self.budget, weights, floor: self.floor, price: self.price })
    }
}

/// Levels of objects, the additional columns if requested, work counters, price, triangles and mean score.
type Bought<'py> = (Levels<'py>, Vec<Array1<'py, f64>>, Vec<u64>, (f64, u64, f64));

/// Chooses levels with the greatest weighted score within a budget. `triangles` has the counts of all levels, model by
/// model, `rises` (N, 4) the curves that are added to those of the models.
#[pyfunction]
pub fn spend_triangles<'py>(
    py: Python<'py>,
    inputs: Inputs<'py>,
    triangles: Read1<'py, i64>,
    rises: Read2<'py, f64>,
    budget: BudgetArguments<'py>,
) -> PyResult<Bought<'py>> {
    let (mut triangles, mut rises) = (triangles.as_slice()?, rises.as_slice()?.as_chunks::<4>().0);
    let mut rated = Vec::new();
    for model in inputs.models()? {
        let (level_triangles, others) = triangles.split_at(model.curves.len() + 1);
        let (level_rises, other_rises) = rises.split_at(model.curves.len());
        rated.push(RatedModel { model, rises: level_rises, triangles: level_triangles });
        (triangles, rises) = (others, other_rises);
    }
    let (objects, eyes, budget) = (inputs.objects()?, inputs.eyes(), budget.convert()?);
    let (line, apparent) = (inputs.line(), inputs.apparent());
    let rules = BudgetRules { line, apparent, cull: inputs.cull, hysteresis: inputs.hysteresis };

    let (level, columns, spent) = create_columns(py, objects.radii.len(), inputs.full, |levels, columns| {
        run::long(py, None, |progress| lod::spend(&rated, &objects, &eyes, &rules, &budget, levels, columns, progress))
    })?;
    Ok((level, columns, count_list(&spent.counts), (spent.price, spent.triangles, spent.score)))
}

/// Fails unless all values are valid weights.
#[pyfunction]
pub fn check_weights(py: Python<'_>, weight: Read1<'_, f64>) -> PyResult<()> {
    let weights = Weights::Each(weight.as_slice()?);
    run::short(py, || weights.check())
}
