import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Texture } from 'three';
import { createStore, type MeshArrays } from '../src/show/buffers';
import { createPrefetch } from '../src/show/loader';
import { createUploads, type Step } from '../src/show/uploads';

const SIZES: Readonly<Record<string, number>> = { a: 10, b: 20, c: 30 };
const sizeOf = (name: string): number => SIZES[name] ?? 0;
const { signal } = new AbortController();

/** Creates a function that fetches files, or fails, and records their names. */
function createFetch(fails = false) {
  const requested: string[] = [];
  const fetch = (name: string): Promise<ArrayBuffer> => {
    requested.push(name);
    return fails ? Promise.reject(new Error('the server is gone')) : Promise.resolve(new ArrayBuffer(sizeOf(name)));
  };
  return { requested, fetch };
}

test('a prefetched file is fetched once, and does not count as prefetched after its use', async () => {
  const { requested, fetch } = createFetch();
  const prefetch = createPrefetch(fetch, sizeOf);
  prefetch.begin(['a', 'b', 'a'], signal);
  assert.deepEqual([requested, prefetch.bytes], [['a', 'b'], 30]);
  assert.equal((await prefetch.fetch('b', signal)).byteLength, 20);
  assert.deepEqual([requested, prefetch.bytes], [['a', 'b'], 10]);
  await prefetch.fetch('b', signal);
  assert.deepEqual(requested, ['a', 'b', 'b']);
});

test('files beyond the limit of bytes are not prefetched', () => {
  const { requested, fetch } = createFetch();
  const prefetch = createPrefetch(fetch, sizeOf, 45);
  prefetch.begin(['a', 'c', 'b'], signal);
  assert.deepEqual([requested, prefetch.bytes], [['a', 'c'], 40]);
});

test('the error of a prefetched file is thrown when the file is used', async () => {
  const prefetch = createPrefetch(createFetch(true).fetch, sizeOf);
  prefetch.begin(['a'], signal);
  await assert.rejects(prefetch.fetch('a', signal), /the server is gone/);
});

test('meshes of one name share arrays, which are freed with the last of them', () => {
  const store = createStore();
  let count = 0;
  const make = (): MeshArrays => {
    count += 1;
    return { attributes: {}, *steps() {}, dispose: () => undefined };
  };
  const [first, second] = [store.acquire('m', make), store.acquire('m', make)];
  assert.equal(first, second);
  assert.deepEqual([count, store.shared], [1, 1]);
  assert.deepEqual([store.release('m'), store.shared], [false, 0]);
  assert.equal(store.release('m'), true);
  assert.notEqual(store.acquire('m', make), first);
  // Meshes without a name share nothing.
  assert.notEqual(store.acquire(null, make), store.acquire(null, make));
  assert.equal(store.release(null), true);
});

test('textures and buffers that no region needs are freed', () => {
  const store = createStore();
  const disposed: string[] = [];
  for (const name of ['x', 'y']) {
    store.textures.set(name, { dispose: () => disposed.push(name) } as unknown as Texture);
    store.buffers.add(`${name}.bin`);
  }
  assert.deepEqual(store.freeExcept(new Set(['y', 'x.bin'])), ['y.bin']);
  assert.deepEqual(disposed, ['x']);
  assert.deepEqual([[...store.textures.keys()], [...store.buffers]], [['y'], ['x.bin']]);
});

test('the generator of an aborted job ends, so that it can free its results', async () => {
  const stop = new AbortController();
  const log: string[] = [];
  function* steps(): Generator<Step> {
    try {
      yield { kind: 'mesh', bytes: 0, run: () => log.push('first') };
      yield { kind: 'mesh', bytes: 0, run: () => log.push('second') };
    } finally {
      log.push('end');
    }
  }
  const uploads = createUploads(() => 0);
  const waitingJob = uploads.add(steps(), stop.signal);
  let time = 0;
  const slowUploads = createUploads(() => (time += 10));
  const startedJob = slowUploads.add(steps(), stop.signal);
  slowUploads.run(1);
  stop.abort(new Error('closed'));
  slowUploads.run(1);
  await assert.rejects(startedJob, /closed/);
  assert.deepEqual(log, ['first', 'end']);
  uploads.run(1);
  await assert.rejects(waitingJob, /closed/);
});
