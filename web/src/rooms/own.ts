/** The user's body as others see it. */
import type { Pose } from '../control/pose';
import { ahead, minus, addScaled, rightOf, type Vector } from '../control/vector';
import type { HandRay } from '../xr/hands';
import { type Body, FARTHEST, type Placed } from './pose';
import { rotationAlong, rotationOf } from './rotation';

/** Metres right, down and ahead from the eyes of a user at a screen to the pointing hand. */
const [RIGHT, DOWN, AHEAD] = [0.22, 0.28, 0.4] as const;

/** Body of a user at a screen: a head, and a right hand with a pointer to the target while pointing. */
export function atScreen(pose: Pose, target: Vector | null): Body {
  const head: Placed = { position: pose.position, rotation: rotationOf(pose.yaw, pose.pitch) };
  if (!target) return { head, left: null, right: null, pointer: null };
  const side = addScaled(pose.position, rightOf(pose.yaw), RIGHT);
  const position = addScaled(addScaled(side, ahead({ yaw: pose.yaw, pitch: 0 }), AHEAD), [0, -1, 0], DOWN);
  const way = minus(target, position);
  const right: Placed = { position, rotation: rotationAlong(way) };
  return { head, left: null, right, pointer: { begin: 'right', length: Math.min(Math.hypot(...way), FARTHEST) } };
}

/**
 * Body of a user in a headset: a head, the tracked hands, and a pointer from the first pointing hand; if the user
 * always points, from the right hand or any other.
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
