import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  clampToBounds,
  destinationOf,
  directionTo,
  EYE_OFFSET,
  floorUnder,
  type Head,
  headBounds,
  headOf,
  localOf,
  moveFloor,
  turnFloor,
  worldOf,
  worldPose,
} from '../src/control/floor';
import type { Vector } from '../src/control/pose';
import { assertNear } from './support/near';

const HEAD: Head = { position: [0.4, 1.5, -0.3], yaw: 0.7, pitch: -0.2 };
const FLOOR = { position: [10, 3, -20], yaw: 1.1 } as const;

/** Column-major matrix of a head after a yaw, a pitch upwards and a roll to the left. */
function matrixOf(yaw: number, pitch: number, roll: number): number[] {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const [right, up]: [Vector, Vector] = [[cy, 0, -sy], [sy * sp, cp, cy * sp]];
  const [c, s] = [Math.cos(roll), Math.sin(roll)];
  const combine = (a: Vector, b: Vector, p: number, q: number): number[] => a.map((value, i) => p * value + q * (b[i] ?? 0));
  const back = [sy * cp, -sp, cy * cp];
  return [...combine(right, up, c, s), 0, ...combine(up, right, c, -s), 0, ...back, 0, 1, 2, 3, 1];
}

test('conversions of points between headset and world are inverse', () => {
  assertNear(worldOf({ position: [1, 2, 3], yaw: Math.PI / 2 }, [0, 0, -1]), [0, 2, 3]);
  assertNear(localOf(FLOOR, worldOf(FLOOR, [1.5, 0.2, -4])), [1.5, 0.2, -4]);
});

test('the head begins above the ground point, with the yaw of the page', () => {
  const floor = floorUnder([5, 0, 6], 2.5, HEAD);
  const { position, yaw, pitch } = worldPose(floor, HEAD);
  assertNear([...position, yaw, pitch], [5, 1.5, 6, 2.5, -0.2]);
});

test('turns rotate about the head', () => {
  const before = worldPose(FLOOR, HEAD);
  const after = worldPose(turnFloor(FLOOR, HEAD, 0.5), HEAD);
  assertNear(after.position, before.position);
  assertNear([after.yaw - before.yaw], [0.5]);
});

test('moves place the head above a point, at its height', () => {
  assertNear(worldPose(moveFloor(FLOOR, HEAD, [-1, 99, 2]), HEAD).position, [-1, 4.5, 2]);
});

test('both eyes stay within the limits', () => {
  const limit = { center: [1, 0, 1], metres: 4 } as const;
  const bounds = headBounds({ soft: [limit], hard: [limit] });
  assertNear(clampToBounds([2, 7, 3], bounds), [2, 7, 3]);
  assertNear(clampToBounds([1, 7, 101], bounds), [1, 7, 5 - EYE_OFFSET]);
  assertNear(clampToBounds([1, 7, 101], null), [1, 7, 101]);
  assertNear(clampToBounds([3, 7, 1], headBounds({ soft: [], hard: [{ ...limit, metres: 0 }] })), [1, 7, 1]);
  // While one region replaces another, the limits of both count.
  const bothRegions = { soft: [], hard: [limit, { center: [6, 0, 1], metres: 2 }] } as const;
  for (const point of [[0, 7, 0], [9, 7, 9], [4.5, 7, 1]] as const) {
    const [x, y, z] = clampToBounds(point, bothRegions);
    assert.ok(Math.hypot(x - 1, z - 1) < 4 + 0.05 && Math.hypot(x - 6, z - 1) < 2 + 0.05);
    assert.equal(y, 7);
  }
  assertNear(clampToBounds([4.5, 7, 1], bothRegions), [4.5, 7, 1]);
});

test('yaw and pitch of a head do not depend on its roll', () => {
  for (const [yaw, pitch, roll] of [[0, 0, 0], [2, 1, 0.4], [-3, -1.2, -1], [0.3, 1.5, 0.01]] as const) {
    const { position, ...angles } = headOf(matrixOf(yaw, pitch, roll));
    assert.deepEqual(position, [1, 2, 3]);
    assertNear([angles.yaw, angles.pitch], [yaw, pitch]);
  }
});

test('a head that looks straight up or down keeps its yaw', () => {
  for (const pitch of [Math.PI / 2, -Math.PI / 2, 1.56, -1.56]) assertNear([headOf(matrixOf(0.8, pitch, 0)).yaw], [0.8], 1e-9);
});

const EYE: Vector = [1, 1.7, 2];
test('a direction is computed from a place in the picture', () => {
  const pose = { position: EYE, yaw: 0, pitch: 0 };
  assertNear(directionTo(pose, [0.5, 0.5], { fov: 90, aspect: 1.5 }), [0, 0, -1]);
  assertNear(directionTo(pose, [1, 0.5], { fov: 90, aspect: 1 }), [Math.SQRT1_2, 0, -Math.SQRT1_2]);
  assertNear(directionTo(pose, [0.5, 0], { fov: 90, aspect: 1.5 }), [0, Math.SQRT1_2, -Math.SQRT1_2]);
  assertNear(directionTo({ ...pose, yaw: Math.PI / 2 }, [0, 0.5], { fov: 90, aspect: 1 }), [-Math.SQRT1_2, 0, Math.SQRT1_2]);
  assertNear(directionTo({ ...pose, pitch: 0.3 }, [0.5, 0.5], { fov: 90, aspect: 1 }), [0, Math.sin(0.3), -Math.cos(0.3)]);
});

test('destinations are on the ground, or in front of other surfaces', () => {
  assertNear(destinationOf(EYE, [0, -0.5, -Math.sqrt(0.75)], [1, 0.1, -3]), [1, 1.7, -3]);
  assertNear(destinationOf(EYE, [0, 0, -1], [1, 1.7, -6]), [1, 1.7, -5]);
  // A surface nearer than this distance does not move the user.
  assertNear(destinationOf(EYE, [0, 0, -1], [1, 1.7, 1.5]), EYE);
});

test('without a surface, directions below the horizon lead to assumed ground, others ahead', () => {
  const down = Math.SQRT1_2;
  assertNear(destinationOf(EYE, [0, -down, -down], null), [1, 1.7, 0.3]);
  assertNear(destinationOf(EYE, [1, 0, 0], null), [16, 1.7, 2]);
  assertNear(destinationOf(EYE, [0, 1, 0], null), EYE);
});
