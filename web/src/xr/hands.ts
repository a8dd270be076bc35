/** Rays of a headset's hands in world space, with pointing by grip or gesture. */
import { type Floor, worldOf } from '../control/floor';
import type { Vector } from '../control/pose';
import type { Input, Joints } from './inputs';

export interface HandRay {
  readonly side: 'left' | 'right';
  /** Origin in world space; the direction is a unit vector. */
  readonly origin: Vector;
  readonly direction: Vector;
  /** Whether the grip is squeezed, or only the index finger is straight. */
  readonly isPointing: boolean;
}

/** Creates a function that returns the tracked hands above a floor, until the signal aborts. */
export function createHands(session: XRSession, signal: AbortSignal) {
  const squeezed = new Set<XRInputSource>();
  let gesturing = new Set<XRInputSource>();
  session.addEventListener('squeezestart', ({ inputSource }) => squeezed.add(inputSource), { signal });
  session.addEventListener('squeezeend', ({ inputSource }) => squeezed.delete(inputSource), { signal });

  return (inputs: readonly Input[], floor: Floor): HandRay[] => {
    const turn = { position: [0, 0, 0], yaw: floor.yaw } as const;
    const pointing = inputs.filter(({ source, joints }) => isPointing(joints, gesturing.has(source)));
    gesturing = new Set(pointing.map(({ source }) => source));
    return inputs.flatMap(({ source, ray }) => {
      const { handedness: side } = source;
      if (!ray || side === 'none') return [];
      const [origin, direction] = [worldOf(floor, ray.origin), worldOf(turn, ray.direction)];
      return [{ side, origin, direction, isPointing: squeezed.has(source) || gesturing.has(source) }];
    });
  };
}

/** Index of the first joint of each finger but the thumb, in the order of WebXR. */
const [INDEX_FINGER, OTHER_FINGERS] = [6, [11, 16, 21]] as const;
const [BONES, MATRIX] = [3, 16] as const;
/** Thresholds of straightness to begin and to continue pointing (hysteresis). */
const BEGIN_THRESHOLDS = { straight: 0.9, bent: 0.75 } as const;
const CONTINUE_THRESHOLDS = { straight: 0.8, bent: 0.85 } as const;

/** Whether a hand points, given its previous state; false without tracked joints. */
export function isPointing(joints: Joints | null, wasPointing: boolean): boolean {
  if (!joints) return false;
  const { straight, bent } = wasPointing ? CONTINUE_THRESHOLDS : BEGIN_THRESHOLDS;
  return straightness(joints, INDEX_FINGER) > straight && OTHER_FINGERS.every((finger) => straightness(joints, finger) < bent);
}

/** Straightness of a finger: distance from knuckle to tip divided by the length of the bones; 1 if straight. */
function straightness({ matrices }: Joints, knuckle: number): number {
  const between = (a: number, b: number): number => {
    const along = (axis: number): number => (matrices[MATRIX * a + axis] ?? 0) - (matrices[MATRIX * b + axis] ?? 0);
    return Math.hypot(along(12), along(13), along(14));
  };
  let bones = 0;
  for (let joint = knuckle; joint < knuckle + BONES; joint++) bones += between(joint, joint + 1);
  return bones > 0 ? between(knuckle, knuckle + BONES) / bones : 0;
}
