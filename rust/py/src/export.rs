//! Bindings of `export`.

use nearfar_core::export::ranges::{self, Faces};
use nearfar_core::export::{self, Kind, Settings, Statistics};
use numpy::{IntoPyArray, PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{IntoPyDict, PyBytes, PyDict};

use crate::convert::{Array1, Array3, Read1, Report, bytes_of, run};
use crate::scene::{Scene, texture};

/// A scene prepared for export to files.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Export(export::Export);

/// Step of positions in metres, and whether files are compressed.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Encoding {
    step: f64,
    compressed: bool,
}

/// Bytes, groups and statistics of a mesh with several placements.
type SharedMesh<'py> = (Bound<'py, PyBytes>, Vec<u16>, Bound<'py, PyDict>);

#[pymethods]
impl Export {
    /// `groups` has the group of each object, then that of the faces without an object.
    #[new]
    #[pyo3(signature = (scene, groups, count, *, names, images, encoding, report=None))]
    fn new(
        scene: &Bound<'_, Scene>,
        groups: Read1<'_, u16>,
        count: usize,
        names: Vec<String>,
        images: Vec<Option<String>>,
        encoding: Encoding,
        report: Report,
    ) -> PyResult<Self> {
        let (py, scene, groups) = (scene.py(), &scene.get().0, groups.as_slice()?);
        let settings = Settings { step: encoding.step, compressed: encoding.compressed };
        run::long(py, report, |progress| export::Export::new(scene, groups, count, names, images, settings, progress))
            .map(Self)
    }

    /// Bytes of each mesh with several placements, the groups that place it, and statistics.
    fn shared<'py>(&self, py: Python<'py>) -> PyResult<Vec<SharedMesh<'py>>> {
        let describe = |mesh: &export::SharedMesh| {
            let bytes = run::short(py, || mesh.bytes())?;
            Ok((bytes_of(py, &bytes)?, mesh.groups.clone(), statistics_dict(py, mesh.statistics())?))
        };
        self.0.shared.iter().map(describe).collect()
    }

    /// GLB file of a group and its statistics. `uris` has the URI of each shared mesh, `None` for meshes that are
    /// embedded in the file.
    #[pyo3(signature = (group, *, uris, report=None))]
    fn glb<'py>(
        &self,
        py: Python<'py>,
        group: u16,
        uris: Vec<Option<String>>,
        report: Report,
    ) -> PyResult<(Bound<'py, PyBytes>, Bound<'py, PyDict>)> {
        let glb = run::long(py, report, |progress| self.0.glb(group, &uris, progress))?;
        Ok((bytes_of(py, &glb.bytes)?, statistics_dict(py, &glb.statistics)?))
    }
}

fn statistics_dict<'py>(py: Python<'py>, statistics: &Statistics) -> PyResult<Bound<'py, PyDict>> {
    let counts = [
        ("raw_bytes", statistics.raw_bytes),
        ("triangles", statistics.triangles),
        ("vertices", statistics.vertices),
        ("drawn", statistics.drawn),
        ("dropped", statistics.dropped),
    ];
    let dict = counts.into_py_dict(py)?;
    dict.set_item("bytes", Kind::ALL.map(|(kind, name)| (name, statistics.bytes(kind))).into_py_dict(py)?)?;
    dict.set_item("position_error", statistics.position_error)?;
    Ok(dict)
}

/// Least number of texels per radian at which each texture is seen. `distances` has the least distance of each
/// object in metres, then that of the faces without an object.
#[pyfunction]
#[pyo3(signature = (scene, distances, *, report=None))]
pub fn texels_per_radian<'py>(
    py: Python<'py>,
    scene: &Scene,
    distances: Read1<'py, f64>,
    report: Report,
) -> PyResult<Array1<'py, f64>> {
    let distances = distances.as_slice()?;
    let texels = run::long(py, report, |progress| export::texels_per_radian(&scene.0, distances, progress))?;
    Ok(texels.into_pyarray(py))
}

/// Halves the sides of a texture (H, W, 4), sRGB with alpha, `times` times; `cutout` weights colours by alpha.
#[pyfunction]
#[pyo3(signature = (texels, *, times, cutout))]
pub fn halved_texture<'py>(
    py: Python<'py>,
    texels: Bound<'py, PyArrayDyn<u8>>,
    times: u32,
    cutout: bool,
) -> PyResult<Array3<'py, u8>> {
    let texture = texture(&texels)?;
    let halved = run::long(py, None, |progress| texture.halved(times, cutout, progress))?;
    let rows = PyArray1::from_slice(py, halved.texels.as_flattened());
    rows.reshape([halved.height as usize, halved.width as usize, 4])
}

/// Side of a face and of a tile in texels, the listed tiles, and the step of the codes, which are quantised ranges.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct LayoutArguments<'py> {
    size: usize,
    tile: usize,
    tiles: Read1<'py, u32>,
    step: f64,
}

impl LayoutArguments<'_> {
    fn convert(&self) -> PyResult<Faces<'_>> {
        Ok(Faces { size: self.size, tile: self.tile, listed: self.tiles.as_slice()?, step: self.step })
    }
}

/// Codes (quantised ranges), and the mask of changed texels.
type Decoded<'py> = (Array1<'py, u16>, Array1<'py, bool>);

/// Encodes quantised ranges (codes) to byte planes: all texels, or only those that differ from the codes `before`.
#[pyfunction]
pub fn encode_ranges<'py>(
    py: Python<'py>,
    codes: Read1<'py, u16>,
    before: Option<Read1<'py, u16>>,
    changed: Read1<'py, bool>,
    layout: LayoutArguments<'py>,
) -> PyResult<Vec<Bound<'py, PyBytes>>> {
    let (codes, changed) = (codes.as_slice()?, changed.as_slice()?);
    let before = before.as_ref().map(Read1::as_slice).transpose()?;
    let faces = layout.convert()?;
    let planes = run::long(py, None, |progress| ranges::encode(codes, before, changed, faces, progress))?;
    planes.iter().map(|plane| bytes_of(py, plane)).collect()
}

/// Decodes the quantised ranges (codes) of faces, and the mask of changed texels.
#[pyfunction]
pub fn decode_ranges<'py>(
    py: Python<'py>,
    planes: Vec<PyBackedBytes>,
    before: Option<Read1<'py, u16>>,
    face_count: usize,
    layout: LayoutArguments<'py>,
) -> PyResult<Decoded<'py>> {
    let before = before.as_ref().map(Read1::as_slice).transpose()?;
    let layout = layout.convert()?;
    let planes: Vec<&[u8]> = planes.iter().map(|plane| &plane[..]).collect();
    let (codes, changed) =
        run::long(py, None, |progress| ranges::decode(&planes, face_count, before, layout, progress))?;
    Ok((codes.into_pyarray(py), changed.into_pyarray(py)))
}
