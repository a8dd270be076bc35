/** Decodes the geometry of a ring or of dynamic objects into pieces, each of which is one draw call. */
import { messageOf } from '../base/errors';
import type { Point } from '../bundle/manifest';
import { contentOf, pictureOf } from './files';
import { entries, entryAt, type Glb, openGlb } from './glb';
import type { FileData, GeometryRequest, Piece, Triangles } from './messages';
import { splitIntoPieces } from './pieces';
import { concatPlacements, isIdentity, originOf, type PlacedNode, placementsByMesh, ROWS } from './placements';
import { splitPlaced } from './split/placed';
import { createRule, NO_GROWTH, type Rule, TOLERANCE } from './split/rule';
import { type Budget, splitArrays } from './split/triangles';
import { type Arrays, FOLDER, pictureName, primitiveOf, arraysKey } from './surfaces';

/** Greatest number of pieces of a file; each needs a draw call. */
const MAX_PIECES = 2 ** 18;
/** Greatest number of triangles that splitting may add to a file; they take some tens of megabytes. */
const MAX_ADDED_TRIANGLES = 2 ** 19;

/** Cached files of the bundle, by their URIs in other files: buffers, and the GLB of dynamic objects. */
export type Buffers = Map<string, Uint8Array<ArrayBuffer>>;

/** Content of a decoded file. */
export interface Decoded {
  readonly pieces: readonly Piece[];
  /** Pictures that the page does not have yet, by URI. */
  readonly images: Readonly<Record<string, ImageBitmap>>;
  readonly triangles: Triangles;
}

/** Decodes a file; `buffers` has the buffers of earlier requests, and those of this one are added. */
export async function decodeGeometry(request: GeometryRequest, buffers: Buffers): Promise<Decoded> {
  const parts = await readParts(request.parts, buffers);
  const { name } = request.glb;
  const content = await contentOfGlb(request, buffers);
  try {
    const glb = openGlb(content, buffers);
    const [surfaces, offset] = await readSurfaces(glb, request);
    const pieces = splitPieces(surfaces, offset, request);
    const fileCounts = surfaces.flatMap(({ arrays, placed }) => placed.map((group) => trianglesOf(arrays, group)));
    const pieceCounts = pieces.map((piece) => trianglesOf(piece, piece));
    const [inFile = 0, drawn = 0] = [fileCounts, pieceCounts].map((counts) => counts.reduce((sum, count) => sum + count, 0));
    const triangles = { inFile, drawn };
    return { pieces, images: await decodeImages(glb, parts, request.known), triangles };
  } catch (error) {
    const reason = messageOf(error);
    throw new Error(reason.startsWith(FOLDER) ? reason : `${name}: ${reason}`);
  }
}

/** Content of the requested GLB; the GLB of dynamic objects is cached, because every region requests it. */
async function contentOfGlb({ glb, isDynamic }: GeometryRequest, buffers: Buffers): Promise<Uint8Array<ArrayBuffer>> {
  const name = glb.name.slice(FOLDER.length);
  if (glb.data === null) {
    const content = buffers.get(name);
    if (!content) throw new Error(`${glb.name} is missing`);
    return content;
  }
  const content = await contentOf(glb);
  if (isDynamic) buffers.set(name, content);
  return content;
}

/** Number of triangles of a mesh in all its placements. */
function trianglesOf({ indices }: Pick<Piece, 'indices'>, { placements }: Pick<Piece, 'placements'>): number {
  return (indices.length / 3) * (placements ? placements.length / ROWS : 1);
}

/**
 * Returns the contents of parts by name. Valid buffers are cached even if another part is damaged, because each buffer
 * is sent only once.
 */
async function readParts(parts: readonly FileData[], buffers: Buffers): Promise<Map<string, Uint8Array<ArrayBuffer>>> {
  const contents = new Map<string, Uint8Array<ArrayBuffer>>();
  const results = await Promise.allSettled(
    parts.map(async (part) => {
      const data = await contentOf(part);
      contents.set(part.name, data);
      if (part.name.endsWith('.bin')) buffers.set(part.name.slice(FOLDER.length), data);
    }),
  );
  const failed = results.find((result) => result.status === 'rejected');
  if (failed) throw failed.reason as Error;
  return contents;
}

/** Decodes the pictures that the page does not have yet, by name. */
async function decodeImages(glb: Glb, parts: ReadonlyMap<string, Uint8Array<ArrayBuffer>>, known: readonly string[]) {
  const images: Record<string, ImageBitmap> = {};
  try {
    for (const entry of entries(glb.document.images, 'images')) {
      const name = pictureName(entry);
      const data = parts.get(name);
      if (data && !Object.hasOwn(images, name)) images[name] = await pictureOf(name, data);
      else if (!data && !known.includes(name)) throw new Error(`${name} is missing`);
    }
  } catch (error) {
    for (const image of Object.values(images)) image.close();
    throw error;
  }
  return images;
}

/** Primitive and its placements; without placements its positions are in the frame of the nodes. */
interface Surface {
  readonly arrays: Arrays;
  readonly sharedKey: string;
  readonly placed: readonly { readonly name: string; readonly placements: Float32Array | null }[];
}

async function readSurfaces(glb: Glb, { glb: file, center, isDynamic }: GeometryRequest): Promise<[Surface[], Point]> {
  const [root, ...nodes] = entries(glb.document.nodes, 'nodes');
  const [x, y, z] = originOf(root?.translation);
  // Vector from the centre to the origin of the nodes' frame, metres.
  const offset = [x - center[0], y - center[1], z - center[2]] as const;
  const surfaces: Surface[] = [];
  for (const [mesh, meshNodes] of await placementsByMesh(glb, nodes)) {
    // Static nodes of a mesh form one group; dynamic ones stay separate.
    const groups = isDynamic ? meshNodes.map((node) => [node]) : [meshNodes];
    const placed = groups.map((group) => {
      const [{ name }, rows] = [group[0] as PlacedNode, group.map((node) => node.rows)];
      const isPlain = !isDynamic && rows.length === 1 && rows.every(isIdentity);
      return { name, placements: isPlain ? null : concatPlacements(rows, offset) };
    });
    for (const primitive of entries(entryAt(glb.document.meshes, mesh, 'mesh').primitives, 'primitives'))
      surfaces.push({ arrays: await primitiveOf(glb, primitive), sharedKey: arraysKey(glb, primitive, file.name), placed });
  }
  return [surfaces, offset];
}

/** Splits surfaces into pieces, and their large triangles as finely as the budget allows. */
function splitPieces(surfaces: readonly Surface[], offset: Point, { growth, isDynamic }: GeometryRequest): Piece[] {
  for (let tolerance = TOLERANCE; ; tolerance *= 2) {
    const budget = { triangles: MAX_ADDED_TRIANGLES };
    // Triangles of dynamic objects are not split, because it depends on the pose which of them are large.
    const pieces = piecesOf(surfaces, offset, createRule(isDynamic ? NO_GROWTH : growth, tolerance), budget);
    if (budget.triangles >= 0) return pieces;
  }
}

function piecesOf(surfaces: readonly Surface[], offset: Point, rule: Rule, budget: Budget): Piece[] {
  const pieces: Piece[] = [];
  for (const { arrays, sharedKey, placed } of surfaces) {
    for (const { name, placements } of placed) {
      const translateArrays = (): Arrays => ({ ...arrays, positions: translate(arrays.positions, offset) });
      const parts = placements
        ? splitPlaced(arrays, placements, rule, budget)
        : [{ arrays: splitArrays(translateArrays(), rule, budget), placements }];
      for (const part of parts) {
        for (const [number, piece] of splitIntoPieces(part.arrays).entries()) {
          // Other regions cannot share split triangles or translated positions.
          const key = part.arrays === arrays ? `${sharedKey} ${number}` : null;
          if (part.placements?.length !== 0) pieces.push({ ...piece, name, sharedKey: key, placements: part.placements });
          if (pieces.length > MAX_PIECES) throw new Error(`expected at most ${MAX_PIECES} pieces of geometry`);
        }
      }
    }
  }
  return pieces;
}

/** Translates positions; the sums are computed in float64 and rounded once. */
function translate(positions: Float32Array, offset: Point): Float32Array {
  return positions.map((value, n) => value + (offset[n % 3] as number));
}
