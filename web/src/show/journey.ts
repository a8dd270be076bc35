/**
 * Which region is shown as the user walks on or goes to another place, and which is loaded ahead. A region takes over
 * from another one by a cross-fade, and only where neither picture folds; until then the user stays where the picture
 * that is shown does not fold.
 */
import { type Bounds, distance, FREE, type Limit, within } from '../control/limit';
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import { type Grown, NOTHING_NEAR } from './growth';
import { apartOf, type Places } from './places';

/** How much nearer another centre must be before it takes over: a part of their distance, metres at most. */
const [GAP_SHARE, GAP_MOST] = [0.1, 2] as const;
/** Part of a region's limit that must be left before it takes over by being nearer, so that it is not left at once. */
const ROOM_SHARE = 0.3;
/** Metres beyond the user's place at which a radius that is chosen for it would fold. */
const SLACK = 0.5;
/** The last radius counts as great enough whatever its product with the near share is rounded to. */
const ROUNDED = 1 - 1e-9;
/** Part of the limit within which a place to go to is put, and within which it needs no other region. */
const [LANDING, HERE_SHARE] = [0.9, 0.5] as const;

/** The regions of a journey: its questions to them, and their answers. */
export interface Regions {
  /** Load a region, unless that was begun. */
  open(region: number): void;
  close(region: number): void;
  /** Load regions in this order; others wait. */
  prefer(order: readonly number[]): void;
  /** The first state that it would show after one of another region; null before its ring 0 is there. */
  offer(region: number, from: Grown): Grown | null;
  /** All rings are there. */
  isComplete(region: number): boolean;
  /** Its maps are coarse, and finer ones are to come. */
  isCoarse(region: number): boolean;
  /** Show it from now on, as much like a state of another region as it can. */
  enter(region: number, from: Grown): void;
  /** Show it no more. */
  leave(region: number): void;
  /** Radius and strength that it shows; null while nothing of it can be shown. */
  grown(region: number): Grown | null;
}

export interface JourneySettings {
  readonly places: Places;
  /** Of a radius of the morph: how far from the centre its picture does not fold. */
  readonly marginShare: number;
  /** Seconds of a cross-fade. */
  readonly fade: number;
  /** The user was put to another place. */
  readonly moved: (pose: Pose) => void;
}

/** The picture of a journey now. */
export interface Leg {
  readonly region: number;
  /** The picture that goes out below that of the region, which has a share; a pose of its own if the user was moved. */
  readonly leaving: { readonly region: number; readonly pose: Pose | null; readonly share: number } | null;
}

export interface Journey {
  /** Go on by some seconds with the user at a pose. */
  advance(seconds: number, user: Pose): Leg;
  /** Go to another place as soon as its region can be shown. */
  go(target: Pose): void;
  /** Loading a region has failed: nobody waits for it. */
  failed(region: number): void;
  /** Where the user may be. */
  readonly bounds: Bounds;
  readonly region: number;
  /** The region of the place that the user is about to go to; null for none. */
  readonly goal: number | null;
  /** The least radius of the region's morph that does not fold where the user is. */
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

  /** Where a state of a region does not fold: anywhere within its margin while nothing is near yet. */
  function limitOf(region: number, grown: Grown | null): Limit {
    const { center, fold_margin } = places.of(region);
    return { center, metres: grown && grown.strength > 0 ? settings.marginShare * grown.radius : fold_margin };
  }

  function room(limit: Limit, place: Vector): number {
    return limit.metres - distance(place, limit);
  }

  const far = (region: number, place: Vector): number => apartOf(places.of(region).center, place);

  /** The state that the region ahead would show now; null if it cannot take over. */
  function offered(region: number): Grown | null {
    const from = regions.grown(current);
    const offer = from && regions.offer(region, from);
    // Geometry that is shown does not go back into a map.
    if (!from || !offer || (from.strength > 0 && offer.strength === 0)) return null;
    return offer;
  }

  /** Whether the region ahead takes over. */
  function mayCross(next: number, place: Vector): boolean {
    const [from, offer] = [regions.grown(current), offered(next)];
    if (!from || !offer) return false;
    const gap = Math.min(GAP_SHARE * far(next, places.of(current).center), GAP_MOST);
    const [here, there] = [limitOf(current, from), limitOf(next, offer)];
    const isNearer = far(next, place) + gap <= far(current, place);
    const isAsLarge = offer.radius >= from.radius && !regions.isCoarse(next);
    const isAlike = from.strength === 0 || isAsLarge || regions.isComplete(next);
    if (isNearer && isAlike && room(there, place) >= ROOM_SHARE * there.metres) return true;
    // At its edge the picture is given up for one that is less like it.
    const isAtEdge = room(here, place) < (1 - FREE) * here.metres;
    return isAtEdge && room(there, place) >= Math.max(room(here, place), 0) + gap;
  }

  function take(region: number, from: Grown, pose: Pose | null): void {
    leaving = { region: current, pose, since: 0 };
    if (region !== current) {
      regions.enter(region, from);
      current = region;
    }
  }

  /** Where the user is put for a place to go to, if its region begins with a state. */
  function landing(region: number, grown: Grown, target: Pose): Pose {
    const { center, metres } = limitOf(region, grown);
    return { ...target, position: within(target.position, { center, metres: LANDING * metres }) };
  }

  /** Go, if the region of the place can be shown. */
  function depart(pose: Pose): void {
    if (!going) return;
    const { region, target } = going;
    const from = regions.grown(current);
    const isHere = region === current;
    const offer = isHere ? from : regions.offer(region, from ?? NOTHING_NEAR);
    if (!offer) return;
    // Its picture must leave the user room; else it begins with nothing near.
    const fits = isHere || room(limitOf(region, offer), target.position) > (1 - FREE) * limitOf(region, offer).metres;
    const place = landing(region, fits ? offer : NOTHING_NEAR, target);
    going = null;
    take(region, fits && from ? from : NOTHING_NEAR, from ? pose : null);
    if (!from) leaving = null;
    user = place;
    settings.moved(place);
  }

  /** Close what is needed no more, and load what is, the region where the user is or will be before others. */
  function arrange(place: Vector): void {
    const goal = going?.region ?? null;
    // While two are shown, there is no third.
    if (leaving) ahead = leaving.region === current ? null : leaving.region;
    else ahead = goal === null ? places.ahead({ place, current, ahead, limit: limitOf(current, regions.grown(current)) }) : null;
    const other = leaving ? ahead : (goal ?? ahead);
    const wanted = [...new Set([current, other ?? current])];
    const isAwaited = goal !== null && !leaving;
    if (other !== null && (isAwaited || far(other, place) < far(current, place))) wanted.reverse();
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
      // Near the centre the region that is there serves at once; a nearer one takes over later.
      const isHere = room(here, target.position) >= HERE_SHARE * here.metres;
      going = { region: isHere ? current : region, target };
    },
    failed(region) {
      if (going?.region === region && region !== current && regions.offer(region, NOTHING_NEAR) === null) going = null;
    },
    get bounds() {
      const here = limitOf(current, regions.grown(current));
      // A picture of another pose stays where it was.
      const shown = leaving && !leaving.pose ? [here, limitOf(leaving.region, regions.grown(leaving.region))] : [here];
      const offer = !leaving && ahead !== null ? offered(ahead) : null;
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
