import assert from 'node:assert/strict';
import { test } from 'node:test';
import { texelOf } from '../src/rooms/pointing';
import type { Body } from '../src/rooms/pose';
import { createSender } from '../src/rooms/sending';
import { applyMorph, invertMorph, type Morph } from '../src/rooms/unmorph';
import { randomOf } from './support/random';
import { REST } from './support/rooms';

const at = (x: number): Body => ({ ...REST, head: { ...REST.head, position: [x, 0, 0] } });

/** Sender with its sent poses; the test decides whether the connection accepts poses. */
class TestSender {
  readonly sent: [number, boolean][] = [];
  isOpen = true;
  readonly sender = createSender((body, stops) => {
    if (this.isOpen) this.sent.push([body.head.position[0], stops]);
    return this.isOpen;
  });
}

test('poses are sent while the user moves, and then one that marks the end', () => {
  const { sent, sender } = new TestSender();
  [0, 1, 2, 2, 2, 2, 3, 3].forEach((x, frame) => sender.update(at(x), frame / 60));
  assert.deepEqual(sent, [[0, false], [1, false], [2, false], [2, true], [3, false], [3, true]]);
});

test('at most 72 poses a second are sent, on displays of any rate', () => {
  for (const [hertz, expected] of [[60, 60], [72, 72], [90, 72], [144, 72], [1000, 72]] as const) {
    const { sent, sender } = new TestSender();
    for (let frame = 0; frame < 10 * hertz; frame++) sender.update(at(frame), frame / hertz);
    assert.ok(sent.length <= 10 * 72 + 1, `${sent.length} at ${hertz}`);
    assert.ok(sent.length >= 8 * expected, `${sent.length} at ${hertz}`);
  }
});

test('movements below a millimetre are not sent, and poses that could not be sent are sent later', () => {
  const context = new TestSender();
  for (let frame = 0; frame < 9; frame++) context.sender.update(at(5e-4 * (frame % 2)), frame / 60);
  assert.deepEqual(context.sent.map(([, stops]) => stops), [false, true]);
  context.isOpen = false;
  context.sender.update(at(1), 1);
  context.isOpen = true;
  context.sender.update(at(1), 2);
  assert.deepEqual(context.sent.slice(2), [[1, false]]);
});

test('the pose of a resting user is repeated for new users', () => {
  const { sent, sender } = new TestSender();
  for (const now of [0, 1, 2]) sender.update(at(4), now);
  sender.repeat();
  for (const now of [3, 4]) sender.update(at(4), now);
  assert.deepEqual(sent, [[4, false], [4, true], [4, true]]);
});

test('the user of a hidden page rests without a pointer, also for new users', () => {
  const sent: [Body, boolean][] = [];
  const sender = createSender((body, stops) => sent.push([body, stops]) > 0);
  sender.rest();
  assert.deepEqual(sent, []);
  const pointing: Body = { ...at(1), right: REST.head, pointer: { begin: 'right', length: 10 } };
  sender.update(pointing, 0);
  sender.rest();
  sender.repeat();
  const resting: Body = { ...pointing, pointer: null };
  assert.deepEqual(sent.slice(1), [[resting, true], [resting, true]]);
  sender.update(resting, 1);
  assert.equal(sent.length, 3);
  sender.update(pointing, 2);
  sender.repeat();
  sender.update(pointing, 3);
  assert.deepEqual(sent.slice(3), [[pointing, false], [pointing, true]]);
});

test('poses are sent when hands or pointers appear, disappear or change', () => {
  const { sent, sender } = new TestSender();
  const bodies: readonly Body[] = [
    REST,
    { ...REST, right: REST.head },
    { ...REST, right: REST.head, pointer: { begin: 'right', length: 10 } },
    { ...REST, right: REST.head, pointer: { begin: 'right', length: 10.1 } },
    { ...REST, right: REST.head, pointer: { begin: 'head', length: 10.1 } },
    { ...REST, left: REST.head },
  ];
  bodies.forEach((body, now) => sender.update(body, now));
  assert.deepEqual(sent.map(([, stops]) => stops), bodies.map(() => false));
});

test('the morph is inverted in all zones', () => {
  let [worst, count] = [0, 0];
  const random = randomOf(5);
  for (const strength of [0, 0.3, 1]) {
    for (let number = 0; number < 3000; number++) {
      const angle = 2 * Math.PI * random();
      const userDistance = 0.2 * 22 * Math.sqrt(random());
      const user = [userDistance * Math.cos(angle), 0.5 * random(), userDistance * Math.sin(angle)] as const;
      const morph: Morph = { user, inner: 0.7 * 22, radius: 22, strength };
      const [turn, rho] = [2 * Math.PI * random(), 1 + 40 * random()];
      const point = [rho * Math.cos(turn), 20 * random() - 3, rho * Math.sin(turn)] as const;
      const found = invertMorph(applyMorph(point, morph), morph);
      assert.ok(found, `nothing at ${point.join()} for ${user.join()}`);
      worst = Math.max(worst, Math.hypot(found[0] - point[0], found[1] - point[1], found[2] - point[2]));
      count += 1;
    }
  }
  assert.ok(count === 9000 && worst < 1e-3, `${worst} m`);
});

test('before the first ring, points are shown as the centre sees them', () => {
  const morph: Morph = { user: [1, 0, 0], inner: 0, radius: 0, strength: 0 };
  applyMorph([0, 3, -4], morph).forEach((value, axis) => assert.ok(Math.abs(value - ([0, 3, -4][axis] ?? 9)) < 1e-12));
  assert.deepEqual(invertMorph([0, 3, -4], morph), [0, 3, -4]);
});

test('directions map to the texels of a cube map that WebGL samples', () => {
  const size = 4;
  assert.deepEqual(texelOf([1, 0.9, 0.9], size), { face: 0, x: 0, y: 0 });
  assert.deepEqual(texelOf([-1, -0.9, -0.9], size), { face: 1, x: 0, y: 3 });
  assert.deepEqual(texelOf([0.9, 2, -0.1], size), { face: 2, x: 2, y: 1 });
  assert.deepEqual(texelOf([-0.9, -1, -0.9], size), { face: 3, x: 0, y: 3 });
  assert.deepEqual(texelOf([0.9, 0.1, 1], size), { face: 4, x: 3, y: 1 });
  assert.deepEqual(texelOf([0.9, 0.1, -1], size), { face: 5, x: 0, y: 1 });
  assert.deepEqual(texelOf([1, 1, 1], size).face, 0);
});
