/** A store for zarrita: array metadata derived from the layout, and byte ranges of shards. */
import { LruCache } from '../../base/cache';
import { BEHIND, CONNECTION_BITS, type Layout, shardSide } from '../store/layout';
import { StoreError } from '../store/error';
import type { Bytes, Files } from '../store/files';

/** Size in bytes up to which shards are read as a whole: an index alone has 8 kB. */
const SMALL = 1 << 16;
/** Size of the cache of whole shards, bytes. */
const KEPT = 1 << 25;

/** Size and version of shards, by their paths with the folders of their generations. */
export type Known = ReadonlyMap<string, { readonly size: number; readonly version: string }>;

type Range = { readonly offset: number; readonly length: number } | { readonly suffixLength: number };

export class Shards {
  /** Whole shards: small ones, and those of servers without range requests. */
  readonly #whole = new LruCache<Promise<Bytes>>(KEPT);

  constructor(
    readonly files: Files,
    readonly layout: Layout,
    /** Shards of the views that are being read. */
    readonly known: Known,
  ) {}

  /** Metadata of an array; undefined for chunks, which zarrita never requests in sharded stores. */
  get(key: string): Promise<Bytes | undefined> {
    const found = /^\/(?:nearfar\/generations\/\d+\/)?(\d+)\/[a-z_]+\/([a-z_]+)\/zarr\.json$/.exec(key);
    if (!found) return Promise.resolve(undefined);
    const [, level, channel] = found;
    return Promise.resolve(
      new TextEncoder().encode(JSON.stringify(metadataOf(this.layout, Number(level), channel ?? ''))),
    );
  }

  async getRange(key: string, range: Range, options: { signal?: AbortSignal } = {}): Promise<Bytes | undefined> {
    const path = key.slice(1);
    const shard = this.known.get(path);
    if (!shard) throw new StoreError('gone', `${path}: no record lists this shard`);
    const [first, length] =
      'offset' in range ? [range.offset, range.length] : [shard.size - range.suffixLength, range.suffixLength];
    // In updates, a chunk of length 0 marks a removed one.
    if (length === 0) return undefined;
    if (first < 0 || first + length > shard.size)
      throw new StoreError('damaged', `${path}: its index points beyond its end`);
    const whole = this.#whole.get(path) ?? (shard.size <= SMALL ? this.#keep(path, this.#read(path, shard)) : null);
    if (whole) return cut(await whole, first, length);
    // Not aborted for an index: zarrita reads it once for all waiting requests.
    const signal = 'offset' in range ? options.signal : undefined;
    const found = await this.files.read({ path, version: shard.version, part: [first, length], signal });
    if (!found) throw missingShard(path);
    if (found.isWhole) return cut(await this.#keep(path, Promise.resolve(found.bytes)), first, length);
    if (found.bytes.length < length) throw new StoreError('damaged', `${path}: ends too early`);
    return found.bytes;
  }

  async #read(path: string, { size, version }: { size: number; version: string }): Promise<Bytes> {
    // A range request, so that no server compresses compressed data again.
    const found = await this.files.read({ path, version, part: [0, size] });
    if (!found) throw missingShard(path);
    if (found.bytes.length !== size)
      throw new StoreError('damaged', `${path}: expected ${size} bytes, got ${found.bytes.length}`);
    return found.bytes;
  }

  #keep(path: string, content: Promise<Bytes>): Promise<Bytes> {
    this.#whole.add(path, content, this.known.get(path)?.size ?? 0);
    content.catch(() => this.#whole.delete(path));
    return content;
  }
}

function missingShard(path: string): StoreError {
  return new StoreError('gone', `${path}: the shard is gone`);
}

/** Copies a part of a shard, so that the part does not keep the shard in memory. */
function cut(whole: Bytes, first: number, length: number): Bytes {
  return whole.slice(first, first + length);
}

/** Metadata of an array, identical to those that the build writes. */
function metadataOf(layout: Layout, level: number, channel: string): object {
  const kind = channel.replace(BEHIND, '');
  const [side, { size }] = [shardSide(layout, level), layout];
  const values = { color: 3, depth: 1, normal: layout.normalBits / 8 }[kind] ?? 1;
  const picture = [size, size, values];
  const bytes = { name: 'bytes', configuration: { endian: 'little' } };
  const isImage = kind === 'color' && layout.color === 'webp';
  const isLong = kind === 'depth' && layout.depthBits + CONNECTION_BITS > 16;
  const inner = isImage
    ? [{ name: 'imagecodecs_webp', configuration: {} }, { name: 'crc32c' }]
    : [bytes, { name: 'zstd', configuration: {} }];
  return {
    zarr_format: 3,
    node_type: 'array',
    shape: [...layout.counts.map((count) => Math.ceil(count / 2 ** level)), ...picture],
    data_type: kind !== 'depth' ? 'uint8' : isLong ? 'uint32' : 'uint16',
    chunk_grid: { name: 'regular', configuration: { chunk_shape: [side, side, side, ...picture] } },
    chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
    fill_value: 0,
    codecs: [
      {
        name: 'sharding_indexed',
        configuration: {
          chunk_shape: [1, 1, 1, ...picture],
          codecs: inner,
          index_codecs: [bytes, { name: 'crc32c' }],
          index_location: 'end',
        },
      },
    ],
    attributes: {},
  };
}
