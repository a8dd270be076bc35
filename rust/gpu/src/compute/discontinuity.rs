//! Discontinuity of a frame: how far neighbours in the true picture are torn apart. Popescu, Lee, Choi, Fahmy (2022),
//! Eq. 5–6. Points are binned by their position in the truth, then each point searches the nine cells around its own.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4};
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::metrics::Neighbourhood;
use wgpu::{BindingResource, BufferUsages};

use super::memory::{LentBuffer, Results, copy};
use super::programs::{Program, Work, groups};
use crate::device::{Device, Submission};
use crate::draw::{Axes, DeviceFrame};

/// Pairs per submission; cancellation is checked between submissions.
const PAIRS_PER_SUBMISSION: f64 = 2e9;
/// Points of each cell that one call visits. Its loop has nine times as many iterations; software drivers end loops
/// after 65,535.
const POINTS_PER_SLICE: u32 = 1 << 12;
const _: () = assert!(9 * POINTS_PER_SLICE < 65_535);
/// Minimum side of a cell, pixels: smaller ones hold few points.
const MIN_CELL_PX: f64 = 4.0;

/// The uniform block `Torn` of `compute_discontinuity.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct TornBlock {
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
const PLACE: Kernel = ("discontinuity_place", &[0, 1, 2, 3, 4, 8]);
/// Computes where each cell starts, and the maximum count, from the counts.
const ADD_UP: Kernel = ("discontinuity_add_up", &[0, 4, 5, 9]);
/// Lists the pixels of each cell, in any order.
const SCATTER: Kernel = ("discontinuity_scatter", &[0, 3, 5, 6]);
/// Counts, for each pixel, the earlier pixels in a slice of its cell.
const ORDER: Kernel = ("discontinuity_order", &[0, 3, 5, 6]);
/// Stores the points of each cell contiguously.
const GATHER: Kernel = ("discontinuity_gather", &[0, 2, 3, 5, 7]);
/// Adds the neighbours in a slice of each cell to the sums of some points.
const TEAR: Kernel = ("discontinuity_tear", &[0, 2, 3, 5, 7, 8]);

/// Points sorted by cells of their position in the truth, and the sums over their neighbours.
struct Bins<'a> {
    positions: BindingResource<'a>,
    shifts: LentBuffer<'a>,
    cells: LentBuffer<'a>,
    counts: LentBuffer<'a>,
    starts: LentBuffer<'a>,
    list: LentBuffer<'a>,
    points: LentBuffer<'a>,
    torn: Results<'a>,
    most: Results<'a>,
}

/// Returns δ for each pixel of a frame with positions; NaN where there is none.
pub fn discontinuity(
    frame: &DeviceFrame,
    truth: &Camera,
    around: Neighbourhood,
    progress: &Progress,
) -> Result<Vec<f32>> {
    for (argument, value) in [("epsilon", around.epsilon), ("min_distance", around.least)] {
        if !(1e-6..=1e4).contains(&value) {
            return Err(Error::value(argument, "from a millionth of a pixel to 10,000 pixels", value));
        }
    }
    let device = &**frame.device();
    let position = frame.position()?;
    let [width, height] = [frame.camera().width, frame.camera().height];
    let pixels = width * height;
    check(device, [width, height])?;
    progress.expect(u64::from(pixels));
    // Longer than ε by more than the rounding of positions up to 10⁵ pixels, so that no neighbour is missed.
    let cell = (around.epsilon * 1.001 + 0.05).max(MIN_CELL_PX);
    let across = |truth: u32, here: u32| ((f64::from(truth) / cell).ceil() as u32 + 2).clamp(3, here / 2 + 3);
    let grid = [across(truth.width, width), across(truth.height, height)];
    let cells = grid[0] * grid[1];
    let bins = Bins::new(device, position.buffer.as_entire_binding(), u64::from(pixels), u64::from(cells))?;
    let uniform = |first: u32, count: u32, slice: u32| {
        let block = torn_block(frame, truth, around, [position.first, cells], cell);
        let block =
            TornBlock { grid: [grid[0], grid[1], first, count], slice: [slice, POINTS_PER_SLICE, 0, 0], ..block };
        device.filled_buffer("discontinuity", bytemuck::cast_slice(&[block]), BufferUsages::UNIFORM)
    };
    let all = uniform(0, pixels, 0)?;
    let alone = frame.alone();
    let mut work = Work::new(device);
    work.encoder.clear_buffer(&bins.counts, 0, None);
    bins.run(&mut work, PLACE, &all, groups(pixels))?;
    bins.run(&mut work, ADD_UP, &all, [1, 1])?;
    bins.run(&mut work, SCATTER, &all, groups(pixels))?;
    bins.most.bring(&mut work.encoder);
    work.submit(progress)?;
    drop(alone);
    let most = bins.most.read(progress, |bytes| bytes.first_chunk().copied().map_or(0, u32::from_ne_bytes))?;
    let slices = || (0..most.max(1)).step_by(POINTS_PER_SLICE as usize);
    let mut under_way = UnderWay { device, progress, last: None };
    for slice in slices() {
        let mut work = Work::new(device);
        bins.run(&mut work, ORDER, &uniform(0, pixels, slice)?, groups(pixels))?;
        if slice + POINTS_PER_SLICE >= most {
            bins.run(&mut work, GATHER, &all, groups(pixels))?;
        }
        under_way.submit(work, 0)?;
    }
    let few = (PAIRS_PER_SUBMISSION / (9.0 * f64::from(most.clamp(1, POINTS_PER_SLICE))))
        .clamp(4096.0, f64::from(1 << 20)) as u32;
    for first in (0..pixels).step_by(few as usize) {
        let count = few.min(pixels - first);
        for slice in slices() {
            let mut work = Work::new(device);
            bins.run(&mut work, TEAR, &uniform(first, count, slice)?, groups(count))?;
            let ends = slice + POINTS_PER_SLICE >= most;
            if ends && first + count == pixels {
                bins.torn.bring(&mut work.encoder);
            }
            under_way.submit(work, if ends { count } else { 0 })?;
        }
    }
    let mut image = vec![0.0f32; pixels as usize];
    bins.torn.read(progress, |bytes| copy(bytemuck::cast_slice_mut(&mut image), bytes))?;
    Ok(image)
}

/// Last submission: at most one is in flight while the next is encoded.
struct UnderWay<'a> {
    device: &'a Device,
    progress: &'a Progress,
    last: Option<(Submission, u32)>,
}

impl UnderWay<'_> {
    /// Submits work that finishes some points, and waits for the previous submission.
    fn submit(&mut self, work: Work<'_>, points: u32) -> Result<()> {
        if let Some((before, points)) = self.last.replace((work.submit(self.progress)?, points)) {
            self.device.wait(&before, self.progress)?;
            self.progress.report(u64::from(points))?;
        }
        Ok(())
    }
}

fn check(device: &Device, [width, height]: [u32; 2]) -> Result<()> {
    let (pixels, most) = (u64::from(width) * u64::from(height), device.largest_binding() / 16);
    if pixels > most {
        let label = device.report().label();
        return Err(Error::Device(format!(
            "{label}: a frame of {width} × {height} pixels, {most} pixels can be sorted; use nearfar.metrics.discontinuity"
        )));
    }
    Ok(())
}

/// Returns the uniform block: rows that map a point to its position in the truth, and the limits.
fn torn_block(
    frame: &DeviceFrame,
    truth: &Camera,
    around: Neighbourhood,
    [first, cells]: [u32; 2],
    cell: f64,
) -> TornBlock {
    let Axes { right, up, ahead, fov } = Axes::new(truth);
    let (across, down) =
        (f64::from(truth.width) / (fov.right - fov.left), f64::from(truth.height) / (fov.up - fov.down));
    let eye = truth.position - frame.origin();
    let eye_high = eye.as_vec3();
    let wide = |v: DVec4| v.as_vec4().to_array();
    let parallel = if truth.is_parallel() { 1.0 } else { 0.0 };
    let low: DVec3 = eye - eye_high.as_dvec3();
    TornBlock {
        x: wide((right * across).extend(-fov.left * across)),
        y: wide((-up * down).extend(fov.up * down)),
        ahead: wide(ahead.extend(parallel)),
        eye_high: eye_high.extend(0.0).to_array(),
        eye_low: wide(low.extend(0.0)),
        limits: [around.epsilon * around.epsilon, around.least * around.least, 1.0 / cell, 0.0].map(|x| x as f32),
        size: [frame.camera().width, frame.camera().width * frame.camera().height, first, cells],
        grid: [0; 4],
        slice: [0; 4],
    }
}

impl<'a> Bins<'a> {
    fn new(device: &'a Device, positions: BindingResource<'a>, pixels: u64, cells: u64) -> Result<Self> {
        Ok(Self {
            positions,
            shifts: LentBuffer::scratch(device, 8 * pixels)?,
            cells: LentBuffer::scratch(device, 8 * pixels)?,
            counts: LentBuffer::scratch(device, 4 * cells)?,
            starts: LentBuffer::scratch(device, 4 * (cells + 1))?,
            list: LentBuffer::scratch(device, 4 * pixels)?,
            points: LentBuffer::scratch(device, 16 * pixels)?,
            torn: Results::new(device, 4 * pixels)?,
            most: Results::new(device, 4)?,
        })
    }

    /// Encodes a kernel.
    fn run(&self, work: &mut Work<'_>, kernel: Kernel, uniform: &wgpu::Buffer, groups: [u32; 2]) -> Result<()> {
        let (entry, bindings) = kernel;
        let text = &[include_str!("../shaders/compute_discontinuity.wgsl")];
        let buffers = [&self.shifts, &self.cells, &self.counts, &self.starts, &self.list, &self.points];
        let results = [&self.torn.on_device, &self.most.on_device];
        let mut all = vec![uniform.as_entire_binding(), self.positions.clone()];
        all.extend(buffers.into_iter().chain(results).map(LentBuffer::binding));
        let resources: Vec<_> = bindings.iter().map(|&binding| (binding, all[binding as usize].clone())).collect();
        work.run(&Program { text, entry, constants: &[], group: 0 }, &resources, groups)
    }
}
