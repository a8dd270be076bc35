/** Splits meshes into pieces of bounded size, and packs these into parts that are deserialised well within a frame. */
import type { Band, Part, Piece } from './messages';
import type { Arrays } from './surfaces';

/** Maximum number of triangles of a piece; they take about a megabyte. */
const MAX_TRIANGLES = 32_768;
/** Number of vertices that 16-bit indices can address. */
const SHORT_INDEX_VERTICES = 65_536;

/** Splits a mesh into pieces of bounded size; each has only the vertices that it uses. */
export function splitIntoPieces(mesh: Arrays): Arrays[] {
  const indicesPerPiece = 3 * MAX_TRIANGLES;
  if (mesh.indices.length === 0) return [];
  if (mesh.indices.length <= indicesPerPiece) return [mesh];
  const newIndices = new Int32Array(mesh.positions.length / 3).fill(-1);
  const count = Math.ceil(mesh.indices.length / indicesPerPiece);
  return Array.from({ length: count }, (_, n) => {
    return selectTriangles(mesh, mesh.indices.subarray(n * indicesPerPiece, (n + 1) * indicesPerPiece), newIndices);
  });
}

/** Mesh of some triangles, with the vertices that they use. `newIndices` is −1 for each vertex before and after. */
export function selectTriangles(
  mesh: Arrays,
  triangleIndices: Uint16Array | Uint32Array,
  newIndices = new Int32Array(mesh.positions.length / 3).fill(-1),
): Arrays {
  const indices = new Uint32Array(triangleIndices.length);
  const usedBuffer = new Uint32Array(triangleIndices.length);
  let count = 0;
  for (let n = 0; n < triangleIndices.length; n++) {
    const vertex = triangleIndices[n] as number;
    if (newIndices[vertex] === -1) {
      newIndices[vertex] = count;
      usedBuffer[count++] = vertex;
    }
    indices[n] = newIndices[vertex] as number;
  }
  const usedVertices = usedBuffer.subarray(0, count);
  for (const vertex of usedVertices) newIndices[vertex] = -1;
  return {
    ...mesh,
    indices: count <= SHORT_INDEX_VERTICES ? Uint16Array.from(indices) : indices,
    positions: rowsOf(mesh.positions, usedVertices, 3),
    normals: mesh.normals && rowsOf(mesh.normals, usedVertices, 3),
    uvs: mesh.uvs && rowsOf(mesh.uvs, usedVertices, 2),
    colors: mesh.colors && rowsOf(mesh.colors, usedVertices, 4),
  };
}

function rowsOf<T extends Float32Array | Uint16Array>(rows: T, selection: Uint32Array, width: number): T {
  const selected = new (rows.constructor as new (length: number) => T)(selection.length * width);
  for (let n = 0; n < selection.length; n++) {
    const row = selection[n] as number;
    for (let column = 0; column < width; column++) selected[n * width + column] = rows[row * width + column] as number;
  }
  return selected;
}

/** Maximum number of pieces and bands of a part together; each takes about 20 µs to deserialise. */
const MAX_PIECES = 32;
/** Maximum size of a part, bytes, unless a single piece is larger; limits the memory of waiting messages. */
const MAX_BYTES = 2 ** 22;

/** Packs all bands and pieces into parts, in order. */
export function packIntoParts(bands: readonly Band[], pieces: readonly Piece[]): Part[] {
  const parts: { bands: Band[]; pieces: Piece[] }[] = [];
  let [count, bytes] = [0, 0];
  /** Last part if an item of this size fits, else a new one; counts the item. */
  const partWithRoomFor = (size: number): { bands: Band[]; pieces: Piece[] } => {
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
  for (const band of bands) partWithRoomFor(4 * band.bitmap.width * band.bitmap.height).bands.push(band);
  const sent = new Set<string | Float32Array | null>();
  for (const piece of pieces) {
    const { sharedKey, placements } = piece;
    const withNeededArrays = sharedKey !== null && sent.has(sharedKey) ? withoutArrays(piece) : piece;
    // Pieces of a mesh share placements; transferring them with one piece detaches them for the others.
    const isShared = placements !== null && sent.has(placements);
    const transferable = isShared ? { ...withNeededArrays, placements: placements.slice() } : withNeededArrays;
    sent.add(sharedKey).add(placements);
    partWithRoomFor(arraysOf(transferable).reduce((sum, array) => sum + array.byteLength, 0)).pieces.push(transferable);
  }
  return parts;
}

/** One piece, without its arrays, for each shader program that the pieces need. */
export function samplesOf(pieces: readonly Piece[]): Piece[] {
  const samples = new Map<string, Piece>();
  for (const piece of pieces) {
    const { normals, uvs, colors, material } = piece;
    const { image, cutoff, emission, glow, isUnlit } = material;
    const placements = piece.placements && new Float32Array(0);
    const parts = [normals, uvs, colors, placements, image, cutoff, emission, glow];
    const kind = [...parts.map((part) => part !== null), isUnlit].join();
    if (!samples.has(kind)) samples.set(kind, { ...withoutArrays(piece), placements });
  }
  return [...samples.values()];
}

/** Buffers to transfer with a part. */
export function transferablesOf({ bands, pieces }: Part): Transferable[] {
  const buffers = pieces.flatMap(arraysOf).map((array) => array.buffer as ArrayBuffer);
  return [...new Set(buffers), ...bands.map(({ bitmap }) => bitmap)];
}

export function arraysOf(piece: Omit<Arrays, 'material'> & Pick<Piece, 'placements'>) {
  const { positions, normals, uvs, colors, indices, placements } = piece;
  return [positions, normals, uvs, colors, indices, placements].filter((array) => array !== null);
}

/** Copy of a piece without the arrays that an earlier piece of the same mesh has. */
function withoutArrays(piece: Piece): Piece {
  return { ...piece, ...selectTriangles(piece, new Uint16Array(0), new Int32Array(0)) };
}
