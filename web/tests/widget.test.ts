import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openKernel } from '../src/widget/kernel';
import { createMirror, MIN_INTERVAL, type Model } from '../src/widget/model';
import { asManifest, FILE, manifest } from './support/manifest';

type Callback = (...args: never[]) => void;

/** Request of a view. */
interface Request {
  readonly id: string;
  readonly name: string;
  readonly start: number;
}

/** Creates a model; the test is its Python side. */
function createFakeModel(state: Record<string, unknown> = {}) {
  const callbacks = new Map<string, Set<Callback>>();
  const requests: Request[] = [];
  const saved: Record<string, unknown>[] = [];
  const emit = (event: string, ...args: unknown[]): void => {
    for (const callback of [...(callbacks.get(event) ?? [])]) callback(...(args as never[]));
  };
  const model: Model = {
    get: (name) => state[name],
    set(name, value) {
      state[name] = value;
      emit(`change:${name}`);
    },
    save_changes: () => void saved.push({ ...state }),
    on: (event, callback) => void callbacks.set(event, (callbacks.get(event) ?? new Set()).add(callback)),
    off: (event, callback) => void callbacks.get(event)?.delete(callback),
    send: (content) => void requests.push(content as Request),
  };
  const answer = (content: object, data?: Uint8Array): void =>
    emit('msg:custom', content, data ? [new DataView(data.buffer, data.byteOffset, data.byteLength)] : []);
  const countListeners = (): number => [...callbacks.values()].reduce((sum, { size }) => sum + size, 0);
  return { model, requests, saved, answer, countListeners };
}

const text = new TextEncoder().encode(asManifest(manifest()));
const pause = (): Promise<void> => new Promise((done) => setTimeout(done, 0));
const signal = new AbortController().signal;

async function openFakeKernel() {
  const fake = createFakeModel();
  const opening = openKernel(fake.model, () => undefined, signal);
  fake.answer({ id: fake.requests[0]?.id, bytes: text.length }, text);
  return { ...fake, source: await opening };
}

test('the kernel sends the manifest, and files in pieces', async () => {
  const fake = await openFakeKernel();
  assert.equal(fake.source.manifest.files[FILE]?.bytes, 3);
  const file = fake.source.fetch(FILE, signal);
  await pause();
  assert.deepEqual([fake.requests[1]?.name, fake.requests[1]?.start], [FILE, 0]);
  fake.answer({ id: fake.requests[1]?.id, bytes: 3 }, Uint8Array.of(9, 7, 8).subarray(1));
  await pause();
  assert.equal(fake.requests[2]?.start, 2);
  fake.answer({ id: fake.requests[2]?.id, bytes: 3 }, Uint8Array.of(9));
  assert.deepEqual([...new Uint8Array(await file)], [7, 8, 9]);
});

test('missing and wrong files are errors', async () => {
  const fake = await openFakeKernel();
  await assert.rejects(fake.source.fetch('files/0000000000000000.webp', signal), /manifest does not list/);
  for (const [answer, data, message] of [
    [{ problem: 'no such file' }, undefined, /^BundleError: no such file$/],
    [{ bytes: 4 }, Uint8Array.of(1), /expected 3 bytes, as the manifest lists it, got 4/],
    [{ bytes: 3 }, Uint8Array.of(), /expected 3 bytes/],
    [{ bytes: 3 }, undefined, /without a file/],
  ] as const) {
    const file = fake.source.fetch(FILE, signal);
    await pause();
    fake.answer({ id: fake.requests.at(-1)?.id, ...answer }, data);
    await assert.rejects(file, message);
  }
});

test('a view that is removed waits for no answer, and has no listeners', async () => {
  const fake = await openFakeKernel();
  const stop = new AbortController();
  const file = fake.source.fetch(FILE, stop.signal);
  await pause();
  stop.abort(new Error('gone'));
  await assert.rejects(file, /gone/);
  fake.answer({ id: fake.requests.at(-1)?.id, bytes: 3 }, Uint8Array.of(1, 2, 3));
  fake.source.dispose();
  assert.equal(fake.countListeners(), 0);
});

test('each view takes only its own answers', async () => {
  const fake = createFakeModel();
  const [first, second] = [0, 1].map(() => openKernel(fake.model, () => undefined, signal));
  const [firstRequest, secondRequest] = fake.requests;
  assert.notEqual(firstRequest?.id, secondRequest?.id);
  fake.answer({ id: secondRequest?.id, bytes: text.length }, text);
  assert.equal((await second)?.manifest.version, 1);
  fake.answer({ id: firstRequest?.id, bytes: text.length }, text);
  assert.equal((await first)?.manifest.version, 1);
});

test('only changes are sent to Python, and not in every frame', () => {
  const { model, saved } = createFakeModel({ yaw: 0, position: [1, 2, 3] });
  const mirror = createMirror(model);
  mirror.send({ yaw: 0, position: [1, 2, 3] }, 0);
  assert.equal(saved.length, 0);
  for (let now = 0; now <= 10 * MIN_INTERVAL; now += 16) mirror.send({ yaw: now }, now);
  assert.ok(saved.length > 5 && saved.length <= 11, `${saved.length}`);
  // The last change is sent after the pause.
  mirror.send({ yaw: -1 }, 20 * MIN_INTERVAL);
  assert.equal(saved.at(-1)?.['yaw'], -1);
});

test('a view gets changes by Python once for all values, and does not get its own changes', async () => {
  const fake = createFakeModel({ yaw: 0, pitch: 0 });
  const mirror = createMirror(fake.model);
  let changes = 0;
  mirror.listen(['yaw', 'pitch'], () => void changes++);
  mirror.send({ yaw: 1, pitch: 1 }, 0);
  await pause();
  assert.equal(changes, 0);
  fake.model.set('yaw', 2);
  fake.model.set('pitch', 2);
  await pause();
  assert.equal(changes, 1);
  mirror.dispose();
  fake.model.set('yaw', 3);
  await pause();
  assert.deepEqual([changes, fake.countListeners()], [1, 0]);
});
