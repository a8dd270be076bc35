/** Division of meshes into pieces of bounded size. */
import type { Arrays } from './surfaces';

/** Greatest number of triangles of a piece: about a megabyte. */
const MAX_TRIANGLES = 32_768;
/** Number of vertices that 16-bit indices can address. */
const SHORT = 65_536;

/** The same triangles in pieces of bounded size, each with the vertices that it uses. */
export function chopped(whole: Arrays): Arrays[] {
  const corners = 3 * MAX_TRIANGLES;
  if (whole.indices.length === 0) return [];
  if (whole.indices.length <= corners) return [whole];
  const renamed = new Int32Array(whole.positions.length / 3).fill(-1);
  const count = Math.ceil(whole.indices.length / corners);
  return Array.from({ length: count }, (_, n) => {
    return chosenRows(whole, whole.indices.subarray(n * corners, (n + 1) * corners), renamed);
  });
}

/** Triangles by their indices, with the vertices that they use. `renamed` has −1 for each vertex, before and after. */
export function chosenRows(
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
