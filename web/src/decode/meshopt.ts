/**
 * Decompression of arrays by meshoptimizer, whose decoder does not validate its arguments, so they are checked here.
 */
import { MeshoptDecoder } from 'meshoptimizer/decoder';

/** Description of an array in `EXT_meshopt_compression`. Every number may be wrong in a damaged file. */
export interface Compression {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride: number;
  readonly count: number;
  readonly mode: string;
  readonly filter?: string;
}

/** Greatest size of a decompressed array in bytes; the largest ring of a bundle has a fraction of it. */
const MAX_BYTES = 2 ** 28;
/**
 * Greatest number of bytes that a compressed byte decodes to: version 0 of the vertex codec spends at least two bits on
 * 16 bytes of a column, the index codecs spend at least a byte on a triangle, or on an index.
 */
const MAX_GROWTH = 64;
/** Allowed size of short arrays in any case, bytes, because their last block may be padded. */
const MIN_BYTES = 2 ** 16;
const MAX_STRIDE = 256;

type Strides = (stride: number) => boolean;
const isCorner: Strides = (stride) => stride === 2 || stride === 4;
const MODES: ReadonlyMap<string, Strides> = new Map([
  ['ATTRIBUTES', (stride: number) => stride % 4 === 0 && stride <= MAX_STRIDE],
  ['TRIANGLES', isCorner],
  ['INDICES', isCorner],
]);
const FILTERS: ReadonlyMap<string, Strides> = new Map([
  ['NONE', () => true],
  ['OCTAHEDRAL', (stride: number) => stride === 4 || stride === 8],
  ['QUATERNION', (stride: number) => stride === 8],
  ['EXPONENTIAL', (stride: number) => stride % 4 === 0],
]);

export async function decompressed(source: Uint8Array, { count, byteStride, mode, filter = 'NONE' }: Compression) {
  const isSized = isCount(count) && isCount(byteStride) && byteStride > 0;
  const size = count * byteStride;
  if (!isSized || size > Math.min(MAX_BYTES, MIN_BYTES + MAX_GROWTH * source.length)) {
    throw new Error(`${source.length} compressed bytes claim ${count} rows of ${byteStride} bytes`);
  }
  if (!MODES.get(mode)?.(byteStride) || (mode === 'TRIANGLES' && count % 3 !== 0)) {
    throw new Error(`${count} rows of ${byteStride} bytes cannot be ${mode}`);
  }
  if (!FILTERS.get(filter)?.(byteStride) || (mode !== 'ATTRIBUTES' && filter !== 'NONE')) {
    throw new Error(`${mode} of ${byteStride} bytes have no filter ${filter}`);
  }
  const target = new Uint8Array(size);
  await MeshoptDecoder.ready;
  try {
    MeshoptDecoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
  } catch {
    throw new Error('expected a compressed array, got something else');
  }
  return target;
}

export function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}
