/** Content of a viewer: the places of regions, access to each, and the choice of the region to preload. */
import { completeRegion, type ArrivingRegion } from '../bundle/contents';
import type { Manifest, RegionEntry } from '../bundle/manifest';
import type { Limit } from '../control/limit';
import type { Vector } from '../control/pose';

export interface World {
  readonly places: Places;
  /** Texels along an edge of a map of full size. */
  readonly faceSize: number;
  /** n: nothing moves within n R. */
  readonly nearShare: number;
  /** Share of a morph's radius within which its picture does not fold. */
  readonly marginShare: number;
  /** Duration of a cross-fade, seconds. */
  readonly fade: number;
  /** Opens a region; the signal is aborted when it is no longer needed. */
  open(region: number, signal: AbortSignal): Promise<ArrivingRegion>;
}

/** World of a bundle's regions. */
export function worldOf(manifest: Manifest): World {
  return {
    places: knownPlaces(manifest.regions),
    faceSize: manifest.map.face_size,
    nearShare: manifest.morph.near_share,
    marginShare: marginShareOf(manifest),
    fade: manifest.growth.fade,
    open: (region) => Promise.resolve(completeRegion(manifest, region)),
  };
}

/** Returns the fold margin as a share of the morph's radius: for the cylinder morph the near share. */
function marginShareOf({ morph, regions }: Manifest): number {
  const [first] = regions;
  if (!first || !Number.isFinite(first.cut)) return morph.near_share;
  return Math.max(first.fold_margin / first.cut, Number.EPSILON);
}

/** Distance to the border that triggers preloading, as a share of the way from the centre to the border. */
const AHEAD_SHARE = 0.5;
/** Least distance that triggers preloading, metres. */
const AHEAD_METRES = 4;
/** Greatest share of the way at which `AHEAD_METRES` counts. */
const AHEAD_MAX_SHARE = 0.9;
/** Additional share of the way for which a preloaded region is kept. */
const KEPT_SHARE = 0.25;

/** Centre of a region, and the distance from it within which the last ring's picture does not fold. */
export type Spot = Pick<RegionEntry, 'center' | 'fold_margin'>;

/** User at a place in a region, with the limit of the current picture. */
export interface UserPlace {
  readonly place: Vector;
  readonly current: number;
  /** Region that is preloaded so far; null for none. */
  readonly ahead: number | null;
  readonly limit: Limit;
}

export interface Places {
  of(region: number): Spot;
  /** Returns the region that a place belongs to. */
  nearest(place: Vector): number;
  /** Returns the region to preload; null for none. */
  ahead(user: UserPlace): number | null;
}

export function distanceBetween(a: Vector, b: Vector): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Distance of two centres, and of a place from the border between them, metres; negative beyond the border. */
function borderOf(from: Vector, to: Vector, place: Vector): { apart: number; border: number } {
  const apart = Math.max(distanceBetween(to, from), 1e-6);
  return { apart, border: (distanceBetween(to, place) ** 2 - distanceBetween(from, place) ** 2) / (2 * apart) };
}

/** Returns the region with the nearest centre, except `excluded`, the first of equally near ones; null for none. */
export function nearestOf(spots: readonly Pick<Spot, 'center'>[], place: Vector, excluded = -1): number | null {
  let best: number | null = null;
  let least = Number.POSITIVE_INFINITY;
  spots.forEach(({ center }, number) => {
    const distance = distanceBetween(center, place);
    if (number !== excluded && distance < least) [best, least] = [number, distance];
  });
  return best;
}

/** Places of a bundle, all of which are known. */
export function knownPlaces(spots: readonly Spot[]): Places {
  const of = (region: number): Spot => spots[region] as Spot;
  return {
    of,
    nearest: (place) => nearestOf(spots, place) ?? 0,
    /** Returns the nearest other region, or keeps the previous one while it is about as near. */
    ahead({ place, current, ahead }) {
      const other = nearestOf(spots, place, current);
      if (other === null) return null;
      const from = of(current).center;
      const distanceTo = (region: number): number => distanceBetween(of(region).center, place);
      const { apart, border } = borderOf(from, of(other).center, place);
      const lead = Math.max((AHEAD_SHARE * apart) / 2, Math.min((AHEAD_MAX_SHARE * apart) / 2, AHEAD_METRES));
      if (ahead !== null && ahead !== current) {
        const isAsNear = distanceTo(ahead) < distanceTo(other) + KEPT_SHARE * apart;
        const aheadBorder = borderOf(from, of(ahead).center, place).border;
        if (isAsNear && aheadBorder < lead + (KEPT_SHARE * apart) / 2) return ahead;
      }
      return border < lead ? other : null;
    },
  };
}
