import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isPointing } from '../src/xr/hands';
import type { Joints } from '../src/xr/inputs';

/** Returns the joints of a hand whose index, middle, ring and little finger bend by these radians at each joint. */
function createHand(...bends: readonly [number, number, number, number]): Joints {
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

test('a hand points if only its index finger is straight', () => {
  assert.equal(isPointing(createHand(STRAIGHT, FIST, FIST, FIST), false), true);
  assert.equal(isPointing(createHand(STRAIGHT, STRAIGHT, STRAIGHT, STRAIGHT), false), false);
  assert.equal(isPointing(createHand(FIST, FIST, FIST, FIST), true), false);
  // In a pinch, the index finger bends to the thumb.
  assert.equal(isPointing(createHand(BENT, STRAIGHT, STRAIGHT, STRAIGHT), true), false);
  assert.equal(isPointing(createHand(STRAIGHT, FIST, FIST, STRAIGHT), true), false);
});

test('a hand continues to point while its fingers are less straight than at the beginning', () => {
  const between = createHand(0.6, 1.0, 1.0, 1.0);
  assert.equal(isPointing(between, false), false);
  assert.equal(isPointing(between, true), true);
});

test('a hand without joints, or with all joints in one place, does not point', () => {
  assert.equal(isPointing(null, true), false);
  assert.equal(isPointing({ matrices: new Float32Array(400), radii: new Float32Array(25) }, true), false);
});
