//! Bindings of `export`.

use nearfar_core::export::{self, Kind, Settings, Statistics};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::convert::run;
use crate::scene::Scene;

/// A scene divided into files.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Export(export::Export);

/// Bytes, groups and statistics of a mesh with several placements.
type SharedMesh<'py> = (Bound<'py, PyBytes>, Vec<u16>, Bound<'py, PyDict>);

#[pymethods]
impl Export {
    /// `groups` has the group of each object, and last that of faces without an object.
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
            Ok((PyBytes::new(py, &bytes), mesh.groups().to_vec(), named(py, mesh.statistics())?))
        };
        self.0.shared().iter().map(described).collect()
    }

    /// The file of a group and its statistics. `uris` has the URI of each shared mesh, `None` for those that are written
    /// into the file.
    #[pyo3(signature = (group, *, uris, report=None))]
    fn glb<'py>(
        &self,
        py: Python<'py>,
        group: u16,
        uris: Vec<Option<String>>,
        report: Option<Py<PyAny>>,
    ) -> PyResult<(Bound<'py, PyBytes>, Bound<'py, PyDict>)> {
        let glb = run::long(py, report, |progress| self.0.glb(group, &uris, progress))?;
        Ok((PyBytes::new(py, &glb.bytes), named(py, &glb.statistics)?))
    }
}

fn named<'py>(py: Python<'py>, statistics: &Statistics) -> PyResult<Bound<'py, PyDict>> {
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
