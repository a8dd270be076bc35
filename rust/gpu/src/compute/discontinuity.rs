//! Discontinuity of a frame: how far neighbours in the true picture are torn apart (Popescu, Lee, Choi, Fahmy 2022, Eq.
//! 5–6). Points are binned by their position in the truth; then each point is compared with those in its cell and the
//! eight around it.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4};
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::metrics::Neighbourhood;
use wgpu::{BindingResource, BufferUsages};

use super::memory::{PooledBuffer, Results};
use super::programs::{Program, Work, groups};
use crate::device::{Device, Submission};
use crate::draw::{Axes, DeviceFrame};

/// Pairs per submission; cancellation is checked between submissions.
const PAIRS_PER_SUBMISSION: f64 = 2e9;
/// Points of each cell that one call visits: its loop has nine times as many iterations, and software drivers end loops
/// after 65,535.
const POINTS_PER_SLICE: u32 = 1 << 12;
const _: () = assert!(9 * POINTS_PER_SLICE < 65_535);
/// Minimum side of a cell, pixels: smaller ones hold few points.
const MIN_CELL_PX: f64 = 4.0;

/// The uniform block `Settings` of `compute_discontinuity.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct SettingsBlock {
    x: [f32; 4],
    y: [f32; 4],
    ahead: [f32; 4],
    eye_high: [f32; 4],
    eye_low: [f32; 4],
    limits: [f32; 4],
    size: [u32; 4],
    grid: [u32; 4],
    slice: [u32; 4],
}

/// An entry point of `compute_discontinuity.wgsl`, and the bindings that it uses.
type Kernel = (&'static str, &'static [u32]);

/// Finds the cell of each pixel, and counts the pixels of each cell.
const BIN: Kernel = ("discontinuity_bin", &[0, 1, 2, 3, 4, 8]);
/// Computes where each cell starts, and the maximum count, from the counts.
const ADD_COUNTS: Kernel = ("discontinuity_add_counts", &[0, 4, 5, 9]);
/// Lists the pixels of each cell, in any order.
const SCATTER: Kernel = ("discontinuity_scatter", &[0, 3, 5, 6]);
/// Counts, for each pixel, the earlier pixels in a slice of its cell.
const ORDER: Kernel = ("discontinuity_order", &[0, 3, 5, 6]);
/// Stores the points of each cell contiguously.
const GATHER: Kernel = ("discontinuity_gather", &[0, 2, 3, 5, 7]);
/// Adds the neighbours in a slice of each cell to the sums of some points.
const SUM: Kernel = ("discontinuity_sum", &[0, 2, 3, 5, 7, 8]);

/// Points sorted by cells of their position in the truth, and the sums over their neighbours.
struct Bins<'a> {
    positions: BindingResource<'a>,
    shifts: PooledBuffer<'a>,
    cells: PooledBuffer<'a>,
    counts: PooledBuffer<'a>,
    starts: PooledBuffer<'a>,
    list: PooledBuffer<'a>,
    points: PooledBuffer<'a>,
    discontinuity: Results<'a>,
    max_count: Results<'a>,
}

/// Returns δ for each pixel of a frame with positions; NaN where there is none.
pub fn discontinuity(
    frame: &DeviceFrame,
    truth: &Camera,
    neighbourhood: Neighbourhood,
    progress: &Progress,
) -> Result<Vec<f32>> {
    let Neighbourhood { epsilon, least } = neighbourhood;
    for (argument, value) in [("epsilon", epsilon), ("min_distance", least)] {
        if !(1e-6..=1e4).contains(&value) {
            return Err(Error::value(argument, "from a millionth of a pixel to 10,000 pixels", value));
        }
    }
    let device = &**frame.device();
    let position = frame.position()?;
    let Camera { width, height, .. } = *frame.camera();
    let (pixels, max_pixels) = (width * height, device.largest_binding() / 16);
    if u64::from(pixels) > max_pixels {
        return Err(device.error(format!(
            "a frame of {width} × {height} pixels, {max_pixels} pixels can be sorted; use nearfar.metrics.discontinuity"
        )));
    }
    progress.expect(u64::from(pixels));
    // The side of a cell exceeds ε by more than the rounding error of positions up to 10⁵ pixels, so that no neighbour
    // is missed.
    let cell = (epsilon * 1.001 + 0.05).max(MIN_CELL_PX);
    let cells_along = |truth: u32, frame: u32| ((f64::from(truth) / cell).ceil() as u32 + 2).clamp(3, frame / 2 + 3);
    let grid = [cells_along(truth.width, width), cells_along(truth.height, height)];
    let cells = grid[0] * grid[1];
    let bins = Bins::new(device, position.buffer.as_entire_binding(), u64::from(pixels), u64::from(cells))?;
    let settings = settings(truth, frame.origin(), neighbourhood, cell);
    let settings = SettingsBlock { size: [width, pixels, position.first, cells], ..settings };
    let uniform = |first: u32, count: u32, slice: u32| {
        let (grid, slice) = ([grid[0], grid[1], first, count], [slice, POINTS_PER_SLICE, 0, 0]);
        device.filled_buffer("discontinuity", &[SettingsBlock { grid, slice, ..settings }], BufferUsages::UNIFORM)
    };
    let all_points = uniform(0, pixels, 0)?;
    let frame_lock = frame.lock();
    let mut work = Work::new(device);
    work.encoder.clear_buffer(&bins.counts, 0, None);
    bins.run(&mut work, BIN, &all_points, groups(pixels))?;
    bins.run(&mut work, ADD_COUNTS, &all_points, [1, 1])?;
    bins.run(&mut work, SCATTER, &all_points, groups(pixels))?;
    bins.max_count.encode_copy(&mut work.encoder);
    work.submit(progress)?;
    drop(frame_lock);
    let max_count = bins.max_count.read_word(progress)?;
    let slices = || (0..max_count.max(1)).step_by(POINTS_PER_SLICE as usize);
    // One submission, with the number of points that it finishes, is in flight while the next is encoded.
    let mut in_flight: Option<(Submission, u32)> = None;
    let mut submit = |work: Work<'_>, points: u32| -> Result<()> {
        if let Some((submission, points)) = in_flight.replace((work.submit(progress)?, points)) {
            device.wait(&submission, progress)?;
            progress.report(u64::from(points))?;
        }
        Ok(())
    };
    for slice in slices() {
        let mut work = Work::new(device);
        bins.run(&mut work, ORDER, &uniform(0, pixels, slice)?, groups(pixels))?;
        if slice + POINTS_PER_SLICE >= max_count {
            bins.run(&mut work, GATHER, &all_points, groups(pixels))?;
        }
        submit(work, 0)?;
    }
    let points_per_call = (PAIRS_PER_SUBMISSION / (9.0 * f64::from(max_count.clamp(1, POINTS_PER_SLICE))))
        .clamp(4096.0, f64::from(1 << 20)) as u32;
    for first in (0..pixels).step_by(points_per_call as usize) {
        let count = points_per_call.min(pixels - first);
        for slice in slices() {
            let mut work = Work::new(device);
            bins.run(&mut work, SUM, &uniform(first, count, slice)?, groups(count))?;
            let is_last_slice = slice + POINTS_PER_SLICE >= max_count;
            if is_last_slice && first + count == pixels {
                bins.discontinuity.encode_copy(&mut work.encoder);
            }
            submit(work, if is_last_slice { count } else { 0 })?;
        }
    }
    bins.discontinuity.read_values(pixels as usize, progress)
}

/// Returns the settings of all calls: rows that map a point to its position in the truth, and the limits.
fn settings(truth: &Camera, origin: DVec3, neighbourhood: Neighbourhood, cell: f64) -> SettingsBlock {
    let Neighbourhood { epsilon, least } = neighbourhood;
    let Axes { right, up, ahead, fov } = Axes::new(truth);
    let across = f64::from(truth.width) / (fov.right - fov.left);
    let down = f64::from(truth.height) / (fov.up - fov.down);
    let eye = truth.position - origin;
    let eye_high = eye.as_vec3();
    let vec4 = |v: DVec4| v.as_vec4().to_array();
    SettingsBlock {
        x: vec4((right * across).extend(-fov.left * across)),
        y: vec4((-up * down).extend(fov.up * down)),
        ahead: vec4(ahead.extend(f64::from(truth.is_parallel()))),
        eye_high: eye_high.extend(0.0).to_array(),
        eye_low: vec4((eye - eye_high.as_dvec3()).extend(0.0)),
        limits: [epsilon * epsilon, least * least, 1.0 / cell, 0.0].map(|x| x as f32),
        size: [0; 4],
        grid: [0; 4],
        slice: [0; 4],
    }
}

impl<'a> Bins<'a> {
    fn new(device: &'a Device, positions: BindingResource<'a>, pixels: u64, cells: u64) -> Result<Self> {
        Ok(Self {
            positions,
            shifts: PooledBuffer::scratch(device, 8 * pixels)?,
            cells: PooledBuffer::scratch(device, 8 * pixels)?,
            counts: PooledBuffer::scratch(device, 4 * cells)?,
            starts: PooledBuffer::scratch(device, 4 * (cells + 1))?,
            list: PooledBuffer::scratch(device, 4 * pixels)?,
            points: PooledBuffer::scratch(device, 16 * pixels)?,
            discontinuity: Results::new(device, 4 * pixels)?,
            max_count: Results::new(device, 4)?,
        })
    }

    fn run(&self, work: &mut Work<'_>, kernel: Kernel, uniform: &wgpu::Buffer, groups: [u32; 2]) -> Result<()> {
        let (entry, bindings) = kernel;
        let text = &[include_str!("../shaders/compute_discontinuity.wgsl")];
        let buffers = [&self.shifts, &self.cells, &self.counts, &self.starts, &self.list, &self.points];
        let results = [&self.discontinuity.on_device, &self.max_count.on_device];
        let mut all = vec![uniform.as_entire_binding(), self.positions.clone()];
        all.extend(buffers.into_iter().chain(results).map(PooledBuffer::binding));
        let resources: Vec<_> = bindings.iter().map(|&binding| (binding, all[binding as usize].clone())).collect();
        work.run(&Program { text, entry, constants: &[], group: 0 }, &resources, groups)
    }
}
