/** Files of trees: failing servers, missing or damaged documents; leaves within a small memory limit. */
import assert from 'node:assert/strict';
import { afterEach, mock, test } from 'node:test';
import { cameraOf } from '../src/orthoview/cut/camera';
import type { Piece } from '../src/orthoview/decode/leaf';
import { Shards } from '../src/orthoview/decode/shards';
import type { Drawer, GpuResource } from '../src/orthoview/draw/drawer';
import { createResidentTree } from '../src/orthoview/show/resident';
import { canRetry, type Kind, StoreError } from '../src/orthoview/store/error';
import { createFiles, type Files } from '../src/orthoview/store/files';
import { nameOf, parseLayout, type Triple } from '../src/orthoview/store/layout';
import { openRecords } from '../src/orthoview/store/records';

afterEach(() => mock.restoreAll());

/** Files of a server with prepared replies; `log` has the requested addresses and received bytes. */
function createTestFiles(reply: (init: RequestInit) => Promise<Response>) {
  const log: { urls: string[]; range: string | null; received: number } = { urls: [], range: null, received: 0 };
  mock.method(globalThis, 'fetch', (url: URL, init: RequestInit) => {
    log.urls.push(url.href);
    log.range = new Headers(init.headers).get('Range');
    return reply(init);
  });
  const files = createFiles(new URL('http://tree.test/a/?key=1'), (bytes) => (log.received += bytes));
  return { files, log };
}

const failing =
  (kind: Kind, word: string) =>
  (error: unknown): boolean =>
    error instanceof StoreError && error.kind === kind && error.message.includes(word);

test('a server that fails, does not answer or is too slow is distinguished from one without the file', async () => {
  const cases: [() => Promise<Response>, Kind, string][] = [
    [async () => new Response(null, { status: 500 }), 'refused', 'answers 500'],
    [() => Promise.reject(new TypeError('fetch failed')), 'unreachable', 'does not answer'],
    [() => Promise.reject(new DOMException('late', 'TimeoutError')), 'unreachable', 'too slow'],
  ];
  for (const [reply, kind, word] of cases) {
    const { files } = createTestFiles(reply);
    await assert.rejects(files.read({ path: 'b/c', version: 'v' }), (error) => failing(kind, word)(error));
    assert.ok(canRetry({ kind, message: word }));
    mock.restoreAll();
  }
  const { files } = createTestFiles(async () => new Response(null, { status: 404 }));
  const missing = 'there is no such tree';
  await assert.rejects(files.read({ path: 'b/c', missing }), (error) => failing('gone', missing)(error));
});

test('answers with a byte range and with a whole file are told apart', async () => {
  for (const status of [206, 200]) {
    const { files, log } = createTestFiles(async () => new Response(new Uint8Array(4), { status }));
    const found = await files.read({ path: 'b/c', version: 'v', part: [3, 4] });
    assert.equal(found?.isWhole, status === 200);
    assert.deepEqual(log, { urls: ['http://tree.test/a/b/c?key=1&v=v'], range: 'bytes=3-6', received: 4 });
    mock.restoreAll();
  }
});

test('an aborted request is not reported as a failure of the server', async () => {
  const controller = new AbortController();
  const { files } = createTestFiles(({ signal }) => Promise.reject(signal?.reason));
  controller.abort();
  await assert.rejects(files.read({ path: 'b/c', signal: controller.signal }), { name: 'AbortError' });
});

const DESCRIBED = {
  origin: [0, 0, 0],
  cell: 10,
  counts: [4, 4, 4],
  levels: 3,
  directions: [[0, 1, 0]],
  names: ['py'],
  size: 8,
  depth_bits: 12,
  normal_bits: 16,
  subtree: 3,
  color: 'zstd',
  quality: null,
  geometry: true,
  layers: 1,
};

const COMPLETE = { format: 'nearfar.orthoview', version: 2, generation: 0, complete: true, layout: DESCRIBED };

test('missing and damaged documents of a tree are told apart', async () => {
  const group = (attributes: object): string =>
    JSON.stringify({
      zarr_format: 3,
      node_type: 'group',
      attributes: { nearfar: { ...COMPLETE, ...attributes } },
    });
  const cases: [Record<string, string>, Kind, string][] = [
    [{}, 'gone', 'zarr.json'],
    [{ 'zarr.json': '{' }, 'damaged', 'zarr.json'],
    [{ 'zarr.json': '{"attributes": {}}' }, 'damaged', 'zarr.json'],
    [{ 'zarr.json': group({ version: 99 }) }, 'newer', 'zarr.json'],
    [{ 'zarr.json': group({ version: 1 }) }, 'damaged', 'build it again'],
    [{ 'zarr.json': group({ complete: false, failed: {} }) }, 'gone', 'has not ended'],
    [{ 'zarr.json': group({}) }, 'gone', 'records.json'],
    [{ 'zarr.json': group({ complete: false, failed: { '0_0_0': 'OSError' } }) }, 'gone', 'records.json'],
    [{ 'zarr.json': group({}), 'nearfar/records.json': '[]' }, 'damaged', 'records.json'],
  ];
  for (const [texts, kind, word] of cases) {
    const files: Files = {
      read: async ({ path, missing }) => {
        const text = texts[path];
        if (text === undefined) throw new StoreError('gone', `${path}: ${missing}`);
        return { bytes: new TextEncoder().encode(text), isWhole: true };
      },
    };
    await assert.rejects(openRecords(files), (error) => failing(kind, word)(error), `${kind} ${word}`);
  }
});

test('a record whose SHA-256 is not the listed one is damaged', async () => {
  const texts: Record<string, string> = {
    'zarr.json': JSON.stringify({ zarr_format: 3, node_type: 'group', attributes: { nearfar: COMPLETE } }),
    'nearfar/records.json': JSON.stringify({
      format: 'nearfar.orthoview_records',
      version: 1,
      records: { '0_0_0_0.json': 'a'.repeat(64) },
    }),
  };
  const files: Files = {
    read: async ({ path }) => ({ bytes: new TextEncoder().encode(texts[path] ?? '{}'), isWhole: true }),
  };
  const { subtree } = await openRecords(files);
  await assert.rejects(subtree(0, [0, 0, 0]), failing('damaged', 'SHA-256'));
});

test('a server that ignores ranges sends each shard once, and others only chunks', async () => {
  const content = Uint8Array.from({ length: 100 }, (_, index) => index);
  const { signal } = new AbortController();
  const warn = mock.method(console, 'warn', () => undefined);
  for (const isWhole of [true, false]) {
    const requested: string[] = [];
    const files: Files = {
      read: async ({ path, part: [first, length] = [0, 100] }) => {
        requested.push(path);
        return { bytes: isWhole ? content : content.slice(first, first + length), isWhole };
      },
    };
    const shards = new Shards(files);
    for (const [name, first] of [['a', 3], ['b', 7], ['a', 90], ['b', 50], ['a', 3]] as const)
      assert.deepEqual(await shards.read([name, 100, 'v'], [first, 5], signal), content.slice(first, first + 5));
    assert.deepEqual(requested, isWhole ? ['a', 'b'] : ['a', 'b', 'a', 'b', 'a']);
    assert.equal(warn.mock.callCount(), 1);
    await assert.rejects(shards.read(['c', 101, 'v'], [98, 3], signal), failing('damaged', 'c: '));
  }
});

test('leaves in the picture are not evicted, even beyond the limit', () => {
  const layout = parseLayout(DESCRIBED);
  let drawn: readonly number[] = [];
  const drawer: Drawer<GpuResource, GpuResource & { readonly number: number }> = {
    upload: () => ({ bytes: 1 }),
    drop: () => undefined,
    meshes: { upload: ({ origin }) => ({ bytes: 1000, number: origin[0] }), drop: () => undefined },
    draw: (meshes) => {
      drawn = meshes.map(({ number }) => number);
      return { splats: 0, triangles: 0, calls: 0 };
    },
    isDone: true,
    finish: async () => undefined,
    drawnSplats: null,
  };
  const resident = createResidentTree(layout, drawer, 4 * 2500);
  const leaf = (x: number): Triple => [x, 0, 0];
  const camera = cameraOf({ position: [0, 0, 0], yaw: 0, pitch: 0 }, 1, 64, 48);
  const loaded = (): number[] => [0, 1, 2, 3].filter((x) => resident.hasLeaf(leaf(x)));
  const draw = (drawnLeaves: readonly number[], retained: readonly number[] = []): void => {
    const leaves = new Set(retained.map((x) => nameOf(0, leaf(x))));
    const choice = { leaves: drawnLeaves.map(leaf), views: [], missingViews: [], missingLeaves: [], holes: 0 };
    resident.draw(choice, camera, 1, { cells: new Set(), leaves });
  };
  for (const x of [0, 1, 2, 3]) resident.addLeaf(leaf(x), [{ origin: leaf(x) } as unknown as Piece]);
  draw([0, 1, 2]);
  // Three leaves exceed the limit, but the picture shows them.
  assert.deepEqual([drawn, loaded()], [[0, 1, 2], [0, 1, 2]]);
  resident.addLeaf(leaf(3), [{ origin: leaf(3) } as unknown as Piece]);
  draw([3], [0]);
  assert.deepEqual([drawn, loaded()], [[3], [0, 3]]);
  // A later picture uses leaf 0 again, so that leaf 3 is the least recently used one.
  draw([0]);
  resident.addLeaf(leaf(1), [{ origin: leaf(1) } as unknown as Piece]);
  draw([1]);
  assert.deepEqual(loaded(), [0, 1]);
});
