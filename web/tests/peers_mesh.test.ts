import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Call, type CallEvents, type Signal, writeSignal } from '../src/peers/call';
import { createMesh } from '../src/peers/mesh';
import { settled, steppedClock, createWires } from './support/peers';

const SDP = 'm=application 9 UDP/DTLS/SCTP webrtc-datachannel\r\n';

interface Made extends Call {
  readonly events: CallEvents;
  readonly log: string[];
}

/** A mesh whose calls and signals the test answers. */
function bench() {
  const clock = steppedClock();
  const [calls, opened, ended]: [Made[], number[], number[]] = [[], [], []];
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
      const call: Made = {
        events,
        log,
        offer: () => record('offer'),
        answer: (offer) => record(`answer ${offer}`),
        take: async (answer) => void (await record(`take ${answer}`)),
        close: () => void log.push('close'),
      };
      calls.push(call);
      return call;
    },
    signal: (user, signal) => sent.push([user, signal]),
    opened: (user) => opened.push(user),
    ended: (user) => ended.push(user),
  });
  const made = {
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
    async say(user: number, signal: Signal | Uint8Array): Promise<void> {
      mesh.hear({ kind: 'signal', user, payload: signal instanceof Uint8Array ? signal : writeSignal(signal) });
      await settled(2);
    },
    /** Makes the browser fail to create connections. */
    refuseCalls: (): void => void (isFull = true),
  };
  void mesh.ready.then(() => (made.isReady = true));
  return made;
}

const offer = (attempt = 1, sdp = SDP): Signal => ({ kind: 'offer', attempt, sdp });
const open = (call: Made | undefined): void => call?.events.opened(createWires()[0]);

test('the user with the smaller number offers, and the other one answers', async () => {
  const { mesh, enter, calls, sent, say, opened } = bench();
  mesh.begin(true);
  enter(5, 3, 9);
  await settled(2);
  assert.deepEqual(sent.map(([user, { kind }]) => [user, kind]), [[9, 'offer']]);
  await say(3, offer(77));
  assert.deepEqual(sent[1], [3, { kind: 'answer', attempt: 77, sdp: SDP }]);
  await say(9, { kind: 'answer', attempt: sent[0]?.[1].attempt ?? 0, sdp: SDP });
  assert.deepEqual(calls.map(({ log }) => log), [['offer', `take ${SDP}`], [`answer ${SDP}`]]);
  calls.forEach(open);
  assert.deepEqual(opened, [9, 3]);
});

test('files wait until all users have announced their files or failed to connect, up to a timeout', async () => {
  const alone = bench();
  alone.mesh.begin(true);
  alone.enter(5);
  await settled(2);
  assert.ok(alone.isReady);
  const among = bench();
  among.enter(5, 3, 9);
  among.mesh.begin(true);
  await among.say(3, offer());
  open(among.calls[0]);
  await settled(2);
  among.mesh.greeted(9);
  open(among.calls[1]);
  await settled(2);
  assert.equal(among.isReady, false);
  among.mesh.greeted(3);
  await settled(2);
  assert.ok(among.isReady);
  const slow = bench();
  slow.mesh.begin(true);
  await slow.clock.pass(1.25);
  slow.enter(1, 2, 3);
  await settled(2);
  open(slow.calls[0]);
  await slow.clock.pass(1.25);
  assert.equal(slow.isReady, false);
  await slow.clock.pass(0.25);
  assert.ok(slow.isReady);
  const outside = bench();
  await outside.clock.pass(1.5);
  assert.ok(outside.isReady);
  const refused = bench();
  refused.mesh.begin(true);
  refused.enter(1, 2);
  await refused.say(2, { kind: 'no', attempt: 0, sdp: '' });
  assert.ok(refused.isReady);
});

test('a page that does not share files tells others, and answers no offer', async () => {
  const { mesh, enter, calls, sent, say } = bench();
  enter(5, 3, 9);
  await say(3, offer());
  mesh.begin(false);
  mesh.hear({ kind: 'joined', user: 12, group: 0, name: '' });
  await say(3, offer());
  assert.deepEqual(calls, []);
  assert.deepEqual(sent.map(([user, { kind }]) => [user, kind]), [[3, 'no'], [9, 'no'], [12, 'no'], [3, 'no']]);
});

test('ending the exchange closes all connections, and tells others', async () => {
  const { mesh, enter, calls, sent, say, ended } = bench();
  mesh.begin(true);
  enter(5, 3, 9);
  await say(3, offer());
  calls.forEach(open);
  sent.length = 0;
  mesh.begin(false);
  assert.deepEqual([ended, calls.map(({ log }) => log.at(-1))], [[9, 3], ['close', 'close']]);
  assert.deepEqual(sent.map(([user, { kind }]) => [user, kind]), [[3, 'no'], [9, 'no']]);
  await say(3, offer(2));
  mesh.hear({ kind: 'joined', user: 11, group: 0, name: '' });
  assert.equal(calls.length, 2);
});

test('offers that precede permission by the server are answered after it', async () => {
  const { mesh, enter, sent, say } = bench();
  enter(5, 3);
  await say(3, offer(8));
  assert.deepEqual(sent, []);
  mesh.begin(true);
  await settled(2);
  assert.deepEqual(sent, [[3, { kind: 'answer', attempt: 8, sdp: SDP }]]);
});

test('malformed messages of a user end at most its own connection', async () => {
  const { mesh, enter, calls, sent, say, ended } = bench();
  mesh.begin(true);
  enter(5, 3, 4, 9);
  await say(3, offer());
  await say(4, offer());
  calls.forEach(open);
  await say(3, new Uint8Array([9, 9, 9]));
  await say(77, offer());
  await say(9, offer());
  assert.deepEqual(ended, [3]);
  // A greater number does not offer, nor does an absent user.
  assert.equal(calls.length, 3);
  assert.deepEqual(sent.filter(([, { kind }]) => kind === 'no').map(([user]) => user), [9]);
  for (const [attempt, sdp] of [[1, SDP], [2, SDP.replace('9', 'garbage')]] as const) await say(4, offer(attempt, sdp));
  await say(4, offer(3, `${SDP}a=garbage\r\n`));
  assert.deepEqual(ended, [3, 4]);
  assert.equal(mesh.dropped.size, 0);
});

test('unexpected answers are ignored, and malformed ones end the connection', async () => {
  const { mesh, enter, calls, sent, say } = bench();
  mesh.begin(true);
  enter(5, 3, 9);
  await settled(2);
  const attempt = sent[0]?.[1].attempt ?? 0;
  await say(9, { kind: 'answer', attempt: attempt + 1, sdp: SDP });
  await say(3, { kind: 'answer', attempt, sdp: SDP });
  assert.deepEqual(calls[0]?.log, ['offer']);
  await say(9, { kind: 'answer', attempt, sdp: `${SDP}a=garbage\r\n` });
  assert.match(mesh.dropped.get(9) ?? '', /answer/);
  assert.equal(calls[0]?.log.at(-1), 'close');
});

test('dropped users are not reconnected, nor are users who offer too often', async () => {
  const { mesh, enter, calls, say } = bench();
  mesh.begin(true);
  enter(5, 3, 9);
  await settled(2);
  open(calls[0]);
  calls[0]?.events.refuse('it opens another channel');
  assert.deepEqual([...mesh.dropped], [[9, 'it opens another channel']]);
  mesh.hear({ kind: 'left', user: 9 });
  mesh.hear({ kind: 'joined', user: 9, group: 0, name: '' });
  assert.equal(calls.length, 1);
  for (let attempt = 0; attempt < 12; attempt++) await say(3, offer(attempt));
  assert.match(mesh.dropped.get(3) ?? '', /too often/);
  assert.equal(calls.length, 9);
  assert.equal(calls.filter(({ log }) => log.at(-1) === 'close').length, 9);
});

test('connections that fail end, and others close when their users leave', async () => {
  const { mesh, enter, calls, clock, ended, opened } = bench();
  mesh.begin(true);
  enter(1, 2, 3, 4);
  await settled(2);
  open(calls[0]);
  open(calls[1]);
  await clock.pass(10);
  assert.deepEqual(calls.map(({ log }) => log.at(-1)), ['offer', 'offer', 'close']);
  mesh.hear({ kind: 'left', user: 2 });
  calls[1]?.events.ended();
  assert.deepEqual([ended, opened], [[2, 3], [2, 3]]);
  // Events of ended connections are ignored.
  open(calls[2]);
  assert.deepEqual(opened, [2, 3]);
  mesh.hear({ kind: 'joined', user: 2, group: 0, name: '' });
  assert.equal(calls.length, 4);
  mesh.clear();
  assert.deepEqual([mesh.ownNumber, calls[3]?.log.at(-1)], [null, 'close']);
});

test('in a large room each page connects to the nearest numbers, and both ends choose the same', async () => {
  const users = [...Array(40).keys()].map((at) => 11 * at + 3);
  const pairs = new Set<string>();
  for (const own of users) {
    const { mesh, enter, sent } = bench();
    enter(own, ...users.filter((user) => user !== own));
    mesh.begin(true);
    await settled(2);
    const offered = sent.map(([user]) => user);
    assert.ok(offered.length <= 12);
    for (const user of offered) pairs.add(`${own} ${user}`);
  }
  assert.equal(pairs.size, 40 * 6);
});

test('a user who is not a neighbour gets no answer', async () => {
  const { enter, mesh, calls, sent, say } = bench();
  mesh.begin(true);
  enter(1000, ...[...Array(30).keys()]);
  for (let user = 0; user < 30; user++) await say(user, offer());
  assert.equal(calls.length, 12);
  const refused = sent.filter(([, { kind }]) => kind === 'no').map(([user]) => user);
  assert.deepEqual(refused, [...Array(18).keys()].map((at) => at + 6));
});

test('a page offers to nobody before it knows the users', async () => {
  const { mesh, calls } = bench();
  mesh.begin(true);
  mesh.hear({ kind: 'welcome', user: 1, others: 2, ticket: new Uint8Array() });
  mesh.hear({ kind: 'joined', user: 2, group: 0, name: '' });
  assert.equal(calls.length, 0);
  mesh.hear({ kind: 'joined', user: 3, group: 0, name: '' });
  assert.equal(calls.length, 2);
});

test('repeated returns create no more connections than the limit per second', async () => {
  const { enter, mesh, calls, clock, say } = bench();
  mesh.begin(true);
  enter(5, 3);
  const come = async (): Promise<void> => {
    mesh.hear({ kind: 'left', user: 3 });
    mesh.hear({ kind: 'joined', user: 3, group: 0, name: '' });
    await say(3, offer());
  };
  for (let turn = 0; turn < 40; turn++) await come();
  assert.equal(calls.length, 16);
  await clock.pass(2);
  for (let turn = 0; turn < 10; turn++) await come();
  assert.equal(calls.length, 18);
  // A page's own offer waits for its turn.
  mesh.hear({ kind: 'joined', user: 9, group: 0, name: '' });
  assert.equal(calls.length, 18);
  await clock.pass(1);
  assert.deepEqual([calls.length, calls.at(-1)?.log], [19, ['offer']]);
});

test('a browser that fails to create a connection loses that connection only', async () => {
  const { enter, mesh, sent, say, refuseCalls } = bench();
  refuseCalls();
  mesh.begin(true);
  enter(5, 3, 9);
  await say(3, offer());
  assert.deepEqual([sent, mesh.dropped.size], [[], 0]);
  await mesh.ready;
});
