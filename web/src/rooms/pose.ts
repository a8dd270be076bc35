/** Where a user's head, hands and pointer are, as bytes: the second table of docs/rooms.md. */
import type { Vector } from '../control/vector';
import { FrameError, type Reader, type Writer } from './bytes';

/** A unit quaternion (x, y, z, w). */
export type Rotation = readonly [number, number, number, number];

export interface Placed {
  /** Metres from the scene's origin. */
  readonly position: Vector;
  readonly rotation: Rotation;
}

/** Where a pointer's ray begins, in the order of the numbers for it. */
export const BEGINS = ['head', 'left', 'right'] as const;
export type Begin = (typeof BEGINS)[number];

/** The ray leaves its begin along −z. */
export interface Pointer {
  readonly begin: Begin;
  /** Metres. */
  readonly length: number;
}

/** The parts of a user that others see. */
export interface Body {
  readonly head: Placed;
  readonly left: Placed | null;
  readonly right: Placed | null;
  readonly pointer: Pointer | null;
}

export interface Pose extends Body {
  /** Greater than in each pose before. */
  readonly sequence: number;
  /** The sender's clock, microseconds from any begin. */
  readonly clock: bigint;
  /** The group's users are to acknowledge this pose. */
  readonly isAcknowledged: boolean;
  /** No pose follows until the user moves again. */
  readonly stops: boolean;
}

/** Greatest coordinate, and greatest length of a pointer, metres. */
export const FARTHEST = 1e6;
/** The number that 1 is in a rotation. */
const ONE = 32767;
/** Squares of the least and the greatest length of a rotation, as float32. */
const [SHORTEST, LONGEST] = [Math.fround(0.81), Math.fround(1.21)] as const;
const FLAGS = { acknowledged: 1, stops: 2, left: 4, right: 8 } as const;
/** Place of the pointer's two flags, and all flags that have a meaning. */
const [POINTER, KNOWN] = [4, 0b11_1111] as const;

/** Read a pose that takes all bytes of a body. */
export function readPose(body: Reader): Pose {
  const [sequence, clock, flags] = [body.u32(), body.u64(), body.u8()];
  if ((flags & ~KNOWN) !== 0) throw new FrameError('a pose has flags without a meaning');
  const head = readPlaced(body);
  const left = flags & FLAGS.left ? readPlaced(body) : null;
  const right = flags & FLAGS.right ? readPlaced(body) : null;
  const begin = BEGINS[(flags >> POINTER) - 1];
  const hands = { head, left, right };
  if (begin && !hands[begin]) throw new FrameError('a pointer begins at no hand');
  const pointer = begin ? { begin, length: readLength(body) } : null;
  body.end('a pose is too long');
  const [isAcknowledged, stops] = [(flags & FLAGS.acknowledged) !== 0, (flags & FLAGS.stops) !== 0];
  return { sequence, clock, isAcknowledged, stops, ...hands, pointer };
}

export function writePose(out: Writer, pose: Pose): void {
  const { left, right, pointer } = pose;
  const set = [
    pose.isAcknowledged ? FLAGS.acknowledged : 0,
    pose.stops ? FLAGS.stops : 0,
    left ? FLAGS.left : 0,
    right ? FLAGS.right : 0,
    pointer ? (1 + BEGINS.indexOf(pointer.begin)) << POINTER : 0,
  ];
  out.u32(pose.sequence);
  out.u64(pose.clock);
  out.u8(set.reduce((flags, flag) => flags | flag));
  for (const placed of [pose.head, left, right]) if (placed) writePlaced(out, placed);
  if (pointer) out.f32(pointer.length);
}

/** Whether a frame may hold a position. */
export function isWithin(position: Vector): boolean {
  return position.every((value) => Math.abs(value) <= FARTHEST);
}

function readPlaced(body: Reader): Placed {
  const position = [body.f32(), body.f32(), body.f32()] as const;
  const parts = [body.i16(), body.i16(), body.i16(), body.i16()] as const;
  // Not-a-number is in no range.
  if (!isWithin(position)) throw new FrameError('a position is none');
  const rotation = parts.map((part) => Math.fround(part / ONE)) as unknown as Rotation;
  // In float32, as the server adds.
  const square = rotation.reduce((sum, part) => Math.fround(sum + Math.fround(part * part)), 0);
  if (!(square >= SHORTEST && square <= LONGEST)) throw new FrameError('a rotation is no unit quaternion');
  return { position, rotation };
}

function writePlaced(out: Writer, { position, rotation }: Placed): void {
  for (const value of position) out.f32(value);
  for (const part of rotation) out.i16(Math.round(ONE * part));
}

function readLength(body: Reader): number {
  const length = body.f32();
  if (!(length >= 0 && length <= FARTHEST)) throw new FrameError("a pointer's length is none");
  return length;
}
