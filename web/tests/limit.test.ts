import assert from 'node:assert/strict';
import { test } from 'node:test';
import { allowedShare, confine, distance, settle } from '../src/control/limit';
import type { Vector } from '../src/control/vector';

const LIMIT = { center: [5, 0, -3], metres: 10 } as const;
const at = (away: number, height = 1.7): Vector => [5 + 0.6 * away, height, -3 + 0.8 * away];
const close = (a: number, b: number, within = 1e-9): void => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test('within the free part, and without a limit, steps are whole', () => {
  assert.deepEqual(confine(at(0), at(7.9), LIMIT), at(7.9));
  assert.deepEqual(confine(at(0), at(500), null), at(500));
});

test('steps back are whole from everywhere', () => {
  assert.deepEqual(confine(at(9.9), at(9.5), LIMIT), at(9.5));
  assert.deepEqual(confine(at(30), at(29), LIMIT), at(29));
});

test('steps outwards end within the limit, however long they are', () => {
  for (const reach of [9, 10, 11, 20, 1e6]) {
    const far = distance(confine(at(0), at(reach), LIMIT), LIMIT);
    assert.ok(far > 8 && far <= 10);
  }
  assert.equal(confine(at(0), at(50, 4), LIMIT)[1], 4);
});

test('one long step equals many short ones', () => {
  let place = at(6);
  const once = confine(place, at(6 + 5), LIMIT);
  for (let step = 0; step < 50; step++) {
    const away = distance(place, LIMIT);
    place = confine(place, at(away + 0.1), LIMIT);
  }
  place.forEach((value, axis) => close(value, once[axis] ?? 0));
});

test('the first step beyond the free part is whole: nothing jars', () => {
  close(distance(confine(at(8), at(8.001), LIMIT), LIMIT), 8.001, 1e-6);
});

test('a user beyond the limit cannot go on, and is led back without a jump', () => {
  close(distance(confine(at(12), at(13), LIMIT), LIMIT), 12);
  let place = at(12);
  for (let step = 0; step < 100; step++) {
    const next = settle(place, LIMIT, 0.02);
    assert.ok(distance(place, LIMIT) - distance(next, LIMIT) < 0.13);
    place = next;
  }
  close(distance(place, LIMIT), distance(settle(at(12), LIMIT, 2), LIMIT));
  close(distance(place, LIMIT), 10, 0.01);
  assert.deepEqual(settle(at(9), LIMIT, 1), at(9));
});

test('the share of a step ends as far out as the step does', () => {
  const [from, to]: [Vector, Vector] = [at(7), at(15)];
  const share = allowedShare(from, to, LIMIT);
  close(7 + 8 * share, distance(confine(from, to, LIMIT), LIMIT));
  assert.equal(allowedShare(to, from, LIMIT), 1);
  assert.equal(allowedShare(from, to, null), 1);
  close(allowedShare(at(12), at(13), LIMIT), 0);
});
