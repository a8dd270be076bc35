//! Pictures: layers before a backdrop.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Buffer;
use nearfar_core::render::{Limits, Segment};

use super::layers::Layer;
use super::mask::Mask;
use super::style::{Cut, Parameters, Style};
use crate::device::Device;
use crate::upload::EnvTexels;

/// A picture to be taken by a camera.
#[derive(Clone)]
pub(crate) struct Picture {
    /// In order of drawing.
    pub layers: Vec<Layer>,
    /// Numbers that the layers' styles and cuts read.
    pub parameters: Parameters,
    /// The environment map where nothing is drawn; the sky without one.
    pub backdrop: Option<Backdrop>,
    /// Style whose `backdrop_range` tells how far away the backdrop is shown.
    pub backdrop_style: Style,
    /// World position of the scenes' origin.
    pub origin: DVec3,
    /// Four samples may be the adapter's own, which shade each face once per pixel: for frames, not for baked maps.
    pub multisampled: bool,
    /// The part of space in which surfaces and map are seen, relative to the scenes' origin; none for all of it, which
    /// costs nothing to test.
    pub limits: Option<Limits>,
    /// Samples that see no triangle are black instead of showing map or sky.
    pub bare: bool,
    /// The pixels that are drawn; all without a mask.
    pub mask: Option<Arc<Mask>>,
}

/// An environment map behind everything that is drawn.
#[derive(Clone)]
pub(crate) struct Backdrop {
    pub texels: Arc<EnvTexels>,
    /// Objects of its texels, where it has them.
    pub objects: Option<Buffer<i32>>,
    /// Where it was taken, relative to the scenes' origin.
    pub center: DVec3,
}

impl Picture {
    /// Whether the adapter clips a layer's triangles at the limits: planes alone, which cut points where they are shown.
    pub fn clips(&self, device: &Device, layer: &Layer) -> bool {
        let whole = layer.style == Style::PLAIN && layer.cut == Cut::NONE && !layer.scene.has_cutouts();
        let planes = self.limits.is_some_and(|limits| limits.segment == Segment::WHOLE);
        device.clips && whole && planes
    }

    /// Layers without parameters, before the sky.
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
