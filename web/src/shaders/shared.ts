/** Shared GLSL of near geometry and the map. All positions are relative to the centre O in metres, y up. */
import { MORPH } from './morph';

export const PRECISION = /* glsl */ `
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`;

/** Uniforms of the morph, whose functions are in `morph.ts`. */
const SHOWN = /* glsl */ `
// The eye, from the centre: each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a strength below 0 stands for no morph at all.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`;

export const SHARED = PRECISION + MORPH + SHOWN;

/** Computes the shown position of a point relative to the eye in a vertex shader. */
export const SHOWN_AT = /* glsl */ `
vec3 displayed(vec3 p) {
  vec3 from_user = p - cameraPosition;
  float rho = length(p.xz);
  if (!is_morphed() || (radii.w == 1.0 && rho <= radii.x)) {
    return from_user;
  }
  float w = radii.w * user_weight(rho, radii.y, radii.z);
  vec4 to = blended(from_user, p, w);
  return to.w * to.xyz;
}
`;
