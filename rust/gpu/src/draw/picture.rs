//! Pictures: layers in front of a backdrop.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Buffer;
use nearfar_core::render::{Limits, Segment};

use super::layers::Layer;
use super::mask::Mask;
use super::style::{Cut, Parameters, Style};
use crate::device::Device;
use crate::upload::EnvTexels;

/// A picture to be drawn for a camera.
#[derive(Clone)]
pub(crate) struct Picture {
    /// Layers in drawing order.
    pub layers: Vec<Layer>,
    /// Parameters of the layers' styles and cuts.
    pub parameters: Parameters,
    /// Environment map behind all layers; `None` for the sky.
    pub backdrop: Option<Backdrop>,
    /// Style whose `backdrop_range` gives the displayed distance of the backdrop.
    pub backdrop_style: Style,
    /// World position of the scenes' origin.
    pub origin: DVec3,
    /// Whether four samples may use hardware multisampling, which shades each face once per pixel: for frames, not for
    /// baked maps.
    pub multisampled: bool,
    /// Visible volume of surfaces and map, relative to the scenes' origin; `None` for no limits, which needs no test.
    pub limits: Option<Limits>,
    /// Whether samples without a triangle are black instead of showing map or sky.
    pub bare: bool,
    /// Drawn pixels; `None` draws all.
    pub mask: Option<Arc<Mask>>,
}

/// Environment map behind all layers.
#[derive(Clone)]
pub(crate) struct Backdrop {
    pub texels: Arc<EnvTexels>,
    /// Objects of its texels, if present.
    pub objects: Option<Buffer<i32>>,
    /// Centre of the map, relative to the scenes' origin.
    pub center: DVec3,
}

impl Picture {
    /// Returns whether the adapter clips a layer's triangles: only planes, and only undisplaced whole triangles.
    pub fn clips(&self, device: &Device, layer: &Layer) -> bool {
        let whole = layer.style == Style::PLAIN && layer.cut == Cut::NONE && !layer.scene.has_cutouts();
        let planes = self.limits.is_some_and(|limits| limits.segment == Segment::WHOLE);
        device.clips && whole && planes
    }

    /// Creates a picture of layers without parameters, in front of the sky.
    pub fn plain(layers: Vec<Layer>, origin: DVec3) -> Self {
        Self {
            layers,
            parameters: Parameters::default(),
            backdrop: None,
            backdrop_style: Style::PLAIN,
            origin,
            multisampled: true,
            limits: None,
            bare: false,
            mask: None,
        }
    }
}
