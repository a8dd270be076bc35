/** Vertex shader of the ring around a sphere. It uses the fragment shader of near geometry. */
import { HEAD } from '../rooms/shaders';

export const RING_VERTEX = /* glsl */ `
${HEAD}
// Share of the way from begin to end of the part that is drawn; 0 inside, 1 outside.
in vec3 position;
uniform vec3 begin;
uniform float radius;
// Shares of a turn, clockwise from above, between which the ring is drawn.
uniform float shares[2];
// Inner and outer radius in radii of the sphere.
const vec2 RING = vec2(1.25, 1.45);

void main() {
  v_point = begin;
  vec3 at = displayed(v_point);
  mat3 axes = facing(at);
  float angle = 6.2831853 * mix(shares[0], shares[1], position.x);
  float size = radius * mix(RING.x, RING.y, position.y);
  v_shown = at + size * (sin(angle) * axes[0] + cos(angle) * axes[1]);
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;
