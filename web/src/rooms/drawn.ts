/** Meshes of avatars, with materials of shared and own uniforms. */
import { type BufferGeometry, type IUniform, Mesh, RawShaderMaterial, type Vector3, type Vector4 } from 'three';
import type { Vector } from '../control/vector';
import { NEAR_FRAGMENT } from '../shaders/near';
import { BLENDING, NOWHERE, type Shared } from '../show/materials';
import { colorOf } from './color';

export type Drawn = Mesh<BufferGeometry, RawShaderMaterial>;

/** Creates a mesh that its vertex shader places. */
export function createMesh(
  shape: BufferGeometry,
  shared: Shared,
  vertexShader: string,
  defines: Record<string, string>,
  own: Record<string, IUniform>,
): Drawn {
  const material = new RawShaderMaterial({
    ...BLENDING,
    vertexShader,
    fragmentShader: NEAR_FRAGMENT,
    defines,
    uniforms: { ...shared, ...own, cut: { value: NOWHERE } },
  });
  const mesh = new Mesh(shape, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** Sets a point among a mesh's uniforms. */
export function setPoint({ material }: Drawn, name: string, value: Vector): void {
  (material.uniforms[name]?.value as Vector3).set(...value);
}

/** Sets a colour for uniforms to that of a user. */
export function paint(color: Vector4, number: number): void {
  const { r, g, b } = colorOf(number);
  color.set(r, g, b, 1);
}
