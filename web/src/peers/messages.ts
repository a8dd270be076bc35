/** Binary messages between two pages. docs/peers.md has a table of every field. */
import { bytesOf, hexOf } from '../base/bytes';
import { FrameError, Reader, Writer } from '../rooms/bytes';

/** Bytes per part of a file; the last part may be shorter. */
export const PART = 16_384;
/** Greatest number of files per `tell` message. */
export const MAX_FILES_PER_MESSAGE = 500;
/** Bytes of a key, which is the SHA-256 of a file's content. */
const KEY = 32;
/** Bytes of the header: message kind and request number. */
const HEAD = 5;
/** Greatest size of a message, bytes. */
const MAX_BYTES = HEAD + PART;

/** State of a file on a page: present, being received from the server, or neither. */
export type Holding = 'here' | 'coming' | 'gone';
const HOLDINGS = ['gone', 'coming', 'here'] as const;
const KINDS = { tell: 1, want: 2, part: 3, wait: 4, none: 5, cancel: 6 } as const;

/** Message with keys as hexadecimal digits and request numbers chosen by the requesting page. */
export type Message =
  | { readonly kind: 'tell'; readonly holding: Holding; readonly keys: readonly string[] }
  | { readonly kind: 'want'; readonly request: number; readonly key: string }
  | { readonly kind: 'part'; readonly request: number; readonly data: Uint8Array }
  /** The file is still being received; `bytes` of it are present. */
  | { readonly kind: 'wait'; readonly request: number; readonly bytes: number }
  /** Ends a request: no more data of the file follow. */
  | { readonly kind: 'none'; readonly request: number }
  | { readonly kind: 'cancel'; readonly request: number };

/** Parses a message; throws `FrameError` if it is malformed. */
export function readMessage(bytes: Uint8Array): Message {
  if (bytes.length > MAX_BYTES) throw new FrameError('a message is too long');
  const reader = new Reader(bytes);
  const message = readBody(reader.u8(), reader);
  reader.expectEnd('a message is too long');
  return message;
}

function readBody(kind: number, reader: Reader): Message {
  switch (kind) {
    case KINDS.tell: {
      const holding = HOLDINGS[reader.u8()];
      if (!holding) throw new FrameError('a file has an unknown state');
      const keys: string[] = [];
      while (!reader.isAtEnd && keys.length <= MAX_FILES_PER_MESSAGE) keys.push(hexOf(reader.take(KEY)));
      return { kind: 'tell', holding, keys };
    }
    case KINDS.want:
      return { kind: 'want', request: reader.u32(), key: hexOf(reader.take(KEY)) };
    case KINDS.part:
      return { kind: 'part', request: reader.u32(), data: reader.takeRest(PART) };
    case KINDS.wait:
      return { kind: 'wait', request: reader.u32(), bytes: reader.u32() };
    case KINDS.none:
      return { kind: 'none', request: reader.u32() };
    case KINDS.cancel:
      return { kind: 'cancel', request: reader.u32() };
    default:
      throw new FrameError('a message has an unknown kind');
  }
}

export function writeMessage(message: Message): Uint8Array<ArrayBuffer> {
  if (message.kind === 'part') return writePart(message.request, message.data);
  const out = new Writer();
  out.u8(KINDS[message.kind]);
  if (message.kind === 'tell') {
    out.u8(HOLDINGS.indexOf(message.holding));
    for (const key of message.keys) out.put(bytesOf(key));
    return out.toBytes();
  }
  out.u32(message.request);
  if (message.kind === 'want') out.put(bytesOf(message.key));
  if (message.kind === 'wait') out.u32(message.bytes);
  return out.toBytes();
}

/** Writes a part with one copy instead of byte by byte. */
function writePart(request: number, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(HEAD + data.length);
  bytes[0] = KINDS.part;
  new DataView(bytes.buffer).setUint32(1, request, true);
  bytes.set(data, HEAD);
  return bytes;
}
