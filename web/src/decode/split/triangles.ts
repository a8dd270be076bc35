/** Splits the triangles of a mesh; interpolates the attributes of new vertices linearly. */
import type { Arrays } from '../surfaces';
import type { Rule, Vector } from './rule';

export interface Budget {
  /** Number of triangles that may still be added; splitting is aborted below 0. */
  triangles: number;
}

/** Greatest depth of nested cuts; with rounding errors the same edge might otherwise be cut for ever. */
const MAX_DEPTH = 192;

/**
 * Splits a surface into triangles that are small enough for a per-vertex morph. Returns the same arrays if no triangle
 * is too large or the budget is exceeded.
 */
export function splitArrays(arrays: Arrays, rule: Rule, budget: Budget): Arrays {
  const large = largeTriangles(arrays, rule);
  if (large.length === 0) return arrays;
  const { indices } = arrays;
  const mesh = createMesh(arrays, rule);
  const corners: number[] = [];
  let index = 0;
  for (const triangle of large) {
    for (; index < 3 * triangle; index++) corners.push(indices[index] as number);
    index += 3;
    budget.triangles += 1;
    mesh.split([indices[index - 3], indices[index - 2], indices[index - 1]] as unknown as Corners, (a, b, c) => {
      budget.triangles -= 1;
      corners.push(a, b, c);
      return budget.triangles >= 0;
    });
    if (budget.triangles < 0) return arrays;
  }
  for (; index < indices.length; index++) corners.push(indices[index] as number);
  return mesh.newVertexCount() > 0 ? mesh.build(corners) : arrays;
}

/** Indices of the triangles with an edge that may be cut. */
export function largeTriangles({ positions, indices }: Arrays, rule: Rule): number[] {
  const triangles: number[] = [];
  for (let n = 0; n < indices.length; n += 3) {
    const [i, j, k] = [3 * (indices[n] as number), 3 * (indices[n + 1] as number), 3 * (indices[n + 2] as number)];
    const longest = Math.max(lengthOf(positions, i, j), lengthOf(positions, j, k), lengthOf(positions, k, i));
    let [minRhoSquared, minDistanceSquared] = [Infinity, Infinity];
    for (const offset of [i, j, k]) {
      const [x, y, z] = [positions[offset] as number, positions[offset + 1] as number, positions[offset + 2] as number];
      const rhoSquared = x * x + z * z;
      minRhoSquared = Math.min(minRhoSquared, rhoSquared);
      minDistanceSquared = Math.min(minDistanceSquared, rhoSquared + y * y);
    }
    const [minRho, minDistance] = [Math.sqrt(minRhoSquared), Math.sqrt(minDistanceSquared)];
    const range = [Math.max(minRho - longest, 0), minRho + longest] as const;
    if (!rule.isUncut(longest, range, Math.max(minDistance - longest, 0))) triangles.push(n / 3);
  }
  return triangles;
}

export function lengthOf(positions: Float32Array, i: number, j: number): number {
  const x = (positions[i] as number) - (positions[j] as number);
  const y = (positions[i + 1] as number) - (positions[j + 1] as number);
  const z = (positions[i + 2] as number) - (positions[j + 2] as number);
  return Math.sqrt(x * x + y * y + z * z);
}

type Corners = readonly [number, number, number];

/** Rows of an attribute, to which rows of new vertices are added. */
interface Rows {
  readonly width: number;
  readonly source: Float32Array | Uint16Array;
  readonly added: number[];
}

function createMesh(arrays: Arrays, rule: Rule) {
  const sourceCount = arrays.positions.length / 3;
  const rowsOf = (source: Float32Array | Uint16Array, width: number): Rows => ({ source, width, added: [] });
  const positions = rowsOf(arrays.positions, 3);
  const normals = arrays.normals && rowsOf(arrays.normals, 3);
  const uvs = arrays.uvs && rowsOf(arrays.uvs, 2);
  const colors = arrays.colors && rowsOf(arrays.colors, 4);
  const attributes = [positions, normals, uvs, colors].filter((each) => each !== null);
  /** New vertices, by a key of the two ends of an edge; −1 for uncut edges. */
  const cuts = new Map<number, number>();
  let vertexCount = sourceCount;

  function valueOf({ source, width, added }: Rows, vertex: number, column: number): number {
    const isSource = vertex < sourceCount;
    return (isSource ? source[width * vertex + column] : added[width * (vertex - sourceCount) + column]) as number;
  }

  function pointOf(vertex: number): Vector {
    return [valueOf(positions, vertex, 0), valueOf(positions, vertex, 1), valueOf(positions, vertex, 2)];
  }

  /** Cuts an edge if necessary; returns the vertex of the cut, −1 for none. */
  function cutEdge(i: number, j: number): number {
    const key = i < j ? i * 2 ** 26 + j : j * 2 ** 26 + i;
    const cachedVertex = cuts.get(key);
    if (cachedVertex !== undefined) return cachedVertex;
    const [p, q] = [pointOf(i), pointOf(j)];
    const order = p[0] - q[0] || p[1] - q[1] || p[2] - q[2];
    const [from, to, a, b] = order <= 0 ? [i, j, p, q] : [j, i, q, p];
    const weight = rule.cutShare(a, b);
    const vertex = weight > 0 ? addVertex([[from, 1 - weight], [to, weight]]) : -1;
    cuts.set(key, vertex);
    return vertex;
  }

  /** Adds a weighted mean of vertices; returns −1 if it coincides with one of them. */
  function addVertex(parts: readonly (readonly [vertex: number, weight: number])[]): number {
    const [[base]] = parts as [readonly [number, number]];
    const mean = (rows: Rows, column: number): number => {
      const start = valueOf(rows, base, column);
      return parts.reduce((sum, [vertex, weight]) => sum + weight * (valueOf(rows, vertex, column) - start), start);
    };
    const position = [0, 1, 2].map((column) => Math.fround(mean(positions, column)));
    if (parts.some(([vertex]) => pointOf(vertex).every((x, column) => x === position[column]))) return -1;
    for (const rows of attributes) {
      for (let column = 0; column < rows.width; column++)
        rows.added.push(rows === positions ? (position[column] as number) : mean(rows, column));
    }
    return vertexCount++;
  }

  /** Adds a vertex on the axis for a triangle around the cylinder of radius `outer`; returns −1 for other triangles. */
  function addInteriorVertex(corners: Corners): number {
    const [a, b, c] = corners.map(pointOf) as [Vector, Vector, Vector];
    if ([a, b, c].some(([x, , z]) => Math.hypot(x, z) < rule.outer)) return -1;
    const areas = [cross(b, c), cross(c, a), cross(a, b)];
    const sum = areas.reduce((total, area) => total + area, 0);
    if (areas.some((area) => !(area / sum > 0))) return -1;
    return addVertex(corners.map((vertex, n) => [vertex, (areas[n] as number) / sum]));
  }

  return {
    /** Splits a triangle; `emit` receives the parts one by one and may abort by returning false. */
    split(triangle: Corners, emit: (a: number, b: number, c: number) => boolean): void {
      const pending: (readonly [...Corners, number])[] = [[...triangle, 0]];
      for (let part = pending.pop(); part; part = pending.pop()) {
        const [a, b, c, depth] = part;
        const corners = [[a, b, c], [b, c, a], [c, a, b]] as const;
        const edges = corners.map(([i, j, k]) => ({ i, j, k, middle: cutEdge(i, j) }));
        const cutEdges = edges.filter(({ middle }) => middle >= 0 && depth < MAX_DEPTH);
        const squaredLength = ({ i, j }: { i: number; j: number }): number => squaredDistance(pointOf(i), pointOf(j));
        const [longest] = cutEdges.sort((e, f) => squaredLength(f) - squaredLength(e));
        const interior = longest ? -1 : addInteriorVertex([a, b, c]);
        if (longest) {
          const { i, j, k, middle } = longest;
          pending.push([i, middle, k, depth + 1], [middle, j, k, depth + 1]);
        } else if (interior >= 0) {
          pending.push([a, b, interior, depth + 1], [b, c, interior, depth + 1], [c, a, interior, depth + 1]);
        } else if (!emit(a, b, c)) return;
      }
    },
    /** Number of new vertices. */
    newVertexCount: (): number => vertexCount - sourceCount,
    /** Arrays with the new vertices and the given indices. */
    build(corners: readonly number[]): Arrays {
      const join = <T extends Float32Array | Uint16Array>(rows: Rows): T => {
        const Type = rows.source.constructor as new (size: number) => T;
        const values = new Type(rows.width * vertexCount);
        values.set(rows.source);
        for (let n = 0; n < rows.added.length; n++) {
          const number = rows.added[n] as number;
          values[rows.source.length + n] = values instanceof Uint16Array ? Math.round(number) : number;
        }
        return values;
      };
      return {
        ...arrays,
        indices: vertexCount <= 2 ** 16 ? Uint16Array.from(corners) : Uint32Array.from(corners),
        positions: join<Float32Array>(positions),
        normals: normals && join<Float32Array>(normals),
        uvs: uvs && join<Float32Array>(uvs),
        colors: colors && join<Uint16Array>(colors),
      };
    },
  };
}

function cross(a: Vector, b: Vector): number {
  return a[0] * b[2] - a[2] * b[0];
}

function squaredDistance(a: Vector, b: Vector): number {
  return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
}
