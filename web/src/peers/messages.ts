/** Binary messages between two pages. docs/peers.md has a table of every field. */
import { bytesOf, hexOf } from '../base/bytes';
import { choiceOf, type Codec, decode, encode, FrameError, kindsOf, type MessageOf, payload, record, U32 } from '../rooms/bytes';

/** Bytes per part of a file; the last part may be shorter. */
export const PART = 16_384;
/** Greatest number of files per `tell` message. */
export const MAX_FILES_PER_MESSAGE = 500;
/** Bytes of a key, which is the SHA-256 of a file's content. */
const KEY_BYTES = 32;
/** Greatest size of a message, bytes: a kind, the number of a request, and a part. */
const MAX_BYTES = 5 + PART;

/** State of a file on a page: present, being received from the server, or neither. */
export type Holding = 'here' | 'coming' | 'gone';
const holding = choiceOf<Holding>(['gone', 'coming', 'here'], 'a file has an unknown state');

/** Key as hexadecimal digits. */
const key: Codec<string> = {
  read: (from) => hexOf(from.take(KEY_BYTES)),
  write: (out, digits) => out.put(bytesOf(digits)),
};
const keys: Codec<readonly string[]> = {
  read(from) {
    const found: string[] = [];
    while (from.remaining > 0 && found.length <= MAX_FILES_PER_MESSAGE) found.push(key.read(from));
    return found;
  },
  write: (out, all) => all.forEach((each) => key.write(out, each)),
};

/** Codes and bodies of messages; the page that sends a request chooses its number. */
const KINDS = {
  tell: [1, record({ holding, keys })],
  want: [2, record({ request: U32, key })],
  part: [3, record({ request: U32, data: payload(PART) })],
  /** The file is still being received; `bytes` of it are present. */
  wait: [4, record({ request: U32, bytes: U32 })],
  /** Ends a request: no more data of the file follow. */
  none: [5, record({ request: U32 })],
  cancel: [6, record({ request: U32 })],
} as const;
export type Message = MessageOf<typeof KINDS>;
const MESSAGE = kindsOf(KINDS, 'a message has an unknown kind');

/** Parses a message; throws `FrameError` if it is malformed. */
export function readMessage(bytes: Uint8Array): Message {
  if (bytes.length > MAX_BYTES) throw new FrameError('a message is too long');
  return decode(MESSAGE, bytes, 'a message is too long');
}

export function writeMessage(message: Message): Uint8Array<ArrayBuffer> {
  return encode(MESSAGE, message);
}
