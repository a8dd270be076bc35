/** Decodes the geometry of a ring, or of dynamic objects, into pieces that can be uploaded one by one. */
import type { Point } from '../bundle/manifest';
import { contentOf, pictureOf } from './files';
import { at, type Glb, type MaterialEntry, type Node, openGlb, type Primitive } from './glb';
import type { Geometry, GeometryRequest, Material, Piece } from './messages';
import { chopped, type Matrix, placementRows } from './pieces';

/** Folder of the files of a bundle; files refer to each other within it. */
const FOLDER = 'files/';

const IDENTITY: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Buffers of the bundle by their URIs in its files. */
const kept = new Map<string, Uint8Array>();

export async function decodeGeometry(request: GeometryRequest): Promise<Geometry> {
  const { name } = request.glb;
  const content = await Promise.all([request.glb, ...request.parts].map(contentOf));
  request.parts.forEach((part, number) => {
    const data = content[number + 1];
    if (data && part.name.endsWith('.bin')) kept.set(part.name.slice(FOLDER.length), data);
  });
  try {
    const glb = openGlb(content[0] as Uint8Array<ArrayBuffer>, kept);
    const whole = await piecesOf(glb, request);
    return {
      pieces: whole.flatMap(chopped),
      images: await imagesOf(glb, request, content as Uint8Array<ArrayBuffer>[]),
      triangles: whole.reduce((sum, piece) => sum + trianglesOf(piece), 0),
    };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new Error(reason.startsWith(FOLDER) ? reason : `${name}: ${reason}`);
  }
}

function trianglesOf({ indices, placements }: Piece): number {
  return (indices.length / 3) * (placements ? placements.length / 12 : 1);
}

/** Pictures that the page does not have yet, by URI. */
async function imagesOf(
  glb: Glb,
  { known, parts }: GeometryRequest,
  content: readonly Uint8Array<ArrayBuffer>[],
): Promise<Record<string, ImageBitmap>> {
  const images: Record<string, ImageBitmap> = Object.create(null) as Record<string, ImageBitmap>;
  for (const { uri } of glb.document.images ?? []) {
    const name = FOLDER + uri;
    const number = parts.findIndex((part) => part.name === name);
    const data = content[number + 1];
    if (number >= 0 && data) images[name] = await pictureOf(name, data);
    else if (!known.includes(name)) throw new Error(`${name} is not there`);
  }
  return images;
}

/** Pieces by mesh and material: static nodes that show one mesh are its placements, dynamic ones stay apart. */
async function piecesOf(glb: Glb, { center, isDynamic }: GeometryRequest): Promise<Piece[]> {
  const [root, ...nodes] = glb.document.nodes ?? [];
  const [x, y, z] = root?.translation ?? [0, 0, 0];
  const offset: Point = [(x ?? 0) - center[0], (y ?? 0) - center[1], (z ?? 0) - center[2]];
  const byMesh = new Map<number, { name: string; matrices: Matrix[] }[]>();
  for (const node of nodes) {
    if (node.mesh === undefined) continue;
    const matrices = await matricesOf(glb, node);
    const groups = byMesh.get(node.mesh) ?? [];
    byMesh.set(node.mesh, groups);
    const last = groups.at(-1);
    if (last && !isDynamic) last.matrices.push(...matrices);
    else groups.push({ name: node.name ?? '', matrices });
  }
  const pieces: Piece[] = [];
  for (const [mesh, groups] of byMesh) {
    for (const primitive of at(glb.document.meshes, mesh, 'mesh').primitives) {
      const arrays = await arraysOf(glb, primitive);
      for (const { name, matrices } of groups) {
        const isPlain = !isDynamic && matrices.length === 1 && matrices[0]?.every((value, n) => value === IDENTITY[n]);
        pieces.push({
          ...arrays,
          name,
          positions: isPlain ? moved(arrays.positions, offset) : arrays.positions,
          placements: isPlain ? null : placementRows(matrices, offset),
        });
      }
    }
  }
  return pieces;
}

function moved(positions: Float32Array, offset: Point): Float32Array {
  return positions.map((value, n) => value + (offset[n % 3] as number));
}

/** Matrices of a node's placements, 16 numbers in columns, to the frame of the root. */
async function matricesOf(glb: Glb, node: Node): Promise<Matrix[]> {
  const own = node.matrix ?? IDENTITY;
  if (own.length !== 16 || !own.every(Number.isFinite)) throw new Error('a node has no finite matrix of 16 numbers');
  const attributes = node.extensions?.EXT_mesh_gpu_instancing?.attributes;
  if (!attributes) return [own];
  const [translations, rotations, scales] = await Promise.all(
    ([['TRANSLATION', 3], ['ROTATION', 4], ['SCALE', 3]] as const).map(([name, width]) =>
      attributes[name] === undefined ? null : glb.read(attributes[name], width),
    ),
  );
  const count = Math.max(...[translations, scales].map((rows) => (rows?.length ?? 0) / 3), (rotations?.length ?? 0) / 4);
  return Array.from({ length: count }, (_, n) => {
    const [qx, qy, qz, qw] = rotations ? rotations.subarray(4 * n, 4 * n + 4) : [0, 0, 0, 1];
    const [sx, sy, sz] = scales ? scales.subarray(3 * n, 3 * n + 3) : [1, 1, 1];
    const [tx, ty, tz] = translations ? translations.subarray(3 * n, 3 * n + 3) : [0, 0, 0];
    return composed([tx, ty, tz] as number[], [qx, qy, qz, qw] as number[], [sx, sy, sz] as number[]);
  });
}

/** The matrix that scales, turns by a unit quaternion, and moves. */
function composed(move: readonly number[], turn: readonly number[], scale: readonly number[]): Matrix {
  const [x, y, z, w] = turn as [number, number, number, number];
  const [a, b, c] = scale as [number, number, number];
  return [
    a * (1 - 2 * (y * y + z * z)), a * 2 * (x * y + w * z), a * 2 * (x * z - w * y), 0,
    b * 2 * (x * y - w * z), b * (1 - 2 * (x * x + z * z)), b * 2 * (y * z + w * x), 0,
    c * 2 * (x * z + w * y), c * 2 * (y * z - w * x), c * (1 - 2 * (x * x + y * y)), 0,
    ...(move as [number, number, number]), 1,
  ]; // prettier-ignore
}

type Arrays = Omit<Piece, 'name' | 'placements'>;

async function arraysOf(glb: Glb, { attributes, indices, material }: Primitive): Promise<Arrays> {
  const optional = (name: string, width: number) =>
    attributes[name] === undefined ? null : glb.read(attributes[name], width);
  const [positions, normals, uvs, colors, corners] = await Promise.all([
    glb.read(attributes['POSITION'], 3),
    optional('NORMAL', 3),
    optional('TEXCOORD_0', 2),
    optional('COLOR_0', 4),
    glb.read(indices, 1),
  ]);
  const vertices = positions.length / 3;
  if (!(positions instanceof Float32Array) || !positions.every(Number.isFinite)) {
    throw new Error('expected finite positions of 32 bits');
  }
  if (!(corners instanceof Uint16Array || corners instanceof Uint32Array) || corners.length % 3 !== 0) {
    throw new Error('expected triangles of 16 or 32 bits');
  }
  if (corners.some((corner) => corner >= vertices)) throw new Error(`expected corners below ${vertices}`);
  const counts = [[normals, 3], [uvs, 2], [colors, 4]] as const;
  if (counts.some(([rows, width]) => rows && rows.length !== width * vertices)) {
    throw new Error(`expected attributes of ${vertices} vertices`);
  }
  if (colors && !(colors instanceof Uint16Array)) throw new Error('expected colours of 16 bits');
  return {
    positions,
    normals: normals && unitVectors(normals),
    uvs: uvs && Float32Array.from(uvs),
    colors: colors as Uint16Array | null,
    indices: corners,
    material: materialOf(glb, at(glb.document.materials, material, 'material')),
  };
}

/** Normals are bytes or floats; the vectors get length 1. */
function unitVectors(rows: ArrayLike<number>): Float32Array {
  const unit = new Float32Array(rows.length);
  for (let n = 0; n < rows.length; n += 3) {
    const [x, y, z] = [rows[n], rows[n + 1], rows[n + 2]] as [number, number, number];
    const size = Math.hypot(x, y, z) || 1;
    unit.set([x / size, y / size, z / size], n);
  }
  return unit;
}

function materialOf(glb: Glb, entry: MaterialEntry): Material {
  const surface = entry.pbrMetallicRoughness ?? {};
  const [red, green, blue, alpha] = surface.baseColorFactor ?? [1, 1, 1, 1];
  return {
    color: [red ?? 1, green ?? 1, blue ?? 1, alpha ?? 1],
    image: surface.baseColorTexture ? imageOf(glb, surface.baseColorTexture.index) : null,
    cutoff: entry.alphaMode === 'MASK' ? (entry.alphaCutoff ?? 0.5) : null,
  };
}

function imageOf({ document }: Glb, texture: number): string {
  const entry = at(document.textures, texture, 'texture');
  return FOLDER + at(document.images, entry.extensions?.EXT_texture_webp?.source ?? entry.source, 'image').uri;
}
