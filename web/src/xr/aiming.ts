/** Aiming of a jump: the trigger or pinch is held and released. */
import type { Vector } from '../control/vector';
import type { Input } from './inputs';
import type { Aim } from './look';
import { arc, landing } from './teleport';

export interface Aiming {
  /**
   * Updates the aim of the holding hand; the target is the nearest `allowed` place. Points are in the headset's space.
   */
  update(inputs: readonly Input[], allowed: (wanted: Vector) => Vector): Aim | null;
  dispose(): void;
}

/** Tolerance in metres between the aimed place and the target. */
const SAME = 0.01;

/** Listens to a session; `jump` is called with the target on release. */
export function createAiming(session: XRSession, jump: (target: Vector) => void): Aiming {
  const stop = new AbortController();
  let holding: XRInputSource | null = null;
  let aim: Aim | null = null;

  // The hand that pressed last aims; the press of the other one is ignored.
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
        // A hand out of sight has no aim; it may come back.
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
