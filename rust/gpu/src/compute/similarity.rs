//! Structural similarity of two frames: Wang, Bovik, Sheikh, Simoncelli (2004), on the sRGB-encoded Rec. 709 luma with
//! a range of 1, with moments as in `metrics::moments`.

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::metrics::Window;
use wgpu::BufferUsages;

use super::memory::{PooledBuffer, Results};
use super::programs::{Program, Work, groups};
use crate::draw::DeviceFrame;

/// Maximum window width in pixels: the pixels that a workgroup reads must fit into 16 KiB.
pub const MAX_TAPS: usize = 17;
/// Width of a workgroup's tile, pixels.
const TILE: u32 = 16;
/// (k₁ L)² and (k₂ L)² with Wang's k₁ = 0.01, k₂ = 0.03.
const C1_C2: [f64; 2] = [1e-4, 9e-4];

/// The uniform block `Similarity` of `compute_similarity.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct SimilarityBlock {
    size: [u32; 4],
    first: [u32; 4],
    inside: [u32; 4],
    constants: [f32; 4],
    weights: [[f32; 4]; 5],
}

/// Structural similarity of two frames.
pub struct Similarity {
    /// Mean over the windows inside the picture.
    pub mean: f64,
    /// Similarity around each pixel, if requested.
    pub map: Option<Vec<f32>>,
}

/// Compares the colours of two frames of one device and size.
pub fn similarity(
    [reference, test]: [&DeviceFrame; 2],
    window: &Window,
    full: bool,
    progress: &Progress,
) -> Result<Similarity> {
    let device = &**reference.device();
    let weights = weights(window)?;
    let size = check(reference, test)?;
    let pixels = size[0] * size[1];
    let inside = inner_window(size, weights.len() as u32)?;
    let tiles = size.map(|length| length.div_ceil(TILE));
    let colors = [reference.color()?, test.color()?];
    let mut block = SimilarityBlock {
        size: [size[0], size[1], pixels, tiles[0]],
        first: [colors[0].first, colors[1].first, 0, 0],
        inside,
        constants: [C1_C2[0] as f32, C1_C2[1] as f32, 0.0, 0.0],
        weights: [[0.0; 4]; 5],
    };
    for (slot, &weight) in block.weights.as_flattened_mut().iter_mut().zip(&weights) {
        *slot = weight as f32;
    }
    let uniform = device.filled_buffer("similarity", &[block], BufferUsages::UNIFORM)?;
    let planes = PooledBuffer::scratch(device, 8 * u64::from(pixels))?;
    let sums = Results::new(device, 4 * u64::from(tiles[0]) * u64::from(tiles[1]))?;
    let map = full.then(|| Results::new(device, 4 * u64::from(pixels))).transpose()?;
    let constants = &[("TAPS", weights.len() as u32)];
    let text = &[include_str!("../shaders/compute_similarity.wgsl")];
    let program = |entry| Program { text, entry, constants, group: 0 };
    let frame_lock = reference.lock();
    let mut work = Work::new(device);
    let luma = [
        (0, uniform.as_entire_binding()),
        (1, colors[0].buffer.as_entire_binding()),
        (2, colors[1].buffer.as_entire_binding()),
        (3, planes.binding()),
    ];
    work.run(&program("similarity_luma"), &luma, groups(pixels))?;
    let mut moments = vec![(0, uniform.as_entire_binding()), (3, planes.binding()), (4, sums.on_device.binding())];
    moments.extend(map.as_ref().map(|map| (5, map.on_device.binding())));
    let entry = if full { "similarity_map" } else { "similarity_sums" };
    work.run(&program(entry), &moments, tiles)?;
    [Some(&sums), map.as_ref()].into_iter().flatten().for_each(|results| results.encode_copy(&mut work.encoder));
    work.submit(progress)?;
    drop(frame_lock);
    let sums: Vec<f32> = sums.read_values(tiles[0] as usize * tiles[1] as usize, progress)?;
    let loss: f64 = sums.into_iter().map(f64::from).sum();
    let [left, top, right, bottom] = inside.map(f64::from);
    let map = map.map(|map| map.read_values(pixels as usize, progress));
    Ok(Similarity { mean: 1.0 - loss / ((right - left) * (bottom - top)), map: map.transpose()? })
}

fn weights(window: &Window) -> Result<Vec<f64>> {
    match window {
        Window::Weights(weights) if (1..=MAX_TAPS).contains(&weights.len()) => Ok(weights.clone()),
        Window::Weights(weights) => {
            Err(Error::value("size", format!("1 to {MAX_TAPS} pixels across the window"), weights.len()))
        }
        Window::Global => Err(Error::value("window", "'gaussian' or 'uniform'", "'global'")),
    }
}

/// Checks that both frames have one device and size; returns their width and height.
fn check(reference: &DeviceFrame, test: &DeviceFrame) -> Result<[u32; 2]> {
    // A device that was lost and reopened has the same name.
    reference.device().check()?;
    test.device().check()?;
    if !std::ptr::eq(&**reference.device(), &**test.device()) {
        let label = |frame: &DeviceFrame| frame.device().report().label();
        let (expected, got) = (format!("a frame on {}", label(reference)), format!("one on {}", label(test)));
        return Err(Error::value("test", expected, got));
    }
    let size = |frame: &DeviceFrame| [frame.camera().width, frame.camera().height];
    let (expected, got) = (size(reference), size(test));
    if expected != got {
        let text = |[width, height]: [u32; 2]| format!("{width} × {height} pixels");
        return Err(Error::value("test", text(expected), text(got)));
    }
    Ok(expected)
}

/// Returns the pixels whose windows lie inside the picture: first column and row, end column and row.
fn inner_window([width, height]: [u32; 2], taps: u32) -> Result<[u32; 4]> {
    let shorter = width.min(height);
    if taps > shorter {
        let expected = format!("a window of at most {shorter} pixels, the pictures' shorter side");
        return Err(Error::value("size", expected, taps.to_string()));
    }
    let (before, after) = (taps / 2, taps - 1 - taps / 2);
    Ok([before, before, width - after, height - after])
}
