import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inviteOf, readAddress, relayOf, displayName } from '../src/rooms/address';
import { connect, type State } from '../src/rooms/connection';
import type { FromServer } from '../src/rooms/frames';
import type { Listener, Socket } from '../src/rooms/server';
import { createSteppedClock } from './support/clock';
import { encodeBody, encodeFrame, REST } from './support/rooms';

/** Socket that a test opens and closes. */
class FakeSocket implements Socket {
  bufferedAmount = 0;
  readonly sent: Uint8Array[] = [];
  /** Whether each sent frame may get lost. */
  readonly mayBeLost: boolean[] = [];
  isClosed = false;
  isImmediate = false;

  constructor(
    readonly url: string,
    private readonly listener: Listener,
  ) {}

  send(data: Uint8Array, mayBeLost: boolean): void {
    this.sent.push(data);
    this.mayBeLost.push(mayBeLost);
  }

  close(isImmediate: boolean): void {
    [this.isClosed, this.isImmediate] = [true, isImmediate];
  }

  open(): void {
    this.listener.onOpen();
  }

  /** Delivers frames of the server in one message. */
  deliver(...frames: readonly (FromServer | Uint8Array)[]): void {
    const bytes = frames.map((frame) => (frame instanceof Uint8Array ? frame : encodeFrame(frame)));
    this.deliverData(Uint8Array.from(Buffer.concat(bytes)).buffer);
  }

  deliverData(data: unknown): void {
    this.listener.onData(data);
  }

  break(code = 1006): void {
    this.listener.onClose(code);
  }
}

type TestConnection = ReturnType<typeof createTestConnection>;

/** Creates a connection with fake sockets, on a clock that the test advances. */
function createTestConnection() {
  const { advance, ...clock } = createSteppedClock();
  const [sockets, states, frames]: [FakeSocket[], State[], FromServer[]] = [[], [], []];
  const connection = connect({
    address: { room: 'a b', name: 'Ada', group: 3, token: '7.x.y' },
    page: 'https://host:8/folder/index.html?room=1#p=1,2,3',
    onFrame: (frame) => frames.push(frame),
    onChange: (state) => states.push(state),
    open: (url, listener) => {
      sockets.push(new FakeSocket(url, listener));
      return sockets.at(-1) as FakeSocket;
    },
    clock,
  });
  /** Latest socket. */
  const socket = (): FakeSocket => sockets.at(-1) as FakeSocket;
  return { connection, sockets, states, frames, socket, advance };
}

const WELCOME: FromServer = { kind: 'welcome', user: 5, others: 1, ticket: new Uint8Array([1, 2, 3]) };
const PEER: FromServer = { kind: 'joined', user: 6, group: 3, name: 'Peer' };

function enterRoom(): TestConnection {
  const context = createTestConnection();
  context.socket().open();
  context.socket().deliver(WELCOME, PEER);
  return context;
}

test('the page joins the room on its own server, by name and token', () => {
  const { socket, states, frames, connection } = createTestConnection();
  assert.equal(socket().url, 'wss://host:8/folder/rooms/a%20b?token=7.x.y');
  assert.deepEqual(connection.state, { kind: 'joining' });
  assert.equal(connection.pose(REST, false), false);
  socket().open();
  assert.equal(Buffer.from(socket().sent[0] ?? []).toString('hex'), '010800' + '010300' + '03416461' + '00');
  socket().deliver(WELCOME, PEER);
  assert.deepEqual(states.at(-1), { kind: 'here', user: 5 });
  assert.deepEqual(frames.map(({ kind }) => kind), ['welcome', 'joined']);
});

test('poses older than the last one, and poses of absent users, are ignored', () => {
  const { socket, frames } = enterRoom();
  const pose = (sequence: number, stops = false): FromServer =>
    ({ kind: 'pose', user: 6, pose: { ...REST, sequence, clock: 0n, isAcknowledged: false, stops } });
  const sequences = (): readonly number[] =>
    frames.splice(0).flatMap((frame) => (frame.kind === 'pose' ? [frame.pose.sequence] : []));
  socket().deliver(pose(5, true), pose(4), pose(5), pose(6));
  assert.deepEqual(sequences(), [5, 6]);
  socket().deliver({ kind: 'left', user: 6 }, pose(7));
  assert.deepEqual(sequences(), []);
  // Sequence numbers start again when the user returns.
  socket().deliver(PEER, pose(1));
  assert.deepEqual(sequences(), [1]);
});

test('the page reconnects with its ticket, after pauses that double up to half a minute', () => {
  const { socket, sockets, states, advance } = enterRoom();
  socket().break();
  for (const seconds of [1, 2, 4, 8, 16, 30, 30]) {
    const state = states.at(-1);
    assert.deepEqual(state?.kind === 'waiting' && state.seconds, seconds);
    const before = sockets.length;
    advance(seconds - 0.01);
    assert.equal(sockets.length, before);
    advance(0.01);
    assert.equal(sockets.length, before + 1);
    socket().break();
  }
  advance(30);
  socket().open();
  assert.deepEqual([...(socket().sent[0] ?? [])].slice(-4), [3, 1, 2, 3]);
  socket().deliver(WELCOME);
  // After a long connection the pause is the shortest again.
  advance(10);
  socket().break();
  const state = states.at(-1);
  assert.deepEqual(state?.kind === 'waiting' && state.seconds, 1);
});

test('pauses also double if the server admits the user and then ends the connection', () => {
  const { socket, states, advance } = enterRoom();
  socket().break(4006);
  advance(1);
  socket().open();
  socket().deliver(WELCOME);
  socket().break(4006);
  const state = states.at(-1);
  assert.ok(state?.kind === 'waiting' && state.seconds === 2 && /more than the server accepts/.test(state.words));
});

test('reasons become sentences, and after final ones the page reconnects only if the user wants', () => {
  const reasons: Readonly<Record<number, [string, RegExp]>> = {
    2: ['ended', /another version/],
    4: ['ended', /does not let you into/],
    9: ['ended', /entered the room elsewhere/],
    5: ['waiting', /full/],
    10: ['waiting', /shutting down/],
    200: ['waiting', /ended the connection/],
  };
  for (const [reason, [kind, expected]] of Object.entries(reasons)) {
    for (const isFrame of [true, false]) {
      const { socket, sockets, states, connection } = enterRoom();
      if (isFrame) socket().deliver({ kind: 'refused', reason: Number(reason), sentence: '<b>' });
      else socket().break(4000 + Number(reason));
      const state = states.at(-1);
      assert.equal(state?.kind, kind);
      assert.match(state && 'words' in state ? state.words : '', expected);
      if (isFrame) socket().break();
      connection.retry();
      assert.equal(sockets.length, 2);
    }
  }
});

test('a silent server, an unreachable one and a lost connection are told apart', () => {
  const silentServer = createTestConnection();
  silentServer.advance(15);
  assert.match(JSON.stringify(silentServer.states.at(-1)), /does not answer/);
  assert.ok(silentServer.sockets[0]?.isClosed);
  const unreachable = createTestConnection();
  unreachable.socket().break();
  assert.match(JSON.stringify(unreachable.states.at(-1)), /cannot be reached/);
  const lost = enterRoom();
  lost.socket().break();
  assert.match(JSON.stringify(lost.states.at(-1)), /was lost/);
});

test('malformed frames end the connection, and later frames are ignored', () => {
  const unknown = encodeBody(7, new Uint8Array()).slice().buffer;
  for (const data of ['text', new Uint8Array([130, 1]).buffer, unknown]) {
    const { socket, states, frames } = enterRoom();
    const [count, firstSocket] = [frames.length, socket()];
    firstSocket.deliverData(data);
    assert.equal(states.at(-1)?.kind, 'waiting');
    firstSocket.deliver(PEER);
    firstSocket.break();
    assert.equal(frames.length, count);
    assert.equal(states.filter(({ kind }) => kind === 'waiting').length, 1);
  }
  const twice = enterRoom();
  twice.socket().deliver(WELCOME);
  assert.equal(twice.states.at(-1)?.kind, 'waiting');
  const early = createTestConnection();
  early.socket().deliver(PEER);
  assert.equal(early.states.at(-1)?.kind, 'waiting');
});

test('poses of others that request an acknowledgement get it at once', () => {
  const { socket } = enterRoom();
  const before = socket().sent.length;
  socket().deliver(
    { kind: 'pose', user: 6, pose: { ...REST, sequence: 8 } },
    { kind: 'pose', user: 6, pose: { ...REST, sequence: 9, isAcknowledged: true } },
  );
  const answers = socket().sent.slice(before).map((bytes) => Buffer.from(bytes).toString('hex'));
  assert.deepEqual(answers, ['030600' + '0600' + '09000000']);
});

test('frames that later ones replace may get lost, but not the last one before a pause', () => {
  const { connection, socket, advance } = enterRoom();
  const before = socket().sent.length;
  connection.pose(REST, false);
  connection.pose(REST, true);
  // The second pose also requests an acknowledgement, because the first is not acknowledged yet.
  assert.deepEqual(poses(socket()), [[1, 1], [2, 3]]);
  const pose = { ...REST, isAcknowledged: true };
  socket().deliver({ kind: 'pose', user: 6, pose: { ...pose, sequence: 8 } });
  socket().deliver({ kind: 'pose', user: 6, pose: { ...pose, sequence: 9, stops: true } });
  assert.deepEqual(socket().mayBeLost.slice(before), [true, false, true, false]);
  socket().deliver({ kind: 'settled', sequence: 2 });
  advance(0.01);
  connection.pose(REST, true);
  assert.deepEqual(poses(socket()).at(-1), [3, 2]);
  connection.leave();
  assert.equal(socket().mayBeLost.at(-1), false);
});

test('frames that overtake the welcome as datagrams are ignored', () => {
  const { socket, states, frames } = createTestConnection();
  socket().open();
  const sent = socket().sent.length;
  socket().deliver({ kind: 'pose', user: 6, pose: { ...REST, sequence: 8, isAcknowledged: true } });
  socket().deliver({ kind: 'settled', sequence: 2 });
  assert.deepEqual([frames.length, socket().sent.length, states.at(-1)?.kind], [0, sent, 'joining']);
});

/** Sequence numbers and flags of the sent poses. */
function poses(socket: FakeSocket): [number, number][] {
  const sent = socket.sent.filter(([kind]) => kind === 2).map((bytes) => Buffer.from(bytes));
  return sent.map((bytes) => [bytes.readUInt32LE(3), bytes[15] ?? 0]);
}

test('round trips of some poses are measured, from sending to acknowledgement', () => {
  const { connection, socket, advance } = enterRoom();
  assert.equal(connection.roundTrips.median, null);
  for (let number = 0; number < 3; number++) {
    assert.ok(connection.pose(REST, number === 2));
    advance(0.125);
  }
  assert.deepEqual(poses(socket()), [[1, 1], [2, 0], [3, 3]]);
  socket().deliver({ kind: 'settled', sequence: 2 });
  assert.ok(Math.abs((connection.roundTrips.median ?? 0) - 0.375) < 1e-9);
  // Poses without recipients are not acknowledged.
  socket().deliver({ kind: 'left', user: 6 });
  advance(1);
  connection.pose(REST, false);
  assert.deepEqual(poses(socket()).at(-1), [4, 0]);
});

test('open round trips are discarded when the last other user leaves', () => {
  const { connection, socket, advance } = enterRoom();
  connection.pose(REST, false);
  socket().deliver({ kind: 'left', user: 6 });
  advance(60);
  socket().deliver(PEER);
  connection.pose(REST, false);
  advance(0.125);
  socket().deliver({ kind: 'settled', sequence: 2 });
  assert.ok(Math.abs((connection.roundTrips.median ?? 0) - 0.125) < 1e-9);
});

test('poses still request acknowledgements if a user never acknowledges', () => {
  const { connection, socket, advance } = enterRoom();
  for (let number = 0; number < 100; number++) {
    connection.pose(REST, false);
    advance(0.25);
  }
  assert.ok(poses(socket()).every(([, flags]) => flags === 1));
});

test('poses are not sent while many bytes are buffered', () => {
  const { connection, socket } = enterRoom();
  socket().bufferedAmount = 1 << 20;
  assert.equal(connection.pose(REST, false), false);
  socket().bufferedAmount = 0;
  assert.equal(connection.pose(REST, false), true);
  assert.deepEqual(poses(socket()), [[1, 1]]);
});

test('a user who leaves sends a bye, and is not reconnected', () => {
  const { connection, socket, sockets, states, advance } = enterRoom();
  connection.leave();
  assert.deepEqual([...(socket().sent.at(-1) ?? [])], [6, 0, 0]);
  socket().break(1000);
  advance(100);
  assert.equal(sockets.length, 1);
  assert.equal(states.at(-1)?.kind, 'ended');
});

test('joining again waits some seconds until the server has closed the previous socket', () => {
  const { connection, sockets, states, advance } = enterRoom();
  connection.leave();
  connection.retry();
  assert.equal(states.at(-1)?.kind, 'joining');
  advance(4.99);
  assert.equal(sockets.length, 1);
  sockets[0]?.break(1000);
  assert.equal(sockets.length, 2);
  // The same before the welcome, when the hello may be on its way; the user's last decision counts.
  sockets[1]?.open();
  for (let count = 0; count < 2; count++) {
    connection.leave();
    connection.retry();
  }
  connection.leave();
  sockets[1]?.break(1000);
  assert.deepEqual([sockets.length, states.at(-1)?.kind], [2, 'ended']);
  connection.retry();
  connection.leave();
  connection.retry();
  advance(4.99);
  assert.equal(sockets.length, 3);
  advance(0.01);
  assert.equal(sockets.length, 4);
  sockets[2]?.break();
  assert.deepEqual([sockets.length, states.at(-1)?.kind], [4, 'joining']);
});

test('a closing page closes its socket immediately', () => {
  for (const isImmediate of [true, false]) {
    const { connection, socket } = enterRoom();
    connection.leave(isImmediate);
    assert.deepEqual([socket().isClosed, socket().isImmediate], [true, isImmediate]);
  }
});

test('the room of an address is parsed, and errors name the parameter', () => {
  const read = (query: string): ReturnType<typeof readAddress> => readAddress(new URLSearchParams(query));
  assert.deepEqual(read('room=x'), { room: 'x', name: 'Guest', group: 0, token: null });
  const all = { room: 'x', name: 'Ada', group: 65535, token: 't' };
  assert.deepEqual(read('room=x&name=%20Ada%0A&group=65535&token=t'), all);
  assert.deepEqual(read('room=x&name=A%E2%80%8Bda&group=65535&token=t'), all);
  assert.deepEqual(read(`room=x&name=${'é'.repeat(40)}`), { ...(read('room=x') as object), name: 'é'.repeat(32) });
  const [rooms, groups] = [['', '.', '..', 'a/b', 'a%00', 'x'.repeat(65)], ['', '-1', '65536', '1.5', 'x']];
  for (const room of rooms) assert.match(String(read(`room=${room}`)), /^room:/);
  for (const group of groups) assert.match(String(read(`room=x&group=${group}`)), /^group:/);
});

test('the relay is beside the page, and an invitation omits the user’s own settings', () => {
  const address = { room: '#?é', name: 'n', group: 0, token: null };
  assert.equal(relayOf('http://h/a/b?c#d', address), 'ws://h/a/rooms/%23%3F%C3%A9');
  const own = 'http://h/?room=x&name=A&token=t&peers=off&group=2&datagrams=off#p=1,2,3';
  assert.equal(inviteOf(own), 'http://h/?room=x&group=2#p=1,2,3');
});

test('users of the same name are distinguished by their numbers', () => {
  assert.deepEqual([displayName('Ada', 3), displayName('Ada', 4), displayName('', 5)], ['Ada #3', 'Ada #4', 'Guest #5']);
});
