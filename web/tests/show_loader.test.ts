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
 * Begins to load a region of three rings without maps. Files arrive, and geometry is decoded, when the test says so.
 * The first two rings have a part in common.
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
  const [requested, arrived]: [string[], number[]] = [[], []];
  const progress = { bytes: 0, end: Promise.resolve() };
  const stop = new AbortController();
  const geometry = (async (request: any) => {
    if (request.kind !== 'geometry') return undefined;
    await new Promise<void>((done) => decoded.set(request.glb.name, done));
    return { number: 1, parts: 0, samples: [], triangles: { inFile: 0, drawn: 0 } };
  }) as unknown as Decoder;
  const loading = {
    store: createStore(),
    geometry,
    programs: { compileFor: async () => undefined },
    renderer: { getContext: () => null },
    fetch: async (name: string, signal: AbortSignal, onBytes: (bytes: number) => void) => {
      requested.push(name);
      await new Promise<void>((done, failed) => {
        files.set(name, done);
        signal.addEventListener('abort', () => failed(signal.reason as Error));
      });
      onBytes(whole.files[name]?.bytes ?? 0);
      return new ArrayBuffer(0);
    },
  } as unknown as Loading;
  const regionLoading = {
    manifest: whole,
    region: { entry, groups: rings.map(() => ({})), triangles: [] },
    number: 0,
    onRing: (ring: number) => arrived.push(ring),
    onBytes: (bytes: number) => (progress.bytes += bytes),
    waitForRing: async (ring: number) => rings[ring],
    waitForCube: async () => undefined,
    signal: stop.signal,
  } as unknown as RegionLoading;
  progress.end = loadRegion(loading, regionLoading);
  const pause = (): Promise<void> => new Promise((done) => setTimeout(done, 1));
  const finish = async (waiting: Map<string, () => void>, names: readonly string[]): Promise<void> => {
    await pause();
    for (const name of names) waiting.get(name)?.();
    await pause();
  };
  return {
    progress, requested, arrived, stop, loading,
    deliver: (...names: string[]) => finish(files, names),
    decode: (...names: string[]) => finish(decoded, names),
  };
}

test('while a ring is decoded, only the files of the next ring are fetched', async () => {
  const { requested, arrived, deliver, decode } = createRegion();
  await deliver(FIRST, SHARED);
  assert.deepEqual(arrived, [0]);
  assert.deepEqual(requested, [FIRST, SHARED, SECOND]);
  await deliver(SECOND);
  assert.deepEqual(arrived, [0]);
  await decode(FIRST);
  assert.deepEqual([arrived, requested.at(-1)], [[0, 1], THIRD]);
});

test('rings are shown in order, even if a later one arrives first', async () => {
  const { progress, arrived, deliver, decode } = createRegion();
  await deliver(SECOND);
  assert.deepEqual(arrived, [0]);
  await deliver(SHARED, FIRST);
  await decode(FIRST);
  await deliver(THIRD);
  assert.deepEqual(arrived, [0, 1]);
  await decode(SECOND);
  await decode(THIRD);
  await progress.end;
  assert.deepEqual(arrived, [0, 1, 2, 3]);
});

test('a file of two rings is fetched and counted once', async () => {
  const { progress, requested, deliver, decode, loading } = createRegion();
  await deliver(FIRST, SHARED, SECOND);
  await decode(FIRST);
  await deliver(THIRD);
  await decode(SECOND);
  await decode(THIRD);
  await progress.end;
  assert.equal(requested.filter((name) => name === SHARED).length, 1);
  assert.equal(progress.bytes, 65);
  assert.ok(loading.store.buffers.has(SHARED));
});

test('an aborted loading has shown the rings that were complete', async () => {
  const { progress, arrived, stop, deliver } = createRegion();
  const rejection = assert.rejects(progress.end, /enough/);
  await deliver(FIRST);
  stop.abort(new Error('enough'));
  await rejection;
  assert.deepEqual(arrived, [0]);
});

test('a full-size map replaces the cube of its own ring, not the cube that is shown', async () => {
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
  const sizesAfterRing: [number, number[]][] = [];
  const gl = new Proxy({}, { get: () => () => ({}) });
  const properties = { get: () => ({}), remove: () => undefined };
  const loading = {
    store: createStore(),
    maps: async () => ({}),
    uploads: { add: async () => undefined },
    renderer: { getContext: () => gl, resetState: () => undefined, properties },
    fetch: async () => new ArrayBuffer(0),
  } as unknown as Loading;
  const regionLoading = {
    manifest: whole,
    region: { entry: { ...whole.regions[0], rings }, groups: [], triangles: [], cubes },
    number: 0,
    onRing: (ring: number) => sizesAfterRing.push([ring, cubes.map(({ size }) => size)]),
    onBytes: () => undefined,
    waitForRing: async (ring: number) => rings[ring],
    waitForCube: async () => undefined,
    signal: new AbortController().signal,
  } as unknown as RegionLoading;
  await loadRegion(loading, regionLoading);
  assert.deepEqual(sizesAfterRing, [[0, [64, 64]], [1, [64, 128]], [2, [128, 128]]]);
  assert.deepEqual(disposed, [1, 0]);
});
