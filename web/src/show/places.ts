/** The places that regions belong to, and which of them is loaded ahead of a user who walks on. */
import type { RegionEntry } from '../bundle/manifest';
import type { Limit } from '../control/limit';
import type { Vector } from '../control/vector';

/** A region is loaded ahead when the border is nearer than this part of the way from the centre to it, or metres. */
const [AHEAD_SHARE, AHEAD_METRES, AHEAD_MOST] = [0.5, 4, 0.9] as const;
/** A region that is loaded ahead is kept until the border is farther than that by this part of the way. */
const KEPT_SHARE = 0.25;

/** The centre of a region, and how far from it the picture of the last ring does not fold. */
export type Spot = Pick<RegionEntry, 'center' | 'fold_margin'>;

/** A user at a place in a region, whose present picture has a limit. */
export interface Standing {
  readonly place: Vector;
  readonly current: number;
  /** The region that is loaded ahead until now; null for none. */
  readonly ahead: number | null;
  readonly limit: Limit;
}

export interface Places {
  of(region: number): Spot;
  /** The region that a place to go to belongs to. */
  nearest(place: Vector): number;
  /** The region to load ahead; null for none. */
  ahead(standing: Standing): number | null;
}

export function apartOf(a: Vector, b: Vector): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Metres from one centre to another one, and from a place to the border between them; below 0 beyond it. */
export function borderOf(from: Vector, to: Vector, place: Vector): { apart: number; border: number } {
  const apart = Math.max(apartOf(to, from), 1e-6);
  return { apart, border: (apartOf(to, place) ** 2 - apartOf(from, place) ** 2) / (2 * apart) };
}

/** The region whose centre is nearest to a place, of equally near ones the first; null if there is no other than `but`. */
export function nearestOf(spots: readonly Pick<Spot, 'center'>[], place: Vector, but = -1): number | null {
  let best: number | null = null;
  let least = Number.POSITIVE_INFINITY;
  spots.forEach(({ center }, number) => {
    const far = apartOf(center, place);
    if (number !== but && far < least) [best, least] = [number, far];
  });
  return best;
}

/** Places of a bundle, which are all known. */
export function knownPlaces(spots: readonly Spot[]): Places {
  const of = (region: number): Spot => spots[region] as Spot;
  return {
    of,
    nearest: (place) => nearestOf(spots, place) ?? 0,
    /** The nearest other one; the one before, while it is about as near. */
    ahead({ place, current, ahead }) {
      const other = nearestOf(spots, place, current);
      if (other === null) return null;
      const from = of(current).center;
      const far = (region: number): number => apartOf(of(region).center, place);
      const { apart, border } = borderOf(from, of(other).center, place);
      const lead = Math.max((AHEAD_SHARE * apart) / 2, Math.min((AHEAD_MOST * apart) / 2, AHEAD_METRES));
      if (ahead !== null && ahead !== current) {
        const isAsNear = far(ahead) < far(other) + KEPT_SHARE * apart;
        const near = borderOf(from, of(ahead).center, place).border;
        if (isAsNear && near < lead + (KEPT_SHARE * apart) / 2) return ahead;
      }
      return border < lead ? other : null;
    },
  };
}
