/** Decodes the maps of a region: the whole map of ring 0, then the changes of each ring. */
import { messageOf } from '../base/errors';
import { inflateFile, pixelsOf } from './files';
import { type FileData, type FirstMapRequest, type MapUpdate, type NextMapRequest, tileAt } from './messages';
import { decodeRanges } from './ranges';

const FACES = 6;
/** Greatest number of texels along a face. */
const MAX_SIDE = 4096;
/** Size of the head of a range file, bytes: nine lengths. */
const HEAD_BYTES = 36;
/** Greatest size of a texel in a range file, bytes: 1 + 1 + 2 + 8 + 16 bits, rounded up to bytes. */
const MAX_TEXEL_BYTES = 4;
/** Greatest padding, bytes: one at the end of each of the nine bit planes. */
const PADDING_BYTES = 9;

/** Decoder of a region's maps, which stores the map of the last ring. */
export type Maps = ReturnType<typeof createMaps>;

interface State {
  readonly size: number;
  readonly tile: number;
  /** Tiles in a row of a tile sheet. */
  readonly across: number;
  /** Natural logarithm of the ratio of two consecutive codes' ranges. */
  readonly step: number;
  /** sRGB colours, RGBA, of all faces. */
  readonly color: Uint8Array<ArrayBuffer>;
  /** Range codes of all faces; null before ring 1. */
  codes: Uint16Array<ArrayBuffer> | null;
  /** Changed tiles of each ring, from ring 1 on. */
  readonly changed: number[][];
}

export function createMaps() {
  let state: State | null = null;
  return {
    async decodeFirst({ faceSize: size, tile, across, step, color }: FirstMapRequest): Promise<MapUpdate> {
      checkLayout(size, tile, across);
      if (color.length !== FACES) throw new Error(`map: expected six pictures, got ${color.length}`);
      const colors = new Uint8Array(4 * FACES * size * size);
      const faces = await Promise.all(color.map((file) => pixelsOf(file, size, size)));
      faces.forEach((face, number) => colors.set(face, number * face.length));
      state = { size, tile, across, step, color: colors, codes: null, changed: [] };
      return wholeMap(state);
    },
    async decodeNext(request: NextMapRequest): Promise<MapUpdate> {
      if (!state) throw new Error('map: a ring was requested before the first map');
      const { since, ring } = request;
      if (since !== null && !(Number.isInteger(since) && since >= 0 && since <= ring))
        throw new Error(`map: expected an earlier ring than ${ring}, got ${since}`);
      await apply(state, request);
      return since === null ? wholeMap(state) : changedTiles(state, since, ring);
    },
  };
}

function checkLayout(size: number, tile: number, across: number): void {
  const areCounts = [size, tile, across].every((value) => Number.isInteger(value) && value > 0);
  const isLayout = areCounts && size <= MAX_SIDE && size % tile === 0;
  if (!isLayout) throw new Error(`map: expected a face of at most ${MAX_SIDE} texels that whole tiles fill, got ${size} and tiles of ${tile}`);
}

async function apply(state: State, request: NextMapRequest): Promise<void> {
  const { ring, tiles, color } = request;
  const { size, tile } = state;
  const side = size / tile;
  if (ring !== state.changed.length + 1) throw new Error(`map: expected ring ${state.changed.length + 1}, got ${ring}`);
  const isTile = (number: number): boolean => Number.isInteger(number) && number >= 0 && number < FACES * side * side;
  if (!tiles.every(isTile)) throw new Error(`map: expected tile numbers below ${FACES * side * side}`);
  const next = await (state.codes ? decodeLaterCodes(state, state.codes, request) : decodeFirstCodes(state, request));
  const sheet = await readSheet(state, tiles.length, color);
  // Everything is decoded first, so that a damaged file leaves the previous map unchanged.
  if (sheet) putChanges(state, sheet, next.changed, tiles);
  state.codes = next.codes;
  state.changed.push([...tiles]);
}

function readSheet({ tile, across }: State, count: number, color: FileData | null): Promise<Uint8Array> | null {
  if (count === 0) return null;
  if (!color) throw new Error('map: expected a picture of the tiles that change, got none');
  return pixelsOf(color, across * tile, Math.ceil(count / across) * tile);
}

/** Decodes the codes of ring 1 from one file per face; also returns the mask of changed texels. */
async function decodeFirstCodes(state: State, { tiles, range }: NextMapRequest) {
  const area = state.size * state.size;
  const perFace = (state.size / state.tile) ** 2;
  if (range.length !== FACES) throw new Error(`map: expected six files of ranges, got ${range.length}`);
  const codes = new Uint16Array(FACES * area);
  const changed = new Uint8Array(FACES * area);
  await Promise.all(
    range.map(async (file, face) => {
      const raw = await inflateFile(file, HEAD_BYTES + PADDING_BYTES + MAX_TEXEL_BYTES * area);
      const inFace = tiles.filter((number) => Math.floor(number / perFace) === face);
      const faceTiles = inFace.map((number) => number % perFace);
      const faceCodes = codes.subarray(face * area, (face + 1) * area);
      changed.set(withFileName(file, () => decodeRanges(raw, faceCodes, null, faceTiles, state)), face * area);
    }),
  );
  return { codes, changed };
}

/** Decodes the codes of a later ring from one file; there is no file if nothing changes. */
async function decodeLaterCodes(state: State, before: Uint16Array<ArrayBuffer>, { tiles, range }: NextMapRequest) {
  const { tile } = state;
  const [file] = range;
  if (range.length !== (tiles.length > 0 ? 1 : 0))
    throw new Error(`map: expected one range file if tiles change and none otherwise, got ${range.length}`);
  if (!file) return { codes: before, changed: new Uint8Array(before.length) };
  const raw = await inflateFile(file, HEAD_BYTES + PADDING_BYTES + MAX_TEXEL_BYTES * tiles.length * tile * tile);
  const codes = before.slice();
  return { codes, changed: withFileName(file, () => decodeRanges(raw, codes, before, tiles, state)) };
}

/** Runs a function; adds the name of a file to its errors. */
function withFileName<T>(file: FileData, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Error(`${file.name}: ${messageOf(error)}`);
  }
}

/** Copies changed texels, and their eight neighbours on the same face, from a tile sheet to the map. */
function putChanges(state: State, sheet: Uint8Array, changed: Uint8Array, tiles: readonly number[]): void {
  const { size, tile, across } = state;
  tiles.forEach((number, order) => {
    const { face, x: left, y: top } = tileAt(number, size / tile, tile);
    const [sheetLeft, sheetTop] = [(order % across) * tile, Math.floor(order / across) * tile];
    for (let y = 0; y < tile; y++) {
      for (let x = 0; x < tile; x++) {
        if (!isNearChange(changed, face * size * size, left + x, top + y, size)) continue;
        const to = 4 * (face * size * size + (top + y) * size + left + x);
        const from = 4 * ((sheetTop + y) * across * tile + sheetLeft + x);
        for (let channel = 0; channel < 3; channel++) state.color[to + channel] = sheet[from + channel] as number;
      }
    }
  });
}

/** Whether a texel or one of its neighbours changes. */
function isNearChange(changed: Uint8Array, start: number, x: number, y: number, size: number): boolean {
  for (let row = Math.max(y - 1, 0); row <= Math.min(y + 1, size - 1); row++) {
    for (let column = Math.max(x - 1, 0); column <= Math.min(x + 1, size - 1); column++)
      if (changed[start + row * size + column]) return true;
  }
  return false;
}

function wholeMap({ size, color, codes }: State): MapUpdate {
  const area = size * size;
  const faces = Array.from({ length: FACES }, (_, face) => face);
  return {
    whole: true,
    color: faces.map((face) => color.slice(4 * face * area, 4 * (face + 1) * area)),
    codes: codes && faces.map((face) => codes.slice(face * area, (face + 1) * area)),
  };
}

/** Tiles that the rings after `since`, up to and including `ring`, change. */
function changedTiles(state: State, since: number, ring: number): MapUpdate {
  const { size, tile, color, codes } = state;
  if (!codes) throw new Error('map: a ring has no ranges');
  const tiles = Int32Array.from(new Set(state.changed.slice(since, ring).flat())).sort();
  const update = {
    whole: false as const,
    tiles,
    color: new Uint8Array(4 * tiles.length * tile * tile),
    codes: new Uint16Array(tiles.length * tile * tile),
  };
  tiles.forEach((number, order) => {
    const { face, x, y: top } = tileAt(number, size / tile, tile);
    for (let y = 0; y < tile; y++) {
      const from = face * size * size + (top + y) * size + x;
      const to = (order * tile + y) * tile;
      update.color.set(color.subarray(4 * from, 4 * (from + tile)), 4 * to);
      update.codes.set(codes.subarray(from, from + tile), to);
    }
  });
  return update;
}
