//! Bindings of `exr`: named parts with channels and attributes.

use nearfar_core::exr::{self, Attribute, Part, Values};
use numpy::{IntoPyArray, PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::{Array1, Read2, argument_enum, run, with_array};

argument_enum! {
    enum ChannelArgument<'py> {
        Half(Read2<'py, half::f16>),
        Float(Read2<'py, f32>),
        Unsigned(Read2<'py, u32>),
    }
}

impl ChannelArgument<'_> {
    fn values(&self) -> PyResult<Values<'_>> {
        Ok(match self {
            Self::Half(array) => Values::Half(array.as_slice()?.into()),
            Self::Float(array) => Values::Float(array.as_slice()?.into()),
            Self::Unsigned(array) => Values::Unsigned(array.as_slice()?.into()),
        })
    }

    fn shape(&self) -> (usize, usize) {
        let shape = with_array!(Self::{Half, Float, Unsigned}, self, array => array.shape());
        (shape[0], shape[1])
    }
}

/// Encodes an EXR file. A part is (name, channels, attributes): a dictionary of (H, W) float16, float32 or uint32
/// arrays, and a dictionary of texts and triples of numbers.
#[pyfunction]
pub fn encode_exr<'py>(
    py: Python<'py>,
    parts: Vec<(String, Bound<'py, PyDict>, Bound<'py, PyDict>)>,
) -> PyResult<Array1<'py, u8>> {
    let arrays = parts.iter().map(|(_, channels, _)| arrays_of(channels)).collect::<PyResult<Vec<_>>>()?;
    let parts = parts.iter().zip(&arrays).map(|((name, _, attributes), arrays)| part_of(name, arrays, attributes));
    let parts = parts.collect::<PyResult<Vec<_>>>()?;
    let bytes = run::long(py, None, |progress| exr::encode(&parts, progress))?;
    Ok(bytes.into_pyarray(py))
}

type DecodedPart<'py> = (String, Bound<'py, PyDict>, Bound<'py, PyDict>);

/// Decodes an EXR file to parts in the form that `encode_exr` takes.
#[pyfunction]
pub fn decode_exr<'py>(py: Python<'py>, data: &[u8]) -> PyResult<Vec<DecodedPart<'py>>> {
    let parts = run::long(py, None, |progress| exr::decode(data, progress))?;
    parts.into_iter().map(|part| part_to_python(py, part)).collect()
}

fn arrays_of<'py>(channels: &Bound<'py, PyDict>) -> PyResult<Vec<(String, ChannelArgument<'py>)>> {
    let mut arrays: Vec<(String, ChannelArgument)> = Vec::new();
    for (key, image) in channels {
        let image: ChannelArgument = image.extract().map_err(|_| {
            PyTypeError::new_err(format!("channels: expected (H, W) float16, float32 or uint32 for '{key}'"))
        })?;
        if arrays.first().is_some_and(|(_, first)| first.shape() != image.shape()) {
            return Err(PyValueError::new_err(format!("channels: '{key}' differs in shape from the others")));
        }
        arrays.push((key.extract()?, image));
    }
    Ok(arrays)
}

fn part_of<'a>(
    name: &str,
    arrays: &'a [(String, ChannelArgument<'_>)],
    attributes: &Bound<'_, PyDict>,
) -> PyResult<Part<'a>> {
    let (_, first) = arrays.first().ok_or_else(|| PyValueError::new_err("channels: expected at least one image"))?;
    let (height, width) = first.shape();
    let channels = arrays.iter().map(|(name, array)| Ok((name.clone(), array.values()?)));
    let attributes = attributes.iter().map(|(key, value)| {
        let text = value.extract().map(Attribute::Text);
        let value = text.or_else(|_| Ok::<_, PyErr>(Attribute::Vector(value.extract::<(f32, f32, f32)>()?.into())))?;
        Ok((key.extract()?, value))
    });
    let (channels, attributes) = (channels.collect::<PyResult<_>>()?, attributes.collect::<PyResult<_>>()?);
    Ok(Part { name: name.to_owned(), width, height, channels, attributes })
}

fn part_to_python<'py>(py: Python<'py>, part: Part<'_>) -> PyResult<DecodedPart<'py>> {
    let shape = [part.height, part.width];
    let channels = PyDict::new(py);
    for (name, values) in part.channels {
        with_array!(Values::{Half, Float, Unsigned}, values, values => {
            channels.set_item(name, PyArray1::from_vec(py, values.into_owned()).reshape(shape)?)?
        });
    }
    let attributes = PyDict::new(py);
    for (name, value) in part.attributes {
        match value {
            Attribute::Text(text) => attributes.set_item(name, text)?,
            Attribute::Vector([x, y, z]) => attributes.set_item(name, (x, y, z))?,
        }
    }
    Ok((part.name, channels, attributes))
}
