/** Pieces of geometry as three.js holds them. Their arrays belong to the page, which sends and frees them itself. */
import {
  type BufferAttribute,
  BufferGeometry,
  type GLBufferAttribute,
  InstancedBufferGeometry,
  type InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  type RawShaderMaterial,
} from 'three';
import type { Piece } from '../decode/messages';
import { type Buffers, createBuffers } from './buffers';
import type { MeshArrays, Store } from './store';
import type { Step } from './uploads';

export type PieceMesh = Mesh<BufferGeometry, RawShaderMaterial>;

/** Numbers of a placement: three rows of four. */
const PLACEMENT = 12;

/** Things that making meshes needs. */
export interface Making {
  readonly gl: WebGL2RenderingContext;
  readonly store: Store;
  /** Makes three.js ready to draw meshes. */
  readonly warm: (meshes: readonly PieceMesh[]) => void;
}

/** The arrays of a mesh, and what must be done when it is let go. */
interface Owned {
  readonly arrays: MeshArrays;
  readonly placements: Buffers<'placement'> | null;
  readonly same: string | null;
}

const owned = new WeakMap<PieceMesh, Owned>();

/** A piece whose arrays have a place on the GPU. */
export interface Prepared {
  /** Steps that send the arrays. */
  steps(): Generator<Step>;
  /** The mesh, once they are done. */
  make(material: RawShaderMaterial): PieceMesh;
  /** Let the arrays go, if no mesh was made. */
  free(): void;
}

export function prepare(piece: Piece, { gl, store }: Making): Prepared {
  const { same } = piece;
  let isNew = false;
  const arrays = store.take(same, () => {
    isNew = true;
    return arraysOf(gl, piece);
  });
  const placements = piece.placements ? createBuffers(gl, { placement: columnOf(piece.placements, PLACEMENT) }) : null;
  const parts = { arrays, placements, same };
  return {
    *steps() {
      if (isNew) yield* arrays.steps();
      if (placements) yield* placements.steps();
    },
    make(material) {
      const mesh = meshOf(piece.name, parts, material);
      owned.set(mesh, parts);
      return mesh;
    },
    free: () => free(parts, store),
  };
}

function meshOf(name: string, { arrays, placements }: Owned, material: RawShaderMaterial): PieceMesh {
  const geometry = placements ? placedGeometry(placements) : new BufferGeometry();
  const { index, ...attributes } = arrays.attributes;
  // three.js takes attributes whose buffers are not its own, and such an index, too; its types do not say so.
  for (const [role, attribute] of Object.entries(attributes)) {
    geometry.setAttribute(role, attribute as unknown as BufferAttribute);
  }
  geometry.setIndex(index as unknown as BufferAttribute);
  const mesh = new Mesh(geometry, material);
  mesh.name = name;
  // The morph moves vertices, so that boxes of where they are say nothing.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** Free what the GPU holds of a mesh, but for arrays that other meshes share with it. */
export function disposeMesh(mesh: PieceMesh, store: Store): void {
  const { geometry } = mesh;
  // three.js frees all arrays that a geometry still has.
  for (const name of Object.keys(geometry.attributes)) geometry.deleteAttribute(name);
  geometry.setIndex(null);
  geometry.dispose();
  const parts = owned.get(mesh);
  if (parts) free(parts, store);
  owned.delete(mesh);
}

function free({ arrays, placements, same }: Owned, store: Store): void {
  if (store.give(same)) arrays.dispose();
  placements?.dispose();
}

function arraysOf(gl: WebGL2RenderingContext, { positions, normals, uvs, colors, indices }: Piece): MeshArrays {
  return createBuffers(gl, {
    position: columnOf(positions, 3),
    normal: normals && columnOf(normals, 3),
    uv: uvs && columnOf(uvs, 2),
    color: colors && { ...columnOf(colors, 4), isShare: true },
    index: columnOf(indices, 1),
  });
}

function columnOf<T extends Float32Array | Uint16Array | Uint32Array>(rows: T, width: number): { rows: T; width: number } {
  return { rows, width };
}

/** Placements are read as three rows each, from one array that goes on with each placement. */
function placedGeometry({ attributes }: Buffers<'placement'>): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const rows = Object.assign(attributes.placement as GLBufferAttribute, {
    isInstancedBufferAttribute: true,
    meshPerAttribute: 1,
    // three.js wants to know its kind of numbers.
    array: new Float32Array(0),
  });
  ['row_x', 'row_y', 'row_z'].forEach((name, row) => {
    geometry.setAttribute(name, new InterleavedBufferAttribute(rows as unknown as InterleavedBuffer, 4, 4 * row));
  });
  geometry.instanceCount = rows.count;
  return geometry;
}
