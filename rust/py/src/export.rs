//! Bindings of `export`.

use nearfar_core::export::ranges::{self, Faces};
use nearfar_core::export::{self, Kind, Settings, Statistics};
use numpy::{IntoPyArray, PyArray1, PyArray3, PyArrayDyn, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyBytes, PyDict};

use crate::convert::run;
use crate::scene::{Scene, texture};

/// A scene prepared for export to files.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Export(export::Export);

/// Bytes, groups and statistics of a mesh with several placements.
type SharedMesh<'py> = (Bound<'py, PyBytes>, Vec<u16>, Bound<'py, PyDict>);

#[pymethods]
impl Export {
    /// `groups` has the group of each object, then that of the faces without an object.
    #[new]
    #[pyo3(signature = (scene, groups, count, *, names, images, step, compressed, report=None))]
    #[expect(clippy::too_many_arguments, reason = "settings, by keyword only")]
    fn new<'py>(
        py: Python<'py>,
        scene: &Scene,
        groups: PyReadonlyArray1<'py, u16>,
        count: usize,
        names: Vec<String>,
        images: Vec<Option<String>>,
        step: f64,
        compressed: bool,
        report: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let groups = groups.as_slice()?;
        let settings = Settings { step, compressed };
        run::long(py, report, |progress| {
            export::Export::new(&scene.0, groups, count, names, images, settings, progress)
        })
        .map(Self)
    }

    /// Bytes of each mesh with several placements, the groups that place it, and statistics.
    fn shared<'py>(&self, py: Python<'py>) -> PyResult<Vec<SharedMesh<'py>>> {
        let described = |mesh: &export::SharedMesh| {
            let bytes = run::short(py, || Ok(mesh.bytes()))?;
            Ok((PyBytes::new(py, &bytes), mesh.groups().to_vec(), statistics_dict(py, mesh.statistics())?))
        };
        self.0.shared().iter().map(described).collect()
    }

    /// GLB file of a group and its statistics. `uris` has the URI of each shared mesh, `None` for meshes that are
    /// embedded in the file.
    #[pyo3(signature = (group, *, uris, report=None))]
    fn glb<'py>(
        &self,
        py: Python<'py>,
        group: u16,
        uris: Vec<Option<String>>,
        report: Option<Py<PyAny>>,
    ) -> PyResult<(Bound<'py, PyBytes>, Bound<'py, PyDict>)> {
        let glb = run::long(py, report, |progress| self.0.glb(group, &uris, progress))?;
        Ok((PyBytes::new(py, &glb.bytes), statistics_dict(py, &glb.statistics)?))
    }
}

fn statistics_dict<'py>(py: Python<'py>, statistics: &Statistics) -> PyResult<Bound<'py, PyDict>> {
    let (named, bytes) = (PyDict::new(py), PyDict::new(py));
    for kind in Kind::ALL {
        bytes.set_item(kind.name(), statistics.bytes(kind))?;
    }
    named.set_item("bytes", bytes)?;
    for (name, count) in [
        ("raw_bytes", statistics.raw_bytes),
        ("triangles", statistics.triangles),
        ("vertices", statistics.vertices),
        ("drawn", statistics.drawn),
        ("dropped", statistics.dropped),
    ] {
        named.set_item(name, count)?;
    }
    named.set_item("position_error", statistics.position_error)?;
    Ok(named)
}

/// Least number of texels per radian at which each texture is seen. `distances` has the least distance of each
/// object in metres, then that of the faces without an object.
#[pyfunction]
#[pyo3(signature = (scene, distances, *, report=None))]
pub(crate) fn texels_per_radian<'py>(
    py: Python<'py>,
    scene: &Scene,
    distances: PyReadonlyArray1<'py, f64>,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let distances = distances.as_slice()?;
    let found = run::long(py, report, |progress| export::texels_per_radian(&scene.0, distances, progress))?;
    Ok(found.into_pyarray(py))
}

/// Halves the sides of a texture (H, W, 4), sRGB with alpha, `times` times; `cutout` weights colours by alpha.
#[pyfunction]
#[pyo3(signature = (texels, *, times, cutout))]
pub(crate) fn halved_texture<'py>(
    py: Python<'py>,
    texels: Bound<'py, PyArrayDyn<u8>>,
    times: u32,
    cutout: bool,
) -> PyResult<Bound<'py, PyArray3<u8>>> {
    let texture = texture(&texels)?;
    let halved = run::long(py, None, |progress| texture.halved(times, cutout, progress))?;
    let rows = PyArray1::from_slice(py, halved.texels.as_flattened());
    rows.reshape([halved.height as usize, halved.width as usize, 4])
}

/// Codes, and the mask of changed texels.
type Decoded<'py> = (Bound<'py, PyArray1<u16>>, Bound<'py, PyArray1<bool>>);

/// Encodes codes to byte planes: all texels, or only those that differ from the codes `before`.
#[pyfunction]
#[pyo3(signature = (codes, before, changed, *, size, tile, tiles, step))]
#[expect(clippy::too_many_arguments, reason = "settings, by keyword only")]
pub(crate) fn encode_ranges<'py>(
    py: Python<'py>,
    codes: PyReadonlyArray1<'py, u16>,
    before: Option<PyReadonlyArray1<'py, u16>>,
    changed: PyReadonlyArray1<'py, bool>,
    size: usize,
    tile: usize,
    tiles: PyReadonlyArray1<'py, u32>,
    step: f64,
) -> PyResult<Vec<Bound<'py, PyBytes>>> {
    let (codes, changed) = (codes.as_slice()?, changed.as_slice()?);
    let before = before.as_ref().map(PyReadonlyArray1::as_slice).transpose()?;
    let faces = Faces { size, tile, listed: tiles.as_slice()?, step };
    let planes = run::long(py, None, |progress| ranges::encode(codes, before, changed, faces, progress))?;
    Ok(planes.iter().map(|plane| PyBytes::new(py, plane)).collect())
}

/// Decodes the codes of `faces` faces, and the mask of changed texels.
#[pyfunction]
#[pyo3(signature = (planes, before, *, faces, size, tile, tiles, step))]
#[expect(clippy::too_many_arguments, reason = "settings, by keyword only")]
pub(crate) fn decode_ranges<'py>(
    py: Python<'py>,
    planes: Vec<PyBackedBytes>,
    before: Option<PyReadonlyArray1<'py, u16>>,
    faces: usize,
    size: usize,
    tile: usize,
    tiles: PyReadonlyArray1<'py, u32>,
    step: f64,
) -> PyResult<Decoded<'py>> {
    let before = before.as_ref().map(PyReadonlyArray1::as_slice).transpose()?;
    let layout = Faces { size, tile, listed: tiles.as_slice()?, step };
    let planes: Vec<&[u8]> = planes.iter().map(|plane| &plane[..]).collect();
    let (codes, changed) = run::long(py, None, |progress| ranges::decode(&planes, faces, before, layout, progress))?;
    Ok((codes.into_pyarray(py), changed.into_pyarray(py)))
}
