/** WGSL for splats: they raise the depths of samples, and the nearest ones then set the colours. */
import { float, LIGHT_WGSL } from '../../../shaders/light';
import { BORDER_FACTOR, MIN_COSINE, SQUARED_RADIUS, VECTORS_PER_VIEW } from '../projection';
import { DRAW, FARTHEST_OF_TILES, GROUP, ROW, TILE } from './sample_shaders';

/** Greatest number of samples of a splat that one thread draws; the workgroup draws larger splats together. */
const MAX_THREAD_SAMPLES = 256;

/** Module that finds depths and splats of samples, farthest depths of tiles, and the splats' light. */
export const SPLATS = /* wgsl */ `
${DRAW}
struct Part {
  view: u32,
  // First word in the page, number of splats, and index of the first splat among those of all parts.
  first: u32,
  count: u32,
  number: u32,
  // Bits of the depth of the part's nearest point.
  nearest_bits: u32,
  // Bounds [low, high) in the picture: 16 bits each of column and row.
  low: u32,
  high: u32,
  page: u32,
}

@group(0) @binding(1) var<storage, read> views: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> parts: array<Part>;
// Indices of all parts, sorted by their first splats.
@group(0) @binding(3) var<storage, read> part_order: array<u32>;
@group(0) @binding(4) var<storage, read> words: array<u32>;
// Number of splats of visible parts, then the bits of each tile's farthest depth.
@group(0) @binding(5) var<storage, read_write> tiles: array<atomic<u32>>;
// Bits of the samples' depths: floats of at least 0 compare like their bits.
@group(0) @binding(6) var<storage, read_write> depth_bits: array<atomic<u32>>;
// For each sample, LAST minus the index of its splat; shade() replaces it by the colour.
@group(0) @binding(7) var<storage, read_write> colors: array<atomic<u32>>;
${LIGHT_WGSL}
const TILE = ${TILE}u;
const GROUP = ${GROUP}u;
const ROW = ${ROW}u;
// Number of splats of a part after which the workgroup draws the large ones among them.
const BATCH = 1024u;
const RADIUS = ${float(Math.sqrt(SQUARED_RADIUS))};
const SQUARED_RADIUS = ${float(SQUARED_RADIUS)};

struct Ellipse {
  middle: vec2<f32>,
  // Inverse of the matrix of axes, by rows.
  inverse: vec4<f32>,
  // 1/W at the middle, and its changes by a column and a row.
  nearness: vec3<f32>,
  // First and last column and row; nothing is shown if low exceeds high.
  low: vec2<i32>,
  high: vec2<i32>,
  normal: vec3<f32>,
  code: u32,
}

// Tolerance of depths in the second round, in steps of float32, as compilers may round differently in each round.
const SLACK = 4u;
const LAST = 0x7fffffffu;
// Flag of colours.
const COLOR = 0x80000000u;

fn view_vector(view: u32, n: u32) -> vec4<f32> {
  return views[view * ${VECTORS_PER_VIEW}u + n];
}

// Half the extent of a ball along an axis of the picture: the length of the gradient of X/W (or Y/W).
fn half_extent(view: u32, gradient: vec3<f32>, ratio: f32, inverse_w: f32) -> f32 {
  return length((gradient - ratio * draw.gradients[2].xyz) * inverse_w) * view_vector(view, 2u).w;
}

fn normal_of(codes: u32, scale: f32) -> vec3<f32> {
  let flat = vec2<f32>(f32(codes & 4095u), f32((codes >> 12u) & 4095u)) * scale - 1.0;
  let z = 1.0 - abs(flat.x) - abs(flat.y);
  let fold = max(-z, 0.0);
  return normalize(vec3<f32>(flat - select(vec2<f32>(fold), vec2<f32>(-fold), flat < vec2<f32>(0.0)), z));
}

fn ellipse_of(part: Part, number: u32) -> Ellipse {
  let word_index = part.first + 3u * number;
  let word = vec3<u32>(words[word_index], words[word_index + 1u], words[word_index + 2u]);
  let view = part.view;
  let column = view_vector(view, 1u);
  let row = view_vector(view, 2u);
  let step = view_vector(view, 3u).xyz;
  let depth = f32(((word.x >> 24u) << 8u) | (word.y >> 24u)) - 0.5;
  // Column, row and depth step of the splat's centre.
  let p = vec3<f32>(f32(word.z & 4095u) + 0.5, f32((word.z >> 12u) & 4095u) + 0.5, depth);
  let box_x = view_vector(view, 7u);
  let box_y = view_vector(view, 8u);
  let box_z = view_vector(view, 9u);
  let inside = vec3<f32>(dot(box_x.xyz, p) + box_x.w, dot(box_y.xyz, p) + box_y.w, dot(box_z.xyz, p) + box_z.w);
  let start = view_vector(view, 0u);
  let xyw = start.xyz + p.x * column.xyz + p.y * row.xyz + p.z * step;
  let inverse_w = 1.0 / xyw.z;
  let middle = xyw.xy * inverse_w;

  // Normal, and the change of depth per pixel on its plane.
  var normal = normal_of(word.y, column.w);
  let facing = 1.0 / max(dot(view_vector(view, 6u).xyz, normal), ${float(MIN_COSINE)});
  let u = column.xyz + dot(view_vector(view, 4u).xyz, normal) * facing * step;
  let v = row.xyz - dot(view_vector(view, 5u).xyz, normal) * facing * step;
  let is_surfel = ((word.z >> 24u) & 1u) == 1u;
  let factor = select(0.0, select(${float(BORDER_FACTOR)}, 1.0, ((word.z >> 25u) & 1u) == 1u), is_surfel);

  var ellipse: Ellipse;
  ellipse.middle = middle;
  ellipse.nearness = vec3<f32>(inverse_w, 0.0, 0.0);
  // The ellipse's axes in the picture, and the changes of nearness along them.
  let du = (u.xy - middle * u.z) * inverse_w * factor;
  let dv = (v.xy - middle * v.z) * inverse_w * factor;
  let slope = -vec2<f32>(u.z, v.z) * inverse_w * inverse_w * factor;
  var half_size = vec2<f32>(0.0);
  if is_surfel {
    // Edge-on, a surfel is a line; only the sample at its centre shows it.
    let determinant = du.x * dv.y - dv.x * du.y;
    let is_flat = abs(determinant) <= 1.2e-7 * (abs(du.x) + abs(dv.x)) * (abs(du.y) + abs(dv.y));
    if is_flat {
      ellipse.inverse = vec4<f32>(1e9);
    } else {
      let inverse = vec4<f32>(dv.y, -dv.x, -du.y, du.x) / determinant;
      ellipse.inverse = inverse;
      ellipse.nearness.y = slope.x * inverse.x + slope.y * inverse.z;
      ellipse.nearness.z = slope.x * inverse.y + slope.y * inverse.w;
      half_size = RADIUS * sqrt(vec2<f32>(du.x * du.x + dv.x * dv.x, du.y * du.y + dv.y * dv.y));
    }
  } else {
    let ball = vec2<f32>(
      half_extent(view, draw.gradients[0].xyz, middle.x, inverse_w),
      half_extent(view, draw.gradients[1].xyz, middle.y, inverse_w),
    );
    ellipse.inverse = vec4<f32>(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
    half_size = RADIUS * ball;
  }
  let first = f32(draw.size.z);
  let first_sample = vec2<f32>(0.0, first);
  let last_sample = vec2<f32>(f32(draw.size.x), first + f32(draw.size.y)) - 1.0;
  ellipse.low = vec2<i32>(max(min(ceil(middle - half_size - 0.5), floor(middle)), first_sample));
  ellipse.high = vec2<i32>(min(max(floor(middle + half_size - 0.5), floor(middle)), last_sample));
  ellipse.code = word.x & 0xffffffu;
  ellipse.normal = normal;
  // Splats near the eye are not shown: the derivatives at their middle would give huge ellipses.
  let is_shown = xyw.z - RADIUS * factor * length(vec2<f32>(u.z, v.z)) >= start.w
    && all(inside >= vec3<f32>(0.0)) && all(inside < vec3<f32>(1.0));
  if !is_shown {
    ellipse.low = vec2<i32>(0);
    ellipse.high = vec2<i32>(-1);
  }
  return ellipse;
}

fn cover(ellipse: Ellipse, position: vec2<i32>, number: u32) {
  let p = vec2<f32>(position) + 0.5 - ellipse.middle;
  let q = vec2<f32>(dot(ellipse.inverse.xy, p), dot(ellipse.inverse.zw, p));
  let is_inside = dot(q, q) <= SQUARED_RADIUS;
  // The sample that holds a splat's middle always belongs to it.
  if !is_inside && any(position != vec2<i32>(floor(ellipse.middle))) {
    return;
  }
  let nearness = ellipse.nearness.x + select(0.0, dot(ellipse.nearness.yz, p), is_inside);
  let bits = bitcast<u32>(clamp(draw.nearest * nearness, 1e-30, 1.0));
  let sample = (u32(position.y) - draw.size.z) * draw.size.x + u32(position.x);
  if draw.work.z == 0u {
    atomicMax(&depth_bits[sample], bits);
  } else if bits + SLACK >= atomicLoad(&depth_bits[sample]) {
    atomicMax(&colors[sample], LAST - number);
  }
}

fn extent_of(ellipse: Ellipse) -> vec2<u32> {
  return vec2<u32>(max(ellipse.high - ellipse.low + 1, vec2<i32>(0)));
}

// First column and row of the tiles that a part may cover, and the numbers of their columns and rows.
fn tiles_of(part: Part) -> vec4<u32> {
  let low = vec2<u32>(part.low & 0xffffu, max(part.low >> 16u, draw.size.z) - draw.size.z);
  let bottom = min(part.high >> 16u, draw.size.z + draw.size.y);
  let high = vec2<u32>(part.high & 0xffffu, max(bottom, draw.size.z) - draw.size.z);
  if any(high <= low) {
    return vec4<u32>(0u);
  }
  return vec4<u32>(low / TILE, (high + TILE - 1u) / TILE - low / TILE);
}

fn tile_columns() -> u32 {
  return (draw.size.x + TILE - 1u) / TILE;
}

var<workgroup> is_reached: atomic<u32>;
var<workgroup> is_visible: u32;
// Splats that cover many samples.
var<workgroup> large_count: atomic<u32>;
var<workgroup> large: array<u32, BATCH>;

// Each workgroup draws a part, unless the part lies behind the farthest depth of each tile that it may cover.
@compute @workgroup_size(GROUP)
fn splats(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
  let number = group.y * ROW + group.x;
  if number >= draw.work.y {
    return;
  }
  let part = parts[draw.work.x + number];
  let part_tiles = tiles_of(part);
  for (var n = lane; n < part_tiles.z * part_tiles.w; n += GROUP) {
    let tile = (part_tiles.y + n / part_tiles.z) * tile_columns() + part_tiles.x + n % part_tiles.z;
    if atomicLoad(&tiles[1u + tile]) <= part.nearest_bits {
      atomicStore(&is_reached, 1u);
    }
  }
  workgroupBarrier();
  if lane == 0u {
    is_visible = atomicLoad(&is_reached);
    if is_visible == 1u && draw.work.z == 0u {
      atomicAdd(&tiles[0], part.count);
    }
  }
  if workgroupUniformLoad(&is_visible) == 0u {
    return;
  }
  for (var first = 0u; first < part.count; first += BATCH) {
    let end = min(first + BATCH, part.count);
    for (var n = first + lane; n < end; n += GROUP) {
      let ellipse = ellipse_of(part, n);
      let extent = extent_of(ellipse);
      if extent.x * extent.y > ${MAX_THREAD_SAMPLES}u {
        large[atomicAdd(&large_count, 1u)] = n;
        continue;
      }
      for (var y = ellipse.low.y; y <= ellipse.high.y; y++) {
        for (var x = ellipse.low.x; x <= ellipse.high.x; x++) {
          cover(ellipse, vec2<i32>(x, y), part.number + n);
        }
      }
    }
    workgroupBarrier();
    let count = atomicLoad(&large_count);
    for (var large_index = 0u; large_index < count; large_index++) {
      let n = large[large_index];
      let ellipse = ellipse_of(part, n);
      let extent = extent_of(ellipse);
      for (var position = lane; position < extent.x * extent.y; position += GROUP) {
        cover(ellipse, ellipse.low + vec2<i32>(vec2<u32>(position % extent.x, position / extent.x)), part.number + n);
      }
    }
    workgroupBarrier();
    if lane == 0u {
      atomicStore(&large_count, 0u);
    }
    workgroupBarrier();
  }
}

// Index of the part that contains a splat.
fn part_of(splat: u32) -> u32 {
  var low = 0u;
  var high = draw.all.x;
  while high - low > 1u {
    let middle = (low + high) / 2u;
    if parts[part_order[middle]].number <= splat {
      low = middle;
    } else {
      high = middle;
    }
  }
  return part_order[low];
}

// Shades the samples whose splats lie in one page.
@compute @workgroup_size(GROUP)
fn shade(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
  let sample = (group.y * ROW + group.x) * GROUP + lane;
  if sample >= draw.size.x * draw.size.y {
    return;
  }
  let code = atomicLoad(&colors[sample]);
  if code == 0u || (code & COLOR) != 0u {
    return;
  }
  let part = parts[part_of(LAST - code)];
  if part.page != draw.all.y {
    return;
  }
  let ellipse = ellipse_of(part, LAST - code - part.number);
  // Normals face the viewer, because surfaces that a cell's side cuts are seen from inside.
  let ray = draw.rays[0].xyz + ellipse.middle.x * draw.rays[1].xyz + ellipse.middle.y * draw.rays[2].xyz;
  let normal = select(ellipse.normal, -ellipse.normal, dot(ellipse.normal, ray) > 0.0);
  let bytes = vec3<u32>(ellipse.code, ellipse.code >> 8u, ellipse.code >> 16u) & vec3<u32>(255u);
  let albedo = linear_of(vec3<f32>(bytes) / 255.0);
  let bits = vec3<u32>(srgb_of(albedo * irradiance(normal)) * 1023.0 + 0.5);
  atomicStore(&colors[sample], COLOR | (bits.x << 20u) | (bits.y << 10u) | bits.z);
}
${FARTHEST_OF_TILES}`;
