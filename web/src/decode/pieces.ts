/** Placements as rows, and pieces that are small enough to be uploaded within a frame. */
import type { Point } from '../bundle/manifest';
import type { Piece } from './messages';

/** 16 numbers in columns. */
export type Matrix = readonly number[];

/** Triangles of a piece, at most: about a megabyte. */
const MOST_TRIANGLES = 32_768;

/** Rows of 3 × 4 of matrices, moved by an offset in float64 before they are rounded. */
export function placementRows(matrices: readonly Matrix[], offset: Point): Float32Array {
  const rows = new Float32Array(12 * matrices.length);
  matrices.forEach((matrix, number) => {
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 4; column++) {
        const value = matrix[4 * column + row] as number;
        rows[12 * number + 4 * row + column] = column === 3 ? value + (offset[row] as number) : value;
      }
    }
  });
  return rows;
}

/** The same triangles in pieces of a bounded size, each with its own vertices. */
export function chopped(piece: Piece): Piece[] {
  const corners = 3 * MOST_TRIANGLES;
  if (piece.indices.length <= corners) return [piece];
  const pieces: Piece[] = [];
  const renamed = new Int32Array(piece.positions.length / 3).fill(-1);
  for (let start = 0; start < piece.indices.length; start += corners) {
    const part = piece.indices.subarray(start, start + corners);
    const indices = new Uint32Array(part.length);
    const used: number[] = [];
    part.forEach((vertex, n) => {
      if (renamed[vertex] === -1) {
        renamed[vertex] = used.length;
        used.push(vertex);
      }
      indices[n] = renamed[vertex] as number;
    });
    pieces.push({
      ...piece,
      indices: used.length <= 65_536 ? Uint16Array.from(indices) : indices,
      positions: rowsOf(piece.positions, used, 3),
      normals: piece.normals && rowsOf(piece.normals, used, 3),
      uvs: piece.uvs && rowsOf(piece.uvs, used, 2),
      colors: piece.colors && rowsOf(piece.colors, used, 4),
    });
    for (const vertex of used) renamed[vertex] = -1;
  }
  return pieces;
}

function rowsOf<T extends Float32Array | Uint16Array>(rows: T, chosen: readonly number[], width: number): T {
  const found = new (rows.constructor as new (length: number) => T)(chosen.length * width);
  chosen.forEach((row, n) => {
    for (let column = 0; column < width; column++) found[n * width + column] = rows[row * width + column] as number;
  });
  return found;
}
