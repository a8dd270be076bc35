import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BundleError } from '../src/bundle/error';
import type { FileEntry } from '../src/bundle/manifest';
import type { Network } from '../src/bundle/transfer';
import { type ServerProgress, readPlace } from '../src/demand/place';
import { request, linesOf } from '../src/demand/request';
import { isSite, readScene, readSite } from '../src/demand/scene';
import { createGrid } from '../src/demand/world';
import { FACES, FILE, manifest } from './support/manifest';

const OTHER = 'files/fedcba9876543210.webp';
const BASE = new URL('http://example.test/site/');
const ENTRY = { bytes: 3, sha256: 'a'.repeat(64) };

/** Stream of lines that the test sends. */
function createChannel() {
  const waitingReaders: ((line: IteratorResult<unknown>) => void)[] = [];
  const unreadLines: IteratorResult<unknown>[] = [];
  const deliver = (line: IteratorResult<unknown>): void => {
    const reader = waitingReaders.shift();
    if (reader) reader(line);
    else unreadLines.push(line);
  };
  const lines: AsyncIterator<unknown> = {
    next: () => {
      const line = unreadLines.shift();
      return line ? Promise.resolve(line) : new Promise((done) => waitingReaders.push(done));
    },
  };
  return {
    lines,
    send: (...values: unknown[]) => values.forEach((value) => deliver({ done: false, value })),
    end: () => deliver({ done: true, value: undefined }),
  };
}

function createListener() {
  const progresses: ServerProgress[] = [];
  const files: Record<string, FileEntry> = {};
  return {
    progresses,
    files,
    listener: {
      onFiles: (entries: Readonly<Record<string, FileEntry>>) => void Object.assign(files, entries),
      onProgress: (progress: ServerProgress) => void progresses.push(progress),
    },
  };
}

/** Manifest at the beginning of a stage; faces of maps have `faceSize` texels along an edge. */
function outline(faceSize: number): Record<string, unknown> {
  const whole = manifest() as { regions: Record<string, unknown>[]; files: unknown };
  const rings = (whole.regions[0]?.['rings'] as object[]).map((ring) => ({ ...ring, geometry: null, parts: [], map: null }));
  const map = { face_size: faceSize, tile: 64, across: 16 };
  return { ...whole, map, regions: [{ ...whole.regions[0], range: { least: faceSize, step: 0.001 }, rings }], files: {} };
}

const begin = (stage: number) => ({ event: 'begin', stage, manifest: outline(64 * (stage + 1)), files: {} });

function ring(stage: number, number: number, file = FILE): unknown {
  const entry = ((manifest() as any).regions[0].rings as any[])[number];
  const renamed: unknown = JSON.parse(JSON.stringify(entry).replaceAll(FILE, file));
  return { event: 'ring', stage, ring: number, entry: renamed, files: { [file]: ENTRY } };
}

const waitForReader = (): Promise<void> => new Promise((done) => setTimeout(done, 1));

test('rings can be fetched as they are announced, and full-size maps replace coarse ones', async () => {
  const { lines, send, end } = createChannel();
  const { files, listener, progresses } = createListener();
  send({ event: 'waiting', before: 2 }, begin(0));
  const region = await readPlace(lines, null, listener);
  assert.deepEqual(progresses, [{ stage: 'waiting', before: 2 }, { stage: 'coarse' }]);
  assert.deepEqual(region.entry.rings.map(({ radius }) => radius), [0, 10, 22, 22]);
  assert.ok(region.entry.isCoarse);
  const first = region.ring(0);
  assert.ok(first instanceof Promise);
  assert.deepEqual(files, {});
  send(ring(0, 0));
  assert.deepEqual((await first).map?.color, FACES);
  assert.deepEqual(Object.keys(files), [FILE]);
  // The ring has arrived, so it is returned at once.
  assert.deepEqual(region.ring(0), region.entry.rings[0]);
  assert.equal(region.manifest.map.face_size, 64);
  const last = region.ring(3);
  send(ring(0, 1), ring(0, 2), begin(1), ring(1, 0, OTHER), ring(1, 1, OTHER), ring(1, 2));
  await waitForReader();
  assert.equal(region.entry.rings[3]?.sharper, undefined);
  send({ event: 'end', stage: 1 });
  const { sharper, map, geometry } = await last;
  assert.deepEqual([map, geometry], [null, null]);
  assert.deepEqual([sharper?.layout.face_size, sharper?.range.least, sharper?.maps.length], [128, 128, 3]);
  assert.equal(progresses.at(-1)?.stage, 'full');
  end();
});

test('an existing place arrives complete', async () => {
  const { lines, send } = createChannel();
  const { files, listener, progresses } = createListener();
  send({ event: 'whole', manifest: manifest() });
  const region = await readPlace(lines, null, listener);
  assert.equal(region.entry.isCoarse, undefined);
  assert.equal(region.ring(2), region.entry.rings[2]);
  assert.deepEqual(progresses, [{ stage: 'full' }]);
  assert.deepEqual(Object.keys(files), [FILE]);
});

test('rings beyond the last requested one are ignored', async () => {
  const { lines, send } = createChannel();
  send(begin(0), ring(0, 0), ring(0, 1), ring(0, 2), begin(1), ring(1, 0), ring(1, 1), ring(1, 2), { event: 'end' });
  const region = await readPlace(lines, '1', createListener().listener);
  assert.equal(region.entry.rings.length, 3);
  assert.equal((await region.ring(2)).sharper?.maps.length, 2);
});

test('failures, ends of the connection and damage reject what is awaited', async () => {
  const cases: [lines: unknown[], kind: string, message: RegExp][] = [
    [[{ event: 'failed', reason: 'center: expected one with objects around it' }], 'place', /^center: expected one/],
    [[], 'network', /connection ended/],
    [[{ event: 'other' }], 'damaged', /parts\.event: expected waiting or begin/],
    [['text'], 'damaged', /parts: expected an object/],
    [[{ event: 'end', stage: 1 }], 'damaged', /expected another event, got end/],
    [[{ event: 'begin', manifest: null }], 'damaged', /manifest: expected an object/],
  ];
  for (const [lines, kind, message] of cases) {
    const channel = createChannel();
    channel.send(...lines);
    channel.end();
    await assert.rejects(readPlace(channel.lines, null, createListener().listener), (error: BundleError) => {
      assert.match(error.message, message);
      return error.kind === kind;
    });
  }
  const casesAfterBegin: [lines: unknown[], message: RegExp][] = [
    [[{ event: 'failed', reason: 'the disk is gone' }], /the disk is gone$/],
    [[], /connection ended/],
    [[ring(1, 0)], /got ring/],
    [[begin(1), ring(1, 1)], /got ring/],
    [[{ event: 'end' }], /got end/],
    [[begin(1), ring(1, 0), { event: 'end' }], /got end/],
    [[{ ...(ring(0, 0) as object), files: { '../secret': ENTRY } }], /files/],
    [[{ ...(ring(0, 0) as object), entry: { radius: 0 } }], /ring 0\.objects/],
  ];
  for (const [lines, message] of casesAfterBegin) {
    const { lines: read, send, end } = createChannel();
    send(begin(0));
    const region = await readPlace(read, null, createListener().listener);
    send(...lines);
    end();
    await assert.rejects(Promise.resolve(region.ring(3)), message);
  }
});

test('complete lines are yielded, however the stream is divided into chunks', async () => {
  const bytes = new TextEncoder().encode('{"a":"ä"}\n[1]\n2');
  for (const size of [1, 3, 100]) {
    const pieces = Array.from({ length: Math.ceil(bytes.length / size) }, (_, n) => bytes.slice(n * size, (n + 1) * size));
    const body = new ReadableStream({
      start(control) {
        for (const piece of pieces) control.enqueue(piece);
        control.close();
      },
    });
    const found = [];
    for await (const line of linesOf('parts', new Response(body), 100)) found.push(line);
    assert.deepEqual(found, [{ a: 'ä' }, [1], 2]);
  }
  await assert.rejects(async () => {
    for await (const line of linesOf('parts', new Response('x'.repeat(101)), 100)) assert.fail(String(line));
  }, /expected lines of at most 100/);
  await assert.rejects(async () => {
    for await (const line of linesOf('parts', new Response('{"a":\n'), 100)) assert.fail(String(line));
  }, /parts: expected JSON/);
});

/** Network with prepared answers, which records waiting times. */
function createNetwork(...answers: (Response | Error)[]) {
  const waits: number[] = [];
  const network: Network = {
    fetch: async () => {
      const answer = answers.shift();
      if (answer instanceof Response) return answer;
      throw answer ?? new Error('nobody listens');
    },
    wait: async (seconds) => void waits.push(seconds),
  };
  return { network, waits };
}

test('requests are repeated: to a busy server after the time that it states, to an unreachable one a few times', async () => {
  const { signal } = new AbortController();
  const busyAnswer = (status: number, seconds?: string) =>
    new Response('', { status, headers: seconds === undefined ? {} : { 'retry-after': seconds } });
  const pauses: number[] = [];
  const first = createNetwork(
    ...[busyAnswer(429, '3'), busyAnswer(503), busyAnswer(503, 'Tomorrow'), busyAnswer(503, '9999')],
    ...[new Error('lost'), new Response('yes')],
  );
  const answer = await request(BASE, 'place', (seconds) => void pauses.push(seconds), signal, first.network);
  assert.equal(await answer.text(), 'yes');
  assert.deepEqual(pauses, [3, 2, 2, 60]);
  assert.deepEqual(first.waits, [3, 2, 2, 60, 0.5]);
  const second = createNetwork();
  await assert.rejects(request(BASE, 'place', () => undefined, signal, second.network), /cannot be reached: nobody listens/);
  assert.deepEqual(second.waits, [0.5, 1, 2, 4]);
  const third = createNetwork(new Response('400 Bad Request: expected three numbers\n', { status: 400 }));
  await assert.rejects(request(BASE, 'place', () => undefined, signal, third.network), (error: BundleError) => {
    return error.kind === 'place' && error.message === 'expected three numbers';
  });
});

test('a place on the grid has one number, and its margin after the server has sent it', () => {
  const grid = createGrid(2);
  const first = grid.nearest([0.9, 1.7, -0.9]);
  assert.deepEqual(grid.spotOf(first).center.join(), '0,1.75,0');
  assert.equal(grid.nearest([-0.6, 1.76, 0.3]), first);
  assert.notEqual(grid.nearest([1.1, 1.7, 0]), first);
  grid.record(first, { center: [0, 1.75, 0], fold_margin: 44 });
  assert.equal(grid.spotOf(first).fold_margin, 44);
});

test('the user\'s place is preloaded when half of the way to the limit is left, and kept while it is near', () => {
  const grid = createGrid(2);
  const current = grid.nearest([0, 1.75, 0]);
  const at = (z: number, preloaded: number | null, metres = 44) => {
    return grid.regionToPreload({ place: [0, 1.75, z], current, preloaded, limit: { center: [0, 1.75, 0], metres } });
  };
  assert.equal(at(21, null), null);
  const next = at(23, null) as number;
  assert.deepEqual(grid.spotOf(next).center, [0, 1.75, 24]);
  // The user moves on, and then back.
  assert.equal(at(30, next), next);
  assert.equal(at(19, next), next);
  assert.equal(at(17, next), null);
  // Another place is nearer to a user at the side.
  const limit = { center: [0, 1.75, 0], metres: 44 } as const;
  const sidePlace = grid.regionToPreload({ place: [18, 1.75, 18], current, preloaded: next, limit });
  assert.deepEqual(grid.spotOf(sidePlace as number).center, [18, 1.75, 18]);
  // The limit depends on the current picture.
  assert.deepEqual(grid.spotOf(at(5.2, null, 7) as number).center, [0, 1.75, 6]);
  assert.equal(at(5, null), null);
  assert.equal(at(0.5, null, 0.6), null);
});

const SITE = { format: 'nearfar.on_demand', version: 1, title: 'a city', grid: 2, scene: 'files/0123456789abcdef.json' };
const SCENE = {
  format: 'nearfar.scene',
  version: 1,
  triangles: 12,
  bounds: [[0, 0, 0], [1, 1, 1]],
  start: { position: [0, 1.7, 0], yaw: 1 },
  face_size: 1024,
  near_share: 0.7,
  growth: { speed: 0.7, reach: 1, fade: 0.5 },
  is_static: true,
};

test('the documents of a scene are parsed, and errors name the damaged field', async () => {
  const { signal } = new AbortController();
  assert.ok(isSite(SITE));
  assert.ok(![manifest(), null, 3, []].some(isSite));
  const site = readSite(SITE);
  const read = (document: unknown) => {
    return readScene(BASE, site, signal, createNetwork(new Response(JSON.stringify(document))).network);
  };
  assert.deepEqual((await read(SCENE)).start, { position: [0, 1.7, 0], yaw: 1 });
  const cases: [change: object, message: RegExp][] = [
    [{ format: 'nearfar.bundle' }, /expected the format nearfar\.scene/],
    [{ version: 2 }, /newer nearfar/],
    [{ start: { position: [0, 1], yaw: 0 } }, /start\.position/],
    [{ growth: null }, /growth/],
    [{ face_size: 1e6 }, /face_size/],
    [{ near_share: 1 }, /near_share/],
    [{ failed: 'scene.glb: the scene cannot be loaded' }, /scene\.glb: the scene cannot be loaded$/],
  ];
  for (const [change, message] of cases) await assert.rejects(read({ ...SCENE, ...change }), message);
  for (const change of [{ version: 2 }, { grid: 0 }, { scene: '../x.json' }, { title: 3 }]) {
    assert.throws(() => readSite({ ...SITE, ...change }), BundleError);
  }
});
