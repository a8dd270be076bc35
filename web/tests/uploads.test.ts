import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createUploads } from '../src/show/uploads';

/** Uploads on a clock that only steps move. */
function onClock() {
  let time = 0;
  const uploads = createUploads(() => time);
  const steps = (lengths: readonly number[]) => lengths.map((length) => (): void => void (time += length));
  return { uploads, steps };
}

test('a frame takes its budget and one step more at most', async () => {
  const { uploads, steps } = onClock();
  const lengths = Array.from({ length: 500 }, (_, n) => ((7 * n) % 19) / 10);
  const longest = Math.max(...lengths);
  let isDone = false;
  const done = uploads.add(steps(lengths), new AbortController().signal).then(() => (isDone = true));
  let [sum, frames] = [0, 0];
  while (!isDone) {
    const taken = uploads.run(3);
    assert.ok(taken < 3 + longest, `${taken}`);
    sum += taken;
    frames += 1;
    await Promise.resolve();
  }
  await done;
  assert.ok(Math.abs(sum - lengths.reduce((all, length) => all + length, 0)) < 1e-9);
  // No frame leaves time unused while work is left.
  assert.ok(frames <= Math.ceil(sum / 3) + 2, `${frames}`);
});

test('a step that takes longer than a frame is alone in it', async () => {
  const { uploads, steps } = onClock();
  const done = uploads.add(steps([10, 10, 1, 1]), new AbortController().signal);
  assert.deepEqual([uploads.run(3), uploads.run(3), uploads.run(3), uploads.run(3)], [10, 10, 2, 0]);
  await done;
});
