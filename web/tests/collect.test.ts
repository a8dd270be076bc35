import assert from 'node:assert/strict';
import { test } from 'node:test';
import vectors from '../../tests/vectors/collect.json';
import { LEVELS, type Message, read, type Rules, type Tally, write } from '../src/collect/messages';
import { reflectInto, isAimed, type Ray, seatsOf, sphereOf } from '../src/collect/spheres';
import { Task } from '../src/collect/task';
import type { Vector } from '../src/control/pose';
import { bytesOf, hexOf } from '../src/base/bytes';
import { FrameError } from '../src/rooms/bytes';
import { assertNear } from './support/near';

/** Converts a message to the fields of the vectors. */
function withVectorNames(message: Message | null): unknown {
  if (message?.kind !== 'trial') return message;
  const tallyRow = ({ spheres, misses, seconds }: Tally): readonly number[] => [spheres, misses, seconds];
  return { ...message, tallies: message.tallies.map(tallyRow) };
}

test('messages equal the vectors of all languages', () => {
  for (const { message, bytes, region } of vectors.messages) {
    const found = read(bytesOf(bytes));
    assert.deepEqual(withVectorNames(found), message, region);
    assert.equal(found && hexOf(write(found)), bytes, region);
  }
});

test('malformed bytes are rejected', () => {
  for (const { bytes, region } of vectors.refused) assert.throws(() => read(bytesOf(bytes)), FrameError, region);
  assert.equal(read(new Uint8Array()), null);
  assert.equal(read(new TextEncoder().encode('hello')), null);
});

test('truncated messages are rejected, and corrupted ones parsed or rejected', () => {
  for (const { bytes } of vectors.messages) {
    const data = bytesOf(bytes);
    for (let length = 1; length < data.length; length++) {
      assert.throws(() => read(data.subarray(0, length)), FrameError);
    }
    const task = new Task(3, 0);
    for (let bit = 0; bit < 8 * data.length; bit++) {
      const changed = data.slice();
      changed[bit >> 3] = (changed[bit >> 3] ?? 0) ^ (1 << (bit & 7));
      let message: Message | null = null;
      try {
        message = read(changed);
      } catch (error) {
        assert.ok(error instanceof FrameError, String(error));
      }
      if (message) task.hear(message, 1);
      const ray: Ray = { begin: [0, 1.7, 0], direction: [0, 0, -1] };
      for (const answer of task.conduct(2, new Map([[3, ray]]))) write(answer);
    }
  }
});

type Hearing = (typeof vectors.hearings)[number];

function firstTrial(): Rules {
  const found = read(bytesOf(vectors.messages[0]?.bytes ?? ''));
  assert.ok(found?.kind === 'trial');
  return found;
}

test('spheres and seats have the positions of the vectors', () => {
  const rules = firstTrial();
  for (const { group, run, trial, number, level, position, velocity, seat } of vectors.places) {
    const sphere = sphereOf(rules, { run, trial }, group, number);
    assert.equal(sphere.level, level);
    assertNear(sphere.position, position, 1e-12);
    assertNear(sphere.velocity, velocity, 1e-12);
    assertNear(seatsOf(rules, { run, trial }, group, [9])[0]?.position ?? [], seat, 1e-12);
  }
});

/** Describes a message in the words of the vectors. */
function describe(speaker: number, message: Message): string {
  const text = (): string => {
    if (message.kind === 'trial') return `${message.over ? 'over' : 'trial'} ${message.trial}`;
    if (message.kind === 'sphere') return `sphere ${message.number} ${message.level}`;
    if (message.kind === 'score') return `score ${message.spheres} ${message.misses}`;
    if (message.kind === 'collected') {
      return `collected ${message.number} ${message.level}, ${message.misses} missed, ${message.seconds} s`;
    }
    const { event, user, users, misses, held } = message;
    if (event === 'told') return `told [${users.join(', ')}]${users.length > 0 ? '' : `, ${misses} missed`}`;
    return `${event} ${user}${event === 'lost' ? `, ${misses} missed` : ''}${held === null ? '' : `, held ${held}`}`;
  };
  return `${speaker}: ${text()}`;
}

test('a game runs as in the vectors', () => {
  for (const { rules, group, users, steps } of vectors.plays) {
    const tasks = new Map<number, Task>(users.map((user) => [user, new Task(user, group)]));
    let messagesSoFar: string[] = [];
    const join = (user: number): void => tasks.forEach((task) => task.addUser(user));
    const deliver = (speaker: number, messages: readonly Message[], now: number): void => {
      for (const message of messages) {
        messagesSoFar.push(describe(speaker, message));
        for (const [user, task] of tasks) if (user !== speaker) task.hear(message, now, speaker, group);
      }
    };
    users.forEach(join);
    for (const { now, comes, goes, aiming, said: expected } of steps) {
      if (comes !== null) {
        const late = new Task(comes, group);
        for (const user of tasks.keys()) late.present.add(user);
        tasks.set(comes, late);
        join(comes);
      }
      if (goes !== null) {
        tasks.delete(goes);
        tasks.forEach((task) => task.removeUser(goes));
      }
      if (now === 0) deliver(3, tasks.get(3)?.start({ ...firstTrial(), ...rules }, now) ?? [], now);
      for (const [user, task] of [...tasks].sort(([a], [b]) => b - a)) {
        const [x, y, z] = task.place(now) ?? [0, 0, 0];
        const rayOf = (other: number): Ray => ({
          begin: [x, y, z + 4],
          direction: aiming.includes(other) ? [0, 0, -1] : [0, 1, 0],
        });
        deliver(user, task.conduct(now, new Map([...tasks.keys()].map((other) => [other, rayOf(other)]))), now);
      }
      assert.deepEqual(messagesSoFar, expected, `${now}`);
      messagesSoFar = [];
    }
    assert.ok([...tasks.values()].every((task) => task.isOver));
  }
});

/** Converts a message of the vectors to the fields of this module. */
function messageOf(fields: Hearing['steps'][number]['message']): Message {
  const tallyOf = ([spheres, misses, seconds]: readonly number[]): Tally =>
    ({ spheres: spheres ?? 0, misses: misses ?? 0, seconds: seconds ?? 0 });
  const tallies = 'tallies' in fields && { tallies: fields.tallies?.map(tallyOf) };
  return { ...fields, ...tallies } as unknown as Message;
}

/** Rays of users who aim at the middle of the sphere. */
function raysAtSphere(task: Task, users: Iterable<number>, now: number): Map<number, Ray> {
  const [x, y, z] = task.place(now) ?? [0, 0, 0];
  const ray: Ray = { begin: [x, y, z + 4], direction: [0, 0, -1] };
  return new Map([...users].map((user) => [user, ray]));
}

test('the state that a user derives equals the vectors', () => {
  for (const { region, user, group, others, steps, now: end, said } of vectors.hearings) {
    const task = new Task(user, group);
    const enter = (): void => {
      task.resetUsers();
      others.forEach((other) => task.addUser(other));
    };
    enter();
    for (const { now, returns, sender, message, taken } of steps) {
      if (returns) enter();
      assert.equal(task.hear(messageOf(message), now, sender, group), taken, `${region}: ${message.kind}`);
    }
    const messages = task.conduct(end, raysAtSphere(task, task.present, end));
    assert.deepEqual(messages.map((message) => describe(user, message)), said, region);
  }
});

/** Task of a conductor in a trial that has begun, with a sphere that does not move. */
function startTrial(users: number): Task {
  const task = new Task(0, 0);
  for (let user = 1; user < users; user++) task.addUser(user);
  task.start({ ...firstTrial(), speeds: [0, 0, 0], duration: 1000, hold: 1000, users }, 0);
  assert.equal(task.conduct(0, new Map())[0]?.kind, 'sphere');
  return task;
}

test('flickering pointers do not exceed the rate of messages', () => {
  const [task, seconds] = [startTrial(64), 8];
  const users = Array.from({ length: 64 }, (_, user) => user);
  let size = 0;
  for (let moment = 1; moment <= 512 * seconds; moment++) {
    const now = moment / 512;
    const messages = task.conduct(now, moment % 2 === 1 ? raysAtSphere(task, users, now) : new Map());
    for (const message of messages) size += Math.max(write(message).length + 5, 64);
  }
  assert.ok(size > 8000 * seconds && size <= 16384 * seconds + 8192, `${size}`);
  // The last state is sent as soon as the rate allows.
  for (let moment = 0; moment < 80; moment++) {
    const now = seconds + 1 + moment / 80;
    task.conduct(now, raysAtSphere(task, users, now));
  }
  assert.deepEqual(task.aims, users);
});

test('the conductor judges at most as often as it receives poses', () => {
  const task = startTrial(1);
  let messageCount = 0;
  for (let moment = 1; moment <= 1000; moment++) {
    const now = moment / 1000;
    messageCount += task.conduct(now, moment % 2 === 1 ? raysAtSphere(task, [0], now) : new Map()).length;
  }
  assert.ok(messageCount > 0 && messageCount <= 80, `${messageCount}`);
});

test('scores of groups that have left are forgotten', () => {
  const task = new Task(0, 2);
  for (const group of [0, 1, 2, 3, 4]) {
    task.hear({ kind: 'score', run: 1, trial: 1, over: false, spheres: group, misses: 0 }, 0, 9, group);
  }
  task.forgetScores((group) => group === 2 || group === 4);
  assert.deepEqual([...task.scores.keys()], [2, 4]);
  task.resetUsers();
  assert.deepEqual([...task.scores.keys()], [2]);
});

test('a pointer aims at a sphere only if its ray hits it', () => {
  const aims = (x: number, center: Vector): boolean =>
    isAimed({ begin: [x, 0, 0], direction: [0, 0, -1] }, center, 0.3);
  assert.deepEqual([0, 0.299, 0.301].map((x) => aims(x, [0, 0, -8])), [true, true, false]);
  assert.equal(aims(0, [0, 0, 8]), false);
  assert.equal(aims(0.1, [0, 0, 0]), true);
});

test('spheres are reflected at the faces of their box', () => {
  assert.deepEqual([0.5, 2.5, -1.5, 7.5].map((at) => reflectInto(at, -1, 2)), [0.5, 1.5, -0.5, 1.5]);
  assert.equal(reflectInto(7, 1, 1), 1);
  assert.equal(LEVELS.length, 3);
});
