/** Reads the geometry of leaves: GLB files, and shared textures. */
import { sha256 } from '../../base/bytes';
import { LruCache } from '../../base/cache';
import { messageOf } from '../../base/errors';
import { pictureOf } from '../../decode/files';
import { entries, entryAt, type Glb, openGlb } from '../../decode/glb';
import type { Material } from '../../decode/messages';
import { arraysOf } from '../../decode/pieces';
import { originOf, placementsByMesh } from '../../decode/placements';
import { type Arrays, FOLDER, primitiveOf } from '../../decode/surfaces';
import { damagedError, StoreError } from '../store/error';
import type { Bytes, Files } from '../store/files';
import type { Triple } from '../store/layout';
import type { StoredFile } from '../store/records';

/** Placed triangles of one material. */
export interface Piece extends Omit<Arrays, 'material'> {
  /** World position that placements are relative to, metres. */
  readonly origin: Triple;
  /** Twelve numbers for each copy: rows of 3 × 4. */
  readonly placements: Float32Array;
  readonly material: Omit<Material, 'image' | 'glow'>;
  readonly image: ImageBitmap | null;
  readonly glow: ImageBitmap | null;
}

/** Greatest size of a file's decoded arrays, bytes; real leaves have far smaller ones. */
const MAX_BYTES = 2 ** 28;
const PICTURE = /^(?:\.\.\/)+(images\/([0-9a-f]{16}\.webp))$/;

/** Size of the cache of textures, which leaves share; bytes. */
const CACHE_BYTES = 1 << 25;

/** Reads the texture with a path and version, or returns it from the cache. */
export type TextureReader = (path: string, version: string) => Promise<Bytes>;

export function createTextureReader(files: Files): TextureReader {
  const cache = new LruCache<Promise<Bytes>>(CACHE_BYTES);
  return (path, version) => {
    const cached = cache.get(path);
    if (cached) return cached;
    // The request is not aborted with this leaf, because other leaves may wait for the same texture.
    const content = files.read({ path, version }).then(({ bytes }) => bytes);
    cache.add(path, content, 0);
    content.then(({ length }) => cache.add(path, content, length), () => cache.delete(path));
    return content;
  };
}

/** Reads the pieces of all files of a leaf. */
export async function readLeaf(
  files: Files,
  read: TextureReader,
  leafFiles: readonly StoredFile[],
  signal: AbortSignal,
): Promise<Piece[]> {
  const parts = await Promise.all(
    leafFiles.map(async ([path, size, version]) => {
      // Servers do not compress the answers to range requests; the data are compressed already.
      const { bytes } = await files.read({ path, version, part: [0, size], signal });
      const digest = await sha256(bytes);
      const isListed = bytes.length === size && (digest === null || digest.startsWith(version));
      if (!isListed) throw damagedError(path, 'its size or SHA-256 is not that of the record');
      return decodePieces(read, path, bytes, signal);
    }),
  );
  return parts.flat();
}

/** Buffers to transfer without copying. */
export function buffersOf(pieces: readonly Piece[]): Transferable[] {
  const buffers = pieces.flatMap(arraysOf).map((array) => array.buffer as ArrayBuffer);
  const images = pieces.flatMap(({ image, glow }) => [image, glow]).filter((image) => image !== null);
  return [...new Set([...buffers, ...images])];
}

async function decodePieces(read: TextureReader, path: string, bytes: Bytes, signal: AbortSignal): Promise<Piece[]> {
  try {
    const { glb, paths } = renameImages(openGlb(bytes, new Map(), MAX_BYTES));
    const [root, ...nodes] = entries(glb.document.nodes, 'nodes');
    const origin = originOf(root?.translation);
    const byMesh = await placementsByMesh(glb, nodes);
    // Textures lie beside the folders of all levels.
    const folder = path.slice(0, path.lastIndexOf('geometry/')) + 'geometry/';
    const picture = async (name: string | null): Promise<ImageBitmap | null> => {
      if (name === null) return null;
      // The file's name is the hash of its content.
      const [file, hash] = [name.slice(FOLDER.length), name.slice(FOLDER.length, -'.webp'.length)];
      return pictureOf(name, await read(folder + paths.get(file), hash));
    };
    const pieces: Piece[] = [];
    for (const [mesh, placed] of byMesh) {
      const placements = Float32Array.from(placed.flatMap(({ rows }) => [...rows]));
      for (const primitive of entries(entryAt(glb.document.meshes, mesh, 'mesh').primitives, 'primitives')) {
        const { material, ...arrays } = await primitiveOf(glb, primitive);
        const { image, glow, ...plain } = material;
        const pictures = { image: await picture(image), glow: await picture(glow) };
        pieces.push({ ...arrays, ...pictures, origin, placements: placements.slice(), material: plain });
      }
    }
    return pieces;
  } catch (reason) {
    if (signal.aborted || reason instanceof StoreError) throw reason;
    throw damagedError(path, messageOf(reason));
  }
}

/** Replaces the paths of images by file names, which readers of materials expect; also returns the paths by name. */
function renameImages(glb: Glb): { glb: Glb; paths: ReadonlyMap<string, string> } {
  const paths = new Map<string, string>();
  const images = entries(glb.document.images, 'images').map(({ uri }) => {
    const [, path, name] = PICTURE.exec(String(uri)) ?? [];
    if (path === undefined || name === undefined) throw new Error(`expected images of the store, got ${String(uri)}`);
    paths.set(name, path);
    return { uri: name };
  });
  return { glb: { ...glb, document: { ...glb.document, images } }, paths };
}
