/** GLSL and WGSL functions of light and colour that the pages of scenes and of orthoviews share. */

/** Constants of docs/render.md for the light and the sky. */
const CONSTANTS = {
  SUN_DIRECTION: [0.5263158, 0.7894737, 0.3157895],
  SUN: [0.6, 0.56, 0.5],
  SKY_DIRECTION: [-0.2062843, 0.9282791, 0.3094264],
  SKY_LOW: [0.13, 0.135, 0.15],
  SKY_HIGH: [0.38, 0.42, 0.48],
  HORIZON: [0.66, 0.74, 0.82],
  ZENITH: [0.16, 0.34, 0.66],
  NADIR: [0.24, 0.25, 0.26],
} as const;

type Name = keyof typeof CONSTANTS;

const LIGHT_NAMES = ['SUN_DIRECTION', 'SUN', 'SKY_DIRECTION', 'SKY_LOW', 'SKY_HIGH'] as const;
const SKY_NAMES = ['HORIZON', 'ZENITH', 'NADIR'] as const;

/** Returns a number as a literal that is valid in both languages. */
export const float = (value: number): string => (Number.isInteger(value) ? value.toFixed(1) : String(value));

const vector = (name: Name): string => CONSTANTS[name].map(float).join(', ');
const glsl = (names: readonly Name[]): string =>
  names.map((name) => `const vec3 ${name} = vec3(${vector(name)});`).join('\n');
const wgsl = (names: readonly Name[]): string =>
  names.map((name) => `const ${name} = vec3<f32>(${vector(name)});`).join('\n');

/** Light that reaches a surface with a normal. */
export const IRRADIANCE = /* glsl */ `
${glsl(LIGHT_NAMES)}

vec3 irradiance(vec3 n) {
  float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`;

/**
 * Normal for shading: the interpolated normal of the vertices, or the normal of the face if that has length 0. It
 * points to the side of the face that the viewer sees; `toward` points to the viewer.
 */
export const SHADING_NORMAL = /* glsl */ `
vec3 shading_normal(vec3 face_normal, vec3 toward, vec3 vertex_normal) {
  float face_length = length(face_normal);
  vec3 face = face_length > 0.0 ? face_normal / face_length : toward;
  face = dot(face, toward) < 0.0 ? -face : face;
  float vertex_length = length(vertex_normal);
  if (vertex_length == 0.0) return face;
  vec3 n = vertex_normal / vertex_length;
  return dot(n, face) < 0.0 ? -n : n;
}
`;

/**
 * Mipmap level at which a texel has the same area as a pixel. `right` and `down` are the changes of the texture
 * coordinates from one pixel to the next.
 */
export const LEVEL_OF = /* glsl */ `
float level_of(ivec2 size, vec2 right, vec2 down) {
  vec2 dx = right * vec2(size);
  vec2 dy = down * vec2(size);
  return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}
`;

/** Sky colour in a direction in which there is no surface. */
export const BACKGROUND = /* glsl */ `
${glsl(SKY_NAMES)}

vec3 background(vec3 direction) {
  return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`;

/** Encodes linear colours as sRGB. */
export const SRGB = /* glsl */ `
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`;

/** Decodes sRGB colours to linear ones. */
export const LINEAR = /* glsl */ `
vec3 linear_of(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));
}
`;

/** WGSL versions of all functions above. */
export const LIGHT_WGSL = /* wgsl */ `
${wgsl([...LIGHT_NAMES, ...SKY_NAMES])}

fn irradiance(n: vec3<f32>) -> vec3<f32> {
  let sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}

fn background(direction: vec3<f32>) -> vec3<f32> {
  return mix(HORIZON, select(ZENITH, NADIR, direction.y < 0.0), sqrt(abs(direction.y)));
}

fn srgb_of(linear: vec3<f32>) -> vec3<f32> {
  let c = clamp(linear, vec3<f32>(0.0), vec3<f32>(1.0));
  return select(1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * c, c <= vec3<f32>(0.0031308));
}

fn linear_of(c: vec3<f32>) -> vec3<f32> {
  return select(pow((c + 0.055) / 1.055, vec3<f32>(2.4)), c / 12.92, c <= vec3<f32>(0.04045));
}
`;
