import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openKernel } from '../src/widget/kernel';
import { createMirror, MIN_INTERVAL, type Model } from '../src/widget/model';
import { asManifest, FILE, manifest } from './support/manifest';

type Callback = (...args: never[]) => void;

interface Asked {
  readonly id: string;
  readonly name: string;
  readonly start: number;
}

/** A model whose Python side is the test. */
function fakeModel(state: Record<string, unknown> = {}) {
  const callbacks = new Map<string, Set<Callback>>();
  const asked: Asked[] = [];
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
    send: (content) => void asked.push(content as Asked),
  };
  const answer = (content: object, data?: Uint8Array): void =>
    emit('msg:custom', content, data ? [new DataView(data.buffer, data.byteOffset, data.byteLength)] : []);
  return { model, asked, saved, answer, count: () => [...callbacks.values()].reduce((sum, set) => sum + set.size, 0) };
}

const text = new TextEncoder().encode(asManifest(manifest()));
const soon = (): Promise<void> => new Promise((done) => setTimeout(done, 0));
const signal = new AbortController().signal;

async function openFakeKernel() {
  const fake = fakeModel();
  const opening = openKernel(fake.model, () => undefined, signal);
  fake.answer({ id: fake.asked[0]?.id, bytes: text.length }, text);
  return { ...fake, source: await opening };
}

test('a manifest comes from the kernel, and files in pieces', async () => {
  const fake = await openFakeKernel();
  assert.equal(fake.source.manifest.files[FILE]?.bytes, 3);
  const file = fake.source.fetch(FILE, signal);
  await soon();
  assert.deepEqual([fake.asked[1]?.name, fake.asked[1]?.start], [FILE, 0]);
  fake.answer({ id: fake.asked[1]?.id, bytes: 3 }, Uint8Array.of(9, 7, 8).subarray(1));
  await soon();
  assert.equal(fake.asked[2]?.start, 2);
  fake.answer({ id: fake.asked[2]?.id, bytes: 3 }, Uint8Array.of(9));
  assert.deepEqual([...new Uint8Array(await file)], [7, 8, 9]);
});

test('missing files are reported', async () => {
  const fake = await openFakeKernel();
  await assert.rejects(fake.source.fetch('files/0000000000000000.webp', signal), /manifest does not list/);
  for (const [answer, data, message] of [
    [{ problem: 'no such file' }, undefined, /^BundleError: no such file$/],
    [{ bytes: 4 }, Uint8Array.of(1), /expected 3 bytes, as the manifest lists it, got 4/],
    [{ bytes: 3 }, Uint8Array.of(), /expected 3 bytes/],
    [{ bytes: 3 }, undefined, /without a file/],
  ] as const) {
    const file = fake.source.fetch(FILE, signal);
    await soon();
    fake.answer({ id: fake.asked.at(-1)?.id, ...answer }, data);
    await assert.rejects(file, message);
  }
});

test('a removed view stops waiting and listening', async () => {
  const fake = await openFakeKernel();
  const stop = new AbortController();
  const file = fake.source.fetch(FILE, stop.signal);
  await soon();
  stop.abort(new Error('gone'));
  await assert.rejects(file, /gone/);
  fake.answer({ id: fake.asked.at(-1)?.id, bytes: 3 }, Uint8Array.of(1, 2, 3));
  fake.source.dispose();
  assert.equal(fake.count(), 0);
});

test('answers for another view are ignored', async () => {
  const fake = fakeModel();
  const [first, second] = [0, 1].map(() => openKernel(fake.model, () => undefined, signal));
  const [one, two] = fake.asked;
  assert.notEqual(one?.id, two?.id);
  fake.answer({ id: two?.id, bytes: text.length }, text);
  assert.equal((await second)?.manifest.version, 1);
  fake.answer({ id: one?.id, bytes: text.length }, text);
  assert.equal((await first)?.manifest.version, 1);
});

test('only changes are sent to Python, and not in every frame', () => {
  const { model, saved } = fakeModel({ yaw: 0, position: [1, 2, 3] });
  const mirror = createMirror(model);
  mirror.tell({ yaw: 0, position: [1, 2, 3] }, 0);
  assert.equal(saved.length, 0);
  for (let now = 0; now <= 10 * MIN_INTERVAL; now += 16) mirror.tell({ yaw: now }, now);
  assert.ok(saved.length > 5 && saved.length <= 11, `${saved.length}`);
  // The rest is sent after the pause.
  mirror.tell({ yaw: -1 }, 20 * MIN_INTERVAL);
  assert.equal(saved.at(-1)?.['yaw'], -1);
});

test('changes from Python are applied together, and those of the view are not echoed', async () => {
  const fake = fakeModel({ yaw: 0, pitch: 0 });
  const mirror = createMirror(fake.model);
  let heard = 0;
  mirror.hear(['yaw', 'pitch'], () => void heard++);
  mirror.tell({ yaw: 1, pitch: 1 }, 0);
  await soon();
  assert.equal(heard, 0);
  fake.model.set('yaw', 2);
  fake.model.set('pitch', 2);
  await soon();
  assert.equal(heard, 1);
  mirror.dispose();
  fake.model.set('yaw', 3);
  await soon();
  assert.deepEqual([heard, fake.count()], [1, 0]);
});
