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

export type PieceMesh = Mesh<BufferGeometry, RawShaderMaterial>;

/** Numbers of a placement: three rows of four. */
const PLACEMENT = 12;

export function meshOf(piece: Piece, texture: Texture | null, shared: Shared): PieceMesh {
  const geometry = piece.placements ? placed(piece.placements) : new BufferGeometry();
  geometry.setAttribute('position', sent(new BufferAttribute(piece.positions, 3)));
  if (piece.normals) geometry.setAttribute('normal', sent(new BufferAttribute(piece.normals, 3)));
  if (piece.uvs) geometry.setAttribute('uv', sent(new BufferAttribute(piece.uvs, 2)));
  if (piece.colors) geometry.setAttribute('color', sent(new BufferAttribute(piece.colors, 4, true)));
  geometry.setIndex(sent(new BufferAttribute(piece.indices, 1)));
  const mesh = new Mesh(geometry, nearMaterial(piece, texture, shared));
  mesh.name = piece.name;
  // The morph moves vertices, so that boxes of where they are say nothing.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  mesh.userData['triangles'] = trianglesOf(piece);
  return mesh;
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
