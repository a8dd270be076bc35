/** Jumps in a headset: the user aims along an arc by trigger or pinch, and the picture fades to black and back. */
import type { Vector } from '../control/pose';
import type { Input, Ray } from './inputs';

/** Metres per second and per second². A level arc from the hip reaches about 4 m, one at 45° more than 7 m. */
const [SPEED, GRAVITY] = [7.5, 9.81] as const;
export const ARC_POINTS = 24;
/** Seconds in which the picture fades to black, and seconds in which it fades back. */
const FADE_SECONDS = 0.12;

/** Returns where an arc along a ray meets the ground at height 0. A hand below the ground counts as on it. */
export function landingPoint({ origin: [x, y, z], direction: [dx, dy, dz] }: Ray): Vector {
  const seconds = fallSeconds(y, dy);
  return [x + SPEED * dx * seconds, 0, z + SPEED * dz * seconds];
}

/** Returns points of an arc from the hand to a target on the ground, also if the arc of the ray would end elsewhere. */
export function pointsOfArc(ray: Ray, target: Vector): Vector[] {
  const { origin, direction } = ray;
  const seconds = fallSeconds(origin[1], direction[1]);
  const end = landingPoint(ray);
  return Array.from({ length: ARC_POINTS }, (_, number): Vector => {
    const share = number / (ARC_POINTS - 1);
    const time = share * seconds;
    const at = (axis: 0 | 1 | 2): number =>
      origin[axis] + SPEED * direction[axis] * time + share * share * (target[axis] - end[axis]);
    return [at(0), at(1) - (GRAVITY / 2) * time * time, at(2)];
  });
}

/** Returns the seconds until a throw from a height lands; `up` is the upward component of its direction. */
function fallSeconds(height: number, up: number): number {
  const rise = SPEED * up;
  return (rise + Math.sqrt(rise * rise + 2 * GRAVITY * Math.max(height, 0))) / GRAVITY;
}

export type Jump = ReturnType<typeof createJump>;

export function createJump() {
  // Seconds since the start; the picture is darkest at FADE_SECONDS.
  let elapsed = 2 * FADE_SECONDS;
  let pending: (() => void) | null = null;

  return {
    /** Fades to black, calls `action`, and fades back. An earlier action that has not been called is dropped. */
    start(action: () => void): void {
      pending = action;
      // The fade begins with the current darkness.
      elapsed = Math.min(elapsed, Math.max(2 * FADE_SECONDS - elapsed, 0));
    },
    /** Advances by some seconds; returns the darkness, 0 to 1. */
    advance(seconds: number): number {
      const before = elapsed;
      elapsed = Math.min(elapsed + seconds, 2 * FADE_SECONDS);
      if (pending && elapsed >= FADE_SECONDS) {
        // There is a frame at full darkness, even if a frame takes longer than the fade.
        if (before < FADE_SECONDS) elapsed = FADE_SECONDS;
        const action = pending;
        pending = null;
        action();
      }
      return 1 - Math.abs(elapsed - FADE_SECONDS) / FADE_SECONDS;
    },
  };
}

/** Aim of a jump, in the headset's space. */
export interface Aim {
  /** Points of the arc. */
  readonly points: readonly Vector[];
  readonly target: Vector;
  /** Whether the user aims beyond the bounds, so that the target is not where the user aims. */
  readonly isClamped: boolean;
}

/** Distance in metres above which the target is not where the user aims. */
const TOLERANCE = 0.01;

/**
 * Listens to a session until the signal aborts. While a hand holds its trigger or a pinch, the returned function
 * returns its aim; when the hand lets go, `jump` is called with the target. `clamp` moves a point into the bounds. All
 * points are in the headset's space.
 */
export function createAiming(session: XRSession, signal: AbortSignal, jump: (target: Vector) => void) {
  let aimingHand: XRInputSource | null = null;
  let aim: Aim | null = null;

  // The hand that has pressed last aims; if the other one lets go, nothing happens.
  session.addEventListener('selectstart', ({ inputSource }) => (aimingHand = inputSource), { signal });
  session.addEventListener('selectend', ({ inputSource }) => {
    if (inputSource !== aimingHand) return;
    const target = aim?.target;
    aimingHand = aim = null;
    if (target) jump(target);
  }, { signal });

  return (inputs: readonly Input[], clamp: (point: Vector) => Vector): Aim | null => {
    // A hand that is not tracked has no aim, but it can still return.
    const ray = aimingHand && inputs.find(({ source }) => source === aimingHand)?.ray;
    if (!ray) return (aim = null);
    const end = landingPoint(ray);
    const target = clamp(end);
    const isClamped = Math.hypot(target[0] - end[0], target[2] - end[2]) > TOLERANCE;
    aim = { points: pointsOfArc(ray, target), target, isClamped };
    return aim;
  };
}
