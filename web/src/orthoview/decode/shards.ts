/** Store interface for zarrita: array metadata, which follow from the layout, and byte ranges of shards. */
import { LruCache } from '../../base/cache';
import { BEHIND_PREFIX, CONNECTION_BITS, type Layout, shardSide } from '../store/layout';
import { damagedError, StoreError } from '../store/error';
import type { Bytes, Files } from '../store/files';

/** Greatest size of shards that are read as a whole, bytes; an index alone has 8 kB. */
const SMALL_BYTES = 1 << 16;
/** Size of the cache of whole shards, bytes. */
const CACHE_BYTES = 1 << 25;

type Range = { readonly offset: number; readonly length: number } | { readonly suffixLength: number };

export class Shards {
  /** Cache of whole shards: small shards, and all shards if the server ignores range requests. */
  readonly #whole = new LruCache<Promise<Bytes>>(CACHE_BYTES);

  /** Shards of the requested views by path, with the folder of their generation. */
  readonly shardByPath = new Map<string, { readonly size: number; readonly version: string }>();

  constructor(readonly files: Files, readonly layout: Layout) {}

  /** Metadata of an array; undefined for chunks, which zarrita never requests in sharded stores. */
  async get(key: string): Promise<Bytes | undefined> {
    const path = /^\/(?:nearfar\/generations\/\d+\/)?(\d+)\/[a-z_]+\/([a-z_]+)\/zarr\.json$/.exec(key);
    if (!path) return undefined;
    const [, level, channel = ''] = path;
    return new TextEncoder().encode(JSON.stringify(metadataOf(this.layout, Number(level), channel)));
  }

  async getRange(key: string, range: Range, options: { signal?: AbortSignal } = {}): Promise<Bytes | undefined> {
    const path = key.slice(1);
    const shard = this.shardByPath.get(path);
    if (!shard) throw new StoreError('gone', `${path}: no record lists this shard`);
    const [first, length] =
      'offset' in range ? [range.offset, range.length] : [shard.size - range.suffixLength, range.suffixLength];
    // In updates, length 0 marks a removed chunk.
    if (length === 0) return undefined;
    if (first < 0 || first + length > shard.size) throw damagedError(path, 'its index points beyond its end');
    // A copy, because a subarray would keep the whole shard in memory.
    const partOf = (content: Bytes): Bytes => content.slice(first, first + length);
    const isSmall = shard.size <= SMALL_BYTES;
    const whole = this.#whole.get(path) ?? (isSmall ? this.#keep(path, this.#read(path, shard)) : null);
    if (whole) return partOf(await whole);
    // The read of an index is not aborted: zarrita reads it once for all waiting requests.
    const signal = 'offset' in range ? options.signal : undefined;
    const { bytes, isWhole } = await this.files.read({ path, version: shard.version, part: [first, length], signal });
    if (isWhole) return partOf(await this.#keep(path, Promise.resolve(bytes)));
    if (bytes.length < length) throw damagedError(path, `expected ${length} bytes, got ${bytes.length}`);
    return bytes;
  }

  async #read(path: string, { size, version }: { size: number; version: string }): Promise<Bytes> {
    // Servers do not compress the answers to range requests; the data are compressed already.
    const { bytes } = await this.files.read({ path, version, part: [0, size] });
    if (bytes.length !== size) throw damagedError(path, `expected ${size} bytes, got ${bytes.length}`);
    return bytes;
  }

  #keep(path: string, content: Promise<Bytes>): Promise<Bytes> {
    this.#whole.add(path, content, this.shardByPath.get(path)?.size ?? 0);
    content.catch(() => this.#whole.delete(path));
    return content;
  }
}

/** Metadata of an array, identical to the `zarr.json` that the build writes. */
function metadataOf(layout: Layout, level: number, channel: string): object {
  const kind = channel.replace(BEHIND_PREFIX, '');
  const [side, { size }] = [shardSide(layout, level), layout];
  const values = { color: 3, depth: 1, normal: layout.normalBits / 8 }[kind] ?? 1;
  const picture = [size, size, values];
  const bytes = { name: 'bytes', configuration: { endian: 'little' } };
  const isImage = kind === 'color' && layout.color === 'webp';
  const isLong = kind === 'depth' && layout.depthBits + CONNECTION_BITS > 16;
  const inner = isImage
    ? [{ name: 'imagecodecs_webp', configuration: {} }, { name: 'crc32c' }]
    : [bytes, { name: 'zstd', configuration: {} }];
  const chunk = { chunk_shape: [1, 1, 1, ...picture], codecs: inner };
  const sharding = { ...chunk, index_codecs: [bytes, { name: 'crc32c' }], index_location: 'end' };
  return {
    zarr_format: 3,
    node_type: 'array',
    shape: [...layout.counts.map((count) => Math.ceil(count / 2 ** level)), ...picture],
    data_type: kind !== 'depth' ? 'uint8' : isLong ? 'uint32' : 'uint16',
    chunk_grid: { name: 'regular', configuration: { chunk_shape: [side, side, side, ...picture] } },
    chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
    fill_value: 0,
    codecs: [{ name: 'sharding_indexed', configuration: sharding }],
    attributes: {},
  };
}
