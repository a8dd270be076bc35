/** Checks and packed numbers of a store's documents. */
import { damaged, StoreError } from './error';
import { fields } from './layout';
import type { Bytes } from './files';

/** Hexadecimal SHA-256; null where the browser offers none: on pages without https, but for this machine's. */
export async function sha256(bytes: Bytes): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** Little-endian uint32 numbers of base64 of zlib; `length` of them are expected. */
export async function numbersOf(text: unknown, length: number, file: string): Promise<Uint32Array> {
  const packed = bytesOf(text, file);
  const found = new Uint8Array(4 * length);
  let filled = 0;
  try {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    const reader = stream.getReader();
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
      // No more than is expected: a damaged text may unpack to any length.
      if (filled + next.value.length > found.length) throw new RangeError('more numbers than cells');
      found.set(next.value, filled);
      filled += next.value.length;
    }
  } catch (reason) {
    throw damaged(file, `views: ${reason instanceof Error ? reason.message : reason}`);
  }
  if (filled !== found.length) throw damaged(file, `views: expected ${found.length} bytes, got ${filled}`);
  const view = new DataView(found.buffer);
  return Uint32Array.from({ length }, (_, at) => view.getUint32(4 * at, true));
}

function bytesOf(text: unknown, file: string): Bytes {
  try {
    if (typeof text !== 'string') throw new TypeError('no text');
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw damaged(file, 'views: expected base64');
  }
}

/** The object of a JSON document of a kind and a version. */
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
  return checked(fields(found, file), file, kind, version);
}

/** The same object, if it says that it is of a kind and a version. */
export function checked(
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
