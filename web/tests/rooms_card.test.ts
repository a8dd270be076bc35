import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createArrivals } from '../src/rooms/card';
import { createThrottled } from '../src/rooms/pointing';

test('a single arrival is named, and several together are one sentence', () => {
  const sentences: string[] = [];
  const arrivals = createArrivals((sentence) => sentences.push(sentence));
  arrivals.begin(2);
  for (const number of [1, 2]) arrivals.add(number, 'there before');
  arrivals.announceDue(0);
  arrivals.announceDue(10);
  assert.deepEqual(sentences, []);
  arrivals.add(3, 'Ada #3');
  for (let now = 10; now < 12; now += 0.1) arrivals.announceDue(now);
  assert.deepEqual(sentences, ['Ada #3 has joined']);
  for (let number = 10; number < 60; number++) arrivals.add(number, `User #${number}`);
  // Some of them have left before anybody was told.
  for (let number = 10; number < 15; number++) arrivals.remove(number);
  for (let now = 12; now < 30; now += 0.1) arrivals.announceDue(now);
  assert.deepEqual(sentences.slice(1), ['45 more have joined']);
});

test('many who enter together are one sentence, without a separate one for the first', () => {
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

test('a costly check runs less often than it is requested', () => {
  const seldom = createThrottled<number | null>(0.1);
  let looks = 0;
  const ask = (now: number): number | null => seldom.at(now, () => (looks++ === 0 ? null : looks));
  assert.equal(ask(1), null);
  assert.equal(ask(1.09), null);
  assert.equal(ask(1.11), 2);
  seldom.forget();
  assert.equal(ask(1.12), 3);
});
