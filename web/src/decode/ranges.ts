/** Decodes the ranges of a map: docs/stream.md, "Files of ranges". All decoders yield bit-identical codes. */
import { createScale, damaged, NOTHING, type Planes, readPlanes, type Scale, TRUST, type Trust } from './planes';

/** Division of a map. */
export interface Layout {
  /** Texels along a face. */
  readonly size: number;
  /** Texels along a tile; it divides `size`. */
  readonly tile: number;
  /** Natural logarithm of the ratio of two consecutive codes' ranges. */
  readonly step: number;
}

/**
 * Least texels of a line that predicts, least texels of a line that is trusted; greatest texels that a line remembers.
 */
const [MIN, LONG, MEMORY] = [3, 8, 128] as const;
/**
 * Greatest differences in codes: of a texel from its line, of the second texel from the first, of two calm neighbours.
 */
const [FIT, FIRST_FIT, CALM] = [1, 64, 8] as const;

/**
 * Decodes the codes of faces in place. Without `before` all texels are new; otherwise only changed ones, and `codes`
 * holds a copy of `before`. Returns the mask of changed texels.
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
    const own = {
      codes: codes.subarray(start, end),
      before: before?.subarray(start, end) ?? null,
      changed: changed.subarray(start, end),
    };
    decodeFace(face, own, listed, layout, scale, planes);
  }
  planes.finish();
  return changed;
}

interface Face {
  readonly codes: Uint16Array;
  readonly before: Uint16Array | null;
  readonly changed: Uint8Array;
}

/** Least-squares lines along the columns, or along one row: value at the last texel, slope, and number of texels. */
interface Lines {
  readonly value: Float64Array;
  readonly slope: Float64Array;
  readonly count: Uint8Array;
}

function createLines(number: number): Lines {
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
  const across = size / tile;
  const columns = createLines(size);
  const row = createLines(1);
  const walk = { last: 0 };
  for (let band = 0; band < across; band++) {
    const before = (number * across + band) * across;
    const isListed = Array.from({ length: across }, (_, column) => listed.has(before + column));
    const isVisited = isListed.map((own) => own || face.before === null);
    for (let x = 0; x < size; x++) {
      if (band === 0 || !isVisited[Math.floor(x / tile)]) columns.count[x] = 0;
    }
    for (let y = band * tile; y < (band + 1) * tile; y++) {
      const v = (2 * y + 1) / size - 1;
      row.count[0] = 0;
      for (let column = 0; column < across; column++) {
        if (!isVisited[column]) {
          row.count[0] = 0;
          continue;
        }
        for (let x = column * tile; x < (column + 1) * tile; x++) {
          const place = y * size + x;
          if (isListed[column]) {
            face.changed[place] = planes.changed(predictChange(face, x, y, size)) ? 1 : 0;
          }
          const u = (2 * x + 1) / size - 1;
          texel(face, x, y, size, Math.sqrt(1 + u * u + v * v), row, columns, walk, scale, planes);
        }
      }
    }
  }
}

/** Decodes a texel if it is new, and adds it to the lines through it. */
function texel(
  face: Face,
  x: number,
  y: number,
  size: number,
  distance: number,
  row: Lines,
  columns: Lines,
  walk: { last: number },
  scale: Scale,
  planes: Planes,
): void {
  const { codes } = face;
  const place = y * size + x;
  const isNew = face.before === null || face.changed[place] === 1;
  const left = x > 0 ? (codes[place - 1] as number) : NOTHING;
  const above = y > 0 ? (codes[place - size] as number) : NOTHING;
  const corner = x > 0 && y > 0 ? (codes[place - size - 1] as number) : NOTHING;
  let isNothing = codes[place] === NOTHING;
  if (isNew) isNothing = planes.nothing(median(left === NOTHING, above === NOTHING, corner === NOTHING));
  if (isNothing) {
    codes[place] = NOTHING;
    row.count[0] = 0;
    columns.count[x] = 0;
    return;
  }
  const right = x + 1 < size && y > 0 ? (codes[place - size + 1] as number) : NOTHING;
  const neighbour = predictCode(left, above, corner, right, walk.last);
  const [n, m] = [row.count[0] as number, columns.count[x] as number];
  const byRow = n > 0 ? scale.code(next(row, 0), distance, neighbour) : -1;
  const byColumn = m > 0 ? scale.code(next(columns, x), distance, neighbour) : -1;
  if (isNew) {
    let guess = neighbour;
    let trust: Trust =
      left !== NOTHING && above !== NOTHING && Math.abs(left - above) <= CALM ? TRUST.calm : TRUST.low;
    if (n >= MIN && m >= MIN) {
      if (Math.abs(byRow - byColumn) <= FIT) {
        guess = scale.code((next(row, 0) * n + next(columns, x) * m) / (n + m), distance, byRow);
        trust = n + m > 2 * LONG ? TRUST.high : TRUST.some;
      } else {
        guess = Math.abs(byRow - neighbour) <= Math.abs(byColumn - neighbour) ? byRow : byColumn;
        trust = TRUST.some;
      }
    } else if (n >= MIN && Math.abs(byRow - neighbour) <= FIT) {
      guess = byRow;
      trust = n > LONG ? TRUST.high : TRUST.some;
    } else if (n < MIN && m >= MIN && Math.abs(byColumn - neighbour) <= FIT) {
      guess = byColumn;
      trust = m > LONG ? TRUST.high : TRUST.some;
    }
    const reflectInto = planes.residual(trust);
    const code = (guess + ((reflectInto >> 1) ^ -(reflectInto & 1))) & 0xffff;
    if (code === NOTHING) throw damaged('a surface without range');
    codes[place] = code;
  }
  const code = codes[place] as number;
  const nearness = scale.nearness(code, distance);
  extend(row, 0, nearness, n > 0 && Math.abs(byRow - code) <= (n < 2 ? FIRST_FIT : FIT));
  extend(columns, x, nearness, m > 0 && Math.abs(byColumn - code) <= (m < 2 ? FIRST_FIT : FIT));
  walk.last = code;
}

function next(lines: Lines, at: number): number {
  return (lines.value[at] as number) + (lines.slope[at] as number);
}

/** Adds the next texel to a line, or starts a new line; the format prescribes the order of operations. */
function extend(lines: Lines, at: number, value: number, fits: boolean): void {
  if (!fits) {
    lines.value[at] = value;
    lines.slope[at] = 0;
    lines.count[at] = 1;
    return;
  }
  const line = next(lines, at);
  const error = value - line;
  const n = Math.min((lines.count[at] as number) + 1, MEMORY);
  const scale = 1 / (n * (n + 1));
  lines.count[at] = n;
  lines.value[at] = line + (4 * n - 2) * scale * error;
  lines.slope[at] = (lines.slope[at] as number) + 6 * scale * error;
}

function predictChange({ before, changed }: Face, x: number, y: number, size: number): boolean {
  const place = y * size + x;
  const left = x > 0 && changed[place - 1] === 1;
  const above = y > 0 && changed[place - size] === 1;
  if (x === 0 || y === 0) return x === 0 ? above : left;
  if (before === null) return median(left, above, changed[place - size - 1] === 1);
  const own = before[place] as number;
  const toLeft = Math.abs((before[place - 1] as number) - own);
  const toAbove = Math.abs((before[place - size] as number) - own);
  return toLeft <= toAbove ? left : above;
}

/** Code predicted from the neighbours; `last` if none shows a surface. */
function predictCode(left: number, above: number, corner: number, right: number, last: number): number {
  if (left === NOTHING || above === NOTHING || corner === NOTHING) {
    return [left, above, corner, right].find((code) => code !== NOTHING) ?? last;
  }
  const plane = left + above - corner;
  return Math.max(Math.min(left, above), Math.min(Math.max(left, above), plane));
}

/** Median of left, above, and left + above − corner. */
function median(left: boolean, above: boolean, corner: boolean): boolean {
  return corner ? left && above : left || above;
}
