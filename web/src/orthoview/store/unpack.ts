/** Validation and decompression of a store's documents. */
import { inflated } from '../../base/bytes';
import { messageOf } from '../../base/errors';
import { damaged, StoreError } from './error';
import { fields } from './layout';
import type { Bytes } from './files';

/** Greatest decompressed size of a list of guests. */
const MAX_BYTES = 2 ** 26;

/** Decodes little-endian uint32 numbers from base64 of zlib; throws an error if there are not `length`. */
export async function numbersOf(text: unknown, length: number, file: string): Promise<Uint32Array> {
  const found = await decodeZlib(text, 4 * length, 'views', file);
  if (found.length !== 4 * length) throw damaged(file, `views: expected ${4 * length} bytes, got ${found.length}`);
  return wordsOf(found);
}

/** Decodes rows of `width` numbers in the same encoding, of any count. */
export async function rowsOf(text: unknown, width: number, file: string): Promise<Uint32Array> {
  const found = await decodeZlib(text, MAX_BYTES, 'guests', file);
  if (found.length % (4 * width) !== 0) throw damaged(file, `guests: expected rows, got ${found.length} bytes`);
  return wordsOf(found);
}

function wordsOf(bytes: Bytes): Uint32Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return Uint32Array.from({ length: bytes.length / 4 }, (_, at) => view.getUint32(4 * at, true));
}

/** Decompresses at most the expected size: damaged data may decompress to any length. */
async function decodeZlib(text: unknown, most: number, what: string, file: string): Promise<Bytes> {
  const packed = bytesOf(text, what, file);
  try {
    return await inflated(packed, most);
  } catch (reason) {
    throw damaged(file, `${what}: ${messageOf(reason)}`);
  }
}

function bytesOf(text: unknown, what: string, file: string): Bytes {
  try {
    if (typeof text !== 'string') throw new TypeError('no text');
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw damaged(file, `${what}: expected base64`);
  }
}

/** Parses a JSON document and checks its kind and version. */
export function documentOf(
  bytes: Bytes,
  file: string,
  kind: string,
  version: number,
): Readonly<Record<string, unknown>> {
  let found: unknown;
  try {
    found = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw damaged(file, 'expected JSON');
  }
  return checkFormat(fields(found, file), file, kind, version);
}

/** Returns the object if its kind and version match. */
export function checkFormat(
  found: Readonly<Record<string, unknown>>,
  file: string,
  kind: string,
  version: number,
): Readonly<Record<string, unknown>> {
  if (found['format'] !== `nearfar.${kind}`) throw damaged(file, `expected a document nearfar.${kind}`);
  if (found['version'] !== version)
    throw new StoreError('newer', `${file}: version ${JSON.stringify(found['version'])}`);
  return found;
}
