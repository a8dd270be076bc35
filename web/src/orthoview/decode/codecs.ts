/** Codecs of a Zarr store, with the checks that zarrita omits. */
import { decompress } from 'fzstd';
import * as zarr from 'zarrita';
import { damaged } from '../store/error';
import type { Bytes } from '../store/files';
import { xxh64 } from './xxh64';

/** Polynomial of CRC32C (Castagnoli), bit-reversed. */
const CASTAGNOLI = 0x82f6_3b78;
const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ CASTAGNOLI : sum >>> 1;
  return sum;
});

export function crc32c(bytes: Uint8Array): number {
  let sum = ~0;
  for (const byte of bytes) sum = (sum >>> 8) ^ (TABLE[(sum ^ byte) & 255] as number);
  return ~sum >>> 0;
}

/** Bytes in front of a checksum; throws if it is wrong. */
function unsummed(bytes: Uint8Array): Uint8Array {
  const data = bytes.subarray(0, -4);
  const sum = new DataView(bytes.buffer, bytes.byteOffset + data.length).getUint32(0, true);
  if (bytes.length < 4 || crc32c(data) !== sum) throw damaged('a chunk', 'its checksum is wrong');
  return data;
}

/** Greatest decompressed size of a chunk in bytes, because a damaged one may state any. */
const MAX = 4096 * 4096 * 4;

/** Content size in the header of a Zstandard frame (RFC 8878, 3.1.1.1); null if it is absent. */
export function statedSize(frame: Uint8Array): number | null {
  const view = new DataView(frame.buffer, frame.byteOffset, frame.byteLength);
  const flags = view.getUint8(4);
  const [isSingle, kind] = [(flags & 32) !== 0, flags >> 6];
  const at = 5 + (isSingle ? 0 : 1) + ([0, 1, 2, 4][flags & 3] as number);
  if (kind === 0) return isSingle ? view.getUint8(at) : null;
  if (kind === 1) return view.getUint16(at, true) + 256;
  return kind === 2 ? view.getUint32(at, true) : Number(view.getBigUint64(at, true));
}

/** Content of a Zstandard frame with a checksum. */
export function unpacked(frame: Uint8Array): Uint8Array {
  const size = frame.length < 18 ? null : statedSize(frame);
  if (size === null || size > MAX) throw damaged('a chunk', `its header states ${size} bytes`);
  const found = decompress(frame, new Uint8Array(size));
  const sum = new DataView(frame.buffer, frame.byteOffset + frame.length - 4).getUint32(0, true);
  // fzstd does not verify the checksum.
  if (found.length !== size || Number(xxh64(found) & 0xffff_ffffn) !== sum)
    throw damaged('a chunk', 'its checksum is wrong');
  return found;
}

interface Meta {
  readonly shape: readonly number[];
}

function encode(): never {
  throw new Error('stores are only read here');
}

/** Registers a codec; zarrita's registry type lacks codecs between arrays and bytes. */
function register(name: string, fromConfig: (config: unknown, meta: Meta) => object): void {
  zarr.registry.set(name, async () => ({ fromConfig }) as never);
}

/** Registers the codecs with zarrita. */
export function registerCodecs(): void {
  register('zstd', () => ({ kind: 'bytes_to_bytes', encode, decode: unpacked }));
  register('crc32c', () => ({
    kind: 'bytes_to_bytes',
    encode,
    decode: unsummed,
    computeEncodedSize: (size: number) => size + 4,
  }));
  register('imagecodecs_webp', (_, { shape }) => ({
    kind: 'array_to_bytes',
    encode,
    decode: async (bytes: Bytes) => ({ data: await pixelsOf(bytes, shape), shape, stride: stridesOf(shape) }),
  }));
}

/** RGB of a WebP file; such files have no alpha, so drawing to a canvas is lossless. */
async function pixelsOf(bytes: Bytes, shape: readonly number[]): Promise<Uint8Array> {
  const image = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const { width, height } = image;
  if (3 * width * height !== shape.reduce((a, b) => a * b, 1))
    throw damaged('a chunk', `an image of ${width} × ${height}`);
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('the browser gives no canvas to a worker');
  context.drawImage(image, 0, 0);
  image.close();
  const rgba = context.getImageData(0, 0, width, height).data;
  const rgb = new Uint8Array(3 * width * height);
  for (let from = 0, to = 0; to < rgb.length; from += 4, to += 3) {
    rgb[to] = rgba[from] as number;
    rgb[to + 1] = rgba[from + 1] as number;
    rgb[to + 2] = rgba[from + 2] as number;
  }
  return rgb;
}

function stridesOf(shape: readonly number[]): number[] {
  return shape.map((_, axis) => shape.slice(axis + 1).reduce((a, b) => a * b, 1));
}
