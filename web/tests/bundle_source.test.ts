import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BundleError } from '../src/bundle/error';
import { parseManifest } from '../src/bundle/parse';
import { createFiles, readDocument, type Received, type Source } from '../src/bundle/source';
import type { Network } from '../src/bundle/transfer';
import { asManifest, manifest } from './support/manifest';

const BASE = new URL('http://example.test/bundle/');
const name = (number: number): string => `files/${number.toString(16).padStart(16, '0')}.bin`;

type Reply = (signal: AbortSignal) => Promise<Response> | Response;

/** A server of replies by name, and a clock that the test advances. */
function createWorld(replies: Record<string, Reply[]>) {
  const asked: string[] = [];
  const again: boolean[] = [];
  const waiting = new Map<() => void, number>();
  let open = 0;
  let most = 0;
  const network: Network = {
    async fetch(url, signal, isAgain) {
      const file = url.href.slice(BASE.href.length);
      asked.push(file);
      again.push(isAgain);
      open += 1;
      most = Math.max(most, open);
      try {
        const queue = replies[file];
        const reply = queue?.length === 1 ? queue[0] : queue?.shift();
        return await (reply ? reply(signal) : new Response(null, { status: 404, statusText: 'Not Found' }));
      } finally {
        open -= 1;
      }
    },
    wait: (seconds, signal) =>
      new Promise((done, failed) => {
        signal.throwIfAborted();
        const ring = (): void => done();
        waiting.set(ring, seconds);
        signal.addEventListener('abort', () => {
          waiting.delete(ring);
          failed(signal.reason as Error);
        });
      }),
  };
  const settle = (): Promise<void> => new Promise((done) => setTimeout(done, 2));
  return {
    network,
    asked,
    again,
    /** Maximum number of concurrent requests. */
    most: () => most,
    settle,
    /** Let the shortest wait end; returns its seconds. */
    async tick(): Promise<number> {
      await settle();
      const [next] = [...waiting].sort((a, b) => a[1] - b[1]);
      if (!next) return 0;
      waiting.delete(next[0]);
      next[0]();
      await settle();
      return next[1];
    },
  };
}

const bytes = (size: number, fill = 1): Uint8Array<ArrayBuffer> => new Uint8Array(size).fill(fill);
const whole = (size: number, fill = 1): Reply => () => new Response(bytes(size, fill));
const broken: Reply = () => Promise.reject(new TypeError('network error'));

/** Some bytes, and then nothing, or an end after a while. */
function slow(size: number, go: Promise<void>): Reply {
  return (signal) =>
    new Response(new ReadableStream({
      start(controller) {
        controller.enqueue(bytes(size));
        signal.addEventListener('abort', () => controller.error(signal.reason));
        void go.then(() => controller.close());
      },
    }));
}
const NEVER = new Promise<void>(() => undefined);

async function openSource(received: Received, network: Network): Promise<Source> {
  const manifest = parseManifest(await readDocument(BASE, received, signal(), network));
  return { manifest, ...createFiles(BASE, (file) => manifest.files[file], received, network) };
}

async function openWorld(replies: Record<string, Reply[]>, sizes: readonly number[] = [4, 4, 4]) {
  const files = Object.fromEntries(sizes.map((size, number) => [name(number), size]));
  const world = createWorld({ ...replies, 'manifest.json': [() => new Response(asManifest(manifest(files)))] });
  const counted = { bytes: 0 };
  const source = await openSource((more) => (counted.bytes += more), world.network);
  counted.bytes = 0;
  return { world, source, counted };
}

const signal = (): AbortSignal => new AbortController().signal;
const read = async (source: Source, number: number): Promise<number[]> => [
  ...new Uint8Array(await source.fetch(name(number), signal())),
];

test('one request serves all concurrent readers, each with its own bytes', async () => {
  const { world, source, counted } = await openWorld({ [name(0)]: [whole(4, 7)] });
  const told: number[] = [];
  const all = await Promise.all([
    source.fetch(name(0), signal(), (more) => told.push(more)),
    source.fetch(name(0), signal()),
    source.fetch(name(0), signal()),
  ]);
  assert.equal(new Set(all).size, 3);
  for (const data of all) {
    assert.deepEqual([...new Uint8Array(data)], [7, 7, 7, 7]);
    // As a worker that takes ownership.
    structuredClone(data, { transfer: [data] });
  }
  assert.deepEqual([counted.bytes, told.reduce((sum, more) => sum + more)], [4, 4]);
  assert.deepEqual(world.asked, ['manifest.json', name(0)]);
  await read(source, 0);
  assert.equal(world.asked.length, 3);
});

test('at most six requests at once, in order', async () => {
  const sizes = Array.from({ length: 20 }, () => 4);
  const later: Reply = () => new Promise((done) => setTimeout(() => done(new Response(bytes(4))), 3));
  const { world, source } = await openWorld(Object.fromEntries(sizes.map((_, number) => [name(number), [later]])), sizes);
  await Promise.all(sizes.map((_, number) => read(source, number)));
  assert.equal(world.most(), 6);
  assert.deepEqual(world.asked.slice(1), sizes.map((_, number) => name(number)));
});

test('an interrupted transfer restarts after growing pauses, and bytes count once', async () => {
  const { world, source, counted } = await openWorld({ [name(0)]: [broken, whole(3), broken, whole(4, 5)] });
  const done = read(source, 0);
  const pauses = [await world.tick(), await world.tick(), await world.tick()];
  assert.deepEqual(pauses, [0.5, 1, 2]);
  assert.deepEqual(await done, [5, 5, 5, 5]);
  assert.equal(counted.bytes, 4);
  assert.deepEqual(world.again.slice(1), [false, true, true, true]);
});

test('a damaged file is not taken from the cache the next time', async () => {
  const { world, source } = await openWorld({ [name(0)]: [whole(4)], [name(1)]: [whole(4)] });
  await read(source, 0);
  source.distrust(name(0));
  for (const number of [1, 0, 0]) await read(source, number);
  assert.deepEqual(world.again.slice(1), [false, false, true, false]);
});

test('a stalled transfer is aborted and repeated', async () => {
  const { world, source, counted } = await openWorld({ [name(0)]: [slow(2, NEVER), whole(4)] });
  const done = read(source, 0);
  // The bytes arrived before the first check.
  assert.equal(await world.tick(), 10);
  assert.equal(counted.bytes, 2);
  assert.equal(await world.tick(), 10);
  assert.equal(await world.tick(), 0.5);
  assert.deepEqual(await done, [1, 1, 1, 1]);
  assert.equal(counted.bytes, 4);
});

test('after five attempts the error names the file', async () => {
  const { world, source } = await openWorld({ [name(0)]: [broken] });
  const failed = assert.rejects(read(source, 0), (error: Error) => {
    assert.ok(error instanceof BundleError);
    assert.equal(error.message, `${name(0)} cannot be loaded: network error`);
    return true;
  });
  for (const pause of [0.5, 1, 2, 4]) assert.equal(await world.tick(), pause);
  await failed;
  assert.equal(world.asked.length, 6);
});

test('permanent errors are reported at once', async () => {
  const endless: Reply = (end) =>
    new Response(new ReadableStream({ pull: (controller) => {
      end.throwIfAborted();
      controller.enqueue(bytes(1000));
    } }));
  const { world, source } = await openWorld({ [name(0)]: [whole(5)], [name(2)]: [endless] });
  await assert.rejects(read(source, 0), /^BundleError: files\/0+\.bin: expected 4 bytes, as the manifest lists it/);
  await assert.rejects(read(source, 1), /^BundleError: files\/0+1\.bin: the server answers 404 Not Found$/);
  await assert.rejects(read(source, 2), /expected 4 bytes/);
  await assert.rejects(read(source, 9), /the manifest does not list this file/);
  assert.equal(world.asked.length, 4);
});

test('busy servers are asked again', async () => {
  const busy = (status: number): Reply => () => new Response(null, { status });
  const { world, source } = await openWorld({ [name(0)]: [busy(503), busy(429), whole(4)] });
  const done = read(source, 0);
  assert.deepEqual([await world.tick(), await world.tick()], [0.5, 1]);
  assert.equal((await done).length, 4);
});

test('cancelled readers return at once, and others continue', async () => {
  let go = (): void => undefined;
  const ready = new Promise<void>((done) => (go = done));
  const { world, source } = await openWorld({ [name(0)]: [slow(4, ready), whole(4)] });
  const stop = new AbortController();
  const stopped = source.fetch(name(0), stop.signal);
  const other = read(source, 0);
  await world.settle();
  stop.abort(new Error('enough'));
  await assert.rejects(stopped, /enough/);
  go();
  assert.equal((await other).length, 4);
  assert.equal(world.asked.length, 2);
});

test('a request without readers is aborted, and its slot is free', async () => {
  const sizes = Array.from({ length: 8 }, () => 4);
  const replies = Object.fromEntries(sizes.map((_, number) => [name(number), [slow(1, NEVER)]]));
  const { world, source, counted } = await openWorld({ ...replies, [name(7)]: [whole(4)] }, sizes);
  const stop = new AbortController();
  const stalled = sizes.slice(0, 7).map((_, number) => source.fetch(name(number), stop.signal));
  const last = read(source, 7);
  await world.settle();
  assert.equal(world.asked.length, 7);
  stop.abort(new Error('enough'));
  for (const result of await Promise.allSettled(stalled)) assert.equal(result.status, 'rejected');
  assert.equal((await last).length, 4);
  // The seventh never began.
  assert.ok(!world.asked.includes(name(6)));
  assert.equal(counted.bytes, 4);
  await assert.rejects(source.fetch(name(0), stop.signal), /enough/);
});

test('a missing or malformed manifest is reported', async () => {
  const open = (reply: Reply): Promise<Source> => {
    const { network } = createWorld({ 'manifest.json': [reply] });
    return openSource(() => undefined, network);
  };
  await assert.rejects(open(() => new Response('<html>')), /^BundleError: manifest\.json: expected JSON/);
  await assert.rejects(open(() => new Response(null, { status: 403 })), /manifest\.json: the server answers 403/);
});
