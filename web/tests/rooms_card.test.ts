import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createArrivals } from '../src/rooms/card';
import { createThrottled } from '../src/rooms/pointing';

test('a single arrival is announced by name, several together by their number', () => {
  const sentences: string[] = [];
  const arrivals = createArrivals((sentence) => sentences.push(sentence));
  arrivals.begin(2);
  for (const number of [1, 2]) arrivals.add(number, 'present');
  arrivals.announceDue(0);
  arrivals.announceDue(10);
  assert.deepEqual(sentences, []);
  arrivals.add(3, 'Ada #3');
  for (let now = 10; now < 12; now += 0.1) arrivals.announceDue(now);
  assert.deepEqual(sentences, ['Ada #3 has joined']);
  for (let number = 10; number < 60; number++) arrivals.add(number, `User #${number}`);
  // Some of them leave before the announcement.
  for (let number = 10; number < 15; number++) arrivals.remove(number);
  for (let now = 12; now < 30; now += 0.1) arrivals.announceDue(now);
  assert.deepEqual(sentences.slice(1), ['45 more have joined']);
});

test('users who enter together are announced in one sentence', () => {
  const sentences: string[] = [];
  const arrivals = createArrivals((sentence) => sentences.push(sentence));
  for (let number = 0; number < 50; number++) {
    arrivals.add(number, 'User');
    arrivals.announceDue(number / 100);
  }
  for (let now = 0.5; now < 10; now += 0.1) arrivals.announceDue(now);
  assert.deepEqual(sentences, ['50 more have joined']);
});

test('users present at a reconnection, and users who left meanwhile, are not announced', () => {
  const sentences: string[] = [];
  const arrivals = createArrivals((sentence) => sentences.push(sentence));
  arrivals.add(7, 'Grace #7');
  arrivals.begin(1);
  arrivals.add(7, 'Grace #7');
  arrivals.add(8, 'Alan #8');
  arrivals.remove(8);
  for (let now = 0; now < 10; now += 0.1) arrivals.announceDue(now);
  assert.deepEqual(sentences, []);
});

test('a throttled value is computed less often than it is requested', () => {
  const throttled = createThrottled<number | null>(0.1);
  let count = 0;
  const valueAt = (now: number): number | null => throttled.get(now, () => (count++ === 0 ? null : count));
  assert.equal(valueAt(1), null);
  assert.equal(valueAt(1.09), null);
  assert.equal(valueAt(1.11), 2);
  throttled.forget();
  assert.equal(valueAt(1.12), 3);
});
