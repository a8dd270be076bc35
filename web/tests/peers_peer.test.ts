import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Message, PART, readMessage, writeMessage } from '../src/peers/messages';
import { addFile, connect, createPage, createWires, join, makeContent } from './support/peers';
import { steppedClock, waitUntilIdle, type World } from './support/peers';

const WORLD: World = { a: makeContent(3 * PART + 5, 1), b: makeContent(PART, 2), c: makeContent(7, 3) };
const KEYS = Object.values(WORLD).map(({ entry }) => entry.sha256);
const [A = '', B = '', C = ''] = KEYS;
const contentOf = (name: string): Uint8Array => new Uint8Array(WORLD[name]?.data ?? new ArrayBuffer(0));
const assertContent = (data: ArrayBuffer, name: string): void => assert.deepEqual(new Uint8Array(data), contentOf(name));

/** Creates a page that is connected to user 2, whose messages the test sends. */
function createTestPage() {
  const clock = steppedClock();
  const page = createPage(1, WORLD, clock);
  /** Ends of the channel at the page and at user 2. */
  const [pageWire, userWire] = createWires();
  /** Messages that user 2 has received. */
  const received: Message[] = [];
  userWire.onmessage = ({ data }) => received.push(readMessage(new Uint8Array(data as ArrayBuffer).slice()));
  connect(page, 2, pageWire, clock);
  const send = async (...messages: readonly Message[]): Promise<void> => {
    for (const message of messages) userWire.send(writeMessage(message));
    await waitUntilIdle();
  };
  return { clock, page, pageWire, userWire, received, send };
}

/** Numbers of the requests among messages. */
const requestsOf = (messages: readonly Message[]): number[] =>
  messages.flatMap((message) => (message.kind === 'want' ? [message.request] : []));
const countOf = (messages: readonly Message[], kind: Message['kind']): number =>
  messages.filter((each) => each.kind === kind).length;

type TestPage = ReturnType<typeof createTestPage>;

/** Sends the page a list of user 2's files; the page then requests the file `a`. */
async function requestA({ page, send, received }: TestPage, keys = [A], holding: 'here' | 'coming' = 'here') {
  await send({ kind: 'tell', holding, keys });
  const content = page.get('a');
  await waitUntilIdle();
  return { content, request: requestsOf(received)[0] ?? 0 };
}

/** Messages with the parts of a file. */
function partsOf(name: string, request: number, begin = 0): Message[] {
  const data = contentOf(name);
  const places = [...Array(Math.ceil(data.length / PART)).keys()].slice(begin);
  return places.map((at) => ({ kind: 'part', request, data: data.subarray(PART * at, PART * (at + 1)) }));
}

test('a page gets a file from a user who has it, and offers it to others', async () => {
  const clock = steppedClock();
  const [one, other] = [createPage(1, WORLD, clock), createPage(2, WORLD, clock)];
  await one.get('a');
  join(one, other, clock);
  await waitUntilIdle();
  assertContent(await other.get('a'), 'a');
  assert.deepEqual([one.serverRequests, other.serverRequests], [['a'], []]);
  assert.deepEqual(other.store.keys, [A]);
  assert.deepEqual(other.share.counts, { others: { bytes: 3 * PART + 5, files: 1 }, server: { bytes: 0, files: 0 } });
});

test('a wrong file is discarded, its sender is dropped, and the server sends the file', async () => {
  const context = createTestPage();
  const { page, pageWire, send } = context;
  const { content, request } = await requestA(context);
  const parts = partsOf('a', request);
  (parts.at(-1) as { data: Uint8Array }).data = new Uint8Array(5).fill(9);
  await send(...parts);
  assertContent(await content, 'a');
  assert.match(page.dropped.get(2) ?? '', /wrong content/);
  assert.deepEqual(page.serverRequests, ['a']);
  assert.ok(pageWire.isClosed);
  assert.equal(page.share.counts.others.bytes, 0);
});

test('senders of unrequested bytes and of parts with a wrong length are dropped', async () => {
  const cases: readonly [RegExp, (request: number) => Message[]][] = [
    [/answers no open request/, () => [{ kind: 'part', request: 77, data: new Uint8Array(5) }]],
    [/answers no open request/, () => [{ kind: 'none', request: 77 }]],
    [/wrong length/, (request) => [{ kind: 'part', request, data: new Uint8Array() }]],
    [/wrong length/, (request) => [{ kind: 'part', request, data: new Uint8Array(PART - 1) }]],
    [/wrong length/, (request) => [...partsOf('b', request), ...partsOf('a', request, 3)]],
    [/answers no open request/, (request) => [...partsOf('a', request), { kind: 'part', request, data: new Uint8Array(1) }]],
    [/more bytes are reported/, (request) => [{ kind: 'wait', request, bytes: 3 * PART + 6 }]],
  ];
  for (const [reason, messages] of cases) {
    const context = createTestPage();
    const { page, send } = context;
    const { content, request } = await requestA(context);
    await send(...messages(request));
    assertContent(await content, 'a');
    assert.match(page.dropped.get(2) ?? '', reason);
  }
});

test('senders of malformed messages, texts and floods are dropped', async () => {
  const unknown = Uint8Array.from([9, 1, 2]).buffer;
  for (const data of ['text', new ArrayBuffer(0), unknown, new ArrayBuffer(1 << 20)]) {
    const { page, pageWire } = createTestPage();
    pageWire.receive(data);
    assert.equal(page.dropped.size, 1);
  }
  const { page, pageWire } = createTestPage();
  for (let each = 0; each < 2100; each++) pageWire.receive(writeMessage({ kind: 'cancel', request: 1 }).buffer);
  assert.match(page.dropped.get(2) ?? '', /too many messages/);
});

test('a stalled request is cancelled, and its sender gets requests again when it has ended this one', async () => {
  const context = createTestPage();
  const { page, received, send, clock } = context;
  const { content, request } = await requestA(context, KEYS);
  await send(...partsOf('a', request).slice(0, 2));
  await clock.advance(3.75);
  assert.equal(countOf(received, 'cancel'), 0);
  await clock.advance(0.75);
  assertContent(await content, 'a');
  assert.deepEqual([page.serverRequests, countOf(received, 'cancel'), page.dropped.size], [['a'], 1, 0]);
  await page.get('b');
  assert.deepEqual(page.serverRequests, ['a', 'b']);
  // Parts that were already on their way are not a violation.
  await send(...partsOf('a', request).slice(2, 3), { kind: 'none', request });
  const nextContent = page.get('c');
  await waitUntilIdle();
  await send(...partsOf('c', requestsOf(received)[1] ?? 0));
  assertContent(await nextContent, 'c');
  assert.deepEqual([page.serverRequests, page.dropped.size], [['a', 'b'], 0]);
});

test('a user who repeatedly leaves requests unanswered gets no more requests', async () => {
  const { page, received, send, clock } = createTestPage();
  const names = ['a', 'b', 'c', 'a'];
  for (const [turn, name] of names.entries()) {
    await send({ kind: 'tell', holding: 'here', keys: KEYS });
    // Evicts the files of the earlier attempts.
    if (turn === 3) addFile(page, 'x', new ArrayBuffer(64 * 2 ** 20));
    const content = page.get(name);
    await waitUntilIdle();
    const request = requestsOf(received).at(-1) ?? 0;
    await clock.advance(4.5);
    await content;
    if (turn < 3) await send({ kind: 'none', request });
  }
  assert.deepEqual([requestsOf(received).length, page.serverRequests, page.dropped.size], [3, names, 0]);
});

test('simultaneous timeouts count once', async () => {
  const { page, received, send, clock } = createTestPage();
  await send({ kind: 'tell', holding: 'here', keys: KEYS });
  const all = Promise.all(['a', 'b', 'c'].map((name) => page.get(name)));
  await waitUntilIdle();
  await clock.advance(4.5);
  await all;
  await send(...requestsOf(received).map((request) => ({ kind: 'none', request }) as const));
  assert.deepEqual([page.peers.get(2)?.isFree, page.dropped.size], [true, 0]);
});

test('a page waits for another one that is still fetching the file, as long as there is progress', async () => {
  const context = createTestPage();
  const { page, send, clock } = context;
  const { content, request } = await requestA(context, [A], 'coming');
  for (let bytes = 0; bytes < 3; bytes++) {
    await send({ kind: 'wait', request, bytes });
    await clock.advance(3);
  }
  assert.deepEqual(page.serverRequests, []);
  // The same number of bytes is not progress.
  await send({ kind: 'wait', request, bytes: 2 });
  await clock.advance(1.5);
  assertContent(await content, 'a');
  assert.deepEqual(page.serverRequests, ['a']);
});

test('the time for a whole file is limited', async () => {
  const context = createTestPage();
  const { page, send, clock } = context;
  const { content, request } = await requestA(context);
  const parts = partsOf('a', request);
  for (const part of parts.slice(0, 3)) {
    await send(part);
    await clock.advance(3.75);
  }
  assertContent(await content, 'a');
  assert.deepEqual(page.serverRequests, ['a']);
});

test('the server sends the file of a user who leaves', async () => {
  const context = createTestPage();
  const { page, send } = context;
  const { content, request } = await requestA(context);
  await send(...partsOf('a', request).slice(0, 1));
  page.peers.get(2)?.end();
  page.peers.delete(2);
  assertContent(await content, 'a');
  assert.deepEqual(page.serverRequests, ['a']);
});

test('a cancelled request is cancelled at the sender, and its data are discarded', async () => {
  const { page, received, send } = createTestPage();
  await send({ kind: 'tell', holding: 'here', keys: [A] });
  const stop = new AbortController();
  const content = page.get('a', stop.signal);
  await waitUntilIdle();
  const [request = 0] = requestsOf(received);
  await send(...partsOf('a', request).slice(0, 1));
  stop.abort(new Error('enough'));
  await assert.rejects(content, /enough/);
  await send(...partsOf('a', request, 1));
  assert.deepEqual([countOf(received, 'cancel'), page.store.keys, page.dropped.size, page.serverRequests], [1, [], 0, []]);
});

test('files are sent one after another, no faster than the browser accepts them', async () => {
  const { page, pageWire, send } = createTestPage();
  const big: World = { big: makeContent(40 * PART, 4) };
  addFile(page, big['big']?.entry.sha256 ?? '', big['big']?.data ?? new ArrayBuffer(0));
  addFile(page, C, WORLD['c']?.data ?? new ArrayBuffer(0));
  pageWire.isHeld = true;
  await send({ kind: 'want', request: 1, key: big['big']?.entry.sha256 ?? '' }, { kind: 'want', request: 2, key: C });
  const { bufferedAmount } = pageWire;
  assert.ok(bufferedAmount > 1 << 18 && bufferedAmount < (1 << 18) + 5 * PART, `${bufferedAmount}`);
  pageWire.drain();
  await waitUntilIdle();
  const sent = pageWire.sent.map(readMessage).flatMap((each) => (each.kind === 'part' ? [each.request] : []));
  assert.deepEqual(sent, [...Array(40).fill(1), 2]);
  assert.equal(page.dropped.size, 0);
});

test('sending stops when the receiver cancels', async () => {
  const { page, pageWire, send } = createTestPage();
  const { entry, data } = makeContent(40 * PART, 4);
  addFile(page, entry.sha256, data);
  pageWire.isHeld = true;
  await send({ kind: 'want', request: 1, key: entry.sha256 });
  await send({ kind: 'cancel', request: 1 });
  pageWire.drain();
  await waitUntilIdle();
  const parts = pageWire.sent.map(readMessage).filter(({ kind }) => kind === 'part');
  assert.ok(parts.length > 0 && parts.length < 40, `${parts.length}`);
});

test('only files that the page shows are sent, and request numbers must ascend', async () => {
  const { page, received, send } = createTestPage();
  await send({ kind: 'want', request: 1, key: 'ab'.repeat(32) });
  assert.deepEqual(received.at(-1), { kind: 'none', request: 1 });
  page.shownNames = [];
  await send({ kind: 'want', request: 2, key: A });
  assert.deepEqual([received.at(-1), page.serverRequests], [{ kind: 'none', request: 2 }, []]);
  await send({ kind: 'want', request: 2, key: A });
  assert.match(page.dropped.get(2) ?? '', /reuses a number/);
});

test('the sender of too many concurrent requests is dropped, and too many requests per second are refused', async () => {
  const concurrent = createTestPage();
  concurrent.page.serve = () => new Promise(() => undefined);
  await concurrent.send(...[...Array(65).keys()].map((at) => ({ kind: 'want', request: at + 1, key: A }) as const));
  assert.match(concurrent.page.dropped.get(2) ?? '', /too many requests/);
  assert.deepEqual(concurrent.page.serverRequests, ['a']);
  const fast = createTestPage();
  for (let request = 1; request <= 500; request++) {
    const { data, entry } = makeContent(request, 4);
    addFile(fast.page, entry.sha256, data);
    fast.userWire.send(writeMessage({ kind: 'want', request, key: entry.sha256 }));
    if (request % 20 === 0) await waitUntilIdle();
  }
  await waitUntilIdle();
  assert.deepEqual([countOf(fast.received, 'part'), countOf(fast.received, 'none'), fast.page.dropped.size], [400, 100, 0]);
});

test('a page fetches only files that it shows itself for others, each once', async () => {
  const { page, received, send } = createTestPage();
  await send({ kind: 'want', request: 1, key: B }, { kind: 'want', request: 2, key: B });
  assert.deepEqual(page.serverRequests, ['b']);
  assert.equal(countOf(received, 'part'), 2);
  page.serve = () => Promise.reject(new Error('gone'));
  await send({ kind: 'want', request: 3, key: A });
  assert.deepEqual(received.at(-1), { kind: 'none', request: 3 });
});

test('a page gets a file at most twice, from the store or from the server', async () => {
  const { page, received, send } = createTestPage();
  addFile(page, C, contentOf('c').slice().buffer);
  for (let request = 1; request <= 4; request++) await send({ kind: 'want', request, key: C });
  assert.deepEqual([countOf(received, 'part'), countOf(received, 'none')], [2, 2]);
  await send(...[5, 6, 7].map((request) => ({ kind: 'want', request, key: B }) as const));
  assert.deepEqual([countOf(received, 'part'), countOf(received, 'none'), page.serverRequests], [4, 3, ['b']]);
});

test('a budget limits the bytes that a page sends to all others together', async () => {
  const clock = steppedClock();
  const page = createPage(1, WORLD, clock);
  addFile(page, A, contentOf('a').slice().buffer);
  page.budget.take(64 * 2 ** 20 - (WORLD['a']?.entry.bytes ?? 0));
  const others = [2, 3].map((number) => createPage(number, WORLD, clock));
  for (const other of others) {
    join(page, other, clock);
    await waitUntilIdle();
    assertContent(await other.get('a'), 'a');
  }
  assert.deepEqual(others.map(({ serverRequests }) => serverRequests), [[], ['a']]);
  await clock.advance(1);
  const third = createPage(4, WORLD, clock);
  join(page, third, clock);
  await waitUntilIdle();
  assertContent(await third.get('a'), 'a');
  assert.deepEqual(third.serverRequests, []);
});

test('at most two slow pages delay the first picture, each by little more than five seconds', async () => {
  const clock = steppedClock();
  const page = createPage(1, WORLD, clock);
  page.isFirstPictureMissing = true;
  const [requestedUsers, progressReports]: [number[], (() => void)[]] = [[], []];
  for (const user of [2, 3, 4]) {
    const [pageWire, userWire] = createWires();
    connect(page, user, pageWire, clock);
    let [request, bytes] = [0, 0];
    userWire.onmessage = ({ data }) => {
      const message = readMessage(new Uint8Array(data as ArrayBuffer).slice());
      if (message.kind !== 'want') return;
      requestedUsers.push(user);
      [request, bytes] = [message.request, 0];
    };
    progressReports.push(() => request && userWire.send(writeMessage({ kind: 'wait', request, bytes: bytes++ })));
    userWire.send(writeMessage({ kind: 'tell', holding: 'here', keys: KEYS }));
  }
  await waitUntilIdle();
  for (const name of ['a', 'b', 'c']) {
    let hasArrived = false;
    const content = page.get(name).then(() => (hasArrived = true));
    for (let ticks = 0; !hasArrived && ticks < 22; ticks++) {
      await waitUntilIdle();
      progressReports.forEach((report) => report());
      await clock.advance(0.25);
    }
    assert.ok(hasArrived, name);
    await content;
  }
  assert.equal(new Set(requestedUsers).size, 2);
  assert.deepEqual([requestedUsers.length, page.serverRequests, page.dropped.size], [2, ['a', 'b', 'c'], 0]);
});
