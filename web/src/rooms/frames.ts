/** Binary frames of rooms: kind, length of the body, and body. docs/rooms.md has a table of every field. */
import { FrameError, Reader, textOf, Writer } from './bytes';
import { type Pose, readPose, writePose } from './pose';

/** Protocol version of all frames. */
const VERSION = 1;
/** Greatest number of bytes of a user's name, of a `say` payload and of a signal. */
export const NAME = 64;
const [SAY, SIGNAL] = [1 << 12, 1 << 14] as const;

const KINDS = { hello: 1, pose: 2, ack: 3, say: 4, signal: 5, bye: 6 } as const;
/** Kinds of the server's frames. */
export const SERVER = {
  welcome: 129,
  pose: 130,
  settled: 131,
  say: 132,
  signal: 133,
  joined: 134,
  left: 135,
  refused: 136,
} as const;

/** Recipients of a `say` frame, in the order of their codes. */
const AUDIENCES = ['group', 'room'] as const;
export type Audience = (typeof AUDIENCES)[number];

/** Frame from a user. */
export type FromUser =
  | { readonly kind: 'hello'; readonly group: number; readonly name: string; readonly ticket: Uint8Array }
  | { readonly kind: 'pose'; readonly pose: Pose }
  | { readonly kind: 'ack'; readonly user: number; readonly sequence: number }
  | { readonly kind: 'signal'; readonly user: number; readonly payload: Uint8Array }
  | { readonly kind: 'say'; readonly to: Audience; readonly payload: Uint8Array }
  | { readonly kind: 'bye' };

/** Frame from the server. */
export type FromServer =
  | { readonly kind: 'welcome'; readonly user: number; readonly others: number; readonly ticket: Uint8Array }
  | { readonly kind: 'pose'; readonly user: number; readonly pose: Pose }
  | { readonly kind: 'settled'; readonly sequence: number }
  | { readonly kind: 'say'; readonly user: number; readonly to: Audience; readonly payload: Uint8Array }
  | { readonly kind: 'signal'; readonly user: number; readonly payload: Uint8Array }
  | { readonly kind: 'joined'; readonly user: number; readonly group: number; readonly name: string }
  | { readonly kind: 'left'; readonly user: number }
  | { readonly kind: 'refused'; readonly reason: number; readonly sentence: string };

/** Parses all frames of a message from the server; throws `FrameError` if one is malformed. */
export function readMessage(message: Uint8Array): FromServer[] {
  const frames: FromServer[] = [];
  const bytes = new Reader(message);
  while (!bytes.isAtEnd) {
    const [kind, length] = [bytes.u8(), bytes.u16()];
    frames.push(readFrame(kind, new Reader(bytes.take(length))));
  }
  return frames;
}

function readFrame(kind: number, body: Reader): FromServer {
  const frame = readBody(kind, body);
  body.expectEnd();
  return frame;
}

function readBody(kind: number, body: Reader): FromServer {
  switch (kind) {
    case SERVER.welcome:
      return { kind: 'welcome', user: body.u16(), others: body.u16(), ticket: body.take(body.u8()).slice() };
    case SERVER.pose:
      return { kind: 'pose', user: body.u16(), pose: readPose(body) };
    case SERVER.settled:
      return { kind: 'settled', sequence: body.u32() };
    case SERVER.say:
      return { kind: 'say', user: body.u16(), to: readTo(body), payload: body.takeRest(SAY).slice() };
    case SERVER.signal:
      return { kind: 'signal', user: body.u16(), payload: body.takeRest(SIGNAL).slice() };
    case SERVER.joined:
      return { kind: 'joined', user: body.u16(), group: body.u16(), name: readName(body) };
    case SERVER.left:
      return { kind: 'left', user: body.u16() };
    case SERVER.refused:
      return { kind: 'refused', reason: body.u8(), sentence: textOf(body.takeRest(SAY), 'a sentence is not UTF-8') };
    default:
      throw new FrameError('a frame has an unknown kind');
  }
}

/**
 * Serializes a frame; throws `FrameError` for an invalid name or ticket in a hello, and for a payload that is too long.
 */
export function writeFrame(frame: FromUser): Uint8Array<ArrayBuffer> {
  const body = new Writer();
  if (frame.kind === 'hello') {
    body.u8(VERSION);
    body.u16(frame.group);
    const name = new TextEncoder().encode(checkName(frame.name));
    for (const bytes of [name, frame.ticket]) {
      if (bytes.length > 0xff) throw new FrameError('a ticket is too long');
      body.u8(bytes.length);
      body.put(bytes);
    }
  } else if (frame.kind === 'pose') {
    writePose(body, frame.pose);
  } else if (frame.kind === 'ack') {
    body.u16(frame.user);
    body.u32(frame.sequence);
  } else if (frame.kind === 'signal') {
    if (frame.payload.length > SIGNAL) throw new FrameError('a payload is too long');
    body.u16(frame.user);
    body.put(frame.payload);
  } else if (frame.kind === 'say') {
    if (frame.payload.length > SAY) throw new FrameError('a payload is too long');
    body.u8(AUDIENCES.indexOf(frame.to));
    body.put(frame.payload);
  }
  const out = new Writer();
  out.u8(KINDS[frame.kind]);
  out.u16(body.length);
  out.put(body.toBytes());
  return out.toBytes();
}

function readTo(body: Reader): Audience {
  const to = AUDIENCES[body.u8()];
  if (!to) throw new FrameError('expected the group or the room');
  return to;
}

function readName(body: Reader): string {
  return checkName(textOf(body.take(body.u8()), 'a name is not UTF-8'));
}

/** Characters forbidden in names: control characters, and format characters, which are invisible or reorder text. */
export const HIDDEN = /[\p{Cc}\p{Cf}]/u;

function checkName(name: string): string {
  if (new TextEncoder().encode(name).length > NAME) throw new FrameError('a name is too long');
  if (HIDDEN.test(name)) throw new FrameError('a name has characters that control or format text');
  return name;
}
