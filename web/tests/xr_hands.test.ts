import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isPointing } from '../src/xr/hands';
import type { Joints } from '../src/xr/inputs';

/** Joints of a hand whose index, middle, ring and little finger bend by so many radians at each joint. */
function hand(...bends: readonly [number, number, number, number]): Joints {
  const matrices = new Float32Array(16 * 25);
  bends.forEach((bend, finger) => {
    let [x, y, angle] = [0, 0, 0];
    for (let joint = 6 + 5 * finger; joint < 10 + 5 * finger; joint++) {
      matrices.set([0.02 * finger, y, -x], 16 * joint + 12);
      [x, y, angle] = [x + 0.03 * Math.cos(angle), y - 0.03 * Math.sin(angle), angle + bend];
    }
  });
  return { matrices, radii: new Float32Array(25).fill(0.01) };
}

const [STRAIGHT, BENT, FIST] = [0.1, 0.9, 1.4] as const;

test('a hand points with its index finger alone', () => {
  assert.equal(isPointing(hand(STRAIGHT, FIST, FIST, FIST), false), true);
  assert.equal(isPointing(hand(STRAIGHT, STRAIGHT, STRAIGHT, STRAIGHT), false), false);
  assert.equal(isPointing(hand(FIST, FIST, FIST, FIST), true), false);
  // A pinch: the index finger bends to the thumb.
  assert.equal(isPointing(hand(BENT, STRAIGHT, STRAIGHT, STRAIGHT), true), false);
  assert.equal(isPointing(hand(STRAIGHT, FIST, FIST, STRAIGHT), true), false);
});

test('pointing continues while fingers tremble', () => {
  const between = hand(0.6, 1.0, 1.0, 1.0);
  assert.equal(isPointing(between, false), false);
  assert.equal(isPointing(between, true), true);
});

test('a hand without joints, or with all joints in one place, does not point', () => {
  assert.equal(isPointing(null, true), false);
  assert.equal(isPointing({ matrices: new Float32Array(400), radii: new Float32Array(25) }, true), false);
});
