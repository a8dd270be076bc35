/** Distance along a ray to the first hit of what is drawn. */
import { PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';
import type { Vector } from '../control/vector';
import type { Picker } from './pick';

/** Field of view of the single pixel, degrees; least and greatest distance, metres. */
const [ANGLE, NEAR, FAR] = [0.5, 0.05, 30_000] as const;

/** Returns the distance along a ray in metres, in the frame of `draw`; null without a hit. */
export function castRay(
  renderer: WebGLRenderer,
  picker: Picker,
  origin: Vector,
  direction: Vector,
  draw: (eye: PerspectiveCamera) => void,
): number | null {
  const eye = new PerspectiveCamera(ANGLE, 1, NEAR, FAR);
  eye.position.set(...origin);
  eye.lookAt(new Vector3(...origin).add(new Vector3(...direction)));
  eye.updateMatrixWorld(true);
  // In a headset three.js would draw for its eyes.
  const { enabled } = renderer.xr;
  renderer.xr.enabled = false;
  try {
    return picker.pick(eye, [0.5, 0.5], () => draw(eye))?.distanceTo(eye.position) ?? null;
  } finally {
    renderer.xr.enabled = enabled;
  }
}
