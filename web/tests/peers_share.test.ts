import assert from 'node:assert/strict';
import { test } from 'node:test';
import { precedes } from '../src/peers/share';
import {
  createPage,
  join,
  makeContent,
  type Page,
  waitUntilIdle,
  type Stepped,
  steppedClock,
  type World,
} from './support/peers';

const NAMES = [...Array(40).keys()].map((number) => `files/${number}`);
const WORLD: World = Object.fromEntries(NAMES.map((name, number) => [name, makeContent(20_000 + 300 * number, number)]));
const BYTES = NAMES.reduce((sum, name) => sum + (WORLD[name]?.entry.bytes ?? 0), 0);

function createPages(count: number, clock: Stepped): Page[] {
  return [...Array(count).keys()].map((at) => createPage(100 + 7 * at, WORLD, clock));
}

function joinAll(pages: readonly Page[], clock: Stepped): void {
  pages.forEach((page, at) => pages.slice(at + 1).forEach((other) => join(page, other, clock)));
}

/** Loads all files, a few at a time and in the same order, as pages do. */
async function load(page: Page, names: readonly string[] = NAMES): Promise<void> {
  for (let at = 0; at < names.length; at += 6) {
    const contents = await Promise.all(names.slice(at, at + 6).map((name) => page.get(name)));
    contents.forEach((data, number) => {
      const expected = WORLD[names[at + number] ?? '']?.data ?? new ArrayBuffer(0);
      assert.deepEqual(new Uint8Array(data), new Uint8Array(expected));
    });
  }
}

const requestedFiles = (all: readonly Page[]): string[] => all.flatMap((page) => page.serverRequests);

test('of eight pages that start together, one requests each file from the server, and all share the work', async () => {
  const clock = steppedClock();
  const all = createPages(8, clock);
  joinAll(all, clock);
  await Promise.all(all.map((page) => load(page)));
  assert.deepEqual(requestedFiles(all).sort(), [...NAMES].sort());
  assert.ok(all.filter((page) => page.serverRequests.length > 0).length > 5);
  for (const page of all) {
    assert.ok(page.serverRequests.length < 15);
    assert.deepEqual([page.dropped.size, page.share.counts.others.bytes + page.share.counts.server.bytes], [0, BYTES]);
  }
});

test('pages that start later request no file from the server that others have', async () => {
  const clock = steppedClock();
  const all: Page[] = [];
  for (const page of createPages(8, clock)) {
    for (const other of all) join(page, other, clock);
    await waitUntilIdle();
    await load(page);
    all.push(page);
  }
  assert.deepEqual(requestedFiles(all), NAMES);
});

test('pages that know different users never wait for each other in a circle', async () => {
  const clock = steppedClock();
  const all = createPages(8, clock);
  // Each page is connected to two others in a ring.
  all.forEach((page, at) => join(page, all[(at + 1) % all.length] as Page, clock));
  await Promise.all(all.map((page) => load(page)));
  assert.ok(requestedFiles(all).length < 4 * NAMES.length);
  assert.ok(clock.now() === 100, 'no time passes');
});

test('when a page leaves, the others request its files from the server', async () => {
  const clock = steppedClock();
  const all = createPages(4, clock);
  joinAll(all, clock);
  const [leaver, ...remaining] = all as [Page, ...Page[]];
  leaver.serve = () => new Promise(() => undefined);
  const loading = Promise.all(remaining.map((page) => load(page)));
  await waitUntilIdle();
  for (const page of remaining) {
    page.peers.get(leaver.number)?.end();
    page.peers.delete(leaver.number);
  }
  await loading;
  assert.deepEqual([...new Set(requestedFiles(remaining))].sort(), [...NAMES].sort());
});

test('another page takes over the requests of a page whose server stalls', async () => {
  const clock = steppedClock();
  const all = createPages(3, clock);
  joinAll(all, clock);
  const [stuck, ...remaining] = all as [Page, ...Page[]];
  stuck.serve = () => new Promise(() => undefined);
  const isDone = Promise.all(remaining.map((page) => load(page))).then(() => true);
  let done = false;
  void isDone.then(() => (done = true));
  for (let seconds = 0; !done && seconds < 120; seconds++) await clock.advance(1);
  assert.ok(done);
  assert.equal(remaining.reduce((sum, page) => sum + page.dropped.size, 0), 0);
});

test('a page that announces missing files gets one request for each', async () => {
  const clock = steppedClock();
  const [liar, page] = createPages(2, clock) as [Page, Page];
  liar.shownNames = [];
  join(liar, page, clock);
  liar.peers.get(page.number)?.tell('here', NAMES.map((name) => WORLD[name]?.entry.sha256 ?? ''));
  await waitUntilIdle();
  await load(page, NAMES.slice(0, 3));
  assert.deepEqual([page.serverRequests, liar.serverRequests], [NAMES.slice(0, 3), []]);
});

test('before the first picture a page waits for others once, for at most three seconds', async () => {
  const clock = steppedClock();
  const all = createPages(3, clock);
  joinAll(all, clock);
  const name = NAMES.find((each) => {
    const key = WORLD[each]?.entry.sha256 ?? '';
    return all.slice(1).every(({ number }) => precedes(number, all[0]?.number ?? 0, key));
  });
  const [page, ...others] = all as [Page, ...Page[]];
  page.isFirstPictureMissing = true;
  for (const other of others) other.serve = () => new Promise(() => undefined);
  const content = page.get(name ?? '');
  await waitUntilIdle();
  await clock.advance(3);
  assert.deepEqual(page.serverRequests, []);
  await clock.advance(0.25);
  await content;
  assert.deepEqual(page.serverRequests, [name]);
});

test('requests wait until others are connected, unless a connected page has the file', async () => {
  const clock = steppedClock();
  let setReady = (): void => undefined;
  const page = createPage(1, WORLD, clock, new Promise((done) => (setReady = done)));
  const other = createPage(2, WORLD, clock);
  const [pendingName = '', storedName = ''] = NAMES;
  await other.get(storedName);
  const content = page.get(pendingName);
  await waitUntilIdle();
  assert.deepEqual(page.serverRequests, []);
  join(page, other, clock);
  await waitUntilIdle();
  // Users without files send an empty list.
  assert.deepEqual([page.usersWithFiles, other.usersWithFiles], [[2], [1]]);
  await page.get(storedName);
  assert.deepEqual(page.serverRequests, []);
  const stop = new AbortController();
  const abortedRequest = page.get(NAMES[2] ?? '', stop.signal);
  stop.abort(new Error('enough'));
  await assert.rejects(abortedRequest, /enough/);
  setReady();
  await content;
});

test('a damaged file of the server is passed to the decoder, but not to other users', async () => {
  const clock = steppedClock();
  const [one, other] = createPages(2, clock) as [Page, Page];
  const [name = ''] = NAMES;
  one.serve = () => Promise.resolve(new Uint8Array(20_000).fill(99).buffer);
  await one.get(name);
  assert.deepEqual(one.store.keys, []);
  join(one, other, clock);
  one.shownNames = [];
  assert.deepEqual(new Uint8Array(await other.get(name)), new Uint8Array(WORLD[name]?.data ?? new ArrayBuffer(0)));
  assert.deepEqual([other.serverRequests, other.dropped.size], [[name], 0]);
});
