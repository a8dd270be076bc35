/** The hands of a headset's user in world space: their rays, and whether they point. */
import { type Floor, worldOf } from '../control/floor';
import type { Vector } from '../control/pose';
import type { Input, Joints } from './inputs';

export interface HandRay {
  readonly side: 'left' | 'right';
  /** Position of the hand in the world, and unit vector in which it points. */
  readonly origin: Vector;
  readonly direction: Vector;
  /** Whether the user squeezes the grip of a controller, or stretches only the index finger. */
  readonly isPointing: boolean;
}

/** Creates a function that returns the tracked hands of a user on a floor. It works until the signal aborts. */
export function createHands(session: XRSession, signal: AbortSignal) {
  const squeezed = new Set<XRInputSource>();
  let pointingHands = new Set<XRInputSource>();
  session.addEventListener('squeezestart', ({ inputSource }) => squeezed.add(inputSource), { signal });
  session.addEventListener('squeezeend', ({ inputSource }) => squeezed.delete(inputSource), { signal });

  return (inputs: readonly Input[], floor: Floor): HandRay[] => {
    const turn = { position: [0, 0, 0], yaw: floor.yaw } as const;
    const pointing = inputs.filter(({ source, joints }) => isPointing(joints, pointingHands.has(source)));
    pointingHands = new Set(pointing.map(({ source }) => source));
    return inputs.flatMap(({ source, ray }) => {
      const { handedness: side } = source;
      if (!ray || side === 'none') return [];
      const [origin, direction] = [worldOf(floor, ray.origin), worldOf(turn, ray.direction)];
      return [{ side, origin, direction, isPointing: squeezed.has(source) || pointingHands.has(source) }];
    });
  };
}

/** Number of the first joint of the index finger, and of the three other fingers, in the order of WebXR. */
const [INDEX_FINGER, OTHER_FINGERS] = [6, [11, 16, 21]] as const;
const [BONES, MATRIX] = [3, 16] as const;
/** Least straightness of the index finger and greatest of the others, to begin pointing and to continue it. */
const BEGIN_THRESHOLDS = { straight: 0.9, bent: 0.75 } as const;
const CONTINUE_THRESHOLDS = { straight: 0.8, bent: 0.85 } as const;

/** Whether a hand points, if it did or did not point before; false without tracked joints. */
export function isPointing(joints: Joints | null, wasPointing: boolean): boolean {
  if (!joints) return false;
  const { straight, bent } = wasPointing ? CONTINUE_THRESHOLDS : BEGIN_THRESHOLDS;
  return straightness(joints, INDEX_FINGER) > straight && OTHER_FINGERS.every((finger) => straightness(joints, finger) < bent);
}

/** Returns the distance from the knuckle to the tip of a finger, divided by the length of its bones: 1 if straight. */
function straightness({ matrices }: Joints, knuckle: number): number {
  const between = (a: number, b: number): number => {
    const along = (axis: number): number => (matrices[MATRIX * a + axis] ?? 0) - (matrices[MATRIX * b + axis] ?? 0);
    return Math.hypot(along(12), along(13), along(14));
  };
  let bones = 0;
  for (let joint = knuckle; joint < knuckle + BONES; joint++) bones += between(joint, joint + 1);
  return bones > 0 ? between(knuckle, knuckle + BONES) / bones : 0;
}
