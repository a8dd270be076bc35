/** GLSL of splats, of the picture's samples, and of the geometry of near leaves. */
import { BACKGROUND, float, IRRADIANCE, LEVEL_OF, LINEAR, SHADING_NORMAL, SRGB } from '../../../shaders/light';
import { BORDER_FACTOR, MIN_COSINE, SQUARED_RADIUS, VECTORS_PER_VIEW } from '../projection';

const HEAD = /* glsl */ `#version 300 es
precision highp float;
precision highp int;
`;

/**
 * A splat is drawn as a point primitive: a square around its ellipse. Its flat outputs are the inverse of the ellipse's
 * axes, its middle, and its nearness 1/W with the changes per column and row.
 */
export const SPLAT_VERTEX = /* glsl */ `${HEAD}
layout(location = 0) in uvec3 splat;
uniform vec4 view[${VECTORS_PER_VIEW}];
// Gradients of X, Y and W; ray through the picture's corner, and its changes by a sample to the right and down.
uniform vec3 gradients[3];
uniform vec3 rays[3];
// Width and height of the picture in samples, and the greatest size of a point.
uniform vec3 screen;
flat out vec4 v_inverse;
flat out vec2 v_middle;
flat out vec3 v_nearness;
flat out vec3 v_color;
const float RADIUS = ${float(Math.sqrt(SQUARED_RADIUS))};
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
${IRRADIANCE}
${LINEAR}
// Half the extent of a ball along an axis of the picture: the length of the gradient of X/W (or Y/W).
float half_extent(vec3 gradient, float ratio, float inverse_w) {
  return length((gradient - ratio * gradients[2]) * inverse_w) * view[2].w;
}

void main() {
  float depth = float((splat.x >> 24) << 8 | splat.y >> 24) - 0.5;
  vec3 view_point = vec3(float(splat.z & 4095u) + 0.5, float(splat.z >> 12 & 4095u) + 0.5, depth);
  vec3 inside = vec3(dot(view[7].xyz, view_point), dot(view[8].xyz, view_point), dot(view[9].xyz, view_point));
  inside += vec3(view[7].w, view[8].w, view[9].w);
  vec3 xyw = view[0].xyz + view_point.x * view[1].xyz + view_point.y * view[2].xyz + view_point.z * view[3].xyz;
  float inverse_w = 1.0 / xyw.z;
  vec2 middle = xyw.xy * inverse_w;

  // Normal, and the changes u and v of (X, Y, W) per pixel of the view on the plane of the normal.
  vec2 code = vec2(float(splat.y & 4095u), float(splat.y >> 12 & 4095u)) * view[1].w - 1.0;
  vec3 normal = vec3(code, 1.0 - abs(code.x) - abs(code.y));
  float fold = max(-normal.z, 0.0);
  normal.xy -= vec2(normal.x < 0.0 ? -fold : fold, normal.y < 0.0 ? -fold : fold);
  normal = normalize(normal);
  float facing = 1.0 / max(dot(view[6].xyz, normal), ${float(MIN_COSINE)});
  vec3 u = view[1].xyz + dot(view[4].xyz, normal) * facing * view[3].xyz;
  vec3 v = view[2].xyz - dot(view[5].xyz, normal) * facing * view[3].xyz;
  bool is_surfel = (splat.z >> 24 & 1u) == 1u;
  float factor = is_surfel ? ((splat.z >> 25 & 1u) == 1u ? 1.0 : ${float(BORDER_FACTOR)}) : 0.0;

  // The ellipse's axes in the picture, and the changes of nearness along them.
  vec2 du = (u.xy - middle * u.z) * inverse_w * factor;
  vec2 dv = (v.xy - middle * v.z) * inverse_w * factor;
  vec2 slope = -vec2(u.z, v.z) * inverse_w * inverse_w * factor;
  float determinant = du.x * dv.y - dv.x * du.y;
  vec2 half_size;
  if (is_surfel) {
    // Edge-on, a surfel is a line; only the sample at its centre shows it.
    bool is_flat = abs(determinant) <= 1.2e-7 * (abs(du.x) + abs(dv.x)) * (abs(du.y) + abs(dv.y));
    vec4 change = vec4(dv.y, -dv.x, -du.y, du.x) * (is_flat ? 0.0 : 1.0 / determinant);
    v_inverse = is_flat ? vec4(1e9) : change;
    v_nearness = vec3(inverse_w, slope.x * change.x + slope.y * change.z, slope.x * change.y + slope.y * change.w);
    half_size = is_flat ? vec2(0.0) : RADIUS * sqrt(vec2(du.x * du.x + dv.x * dv.x, du.y * du.y + dv.y * dv.y));
  } else {
    vec2 ball = vec2(half_extent(gradients[0], middle.x, inverse_w), half_extent(gradients[1], middle.y, inverse_w));
    v_inverse = vec4(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
    v_nearness = vec3(inverse_w, 0.0, 0.0);
    half_size = RADIUS * ball;
  }
  v_middle = middle;

  // Normals face the viewer, because surfaces that a cell's side cuts are seen from inside.
  vec3 ray = rays[0] + middle.x * rays[1] + middle.y * rays[2];
  normal = dot(normal, ray) > 0.0 ? -normal : normal;
  vec3 albedo = linear_of(vec3(splat.x & 255u, splat.x >> 8 & 255u, splat.x >> 16 & 255u) / 255.0);
  v_color = albedo * irradiance(normal);

  // Splats near the eye are not shown: the derivatives at their middle would give huge ellipses.
  bool is_shown = xyw.z - RADIUS * factor * length(vec2(u.z, v.z)) >= view[0].w;
  is_shown = is_shown && all(greaterThanEqual(inside, vec3(0.0))) && all(lessThan(inside, vec3(1.0)));
  is_shown = is_shown && all(lessThan(abs(middle - 0.5 * screen.xy), 0.5 * screen.xy + max(half_size, 0.5)));
  // WebGL clips points whose centres lie outside, whatever their size, so such centres are moved to the picture's edge.
  vec2 start = clamp(middle, vec2(0.0), screen.xy);
  vec2 reach = half_size + abs(start - middle);
  gl_PointSize = clamp(2.0 * max(reach.x, reach.y), 1.0, screen.z);
  vec2 clip = start / screen.xy * 2.0 - 1.0;
  gl_Position = is_shown ? vec4(clip.x, -clip.y, 0.0, 1.0) : NOWHERE;
}
`;

export const SPLAT_FRAGMENT = /* glsl */ `${HEAD}
uniform vec3 screen;
// Near distance, metres. A depth value is the near distance divided by the distance along the viewing axis.
uniform float nearest;
flat in vec4 v_inverse;
flat in vec2 v_middle;
flat in vec3 v_nearness;
flat in vec3 v_color;
out vec4 shade;

void main() {
  vec2 screen_point = vec2(gl_FragCoord.x, screen.y - gl_FragCoord.y);
  vec2 p = screen_point - v_middle;
  vec2 q = vec2(dot(v_inverse.xy, p), dot(v_inverse.zw, p));
  bool is_inside = dot(q, q) <= ${float(SQUARED_RADIUS)};
  // The sample that holds a splat's middle always belongs to it.
  if (!is_inside && any(notEqual(floor(screen_point), floor(v_middle)))) discard;
  float nearness = v_nearness.x + (is_inside ? dot(v_nearness.yz, p) : 0.0);
  // Linear on a plane, so exact; greater for nearer points, so float32 stays precise far away.
  gl_FragDepth = nearest * nearness;
  shade = vec4(v_color, 1.0);
}
`;

/** Triangle that covers the picture. */
export const FULL_SCREEN_VERTEX = /* glsl */ `${HEAD}
void main() {
  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
`;

/** Mean of a pixel's samples in linear light; empty samples show the sky of docs/render.md. */
export const RESOLVE_FRAGMENT = /* glsl */ `${HEAD}
uniform sampler2D samples;
// Samples along each axis of a pixel.
uniform int grid;
uniform vec3 screen;
uniform vec3 rays[3];
out vec4 shade;
${SRGB}
${BACKGROUND}
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * grid;
  vec3 sum = vec3(0.0);
  for (int row = 0; row < grid; row++) {
    for (int column = 0; column < grid; column++) {
      ivec2 texel = first + ivec2(column, row);
      vec4 color = texelFetch(samples, texel, 0);
      vec2 screen_point = vec2(float(texel.x) + 0.5, screen.y - float(texel.y) - 0.5);
      vec3 ray = rays[0] + screen_point.x * rays[1] + screen_point.y * rays[2];
      sum += color.a > 0.0 ? color.rgb : background(normalize(ray));
    }
  }
  shade = vec4(srgb_of(sum / float(grid * grid)), 1.0);
}
`;

export const MESH_VERTEX = /* glsl */ `${HEAD}
layout(location = 0) in vec3 position;
// Zero for flat shading.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
// Rows of the matrix from the mesh to metres from the leaf's origin.
layout(location = 4) in vec4 row_x;
layout(location = 5) in vec4 row_y;
layout(location = 6) in vec4 row_z;
// Vector from the eye to that origin.
uniform vec3 offset;
// Gradients of X, Y and W.
uniform vec3 gradients[3];
uniform vec2 screen;
// Near distance, metres.
uniform float nearest;
out vec3 v_point;
out vec3 v_normal;
out vec2 v_uv;
out vec3 v_color;

void main() {
  vec4 at = vec4(position, 1.0);
  v_point = vec3(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + offset;
  // Normals are transformed by the cofactor matrix, for any scale and handedness.
  v_normal = normal * mat3(cross(row_y.xyz, row_z.xyz), cross(row_z.xyz, row_x.xyz), cross(row_x.xyz, row_y.xyz));
  v_uv = uv;
  v_color = color.rgb;
  vec3 xyw = vec3(dot(gradients[0], v_point), dot(gradients[1], v_point), dot(gradients[2], v_point));
  vec2 clip = 2.0 * xyw.xy / screen - xyw.z;
  gl_Position = vec4(clip.x, -clip.y, xyw.z - 2.0 * nearest, xyw.z);
}
`;

export const MESH_FRAGMENT = /* glsl */ `${HEAD}
uniform sampler2D image;
uniform sampler2D glow;
uniform vec4 base;
uniform vec3 emission;
// Least alpha that is drawn; negative for opaque materials.
uniform float cutoff;
uniform float unlit;
uniform float nearest;
in vec3 v_point;
in vec3 v_normal;
in vec2 v_uv;
in vec3 v_color;
out vec4 shade;
${IRRADIANCE}
${SHADING_NORMAL}
${LEVEL_OF}
void main() {
  vec3 normal = shading_normal(cross(dFdx(v_point), dFdy(v_point)), -normalize(v_point), v_normal);
  vec2 right = dFdx(v_uv);
  vec2 down = dFdy(v_uv);
  vec4 texel = textureLod(image, v_uv, level_of(textureSize(image, 0), right, down));
  vec3 light = textureLod(glow, v_uv, level_of(textureSize(glow, 0), right, down)).rgb;
  if (base.a * textureLod(image, v_uv, 0.0).a < cutoff) discard;
  vec3 albedo = base.rgb * v_color * texel.rgb;
  shade = vec4(albedo * mix(irradiance(normal), vec3(1.0), unlit) + emission * light, 1.0);
  // The depth is computed as for splats.
  gl_FragDepth = nearest * gl_FragCoord.w;
}
`;
