//! Bindings of `impostor`.

use glam::DVec3;
use nearfar_core::impostor::{self, Settings, Sheet};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::{Report, run};
use crate::scene::Scene;

/// Settings of a bake by their public names.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct BakeArguments {
    center: [f64; 3],
    reach: f64,
    height: f64,
    r2: f64,
    size: u32,
    angle: f64,
    centers: u32,
    missing: f64,
}

/// Quads of a bake, which the bake of another region of the same scene can use again.
#[pyclass(frozen, module = "nearfar._core")]
pub struct ImpostorSheets(Vec<Sheet>);

#[pymethods]
impl ImpostorSheets {
    /// Bytes of the quads.
    fn bytes(&self) -> usize {
        self.0.iter().map(Sheet::bytes).sum()
    }
}

/// Textured quads of the far part: vertices (V, 3) relative to the centre, texture coordinates (V, 2), faces (F, 3),
/// the quad of each face (F,), object number (−1 without one) and mask of each quad (Q,), and the atlas (H, W, 4), by name; with the layers' centres
/// and numbers of quads, the number of quads `shared` with the bake of `earlier`, which are the first, the shares of
/// missing pixels, and the numbers of the near static triangles that rays from the region hit.
#[pyfunction]
#[pyo3(signature = (scene, settings, *, earlier=None, report=None))]
pub fn bake_impostors<'py>(
    py: Python<'py>,
    scene: &Scene,
    settings: BakeArguments,
    earlier: Option<&ImpostorSheets>,
    report: Report,
) -> PyResult<Bound<'py, PyDict>> {
    let BakeArguments { center, reach, height, r2, size, angle, centers, missing } = settings;
    let settings = Settings { center: DVec3::from_array(center), reach, height, r2, size, angle, centers, missing };
    let earlier = earlier.map_or(&[][..], |sheets| &sheets.0);
    let baked = run::long(py, report, |progress| impostor::bake(&scene.0, &settings, earlier, progress))?;
    let mesh = baked.mesh;
    let result = PyDict::new(py);
    let rows = |values: usize| [values, 3];
    let vertices = mesh.positions.len();
    result.set_item("vertices", PyArray1::from_vec(py, mesh.positions.into_flattened()).reshape(rows(vertices))?)?;
    result.set_item("uv", PyArray1::from_vec(py, mesh.uv.into_flattened()).reshape([vertices, 2])?)?;
    let faces = mesh.faces.len();
    result.set_item("faces", PyArray1::from_vec(py, mesh.faces.into_flattened()).reshape(rows(faces))?)?;
    result.set_item("quads", PyArray1::from_vec(py, mesh.quads))?;
    result.set_item("objects", PyArray1::from_vec(py, mesh.objects))?;
    result.set_item("masked", PyArray1::from_vec(py, mesh.masked))?;
    let [width, height] = mesh.size.map(|side| side as usize);
    result.set_item("atlas", PyArray1::from_vec(py, mesh.texels.into_flattened()).reshape([height, width, 4])?)?;
    result.set_item("layers", baked.layers)?;
    result.set_item("shared", baked.shared)?;
    result.set_item("sheets", ImpostorSheets(baked.sheets))?;
    result.set_item("missing", baked.missing)?;
    result.set_item("seen", PyArray1::from_vec(py, baked.seen))?;
    Ok(result)
}
