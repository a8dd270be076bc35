/** Reader of the nine planes of a range file, and the scale of range codes: docs/stream.md, "Files of ranges". */

export const NO_SURFACE = 65535;

const PLANES = 9;
const [CHANGED, EMPTY, BITS, WORDS] = [0, 1, 2, 8] as const;

/** Confidence in a prediction, which decides in which planes its residual is stored. */
export const TRUST = {
  high: { pair: 3, byte: 6, isBit: true },
  medium: { pair: 4, byte: 6, isBit: false },
  calm: { pair: 5, byte: 6, isBit: false },
  low: { pair: null, byte: 7, isBit: false },
} as const;
export type Trust = (typeof TRUST)[keyof typeof TRUST];

export type Planes = ReturnType<typeof readPlanes>;

export function rangeError(found: string): Error {
  return new Error(`expected ranges of the listed tiles, got ${found}`);
}

export function readPlanes(raw: Uint8Array) {
  const head = 4 * PLANES;
  if (raw.length < head) throw rangeError('fewer bytes');
  const lengths = new DataView(raw.buffer, raw.byteOffset, head);
  const planes: Uint8Array[] = [];
  let end = head;
  for (let plane = 0; plane < PLANES; plane++) {
    const start = end;
    end += lengths.getUint32(4 * plane, true);
    if (end > raw.length) throw rangeError('fewer bytes');
    planes.push(raw.subarray(start, end));
  }
  if (end !== raw.length) throw rangeError('more bytes');
  // Number of bits read so far from each plane; for the last plane, number of words.
  const readCounts = new Uint32Array(PLANES);

  /** Reads bits that lie in one byte. */
  function readBits(plane: number, count: number): number {
    const first = readCounts[plane] as number;
    const byte = planes[plane]?.[first >> 3];
    if (byte === undefined) throw rangeError('fewer bytes');
    readCounts[plane] = first + count;
    return (byte >> (8 - count - (first & 7))) & ((1 << count) - 1);
  }

  function readWord(): number {
    const plane = planes[WORDS] as Uint8Array;
    const wordCount = plane.length >> 1;
    const index = readCounts[WORDS] as number;
    const [high, low] = [plane[index], plane[wordCount + index]];
    if (index >= wordCount || high === undefined || low === undefined) throw rangeError('fewer bytes');
    readCounts[WORDS] = index + 1;
    return (high << 8) | low;
  }

  return {
    /** Reads a flag; its bit is 1 if the prediction is wrong. */
    readChanged: (predicted: boolean): boolean => predicted !== (readBits(CHANGED, 1) === 1),
    readEmpty: (predicted: boolean): boolean => predicted !== (readBits(EMPTY, 1) === 1),
    /** Reads a residual as a zigzag code. */
    readResidual(trust: Trust): number {
      let sum = 0;
      if (trust.isBit) {
        if (readBits(BITS, 1) === 0) return 0;
        sum = 1;
      }
      if (trust.pair !== null) {
        const pair = readBits(trust.pair, 2);
        if (pair < 3) return sum + pair;
        sum += 3;
      }
      const byte = readBits(trust.byte, 8);
      const value = sum + byte + (byte === 255 ? readWord() : 0);
      if (value > 65535) throw rangeError('a number beyond 16 bits');
      return value;
    },
    /** Throws an error if bytes have not been read. */
    finish(): void {
      const bytesRead = [...readCounts].map((count, plane) => (plane === WORDS ? 2 * count : (count + 7) >> 3));
      if (planes.some((plane, number) => bytesRead[number] !== plane.length)) throw rangeError('more bytes');
    },
  };
}

/** Distance from a guess within which codes are tried before all others. */
const NEARBY = 4;

/** Conversion between codes and ranges by powers of the ratio of consecutive ranges, bit-identical on every machine. */
export type Scale = ReturnType<typeof createScale>;

export function createScale(step: number) {
  const [ratio, half] = [exponential(step), exponential(0.5 * step)];
  const reciprocals = new Float64Array(NO_SURFACE);
  const bounds = new Float64Array(NO_SURFACE - 1);
  for (let code = 0, power = 1; code < NO_SURFACE; code++, power *= ratio) {
    reciprocals[code] = 1 / power;
    if (code < bounds.length) bounds[code] = power * half;
  }
  const last = bounds.length;
  return {
    /** Inverse range times the texel's distance at depth 1; for a plane it is linear in texel coordinates. */
    nearness: (code: number, distance: number): number => distance * (reciprocals[code] as number),
    /** Code of a nearness; a good guess saves time. */
    code(nearness: number, distance: number, guess: number): number {
      if (!(nearness > 0)) return NO_SURFACE - 1;
      const range = distance / nearness;
      let from = Math.max(guess - NEARBY, 0);
      let to = guess + NEARBY;
      const isWithin = to < last && (from === 0 || (bounds[from - 1] as number) <= range) && range < (bounds[to] as number);
      if (!isWithin) [from, to] = [0, last];
      // Binary search for the number of bounds up to the range.
      while (from < to) {
        const middle = (from + to) >> 1;
        if ((bounds[middle] as number) <= range) from = middle + 1;
        else to = middle;
      }
      return from;
    },
  };
}

/** Exponential of a small number by its series: implementations of Math.exp differ in the last digit. */
function exponential(x: number): number {
  let sum = 1;
  for (let n = 10; n >= 1; n--) sum = 1 + (x / n) * sum;
  return sum;
}
