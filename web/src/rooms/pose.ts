/** Poses of a user's head, hands and pointer: their binary codec (second table of docs/rooms.md), and interpolation. */
import { Euler, Quaternion, type QuaternionTuple, Vector3, type Vector3Tuple } from 'three';
import { addScaled, subtract, type Vector } from '../control/pose';
import { withCheck, type Codec, F32, FrameError, I16, record, tuple, U32, U64, U8 } from './bytes';

/** Unit quaternion (x, y, z, w). */
export type Rotation = readonly [number, number, number, number];

/** Position and rotation of a part of the body. */
export interface Placement {
  /** Metres from the scene's origin. */
  readonly position: Vector;
  readonly rotation: Rotation;
}

/** Origins of a pointer's ray, in the order of their codes. */
const POINTER_ORIGINS = ['head', 'left', 'right'] as const;
export type PointerOrigin = (typeof POINTER_ORIGINS)[number];

/** Pointer along −z of the head or of a hand. */
export interface Pointer {
  readonly begin: PointerOrigin;
  /** Length in metres. */
  readonly length: number;
}

/** Parts of a user's body that others see. */
export interface Body {
  readonly head: Placement;
  readonly left: Placement | null;
  readonly right: Placement | null;
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
export const MAX_COORDINATE = 1e6;
/** Integer that encodes 1 in a rotation. */
const ROTATION_SCALE = 32767;
/** Least and greatest squared norm of a rotation, as float32. */
const [MIN_NORM, MAX_NORM] = [Math.fround(0.81), Math.fround(1.21)] as const;
const FLAGS = { acknowledged: 1, stops: 2, left: 4, right: 8 } as const;
/** Bit offset of the pointer's two bits; mask of all defined flags. */
const [POINTER_SHIFT, KNOWN_FLAGS] = [4, 0b11_1111] as const;

/** Whether frames can encode a position. */
export function isInRange(position: Vector): boolean {
  return position.every((value) => Math.abs(value) <= MAX_COORDINATE);
}

const ROTATION_PART: Codec<number> = {
  read: (from) => Math.fround(I16.read(from) / ROTATION_SCALE),
  write: (out, part) => I16.write(out, Math.round(ROTATION_SCALE * part)),
};
const PLACEMENT_FIELDS = record<Placement>({
  position: tuple(F32, F32, F32),
  rotation: tuple(ROTATION_PART, ROTATION_PART, ROTATION_PART, ROTATION_PART),
});
// NaN fails these tests, too.
const PLACEMENT = withCheck(PLACEMENT_FIELDS, ({ position, rotation }) => {
  if (!isInRange(position)) throw new FrameError('a position is out of range');
  // The sum is computed in float32, as in the server.
  const norm = rotation.reduce((sum, part) => Math.fround(sum + Math.fround(part * part)), 0);
  if (!(norm >= MIN_NORM && norm <= MAX_NORM)) throw new FrameError('a rotation is not a unit quaternion');
});
const LENGTH = withCheck(F32, (length) => {
  if (!(length >= 0 && length <= MAX_COORDINATE)) throw new FrameError("a pointer's length is out of range");
});

export const POSE: Codec<Pose> = {
  read(from) {
    const [sequence, clock, flags] = [U32.read(from), U64.read(from), U8.read(from)];
    if ((flags & ~KNOWN_FLAGS) !== 0) throw new FrameError('a pose has unknown flags');
    const head = PLACEMENT.read(from);
    const left = flags & FLAGS.left ? PLACEMENT.read(from) : null;
    const right = flags & FLAGS.right ? PLACEMENT.read(from) : null;
    const begin = POINTER_ORIGINS[(flags >> POINTER_SHIFT) - 1];
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
      pointer ? (1 + POINTER_ORIGINS.indexOf(pointer.begin)) << POINTER_SHIFT : 0,
    ];
    U32.write(out, pose.sequence);
    U64.write(out, pose.clock);
    U8.write(out, flags.reduce((all, flag) => all | flag));
    for (const part of [pose.head, left, right]) if (part) PLACEMENT.write(out, part);
    if (pointer) LENGTH.write(out, pointer.length);
  },
};

/** Rotation of a view with a yaw and a pitch. */
export function rotationOf(yaw: number, pitch: number): Rotation {
  return new Quaternion().setFromEuler(new Euler(pitch, yaw, 0, 'YXZ')).toArray() as QuaternionTuple;
}

/** Upright rotation with −z along a direction, which may have any length. */
export function rotationAlong([x, y, z]: Vector): Rotation {
  return rotationOf(Math.atan2(-x, -z), Math.atan2(y, Math.hypot(x, z)));
}

export function rotate(rotation: Rotation, vector: Vector): Vector {
  return new Vector3(...vector).applyQuaternion(new Quaternion(...rotation)).toArray() as Vector3Tuple;
}

/** Interpolates spherically along the shorter arc; fractions beyond 1 extrapolate. */
export function slerp(from: Rotation, to: Rotation, fraction: number): Rotation {
  return new Quaternion(...from).slerp(new Quaternion(...to), fraction).normalize().toArray() as QuaternionTuple;
}

/** Interpolates between two bodies; fractions beyond 1 extrapolate, except hands and pointers. */
export function interpolateBodies(from: Body, to: Body, fraction: number): Body {
  const nearer = fraction < 0.5 ? from : to;
  const hand = (side: 'left' | 'right'): Placement | null => {
    const [a, b] = [from[side], to[side]];
    return a && b ? interpolatePlacements(a, b, Math.min(fraction, 1)) : nearer[side];
  };
  const [a, b] = [from.pointer, to.pointer];
  const isSameOrigin = a !== null && b !== null && a.begin === b.begin;
  const length = (a?.length ?? 0) + Math.min(fraction, 1) * ((b?.length ?? 0) - (a?.length ?? 0));
  return {
    head: interpolatePlacements(from.head, to.head, fraction),
    left: hand('left'),
    right: hand('right'),
    pointer: isSameOrigin ? { begin: b.begin, length } : nearer.pointer,
  };
}

function interpolatePlacements(from: Placement, to: Placement, fraction: number): Placement {
  const position = addScaled(from.position, subtract(to.position, from.position), fraction);
  return { position, rotation: slerp(from.rotation, to.rotation, fraction) };
}
