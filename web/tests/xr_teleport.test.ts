import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ARC_POINTS, createJump, landingPoint, pointsOfArc } from '../src/xr/teleport';
import { assertNear } from './support/near';

const LEVEL = { origin: [1, 1.2, 2], direction: [0, 0, -1] } as const;

test('an arc ends where a thrown object would land', () => {
  // A fall from the height h takes √(2 h / g).
  assertNear(landingPoint(LEVEL), [1, 0, 2 - 7.5 * Math.sqrt(2.4 / 9.81)], 1e-12);
  const diagonal = { ...LEVEL, origin: [0, 0, 0], direction: [0, Math.SQRT1_2, -Math.SQRT1_2] } as const;
  assert.ok(Math.abs(landingPoint(diagonal)[2] + 7.5 ** 2 / 9.81) < 1e-12);
  // A throw straight up ends below the hand, and so does one from a hand below the floor.
  assertNear(landingPoint({ ...LEVEL, direction: [0, 1, 0] }), [1, 0, 2], 1e-12);
  assertNear(landingPoint({ origin: [1, -0.5, 2], direction: [0, -1, 0] }), [1, 0, 2], 1e-12);
  assertNear(landingPoint({ ...LEVEL, origin: [1, -0.5, 2] }), [1, 0, 2], 1e-12);
});

test('the points of an arc lead from the hand to the target', () => {
  for (const target of [landingPoint(LEVEL), [3, 0, 1]] as const) {
    const points = pointsOfArc(LEVEL, target);
    assert.equal(points.length, ARC_POINTS);
    assert.deepEqual(points[0], LEVEL.origin);
    assertNear(points.at(-1) ?? [], target, 1e-12);
  }
});

test('the action of a jump is called once, when the picture is black', () => {
  for (const seconds of [0.001, 0.011, 0.05, 0.3]) {
    const jump = createJump();
    let count = 0;
    assert.equal(jump.advance(seconds), 0);
    jump.start(() => count++);
    let before = count;
    const darkness: number[] = [];
    for (let frame = 0; frame < 1 / seconds + 3; frame++) {
      const dark = jump.advance(seconds);
      if (count > before) assert.equal(dark, 1);
      before = count;
      darkness.push(dark);
    }
    assert.equal(count, 1);
    assert.equal(darkness.at(-1), 0);
    assert.ok(darkness.every((dark) => dark >= 0 && dark <= 1));
  }
});

test('a second jump replaces the first, and begins with the current darkness', () => {
  const jump = createJump();
  const actions: string[] = [];
  jump.start(() => actions.push('first'));
  const before = jump.advance(0.06);
  jump.start(() => actions.push('second'));
  assert.equal(jump.advance(0), before);
  for (let frame = 0; frame < 60; frame++) jump.advance(1 / 60);
  assert.deepEqual(actions, ['second']);
});
