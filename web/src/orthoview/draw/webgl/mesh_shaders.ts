/** GLSL of the geometry of near leaves. */
import { IRRADIANCE, LEVEL_OF, SHADING_NORMAL } from '../../../shaders/light';
import { HEAD } from './shaders';

export const MESH_VERTEX = /* glsl */ `${HEAD}
layout(location = 0) in vec3 position;
// Zero for flat shading.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
// Rows of the matrix to metres from the leaf's origin, which lies at an offset from the eye.
layout(location = 4) in vec4 row_x;
layout(location = 5) in vec4 row_y;
layout(location = 6) in vec4 row_z;
uniform vec3 offset;
// The camera's gradients of X, Y and W.
uniform vec3 gradients[3];
uniform vec2 screen;
// Near distance in metres: depths are this divided by the distance along the axis.
uniform float nearest;
out vec3 v_point;
out vec3 v_normal;
out vec2 v_uv;
out vec3 v_color;

void main() {
  vec4 at = vec4(position, 1.0);
  v_point = vec3(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + offset;
  // Normals are transformed by the cofactor matrix, for any scale and handedness.
  vec3 x = cross(row_y.xyz, row_z.xyz);
  vec3 y = cross(row_z.xyz, row_x.xyz);
  vec3 z = cross(row_x.xyz, row_y.xyz);
  v_normal = vec3(dot(x, normal), dot(y, normal), dot(z, normal));
  v_uv = uv;
  v_color = color.rgb;
  vec3 shown = vec3(dot(gradients[0], v_point), dot(gradients[1], v_point), dot(gradients[2], v_point));
  vec2 place = 2.0 * shown.xy / screen - shown.z;
  gl_Position = vec4(place.x, -place.y, shown.z - 2.0 * nearest, shown.z);
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
  if (base.a * textureLod(image, v_uv, 0.0).a < cutoff) {
    discard;
  }
  vec3 albedo = base.rgb * v_color * texel.rgb;
  shade = vec4(albedo * mix(irradiance(normal), vec3(1.0), unlit) + emission * light, 1.0);
  // Same as for splats: the near distance divided by the distance along the axis.
  gl_FragDepth = nearest * gl_FragCoord.w;
}
`;
