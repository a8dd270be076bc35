/**
 * Which pictures of a region are shown as time passes: a ring that has arrived fades in over the ring before, and the
 * morph grows. Nothing jumps, whatever arrives when.
 */
import { grow, type Grown, type GrowthSettings, NOTHING_NEAR } from './growth';

/** The order in which pictures come to the screen. */
export interface Manner {
  /** Rings that arrive fade in, and the morph grows; else both happen at once. */
  readonly isSmooth: boolean;
  /** Nothing is shown before the last ring is there. */
  readonly isWhole: boolean;
}

/** The present picture, or two while one fades in over the other. */
export interface Shown {
  readonly ring: number;
  readonly grown: Grown;
  /** The ring that fades in, and its share of the picture; null for none. */
  readonly fading: { readonly ring: number; readonly share: number } | null;
}

export interface Stage {
  /** A ring is there; rings come in order. Until the stage is entered, each takes the place of the one before. */
  arrive(ring: number): void;
  /** The first state after the picture of another region goes over into this one; null before ring 0. */
  offer(from: Grown): Grown | null;
  /** Show the region from now on, as much like the other region's picture as the rings that are there allow. */
  enter(from: Grown): void;
  /** Show it no more. */
  leave(): void;
  /** Go on by some seconds; smaller radii than `least` would fold. */
  advance(seconds: number, least?: number): Shown | null;
  /** Resolves when the map of the ring before `ring` − 1 is no longer shown, so that the map of `ring` may replace it. */
  replaceable(ring: number): Promise<void>;
}

export function createStage(settings: GrowthSettings & { readonly fade: number }, { isSmooth, isWhole }: Manner): Stage {
  let arrived = -1;
  let ring = -1;
  let since = 0;
  let isFading = false;
  let isEntered = false;
  let grown = NOTHING_NEAR;
  let waiting: { ring: number; done: () => void }[] = [];

  function isThere(): boolean {
    return ring >= (isWhole ? settings.radii.length : 0);
  }

  function offer(from: Grown): Grown | null {
    const [first, last] = [settings.radii[0], settings.radii[ring - 1]];
    if (!isThere()) return null;
    if (first === undefined || last === undefined) return NOTHING_NEAR;
    return { radius: Math.min(Math.max(from.radius, first), last), strength: from.radius > 0 ? from.strength : 0 };
  }

  /** Without smoothness all is shown at once, as soon as it does not fold. */
  function atOnce(least: number): Grown {
    const radius = settings.radii[ring - 1];
    if (radius === undefined) return NOTHING_NEAR;
    return { radius, strength: grown.strength === 1 || radius >= least ? 1 : 0 };
  }

  function release(): void {
    const free = waiting.filter((entry) => isFree(entry.ring));
    waiting = waiting.filter((entry) => !isFree(entry.ring));
    for (const { done } of free) done();
  }

  /** The map of `next` takes the place of that of `next` − 2. */
  function isFree(next: number): boolean {
    return ring >= next - 1 || arrived < 1;
  }

  return {
    arrive(next) {
      arrived = next;
      if (isEntered && isSmooth && ring >= 0) return;
      ring = next;
      release();
    },
    offer,
    enter(from) {
      grown = offer(from) ?? NOTHING_NEAR;
      isEntered = true;
    },
    leave() {
      isEntered = isFading = false;
      ring = arrived;
      release();
    },
    advance(seconds, least = 0) {
      if (!isThere()) return null;
      grown = isSmooth ? grow(grown, ring, isFading ? 0 : seconds, settings, least) : atOnce(least);
      if (!isFading && arrived > ring) {
        isFading = true;
        since = 0;
        return { ring, grown, fading: { ring: ring + 1, share: 0 } };
      }
      if (!isFading) return { ring, grown, fading: null };
      since += seconds;
      const share = settings.fade > 0 ? Math.min(since / settings.fade, 1) : 1;
      if (share < 1) return { ring, grown, fading: { ring: ring + 1, share } };
      ring += 1;
      isFading = false;
      release();
      return { ring, grown, fading: null };
    },
    replaceable(next) {
      return new Promise((done) => {
        if (isFree(next)) done();
        else waiting.push({ ring: next, done });
      });
    },
  };
}
