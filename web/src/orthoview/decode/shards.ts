/** Chunks of views: byte ranges of shards, or parts of whole shards from servers without range requests. */
import { LruCache } from '../../base/cache';
import { damaged } from '../store/error';
import type { Bytes, Files } from '../store/files';
import type { StoredFile } from '../store/records';

/** Size of the cache of whole shards, bytes. */
const CACHE_BYTES = 1 << 25;

export class Shards {
  /** Whole shards of servers without range requests. */
  readonly #whole = new LruCache<Promise<Bytes>>(CACHE_BYTES);
  #sendsWholeFiles = false;

  constructor(readonly files: Files) {}

  async read(file: StoredFile, [first, length]: readonly [number, number], signal: AbortSignal): Promise<Bytes> {
    const [path, size, version] = file;
    const known = this.#whole.get(path);
    const whole = known ?? (this.#sendsWholeFiles ? this.#keep(file, this.#readWhole(file)) : null);
    // Copied, so that a part does not keep its shard in memory.
    if (whole) return (await whole).slice(first, first + length);
    const { bytes, isWhole } = await this.files.read({ path, version, part: [first, length], signal });
    if (isWhole && length < size) {
      if (!this.#sendsWholeFiles) console.warn(`${path}: the server sends whole files where parts are requested`);
      this.#sendsWholeFiles = true;
      return (await this.#keep(file, Promise.resolve(checkSize(file, bytes)))).slice(first, first + length);
    }
    if (bytes.length < length) throw damaged(path, 'ends too early');
    return bytes;
  }

  async #readWhole(file: StoredFile): Promise<Bytes> {
    const [path, size, version] = file;
    // A range request, so that no server compresses compressed data again.
    return checkSize(file, (await this.files.read({ path, version, part: [0, size] })).bytes);
  }

  #keep([path, size]: StoredFile, content: Promise<Bytes>): Promise<Bytes> {
    this.#whole.add(path, content, size);
    content.catch(() => this.#whole.delete(path));
    return content;
  }
}

function checkSize([path, size]: StoredFile, bytes: Bytes): Bytes {
  if (bytes.length !== size) throw damaged(path, `expected ${size} bytes, got ${bytes.length}`);
  return bytes;
}
