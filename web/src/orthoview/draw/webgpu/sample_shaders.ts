/** WGSL for samples: uniforms of a call, initial depths, farthest depths of tiles, and averages for pixels. */
import { LIGHT_WGSL } from '../../../shaders/light';

/** Threads per workgroup. */
export const GROUP = 64;
/** Workgroups per row of a dispatch. */
export const ROW = 16384;
/** Width and height of a tile of samples whose farthest depth is stored. */
export const TILE = 16;
/** Uniforms of a call. */
export const DRAW = /* wgsl */ `
struct Draw {
  // Gradients of X, Y and W; ray through the picture's corner, and its changes by a sample to the right and down.
  gradients: array<vec4<f32>, 3>,
  rays: array<vec4<f32>, 3>,
  // Width and height of the band in samples, its first row in the picture, samples along each axis of a pixel.
  size: vec4<u32>,
  // First part, number of parts, round.
  work: vec4<u32>,
  // Number of parts of all calls, index of the page.
  all: vec4<u32>,
  // Near distance, metres. A depth is the near distance divided by the distance along the axis.
  nearest: f32,
}

@group(0) @binding(0) var<uniform> draw: Draw;
`;

/** Farthest depth of each tile, for the module of splats. */
export const FARTHEST_OF_TILES = /* wgsl */ `
// One thread reads all samples of a tile; a parallel reduction by a workgroup takes longer.
@compute @workgroup_size(GROUP)
fn farthest_of_tiles(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
  let number = (group.y * ROW + group.x) * GROUP + lane;
  let rows = (draw.size.y + TILE - 1u) / TILE;
  if number >= tile_columns() * rows {
    return;
  }
  let first = vec2<u32>(number % tile_columns(), number / tile_columns()) * TILE;
  let end = min(first + TILE, draw.size.xy);
  var farthest = 0xffffffffu;
  for (var y = first.y; y < end.y; y++) {
    for (var x = first.x; x < end.x; x++) {
      farthest = min(farthest, atomicLoad(&depth_bits[y * draw.size.x + x]));
    }
  }
  atomicStore(&tiles[1u + number], farthest);
}
`;

/** Initial depths of samples, from the geometry. */
export const BEGIN = /* wgsl */ `
${DRAW}
@group(0) @binding(1) var depths: texture_depth_2d;
@group(0) @binding(2) var<storage, read_write> depth_bits: array<u32>;

@compute @workgroup_size(${GROUP})
fn begin(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
  let sample = (group.y * ${ROW}u + group.x) * ${GROUP}u + lane;
  if sample >= draw.size.x * draw.size.y {
    return;
  }
  let position = vec2<u32>(sample % draw.size.x, sample / draw.size.x);
  depth_bits[sample] = bitcast<u32>(textureLoad(depths, position, 0));
}
`;

/** Mean of a pixel's samples in linear light; empty samples show the sky of docs/render.md. */
export const RESOLVE = /* wgsl */ `
${DRAW}
@group(0) @binding(1) var geometry: texture_2d<f32>;
@group(0) @binding(2) var<storage, read> depth_bits: array<u32>;
@group(0) @binding(3) var<storage, read> colors: array<u32>;
${LIGHT_WGSL}
@vertex
fn cover_picture(@builtin(vertex_index) n: u32) -> @builtin(position) vec4<f32> {
  return vec4<f32>(f32(n & 1u) * 4.0 - 1.0, f32(n >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn resolve(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
  let grid = draw.size.w;
  let first = vec2<u32>(pixel.xy) * grid;
  var sum = vec3<f32>(0.0);
  for (var row = 0u; row < grid; row++) {
    for (var column = 0u; column < grid; column++) {
      let position = first + vec2<u32>(column, row);
      let in_band = vec2<u32>(position.x, position.y - draw.size.z);
      let sample = in_band.y * draw.size.x + in_band.x;
      let code = colors[sample];
      if code != 0u {
        let bits = vec3<u32>(code >> 20u, code >> 10u, code) & vec3<u32>(1023u);
        sum += linear_of(vec3<f32>(bits) / 1023.0);
      } else if depth_bits[sample] != 0u {
        sum += textureLoad(geometry, in_band, 0).rgb;
      } else {
        let center = vec2<f32>(position) + 0.5;
        sum += background(normalize(draw.rays[0].xyz + center.x * draw.rays[1].xyz + center.y * draw.rays[2].xyz));
      }
    }
  }
  return vec4<f32>(srgb_of(sum / f32(grid * grid)), 1.0);
}
`;
