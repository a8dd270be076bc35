/** Rays of a headset's hands in world space, with pointing. */
import { type Floor, worldOf } from '../control/floor';
import type { Vector } from '../control/vector';
import { isPointing } from './gesture';
import type { Input } from './inputs';

export interface HandRay {
  readonly side: 'left' | 'right';
  /** Origin in world space; the direction is a unit vector. */
  readonly origin: Vector;
  readonly direction: Vector;
  /** Whether the grip is squeezed, or only the index finger is straight. */
  readonly isPointing: boolean;
}

export interface Hands {
  /** Returns the tracked hands above a floor. */
  update(inputs: readonly Input[], floor: Floor): HandRay[];
  dispose(): void;
}

export function createHands(session: XRSession): Hands {
  const stop = new AbortController();
  const squeezed = new Set<XRInputSource>();
  let gesturing = new Set<XRInputSource>();
  const { signal } = stop;
  session.addEventListener('squeezestart', ({ inputSource }) => squeezed.add(inputSource), { signal });
  session.addEventListener('squeezeend', ({ inputSource }) => squeezed.delete(inputSource), { signal });

  return {
    update(inputs, floor) {
      const turn = { position: [0, 0, 0], yaw: floor.yaw } as const;
      const found = inputs.filter(({ source, joints }) => isPointing(joints, gesturing.has(source)));
      gesturing = new Set(found.map(({ source }) => source));
      return inputs.flatMap(({ source, ray }) => {
        const { handedness: side } = source;
        if (!ray || side === 'none') return [];
        const [origin, direction] = [worldOf(floor, ray.origin), worldOf(turn, ray.direction)];
        return [{ side, origin, direction, isPointing: squeezed.has(source) || gesturing.has(source) }];
      });
    },
    dispose: () => stop.abort(),
  };
}
