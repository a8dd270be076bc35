/** Dark veil over the whole picture, for each eye: it covers jumps. */
import {
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  GLSL3,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
} from 'three';

const VERTEX = /* glsl */ `
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision mediump float;
uniform float darkness;
out vec4 shade;

void main() {
  shade = vec4(0.0, 0.0, 0.0, darkness);
}
`;

export interface Veil {
  readonly mesh: Mesh;
  /** Sets the darkness: 0 for none, 1 for black. */
  set(darkness: number): void;
}

export function createVeil(): Veil {
  const darkness = { value: 0 };
  const material = new RawShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    glslVersion: GLSL3,
    uniforms: { darkness },
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    depthTest: false,
    depthWrite: false,
    transparent: true,
  });
  const mesh = new Mesh(covering(), material);
  mesh.frustumCulled = false;
  mesh.visible = false;
  return {
    mesh,
    set(value) {
      darkness.value = value;
      mesh.visible = value > 0;
    },
  };
}

/** Triangle that covers the whole picture. */
export function covering(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  return geometry;
}
