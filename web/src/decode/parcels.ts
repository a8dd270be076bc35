/** Divides geometry into parts, each of which the page deserialises in a fraction of a frame. */
import type { Band, Part, Piece } from './messages';

/** Greatest number of pieces and bands of a part; deserialising one takes about 20 µs. */
const MAX_PIECES = 32;
/** Greatest size of a part in bytes, unless a single piece is larger; bounds the memory of waiting messages. */
const MAX_BYTES = 2 ** 22;

/** Packs all bands and pieces into parts, in order. */
export function parcelled(bands: readonly Band[], pieces: readonly Piece[]): Part[] {
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
    const whole = same !== null && sent.has(same) ? emptied(piece) : piece;
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
    if (!samples.has(kind)) samples.set(kind, { ...emptied(piece), placements: placements && new Float32Array(0) });
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
function emptied(piece: Piece): Piece {
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
