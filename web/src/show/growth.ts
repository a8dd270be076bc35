/**
 * Growth of the morph after the arrival of rings (nf.stream.Growth): the first ring grows by its strength, the others
 * by their radius, whose inverse falls linearly. The picture of a user at `reach` metres from the centre turns at
 * `speed`.
 */

export interface GrowthSettings {
  /** Radii of the rings 1 to n, metres, ascending. */
  readonly radii: readonly number[];
  /** Degrees per second. */
  readonly speed: number;
  /** Distance of the user in metres. */
  readonly reach: number;
  readonly nearShare: number;
}

/** State of the growth. */
export interface Grown {
  /** R, metres. */
  readonly radius: number;
  /** Strength of the morph, 0 to 1. */
  readonly strength: number;
}

/** Least near share for the growth of the strength: nearer points turn faster. */
const MIN_SHARE = 0.05;

/** State before ring 1. */
export const NOTHING_NEAR: Grown = { radius: 0, strength: 0 };

/**
 * Advances the growth by some seconds, with the rings up to `ring`. Pictures with a radius below `least` would fold:
 * until a ring reaches it, the strength stays 0, which gives the same picture at any radius.
 */
export function grow(now: Grown, ring: number, seconds: number, settings: GrowthSettings, least = 0): Grown {
  const goal = settings.radii[ring - 1];
  if (goal === undefined) return NOTHING_NEAR;
  const rate = (settings.speed * Math.PI) / 180 / settings.reach;
  let left = seconds;
  let strength = now.radius === 0 ? 0 : now.strength;
  const begins = settings.radii.find((each) => each >= least) ?? Number.POSITIVE_INFINITY;
  if (strength === 0 && begins > goal) return { radius: goal, strength };
  const radius = strength === 0 ? begins : now.radius;
  if (strength < 1) {
    const whole = 1 / (Math.max(settings.nearShare, MIN_SHARE) * radius * rate);
    const needed = (1 - strength) * whole;
    strength = left >= needed ? 1 : strength + left / whole;
    left = Math.max(0, left - needed);
  }
  if (strength < 1 || radius >= goal) return { radius: Math.min(radius, goal), strength };
  const inverse = 1 / radius - (1 - settings.nearShare) * rate * left;
  return { radius: inverse <= 1 / goal ? goal : 1 / inverse, strength };
}
