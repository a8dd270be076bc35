/** Binary poses of a user's head, hands and pointer: the second table of docs/rooms.md. */
import type { Vector } from '../control/vector';
import { FrameError, type Reader, type Writer } from './bytes';

/** Unit quaternion (x, y, z, w). */
export type Rotation = readonly [number, number, number, number];

export interface Placed {
  /** Metres from the scene's origin. */
  readonly position: Vector;
  readonly rotation: Rotation;
}

/** Origins of a pointer's ray, in the order of their codes. */
export const BEGINS = ['head', 'left', 'right'] as const;
export type Begin = (typeof BEGINS)[number];

/** Pointer along −z of its origin. */
export interface Pointer {
  readonly begin: Begin;
  /** Length in metres. */
  readonly length: number;
}

/** Parts of a user that others see. */
export interface Body {
  readonly head: Placed;
  readonly left: Placed | null;
  readonly right: Placed | null;
  readonly pointer: Pointer | null;
}

export interface Pose extends Body {
  /** Sequence number, greater than in all earlier poses. */
  readonly sequence: number;
  /** Sender's clock, microseconds since an arbitrary origin. */
  readonly clock: bigint;
  /** Whether the users of the group acknowledge this pose. */
  readonly isAcknowledged: boolean;
  /** Whether no pose follows until the user moves again. */
  readonly stops: boolean;
}

/** Greatest coordinate and greatest length of a pointer, metres. */
export const FARTHEST = 1e6;
/** Fixed-point value of 1 in a rotation. */
const ONE = 32767;
/** Least and greatest squared norm of a rotation, as float32. */
const [SHORTEST, LONGEST] = [Math.fround(0.81), Math.fround(1.21)] as const;
const FLAGS = { acknowledged: 1, stops: 2, left: 4, right: 8 } as const;
/** Bit offset of the pointer's two flags; mask of all defined flags. */
const [POINTER, KNOWN] = [4, 0b11_1111] as const;

/** Reads a pose that fills the whole body. */
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

/** Whether a frame can encode a position. */
export function isWithin(position: Vector): boolean {
  return position.every((value) => Math.abs(value) <= FARTHEST);
}

function readPlaced(body: Reader): Placed {
  const position = [body.f32(), body.f32(), body.f32()] as const;
  const parts = [body.i16(), body.i16(), body.i16(), body.i16()] as const;
  // NaN fails the test, too.
  if (!isWithin(position)) throw new FrameError('a position is none');
  const rotation = parts.map((part) => Math.fround(part / ONE)) as unknown as Rotation;
  // Sum in float32, like the server's.
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
