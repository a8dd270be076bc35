import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createStage, grow, NOTHING_NEAR } from '../src/show/stage';

const settings = { radii: [10, 22, 63], speed: 0.7, reach: 1, nearShare: 0.7, fade: 0.5 };
const rate = (0.7 * Math.PI) / 180;

test('ring 1 grows in strength, in the time that the manifest prescribes', () => {
  const whole = 1 / (0.7 * 10 * rate);
  const half = grow(NOTHING_NEAR, 1, whole / 2, settings);
  assert.ok(Math.abs(half.strength - 0.5) < 1e-12);
  assert.deepEqual(grow(half, 1, whole, settings), { radius: 10, strength: 1 });
});

test('later rings grow so that 1/R falls linearly', () => {
  const { radius } = grow({ radius: 10, strength: 1 }, 2, 2, settings);
  assert.ok(Math.abs(1 / radius - (1 / 10 - 0.3 * rate * 2)) < 1e-12);
  assert.equal(grow({ radius: 10, strength: 1 }, 2, 1e6, settings).radius, 22);
});

test('the frame rate does not matter', () => {
  let many = NOTHING_NEAR;
  for (let n = 0; n < 3000; n++) many = grow(many, 3, 0.01, settings);
  const once = grow(NOTHING_NEAR, 3, 30, settings);
  assert.ok(Math.abs(many.radius - once.radius) < 1e-6);
});

test('rings that arrive together fade in one after the other, no radius exceeds that of a loaded ring', async () => {
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
  await stage.whenReplaceable(4);
});

test('a ring may replace a map only when the map is no longer shown', async () => {
  const stage = createStage(settings, { isSmooth: true, isWhole: false });
  stage.enter(NOTHING_NEAR);
  stage.arrive(0);
  stage.advance(0);
  let isFree = false;
  stage.arrive(1);
  const wait = stage.whenReplaceable(2).then(() => {
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

test('a folding radius is not shown: near things stay as seen from the centre until a ring is large enough', () => {
  const held = grow(NOTHING_NEAR, 2, 5, settings, 30);
  assert.deepEqual(held, { radius: 22, strength: 0 });
  const begun = grow(held, 3, 1, settings, 30);
  assert.ok(begun.radius === 63 && begun.strength > 0 && begun.strength < 1);
  // Once points have begun to move, they continue.
  assert.ok(grow({ radius: 22, strength: 0.5 }, 2, 1, settings, 30).strength > 0.5);
  // Walking back needs no large radius.
  assert.equal(grow(held, 2, 1, settings, 5).radius, 10);
});

test('a region begins like the region shown before, as far as its rings allow', () => {
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

test('a hidden region replaces each ring by the next, so that no map waits', async () => {
  const stage = createStage(settings, { isSmooth: true, isWhole: false });
  for (const ring of [0, 1, 2]) {
    await stage.whenReplaceable(ring);
    stage.arrive(ring);
  }
  stage.enter(NOTHING_NEAR);
  stage.arrive(3);
  assert.equal(stage.advance(0)?.fading?.ring, 3);
  stage.leave();
  assert.equal(stage.advance(0)?.ring, 3);
});
