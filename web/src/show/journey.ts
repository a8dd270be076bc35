/**
 * Choice of the region to show while the user walks or jumps to another place, and of the region to preload. A region
 * replaces another one by a cross-fade, and only where neither picture folds; until then the user is confined to the
 * area where the current picture does not fold.
 */
import { type Bounds, clampToLimit, distance, FREE, type Limit } from '../control/limit';
import type { Pose, Vector } from '../control/pose';
import { type MorphState, NOTHING_NEAR } from './stage';
import { distanceBetween, type Places } from './world';

/** Hysteresis: another centre must be nearer by this share of the centres' distance, at most this many metres. */
const [GAP_SHARE, GAP_MAX] = [0.1, 2] as const;
/** Share of its limit that a nearer region must have left to take over, so that it is not left at once. */
const ROOM_SHARE = 0.3;
/** Margin in metres beyond the user's position at which a radius may begin to fold. */
const SLACK = 0.5;
/** Tolerance for rounding, so that the last radius always counts as sufficient. */
const ROUNDED = 1 - 1e-9;
/** Share of the limit to which a landing position is clamped, and within which no other region is needed. */
const [LANDING, HERE_SHARE] = [0.9, 0.5] as const;

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
  /** Shows it from now on, in a state as similar as possible to that of another region. */
  enter(region: number, from: MorphState): void;
  /** Stops showing it. */
  leave(region: number): void;
  /** Radius and strength of its picture; null while it cannot be shown. */
  grown(region: number): MorphState | null;
}

export interface JourneySettings {
  readonly places: Places;
  /** Share of a morph's radius within which its picture does not fold. */
  readonly marginShare: number;
  /** Duration of a cross-fade, seconds. */
  readonly fade: number;
  /** Called when the user was moved to another place. */
  readonly moved: (pose: Pose) => void;
}

/** Current picture of a journey. */
export interface Leg {
  readonly region: number;
  /**
   * Picture that is fading out below that of the region, whose opacity is `share`; with a pose if the user was moved.
   */
  readonly leaving: { readonly region: number; readonly pose: Pose | null; readonly share: number } | null;
}

export interface Journey {
  /** Advances by some seconds with the user's pose. */
  advance(seconds: number, user: Pose): Leg;
  /** Moves to another place when its region can be shown. */
  go(target: Pose): void;
  /** Stops waiting for a region whose loading has failed. */
  failed(region: number): void;
  /** Area where the user may be. */
  readonly bounds: Bounds;
  readonly region: number;
  /** Region that the user is moving to; null for none. */
  readonly goal: number | null;
  /** Least radius of the region's morph that does not fold at the user's position. */
  readonly least: number;
}

export function createJourney(settings: JourneySettings, regions: Regions, first: number): Journey {
  let current = first;
  let ahead: number | null = null;
  let leaving: { region: number; pose: Pose | null; since: number } | null = null;
  let going: { region: number; target: Pose } | null = null;
  let user: Pose | null = null;
  let opened: readonly number[] = [first];

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
    const [here, there] = [limitOf(current, from), limitOf(next, offer)];
    const isNearer = distanceTo(next, place) + gap <= distanceTo(current, place);
    const isAsLarge = offer.radius >= from.radius && !regions.isCoarse(next);
    const isAlike = from.strength === 0 || isAsLarge || regions.isComplete(next);
    if (isNearer && isAlike && marginAt(there, place) >= ROOM_SHARE * there.metres) return true;
    // At its edge the picture is replaced even by one that is less similar.
    const isAtEdge = marginAt(here, place) < (1 - FREE) * here.metres;
    return isAtEdge && marginAt(there, place) >= Math.max(marginAt(here, place), 0) + gap;
  }

  function take(region: number, from: MorphState, pose: Pose | null): void {
    leaving = { region: current, pose, since: 0 };
    if (region !== current) {
      regions.enter(region, from);
      current = region;
    }
  }

  /** Returns the pose at which the user lands if the region begins with a state. */
  function landing(region: number, grown: MorphState, target: Pose): Pose {
    const { center, metres } = limitOf(region, grown);
    return { ...target, position: clampToLimit(target.position, { center, metres: LANDING * metres }) };
  }

  /** Moves the user if the region of the place can be shown. */
  function depart(pose: Pose): void {
    if (!going) return;
    const { region, target } = going;
    const from = regions.grown(current);
    const isHere = region === current;
    const offer = isHere ? from : regions.offer(region, from ?? NOTHING_NEAR);
    if (!offer) return;
    // Its picture must leave the user room; otherwise it begins with nothing near.
    const fits = isHere || marginAt(limitOf(region, offer), target.position) > (1 - FREE) * limitOf(region, offer).metres;
    const place = landing(region, fits ? offer : NOTHING_NEAR, target);
    going = null;
    take(region, fits && from ? from : NOTHING_NEAR, from ? pose : null);
    if (!from) leaving = null;
    user = place;
    settings.moved(place);
  }

  /** Closes unneeded regions and loads needed ones, first the region of the user's current or future position. */
  function arrange(place: Vector): void {
    const goal = going?.region ?? null;
    // At most two regions are open during a cross-fade.
    if (leaving) ahead = leaving.region === current ? null : leaving.region;
    else ahead = goal === null ? places.ahead({ place, current, ahead, limit: limitOf(current, regions.grown(current)) }) : null;
    const other = leaving ? ahead : (goal ?? ahead);
    const wanted = [...new Set([current, other ?? current])];
    const isAwaited = goal !== null && !leaving;
    if (other !== null && (isAwaited || distanceTo(other, place) < distanceTo(current, place))) wanted.reverse();
    for (const region of opened) {
      if (!wanted.includes(region)) regions.close(region);
    }
    for (const region of wanted) regions.open(region);
    opened = wanted;
    regions.prefer(wanted);
  }

  regions.open(first);
  regions.enter(first, NOTHING_NEAR);

  return {
    advance(seconds, pose) {
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
      if (!leaving && !going && ahead !== null && mayCross(ahead, user.position)) {
        take(ahead, regions.grown(current) ?? NOTHING_NEAR, null);
        arrange(user.position);
      }
      const share = leaving && settings.fade > 0 ? leaving.since / settings.fade : 1;
      return { region: current, leaving: leaving && { region: leaving.region, pose: leaving.pose, share } };
    },
    go(target) {
      const region = places.nearest(target.position);
      const here = limitOf(current, regions.grown(current));
      // Near the centre the current region serves at once; a nearer one takes over later.
      const isHere = marginAt(here, target.position) >= HERE_SHARE * here.metres;
      going = { region: isHere ? current : region, target };
    },
    failed(region) {
      if (going?.region === region && region !== current && regions.offer(region, NOTHING_NEAR) === null) going = null;
    },
    get bounds() {
      const here = limitOf(current, regions.grown(current));
      // A picture with its own pose stays there.
      const shown = leaving && !leaving.pose ? [here, limitOf(leaving.region, regions.grown(leaving.region))] : [here];
      const offer = !leaving && ahead !== null ? offerOf(ahead) : null;
      return { shown, open: offer && ahead !== null ? [here, limitOf(ahead, offer)] : [here] };
    },
    get region() {
      return current;
    },
    get goal() {
      return going?.region ?? null;
    },
    get least() {
      const { center, fold_margin } = places.of(current);
      const away = user ? distance(user.position, { center, metres: fold_margin }) : 0;
      return (ROUNDED * Math.min(away + SLACK, fold_margin)) / settings.marginShare;
    },
  };
}
