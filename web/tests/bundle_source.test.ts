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

/** Server with replies by file name, and a clock that the test advances. */
function createServer(replies: Record<string, Reply[]>) {
  const requests: string[] = [];
  const retries: boolean[] = [];
  const timers = new Map<() => void, number>();
  let openCount = 0;
  let maxOpenCount = 0;
  const network: Network = {
    async fetch(url, signal, isRetry) {
      const file = url.href.slice(BASE.href.length);
      requests.push(file);
      retries.push(isRetry);
      openCount += 1;
      maxOpenCount = Math.max(maxOpenCount, openCount);
      try {
        const queue = replies[file];
        const reply = queue?.length === 1 ? queue[0] : queue?.shift();
        return await (reply ? reply(signal) : new Response(null, { status: 404, statusText: 'Not Found' }));
      } finally {
        openCount -= 1;
      }
    },
    wait: (seconds, signal) =>
      new Promise((done, failed) => {
        signal.throwIfAborted();
        const timer = (): void => done();
        timers.set(timer, seconds);
        signal.addEventListener('abort', () => {
          timers.delete(timer);
          failed(signal.reason as Error);
        });
      }),
  };
  const settle = (): Promise<void> => new Promise((done) => setTimeout(done, 2));
  return {
    network,
    requests,
    retries,
    /** Greatest number of concurrent requests. */
    maxOpenCount: () => maxOpenCount,
    settle,
    /** Ends the shortest wait; returns its seconds. */
    async endWait(): Promise<number> {
      await settle();
      const [next] = [...timers].sort((a, b) => a[1] - b[1]);
      if (!next) return 0;
      timers.delete(next[0]);
      next[0]();
      await settle();
      return next[1];
    },
  };
}

const bytes = (size: number, fill = 1): Uint8Array<ArrayBuffer> => new Uint8Array(size).fill(fill);
const whole = (size: number, fill = 1): Reply => () => new Response(bytes(size, fill));
const broken: Reply = () => Promise.reject(new TypeError('network error'));

/** Sends some bytes, and ends when a promise resolves. */
function slow(size: number, end: Promise<void>): Reply {
  return (signal) =>
    new Response(new ReadableStream({
      start(controller) {
        controller.enqueue(bytes(size));
        signal.addEventListener('abort', () => controller.error(signal.reason));
        void end.then(() => controller.close());
      },
    }));
}
const NEVER = new Promise<void>(() => undefined);

async function openSource(received: Received, network: Network): Promise<Source> {
  const manifest = parseManifest(await readDocument(BASE, received, signal(), network));
  return { manifest, ...createFiles(BASE, (file) => manifest.files[file], received, network) };
}

async function openTestSource(replies: Record<string, Reply[]>, sizes: readonly number[] = [4, 4, 4]) {
  const files = Object.fromEntries(sizes.map((size, number) => [name(number), size]));
  const server = createServer({ ...replies, 'manifest.json': [() => new Response(asManifest(manifest(files)))] });
  const received = { bytes: 0 };
  const source = await openSource((bytes) => (received.bytes += bytes), server.network);
  received.bytes = 0;
  return { server, source, received };
}

const signal = (): AbortSignal => new AbortController().signal;
const read = async (source: Source, number: number): Promise<number[]> => [
  ...new Uint8Array(await source.fetch(name(number), signal())),
];

test('concurrent readers share one request, and each gets a copy of the data', async () => {
  const { server, source, received } = await openTestSource({ [name(0)]: [whole(4, 7)] });
  const reports: number[] = [];
  const all = await Promise.all([
    source.fetch(name(0), signal(), (bytes) => reports.push(bytes)),
    source.fetch(name(0), signal()),
    source.fetch(name(0), signal()),
  ]);
  assert.equal(new Set(all).size, 3);
  for (const data of all) {
    assert.deepEqual([...new Uint8Array(data)], [7, 7, 7, 7]);
    // Transfers the copy, as to a worker.
    structuredClone(data, { transfer: [data] });
  }
  assert.deepEqual([received.bytes, reports.reduce((sum, bytes) => sum + bytes)], [4, 4]);
  assert.deepEqual(server.requests, ['manifest.json', name(0)]);
  await read(source, 0);
  assert.equal(server.requests.length, 3);
});

test('at most six requests are open at once, in order', async () => {
  const sizes = Array.from({ length: 20 }, () => 4);
  const later: Reply = () => new Promise((done) => setTimeout(() => done(new Response(bytes(4))), 3));
  const { server, source } = await openTestSource(Object.fromEntries(sizes.map((_, number) => [name(number), [later]])), sizes);
  await Promise.all(sizes.map((_, number) => read(source, number)));
  assert.equal(server.maxOpenCount(), 6);
  assert.deepEqual(server.requests.slice(1), sizes.map((_, number) => name(number)));
});

test('an interrupted transfer restarts after growing pauses, and bytes count once', async () => {
  const { server, source, received } = await openTestSource({ [name(0)]: [broken, whole(3), broken, whole(4, 5)] });
  const done = read(source, 0);
  const pauses = [await server.endWait(), await server.endWait(), await server.endWait()];
  assert.deepEqual(pauses, [0.5, 1, 2]);
  assert.deepEqual(await done, [5, 5, 5, 5]);
  assert.equal(received.bytes, 4);
  assert.deepEqual(server.retries.slice(1), [false, true, true, true]);
});

test('the next request of a damaged file bypasses the cache', async () => {
  const { server, source } = await openTestSource({ [name(0)]: [whole(4)], [name(1)]: [whole(4)] });
  await read(source, 0);
  source.distrust(name(0));
  for (const number of [1, 0, 0]) await read(source, number);
  assert.deepEqual(server.retries.slice(1), [false, false, true, false]);
});

test('a stalled transfer is aborted and repeated', async () => {
  const { server, source, received } = await openTestSource({ [name(0)]: [slow(2, NEVER), whole(4)] });
  const done = read(source, 0);
  // The two bytes have arrived before the first check.
  assert.equal(await server.endWait(), 10);
  assert.equal(received.bytes, 2);
  assert.equal(await server.endWait(), 10);
  assert.equal(await server.endWait(), 0.5);
  assert.deepEqual(await done, [1, 1, 1, 1]);
  assert.equal(received.bytes, 4);
});

test('after five attempts the error names the file', async () => {
  const { server, source } = await openTestSource({ [name(0)]: [broken] });
  const failed = assert.rejects(read(source, 0), (error: Error) => {
    assert.ok(error instanceof BundleError);
    assert.equal(error.message, `${name(0)} cannot be loaded: network error`);
    return true;
  });
  for (const pause of [0.5, 1, 2, 4]) assert.equal(await server.endWait(), pause);
  await failed;
  assert.equal(server.requests.length, 6);
});

test('permanent errors are reported at once', async () => {
  const endless: Reply = (end) =>
    new Response(new ReadableStream({ pull: (controller) => {
      end.throwIfAborted();
      controller.enqueue(bytes(1000));
    } }));
  const { server, source } = await openTestSource({ [name(0)]: [whole(5)], [name(2)]: [endless] });
  await assert.rejects(read(source, 0), /^BundleError: files\/0+\.bin: expected 4 bytes, as the manifest lists it/);
  await assert.rejects(read(source, 1), /^BundleError: files\/0+1\.bin: the server answers 404 Not Found$/);
  await assert.rejects(read(source, 2), /expected 4 bytes/);
  await assert.rejects(read(source, 9), /the manifest does not list this file/);
  assert.equal(server.requests.length, 4);
});

test('requests to busy servers are repeated', async () => {
  const busy = (status: number): Reply => () => new Response(null, { status });
  const { server, source } = await openTestSource({ [name(0)]: [busy(503), busy(429), whole(4)] });
  const done = read(source, 0);
  assert.deepEqual([await server.endWait(), await server.endWait()], [0.5, 1]);
  assert.equal((await done).length, 4);
});

test('cancelled readers return at once, and others continue', async () => {
  let endTransfer = (): void => undefined;
  const end = new Promise<void>((done) => (endTransfer = done));
  const { server, source } = await openTestSource({ [name(0)]: [slow(4, end), whole(4)] });
  const stop = new AbortController();
  const stopped = source.fetch(name(0), stop.signal);
  const other = read(source, 0);
  await server.settle();
  stop.abort(new Error('enough'));
  await assert.rejects(stopped, /enough/);
  endTransfer();
  assert.equal((await other).length, 4);
  assert.equal(server.requests.length, 2);
});

test('a request without readers is aborted and frees its slot', async () => {
  const sizes = Array.from({ length: 8 }, () => 4);
  const replies = Object.fromEntries(sizes.map((_, number) => [name(number), [slow(1, NEVER)]]));
  const { server, source, received } = await openTestSource({ ...replies, [name(7)]: [whole(4)] }, sizes);
  const stop = new AbortController();
  const stalled = sizes.slice(0, 7).map((_, number) => source.fetch(name(number), stop.signal));
  const last = read(source, 7);
  await server.settle();
  assert.equal(server.requests.length, 7);
  stop.abort(new Error('enough'));
  for (const result of await Promise.allSettled(stalled)) assert.equal(result.status, 'rejected');
  assert.equal((await last).length, 4);
  // The seventh request did not begin.
  assert.ok(!server.requests.includes(name(6)));
  assert.equal(received.bytes, 4);
  await assert.rejects(source.fetch(name(0), stop.signal), /enough/);
});

test('a missing or malformed manifest is reported', async () => {
  const open = (reply: Reply): Promise<Source> => {
    const { network } = createServer({ 'manifest.json': [reply] });
    return openSource(() => undefined, network);
  };
  await assert.rejects(open(() => new Response('<html>')), /^BundleError: manifest\.json: expected JSON/);
  await assert.rejects(open(() => new Response(null, { status: 403 })), /manifest\.json: the server answers 403/);
});
