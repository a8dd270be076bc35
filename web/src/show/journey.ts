/**
 * Choice of the region to show while the user walks or jumps to another place, and of the region to preload. A region
 * replaces another one by a cross-fade, and only where neither picture folds; until then the user is confined to the
 * area where the current picture does not fold.
 */
import { type Bounds, clampToLimit, distance, FREE_SHARE, type Limit } from '../control/limit';
import type { Pose, Vector } from '../control/pose';
import { type MorphState, NOTHING_NEAR } from './stage';
import { distanceBetween, type World } from './world';

/** Hysteresis: share of two centres' distance by which another centre must be nearer. */
const GAP_SHARE = 0.1;
/** Greatest hysteresis, metres. */
const GAP_MAX = 2;
/** Least margin, as a share of its limit, with which a nearer region takes over, so that it is not left at once. */
const MIN_MARGIN_SHARE = 0.3;
/** Margin in metres beyond the user's position at which a radius may begin to fold. */
const MARGIN_METRES = 0.5;
/** Tolerance for rounding, so that the last radius always counts as sufficient. */
const ROUNDING_FACTOR = 1 - 1e-9;
/** Share of the limit to which a landing position is clamped. */
const LANDING_SHARE = 0.9;
/** Least margin of a target, as a share of the current region's limit, for which the user jumps within that region. */
const HERE_SHARE = 0.5;

/** Interface of a journey to the regions. */
export interface Regions {
  /** Loads a region, unless its loading has begun. */
  open(region: number): void;
  close(region: number): void;
  /** Sets the order of loading; later regions wait for earlier ones. */
  prefer(order: readonly number[]): void;
  /** Returns its first state after one of another region; null before its ring 0 is loaded. */
  offer(region: number, from: MorphState): MorphState | null;
  /** Whether all rings are loaded. */
  isComplete(region: number): boolean;
  /** Whether its maps are coarse and finer ones are to come. */
  isCoarse(region: number): boolean;
  /** Shows it from now on, in a state as similar as possible to the state `from` of another region. */
  enter(region: number, from: MorphState): void;
  /** Stops showing it. */
  leave(region: number): void;
  /** Radius and strength of its picture; null while it cannot be shown. */
  grown(region: number): MorphState | null;
}

/** Current picture of a journey. */
export interface Leg {
  readonly region: number;
  /** Picture that fades out below the region's, whose opacity is `share`; with its pose if the user was moved. */
  readonly leaving: { readonly region: number; readonly pose: Pose | null; readonly share: number } | null;
}

export type Journey = ReturnType<typeof createJourney>;

/** Creates a journey; `onMove` is called when the user was moved to another place. */
export function createJourney(
  settings: Pick<World, 'places' | 'marginShare' | 'fade'> & { readonly onMove: (pose: Pose) => void },
  regions: Regions,
  first: number,
) {
  let current = first;
  let ahead: number | null = null;
  let leaving: { region: number; pose: Pose | null; since: number } | null = null;
  let jump: { region: number; target: Pose } | null = null;
  let user: Pose | null = null;
  let openRegions: readonly number[] = [first];

  const { places } = settings;

  /** Area without folds for a state of a region: its whole margin while nothing is near yet. */
  function limitOf(region: number, grown: MorphState | null): Limit {
    const { center, fold_margin } = places.of(region);
    return { center, metres: grown && grown.strength > 0 ? settings.marginShare * grown.radius : fold_margin };
  }

  function marginAt(limit: Limit, place: Vector): number {
    return limit.metres - distance(place, limit);
  }

  const distanceTo = (region: number, place: Vector): number => distanceBetween(places.of(region).center, place);

  /** Returns the state in which a region would begin now; null if it cannot take over. */
  function offerOf(region: number): MorphState | null {
    const from = regions.grown(current);
    const offer = from && regions.offer(region, from);
    // Visible geometry does not become part of a map again.
    if (!from || !offer || (from.strength > 0 && offer.strength === 0)) return null;
    return offer;
  }

  /** Whether a region takes over. */
  function mayCross(next: number, place: Vector): boolean {
    const [from, offer] = [regions.grown(current), offerOf(next)];
    if (!from || !offer) return false;
    const gap = Math.min(GAP_SHARE * distanceTo(next, places.of(current).center), GAP_MAX);
    const [currentLimit, nextLimit] = [limitOf(current, from), limitOf(next, offer)];
    const isNearer = distanceTo(next, place) + gap <= distanceTo(current, place);
    const isAsLarge = offer.radius >= from.radius && !regions.isCoarse(next);
    const isAlike = from.strength === 0 || isAsLarge || regions.isComplete(next);
    if (isNearer && isAlike && marginAt(nextLimit, place) >= MIN_MARGIN_SHARE * nextLimit.metres) return true;
    // At its edge the picture is replaced even by one that is less similar.
    const isAtEdge = marginAt(currentLimit, place) < (1 - FREE_SHARE) * currentLimit.metres;
    return isAtEdge && marginAt(nextLimit, place) >= Math.max(marginAt(currentLimit, place), 0) + gap;
  }

  function takeOver(region: number, from: MorphState, pose: Pose | null): void {
    leaving = { region: current, pose, since: 0 };
    if (region !== current) {
      regions.enter(region, from);
      current = region;
    }
  }

  /** Moves the user if the region of the place can be shown. */
  function depart(pose: Pose): void {
    if (!jump) return;
    const { region, target } = jump;
    const from = regions.grown(current);
    const isHere = region === current;
    const offer = isHere ? from : regions.offer(region, from ?? NOTHING_NEAR);
    if (!offer) return;
    // Its picture must leave the user room; otherwise it begins with nothing near.
    const limit = limitOf(region, offer);
    const fits = isHere || marginAt(limit, target.position) > (1 - FREE_SHARE) * limit.metres;
    const { center, metres } = limitOf(region, fits ? offer : NOTHING_NEAR);
    jump = null;
    takeOver(region, fits && from ? from : NOTHING_NEAR, from ? pose : null);
    if (!from) leaving = null;
    user = { ...target, position: clampToLimit(target.position, { center, metres: LANDING_SHARE * metres }) };
    settings.onMove(user);
  }

  /** Closes unneeded regions and loads needed ones, first the region of the user's current or future position. */
  function arrange(place: Vector): void {
    const goal = jump?.region ?? null;
    // At most two regions are open during a cross-fade.
    const limit = limitOf(current, regions.grown(current));
    if (leaving) ahead = leaving.region === current ? null : leaving.region;
    else ahead = goal === null ? places.ahead({ place, current, ahead, limit }) : null;
    const secondRegion = leaving ? ahead : (goal ?? ahead);
    const order = [...new Set([current, secondRegion ?? current])];
    const isAwaited = goal !== null && !leaving;
    const isNearer = secondRegion !== null && distanceTo(secondRegion, place) < distanceTo(current, place);
    if (isNearer || (secondRegion !== null && isAwaited)) order.reverse();
    for (const region of openRegions) if (!order.includes(region)) regions.close(region);
    for (const region of order) regions.open(region);
    openRegions = order;
    regions.prefer(order);
  }

  regions.open(first);
  regions.enter(first, NOTHING_NEAR);

  return {
    /** Advances by some seconds with the user's pose. */
    advance(seconds: number, pose: Pose): Leg {
      user = pose;
      if (leaving) {
        leaving.since += seconds;
        if (leaving.since >= settings.fade) {
          if (leaving.region !== current) regions.leave(leaving.region);
          leaving = null;
        }
      }
      if (!leaving) depart(pose);
      arrange(user.position);
      if (!leaving && !jump && ahead !== null && mayCross(ahead, user.position)) {
        takeOver(ahead, regions.grown(current) ?? NOTHING_NEAR, null);
        arrange(user.position);
      }
      const share = leaving && settings.fade > 0 ? leaving.since / settings.fade : 1;
      return { region: current, leaving: leaving && { region: leaving.region, pose: leaving.pose, share } };
    },
    /** Moves to another place when its region can be shown. */
    go(target: Pose): void {
      const region = places.nearest(target.position);
      const currentLimit = limitOf(current, regions.grown(current));
      // Near the centre the current region serves at once; a nearer one takes over later.
      const isHere = marginAt(currentLimit, target.position) >= HERE_SHARE * currentLimit.metres;
      jump = { region: isHere ? current : region, target };
    },
    /** Stops waiting for a region whose loading has failed. */
    failed(region: number): void {
      if (jump?.region === region && region !== current && regions.offer(region, NOTHING_NEAR) === null) jump = null;
    },
    /** Area where the user may be. */
    get bounds(): Bounds {
      const here = limitOf(current, regions.grown(current));
      // A picture that fades out with its own pose does not limit the user.
      const hard = leaving && !leaving.pose ? [here, limitOf(leaving.region, regions.grown(leaving.region))] : [here];
      const offer = !leaving && ahead !== null ? offerOf(ahead) : null;
      return { hard, soft: offer && ahead !== null ? [here, limitOf(ahead, offer)] : [here] };
    },
    get region(): number {
      return current;
    },
    /** Region that the user is moving to; null for none. */
    get goal(): number | null {
      return jump?.region ?? null;
    },
    /** Least radius of the region's morph that does not fold at the user's position. */
    get minRadius(): number {
      const { center, fold_margin } = places.of(current);
      const distanceToCenter = user ? distance(user.position, { center, metres: fold_margin }) : 0;
      return (ROUNDING_FACTOR * Math.min(distanceToCenter + MARGIN_METRES, fold_margin)) / settings.marginShare;
    },
  };
}
