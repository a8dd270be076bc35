/** Pieces of geometry and pictures as three.js holds them. */
import {
  BufferAttribute,
  BufferGeometry,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  type RawShaderMaterial,
  RepeatWrapping,
  SRGBColorSpace,
  Texture,
} from 'three';
import type { Piece } from '../decode/messages';
import { nearMaterial, type Shared } from './materials';
import type { MeshArrays, Store } from './store';

export type PieceMesh = Mesh<BufferGeometry, RawShaderMaterial>;

/** Numbers of a placement: three rows of four. */
const PLACEMENT = 12;

/** A mesh whose static geometry ends at a radius, or nowhere (`Infinity`). */
export function meshOf(piece: Piece, texture: Texture | null, shared: Shared, store: Store, cut: number): PieceMesh {
  const geometry = piece.placements ? placed(piece.placements) : new BufferGeometry();
  const arrays = store.take(piece.same, () => arraysOf(piece));
  for (const [name, attribute] of Object.entries(arrays.attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(arrays.index);
  const mesh = new Mesh(geometry, nearMaterial(piece, texture, shared, cut));
  mesh.name = piece.name;
  // The morph moves vertices, so that boxes of where they are say nothing.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  mesh.userData['triangles'] = trianglesOf(piece);
  mesh.userData['same'] = piece.same;
  return mesh;
}

/** Free what the GPU holds of a mesh, but for arrays that other meshes share with it. */
export function disposeMesh({ geometry, material, userData }: PieceMesh, store: Store): void {
  const isShared = !store.give(userData['same'] as string | null);
  if (isShared) {
    // three.js frees all arrays that a geometry still has.
    for (const name of Object.keys(ATTRIBUTES)) geometry.deleteAttribute(name);
    geometry.setIndex(null);
  }
  geometry.dispose();
  material.dispose();
}

/** Numbers a vertex of each attribute of the shader. */
const ATTRIBUTES = { position: 3, normal: 3, uv: 2, color: 4 } as const;

function arraysOf({ positions, normals, uvs, colors, indices }: Piece): MeshArrays {
  const found = { position: positions, normal: normals, uv: uvs, color: colors };
  const attributes: Record<string, BufferAttribute> = {};
  for (const [name, width] of Object.entries(ATTRIBUTES)) {
    const array = found[name as keyof typeof found];
    if (array) attributes[name] = sent(new BufferAttribute(array, width, name === 'color'));
  }
  return { attributes, index: sent(new BufferAttribute(indices, 1)) };
}

export function trianglesOf(piece: Piece): number {
  return (piece.indices.length / 3) * (piece.placements ? piece.placements.length / PLACEMENT : 1);
}

function placed(placements: Float32Array): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const buffer = new InstancedInterleavedBuffer(placements, PLACEMENT);
  ['row_x', 'row_y', 'row_z'].forEach((name, row) => {
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, 4, 4 * row));
  });
  geometry.instanceCount = placements.length / PLACEMENT;
  return geometry;
}

/** The page's copy goes as soon as the GPU has its own. */
function sent<T extends BufferAttribute | InstancedBufferAttribute>(attribute: T): T {
  attribute.onUpload(() => {
    attribute.array = new (attribute.array.constructor as Float32ArrayConstructor)(0);
  });
  return attribute;
}

export function textureOf(image: ImageBitmap): Texture {
  const texture = new Texture(image);
  texture.colorSpace = SRGBColorSpace;
  texture.flipY = false;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.needsUpdate = true;
  return texture;
}
