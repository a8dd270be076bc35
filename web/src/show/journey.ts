/**
 * Decides which region is shown while the user walks or jumps to another place, and which one is preloaded. A region
 * replaces another one by a cross-fade, at a place where neither picture folds. Until then the user stays in the area
 * where the current picture does not fold.
 */
import { type Bounds, clampToLimit, distance, FREE_SHARE, type Limit } from '../control/limit';
import type { Pose, Vector } from '../control/pose';
import { type MorphState, NOTHING_NEAR } from './stage';
import { distanceBetween, type World } from './world';

/** A region takes over if its centre is nearer by this share of the distance between both centres (hysteresis). */
const GAP_SHARE = 0.1;
/** Greatest difference of the distances that a region needs to take over, metres. */
const GAP_MAX = 2;
/** A nearer region takes over only if the user has this share of its limit left, and so does not leave it at once. */
const MIN_MARGIN_SHARE = 0.3;
/** Metres by which a picture must stay free of folds beyond the user's position. */
const MARGIN_METRES = 0.5;
/** Tolerance for rounding, so that the radius of the last ring is always large enough. */
const ROUNDING_FACTOR = 1 - 1e-9;
/** A jump ends within this share of the limit. */
const LANDING_SHARE = 0.9;
/** The user jumps within the current region if the target has this share of the region's limit left. */
const HERE_SHARE = 0.5;

/** Regions, as a journey uses them. */
export interface Regions {
  /** Begins to load a region, unless it is open. */
  open(region: number): void;
  close(region: number): void;
  /** Sets the order of loading; later regions wait for earlier ones. */
  prefer(order: readonly number[]): void;
  /** Returns the state in which a region would begin after another region's state `from`; null before its ring 0. */
  offer(region: number, from: MorphState): MorphState | null;
  /** Whether all rings are loaded. */
  isComplete(region: number): boolean;
  /** Whether the maps of a region are coarse, and the server still refines them. */
  isCoarse(region: number): boolean;
  /** Shows a region, in a state as similar as possible to the state `from` of another region. */
  enter(region: number, from: MorphState): void;
  /** Hides a region. */
  leave(region: number): void;
  /** Returns the radius and the strength of a region's picture; null while there is no picture. */
  morphState(region: number): MorphState | null;
}

/** Current picture of a journey. */
export interface Leg {
  readonly region: number;
  /**
   * Region whose picture lies below that of `region`, which fades in with the opacity `share`. After a jump, the
   * picture below is drawn from `pose`.
   */
  readonly leaving: { readonly region: number; readonly pose: Pose | null; readonly share: number } | null;
}

export type Journey = ReturnType<typeof createJourney>;

/** Creates a journey that begins in the region `first`; calls `onMove` when a jump moves the user. */
export function createJourney(
  settings: Pick<World, 'places' | 'marginShare' | 'fade'> & { readonly onMove: (pose: Pose) => void },
  regions: Regions,
  first: number,
) {
  let current = first;
  let preloaded: number | null = null;
  let leaving: { region: number; pose: Pose | null; since: number } | null = null;
  let jump: { region: number; target: Pose } | null = null;
  let user: Pose | null = null;
  let openRegions: readonly number[] = [first];

  const { places } = settings;

  /** Returns the area where a region's picture in a state does not fold: its whole margin before the morph begins. */
  function limitOf(region: number, state: MorphState | null): Limit {
    const { center, fold_margin } = places.spotOf(region);
    return { center, metres: state && state.strength > 0 ? settings.marginShare * state.radius : fold_margin };
  }

  function marginAt(limit: Limit, place: Vector): number {
    return limit.metres - distance(place, limit);
  }

  const distanceTo = (region: number, place: Vector): number => distanceBetween(places.spotOf(region).center, place);

  /** Returns the state in which a region would begin if it took over now; null if it cannot. */
  function offerOf(region: number): MorphState | null {
    const from = regions.morphState(current);
    const offer = from && regions.offer(region, from);
    // Near geometry that the user sees does not disappear into a map again.
    if (!from || !offer || (from.strength > 0 && offer.strength === 0)) return null;
    return offer;
  }

  /** Whether a region takes over from the current one at a place. */
  function takesOver(next: number, place: Vector): boolean {
    const [from, offer] = [regions.morphState(current), offerOf(next)];
    if (!from || !offer) return false;
    const gap = Math.min(GAP_SHARE * distanceTo(next, places.spotOf(current).center), GAP_MAX);
    const [currentLimit, nextLimit] = [limitOf(current, from), limitOf(next, offer)];
    const isNearer = distanceTo(next, place) + gap <= distanceTo(current, place);
    const isAsLarge = offer.radius >= from.radius && !regions.isCoarse(next);
    const isAlike = from.strength === 0 || isAsLarge || regions.isComplete(next);
    if (isNearer && isAlike && marginAt(nextLimit, place) >= MIN_MARGIN_SHARE * nextLimit.metres) return true;
    // At the edge of the current region, even a picture that looks different takes over.
    const isAtEdge = marginAt(currentLimit, place) < (1 - FREE_SHARE) * currentLimit.metres;
    return isAtEdge && marginAt(nextLimit, place) >= Math.max(marginAt(currentLimit, place), 0) + gap;
  }

  function beginFade(region: number, from: MorphState, pose: Pose | null): void {
    leaving = { region: current, pose, since: 0 };
    if (region !== current) {
      regions.enter(region, from);
      current = region;
    }
  }

  /** Moves the user to the target of a jump if the region of the target can be shown; `pose` is the user's pose. */
  function tryJump(pose: Pose): void {
    if (!jump) return;
    const { region, target } = jump;
    const from = regions.morphState(current);
    const isHere = region === current;
    const offer = isHere ? from : regions.offer(region, from ?? NOTHING_NEAR);
    if (!offer) return;
    // If the picture would leave the user no room, the region begins without near geometry.
    const limit = limitOf(region, offer);
    const fits = isHere || marginAt(limit, target.position) > (1 - FREE_SHARE) * limit.metres;
    const { center, metres } = limitOf(region, fits ? offer : NOTHING_NEAR);
    jump = null;
    beginFade(region, fits && from ? from : NOTHING_NEAR, from ? pose : null);
    if (!from) leaving = null;
    user = { ...target, position: clampToLimit(target.position, { center, metres: LANDING_SHARE * metres }) };
    settings.onMove(user);
  }

  /** Opens the regions that the user needs, in the order of loading, and closes all others. */
  function updateRegions(place: Vector): void {
    const goal = jump?.region ?? null;
    // At most two regions are open during a cross-fade.
    const limit = limitOf(current, regions.morphState(current));
    if (leaving) preloaded = leaving.region === current ? null : leaving.region;
    else preloaded = goal === null ? places.regionToPreload({ place, current, preloaded, limit }) : null;
    const secondRegion = leaving ? preloaded : (goal ?? preloaded);
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
      if (!leaving) tryJump(pose);
      updateRegions(user.position);
      if (!leaving && !jump && preloaded !== null && takesOver(preloaded, user.position)) {
        beginFade(preloaded, regions.morphState(current) ?? NOTHING_NEAR, null);
        updateRegions(user.position);
      }
      const share = leaving && settings.fade > 0 ? leaving.since / settings.fade : 1;
      return { region: current, leaving: leaving && { region: leaving.region, pose: leaving.pose, share } };
    },
    /** Moves the user to another place as soon as its region can be shown. */
    go(target: Pose): void {
      const region = places.nearest(target.position);
      const currentLimit = limitOf(current, regions.morphState(current));
      // Near its centre, the current region can be shown at once; a nearer region takes over later.
      const isHere = marginAt(currentLimit, target.position) >= HERE_SHARE * currentLimit.metres;
      jump = { region: isHere ? current : region, target };
    },
    /** Cancels the jump to a region that cannot be loaded. */
    abandon(region: number): void {
      if (jump?.region === region && region !== current && regions.offer(region, NOTHING_NEAR) === null) jump = null;
    },
    /** Area where the user may be. */
    get bounds(): Bounds {
      const stateOf = regions.morphState;
      const here = limitOf(current, stateOf(current));
      // A picture that fades out with its own pose does not limit the user.
      const hard = leaving && !leaving.pose ? [here, limitOf(leaving.region, stateOf(leaving.region))] : [here];
      const offer = !leaving && preloaded !== null ? offerOf(preloaded) : null;
      return { hard, soft: offer && preloaded !== null ? [here, limitOf(preloaded, offer)] : [here] };
    },
    get region(): number {
      return current;
    },
    /** Region that the user jumps to; null for none. */
    get goal(): number | null {
      return jump?.region ?? null;
    },
    /** Least radius with which the current region's picture does not fold at the user's position. */
    get minRadius(): number {
      const { center, fold_margin } = places.spotOf(current);
      const distanceToCenter = user ? distance(user.position, { center, metres: fold_margin }) : 0;
      return (ROUNDING_FACTOR * Math.min(distanceToCenter + MARGIN_METRES, fold_margin)) / settings.marginShare;
    },
  };
}
