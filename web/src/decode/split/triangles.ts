/** Splits the triangles of a mesh; attributes of new vertices are interpolated linearly. */
import type { Arrays } from '../surfaces';
import type { Rule, Vector } from './rule';

/** Remaining number of triangles that may be made; below 0 the work is aborted. */
export interface Budget {
  left: number;
}

/** Greatest depth of cuts, because rounding could make an edge reappear. */
const DEEPEST = 192;

/** The same surface in triangles small enough for a per-vertex morph; the same arrays if none is too large. */
export function splitArrays(whole: Arrays, rule: Rule, budget: Budget): Arrays {
  const chosen = largeTriangles(whole, rule);
  if (chosen.length === 0) return whole;
  const { indices } = whole;
  const mesh = createMesh(whole, rule);
  const corners: number[] = [];
  let place = 0;
  for (const triangle of chosen) {
    for (; place < 3 * triangle; place++) corners.push(indices[place] as number);
    place += 3;
    budget.left += 1;
    mesh.split([indices[place - 3], indices[place - 2], indices[place - 1]] as unknown as Corners, (a, b, c) => {
      budget.left -= 1;
      corners.push(a, b, c);
      return budget.left >= 0;
    });
    if (budget.left < 0) return whole;
  }
  for (; place < indices.length; place++) corners.push(indices[place] as number);
  return mesh.made() > 0 ? mesh.finished(corners) : whole;
}

/** Indices of the triangles with an edge that may be cut. */
export function largeTriangles({ positions, indices }: Arrays, rule: Rule): number[] {
  const found: number[] = [];
  for (let n = 0; n < indices.length; n += 3) {
    const [i, j, k] = [3 * (indices[n] as number), 3 * (indices[n + 1] as number), 3 * (indices[n + 2] as number)];
    const longest = Math.max(lengthOf(positions, i, j), lengthOf(positions, j, k), lengthOf(positions, k, i));
    let [rho, distance] = [Infinity, Infinity];
    for (const at of [i, j, k]) {
      const [x, y, z] = [positions[at] as number, positions[at + 1] as number, positions[at + 2] as number];
      const level = x * x + z * z;
      rho = Math.min(rho, level);
      distance = Math.min(distance, level + y * y);
    }
    const [nearest, away] = [Math.sqrt(rho), Math.sqrt(distance)];
    const range = [Math.max(nearest - longest, 0), nearest + longest] as const;
    if (!rule.isHarmless(longest, range, Math.max(away - longest, 0))) found.push(n / 3);
  }
  return found;
}

function lengthOf(positions: Float32Array, i: number, j: number): number {
  const x = (positions[i] as number) - (positions[j] as number);
  const y = (positions[i + 1] as number) - (positions[j + 1] as number);
  const z = (positions[i + 2] as number) - (positions[j + 2] as number);
  return Math.sqrt(x * x + y * y + z * z);
}

type Corners = readonly [number, number, number];

/** Growing rows of an attribute. */
interface Rows {
  readonly width: number;
  readonly source: Float32Array | Uint16Array;
  readonly more: number[];
}

function createMesh(whole: Arrays, rule: Rule) {
  const count = whole.positions.length / 3;
  const rows = (source: Float32Array | Uint16Array, width: number): Rows => ({ source, width, more: [] });
  const positions = rows(whole.positions, 3);
  const normals = whole.normals && rows(whole.normals, 3);
  const uvs = whole.uvs && rows(whole.uvs, 2);
  const colors = whole.colors && rows(whole.colors, 4);
  const attributes = [positions, normals, uvs, colors].filter((each) => each !== null);
  /** New vertices by the indices of their edges' ends; −1 for uncut edges. */
  const cuts = new Map<number, number>();
  let next = count;

  function value({ source, width, more }: Rows, vertex: number, column: number): number {
    return (vertex < count ? source[width * vertex + column] : more[width * (vertex - count) + column]) as number;
  }

  function point(vertex: number): Vector {
    return [value(positions, vertex, 0), value(positions, vertex, 1), value(positions, vertex, 2)];
  }

  /** Vertex at which an edge is cut, −1 for none. */
  function cut(i: number, j: number): number {
    const key = i < j ? i * 2 ** 26 + j : j * 2 ** 26 + i;
    const known = cuts.get(key);
    if (known !== undefined) return known;
    const [p, q] = [point(i), point(j)];
    const isOrdered = p[0] - q[0] || p[1] - q[1] || p[2] - q[2];
    const [from, to, a, b] = isOrdered <= 0 ? [i, j, p, q] : [j, i, q, p];
    const share = rule.share(a, b);
    const made = share > 0 ? add([[from, 1 - share], [to, share]]) : -1;
    cuts.set(key, made);
    return made;
  }

  /** Adds a weighted mean of vertices; −1 if it would coincide with one of them. */
  function add(parts: readonly (readonly [vertex: number, weight: number])[]): number {
    const [[base]] = parts as [readonly [number, number]];
    const mean = (each: Rows, column: number): number => {
      const start = value(each, base, column);
      return parts.reduce((sum, [vertex, weight]) => sum + weight * (value(each, vertex, column) - start), start);
    };
    const place = [0, 1, 2].map((column) => Math.fround(mean(positions, column)));
    if (parts.some(([vertex]) => point(vertex).every((x, column) => x === place[column]))) return -1;
    for (const each of attributes) {
      for (let column = 0; column < each.width; column++) {
        each.more.push(each === positions ? (place[column] as number) : mean(each, column));
      }
    }
    return next++;
  }

  /** Interior vertex of a triangle that surrounds the whole cylinder and has no cut edge; −1 for other triangles. */
  function addInteriorVertex(corners: Corners): number {
    const [a, b, c] = corners.map(point) as [Vector, Vector, Vector];
    if ([a, b, c].some(([x, , z]) => Math.hypot(x, z) < rule.outer)) return -1;
    const areas = [cross(b, c), cross(c, a), cross(a, b)];
    const sum = areas.reduce((total, area) => total + area, 0);
    if (areas.some((area) => !(area / sum > 0))) return -1;
    return add(corners.map((vertex, n) => [vertex, (areas[n] as number) / sum]));
  }

  return {
    /** Splits a triangle; `made` receives the parts one by one and may abort by returning false. */
    split(triangle: Corners, made: (a: number, b: number, c: number) => boolean): void {
      const rest: (readonly [...Corners, number])[] = [[...triangle, 0]];
      for (let part = rest.pop(); part; part = rest.pop()) {
        const [a, b, c, depth] = part;
        const edges = ([[a, b, c], [b, c, a], [c, a, b]] as const).map(([i, j, k]) => ({ i, j, k, at: cut(i, j) }));
        const [longest] = edges
          .filter(({ at }) => at >= 0 && depth < DEEPEST)
          .sort((one, other) => squared(point(other.i), point(other.j)) - squared(point(one.i), point(one.j)));
        const middle = longest ? -1 : addInteriorVertex([a, b, c]);
        if (longest) {
          const { i, j, k, at } = longest;
          rest.push([i, at, k, depth + 1], [at, j, k, depth + 1]);
        } else if (middle >= 0) {
          rest.push([a, b, middle, depth + 1], [b, c, middle, depth + 1], [c, a, middle, depth + 1]);
        } else if (!made(a, b, c)) {
          return;
        }
      }
    },
    /** Number of new vertices. */
    made: (): number => next - count,
    /** Arrays with the new vertices and the given indices. */
    finished(corners: readonly number[]): Arrays {
      const joined = <T extends Float32Array | Uint16Array>(each: Rows): T => {
        const Type = each.source.constructor as new (size: number) => T;
        const all = new Type(each.width * next);
        all.set(each.source);
        for (let n = 0; n < each.more.length; n++) {
          const item = each.more[n] as number;
          all[each.source.length + n] = all instanceof Uint16Array ? Math.round(item) : item;
        }
        return all;
      };
      return {
        ...whole,
        indices: next <= 2 ** 16 ? Uint16Array.from(corners) : Uint32Array.from(corners),
        positions: joined<Float32Array>(positions),
        normals: normals && joined<Float32Array>(normals),
        uvs: uvs && joined<Float32Array>(uvs),
        colors: colors && joined<Uint16Array>(colors),
      };
    },
  };
}

function cross(a: Vector, b: Vector): number {
  return a[0] * b[2] - a[2] * b[0];
}

function squared(a: Vector, b: Vector): number {
  return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
}
