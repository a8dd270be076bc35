import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createFlight, createUploads, MAX_IN_FLIGHT, type Step } from '../src/show/uploads';

const signal = new AbortController().signal;

/** Creates a queue of uploads with a clock that only its steps advance. */
function createTimedUploads() {
  let time = 0;
  const uploads = createUploads(() => time);
  const step = (length: number, kind: Step['kind'] = 'map', bytes = 0): Step => {
    return { kind, bytes, run: () => void (time += length) };
  };
  return { uploads, step };
}

test('no frame exceeds its budget when the estimates of steps are right', async () => {
  const { uploads, step } = createTimedUploads();
  // A step takes 0.03 ms, and 0.03 ms more for each 64 KiB.
  const sizes = Array.from({ length: 500 }, (_, n) => ((7 * n) % 19) * 2 ** 14);
  let isDone = false;
  const steps = sizes.map((bytes) => step(0.03 * (1 + bytes / 2 ** 16), 'arrays', bytes));
  const done = uploads.add(steps, signal).then(() => (isDone = true));
  const times: number[] = [];
  while (!isDone) {
    times.push(uploads.run(3));
    await Promise.resolve();
  }
  await done;
  const sum = sizes.reduce((all, bytes) => all + 0.03 * (1 + bytes / 2 ** 16), 0);
  assert.ok(Math.abs(times.reduce((all, each) => all + each, 0) - sum) < 1e-9);
  assert.ok(times.every((each) => each <= 3), `${times}`);
  // No frame leaves much time unused while work remains.
  assert.ok(times.length <= Math.ceil(sum / 2.7) + 2, `${times}`);
});

test('a step that would probably exceed the budget waits for the next frame', async () => {
  const { uploads, step } = createTimedUploads();
  const long = Array.from({ length: 40 }, () => step(2, 'mesh'));
  const mixed = [step(1.5, 'program'), step(2, 'mesh'), step(0.1), step(0.1)];
  void uploads.add(long, signal);
  for (let n = 0; n < 60; n++) uploads.run(3);
  const done = uploads.add(mixed, signal);
  assert.deepEqual([uploads.run(3), uploads.run(3)].map((each) => Number(each.toFixed(6))), [1.5, 2.2]);
  uploads.run(3);
  await done;
});

test('a step that takes longer than the budget has a frame of its own', async () => {
  const { uploads, step } = createTimedUploads();
  const done = uploads.add([step(10), step(10), step(1)], signal);
  const times = [uploads.run(3), uploads.run(3), uploads.run(3), uploads.run(3)];
  assert.deepEqual(times, [10, 10, 1, 0]);
  await done;
});

test('answers leave less time for steps', async () => {
  const { uploads, step } = createTimedUploads();
  void uploads.add(Array.from({ length: 100 }, () => step(0.2)), signal);
  assert.ok(Math.abs(uploads.run(3) - 3) < 0.2001);
  uploads.spend(2.1);
  const times = uploads.run(3);
  assert.ok(times >= 2.1 && times <= 3, `${times}`);
  // After an answer that took the whole budget no step runs; the next frame has a new budget.
  uploads.spend(5);
  assert.equal(uploads.run(3), 5);
  assert.ok(uploads.run(3) > 2);
});

test('an urgent job runs before the others', async () => {
  const { uploads } = createTimedUploads();
  const order: string[] = [];
  const stepNamed = (name: string): Step => ({ kind: 'mesh', bytes: 0, run: () => void order.push(name) });
  const done = [
    uploads.add([stepNamed('a'), stepNamed('b')], signal),
    uploads.add([stepNamed('c')], signal),
    uploads.add([stepNamed('urgent')], signal, true),
  ];
  while (uploads.run(0.1) || order.length < 4);
  uploads.run(0.1);
  await Promise.all(done);
  assert.deepEqual(order, ['urgent', 'a', 'b', 'c']);
});

test('a step that fails ends only its own job', async () => {
  const { uploads, step } = createTimedUploads();
  const failingStep: Step = { kind: 'map', bytes: 0, run: () => assert.fail('no memory') };
  const failed = uploads.add([step(0.1), failingStep, step(0.1)], signal);
  const done = uploads.add([step(0.1)], signal);
  uploads.run(3);
  await assert.rejects(failed, /no memory/);
  await done;
});

/** Creates a GPU that passes fences when the test says so. */
function createSlowGpu() {
  const marks: { isPassed: boolean }[] = [];
  const gl = {
    SIGNALED: 1,
    fenceSync: () => {
      const mark = { isPassed: false };
      marks.push(mark);
      return mark;
    },
    getSyncParameter: (mark: { isPassed: boolean }) => (mark.isPassed ? 1 : 0),
    deleteSync: () => undefined,
    flush: () => undefined,
  };
  return { marks, flight: createFlight(gl as unknown as WebGL2RenderingContext) };
}

test('uploads wait while the GPU has too many bytes to consume', async () => {
  const { marks, flight } = createSlowGpu();
  const uploads = createUploads(() => 0, flight);
  let sent = 0;
  const bytes = MAX_IN_FLIGHT / 4;
  const steps = Array.from({ length: 10 }, (): Step => ({ kind: 'map', bytes, run: () => void (sent += bytes) }));
  const done = uploads.add(steps, signal);
  uploads.run(Infinity);
  assert.equal(sent, MAX_IN_FLIGHT);
  uploads.run(Infinity);
  assert.equal(sent, MAX_IN_FLIGHT);
  for (const mark of marks) mark.isPassed = true;
  uploads.run(Infinity);
  assert.equal(sent, 2 * MAX_IN_FLIGHT);
  // After a loss of the context, nothing is in flight.
  uploads.forget();
  uploads.run(Infinity);
  uploads.run(Infinity);
  await done;
  assert.equal(sent, 10 * bytes);
});

test('an upload above the limit waits until nothing else is in flight', () => {
  const { marks, flight } = createSlowGpu();
  assert.ok(flight.hasRoom(2 * MAX_IN_FLIGHT));
  flight.send(2 * MAX_IN_FLIGHT);
  flight.mark();
  assert.ok(!flight.hasRoom(1));
  assert.ok(flight.hasRoom(0));
  for (const mark of marks) mark.isPassed = true;
  assert.ok(flight.hasRoom(1));
});
