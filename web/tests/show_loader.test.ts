import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readManifest } from '../src/bundle/parse';
import type { Decoder } from '../src/decode/messages';
import { createStore } from '../src/show/buffers';
import { type Loading, loadRegion, type RegionLoading } from '../src/show/loader';
import type { Cube } from '../src/show/textures';
import { FACES, FILE, manifest } from './support/manifest';

const [FIRST, SECOND, THIRD, SHARED] = [
  'files/aaaaaaaaaaaaaaaa.glb',
  'files/bbbbbbbbbbbbbbbb.glb',
  'files/cccccccccccccccc.glb',
  'files/dddddddddddddddd.bin',
] as const;

/**
 * A region of three rings without maps, whose files and decoder answer on command. The second ring shows what the
 * first one has brought.
 */
function createRegion() {
  const whole = readManifest(manifest({ [FIRST]: 10, [SECOND]: 20, [THIRD]: 30, [SHARED]: 5 }));
  const none = { geometry: null, parts: [], map: null };
  const rings = [
    { ...none, radius: 0 },
    { ...none, radius: 10, geometry: FIRST, parts: [SHARED] },
    { ...none, radius: 20, geometry: SECOND, parts: [SHARED] },
    { ...none, radius: 40, geometry: THIRD },
  ];
  const entry = { ...whole.regions[0], rings };
  const [files, decoded] = [new Map<string, () => void>(), new Map<string, () => void>()];
  const [asked, arrived]: [string[], number[]] = [[], []];
  const made = { bytes: 0, end: Promise.resolve() };
  const stop = new AbortController();
  const geometry = (async (request: any) => {
    if (request.kind !== 'geometry') return undefined;
    await new Promise<void>((done) => decoded.set(request.glb.name, done));
    return { number: 1, parts: 0, samples: [], triangles: { own: 0, drawn: 0 } };
  }) as unknown as Decoder;
  const loading = {
    store: createStore(),
    geometry,
    programs: { ready: async () => undefined },
    renderer: { getContext: () => null },
    fetch: async (name: string, signal: AbortSignal, received: (bytes: number) => void) => {
      asked.push(name);
      await new Promise<void>((done, failed) => {
        files.set(name, done);
        signal.addEventListener('abort', () => failed(signal.reason as Error));
      });
      received(whole.files[name]?.bytes ?? 0);
      return new ArrayBuffer(0);
    },
  } as unknown as Loading;
  const course = {
    manifest: whole,
    region: { entry, groups: rings.map(() => ({})), triangles: [] },
    number: 0,
    arrived: (ring: number) => arrived.push(ring),
    received: (bytes: number) => (made.bytes += bytes),
    waitForRing: async (ring: number) => rings[ring],
    mayReplace: async () => undefined,
    signal: stop.signal,
  } as unknown as RegionLoading;
  made.end = loadRegion(loading, course);
  const settled = (): Promise<void> => new Promise((done) => setTimeout(done, 1));
  const act = async (on: Map<string, () => void>, ...names: readonly string[]): Promise<void> => {
    await settled();
    for (const name of names) on.get(name)?.();
    await settled();
  };
  return {
    made, asked, arrived, stop, loading,
    come: (...names: string[]) => act(files, ...names),
    decode: (...names: string[]) => act(decoded, ...names),
  };
}

test('while a ring is built, files of the next ring are fetched, and no others', async () => {
  const { asked, arrived, come, decode } = createRegion();
  await come(FIRST, SHARED);
  assert.deepEqual(arrived, [0]);
  assert.deepEqual(asked, [FIRST, SHARED, SECOND]);
  await come(SECOND);
  assert.deepEqual(arrived, [0]);
  await decode(FIRST);
  assert.deepEqual([arrived, asked.at(-1)], [[0, 1], THIRD]);
});

test('rings are shown in order, whatever arrives first', async () => {
  const { made, arrived, come, decode } = createRegion();
  await come(SECOND);
  assert.deepEqual(arrived, [0]);
  await come(SHARED, FIRST);
  await decode(FIRST);
  await come(THIRD);
  assert.deepEqual(arrived, [0, 1]);
  await decode(SECOND);
  await decode(THIRD);
  await made.end;
  assert.deepEqual(arrived, [0, 1, 2, 3]);
});

test('a file that two rings need is fetched and counted once', async () => {
  const { made, asked, come, decode, loading } = createRegion();
  await come(FIRST, SHARED, SECOND);
  await decode(FIRST);
  await come(THIRD);
  await decode(SECOND);
  await decode(THIRD);
  await made.end;
  assert.equal(asked.filter((name) => name === SHARED).length, 1);
  assert.equal(made.bytes, 65);
  assert.ok(loading.store.buffers.has(SHARED));
});

test('a missing file ends loading with the rings before it', async () => {
  const { made, arrived, stop, come } = createRegion();
  const ended = assert.rejects(made.end, /enough/);
  await come(FIRST);
  stop.abort(new Error('enough'));
  await ended;
  assert.deepEqual(arrived, [0]);
});

test('a full-size map replaces the cube of its own ring, not the one that is shown', async () => {
  const whole = readManifest(manifest());
  const none = { geometry: null, parts: [], map: null };
  const layout = { face_size: 128, tile: 64, across: 16 };
  const maps = [{ color: FACES, tiles: [], range: null }, { color: FILE, tiles: [0], range: null }];
  const rings = [
    { ...none, radius: 0 },
    { ...none, radius: 10, sharper: { layout, maps, range: { least: 0.5, step: 0.001 } } },
    { ...none, radius: 20, sharper: { layout, maps, range: { least: 0.5, step: 0.001 } } },
  ];
  const disposed: number[] = [];
  const coarse = [0, 1].map((index) => ({ size: 64, dispose: () => disposed.push(index) }));
  const cubes = [...coarse] as unknown as Cube[];
  const replaced: [number, number[]][] = [];
  const gl = new Proxy({}, { get: () => () => ({}) });
  const properties = { get: () => ({}), remove: () => undefined };
  const loading = {
    store: createStore(),
    maps: async () => ({}),
    uploads: { add: async () => undefined },
    renderer: { getContext: () => gl, resetState: () => undefined, properties },
    fetch: async () => new ArrayBuffer(0),
  } as unknown as Loading;
  const course = {
    manifest: whole,
    region: { entry: { ...whole.regions[0], rings }, groups: [], triangles: [], cubes },
    number: 0,
    arrived: (ring: number) => replaced.push([ring, cubes.map(({ size }) => size)]),
    received: () => undefined,
    waitForRing: async (ring: number) => rings[ring],
    mayReplace: async () => undefined,
    signal: new AbortController().signal,
  } as unknown as RegionLoading;
  await loadRegion(loading, course);
  assert.deepEqual(replaced, [[0, [64, 64]], [1, [64, 128]], [2, [128, 128]]]);
  assert.deepEqual(disposed, [1, 0]);
});
