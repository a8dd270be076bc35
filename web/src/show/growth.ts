/**
 * How the morph grows when rings have arrived (nf.stream.Growth): the first ring by its strength, the others by their
 * radius, whose inverse falls linearly. The picture of a user at `reach` metres from the centre turns at `speed`.
 */

export interface GrowthSettings {
  /** Radii of the rings 1 to n, metres, ascending. */
  readonly radii: readonly number[];
  /** Degrees a second. */
  readonly speed: number;
  /** Metres. */
  readonly reach: number;
  readonly nearShare: number;
}

/** The part of the arrived rings that is shown. */
export interface Grown {
  /** R, metres. */
  readonly radius: number;
  /** 0 to 1. */
  readonly strength: number;
}

/** Least near share by which the strength grows: what lies nearer than that turns faster. */
const LEAST_SHARE = 0.05;

/** Before ring 1 is there. */
export const NOTHING_NEAR: Grown = { radius: 0, strength: 0 };

/**
 * What is shown after some seconds more, with the rings up to `ring`. Pictures of a radius below `least` would fold:
 * until a ring reaches it, everything is shown as the centre sees it, which is the same picture at any radius.
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
    const whole = 1 / (Math.max(settings.nearShare, LEAST_SHARE) * radius * rate);
    const needed = (1 - strength) * whole;
    strength = left >= needed ? 1 : strength + left / whole;
    left = Math.max(0, left - needed);
  }
  if (strength < 1 || radius >= goal) return { radius: Math.min(radius, goal), strength };
  const inverse = 1 / radius - (1 - settings.nearShare) * rate * left;
  return { radius: inverse <= 1 / goal ? goal : 1 / inverse, strength };
}
