/** Decodes the geometry of a ring, or of dynamic objects, into pieces that can be uploaded one by one. */
import type { Point } from '../bundle/manifest';
import { contentOf, reasonOf } from './files';
import { at, entries, type Glb, openGlb } from './glb';
import { pictureOf } from './images';
import type { FileData, Geometry, GeometryRequest, Piece } from './messages';
import { chopped, shared } from './pieces';
import { isIdentity, placementsOf, rounded } from './placements';
import { FOLDER, pictureName, primitiveOf, sameOf } from './surfaces';

/** Pieces of a file, at most: each is drawn for itself. */
const MOST_PIECES = 2 ** 18;

/** Buffers of the bundle by their URIs in its files. */
export type Buffers = Map<string, Uint8Array>;

/** Decode a file; `kept` has the buffers of earlier requests and gets those of this one. */
export async function decodeGeometry(request: GeometryRequest, kept: Buffers): Promise<Geometry> {
  const parts = await partsOf(request.parts, kept);
  const { name } = request.glb;
  const content = await contentOf(request.glb);
  try {
    const glb = openGlb(content, kept);
    const pieces = await piecesOf(glb, request);
    return {
      pieces,
      images: await imagesOf(glb, parts, request.known),
      triangles: pieces.reduce((sum, { indices, placements }) => {
        return sum + (indices.length / 3) * (placements ? placements.length / 12 : 1);
      }, 0),
    };
  } catch (error) {
    const reason = reasonOf(error);
    throw new Error(reason.startsWith(FOLDER) ? reason : `${name}: ${reason}`);
  }
}

/** The contents of parts by name. Whole buffers are kept even if another part is damaged, since they come only once. */
async function partsOf(parts: readonly FileData[], kept: Buffers): Promise<Map<string, Uint8Array<ArrayBuffer>>> {
  const found = new Map<string, Uint8Array<ArrayBuffer>>();
  const results = await Promise.allSettled(
    parts.map(async (part) => {
      const data = await contentOf(part);
      found.set(part.name, data);
      if (part.name.endsWith('.bin')) kept.set(part.name.slice(FOLDER.length), data);
    }),
  );
  const failed = results.find((result) => result.status === 'rejected');
  if (failed) throw failed.reason as Error;
  return found;
}

/** Pictures that the page does not have yet, by name. */
async function imagesOf(
  glb: Glb,
  parts: ReadonlyMap<string, Uint8Array<ArrayBuffer>>,
  known: readonly string[],
): Promise<Record<string, ImageBitmap>> {
  const images: Record<string, ImageBitmap> = {};
  try {
    for (const entry of entries(glb.document.images, 'images')) {
      const name = pictureName(entry);
      const data = parts.get(name);
      if (data && !Object.hasOwn(images, name)) images[name] = await pictureOf(name, data);
      else if (!data && !known.includes(name)) throw new Error(`${name} is not there`);
    }
  } catch (error) {
    for (const image of Object.values(images)) image.close();
    throw error;
  }
  return images;
}

/** Placements of a mesh: static nodes that show it are one group, dynamic ones stay apart. */
interface Placed {
  readonly name: string;
  readonly rows: Float64Array[];
}

async function piecesOf(glb: Glb, { glb: file, center, isDynamic }: GeometryRequest): Promise<Piece[]> {
  const [root, ...nodes] = entries(glb.document.nodes, 'nodes');
  const offset = offsetOf(root?.translation, center);
  const byMesh = new Map<number, Placed[]>();
  for (const node of nodes) {
    if (node.mesh === undefined) continue;
    const rows = await placementsOf(glb, node);
    const groups = byMesh.get(node.mesh) ?? [];
    byMesh.set(node.mesh, groups);
    const last = groups.at(-1);
    if (last && !isDynamic) last.rows.push(rows);
    else groups.push({ name: typeof node.name === 'string' ? node.name : '', rows: [rows] });
  }
  const pieces: Piece[] = [];
  for (const [mesh, groups] of byMesh) {
    const placed = groups.map(({ name, rows }) => {
      const isPlain = !isDynamic && rows.length === 1 && rows.every(isIdentity);
      return { name, placements: isPlain ? null : rounded(rows, offset) };
    });
    for (const primitive of entries(at(glb.document.meshes, mesh, 'mesh').primitives, 'primitives')) {
      for (const [part, arrays] of chopped(await primitiveOf(glb, primitive)).entries()) {
        // Without placements positions are those of this region.
        const same = `${sameOf(glb, primitive, file.name)} ${part}`;
        for (const { name, placements } of placed) {
          if (placements) for (const own of shared(placements)) pieces.push({ ...arrays, name, placements: own, same });
          else pieces.push({ ...arrays, name, placements, same: null, positions: moved(arrays.positions, offset) });
          if (pieces.length > MOST_PIECES) throw new Error(`expected at most ${MOST_PIECES} pieces of geometry`);
        }
      }
    }
  }
  return pieces;
}

/** From the centre to the frame of the nodes, metres. */
function offsetOf(translation: readonly number[] | undefined, center: Point): Point {
  const [x, y, z] = translation ?? [0, 0, 0];
  const offset = [Number(x) - center[0], Number(y) - center[1], Number(z) - center[2]] as const;
  if (!offset.every(Number.isFinite)) throw new Error('expected an origin of three numbers');
  return offset;
}

/** Sums are float64, and rounded once. */
function moved(positions: Float32Array, offset: Point): Float32Array {
  return positions.map((value, n) => value + (offset[n % 3] as number));
}
