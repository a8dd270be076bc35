import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NO_MOTION } from '../src/control/drive';
import type { Bounds } from '../src/control/limit';
import { createOrbit } from '../src/control/orbit';
import { ahead, type Pose } from '../src/control/pose';
import { createWalk } from '../src/control/walk';
import { assertNear } from './support/near';

const START: Pose = { position: [0, 1.7, 0], yaw: 0, pitch: 0 };
const LIMIT = { center: [0, 0, 0], metres: 5 } as const;
const BOUNDS: Bounds = { soft: [LIMIT], hard: [LIMIT] };
const isSmooth = (): boolean => false;
const isSudden = (): boolean => true;

function poseAfterWalk(drive: object, seconds: number, rate: number, suddenness = isSmooth, bounds: Bounds | null = null): Pose {
  const walk = createWalk(START, () => bounds, suddenness);
  for (let frame = 0; frame < seconds * rate; frame++) walk.update(1 / rate, { ...NO_MOTION, ...drive });
  return walk.pose;
}

function distanceBetween(a: Pose, b: Pose): number {
  return Math.hypot(...a.position.map((value, axis) => value - (b.position[axis] ?? 0)));
}

test('speeds are metres per second', () => {
  assertNear(poseAfterWalk({ ahead: 1 }, 10, 60, isSudden).position, [0, 1.7, -16]);
  assertNear(poseAfterWalk({ right: 1 }, 10, 60, isSudden).position, [16, 1.7, 0]);
  assertNear(poseAfterWalk({ ahead: 1, isRunning: true }, 10, 60, isSudden).position, [0, 1.7, -48]);
  assert.ok(Math.abs(poseAfterWalk({ turn: 1 }, 10, 60).yaw - 14) < 1e-9);
});

test('a user walks where the view looks, at the same height', () => {
  const walk = createWalk({ position: [1, 1.7, 2], yaw: 0.7, pitch: 1.2 }, () => null, isSudden);
  walk.update(1, { ...NO_MOTION, ahead: 1 });
  const [x, , z] = ahead({ yaw: 0.7, pitch: 0 });
  assertNear(walk.pose.position, [1 + 1.6 * x, 1.7, 2 + 1.6 * z]);
});

test('walking does not depend on the frame rate', () => {
  for (const drive of [{ ahead: 1 }, { right: -0.4, ahead: 0.2, isRunning: true }]) {
    const exact = poseAfterWalk(drive, 2, 1);
    for (const rate of [4, 30, 72, 144]) assert.ok(distanceBetween(poseAfterWalk(drive, 2, rate), exact) < 1e-9);
  }
  const curve = poseAfterWalk({ ahead: 1, turn: 1, isRunning: true }, 2, 1);
  for (const rate of [4, 30, 72, 144, 1000]) {
    const found = poseAfterWalk({ ahead: 1, turn: 1, isRunning: true }, 2, rate);
    assert.ok(distanceBetween(found, curve) < 0.001, `${rate}: ${distanceBetween(found, curve)}`);
    assert.ok(Math.abs(found.yaw - curve.yaw) < 1e-9);
  }
  const edge = poseAfterWalk({ ahead: 1, isRunning: true }, 4, 1, isSmooth, BOUNDS);
  for (const rate of [4, 30, 144]) {
    assert.ok(distanceBetween(poseAfterWalk({ ahead: 1, isRunning: true }, 4, rate, isSmooth, BOUNDS), edge) < 1e-6);
  }
});

test('users stay within the limit, also when they walk along it', () => {
  for (const drive of [{ ahead: 1, isRunning: true }, { ahead: 1, right: 1, turn: 0.3, isRunning: true }]) {
    const { position } = poseAfterWalk(drive, 60, 30, isSmooth, BOUNDS);
    assert.ok(Math.hypot(position[0], position[2]) <= 5 + 1e-9);
  }
});

test('the view stops before it turns over', () => {
  assert.equal(poseAfterWalk({ look: 1 }, 10, 60).pitch, 1.5);
  assert.equal(poseAfterWalk({ look: -1 }, 10, 60).pitch, -1.5);
  const walk = createWalk(START, () => null, isSmooth);
  walk.look(0.5, 9);
  assert.deepEqual([walk.pose.yaw, walk.pose.pitch], [0.5, 1.5]);
});

test('after orbiting the eye returns to its height without a jump, or at once on request', () => {
  const high: Pose = { position: [0, 21.7, 0], yaw: 0, pitch: 0 };
  const walk = createWalk(START, () => null, isSmooth);
  walk.resume(high);
  assert.equal(walk.pose.position[1], 21.7);
  walk.update(1 / 60, NO_MOTION);
  assert.ok(walk.pose.position[1] > 20 && walk.pose.position[1] < 21.7);
  walk.update(5, NO_MOTION);
  assert.ok(Math.abs(walk.pose.position[1] - 1.7) < 1e-6);
  const sudden = createWalk(START, () => null, isSudden);
  sudden.resume(high);
  sudden.update(1 / 60, NO_MOTION);
  assert.equal(sudden.pose.position[1], 1.7);
  sudden.setPose(high);
  sudden.update(1, NO_MOTION);
  assert.equal(sudden.pose.position[1], 21.7);
});

/** Point ahead of a pose at a distance, metres. */
function pointAhead({ position, yaw, pitch }: Pose, distance: number): number[] {
  return ahead({ yaw, pitch }).map((value, axis) => value * distance + (position[axis] ?? 0));
}

test('an orbit keeps its point in the middle of the picture and its distance', () => {
  const orbit = createOrbit({ position: [3, 2, 1], yaw: 0.4, pitch: -0.2 }, () => null);
  const point = pointAhead(orbit.pose, 4);
  orbit.rotate(0.9, 0.3);
  orbit.update(0.7, { ...NO_MOTION, turn: 1, look: -0.4 });
  assertNear(pointAhead(orbit.pose, 4), point);
  orbit.zoom(2);
  assertNear(pointAhead(orbit.pose, 8), point);
  orbit.zoom(1e-9);
  assertNear(pointAhead(orbit.pose, 0.3), point);
  for (const wrong of [0, -1, Number.NaN]) orbit.zoom(wrong);
  assert.ok(orbit.pose.position.every(Number.isFinite));
});

test('an orbit pans in the picture', () => {
  const orbit = createOrbit({ position: [0, 0, 0], yaw: 0, pitch: 0 }, () => null);
  orbit.pan(0.5, 0.25);
  assertNear(orbit.pose.position, [2, 1, 0]);
});

test('an orbit does not depend on the frame rate', () => {
  const end = (rate: number): Pose => {
    const orbit = createOrbit(START, () => null);
    for (let frame = 0; frame < 2 * rate; frame++) orbit.update(1 / rate, { ...NO_MOTION, ahead: -0.5, turn: 0.6 });
    return orbit.pose;
  };
  for (const rate of [4, 30, 144]) assert.ok(distanceBetween(end(rate), end(1)) < 1e-9);
});

test('an orbit stays within the limit for all inputs', () => {
  const orbit = createOrbit(START, () => BOUNDS);
  const acts = [
    () => orbit.zoom(3),
    () => orbit.rotate(1.3, -0.2),
    () => orbit.pan(0.8, -0.3),
    () => orbit.update(0.3, { ...NO_MOTION, right: 1, ahead: -1 }),
    () => orbit.update(0.3, { ...NO_MOTION, right: -1, ahead: 1, isRunning: true }),
  ];
  for (let number = 0; number < 500; number++) {
    acts[(number * 7 + (number >> 2)) % acts.length]?.();
    const { position, yaw, pitch } = orbit.pose;
    assert.ok([...position, yaw].every(Number.isFinite) && Math.abs(pitch) <= 1.5);
    assert.ok(Math.hypot(position[0], position[2]) <= 5 + 1e-9, `${number}`);
  }
});
