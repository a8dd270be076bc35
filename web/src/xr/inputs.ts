/** What a headset's hands do in a frame: their rays and joints, and the sticks that walk and turn. */
import { applyDeadZone, type Drive, NO_MOTION } from '../control/drive';
import { unit, type Vector } from '../control/pose';

declare global {
  interface XRFrame {
    // These methods are part of the WebXR Hand Input Module.
    fillPoses?(spaces: Iterable<XRSpace>, base: XRSpace, transforms: Float32Array): boolean;
    fillJointRadii?(spaces: Iterable<XRJointSpace>, radii: Float32Array): boolean;
  }
}

export interface Ray {
  readonly origin: Vector;
  /** Unit vector. */
  readonly direction: Vector;
}

export interface Input {
  readonly source: XRInputSource;
  /** Ray in which the hand points, in the headset's space; null without tracking. */
  readonly ray: Ray | null;
  /** Matrix of the controller in the hand, by columns; null without a controller. */
  readonly grip: Float32Array | null;
  readonly stick: Stick | null;
  readonly joints: Joints | null;
}

/** Joints of a hand: a matrix of 16 numbers for each, by columns, and the radii in metres. */
export type Joints = Readonly<Record<'matrices' | 'radii', Float32Array>>;

/** Indices of the stick's axes and of its button in the layout `xr-standard`. */
const [ACROSS, DOWN, PRESSED] = [2, 3, 3] as const;
const MATRIX = 16;

export function readInputs(frame: XRFrame, space: XRReferenceSpace): Input[] {
  const { session } = frame;
  // While a menu of the system covers the picture, the input belongs to the menu.
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

/** Returns the ray of a controller, which points along −z. */
function rayOf(matrix: Float32Array): Ray {
  const at = (index: number): number => matrix[index] ?? 0;
  return { origin: [at(12), at(13), at(14)], direction: unit([-at(8), -at(9), -at(10)]) };
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

/** Position of a stick, to the right and down, each from −1 to 1, and whether the stick is pressed. */
export interface Stick {
  readonly x: number;
  readonly y: number;
  readonly isPressed: boolean;
}

/** Angle by which a stick turns the user at once, radians: smooth turns cause sickness. */
export const SNAP = Math.PI / 6;
const DEAD_ZONE = 0.18;
/** A stick beyond `TRIGGER` turns the user once; the next turn needs a stick below `REARM` before. */
const [TRIGGER, REARM] = [0.7, 0.35] as const;

export type Steering = ReturnType<typeof createSteering>;

/**
 * Creates a function that steers by the sticks of both hands. It returns how the user walks, relative to the direction
 * of the head, and by how many radians the user turns left at once. A single stick walks and turns.
 */
export function createSteering() {
  let isArmed = true;

  function turnOnce(x: number): number {
    if (Math.abs(x) < REARM) isArmed = true;
    if (!isArmed || Math.abs(x) < TRIGGER) return 0;
    isArmed = false;
    return -Math.sign(x) * SNAP;
  }

  return (left: Stick | null, right: Stick | null): { readonly drive: Drive; readonly turn: number } => {
    const [walkStick, turnStick] = [left ?? right, right ?? left];
    const turn = turnOnce(turnStick?.x ?? 0);
    if (!walkStick) return { drive: NO_MOTION, turn };
    // A single stick walks only ahead and back, because it turns to the sides.
    const [x, y] = applyDeadZone(walkStick === turnStick ? 0 : walkStick.x, walkStick.y, DEAD_ZONE);
    return { drive: { ...NO_MOTION, right: x, ahead: 0 - y, isRunning: walkStick.isPressed }, turn };
  };
}
