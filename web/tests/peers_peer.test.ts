import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Message, PART, readMessage, writeMessage } from '../src/peers/messages';
import { createPage, createWires, hold, join, makeContent, plug, settled, steppedClock, type Wire, type World } from './support/peers';

const WORLD: World = { a: makeContent(3 * PART + 5, 1), b: makeContent(PART, 2), c: makeContent(7, 3) };
const KEYS = Object.values(WORLD).map(({ listed }) => listed.sha256);
const [A = '', B = '', C = ''] = KEYS;
const contentOf = (name: string): Uint8Array => new Uint8Array(WORLD[name]?.data ?? new ArrayBuffer(0));
const assertContent = (data: ArrayBuffer, name: string): void => assert.deepEqual(new Uint8Array(data), contentOf(name));

/** A page that is connected to user 2, whose messages the test writes. */
function bench() {
  const clock = steppedClock();
  const page = createPage(1, WORLD, clock);
  /** Ends of the channel: the page's, and that of user 2. */
  const [own, line] = createWires();
  /** Messages that arrived at user 2. */
  const heard: Message[] = [];
  line.onmessage = ({ data }) => heard.push(readMessage(new Uint8Array(data as ArrayBuffer).slice()));
  plug(page, 2, own, clock);
  const say = async (...messages: readonly Message[]): Promise<void> => {
    for (const message of messages) line.send(writeMessage(message));
    await settled();
  };
  return { clock, page, line, heard, say };
}

const wants = (heard: readonly Message[]): number[] =>
  heard.flatMap((message) => (message.kind === 'want' ? [message.request] : []));
const ends = (heard: readonly Message[], kind: Message['kind']): number =>
  heard.filter((each) => each.kind === kind).length;

/** Announces files of user 2 to the page, which then requests the file `a`. */
async function requestA({ page, say, heard }: ReturnType<typeof bench>, keys = [A], holding: 'here' | 'coming' = 'here') {
  await say({ kind: 'tell', holding, keys });
  const coming = page.get('a');
  await settled();
  return { coming, request: wants(heard)[0] ?? 0 };
}

/** The parts of a file. */
function partsOf(name: string, request: number, begin = 0): Message[] {
  const data = contentOf(name);
  const places = [...Array(Math.ceil(data.length / PART)).keys()].slice(begin);
  return places.map((at) => ({ kind: 'part', request, data: data.subarray(PART * at, PART * (at + 1)) }));
}

test('a file comes from a user who has it, complete and checked, and is offered to others', async () => {
  const clock = steppedClock();
  const [one, other] = [createPage(1, WORLD, clock), createPage(2, WORLD, clock)];
  await one.get('a');
  join(one, other, clock);
  await settled();
  assertContent(await other.get('a'), 'a');
  assert.deepEqual([one.serverRequests, other.serverRequests], [['a'], []]);
  assert.deepEqual(other.store.keys, [A]);
  assert.deepEqual(other.share.counts, { others: { bytes: 3 * PART + 5, files: 1 }, server: { bytes: 0, files: 0 } });
});

test('a wrong file is not used: its sender is dropped, and the server sends the file', async () => {
  const context = bench();
  const { page, say, line } = context;
  const { coming, request } = await requestA(context);
  const parts = partsOf('a', request);
  (parts.at(-1) as { data: Uint8Array }).data = new Uint8Array(5).fill(9);
  await say(...parts);
  assertContent(await coming, 'a');
  assert.match(page.dropped.get(2) ?? '', /wrong content/);
  assert.deepEqual(page.serverRequests, ['a']);
  assert.ok(line.other?.isClosed);
  assert.equal(page.share.counts.others.bytes, 0);
});

test('unrequested bytes and parts of a wrong length drop their sender', async () => {
  const wrong: readonly [RegExp, (request: number) => Message[]][] = [
    [/answers no open request/, () => [{ kind: 'part', request: 77, data: new Uint8Array(5) }]],
    [/answers no open request/, () => [{ kind: 'none', request: 77 }]],
    [/wrong length/, (request) => [{ kind: 'part', request, data: new Uint8Array() }]],
    [/wrong length/, (request) => [{ kind: 'part', request, data: new Uint8Array(PART - 1) }]],
    [/wrong length/, (request) => [...partsOf('b', request), ...partsOf('a', request, 3)]],
    [/answers no open request/, (request) => [...partsOf('a', request), { kind: 'part', request, data: new Uint8Array(1) }]],
    [/more bytes are reported/, (request) => [{ kind: 'wait', request, bytes: 3 * PART + 6 }]],
  ];
  for (const [reason, messages] of wrong) {
    const context = bench();
    const { page, say } = context;
    const { coming, request } = await requestA(context);
    await say(...messages(request));
    assertContent(await coming, 'a');
    assert.match(page.dropped.get(2) ?? '', reason);
  }
});

test('malformed messages, texts and floods drop their sender', async () => {
  const unknown = Uint8Array.from([9, 1, 2]).buffer;
  for (const data of ['text', new ArrayBuffer(0), unknown, new ArrayBuffer(1 << 20)]) {
    const { page, line } = bench();
    line.other?.comes(data);
    assert.equal(page.dropped.size, 1);
  }
  const { page, line } = bench();
  for (let each = 0; each < 2100; each++) line.other?.comes(writeMessage({ kind: 'cancel', request: 1 }).buffer);
  assert.match(page.dropped.get(2) ?? '', /too many messages/);
});

test('a sender that stalls within a file loses the request, and is asked again once it has ended the request', async () => {
  const context = bench();
  const { page, heard, say, clock } = context;
  const { coming, request } = await requestA(context, KEYS);
  await say(...partsOf('a', request).slice(0, 2));
  await clock.pass(3.75);
  assert.equal(ends(heard, 'cancel'), 0);
  await clock.pass(0.75);
  assertContent(await coming, 'a');
  assert.deepEqual([page.serverRequests, ends(heard, 'cancel'), page.dropped.size], [['a'], 1, 0]);
  await page.get('b');
  assert.deepEqual(page.serverRequests, ['a', 'b']);
  // Parts that were on their way are no fault.
  await say(...partsOf('a', request).slice(2, 3), { kind: 'none', request });
  const later = page.get('c');
  await settled();
  await say(...partsOf('c', wants(heard)[1] ?? 0));
  assertContent(await later, 'c');
  assert.deepEqual([page.serverRequests, page.dropped.size], [['a', 'b'], 0]);
});

test('a user who repeatedly leaves requests unanswered is asked no more', async () => {
  const { page, heard, say, clock } = bench();
  const names = ['a', 'b', 'c', 'a'];
  for (const [turn, name] of names.entries()) {
    await say({ kind: 'tell', holding: 'here', keys: KEYS });
    // Nothing of the earlier attempt is kept.
    if (turn === 3) hold(page, 'x', new ArrayBuffer(64 * 2 ** 20));
    const coming = page.get(name);
    await settled();
    const request = wants(heard).at(-1) ?? 0;
    await clock.pass(4.5);
    await coming;
    if (turn < 3) await say({ kind: 'none', request });
  }
  assert.deepEqual([wants(heard).length, page.serverRequests, page.dropped.size], [3, names, 0]);
});

test('requests that are unanswered at the same time count as one', async () => {
  const { page, heard, say, clock } = bench();
  await say({ kind: 'tell', holding: 'here', keys: KEYS });
  const all = Promise.all(['a', 'b', 'c'].map((name) => page.get(name)));
  await settled();
  await clock.pass(4.5);
  await all;
  await say(...wants(heard).map((request) => ({ kind: 'none', request }) as const));
  assert.deepEqual([page.peers.get(2)?.isFree, page.dropped.size], [true, 0]);
});

test('a page waits for another that has to fetch the file first, while it makes progress', async () => {
  const context = bench();
  const { page, say, clock } = context;
  const { coming, request } = await requestA(context, [A], 'coming');
  for (let bytes = 0; bytes < 3; bytes++) {
    await say({ kind: 'wait', request, bytes });
    await clock.pass(3);
  }
  assert.deepEqual(page.serverRequests, []);
  // The same number is no progress.
  await say({ kind: 'wait', request, bytes: 2 });
  await clock.pass(1.5);
  assertContent(await coming, 'a');
  assert.deepEqual(page.serverRequests, ['a']);
});

test('a file that trickles is given up in the end', async () => {
  const context = bench();
  const { page, say, clock } = context;
  const { coming, request } = await requestA(context);
  const parts = partsOf('a', request);
  for (const part of parts.slice(0, 3)) {
    await say(part);
    await clock.pass(3.75);
  }
  assertContent(await coming, 'a');
  assert.deepEqual(page.serverRequests, ['a']);
});

test('a user who leaves in the middle of a file is replaced by the server', async () => {
  const context = bench();
  const { page, say } = context;
  const { coming, request } = await requestA(context);
  await say(...partsOf('a', request).slice(0, 1));
  page.peers.get(2)?.end();
  page.peers.delete(2);
  assertContent(await coming, 'a');
  assert.deepEqual(page.serverRequests, ['a']);
});

test('a cancelled request is cancelled at the sender, and nothing is kept', async () => {
  const { page, heard, say } = bench();
  await say({ kind: 'tell', holding: 'here', keys: [A] });
  const stop = new AbortController();
  const coming = page.get('a', stop.signal);
  await settled();
  const [request = 0] = wants(heard);
  await say(...partsOf('a', request).slice(0, 1));
  stop.abort(new Error('enough'));
  await assert.rejects(coming, /enough/);
  await say(...partsOf('a', request, 1));
  assert.deepEqual([ends(heard, 'cancel'), page.store.keys, page.dropped.size, page.serverRequests], [1, [], 0, []]);
});

test('files are sent no faster than the browser accepts them, one after the other', async () => {
  const { page, say, line } = bench();
  const big: World = { big: makeContent(40 * PART, 4) };
  hold(page, big['big']?.listed.sha256 ?? '', big['big']?.data ?? new ArrayBuffer(0));
  hold(page, C, WORLD['c']?.data ?? new ArrayBuffer(0));
  const own = line.other as Wire;
  own.isHeld = true;
  await say({ kind: 'want', request: 1, key: big['big']?.listed.sha256 ?? '' }, { kind: 'want', request: 2, key: C });
  const held = own.bufferedAmount;
  assert.ok(held > 1 << 18 && held < (1 << 18) + 5 * PART, `${held}`);
  own.drain();
  await settled();
  const sent = own.sent.map(readMessage).flatMap((each) => (each.kind === 'part' ? [each.request] : []));
  assert.deepEqual(sent, [...Array(40).fill(1), 2]);
  assert.equal(page.dropped.size, 0);
});

test('a file is sent no further once its receiver cancels', async () => {
  const { page, say, line } = bench();
  const { listed, data } = makeContent(40 * PART, 4);
  hold(page, listed.sha256, data);
  const own = line.other as Wire;
  own.isHeld = true;
  await say({ kind: 'want', request: 1, key: listed.sha256 });
  await say({ kind: 'cancel', request: 1 });
  own.drain();
  await settled();
  const parts = own.sent.map(readMessage).filter(({ kind }) => kind === 'part');
  assert.ok(parts.length > 0 && parts.length < 40, `${parts.length}`);
});

test('only listed files are sent, for a limited number of requests', async () => {
  const { page, heard, say } = bench();
  await say({ kind: 'want', request: 1, key: 'ab'.repeat(32) });
  assert.deepEqual(heard.at(-1), { kind: 'none', request: 1 });
  page.shownNames = [];
  await say({ kind: 'want', request: 2, key: A });
  assert.deepEqual([heard.at(-1), page.serverRequests], [{ kind: 'none', request: 2 }, []]);
  await say({ kind: 'want', request: 2, key: A });
  assert.match(page.dropped.get(2) ?? '', /reuses a number/);
});

test('too many concurrent requests drop the sender, and too many a second are refused', async () => {
  const crowd = bench();
  crowd.page.serve = () => new Promise(() => undefined);
  await crowd.say(...[...Array(65).keys()].map((at) => ({ kind: 'want', request: at + 1, key: A }) as const));
  assert.match(crowd.page.dropped.get(2) ?? '', /too many requests/);
  assert.deepEqual(crowd.page.serverRequests, ['a']);
  const hurry = bench();
  for (let request = 1; request <= 500; request++) {
    const { data, listed } = makeContent(request, 4);
    hold(hurry.page, listed.sha256, data);
    hurry.line.send(writeMessage({ kind: 'want', request, key: listed.sha256 }));
    if (request % 20 === 0) await settled();
  }
  await settled();
  assert.deepEqual([ends(hurry.heard, 'part'), ends(hurry.heard, 'none'), hurry.page.dropped.size], [400, 100, 0]);
});

test('a page fetches for others only files that it shows itself, once', async () => {
  const { page, heard, say } = bench();
  await say({ kind: 'want', request: 1, key: B }, { kind: 'want', request: 2, key: B });
  assert.deepEqual(page.serverRequests, ['b']);
  assert.equal(ends(heard, 'part'), 2);
  page.serve = () => Promise.reject(new Error('gone'));
  await say({ kind: 'want', request: 3, key: A });
  assert.deepEqual(heard.at(-1), { kind: 'none', request: 3 });
});

test('a page loads a file at most twice, from the store and from the server', async () => {
  const { page, heard, say } = bench();
  hold(page, C, contentOf('c').slice().buffer);
  for (let request = 1; request <= 4; request++) await say({ kind: 'want', request, key: C });
  assert.deepEqual([ends(heard, 'part'), ends(heard, 'none')], [2, 2]);
  await say(...[5, 6, 7].map((request) => ({ kind: 'want', request, key: B }) as const));
  assert.deepEqual([ends(heard, 'part'), ends(heard, 'none'), page.serverRequests], [4, 3, ['b']]);
});

test('all pages together get at most the limit of bytes that a page sends', async () => {
  const clock = steppedClock();
  const page = createPage(1, WORLD, clock);
  hold(page, A, contentOf('a').slice().buffer);
  page.budget.take(64 * 2 ** 20 - (WORLD['a']?.listed.bytes ?? 0));
  const others = [2, 3].map((number) => createPage(number, WORLD, clock));
  for (const other of others) {
    join(page, other, clock);
    await settled();
    assertContent(await other.get('a'), 'a');
  }
  assert.deepEqual(others.map(({ serverRequests }) => serverRequests), [[], ['a']]);
  await clock.pass(1);
  const third = createPage(4, WORLD, clock);
  join(page, third, clock);
  await settled();
  assertContent(await third.get('a'), 'a');
  assert.deepEqual(third.serverRequests, []);
});

test('slow pages delay the first picture for little more than five seconds each, and two of them at most', async () => {
  const clock = steppedClock();
  const page = createPage(1, WORLD, clock);
  page.isFirst = true;
  const [askedUsers, drips]: [number[], (() => void)[]] = [[], []];
  for (const user of [2, 3, 4]) {
    const [own, line] = createWires();
    plug(page, user, own, clock);
    let [request, bytes] = [0, 0];
    line.onmessage = ({ data }) => {
      const message = readMessage(new Uint8Array(data as ArrayBuffer).slice());
      if (message.kind !== 'want') return;
      askedUsers.push(user);
      [request, bytes] = [message.request, 0];
    };
    drips.push(() => request && line.send(writeMessage({ kind: 'wait', request, bytes: bytes++ })));
    line.send(writeMessage({ kind: 'tell', holding: 'here', keys: KEYS }));
  }
  await settled();
  for (const name of ['a', 'b', 'c']) {
    let isThere = false;
    const coming = page.get(name).then(() => (isThere = true));
    for (let ticks = 0; !isThere && ticks < 22; ticks++) {
      await settled();
      drips.forEach((drip) => drip());
      await clock.pass(0.25);
    }
    assert.ok(isThere, name);
    await coming;
  }
  assert.equal(new Set(askedUsers).size, 2);
  assert.deepEqual([askedUsers.length, page.serverRequests, page.dropped.size], [2, ['a', 'b', 'c'], 0]);
});
