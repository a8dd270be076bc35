/** Places on the grid to which a server moves what it is asked for: regions get their numbers as they are met. */
import { distance } from '../control/limit';
import type { Vector } from '../control/vector';
import type { Places, Spot } from '../show/places';

/** Steps to which a server moves the height of a place, metres. */
const HEIGHT = 1 / 8;
/** Another place is asked for when less than this part of the limit is left, and dropped when more than that is. */
const [ASKED_SHARE, DROPPED_SHARE] = [0.5, 0.6] as const;
/** The place that was asked for is kept while it is nearer than this part of the way to the centre that is shown. */
const KEPT_SHARE = 0.6;

export interface Grid extends Places {
  /** Something is known of a region. */
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
    // Its margin is not known: those who ask for it are no farther than that.
    spots.push({ center, fold_margin: spacing });
    numbers.set(name, spots.length - 1);
    return spots.length - 1;
  }

  return {
    of,
    nearest,
    /** The place where the user is, if the picture that is shown ends soon; the one before, while it serves as well. */
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
  // Without a negative zero, which has another name.
  return step * Math.round(value / step) + 0;
}
