/** Checks and decompression of a bundle's files. */
import { sha256 as hashOf } from '../hex';
import type { FileData } from './messages';

/** Content of a file, checked against the manifest's size and hash. */
export async function contentOf(file: FileData): Promise<Uint8Array<ArrayBuffer>> {
  const { name, data, bytes, sha256 } = file;
  if (data.byteLength !== bytes) {
    throw new Error(`${name}: expected ${bytes} bytes, as the manifest lists it, got ${data.byteLength}`);
  }
  // Browsers offer hashes only on https and localhost; elsewhere only the size is checked.
  const found = await hashOf(data);
  if (found !== null && found !== sha256) {
    throw new Error(`${name}: expected SHA-256 ${sha256.slice(0, 16)}…, got ${found.slice(0, 16)}…`);
  }
  return new Uint8Array(data);
}

/** Message of an error. */
export function reasonOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** Decompresses a zlib stream to at most `most` bytes. */
export async function inflated(name: string, data: Uint8Array<ArrayBuffer>, most: number): Promise<Uint8Array> {
  const parts: Uint8Array[] = [];
  let size = 0;
  try {
    const stream = new Blob([data]).stream().pipeThrough(new DecompressionStream('deflate'));
    for (const reader = stream.getReader(); ; ) {
      const { done, value } = await reader.read();
      if (done) break;
      parts.push(value);
      size += value.length;
      if (size > most) {
        await reader.cancel();
        throw new Error(`more than ${most} bytes`);
      }
    }
  } catch (error) {
    throw new Error(`${name}: expected compressed ranges, got ${reasonOf(error)}`);
  }
  const whole = new Uint8Array(size);
  let place = 0;
  for (const part of parts) {
    whole.set(part, place);
    place += part.length;
  }
  return whole;
}
