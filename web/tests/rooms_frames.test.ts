import assert from 'node:assert/strict';
import { test } from 'node:test';
import vectors from '../../tests/vectors/rooms.json';
import { bytesOf, hexOf } from '../src/base/bytes';
import { FrameError } from '../src/rooms/bytes';
import { type FromServer, type FromUser, readMessage, writeFrame } from '../src/rooms/frames';
import type { Placement, Pose } from '../src/rooms/pose';
import { encodeBody, encodeFrame, REST } from './support/rooms';

/** Rotation of components that are encoded as 16-bit integers. */
const parts = (...units: readonly number[]): Placement['rotation'] =>
  units.map((unit) => Math.fround(unit / 32767)) as unknown as Placement['rotation'];
const placementAt = (x: number): Placement => ({ position: [x, -0, 1e6], rotation: parts(23170, 0, -23170, 1) });

const FULL_POSE: Pose = {
  sequence: 0xffffffff,
  clock: 1n << 50n,
  isAcknowledged: true,
  stops: true,
  head: placementAt(1.5),
  left: placementAt(-2),
  right: placementAt(0),
  pointer: { begin: 'right', length: 20 },
};
const POSES: readonly Pose[] = [
  REST,
  FULL_POSE,
  { ...FULL_POSE, right: null, pointer: { begin: 'left', length: 0 } },
  { ...REST, stops: true, pointer: { begin: 'head', length: 3.25 } },
];
const FRAMES: readonly FromServer[] = [
  { kind: 'welcome', user: 1, others: 3, ticket: new Uint8Array(26).fill(7) },
  { kind: 'joined', user: 2, group: 4, name: 'Grace é' },
  { kind: 'left', user: 0xffff },
  { kind: 'say', user: 2, to: 'group', payload: new Uint8Array([104, 105]) },
  { kind: 'say', user: 2, to: 'room', payload: new Uint8Array() },
  { kind: 'signal', user: 5, payload: new Uint8Array([0, 255]) },
  { kind: 'settled', sequence: 9 },
  { kind: 'refused', reason: 3, sentence: 'expected frames' },
  ...POSES.map((pose): FromServer => ({ kind: 'pose', user: 77, pose })),
];

test('frames are encoded and decoded, also several in one message', () => {
  const message = Uint8Array.from(Buffer.concat(FRAMES.map(encodeFrame)));
  assert.deepEqual(readMessage(message), FRAMES);
  assert.deepEqual(readMessage(new Uint8Array()), []);
});

test('truncated frames are rejected', () => {
  for (const bytes of FRAMES.map(encodeFrame)) {
    const digits = hexOf(bytes);
    for (let length = 1; length < bytes.length; length++) {
      assert.throws(() => readMessage(bytes.subarray(0, length)), FrameError, `${length} bytes of ${digits}`);
      if (length < 3) continue;
      // With a shorter length in the header, frames that end with a payload or a sentence are valid.
      const short = encodeBody(bytes[0] ?? 0, bytes.subarray(3, length));
      let found: FromServer[] = [];
      try {
        found = readMessage(short);
      } catch (error) {
        assert.ok(error instanceof FrameError);
        continue;
      }
      assert.deepEqual(found.map(encodeFrame).map(hexOf), [hexOf(short)]);
    }
  }
});

test('an additional byte is rejected unless it belongs to a payload or a sentence', () => {
  for (const frame of FRAMES) {
    const bytes = encodeFrame(frame);
    const long = encodeBody(bytes[0] ?? 0, Buffer.concat([bytes.subarray(3), new Uint8Array([65])]));
    if (['say', 'signal', 'refused'].includes(frame.kind)) readMessage(long);
    else assert.throws(() => readMessage(long), FrameError, frame.kind);
  }
});

test('frames with a changed bit are rejected, or encoded as the same bytes again', () => {
  let rejectedCount = 0;
  for (const bytes of FRAMES.map(encodeFrame)) {
    for (let bit = 0; bit < 8 * bytes.length; bit++) {
      const changed = bytes.slice();
      changed[bit >> 3] = (changed[bit >> 3] ?? 0) ^ (1 << (bit & 7));
      try {
        assert.equal(hexOf(Buffer.concat(readMessage(changed).map(encodeFrame))), hexOf(changed));
      } catch (error) {
        assert.ok(error instanceof FrameError, String(error));
        rejectedCount += 1;
      }
    }
  }
  assert.ok(rejectedCount > 500, `${rejectedCount}`);
});

/** Encodes a pose of the server and changes bytes of its body. */
function encodeAltered(pose: Pose, at: number, ...bytes: readonly number[]): Uint8Array {
  const frame = encodeFrame({ kind: 'pose', user: 1, pose });
  frame.set(bytes, 5 + at);
  return frame;
}

test('impossible poses are rejected with a reason', () => {
  const [nan, far] = [[0, 0, 0xc0, 0x7f], [0x01, 0x24, 0x74, 0x49]] as const;
  const cases: readonly (readonly [RegExp, Uint8Array])[] = [
    [/flags/, encodeAltered(REST, 12, 0x40)],
    [/missing hand/, encodeAltered(REST, 12, 0x30)],
    [/position/, encodeAltered(REST, 13, ...nan)],
    [/position/, encodeAltered(REST, 17, ...far)],
    [/quaternion/, encodeAltered(REST, 25, 0, 0, 0, 0, 0, 0, 0, 0)],
    [/quaternion/, encodeAltered(REST, 25, 0xff, 0x7f)],
    [/length/, encodeAltered({ ...REST, pointer: { begin: 'head', length: 1 } }, 33, ...nan)],
    [/length/, encodeAltered({ ...REST, pointer: { begin: 'head', length: 1 } }, 33, 0, 0, 0x80, 0xbf)],
  ];
  for (const [words, bytes] of cases) assert.throws(() => readMessage(bytes), words);
});

test('invalid frames of the server are rejected', () => {
  const joined = (...name: readonly number[]): Uint8Array =>
    encodeBody(134, Uint8Array.from([1, 0, 0, 0, name.length, ...name]));
  assert.throws(() => readMessage(writeFrame({ kind: 'bye' })), /unknown kind/);
  assert.throws(() => readMessage(joined(0xff)), /not UTF-8/);
  assert.throws(() => readMessage(joined(65, 0x1b)), /control/);
  assert.throws(() => readMessage(joined(...Array<number>(65).fill(65))), /too long/);
  assert.throws(() => readMessage(encodeBody(132, Uint8Array.from([1, 0, 2]))), /the group or the room/);
  assert.throws(() => readMessage(encodeBody(132, new Uint8Array(3 + 4097))), /too long/);
});

test('frames of users equal the bytes of the table', () => {
  const pose: Pose = { ...REST, sequence: 0x01020304, clock: 5n, isAcknowledged: true };
  const ticket = new Uint8Array([9, 8]);
  const cases = [
    [writeFrame({ kind: 'hello', group: 3, name: 'Aé', ticket }), '010a00010300' + '0341c3a9' + '020908'],
    [writeFrame({ kind: 'ack', user: 258, sequence: 7 }), '030600' + '0201' + '07000000'],
    [writeFrame({ kind: 'bye' }), '060000'],
    [writeFrame({ kind: 'pose', pose }), '022100' + '04030201' + '0500000000000000' + '01' + '00'.repeat(18) + 'ff7f'],
  ] as const;
  for (const [bytes, expected] of cases) assert.equal(hexOf(bytes), expected);
});

test('a hello with an invalid name is not written', () => {
  const ticket = new Uint8Array();
  assert.throws(() => writeFrame({ kind: 'hello', group: 0, name: 'a\nb', ticket }), /control/);
  assert.throws(() => writeFrame({ kind: 'hello', group: 0, name: 'é'.repeat(33), ticket }), /too long/);
});

interface Field {
  readonly [name: string]: unknown;
}

/** Converts a frame of the page to the field names of docs/rooms.md. */
function withFieldNames(frame: FromServer | FromUser): Field {
  const renamed = 'pose' in frame ? { ...frame, pose: namedPose(frame.pose) } : frame;
  const fields = Object.entries(renamed).map(([name, value]) => [
    name === 'payload' ? 'data' : name,
    value instanceof Uint8Array ? hexOf(value) : value,
  ]);
  return Object.fromEntries(fields) as Field;
}

function namedPose({ sequence, clock, isAcknowledged: acknowledged, stops, pointer, ...body }: Pose): Field {
  const integers = (part: Placement | null): unknown =>
    part && { position: part.position, rotation: part.rotation.map((value) => Math.round(32767 * value)) };
  const [head, left, right] = [integers(body.head), integers(body.left), integers(body.right)];
  return { sequence, clock: Number(clock), acknowledged, stops, head, left, right, pointer };
}

test('frames of the server equal the vectors of all languages', () => {
  for (const { frame, bytes, region } of vectors.servers) {
    const read = readMessage(bytesOf(bytes));
    assert.deepEqual(read.map(withFieldNames), [frame], region);
    assert.deepEqual(read.map(encodeFrame).map(hexOf), [bytes], region);
  }
  for (const { server, region } of vectors.refused) {
    if (server === null) continue;
    assert.throws(() => readMessage(bytesOf(server)), FrameError, region);
  }
});

test('frames of users equal the vectors of all languages', () => {
  for (const { frame, bytes, region } of vectors.users.filter((vector) => vector.frame.kind === 'say')) {
    const to = frame.to === 'room' ? 'room' : 'group';
    const payload = bytesOf(frame.data ?? '');
    assert.equal(hexOf(writeFrame({ kind: 'say', to, payload })), bytes, region);
  }
  assert.throws(() => writeFrame({ kind: 'say', to: 'room', payload: new Uint8Array(4097) }), /too long/);
});

test('poses of users equal the vectors of all languages', () => {
  const head = (bytes: string): string => bytes.slice(6);
  for (const { frame, bytes, region } of vectors.servers.filter((vector) => vector.frame.kind === 'pose')) {
    const [read] = readMessage(bytesOf(bytes));
    assert.ok(read?.kind === 'pose' && frame.kind === 'pose');
    const written = hexOf(writeFrame({ kind: 'pose', pose: read.pose }));
    const expected = vectors.users.find((vector) => vector.region === region)?.bytes;
    assert.deepEqual([head(written), written.slice(0, 2)], [head(expected ?? ''), '02'], region);
  }
});
