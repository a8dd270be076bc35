import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inviteOf, readAddress, relayOf, shownName } from '../src/rooms/address';
import { connect, type State } from '../src/rooms/connection';
import type { FromServer } from '../src/rooms/frames';
import type { Listener, Socket } from '../src/rooms/server';
import { createSteppedClock } from './support/clock';
import { encodeBody, encodeFrame, REST } from './support/rooms';

/** A socket that a test opens and closes. */
class Fake implements Socket {
  bufferedAmount = 0;
  readonly sent: Uint8Array[] = [];
  /** For each sent frame, whether it may get lost. */
  readonly passing: boolean[] = [];
  isClosed = false;
  isImmediate = false;

  constructor(
    readonly url: string,
    private readonly listener: Listener,
  ) {}

  send(data: Uint8Array, mayBeLost: boolean): void {
    this.sent.push(data);
    this.passing.push(mayBeLost);
  }

  close(isImmediate: boolean): void {
    [this.isClosed, this.isImmediate] = [true, isImmediate];
  }

  open(): void {
    this.listener.opened();
  }

  /** Deliver frames of the server in one message. */
  comes(...frames: readonly (FromServer | Uint8Array)[]): void {
    const bytes = frames.map((frame) => (frame instanceof Uint8Array ? frame : encodeFrame(frame)));
    this.data(Uint8Array.from(Buffer.concat(bytes)).buffer);
  }

  data(data: unknown): void {
    this.listener.received(data);
  }

  breaks(code = 1006): void {
    this.listener.closed(code);
  }
}

type Bench = ReturnType<typeof bench>;

/** A connection to sockets of the test, on a clock that the test advances. */
function bench() {
  const { advance, ...clock } = createSteppedClock();
  const [sockets, states, heard]: [Fake[], State[], FromServer[]] = [[], [], []];
  const connection = connect({
    address: { room: 'a b', name: 'Ada', group: 3, token: '7.x.y' },
    page: 'https://host:8/folder/index.html?room=1#p=1,2,3',
    onFrame: (frame) => heard.push(frame),
    changed: (state) => states.push(state),
    open: (url, listener) => {
      sockets.push(new Fake(url, listener));
      return sockets.at(-1) as Fake;
    },
    clock,
  });
  /** The socket that was opened last. */
  const socket = (): Fake => sockets.at(-1) as Fake;
  return { connection, sockets, states, heard, socket, pass: advance };
}

const WELCOME: FromServer = { kind: 'welcome', user: 5, others: 1, ticket: new Uint8Array([1, 2, 3]) };
const PEER: FromServer = { kind: 'joined', user: 6, group: 3, name: 'Peer' };

function enterRoom(): Bench {
  const made = bench();
  made.socket().open();
  made.socket().comes(WELCOME, PEER);
  return made;
}

test('it joins the room beside the page, by name and token', () => {
  const { socket, states, heard, connection } = bench();
  assert.equal(socket().url, 'wss://host:8/folder/rooms/a%20b?token=7.x.y');
  assert.deepEqual(connection.state, { kind: 'joining' });
  assert.equal(connection.pose(REST, false), false);
  socket().open();
  assert.equal(Buffer.from(socket().sent[0] ?? []).toString('hex'), '010800' + '010300' + '03416461' + '00');
  socket().comes(WELCOME, PEER);
  assert.deepEqual(states.at(-1), { kind: 'here', user: 5 });
  assert.deepEqual(heard.map(({ kind }) => kind), ['welcome', 'joined']);
});

test('a pose older than the last one is not passed on, nor one of an absent user', () => {
  const { socket, heard } = enterRoom();
  const pose = (sequence: number, stops = false): FromServer =>
    ({ kind: 'pose', user: 6, pose: { ...REST, sequence, clock: 0n, isAcknowledged: false, stops } });
  const passed = (): readonly number[] =>
    heard.splice(0).flatMap((frame) => (frame.kind === 'pose' ? [frame.pose.sequence] : []));
  socket().comes(pose(5, true), pose(4), pose(5), pose(6));
  assert.deepEqual(passed(), [5, 6]);
  socket().comes({ kind: 'left', user: 6 }, pose(7));
  assert.deepEqual(passed(), []);
  // A user with a new number starts afresh.
  socket().comes(PEER, pose(1));
  assert.deepEqual(passed(), [1]);
});

test('it reconnects with its ticket, after pauses that double up to half a minute', () => {
  const { socket, sockets, states, pass } = enterRoom();
  socket().breaks();
  for (const seconds of [1, 2, 4, 8, 16, 30, 30]) {
    const state = states.at(-1);
    assert.deepEqual(state?.kind === 'waiting' && state.seconds, seconds);
    const before = sockets.length;
    pass(seconds - 0.01);
    assert.equal(sockets.length, before);
    pass(0.01);
    assert.equal(sockets.length, before + 1);
    socket().breaks();
  }
  pass(30);
  socket().open();
  assert.deepEqual([...(socket().sent[0] ?? [])].slice(-4), [3, 1, 2, 3]);
  socket().comes(WELCOME);
  // After a long connection the pause is the shortest again.
  pass(10);
  socket().breaks();
  const state = states.at(-1);
  assert.deepEqual(state?.kind === 'waiting' && state.seconds, 1);
});

test('a server that admits and throws out is not asked faster and faster', () => {
  const { socket, states, pass } = enterRoom();
  socket().breaks(4006);
  pass(1);
  socket().open();
  socket().comes(WELCOME);
  socket().breaks(4006);
  const state = states.at(-1);
  assert.ok(state?.kind === 'waiting' && state.seconds === 2 && /more than the server accepts/.test(state.words));
});

test('reasons are given in words, and final ones stop reconnection until the user asks', () => {
  const words: Readonly<Record<number, [string, RegExp]>> = {
    2: ['ended', /another version/],
    4: ['ended', /does not let you into/],
    9: ['ended', /entered the room elsewhere/],
    5: ['waiting', /full/],
    10: ['waiting', /shutting down/],
    200: ['waiting', /ended the connection/],
  };
  for (const [reason, [kind, expected]] of Object.entries(words)) {
    for (const isFrame of [true, false]) {
      const { socket, sockets, states, connection } = enterRoom();
      if (isFrame) socket().comes({ kind: 'refused', reason: Number(reason), sentence: '<b>' });
      else socket().breaks(4000 + Number(reason));
      const state = states.at(-1);
      assert.equal(state?.kind, kind);
      assert.match(state && 'words' in state ? state.words : '', expected);
      if (isFrame) socket().breaks();
      connection.retry();
      assert.equal(sockets.length, 2);
    }
  }
});

test('a server that does not answer is distinguished from one that breaks off', () => {
  const silent = bench();
  silent.pass(15);
  assert.match(JSON.stringify(silent.states.at(-1)), /does not answer/);
  assert.ok(silent.sockets[0]?.isClosed);
  const absent = bench();
  absent.socket().breaks();
  assert.match(JSON.stringify(absent.states.at(-1)), /cannot be reached/);
  const broken = enterRoom();
  broken.socket().breaks();
  assert.match(JSON.stringify(broken.states.at(-1)), /was lost/);
});

test('malformed frames end the connection, and later frames are ignored', () => {
  const unknown = encodeBody(7, new Uint8Array()).slice().buffer;
  for (const data of ['text', new Uint8Array([130, 1]).buffer, unknown]) {
    const { socket, states, heard } = enterRoom();
    const [count, own] = [heard.length, socket()];
    own.data(data);
    assert.equal(states.at(-1)?.kind, 'waiting');
    own.comes(PEER);
    own.breaks();
    assert.equal(heard.length, count);
    assert.equal(states.filter(({ kind }) => kind === 'waiting').length, 1);
  }
  const twice = enterRoom();
  twice.socket().comes(WELCOME);
  assert.equal(twice.states.at(-1)?.kind, 'waiting');
  const early = bench();
  early.socket().comes(PEER);
  assert.equal(early.states.at(-1)?.kind, 'waiting');
});

test('poses of others that ask for it are acknowledged at once', () => {
  const { socket } = enterRoom();
  const before = socket().sent.length;
  socket().comes(
    { kind: 'pose', user: 6, pose: { ...REST, sequence: 8 } },
    { kind: 'pose', user: 6, pose: { ...REST, sequence: 9, isAcknowledged: true } },
  );
  const answers = socket().sent.slice(before).map((bytes) => Buffer.from(bytes).toString('hex'));
  assert.deepEqual(answers, ['030600' + '0600' + '09000000']);
});

test('frames that a later one replaces may get lost, the last one before a pause may not', () => {
  const { connection, socket, pass } = enterRoom();
  const before = socket().sent.length;
  connection.pose(REST, false);
  connection.pose(REST, true);
  // An earlier frame is outstanding, so this one asks for an acknowledgement, too.
  assert.deepEqual(poses(socket()), [[1, 1], [2, 3]]);
  const theirs = { ...REST, isAcknowledged: true };
  socket().comes({ kind: 'pose', user: 6, pose: { ...theirs, sequence: 8 } });
  socket().comes({ kind: 'pose', user: 6, pose: { ...theirs, sequence: 9, stops: true } });
  assert.deepEqual(socket().passing.slice(before), [true, false, true, false]);
  socket().comes({ kind: 'settled', sequence: 2 });
  pass(0.01);
  connection.pose(REST, true);
  assert.deepEqual(poses(socket()).at(-1), [3, 2]);
  connection.leave();
  assert.equal(socket().passing.at(-1), false);
});

test('datagrams that overtake the welcome are ignored', () => {
  const { socket, states, heard } = bench();
  socket().open();
  const sent = socket().sent.length;
  socket().comes({ kind: 'pose', user: 6, pose: { ...REST, sequence: 8, isAcknowledged: true } });
  socket().comes({ kind: 'settled', sequence: 2 });
  assert.deepEqual([heard.length, socket().sent.length, states.at(-1)?.kind], [0, sent, 'joining']);
});

/** Sequence numbers and flags of the sent poses. */
function poses(socket: Fake): [number, number][] {
  const sent = socket.sent.filter(([kind]) => kind === 2).map((bytes) => Buffer.from(bytes));
  return sent.map((bytes) => [bytes.readUInt32LE(3), bytes[15] ?? 0]);
}

test('round trips last from sending to acknowledgement, for some poses, on one clock', () => {
  const { connection, socket, pass } = enterRoom();
  assert.equal(connection.roundTrips.median, null);
  for (let number = 0; number < 3; number++) {
    assert.ok(connection.pose(REST, number === 2));
    pass(0.125);
  }
  assert.deepEqual(poses(socket()), [[1, 1], [2, 0], [3, 3]]);
  socket().comes({ kind: 'settled', sequence: 2 });
  assert.ok(Math.abs((connection.roundTrips.median ?? 0) - 0.375) < 1e-9);
  // Poses without recipients are not acknowledged.
  socket().comes({ kind: 'left', user: 6 });
  pass(1);
  connection.pose(REST, false);
  assert.deepEqual(poses(socket()).at(-1), [4, 0]);
});

test('round trips of poses are forgotten when nobody is left to acknowledge them', () => {
  const { connection, socket, pass } = enterRoom();
  connection.pose(REST, false);
  socket().comes({ kind: 'left', user: 6 });
  pass(60);
  socket().comes(PEER);
  connection.pose(REST, false);
  pass(0.125);
  socket().comes({ kind: 'settled', sequence: 2 });
  assert.ok(Math.abs((connection.roundTrips.median ?? 0) - 0.125) < 1e-9);
});

test('a peer that never acknowledges does not stop the measurement', () => {
  const { connection, socket, pass } = enterRoom();
  for (let number = 0; number < 100; number++) {
    connection.pose(REST, false);
    pass(0.25);
  }
  assert.ok(poses(socket()).every(([, flags]) => flags === 1));
});

test('poses do not queue behind others', () => {
  const { connection, socket } = enterRoom();
  socket().bufferedAmount = 1 << 20;
  assert.equal(connection.pose(REST, false), false);
  socket().bufferedAmount = 0;
  assert.equal(connection.pose(REST, false), true);
  assert.deepEqual(poses(socket()), [[1, 1]]);
});

test('leaving sends a goodbye, and does not reconnect by itself', () => {
  const { connection, socket, sockets, states, pass } = enterRoom();
  connection.leave();
  assert.deepEqual([...(socket().sent.at(-1) ?? [])], [6, 0, 0]);
  socket().breaks(1000);
  pass(100);
  assert.equal(sockets.length, 1);
  assert.equal(states.at(-1)?.kind, 'ended');
});

test('joining again waits some seconds until the server has closed the previous socket', () => {
  const { connection, sockets, states, pass } = enterRoom();
  connection.leave();
  connection.retry();
  assert.equal(states.at(-1)?.kind, 'joining');
  pass(4.99);
  assert.equal(sockets.length, 1);
  sockets[0]?.breaks(1000);
  assert.equal(sockets.length, 2);
  // Also before admission, when the hello may be on its way; users who change their mind stay away.
  sockets[1]?.open();
  for (let count = 0; count < 2; count++) {
    connection.leave();
    connection.retry();
  }
  connection.leave();
  sockets[1]?.breaks(1000);
  assert.deepEqual([sockets.length, states.at(-1)?.kind], [2, 'ended']);
  connection.retry();
  connection.leave();
  connection.retry();
  pass(4.99);
  assert.equal(sockets.length, 3);
  pass(0.01);
  assert.equal(sockets.length, 4);
  sockets[2]?.breaks();
  assert.deepEqual([sockets.length, states.at(-1)?.kind], [4, 'joining']);
});

test('a closing page waits for nothing', () => {
  for (const isImmediate of [true, false]) {
    const { connection, socket } = enterRoom();
    connection.leave(isImmediate);
    assert.deepEqual([socket().isClosed, socket().isImmediate], [true, isImmediate]);
  }
});

test('an address names a room, or the error says what was expected', () => {
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
  assert.deepEqual([shownName('Ada', 3), shownName('Ada', 4), shownName('', 5)], ['Ada #3', 'Ada #4', 'Guest #5']);
});
