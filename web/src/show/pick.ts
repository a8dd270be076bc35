/** Finds the point of near geometry at a pixel, or along a ray. */
import {
  DepthTexture,
  GLSL3,
  NoBlending,
  PerspectiveCamera,
  RawShaderMaterial,
  Scene,
  UnsignedIntType,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { Vector } from '../control/pose';
import { FAR_PLANE, NEAR_PLANE } from './composer';
import { SCREEN_VERTEX, screenMesh } from './painter';

/** WebGL cannot read depths: the shader writes the depth into three bytes of a colour. */
const FRAGMENT = /* glsl */ `
precision highp float;
precision highp sampler2D;
uniform sampler2D depth;
out vec4 digits;

void main() {
  float value = texelFetch(depth, ivec2(0), 0).r;
  vec3 scaled = fract(value * vec3(1.0, 255.0, 65025.0));
  digits = vec4(scaled - vec3(scaled.yz / 255.0, 0.0), value < 1.0 ? 1.0 : 0.0);
}
`;

export type Picker = ReturnType<typeof createPicker>;

/** Creates a picker, which keeps its shader program for all picks. */
export function createPicker(renderer: WebGLRenderer) {
  const depth = new DepthTexture(1, 1, UnsignedIntType);
  const target = new WebGLRenderTarget(1, 1, { depthTexture: depth });
  const result = new WebGLRenderTarget(1, 1);
  const material = new RawShaderMaterial({
    vertexShader: SCREEN_VERTEX,
    fragmentShader: FRAGMENT,
    glslVersion: GLSL3,
    blending: NoBlending,
    depthTest: false,
    uniforms: { depth: { value: depth } },
  });
  const mesh = screenMesh(material);
  const scene = new Scene().add(mesh);
  const digits = new Uint8Array(4);

  return {
    /**
     * Returns the point at a pixel of the camera's picture, which `draw` draws, in the coordinates of that picture. x
     * and y are shares of the picture's width and height, from the upper left. Returns null if nothing is drawn there.
     */
    pick(camera: PerspectiveCamera, [x, y]: readonly [number, number], draw: () => void): Vector3 | null {
      const before = renderer.getRenderTarget();
      const { width, height } = renderer.domElement;
      camera.setViewOffset(width, height, Math.floor(x * width), Math.floor(y * height), 1, 1);
      try {
        renderer.setRenderTarget(target);
        draw();
        renderer.setRenderTarget(result);
        renderer.render(scene, camera);
        renderer.readRenderTargetPixels(result, 0, 0, 1, 1, digits);
        if (digits[3] === 0) return null;
        const value = ((digits[2] ?? 0) / 65025 + (digits[1] ?? 0) / 255 + (digits[0] ?? 0)) / 255;
        return new Vector3(0, 0, 2 * value - 1).unproject(camera);
      } finally {
        camera.clearViewOffset();
        renderer.setRenderTarget(before);
      }
    },
    /** Frees the GPU resources; three.js creates them again for a later pick. */
    dispose(): void {
      for (const resource of [mesh.geometry, material, depth, target, result]) resource.dispose();
    },
  };
}

/** Field of view of the only pixel, degrees. */
const PIXEL_ANGLE = 0.5;

/** Returns the distance in metres to the first surface that `draw` draws along a ray; null without a surface. */
export function castRay(
  renderer: WebGLRenderer,
  picker: Picker,
  origin: Vector,
  direction: Vector,
  draw: (eye: PerspectiveCamera) => void,
): number | null {
  const eye = new PerspectiveCamera(PIXEL_ANGLE, 1, NEAR_PLANE, FAR_PLANE);
  eye.position.set(...origin);
  eye.lookAt(new Vector3(...origin).add(new Vector3(...direction)));
  eye.updateMatrixWorld(true);
  // In a headset, three.js would draw from the user's eyes instead.
  const { enabled } = renderer.xr;
  renderer.xr.enabled = false;
  try {
    return picker.pick(eye, [0.5, 0.5], () => draw(eye))?.distanceTo(eye.position) ?? null;
  } finally {
    renderer.xr.enabled = enabled;
  }
}
