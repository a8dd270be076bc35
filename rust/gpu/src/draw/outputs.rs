//! Output layout of a window: the words of each channel, view by view.

use nearfar_core::render::Channels;

use super::view::{CHANNELS, Outputs};
use super::window::Window;
use crate::device::Device;

/// Bytes per pixel of each channel: colour, range, ids, position, normal, albedo, shading normal, coverage.
const CHANNEL_BYTES: [u64; CHANNELS] = [12, 4, 8, 12, 12, 12, 12, 4];

/// Returns flags of the requested channels, in the order of `CHANNEL_BYTES`.
fn channel_flags(channels: Channels) -> [bool; CHANNELS] {
    let Channels { color, coverage, range, object_id, face_id, position, normal, albedo, shading_normal } = channels;
    [color, range, object_id || face_id, position, normal, albedo, shading_normal, coverage]
}

/// Returns the bytes per pixel.
pub(super) fn bytes_per_pixel(channels: Channels) -> u64 {
    channel_flags(channels).iter().zip(CHANNEL_BYTES).map(|(&wanted, bytes)| u64::from(wanted) * bytes).sum()
}

/// Returns the maximum number of pixels of a window, and its maximum width and height.
pub(super) fn window_limits(device: &Device, channels: Channels) -> (u64, u32) {
    let most = device.largest_binding() / bytes_per_pixel(channels).max(1);
    (most.max(1), device.limits.max_texture_dimension_2d)
}

/// Returns the first word of each channel of a window, for each view.
pub(super) fn layouts(channels: Channels, window: &Window, views: usize) -> Vec<Outputs> {
    let mut at = 0;
    let mut layout = || {
        let mut outputs = [u32::MAX; CHANNELS];
        for ((slot, wanted), bytes) in outputs.iter_mut().zip(channel_flags(channels)).zip(CHANNEL_BYTES) {
            if wanted {
                *slot = at;
                at += (bytes / 4) as u32 * window.pixels() as u32;
            }
        }
        outputs
    };
    (0..views).map(|_| layout()).collect()
}
