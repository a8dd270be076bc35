import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Texture } from 'three';
import { createStore, type MeshArrays } from '../src/show/buffers';
import { createPrefetch } from '../src/show/loader';
import { createUploads, type Step } from '../src/show/uploads';

const SIZES: Readonly<Record<string, number>> = { a: 10, b: 20, c: 30 };
const sizeOf = (name: string): number => SIZES[name] ?? 0;
const { signal } = new AbortController();

function countingFetch(fails = false) {
  const asked: string[] = [];
  const fetch = (name: string): Promise<ArrayBuffer> => {
    asked.push(name);
    return fails ? Promise.reject(new Error('the server is gone')) : Promise.resolve(new ArrayBuffer(sizeOf(name)));
  };
  return { asked, fetch };
}

test('a prefetched file is not fetched again, and no longer counts as prefetched', async () => {
  const { asked, fetch } = countingFetch();
  const ahead = createPrefetch(fetch, sizeOf);
  ahead.begin(['a', 'b', 'a'], signal);
  assert.deepEqual([asked, ahead.bytes], [['a', 'b'], 30]);
  assert.equal((await ahead.fetch('b', signal)).byteLength, 20);
  assert.deepEqual([asked, ahead.bytes], [['a', 'b'], 10]);
  await ahead.fetch('b', signal);
  assert.deepEqual(asked, ['a', 'b', 'b']);
});

test('prefetching stays within its limit of bytes', () => {
  const { asked, fetch } = countingFetch();
  const ahead = createPrefetch(fetch, sizeOf, 45);
  ahead.begin(['a', 'c', 'b'], signal);
  assert.deepEqual([asked, ahead.bytes], [['a', 'c'], 40]);
});

test('a failed prefetch is reported when the file is requested', async () => {
  const ahead = createPrefetch(countingFetch(true).fetch, sizeOf);
  ahead.begin(['a'], signal);
  await assert.rejects(ahead.fetch('a', signal), /the server is gone/);
});

test('arrays of a mesh are created once, and freed with the last mesh that uses them', () => {
  const store = createStore();
  let made = 0;
  const make = (): MeshArrays => ({ attributes: {}, *steps() {}, dispose: () => undefined, made: ++made }) as MeshArrays;
  const [first, second] = [store.acquire('m', make), store.acquire('m', make)];
  assert.equal(first, second);
  assert.deepEqual([made, store.shared], [1, 1]);
  assert.deepEqual([store.release('m'), store.shared], [false, 0]);
  assert.equal(store.release('m'), true);
  assert.notEqual(store.acquire('m', make), first);
  // Without a name nothing is shared.
  assert.notEqual(store.acquire(null, make), store.acquire(null, make));
  assert.equal(store.release(null), true);
});

test('textures and buffers that no region needs are freed, others stay', () => {
  const store = createStore();
  const gone: string[] = [];
  for (const name of ['x', 'y']) {
    store.textures.set(name, { dispose: () => gone.push(name) } as unknown as Texture);
    store.buffers.add(`${name}.bin`);
  }
  assert.deepEqual(store.freeExcept(new Set(['y', 'x.bin'])), ['y.bin']);
  assert.deepEqual(gone, ['x']);
  assert.deepEqual([[...store.textures.keys()], [...store.buffers]], [['y'], ['x.bin']]);
});

test('steps of a cancelled job clean up', async () => {
  const stop = new AbortController();
  const log: string[] = [];
  function* steps(): Generator<Step> {
    try {
      yield { kind: 'mesh', bytes: 0, run: () => log.push('first') };
      yield { kind: 'mesh', bytes: 0, run: () => log.push('second') };
    } finally {
      log.push('cleaned up');
    }
  }
  const uploads = createUploads(() => 0);
  const done = uploads.add(steps(), stop.signal);
  let time = 0;
  const one = createUploads(() => (time += 10));
  const later = one.add(steps(), stop.signal);
  one.run(1);
  stop.abort(new Error('closed'));
  one.run(1);
  await assert.rejects(later, /closed/);
  assert.deepEqual(log, ['first', 'cleaned up']);
  uploads.run(1);
  await assert.rejects(done, /closed/);
});
