/** Shaders of the map, which fills pixels without near geometry. */
import { SRGB } from './light';
import { PRECISION } from './shared';

export const FAR_VERTEX = /* glsl */ `
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
out vec3 v_direction;

void main() {
  // On the far plane, where the depth is still that of an empty picture.
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
