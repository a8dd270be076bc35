/** Binary frames of rooms: kind, length of the body, and body. docs/rooms.md has a table of every field. */
import {
  withCheck,
  choiceOf,
  type Codec,
  encode,
  FrameError,
  kindsOf,
  type MessageOf,
  payload,
  withPrefix,
  Reader,
  record,
  shortBytes,
  U16,
  U32,
  U8,
  utf8,
} from './bytes';
import { POSE } from './pose';

/** Protocol version of all frames. */
const VERSION = 1;
/** Greatest number of bytes of a user's name, of a `say` frame's payload, and of a signal. */
export const MAX_NAME_BYTES = 64;
const [MAX_SAY_BYTES, MAX_SIGNAL_BYTES] = [1 << 12, 1 << 14] as const;
/**
 * Characters that names must not have: control characters, and format characters, which are invisible or reorder text.
 */
export const FORBIDDEN = /[\p{Cc}\p{Cf}]/u;

function checkName(text: string): void {
  if (new TextEncoder().encode(text).length > MAX_NAME_BYTES) throw new FrameError('a name is too long');
  if (FORBIDDEN.test(text)) throw new FrameError('a name has characters that control or format text');
}

const name = withCheck(utf8(shortBytes('a name is too long'), 'a name is not UTF-8'), checkName);
const ticket = shortBytes('a ticket is too long');
const sentence = utf8(payload(MAX_SAY_BYTES), 'a sentence is not UTF-8');
/** Recipients of a `say` frame. */
const to = choiceOf(['group', 'room'], 'expected the group or the room');
const [sayPayload, signalPayload] = [payload(MAX_SAY_BYTES), payload(MAX_SIGNAL_BYTES)];

/** Frames that users send. */
const USER_KINDS = {
  hello: [1, withLength(withPrefix(VERSION, 'a hello has another version', record({ group: U16, name, ticket })))],
  pose: [2, withLength(record({ pose: POSE }))],
  ack: [3, withLength(record({ user: U16, sequence: U32 }))],
  say: [4, withLength(record({ to, payload: sayPayload }))],
  signal: [5, withLength(record({ user: U16, payload: signalPayload }))],
  bye: [6, withLength(record({}))],
} as const;
export type FromUser = MessageOf<typeof USER_KINDS>;
const USER_FRAME = kindsOf(USER_KINDS, 'a frame has an unknown kind');

/** Frames that the server sends. */
const SERVER_KINDS = {
  welcome: [129, withLength(record({ user: U16, others: U16, ticket }))],
  pose: [130, withLength(record({ user: U16, pose: POSE }))],
  settled: [131, withLength(record({ sequence: U32 }))],
  say: [132, withLength(record({ user: U16, to, payload: sayPayload }))],
  signal: [133, withLength(record({ user: U16, payload: signalPayload }))],
  joined: [134, withLength(record({ user: U16, group: U16, name }))],
  left: [135, withLength(record({ user: U16 }))],
  refused: [136, withLength(record({ reason: U8, sentence }))],
} as const;
export type FromServer = MessageOf<typeof SERVER_KINDS>;
export const SERVER_FRAME = kindsOf(SERVER_KINDS, 'a frame has an unknown kind');

export type Audience = (FromUser & { readonly kind: 'say' })['to'];

/** Codec of a value after the number of its bytes. */
function withLength<Value>(codec: Codec<Value>): Codec<Value> {
  return {
    read(from) {
      const body = new Reader(from.take(U16.read(from)));
      const value = codec.read(body);
      body.expectEnd();
      return value;
    },
    write(out, value) {
      const body = encode(codec, value);
      U16.write(out, body.length);
      out.put(body);
    },
  };
}

/** Parses all frames of a message from the server; throws `FrameError` if one is malformed. */
export function readMessage(message: Uint8Array): FromServer[] {
  const frames: FromServer[] = [];
  const reader = new Reader(message);
  while (reader.remaining > 0) frames.push(SERVER_FRAME.read(reader));
  return frames;
}

/** Writes a frame; throws `FrameError` for an invalid name or ticket in a hello, and for a payload that is too long. */
export function writeFrame(frame: FromUser): Uint8Array<ArrayBuffer> {
  if (frame.kind === 'hello') checkName(frame.name);
  return encode(USER_FRAME, frame);
}
