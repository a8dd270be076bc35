/** Grid of places to which a server snaps requests; regions are numbered in the order of their discovery. */
import { distance } from '../control/limit';
import type { Vector } from '../control/vector';
import type { Places, Spot } from '../show/places';

/** Step to which a server rounds the height of a place, metres. */
const HEIGHT = 1 / 8;
/** Remaining share of the limit below which the next place is requested, and above which it is dropped. */
const [ASKED_SHARE, DROPPED_SHARE] = [0.5, 0.6] as const;
/** A requested place is kept while its distance is below this share of the distance to the shown centre. */
const KEPT_SHARE = 0.6;

export interface Grid extends Places {
  /** Records the place of a region. */
  know(region: number, spot: Spot): void;
}

export function createGrid(spacing: number): Grid {
  const numbers = new Map<string, number>();
  const spots: Spot[] = [];
  const of = (region: number): Spot => spots[region] as Spot;

  function nearest([x, y, z]: Vector): number {
    const center: Vector = [snapped(x, spacing), snapped(y, HEIGHT), snapped(z, spacing)];
    const name = center.join();
    const found = numbers.get(name);
    if (found !== undefined) return found;
    // The margin is unknown; users who request the region are at most this far away.
    spots.push({ center, fold_margin: spacing });
    numbers.set(name, spots.length - 1);
    return spots.length - 1;
  }

  return {
    of,
    nearest,
    /** Place of the user, if the shown region is about to end; the previous choice, while it is about as good. */
    ahead({ place, current, ahead, limit }) {
      const left = limit.metres - distance(place, limit);
      if (left > (ahead === null ? ASKED_SHARE : DROPPED_SHARE) * limit.metres) return null;
      const far = (region: number): number => distance(place, { center: of(region).center, metres: 0 });
      if (ahead !== null && ahead !== current && far(ahead) <= KEPT_SHARE * far(current)) return ahead;
      const here = nearest(place);
      return here === current ? null : here;
    },
    know(region, spot) {
      spots[region] = spot;
    },
  };
}

function snapped(value: number, step: number): number {
  // Adding 0 turns −0 into 0; −0 has another name.
  return step * Math.round(value / step) + 0;
}
