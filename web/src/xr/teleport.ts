/** Jump to another place: aiming by the trigger or pinch, the ballistic arc, and the fade. */
import type { Vector } from '../control/pose';
import type { Input, Ray } from './inputs';

/** Metres per second and per second²: an arc aimed level from the hip reaches about 4 m, one at 45° more than 7 m. */
const [SPEED, GRAVITY] = [7.5, 9.81] as const;
export const ARC_POINTS = 24;
/** Seconds in which the picture fades to black, and back. */
const FADE_SECONDS = 0.12;

/** Returns where an arc along a ray lands on the ground at height 0. A hand below the ground throws from it. */
export function landing({ origin: [x, y, z], direction: [dx, dy, dz] }: Ray): Vector {
  const seconds = fall(y, dy);
  return [x + SPEED * dx * seconds, 0, z + SPEED * dz * seconds];
}

/** Points of the arc from the hand to a target on the ground, bent if the target is not its landing point. */
export function arc(ray: Ray, target: Vector): Vector[] {
  const { origin, direction } = ray;
  const seconds = fall(origin[1], direction[1]);
  const end = landing(ray);
  return Array.from({ length: ARC_POINTS }, (_, number): Vector => {
    const share = number / (ARC_POINTS - 1);
    const time = share * seconds;
    const at = (axis: 0 | 1 | 2): number =>
      origin[axis] + SPEED * direction[axis] * time + share * share * (target[axis] - end[axis]);
    return [at(0), at(1) - (GRAVITY / 2) * time * time, at(2)];
  });
}

/** Seconds until a throw from a height lands, with its upward component as a share of the speed. */
function fall(height: number, up: number): number {
  const rise = SPEED * up;
  return (rise + Math.sqrt(rise * rise + 2 * GRAVITY * Math.max(height, 0))) / GRAVITY;
}

export type Jump = ReturnType<typeof createJump>;

export function createJump() {
  // Seconds since the start; the picture is darkest at FADE_SECONDS.
  let elapsed = 2 * FADE_SECONDS;
  let pending: (() => void) | null = null;

  return {
    /** Fades to black, acts, and fades back. Replaces a jump that has not acted. */
    start(action: () => void): void {
      pending = action;
      // Starts at the current darkness.
      elapsed = Math.min(elapsed, Math.max(2 * FADE_SECONDS - elapsed, 0));
    },
    /** Advances by some seconds; returns the darkness, 0 to 1. */
    advance(seconds: number): number {
      const before = elapsed;
      elapsed = Math.min(elapsed + seconds, 2 * FADE_SECONDS);
      if (pending && elapsed >= FADE_SECONDS) {
        // Guarantees a frame at full darkness, however long frames are.
        if (before < FADE_SECONDS) elapsed = FADE_SECONDS;
        const action = pending;
        pending = null;
        action();
      }
      return 1 - Math.abs(elapsed - FADE_SECONDS) / FADE_SECONDS;
    },
  };
}

/** Aim of a jump in the headset's space. */
export interface Aim {
  readonly arc: readonly Vector[];
  readonly target: Vector;
  /** Whether the target was clamped, because the aimed place lies beyond the limit. */
  readonly isClamped: boolean;
}

/** Tolerance in metres between the aimed place and the target. */
const TOLERANCE = 0.01;

/**
 * Listens to a session until the signal aborts; `jump` is called with the target on release. The returned function
 * updates the aim of the holding hand; the target is the nearest `allowed` place. Points are in the headset's space.
 */
export function createAiming(session: XRSession, signal: AbortSignal, jump: (target: Vector) => void) {
  let holding: XRInputSource | null = null;
  let aim: Aim | null = null;

  // The hand that pressed last aims; the press of the other one is ignored.
  session.addEventListener('selectstart', ({ inputSource }) => (holding = inputSource), { signal });
  session.addEventListener('selectend', ({ inputSource }) => {
    if (inputSource !== holding) return;
    const target = aim?.target;
    holding = aim = null;
    if (target) jump(target);
  }, { signal });

  return (inputs: readonly Input[], allowed: (aimed: Vector) => Vector): Aim | null => {
    // A hand out of sight has no aim; it may come back.
    const ray = holding && inputs.find(({ source }) => source === holding)?.ray;
    if (!ray) return (aim = null);
    const aimed = landing(ray);
    const target = allowed(aimed);
    const isClamped = Math.hypot(target[0] - aimed[0], target[2] - aimed[2]) > TOLERANCE;
    aim = { arc: arc(ray, target), target, isClamped };
    return aim;
  };
}
