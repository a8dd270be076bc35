/** Decodes the ranges of a map: docs/stream.md, "Files of ranges". All decoders yield bit-identical codes. */
import { createScale, rangeError, NO_SURFACE, type Planes, readPlanes, type Scale, TRUST, type Trust } from './planes';

/** Division of a map. */
export interface Layout {
  /** Texels along a face. */
  readonly size: number;
  /** Texels along a tile; it divides `size`. */
  readonly tile: number;
  /** Natural logarithm of the ratio of two consecutive codes' ranges. */
  readonly step: number;
}

/** Least number of texels of a line that is used for predictions. */
const MIN_TEXELS = 3;
/** Number of texels above which a line's predictions have high confidence. */
const LONG_LINE = 8;
/** Greatest number of texels that count in a line. */
const MAX_MEMORY = 128;
/** Greatest difference between the codes of a texel and of the line that it extends. */
const FIT = 1;
/** Greatest difference between the codes of a line's first two texels. */
const FIRST_FIT = 64;
/** Greatest difference of the codes of two calm neighbours. */
const CALM = 8;

/**
 * Decodes the codes of faces in place; returns the mask of changed texels. `before` has the codes of the previous ring,
 * of which `codes` must be a copy; only changed texels are decoded. If `before` is null, all texels are decoded.
 */
export function decodeRanges(
  raw: Uint8Array,
  codes: Uint16Array,
  before: Uint16Array | null,
  tiles: readonly number[],
  layout: Layout,
): Uint8Array {
  const area = layout.size * layout.size;
  const planes = readPlanes(raw);
  const scale = createScale(layout.step);
  const changed = new Uint8Array(codes.length);
  const listed = new Set(tiles);
  for (let face = 0; face < codes.length / area; face++) {
    const [start, end] = [face * area, (face + 1) * area];
    const faceArrays = {
      codes: codes.subarray(start, end),
      before: before?.subarray(start, end) ?? null,
      changed: changed.subarray(start, end),
    };
    decodeFace(face, faceArrays, listed, layout, scale, planes);
  }
  planes.finish();
  return changed;
}

interface Face {
  readonly codes: Uint16Array;
  readonly before: Uint16Array | null;
  readonly changed: Uint8Array;
}

/** Least-squares lines, one per column or one for a row: value at the last texel, slope, and number of texels. */
type Lines = ReturnType<typeof createLines>;

function createLines(number: number) {
  return { value: new Float64Array(number), slope: new Float64Array(number), count: new Uint8Array(number) };
}

function decodeFace(
  number: number,
  face: Face,
  listed: ReadonlySet<number>,
  { size, tile }: Layout,
  scale: Scale,
  planes: Planes,
): void {
  const tilesPerRow = size / tile;
  const columns = createLines(size);
  const row = createLines(1);
  const scan = { lastCode: 0 };
  for (let band = 0; band < tilesPerRow; band++) {
    const firstTile = (number * tilesPerRow + band) * tilesPerRow;
    const isListed = Array.from({ length: tilesPerRow }, (_, column) => listed.has(firstTile + column));
    const isVisited = isListed.map((value) => value || face.before === null);
    for (let x = 0; x < size; x++) if (band === 0 || !isVisited[Math.floor(x / tile)]) columns.count[x] = 0;
    for (let y = band * tile; y < (band + 1) * tile; y++) {
      const v = (2 * y + 1) / size - 1;
      row.count[0] = 0;
      for (let column = 0; column < tilesPerRow; column++) {
        if (!isVisited[column]) {
          row.count[0] = 0;
          continue;
        }
        for (let x = column * tile; x < (column + 1) * tile; x++) {
          const place = y * size + x;
          if (isListed[column]) face.changed[place] = planes.readChanged(predictChange(face, x, y, size)) ? 1 : 0;
          const u = (2 * x + 1) / size - 1;
          decodeTexel(face, x, y, size, Math.sqrt(1 + u * u + v * v), row, columns, scan, scale, planes);
        }
      }
    }
  }
}

/** Decodes a texel if it is new or changed, and extends the lines through it. */
function decodeTexel(
  face: Face,
  x: number,
  y: number,
  size: number,
  distance: number,
  row: Lines,
  columns: Lines,
  scan: { lastCode: number },
  scale: Scale,
  planes: Planes,
): void {
  const { codes } = face;
  const place = y * size + x;
  const isNew = face.before === null || face.changed[place] === 1;
  const left = x > 0 ? (codes[place - 1] as number) : NO_SURFACE;
  const above = y > 0 ? (codes[place - size] as number) : NO_SURFACE;
  const corner = x > 0 && y > 0 ? (codes[place - size - 1] as number) : NO_SURFACE;
  let isEmpty = codes[place] === NO_SURFACE;
  if (isNew) isEmpty = planes.readEmpty(median(left === NO_SURFACE, above === NO_SURFACE, corner === NO_SURFACE));
  if (isEmpty) {
    codes[place] = NO_SURFACE;
    row.count[0] = 0;
    columns.count[x] = 0;
    return;
  }
  const right = x + 1 < size && y > 0 ? (codes[place - size + 1] as number) : NO_SURFACE;
  const neighbour = predictCode(left, above, corner, right, scan.lastCode);
  const [n, m] = [row.count[0] as number, columns.count[x] as number];
  const byRow = n > 0 ? scale.code(predictValue(row, 0), distance, neighbour) : -1;
  const byColumn = m > 0 ? scale.code(predictValue(columns, x), distance, neighbour) : -1;
  if (isNew) {
    let guess = neighbour;
    let trust: Trust = left !== NO_SURFACE && above !== NO_SURFACE && Math.abs(left - above) <= CALM ? TRUST.calm : TRUST.low;
    if (n >= MIN_TEXELS && m >= MIN_TEXELS) {
      if (Math.abs(byRow - byColumn) <= FIT) {
        guess = scale.code((predictValue(row, 0) * n + predictValue(columns, x) * m) / (n + m), distance, byRow);
        trust = n + m > 2 * LONG_LINE ? TRUST.high : TRUST.medium;
      } else {
        guess = Math.abs(byRow - neighbour) <= Math.abs(byColumn - neighbour) ? byRow : byColumn;
        trust = TRUST.medium;
      }
    } else if (n >= MIN_TEXELS && Math.abs(byRow - neighbour) <= FIT) {
      guess = byRow;
      trust = n > LONG_LINE ? TRUST.high : TRUST.medium;
    } else if (n < MIN_TEXELS && m >= MIN_TEXELS && Math.abs(byColumn - neighbour) <= FIT) {
      guess = byColumn;
      trust = m > LONG_LINE ? TRUST.high : TRUST.medium;
    }
    const folded = planes.readResidual(trust);
    const code = (guess + ((folded >> 1) ^ -(folded & 1))) & 0xffff;
    if (code === NO_SURFACE) throw rangeError('a surface without range');
    codes[place] = code;
  }
  const code = codes[place] as number;
  const nearness = scale.nearness(code, distance);
  extend(row, 0, nearness, n > 0 && Math.abs(byRow - code) <= (n < 2 ? FIRST_FIT : FIT));
  extend(columns, x, nearness, m > 0 && Math.abs(byColumn - code) <= (m < 2 ? FIRST_FIT : FIT));
  scan.lastCode = code;
}

function predictValue(lines: Lines, index: number): number {
  return (lines.value[index] as number) + (lines.slope[index] as number);
}

/** Adds the next texel to a line, or starts a new line; the format prescribes the order of operations. */
function extend(lines: Lines, index: number, value: number, fits: boolean): void {
  if (!fits) {
    lines.value[index] = value;
    lines.slope[index] = 0;
    lines.count[index] = 1;
    return;
  }
  const line = predictValue(lines, index);
  const error = value - line;
  const n = Math.min((lines.count[index] as number) + 1, MAX_MEMORY);
  const scale = 1 / (n * (n + 1));
  lines.count[index] = n;
  lines.value[index] = line + (4 * n - 2) * scale * error;
  lines.slope[index] = (lines.slope[index] as number) + 6 * scale * error;
}

function predictChange({ before, changed }: Face, x: number, y: number, size: number): boolean {
  const place = y * size + x;
  const left = x > 0 && changed[place - 1] === 1;
  const above = y > 0 && changed[place - size] === 1;
  if (x === 0 || y === 0) return x === 0 ? above : left;
  if (before === null) return median(left, above, changed[place - size - 1] === 1);
  const ownCode = before[place] as number;
  const leftDifference = Math.abs((before[place - 1] as number) - ownCode);
  const aboveDifference = Math.abs((before[place - size] as number) - ownCode);
  return leftDifference <= aboveDifference ? left : above;
}

/** Predicts a code from its neighbours; `last` if they have no surface. */
function predictCode(left: number, above: number, corner: number, right: number, last: number): number {
  if (left === NO_SURFACE || above === NO_SURFACE || corner === NO_SURFACE)
    return [left, above, corner, right].find((code) => code !== NO_SURFACE) ?? last;
  const plane = left + above - corner;
  return Math.max(Math.min(left, above), Math.min(Math.max(left, above), plane));
}

/** Median of left, above, and left + above − corner, as for numbers 0 and 1. */
function median(left: boolean, above: boolean, corner: boolean): boolean {
  return corner ? left && above : left || above;
}
