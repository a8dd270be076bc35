/** Parts of the page of trees: stand-ins for missing views, requests, GPU memory, codecs, layouts, flight. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NO_MOTION } from '../src/control/drive';
import { Cells, type Cut } from '../src/orthoview/cut/cut';
import { crc32c, contentSize, decompressZstd, xxh64 } from '../src/orthoview/decode/codecs';
import { advanceFlight, startPose } from '../src/orthoview/fly';
import { Queue } from '../src/orthoview/show/queue';
import { choose, type GeometryState } from '../src/orthoview/show/stand_in';
import { GpuCache } from '../src/orthoview/show/resident';
import type { Failure } from '../src/orthoview/store/error';
import { type Layout, parseLayout, cellCounts, type Triple } from '../src/orthoview/store/layout';

const DESCRIBED = {
  origin: [0, 0, 0],
  cell: 10,
  counts: [4, 4, 4],
  levels: 3,
  directions: [
    [0, 0, 1],
    [1, 0, 0],
    [0, 1, 0],
  ],
  names: ['pz', 'px', 'py'],
  size: 8,
  depth_bits: 12,
  normal_bits: 16,
  subtree: 3,
  color: 'zstd',
  quality: null,
  geometry: false,
  layers: 1,
};
const LAYOUT = parseLayout(DESCRIBED);

/** Cells of a tree of three levels, which have views of all directions, except the cells in `empty`. */
function cellsOf(layout: Layout, empty: readonly string[] = []): Cells {
  const cells = new Cells(layout);
  const shapes = cellCounts(layout, 0);
  const masks = shapes.map((count) => new Uint32Array(count).fill(7));
  for (const name of empty) {
    const [level, x, y, z] = name.split('/').map(Number) as [number, number, number, number];
    const side = 2 ** (3 - level);
    (masks[level] as Uint32Array)[(x * side + y) * side + z] = 0;
  }
  cells.add({
    tier: 0,
    place: [0, 0, 0],
    masks,
    generations: shapes.map((count) => new Uint16Array(count)),
    shards: [],
    geometry: [],
    guests: new Map([['0/0/0/0', [[0, 0, 1] as const]]]),
  });
  return cells;
}

function cutOf(...cells: readonly (readonly [number, Triple, readonly number[]])[]): Cut {
  const drawn = cells.map(([level, place, directions], distance) => ({
    level,
    place,
    directions,
    distance,
    isInPicture: true,
  }));
  return { cells: drawn, leaves: [], leafDistance: 1, unknown: [], unbuilt: 0 };
}

/** A cut whose leaves are all drawn as geometry. */
function geometryCutOf(...cells: readonly (readonly [number, Triple, readonly number[]])[]): Cut {
  const { cells: leaves, ...cut } = cutOf(...cells);
  return { ...cut, cells: [], leaves };
}

type StateOf = (leaf: Triple) => GeometryState;

const ROOT = '2/0/0/0';
const NONE: Readonly<Record<string, readonly number[]>> = {};

function chooseParts(
  cut: Cut,
  loaded: Readonly<Record<string, readonly number[]>>,
  cells = cellsOf(LAYOUT),
  stateOf: StateOf = () => 'missing',
) {
  const directionsOf = (level: number, place: Triple): readonly number[] => loaded[[level, ...place].join('/')] ?? [];
  const { views, missingViews, holes, leaves, missingLeaves } = choose(cut, cells, directionsOf, 2, stateOf);
  const name = ({ level, place, direction }: { level: number; place: Triple; direction: number }): string =>
    `${[level, ...place].join('/')}:${direction}`;
  return {
    shown: views.map((each) => name(each) + (each.box ? ` in ${[each.box.level, ...each.box.place].join('/')}` : '')),
    missing: missingViews.map(name),
    holes,
    ...(cut.leaves.length > 0 ? { leaves, missingLeaves } : {}),
  };
}

test('cells are drawn from their own views', () => {
  const found = chooseParts(cutOf([1, [0, 0, 0], [0, 1]]), { '1/0/0/0': [2, 1, 0], [ROOT]: [0, 1] });
  assert.deepEqual(found, { shown: ['1/0/0/0:0', '1/0/0/0:1'], missing: [], holes: 0 });
});

test('after a turn a cell is drawn from the views that are loaded', () => {
  const found = chooseParts(cutOf([1, [0, 0, 0], [0, 2]]), { '1/0/0/0': [0, 1], [ROOT]: [0, 1] });
  assert.deepEqual(found, { shown: ['1/0/0/0:0', '1/0/0/0:1'], missing: ['1/0/0/0:2'], holes: 0 });
});

test('views of an ancestor stand in within the box of the missing cell', () => {
  const cut = cutOf([0, [3, 2, 1], [0, 1]], [0, [0, 0, 0], [0, 1]]);
  const found = chooseParts(cut, { '0/0/0/0': [0, 1], '1/1/1/0': [0], [ROOT]: [0, 1] });
  // The parent has only one of two views; the root has both.
  assert.deepEqual(found.shown, [`${ROOT}:0 in 0/3/2/1`, `${ROOT}:1 in 0/3/2/1`, '0/0/0/0:0', '0/0/0/0:1']);
  assert.deepEqual(found.missing, ['0/3/2/1:0', '0/3/2/1:1']);
});

test('views stand in for a leaf until its geometry and that of its guests are loaded', () => {
  const cut = geometryCutOf([0, [0, 0, 0], [0, 1]], [0, [1, 1, 1], [0, 1]]);
  const stateWithout = (...names: readonly string[]): StateOf => {
    return (place) => (names.includes(place.join('/')) ? 'missing' : 'loaded');
  };
  const found = chooseParts(cut, { [ROOT]: [0, 1] }, undefined, stateWithout('0/0/1'));
  // The leaf's own views are not requested.
  const shown = [`${ROOT}:0 in 0/0/0/0`, `${ROOT}:1 in 0/0/0/0`];
  assert.deepEqual(found, { shown, missing: [], holes: 0, leaves: [[1, 1, 1]], missingLeaves: [[0, 0, 1]] });
  const all = chooseParts(cut, { [ROOT]: [0, 1] }, undefined, stateWithout());
  const leaves = [
    [0, 0, 0],
    [0, 0, 1],
    [1, 1, 1],
  ];
  assert.deepEqual(all, { shown: [], missing: [], holes: 0, leaves, missingLeaves: [] });
});

test('a leaf whose geometry cannot be drawn is drawn from views', () => {
  const stateOf: StateOf = (place) => (place.join('/') === '0/0/1' ? 'undrawable' : 'loaded');
  const found = chooseParts(geometryCutOf([0, [0, 0, 0], [0, 1]]), { '0/0/0/0': [1], [ROOT]: [0, 1] }, undefined, stateOf);
  assert.deepEqual(found.missing, ['0/0/0/0:0']);
  assert.deepEqual(found.shown, [`${ROOT}:0 in 0/0/0/0`, `${ROOT}:1 in 0/0/0/0`]);
  assert.deepEqual([found.leaves, found.missingLeaves], [[], []]);
});

test('views of descendants stand in if they cover the whole cell', () => {
  const children = Object.fromEntries(
    [...Array(8).keys()].map((n) => [`0/${n >> 2}/${(n >> 1) & 1}/${n & 1}`, [0, 1]]),
  );
  const cut = cutOf([1, [0, 0, 0], [0, 1]]);
  assert.equal(chooseParts(cut, { ...children, [ROOT]: [0, 1] }).shown.length, 16);
  const { '0/1/1/1': _, ...sevenChildren } = children;
  assert.deepEqual(chooseParts(cut, { ...sevenChildren, [ROOT]: [0, 1] }).shown, [`${ROOT}:0 in 1/0/0/0`, `${ROOT}:1 in 1/0/0/0`]);
  // The eighth child is empty.
  assert.equal(chooseParts(cut, { ...sevenChildren, [ROOT]: [0, 1] }, cellsOf(LAYOUT, ['0/1/1/1'])).shown.length, 14);
});

test('a cell is drawn from too few views rather than from none', () => {
  const cut = cutOf([1, [0, 0, 0], [0, 1]]);
  assert.deepEqual(chooseParts(cut, { '1/0/0/0': [1] }).shown, ['1/0/0/0:1']);
  assert.equal(chooseParts(cut, { '1/0/0/0': [1] }).holes, 0);
  assert.equal(chooseParts(cut, NONE).holes, 1);
});

function createQueue(maxRunning = 2) {
  const log: { sent: [number, string][]; cancelled: number[]; failed: string[]; recovered: number; now: number } = {
    recovered: 0,
    sent: [],
    cancelled: [],
    failed: [],
    now: 0,
  };
  const queue = new Queue<string>({
    maxRunning,
    send: (id, job) => log.sent.push([id, job]),
    cancel: (id) => log.cancelled.push(id),
    onFailure: ({ message }) => log.failed.push(message),
    onRecovered: () => (log.recovered += 1),
    now: () => log.now,
  });
  const request = (...names: string[]): void => queue.replace(new Map(names.map((name) => [name, name])));
  return { queue, log, request };
}

test('views of high priority are requested first, up to the concurrency limit', () => {
  const { queue, log, request } = createQueue();
  request('a', 'b', 'c');
  assert.deepEqual(log.sent, [
    [1, 'a'],
    [2, 'b'],
  ]);
  assert.equal(queue.recordArrival(1), 'a');
  queue.fill();
  assert.deepEqual(log.sent.at(-1), [3, 'c']);
  assert.equal(queue.waiting, 2);
  request('b', 'd');
  assert.deepEqual(log.cancelled, [3]);
  // A slot is free when the cancelled request has ended.
  assert.equal(log.sent.length, 3);
  queue.recordCancellation(3);
  assert.deepEqual(log.sent.at(-1), [4, 'd']);
});

const GONE: Failure = { kind: 'gone', message: 'a shard is gone' };
const AWAY: Failure = { kind: 'unreachable', message: 'no answer' };

test('temporary failures are retried with growing pauses, and reported once', () => {
  const { queue, log, request } = createQueue();
  request('a', 'b');
  queue.recordFailure(2, { ...AWAY, message: 'no answer for b' });
  assert.deepEqual(log.failed, ['no answer for b']);
  log.failed = [];
  request('a');
  const starts = [0];
  for (const id of [1, 3, 4]) {
    queue.recordFailure(id, AWAY);
    const { length } = log.sent;
    while (log.sent.length === length) {
      log.now += 0.5;
      queue.fill();
    }
    starts.push(log.now);
  }
  assert.deepEqual(starts, [0, 1, 3, 7]);
  assert.deepEqual(log.failed, []);
  assert.equal(queue.recordArrival(5), 'a');
  assert.equal(log.recovered, 1);
});

test('damaged views are retried only if the user asks', () => {
  const { queue, log, request } = createQueue();
  request('a', 'b');
  queue.recordFailure(1, GONE);
  log.now = 1e6;
  queue.fill();
  assert.equal(log.sent.length, 2);
  assert.equal(queue.waiting, 1);
  queue.retry();
  assert.deepEqual(log.sent.at(-1), [3, 'a']);
});

test('the least recently used views are evicted, but no view in the picture', () => {
  const dropped: number[] = [];
  const resident = new GpuCache<{ bytes: number }>(({ bytes }) => dropped.push(bytes), 100);
  [40, 44, 48].forEach((bytes, direction) => resident.add(0, [1, 2, 3], direction, [{ bytes }]));
  assert.equal(resident.bytes, 4 * 33);
  resident.begin();
  assert.equal(resident.use(0, [1, 2, 3], 0).length, 1);
  resident.trim(() => false);
  // 132 bytes exceed the limit by 32: the second view is evicted, since the first one is in the picture.
  assert.deepEqual(dropped, [44]);
  assert.deepEqual(resident.directionsOf(0, [1, 2, 3]), [0, 2]);
  resident.add(0, [1, 2, 3], 1, [{ bytes: 80 }]);
  resident.trim(() => true);
  assert.equal(resident.count, 3);
});

test('checksums and sizes are read', () => {
  // Test vector of RFC 3720, B.4.
  assert.equal(crc32c(new Uint8Array(32)), 0x8a9136aa);
  assert.equal(crc32c(Uint8Array.from({ length: 32 }, (_, n) => n)), 0x46dd794e);
  // Hash by the reference implementation, seed 0.
  const text = (letters: string): Uint8Array => new TextEncoder().encode(letters);
  assert.equal(xxh64(text('')), 0xef46db3751d8e999n);
  assert.equal(xxh64(text('abc')), 0x44bc2cf5ad770999n);
  assert.equal(xxh64(text('xxhash')), 0x32dd38952c4bc720n);
  const frame = (...bytes: number[]): Uint8Array =>
    Uint8Array.from([0x28, 0xb5, 0x2f, 0xfd, ...bytes, ...Array(12).fill(0)]);
  assert.equal(contentSize(frame(0x20, 77)), 77);
  assert.equal(contentSize(frame(0x60, 1, 2)), 256 + 0x201);
  assert.equal(contentSize(frame(0xa4, 1, 2, 3, 0)), 0x30201);
  assert.equal(contentSize(frame(0xe0, 1, 0, 0, 0, 2, 0, 0, 0)), 2 ** 33 + 1);
  assert.equal(contentSize(frame(0x80, 99, 5, 0, 0, 0)), 5);
  assert.equal(contentSize(frame(0x00, 99)), null);
});

test('altered Zstandard frames are rejected', () => {
  const content = new TextEncoder().encode('an uncompressed block');
  const sum = new Uint8Array(4);
  new DataView(sum.buffer).setUint32(0, Number(xxh64(content) & 0xffff_ffffn), true);
  // Header of a single segment with a checksum, and of the last block, which is uncompressed.
  const head = [0x28, 0xb5, 0x2f, 0xfd, 0x24, content.length, (content.length << 3) | 1, 0, 0];
  const frame = Uint8Array.from([...head, ...content, ...sum]);
  assert.deepEqual(decompressZstd(frame, content.length), content);
  for (let at = head.length; at < frame.length; at++) {
    const altered = frame.slice();
    altered[at] = (altered[at] as number) ^ 1;
    assert.throws(() => decompressZstd(altered, content.length), /checksum/);
  }
  const huge = Uint8Array.from([0x28, 0xb5, 0x2f, 0xfd, 0xe4, 0, 0, 0, 0, 1, 0, 0, 0, ...frame]);
  assert.throws(() => decompressZstd(huge, content.length), /states 4294967296 bytes/);
});

test('inconsistent layouts are rejected', () => {
  for (const wrong of [
    { size: 10 },
    { levels: 2 },
    { directions: [[0, 0, 2]] },
    { names: ['pz'] },
    { cell: 0 },
    { subtree: 9 },
  ]) {
    assert.throws(() => parseLayout({ ...DESCRIBED, ...wrong }), /zarr\.json/);
  }
});

test('flight is faster at greater height, and follows the view', () => {
  const start = { position: [0, 12, 0] as Triple, yaw: 0, pitch: 0 };
  const low = advanceFlight(start, { ...NO_MOTION, ahead: 1 }, 0, 0, 2, 0.5);
  assert.deepEqual(low.position, [0, 12, -3]);
  const high = advanceFlight({ ...start, position: [0, 102, 0] }, { ...NO_MOTION, right: 1 }, 1, 1, 2, 0.1);
  assert.ok(Math.hypot(high.position[0] - 12, high.position[1] - 114, high.position[2]) < 1e-9);
  const dive = advanceFlight({ ...start, pitch: -Math.PI / 6 }, { ...NO_MOTION, ahead: 1, isRunning: true }, 0, 0, 2, 0.5);
  assert.ok(Math.abs(dive.position[1] - 6) < 1e-9);
});

test('without a link the flight begins above the world, looking at its centre', () => {
  const { position, pitch } = startPose(LAYOUT);
  assert.equal(position[0], 20);
  assert.ok(Math.abs(position[1] / (position[2] - 20) - Math.tan(-pitch)) < 1e-9);
  assert.ok(position[1] > 0);
});
