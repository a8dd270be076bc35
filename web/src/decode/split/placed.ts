/** Splits large triangles of meshes with placements, separately for each placement that is near enough. */
import { selectTriangles } from '../pieces';
import { ROWS } from '../placements';
import type { Arrays } from '../surfaces';
import type { Rule } from './rule';
import { type Budget, largeTriangles, splitArrays } from './triangles';

/** Triangles of a mesh, for several placements or, without placements, already placed. */
export interface Part {
  readonly arrays: Arrays;
  readonly placements: Float32Array | null;
}

/** Parts that show a mesh in all its placements; one part with the same arrays if no triangle is large anywhere. */
export function splitPlaced(mesh: Arrays, placements: Float32Array, rule: Rule, budget: Budget): Part[] {
  const ball = ballOf(mesh);
  const large = new Set<number>();
  const [near, far]: [Float32Array[], Float32Array[]] = [[], []];
  for (let start = 0; start < placements.length; start += ROWS) {
    const rows = placements.subarray(start, start + ROWS);
    const found = isHarmless(ball, rows, rule) ? [] : largeTriangles(transformMesh(mesh, rows), rule);
    (found.length > 0 ? near : far).push(rows);
    for (const triangle of found) large.add(triangle);
  }
  if (large.size === 0) return [{ arrays: mesh, placements }];
  const all = Array.from({ length: mesh.indices.length / 3 }, (_, triangle) => triangle);
  const some = pickTriangles(mesh, [...large].sort((a, b) => a - b));
  const apart = near.map((rows) => splitArrays(transformMesh(some, rows), rule, budget));
  const parts: Part[] = [{ arrays: mergeMeshes(apart), placements: null }];
  if (far.length > 0) parts.push({ arrays: some, placements: concatRows(far) });
  const rest = all.filter((triangle) => !large.has(triangle));
  if (rest.length > 0) parts.push({ arrays: pickTriangles(mesh, rest), placements });
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
    const found = new (rows[0].constructor as new (size: number) => T)(rows.reduce((sum, own) => sum + own.length, 0));
    rows.reduce((start, own) => {
      found.set(own, start);
      return start + own.length;
    }, 0);
    return found;
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
interface Ball {
  readonly center: readonly [number, number, number];
  readonly radius: number;
  readonly longest: number;
}

function ballOf({ positions, indices }: Arrays): Ball {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (let n = 0; n < positions.length; n++) {
    low[n % 3] = Math.min(low[n % 3] as number, positions[n] as number);
    high[n % 3] = Math.max(high[n % 3] as number, positions[n] as number);
  }
  let longest = 0;
  for (let n = 0; n < indices.length; n++) {
    const i = 3 * (indices[n] as number);
    const j = 3 * (indices[n % 3 === 2 ? n - 2 : n + 1] as number);
    const [x, y, z] = [0, 1, 2].map((k) => (positions[i + k] as number) - (positions[j + k] as number)) as Triple;
    longest = Math.max(longest, x * x + y * y + z * z);
  }
  const center = low.map((value, k) => (value + (high[k] as number)) / 2) as Triple;
  const radius = Math.hypot(...low.map((value, k) => (high[k] as number) - value)) / 2;
  return { center, radius, longest: Math.sqrt(longest) };
}

type Triple = [number, number, number];

/** Whether no triangle of a mesh is large in a placement. */
function isHarmless({ center, radius, longest }: Ball, rows: Float32Array, rule: Rule): boolean {
  const [x, y, z] = pointOf(center, rows);
  const stretch = stretchOf(rows);
  const [level, away] = [Math.hypot(x, z), Math.hypot(x, y, z)];
  const around = radius * stretch;
  return rule.isHarmless(longest * stretch, [Math.max(level - around, 0), level + around], Math.max(away - around, 0));
}

/** Upper bound of a placement's stretch of lengths; for placements without shear, the greatest scale. */
function stretchOf(rows: Float32Array): number {
  const at = (row: number, column: number): number => rows[4 * row + column] as number;
  const dot = (i: number, j: number): number => at(0, i) * at(0, j) + at(1, i) * at(1, j) + at(2, i) * at(2, j);
  const sums = [0, 1, 2].map((i) => [0, 1, 2].reduce((sum, j) => sum + Math.abs(dot(i, j)), 0));
  return Math.sqrt(Math.max(...sums));
}

function pointOf([x, y, z]: readonly [number, number, number], rows: Float32Array): Triple {
  return [0, 4, 8].map((row) => {
    const [a, b, c, d] = rows.subarray(row, row + 4) as unknown as [number, number, number, number];
    return a * x + b * y + c * z + d;
  }) as Triple;
}

/** A mesh in one placement; normals are transformed by the cofactor matrix, as in the shader. */
function transformMesh(mesh: Arrays, rows: Float32Array): Arrays {
  const at = (row: number, column: number): number => rows[4 * (row % 3) + (column % 3)] as number;
  const turned = new Float32Array(ROWS);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) {
      const [i, j] = [row + 1, column + 1];
      turned[4 * row + column] = at(i, j) * at(i + 1, j + 1) - at(i, j + 1) * at(i + 1, j);
    }
  }
  return {
    ...mesh,
    positions: transformVectors(mesh.positions, rows),
    normals: mesh.normals && transformVectors(mesh.normals, turned),
  };
}

function transformVectors(vectors: Float32Array, rows: Float32Array): Float32Array {
  const [a, b, c, d, e, f, g, h, i, j, k, l] = rows as unknown as number[] & Record<number, number>;
  const found = new Float32Array(vectors.length);
  for (let n = 0; n < vectors.length; n += 3) {
    const [x, y, z] = [vectors[n] as number, vectors[n + 1] as number, vectors[n + 2] as number];
    found[n] = (a as number) * x + (b as number) * y + (c as number) * z + (d as number);
    found[n + 1] = (e as number) * x + (f as number) * y + (g as number) * z + (h as number);
    found[n + 2] = (i as number) * x + (j as number) * y + (k as number) * z + (l as number);
  }
  return found;
}

/** Some triangles of a mesh, with the vertices that they use. */
function pickTriangles(mesh: Arrays, triangles: readonly number[]): Arrays {
  const corners = triangles.flatMap((triangle) => [0, 1, 2].map((n) => mesh.indices[3 * triangle + n] as number));
  return selectTriangles(mesh, Uint32Array.from(corners));
}

function concatRows(placements: readonly Float32Array[]): Float32Array {
  const all = new Float32Array(ROWS * placements.length);
  placements.forEach((rows, n) => all.set(rows, ROWS * n));
  return all;
}
