/** XXH64 with seed 0, whose lower 32 bits are the checksum of Zstandard frames (xxHash specification 0.1.1). */

const [P1, P2, P3, P4, P5] = [
  0x9e37_79b1_85eb_ca87n,
  0xc2b2_ae3d_27d4_eb4fn,
  0x1656_67b1_9e37_79f9n,
  0x85eb_ca77_c2b2_ae63n,
  0x27d4_eb2f_1656_67c5n,
] as const;

const STRIPE = 32;

const mask = (value: bigint): bigint => BigInt.asUintN(64, value);
const turned = (value: bigint, bits: bigint): bigint => mask((value << bits) | (value >> (64n - bits)));
const round = (sum: bigint, input: bigint): bigint => mask(turned(mask(sum + input * P2), 31n) * P1);

export function xxh64(bytes: Uint8Array): bigint {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  let sum: bigint = P5;
  if (bytes.length >= STRIPE) {
    at = bytes.length - (bytes.length % STRIPE);
    const lanes = [mask(P1 + P2), P2, 0n, mask(-P1)].map((start, lane) => striped(view, start, 8 * lane, at));
    const [a, b, c, d] = lanes as [bigint, bigint, bigint, bigint];
    sum = mask(turned(a, 1n) + turned(b, 7n) + turned(c, 12n) + turned(d, 18n));
    for (const lane of lanes) sum = mask((sum ^ round(0n, lane)) * P1 + P4);
  }
  sum = mask(sum + BigInt(bytes.length));
  for (; at + 8 <= bytes.length; at += 8) {
    sum = mask(turned(sum ^ round(0n, view.getBigUint64(at, true)), 27n) * P1 + P4);
  }
  for (; at + 4 <= bytes.length; at += 4) {
    sum = mask(turned(sum ^ mask(BigInt(view.getUint32(at, true)) * P1), 23n) * P2 + P3);
  }
  for (; at < bytes.length; at++) sum = mask(turned(sum ^ mask(BigInt(view.getUint8(at)) * P5), 11n) * P1);
  sum = mask((sum ^ (sum >> 33n)) * P2);
  sum = mask((sum ^ (sum >> 29n)) * P3);
  return sum ^ (sum >> 32n);
}

/** A lane's sum over all stripes, in 32-bit arithmetic: 64-bit BigInts take ten times as long. */
function striped(view: DataView, start: bigint, first: number, end: number): bigint {
  let [high, low] = [Number(start >> 32n), Number(start & 0xffff_ffffn)];
  for (let at = first; at < end; at += STRIPE) {
    const [inputLow, inputHigh] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    // sum + input × P2
    let product = upperOf(inputLow, 0x27d4_eb4f);
    let upper = product + Math.imul(inputHigh, 0x27d4_eb4f) + Math.imul(inputLow, 0xc2b2_ae3d);
    low = (low >>> 0) + (Math.imul(inputLow, 0x27d4_eb4f) >>> 0);
    high = (high + upper + (low > 0xffff_ffff ? 1 : 0)) >>> 0;
    low >>>= 0;
    // Rotated by 31 bits.
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
  const middle = a0 * b1 + a1 * b0 + ((a0 * b0) >>> 16);
  return a1 * b1 + Math.floor(middle / 65536);
}
