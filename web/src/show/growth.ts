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

/** What is shown of the rings that are there. */
export interface Grown {
  /** R, metres. */
  readonly radius: number;
  /** 0 to 1. */
  readonly strength: number;
}

/** Before ring 1 is there. */
export const NOTHING_NEAR: Grown = { radius: 0, strength: 0 };

/** What is shown after some seconds more, with the rings up to `ring`. */
export function grow(now: Grown, ring: number, seconds: number, settings: GrowthSettings): Grown {
  const goal = settings.radii[ring - 1];
  const first = settings.radii[0];
  if (goal === undefined || first === undefined) return NOTHING_NEAR;
  const rate = (settings.speed * Math.PI) / 180 / settings.reach;
  const radius = Math.max(now.radius, first);
  let left = seconds;
  let strength = now.radius === 0 ? 0 : now.strength;
  if (strength < 1) {
    const whole = 1 / (settings.nearShare * first * rate);
    const needed = (1 - strength) * whole;
    strength = left >= needed ? 1 : strength + left / whole;
    left = Math.max(0, left - needed);
  }
  if (strength < 1 || radius >= goal) return { radius: Math.min(radius, goal), strength };
  const inverse = 1 / radius - (1 - settings.nearShare) * rate * left;
  return { radius: inverse <= 1 / goal ? goal : 1 / inverse, strength };
}
