import assert from 'node:assert/strict';
import { test } from 'node:test';
import { confine, distance, leadBack } from '../src/control/limit';
import type { Pose, Vector } from '../src/control/pose';
import { createJourney, type Leg, type Regions } from '../src/show/journey';
import { createStage, type Shown, type Stage } from '../src/show/stage';
import { bundlePlaces } from '../src/show/world';
import { assertNear } from './support/near';
import { randomOf } from './support/random';

const NEAR_SHARE = 0.7;
const RADII = [10, 22];
const MARGIN = NEAR_SHARE * 22;
const FADE = 0.5;
const FRAME = 1 / 72;
const MANNER = { isSmooth: true, isWhole: false };

/** Region of the test that is open. */
interface FakeRegion {
  readonly stage: Stage;
  ring: number;
  shown: Shown | null;
  since: number;
}

/**
 * Creates a walk through regions along x. Their rings arrive some seconds after a region begins to load; one region
 * loads at a time.
 */
function createWalk(centers: readonly number[], arrivals: readonly number[] = [0.2, 0.5, 1], speed = 50) {
  const openRegions = new Map<number, FakeRegion>();
  const log: string[] = [];
  let order: readonly number[] = [];
  const stalled = new Set<number>();
  const coarse = new Set<number>();
  const settings = { radii: RADII, speed, reach: 1, nearShare: NEAR_SHARE, fade: FADE };
  const regions: Regions = {
    open(region) {
      if (openRegions.has(region)) return;
      log.push(`open ${region}`);
      openRegions.set(region, { stage: createStage(settings, MANNER), ring: -1, shown: null, since: 0 });
    },
    close(region) {
      if (openRegions.delete(region)) log.push(`close ${region}`);
    },
    prefer: (next) => {
      order = next;
    },
    offer: (region, from) => openRegions.get(region)?.stage.offer(from) ?? null,
    isComplete: (region) => openRegions.get(region)?.ring === RADII.length,
    isCoarse: (region) => coarse.has(region),
    enter(region, from) {
      log.push(`enter ${region}`);
      const open = openRegions.get(region) as FakeRegion;
      open.stage.enter(from);
      open.shown = null;
    },
    leave(region) {
      log.push(`leave ${region}`);
      openRegions.get(region)?.stage.leave();
    },
    morphState: (region) => openRegions.get(region)?.shown?.grown ?? null,
  };
  const load = (seconds: number): void => {
    const active = order.find((region) => openRegions.get(region)?.ring !== RADII.length);
    const open = active === undefined || stalled.has(active) ? undefined : openRegions.get(active);
    if (!open) return;
    open.since += seconds;
    while (open.ring < RADII.length && open.since >= (arrivals[open.ring + 1] ?? Number.POSITIVE_INFINITY)) {
      open.ring += 1;
      open.stage.arrive(open.ring);
    }
  };
  const moves: Pose[] = [];
  const entries = centers.map((x) => ({ center: [x, 1.7, 0], fold_margin: MARGIN }) as const);
  const journey = createJourney(
    { places: bundlePlaces(entries), marginShare: NEAR_SHARE, fade: FADE, onMove: (pose) => moves.push(pose) },
    regions,
    0,
  );
  let position: Vector = [centers[0] ?? 0, 1.7, 0];

  /** Draws a frame of a user who moves with a velocity, and checks each picture that it shows. */
  function frame(velocity: Vector, seconds = FRAME): Leg {
    load(seconds);
    const { bounds } = journey;
    const target: Vector = [position[0] + velocity[0] * seconds, position[1], position[2] + velocity[2] * seconds];
    position = leadBack(confine(position, target, bounds), bounds, seconds);
    const before = moves.length;
    const leg = journey.advance(seconds, { position, yaw: 0, pitch: 0 });
    if (moves.length > before) position = moves.at(-1)?.position ?? position;
    const open = openRegions.get(leg.region) as FakeRegion;
    open.shown = open.stage.advance(leg.leaving ? 0 : seconds, journey.minRadius);
    check(leg.region, position);
    if (leg.leaving) check(leg.leaving.region, leg.leaving.pose?.position ?? position);
    assert.ok(openRegions.size <= 2, 'more than two regions are open');
    return leg;
  }

  /** Checks that the picture of a region does not fold at a place. */
  function check(region: number, place: Vector): void {
    const state = regions.morphState(region);
    if (!state || state.strength === 0) return;
    const limit = { center: entries[region]?.center ?? [0, 0, 0], metres: NEAR_SHARE * state.radius } as const;
    const excess = distance(place, limit) - limit.metres;
    assert.ok(excess <= 1e-9, `region ${region} is shown ${excess} m beyond the limit of its picture`);
  }

  return { frame, journey, log, stalled, coarse, moves, openRegions, place: () => position };
}

/** Draws some frames of a user who moves with a velocity. */
function drawFrames(walk: ReturnType<typeof createWalk>, count: number, velocity: Vector): Leg[] {
  return Array.from({ length: count }, () => walk.frame(velocity));
}

const STILL: Vector = [0, 0, 0];
const EAST: Vector = [1.4, 0, 0];

test('the next region is loaded before its border, and fades in behind it', () => {
  const walk = createWalk([0, 12]);
  drawFrames(walk, 72 * 12, STILL);
  assert.deepEqual(walk.log, ['open 0', 'enter 0']);
  let [openedAt, enteredAt] = [0, 0];
  const legs: Leg[] = [];
  for (let n = 0; n < 72 * 8; n++) {
    legs.push(walk.frame(EAST));
    if (!openedAt && walk.log.includes('open 1')) [openedAt] = walk.place();
    if (!enteredAt && walk.log.includes('enter 1')) [enteredAt] = walk.place();
  }
  assert.ok(openedAt > 1 && openedAt < 6, `loaded from ${openedAt} m on`);
  assert.ok(enteredAt > 6 && enteredAt < 7.3, `taken over at ${enteredAt} m`);
  const shares = legs.flatMap(({ leaving }) => (leaving ? [leaving.share] : []));
  assert.equal(shares[0], 0);
  shares.forEach((share, n) => n > 0 && assertNear(share - (shares[n - 1] ?? 0), FRAME / FADE));
  assertNear(shares.at(-1) ?? 0, 1, 1.5 * (FRAME / FADE));
  // Radius and strength are those of the region that was shown before.
  assert.deepEqual(walk.openRegions.get(1)?.shown?.grown, { radius: 22, strength: 1 });
  assertNear(walk.place()[0], 1.4 * 8, 1e-9);
});

test('a user who walks to and fro across a border does not change regions, and both stay open', () => {
  const walk = createWalk([0, 12]);
  drawFrames(walk, 72 * 12, STILL);
  drawFrames(walk, Math.round(72 * (7 / 1.4)), EAST);
  for (let turn = 0; turn < 20; turn++) drawFrames(walk, 30, [turn % 2 ? 1.4 : -1.4, 0, 0]);
  assert.deepEqual(walk.log.filter((line) => line.startsWith('enter')), ['enter 0', 'enter 1']);
  drawFrames(walk, 72 * 3, [-1.4, 0, 0]);
  assert.deepEqual(walk.log.filter((line) => !line.startsWith('leave')), [
    'open 0',
    'enter 0',
    'open 1',
    'enter 1',
    'enter 0',
  ]);
  // Far from the border, the other region is closed.
  drawFrames(walk, 72 * 4, [-1.4, 0, 0]);
  assert.equal(walk.log.at(-1), 'close 1');
});

test('while the next region is loading, the user is stopped where the old picture would fold', () => {
  const walk = createWalk([0, 24]);
  drawFrames(walk, 72 * 12, STILL);
  walk.stalled.add(1);
  drawFrames(walk, 72 * 30, EAST);
  assert.equal(walk.journey.region, 0);
  assert.ok(walk.place()[0] > 0.95 * MARGIN && walk.place()[0] <= MARGIN);
  walk.stalled.clear();
  drawFrames(walk, 72 * 4, EAST);
  assert.equal(walk.journey.region, 1);
  assert.ok(walk.place()[0] > MARGIN);
});

test('a region without ring 1 does not take over, so that near geometry stays', () => {
  const walk = createWalk([0, 24], [0.2, 0.5, 1]);
  drawFrames(walk, 72 * 12, STILL);
  drawFrames(walk, 72 * 5, EAST);
  walk.stalled.add(1);
  walk.openRegions.get(1)?.stage.arrive(0);
  drawFrames(walk, 72 * 10, EAST);
  assert.equal(walk.journey.region, 0);
});

test('a region with smaller rings takes over only at the edge', () => {
  const walk = createWalk([0, 16], [0.2, 0.5, 1e9]);
  const first = walk.openRegions.get(0) as FakeRegion;
  [0, 1, 2].forEach((ring) => first.stage.arrive(ring));
  first.ring = 2;
  drawFrames(walk, 72 * 12, STILL);
  assert.equal(first.shown?.grown.radius, 22);
  let entered = 0;
  for (let n = 0; n < 72 * 12 && !entered; n++) {
    walk.frame(EAST);
    if (walk.journey.region === 1) [entered] = walk.place();
  }
  assert.ok(entered >= 0.8 * MARGIN - 0.1 && entered < MARGIN, `${entered}`);
  assert.equal(walk.openRegions.get(1)?.shown?.grown.radius, 10);
});

test('a user who turns round during a fade sees its end, and then a fade back', () => {
  const walk = createWalk([0, 4]);
  drawFrames(walk, 72 * 12, STILL);
  let n = 0;
  while (walk.journey.region === 0 && n++ < 1000) walk.frame(EAST);
  const legs = drawFrames(walk, 72, [-4.8, 0, 0]);
  assert.equal(walk.journey.region, 0);
  const lines = legs.map(({ region, leaving }) => `${region} ${leaving ? 'fades' : 'is shown'}`);
  const changes = lines.filter((line, number) => line !== lines[number - 1]);
  assert.deepEqual(changes, ['1 fades', '0 fades', '0 is shown']);
});

test('no picture folds for a user who runs through many regions', () => {
  const walk = createWalk(Array.from({ length: 20 }, (_, n) => 6 * n), [0.5, 1.5, 3]);
  drawFrames(walk, 72, STILL);
  for (let n = 0; n < 72 * 60; n++) walk.frame([4.8, 0, n % 300 < 150 ? 1 : -1]);
  assert.equal(walk.journey.region, 19);
});

test('on random walks and networks no picture folds, and no step is longer than the user walks', () => {
  const random = randomOf(1);
  for (let trial = 0; trial < 12; trial++) {
    const spacing = 3 + 30 * random();
    const walk = createWalk([0, spacing, 2 * spacing, 3 * spacing], [random(), 1 + 3 * random(), 3 + 4 * random()]);
    for (let leg = 0; leg < 40; leg++) {
      const angle = 2 * Math.PI * random();
      const speed = 5 * random();
      if (random() < 0.3) walk.stalled.add(Math.floor(4 * random()));
      if (random() < 0.3) walk.stalled.clear();
      if (random() < 0.15) {
        walk.journey.go({ position: [3 * spacing * random(), 1.7, 4 * random()], yaw: 0, pitch: 0 });
      }
      for (let n = 0; n < 60; n++) {
        const before = walk.place();
        const jumps = walk.moves.length;
        walk.frame([speed * Math.cos(angle), 0, speed * Math.sin(angle)]);
        const step = Math.hypot(walk.place()[0] - before[0], walk.place()[2] - before[2]);
        assert.ok(walk.moves.length > jumps || step < 0.3, `a step of ${step} m`);
      }
    }
  }
});

test('a jump nearby moves the user at once, and the old picture fades out at the old place', () => {
  const walk = createWalk([0, 40]);
  drawFrames(walk, 72 * 12, STILL);
  walk.journey.go({ position: [5, 1.7, 2], yaw: 1, pitch: 0 });
  const leg = walk.frame(STILL);
  assert.deepEqual(walk.moves, [{ position: [5, 1.7, 2], yaw: 1, pitch: 0 }]);
  assert.deepEqual([leg.region, leg.leaving?.region, leg.leaving?.share], [0, 0, 0]);
  assert.deepEqual(leg.leaving?.pose?.position, [0, 1.7, 0]);
  const legs = drawFrames(walk, 72, STILL);
  assert.equal(legs.at(-1)?.leaving, null);
  assert.equal(walk.log.includes('leave 0'), false);
});

test('a jump to another region waits for its first map, which is loaded before everything else', () => {
  const walk = createWalk([0, 100], [1, 2, 3]);
  drawFrames(walk, 10, STILL);
  walk.journey.go({ position: [105, 1.7, 0], yaw: 0, pitch: 0 });
  drawFrames(walk, 72, STILL);
  assert.equal(walk.journey.goal, 1);
  assert.equal(walk.openRegions.get(0)?.ring, -1);
  drawFrames(walk, 30, STILL);
  assert.deepEqual([walk.journey.region, walk.journey.goal], [1, null]);
  assert.deepEqual(walk.place(), [105, 1.7, 0]);
  drawFrames(walk, 72 * 4, STILL);
  assert.deepEqual([...walk.openRegions.keys()], [1]);
  // 5 m from the centre, the radius of the first ring does not fold.
  assert.deepEqual(walk.openRegions.get(1)?.shown?.grown, { radius: 22, strength: 1 });
});

test('where the first radius would fold, the strength stays 0 until a ring is large enough', () => {
  const walk = createWalk([0, 100], [0.1, 0.2, 5]);
  drawFrames(walk, 72, STILL);
  walk.journey.go({ position: [112, 1.7, 0], yaw: 0, pitch: 0 });
  drawFrames(walk, 72 * 4, STILL);
  assert.equal(walk.openRegions.get(1)?.shown?.grown.strength, 0);
  drawFrames(walk, 72 * 5, STILL);
  const { radius, strength } = walk.openRegions.get(1)?.shown?.grown ?? {};
  assert.ok(radius === 22 && (strength ?? 0) > 0);
});

test('a jump to a place outside all regions ends inside the nearest one', () => {
  const walk = createWalk([0, 30]);
  drawFrames(walk, 72 * 12, STILL);
  walk.journey.go({ position: [500, 1.7, 0], yaw: 0, pitch: 0 });
  drawFrames(walk, 72 * 2, STILL);
  assert.equal(walk.journey.region, 1);
  assertNear(walk.place()[0], 30 + 0.9 * MARGIN, 1e-9);
});

test('a region that cannot be loaded cancels the jump to it', () => {
  const walk = createWalk([0, 100]);
  drawFrames(walk, 72 * 2, STILL);
  walk.stalled.add(1);
  walk.journey.go({ position: [100, 1.7, 0], yaw: 0, pitch: 0 });
  drawFrames(walk, 72, STILL);
  assert.equal(walk.journey.goal, 1);
  walk.journey.abandon(1);
  drawFrames(walk, 2, STILL);
  assert.equal(walk.journey.goal, null);
  assert.deepEqual([...walk.openRegions.keys()], [0]);
});

test('a region with coarse maps takes over only at the edge', () => {
  const walk = createWalk([0, 16]);
  drawFrames(walk, 72 * 12, STILL);
  walk.coarse.add(1);
  drawFrames(walk, Math.round(72 * (8 / 1.4)), EAST);
  const loaded = walk.openRegions.get(1) as FakeRegion;
  // All rings have arrived except the one with the fine map.
  loaded.ring = RADII.length - 1;
  [0, 1, 2].forEach((ring) => loaded.stage.arrive(ring));
  walk.stalled.add(1);
  while (walk.place()[0] < 11) walk.frame(EAST);
  assert.equal(walk.journey.region, 0);
  let entered = 0;
  for (let n = 0; n < 72 * 12 && !entered; n++) {
    walk.frame(EAST);
    if (walk.journey.region > 0) [entered] = walk.place();
  }
  assert.ok(entered >= 0.8 * MARGIN - 0.1 && entered < MARGIN, `${entered}`);
});
