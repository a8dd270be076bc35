import assert from 'node:assert/strict';
import { test } from 'node:test';
import { allowedShare, type Bounds, clampToLimit, confine, distance, leadBack } from '../src/control/limit';
import type { Vector } from '../src/control/pose';
import { assertNear } from './support/near';

const LIMIT = { center: [5, 0, -3], metres: 10 } as const;
const BOUNDS: Bounds = { soft: [LIMIT], hard: [LIMIT] };
const at = (away: number, height = 1.7): Vector => [5 + 0.6 * away, height, -3 + 0.8 * away];

test('steps within the free part, and without a limit, are not shortened', () => {
  assert.deepEqual(confine(at(0), at(7.9), BOUNDS), at(7.9));
  assert.deepEqual(confine(at(0), at(500), null), at(500));
});

test('steps inwards are not shortened', () => {
  assert.deepEqual(confine(at(9.9), at(9.5), BOUNDS), at(9.5));
  assert.deepEqual(confine(at(30), at(29), BOUNDS), at(29));
});

test('steps outwards end within the limit, however long they are', () => {
  for (const reach of [9, 10, 11, 20, 1e6]) {
    const far = distance(confine(at(0), at(reach), BOUNDS), LIMIT);
    assert.ok(far > 8 && far <= 10);
  }
  assert.equal(confine(at(0), at(50, 4), BOUNDS)[1], 4);
});

test('one long step equals many short ones', () => {
  let place = at(6);
  const once = confine(place, at(6 + 5), BOUNDS);
  for (let step = 0; step < 50; step++) {
    const away = distance(place, LIMIT);
    place = confine(place, at(away + 0.1), BOUNDS);
  }
  assertNear(place, once);
});

test('the first step beyond the free part is hardly shortened', () => {
  assertNear(distance(confine(at(8), at(8.001), BOUNDS), LIMIT), 8.001, 1e-6);
});

test('a user beyond the limit cannot move farther out, and is led back smoothly', () => {
  assertNear(distance(confine(at(12), at(13), BOUNDS), LIMIT), 12);
  let place = at(12);
  for (let step = 0; step < 100; step++) {
    const next = leadBack(place, BOUNDS, 0.02);
    assert.ok(distance(place, LIMIT) - distance(next, LIMIT) < 0.13);
    place = next;
  }
  assertNear(distance(place, LIMIT), distance(leadBack(at(12), BOUNDS, 2), LIMIT));
  assertNear(distance(place, LIMIT), 10, 0.01);
  assert.deepEqual(leadBack(at(9), BOUNDS, 1), at(9));
});

test('the returned share of a step agrees with its end point', () => {
  const [from, to]: [Vector, Vector] = [at(7), at(15)];
  const share = allowedShare(from, to, BOUNDS);
  assertNear(7 + 8 * share, distance(confine(from, to, BOUNDS), LIMIT));
  assert.equal(allowedShare(to, from, BOUNDS), 1);
  assert.equal(allowedShare(from, to, null), 1);
  assertNear(allowedShare(at(12), at(13), BOUNDS), 0);
});

/** Two discs that overlap by 8 m along x, with the border at x = 6. */
const [LEFT, RIGHT] = [{ center: [0, 0, 0], metres: 10 }, { center: [12, 0, 0], metres: 10 }] as const;

test('steps between two displayable regions are not shortened', () => {
  const both: Bounds = { soft: [LEFT, RIGHT], hard: [LEFT] };
  assert.deepEqual(confine([5, 1.7, 0], [7.5, 1.7, 0], both), [7.5, 1.7, 0]);
  // Beyond the free part of the left region the step would be shortened without the right region.
  assert.ok(confine([8, 1.7, 0], [9, 1.7, 0], { soft: [LEFT], hard: [LEFT] })[0] < 9);
  assert.deepEqual(confine([8, 1.7, 0], [9, 1.7, 0], both), [9, 1.7, 0]);
});

test('no step leaves the displayed region, even if others can be displayed', () => {
  const both: Bounds = { soft: [LEFT, RIGHT], hard: [LEFT] };
  assertNear(confine([9, 1.7, 0], [14, 1.7, 0], both)[0], 10);
  const crossing: Bounds = { soft: [RIGHT], hard: [LEFT, RIGHT] };
  for (const goal of [[40, 1.7, 3], [-40, 1.7, 3], [6, 1.7, 60]] as const) {
    const place = confine([6, 1.7, 0], goal, crossing);
    assert.ok(distance(place, LEFT) <= 10 + 1e-9 && distance(place, RIGHT) <= 10 + 1e-9, String(place));
    const share = allowedShare([6, 1.7, 0], goal, crossing);
    const part: Vector = [6 + share * (goal[0] - 6), 1.7, share * goal[2]];
    assert.ok(distance(part, LEFT) <= 10 + 1e-9 && distance(part, RIGHT) <= 10 + 1e-9, String(part));
  }
});

test('a user outside all regions is led to the nearest one', () => {
  const place = leadBack([30, 1.7, 0], { soft: [LEFT, RIGHT], hard: [] }, 60);
  assertNear(place[0], 22, 1e-6);
});

test('a place is clamped to a limit', () => {
  assert.deepEqual(clampToLimit([3, 5, 4], LEFT), [3, 5, 4]);
  assert.deepEqual(clampToLimit([30, 5, 40], LEFT), [6, 5, 8]);
});
