/** WGSL of the geometry of near leaves, and of mipmaps. */
import { LIGHT_WGSL } from '../../../shaders/light';
import { DRAW } from './sample_shaders';

export const MESHES = /* wgsl */ `
${DRAW}
struct Mesh {
  // Vector from the eye to the leaf's origin; w is the minimum alpha that is drawn, negative for opaque materials.
  offset: vec4<f32>,
  base: vec4<f32>,
  // Emitted light; w is 1 for unlit materials.
  emission: vec4<f32>,
}

@group(1) @binding(0) var<uniform> mesh: Mesh;
@group(2) @binding(0) var image: texture_2d<f32>;
@group(2) @binding(1) var glow: texture_2d<f32>;
@group(2) @binding(2) var image_sampler: sampler;
@group(2) @binding(3) var glow_sampler: sampler;
${LIGHT_WGSL}
// Values that the vertex shader passes on and the rasteriser interpolates.
struct Varyings {
  @builtin(position) clip_position: vec4<f32>,
  // Metres.
  @location(0) from_eye: vec3<f32>,
  @location(1) normal: vec3<f32>,
  @location(2) uv: vec2<f32>,
  @location(3) color: vec3<f32>,
}

@vertex
fn transform(
  @location(0) position: vec3<f32>,
  // Zero for flat shading.
  @location(1) normal: vec3<f32>,
  @location(2) uv: vec2<f32>,
  @location(3) color: vec4<f32>,
  // Rows of the matrix from the mesh to metres from the leaf's origin.
  @location(4) row_x: vec4<f32>,
  @location(5) row_y: vec4<f32>,
  @location(6) row_z: vec4<f32>,
) -> Varyings {
  let at = vec4<f32>(position, 1.0);
  var out: Varyings;
  out.from_eye = vec3<f32>(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + mesh.offset.xyz;
  // Normals are transformed by the cofactor matrix, for any scale and handedness.
  let cofactors = mat3x3<f32>(cross(row_y.xyz, row_z.xyz), cross(row_z.xyz, row_x.xyz), cross(row_x.xyz, row_y.xyz));
  out.normal = normal * cofactors;
  out.uv = uv;
  out.color = color.rgb;
  let p = out.from_eye;
  let xyw = vec3<f32>(dot(draw.gradients[0].xyz, p), dot(draw.gradients[1].xyz, p), dot(draw.gradients[2].xyz, p));
  // The picture is drawn in bands of rows; size.z is the first row of this band.
  let row = xyw.y - f32(draw.size.z) * xyw.z;
  let clip = vec2<f32>(2.0 * xyw.x / f32(draw.size.x) - xyw.z, xyw.z - 2.0 * row / f32(draw.size.y));
  // Depth is the near distance divided by the distance along the axis, as for splats.
  out.clip_position = vec4<f32>(clip, draw.nearest, xyw.z);
  return out;
}

// Vertex normal, or face normal if the vertex normal has length 0, on the side of the face that the viewer sees.
fn shading_normal(varyings: Varyings, face_normal: vec3<f32>) -> vec3<f32> {
  let toward = -normalize(varyings.from_eye);
  let face_length = length(face_normal);
  var face = select(toward, face_normal / face_length, face_length > 0.0);
  face = select(face, -face, dot(face, toward) < 0.0);
  let vertex_length = length(varyings.normal);
  if vertex_length == 0.0 {
    return face;
  }
  let n = varyings.normal / vertex_length;
  return select(n, -n, dot(n, face) < 0.0);
}

// Mipmap level whose texels have the area of a pixel.
fn level_of(texture: texture_2d<f32>, right: vec2<f32>, down: vec2<f32>) -> f32 {
  let size = vec2<f32>(textureDimensions(texture));
  let dx = right * size;
  let dy = down * size;
  return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}

@fragment
fn shade(varyings: Varyings) -> @location(0) vec4<f32> {
  let normal = shading_normal(varyings, cross(dpdx(varyings.from_eye), dpdy(varyings.from_eye)));
  let right = dpdx(varyings.uv);
  let down = dpdy(varyings.uv);
  let texel = textureSampleLevel(image, image_sampler, varyings.uv, level_of(image, right, down));
  let light = textureSampleLevel(glow, glow_sampler, varyings.uv, level_of(glow, right, down)).rgb;
  let alpha = mesh.base.a * textureSampleLevel(image, image_sampler, varyings.uv, 0.0).a;
  if alpha < mesh.offset.w {
    discard;
  }
  let albedo = mesh.base.rgb * varyings.color * texel.rgb;
  return vec4<f32>(albedo * mix(irradiance(normal), vec3<f32>(1.0), mesh.emission.w) + mesh.emission.rgb * light, 1.0);
}
`;

/** Shader that computes a mipmap level: averages four texels of the finer level. */
export const LEVEL = /* wgsl */ `
@group(0) @binding(0) var finer: texture_2d<f32>;
@group(0) @binding(1) var smooth_texels: sampler;

struct Varyings {
  @builtin(position) clip_position: vec4<f32>,
  @location(0) uv: vec2<f32>,
}

@vertex
fn cover_picture(@builtin(vertex_index) n: u32) -> Varyings {
  let at = vec2<f32>(f32(n & 1u) * 2.0, f32(n >> 1u) * 2.0);
  return Varyings(vec4<f32>(at.x * 2.0 - 1.0, 1.0 - at.y * 2.0, 0.0, 1.0), at);
}

@fragment
fn level(varyings: Varyings) -> @location(0) vec4<f32> {
  return textureSampleLevel(finer, smooth_texels, varyings.uv, 0.0);
}
`;
