/** How far a ray goes until something that is drawn stops it. */
import { PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';
import type { Vector } from '../control/vector';
import type { Picker } from './pick';

/** Field of view of the one pixel, degrees; metres at which rays begin and end. */
const [ANGLE, NEAR, FAR] = [0.5, 0.05, 30_000] as const;

/** Metres along a ray, in the frame that `draw` draws in for a camera; null where nothing is drawn. */
export function along(
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
