/** Packs a view's pixels as splats, in parts that are culled as a whole. */
import { CONNECTION_BITS, type Layout } from '../store/layout';

/** 32-bit words per splat. */
export const WORDS = 3;
/** Number of parts along each axis of a view. */
const PARTS = 4;
/** Greatest number of connected neighbours of a ball; pixels with more are surfels. */
const MAX_BALL_NEIGHBOURS = 4;
/** Number of neighbours of a pixel. */
const ALL_NEIGHBOURS = 8;

/** Splats [first, first + count) and the ranges [low, high) of their columns, rows and depth steps. */
export interface Part {
  readonly first: number;
  readonly count: number;
  readonly low: readonly [number, number, number];
  readonly high: readonly [number, number, number];
}

/**
 * Non-empty pixels of a view, three words each: 24 bits of colour and the upper 8 bits of the depth; 24 bits of the
 * normal and the lower 8 bits of the depth; 12 bits of the column, 12 bits of the row, bit 24 for surfels, and bit 25
 * if all neighbours are connected.
 */
export interface Splats {
  readonly words: Uint32Array<ArrayBuffer>;
  readonly parts: readonly Part[];
  readonly count: number;
}

type Numbers = ArrayLike<number>;

export function pack(color: Numbers, depth: Numbers, normal: Numbers, layout: Layout): Splats {
  const { size } = layout;
  const connectedCounts = countConnected(depth, size);
  const words = new Uint32Array(WORDS * countSplats(depth));
  const parts: Part[] = [];
  const partSize = Math.ceil(size / PARTS);
  let count = 0;

  /** Packs a pixel; returns its depth in steps, 0 for an empty pixel. */
  function packPixel(x: number, y: number): number {
    const pixel = y * size + x;
    const steps = (depth[pixel] as number) >>> CONNECTION_BITS;
    if (steps === 0) return 0;
    const index = WORDS * count;
    const [r, g, b] = [color[3 * pixel], color[3 * pixel + 1], color[3 * pixel + 2]] as [number, number, number];
    words[index] = r | (g << 8) | (b << 16) | ((steps >>> 8) << 24);
    words[index + 1] = packNormal(normal, pixel, layout.normalBits) | ((steps & 255) << 24);
    const connected = connectedCounts[pixel] as number;
    const flags = (connected > MAX_BALL_NEIGHBOURS ? 1 << 24 : 0) | (connected === ALL_NEIGHBOURS ? 1 << 25 : 0);
    words[index + 2] = x | (y << 12) | flags;
    count += 1;
    return steps;
  }

  for (let row = 0; row < size; row += partSize) {
    for (let column = 0; column < size; column += partSize) {
      const first = count;
      const low: [number, number, number] = [size, size, 2 ** 16];
      const high: [number, number, number] = [0, 0, 0];
      for (let y = row; y < Math.min(row + partSize, size); y++) {
        for (let x = column; x < Math.min(column + partSize, size); x++) {
          const steps = packPixel(x, y);
          if (steps === 0) continue;
          if (x < low[0]) low[0] = x;
          if (y < low[1]) low[1] = y;
          if (steps - 1 < low[2]) low[2] = steps - 1;
          if (x >= high[0]) high[0] = x + 1;
          if (y >= high[1]) high[1] = y + 1;
          if (steps > high[2]) high[2] = steps;
        }
      }
      if (count > first) parts.push({ first, count: count - first, low, high });
    }
  }
  return { words, parts, count };
}

function countSplats(depth: Numbers): number {
  let count = 0;
  for (let pixel = 0; pixel < depth.length; pixel++) if ((depth[pixel] as number) >>> CONNECTION_BITS) count += 1;
  return count;
}

/** Packs both components of a normal into 24 bits; 8-bit components keep their value. */
function packNormal(normal: Numbers, pixel: number, bits: number): number {
  if (bits === 16) return (normal[2 * pixel] as number) | ((normal[2 * pixel + 1] as number) << 12);
  const first = 3 * pixel;
  const [high, middle, low] = [normal[first], normal[first + 1], normal[first + 2]] as [number, number, number];
  return (high << 4) | (middle >> 4) | ((((middle & 15) << 8) | low) << 12);
}

/** Counts the connected neighbours of each pixel. */
function countConnected(depth: Numbers, size: number): Uint8Array {
  const counts = new Uint8Array(size * size);
  const offsets = [1, size, size + 1, size - 1];
  for (let y = 0, pixel = 0; y < size; y++) {
    for (let x = 0; x < size; x++, pixel++) {
      const bits = (depth[pixel] as number) & 15;
      for (let bit = 0; bit < 4; bit++) {
        // Bits that point outside of the picture are ignored.
        const isOut = (bit !== 1 && (bit === 3 ? x === 0 : x === size - 1)) || (bit > 0 && y === size - 1);
        if (!((bits >> bit) & 1) || isOut) continue;
        const neighbour = pixel + (offsets[bit] as number);
        counts[pixel] = (counts[pixel] as number) + 1;
        counts[neighbour] = (counts[neighbour] as number) + 1;
      }
    }
  }
  return counts;
}
