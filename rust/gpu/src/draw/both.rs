//! Drawing of two views in one pass.

use nearfar_core::camera::Camera;
use nearfar_core::render::Channels;

use super::layers::Layer;
use super::outputs::window_limits;
use super::picture::Picture;
use super::style::{Cut, Style};
use crate::device::{Device, SAMPLES};

/// Returns whether a device draws the frames of two cameras at once: each triangle is submitted once and placed in
/// both. No style or cut may discard parts of triangles, and both frames must fit into one window.
pub(crate) fn draws_both(
    device: &Device,
    picture: &Picture,
    cameras: &[Camera],
    channels: Channels,
    samples: u32,
) -> bool {
    let [left, right] = cameras else { return false };
    let (width, height) = (left.width, left.height);
    let (max_pixels, max_side) = window_limits(device, channels);
    let fits_window = width.max(height) <= max_side && 2 * u64::from(width) * u64::from(height) <= max_pixels;
    let draws_whole_triangles =
        |layer: &Layer| layer.style == Style::PLAIN && layer.cut == Cut::NONE && !layer.scene.has_cutouts();
    device.draws_two_views()
        && (width, height) == (right.width, right.height)
        && !left.is_parallel()
        && !right.is_parallel()
        && picture.mask.is_none()
        && picture.limits.is_none()
        && (samples != SAMPLES || !device.multisamples)
        && fits_window
        && picture.layers.iter().all(draws_whole_triangles)
}
