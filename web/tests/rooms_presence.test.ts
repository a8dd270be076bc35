import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ahead } from '../src/control/pose';
import { type Body, interpolateBodies, type Pose, rotate, rotationAlong, rotationOf, slerp } from '../src/rooms/pose';
import { createPresence } from '../src/rooms/presence';
import { createTrack } from '../src/rooms/track';
import { REST } from './support/rooms';
import { randomOf } from './support/random';
import { assertNear } from './support/near';

/** Poses per second. */
const RATE = 72;

/** Movement of a user who walks in circles and looks around. */
function movement(time: number): Body {
  const position = [3 * Math.sin(0.8 * time), 1.7, 2 * Math.cos(0.8 * time)] as const;
  const head = { position, rotation: rotationOf(Math.sin(1.3 * time), 0.3 * Math.sin(time)) };
  return { head, left: null, right: head, pointer: { begin: 'right', length: 10 + time } };
}

function distance(a: Body, b: Body): number {
  return Math.hypot(...a.head.position.map((value, axis) => value - (b.head.position[axis] ?? 0)));
}

/** Radians between the directions in which two bodies look. */
function angle(a: Body, b: Body): number {
  const [u, v] = [a, b].map(({ head }) => rotate(head.rotation, [0, 0, -1]));
  return Math.acos(Math.min(u && v ? u[0] * v[0] + u[1] * v[1] + u[2] * v[2] : 0, 1));
}

/** Transmission of poses. */
interface Transmission {
  /** Least delay of a pose, and greatest additional delay, seconds. */
  readonly leastDelay: number;
  readonly jitter: number;
  /** Share of poses that are lost. */
  readonly loss: number;
  /** Start of the sender's clock in seconds, and its speed. */
  readonly begin: number;
  readonly speed?: number;
}

interface Frame {
  readonly drawn: Body;
  readonly now: number;
  /** Delay that the track adds to the least delay of the network, seconds. */
  readonly addedDelay: number;
}

/** Transmits some seconds of the movement; returns the bodies drawn at 60 Hz and their added delays. */
function play({ leastDelay, jitter, loss, begin, speed = 1 }: Transmission, seconds: number, seed = 7): Frame[] {
  const chance = randomOf(seed);
  const track = createTrack();
  const poses = Array.from({ length: RATE * seconds }, (_, number) => {
    const sent = number / RATE;
    const clock = BigInt(Math.round(1e6 * (begin + speed * sent)));
    const pose: Pose = { ...REST, ...movement(sent), sequence: number + 1, clock };
    return { pose, arrival: sent + leastDelay + jitter * chance() };
  }).filter(() => chance() >= loss);
  // Poses may overtake each other.
  poses.sort((a, b) => a.arrival - b.arrival);
  const frames: Frame[] = [];
  for (let frame = 0; frame < 60 * seconds; frame++) {
    const now = frame / 60;
    for (let next = poses[0]; next && next.arrival <= now; next = poses[0]) {
      track.hear(next.pose, next.arrival);
      poses.shift();
    }
    const drawn = track.bodyAt(now);
    if (drawn) frames.push({ drawn, now, addedDelay: track.addedDelay });
  }
  return frames;
}

const TRANSMISSIONS: Readonly<Record<string, Transmission>> = {
  'a constant delay': { leastDelay: 0.03, jitter: 0, loss: 0, begin: 0 },
  'jitter and reordering': { leastDelay: 0.02, jitter: 0.06, loss: 0, begin: 1e6 },
  'jitter, reordering and loss': { leastDelay: 0.02, jitter: 0.04, loss: 0.1, begin: 0 },
  'a clock that is 200 ppm fast': { leastDelay: 0.02, jitter: 0.02, loss: 0, begin: 5e3, speed: 1.0002 },
};

for (const [name, transmission] of Object.entries(TRANSMISSIONS)) {
  test(`movement is drawn as it was, with a delay: ${name}`, () => {
    // At first, before the jitter is known, movement is extrapolated.
    const frames = play(transmission, 30).filter(({ now }) => now > 2);
    assert.ok(frames.length > 1600);
    for (const { drawn, now, addedDelay } of frames) {
      const expected = movement(now - transmission.leastDelay - addedDelay);
      // The user moves by up to 2.4 m and 1.3 rad a second; the error of the least delay is about a millisecond.
      assert.ok(distance(drawn, expected) < 0.03, `${distance(drawn, expected)} m at ${now}`);
      assert.ok(angle(drawn, expected) < 0.02, `${angle(drawn, expected)} rad at ${now}`);
      assert.ok(addedDelay <= transmission.jitter + 0.04 && addedDelay > 0, `${addedDelay} s`);
    }
  });
}

test('drawn poses never jump or go back, even while delays grow', () => {
  for (const transmission of Object.values(TRANSMISSIONS)) {
    let last: { drawn: Body; now: number } | null = null;
    for (const { drawn, now } of play(transmission, 10, 3).filter((frame) => frame.now > 1)) {
      if (last) assert.ok(distance(drawn, last.drawn) < 0.1, `${distance(drawn, last.drawn)} m in a frame`);
      last = { drawn, now };
    }
  }
});

/** Track of a user who has walked along x at 1 m/s for a second; poses arrive without delay. */
function trackOfWalk(stops: boolean): ReturnType<typeof createTrack> {
  const track = createTrack();
  for (let number = 0; number <= RATE; number++) {
    const x = number / RATE;
    const clock = BigInt(Math.round(1e6 * x));
    const head = { ...REST.head, position: [x, 0, 0] as const };
    track.hear({ ...REST, head, sequence: number, clock, stops: stops && number === RATE }, x);
    track.bodyAt(x);
  }
  return track;
}

const xAt = (track: ReturnType<typeof createTrack>, now: number): number => track.bodyAt(now)?.head.position[0] ?? NaN;

test('a movement is extrapolated for a tenth of a second, and then stops', () => {
  const track = trackOfWalk(false);
  assert.ok(Math.abs(xAt(track, 1.09) - 1.09 + track.addedDelay) < 1e-3);
  assert.ok(xAt(track, 1.09) > 1.05);
  assertNear(xAt(track, 1.5), 1.1, 1e-3);
  assertNear(xAt(track, 60), 1.1, 1e-3);
});

test('a user who stops is not extrapolated, and does not move before the next pose', () => {
  const track = trackOfWalk(true);
  assertNear(xAt(track, 1.1), 1, 1e-9);
  const pose = { ...REST, sequence: 100, clock: 5_000_000n, head: { ...REST.head, position: [2, 0, 0] as const } };
  track.hear(pose, 5);
  assertNear(xAt(track, 4.99), 1, 1e-9);
  assertNear(xAt(track, 5.1), 2, 1e-9);
});

test('a jump to another place is not extrapolated', () => {
  const track = trackOfWalk(false);
  const pose = { ...REST, sequence: 100, clock: 1_014_000n, head: { ...REST.head, position: [50, 0, 0] as const } };
  track.hear(pose, 1.014);
  assert.equal(xAt(track, 1.2), 50);
});

test('old and repeated poses are ignored, but not poses of a restarted clock', () => {
  const track = trackOfWalk(true);
  const hear = (sequence: number, clock: bigint, x: number): void =>
    track.hear({ ...REST, sequence, clock, stops: true, head: { ...REST.head, position: [x, 0, 0] } }, 2);
  hear(RATE, 1_000_000n, 77);
  hear(3, 2_000_000n, 77);
  assertNear(xAt(track, 2), 1, 1e-9);
  hear(101, 5n, 88);
  assert.equal(xAt(track, 2.5), 88);
});

test('extreme clocks give finite positions', () => {
  const track = createTrack();
  const clocks = [0n, (1n << 64n) - 1n, 1n, 1n << 63n, 2n];
  clocks.forEach((clock, number) => track.hear({ ...REST, sequence: number + 1, clock }, number / 72));
  for (let now = 0; now < 3; now += 0.01) assert.ok(xAt(track, now) === 0, `${xAt(track, now)}`);
});

test('rotations look along their directions, and are interpolated at constant speed along the shorter arc', () => {
  for (const [yaw, pitch] of [[0, 0], [0.7, -0.4], [3, 1.2], [-2, 0.1]] as const) {
    const direction = rotate(rotationOf(yaw, pitch), [0, 0, -1]);
    assertNear(ahead({ yaw, pitch }), direction, 1e-12);
    const [x, y, z] = direction;
    assertNear(rotate(rotationAlong([5 * x, 5 * y, 5 * z]), [0, 0, -1]), direction, 1e-12);
  }
  const [from, to] = [rotationOf(0.2, 0), rotationOf(1.2, 0)];
  const opposite = to.map((part) => -part) as unknown as typeof to;
  for (const share of [0, 0.25, 0.5, 1, 1.3]) {
    assertNear(slerp(from, opposite, share), rotationOf(0.2 + share, 0), 1e-12);
  }
});

test('hands and pointers appear, disappear and change halfway between poses', () => {
  const [a, b] = [movement(0), { ...movement(1), left: movement(1).head }];
  assert.equal(interpolateBodies(a, b, 0.4).left, null);
  assert.ok(interpolateBodies(a, b, 0.6).left);
  assert.equal(interpolateBodies(a, b, 0.25).pointer?.length, 10.25);
  assert.equal(interpolateBodies(a, b, 3).pointer?.length, 11);
  assert.equal(interpolateBodies(a, { ...b, pointer: null }, 0.4).pointer?.length, 10);
  assert.equal(interpolateBodies(a, { ...b, pointer: null }, 0.6).pointer, null);
});

test('guests are users who have joined and not left, visible after their first pose', () => {
  const presence = createPresence();
  const pose = { ...REST, pointer: { begin: 'head', length: 2 } } as const;
  presence.hear({ kind: 'joined', user: 9, group: 0, name: 'Nine' }, 0);
  presence.hear({ kind: 'joined', user: 4, group: 1, name: 'Four' }, 0);
  presence.hear({ kind: 'pose', user: 5, pose }, 0);
  assert.deepEqual(presence.guests.map(({ name }) => name), ['Four', 'Nine']);
  assert.deepEqual(presence.visibleAt(0), []);
  presence.hear({ kind: 'pose', user: 9, pose }, 0);
  assert.equal(presence.visibleAt(1)[0]?.body.pointer?.length, 2);
  presence.mute(9, true);
  assert.equal(presence.visibleAt(1)[0]?.body.pointer, null);
  presence.hear({ kind: 'left', user: 9 }, 1);
  assert.deepEqual(presence.guests.map(({ number }) => number), [4]);
  // A user who returns with the same number is still muted.
  presence.hear({ kind: 'joined', user: 9, group: 0, name: 'Nine' }, 2);
  assert.equal(presence.guests[1]?.isMuted, true);
  presence.hear({ kind: 'welcome', user: 1, others: 0, ticket: new Uint8Array() }, 3);
  assert.deepEqual(presence.guests, []);
});
