/** Materials of near geometry and of the map. All of them share the uniforms of the picture that is drawn. */
import {
  type CubeTexture,
  CustomBlending,
  DoubleSide,
  GLSL3,
  Matrix4,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  SrcAlphaFactor,
  type Texture,
  Vector3,
  Vector4,
} from 'three';
import type { Material, Piece } from '../decode/messages';
import { FAR_FRAGMENT, FAR_VERTEX, NEAR_FRAGMENT, NEAR_VERTEX } from '../shaders/scene';
import { setSampler } from './textures';

/** Uniforms of a picture; see the shaders. */
export type Shared = ReturnType<typeof createShared>;

/** Creates the uniforms with initial textures. */
export function createShared(map: CubeTexture, codes: CubeTexture) {
  return {
    radii: { value: new Vector4() },
    opacity: { value: 1 },
    map: { value: map },
    codes: { value: codes },
    coding: { value: new Vector4() },
  };
}

/** Radius that no point reaches; shaders need not support infinity. */
export const NO_CUT = 1e30;

/** Settings that blend a picture over the previous one with the opacity of its fade; the canvas stays opaque. */
export const BLENDING = {
  blending: CustomBlending,
  blendSrc: SrcAlphaFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
  // three.js keeps the order of opaque objects; it would sort transparent ones.
  transparent: false,
  depthTest: true,
  side: DoubleSide,
  glslVersion: GLSL3,
} as const;

/** Textures of a material by their use; null for those that it does not have. */
export type Textures = Readonly<Record<'image' | 'glow', Texture | null>>;

/**
 * Returns the textures of a material, found by URI. `find` must return another texture for a second use: if colour and
 * emission are the same image with different samplers.
 */
export function texturesOf(
  { image, glow, imageSampler, glowSampler }: Material,
  find: (uri: string, isSecondUse: boolean) => Texture | null,
): Textures {
  const isSecondUse = image === glow && imageSampler.join() !== glowSampler.join();
  return { image: image === null ? null : find(image, false), glow: glow === null ? null : find(glow, isSecondUse) };
}

/** Returns the preprocessor definitions for a piece's shader program. */
export function definesOf(piece: Piece, { image, glow }: Textures): Record<string, string> {
  const { material } = piece;
  const defines: Record<string, string> = {};
  if (piece.normals) defines['SMOOTH'] = '';
  if (piece.colors) defines['COLORED'] = '';
  if (piece.placements) defines['PLACED'] = '';
  if (image && piece.uvs) defines['TEXTURED'] = '';
  if (material.cutoff !== null) defines['CUTOUT'] = '';
  // Emission without its texture would make dark parts glow.
  if (material.emission && (material.glow === null || (glow && piece.uvs)))
    defines[material.glow === null ? 'EMISSIVE' : 'GLOWING'] = '';
  if (material.isUnlit) defines['UNLIT'] = '';
  return defines;
}

/** Creates the material of a piece; beyond the radius `cut`, which may be `Infinity`, the piece is not drawn. */
export function nearMaterial(piece: Piece, textures: Textures, shared: Shared, cut: number): RawShaderMaterial {
  const { color, cutoff, emission, imageSampler, glowSampler } = piece.material;
  const material = new RawShaderMaterial({
    ...BLENDING,
    vertexShader: NEAR_VERTEX,
    fragmentShader: NEAR_FRAGMENT,
    defines: definesOf(piece, textures),
    uniforms: {
      ...shared,
      base_color: { value: new Vector4(...color) },
      cutoff: { value: cutoff ?? 0 },
      image: { value: textures.image },
      emission: { value: new Vector3(...(emission ?? [0, 0, 0])) },
      glow: { value: textures.glow },
      placement: { value: new Matrix4() },
      cut: { value: Math.min(cut, NO_CUT) },
    },
  });
  material.onBeforeRender = (renderer) => {
    if (textures.image) setSampler(renderer, textures.image, imageSampler);
    if (textures.glow) setSampler(renderer, textures.glow, glowSampler);
  };
  return material;
}

/** Creates the materials of a region. Pieces that look alike share one, because each costs three.js time. */
export function createMaterials(shared: Shared) {
  const materials = new Map<string, RawShaderMaterial>();
  return {
    get(piece: Piece, textures: Textures, cut: number): RawShaderMaterial {
      const kind = Object.keys(definesOf(piece, textures));
      const look = JSON.stringify([kind, piece.material, String(cut)]);
      const material = materials.get(look) ?? nearMaterial(piece, textures, shared, cut);
      materials.set(look, material);
      return material;
    },
    dispose(): void {
      for (const material of materials.values()) material.dispose();
      materials.clear();
    },
  };
}

export function farMaterial(shared: Shared): RawShaderMaterial {
  return new RawShaderMaterial({
    ...BLENDING,
    vertexShader: FAR_VERTEX,
    fragmentShader: FAR_FRAGMENT,
    depthWrite: false,
    uniforms: { map: shared.map, opacity: shared.opacity },
  });
}
