//! Bindings of `orthoview`: views of leaves and of parents, and connections of pixels.

use glam::DVec3;
use nearfar_core::base::Error;
use nearfar_core::orthoview::{
    Bounds, Cell, Direction, Format, Parent, SurfaceMethod, Texel, Views, connected, surfels, unseen,
};
use numpy::{Element, IntoPyArray, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::{Array4, Read4, Report, choice, run, to_python};
use crate::scene::Scene;

/// Size of a view, bits of a depth, bits of a normal.
type FormatNumbers = (usize, u32, u32);

fn format_of((size, depth_bits, normal_bits): FormatNumbers) -> PyResult<Format> {
    Format::new(size, depth_bits, normal_bits).map_err(to_python)
}

pub fn directions_of(directions: Vec<[i8; 3]>) -> PyResult<Vec<Direction>> {
    directions.into_iter().map(Direction::new).collect::<Result<_, _>>().map_err(to_python)
}

fn shape_of<T: Element>(array: &Read4<'_, T>) -> [usize; 4] {
    std::array::from_fn(|axis| array.shape()[axis])
}

fn check_shape(argument: &'static str, shape: [usize; 4], expected: [usize; 4]) -> PyResult<()> {
    if shape == expected {
        return Ok(());
    }
    Err(to_python(Error::value(argument, format!("shape {expected:?}"), format!("{shape:?}"))))
}

/// Views of a cell from D directions.
#[pyclass(frozen, module = "nearfar._core")]
pub struct OrthoViews(pub Views);

impl OrthoViews {
    /// Values of all pixels, (D, H, W, C).
    fn rows<'py, T: Element, const C: usize>(
        &self,
        py: Python<'py>,
        of: impl Fn(&Texel) -> [T; C],
    ) -> PyResult<Array4<'py, T>> {
        let values: Vec<[T; C]> = self.0.views().iter().flatten().map(of).collect();
        let size = self.0.format.size;
        values.into_flattened().into_pyarray(py).reshape([self.0.directions.len(), size, size, C])
    }
}

#[pymethods]
impl OrthoViews {
    /// Draws the views of a cubic cell, given by its least corner and its side; `behind` adds a second layer.
    #[staticmethod]
    #[pyo3(signature = (scene, cell, directions, view_format, *, method=None, behind=false, report=None))]
    fn of_cell(
        scene: &Bound<'_, Scene>,
        cell: ([f64; 3], f64),
        directions: Vec<[i8; 3]>,
        view_format: FormatNumbers,
        method: Option<&str>,
        behind: bool,
        report: Report,
    ) -> PyResult<Self> {
        let methods = [("triangles", SurfaceMethod::Triangles), ("rays", SurfaceMethod::Rays)];
        let method = method.map(|name| choice("method", name, &methods)).transpose().map_err(to_python)?;
        let cell = Cell::new(DVec3::from_array(cell.0), cell.1).map_err(to_python)?;
        let (directions, format) = (directions_of(directions)?, format_of(view_format)?);
        let (py, scene) = (scene.py(), &scene.get().0);
        let draw = |progress: &_| Views::of_cell(scene, &cell, &directions, &format, method, behind, progress);
        run::long(py, report, draw).map(Self)
    }

    /// Creates views from arrays in the form of `colors`, `depths` and `normals`.
    #[staticmethod]
    fn from_arrays(
        directions: Vec<[i8; 3]>,
        view_format: FormatNumbers,
        colors: Read4<'_, u8>,
        depths: Read4<'_, u16>,
        normals: Read4<'_, u16>,
    ) -> PyResult<Self> {
        let (directions, format) = (directions_of(directions)?, format_of(view_format)?);
        let [views, size] = [directions.len(), format.size];
        check_shape("colors", shape_of(&colors), [views, size, size, 3])?;
        check_shape("depths", shape_of(&depths), [views, size, size, 1])?;
        check_shape("normals", shape_of(&normals), [views, size, size, 2])?;
        let (colors, normals) = (colors.as_slice()?.as_chunks().0, normals.as_slice()?.as_chunks().0);
        let pixels = colors.iter().zip(depths.as_slice()?).zip(normals);
        let texels = pixels.map(|((&color, &depth), &normal)| Texel { color, depth, normal }).collect();
        Views::new(directions, format, texels).map(Self).map_err(to_python)
    }

    /// Joins a first and a second layer, which `from_arrays` has created.
    #[staticmethod]
    fn with_behind(first: &Self, second: &Self) -> PyResult<Self> {
        first.0.with_behind(&second.0).map(Self).map_err(to_python)
    }

    /// The second layer; None if it is empty.
    fn second_layer(&self) -> Option<Self> {
        self.0.second_layer().map(Self)
    }

    /// Keeps the second layer only for the directions marked in `keep`.
    fn keep_behind(&self, keep: Vec<bool>) -> PyResult<Self> {
        self.0.keep_behind(&keep).map(Self).map_err(to_python)
    }

    /// For each direction, the number of the second layer's pixels that no view of the first layer shows, divided by
    /// the number of the first layer's non-empty pixels.
    fn unseen(&self, py: Python<'_>) -> PyResult<Vec<f32>> {
        run::short(py, || Ok(unseen(&self.0)))
    }

    /// sRGB colours, (D, size, size, 3).
    fn colors<'py>(&self, py: Python<'py>) -> PyResult<Array4<'py, u8>> {
        self.rows(py, |texel| texel.color)
    }

    /// Depths in steps from 1, 0 for no surface, (D, size, size, 1).
    fn depths<'py>(&self, py: Python<'py>) -> PyResult<Array4<'py, u16>> {
        self.rows(py, |texel| [texel.depth])
    }

    /// Octahedral codes of normals, (D, size, size, 2).
    fn normals<'py>(&self, py: Python<'py>) -> PyResult<Array4<'py, u16>> {
        self.rows(py, |texel| texel.normal)
    }

    /// Unit normals, NaN for no surface, (D, size, size, 3).
    fn vectors<'py>(&self, py: Python<'py>) -> PyResult<Array4<'py, f32>> {
        self.rows(py, |texel| self.0.format.normal_of(texel))
    }

    /// Number of depth steps in a cell.
    #[getter]
    fn steps(&self) -> u32 {
        self.0.format.steps
    }

    fn empty(&self) -> Vec<bool> {
        self.0.views().iter().map(|view| view.iter().all(|texel| texel.depth == 0)).collect()
    }

    /// Connections of each pixel, four bits, (D, size, size, 1).
    fn connected<'py>(&self, py: Python<'py>, bounds: (f32, f32, f32)) -> PyResult<Array4<'py, u8>> {
        let (depth, slope, bend) = bounds;
        let bits = run::short(py, || Ok(connected(&self.0, &Bounds { depth, slope, bend })))?;
        let size = self.0.format.size;
        bits.into_pyarray(py).reshape([self.0.directions.len(), size, size, 1])
    }
}

/// Views of a parent, assembled from its children one by one.
#[pyclass(module = "nearfar._core")]
pub struct OrthoParent(Parent);

#[pymethods]
impl OrthoParent {
    #[new]
    #[pyo3(signature = (directions, view_format, *, behind=false))]
    fn new(directions: Vec<[i8; 3]>, view_format: FormatNumbers, behind: bool) -> PyResult<Self> {
        Ok(Self(Parent::new(directions_of(directions)?, format_of(view_format)?, behind)))
    }

    /// Adds a child; `octant` is its position, 0 or 1 along each axis.
    fn add(&mut self, py: Python<'_>, octant: [u8; 3], child: &OrthoViews) -> PyResult<()> {
        run::short(py, || self.0.add(octant, &child.0))
    }

    /// Returns the views of the children added so far.
    fn finish(&self, py: Python<'_>) -> PyResult<OrthoViews> {
        run::short(py, || Ok(OrthoViews(self.0.finish())))
    }
}

/// Unit vectors to the right, upwards and towards the viewer of a direction's views, and a unit cube's extents along
/// them.
#[pyfunction]
pub fn orthoview_axes(direction: [i8; 3]) -> PyResult<([[f64; 3]; 3], [f64; 3])> {
    let frame = Direction::new(direction).map_err(to_python)?.frame();
    Ok((frame.axes().map(|axis| axis.to_array()), frame.extents().to_array()))
}

/// Whether each pixel is a surfel, from its connections (D, size, size, 1).
#[pyfunction]
pub fn orthoview_surfels<'py>(py: Python<'py>, bits: Read4<'py, u8>) -> PyResult<Array4<'py, bool>> {
    let (shape, bits) = (shape_of(&bits), bits.as_slice()?);
    run::short(py, || surfels(bits, shape[2]))?.into_pyarray(py).reshape(shape)
}

/// Number of depth steps of a format; fails for invalid formats.
#[pyfunction]
pub fn orthoview_steps(view_format: FormatNumbers) -> PyResult<u32> {
    Ok(format_of(view_format)?.steps)
}
