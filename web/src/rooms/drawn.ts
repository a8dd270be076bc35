/** Meshes of avatars: materials that the pictures' uniforms and some of their own draw. */
import { type BufferGeometry, type IUniform, Mesh, RawShaderMaterial, type Vector3, type Vector4 } from 'three';
import type { Vector } from '../control/vector';
import { NEAR_FRAGMENT } from '../shaders/near';
import { BLENDING, NOWHERE, type Shared } from '../show/materials';
import { colorOf } from './color';

export type Drawn = Mesh<BufferGeometry, RawShaderMaterial>;

/** A mesh that a vertex shader puts where it is shown. */
export function drawn(
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

/** Set a point among a mesh's uniforms. */
export function setPoint({ material }: Drawn, name: string, value: Vector): void {
  (material.uniforms[name]?.value as Vector3).set(...value);
}

/** Give a colour, as uniforms have it, the one of a user. */
export function paint(color: Vector4, number: number): void {
  const { r, g, b } = colorOf(number);
  color.set(r, g, b, 1);
}
