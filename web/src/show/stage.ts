/**
 * Sequence of a region's pictures: each ring fades in over the one before, and the morph grows. Nothing jumps, whenever
 * the rings arrive. The four strategies of CloVR (2024) differ in this sequence.
 */
import { orderByFootprint } from '../bundle/contents';
import { BundleError } from '../bundle/error';
import type { Manifest } from '../bundle/manifest';

/** How the pictures of a region follow each other. */
export interface Manner {
  /** Whether rings fade in and the morph grows; otherwise each ring appears at once, fully morphed. */
  readonly isSmooth: boolean;
  /** Whether the region is shown only after its last ring is loaded. */
  readonly isWhole: boolean;
}

/** What a frame shows of a region: one picture, or two while a ring fades in. */
export interface Shown {
  readonly ring: number;
  readonly grown: MorphState;
  /** Ring that fades in, and its opacity (`share`); null for none. */
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

  /** Returns the state in which the region would begin after another region's state `from`; null before ring 0. */
  function offer(from: MorphState): MorphState | null {
    const [first, last] = [settings.radii[0], settings.radii[ring - 1]];
    if (!isShowable()) return null;
    if (first === undefined || last === undefined) return NOTHING_NEAR;
    return { radius: Math.min(Math.max(from.radius, first), last), strength: from.radius > 0 ? from.strength : 0 };
  }

  /** Returns the state of a picture that appears at once: fully morphed, unless it would fold. */
  function immediateState(least: number): MorphState {
    const radius = settings.radii[ring - 1];
    if (radius === undefined) return NOTHING_NEAR;
    return { radius, strength: grown.strength === 1 || radius >= least ? 1 : 0 };
  }

  /** Resumes the loading of rings whose cube has become free. */
  function resumeLoading(): void {
    const resumed = waiting.filter((entry) => isCubeFree(entry.ring));
    waiting = waiting.filter((entry) => !isCubeFree(entry.ring));
    for (const { done } of resumed) done();
  }

  /** Whether the map of ring `next` may overwrite that of ring `next` − 2, which is in the same cube. */
  function isCubeFree(next: number): boolean {
    return ring >= next - 1 || arrived < 1;
  }

  return {
    /** Records that the next ring is loaded. Until the region is shown, rings replace each other without a fade. */
    arrive(next: number): void {
      arrived = next;
      if (isEntered && isSmooth && ring >= 0) return;
      ring = next;
      resumeLoading();
    },
    offer,
    /** Shows the region, in a state as similar to another region's state `from` as the loaded rings allow. */
    enter(from: MorphState): void {
      grown = offer(from) ?? NOTHING_NEAR;
      isEntered = true;
    },
    /** Hides the region. */
    leave(): void {
      isEntered = isFading = false;
      ring = arrived;
      resumeLoading();
    },
    /** Returns the picture some seconds later; pictures with a radius below `least` would fold. */
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
      resumeLoading();
      return { ring, grown, fading: null };
    },
    /** Waits until the map of ring `next` − 2 is no longer shown, so that the map of ring `next` may overwrite it. */
    waitForCube: (next: number): Promise<void> =>
      new Promise((done) => {
        waiting.push({ ring: next, done });
        resumeLoading();
      }),
  };
}

export interface GrowthSettings {
  /** Radii of the rings 1 to n, metres, ascending. */
  readonly radii: readonly number[];
  /** Degrees per second. */
  readonly speed: number;
  /** A user at this distance from the centre, in metres, sees the picture turn with `speed`. */
  readonly reach: number;
  readonly nearShare: number;
}

/** State of the morph while it grows (nf.stream.Growth): first its strength grows to 1, then its radius. */
export interface MorphState {
  /** R, metres. */
  readonly radius: number;
  /** Strength of the morph, 0 to 1. */
  readonly strength: number;
}

/** Least near share from which the growth of the strength is computed; nearer points turn faster than `speed`. */
const MIN_SHARE = 0.05;

/** State without near geometry, before ring 1. */
export const NOTHING_NEAR: MorphState = { radius: 0, strength: 0 };

/**
 * Returns the state some seconds later if the rings up to `ring` are shown. The inverse of the radius falls linearly.
 * Pictures with a radius below `least` would fold. Until a ring reaches it, the strength stays 0, with which all radii
 * look alike.
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
  /** Returns the manifest with the rings in the order in which they are loaded. */
  readonly arrange: (manifest: Manifest) => Manifest;
  /** Whether it loads the rings as they are; servers that make regions on demand make no other parts. */
  readonly isByRings: boolean;
}

const keepOrder = (manifest: Manifest): Manifest => manifest;

/** The strategies for near geometry that CloVR (2024) compares. */
const STRATEGIES: Readonly<Record<string, Strategy>> = {
  clovr: { isSmooth: true, isWhole: false, arrange: keepOrder, isByRings: true },
  // Shows rings at once instead of smoothly.
  clovrd: { isSmooth: false, isWhole: false, arrange: keepOrder, isByRings: true },
  // Shows near geometry only when everything that the centre sees is loaded.
  vis0: { isSmooth: false, isWhole: true, arrange: orderByFootprint, isByRings: false },
  // Shows objects as they arrive, the largest footprints first.
  vis1: { isSmooth: false, isWhole: false, arrange: orderByFootprint, isByRings: false },
};

/** Returns the strategy that an address names; clovr if it names none. */
export function strategyOf(name: string | null): Strategy {
  const strategy = Object.hasOwn(STRATEGIES, name ?? 'clovr') ? STRATEGIES[name ?? 'clovr'] : undefined;
  if (!strategy)
    throw new BundleError(`strategy: expected ${Object.keys(STRATEGIES).join(', ')}, got ${name ?? ''}`, 'address');
  return strategy;
}
