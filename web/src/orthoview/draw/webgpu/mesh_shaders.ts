/** WGSL of the geometry of near leaves, and of mipmaps. */
import { LIGHT_WGSL } from '../../../shaders/light';
import { DRAW } from './sample_shaders';

export const MESHES = /* wgsl */ `
${DRAW}
struct Mesh {
  // Vector from the eye to the leaf's origin; w is the least alpha that is drawn, negative for opaque materials.
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
struct Corner {
  @builtin(position) place: vec4<f32>,
  @location(0) point: vec3<f32>,
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
) -> Corner {
  let at = vec4<f32>(position, 1.0);
  var out: Corner;
  out.point = vec3<f32>(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + mesh.offset.xyz;
  // Normals are transformed by the cofactor matrix, for any scale and handedness.
  let cofactors = mat3x3<f32>(cross(row_y.xyz, row_z.xyz), cross(row_z.xyz, row_x.xyz), cross(row_x.xyz, row_y.xyz));
  out.normal = normal * cofactors;
  out.uv = uv;
  out.color = color.rgb;
  let p = out.point;
  let xyw = vec3<f32>(dot(draw.gradients[0].xyz, p), dot(draw.gradients[1].xyz, p), dot(draw.gradients[2].xyz, p));
  let row = xyw.y - f32(draw.size.z) * xyw.z;
  let clip = vec2<f32>(2.0 * xyw.x / f32(draw.size.x) - xyw.z, xyw.z - 2.0 * row / f32(draw.size.y));
  // Depth is the near distance divided by the distance along the axis, as for splats.
  out.place = vec4<f32>(clip, draw.nearest, xyw.z);
  return out;
}

// Vertex normal, or face normal if the vertex normal has length 0, on the side of the face that the viewer sees.
fn shading_normal(corner: Corner, face_normal: vec3<f32>) -> vec3<f32> {
  let toward = -normalize(corner.point);
  let face_length = length(face_normal);
  var face = select(toward, face_normal / face_length, face_length > 0.0);
  face = select(face, -face, dot(face, toward) < 0.0);
  let vertex_length = length(corner.normal);
  if vertex_length == 0.0 {
    return face;
  }
  let n = corner.normal / vertex_length;
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
fn shade(corner: Corner) -> @location(0) vec4<f32> {
  let normal = shading_normal(corner, cross(dpdx(corner.point), dpdy(corner.point)));
  let right = dpdx(corner.uv);
  let down = dpdy(corner.uv);
  let texel = textureSampleLevel(image, image_sampler, corner.uv, level_of(image, right, down));
  let light = textureSampleLevel(glow, glow_sampler, corner.uv, level_of(glow, right, down)).rgb;
  let alpha = mesh.base.a * textureSampleLevel(image, image_sampler, corner.uv, 0.0).a;
  if alpha < mesh.offset.w {
    discard;
  }
  let albedo = mesh.base.rgb * corner.color * texel.rgb;
  return vec4<f32>(albedo * mix(irradiance(normal), vec3<f32>(1.0), mesh.emission.w) + mesh.emission.rgb * light, 1.0);
}
`;

/** Shader that computes a mipmap level: averages four texels of the finer level. */
export const LEVEL = /* wgsl */ `
@group(0) @binding(0) var finer: texture_2d<f32>;
@group(0) @binding(1) var smooth_texels: sampler;

struct Corner {
  @builtin(position) place: vec4<f32>,
  @location(0) uv: vec2<f32>,
}

@vertex
fn cover_picture(@builtin(vertex_index) n: u32) -> Corner {
  let at = vec2<f32>(f32(n & 1u) * 2.0, f32(n >> 1u) * 2.0);
  return Corner(vec4<f32>(at.x * 2.0 - 1.0, 1.0 - at.y * 2.0, 0.0, 1.0), at);
}

@fragment
fn level(corner: Corner) -> @location(0) vec4<f32> {
  return textureSampleLevel(finer, smooth_texels, corner.uv, 0.0);
}
`;
