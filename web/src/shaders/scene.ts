/** Shaders of near geometry and of the map. Positions are in metres from the centre O, with y up. */
import { IRRADIANCE, LEVEL_OF, SHADING_NORMAL, SRGB } from './light';
import { MORPH } from './morph';

const PRECISION = /* glsl */ `
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`;

/** Uniforms of the morph, whose functions are in `morph.ts`. */
const SHOWN = /* glsl */ `
// Position of the eye relative to the centre; each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a negative strength disables the morph.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`;

export const SHARED = PRECISION + MORPH + SHOWN;

/** Function of a vertex shader: returns where the morph shows a point, relative to the eye. */
export const SHOWN_AT = /* glsl */ `
vec3 displayed(vec3 p) {
  vec3 from_user = p - cameraPosition;
  float rho = length(p.xz);
  if (!is_morphed() || (radii.w == 1.0 && rho <= radii.x)) return from_user;
  float w = radii.w * user_weight(rho, radii.y, radii.z);
  vec4 to = blended(from_user, p, w);
  return to.w * to.xyz;
}
`;

/** Defines MAPPED if vertices have texture coordinates. */
const MAPPED = /* glsl */ `
#if defined(TEXTURED) || defined(GLOWING)
#define MAPPED
#endif
`;

export const NEAR_VERTEX = /* glsl */ `
${SHARED}
${MAPPED}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
#ifdef SMOOTH
in vec3 normal;
out vec3 v_normal;
#endif
#ifdef MAPPED
in vec2 uv;
out vec2 v_uv;
#endif
#ifdef COLORED
in vec4 color;
out vec3 v_color;
#endif
#ifdef PLACED
// Rows of the matrix from the mesh to metres from the centre.
in vec4 row_x;
in vec4 row_y;
in vec4 row_z;
#else
uniform mat4 placement;
#endif
// Position relative to the centre, and shown position relative to the eye. With the directions and the distance of the
// blend, which all morphs use, flat surfaces beyond R stay flat, even if their triangles are large.
out vec3 v_point;
out vec3 v_shown;

${SHOWN_AT}
void main() {
#ifdef PLACED
  mat4 placement = transpose(mat4(row_x, row_y, row_z, vec4(0.0, 0.0, 0.0, 1.0)));
#endif
  v_point = (placement * vec4(position, 1.0)).xyz;
  v_shown = displayed(v_point);
#ifdef SMOOTH
  // The cofactor matrix transforms normals correctly for any scale, and for reflections.
  mat3 m = mat3(placement);
  v_normal = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * normal;
#endif
#ifdef MAPPED
  v_uv = uv;
#endif
#ifdef COLORED
  v_color = color.rgb;
#endif
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;

export const NEAR_FRAGMENT = /* glsl */ `
${SHARED}
${SRGB}
${MAPPED}
uniform vec4 base_color;
// Opacity of this picture over the previous one.
uniform float opacity;
#ifdef TEXTURED
uniform sampler2D image;
#endif
#if defined(EMISSIVE) || defined(GLOWING)
uniform vec3 emission;
#endif
#ifdef GLOWING
uniform sampler2D glow;
#endif
#ifdef CUTOUT
uniform float cutoff;
#endif
#ifdef SMOOTH
in vec3 v_normal;
#endif
#ifdef MAPPED
in vec2 v_uv;
#endif
#ifdef COLORED
in vec3 v_color;
#endif
in vec3 v_point;
in vec3 v_shown;
out vec4 shade;

// Range codes; least range, step between codes, texels along an edge of a face, and 1 if the map has ranges.
uniform usamplerCube codes;
uniform vec4 coding;
const uint NO_SURFACE = 65535u;
// A fragment is hidden only if it is behind the map by more than this share of the map's range.
const float BIAS = 4e-3;

// Returns the greatest range of the four texels around a direction.
float farthest_range(vec3 d) {
  vec3 size = abs(d);
  float longest = max(size.x, max(size.y, size.z));
  vec3 at = d / longest;
  float half_texel = 1.0 / coding.z;
  bool is_z = size.z == longest;
  vec3 right = size.x == longest && !is_z ? vec3(0.0, half_texel, 0.0) : vec3(half_texel, 0.0, 0.0);
  vec3 down = is_z ? vec3(0.0, half_texel, 0.0) : vec3(0.0, 0.0, half_texel);
  uint code = max(
    max(texture(codes, at - right - down).r, texture(codes, at + right - down).r),
    max(texture(codes, at - right + down).r, texture(codes, at + right + down).r));
  return code == NO_SURFACE ? 1e38 : coding.x * exp(float(code) * coding.y);
}

// Radius beyond which static geometry is not drawn, and the map appears.
uniform float cut;

bool is_hidden() {
  if (length(v_point.xz) > cut) return true;
  if (coding.w == 0.0 || length(v_point.xz) <= radii.y) return false;
  // Beyond R, the morph shows points in the direction in which the centre sees them, like the map with its ranges.
  float range = length(is_morphed() ? v_point : v_shown);
  return range > farthest_range(normalize(v_shown)) * (1.0 + BIAS);
}

${IRRADIANCE}
${SHADING_NORMAL}
${LEVEL_OF}
void main() {
#ifdef TEXTURED
  float level = level_of(textureSize(image, 0), dFdx(v_uv), dFdy(v_uv));
#endif
#ifdef GLOWING
  float glow_level = level_of(textureSize(glow, 0), dFdx(v_uv), dFdy(v_uv));
#endif
#ifndef UNLIT
  vec3 vertex_normal = vec3(0.0);
#ifdef SMOOTH
  vertex_normal = v_normal;
#endif
  vec3 normal = shading_normal(cross(dFdx(v_point), dFdy(v_point)), -normalize(v_shown), vertex_normal);
#endif
  if (is_hidden()) discard;
  vec3 albedo = base_color.rgb;
#ifdef COLORED
  albedo *= v_color;
#endif
#ifdef TEXTURED
  albedo *= textureLod(image, v_uv, level).rgb;
#endif
#ifdef CUTOUT
  float alpha = base_color.a;
#ifdef TEXTURED
  alpha *= textureLod(image, v_uv, 0.0).a;
#endif
  if (alpha < cutoff) discard;
#endif
  vec3 color = albedo;
#ifndef UNLIT
  color *= irradiance(normal);
#endif
#ifdef EMISSIVE
  color += emission;
#endif
#ifdef GLOWING
  color += emission * textureLod(glow, v_uv, glow_level).rgb;
#endif
  shade = vec4(srgb_of(color), opacity);
}
`;

export const FAR_VERTEX = /* glsl */ `
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
out vec3 v_direction;

void main() {
  // On the far plane, the map passes the depth test only where nothing else is drawn.
  gl_Position = vec4(position.xy, 1.0, 1.0);
  vec4 place = inverse(projectionMatrix) * vec4(position.xy, 1.0, 1.0);
  v_direction = transpose(mat3(viewMatrix)) * (place.xyz / place.w);
}
`;

export const FAR_FRAGMENT = /* glsl */ `
${PRECISION}
${SRGB}
uniform samplerCube map;
uniform float opacity;
in vec3 v_direction;
out vec4 shade;

void main() {
  shade = vec4(srgb_of(textureLod(map, v_direction, 0.0).rgb), opacity);
}
`;
