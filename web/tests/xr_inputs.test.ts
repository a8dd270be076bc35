import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NO_MOTION } from '../src/control/drive';
import { createSteering, SNAP } from '../src/xr/inputs';

const still = { x: 0, y: 0, isPressed: false };

test('the left stick walks and runs', () => {
  const steer = createSteering();
  assert.deepEqual(steer(still, still), { drive: NO_MOTION, turn: 0 });
  const { drive } = steer({ x: 1, y: 0, isPressed: true }, still);
  assert.deepEqual(drive, { ...NO_MOTION, right: 1, isRunning: true });
  assert.equal(steer({ ...still, y: -1 }, still).drive.ahead, 1);
  // An old stick may not return to 0.
  assert.deepEqual(steer({ ...still, x: 0.1, y: -0.1 }, still).drive, NO_MOTION);
});

test('the right stick turns once per push', () => {
  const steer = createSteering();
  const turns = [0.2, 0.8, 1, 0.5, 0.9, 0.1, 1, 0, -1].map((x) => steer(still, { ...still, x }).turn);
  assert.deepEqual(turns, [0, -SNAP, 0, 0, 0, 0, -SNAP, 0, SNAP]);
});

test('a single stick walks and turns', () => {
  for (const isLeft of [true, false]) {
    const steer = createSteering();
    const read = (stick: typeof still) => (isLeft ? steer(stick, null) : steer(null, stick));
    assert.deepEqual(read({ x: 1, y: 0, isPressed: false }), { drive: NO_MOTION, turn: -SNAP });
    assert.equal(read({ x: 0, y: -1, isPressed: false }).drive.ahead, 1);
  }
  assert.deepEqual(createSteering()(null, null), { drive: NO_MOTION, turn: 0 });
});
