/** The body that the user shows to others. */
import type { Pose } from '../control/pose';
import { ahead, minus, moved, rightOf, type Vector } from '../control/vector';
import type { HandRay } from '../xr/hands';
import { type Body, FARTHEST, type Placed } from './pose';
import { rotationAlong, rotationOf } from './rotation';

/** Metres to the right, down and ahead from the eyes of somebody at a screen to the hand that points. */
const [RIGHT, DOWN, AHEAD] = [0.22, 0.28, 0.4] as const;

/** At a screen: a head, and while the user points a right hand whose pointer ends at the target. */
export function atScreen(pose: Pose, target: Vector | null): Body {
  const head: Placed = { position: pose.position, rotation: rotationOf(pose.yaw, pose.pitch) };
  if (!target) return { head, left: null, right: null, pointer: null };
  const side = moved(pose.position, rightOf(pose.yaw), RIGHT);
  const position = moved(moved(side, ahead({ yaw: pose.yaw, pitch: 0 }), AHEAD), [0, -1, 0], DOWN);
  const way = minus(target, position);
  const right: Placed = { position, rotation: rotationAlong(way) };
  return { head, left: null, right, pointer: { begin: 'right', length: Math.min(Math.hypot(...way), FARTHEST) } };
}

/**
 * In a headset: a head, the hands that are tracked, and a pointer from the first one that points; from the right one, or
 * any, where the user always points.
 */
export function inHeadset(
  pose: Pose,
  hands: readonly HandRay[],
  isAlways: boolean,
  lengthOf: (hand: HandRay) => number,
): Body {
  const placed = (side: HandRay['side']): Placed | null => {
    const hand = hands.find((each) => each.side === side);
    return hand ? { position: hand.origin, rotation: rotationAlong(hand.direction) } : null;
  };
  const other = isAlways ? (hands.find(({ side }) => side === 'right') ?? hands[0]) : undefined;
  const pointing = hands.find((each) => each.isPointing) ?? other;
  return {
    head: { position: pose.position, rotation: rotationOf(pose.yaw, pose.pitch) },
    left: placed('left'),
    right: placed('right'),
    pointer: pointing ? { begin: pointing.side, length: Math.min(lengthOf(pointing), FARTHEST) } : null,
  };
}
