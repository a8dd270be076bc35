/** Placements of meshes: twelve numbers each, rows of 3 × 4. */
import type { Point } from '../bundle/manifest';
import type { Glb, Node } from './glb';

/** Numbers per placement. */
export const ROWS = 12;

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] as const;

export function isIdentity(rows: Float64Array): boolean {
  return rows.length === ROWS && rows.every((value, n) => value === IDENTITY[n]);
}

/** Position of a root node; the origin by default. */
export function originOf(translation: readonly number[] | undefined): Point {
  const [x, y, z] = translation ?? [0, 0, 0];
  const origin = [Number(x), Number(y), Number(z)] as const;
  if (!origin.every(Number.isFinite)) throw new Error('expected an origin of three numbers');
  return origin;
}

/** Name and placements of a node. */
export interface PlacedNode {
  readonly name: string;
  readonly rows: Float64Array;
}

/** Placed nodes by the index of their mesh. */
export async function placementsByMesh(glb: Glb, nodes: readonly Node[]): Promise<Map<number, PlacedNode[]>> {
  const byMesh = new Map<number, PlacedNode[]>();
  for (const node of nodes) {
    if (node.mesh === undefined) continue;
    const placed = byMesh.get(node.mesh) ?? [];
    byMesh.set(node.mesh, placed);
    placed.push({ name: typeof node.name === 'string' ? node.name : '', rows: await readPlacements(glb, node) });
  }
  return byMesh;
}

/** Placements of a node in the root's frame: its matrix, or its instancing attributes. */
async function readPlacements(glb: Glb, node: Node): Promise<Float64Array> {
  const rows = node.extensions?.EXT_mesh_gpu_instancing ? await readInstances(glb, node) : matrixOf(node);
  if (!rows.every(Number.isFinite)) throw new Error('expected placements of finite numbers');
  return rows;
}

function matrixOf({ matrix }: Node): Float64Array {
  if (matrix === undefined) return Float64Array.from(IDENTITY);
  if (!Array.isArray(matrix) || matrix.length !== 16) throw new Error('expected matrices of 16 numbers');
  // glTF matrices are column-major.
  return Float64Array.from({ length: ROWS }, (_, n) => matrix[4 * (n % 4) + Math.floor(n / 4)] as number);
}

async function readInstances(glb: Glb, node: Node): Promise<Float64Array> {
  const attributes = node.extensions?.EXT_mesh_gpu_instancing?.attributes ?? {};
  const read = async (name: string, width: number): Promise<Float32Array | null> => {
    if (attributes[name] === undefined) return null;
    const rows = await glb.read(attributes[name], width);
    if (!(rows instanceof Float32Array)) throw new Error(`expected placements whose ${name} has 32 bits`);
    return rows;
  };
  const reads = [read('TRANSLATION', 3), read('ROTATION', 4), read('SCALE', 3)] as const;
  const [translations, rotations, scales] = await Promise.all(reads);
  const counts = [[translations, 3], [rotations, 4], [scales, 3]] as const;
  const numbers = counts.flatMap(([rows, width]) => (rows ? [rows.length / width] : []));
  const [count] = numbers;
  if (count === undefined || numbers.some((other) => other !== count) || node.matrix !== undefined)
    throw new Error('expected arrays of placements of one length');
  const placements = new Float64Array(ROWS * count);
  for (let n = 0; n < count; n++) compose(placements, n, translations, rotations, scales);
  return placements;
}

/** Writes the placement that scales, rotates by a quaternion (x, y, z, w) and translates. */
function compose(
  placements: Float64Array,
  n: number,
  translations: Float32Array | null,
  rotations: Float32Array | null,
  scales: Float32Array | null,
): void {
  const part = (rows: Float32Array | null, width: number, column: number, missing: number): number =>
    rows ? (rows[width * n + column] as number) : missing;
  const quaternion = [0, 1, 2, 3].map((axis) => part(rotations, 4, axis, axis === 3 ? 1 : 0));
  // Normalised, because rounding to float32 changes the length.
  const size = Math.sqrt(quaternion.reduce((sum, component) => sum + component * component, 0)) || 1;
  const [x, y, z, w] = quaternion.map((component) => component / size) as [number, number, number, number];
  const rotation = [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
  ];
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++)
      placements[ROWS * n + 4 * row + column] = (rotation[3 * row + column] as number) * part(scales, 3, column, 1);
    placements[ROWS * n + 4 * row + 3] = part(translations, 3, row, 0);
  }
}

/** Concatenates placements, translated by an offset in float64 and then rounded. */
export function concatPlacements(parts: readonly Float64Array[], offset: Point): Float32Array {
  const all = new Float32Array(parts.reduce((sum, part) => sum + part.length, 0));
  let place = 0;
  for (const part of parts) {
    for (let n = 0; n < part.length; n++)
      all[place++] = (part[n] as number) + (n % 4 === 3 ? (offset[Math.floor((n % ROWS) / 4)] as number) : 0);
  }
  return all;
}
