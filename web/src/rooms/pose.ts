/** Binary poses of a user's head, hands and pointer (the second table of docs/rooms.md), and their interpolation. */
import type { Vector } from '../control/pose';
import { checked, type Codec, F32, FrameError, I16, record, tuple, U32, U64, U8 } from './bytes';

/** Unit quaternion (x, y, z, w). */
export type Rotation = readonly [number, number, number, number];

export interface Placed {
  /** Metres from the scene's origin. */
  readonly position: Vector;
  readonly rotation: Rotation;
}

/** Origins of a pointer's ray, in the order of their codes. */
const BEGINS = ['head', 'left', 'right'] as const;
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
const ROTATION_SCALE = 32767;
/** Least and greatest squared norm of a rotation, as float32. */
const [MIN_NORM, MAX_NORM] = [Math.fround(0.81), Math.fround(1.21)] as const;
const FLAGS = { acknowledged: 1, stops: 2, left: 4, right: 8 } as const;
/** Bit offset of the pointer's two flags; mask of all defined flags. */
const [POINTER_SHIFT, KNOWN_FLAGS] = [4, 0b11_1111] as const;

/** Whether a frame can encode a position. */
export function isWithin(position: Vector): boolean {
  return position.every((value) => Math.abs(value) <= FARTHEST);
}

const ROTATION_PART: Codec<number> = {
  read: (from) => Math.fround(I16.read(from) / ROTATION_SCALE),
  write: (out, part) => I16.write(out, Math.round(ROTATION_SCALE * part)),
};
const PLACED_FIELDS = record<Placed>({
  position: tuple(F32, F32, F32),
  rotation: tuple(ROTATION_PART, ROTATION_PART, ROTATION_PART, ROTATION_PART),
});
// NaN fails these tests, too.
const PLACED = checked(PLACED_FIELDS, ({ position, rotation }) => {
  if (!isWithin(position)) throw new FrameError('a position is out of range');
  // Sum in float32, like the server's.
  const norm = rotation.reduce((sum, part) => Math.fround(sum + Math.fround(part * part)), 0);
  if (!(norm >= MIN_NORM && norm <= MAX_NORM)) throw new FrameError('a rotation is not a unit quaternion');
});
const LENGTH = checked(F32, (length) => {
  if (!(length >= 0 && length <= FARTHEST)) throw new FrameError("a pointer's length is out of range");
});

export const POSE: Codec<Pose> = {
  read(from) {
    const [sequence, clock, flags] = [U32.read(from), U64.read(from), U8.read(from)];
    if ((flags & ~KNOWN_FLAGS) !== 0) throw new FrameError('a pose has unknown flags');
    const head = PLACED.read(from);
    const left = flags & FLAGS.left ? PLACED.read(from) : null;
    const right = flags & FLAGS.right ? PLACED.read(from) : null;
    const begin = BEGINS[(flags >> POINTER_SHIFT) - 1];
    const hands = { head, left, right };
    if (begin && !hands[begin]) throw new FrameError('a pointer begins at a missing hand');
    const pointer = begin ? { begin, length: LENGTH.read(from) } : null;
    const [isAcknowledged, stops] = [(flags & FLAGS.acknowledged) !== 0, (flags & FLAGS.stops) !== 0];
    return { sequence, clock, isAcknowledged, stops, ...hands, pointer };
  },
  write(out, pose) {
    const { left, right, pointer } = pose;
    const flags = [
      pose.isAcknowledged ? FLAGS.acknowledged : 0,
      pose.stops ? FLAGS.stops : 0,
      left ? FLAGS.left : 0,
      right ? FLAGS.right : 0,
      pointer ? (1 + BEGINS.indexOf(pointer.begin)) << POINTER_SHIFT : 0,
    ];
    U32.write(out, pose.sequence);
    U64.write(out, pose.clock);
    U8.write(out, flags.reduce((all, flag) => all | flag));
    for (const placed of [pose.head, left, right]) if (placed) PLACED.write(out, placed);
    if (pointer) LENGTH.write(out, pointer.length);
  },
};

/** Cosine of half an angle above which rotations are interpolated linearly. */
const NEARLY = 0.9995;

/** Rotation of a view with a yaw and a pitch. */
export function rotationOf(yaw: number, pitch: number): Rotation {
  const [sy, cy, sp, cp] = [Math.sin(yaw / 2), Math.cos(yaw / 2), Math.sin(pitch / 2), Math.cos(pitch / 2)];
  return [cy * sp, sy * cp, -sy * sp, cy * cp];
}

/** Upright rotation whose −z points along a direction of any length. */
export function rotationAlong([x, y, z]: Vector): Rotation {
  return rotationOf(Math.atan2(-x, -z), Math.atan2(y, Math.hypot(x, z)));
}

/** Applies a rotation to a vector. */
export function rotate([x, y, z, w]: Rotation, [a, b, c]: Vector): Vector {
  const [tx, ty, tz] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}

/** Interpolates spherically along the shorter arc; shares beyond 1 extrapolate. */
export function slerp(from: Rotation, to: Rotation, share: number): Rotation {
  const dot = from.reduce((sum, part, axis) => sum + part * (to[axis] ?? 0), 0);
  const sign = dot < 0 ? -1 : 1;
  let [a, b] = [1 - share, share];
  if (Math.abs(dot) < NEARLY) {
    const angle = Math.acos(Math.abs(dot));
    [a, b] = [Math.sin((1 - share) * angle) / Math.sin(angle), Math.sin(share * angle) / Math.sin(angle)];
  }
  const mixed = from.map((part, axis) => a * part + sign * b * (to[axis] ?? 0));
  const size = Math.hypot(...mixed) || 1;
  return mixed.map((part) => part / size) as unknown as Rotation;
}

/** Interpolates between two bodies; shares beyond 1 extrapolate, except hands and pointers. */
export function between(from: Body, to: Body, share: number): Body {
  const later = share < 0.5 ? from : to;
  const hand = (side: 'left' | 'right'): Placed | null => {
    const [a, b] = [from[side], to[side]];
    return a && b ? placedBetween(a, b, Math.min(share, 1)) : later[side];
  };
  return {
    head: placedBetween(from.head, to.head, share),
    left: hand('left'),
    right: hand('right'),
    pointer: pointerBetween(from.pointer, to.pointer, Math.min(share, 1)),
  };
}

function placedBetween(from: Placed, to: Placed, share: number): Placed {
  const position = from.position.map((value, axis) => value + share * ((to.position[axis] ?? 0) - value));
  return { position: position as unknown as Vector, rotation: slerp(from.rotation, to.rotation, share) };
}

function pointerBetween(from: Pointer | null, to: Pointer | null, share: number): Pointer | null {
  if (from?.begin !== to?.begin || !from || !to) return share < 0.5 ? from : to;
  return { begin: to.begin, length: from.length + share * (to.length - from.length) };
}
