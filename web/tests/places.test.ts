import assert from 'node:assert/strict';
import { test } from 'node:test';
import { directionTo, placeFor } from '../src/control/floor';
import { createTaps } from '../src/control/pointers';
import type { Vector } from '../src/control/pose';

const EYE: Vector = [1, 1.7, 2];
const near = (a: Vector, b: Vector): void =>
  a.forEach((value, axis) => assert.ok(Math.abs(value - (b[axis] ?? 0)) < 1e-9, `${a} is not ${b}`));

test('a direction is computed from a place in the picture', () => {
  const pose = { position: EYE, yaw: 0, pitch: 0 };
  near(directionTo(pose, [0.5, 0.5], { fov: 90, aspect: 1.5 }), [0, 0, -1]);
  near(directionTo(pose, [1, 0.5], { fov: 90, aspect: 1 }), [Math.SQRT1_2, 0, -Math.SQRT1_2]);
  near(directionTo(pose, [0.5, 0], { fov: 90, aspect: 1.5 }), [0, Math.SQRT1_2, -Math.SQRT1_2]);
  near(directionTo({ ...pose, yaw: Math.PI / 2 }, [0, 0.5], { fov: 90, aspect: 1 }), [-Math.SQRT1_2, 0, Math.SQRT1_2]);
  near(directionTo({ ...pose, pitch: 0.3 }, [0.5, 0.5], { fov: 90, aspect: 1 }), [0, Math.sin(0.3), -Math.cos(0.3)]);
});

test('users stand on the ground, and in front of other things', () => {
  near(placeFor(EYE, [0, -0.5, -Math.sqrt(0.75)], [1, 0.1, -3]), [1, 1.7, -3]);
  near(placeFor(EYE, [0, 0, -1], [1, 1.7, -6]), [1, 1.7, -5]);
  // Things nearer than that do not move the user.
  near(placeFor(EYE, [0, 0, -1], [1, 1.7, 1.5]), EYE);
});

test('where nothing near is seen the ground is guessed; above it a leap moves forward', () => {
  const down = Math.SQRT1_2;
  near(placeFor(EYE, [0, -down, -down], null), [1, 1.7, 0.3]);
  near(placeFor(EYE, [1, 0, 0], null), [16, 1.7, 2]);
  near(placeFor(EYE, [0, 1, 0], null), EYE);
});

function countTaps(events: readonly (readonly ['down' | 'up', number, number, number, number?])[]): number {
  let count = 0;
  const taps = createTaps(() => (count += 1));
  for (const [name, timeStamp, clientX, clientY, pointerId = 1] of events) {
    taps[name]({ timeStamp, clientX, clientY, pointerId });
  }
  return count;
}

test('two taps at one place are reported, once', () => {
  const two = [['down', 0, 50, 50], ['up', 90, 52, 50], ['down', 250, 55, 52], ['up', 330, 55, 52]] as const;
  assert.equal(countTaps(two), 1);
  assert.equal(countTaps([...two, ['down', 450, 55, 52], ['up', 500, 55, 52]]), 1);
});

test('drags, slow taps, taps elsewhere and two fingers are no taps', () => {
  const [first, second] = [[['down', 0, 50, 50], ['up', 90, 50, 50]], [['down', 200, 50, 50], ['up', 280, 50, 50]]] as const;
  assert.equal(countTaps([...first, ...second]), 1);
  assert.equal(countTaps([['down', 0, 50, 50], ['up', 90, 90, 50], ...second]), 0);
  assert.equal(countTaps([['down', 0, 50, 50], ['up', 400, 50, 50], ['down', 450, 50, 50], ['up', 500, 50, 50]]), 0);
  assert.equal(countTaps([...first, ['down', 600, 50, 50], ['up', 650, 50, 50]]), 0);
  assert.equal(countTaps([...first, ['down', 200, 90, 50], ['up', 250, 90, 50]]), 0);
  assert.equal(countTaps([...first, ['down', 200, 50, 50], ['down', 210, 300, 50, 2], ['up', 280, 50, 50]]), 0);
});
