import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createStage, grow, NOTHING_NEAR } from '../src/show/stage';

const settings = { radii: [10, 22, 63], speed: 0.7, reach: 1, nearShare: 0.7, fade: 0.5 };
const rate = (0.7 * Math.PI) / 180;

test('the strength of ring 1 grows in the time that follows from the manifest', () => {
  const seconds = 1 / (0.7 * 10 * rate);
  const half = grow(NOTHING_NEAR, 1, seconds / 2, settings);
  assert.ok(Math.abs(half.strength - 0.5) < 1e-12);
  assert.deepEqual(grow(half, 1, seconds, settings), { radius: 10, strength: 1 });
});

test('later rings grow so that 1/R falls linearly', () => {
  const { radius } = grow({ radius: 10, strength: 1 }, 2, 2, settings);
  assert.ok(Math.abs(1 / radius - (1 / 10 - 0.3 * rate * 2)) < 1e-12);
  assert.equal(grow({ radius: 10, strength: 1 }, 2, 1e6, settings).radius, 22);
});

test('the growth does not depend on the frame rate', () => {
  let inSteps = NOTHING_NEAR;
  for (let n = 0; n < 3000; n++) inSteps = grow(inSteps, 3, 0.01, settings);
  const atOnce = grow(NOTHING_NEAR, 3, 30, settings);
  assert.ok(Math.abs(inSteps.radius - atOnce.radius) < 1e-6);
});

test('rings that arrive together fade in one by one, and no radius exceeds that of a shown ring', async () => {
  const stage = createStage(settings, { isSmooth: true, isWhole: false });
  stage.enter(NOTHING_NEAR);
  for (const ring of [0, 1, 2, 3]) stage.arrive(ring);
  let [before, ring] = [0, 0];
  for (let n = 0; n < 72 * 60; n++) {
    const shown = stage.advance(1 / 72);
    assert.ok(shown);
    assert.ok(shown.grown.radius <= (settings.radii[shown.ring - 1] ?? 0));
    assert.ok(shown.grown.radius >= before && shown.ring - ring <= 1);
    [before, ring] = [shown.grown.radius, shown.ring];
  }
  assert.deepEqual([before, ring], [63, 3]);
  await stage.waitForCube(4);
});

test('the map of a ring waits until the map in its cube is no longer shown', async () => {
  const stage = createStage(settings, { isSmooth: true, isWhole: false });
  stage.enter(NOTHING_NEAR);
  stage.arrive(0);
  stage.advance(0);
  let isFree = false;
  stage.arrive(1);
  const wait = stage.waitForCube(2).then(() => {
    isFree = true;
  });
  stage.advance(0.01);
  stage.advance(0.4);
  await Promise.resolve();
  assert.equal(isFree, false);
  stage.advance(0.2);
  await wait;
  assert.equal(isFree, true);
});

test('the strength stays 0 until the radius of a ring does not fold', () => {
  const waiting = grow(NOTHING_NEAR, 2, 5, settings, 30);
  assert.deepEqual(waiting, { radius: 22, strength: 0 });
  const growing = grow(waiting, 3, 1, settings, 30);
  assert.ok(growing.radius === 63 && growing.strength > 0 && growing.strength < 1);
  // A strength that has begun to grow continues.
  assert.ok(grow({ radius: 22, strength: 0.5 }, 2, 1, settings, 30).strength > 0.5);
  // A user who walks back needs no large radius.
  assert.equal(grow(waiting, 2, 1, settings, 5).radius, 10);
});

test('a region begins in the state of the region before it, as far as its rings allow', () => {
  const stage = createStage(settings, { isSmooth: true, isWhole: false });
  assert.equal(stage.offer({ radius: 15, strength: 1 }), null);
  stage.arrive(0);
  assert.deepEqual(stage.offer({ radius: 15, strength: 1 }), NOTHING_NEAR);
  for (const ring of [1, 2]) stage.arrive(ring);
  assert.deepEqual(stage.offer(NOTHING_NEAR), { radius: 10, strength: 0 });
  assert.deepEqual(stage.offer({ radius: 15, strength: 1 }), { radius: 15, strength: 1 });
  assert.deepEqual(stage.offer({ radius: 63, strength: 1 }), { radius: 22, strength: 1 });
  stage.enter({ radius: 15, strength: 1 });
  assert.deepEqual(stage.advance(0), { ring: 2, grown: { radius: 15, strength: 1 }, fading: null });
  const later = stage.advance(1);
  assert.ok(later && later.grown.radius > 15);
});

test('in a hidden region each ring replaces the one before at once, so that no map waits', async () => {
  const stage = createStage(settings, { isSmooth: true, isWhole: false });
  for (const ring of [0, 1, 2]) {
    await stage.waitForCube(ring);
    stage.arrive(ring);
  }
  stage.enter(NOTHING_NEAR);
  stage.arrive(3);
  assert.equal(stage.advance(0)?.fading?.ring, 3);
  stage.leave();
  assert.equal(stage.advance(0)?.ring, 3);
});
