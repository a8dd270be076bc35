/** The user's body in each frame, with its pointer. */
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import type { Viewer } from '../show/viewer';
import type { HandRay } from '../xr/hands';
import type { Activity } from './activity';
import { NOTHING_HIT, targetAt } from './aim';
import type { Hold } from './hold';
import { atScreen, inHeadset } from './own';
import type { Body } from './pose';
import { createSeldom } from './seldom';

/** Seconds between two updates of the pointer's target: each waits for the GPU. */
const EVERY = 1 / 36;

/** Creates the function; `hands` are null outside the headset, `nearShare` is r1 as a share of r2. */
export function createPointing(
  viewer: Viewer,
  nearShare: number,
  hold: Hold,
  hands: () => readonly HandRay[] | null,
  activity: () => Activity | null,
): (pose: Pose, now: number) => Body {
  const [targets, lengths] = [createSeldom<Vector>(EVERY), createSeldom<number>(EVERY)];

  function targetOf(pose: Pose, now: number): Vector | null {
    const { place } = hold;
    if (place) return targets.at(now, () => activity()?.targetAt(pose, place) ?? targetAt(viewer, nearShare, pose, place));
    targets.forget();
    return null;
  }

  return (pose, now) => {
    const found = hands();
    hold.isAlways = activity()?.isPointing ?? false;
    if (!hold.isAlways && !found?.some(({ isPointing }) => isPointing)) lengths.forget();
    if (!found) return atScreen(pose, targetOf(pose, now));
    return inHeadset(pose, found, hold.isAlways, ({ origin, direction }) =>
      lengths.at(now, () => viewer.along(origin, direction) ?? NOTHING_HIT),
    );
  };
}
