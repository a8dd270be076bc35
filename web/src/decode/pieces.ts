/**
 * Division of meshes into pieces of bounded size, and of pieces into parts that deserialise in a fraction of a frame.
 */
import type { Band, Part, Piece } from './messages';
import type { Arrays } from './surfaces';

/** Greatest number of triangles of a piece: about a megabyte. */
const MAX_TRIANGLES = 32_768;
/** Number of vertices that 16-bit indices can address. */
const SHORT = 65_536;

/** The same triangles in pieces of bounded size, each with the vertices that it uses. */
export function splitIntoPieces(whole: Arrays): Arrays[] {
  const corners = 3 * MAX_TRIANGLES;
  if (whole.indices.length === 0) return [];
  if (whole.indices.length <= corners) return [whole];
  const renamed = new Int32Array(whole.positions.length / 3).fill(-1);
  const count = Math.ceil(whole.indices.length / corners);
  return Array.from({ length: count }, (_, n) => {
    return selectTriangles(whole, whole.indices.subarray(n * corners, (n + 1) * corners), renamed);
  });
}

/** Triangles by their indices, with the vertices that they use. `renamed` has −1 for each vertex, before and after. */
export function selectTriangles(
  whole: Arrays,
  corners: Uint16Array | Uint32Array,
  renamed = new Int32Array(whole.positions.length / 3).fill(-1),
): Arrays {
  const indices = new Uint32Array(corners.length);
  const used = new Uint32Array(corners.length);
  let count = 0;
  for (let n = 0; n < corners.length; n++) {
    const vertex = corners[n] as number;
    if (renamed[vertex] === -1) {
      renamed[vertex] = count;
      used[count++] = vertex;
    }
    indices[n] = renamed[vertex] as number;
  }
  const chosen = used.subarray(0, count);
  for (const vertex of chosen) renamed[vertex] = -1;
  return {
    ...whole,
    indices: count <= SHORT ? Uint16Array.from(indices) : indices,
    positions: rowsOf(whole.positions, chosen, 3),
    normals: whole.normals && rowsOf(whole.normals, chosen, 3),
    uvs: whole.uvs && rowsOf(whole.uvs, chosen, 2),
    colors: whole.colors && rowsOf(whole.colors, chosen, 4),
  };
}

function rowsOf<T extends Float32Array | Uint16Array>(rows: T, chosen: Uint32Array, width: number): T {
  const found = new (rows.constructor as new (length: number) => T)(chosen.length * width);
  for (let n = 0; n < chosen.length; n++) {
    const row = chosen[n] as number;
    for (let column = 0; column < width; column++) found[n * width + column] = rows[row * width + column] as number;
  }
  return found;
}

/** Greatest number of pieces and bands of a part; deserialising one takes about 20 µs. */
const MAX_PIECES = 32;
/** Greatest size of a part in bytes, unless a single piece is larger; bounds the memory of waiting messages. */
const MAX_BYTES = 2 ** 22;

/** Packs all bands and pieces into parts, in order. */
export function packIntoParts(bands: readonly Band[], pieces: readonly Piece[]): Part[] {
  const parts: { bands: Band[]; pieces: Piece[] }[] = [];
  let [count, bytes] = [0, 0];
  const place = (size: number): { bands: Band[]; pieces: Piece[] } => {
    let last = parts.at(-1);
    if (!last || count === MAX_PIECES || bytes + size > MAX_BYTES) {
      last = { bands: [], pieces: [] };
      parts.push(last);
      [count, bytes] = [0, 0];
    }
    count += 1;
    bytes += size;
    return last;
  };
  for (const band of bands) place(4 * band.rows.width * band.rows.height).bands.push(band);
  const sent = new Set<string | Float32Array | null>();
  for (const piece of pieces) {
    const { same, placements } = piece;
    const whole = same !== null && sent.has(same) ? withoutArrays(piece) : piece;
    // Pieces of a mesh share placements; transferring them with one piece detaches them for the others.
    const own = placements && sent.has(placements) ? { ...whole, placements: placements.slice() } : whole;
    sent.add(same).add(placements);
    place(arraysOf(own).reduce((sum, array) => sum + array.byteLength, 0)).pieces.push(own);
  }
  return parts;
}

/** One piece of each kind of surface, without its arrays. */
export function samplesOf(pieces: readonly Piece[]): Piece[] {
  const samples = new Map<string, Piece>();
  for (const piece of pieces) {
    const { normals, uvs, colors, placements, material } = piece;
    const { image, cutoff, emission, glow, isUnlit } = material;
    const parts = [normals, uvs, colors, placements, image, cutoff, emission, glow];
    const kind = [...parts.map((part) => part !== null), isUnlit].join();
    if (!samples.has(kind)) samples.set(kind, { ...withoutArrays(piece), placements: placements && new Float32Array(0) });
  }
  return [...samples.values()];
}

/** Buffers to transfer with a part. */
export function contentsOf({ bands, pieces }: Part): Transferable[] {
  const buffers = pieces.flatMap(arraysOf).map((array) => array.buffer as ArrayBuffer);
  return [...new Set(buffers), ...bands.map(({ rows }) => rows)];
}

function arraysOf({ positions, normals, uvs, colors, indices, placements }: Piece): (Float32Array | Uint16Array | Uint32Array)[] {
  return [positions, normals, uvs, colors, indices, placements].filter((array) => array !== null);
}

/** Copy of a piece without arrays that an earlier piece has. */
function withoutArrays(piece: Piece): Piece {
  const { normals, uvs, colors } = piece;
  return {
    ...piece,
    positions: new Float32Array(0),
    normals: normals && new Float32Array(0),
    uvs: uvs && new Float32Array(0),
    colors: colors && new Uint16Array(0),
    indices: new Uint16Array(0),
  };
}
