//! Morph of long arrays of float32 points.

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::{Progress, Result};
use nearfar_core::morph::{Kind, Morph};
use wgpu::BufferUsages;

use super::programs::{Program, groups};
use super::stream::stream;
use crate::device::Device;

/// The uniform block `Morph` of `compute_morph.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct MorphBlock {
    center_high: [f32; 4],
    center_low: [f32; 4],
    offset: [f32; 4],
    radii: [f32; 4],
    count: [u32; 4],
}

/// Writes the morphed points.
pub fn morph(
    device: &Device,
    morph: &Morph,
    points: &[[f32; 3]],
    displayed: &mut [[f32; 3]],
    progress: &Progress,
) -> Result<()> {
    device.check()?;
    let program = Program {
        text: &[
            include_str!("../shaders/morph.wgsl"),
            include_str!("../shaders/world.wgsl"),
            include_str!("../shaders/compute_morph.wgsl"),
        ],
        entry: "morph_points",
        constants: &[("KEEPS_RHO", u32::from(morph.kind == Kind::Cylinder))],
        group: 0,
    };
    let out = (bytemuck::cast_slice_mut(displayed), size_of::<[f32; 3]>());
    stream(device, points, out, progress, |work, input, results, rows| {
        let block = morph_block(morph, rows.len());
        let uniform = device.filled_buffer("morph", &[block], BufferUsages::UNIFORM)?;
        let resources = [(0, uniform.as_entire_binding()), (1, input.binding()), (2, results.binding())];
        work.run(&program, &resources, groups(rows.len() as u32))
    })
}

fn morph_block(morph: &Morph, points: usize) -> MorphBlock {
    // O as the sum of two numbers: float32 alone would be off by metres at 10⁷ m.
    let high = morph.center.as_vec3();
    let low = (morph.center - high.as_dvec3()).as_vec3();
    // Same as `zones_of`, in float64. If both radii are 0, nothing is near: w is 0, and all points move.
    let slope = if morph.r2 > 0.0 { 1.0 / (morph.r2 - morph.r1) } else { 0.0 };
    let stays = if morph.r2 > 0.0 && morph.strength == 1.0 { morph.r1 } else { -1.0 };
    MorphBlock {
        center_high: high.extend(morph.strength as f32).to_array(),
        center_low: low.extend(0.0).to_array(),
        offset: (morph.user - morph.center).as_vec3().extend(0.0).to_array(),
        radii: [stays, morph.r2, slope, 0.0].map(|x| x as f32),
        count: [points as u32, 0, 0, 0],
    }
}
