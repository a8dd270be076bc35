/** Meshes of three.js for pieces of geometry. The page uploads and frees their arrays itself. */
import type { BufferAttribute, GLBufferAttribute, InterleavedBuffer, RawShaderMaterial, Texture } from 'three';
import { BufferGeometry, InstancedBufferGeometry, InterleavedBufferAttribute, Mesh } from 'three';
import type { Piece } from '../decode/messages';
import { ROWS } from '../decode/placements';
import { type Buffers, createBuffers, type MeshArrays, type Store } from './buffers';
import type { Step } from './uploads';

export type PieceMesh = Mesh<BufferGeometry, RawShaderMaterial>;

/** Resources from which meshes are made. */
export interface MeshResources {
  readonly gl: WebGL2RenderingContext;
  readonly store: Store;
  /** Copies a texture on the GPU. */
  readonly copy: (texture: Texture) => Texture;
  /** Lets three.js prepare meshes before they are drawn. */
  readonly warmUp: (meshes: readonly PieceMesh[]) => void;
}

/** Resources that are freed with a mesh. */
interface MeshParts {
  readonly arrays: MeshArrays;
  readonly placements: Buffers<'placement'> | null;
  readonly sharedKey: string | null;
}

const partsByMesh = new WeakMap<PieceMesh, MeshParts>();

/** Piece whose arrays are allocated on the GPU. */
export type PreparedPiece = ReturnType<typeof preparePiece>;

/** Allocates the arrays of a piece, unless another mesh shares them. */
export function preparePiece(piece: Piece, { gl, store }: MeshResources) {
  const { sharedKey } = piece;
  let isNew = false;
  const arrays = store.acquire(sharedKey, () => {
    isNew = true;
    return arraysOf(gl, piece);
  });
  const rows = piece.placements;
  const placements = rows && createBuffers(gl, { placement: { rows, width: ROWS } });
  const parts = { arrays, placements, sharedKey };
  return {
    /** Steps that upload the arrays. */
    *steps(): Generator<Step> {
      if (isNew) yield* arrays.steps();
      if (placements) yield* placements.steps();
    },
    /** Creates the mesh; all steps must have run. */
    make(material: RawShaderMaterial): PieceMesh {
      const mesh = meshOf(piece.name, parts, material);
      partsByMesh.set(mesh, parts);
      return mesh;
    },
    /** Frees the arrays of a piece without a mesh. */
    free: (): void => free(parts, store),
  };
}

function meshOf(name: string, { arrays, placements }: MeshParts, material: RawShaderMaterial): PieceMesh {
  const geometry = placements ? createPlacedGeometry(placements) : new BufferGeometry();
  const { index, ...attributes } = arrays.attributes;
  // three.js accepts attributes and indices with external buffers, although its types do not say so.
  for (const [role, attribute] of Object.entries(attributes))
    geometry.setAttribute(role, attribute as unknown as BufferAttribute);
  geometry.setIndex(index as unknown as BufferAttribute);
  const mesh = new Mesh(geometry, material);
  mesh.name = name;
  // The morph moves vertices out of the bounding boxes.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** Frees the GPU resources of a mesh, except arrays that other meshes share. */
export function disposeMesh(mesh: PieceMesh, store: Store): void {
  const { geometry } = mesh;
  // Otherwise three.js would free the arrays of the geometry.
  for (const name of Object.keys(geometry.attributes)) geometry.deleteAttribute(name);
  geometry.setIndex(null);
  geometry.dispose();
  const parts = partsByMesh.get(mesh);
  if (parts) free(parts, store);
  partsByMesh.delete(mesh);
}

function free({ arrays, placements, sharedKey }: MeshParts, store: Store): void {
  if (store.release(sharedKey)) arrays.dispose();
  placements?.dispose();
}

function arraysOf(gl: WebGL2RenderingContext, { positions, normals, uvs, colors, indices }: Piece): MeshArrays {
  return createBuffers(gl, {
    position: { rows: positions, width: 3 },
    normal: normals && { rows: normals, width: 3 },
    uv: uvs && { rows: uvs, width: 2 },
    color: colors && { rows: colors, width: 4, isNormalized: true },
    index: { rows: indices, width: 1 },
  });
}

/** Reads each placement as three rows from one interleaved array. */
function createPlacedGeometry({ attributes }: Buffers<'placement'>): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const rows = Object.assign(attributes.placement as GLBufferAttribute, {
    isInstancedBufferAttribute: true,
    meshPerAttribute: 1,
    // three.js derives the number type from this array.
    array: new Float32Array(0),
  });
  ['row_x', 'row_y', 'row_z'].forEach((name, row) => {
    geometry.setAttribute(name, new InterleavedBufferAttribute(rows as unknown as InterleavedBuffer, 4, 4 * row));
  });
  geometry.instanceCount = rows.count;
  return geometry;
}
