/** Splits large triangles of meshes with placements, separately for each placement in which triangles are large. */
import { selectTriangles } from '../pieces';
import { ROWS } from '../placements';
import type { Arrays } from '../surfaces';
import type { Rule } from './rule';
import { type Budget, largeTriangles, lengthOf, splitArrays } from './triangles';

/** Triangles of a mesh with their placements; null if the positions are already placed. */
export interface Part {
  readonly arrays: Arrays;
  readonly placements: Float32Array | null;
}

/** Splits a mesh into parts that show it in all placements; without large triangles, the only part has its arrays. */
export function splitPlaced(mesh: Arrays, placements: Float32Array, rule: Rule, budget: Budget): Part[] {
  const bounds = boundsOf(mesh);
  const large = new Set<number>();
  const [near, far]: [Float32Array[], Float32Array[]] = [[], []];
  for (let start = 0; start < placements.length; start += ROWS) {
    const rows = placements.subarray(start, start + ROWS);
    const triangles = isUncut(bounds, rows, rule) ? [] : largeTriangles(transformMesh(mesh, rows), rule);
    (triangles.length > 0 ? near : far).push(rows);
    for (const triangle of triangles) large.add(triangle);
  }
  if (large.size === 0) return [{ arrays: mesh, placements }];
  const all = Array.from({ length: mesh.indices.length / 3 }, (_, triangle) => triangle);
  const largeMesh = pickTriangles(mesh, [...large].sort((a, b) => a - b));
  const placedMeshes = near.map((rows) => splitArrays(transformMesh(largeMesh, rows), rule, budget));
  const parts: Part[] = [{ arrays: mergeMeshes(placedMeshes), placements: null }];
  const farPlacements = Float32Array.from(far.flatMap((rows) => [...rows]));
  if (far.length > 0) parts.push({ arrays: largeMesh, placements: farPlacements });
  const small = all.filter((triangle) => !large.has(triangle));
  if (small.length > 0) parts.push({ arrays: pickTriangles(mesh, small), placements });
  return parts;
}

/** Merges meshes of the same attributes and material. */
function mergeMeshes(meshes: readonly Arrays[]): Arrays {
  const [first] = meshes as readonly [Arrays];
  const indices = new Uint32Array(meshes.reduce((sum, mesh) => sum + mesh.indices.length, 0));
  let [place, vertex] = [0, 0];
  for (const mesh of meshes) {
    for (const corner of mesh.indices) indices[place++] = vertex + corner;
    vertex += mesh.positions.length / 3;
  }
  const all = <T extends Float32Array | Uint16Array>(rowsOf: (mesh: Arrays) => T | null): T | null => {
    const rows = meshes.map(rowsOf).filter((each) => each !== null);
    if (!rows[0]) return null;
    const size = rows.reduce((sum, each) => sum + each.length, 0);
  const merged = new (rows[0].constructor as new (size: number) => T)(size);
    rows.reduce((start, each) => {
      merged.set(each, start);
      return start + each.length;
    }, 0);
    return merged;
  };
  return {
    ...first,
    indices,
    positions: all((mesh) => mesh.positions) ?? first.positions,
    normals: all((mesh) => mesh.normals),
    uvs: all((mesh) => mesh.uvs),
    colors: all((mesh) => mesh.colors),
  };
}

/** Bounding sphere of a mesh, and its longest edge. */
function boundsOf({ positions, indices }: Arrays) {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (let n = 0; n < positions.length; n++) {
    low[n % 3] = Math.min(low[n % 3] as number, positions[n] as number);
    high[n % 3] = Math.max(high[n % 3] as number, positions[n] as number);
  }
  let longest = 0;
  for (let n = 0; n < indices.length; n++) {
    const i = 3 * (indices[n] as number);
    const j = 3 * (indices[n % 3 === 2 ? n - 2 : n + 1] as number);
    longest = Math.max(longest, lengthOf(positions, i, j));
  }
  const center = low.map((value, k) => (value + (high[k] as number)) / 2) as Triple;
  const radius = Math.hypot(...low.map((value, k) => (high[k] as number) - value)) / 2;
  return { center, radius, longest };
}

type Triple = [number, number, number];

/** Whether no triangle of a mesh is large in a placement. */
function isUncut({ center, radius, longest }: ReturnType<typeof boundsOf>, rows: Float32Array, rule: Rule): boolean {
  const [x, y, z] = [0, 4, 8].map((first) => coordinateOf(...center, rows, first)) as Triple;
  const stretch = stretchOf(rows);
  const [rhoOfCenter, distance] = [Math.hypot(x, z), Math.hypot(x, y, z)];
  const placedRadius = radius * stretch;
  const range = [Math.max(rhoOfCenter - placedRadius, 0), rhoOfCenter + placedRadius] as const;
  return rule.isUncut(longest * stretch, range, Math.max(distance - placedRadius, 0));
}

/** Upper bound of the factor by which a placement stretches lengths; without shear, the greatest scale. */
function stretchOf(rows: Float32Array): number {
  const at = (row: number, column: number): number => rows[4 * row + column] as number;
  const dot = (i: number, j: number): number => at(0, i) * at(0, j) + at(1, i) * at(1, j) + at(2, i) * at(2, j);
  const sums = [0, 1, 2].map((i) => [0, 1, 2].reduce((sum, j) => sum + Math.abs(dot(i, j)), 0));
  return Math.sqrt(Math.max(...sums));
}

/** Coordinate of a placed point; `first` is the index of the row in the placement. */
function coordinateOf(x: number, y: number, z: number, rows: Float32Array, first: number): number {
  const [a, b] = [rows[first] as number, rows[first + 1] as number];
  return a * x + b * y + (rows[first + 2] as number) * z + (rows[first + 3] as number);
}

/** Transforms a mesh by a placement; normals by the cofactor matrix, as in the shader. */
function transformMesh(mesh: Arrays, rows: Float32Array): Arrays {
  const at = (row: number, column: number): number => rows[4 * (row % 3) + (column % 3)] as number;
  const cofactors = new Float32Array(ROWS);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) {
      const [i, j] = [row + 1, column + 1];
      cofactors[4 * row + column] = at(i, j) * at(i + 1, j + 1) - at(i, j + 1) * at(i + 1, j);
    }
  }
  return {
    ...mesh,
    positions: transformVectors(mesh.positions, rows),
    normals: mesh.normals && transformVectors(mesh.normals, cofactors),
  };
}

function transformVectors(vectors: Float32Array, rows: Float32Array): Float32Array {
  const transformed = new Float32Array(vectors.length);
  for (let n = 0; n < vectors.length; n += 3) {
    const [x, y, z] = [vectors[n] as number, vectors[n + 1] as number, vectors[n + 2] as number];
    for (let axis = 0; axis < 3; axis++) transformed[n + axis] = coordinateOf(x, y, z, rows, 4 * axis);
  }
  return transformed;
}

/** Mesh of some triangles, with the vertices that they use. */
function pickTriangles(mesh: Arrays, triangles: readonly number[]): Arrays {
  const corners = triangles.flatMap((triangle) => [0, 1, 2].map((n) => mesh.indices[3 * triangle + n] as number));
  return selectTriangles(mesh, Uint32Array.from(corners));
}
