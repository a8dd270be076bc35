import assert from 'node:assert/strict';
import { test } from 'node:test';
import { confine, distance, leadBack } from '../src/control/limit';
import type { Pose, Vector } from '../src/control/pose';
import { createJourney, type Leg, type Regions } from '../src/show/journey';
import { createStage, type Shown, type Stage } from '../src/show/stage';
import { knownPlaces } from '../src/show/world';
import { assertNear } from './support/near';
import { randomOf } from './support/random';

const NEAR_SHARE = 0.7;
const RADII = [10, 22];
const MARGIN = NEAR_SHARE * 22;
const FADE = 0.5;
const FRAME = 1 / 72;
const MANNER = { isSmooth: true, isWhole: false };

interface Loaded {
  readonly stage: Stage;
  ring: number;
  shown: Shown | null;
  since: number;
}

/** Regions along x, whose rings arrive some seconds after loading began; one region loads at a time. */
function world(centers: readonly number[], arrivals: readonly number[] = [0.2, 0.5, 1], speed = 50) {
  const opened = new Map<number, Loaded>();
  const log: string[] = [];
  let order: readonly number[] = [];
  const stalled = new Set<number>();
  const coarse = new Set<number>();
  const settings = { radii: RADII, speed, reach: 1, nearShare: NEAR_SHARE, fade: FADE };
  const regions: Regions = {
    open(region) {
      if (opened.has(region)) return;
      log.push(`open ${region}`);
      opened.set(region, { stage: createStage(settings, MANNER), ring: -1, shown: null, since: 0 });
    },
    close(region) {
      if (opened.delete(region)) log.push(`close ${region}`);
    },
    prefer: (next) => {
      order = next;
    },
    offer: (region, from) => opened.get(region)?.stage.offer(from) ?? null,
    isComplete: (region) => opened.get(region)?.ring === RADII.length,
    isCoarse: (region) => coarse.has(region),
    enter(region, from) {
      log.push(`enter ${region}`);
      const found = opened.get(region) as Loaded;
      found.stage.enter(from);
      found.shown = null;
    },
    leave(region) {
      log.push(`leave ${region}`);
      opened.get(region)?.stage.leave();
    },
    grown: (region) => opened.get(region)?.shown?.grown ?? null,
  };
  const load = (seconds: number): void => {
    const active = order.find((region) => opened.get(region)?.ring !== RADII.length);
    const found = active === undefined || stalled.has(active) ? undefined : opened.get(active);
    if (!found) return;
    found.since += seconds;
    while (found.ring < RADII.length && found.since >= (arrivals[found.ring + 1] ?? Number.POSITIVE_INFINITY)) {
      found.ring += 1;
      found.stage.arrive(found.ring);
    }
  };
  const moves: Pose[] = [];
  const entries = centers.map((x) => ({ center: [x, 1.7, 0], fold_margin: MARGIN }) as const);
  const journey = createJourney(
    { places: knownPlaces(entries), marginShare: NEAR_SHARE, fade: FADE, onMove: (pose) => moves.push(pose) },
    regions,
    0,
  );
  let position: Vector = [centers[0] ?? 0, 1.7, 0];

  /** A frame of a user who wants to move; every displayed picture is checked. */
  function frame(velocity: Vector, seconds = FRAME): Leg {
    load(seconds);
    const { bounds } = journey;
    const wanted: Vector = [position[0] + velocity[0] * seconds, position[1], position[2] + velocity[2] * seconds];
    position = leadBack(confine(position, wanted, bounds), bounds, seconds);
    const before = moves.length;
    const leg = journey.advance(seconds, { position, yaw: 0, pitch: 0 });
    if (moves.length > before) position = moves.at(-1)?.position ?? position;
    const found = opened.get(leg.region) as Loaded;
    found.shown = found.stage.advance(leg.leaving ? 0 : seconds, journey.minRadius);
    check(leg.region, position);
    if (leg.leaving) check(leg.leaving.region, leg.leaving.pose?.position ?? position);
    assert.ok(opened.size <= 2, 'two regions at most');
    return leg;
  }

  /** Asserts that the picture of a region does not fold at a place. */
  function check(region: number, place: Vector): void {
    const grown = regions.grown(region);
    if (!grown || grown.strength === 0) return;
    const limit = { center: entries[region]?.center ?? [0, 0, 0], metres: NEAR_SHARE * grown.radius } as const;
    const over = distance(place, limit) - limit.metres;
    assert.ok(over <= 1e-9, `region ${region} is shown ${over} m beyond where it folds`);
  }

  return { frame, journey, log, stalled, coarse, moves, opened, place: () => position };
}

function frames(walk: ReturnType<typeof world>, count: number, velocity: Vector): Leg[] {
  return Array.from({ length: count }, () => walk.frame(velocity));
}

const STILL: Vector = [0, 0, 0];
const EAST: Vector = [1.4, 0, 0];

test('the region ahead is loaded before its border, and cross-fades behind it', () => {
  const walk = world([0, 12]);
  frames(walk, 72 * 12, STILL);
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
  // Radius and strength are those of the region shown before.
  assert.deepEqual(walk.opened.get(1)?.shown?.grown, { radius: 22, strength: 1 });
  assertNear(walk.place()[0], 1.4 * 8, 1e-9);
});

test('at a border regions do not alternate, and the region behind is kept', () => {
  const walk = world([0, 12]);
  frames(walk, 72 * 12, STILL);
  frames(walk, Math.round(72 * (7 / 1.4)), EAST);
  for (let turn = 0; turn < 20; turn++) frames(walk, 30, [turn % 2 ? 1.4 : -1.4, 0, 0]);
  assert.deepEqual(walk.log.filter((line) => line.startsWith('enter')), ['enter 0', 'enter 1']);
  frames(walk, 72 * 3, [-1.4, 0, 0]);
  assert.deepEqual(walk.log.filter((line) => !line.startsWith('leave')), [
    'open 0',
    'enter 0',
    'open 1',
    'enter 1',
    'enter 0',
  ]);
  // Far away it is released.
  frames(walk, 72 * 4, [-1.4, 0, 0]);
  assert.equal(walk.log.at(-1), 'close 1');
});

test('on a slow network the old picture stays, and the user is stopped where it would fold', () => {
  const walk = world([0, 24]);
  frames(walk, 72 * 12, STILL);
  walk.stalled.add(1);
  frames(walk, 72 * 30, EAST);
  assert.equal(walk.journey.region, 0);
  assert.ok(walk.place()[0] > 0.95 * MARGIN && walk.place()[0] <= MARGIN);
  walk.stalled.clear();
  frames(walk, 72 * 4, EAST);
  assert.equal(walk.journey.region, 1);
  assert.ok(walk.place()[0] > MARGIN);
});

test('without ring 1 of the next region near geometry does not return into a map', () => {
  const walk = world([0, 24], [0.2, 0.5, 1]);
  frames(walk, 72 * 12, STILL);
  const slow = walk.opened;
  frames(walk, 72 * 5, EAST);
  walk.stalled.add(1);
  slow.get(1)?.stage.arrive(0);
  frames(walk, 72 * 10, EAST);
  assert.equal(walk.journey.region, 0);
});

test('a region with smaller rings takes over only at the edge', () => {
  const walk = world([0, 16], [0.2, 0.5, 1e9]);
  const first = walk.opened.get(0) as Loaded;
  [0, 1, 2].forEach((ring) => first.stage.arrive(ring));
  first.ring = 2;
  frames(walk, 72 * 12, STILL);
  assert.equal(first.shown?.grown.radius, 22);
  let entered = 0;
  for (let n = 0; n < 72 * 12 && !entered; n++) {
    walk.frame(EAST);
    if (walk.journey.region === 1) [entered] = walk.place();
  }
  assert.ok(entered >= 0.8 * MARGIN - 0.1 && entered < MARGIN, `${entered}`);
  assert.equal(walk.opened.get(1)?.shown?.grown.radius, 10);
});

test('turning round during a fade ends it first, and then fades back', () => {
  const walk = world([0, 4]);
  frames(walk, 72 * 12, STILL);
  let n = 0;
  while (walk.journey.region === 0 && n++ < 1000) walk.frame(EAST);
  const legs = frames(walk, 72, [-4.8, 0, 0]);
  assert.equal(walk.journey.region, 0);
  const shares = legs.map(({ region, leaving }) => `${region} ${leaving ? 'fades' : 'is shown'}`);
  const runs = shares.filter((text, place) => text !== shares[place - 1]);
  assert.deepEqual(runs, ['1 fades', '0 fades', '0 is shown']);
});

test('running through many regions never shows a folding picture', () => {
  const walk = world(Array.from({ length: 20 }, (_, n) => 6 * n), [0.5, 1.5, 3]);
  frames(walk, 72, STILL);
  for (let n = 0; n < 72 * 60; n++) walk.frame([4.8, 0, n % 300 < 150 ? 1 : -1]);
  assert.equal(walk.journey.region, 19);
});

test('any walk on any network: no picture folds, and steps keep their length', () => {
  const random = randomOf(1);
  for (let trial = 0; trial < 12; trial++) {
    const apart = 3 + 30 * random();
    const walk = world([0, apart, 2 * apart, 3 * apart], [random(), 1 + 3 * random(), 3 + 4 * random()]);
    for (let leg = 0; leg < 40; leg++) {
      const angle = 2 * Math.PI * random();
      const speed = 5 * random();
      if (random() < 0.3) walk.stalled.add(Math.floor(4 * random()));
      if (random() < 0.3) walk.stalled.clear();
      if (random() < 0.15) {
        walk.journey.go({ position: [3 * apart * random(), 1.7, 4 * random()], yaw: 0, pitch: 0 });
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

test('a nearby place is reached at once, with the old picture in its position', () => {
  const walk = world([0, 40]);
  frames(walk, 72 * 12, STILL);
  walk.journey.go({ position: [5, 1.7, 2], yaw: 1, pitch: 0 });
  const leg = walk.frame(STILL);
  assert.deepEqual(walk.moves, [{ position: [5, 1.7, 2], yaw: 1, pitch: 0 }]);
  assert.deepEqual([leg.region, leg.leaving?.region, leg.leaving?.share], [0, 0, 0]);
  assert.deepEqual(leg.leaving?.pose?.position, [0, 1.7, 0]);
  const legs = frames(walk, 72, STILL);
  assert.equal(legs.at(-1)?.leaving, null);
  assert.equal(walk.log.includes('leave 0'), false);
});

test('a place in another region is reached when its first map has arrived, before other loads', () => {
  const walk = world([0, 100], [1, 2, 3]);
  frames(walk, 10, STILL);
  walk.journey.go({ position: [105, 1.7, 0], yaw: 0, pitch: 0 });
  frames(walk, 72, STILL);
  assert.equal(walk.journey.goal, 1);
  assert.equal(walk.opened.get(0)?.ring, -1);
  frames(walk, 30, STILL);
  assert.deepEqual([walk.journey.region, walk.journey.goal], [1, null]);
  assert.deepEqual(walk.place(), [105, 1.7, 0]);
  frames(walk, 72 * 4, STILL);
  assert.deepEqual([...walk.opened.keys()], [1]);
  // 5 m from the centre the first ring's radius does not fold.
  assert.deepEqual(walk.opened.get(1)?.shown?.grown, { radius: 22, strength: 1 });
});

test('where the first radius would fold, everything is shown from the centre until a ring is large enough', () => {
  const walk = world([0, 100], [0.1, 0.2, 5]);
  frames(walk, 72, STILL);
  walk.journey.go({ position: [112, 1.7, 0], yaw: 0, pitch: 0 });
  frames(walk, 72 * 4, STILL);
  assert.equal(walk.opened.get(1)?.shown?.grown.strength, 0);
  frames(walk, 72 * 5, STILL);
  const { radius, strength } = walk.opened.get(1)?.shown?.grown ?? {};
  assert.ok(radius === 22 && (strength ?? 0) > 0);
});

test('a place outside all regions is clamped into the nearest', () => {
  const walk = world([0, 30]);
  frames(walk, 72 * 12, STILL);
  walk.journey.go({ position: [500, 1.7, 0], yaw: 0, pitch: 0 });
  frames(walk, 72 * 2, STILL);
  assert.equal(walk.journey.region, 1);
  assertNear(walk.place()[0], 30 + 0.9 * MARGIN, 1e-9);
});

test('the page does not wait for a region that failed to load', () => {
  const walk = world([0, 100]);
  frames(walk, 72 * 2, STILL);
  walk.stalled.add(1);
  walk.journey.go({ position: [100, 1.7, 0], yaw: 0, pitch: 0 });
  frames(walk, 72, STILL);
  assert.equal(walk.journey.goal, 1);
  walk.journey.failed(1);
  frames(walk, 2, STILL);
  assert.equal(walk.journey.goal, null);
  assert.deepEqual([...walk.opened.keys()], [0]);
});

test('coarse maps replace fine ones only at the edge', () => {
  const walk = world([0, 16]);
  frames(walk, 72 * 12, STILL);
  walk.coarse.add(1);
  frames(walk, Math.round(72 * (8 / 1.4)), EAST);
  const loaded = walk.opened.get(1) as Loaded;
  // All rings but the one with the fine map.
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
