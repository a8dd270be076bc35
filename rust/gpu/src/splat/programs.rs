//! Kernels of a picture.

use nearfar_core::base::Result;
use nearfar_core::orthoview::splat::{BORDER, HEAD, LANE_BITS, MIN_COSINE, SQUARED_RADIUS};
use wgpu::BindingResource;

use crate::compute::programs::{Program, Work};
use crate::draw::shading_constants;

const LIGHT: &str = include_str!("../shaders/light.wgsl");
const SPLAT: &str = include_str!("../shaders/splat.wgsl");
const WORDS: &str = include_str!("../shaders/splat_words.wgsl");
const PAGE: &str = include_str!("../shaders/splat_page.wgsl");
const PAGES: &str = include_str!("../shaders/splat_pages.wgsl");
const DRAW: &str = include_str!("../shaders/splat_draw.wgsl");
const KEY_64: &str = include_str!("../shaders/splat_key64.wgsl");
const KEY_32: &str = include_str!("../shaders/splat_key32.wgsl");
const TILES: &str = include_str!("../shaders/splat_tiles.wgsl");
const RESOLVE: &str = include_str!("../shaders/splat_resolve.wgsl");

#[derive(Clone, Copy)]
pub(super) enum Kernel {
    /// Draws pieces of views in one page.
    Draw,
    /// Computes the farthest depth order of each tile.
    Tiles,
    /// Converts keys to colours.
    Resolve,
}

/// Kernels of a picture.
pub(super) struct Kernels {
    /// Whether rays are parallel.
    pub is_parallel: bool,
    /// Whether 64-bit atomics are used.
    pub is_long: bool,
}

impl Kernels {
    /// Encodes a kernel; resources come with their binding numbers.
    pub fn run(
        &self,
        work: &mut Work<'_>,
        kernel: Kernel,
        resources: &[(u32, BindingResource<'_>)],
        groups: [u32; 2],
    ) -> Result<()> {
        let numbers = numbers();
        let key = if self.is_long { KEY_64 } else { KEY_32 };
        let (entry, text) = match kernel {
            Kernel::Draw => ("splat_draw", [&numbers, SPLAT, PAGE, WORDS, key, DRAW].concat()),
            Kernel::Tiles => ("splat_tiles", [&numbers, SPLAT, TILES].concat()),
            Kernel::Resolve => {
                ("splat_resolve", [&numbers, &shading_constants()[..], LIGHT, SPLAT, PAGES, WORDS, RESOLVE].concat())
            }
        };
        let constants = [("PARALLEL", u32::from(self.is_parallel)), ("LONG", u32::from(self.is_long))];
        work.run(&Program { text: &[&text], entry, constants: &constants, group: 0 }, resources, groups)
    }
}

/// Returns the constants that shaders share with the processor's kernels.
fn numbers() -> String {
    let epsilon = f32::EPSILON;
    format!(
        "const HEAD: u32 = {HEAD}u;\nconst LANE_BITS: u32 = {LANE_BITS}u;\nconst SQUARED_RADIUS: f32 = {SQUARED_RADIUS:?};\n\
         const BORDER: f32 = {BORDER:?};\nconst MIN_COSINE: f32 = {MIN_COSINE:?};\n\
         const EPSILON: f32 = {epsilon:?};\nconst MAX: f32 = 0x1.fffffep+127f;\n"
    )
}
