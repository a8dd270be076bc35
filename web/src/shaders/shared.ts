/** GLSL that the shaders of near geometry and of the map share. All positions are metres from the centre O, y up. */
import { MORPH } from './morph';

export const PRECISION = /* glsl */ `
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`;

/** Where the user is shown what, by the functions of `morph.ts`. */
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

/** Where a vertex shader shows a point, from the eye. */
export const SHOWN_AT = /* glsl */ `
vec3 shown(vec3 p) {
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
