/**
 * Sequence of a region's pictures: a ring that has arrived fades in over the one before, and the morph grows. Nothing
 * jumps, regardless of the arrival times. The four strategies of CloVR (2024) differ in this sequence.
 */
import { orderByFootprint } from '../bundle/contents';
import { BundleError } from '../bundle/error';
import type { Manifest } from '../bundle/manifest';

/** Ways in which pictures appear. */
export interface Manner {
  /** Whether rings fade in and the morph grows; otherwise both happen at once. */
  readonly isSmooth: boolean;
  /** Whether nothing is shown before the last ring is loaded. */
  readonly isWhole: boolean;
}

/** Current picture, or two during a fade. */
export interface Shown {
  readonly ring: number;
  readonly grown: MorphState;
  /** Ring that fades in, and its opacity; null for none. */
  readonly fading: { readonly ring: number; readonly share: number } | null;
}

export type Stage = ReturnType<typeof createStage>;

export function createStage(settings: GrowthSettings & { readonly fade: number }, { isSmooth, isWhole }: Manner) {
  let arrived = -1;
  let ring = -1;
  let fadeSeconds = 0;
  let isFading = false;
  let isEntered = false;
  let grown = NOTHING_NEAR;
  let waiting: { ring: number; done: () => void }[] = [];

  function isShowable(): boolean {
    return ring >= (isWhole ? settings.radii.length : 0);
  }

  /** Returns the first state after a transition from another region; null before ring 0. */
  function offer(from: MorphState): MorphState | null {
    const [first, last] = [settings.radii[0], settings.radii[ring - 1]];
    if (!isShowable()) return null;
    if (first === undefined || last === undefined) return NOTHING_NEAR;
    return { radius: Math.min(Math.max(from.radius, first), last), strength: from.radius > 0 ? from.strength : 0 };
  }

  /** Without smoothness everything is shown at once, as soon as it does not fold. */
  function immediateState(least: number): MorphState {
    const radius = settings.radii[ring - 1];
    if (radius === undefined) return NOTHING_NEAR;
    return { radius, strength: grown.strength === 1 || radius >= least ? 1 : 0 };
  }

  function release(): void {
    const unblocked = waiting.filter((entry) => mayReplace(entry.ring));
    waiting = waiting.filter((entry) => !mayReplace(entry.ring));
    for (const { done } of unblocked) done();
  }

  /** Whether the map of ring `next` may replace the map of ring `next` − 2. */
  function mayReplace(next: number): boolean {
    return ring >= next - 1 || arrived < 1;
  }

  return {
    /** Records that a ring is loaded, in order. Until the stage is entered, each ring replaces the one before. */
    arrive(next: number): void {
      arrived = next;
      if (isEntered && isSmooth && ring >= 0) return;
      ring = next;
      release();
    },
    offer,
    /** Shows the region from now on, in a state as similar to the other region's as the loaded rings allow. */
    enter(from: MorphState): void {
      grown = offer(from) ?? NOTHING_NEAR;
      isEntered = true;
    },
    /** Stops showing it. */
    leave(): void {
      isEntered = isFading = false;
      ring = arrived;
      release();
    },
    /** Advances by some seconds; radii smaller than `least` would fold. */
    advance(seconds: number, least = 0): Shown | null {
      if (!isShowable()) return null;
      grown = isSmooth ? grow(grown, ring, isFading ? 0 : seconds, settings, least) : immediateState(least);
      if (!isFading && arrived > ring) {
        isFading = true;
        fadeSeconds = 0;
        return { ring, grown, fading: { ring: ring + 1, share: 0 } };
      }
      if (!isFading) return { ring, grown, fading: null };
      fadeSeconds += seconds;
      const share = settings.fade > 0 ? Math.min(fadeSeconds / settings.fade, 1) : 1;
      if (share < 1) return { ring, grown, fading: { ring: ring + 1, share } };
      ring += 1;
      isFading = false;
      release();
      return { ring, grown, fading: null };
    },
    /** Resolves when the map of ring `next` − 2 is no longer shown, so that the map of `next` may replace it. */
    whenReplaceable: (next: number): Promise<void> =>
      new Promise((done) => {
        waiting.push({ ring: next, done });
        release();
      }),
  };
}

export interface GrowthSettings {
  /** Radii of the rings 1 to n, metres, ascending. */
  readonly radii: readonly number[];
  /** Degrees per second. */
  readonly speed: number;
  /** Distance in metres of the user whose picture turns at `speed`. */
  readonly reach: number;
  readonly nearShare: number;
}

/** State of the growth (nf.stream.Growth): the first ring grows by its strength, the others by their radius. */
export interface MorphState {
  /** R, metres. */
  readonly radius: number;
  /** Strength of the morph, 0 to 1. */
  readonly strength: number;
}

/** Least near share for the growth of the strength: nearer points turn faster. */
const MIN_SHARE = 0.05;

/** State before ring 1. */
export const NOTHING_NEAR: MorphState = { radius: 0, strength: 0 };

/**
 * Advances the growth by some seconds, with the rings up to `ring`; the inverse of the radius falls linearly. Pictures
 * with a radius below `least` would fold, so until a ring reaches it the strength stays 0: then all radii look alike.
 */
export function grow(state: MorphState, ring: number, seconds: number, settings: GrowthSettings, least = 0): MorphState {
  const goal = settings.radii[ring - 1];
  if (goal === undefined) return NOTHING_NEAR;
  const rate = (settings.speed * Math.PI) / 180 / settings.reach;
  let remainingSeconds = seconds;
  let strength = state.radius === 0 ? 0 : state.strength;
  const firstRadius = settings.radii.find((each) => each >= least) ?? Number.POSITIVE_INFINITY;
  if (strength === 0 && firstRadius > goal) return { radius: goal, strength };
  const radius = strength === 0 ? firstRadius : state.radius;
  if (strength < 1) {
    const growthSeconds = 1 / (Math.max(settings.nearShare, MIN_SHARE) * radius * rate);
    const missingSeconds = (1 - strength) * growthSeconds;
    strength = remainingSeconds >= missingSeconds ? 1 : strength + remainingSeconds / growthSeconds;
    remainingSeconds = Math.max(0, remainingSeconds - missingSeconds);
  }
  if (strength < 1 || radius >= goal) return { radius: Math.min(radius, goal), strength };
  const inverse = 1 / radius - (1 - settings.nearShare) * rate * remainingSeconds;
  return { radius: inverse <= 1 / goal ? goal : 1 / inverse, strength };
}

export interface Strategy extends Manner {
  /** Returns the manifest in the order of loading. */
  readonly arrange: (manifest: Manifest) => Manifest;
  /** Whether it loads rings; servers that make regions on demand make only rings. */
  readonly isByRings: boolean;
}

const unchanged = (manifest: Manifest): Manifest => manifest;

/** Strategies to load near geometry, compared in CloVR (2024). */
const STRATEGIES: Readonly<Record<string, Strategy>> = {
  clovr: { isSmooth: true, isWhole: false, arrange: unchanged, isByRings: true },
  // Shows rings at once instead of smoothly.
  clovrd: { isSmooth: false, isWhole: false, arrange: unchanged, isByRings: true },
  // Shows nothing until everything that the centre sees is loaded.
  vis0: { isSmooth: false, isWhole: true, arrange: orderByFootprint, isByRings: false },
  // Shows objects as they arrive, the largest footprints first.
  vis1: { isSmooth: false, isWhole: false, arrange: orderByFootprint, isByRings: false },
};

/** Returns the strategy of a name in an address; clovr by default. */
export function strategyOf(name: string | null): Strategy {
  const strategy = Object.hasOwn(STRATEGIES, name ?? 'clovr') ? STRATEGIES[name ?? 'clovr'] : undefined;
  if (!strategy)
    throw new BundleError(`strategy: expected ${Object.keys(STRATEGIES).join(', ')}, got ${name ?? ''}`, 'address');
  return strategy;
}
