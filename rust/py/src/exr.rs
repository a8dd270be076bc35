//! Bindings of `exr`: named parts with channels and attributes.

use nearfar_core::exr::{self, Attribute, Part, Values};
use numpy::{IntoPyArray, PyArray1, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::arrays::with_array;
use crate::convert::one_of::one_of;
use crate::convert::run;

one_of! {
    enum ChannelArgument<'py> {
        Half(PyReadonlyArray2<'py, half::f16>),
        Float(PyReadonlyArray2<'py, f32>),
        Unsigned(PyReadonlyArray2<'py, u32>),
    }
}

one_of! {
    enum AttributeArgument {
        Text(String),
        Vector((f32, f32, f32)),
    }
}

impl From<AttributeArgument> for Attribute {
    fn from(argument: AttributeArgument) -> Self {
        match argument {
            AttributeArgument::Text(text) => Self::Text(text),
            AttributeArgument::Vector(vector) => Self::Vector(vector.into()),
        }
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

/// A part with borrowed arrays.
struct PartArgument<'py> {
    name: String,
    shape: (usize, usize),
    channels: Vec<(String, ChannelArgument<'py>)>,
    attributes: Vec<(String, Attribute)>,
}

impl PartArgument<'_> {
    fn part(&self) -> PyResult<Part<'_>> {
        let channels = self.channels.iter().map(|(name, channel)| Ok((name.clone(), channel.values()?)));
        Ok(Part {
            name: self.name.clone(),
            width: self.shape.1,
            height: self.shape.0,
            channels: channels.collect::<PyResult<_>>()?,
            attributes: self.attributes.clone(),
        })
    }
}

/// Encodes an EXR file. A part is (name, channels, attributes): a dictionary of (H, W) float16, float32 or uint32
/// arrays, and a dictionary of texts and triples of numbers.
#[pyfunction]
pub(crate) fn encode_exr<'py>(
    py: Python<'py>,
    parts: Vec<(String, Bound<'py, PyDict>, Bound<'py, PyDict>)>,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let parts = parts.into_iter().map(|(name, channels, attributes)| argument(name, &channels, &attributes));
    let parts = parts.collect::<PyResult<Vec<_>>>()?;
    let parts = parts.iter().map(PartArgument::part).collect::<PyResult<Vec<_>>>()?;
    let bytes = run::long(py, None, |progress| exr::encode(&parts, progress))?;
    Ok(bytes.into_pyarray(py))
}

type DecodedPart<'py> = (String, Bound<'py, PyDict>, Bound<'py, PyDict>);

/// Decodes an EXR file to parts in the form that `encode_exr` takes.
#[pyfunction]
pub(crate) fn decode_exr<'py>(py: Python<'py>, data: &[u8]) -> PyResult<Vec<DecodedPart<'py>>> {
    let parts = run::long(py, None, |progress| exr::decode(data, progress))?;
    parts.into_iter().map(|part| decoded(py, part)).collect()
}

fn argument<'py>(
    name: String,
    channels: &Bound<'py, PyDict>,
    attributes: &Bound<'py, PyDict>,
) -> PyResult<PartArgument<'py>> {
    let mut shape = None;
    let mut images = Vec::new();
    for (key, image) in channels {
        let image: ChannelArgument = image.extract().map_err(|_| {
            PyTypeError::new_err(format!("channels: expected (H, W) float16, float32 or uint32 for '{key}'"))
        })?;
        if *shape.get_or_insert(image.shape()) != image.shape() {
            return Err(PyValueError::new_err(format!("channels: '{key}' differs in shape from the others")));
        }
        images.push((key.extract()?, image));
    }
    let shape = shape.ok_or_else(|| PyValueError::new_err("channels: expected at least one image"))?;
    let mut values = Vec::new();
    for (key, value) in attributes {
        let value: AttributeArgument = value.extract()?;
        values.push((key.extract()?, value.into()));
    }
    Ok(PartArgument { name, shape, channels: images, attributes: values })
}

fn decoded<'py>(py: Python<'py>, part: Part<'_>) -> PyResult<DecodedPart<'py>> {
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
