//! The output of a window: the words of each channel, for one view after the other.

use nearfar_core::render::Channels;

use super::view::{CHANNELS, Outputs};
use super::window::Window;
use crate::device::Device;

/// Bytes of a pixel's channels: colour, range, ids, position, normal, albedo, shading normal, coverage.
const CHANNEL_BYTES: [u64; CHANNELS] = [12, 4, 8, 12, 12, 12, 12, 4];

/// Flags of the wanted channels, in the order of `CHANNEL_BYTES`.
fn wanted(channels: Channels) -> [bool; CHANNELS] {
    let Channels { color, coverage, range, object_id, face_id, position, normal, albedo, shading_normal } = channels;
    [color, range, object_id || face_id, position, normal, albedo, shading_normal, coverage]
}

/// Bytes of a pixel.
pub(super) fn bytes_per_pixel(channels: Channels) -> u64 {
    wanted(channels).iter().zip(CHANNEL_BYTES).map(|(&wanted, bytes)| u64::from(wanted) * bytes).sum()
}

/// The most pixels that a window may have, and the most across and down.
pub(super) fn window_limits(device: &Device, channels: Channels) -> (u64, u32) {
    let most = device.largest_binding() / bytes_per_pixel(channels).max(1);
    (most.max(1), device.limits.max_texture_dimension_2d)
}

/// First word of each channel of a window, for each of some views.
pub(super) fn layouts(channels: Channels, window: &Window, views: usize) -> Vec<Outputs> {
    let mut at = 0;
    let mut layout = || {
        let mut outputs = [u32::MAX; CHANNELS];
        for ((slot, wanted), bytes) in outputs.iter_mut().zip(wanted(channels)).zip(CHANNEL_BYTES) {
            if wanted {
                *slot = at;
                at += (bytes / 4) as u32 * window.pixels() as u32;
            }
        }
        outputs
    };
    (0..views).map(|_| layout()).collect()
}
