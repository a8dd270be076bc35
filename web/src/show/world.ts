/** What a viewer shows: the places of regions, the files of each, and the choice of the region to preload. */
import { completeRegion, type ArrivingRegion } from '../bundle/contents';
import type { Manifest, RegionEntry } from '../bundle/manifest';
import type { Limit } from '../control/limit';
import type { Vector } from '../control/pose';

export interface World {
  readonly places: Places;
  /** Texels along an edge of a full-size map. */
  readonly faceSize: number;
  /** n: nothing moves within n R. */
  readonly nearShare: number;
  /** Share of a morph's radius within which its picture does not fold. */
  readonly marginShare: number;
  /** Duration of a cross-fade, seconds. */
  readonly fade: number;
  /** Opens a region; the signal aborts when the region is no longer needed. */
  open(region: number, signal: AbortSignal): Promise<ArrivingRegion>;
}

/** Returns the world of a bundle. */
export function worldOf(manifest: Manifest): World {
  return {
    places: bundlePlaces(manifest.regions),
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

/**
 * A region is preloaded when the user is nearer to its border than `PRELOAD_SHARE` of the way from the centre to the
 * border, or than `PRELOAD_METRES`, which count for at most `MAX_PRELOAD_SHARE` of the way.
 */
const PRELOAD_SHARE = 0.5;
const PRELOAD_METRES = 4;
const MAX_PRELOAD_SHARE = 0.9;
/** A preloaded region is kept while another one is nearer by less than this share of the distance between centres. */
const KEEP_SHARE = 0.25;

/** Centre of a region, and the distance from it up to which the picture of the last ring does not fold. */
export type Spot = Pick<RegionEntry, 'center' | 'fold_margin'>;

/** Where a user is: the place, the region, and the limit of its current picture. */
export interface UserPlace {
  readonly place: Vector;
  readonly current: number;
  /** Region that is preloaded; null for none. */
  readonly preloaded: number | null;
  readonly limit: Limit;
}

export interface Places {
  spotOf(region: number): Spot;
  /** Returns the region that a place belongs to. */
  nearest(place: Vector): number;
  /** Returns the region to preload; null for none. */
  regionToPreload(user: UserPlace): number | null;
}

export function distanceBetween(a: Vector, b: Vector): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/**
 * Returns the distance between two centres, and the distance of a place from the border halfway between them, metres.
 * The latter is negative beyond the border.
 */
function distancesAt(place: Vector, from: Vector, to: Vector): { toCenter: number; toBorder: number } {
  const toCenter = Math.max(distanceBetween(to, from), 1e-6);
  const squares = distanceBetween(to, place) ** 2 - distanceBetween(from, place) ** 2;
  return { toCenter, toBorder: squares / (2 * toCenter) };
}

/** Returns the region with the nearest centre, other than `excluded`; the first of equally near ones, null for none. */
export function nearestOf(spots: readonly Pick<Spot, 'center'>[], place: Vector, excluded = -1): number | null {
  let best: number | null = null;
  let least = Number.POSITIVE_INFINITY;
  spots.forEach(({ center }, number) => {
    const distance = distanceBetween(center, place);
    if (number !== excluded && distance < least) [best, least] = [number, distance];
  });
  return best;
}

/** Returns the places of a bundle, which are all known from the start. */
export function bundlePlaces(spots: readonly Spot[]): Places {
  const spotOf = (region: number): Spot => spots[region] as Spot;
  return {
    spotOf,
    nearest: (place) => nearestOf(spots, place) ?? 0,
    /** Returns the nearest other region if its border is near, or the preloaded one while it is about as near. */
    regionToPreload({ place, current, preloaded }) {
      const other = nearestOf(spots, place, current);
      if (other === null) return null;
      const from = spotOf(current).center;
      const distanceTo = (region: number): number => distanceBetween(spotOf(region).center, place);
      const { toCenter, toBorder } = distancesAt(place, from, spotOf(other).center);
      const halfway = toCenter / 2;
      const reach = Math.max(PRELOAD_SHARE * halfway, Math.min(MAX_PRELOAD_SHARE * halfway, PRELOAD_METRES));
      if (preloaded !== null && preloaded !== current) {
        const isAsNear = distanceTo(preloaded) < distanceTo(other) + KEEP_SHARE * toCenter;
        const preloadedBorder = distancesAt(place, from, spotOf(preloaded).center).toBorder;
        if (isAsNear && preloadedBorder < reach + KEEP_SHARE * halfway) return preloaded;
      }
      return toBorder < reach ? other : null;
    },
  };
}
