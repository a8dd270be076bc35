//! Bindings of `partition`.

use glam::DVec3;
use nearfar_core::base::{Real, Result};
use nearfar_core::partition::{self, Rule, TriangleSet};
use numpy::{Element, PyArray1, PyArrayMethods, ToPyArray};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::convert::{Array1, Array2, Points, Read1, Read2, Report, choice, filled, run, with_array};
use crate::scene::Scene;

fn measure<'py, T: Real + Element>(
    py: Python<'py>,
    vertices: &Read2<'py, T>,
    faces: Option<&Read2<'py, u32>>,
    center: [f64; 3],
    report: Report,
) -> PyResult<Py<PyAny>> {
    let rows = vertices.as_slice()?.as_chunks::<3>().0;
    let faces = faces.map(|faces| faces.as_slice()).transpose()?.map(|flat| flat.as_chunks::<3>().0);
    let count = faces.map_or(rows.len() / 3, <[_]>::len);
    let axis = [center[0], center[2]];
    let measure = |to: &mut [T]| {
        let to = to.as_chunks_mut().0;
        run::long(py, report, |progress| partition::triangle_radii(rows, faces, axis, to, progress))
    };
    filled(py, [count, 2], measure)?.into_py_any(py)
}

/// Least and greatest distance (F, 2) of triangles from a vertical axis, in the vertices' type.
#[pyfunction]
#[pyo3(signature = (vertices, faces, center, report=None))]
pub fn triangle_radii(
    py: Python<'_>,
    vertices: Points<'_>,
    faces: Option<Read2<'_, u32>>,
    center: [f64; 3],
    report: Report,
) -> PyResult<Py<PyAny>> {
    with_array!(Points::{Single, Double}, &vertices, vertices => {
        measure(py, vertices, faces.as_ref(), center, report)
    })
}

/// A scene divided at two radii.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Partition(pub partition::Partition);

fn part(name: &str) -> Result<TriangleSet> {
    use TriangleSet::{Far, Intermediate, Near, Nsf, Sf};
    choice("part", name, &[("near", Near), ("intermediate", Intermediate), ("far", Far), ("nsf", Nsf), ("sf", Sf)])
}

#[pymethods]
impl Partition {
    #[new]
    #[pyo3(signature = (scene, *, center, r1, r2, report=None))]
    fn new(py: Python<'_>, scene: &Scene, center: [f64; 3], r1: f64, r2: f64, report: Report) -> PyResult<Self> {
        let center = DVec3::from_array(center);
        run::long(py, report, |progress| partition::Partition::new(&scene.0, center, r1, r2, progress)).map(Self)
    }

    /// Numbers of the triangles of a set, ascending.
    fn triangles<'py>(&self, py: Python<'py>, part: &str) -> PyResult<Array1<'py, i64>> {
        let numbers = run::long(py, None, |progress| self.0.triangles(self::part(part)?, progress))?;
        Ok(PyArray1::from_vec(py, numbers))
    }

    /// Numbers of the objects with static triangles that are drawn as geometry, ascending.
    fn near_objects<'py>(&self, py: Python<'py>) -> PyResult<Array1<'py, i32>> {
        Ok(PyArray1::from_vec(py, run::long(py, None, |_| Ok(self.0.near_objects()))?))
    }

    /// Numbers of triangles and instances by name.
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let counts = &self.0.counts;
        let counts = [
            ("triangles", counts.triangles),
            ("near", counts.near),
            ("intermediate", counts.intermediate),
            ("far", counts.far),
            ("straddling", counts.straddling),
            ("nsf", counts.nsf),
            ("nsf_at_r1", counts.nsf_at_r1),
            ("sf", counts.sf),
            ("near_instances", counts.near_instances),
            ("intermediate_instances", counts.intermediate_instances),
            ("far_instances", counts.far_instances),
            ("mixed_instances", counts.mixed_instances),
            ("examined", counts.examined),
            ("measured", counts.measured),
        ];
        counts.into_py_dict(py)
    }

    /// Measures every triangle again and compares the results.
    #[pyo3(signature = (report=None))]
    fn validate(&self, py: Python<'_>, report: Report) -> PyResult<()> {
        run::long(py, report, |progress| self.0.validate(progress))
    }
}

/// Number of triangles that stay geometry as a function of r₂.
#[pyclass(frozen, module = "nearfar._core")]
pub struct LoadCurve(partition::LoadCurve);

#[pymethods]
impl LoadCurve {
    #[new]
    #[pyo3(signature = (scene, *, center, report=None))]
    fn new(py: Python<'_>, scene: &Scene, center: [f64; 3], report: Report) -> PyResult<Self> {
        let center = DVec3::from_array(center);
        run::long(py, report, |progress| partition::LoadCurve::new(&scene.0, center, progress)).map(Self)
    }

    /// Number of triangles that stay geometry at each radius.
    fn count<'py>(&self, py: Python<'py>, r2: Read1<'py, f64>) -> PyResult<Array1<'py, i64>> {
        let radii = r2.as_slice()?;
        let counts: Vec<i64> = run::long(py, None, |progress| self.0.counts(radii, progress))?;
        Ok(counts.to_pyarray(py))
    }

    /// Greatest radius for each budget.
    fn radius<'py>(&self, py: Python<'py>, budget: Read1<'py, i64>) -> PyResult<Array1<'py, f64>> {
        let budgets = budget.as_slice()?;
        let radii: Vec<f64> = run::long(py, None, |progress| self.0.radii(budgets, progress))?;
        Ok(radii.to_pyarray(py))
    }

    #[getter]
    fn total(&self) -> i64 {
        self.0.total()
    }

    #[getter]
    fn moving(&self) -> i64 {
        self.0.moving
    }
}

/// Least ρ of each object's static triangles within `reach`, then that of the faces without an object; and the number
/// of measured triangles.
#[pyfunction]
#[pyo3(signature = (scene, object_count, *, center, reach, rule, report=None))]
pub fn object_radii<'py>(
    py: Python<'py>,
    scene: &Scene,
    object_count: usize,
    center: [f64; 3],
    reach: f64,
    rule: &str,
    report: Report,
) -> PyResult<(Array1<'py, f32>, i64)> {
    let center = DVec3::from_array(center);
    let radii = run::long(py, report, |progress| {
        let rule = choice("rule", rule, &[("object", Rule::Surface), ("vertex", Rule::Vertex)])?;
        partition::object_radii(&scene.0, object_count, center, reach, rule, progress)
    })?;
    Ok((PyArray1::from_vec(py, radii.least), radii.measured))
}

/// Triangles drawn and stored, and instances that place shared meshes, by ring (count, 3).
#[pyfunction]
pub fn ring_loads<'py>(
    py: Python<'py>,
    scene: &Scene,
    rings: Read1<'py, u16>,
    count: usize,
) -> PyResult<Array2<'py, i64>> {
    let rings = rings.as_slice()?;
    let loads = run::long(py, None, |progress| partition::ring_loads(&scene.0, rings, count, progress))?;
    let rows: Vec<i64> = loads.iter().flat_map(|load| [load.drawn, load.stored, load.placed]).collect();
    PyArray1::from_vec(py, rows).reshape([count, 3])
}
