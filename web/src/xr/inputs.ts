/** The hands in a frame: where they point, their sticks, and their joints where they are tracked. */
import type { Vector } from '../control/vector';
import type { Stick } from './steer';
import type { Ray } from './teleport';

declare global {
  interface XRFrame {
    // Of the WebXR Hand Input Module.
    fillPoses?(spaces: Iterable<XRSpace>, base: XRSpace, transforms: Float32Array): boolean;
    fillJointRadii?(spaces: Iterable<XRJointSpace>, radii: Float32Array): boolean;
  }
}

export interface Input {
  readonly source: XRInputSource;
  /** Along which the hand points, in the headset's space; null where it is not tracked. */
  readonly ray: Ray | null;
  /** Matrix (columns) of a controller in the hand. */
  readonly grip: Float32Array | null;
  readonly stick: Stick | null;
  readonly joints: Joints | null;
}

/** Joints of a hand: a matrix of 16 numbers each (columns), and their radii in metres. */
export interface Joints {
  readonly matrices: Float32Array;
  readonly radii: Float32Array;
}

/** Numbers of the axes and buttons of a stick in the layout `xr-standard`. */
const [ACROSS, DOWN, PRESSED] = [2, 3, 3] as const;
const MATRIX = 16;

export function readInputs(frame: XRFrame, space: XRReferenceSpace): Input[] {
  const { session } = frame;
  // A menu of the system lies over the picture, and has the hands.
  if (session.visibilityState !== 'visible') return [];
  return [...session.inputSources]
    .filter(({ targetRayMode }) => targetRayMode === 'tracked-pointer' || targetRayMode === 'transient-pointer')
    .map((source) => {
      const { targetRaySpace, gripSpace, hand, gamepad } = source;
      const ray = frame.getPose(targetRaySpace, space);
      const grip = gripSpace && !hand ? frame.getPose(gripSpace, space) : undefined;
      return {
        source,
        ray: ray ? rayOf(ray.transform.matrix) : null,
        grip: grip ? grip.transform.matrix : null,
        stick: gamepad ? stickOf(gamepad) : null,
        joints: hand ? jointsOf(hand, frame, space) : null,
      };
    });
}

/** Controllers point along −z. */
function rayOf(matrix: Float32Array): Ray {
  const at = (index: number): number => matrix[index] ?? 0;
  const [x, y, z]: Vector = [-at(8), -at(9), -at(10)];
  const size = Math.hypot(x, y, z) || 1;
  return { origin: [at(12), at(13), at(14)], direction: [x / size, y / size, z / size] };
}

function stickOf({ axes, buttons, mapping }: Gamepad): Stick | null {
  if (mapping !== 'xr-standard' || axes.length <= DOWN) return null;
  return { x: axes[ACROSS] ?? 0, y: axes[DOWN] ?? 0, isPressed: buttons[PRESSED]?.pressed ?? false };
}

function jointsOf(hand: XRHand, frame: XRFrame, space: XRReferenceSpace): Joints | null {
  const spaces = [...hand.values()];
  const [matrices, radii] = [new Float32Array(MATRIX * spaces.length), new Float32Array(spaces.length)];
  const isTracked = frame.fillPoses?.(spaces, space, matrices) && frame.fillJointRadii?.(spaces, radii);
  return isTracked ? { matrices, radii } : null;
}
