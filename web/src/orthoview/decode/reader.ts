/** Reader of a store's views and leaves, and the messages of the workers that use it. */
import { messageOf } from '../../base/errors';
import { damagedError, type Failure } from '../store/error';
import { type Bytes, createFiles } from '../store/files';
import { arrayOf, CONNECTION_BITS, type Layout, type ViewKey } from '../store/layout';
import type { StoredFile } from '../store/records';
import { decodeWebp, decompressZstd } from './codecs';
import { createTextureReader, type Piece, readLeaf } from './leaf';
import { pack, type Splats } from './pack';
import { Shards } from './shards';

/** Request for a view or, with the direction `GEOMETRY`, for a leaf's geometry. */
export interface ViewRequest extends ViewKey {
  readonly generation: number;
  /** The shard with the view's chunk, or the leaf's geometry files. */
  readonly files: readonly StoredFile[];
  /** First byte and length of the view's chunk; absent if no record lists it, and for geometry. */
  readonly part?: readonly [number, number] | undefined;
}

export type Reader = ReturnType<typeof createReader>;

export function createReader(base: URL, layout: Layout, receive: (bytes: number) => void) {
  const files = createFiles(base, receive);
  const shards = new Shards(files);
  const readTexture = createTextureReader(files);
  return {
    leaf: (request: ViewRequest, signal: AbortSignal): Promise<Piece[]> =>
      readLeaf(files, readTexture, request.files, signal),
    /** Splats of a view's layers; an empty second layer is omitted. */
    async read(request: ViewRequest, signal: AbortSignal): Promise<Splats[]> {
      const [[file], array] = [request.files, arrayOf(layout, request, request.generation)];
      const cell = `the chunk of the cell ${request.place.join(', ')}`;
      if (!file || !request.part) throw damagedError(array, `${cell} is missing`);
      const chunk = await shards.read(file, request.part, signal);
      let content: Uint8Array;
      try {
        content = await decodeView(chunk, layout);
      } catch (reason) {
        throw damagedError(array, `${cell}: ${messageOf(reason)}`);
      }
      const [first, ...others] = Array.from({ length: layout.layers }, (_, layer) => layerOf(content, layer, layout));
      if (!first?.count) throw damagedError(array, `${cell} is empty`);
      return [first, ...others.filter(({ count }) => count > 0)];
    },
  };
}

/** Bytes of a pixel's depth and of its normal. */
function widthsOf({ depthBits, normalBits }: Layout): [number, number] {
  return [Math.ceil((depthBits + CONNECTION_BITS) / 8), normalBits / 8];
}

/** Bytes of a view: colours of all layers, planes of depth bytes, the lowest first, and normals. */
async function decodeView(chunk: Bytes, layout: Layout): Promise<Uint8Array> {
  const { size, layers, color } = layout;
  const [depthBytes, normalBytes] = widthsOf(layout);
  const viewBytes = layers * size * size * (3 + depthBytes + normalBytes);
  return color === 'webp' ? decodeWebp(chunk, size, layers * size, viewBytes) : decompressZstd(chunk, viewBytes);
}

function layerOf(content: Uint8Array, layer: number, layout: Layout): Splats {
  const pixels = layout.size ** 2;
  const [depthBytes, normalBytes] = widthsOf(layout);
  let end = 0;
  /** This layer's part of the next bytes, which have all layers. */
  const take = (bytesPerPixel: number): Uint8Array => {
    const first = end + layer * pixels * bytesPerPixel;
    end += layout.layers * pixels * bytesPerPixel;
    return content.subarray(first, first + pixels * bytesPerPixel);
  };
  const color = take(3);
  const depth = new Uint32Array(pixels);
  for (let byte = 0; byte < depthBytes; byte++) {
    take(1).forEach((value, pixel) => (depth[pixel] = (depth[pixel] as number) | (value << (8 * byte))));
  }
  return pack(color, depth, take(normalBytes), layout);
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
