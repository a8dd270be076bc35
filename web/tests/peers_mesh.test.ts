import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Call, type CallEvents, type Signal, writeSignal } from '../src/peers/call';
import { createMesh } from '../src/peers/mesh';
import { waitUntilIdle, steppedClock, createWires } from './support/peers';

const SDP = 'm=application 9 UDP/DTLS/SCTP webrtc-datachannel\r\n';

interface TestCall extends Call {
  readonly events: CallEvents;
  readonly log: string[];
}

/** Creates a mesh, of which the test sees the calls and signals. */
function createTestMesh() {
  const clock = steppedClock();
  const [calls, opened, ended]: [TestCall[], number[], number[]] = [[], [], []];
  /** Sent signals with their recipients. */
  const sent: [user: number, signal: Signal][] = [];
  let isFull = false;
  const mesh = createMesh({
    clock,
    create(events) {
      if (isFull) throw new Error('too many connections');
      const log: string[] = [];
      const record = (word: string): Promise<string> => {
        log.push(word);
        return word.includes('garbage') ? Promise.reject(new Error('garbage')) : Promise.resolve(SDP);
      };
      const call: TestCall = {
        events,
        log,
        offer: () => record('offer'),
        answer: (offer) => record(`answer ${offer}`),
        accept: async (answer) => void (await record(`accept ${answer}`)),
        close: () => void log.push('close'),
      };
      calls.push(call);
      return call;
    },
    signal: (user, signal) => sent.push([user, signal]),
    onOpen: (user) => opened.push(user),
    onEnd: (user) => ended.push(user),
  });
  const context = {
    mesh,
    clock,
    calls,
    sent,
    opened,
    ended,
    isReady: false,
    /** Enters the room as a user, with others in it. */
    enter(own: number, ...others: readonly number[]): void {
      mesh.hear({ kind: 'welcome', user: own, others: others.length, ticket: new Uint8Array() });
      for (const user of others) mesh.hear({ kind: 'joined', user, group: 0, name: '' });
    },
    async sendSignal(user: number, signal: Signal | Uint8Array): Promise<void> {
      mesh.hear({ kind: 'signal', user, payload: signal instanceof Uint8Array ? signal : writeSignal(signal) });
      await waitUntilIdle(2);
    },
    /** Makes the browser fail to create connections. */
    refuseCalls: (): void => void (isFull = true),
  };
  void mesh.ready.then(() => (context.isReady = true));
  return context;
}

const offer = (attempt = 1, sdp = SDP): Signal => ({ kind: 'offer', attempt, sdp });
const open = (call: TestCall | undefined): void => call?.events.onOpen(createWires()[0]);

test('the user with the smaller number offers, and the other one answers', async () => {
  const { mesh, enter, calls, sent, sendSignal, opened } = createTestMesh();
  mesh.setEnabled(true);
  enter(5, 3, 9);
  await waitUntilIdle(2);
  assert.deepEqual(sent.map(([user, { kind }]) => [user, kind]), [[9, 'offer']]);
  await sendSignal(3, offer(77));
  assert.deepEqual(sent[1], [3, { kind: 'answer', attempt: 77, sdp: SDP }]);
  await sendSignal(9, { kind: 'answer', attempt: sent[0]?.[1].attempt ?? 0, sdp: SDP });
  assert.deepEqual(calls.map(({ log }) => log), [['offer', `accept ${SDP}`], [`answer ${SDP}`]]);
  calls.forEach(open);
  assert.deepEqual(opened, [9, 3]);
});

test('downloads wait until all users have sent their lists of files or failed to connect, up to a timeout', async () => {
  const alone = createTestMesh();
  alone.mesh.setEnabled(true);
  alone.enter(5);
  await waitUntilIdle(2);
  assert.ok(alone.isReady);
  const room = createTestMesh();
  room.enter(5, 3, 9);
  room.mesh.setEnabled(true);
  await room.sendSignal(3, offer());
  open(room.calls[0]);
  await waitUntilIdle(2);
  room.mesh.recordFiles(9);
  open(room.calls[1]);
  await waitUntilIdle(2);
  assert.equal(room.isReady, false);
  room.mesh.recordFiles(3);
  await waitUntilIdle(2);
  assert.ok(room.isReady);
  const slow = createTestMesh();
  slow.mesh.setEnabled(true);
  await slow.clock.advance(1.25);
  slow.enter(1, 2, 3);
  await waitUntilIdle(2);
  open(slow.calls[0]);
  await slow.clock.advance(1.25);
  assert.equal(slow.isReady, false);
  await slow.clock.advance(0.25);
  assert.ok(slow.isReady);
  const outside = createTestMesh();
  await outside.clock.advance(1.5);
  assert.ok(outside.isReady);
  const refused = createTestMesh();
  refused.mesh.setEnabled(true);
  refused.enter(1, 2);
  await refused.sendSignal(2, { kind: 'no', attempt: 0, sdp: '' });
  assert.ok(refused.isReady);
});

test('a page that does not share files tells others, and answers no offer', async () => {
  const { mesh, enter, calls, sent, sendSignal } = createTestMesh();
  enter(5, 3, 9);
  await sendSignal(3, offer());
  mesh.setEnabled(false);
  mesh.hear({ kind: 'joined', user: 12, group: 0, name: '' });
  await sendSignal(3, offer());
  assert.deepEqual(calls, []);
  assert.deepEqual(sent.map(([user, { kind }]) => [user, kind]), [[3, 'no'], [9, 'no'], [12, 'no'], [3, 'no']]);
});

test('the end of the exchange closes all connections, and others are told', async () => {
  const { mesh, enter, calls, sent, sendSignal, ended } = createTestMesh();
  mesh.setEnabled(true);
  enter(5, 3, 9);
  await sendSignal(3, offer());
  calls.forEach(open);
  sent.length = 0;
  mesh.setEnabled(false);
  assert.deepEqual([ended, calls.map(({ log }) => log.at(-1))], [[9, 3], ['close', 'close']]);
  assert.deepEqual(sent.map(([user, { kind }]) => [user, kind]), [[3, 'no'], [9, 'no']]);
  await sendSignal(3, offer(2));
  mesh.hear({ kind: 'joined', user: 11, group: 0, name: '' });
  assert.equal(calls.length, 2);
});

test('offers that arrive before the server allows connections are answered afterwards', async () => {
  const { mesh, enter, sent, sendSignal } = createTestMesh();
  enter(5, 3);
  await sendSignal(3, offer(8));
  assert.deepEqual(sent, []);
  mesh.setEnabled(true);
  await waitUntilIdle(2);
  assert.deepEqual(sent, [[3, { kind: 'answer', attempt: 8, sdp: SDP }]]);
});

test('malformed messages of a user end only the connection to this user', async () => {
  const { mesh, enter, calls, sent, sendSignal, ended } = createTestMesh();
  mesh.setEnabled(true);
  enter(5, 3, 4, 9);
  await sendSignal(3, offer());
  await sendSignal(4, offer());
  calls.forEach(open);
  await sendSignal(3, new Uint8Array([9, 9, 9]));
  await sendSignal(77, offer());
  await sendSignal(9, offer());
  assert.deepEqual(ended, [3]);
  // Offers from a user with a greater number, or from an absent user, are not answered.
  assert.equal(calls.length, 3);
  assert.deepEqual(sent.filter(([, { kind }]) => kind === 'no').map(([user]) => user), [9]);
  for (const [attempt, sdp] of [[1, SDP], [2, SDP.replace('9', 'garbage')]] as const) await sendSignal(4, offer(attempt, sdp));
  await sendSignal(4, offer(3, `${SDP}a=garbage\r\n`));
  assert.deepEqual(ended, [3, 4]);
  assert.equal(mesh.dropped.size, 0);
});

test('unexpected answers are ignored, and malformed ones end the connection', async () => {
  const { mesh, enter, calls, sent, sendSignal } = createTestMesh();
  mesh.setEnabled(true);
  enter(5, 3, 9);
  await waitUntilIdle(2);
  const attempt = sent[0]?.[1].attempt ?? 0;
  await sendSignal(9, { kind: 'answer', attempt: attempt + 1, sdp: SDP });
  await sendSignal(3, { kind: 'answer', attempt, sdp: SDP });
  assert.deepEqual(calls[0]?.log, ['offer']);
  await sendSignal(9, { kind: 'answer', attempt, sdp: `${SDP}a=garbage\r\n` });
  assert.match(mesh.dropped.get(9) ?? '', /answer/);
  assert.equal(calls[0]?.log.at(-1), 'close');
});

test('dropped users are not reconnected, nor are users who offer too often', async () => {
  const { mesh, enter, calls, sendSignal } = createTestMesh();
  mesh.setEnabled(true);
  enter(5, 3, 9);
  await waitUntilIdle(2);
  open(calls[0]);
  calls[0]?.events.onViolation('it opens another channel');
  assert.deepEqual([...mesh.dropped], [[9, 'it opens another channel']]);
  mesh.hear({ kind: 'left', user: 9 });
  mesh.hear({ kind: 'joined', user: 9, group: 0, name: '' });
  assert.equal(calls.length, 1);
  for (let attempt = 0; attempt < 12; attempt++) await sendSignal(3, offer(attempt));
  assert.match(mesh.dropped.get(3) ?? '', /too often/);
  assert.equal(calls.length, 9);
  assert.equal(calls.filter(({ log }) => log.at(-1) === 'close').length, 9);
});

test('failed connections end, and others close when their users leave', async () => {
  const { mesh, enter, calls, clock, ended, opened } = createTestMesh();
  mesh.setEnabled(true);
  enter(1, 2, 3, 4);
  await waitUntilIdle(2);
  open(calls[0]);
  open(calls[1]);
  await clock.advance(10);
  assert.deepEqual(calls.map(({ log }) => log.at(-1)), ['offer', 'offer', 'close']);
  mesh.hear({ kind: 'left', user: 2 });
  calls[1]?.events.onEnd();
  assert.deepEqual([ended, opened], [[2, 3], [2, 3]]);
  // Events of ended connections are ignored.
  open(calls[2]);
  assert.deepEqual(opened, [2, 3]);
  mesh.hear({ kind: 'joined', user: 2, group: 0, name: '' });
  assert.equal(calls.length, 4);
  mesh.clear();
  assert.deepEqual([mesh.ownNumber, calls[3]?.log.at(-1)], [null, 'close']);
});

test('in a large room pages connect to the nearest numbers, on which both ends agree', async () => {
  const users = [...Array(40).keys()].map((at) => 11 * at + 3);
  const pairs = new Set<string>();
  for (const own of users) {
    const { mesh, enter, sent } = createTestMesh();
    enter(own, ...users.filter((user) => user !== own));
    mesh.setEnabled(true);
    await waitUntilIdle(2);
    const recipients = sent.map(([user]) => user);
    assert.ok(recipients.length <= 12);
    for (const user of recipients) pairs.add(`${own} ${user}`);
  }
  assert.equal(pairs.size, 40 * 6);
});

test('offers of users who are not neighbours are refused', async () => {
  const { enter, mesh, calls, sent, sendSignal } = createTestMesh();
  mesh.setEnabled(true);
  enter(1000, ...[...Array(30).keys()]);
  for (let user = 0; user < 30; user++) await sendSignal(user, offer());
  assert.equal(calls.length, 12);
  const refused = sent.filter(([, { kind }]) => kind === 'no').map(([user]) => user);
  assert.deepEqual(refused, [...Array(18).keys()].map((at) => at + 6));
});

test('a page sends no offers before it knows all users', async () => {
  const { mesh, calls } = createTestMesh();
  mesh.setEnabled(true);
  mesh.hear({ kind: 'welcome', user: 1, others: 2, ticket: new Uint8Array() });
  mesh.hear({ kind: 'joined', user: 2, group: 0, name: '' });
  assert.equal(calls.length, 0);
  mesh.hear({ kind: 'joined', user: 3, group: 0, name: '' });
  assert.equal(calls.length, 2);
});

test('a user who leaves and returns again and again does not exceed the rate of connections', async () => {
  const { enter, mesh, calls, clock, sendSignal } = createTestMesh();
  mesh.setEnabled(true);
  enter(5, 3);
  const returnAndOffer = async (): Promise<void> => {
    mesh.hear({ kind: 'left', user: 3 });
    mesh.hear({ kind: 'joined', user: 3, group: 0, name: '' });
    await sendSignal(3, offer());
  };
  for (let turn = 0; turn < 40; turn++) await returnAndOffer();
  assert.equal(calls.length, 16);
  await clock.advance(2);
  for (let turn = 0; turn < 10; turn++) await returnAndOffer();
  assert.equal(calls.length, 18);
  // The rate also limits the page's own offers.
  mesh.hear({ kind: 'joined', user: 9, group: 0, name: '' });
  assert.equal(calls.length, 18);
  await clock.advance(1);
  assert.deepEqual([calls.length, calls.at(-1)?.log], [19, ['offer']]);
});

test('if the browser fails to create a connection, only this connection fails', async () => {
  const { enter, mesh, sent, sendSignal, refuseCalls } = createTestMesh();
  refuseCalls();
  mesh.setEnabled(true);
  enter(5, 3, 9);
  await sendSignal(3, offer());
  assert.deepEqual([sent, mesh.dropped.size], [[], 0]);
  await mesh.ready;
});
