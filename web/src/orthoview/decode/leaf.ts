/** Reads the geometry of leaves: GLB files, and shared textures. */
import { LruCache } from '../../base/cache';
import { messageOf } from '../../base/errors';
import { pictureOf } from '../../decode/files';
import { entries, entryAt, type Glb, openGlb } from '../../decode/glb';
import type { Material } from '../../decode/messages';
import { placementsOf } from '../../decode/placements';
import { FOLDER, primitiveOf } from '../../decode/surfaces';
import { sha256 } from '../../base/bytes';
import { damaged, StoreError } from '../store/error';
import type { Bytes, Files } from '../store/files';
import type { Triple } from '../store/layout';
import type { Shard } from '../store/records';

/** Placed triangles of one material. */
export interface Piece {
  /** World position that placements are relative to, metres. */
  readonly origin: Triple;
  readonly positions: Float32Array;
  /** Unit vectors, or null for flat shading. */
  readonly normals: Float32Array | null;
  readonly uvs: Float32Array | null;
  readonly colors: Uint16Array | null;
  readonly indices: Uint16Array | Uint32Array;
  /** Twelve numbers for each copy: rows of 3 × 4. */
  readonly placements: Float32Array;
  readonly material: Omit<Material, 'image' | 'glow'>;
  readonly image: ImageBitmap | null;
  readonly glow: ImageBitmap | null;
}

/** Greatest size of a file's arrays, bytes; a leaf has a small part of it. */
const MAX_BYTES = 2 ** 28;
const PICTURE = /^(?:\.\.\/)+(images\/([0-9a-f]{16}\.webp))$/;

/** Size of the texture cache in bytes; leaves share textures. */
const KEPT = 1 << 25;

/** Texture cache. */
export class Textures {
  readonly #kept = new LruCache<Promise<Bytes>>(KEPT);

  constructor(readonly files: Files) {}

  read(path: string, version: string): Promise<Bytes> {
    const found = this.#kept.get(path);
    if (found) return found;
    // Other leaves may wait for the same texture, so it is read even if this leaf is no longer needed.
    const content = contentOf(this.files, path, version, undefined, undefined);
    this.#kept.add(path, content, 0);
    content.then(
      ({ length }) => this.#kept.add(path, content, length),
      () => this.#kept.delete(path),
    );
    return content;
  }

}

/** Pieces of the files of a leaf. */
export async function readLeaf(
  files: Files,
  textures: Textures,
  listed: readonly Shard[],
  signal: AbortSignal,
): Promise<Piece[]> {
  const parts = await Promise.all(
    listed.map(async ([path, size, version]) => {
      // A range request, so that no server compresses compressed data again.
      const bytes = await contentOf(files, path, version, [0, size], signal);
      const digest = await sha256(bytes);
      if (bytes.length !== size || (digest !== null && !digest.startsWith(version)))
        throw damaged(path, 'it is not the file that the record lists');
      return piecesOf(textures, path, bytes, signal);
    }),
  );
  return parts.flat();
}

/** Buffers to transfer without copying. */
export function buffersOf(pieces: readonly Piece[]): Transferable[] {
  const arrays = pieces.flatMap((piece) => [
    piece.positions,
    piece.normals,
    piece.uvs,
    piece.colors,
    piece.indices,
    piece.placements,
  ]);
  const images = pieces.flatMap(({ image, glow }) => [image, glow]);
  const buffers = arrays.flatMap((array): Transferable[] => (array ? [array.buffer as ArrayBuffer] : []));
  return [...new Set([...buffers, ...images.filter((image) => image !== null)])];
}

async function contentOf(
  files: Files,
  path: string,
  version: string,
  part: readonly [number, number] | undefined,
  signal: AbortSignal | undefined,
): Promise<Bytes> {
  const found = await files.read({ path, version, signal, ...(part ? { part } : {}) });
  if (!found) throw new StoreError('gone', `${path}: the file is gone`);
  return found.bytes;
}

async function piecesOf(textures: Textures, path: string, bytes: Bytes, signal: AbortSignal): Promise<Piece[]> {
  try {
    const opened = openGlb(bytes, new Map(), MAX_BYTES);
    const [glb, pictures] = [withNames(opened), picturesOf(opened)];
    const [root, ...nodes] = entries(glb.document.nodes, 'nodes');
    const origin = originOf(root?.translation);
    const byMesh = new Map<number, Float64Array[]>();
    for (const node of nodes) {
      if (node.mesh === undefined) continue;
      byMesh.set(node.mesh, [...(byMesh.get(node.mesh) ?? []), await placementsOf(glb, node)]);
    }
    // Textures lie beside the folders of all levels.
    const folder = path.slice(0, path.lastIndexOf('geometry/')) + 'geometry/';
    const picture = async (name: string | null): Promise<ImageBitmap | null> => {
      if (name === null) return null;
      const place = pictures.get(name.slice(FOLDER.length));
      // Its name is a hash of its content.
      return pictureOf(name, await textures.read(folder + place, name.slice(FOLDER.length, -5)));
    };
    const pieces: Piece[] = [];
    for (const [mesh, rows] of byMesh) {
      const placements = Float32Array.from(rows.flatMap((each) => [...each]));
      for (const primitive of entries(entryAt(glb.document.meshes, mesh, 'mesh').primitives, 'primitives')) {
        const { material, ...arrays } = await primitiveOf(glb, primitive);
        const { image, glow, ...plain } = material;
        const [own, light] = [await picture(image), await picture(glow)];
        pieces.push({ ...arrays, origin, placements: placements.slice(), material: plain, image: own, glow: light });
      }
    }
    return pieces;
  } catch (reason) {
    if (signal.aborted || reason instanceof StoreError) throw reason;
    throw damaged(path, messageOf(reason));
  }
}

/** Paths of textures below the geometry folder, by their names. */
function picturesOf({ document }: Glb): Map<string, string> {
  const found = entries(document.images, 'images').map(({ uri }): readonly [string, string] => {
    const [, place, name] = PICTURE.exec(String(uri)) ?? [];
    if (place === undefined || name === undefined) throw new Error('expected textures of the store');
    return [name, place];
  });
  return new Map(found);
}

/** Rewrites texture URIs to the names that readers of materials expect. */
function withNames(glb: Glb): Glb {
  const images = entries(glb.document.images, 'images').map(({ uri }) => ({ uri: String(uri).replace(PICTURE, '$2') }));
  return { ...glb, document: { ...glb.document, images } };
}

function originOf(translation: readonly number[] = [0, 0, 0]): Triple {
  const [x, y, z] = translation.map(Number);
  const origin = [x, y, z] as Triple;
  if (!origin.every(Number.isFinite)) throw new Error('expected an origin of three numbers');
  return origin;
}
