//! Uniform blocks of a picture's kernels.

use std::num::NonZeroU64;
use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::Result;
use nearfar_core::orthoview::splat::Plan;
use wgpu::{BindingResource, Buffer, BufferBinding, BufferUsages};

use crate::device::Device;

/// Bytes between blocks: a multiple of every adapter's alignment.
const STRIDE: usize = 512;

/// The uniform block `Draw` of `splat.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct DrawBlock {
    pub size: [u32; 4],
    work: [u32; 4],
    pub outputs: [u32; 4],
    limits: [u32; 4],
    start: [[f32; 4]; 3],
    direction: [[f32; 4]; 3],
    segment: [f32; 4],
    planes: [[f32; 4]; 8],
}

impl DrawBlock {
    /// Creates the block of a picture, without size, work and outputs.
    pub fn new(plan: &Plan<'_>) -> Self {
        let (picture, half_spaces) = (plan.picture(), plan.planes());
        let mut planes = [[0.0; 4]; 8];
        planes[..half_spaces.len()].copy_from_slice(&half_spaces);
        let limits = [
            half_spaces.len() as u32,
            u32::from(!picture.limits.is_none()),
            u32::from(picture.pixels.bare),
            u32::from(picture.before.is_some()),
        ];
        let segment = picture.limits.segment;
        Self {
            size: [0; 4],
            work: [0, 0, 0, plan.views.len() as u32],
            outputs: [0; 4],
            limits,
            start: plan.rays.start,
            direction: plan.rays.direction,
            segment: [segment.t_min, segment.t_max.min(f32::MAX), 0.0, 0.0],
            planes,
        }
    }

    /// Returns the block for a pass over some pieces.
    pub fn with_work(mut self, pieces: &Range<u32>, pass: u32) -> Self {
        [self.work[0], self.work[1], self.work[2]] = [pieces.start, pieces.end - pieces.start, pass];
        self
    }
}

/// Uniform blocks in one buffer.
pub(super) struct Uniforms(Buffer);

impl Uniforms {
    pub fn new(device: &Device, blocks: &[DrawBlock]) -> Result<Self> {
        let mut bytes = vec![0u8; blocks.len() * STRIDE];
        for (slot, block) in bytes.chunks_exact_mut(STRIDE).zip(blocks) {
            slot[..size_of_val(block)].copy_from_slice(bytemuck::bytes_of(block));
        }
        device.filled_buffer("splats", &bytes, BufferUsages::UNIFORM).map(Self)
    }

    pub fn binding(&self, number: usize) -> BindingResource<'_> {
        let size = NonZeroU64::new(size_of::<DrawBlock>() as u64);
        BindingResource::Buffer(BufferBinding { buffer: &self.0, offset: (number * STRIDE) as u64, size })
    }
}
