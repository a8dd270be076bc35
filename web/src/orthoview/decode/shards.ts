/** Reads chunks of views as byte ranges of shards, or from whole shards if the server ignores range requests. */
import { LruCache } from '../../base/cache';
import { damagedError } from '../store/error';
import type { Bytes, Files } from '../store/files';
import type { StoredFile } from '../store/records';

/** Size of the cache of whole shards, bytes. */
const CACHE_BYTES = 1 << 25;

export class Shards {
  /** Cache of whole shards, if the server ignores range requests. */
  readonly #whole = new LruCache<Promise<Bytes>>(CACHE_BYTES);
  #sendsWholeFiles = false;

  constructor(readonly files: Files) {}

  async read(file: StoredFile, [first, length]: readonly [number, number], signal: AbortSignal): Promise<Bytes> {
    const [path, size, version] = file;
    const known = this.#whole.get(path);
    const whole = known ?? (this.#sendsWholeFiles ? this.#keep(file, this.#readWhole(file)) : null);
    // A copy, because a subarray would keep the whole shard in memory.
    if (whole) return (await whole).slice(first, first + length);
    const { bytes, isWhole } = await this.files.read({ path, version, part: [first, length], signal });
    if (isWhole && length < size) {
      if (!this.#sendsWholeFiles) console.warn(`${path}: the server sends whole files where parts are requested`);
      this.#sendsWholeFiles = true;
      return (await this.#keep(file, Promise.resolve(checkSize(file, bytes)))).slice(first, first + length);
    }
    if (bytes.length < length) throw damagedError(path, `expected ${length} bytes, got ${bytes.length}`);
    return bytes;
  }

  async #readWhole(file: StoredFile): Promise<Bytes> {
    const [path, size, version] = file;
    // Servers do not compress the answers to range requests; the data are compressed already.
    return checkSize(file, (await this.files.read({ path, version, part: [0, size] })).bytes);
  }

  #keep([path, size]: StoredFile, content: Promise<Bytes>): Promise<Bytes> {
    this.#whole.add(path, content, size);
    content.catch(() => this.#whole.delete(path));
    return content;
  }
}

/** Returns the bytes of a file if they have the listed size. */
function checkSize([path, size]: StoredFile, bytes: Bytes): Bytes {
  if (bytes.length !== size) throw damagedError(path, `expected ${size} bytes, got ${bytes.length}`);
  return bytes;
}
