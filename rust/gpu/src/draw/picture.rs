//! Pictures: layers in front of a backdrop.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Buffer;
use nearfar_core::camera::Camera;
use nearfar_core::render::{Channels, Limits, Segment};

use super::layers::Layer;
use super::mask::Mask;
use super::style::{Parameters, Style};
use super::window::window_limits;
use crate::device::{Device, SAMPLES};
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
        let only_planes = self.limits.is_some_and(|limits| limits.segment == Segment::WHOLE);
        device.clips && layer.draws_whole_triangles() && only_planes
    }

    /// Returns whether a device draws the frames of two cameras at once: each triangle is submitted once and placed in
    /// both. No style or cut may discard parts of triangles, and both frames must fit into one window.
    pub fn draws_both(&self, device: &Device, cameras: &[Camera], channels: Channels, samples: u32) -> bool {
        let [left, right] = cameras else { return false };
        let (width, height) = (left.width, left.height);
        let (max_pixels, max_side) = window_limits(device, channels);
        device.draws_two_views()
            && (width, height) == (right.width, right.height)
            && !left.is_parallel()
            && !right.is_parallel()
            && self.mask.is_none()
            && self.limits.is_none()
            && (samples != SAMPLES || !device.multisamples)
            && width.max(height) <= max_side
            && 2 * u64::from(width) * u64::from(height) <= max_pixels
            && self.layers.iter().all(Layer::draws_whole_triangles)
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
