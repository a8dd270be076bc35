/**
 * Which pictures of a region are shown as time passes: a ring that has arrived fades in over the ring before, and the
 * morph grows. Nothing jumps, whatever arrives when.
 */
import { grow, type Grown, type GrowthSettings, NOTHING_NEAR } from './growth';

/** Of the four ways to load that CloVR compares, those that this page shows by what is on the screen when. */
export interface Manner {
  /** Rings that arrive fade in, and the morph grows; else both happen at once. */
  readonly isSmooth: boolean;
}

/** What is drawn now: one picture, or two while one fades in over the other. */
export interface Shown {
  readonly ring: number;
  readonly grown: Grown;
  /** The ring that fades in, and its share of the picture; null for none. */
  readonly fading: { readonly ring: number; readonly share: number } | null;
}

export interface Stage {
  /** A ring is there; rings come in order. */
  arrive(ring: number): void;
  /** Go on by some seconds. */
  advance(seconds: number): Shown | null;
  /** Resolves when the map of the ring before `ring` − 1 is no longer shown, so that the map of `ring` may replace it. */
  replaceable(ring: number): Promise<void>;
}

export function createStage(settings: GrowthSettings & { readonly fade: number }, { isSmooth }: Manner): Stage {
  let arrived = -1;
  let ring = -1;
  let since = 0;
  let isFading = false;
  let grown = NOTHING_NEAR;
  let waiting: { ring: number; done: () => void }[] = [];

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
      if (ring < 0 || !isSmooth) {
        ring = next;
        const radius = settings.radii[next - 1];
        if (!isSmooth && radius !== undefined) grown = { radius, strength: 1 };
        release();
      }
    },
    advance(seconds) {
      if (ring < 0) return null;
      grown = isSmooth ? grow(grown, ring, isFading ? 0 : seconds, settings) : grown;
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
