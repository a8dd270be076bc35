/** Vertex shaders of billboards: pointers and names. They use the fragment shader of near geometry. */
import { SHARED, SHOWN_AT } from '../shaders/scene';

/** Axes of an upright billboard that faces the viewer. */
const FACING = /* glsl */ `
mat3 facing(vec3 from_eye) {
  vec3 toward = -normalize(from_eye);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`;

/** Common header of the vertex shaders of billboards. */
export const HEAD = /* glsl */ `
${SHARED}
${SHOWN_AT}
${FACING}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`;

/** Pointer: a ribbon along the ray, morphed piece by piece, and a spot at its end. */
export const POINTER_VERTEX = /* glsl */ `
${HEAD}
// Share of the pointer's length, 2 for the spot; offsets to the side and up, in half widths.
in vec3 position;
uniform vec3 begin;
uniform vec3 end;
// Tangent of the angle that a pixel covers.
uniform float pixel;
// Least half widths: in metres; in pixels, so that there are no gaps; for the spot also as the tangent of an angle.
const vec2 RIBBON = vec2(0.003, 0.75);
const vec3 SPOT = vec3(0.02, 2.5, 0.004);
// Factor of the spot's distance, so that it is drawn in front of its surface.
const float SPOT_DISTANCE = 0.985;
// Step along the pointer from which the ribbon's direction is computed, as a share of the length.
const float DIRECTION_STEP = 0.004;

void main() {
  bool is_spot = position.x > 1.5;
  float share = min(position.x, 1.0);
  v_point = mix(begin, end, share);
  vec3 from_eye = displayed(v_point);
  float range = length(from_eye);
  if (is_spot) {
    mat3 axes = facing(from_eye);
    // The map's ranges are measured from the centre, so that the point moves relative to the centre, too.
    v_point *= SPOT_DISTANCE;
    v_shown = SPOT_DISTANCE * from_eye;
    v_shown += (axes[0] * position.y + axes[1] * position.z) * max(SPOT.x, max(SPOT.y * pixel, SPOT.z) * range);
  } else {
    vec3 side = cross(displayed(mix(begin, end, share + DIRECTION_STEP)) - from_eye, from_eye);
    side = dot(side, side) > 0.0 ? normalize(side) : vec3(0.0, 1.0, 0.0);
    v_shown = from_eye + side * position.y * max(RIBBON.x, RIBBON.y * pixel * range);
  }
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;

/** Name above a head, large enough to be read. */
export const NAME_VERTEX = /* glsl */ `
${HEAD}
in vec3 position;
in vec2 uv;
out vec2 v_uv;
uniform vec3 begin;
// Width divided by height.
uniform float ratio;
// Least height in metres, and as the tangent of an angle.
const vec2 HEIGHT = vec2(0.08, 0.032);

void main() {
  v_point = begin;
  v_uv = uv;
  vec3 from_eye = displayed(v_point);
  mat3 axes = facing(from_eye);
  v_shown = from_eye + (axes[0] * position.x * ratio + axes[1] * position.y) * max(HEIGHT.x, HEIGHT.y * length(from_eye));
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;
