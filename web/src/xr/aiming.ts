/** Aiming of a jump: hold the trigger or the pinch, and let it go. */
import type { Vector } from '../control/vector';
import type { Input } from './inputs';
import type { Aim } from './look';
import { arc, landing } from './teleport';

export interface Aiming {
  /** Where the hand that aims points; the nearest place that is `allowed` is the target. Points are the headset's. */
  update(inputs: readonly Input[], allowed: (wanted: Vector) => Vector): Aim | null;
  dispose(): void;
}

/** Metres between where somebody aims and the target that are not told apart. */
const SAME = 0.01;

/** Listen to a session; `jump` is told of the target when the hand lets go. */
export function createAiming(session: XRSession, jump: (target: Vector) => void): Aiming {
  const stop = new AbortController();
  let holding: XRInputSource | null = null;
  let aim: Aim | null = null;

  // The hand that pressed last aims; the other one's press is dropped.
  session.addEventListener('selectstart', ({ inputSource }) => (holding = inputSource), { signal: stop.signal });
  session.addEventListener('selectend', ({ inputSource }) => {
    if (inputSource !== holding) return;
    const target = aim?.target;
    drop();
    if (target) jump(target);
  }, { signal: stop.signal });

  function drop(): void {
    holding = null;
    aim = null;
  }

  return {
    update(inputs, allowed) {
      if (!holding) return null;
      const ray = inputs.find(({ source }) => source === holding)?.ray;
      if (!ray) {
        // A hand that is out of sight aims nowhere; it may come back.
        aim = null;
        return null;
      }
      const wanted = landing(ray);
      const target = allowed(wanted);
      const isHeld = Math.hypot(target[0] - wanted[0], target[2] - wanted[2]) > SAME;
      aim = { arc: arc(ray, target), target, isHeld };
      return aim;
    },
    dispose: () => stop.abort(),
  };
}
