import assert from 'node:assert/strict';
import { test } from 'node:test';
import { askDescription, type Datagrams, type Listener, readDescription, type Socket } from '../src/rooms/server';
import { addressOf, createGatherer, createOpen, createSplitter, openDatagrams, readAll } from '../src/rooms/transports';

const TO: Datagrams = { port: 8443, hashes: [] };
const RELAY = 'wss://host:8/rooms/a';

/** Records opened connections in order, and reports to the page. */
function bench(ask: () => Promise<Datagrams | null>, isTaken: () => boolean, hasSockets = true) {
  const [opened, reports]: [string[], string[]] = [[], []];
  const socket = (name: string): Socket => ({
    bufferedAmount: 7,
    send: (data, mayBeLost) => reports.push(`${name} ${data.length} ${mayBeLost}`),
    close: (isImmediate) => reports.push(`${name} closes${isImmediate ? ' at once' : ''}`),
  });
  const listener: Listener = { opened: () => reports.push('opened'), received: () => {}, closed: (code) => reports.push(`closed ${code}`) };
  const ways = {
    datagrams: () => {
      opened.push('asks');
      return ask();
    },
    openDatagrams: async () => {
      opened.push('datagrams');
      if (!isTaken()) throw new Error('refused');
      return socket('datagrams');
    },
    openSocket: () => {
      opened.push('socket');
      if (!hasSockets) throw new Error('blocked');
      return socket('socket');
    },
  };
  const clock = { now: () => made.now, later: () => () => {} };
  const [on, off] = [false, true].map((isOff) => createOpen(() => Promise.resolve(null), isOff, ways, clock));
  /** Lets pending work continue. */
  const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
  const open = (isOff = false): Socket => (isOff ? off : on)?.(RELAY, listener) as Socket;
  /** `now` is the clock's time in seconds. */
  const made = { opened, reports, open, now: 0, settle };
  return made;
}

test('datagrams are used if the server offers them', async () => {
  const { opened, reports, open, settle } = bench(async () => TO, () => true);
  const socket = open();
  socket.send(new Uint8Array(2), true);
  assert.equal(socket.bufferedAmount, 0);
  await settle();
  assert.deepEqual([opened, reports], [['asks', 'datagrams'], ['opened']]);
  socket.send(new Uint8Array(3), true);
  assert.equal(socket.bufferedAmount, 7);
  open();
  await settle();
  assert.deepEqual(opened, ['asks', 'datagrams', 'asks', 'datagrams']);
  assert.deepEqual(reports, ['opened', 'datagrams 3 true', 'opened']);
});

test('a failed way is tried again when the server has another certificate', async () => {
  let to = { port: 8443, hashes: [new Uint8Array([1])] };
  const { opened, reports, open, settle } = bench(async () => to, () => to.hashes[0]?.[0] === 2);
  for (let count = 0; count < 3; count++) {
    if (count === 2) to = { port: 8443, hashes: [new Uint8Array([2])] };
    open();
    await settle();
  }
  assert.deepEqual(opened, ['asks', 'datagrams', 'socket', 'asks', 'socket', 'asks', 'datagrams']);
  assert.deepEqual(reports, ['opened']);
});

test('a failed way is tried again after a minute', async () => {
  const made = bench(async () => TO, () => made.now > 0);
  for (const now of [0, 59, 60]) {
    made.now = now;
    made.open();
    await made.settle();
  }
  assert.deepEqual(made.opened, ['asks', 'datagrams', 'socket', 'asks', 'socket', 'asks', 'datagrams']);
});

test('a WebSocket that cannot be created is reported as closed', async () => {
  const { reports, open, settle } = bench(async () => null, () => true, false);
  open();
  await settle();
  assert.deepEqual(reports, ['closed 1006']);
});

test('the page does not wait for a server that does not answer', async () => {
  const { fetch } = globalThis;
  const ends = new AbortController();
  let isEnded = false;
  globalThis.fetch = (_, init) =>
    new Promise((_, reject) => init?.signal?.addEventListener('abort', () => reject((isEnded = true))));
  try {
    const reports = askDescription('http://host:8/', ends.signal);
    ends.abort();
    assert.equal(await reports, null);
    assert.ok(isEnded);
  } finally {
    globalThis.fetch = fetch;
  }
});

test('an error in a frame listener ends nothing', async () => {
  const reported: unknown[] = [];
  Object.assign(globalThis, { reportError: (error: unknown) => reported.push(error) });
  const taken: number[] = [];
  const { readable, writable } = new TransformStream<Uint8Array, Uint8Array>();
  const writer = writable.getWriter();
  void Promise.all([...[1, 2, 3].map((byte) => writer.write(Uint8Array.of(byte))), writer.close()]);
  await readAll(readable, (bytes) => {
    if (bytes[0] === 2) throw new Error('two');
    taken.push(bytes[0] ?? 0);
  });
  assert.deepEqual([taken, reported.length], [[1, 3], 1]);
});

test('the end of an unused session is not reported', async () => {
  let end = (_: object): void => {};
  class Useless {
    readonly ready = Promise.resolve();
    readonly closed = new Promise((resolve) => (end = resolve));
    readonly datagrams = { readable: new ReadableStream() };
    createBidirectionalStream(): Promise<object> {
      return Promise.resolve({ readable: new ReadableStream(), writable: new WritableStream() });
    }
    close(): void {
      end({ closeCode: 0 });
    }
  }
  Object.assign(globalThis, { WebTransport: Useless });
  const reports: string[] = [];
  const listener: Listener = { opened: () => {}, received: () => {}, closed: (code) => reports.push(`closed ${code}`) };
  await assert.rejects(openDatagrams(RELAY, TO, listener));
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(reports, []);
});

test('a session ends with its stream, which the server closes, or after some seconds', async (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  for (const [isImmediate, isAnswered] of [[false, true], [false, false], [true, false]] as const) {
    const done: string[] = [];
    let end = (_: object): void => {};
    class Fake {
      readonly ready = Promise.resolve();
      readonly closed = new Promise((resolve) => (end = resolve));
      readonly datagrams = { readable: new ReadableStream(), writable: new WritableStream() };
      createBidirectionalStream(): Promise<object> {
        const writable = new WritableStream({
          write: ({ length }) => void done.push(`wrote ${length}`),
          close: () => void done.push('stream closed'),
        });
        return Promise.resolve({ readable: new ReadableStream(), writable });
      }
      close(): void {
        done.push('closed');
      }
    }
    Object.assign(globalThis, { WebTransport: Fake });
    const listener: Listener = { opened: () => {}, received: () => {}, closed: (code) => done.push(`reports ${code}`) };
    const settle = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));
    const socket = await openDatagrams(RELAY, TO, listener);
    await settle();
    socket.send(new Uint8Array(3), false);
    socket.close(isImmediate);
    await settle();
    if (isAnswered) end({ closeCode: 1000 });
    await settle();
    context.mock.timers.tick(5000);
    await settle();
    const [graceful, sent] = [['wrote 3', 'stream closed'], new Set(done)];
    if (isImmediate) assert.ok(sent.has('closed') && !sent.has('stream closed'));
    else assert.deepEqual(done, [...graceful, isAnswered ? 'reports 1000' : 'closed']);
  }
});

test('without datagrams the connection is a WebSocket', async () => {
  const without = bench(async () => null, () => true);
  without.open();
  await without.settle();
  assert.deepEqual(without.opened, ['asks', 'socket']);
  const off = bench(async () => TO, () => true);
  off.open(true);
  await off.settle();
  assert.deepEqual(off.opened, ['socket']);
});

test('a user who leaves before a way was found is not connected', async () => {
  const { reports, open, settle } = bench(async () => TO, () => true);
  open().close(false);
  await settle();
  assert.deepEqual(reports, ['datagrams closes at once']);
});

test('frames of a stream are complete, however it is cut', () => {
  const frames = [[1, 2, 0, 9, 9], [6, 0, 0], [4, 1, 0, 5]];
  const bytes = Uint8Array.from(frames.flat());
  for (let length = 1; length <= bytes.length; length++) {
    const given: number[] = [];
    const split = createSplitter((whole) => {
      const view = new DataView(whole);
      for (let at = 0; at < view.byteLength; at += 3 + view.getUint16(at + 1, true)) given.push(view.getUint8(at));
      assert.ok(whole.byteLength > 0);
    });
    for (let at = 0; at < bytes.length; at += length) split(bytes.subarray(at, at + length));
    assert.deepEqual(given, [1, 6, 4]);
  }
});

test('frames of one task are one datagram, up to its size', async () => {
  const sent: number[] = [];
  const gather = createGatherer((frames) => sent.push(frames.length));
  for (const length of [40, 30, 30, 50]) gather(new Uint8Array(length), 100);
  assert.deepEqual(sent, [100]);
  await Promise.resolve();
  assert.deepEqual(sent, [100, 50]);
  gather(new Uint8Array(1), 100);
  await Promise.resolve();
  assert.deepEqual(sent, [100, 50, 1]);
});

test('the description that a server gives of rooms is parsed, or ignored as a whole', () => {
  const hash = '0a'.repeat(32);
  const reports = readDescription({ peers: true, datagrams: { port: 8443, hashes: [hash] } });
  assert.equal(reports?.peers, true);
  assert.deepEqual([reports?.datagrams?.port, [...(reports?.datagrams?.hashes[0] ?? [])]], [8443, Array(32).fill(10)]);
  assert.deepEqual(readDescription({ peers: false, datagrams: null }), { peers: false, datagrams: null });
  for (const datagrams of [{ port: 0, hashes: [] }, { port: 1.5, hashes: [] }, { port: 1, hashes: ['0A'] }, { port: 1 }, 3]) {
    assert.deepEqual(readDescription({ peers: true, datagrams }), { peers: true, datagrams: null });
  }
  for (const wrong of [null, 'text', [], {}, { peers: 1 }]) assert.equal(readDescription(wrong), null);
});

test('datagrams may have a separate port', () => {
  const address = addressOf('ws://localhost:8080/rooms/a%20b?token=1.2.3', TO);
  assert.equal(address, 'https://localhost:8443/rooms/a%20b?token=1.2.3');
});
