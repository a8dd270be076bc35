import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createSlots } from '../src/bundle/requests';

test('the place of a cancelled job in the queue goes to the next job', async () => {
  const slots = createSlots(1);
  const [stop, go] = [new AbortController(), new AbortController()];
  let finish = (): void => undefined;
  const first = slots(go.signal, () => new Promise<void>((done) => (finish = done)));
  const second = slots(stop.signal, () => Promise.resolve('second'));
  const third = slots(go.signal, () => Promise.resolve('third'));
  stop.abort(new Error('enough'));
  await assert.rejects(second, /enough/);
  finish();
  await first;
  assert.equal(await third, 'third');
  assert.equal(await slots(go.signal, () => Promise.resolve('again')), 'again');
});

test('a failed job frees its slot', async () => {
  const { signal } = new AbortController();
  const slots = createSlots(1);
  await assert.rejects(slots(signal, () => Promise.reject(new Error('broken'))), /broken/);
  assert.equal(await slots(signal, () => Promise.resolve(1)), 1);
});
