/** Reader of a store's views and leaves, based on zarrita; and the messages of the workers that use it. */
import * as zarr from 'zarrita';
import { damagedError, type Failure, StoreError } from '../store/error';
import { createFiles } from '../store/files';
import { arrayOf, BEHIND_PREFIX, CHANNELS, generationFolder, type Layout, type Triple, type ViewKey } from '../store/layout';
import type { Shard } from '../store/records';
import { registerCodecs } from './codecs';
import { createTextureReader, type Piece, readLeaf } from './leaf';
import { pack, type Splats } from './pack';
import { Shards } from './shards';

/** Request for a view or, with the direction `GEOMETRY`, for a leaf's geometry. */
export interface ViewRequest extends ViewKey {
  readonly generation: number;
  /** Shards with the view's chunks of all layers, or the leaf's geometry files. */
  readonly shards: readonly Shard[];
}

type Values = Uint8Array | Uint16Array | Uint32Array;

export type Reader = ReturnType<typeof createReader>;

export function createReader(base: URL, layout: Layout, receive: (bytes: number) => void) {
  registerCodecs();
  const files = createFiles(base, receive);
  const store = new Shards(files, layout);
  const readTexture = createTextureReader(files);
  const root = zarr.root(store);
  const arrays = new Map<string, Promise<zarr.Array<zarr.DataType>>>();

  function openArray(name: string): Promise<zarr.Array<zarr.DataType>> {
    const array = arrays.get(name) ?? zarr.open.v3(root.resolve(name), { kind: 'array' });
    arrays.set(name, array);
    return array;
  }

  async function readChunk(name: string, place: Triple, signal: AbortSignal): Promise<Values> {
    try {
      const { data } = await (await openArray(name)).getChunk([...place, 0, 0, 0], { signal });
      return data as Values;
    } catch (reason) {
      if (signal.aborted || reason instanceof StoreError) throw reason;
      // zarrita wraps the errors of codecs.
      const cause = reason instanceof Error && reason.cause instanceof Error ? reason.cause.message : String(reason);
      throw damagedError(name, `the chunk of the cell ${place.join(', ')}: ${cause}`);
    }
  }

  return {
    leaf: ({ shards }: ViewRequest, signal: AbortSignal): Promise<Piece[]> =>
      readLeaf(files, readTexture, shards, signal),
    /** Splats of a view's layers; empty layers are omitted. */
    async read(request: ViewRequest, signal: AbortSignal): Promise<Splats[]> {
      const { level, place, direction, generation, shards } = request;
      for (const [path, size, version] of shards) store.shardByPath.set(path, { size, version });
      const folder = generationFolder(generation);
      const layer = async (prefix: string): Promise<Splats | null> => {
        const name = (channel: string): string => folder + arrayOf(layout, level, direction, prefix + channel);
        const channels = await Promise.all(CHANNELS.map((channel) => readChunk(name(channel), place, signal)));
        const [color, depth, normal] = channels;
        return color && depth && normal ? pack(color, depth, normal, layout) : null;
      };
      const first = await layer('');
      if (!first?.count) {
        const array = folder + arrayOf(layout, level, direction, '');
        throw damagedError(array, `the chunk of the cell ${place.join(', ')} is missing`);
      }
      const hasSecond = shards.some(([path]) => path.includes(`/${BEHIND_PREFIX}depth/`));
      const second = hasSecond ? await layer(BEHIND_PREFIX) : null;
      return second?.count ? [first, second] : [first];
    },
  };
}

export type ToReader =
  | { readonly kind: 'open'; readonly base: string; readonly layout: Layout }
  | { readonly kind: 'read'; readonly id: number; readonly request: ViewRequest }
  | { readonly kind: 'cancel'; readonly id: number };

export type FromReader =
  | { readonly kind: 'view'; readonly id: number; readonly layers: readonly Splats[] }
  | { readonly kind: 'leaf'; readonly id: number; readonly pieces: readonly Piece[] }
  | { readonly kind: 'failed'; readonly id: number; readonly failure: Failure }
  | { readonly kind: 'cancelled'; readonly id: number }
  | { readonly kind: 'received'; readonly bytes: number };
