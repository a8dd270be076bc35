/** Decodes the chunks of views: Zstandard and WebP, with checksums, which fzstd does not verify. */
import { decompress } from 'fzstd';
import { rgbaOf } from '../../decode/files';
import { damagedError } from '../store/error';
import type { Bytes } from '../store/files';

/** Polynomial of CRC32C (Castagnoli), bit-reversed. */
const CASTAGNOLI = 0x82f6_3b78;
const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ CASTAGNOLI : sum >>> 1;
  return sum;
});

export function crc32c(bytes: Uint8Array): number {
  let sum = ~0;
  for (const byte of bytes) sum = (sum >>> 8) ^ (CRC_TABLE[(sum ^ byte) & 255] as number);
  return ~sum >>> 0;
}

/** Returns a chunk's data without its checksum; throws if the checksum is wrong. */
function verifyChecksum(bytes: Uint8Array): Uint8Array {
  const data = bytes.subarray(0, -4);
  const sum = new DataView(bytes.buffer, bytes.byteOffset + data.length).getUint32(0, true);
  if (bytes.length < 4 || crc32c(data) !== sum) throw damagedError('a chunk', 'its checksum is wrong');
  return data;
}

/** Decompressed size from the header of a Zstandard frame (RFC 8878, 3.1.1.1); null if absent. */
export function contentSize(frame: Uint8Array): number | null {
  const view = new DataView(frame.buffer, frame.byteOffset, frame.byteLength);
  const flags = view.getUint8(4);
  const [isSingleSegment, sizeCode] = [(flags & 32) !== 0, flags >> 6];
  const offset = 5 + (isSingleSegment ? 0 : 1) + ([0, 1, 2, 4][flags & 3] as number);
  if (sizeCode === 0) return isSingleSegment ? view.getUint8(offset) : null;
  if (sizeCode === 1) return view.getUint16(offset, true) + 256;
  return sizeCode === 2 ? view.getUint32(offset, true) : Number(view.getBigUint64(offset, true));
}

/** Decompresses a Zstandard frame that has a checksum; `size` is the expected size: a damaged header may state any. */
export function decompressZstd(frame: Uint8Array, size: number): Uint8Array {
  const stated = frame.length < 18 ? null : contentSize(frame);
  if (stated !== size) throw damagedError('a chunk', `its header states ${stated} bytes, not ${size}`);
  const content = decompress(frame, new Uint8Array(size));
  const sum = new DataView(frame.buffer, frame.byteOffset + frame.length - 4).getUint32(0, true);
  // fzstd does not verify the checksum.
  if (content.length !== size || Number(xxh64(content) & 0xffff_ffffn) !== sum)
    throw damagedError('a chunk', 'its checksum is wrong');
  return content;
}

/** Decodes a chunk that begins with a WebP image of `width` × `height`; returns `size` bytes. */
export async function decodeWebp(chunk: Bytes, width: number, height: number, size: number): Promise<Uint8Array> {
  const data = verifyChecksum(chunk);
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const end = data.length < 4 ? 0 : 4 + view.getUint32(0, true);
  if (end < 4 || end > data.length) throw damagedError('a chunk', 'its image is longer than the chunk');
  const colorBytes = 3 * width * height;
  const content = new Uint8Array(size);
  content.set(decompressZstd(data.subarray(end), size - colorBytes), colorBytes);
  await putPixels(data.slice(4, end) as Bytes, width, height, content);
  return content;
}

/** Puts the RGB of a WebP file without alpha at the beginning of `target`. */
async function putPixels(file: Bytes, width: number, height: number, target: Uint8Array): Promise<void> {
  const image = await createImageBitmap(new Blob([file]), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  if (image.width !== width || image.height !== height)
    throw damagedError('a chunk', `an image of ${image.width} × ${image.height}`);
  const rgba = rgbaOf(image);
  for (let from = 0, to = 0; to < 3 * width * height; from += 4, to += 3) {
    target[to] = rgba[from] as number;
    target[to + 1] = rgba[from + 1] as number;
    target[to + 2] = rgba[from + 2] as number;
  }
}

const [P1, P2, P3, P4, P5] = [
  0x9e37_79b1_85eb_ca87n,
  0xc2b2_ae3d_27d4_eb4fn,
  0x1656_67b1_9e37_79f9n,
  0x85eb_ca77_c2b2_ae63n,
  0x27d4_eb2f_1656_67c5n,
] as const;

const STRIPE_BYTES = 32;

const mask = (value: bigint): bigint => BigInt.asUintN(64, value);
const rotateLeft = (value: bigint, bits: bigint): bigint => mask((value << bits) | (value >> (64n - bits)));
const round = (sum: bigint, input: bigint): bigint => mask(rotateLeft(mask(sum + input * P2), 31n) * P1);

/** XXH64 hash with seed 0 (xxHash specification 0.1.1); Zstandard frames have its lower 32 bits as checksum. */
export function xxh64(bytes: Uint8Array): bigint {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let offset = 0;
  let sum: bigint = P5;
  if (bytes.length >= STRIPE_BYTES) {
    offset = bytes.length - (bytes.length % STRIPE_BYTES);
    const lanes = [mask(P1 + P2), P2, 0n, mask(-P1)].map((start, lane) => laneSum(view, start, 8 * lane, offset));
    const [a, b, c, d] = lanes as [bigint, bigint, bigint, bigint];
    sum = mask(rotateLeft(a, 1n) + rotateLeft(b, 7n) + rotateLeft(c, 12n) + rotateLeft(d, 18n));
    for (const lane of lanes) sum = mask((sum ^ round(0n, lane)) * P1 + P4);
  }
  sum = mask(sum + BigInt(bytes.length));
  for (; offset + 8 <= bytes.length; offset += 8)
    sum = mask(rotateLeft(sum ^ round(0n, view.getBigUint64(offset, true)), 27n) * P1 + P4);
  for (; offset + 4 <= bytes.length; offset += 4)
    sum = mask(rotateLeft(sum ^ mask(BigInt(view.getUint32(offset, true)) * P1), 23n) * P2 + P3);
  for (; offset < bytes.length; offset++)
    sum = mask(rotateLeft(sum ^ mask(BigInt(view.getUint8(offset)) * P5), 11n) * P1);
  sum = mask((sum ^ (sum >> 33n)) * P2);
  sum = mask((sum ^ (sum >> 29n)) * P3);
  return sum ^ (sum >> 32n);
}

/** Accumulates a lane over all stripes in 32-bit arithmetic: BigInt takes ten times as long. */
function laneSum(view: DataView, start: bigint, first: number, end: number): bigint {
  let [high, low] = [Number(start >> 32n), Number(start & 0xffff_ffffn)];
  for (let offset = first; offset < end; offset += STRIPE_BYTES) {
    const [inputLow, inputHigh] = [view.getUint32(offset, true), view.getUint32(offset + 4, true)];
    // sum + input × P2
    let product = upperOf(inputLow, 0x27d4_eb4f);
    let upper = product + Math.imul(inputHigh, 0x27d4_eb4f) + Math.imul(inputLow, 0xc2b2_ae3d);
    low = (low >>> 0) + (Math.imul(inputLow, 0x27d4_eb4f) >>> 0);
    high = (high + upper + (low > 0xffff_ffff ? 1 : 0)) >>> 0;
    low >>>= 0;
    // Rotate left by 31 bits.
    [high, low] = [((high << 31) | (low >>> 1)) >>> 0, ((low << 31) | (high >>> 1)) >>> 0];
    // × P1
    product = upperOf(low, 0x85eb_ca87);
    upper = product + Math.imul(high, 0x85eb_ca87) + Math.imul(low, 0x9e37_79b1);
    low = Math.imul(low, 0x85eb_ca87) >>> 0;
    high = upper >>> 0;
  }
  return (BigInt(high) << 32n) | BigInt(low);
}

/** Upper 32 bits of the product of two 32-bit numbers. */
function upperOf(a: number, b: number): number {
  const [a0, a1, b0, b1] = [a & 0xffff, a >>> 16, b & 0xffff, b >>> 16];
  const middleSum = a0 * b1 + a1 * b0 + ((a0 * b0) >>> 16);
  return a1 * b1 + Math.floor(middleSum / 65536);
}
