/** The maps of a region: ring 0 whole, then what each ring changes. */
import { contentOf, inflated, pictureOf } from './files';
import type { FileData, FirstMapRequest, MapUpdate, NextMapRequest } from './messages';
import { decodeRanges } from './ranges';

const FACES = 6;
/** Bytes of a file of ranges: nine lengths, and for each texel two flags, a pair of bits, a byte and a word at most. */
const [HEAD, MOST_BYTES, PLANES] = [36, 4, 9] as const;

/** Applies what rings change; keeps the last ring's map. */
export interface Maps {
  first(request: FirstMapRequest): Promise<MapUpdate>;
  next(request: NextMapRequest): Promise<MapUpdate>;
}

interface State {
  readonly size: number;
  readonly tile: number;
  readonly across: number;
  readonly step: number;
  /** sRGB codes, RGBA, of all faces. */
  readonly color: Uint8Array<ArrayBuffer>;
  codes: Uint16Array<ArrayBuffer> | null;
  /** Tiles that each ring from 1 on changes. */
  readonly changed: number[][];
}

export function createMaps(): Maps {
  let state: State | null = null;
  return {
    async first({ faceSize: size, tile, across, step, color }) {
      if (color.length !== FACES) throw new Error(`map: expected six pictures, got ${color.length}`);
      const whole = new Uint8Array(4 * FACES * size * size);
      const faces = await Promise.all(color.map((file) => pixelsOf(file, size, size)));
      faces.forEach((face, number) => whole.set(face, number * face.length));
      state = { size, tile, across, step, color: whole, codes: null, changed: [] };
      return wholeMap(state);
    },
    async next(request) {
      if (!state) throw new Error('map: a ring came before the first map');
      await apply(state, request);
      return request.since === null ? wholeMap(state) : changedTiles(state, request.since, request.ring);
    },
  };
}

async function apply(state: State, { ring, tiles, color, range }: NextMapRequest): Promise<void> {
  const { size, tile } = state;
  const side = size / tile;
  if (ring !== state.changed.length + 1) throw new Error(`map: expected ring ${state.changed.length + 1}, got ${ring}`);
  if (tiles.some((number) => number >= FACES * side * side)) throw new Error('map: expected tiles of the map, got others');
  const changed = await changedTexels(state, tiles, range);
  if (tiles.length > 0) {
    if (!color) throw new Error('map: expected a picture of the tiles that change, got none');
    const rows = Math.ceil(tiles.length / state.across);
    const sheet = await pixelsOf(color, state.across * tile, rows * tile);
    putChanges(state, sheet, changed, tiles);
  }
  state.changed.push([...tiles]);
}

/** Decode the codes of a ring; returns which texels change. */
async function changedTexels(state: State, tiles: readonly number[], range: readonly FileData[]): Promise<Uint8Array> {
  const { size, tile } = state;
  const area = size * size;
  const perFace = (size / tile) ** 2;
  if (state.codes) {
    const file = range[0];
    if (!file) {
      if (tiles.length > 0) throw new Error('map: expected ranges of the tiles that change, got none');
      return new Uint8Array(FACES * area);
    }
    const raw = await inflated(file.name, await contentOf(file), HEAD + PLANES + MOST_BYTES * tiles.length * tile * tile);
    const codes = state.codes.slice();
    const changed = named(file, () => decodeRanges(raw, codes, state.codes, tiles, state));
    state.codes = codes;
    return changed;
  }
  if (range.length !== FACES) throw new Error(`map: expected six files of ranges, got ${range.length}`);
  const codes = new Uint16Array(FACES * area);
  const changed = new Uint8Array(FACES * area);
  await Promise.all(
    range.map(async (file, face) => {
      const raw = await inflated(file.name, await contentOf(file), HEAD + PLANES + MOST_BYTES * area);
      const own = tiles.filter((number) => Math.floor(number / perFace) === face).map((number) => number % perFace);
      const place = codes.subarray(face * area, (face + 1) * area);
      changed.set(named(file, () => decodeRanges(raw, place, null, own, state)), face * area);
    }),
  );
  state.codes = codes;
  return changed;
}

/** Errors of a function name a file. */
function named<T>(file: FileData, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Error(`${file.name}: ${error instanceof Error ? error.message : 'damaged'}`);
  }
}

/** Put texels that change, and their eight neighbours on the same face, from a picture of tiles into the map. */
function putChanges(state: State, sheet: Uint8Array, changed: Uint8Array, tiles: readonly number[]): void {
  const { size, tile, across } = state;
  const side = size / tile;
  tiles.forEach((number, order) => {
    const face = Math.floor(number / (side * side));
    const [column, row] = [number % side, Math.floor(number / side) % side];
    const [fromX, fromY] = [(order % across) * tile, Math.floor(order / across) * tile];
    for (let y = 0; y < tile; y++) {
      for (let x = 0; x < tile; x++) {
        const [faceX, faceY] = [column * tile + x, row * tile + y];
        if (!isNear(changed, face * size * size, faceX, faceY, size)) continue;
        const to = 4 * (face * size * size + faceY * size + faceX);
        const from = 4 * ((fromY + y) * across * tile + fromX + x);
        for (let channel = 0; channel < 3; channel++) state.color[to + channel] = sheet[from + channel] as number;
      }
    }
  });
}

/** Whether a texel or one of its neighbours changes. */
function isNear(changed: Uint8Array, start: number, x: number, y: number, size: number): boolean {
  for (let row = Math.max(y - 1, 0); row <= Math.min(y + 1, size - 1); row++) {
    for (let column = Math.max(x - 1, 0); column <= Math.min(x + 1, size - 1); column++) {
      if (changed[start + row * size + column]) return true;
    }
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

/** The tiles that changed after a ring's map, up to another ring's. */
function changedTiles(state: State, since: number, ring: number): MapUpdate {
  const { size, tile, color, codes } = state;
  if (!codes) throw new Error('map: a ring has no ranges');
  const tiles = Int32Array.from(new Set(state.changed.slice(since, ring).flat())).sort();
  const side = size / tile;
  const update = {
    whole: false as const,
    tiles,
    color: new Uint8Array(4 * tiles.length * tile * tile),
    codes: new Uint16Array(tiles.length * tile * tile),
  };
  tiles.forEach((number, order) => {
    const face = Math.floor(number / (side * side));
    const [column, row] = [number % side, Math.floor(number / side) % side];
    for (let y = 0; y < tile; y++) {
      const from = face * size * size + (row * tile + y) * size + column * tile;
      const to = (order * tile + y) * tile;
      update.color.set(color.subarray(4 * from, 4 * (from + tile)), 4 * to);
      update.codes.set(codes.subarray(from, from + tile), to);
    }
  });
  return update;
}

/** The pixels of a picture of known size, RGBA from the top. */
async function pixelsOf(file: FileData, width: number, height: number): Promise<Uint8Array> {
  const bitmap = await pictureOf(file.name, await contentOf(file));
  try {
    if (bitmap.width !== width || bitmap.height !== height) {
      throw new Error(`${file.name}: expected ${width} × ${height} pixels, got ${bitmap.width} × ${bitmap.height}`);
    }
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    if (!context) throw new Error(`${file.name}: the browser cannot read pictures here`);
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    return new Uint8Array(data.buffer);
  } finally {
    bitmap.close();
  }
}
