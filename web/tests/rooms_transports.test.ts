import assert from 'node:assert/strict';
import { test } from 'node:test';
import { askDescription, type Datagrams, type Listener, readDescription, type Socket } from '../src/rooms/server';
import { addressOf, createGatherer, createOpen, createSplitter, openDatagrams, readAll } from '../src/rooms/transports';

const TO: Datagrams = { port: 8443, hashes: [] };
const RELAY = 'wss://host:8/rooms/a';

/** Opens sockets with fake transports; records the attempts in order, and the events that the page sees. */
function createTestTransports(ask: () => Promise<Datagrams | null>, acceptsDatagrams: () => boolean, hasSockets = true) {
  const [attempts, events]: [string[], string[]] = [[], []];
  const socket = (name: string): Socket => ({
    bufferedAmount: 7,
    send: (data, mayBeLost) => events.push(`${name} ${data.length} ${mayBeLost}`),
    close: (isImmediate) => events.push(`${name} closes${isImmediate ? ' at once' : ''}`),
  });
  const listener: Listener = {
    onOpen: () => events.push('opened'),
    onData: () => {},
    onClose: (code) => events.push(`closed ${code}`),
  };
  const transports = {
    datagrams: () => {
      attempts.push('asks');
      return ask();
    },
    openDatagrams: async () => {
      attempts.push('datagrams');
      if (!acceptsDatagrams()) throw new Error('refused');
      return socket('datagrams');
    },
    openSocket: () => {
      attempts.push('socket');
      if (!hasSockets) throw new Error('blocked');
      return socket('socket');
    },
  };
  const clock = { now: () => context.now, later: () => () => {} };
  const [openAny, openWebSocket] = [false, true].map((isOnly) => createOpen(() => Promise.resolve(null), isOnly, transports, clock));
  /** Lets pending work continue. */
  const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
  const open = (isWebSocketOnly = false): Socket => (isWebSocketOnly ? openWebSocket : openAny)?.(RELAY, listener) as Socket;
  /** `now` is the clock's time in seconds. */
  const context = { attempts, events, open, now: 0, settle };
  return context;
}

test('datagrams are used if the server offers them', async () => {
  const { attempts, events, open, settle } = createTestTransports(async () => TO, () => true);
  const socket = open();
  socket.send(new Uint8Array(2), true);
  assert.equal(socket.bufferedAmount, 0);
  await settle();
  assert.deepEqual([attempts, events], [['asks', 'datagrams'], ['opened']]);
  socket.send(new Uint8Array(3), true);
  assert.equal(socket.bufferedAmount, 7);
  open();
  await settle();
  assert.deepEqual(attempts, ['asks', 'datagrams', 'asks', 'datagrams']);
  assert.deepEqual(events, ['opened', 'datagrams 3 true', 'opened']);
});

test('datagrams are tried again after a failure when the server has another certificate', async () => {
  let to = { port: 8443, hashes: [new Uint8Array([1])] };
  const { attempts, events, open, settle } = createTestTransports(async () => to, () => to.hashes[0]?.[0] === 2);
  for (let count = 0; count < 3; count++) {
    if (count === 2) to = { port: 8443, hashes: [new Uint8Array([2])] };
    open();
    await settle();
  }
  assert.deepEqual(attempts, ['asks', 'datagrams', 'socket', 'asks', 'socket', 'asks', 'datagrams']);
  assert.deepEqual(events, ['opened']);
});

test('datagrams are tried again after a failure and a minute', async () => {
  const context = createTestTransports(async () => TO, () => context.now > 0);
  for (const now of [0, 59, 60]) {
    context.now = now;
    context.open();
    await context.settle();
  }
  assert.deepEqual(context.attempts, ['asks', 'datagrams', 'socket', 'asks', 'socket', 'asks', 'datagrams']);
});

test('a WebSocket that cannot be created is reported as closed', async () => {
  const { events, open, settle } = createTestTransports(async () => null, () => true, false);
  open();
  await settle();
  assert.deepEqual(events, ['closed 1006']);
});

test('the wait for a server that does not answer ends', async () => {
  const { fetch } = globalThis;
  const timeout = new AbortController();
  let isEnded = false;
  globalThis.fetch = (_, init) =>
    new Promise((_, reject) => init?.signal?.addEventListener('abort', () => reject((isEnded = true))));
  try {
    const description = askDescription('http://host:8/', timeout.signal);
    timeout.abort();
    assert.equal(await description, null);
    assert.ok(isEnded);
  } finally {
    globalThis.fetch = fetch;
  }
});

test('an error in a listener of frames does not end the reading', async () => {
  const reported: unknown[] = [];
  Object.assign(globalThis, { reportError: (error: unknown) => reported.push(error) });
  const bytesRead: number[] = [];
  const { readable, writable } = new TransformStream<Uint8Array, Uint8Array>();
  const writer = writable.getWriter();
  void Promise.all([...[1, 2, 3].map((byte) => writer.write(Uint8Array.of(byte))), writer.close()]);
  await readAll(readable, (bytes) => {
    if (bytes[0] === 2) throw new Error('two');
    bytesRead.push(bytes[0] ?? 0);
  });
  assert.deepEqual([bytesRead, reported.length], [[1, 3], 1]);
});

test('the end of a session that could not be used is not reported', async () => {
  let end = (_: object): void => {};
  class UnusableTransport {
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
  Object.assign(globalThis, { WebTransport: UnusableTransport });
  const events: string[] = [];
  const listener: Listener = { onOpen: () => {}, onData: () => {}, onClose: (code) => events.push(`closed ${code}`) };
  await assert.rejects(openDatagrams(RELAY, TO, listener));
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(events, []);
});

test('a session ends when the server closes it after the stream, or after some seconds', async (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  for (const [isImmediate, isAnswered] of [[false, true], [false, false], [true, false]] as const) {
    const events: string[] = [];
    let end = (_: object): void => {};
    class FakeTransport {
      readonly ready = Promise.resolve();
      readonly closed = new Promise((resolve) => (end = resolve));
      readonly datagrams = { readable: new ReadableStream(), writable: new WritableStream() };
      createBidirectionalStream(): Promise<object> {
        const writable = new WritableStream({
          write: ({ length }) => void events.push(`wrote ${length}`),
          close: () => void events.push('stream closed'),
        });
        return Promise.resolve({ readable: new ReadableStream(), writable });
      }
      close(): void {
        events.push('closed');
      }
    }
    Object.assign(globalThis, { WebTransport: FakeTransport });
    const listener: Listener = { onOpen: () => {}, onData: () => {}, onClose: (code) => events.push(`reports ${code}`) };
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
    if (isImmediate) assert.ok(events.includes('closed') && !events.includes('stream closed'));
    else assert.deepEqual(events, ['wrote 3', 'stream closed', isAnswered ? 'reports 1000' : 'closed']);
  }
});

test('without datagrams the connection is a WebSocket', async () => {
  const withoutDatagrams = createTestTransports(async () => null, () => true);
  withoutDatagrams.open();
  await withoutDatagrams.settle();
  assert.deepEqual(withoutDatagrams.attempts, ['asks', 'socket']);
  const webSocketOnly = createTestTransports(async () => TO, () => true);
  webSocketOnly.open(true);
  await webSocketOnly.settle();
  assert.deepEqual(webSocketOnly.attempts, ['socket']);
});

test('a user who leaves before the socket is open is not connected', async () => {
  const { events, open, settle } = createTestTransports(async () => TO, () => true);
  open().close(false);
  await settle();
  assert.deepEqual(events, ['datagrams closes at once']);
});

test('complete frames are read from a stream, however it is divided into chunks', () => {
  const frames = [[1, 2, 0, 9, 9], [6, 0, 0], [4, 1, 0, 5]];
  const bytes = Uint8Array.from(frames.flat());
  for (let length = 1; length <= bytes.length; length++) {
    const kinds: number[] = [];
    const split = createSplitter((frames) => {
      const view = new DataView(frames);
      for (let at = 0; at < view.byteLength; at += 3 + view.getUint16(at + 1, true)) kinds.push(view.getUint8(at));
      assert.ok(frames.byteLength > 0);
    });
    for (let at = 0; at < bytes.length; at += length) split(bytes.subarray(at, at + length));
    assert.deepEqual(kinds, [1, 6, 4]);
  }
});

test('frames of one task are combined in a datagram, up to its greatest size', async () => {
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

test('descriptions of rooms are parsed, and malformed ones or malformed parts ignored', () => {
  const hash = '0a'.repeat(32);
  const description = readDescription({ peers: true, datagrams: { port: 8443, hashes: [hash] } });
  assert.equal(description?.peers, true);
  assert.deepEqual([description?.datagrams?.port, [...(description?.datagrams?.hashes[0] ?? [])]], [8443, Array(32).fill(10)]);
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
